"""Text with a unit to an SI number, and back; the only user of pint.

The number and the unit are taken apart here, so that pint only ever sees a short unit. A bare number is SI (radians for
angles), and is refused where nobody can have meant that: a stroke of 82.5 m, an angle of 90 rad, a speed without unit.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from crankstar.quantity import GREATEST_LENGTH, GREATEST_RELATIVE, Quantity, seen

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
newton = kilogram * metre / second^2 = N
kilonewton = 1000 * newton = kN
newtonmetre = newton * metre = Nm
kilonewtonmetre = 1000 * newton * metre = kNm
"""

_NUMBER = re.compile(r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL)
_UNIT = re.compile(r"[A-Za-z]{1,12}(?:\^-?[1-4])?(?:[*/][A-Za-z]{1,12}(?:\^-?[1-4])?){0,3}")
_REVOLUTIONS = {"1/min", "/min", "r/min", "min^-1"}
"""What a rotational speed in revolutions per minute is also written in."""

_SPELLINGS = str.maketrans(
    {"\u00b0": " deg", "\u00b2": "^2", "\u00b7": "*", "\u22c5": "*", "\u00b5": "u", "\u03bc": "u", "\u2212": "-"}
)
_LONGEST = 60
"""Letters: a longer text is no number with a unit."""
_GREATEST_NUMBER = 1e300


class _Kind(NamedTuple):
    """A dimension: its SI unit, its name in a sentence, the short unit, the greatest bare number and the greatest at all."""

    unit: str
    article: str
    short: str
    greatest_bare: float
    greatest: float


_KINDS = {
    "angle": _Kind("radian", "an angle", "rad", 6.2832, 1e4),
    "length": _Kind("metre", "a length", "m", 5.0, GREATEST_LENGTH),
    "length along the crankshaft": _Kind("metre", "a length", "m", 50.0, 1000.0),
    "mass": _Kind("kilogram", "a mass", "kg", 100.0, 1e6),
    "moment of inertia": _Kind("kilogram*metre^2", "a moment of inertia", "kg*m^2", 100.0, 1e7),
    "unbalance": _Kind("kilogram*metre", "an unbalance", "kg*m", 100.0, 1e7),
    "rotational speed": _Kind("radian/second", "a rotational speed", "rad/s", 0.0, 2e4),
    "force": _Kind("newton", "a force", "N", 1e12, 1e12),
    "couple": _Kind("newton*metre", "a couple", "N m", 1e12, 1e12),
}
_OTHERS = {
    "metre^2": "an area",
    "metre^3": "a volume",
    "second": "a time",
    "metre/second": "a speed along a line",
    "metre/second^2": "an acceleration",
    "kilogram/metre^3": "a density",
    "kilogram/metre": "a mass per length",
}
_SHOWN = {
    "angle": (57.29577951308232, "deg"),
    "length": (1000.0, "mm"),
    "length along the crankshaft": (1000.0, "mm"),
    "mass": (1.0, "kg"),
    "moment of inertia": (1.0, "kg*m^2"),
    "unbalance": (1.0, "kg*m"),
    "rotational speed": (9.549296585513721, "rpm"),
    "force": (1.0, "N"),
    "couple": (1.0, "N m"),
}


def si(value: Any, quantity: Quantity) -> float:
    """The SI number of a value from a file; raises ValueError with a sentence that says what would be right.

    >>> round(si("3.25 in", Quantity("length", "82.5 mm")), 6)
    0.08255
    >>> si("82 kg", Quantity("length", "82.5 mm"))
    Traceback (most recent call last):
    ValueError: is "82 kg", a mass; a length is needed, such as "82.5 mm"
    """
    number, has_unit = _read(value, quantity)
    kind = _KINDS[quantity.dimension]
    if not has_unit and abs(number) > kind.greatest_bare:
        raise ValueError(f"is {seen(value)} without a unit, and {number:g} {kind.short} cannot be meant; {_needed(quantity)}")
    if abs(number) > kind.greatest:
        raise ValueError(f"is {seen(value)}, too large for an engine; {_needed(quantity)}")
    if 0 < abs(number) < quantity.least:
        raise ValueError(f"is {seen(value)}, too small for an engine; {_needed(quantity)}")
    return number


def is_bare(text: str) -> bool:
    """Whether text is a number without a unit, other than nought."""
    try:
        return float(text) != 0
    except ValueError:
        return False


def reader(relative: frozenset[str], *, instead: str = "or give that") -> Callable[[Any, Quantity], float]:
    """The reader of one file's values; what is in `relative` is not known and must be a bare number, in units of itself.

    `instead` says what else than a bare number would help; in it `{name}` stands for what is not known.
    """

    def read(value: Any, quantity: Quantity) -> float:
        missing = quantity.relative_to & relative
        if not missing:
            return si(value, quantity)
        number, has_unit = _read(value, quantity)
        if has_unit and number != 0:
            raise ValueError(
                f"is {seen(value)}, but {_MISSING[min(missing)]}; give a bare number, {instead.format(name=min(missing))}"
            )
        if abs(number) > GREATEST_RELATIVE or 0 < abs(number) < quantity.least:
            raise ValueError(f"is {seen(value)}, out of all proportion; a bare number is needed, such as 1")
        return number

    return read


_MISSING = {
    "radius": "no stroke is known, so that lengths across the crankshaft are counted in crank radii",
    "pitch": "no bore pitch is known, so that lengths along the crankshaft are counted in bore pitches",
    "mass": "no reciprocating mass is known, so that masses are counted in it",
}


def _needed(quantity: Quantity) -> str:
    return f'{_KINDS[quantity.dimension].article} is needed, such as "{quantity.example}"'


def _read(value: Any, quantity: Quantity) -> tuple[float, bool]:
    """The SI number and whether it had a unit."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise ValueError(f"is {seen(value)}; {_needed(quantity)}")
    if not isinstance(value, str):
        if not abs(value) <= _GREATEST_NUMBER:
            raise ValueError(f"is {seen(value)}; {_needed(quantity)}")
        return float(value), False
    text = value.translate(_SPELLINGS).replace("**", "^")
    found = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    if found is None:
        raise ValueError(f"is {seen(value)}, not a number with a unit; {_needed(quantity)}")
    number, unit = float(found.group(1)), found.group(2)
    if re.match(r",\d", unit):
        raise ValueError(f'is {seen(value)}; write numbers with a decimal point and no other commas, as in "{quantity.example}"')
    if abs(number) > _GREATEST_NUMBER:
        raise ValueError(f"is {seen(value)}, too large for an engine; {_needed(quantity)}")
    return (number * _factor(unit, value, quantity), True) if unit else (number, False)


def _factor(unit: str, value: str, quantity: Quantity) -> float:
    """What one of `unit` is in SI; raises ValueError where it is not known or measures something else."""
    try:
        dimensions, factor = _unit(unit)
    except ValueError:
        near = {name.lower(): name for name in _names()}.get(unit.lower())
        meant = f' (did you mean "{near}"?)' if near else ""
        raise ValueError(f"is {seen(value)}, whose unit {seen(unit)} is not known{meant}; {_needed(quantity)}") from None
    if dimensions != _unit(_KINDS[quantity.dimension].unit)[0]:
        article = next((kind.article for kind in _KINDS.values() if _unit(kind.unit)[0] == dimensions), None)
        article = article or next(
            (name for unit, name in _OTHERS.items() if _unit(unit)[0] == dimensions), "another kind of quantity"
        )
        raise ValueError(f"is {seen(value)}, {article}; {_needed(quantity)}")
    return factor


def _names() -> Iterator[str]:
    """The names of all units, as they are written."""
    for line in _DEFINITIONS.strip().splitlines():
        name, _, *others = line.split(" = ")
        yield from (name, *others)


@lru_cache(maxsize=1)
def _registry() -> pint.UnitRegistry:
    import pint

    registry: pint.UnitRegistry = pint.UnitRegistry(None)  # pyright: ignore[reportArgumentType]
    registry.load_definitions(_DEFINITIONS.strip().splitlines())
    return registry


@lru_cache(maxsize=512)
def _unit(unit: str) -> tuple[str, float]:
    """Dimensions and factor to SI of a unit; angles are told apart from plain numbers."""
    spelt = re.sub(r"\s*([*/^])\s*", r"\1", unit)
    spelt = re.sub(r"([A-Za-z])(-?[1-4])", r"\1^\2", re.sub(r"\s+", "*", spelt))  # "kg m2" is kg*m^2
    spelt = "rpm" if spelt in _REVOLUTIONS else spelt
    if not _UNIT.fullmatch(spelt):
        raise ValueError(unit)
    registry = _registry()
    try:
        parsed = registry.parse_units(spelt)
        base: Any = registry.Quantity(1.0, parsed).to_base_units()
    except AttributeError:  # what pint raises for an unknown unit is one
        raise ValueError(unit) from None
    return str(base.units), float(base.magnitude)


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
