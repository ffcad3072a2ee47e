"""Numbers of the public functions as people give them: speeds, crank orders, places."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf
from typing import Any

from crankstar.engine.arguments import check_number as check_number  # with the other numbers
from crankstar.engine.arguments import is_number as is_number
from crankstar.engine.quantities import INERTIA, POWER, PRESSURE, SPEED, Quantity
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.numbers import RPM
from crankstar.language.quoting import given as quoted

GREATEST_BARE_SPEED = 2500.0
"""Of a speed without unit [rad/s], 23,900 rpm; a greater number was meant in rpm."""
BEYOND_ENGINES = 1e6
"""No engine turns so fast, in rad/s or rpm."""
GREATEST_ORDER = 1000
DIMENSIONS = 3
GREATEST_PLACE = 1000.0
"""Metres, as far as lengths along a crankshaft go."""


def speed(given: Any) -> float | str:
    """A speed in rad/s; `file` is for the function itself. Raises ValueError, TypeError."""
    if isinstance(given, str):
        if given == "file":
            return given
        from crankstar.files import units

        try:
            number = units.si(given, SPEED)
        except ValueFaultError as error:
            raise ValueError(error.at("speed")) from None
    elif is_number(given):
        number = float(given) if abs(given) < BEYOND_ENGINES else inf
        if GREATEST_BARE_SPEED < number < inf:
            raise ValueError(
                _(
                    "speed is {given} rad/s, which is {rpm} rpm; if {given} rpm is meant, write "
                    'speed="{given} rpm"',
                    given=f"{number:.6g}",
                    rpm=f"{number * RPM:.6g}",
                )
            )
    else:
        raise TypeError(
            _(
                'speed takes a number in rad/s or text such as "6000 rpm", not {given}',
                given=quoted(given),
            )
        )
    if not 0 < number < inf:
        raise ValueError(
            _(
                "speed is {given}; it must be greater than 0 and that of an engine, such as "
                '"6000 rpm"',
                given=quoted(given),
            )
        )
    return number


def speeds(given: Any) -> tuple[float, ...]:
    """Speeds in rad/s, or text as --speeds takes it. Raises ValueError, TypeError."""
    if isinstance(given, str):
        from crankstar.options import values
        from crankstar.options.refusals import RequestError
        from crankstar.studies.variants import SweepError

        try:
            return tuple(values.speeds(given))
        except (RequestError, SweepError) as error:
            raise ValueError(str(error).replace("--speeds", "speeds")) from None
    if not isinstance(given, Iterable):
        raise TypeError(
            _(
                'speeds takes a list of speeds or text such as "1000..6000 rpm", not {given}',
                given=quoted(given),
            )
        )
    return tuple(float(speed(each)) for each in given)


def pressure(argument: str, given: Any) -> float:
    """A pressure above nought, Pa, or text with its unit. Raises ValueError, TypeError."""
    return _positive(argument, given, PRESSURE, "10 bar")


def inertia(argument: str, given: Any) -> float:
    """A moment of inertia above nought, kg m^2, or text. Raises ValueError, TypeError."""
    return _positive(argument, given, INERTIA, "0.2 kg*m^2")


def power(argument: str, given: Any) -> float:
    """A power above nought, W, or text. Raises ValueError, TypeError."""
    return _positive(argument, given, POWER, "12 MW")


def _positive(argument: str, given: Any, quantity: Quantity, example: str) -> float:
    """A value above nought in SI, or text with its unit."""
    if isinstance(given, str):
        from crankstar.files import units

        try:
            number = units.si(given, quantity)
        except ValueFaultError as error:
            raise ValueError(error.at(argument)) from None
    elif is_number(given):
        number = float(given)
    else:
        raise TypeError(
            _(
                "{argument} takes a number in SI units or text such as {example}, not {given}",
                argument=argument,
                example=quoted(example),
                given=quoted(given),
            )
        )
    if not 0 < number < inf:
        raise ValueError(
            _(
                "{argument} is {given}; it must be greater than 0",
                argument=argument,
                given=quoted(given),
            )
        )
    return number


def orders(given: Any) -> tuple[float, ...]:
    """Crank orders, a list of numbers above 0. Raises ValueError, TypeError."""
    listed = given if isinstance(given, Iterable) and not isinstance(given, str) else None
    numbers = None if listed is None else [*listed]
    if numbers is None or not all(map(is_number, numbers)):
        raise TypeError(
            _("orders takes numbers such as [1, 2, 4], not {given}", given=quoted(given))
        )
    wrong = [order for order in numbers if not 0 < order <= GREATEST_ORDER]
    if wrong:
        raise ValueError(
            _(
                "orders has {given}; each must be greater than 0 and at most {greatest}",
                given=quoted(wrong[0]),
                greatest=GREATEST_ORDER,
            )
        )
    return tuple(map(float, numbers))


def check_place(argument: str, given: Any) -> None:
    """Raises TypeError for what is no number, ValueError for one far from any engine."""
    check_number(argument, given)
    if abs(given) > GREATEST_PLACE:
        raise ValueError(
            _(
                "{argument} is {given}; it must be within {greatest} m of the engine",
                argument=argument,
                given=quoted(given),
                greatest=f"{GREATEST_PLACE:g}",
            )
        )


def point(given: Any, _engine: Any = None) -> tuple[float, float, float]:
    """A point of the block: up, right, z in metres. Raises ValueError, TypeError."""
    if isinstance(given, Iterable) and not isinstance(given, str | bytes | Mapping):
        places = [*given]
        if len(places) == DIMENSIONS and all(map(is_number, places)):
            for each in places:
                check_place("at", each)
            up, right, z = map(float, places)
            return up, right, z
    raise TypeError(
        _(
            'at takes up, right and z in metres, text such as "-120 mm", or the name of a point of '
            "the block, not {given}",
            given=quoted(given),
        )
    )
