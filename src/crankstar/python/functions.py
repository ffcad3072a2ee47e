"""The function of each analysis: an engine and what is asked of it in, a Result out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from inspect import Parameter, Signature
from numbers import Integral, Real
from typing import Any, TypeVar, get_type_hints

from crankstar.analysis.reader import Asked, asked
from crankstar.analysis.record import Analysis
from crankstar.analysis.registry import analysis
from crankstar.engine.torsion import Chain
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given as quoted
from crankstar.options.sources import EngineLike, Loaded, loaded
from crankstar.options.vocabulary import OPTIONS, meaning
from crankstar.python.results import Result

T = TypeVar("T")
EXAMPLE = '{"cylinder.stroke": "90 mm"}'
"""Of values by key path."""
NUMBERS = ("nothing", "whole number")
"""What the parser of the command line reads as a number or a flag itself."""


@cache
def function(name: str) -> Callable[..., Result]:
    """The function of an analysis, with the arguments of its question. Raises KeyError.

    >>> function("mounts").__name__, [*function("torque").__signature__.parameters][:3]
    ('mounts', ['engine', 'speed', 'point'])
    """
    record = analysis(name)
    fields = asked(record.question.value)

    def ask(engine: EngineLike, /, **arguments: Any) -> Result:
        return answered(record, engine, arguments)

    hints = get_type_hints(record.question.value)
    keywords = [
        *(
            Parameter(
                one.name, Parameter.KEYWORD_ONLY, default=one.default, annotation=hints[one.name]
            )
            for one in fields
        ),
        Parameter(
            "changes", Parameter.KEYWORD_ONLY, default=None, annotation=Mapping[str, Any] | None
        ),
        *(
            [Parameter("estimate", Parameter.KEYWORD_ONLY, default=False, annotation=bool)]
            if record.estimates
            else []
        ),
    ]
    first = Parameter("engine", Parameter.POSITIONAL_ONLY, annotation=EngineLike)
    ask.__name__ = ask.__qualname__ = name
    ask.__module__ = "crankstar"
    ask.__doc__ = _docstring(record, fields)
    ask.__signature__ = Signature([first, *keywords], return_annotation=Result)
    return ask


def _docstring(record: Analysis, fields: Iterable[Asked]) -> str:
    """What the function computes, and what each argument is."""
    lines = [f"    {one.name}: {meaning(one.reader.option, one.reader.more)}" for one in fields]
    return "\n".join(
        [
            record.about,
            "",
            "Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.",
            "",
            *lines,
            f"    changes: values of the engine file by key path, such as {EXAMPLE}.",
            *(["    estimate: fill in what the file leaves out."] if record.estimates else []),
            "",
            f'>>> table = crankstar.{record.name}("{record.example}").to_frame()',
        ]
    )


def answered(record: Analysis, engine: EngineLike, arguments: Mapping[str, Any]) -> Result:
    """The result of an analysis. Raises TypeError, ValueError, MessageError of the analysis."""
    fields = {one.name: one for one in asked(record.question.value)}
    own = {"changes", *(["estimate"] if record.estimates else [])}
    for name in arguments:
        if name not in fields and name not in own:
            raise TypeError(
                _(
                    "{function} takes no argument {name}; it takes {names}",
                    function=record.name,
                    name=name,
                    names=", ".join(["engine", *fields, *sorted(own)]),
                )
            )
    source = _source(record, engine, arguments)
    values: dict[str, Any] = {}
    for name, one in fields.items():
        if arguments.get(name) is not None:
            values[name] = _value(one, arguments[name], source)
    question = record.question.value(**values)
    if record.refuse is not None:
        _in_python(record, partial(record.refuse.value, source.source, question))
    return Result(
        record,
        source.source,
        question,
        _in_python(record, partial(record.compute.value, source.source, question)),
        source,
    )


def _source(record: Analysis, engine: EngineLike, arguments: Mapping[str, Any]) -> Loaded:
    changes, estimate = arguments.get("changes"), arguments.get("estimate", False)
    if changes is not None and not isinstance(changes, Mapping):
        raise TypeError(
            _(
                "changes takes a dict of values by key path, such as {example}, not {given}",
                example=EXAMPLE,
                given=quoted(changes),
            )
        )
    if not isinstance(estimate, bool):
        raise TypeError(
            _(
                "{argument} takes True or False, not {given}",
                argument="estimate",
                given=quoted(estimate),
            )
        )
    source = loaded(engine, changes, estimate=estimate, asking=record.name)
    if isinstance(source.source, Chain) and not record.chains:
        raise TypeError(
            _(
                "{function} takes an engine, not a drive line without cylinders",
                function=record.name,
            )
        )
    return source


def _value(one: Asked, value: Any, source: Loaded) -> Any:
    """One argument, read as its reader reads it. Raises TypeError, ValueError."""
    beside = (source.source,) if one.reader.of_source else ()
    _check_kind(one, value)
    if not isinstance(value, str) and one.reader.number is not None:
        return one.reader.number(value, *beside)
    several = OPTIONS[one.reader.option].takes == "several texts"
    text = _text(one, value) if not isinstance(value, str) else [value] if several else value
    try:
        return one.reader.read(text, *beside)
    except MessageError as error:
        raise ValueError(str(error).replace(one.reader.option, one.name)) from None


def _check_kind(one: Asked, value: Any) -> None:
    """Raises TypeError for what is no flag or no whole number where one is asked for."""
    takes = OPTIONS[one.reader.option].takes
    if takes == "nothing" and not isinstance(value, bool):
        raise TypeError(
            _("{argument} takes True or False, not {given}", argument=one.name, given=quoted(value))
        )
    if takes == "whole number" and (isinstance(value, bool) or not isinstance(value, Integral)):
        raise TypeError(
            _(
                "{argument} takes a whole number, not {given}",
                argument=one.name,
                given=quoted(value),
            )
        )


def _text(one: Asked, value: Any) -> Any:
    """A value as the command line has it: numbers as they are, lists with commas, pairs with =."""
    several = OPTIONS[one.reader.option].takes == "several texts"
    if isinstance(value, Mapping):
        return [f"{key}={each}" for key, each in value.items()]
    if isinstance(value, Iterable):
        return [str(each) for each in value] if several else ",".join(str(each) for each in value)
    if isinstance(value, Real):
        return value if OPTIONS[one.reader.option].takes in NUMBERS else str(value)
    raise TypeError(
        _("{argument} takes a number or text, not {given}", argument=one.name, given=quoted(value))
    )


def _in_python(record: Analysis, done: Callable[[], T]) -> T:
    """What is done, its refusals with the names of arguments instead of those of options."""
    try:
        return done()
    except MessageError as error:
        text = str(error)
        for one in asked(record.question.value):
            text = text.replace(one.reader.option, one.name)
        if text == str(error):
            raise
        raise ValueError(text) from None
