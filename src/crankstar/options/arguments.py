"""Arguments of the public functions as people give them.

An engine may be an Engine, a name of the catalog or a path; a speed a number in rad/s or text with
its unit; a point of reference a Reference, z in metres, or text. What is something else is refused
with a sentence that says what to give.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from inspect import Parameter, signature
from math import isfinite, pi
from numbers import Real
from pathlib import Path
from typing import Any, TypeVar

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import SPEED
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.quoting import seen
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.excitation import Reference

Result = TypeVar("Result")
NUMBERS = {"factor", "share", "up", "right"}
"""Arguments that are one number."""
GREATEST_BARE_SPEED = 2500.0
"""Of a speed without unit [rad/s], 23,900 rpm; a greater number was meant in rpm."""


def read(function: Callable[..., Result]) -> Callable[..., Result]:
    """The function, with arguments named engine, engines, speed and reference read as people write.

    >>> from crankstar.mechanics.balance import balance, total
    >>> twin = read(balance)("harley-45", reference="0 mm")
    >>> read(balance)(5)
    Traceback (most recent call last):
    TypeError: balance takes an Engine, a name of the catalog or the path of an engine file, not 5
    """
    asked = signature(function)
    if not {"engine", "engines", "result"} & {*asked.parameters}:
        return function

    @wraps(function)
    def reading(*args: Any, **kwargs: Any) -> Result:
        bound = asked.bind(*args, **kwargs)
        given = bound.arguments
        named = given.get("engine")
        _read_engines(function.__name__, given, asked.parameters)
        if "result" in given:
            _check_balance(function.__name__, given["result"])
        if given.get("speed") is not None:
            given["speed"] = _speed(given["speed"])
        if given.get("orders") is not None:
            given["orders"] = _orders(given["orders"])
        for argument in NUMBERS & given.keys():
            _check_number(argument, given[argument])
        if given.get("reference") is not None:
            engine = given["engine"] if "engine" in given else given["engines"][0]
            given["reference"] = _reference(given["reference"], engine)
        if "str" in str(asked.parameters.get("engine")) and isinstance(named, str | Path):
            given["engine"] = str(named)  # it reads the file itself, whose keys it varies
        return function(*bound.args, **bound.kwargs)

    return reading


def _read_engines(name: str, given: dict[str, Any], parameters: Mapping[str, Parameter]) -> None:
    """Replace what names an engine by the engine."""
    if "engine" in given:
        given["engine"] = _engine(name, given["engine"])
    if "engines" in parameters:
        given["engines"] = tuple(_engine(name, each) for each in given.get("engines", ()))


def _engine(function: str, given: Any) -> Engine:
    """An Engine as it is, one of a name or path as `crankstar.load` reads it. Raises TypeError."""
    if isinstance(given, Engine):
        return given
    if isinstance(given, str | Path):
        from crankstar.files.catalog import load  # no file is read without a name

        return load(given)
    raise TypeError(
        _(
            "{function} takes an Engine, a name of the catalog or the path of an engine file, not "
            "{given}",
            function=function,
            given=seen(given),
        )
    )


def _check_balance(function: str, given: Any) -> None:
    """Raises TypeError if it is no Balance."""
    if isinstance(given, Balance):
        return
    raise TypeError(
        _(
            "{function} takes a Balance, not {given}; write {function}(crankstar.balance(engine))",
            function=function,
            given=f"Engine {seen(given.name)}" if isinstance(given, Engine) else seen(given),
        )
    )


def _speed(given: Any) -> float | str:
    """A speed in rad/s; `file` is for the function itself. Raises ValueError, TypeError."""
    if given == "file":
        return given
    if isinstance(given, str):
        from crankstar.files import units

        try:
            number = units.si(given, SPEED)
        except ValueFaultError as error:
            raise ValueError(error.at("speed")) from None
    elif isinstance(given, Real) and not isinstance(given, bool):
        number = float(given)
        if number > GREATEST_BARE_SPEED:
            raise ValueError(
                _(
                    "speed is {given} rad/s, which is {rpm} rpm; if {given} rpm is meant, write "
                    'speed="{given} rpm"',
                    given=f"{number:.6g}",
                    rpm=f"{number * 30 / pi:.6g}",
                )
            )
    else:
        raise TypeError(
            _(
                'speed takes a number in rad/s or text such as "6000 rpm", not {given}',
                given=seen(given),
            )
        )
    if not (isfinite(number) and number > 0):
        raise ValueError(
            _('speed is {given}; it must be greater than 0, such as "6000 rpm"', given=seen(given))
        )
    return number


def _orders(given: Any) -> tuple[float, ...]:
    """Crank orders, a list of numbers above 0. Raises ValueError, TypeError."""
    orders = given if isinstance(given, Iterable) and not isinstance(given, str) else None
    numbers = None if orders is None else [*orders]
    if numbers is None or not all(isinstance(number, Real) for number in numbers):
        raise TypeError(_("orders takes numbers such as [1, 2, 4], not {given}", given=seen(given)))
    out = tuple(map(float, numbers))
    if not all(isfinite(order) and order > 0 for order in out):
        raise ValueError(
            _("orders is {given}; each must be greater than 0, such as [1, 2]", given=seen(given))
        )
    return out


def _check_number(argument: str, given: Any) -> None:
    """Raises TypeError for what is no number, ValueError for one that is not finite."""
    if not isinstance(given, Real) or isinstance(given, bool):
        raise TypeError(
            _("{argument} takes a number, not {given}", argument=argument, given=seen(given))
        )
    if not isfinite(given):
        raise ValueError(
            _("{argument} is {given}; it must be finite", argument=argument, given=seen(given))
        )


def _reference(given: Any, engine: Engine) -> Reference:
    """A point of reference. Raises ValueError, TypeError."""
    if isinstance(given, Reference):
        for name, place in given._asdict().items():
            _check_number(f"reference.{name}", place)
        return given
    if isinstance(given, str):
        from crankstar.options import values
        from crankstar.options.refusals import RequestError

        try:
            point = values.reference(given, engine)
        except RequestError as error:
            raise ValueError(str(error).replace("--reference", "reference")) from None
        return point or Reference(0.0)
    if isinstance(given, Real) and not isinstance(given, bool):
        _check_number("reference", given)
        return Reference(float(given))
    raise TypeError(
        _(
            'reference takes a crankstar.Reference, z in metres, or text such as "-120 mm", not '
            "{given}",
            given=seen(given),
        )
    )
