"""Text with a unit to an SI number, and back.

A bare number is SI (radians for angles), and is refused where nobody can have meant that: a stroke
of 82.5 m, an angle of 90 rad, a speed without unit. The definitions are written as pint reads them:
it would do the same, but takes longer to load than all that follows; the tests ask it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from functools import lru_cache
from typing import Any, Literal, NamedTuple

from crankstar.engine.quantities import GREATEST_LENGTH, GREATEST_RELATIVE, Quantity
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen

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

_NUMBER = re.compile(
    r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)
_FACTOR = re.compile(r"([*/]?)\s*(?:([\d.]+(?:e-?\d+)?)|([A-Za-z]+))(?:\^(-?\d))?")
_UNIT = re.compile(r"[A-Za-z]{1,12}(?:\^-?[1-4])?(?:[*/][A-Za-z]{1,12}(?:\^-?[1-4])?){0,3}")
_REVOLUTIONS = {"1/min", "/min", "r/min", "min^-1"}
"""What a rotational speed in revolutions per minute is also written in."""

_SPELLINGS = str.maketrans(
    {
        "\u00b0": " deg",
        "\u00b2": "^2",
        "\u00b7": "*",
        "\u22c5": "*",
        "\u00b5": "u",
        "\u03bc": "u",
        "\u2212": "-",
    }
)
_LONGEST = 60
"""Letters: a longer text is no number with a unit."""
_GREATEST_NUMBER = 1e300


class _Kind(NamedTuple):
    """A dimension: its SI unit, short unit, greatest bare number, greatest number."""

    unit: str
    short: str
    greatest_bare: float
    greatest: float


_KINDS = {
    "angle": _Kind("radian", "rad", 6.2832, 1e4),
    "length": _Kind("metre", "m", 5.0, GREATEST_LENGTH),
    "length along the crankshaft": _Kind("metre", "m", 50.0, 1000.0),
    "mass": _Kind("kilogram", "kg", 100.0, 1e6),
    "moment of inertia": _Kind("kilogram*metre^2", "kg*m^2", 100.0, 1e7),
    "unbalance": _Kind("kilogram*metre", "kg*m", 100.0, 1e7),
    "rotational speed": _Kind("radian/second", "rad/s", 0.0, 2e4),
    "force": _Kind("newton", "N", 1e12, 1e12),
    "couple": _Kind("newton*metre", "N m", 1e12, 1e12),
    "stiffness": _Kind("newton/metre", "N/m", 1e13, 1e13),
    "bending stiffness": _Kind("newton*metre^2", "N*m^2", 1e13, 1e13),
}
_OTHERS = {
    "area": "metre^2",
    "volume": "metre^3",
    "time": "second",
    "speed along a line": "metre/second",
    "acceleration": "metre/second^2",
    "density": "kilogram/metre^3",
    "mass per length": "kilogram/metre",
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
    "stiffness": (1.0, "N/m"),
    "bending stiffness": (1.0, "N*m^2"),
}


def si(value: Any, quantity: Quantity) -> float:
    """The SI number of a value from a file; raises ValueFaultError with the right form.

    >>> round(si("3.25 in", Quantity("length", "82.5 mm")), 6)
    0.08255
    >>> si("82 kg", Quantity("length", "82.5 mm"))  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    crankstar...ValueFaultError: the value is "82 kg", a mass; a length is needed, such as "82.5 mm"
    """
    number, has_unit = _read(value, quantity)
    kind = _KINDS[quantity.dimension]
    if not has_unit and abs(number) > kind.greatest_bare:
        raise _implausible(value, number, quantity)
    if abs(number) > kind.greatest:
        raise _fault("unit.too-large", value, quantity)
    if 0 < abs(number) < quantity.least:
        raise _fault("unit.too-small", value, quantity)
    return number


def is_bare(text: str) -> bool:
    """Whether text is a number without a unit, other than nought."""
    try:
        return float(text) != 0
    except ValueError:
        return False


def reader(
    relative: frozenset[str], *, because: Literal["unknown", "relative"] = "unknown"
) -> Callable[[Any, Quantity], float]:
    """The reader of one file's values; those in `relative` are bare numbers in units of themselves.

    `because`: the file does not give it, or says in `relative` that it is not known.
    """

    def read(value: Any, quantity: Quantity) -> float:
        missing = quantity.relative_to & relative
        if not missing:
            return si(value, quantity)
        number, has_unit = _read(value, quantity)
        if has_unit and number != 0:
            raise ValueFaultError(f"unit.{because}-{min(missing)}", value=seen(value))
        if abs(number) > GREATEST_RELATIVE or 0 < abs(number) < quantity.least:
            raise ValueFaultError("unit.bare-out-of-range", value=seen(value))
        return number

    return read


def _fault(code: str, value: Any, quantity: Quantity, **values: Any) -> ValueFaultError:
    example = f'"{quantity.example}"'
    return ValueFaultError(
        code, value=seen(value), dimension=quantity.dimension, example=example, **values
    )


def _implausible(value: Any, number: float, quantity: Quantity) -> ValueFaultError:
    """A bare number larger than any real one: it was meant in the unit that people write."""
    kind = _KINDS[quantity.dimension]
    factor, meant = _SHOWN[quantity.dimension]
    if not kind.greatest_bare or factor == 1.0:
        return _fault("unit.missing", value, quantity)
    return ValueFaultError(
        "unit.implausible", number=number, unit=kind.short, greatest=kind.greatest_bare, meant=meant
    )


def _read(value: Any, quantity: Quantity) -> tuple[float, bool]:
    """The SI number and whether it had a unit."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise _fault("unit.needed", value, quantity)
    if not isinstance(value, str):
        if not abs(value) <= _GREATEST_NUMBER:
            raise _fault("unit.needed", value, quantity)
        return float(value), False
    text = value.translate(_SPELLINGS).replace("**", "^")
    match = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise _fault("unit.not-a-number", value, quantity)
    number, unit = float(match.group(1)), match.group(2)
    if re.match(r",\d", unit):
        raise _fault("unit.decimal-comma", value, quantity)
    if abs(number) > _GREATEST_NUMBER:
        raise _fault("unit.too-large", value, quantity)
    return (number * _factor(unit, value, quantity), True) if unit else (number, False)


def _factor(unit: str, value: str, quantity: Quantity) -> float:
    """What one of `unit` is in SI.

    Raises ValueFaultError where it is not known or measures something else.
    """
    try:
        dimensions, factor = _unit(unit)
    except ValueError:
        near = {name.lower(): name for name in _definitions()}.get(unit.lower())
        if near:
            raise _fault(
                "unit.misspelt", value, quantity, unit=seen(unit), meant=f'"{near}"'
            ) from None
        raise _fault("unit.unknown", value, quantity, unit=seen(unit)) from None
    if dimensions != _unit(_KINDS[quantity.dimension].unit)[0]:
        named = [(name, kind.unit) for name, kind in _KINDS.items()] + list(_OTHERS.items())
        measured = next((name for name, of in named if _unit(of)[0] == dimensions), "other")
        raise _fault("unit.other-dimension", value, quantity, measured=measured)
    return factor


@lru_cache(maxsize=1)
def _definitions() -> dict[str, str]:
    """The definition of every unit by each of its names."""
    lines = (line.split(" = ") for line in _DEFINITIONS.strip().splitlines())
    return {name: parts[1] for parts in lines for name in (parts[0], *parts[2:])}


@lru_cache(maxsize=512)
def _unit(unit: str) -> tuple[frozenset[tuple[str, int]], float]:
    """Dimensions and factor to SI of a unit; angles are distinguished from plain numbers."""
    spelt = re.sub(r"\s*([*/^])\s*", r"\1", unit)
    spelt = re.sub(
        r"([A-Za-z])(-?[1-4])", r"\1^\2", re.sub(r"\s+", "*", spelt)
    )  # "kg m2" is kg*m^2
    spelt = "rpm" if spelt in _REVOLUTIONS else spelt
    if not _UNIT.fullmatch(spelt):
        raise ValueError(unit)
    return _product(spelt)


def _product(expression: str) -> tuple[frozenset[tuple[str, int]], float]:
    """Dimensions with their powers, and factor to SI, of a product of numbers and units."""
    powers: Counter[str] = Counter()
    factor = 1.0
    for divided, number, name, power in _FACTOR.findall(expression):
        exponent = int(power or 1) * (-1 if divided == "/" else 1)
        own, size = (frozenset(), float(number)) if number else _named(name)
        factor *= size**exponent
        powers.update({kind: exponent * each for kind, each in own})
    return frozenset((kind, power) for kind, power in powers.items() if power), factor


@lru_cache(maxsize=128)
def _named(name: str) -> tuple[frozenset[tuple[str, int]], float]:
    """What a single unit is; "kilograms" are kilogram. Raises ValueError."""
    known = _definitions()
    plural = len(name) > 2 and name.endswith("s")  # but "ms" is no metres
    definition = known.get(name) or (known.get(name[:-1]) if plural else None)
    if definition is None:
        raise ValueError(name)
    if definition.startswith("["):
        return frozenset({(definition, 1)}), 1.0
    return _product(definition)


def text(number: float, quantity: Quantity, *, digits: int = 15) -> str:
    """An SI number as text with the unit a reader expects.

    Reading it back gives the number to rounding.

    >>> text(0.0825, Quantity("length", "82.5 mm"))
    '82.5 mm'
    """
    factor, unit = _SHOWN[quantity.dimension]
    if quantity.dimension == "mass" and 0 < abs(number) < 1:
        factor, unit = 1000.0, "g"
    shown = f"{number * factor:.{digits}g}"
    return f"{shown} {unit}"
