"""What the words of a command line ask for: speeds, orders, angles, a point of reference, settings; or what is wrong with them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isfinite
from typing import Any, Literal, get_args

from crankstar import units
from crankstar.balance import Grouping
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.quantity import ANGLE, LENGTH, POSITION, SPEED, Quantity, one_line, seen

Derived = Literal["force", "couple"]


class RequestError(ValueError):
    """A request that cannot be met, as one sentence that says what would be right."""


def setting(text: str) -> tuple[str, Any]:
    """A --set argument: a key path and a value, which is TOML where it can be read so, else text."""
    import tomllib

    path, equals, value = text.partition("=")
    if not equals or not path.strip():
        raise RequestError(f'--set {one_line(text)}: give a key path and a value, as in --set layout.bore_pitch="100 mm"')
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except (ValueError, RecursionError):  # not TOML, or a number of thousands of digits
        return path.strip(), value


def speed(text: str | None) -> float | None:
    """A crank speed in rad/s."""
    if text is None:
        return None
    try:
        found = units.si(text, SPEED)
    except ValueError as error:
        raise RequestError(f"--speed: {error}") from None
    if found <= 0:
        raise RequestError(f'--speed: is {seen(text)}; it must be greater than 0, such as "{SPEED.example}"')
    return found


def orders(text: str | None, present: list[float]) -> list[float] | None:
    """Crank orders; all is those that are present."""
    if text is None:
        return None
    if text.strip() == "all":
        return present
    try:
        wanted = [float(part) for part in text.split(",") if part.strip()]
    except ValueError:
        wanted = []
    if not wanted or not all(isfinite(order) and 0 < order <= 1000 for order in wanted) or len(wanted) > 200:
        raise RequestError(f"--orders {one_line(text)}: give numbers from above 0 up to 1000 with commas, as in 1,2,4,6, or all")
    return list(dict.fromkeys(wanted))


def quantities(text: str | None) -> list[Derived]:
    """Which quantities to derive: one, or both."""
    if text is not None and text not in get_args(Derived):
        raise RequestError(f"--quantity {one_line(text)}: it can be {', '.join(get_args(Derived))}")
    return [one for one in get_args(Derived) if text in (None, one)]


def derived_orders(text: str) -> list[Fraction]:
    """Crank orders to derive, whole, decimal or as fractions; all is those that textbooks give: 1, 2, 4, 6."""
    if text.strip() == "all":
        return [Fraction(order) for order in (1, 2, 4, 6)]
    parts = [part.strip() for part in text.split(",") if part.strip()]
    try:
        wanted = [Fraction(part) for part in parts if len(part) < 20 and "e" not in part.lower()]
    except (ValueError, ZeroDivisionError):
        wanted = []
    if not wanted or len(wanted) < len(parts) or len(wanted) > 24:
        raise RequestError(f"--order {one_line(text)}: give up to 24 crank orders with commas, as in 2 or 1,2,4,6 or 29/31, or all")
    return list(dict.fromkeys(wanted))


def angles(text: str | None) -> list[float]:
    """Crank angles in radians."""
    try:
        return [units.si(part.strip(), ANGLE) for part in (text or "").split(",") if part.strip()]
    except ValueError as error:
        raise RequestError(f"--at: {error}") from None


def grouping(text: str | None) -> Any:
    """By what parts are grouped."""
    if text is not None and text not in get_args(Grouping):
        raise RequestError(f"--by {one_line(text)}: it can be {', '.join(get_args(Grouping))}")
    return text


def reference(text: str | None, engine: Engine) -> Reference | None:
    """A point of reference in the units of the engine."""
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    example = 'as in "-120 mm" (z) or "0 mm, 35 mm, 0 mm" (z, up, right)'
    if len(parts) not in (1, 3):
        raise RequestError(f"--reference {one_line(text)}: give z, or z, up and right, {example}")
    return Reference(*_places("--reference", parts, [POSITION, LENGTH, LENGTH], engine, example))


def planes(text: str | None, engine: Engine) -> list[float] | None:
    """Places along the shaft in the units of the engine."""
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",") if part.strip()]
    if not 2 <= len(parts) <= 64:
        raise RequestError(f'--planes {one_line(text)}: give two or more places along the shaft, as in "-200 mm, 200 mm"')
    return _places("--planes", parts, [POSITION] * len(parts), engine, 'as in "-200 mm, 200 mm"')


def ratios(text: str | None) -> list[Fraction]:
    """Speed ratios of balance shafts."""
    parts = [part.strip() for part in (text or "").split(",") if part.strip()]
    try:
        found = [Fraction(part) for part in parts if len(part) < 20 and "e" not in part.lower()]
    except (ValueError, ZeroDivisionError):
        found = []
    if len(found) < len(parts) or (text is not None and not found) or len(found) > 8:
        raise RequestError(
            f'--shafts {one_line(text or "")}: give speed ratios with commas, negative against the crank, as in -1 or "2, -2"'
        )
    return found


def _places(option: str, parts: list[str], marks: list[Quantity], engine: Engine, example: str) -> list[float]:
    """Lengths with their units, or bare where the engine counts in units of its own."""
    read = units.reader(frozenset(engine.relative))
    for part, mark in zip(parts, marks, strict=False):
        if units.is_bare(part) and not mark.relative_to & frozenset(engine.relative):
            raise RequestError(f"{option} {one_line(part)}: has no unit; write it with one, {example}")
    try:
        return [read(part, mark) for part, mark in zip(parts, marks, strict=False)]
    except ValueError as error:
        raise RequestError(f"{option}: {error}, {example}") from None


def alone(option: str, others: Mapping[str, object]) -> None:
    """Refuse what an option has no use for, rather than leave it unheeded."""
    idle = [name for name, value in others.items() if value is not None]
    if idle:
        raise RequestError(f"{option} has no use for {', '.join(idle)}; leave {'it' if len(idle) == 1 else 'them'} out")
