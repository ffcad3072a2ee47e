"""The verbs of all analyses: an engine and the options of a question in, its document out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from inspect import Parameter as Argument
from inspect import Signature
from itertools import count
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from cyclopts import Parameter

from crankstar.analysis.reader import Asked, asked, being_read, readings
from crankstar.analysis.record import Analysis, Writes
from crankstar.analysis.registry import analysis
from crankstar.cli.options import (
    Csv,
    Estimating,
    Json,
    Output,
    Settings,
    engine_or_chain,
    engine_over_ranges,
    engine_place,
    engine_with_tree,
    mark_speed,
    once,
    option,
    together,
    write_engine,
)
from crankstar.cli.output import progress, working
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.files.box import Spread
from crankstar.language.messages import _
from crankstar.options.forms import TABLES, form_of
from crankstar.options.values import refuse_unused
from crankstar.options.vocabulary import OPTIONS

if TYPE_CHECKING:
    from crankstar.analysis.document import Document

TYPES = {"nothing": bool, "text": str, "several texts": list[str], "whole number": int}
"""What the parser makes of what an option takes."""
SHARED = {"settings": Settings, "estimate": Estimating, "json": Json, "csv": Csv, "output": Output}
"""The options of every analysis, behind those of its question."""


def __getattr__(name: str) -> Callable[..., None]:
    """The verb of an analysis."""
    try:
        return verb(analysis(name))
    except KeyError:
        raise AttributeError(name) from None


def verb(record: Analysis) -> Callable[..., None]:
    """The function of a command line that asks an analysis, with the options of its question."""

    def run(engine: str, /, **options: Any) -> None:
        answer(record, engine, options)

    shared = {name: kind for name, kind in SHARED.items() if name != "estimate" or record.estimates}
    arguments = [
        Argument(
            "engine",
            Argument.POSITIONAL_ONLY,
            annotation=Annotated[str, Parameter(help=record.takes)],
        ),
        *map(_argument, asked(record.question.value)),
        *([] if record.writes is None else [_of_file(record.writes)]),
        *(
            Argument(
                name,
                Argument.KEYWORD_ONLY,
                default=None if name in ("settings", "output") else False,
                annotation=kind,
            )
            for name, kind in shared.items()
        ),
    ]
    run.__doc__ = record.about
    run.__annotations__ = {each.name: each.annotation for each in arguments}
    run.__signature__ = Signature(arguments)
    return run


def _argument(one: Asked) -> Argument:
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
        annotation=Annotated[str | None, option(writes.option)],
    )


def answer(record: Analysis, engine: str, options: dict[str, Any]) -> None:
    """Answer a command line: read all of it, compute, and write what it asks for."""
    output = options.get("output")
    read = _read(record, engine, options)
    with words_for(read.form):
        document = _document(record, read)
    saved = None if record.writes is None else options.get(record.writes.name)
    if record.writes is not None and saved is not None and isinstance(read.source, Engine):
        made = record.writes.engine.value(read.source, read.question)
        write_engine(made, read.tree, saved, option=record.writes.option)
    give(document, output, form=read.form)


def _document(record: Analysis, read: Read) -> Document:
    """What is told of the source, over its ranges, with what it rests on; while the work shows."""
    source, question = read.source, read.question
    if isinstance(source, Chain):
        with working(_(record.doing)):
            return record.told(source, question)
    from crankstar.tables.ranges import ranged, resting

    rests = resting_on(read.form, source, partial(record.answer.value, source, question))
    if not record.estimates:
        with working(_(record.doing)):
            return resting(record.told(source, question), rests)
    several = 1 if read.spread is None else len(read.spread.engines)
    number = count(1)
    with _shown(_(record.doing), several) as tell:

        def told(each: Engine) -> Document:
            tell(next(number))
            return record.told(each, question)

        return ranged(told, read.spread, source, rests=rests)


@contextmanager
def _shown(doing: str, several: int) -> Iterator[Callable[[int], None]]:
    """Show that work is under way; of several engines also with which one, which is called."""
    if several == 1:
        with working(doing):
            yield lambda _number: None
        return
    with progress(doing) as tell:
        yield lambda number: tell(number, several, "")


class Read(NamedTuple):
    """A command line as it was read: the source, its ranges and tree, the question, the form."""

    source: Engine | Chain
    spread: Spread | None
    tree: dict[str, Any] | None
    question: Any
    form: str


def _read(record: Analysis, engine: str, options: dict[str, Any]) -> Read:
    """All of a command line. Raises MessageError with every error of it."""
    fields = asked(record.question.value)
    estimate = bool(options.get("estimate"))
    load = once(partial(_loaded, record, engine, options.get("settings"), estimate=estimate))
    reading = readings(record.question.value, _over_speeds(options, fields), lambda: load()[0])
    forms = {name: bool(options.get(name)) for name in ("json", "csv")}
    form, (source, spread, tree), *values = together(
        partial(form_of, options.get("output"), TABLES, **forms),
        load,
        *reading.values(),
        *_refusals(record, options, reading, lambda: load()[0]),
    )
    question = record.question.value(**dict(zip(reading, values, strict=False)))
    if record.marks_speed and isinstance(source, Engine):
        mark_speed(options.get("speed"), source)
    return Read(source, spread, tree, question, form)


def _refusals(
    record: Analysis,
    options: dict[str, Any],
    reading: Mapping[str, Callable[[], Any]],
    source: Callable[[], Engine | Chain],
) -> Iterator[Callable[[], None]]:
    """What refuses values that do not go together, and a file that cannot be written."""
    question = being_read(record.question.value, reading)
    refuse, writes = record.refuse, record.writes
    if writes is not None and options.get(writes.name) is not None:
        yield partial(engine_place, options[writes.name], option=writes.option)
        if writes.refuse is not None:
            yield partial(writes.refuse.value, question)
    if refuse is not None:
        yield lambda: refuse.value(source(), question)
    yield lambda: _refuse_of_chain(record, options, source())


def _refuse_of_chain(record: Analysis, options: dict[str, Any], source: Engine | Chain) -> None:
    """Refuse what a drive line without cylinders cannot be asked. Raises RequestError."""
    if isinstance(source, Chain):
        fields = asked(record.question.value)
        others = [one for one in fields if one.name not in record.chains]
        unused = {one.reader.option: options.get(one.name) for one in others}
        unused["--estimate"] = options.get("estimate")
        refuse_unused(unused, beside=_("a drive line without cylinders"))


def _loaded(
    record: Analysis, name: str, settings: list[str] | None, *, estimate: bool
) -> tuple[Engine | Chain, Spread | None, dict[str, Any] | None]:
    """The source that is named, its ranges, and the tree of its file."""
    if record.chains:
        source, spread = engine_or_chain(name, settings, estimate=estimate)
        return source, spread, None
    if record.estimates:
        (engine, spread), tree = engine_over_ranges(name, settings, estimate=estimate)
        return engine, spread, tree
    engine, tree = engine_with_tree(name, settings)
    return engine, None, tree


def _over_speeds(options: dict[str, Any], fields: Sequence[Asked]) -> dict[str, Any]:
    """The options; a range that is given as one speed is one of speeds, where those are asked."""
    speed = options.get("speed")
    ranged = speed is not None and ".." in speed and options.get("speeds") is None
    if ranged and any(one.name == "speeds" for one in fields):
        return {**options, "speed": None, "speeds": speed}
    return options
