"""Numbers of the public functions as people give them: speeds, crank orders, places."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from math import inf
from numbers import Integral
from typing import Any

from crankstar.engine.arguments import check_number as check_number  # with the other numbers
from crankstar.engine.arguments import is_number as is_number
from crankstar.engine.arguments import unboxed
from crankstar.engine.quantities import INERTIA, MASS, POWER, PRESSURE, SPEED, Quantity
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.numbers import RPM
from crankstar.language.quoting import given as quoted

GREATEST_BARE_SPEED = 2500.0
"""Of a speed without unit [rad/s], 23,900 rpm; a greater number was meant in rpm."""
BEYOND_ENGINES = 1e6
"""No engine turns so fast, in rad/s or rpm."""
GREATEST_ORDER = 1000
GREATEST_SAMPLES = 100_000
"""Crank angles of a cycle: a hundred times as many as any curve needs."""
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
    return positive(argument, given, PRESSURE, "10 bar")


def inertia(argument: str, given: Any) -> float:
    """A moment of inertia above nought, kg m^2, or text. Raises ValueError, TypeError."""
    return positive(argument, given, INERTIA, "0.2 kg*m^2")


def mass(argument: str, given: Any) -> float:
    """A mass above nought, kg, or text with its unit. Raises ValueError, TypeError."""
    return positive(argument, given, MASS, "5 g")


def power(argument: str, given: Any) -> float:
    """A power above nought, W, or text. Raises ValueError, TypeError."""
    return positive(argument, given, POWER, "12 MW")


def positive(argument: str, given: Any, quantity: Quantity, example: str) -> float:
    """A value above nought in SI, or text with its unit."""
    given = unboxed(given)
    if isinstance(given, str):
        from crankstar.files import units

        try:
            number = units.si(given, quantity)
        except ValueFaultError as error:
            raise ValueError(error.at(argument)) from None
    elif is_number(given):
        number = float(given) if abs(given) <= sys.float_info.max else inf
        check_number(argument, number)
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


def share_of(argument: str, given: Any) -> float:
    """A degree of irregularity: a number, or text such as "1/50". Raises ValueError, TypeError."""
    from crankstar.options.gas import degree_of_irregularity
    from crankstar.options.refusals import RequestError

    if not isinstance(given, str):
        check_number(argument, given)
    try:
        return degree_of_irregularity(str(given)) or 0.0
    except RequestError as error:
        raise ValueError(str(error).replace(f"--{argument}", argument)) from None


def cylinders(argument: str, given: Any) -> tuple[int, ...]:
    """Numbers of cylinders: one, several, or text such as "2,3". Raises TypeError.

    >>> cylinders("off", 1), cylinders("off", "2,3")
    ((1,), (2, 3))
    """
    parts = given.split(",") if isinstance(given, str) else given
    if not isinstance(parts, Iterable) or isinstance(parts, bytes | Mapping):
        parts = [parts]
    numbers = [_cylinder(each) for each in parts]
    if None in numbers:
        raise TypeError(
            _(
                "{argument} takes numbers of cylinders such as {example}, not {given}",
                argument=argument,
                example="[2, 3]",
                given=quoted(given),
            )
        )
    return tuple(number for number in numbers if number is not None)


def _cylinder(given: Any) -> int | None:
    """The number that one is, None for what is none."""
    if isinstance(given, str) and given.strip().isdecimal():
        return int(given)
    return int(given) if isinstance(given, Integral) and not isinstance(given, bool) else None


def lacking(argument: str, given: Any) -> dict[int, float]:
    """The share that each of some cylinders lacks, by its number. Raises ValueError, TypeError.

    >>> lacking("weaker", {3: 0.2, "4": "30%"})
    {3: 0.2, 4: 0.3}
    """
    from crankstar.options.gas import share
    from crankstar.options.refusals import RequestError

    shares = given.items() if isinstance(given, Mapping) else ()
    numbers = {_cylinder(key): value for key, value in shares}
    if not isinstance(given, Mapping) or None in numbers:
        raise TypeError(
            _(
                "{argument} takes a dict of the share that a cylinder lacks by its number, such as "
                "{example}, not {given}",
                argument=argument,
                example="{3: 0.2}",
                given=quoted(given),
            )
        )
    out: dict[int, float] = {}
    for key, value in numbers.items():
        try:
            lost = share(argument, value, value.strip()) if isinstance(value, str) else value
        except RequestError as error:
            raise ValueError(str(error)) from None
        check_number(argument, lost)
        out[key or 0] = float(lost)
    return out


def check_samples(argument: str, given: Any) -> None:
    """Raises TypeError for what is no whole number, ValueError for one below 1 or too large."""
    if not isinstance(given, Integral) or isinstance(given, bool):
        raise TypeError(
            _(
                "{argument} takes a whole number, not {given}",
                argument=argument,
                given=quoted(given),
            )
        )
    if not 1 <= int(given) <= GREATEST_SAMPLES:
        raise ValueError(
            _(
                "{argument} is {given}; it must be from 1 to {greatest}",
                argument=argument,
                given=quoted(given),
                greatest=GREATEST_SAMPLES,
            )
        )


def check_highest(argument: str, given: Any) -> None:
    """Raises TypeError for what is no number, ValueError for no order of a cycle."""
    from crankstar.mechanics.gas_torque import ALL

    if not is_number(given):
        check_number(argument, given)
    if not 0 < given <= ALL:
        raise ValueError(
            _(
                "{argument} is {given}; it must be greater than 0 and at most {greatest}",
                argument=argument,
                given=quoted(given),
                greatest=f"{ALL:g}",
            )
        )


def orders(given: Any) -> tuple[float, ...]:
    """Crank orders, a list of numbers above 0. Raises ValueError, TypeError."""
    given = unboxed(given)
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
