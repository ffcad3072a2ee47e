"""Text with a unit to an SI number, and back; the only user of pint.

The number and the unit are taken apart here, so that pint only ever sees a short unit. A bare number is SI (radians for
angles), and is refused where nobody can have meant that: a stroke of 82.5 m, an angle of 90 rad, a speed without unit.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from crankstar.quantity import Quantity

if TYPE_CHECKING:
    import pint

_DEFINITIONS = """
metre = [length] = m
kilogram = [mass] = kg
second = [time] = s
radian = [] = rad
degree = 0.017453292519943295 * radian = deg = degrees
turn = 6.283185307179586 * radian = rev = revolution = turns
millimetre = 0.001 * metre = mm = millimeter
centimetre = 0.01 * metre = cm = centimeter
micrometre = 1e-6 * metre = um
inch = 0.0254 * metre = in = inches
foot = 0.3048 * metre = ft = feet
gram = 0.001 * kilogram = g = grams
milligram = 1e-6 * kilogram = mg
tonne = 1000 * kilogram = t
pound = 0.45359237 * kilogram = lb = lbs
ounce = 0.028349523125 * kilogram = oz
minute = 60 * second = min
rpm = 0.10471975511965977 * radian / second
hertz = 6.283185307179586 * radian / second = Hz
"""

_NUMBER = re.compile(r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL)
_UNIT = re.compile(r"[A-Za-z]{1,12}(?:\^-?[1-4])?(?:\s*[*/]\s*[A-Za-z]{1,12}(?:\^-?[1-4])?){0,3}")

# Per dimension: SI unit, the plural a sentence needs, the greatest bare number anyone can have meant, and the greatest at all.
_KINDS: dict[str, tuple[str, str, float, float]] = {
    "angle": ("radian", "an angle", 6.2832, 1e4),
    "length": ("metre", "a length", 5.0, 100.0),
    "length along the crankshaft": ("metre", "a length", 50.0, 1000.0),
    "mass": ("kilogram", "a mass", 100.0, 1e6),
    "moment of inertia": ("kilogram*metre^2", "a moment of inertia", 100.0, 1e7),
    "unbalance": ("kilogram*metre", "an unbalance", 100.0, 1e7),
    "rotational speed": ("radian/second", "a rotational speed", 0.0, 2e4),
}
_SMALLEST = 1e-7
_SHOWN = {
    "angle": (57.29577951308232, "deg"),
    "length": (1000.0, "mm"),
    "length along the crankshaft": (1000.0, "mm"),
    "mass": (1.0, "kg"),
    "moment of inertia": (1.0, "kg*m^2"),
    "unbalance": (1.0, "kg*m"),
    "rotational speed": (9.549296585513721, "rpm"),
}


def si(value: Any, quantity: Quantity) -> float:
    """The SI number of a value from a file; raises ValueError with a sentence that says what would be right.

    >>> from crankstar.engine import Throw
    >>> round(si("3.25 in", Quantity("length", "82.5 mm")), 6)
    0.08255
    """
    number, _ = _read(value, quantity)
    return _plausible(number, value, quantity)


def reader(relative: frozenset[str]) -> Callable[[Any, Quantity], float]:
    """The reader of one file's values; what is in `relative` is not known and must be a bare number, in units of itself."""

    def read(value: Any, quantity: Quantity) -> float:
        missing = quantity.relative_to & relative
        if not missing:
            return si(value, quantity)
        number, has_unit = _read(value, quantity)
        if has_unit and number != 0:
            raise ValueError(f'is "{value}", but {_MISSING[min(missing)]}; give a bare number, or give that')
        if abs(number) > 1e6 or 0 < abs(number) < _SMALLEST:
            raise ValueError(f"is {number:g}, out of all proportion")
        return number

    return read


_MISSING = {
    "radius": "no stroke is known, so that lengths across the crankshaft are counted in crank radii",
    "pitch": "no bore pitch is known, so that lengths along the crankshaft are counted in bore pitches",
    "mass": "no reciprocating mass is known, so that masses are counted in it",
}


def _read(value: Any, quantity: Quantity) -> tuple[float, bool]:
    """The SI number and whether it had a unit."""
    _, article, _, _ = _KINDS[quantity.dimension]
    wanted = f'{article} is needed, such as "{quantity.example}"'
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise ValueError(f"is not a number; {wanted}")
    if not isinstance(value, str):
        if abs(value) > 1e300:
            raise ValueError(f"is too large; {wanted}")
        number = float(value)
        if number != number:
            raise ValueError(f"is not a number; {wanted}")
        return number, False
    text = value.replace("\u00b0", " deg").replace("\u00b2", "^2").replace("\u00b7", "*").replace("\u00b5", "u").replace("**", "^")
    found = _NUMBER.fullmatch(text) if len(text) <= 60 else None
    if found is None:
        shown = value if len(value) <= 40 else value[:37] + "..."
        raise ValueError(f'"{shown}" is not a number with a unit; {wanted}')
    number, unit = float(found.group(1)), found.group(2)
    if re.match(r",\d", unit):
        raise ValueError(f'"{value}": use a decimal point, as in "{quantity.example}"')
    if abs(number) == float("inf"):
        raise ValueError(f'"{value}" is too large; {wanted}')
    if not unit:
        return number, False
    return number * _factor(unit, value, quantity), True


def _factor(unit: str, value: str, quantity: Quantity) -> float:
    target, article, _, _ = _KINDS[quantity.dimension]
    wanted = f'{article} is needed, such as "{quantity.example}"'
    try:
        dimensions, factor = _unit(unit)
    except ValueError:
        raise ValueError(f'"{value}": the unit "{unit}" is not known; {wanted}') from None
    if dimensions != _unit(target)[0]:
        actual = next((a for t, a, _, _ in _KINDS.values() if _unit(t)[0] == dimensions), None)
        raise ValueError(f'"{value}" is {actual or "something else"}; {wanted}')
    return factor


@lru_cache(maxsize=1)
def _registry() -> pint.UnitRegistry:
    import pint

    registry: pint.UnitRegistry = pint.UnitRegistry(None)  # pyright: ignore[reportArgumentType]
    registry.load_definitions(_DEFINITIONS.strip().splitlines())
    return registry


@lru_cache(maxsize=512)
def _unit(unit: str) -> tuple[str, float]:
    """Dimensions and factor to SI of a unit; angles are told apart from plain numbers."""
    if not _UNIT.fullmatch(unit):
        raise ValueError(unit)
    registry = _registry()
    try:
        parsed = registry.parse_units(unit.replace(" ", ""))
        base: Any = registry.Quantity(1.0, parsed).to_base_units()
    except AttributeError:  # what pint raises for an unknown unit is one
        raise ValueError(unit) from None
    return str(base.units), float(base.magnitude)


def _plausible(number: float, value: Any, quantity: Quantity) -> float:
    _, article, greatest_bare, greatest = _KINDS[quantity.dimension]
    bare = not isinstance(value, str) or (_NUMBER.fullmatch(value) is not None and not _NUMBER.fullmatch(value).group(2))  # pyright: ignore[reportOptionalMemberAccess]
    if bare and abs(number) > greatest_bare:
        unit = _si_name(quantity)
        raise ValueError(
            f'{value} has no unit, and {number:g} {unit} cannot be meant; write it with one, such as "{quantity.example}"'
        )
    if abs(number) > greatest:
        raise ValueError(f'"{value}" is too large for {article} of an engine; {quantity.example} is the order of size expected')
    if 0 < abs(number) < _SMALLEST and quantity.dimension not in ("angle", "moment of inertia", "unbalance"):
        raise ValueError(f'"{value}" is too small for {article} of an engine; {quantity.example} is the order of size expected')
    return number


def _si_name(quantity: Quantity) -> str:
    short = {"radian": "rad", "metre": "m", "kilogram": "kg", "radian/second": "rad/s"}
    return short.get(_KINDS[quantity.dimension][0], _KINDS[quantity.dimension][0])


def text(number: float, quantity: Quantity, *, digits: int = 15) -> str:
    """An SI number as text with the unit a reader expects; reading it back gives the number to rounding.

    >>> text(0.0825, Quantity("length", "82.5 mm"))
    '82.5 mm'
    """
    factor, unit = _SHOWN[quantity.dimension]
    if quantity.dimension == "mass" and 0 < abs(number) < 1:
        factor, unit = 1000.0, "g"
    shown = f"{number * factor:.{digits}g}"
    return f"{shown} {unit}"
