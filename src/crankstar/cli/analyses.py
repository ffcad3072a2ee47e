"""The verbs of all analyses: an engine and the options of a question in, its document out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from inspect import Parameter as Argument
from inspect import Signature
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar.analysis.reader import Asked, asked, readings
from crankstar.analysis.record import Analysis
from crankstar.analysis.registry import analysis
from crankstar.cli.options import (
    Csv,
    Estimating,
    Json,
    Loaded,
    Output,
    Settings,
    engine_or_chain,
    loaded_engine,
    loaded_values,
    once,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.files.box import Spread
from crankstar.language.messages import _
from crankstar.options.forms import TABLES, form_of
from crankstar.options.values import refuse_unused
from crankstar.options.vocabulary import OPTIONS

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
        default=False if kind is bool else None,
        annotation=Annotated[kind, how] if kind is bool else Annotated[kind | None, how],
    )


def answer(record: Analysis, engine: str, options: dict[str, Any]) -> None:
    """Answer a command line: read all of it, compute, and write what it asks for."""
    output = options.get("output")
    forms = {name: bool(options.get(name)) for name in ("json", "csv")}
    source, spread, question, form = _read(record, engine, options, forms)
    with working(_(record.doing)), words_for(form):
        if isinstance(source, Chain):
            document = record.told(source, question)
        else:
            from crankstar.tables.ranges import ranged

            answered = partial(record.answer.value, source, question)
            rests = resting_on(form, source, answered)
            document = ranged(lambda each: record.told(each, question), spread, source, rests=rests)
    give(document, output, form=form)


def _read(
    record: Analysis, engine: str, options: dict[str, Any], forms: dict[str, bool]
) -> tuple[Engine | Chain, Spread | None, Any, str]:
    """The source with its ranges, the question and the form of the answer; or all errors."""
    fields = asked(record.question.value)
    estimate = bool(options.get("estimate"))
    load = once(partial(_loaded, record, engine, options.get("settings"), estimate=estimate))
    reading = readings(record.question.value, _over_speeds(options, fields), lambda: load()[0])
    form, (source, spread), *values = together(
        partial(form_of, options.get("output"), TABLES, **forms), load, *reading.values()
    )
    question = record.question.value(**dict(zip(reading, values, strict=True)))
    if isinstance(source, Chain):
        others = [one for one in fields if one.name not in record.chains]
        unused = {one.reader.option: options.get(one.name) for one in others}
        unused["--estimate"] = estimate
        refuse_unused(unused, beside=_("a drive line without cylinders"))
    if record.refuse is not None:
        record.refuse.value(source, question)
    return source, spread, question, form


def _loaded(
    record: Analysis, name: str, settings: list[str] | None, *, estimate: bool
) -> Loaded | tuple[Chain, None]:
    if record.chains:
        return engine_or_chain(name, settings, estimate=estimate)
    if record.estimates:
        return loaded_values(name, settings, estimate=estimate)
    return Loaded(loaded_engine(name, settings), None)


def _over_speeds(options: dict[str, Any], fields: Sequence[Asked]) -> dict[str, Any]:
    """The options; a range that is given as one speed is one of speeds, where those are asked."""
    speed = options.get("speed")
    ranged = speed is not None and ".." in speed and options.get("speeds") is None
    if ranged and any(one.name == "speeds" for one in fields):
        return {**options, "speed": None, "speeds": speed}
    return options
