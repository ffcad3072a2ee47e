"""The verbs of all analyses: an engine and the options of a question in, its document out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from functools import partial
from inspect import Parameter as Argument
from inspect import Signature
from itertools import count
from os.path import realpath
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from cyclopts import Parameter

from crankstar.analysis.reader import Asked, asked, being_read, readings
from crankstar.analysis.record import Analysis, Writes
from crankstar.analysis.registry import added, analysis
from crankstar.cli.options import (
    FLAT,
    Csv,
    Estimating,
    Json,
    Looks,
    Output,
    Settings,
    engine_place,
    mark_load,
    mark_speed,
    numbered,
    once,
    option,
    read_engine,
    together,
    write_engine,
)
from crankstar.cli.output import complain, progress, working, writable, write_bytes
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.faults import EngineError
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options.forms import ENGINES, PICTURES, TABLES, form_of, suffix_of
from crankstar.options.refusals import RequestError, refusal, refuse_unused
from crankstar.options.sources import Loaded
from crankstar.options.vocabulary import OPTIONS

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Assumption
    from crankstar.analysis.document import Document

TYPES = {"nothing": bool, "text": str, "several texts": list[str], "whole number": int}
"""What the parser makes of what an option takes."""
SHARED = {
    "settings": Settings,
    "estimate": Estimating,
    "json": Json,
    "csv": Csv,
    "looks": Annotated[Looks, FLAT],
    "output": Output,
}
"""The options of every analysis, behind those of its question; looks where it has a picture."""
LOOKS = Looks()
DEFAULTS: dict[str, Any] = {"settings": None, "looks": LOOKS, "output": None}


def __getattr__(name: str) -> Callable[..., None]:
    """The verb of an analysis."""
    try:
        return verb(analysis(name))
    except KeyError:
        raise AttributeError(name) from None


def verb(record: Analysis) -> Callable[..., None]:
    """The function of a command line that asks an analysis, with the options of its question."""
    fields, writes = asked(record.question.value), record.writes
    names = ["engine", *(one.name for one in fields if one.reader.follows)]

    def run(*words: str, **options: Any) -> None:
        answer(record, {**dict(zip(names, words, strict=True)), **options})

    arguments = [
        Argument(
            "engine",
            Argument.POSITIONAL_ONLY,
            annotation=Annotated[str, Parameter(help=record.takes)],
        ),
        *map(_argument, fields),
        *([] if writes is None or writes.name == "output" else [_of_file(writes)]),
        *(
            Argument(
                name, Argument.KEYWORD_ONLY, default=DEFAULTS.get(name, False), annotation=kind
            )
            for name, kind in _shared(record).items()
        ),
    ]
    run.__doc__ = record.about
    run.__annotations__ = {each.name: each.annotation for each in arguments}
    run.__signature__ = Signature(arguments)
    return run


def _argument(one: Asked) -> Argument:
    if one.reader.follows:
        word = Annotated[str, Parameter(help=one.reader.more)]
        return Argument(one.name, Argument.POSITIONAL_ONLY, annotation=word)
    kind = TYPES[OPTIONS[one.reader.option].takes]
    how = option(one.reader.option, one.reader.more)
    return Argument(
        one.name,
        Argument.KEYWORD_ONLY,
        default=False if kind is bool else _shown_default(one),
        annotation=Annotated[kind, how] if kind is bool else Annotated[kind | None, how],
    )


def _shown_default(one: Asked) -> str | None:
    """The default that help shows: a word."""
    return one.default if isinstance(one.default, str) and one.default else None


def _of_file(writes: Writes) -> Argument:
    return Argument(
        writes.name,
        Argument.KEYWORD_ONLY,
        default=None,
        annotation=_path(writes.option, writes.more),
    )


def _path(name: str, more: str) -> Any:
    """The type of an option that names a file."""
    return Annotated[str | None, option(name, more)]


def _shared(record: Analysis) -> dict[str, Any]:
    """The options of SHARED that an analysis has."""
    shared = dict(SHARED)
    if not record.estimates:
        del shared["estimate"]
    if record.picture is None:
        del shared["looks"]
    else:
        shared["output"] = _path("--output", record.picture.more)
    if _only_printed(record):
        del shared["csv"]
    if record.writes is not None and record.writes.name == "output":
        shared["output"] = _path("--output", record.writes.more)
    return shared


def _only_printed(record: Analysis) -> bool:
    """Whether -o names the engine that it makes, and not its document."""
    writes = record.writes
    return writes is not None and writes.name == "output" and writes.instead is None


def answer(record: Analysis, options: dict[str, Any]) -> None:
    """Answer a command line: read all of it, compute, and write what it asks for."""
    try:
        _answer(record, options)
    except EngineError as error:  # what the engine lacks for this analysis
        raise RequestError(f"{one_line(options['engine'])}: {error}") from None


def _answer(record: Analysis, options: dict[str, Any]) -> None:
    """The same, with the faults of an engine as they are told without its file."""
    with added().running(record.name):
        read = _read(record, options)
    if (writes := record.writes) is not None and _instead(writes, read.question):
        _write_instead(record, writes, read, options.get("output"))
        return
    if read.form in PICTURES:
        _draw(record, read, options)
        return
    with words_for(read.form):
        document, result = _document(record, read)
    if (
        writes is not None
        and writes.instead is None
        and (path := options.get(writes.name)) is not None
    ):
        _write(record, writes, read, result, path)
    tree = read.loaded.tree if record.of_file else None
    output = None if _only_printed(record) else options.get("output")
    give(document, output, form=read.form, tree=tree)


def _write(record: Analysis, writes: Writes, read: Read, result: Any, path: str) -> None:
    """Write the engine that an analysis makes, or several, each in a file with its number."""
    source = read.loaded.source
    if isinstance(source, Engine):
        of = (result,) if writes.of_result else (source, read.question)
        with added().running(record.name):
            made = writes.engine.value(*of)
        several: Sequence[Engine] = (made,) if writes.count is None else made
        for each, place in zip(several, numbered(path, len(several)), strict=True):
            write_engine(each, read.loaded.tree, place, option=_spelt(writes))


def _instead(writes: Writes, question: Any) -> str:
    """The option for which an engine is given in place of the document."""
    return "" if writes.instead is None else writes.instead.value(question)


def _write_instead(record: Analysis, writes: Writes, read: Read, place: str | None) -> None:
    """Write the engine that is given in place of the document, or print it."""
    with added().running(record.name), _shown(record, 1) as steps:
        result = _computed(record, read.loaded.source, read.question, steps.tell)
        made = writes.engine.value(result, read.question)
    write_engine(made, read.loaded.tree, place)


def _form(record: Analysis, options: dict[str, Any], question: Any) -> str:
    """The form of what is written. Raises RequestError."""
    flags = {name: bool(options.get(name)) for name in ("json", "csv")}
    output = None if _only_printed(record) else options.get("output")
    for_engine = "" if record.writes is None else _instead(record.writes, question)
    if for_engine:
        refuse_unused({f"--{name}": given for name, given in flags.items()}, beside=for_engine)
        return form_of(output, ENGINES)
    return form_of(output, _forms(record), **flags)


def _spelt(writes: Writes) -> str:
    """The option of a file as it is named in a refusal."""
    return "-o" if writes.option == "--output" else writes.option


def _draw(record: Analysis, read: Read, options: dict[str, Any]) -> None:
    """Write the picture of a result."""
    from crankstar.options import charts as chart_request

    assert record.picture is not None  # noqa: S101  # only then it has forms of pictures
    drawing, source = chart_request.charts(), read.loaded.source
    title = _(record.picture.title, engine=source.name)
    look = chart_request.paper(read.form, **asdict(options.get("looks", LOOKS)))
    with added().running(record.name), _shown(record, 1) as steps:
        about = read.loaded if record.of_file else source
        result = _computed(record, about, read.question, steps.tell)
        draw = partial(record.picture.draw.value, result, read.question)
        printed = drawing.printed(draw, look, title=title)
        write_bytes(drawing.saved_print(printed, read.form, title=title), options["output"])
    for line in printed.chart.notes:
        complain(line)


def _document(record: Analysis, read: Read) -> tuple[Document, Any]:
    """What is told of the source, over its ranges, with what it rests on; and its result.

    The work is shown meanwhile.
    """
    with added().running(record.name):
        return _documented(record, read)


def _documented(record: Analysis, read: Read) -> tuple[Document, Any]:
    """The same, with whatever the analysis raises."""
    source, spread, question = read.loaded.source, read.loaded.spread, read.question
    if isinstance(source, Chain):
        with working(_(record.doing)):
            return record.told(source, question), None
    from crankstar.tables.ranges import ranged, resting

    several = 1 if spread is None else len(spread.engines)
    number = count(1)
    results: list[Any] = []
    with _shown(record, several) as steps:

        def told(each: Engine) -> Document:
            if several > 1:
                steps.tell(next(number), several)
            own = None if several > 1 else steps.tell
            about = read.loaded.of(each) if record.of_file else each
            results.append(_computed(record, about, question, own))
            proved = record.proved is None or record.proved.value(results[-1])
            if steps.ended() and not proved:
                complain(_("Interrupted: what follows is the best so far, and not proved."))
            return record.document.value(each, results[-1], question)

        def rests() -> Sequence[Assumption]:
            audience = "readers" if read.form == "txt" else "machines"
            about = record.resting(source, results[0])
            answer = partial(record.answered, about, question, results[0], audience)
            found = resting_on(read.form, about, answer)
            return () if found is None else found()

        if record.ranges:
            document = ranged(told, spread, source, rests=rests)
        else:
            document = resting(told(source), rests)
        return document, results[0]


def _computed(
    record: Analysis,
    source: Loaded | Engine | Chain,
    question: Any,
    tell: Callable[[int, int], bool] | None,
) -> Any:
    """The result; `tell` is called after each step of a long one."""
    steps = {"tell": tell} if record.steps else {}
    return record.compute.value(source, question, **steps)


class Steps(NamedTuple):
    """What is called with the steps done and their number, and whether they were to end."""

    tell: Callable[[int, int], bool]
    ended: Callable[[], bool] = lambda: False


@contextmanager
def _shown(record: Analysis, several: int) -> Iterator[Steps]:
    """Show that work is under way; of steps or several engines also how many are done.

    Steps are ended in order by the first interrupt: by False to what can halt.
    """
    doing = _(record.doing)
    if several == 1 and not record.steps:
        with working(doing):
            yield Steps(lambda _done, _of: True)
        return
    from crankstar.stars.interrupts import ended_once, signals_noted

    with ExitStack() as opened:
        noted = opened.enter_context(signals_noted()) if record.proved is not None else None
        if record.steps and noted is None:
            opened.enter_context(ended_once())
        show = opened.enter_context(progress(doing))

        def ended() -> bool:
            return noted is not None and noted.is_set()

        def tell(done: int, of: int) -> bool:
            show(done, of, "" if noted is not None else f"{done}/{of}")
            return not ended()

        yield Steps(tell, ended)


class Read(NamedTuple):
    """A command line as it was read: the engine or drive line, the question, the form."""

    loaded: Loaded
    question: Any
    form: str


def _read(record: Analysis, options: dict[str, Any]) -> Read:
    """All of a command line. Raises MessageError with every error of it."""
    fields = asked(record.question.value)
    estimate = bool(options.get("estimate"))
    settings = options.get("settings")
    load = once(
        partial(
            _loaded,
            record,
            options["engine"],
            settings,
            estimate=estimate,
            speed=options.get("speed"),
        )
    )

    def source() -> Engine | Chain:
        return load().source

    reading = readings(record.question.value, _over_speeds(options, fields), source)
    form, loaded, *values = together(
        partial(_form, record, options, being_read(record.question.value, reading)),
        load,
        *reading.values(),
        *_refusals(record, options, reading, source),
    )
    question = record.question.value(**dict(zip(reading, values, strict=False)))
    if record.marks_speed and isinstance(loaded.source, Engine):
        mark_speed(options.get("speed"), loaded.source)
    if isinstance(loaded.source, Engine) and not getattr(question, "speeds", None):
        point, at = (getattr(question, name, None) for name in ("point", "speed"))
        if point or at is not None:
            mark_load(settings, loaded.source, point=point or "", speed=at)
    return Read(loaded, question, form)


def _refusals(
    record: Analysis,
    options: dict[str, Any],
    reading: Mapping[str, Callable[[], Any]],
    source: Callable[[], Engine | Chain],
) -> Iterator[Callable[[], None]]:
    """What refuses values that do not go together, and a file that cannot be written."""
    question = being_read(record.question.value, reading)
    refuse, writes = record.refuse, record.writes
    if (output := options.get("output")) is not None and not _only_printed(record):
        yield partial(writable, output)
    if writes is not None and writes.instead is None and options.get(writes.name) is not None:
        yield partial(_engine_places, writes, options, question)
        if writes.refuse is not None:
            yield partial(writes.refuse.value, question)
    if record.picture is not None:
        yield partial(_refuse_looks, options)
    if refuse is not None:
        yield lambda: refuse.value(source(), question)
    yield lambda: _refuse_of_chain(record, options, source())


def _refuse_looks(options: dict[str, Any]) -> None:
    """Refuse how a picture looks, of a table altogether. Raises RequestError."""
    kind = suffix_of(options.get("output") or "").removeprefix(".")
    looks = options.get("looks", LOOKS)
    if kind not in PICTURES or options.get("json") or options.get("csv"):
        looks.refuse(_("a table"))
        return
    from crankstar.options import charts as chart_request

    if chart_request.charts():
        chart_request.paper(kind, **asdict(looks))


def _engine_places(writes: Writes, options: dict[str, Any], question: Any) -> None:
    """Refuse files of engines that cannot be written, or that the document would replace."""
    output = None if writes.name == "output" else options.get("output")
    count = 1 if writes.count is None else writes.count.value(question)
    for place in numbered(options[writes.name], count):
        if output is not None and realpath(place) == realpath(output):
            raise refusal(
                _spelt(writes),
                place,
                "it is read or written besides and would be lost; name another",
            )
        engine_place(place, option=_spelt(writes))


def _refuse_of_chain(record: Analysis, options: dict[str, Any], source: Engine | Chain) -> None:
    """Refuse what a drive line without cylinders cannot be asked. Raises RequestError."""
    if isinstance(source, Chain):
        fields = asked(record.question.value)
        others = [one for one in fields if one.name not in record.chains]
        unused = {one.reader.option: options.get(one.name) for one in others}
        unused["--estimate"] = options.get("estimate")
        refuse_unused(unused, beside=_("a drive line without cylinders"))


def _forms(record: Analysis) -> tuple[str, ...]:
    """The forms in which an analysis is written."""
    return TABLES if record.picture is None else (*TABLES, *PICTURES)


def _loaded(
    record: Analysis, name: str, settings: list[str] | None, *, estimate: bool, speed: str | None
) -> Loaded:
    """What is named. Raises MessageError where it lacks what is computed with."""
    chains, ranged = bool(record.chains), record.ranges
    found = read_engine(
        name, settings, estimate=estimate, speed=speed, chains=chains, ranged=ranged
    )
    if record.needs is not None and isinstance(found.source, Engine):
        record.needs.value(found.source)
    return found


def _over_speeds(options: dict[str, Any], fields: Sequence[Asked]) -> dict[str, Any]:
    """The options; a range that is given as one speed is one of speeds, where those are asked."""
    speed = options.get("speed")
    ranged = speed is not None and ".." in speed and options.get("speeds") is None
    if ranged and any(one.name == "speeds" for one in fields):
        return {**options, "speed": None, "speeds": speed}
    return options
