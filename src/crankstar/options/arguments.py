"""Arguments of the public functions as people give them.

An engine may be an Engine, a name of the catalog or a path; a speed a number in rad/s or text with
its unit; a point of reference a Reference, z in metres, or text; planes metres or text. What is
something else is refused with a sentence that says what to give.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from inspect import Parameter, Signature, signature
from numbers import Real
from pathlib import Path
from typing import Any, TypeVar

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import POSITION
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.excitation import Reference
from crankstar.options.cycles import check_cycle
from crankstar.options.numbers import (
    check_highest,
    check_number,
    check_place,
    check_samples,
    cylinders,
    inertia,
    is_number,
    lacking,
    orders,
    pressure,
    share_of,
    speed,
)
from crankstar.options.varied import check_sweep, named

Result = TypeVar("Result")
READ_FILES = {"load", "widget"}
"""Functions that read engine files themselves."""
ENGINES = {"name", "engine", "beside"}
"""Their arguments that name an engine."""


def read(function: Callable[..., Result]) -> Callable[..., Result]:
    """The function, with its arguments read as people write them: by their names.

    >>> from crankstar.mechanics.balance import balance, total
    >>> twin = read(balance)("harley-45", reference="0 mm")
    >>> read(balance)(5)
    Traceback (most recent call last):
    TypeError: balance takes an Engine, a name of the catalog, a path or a dict of keys, not 5
    """
    asked = signature(function)
    name = function.__name__

    @wraps(function)
    def reading(*args: Any, **kwargs: Any) -> Result:
        try:
            bound = asked.bind(*args, **kwargs)
        except TypeError as error:
            raise TypeError(_miscalled(name, asked, error)) from None
        given = bound.arguments = _without_nothing(bound.arguments, asked)
        engine = _read_engines(name, given, asked.parameters)
        if "result" in given:
            _check_balance(name, given["result"])
        check_sweep(name, given)
        if "Cycle" in str(getattr(asked.parameters.get("cycle"), "annotation", "")):
            check_cycle(name, given)
        for argument, value in given.items():
            if argument in READERS and value is not None:
                given[argument] = READERS[argument](value)
            elif argument in MEASURED and value is not None:
                given[argument] = MEASURED[argument](argument, value)
            elif argument in CHECKS:
                CHECKS[argument](argument, value)
        if engine is not None:
            for argument, place in (("reference", _reference), ("planes", _planes)):
                if given.get(argument) is not None:
                    given[argument] = place(given[argument], engine)
        return function(*bound.args, **bound.kwargs)

    vars(reading)["__signature__"] = _as_read(name, asked)
    return reading


def _without_nothing(given: Mapping[str, Any], asked: Signature) -> dict[str, Any]:
    """Arguments without those that are None where None means nothing: they are left out."""

    def is_left_out(each: Parameter) -> bool:
        return each.default not in (None, Parameter.empty) and "None" not in str(each.annotation)

    return {
        name: value
        for name, value in given.items()
        if value is not None or not is_left_out(asked.parameters[name])
    }


def _as_read(function: str, asked: Signature) -> Signature:
    """A signature with the types that are read, as its editor and its reader see them."""
    return asked.replace(
        parameters=[
            each.replace(annotation=_taken(function, each)) for each in asked.parameters.values()
        ]
    )


def _taken(function: str, asked: Parameter) -> str:
    """The type of an argument, as source text."""
    own = str(asked.annotation)
    kept = function in READ_FILES and asked.name in ENGINES
    taken = own if kept else TAKES.get(asked.name, own)
    return f"{taken} | None" if own.endswith("None") and taken != own else taken


def _miscalled(name: str, asked: Signature, error: TypeError) -> str:
    """A call with too many arguments, too few, or others: how the function is called."""
    plain = [
        parameter.replace(annotation=Parameter.empty) for parameter in asked.parameters.values()
    ]
    form = str(asked.replace(parameters=plain, return_annotation=Signature.empty))
    return _("{mistake}; it is called {form}", mistake=f"{name}: {error}", form=f"{name}{form}")


def _read_engines(
    name: str, given: dict[str, Any], parameters: Mapping[str, Parameter]
) -> Engine | None:
    """Replace what names an engine by the engine, the first of which it gives.

    A function that reads files itself, whose keys it varies or shows, keeps names and paths.
    """
    if name in READ_FILES:
        for argument in ENGINES & given.keys():
            if argument != "beside" or given[argument] is not None:
                check_engine(name, given[argument])
    elif "engine" in given:
        named = given["engine"]
        given["engine"] = engine = _engine(name, named)
        if "str" in str(parameters["engine"]) and not isinstance(named, Engine):
            # it reads the file itself, whose keys it varies
            given["engine"] = named if isinstance(named, Mapping) else str(named)
        return engine
    elif "engines" in parameters:
        given["engines"] = tuple(_engine(name, each) for each in given.get("engines", ()))
        if not given["engines"]:
            raise TypeError(
                _(
                    "{function} takes one engine or more, as in {function}({example})",
                    function=name,
                    example='"i4", "i6"',
                )
            )
        return given["engines"][0]
    return None


def check_engine(function: str, given: Any) -> None:
    """Raises TypeError if it is no Engine and cannot name one."""
    if isinstance(given, str | Path) or (isinstance(given, Engine) and function != "load"):
        return
    if function == "load":
        raise TypeError(
            _(
                "{function} takes a name of the catalog or the path of an engine file, not {given}",
                function=function,
                given=named(given),
            )
        )
    _loaded(given, function)


def _loaded(given: Any, function: str) -> Any:
    from crankstar.options.sources import loaded  # no file is read without a name

    return loaded(given, asking=function).source


def _engine(function: str, given: Any) -> Engine:
    """An Engine as it is, or the one that is named. Raises TypeError, EngineFileError."""
    if isinstance(given, Engine):
        return given
    from crankstar.options.sources import engine_named  # no file is read without a name

    return engine_named(given, function)


def _check_balance(function: str, given: Any) -> None:
    """Raises TypeError if it is no Balance."""
    if isinstance(given, Balance):
        return
    raise TypeError(
        _(
            "{function} takes a Balance, not {given}; write {function}(crankstar.balance(engine))",
            function=function,
            given=named(given),
        )
    )


def _changes(given: Any) -> Mapping[str, Any]:
    """Values of an engine file by key path. Raises TypeError."""
    if isinstance(given, Mapping) and all(isinstance(key, str) for key in given):
        from crankstar.files.changes import with_traces  # no file is read without changes

        return with_traces(given, "changes")
    raise TypeError(
        _(
            "changes takes a dict of values by key path, such as {example}, not {given}",
            example='{"cylinder.stroke": "90 mm"}',
            given=_(
                "one with the key {key}",
                key=quoted(next(k for k in given if not isinstance(k, str))),
            )
            if isinstance(given, Mapping)
            else quoted(given),
        )
    )


def _tell(given: Any) -> Callable[..., Any]:
    """A function to be told of progress. Raises TypeError."""
    if callable(given):
        return given
    raise TypeError(
        _(
            "tell takes a function that is called with the progress, not {given}",
            given=quoted(given),
        )
    )


def _units(given: Any) -> str:
    """Units as --units takes them. Raises TypeError."""
    if isinstance(given, str):
        return given
    raise TypeError(
        _('units takes text such as "us" or "kN, kN m", not {given}', given=quoted(given))
    )


def _planes(given: Any, engine: Engine) -> list[float]:
    """Places along the shaft: metres, or text with a unit. Raises TypeError, ValueError."""
    from crankstar.files import bare_numbers

    listed = isinstance(given, Iterable) and not isinstance(given, str | bytes | Mapping)
    parts: list[Any] = [*given] if listed else [None]
    if any(isinstance(part, bool) or not isinstance(part, Real | str) for part in parts):
        raise TypeError(
            _(
                "planes takes places along the shaft in metres or as text, such as {example}, not "
                "{given}",
                example='[-0.2, 0.2] or ["-200 mm", "200 mm"]',
                given=quoted(given),
            )
        )
    for part in parts:
        if not isinstance(part, str):
            check_place("planes", part)
    read_place = bare_numbers.reader(frozenset(engine.relative))
    try:
        return [
            read_place(part, POSITION) if isinstance(part, str) else float(part) for part in parts
        ]
    except ValueFaultError as error:
        raise ValueError(error.at("planes")) from None


def _reference(given: Any, engine: Engine) -> Reference:
    """A point of reference. Raises ValueError, TypeError."""
    if isinstance(given, Reference):
        for name, place in given._asdict().items():
            check_place(f"reference.{name}", place)
        return given
    if isinstance(given, str):
        from crankstar.options import points
        from crankstar.options.refusals import RequestError

        try:
            point = points.reference(given, engine)
        except RequestError as error:
            raise ValueError(str(error).replace("--reference", "reference")) from None
        return point or Reference(0.0)
    if is_number(given):
        check_place("reference", given)
        return Reference(float(given))
    raise TypeError(
        _(
            'reference takes a crankstar.Reference, z in metres, or text such as "-120 mm", not '
            "{given}",
            given=quoted(given),
        )
    )


def _check_flag(argument: str, given: Any) -> None:
    """Raises TypeError for what is neither True nor False."""
    if not isinstance(given, bool):
        raise TypeError(
            _("{argument} takes True or False, not {given}", argument=argument, given=quoted(given))
        )


def _check_name(argument: str, given: Any) -> None:
    """Raises TypeError for what is neither text nor None."""
    if given is not None and not isinstance(given, str):
        raise TypeError(
            _("{argument} takes a name, not {given}", argument=argument, given=quoted(given))
        )


MEASURED: Mapping[str, Callable[[str, Any], Any]] = {
    **dict.fromkeys(("imep", "bmep", "peak_pressure"), pressure),
    "flywheel": inertia,
    "irregularity": share_of,
    "off": cylinders,
    "weaker": lacking,
}
"""The arguments that are quantities, by name: their readers."""
TAKES: Mapping[str, str] = {
    **dict.fromkeys(("engine", "engines"), "EngineLike"),
    **dict.fromkeys(("speed", "imep", "bmep", "peak_pressure", "flywheel"), "float | str"),
    "irregularity": "float | str",
    "reference": "Reference | float | str",
    "orders": "Iterable[float]",
    "planes": "Iterable[float | str]",
    "off": "Iterable[int] | int | str",
    "weaker": "Mapping[int, float | str]",
}
"""What arguments of these names may be, where they are read; in names of this module."""
READERS: Mapping[str, Callable[[Any], Any]] = {
    "speed": speed,
    "orders": orders,
    "changes": _changes,
    "tell": _tell,
    "units": _units,
}
"""What reads an argument of this name."""
CHECKS: Mapping[str, Callable[[str, Any], None]] = {
    **dict.fromkeys(("factor", "share"), check_number),
    **dict.fromkeys(("up", "right"), check_place),
    **dict.fromkeys(("bare", "estimate", "motored"), _check_flag),
    **dict.fromkeys(("model", "point", "shaft"), _check_name),
    "highest": check_highest,
    "samples": check_samples,
}
"""What refuses a wrong argument of this name."""
