"""The verbs of all analyses: an engine and the options of a question in, its document out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import MISSING, asdict, replace
from functools import partial
from inspect import Parameter as Argument
from inspect import Signature
from itertools import count
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from cyclopts import Parameter

from crankstar.analysis.document import remarks
from crankstar.analysis.reader import Asked, asked
from crankstar.analysis.record import Analysis, Writes
from crankstar.analysis.registry import added, analysis
from crankstar.cli.command_lines import LOOKS, CommandLine, instead, only_printed, read_line, spelt
from crankstar.cli.options import (
    FLAT,
    Csv,
    Estimating,
    Json,
    Looks,
    Output,
    Settings,
    command_text,
    numbered,
    option,
    write_engine,
)
from crankstar.cli.output import complain, progress, working, write, write_bytes
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.faults import EngineError
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options.forms import PICTURES
from crankstar.options.refusals import RequestError
from crankstar.options.sources import Loaded
from crankstar.options.vocabulary import option_of

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Assumption
    from crankstar.analysis.document import Document

READ = ("txt", "xlsx")
"""Forms for readers, which say what to go on with."""
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
DEFAULTS: dict[str, Any] = {"settings": None, "looks": LOOKS, "output": None}


def __getattr__(name: str) -> Callable[..., None]:
    """The verb of an analysis."""
    try:
        record = analysis(name)
    except KeyError:
        raise AttributeError(name) from None
    return verb(record)


def verb(record: Analysis) -> Callable[..., None]:
    """The function of a command line that asks an analysis, with the options of its question."""
    fields = asked(record.question.value)
    first = _engine(record)
    names = [
        one.name for one in (*first, *fields) if isinstance(one, Argument) or one.reader.follows
    ]

    def run(*words: str | None, **options: Any) -> None:
        answer(record, {**dict(zip(names, words, strict=False)), **options})

    arguments = [
        *first,
        *map(_argument, fields),
        *(_of_file(each) for each in _files(record)),
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


def _engine(record: Analysis) -> list[Argument]:
    """The word that names the engine, where the analysis is of one."""
    if record.engine == "none":
        return []
    return [_word("engine", record.takes, needed=record.engine == "needed")]


def _word(name: str, about: str, *, needed: bool) -> Argument:
    """A word before the options."""
    return Argument(
        name,
        Argument.POSITIONAL_ONLY,
        default=Argument.empty if needed else None,
        annotation=Annotated[str if needed else str | None, Parameter(help=about)],
    )


def _argument(one: Asked) -> Argument:
    if one.reader.follows:
        return _word(one.name, one.reader.more, needed=one.default is MISSING)
    own = option_of(one.reader)
    kind = TYPES[own.takes]
    how = option(one.reader.option, one.reader.more, own=own)
    return Argument(
        one.name,
        Argument.KEYWORD_ONLY,
        default=False if kind is bool else _shown_default(one),
        annotation=Annotated[kind, how] if kind is bool else Annotated[kind | None, how],
    )


def _shown_default(one: Asked) -> str | None:
    """The default that help shows: a word."""
    return one.default if isinstance(one.default, str) and one.default else None


def _files(record: Analysis) -> Iterator[tuple[str, str, str]]:
    """The options of files that are written besides: argument, option, what it adds to it."""
    if (writes := record.writes) is not None and writes.name != "output":
        yield writes.name, writes.option, writes.more
    if (saves := record.saves) is not None:
        yield saves.name, saves.option, ""


def _of_file(file: tuple[str, str, str]) -> Argument:
    name, option_name, more = file
    return Argument(name, Argument.KEYWORD_ONLY, default=None, annotation=_path(option_name, more))


def _path(name: str, more: str) -> Any:
    """The type of an option that names a file."""
    return Annotated[str | None, option(name, more)]


def _shared(record: Analysis) -> dict[str, Any]:
    """The options of SHARED that an analysis has."""
    shared = dict(SHARED)
    if record.engine == "none":
        del shared["settings"]
    if not record.estimates:
        del shared["estimate"]
    if record.picture is None:
        del shared["looks"]
    else:
        shared["output"] = _path("--output", record.picture.more)
    if only_printed(record):
        del shared["csv"]
    if record.writes is not None and record.writes.name == "output":
        shared["output"] = _path("--output", record.writes.more)
    return shared


def answer(record: Analysis, options: dict[str, Any]) -> None:
    """Answer a command line: read all of it, compute, and write what it asks for."""
    try:
        _answer(record, options)
    except EngineError as error:  # what the engine lacks for this analysis
        raise RequestError(f"{one_line(options['engine'])}: {error}") from None


def _answer(record: Analysis, options: dict[str, Any]) -> None:
    """The same, with the faults of an engine as they are told without its file."""
    with added().running(record.name):
        line = read_line(record, options)
    if (writes := record.writes) is not None and instead(writes, line.question):
        _write_instead(record, writes, line, options.get("output"))
        return
    if line.form in PICTURES:
        _save(record, _draw(record, line, options), options)
        return
    with words_for(line.form):
        document, result = _document(record, line)
    if line.form in READ:
        document = _going_on(record, line, options, document)
    _save(record, result, options)
    if (
        writes is not None
        and writes.instead is None
        and (path := options.get(writes.name)) is not None
    ):
        _write(record, writes, line, result, path)
    tree = line.tree if record.of_file else None
    output = None if only_printed(record) else options.get("output")
    give(document, output, form=line.form, tree=tree)


def _going_on(
    record: Analysis, line: CommandLine, options: dict[str, Any], document: Document
) -> Document:
    """The document, for readers, with the command that goes on from it, if there is one."""
    if record.onward is None or not isinstance(line.source, Engine):
        return document
    onward = record.onward.value(line.source)
    if onward is None:
        return document
    more = {"--estimate": [""]} if options.get("estimate") else {}
    more |= {key: [""] for key in onward.options}
    typed = {"--set": options.get("settings"), **more}
    command = command_text(onward.verb, options["engine"], typed)
    words = remarks(_(onward.sentence, command=command))
    return replace(document, parts=(*document.parts, *words))


def _write(record: Analysis, writes: Writes, line: CommandLine, result: Any, path: str) -> None:
    """Write the engine that an analysis makes, or several, each in a file with its number."""
    source = line.source
    if isinstance(source, Engine):
        of = (result,) if writes.of_result else (source, line.question)
        with added().running(record.name):
            made = writes.engine.value(*of)
        several: Sequence[Engine] = (made,) if writes.count is None else made
        for each, place in zip(several, numbered(path, len(several)), strict=True):
            write_engine(each, line.tree, place, option=spelt(writes))


def _write_instead(record: Analysis, writes: Writes, line: CommandLine, path: str | None) -> None:
    """Write the engine that is given in place of the document, or print it."""
    with added().running(record.name), _shown(record, 1) as steps:
        result = _computed(record, line.about(record), line.question, steps.tell)
        made = writes.engine.value(result, line.question)
    write_engine(made, line.tree, path)


def _save(record: Analysis, result: Any, options: dict[str, Any]) -> None:
    """Write the text of a result that is asked for besides."""
    saves = record.saves
    if saves is not None and (place := options.get(saves.name)) is not None:
        write(saves.text.value(result), place, option=saves.option)


def _draw(record: Analysis, line: CommandLine, options: dict[str, Any]) -> Any:
    """Write the picture of a result, which is returned."""
    from crankstar.options import charts as chart_request

    assert record.picture is not None  # noqa: S101  # only then it has forms of pictures
    drawing = chart_request.charts()
    title = _(record.picture.title, engine="" if line.source is None else line.source.name)
    look = chart_request.paper(line.form, **asdict(options.get("looks", LOOKS)))
    with added().running(record.name), _shown(record, 1) as steps:
        result = _computed(record, line.about(record), line.question, steps.tell)
        draw = partial(record.picture.draw.value, result, line.question)
        printed = drawing.printed(draw, look, title=title)
        write_bytes(drawing.saved_print(printed, line.form, title=title), options["output"])
    for note in printed.chart.notes:
        complain(note)
    return result


def _document(record: Analysis, line: CommandLine) -> tuple[Document, Any]:
    """What is told of the source, over its ranges, with what it rests on; and its result.

    The work is shown meanwhile.
    """
    with added().running(record.name):
        return _documented(record, line)


def _documented(record: Analysis, line: CommandLine) -> tuple[Document, Any]:
    """The same, with whatever the analysis raises."""
    source, question = line.source, line.question
    if line.loaded is None or not isinstance(source, Engine):
        with working(_(record.doing)):
            result = record.compute.value(source, question)
            return record.document.value(source, result, question), result
    file, spread = line.loaded, line.loaded.spread if record.ranges else None
    from crankstar.tables.ranges import ranged, resting

    several = 1 if spread is None else len(spread.engines)
    number = count(1)
    results: list[Any] = []
    with _shown(record, several) as steps:

        def told(each: Engine) -> Document:
            if several > 1:
                steps.tell(next(number), several)
            own = None if several > 1 else steps.tell
            about = file.of(each) if record.of_file else each
            results.append(_computed(record, about, question, own))
            proved = record.proved is None or record.proved.value(results[-1])
            if steps.ended() and not proved:
                complain(_("Interrupted: what follows is the best so far, and not proved."))
            return record.document.value(each, results[-1], question)

        def rests() -> Sequence[Assumption]:
            audience = "readers" if line.form == "txt" else "machines"
            about = record.resting(source, results[0])
            answer = partial(record.answered, about, question, results[0], audience)
            found = resting_on(line.form, about, answer)
            return () if found is None else found()

        if record.ranged:
            document = ranged(told, spread, source, rests=rests)
        else:
            document = resting(told(source), rests)
        return document, results[0]


def _computed(
    record: Analysis,
    source: Loaded | Engine | Chain | None,
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
