"""The function of each analysis: an engine and what is asked of it in, a Result out."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING
from functools import cache, partial
from inspect import Parameter, Signature
from numbers import Integral, Real
from pathlib import Path
from typing import Any, cast, get_type_hints

from crankstar.analysis.reader import Asked, Takes, asked
from crankstar.analysis.record import Analysis
from crankstar.analysis.registry import analysis
from crankstar.engine.arguments import unboxed
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given as quoted
from crankstar.options.refusals import refuse_unused
from crankstar.options.sources import EngineLike, Loaded, loaded
from crankstar.options.vocabulary import option_of
from crankstar.python.results import Result, in_python

EXAMPLE = '{"cylinder.stroke": "90 mm"}'
"""Of values by key path."""


@cache
def function(name: str) -> Callable[..., Result]:
    """The function of an analysis, with the arguments of its question. Raises KeyError.

    >>> function("mounts").__name__, [*function("torque").__signature__.parameters][:3]
    ('mounts', ['engine', 'speed', 'point'])
    """
    try:
        record = analysis(name)
    except KeyError:  # a hyphen of a command is no sign of a name
        record = analysis(name.replace("_", "-"))
    fields = arguments_of(record)
    first = [one.name for one in fields if one.reader.follows]
    first = first if record.engine == "none" else ["engine", *first]

    def ask(*words: Any, **arguments: Any) -> Result:
        if len(words) > len(first):
            raise TypeError(
                _(
                    "{function} takes {names} by position; give the others by name",
                    function=record.identifier,
                    names=", ".join(first),
                )
            )
        given = dict(zip(first, words, strict=False))
        if record.engine == "needed" and not words:
            raise TypeError(_("{function} needs {name}", function=record.identifier, name="engine"))
        return answered(record, given.pop("engine", None), {**given, **arguments})

    hints = get_type_hints(record.question.value)
    keywords = [
        *(
            Parameter(
                one.name,
                Parameter.POSITIONAL_OR_KEYWORD if one.reader.follows else Parameter.KEYWORD_ONLY,
                default=Parameter.empty if one.default is MISSING else one.default,
                annotation=hints[one.name],
            )
            for one in fields
        ),
        *(
            Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=kind)
            for name, (default, kind) in _of_files(record).items()
        ),
    ]
    ask.__name__ = ask.__qualname__ = name
    ask.__module__ = "crankstar"
    ask.__doc__ = _docstring(record, fields)
    ask.__signature__ = Signature([*_engine(record), *keywords], return_annotation=Result)
    return ask


def arguments_of(record: Analysis) -> tuple[Asked, ...]:
    """What a function is asked: the fields of a question, but for those that choose an engine."""
    chosen = () if record.writes is None else record.writes.chosen
    return tuple(one for one in asked(record.question.value) if one.name not in chosen)


def _engine(record: Analysis) -> list[Parameter]:
    """The argument of the engine, where the analysis is of one."""
    kind = Parameter.POSITIONAL_ONLY
    if record.engine == "optional":
        return [Parameter("engine", kind, default=None, annotation=EngineLike | None)]
    named = record.engine == "needed"
    return [Parameter("engine", kind, annotation=EngineLike)] if named else []


def _of_files(record: Analysis) -> dict[str, tuple[Any, Any]]:
    """Arguments about the file of an engine, each with its default and type."""
    if record.engine == "none":
        return {}
    own: dict[str, tuple[Any, Any]] = {"changes": (None, Mapping[str, Any] | None)}
    return own | ({"estimate": (False, bool)} if record.estimates else {})


def _docstring(record: Analysis, fields: Iterable[Asked]) -> str:
    """What the function computes, and what each argument is."""
    skip = "  # doctest: +SKIP" if ".toml" in record.example else ""
    lines = [f"    {one.name}: {meaning_of(one)}" for one in fields]
    of_files = _of_files(record)
    asked_of = f"crankstar.{record.identifier}({_example(record, fields)})"
    changes = f"    changes: values of the engine file by key path, such as {EXAMPLE}."
    return "\n".join(
        [
            record.about,
            "",
            "Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.",
            "",
            *lines,
            *([changes] if "changes" in of_files else []),
            *(
                ["    estimate: fill in what the file leaves out."]
                if "estimate" in of_files
                else []
            ),
            "",
            ">>> import crankstar",
            f">>> table = {asked_of}.to_frame(){skip}",
        ]
    )


def meaning_of(one: Asked) -> str:
    """What an argument means, as the help of the command says it."""
    if one.reader.follows:
        return one.reader.more
    return f"{option_of(one.reader).meaning} {one.reader.more}".rstrip()


def _example(record: Analysis, fields: Iterable[Asked]) -> str:
    """The arguments of an example: those of its command line."""
    names = {one.reader.option: one.name for one in fields}
    takes = {one.reader.option: _takes_what(one) for one in fields}
    words = shlex.split(record.example)
    out: list[str] = []
    while words:
        word = words.pop(0)
        if word not in names:
            out.append(word if word.isdecimal() else f'"{word}"')
        elif takes[word] == "nothing":
            out.append(f"{names[word]}=True")
        else:
            out.append(f'{names[word]}="{words.pop(0)}"')
    return ", ".join(out)


def answered(record: Analysis, engine: EngineLike | None, arguments: Mapping[str, Any]) -> Result:
    """The result of an analysis. Raises TypeError, ValueError, MessageError of the analysis."""
    fields = arguments_of(record)
    own = _of_files(record)
    for name in arguments:
        if name not in own and name not in [one.name for one in fields]:
            raise TypeError(_takes(record, name))
    for one in fields:
        if one.default is MISSING and arguments.get(one.name) is None:
            raise TypeError(_("{function} needs {name}", function=record.identifier, name=one.name))
    loaded_engine = _source(record, engine, arguments)
    source = None if loaded_engine is None else loaded_engine.source
    reading = {one.name: _reading(one, arguments, source) for one in fields}
    values: dict[str, Any] = {}
    for one in fields:
        beside = {name: values[name] for name in one.reader.beside}
        values[one.name] = reading[one.name](beside)
    question = record.question.value(**values)
    if record.needs is not None and isinstance(source, Engine):
        record.needs.value(source)
    if record.refuse is not None:
        in_python(record, partial(record.refuse.value, cast("Any", source), question))
    about = loaded_engine if record.of_file else source
    result = in_python(record, partial(record.compute.value, about, question))
    return Result(record, source, question, result, loaded_engine)


def _takes(record: Analysis, name: str) -> str:
    """What is said of an argument that there is not."""
    fields = [one.name for one in arguments_of(record)]
    first = [] if record.engine == "none" else ["engine"]
    return _(
        "{function} takes no argument {name}; it takes {names}",
        function=record.identifier,
        name=name,
        names=", ".join([*first, *fields, *_of_files(record)]),
    )


def _source(
    record: Analysis, engine: EngineLike | None, arguments: Mapping[str, Any]
) -> Loaded | None:
    changes, estimate = arguments.get("changes"), arguments.get("estimate", False)
    by_path = isinstance(changes, Mapping) and all(isinstance(key, str) for key in changes)
    if changes is not None and not by_path:
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
    if engine is None and record.engine != "needed":
        refuse_unused({"changes": changes, "estimate": estimate}, without="engine")
        return None
    source = loaded(
        cast("EngineLike", engine),
        changes,
        estimate=estimate,
        speed=arguments.get("speed"),
        asking=record.name,
    )
    if isinstance(source.source, Chain) and not record.chains:
        raise TypeError(
            _(
                "{function} takes an engine, not a drive line without cylinders",
                function=record.identifier,
            )
        )
    return source


def _reading(
    one: Asked, arguments: Mapping[str, Any], source: Engine | Chain | None
) -> Callable[[Mapping[str, Any]], Any]:
    """What reads one argument, from the values of the fields that it depends on."""
    value, reader = unboxed(arguments.get(one.name)), one.reader
    engine = (source,) if reader.of_source else ()

    def read(beside: Mapping[str, Any]) -> Any:
        if value is None:
            return one.default
        several = (
            reader.number is not None if reader.follows else _takes_what(one) == "several texts"
        )
        if isinstance(value, Mapping) and not several:
            raise TypeError(_("{argument} takes no dict", argument=one.name))
        try:
            if not isinstance(value, str) and reader.number is not None:
                return reader.number(value, *engine)
            return reader.read(_typed(one, value), *engine, **beside)
        except MessageError as error:
            raise ValueError(str(error).replace(reader.option, one.name)) from None

    return read


def _takes_what(one: Asked) -> Takes:
    """What an argument takes, as its option does."""
    return "text" if one.reader.follows else option_of(one.reader).takes


def _typed(one: Asked, value: Any) -> Any:
    """A value as the command line has it: lists with commas, pairs with =. Raises TypeError."""
    takes = _takes_what(one)
    if takes == "nothing":
        if isinstance(value, bool):
            return value
        raise TypeError(
            _("{argument} takes True or False, not {given}", argument=one.name, given=quoted(value))
        )
    if takes == "whole number":
        if isinstance(value, Integral) and not isinstance(value, bool):
            return int(value)
        raise TypeError(
            _(
                "{argument} takes a whole number, not {given}",
                argument=one.name,
                given=quoted(value),
            )
        )
    several = takes == "several texts"
    if isinstance(value, str | Path):
        return [str(value)] if several else str(value)
    if isinstance(value, Mapping):
        return [f"{key}={each}" for key, each in value.items()]
    if isinstance(value, Iterable) and not isinstance(value, bytes):
        return [str(each) for each in value] if several else ",".join(str(each) for each in value)
    if isinstance(value, Real) and not isinstance(value, bool):
        return [str(value)] if several else str(value)
    raise TypeError(
        _("{argument} takes a number or text, not {given}", argument=one.name, given=quoted(value))
    )
