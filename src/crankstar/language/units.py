"""The units that are read and shown: names, dimensions, factors to SI.

The definitions are written as pint reads them: it would do the same, but takes longer to load than
all that follows; the tests ask it. The units of results are chosen in `shown_units`.
"""

from __future__ import annotations

import re
from collections import Counter
from functools import lru_cache
from typing import NamedTuple

DEFINITIONS = """
metre = [length] = m
kilogram = [mass] = kg
second = [time] = s
kelvin = [temperature] = K
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
litre = 0.001 * metre^3 = l = L = liter
cc = 1e-6 * metre^3
minute = 60 * second = min
rpm = 0.10471975511965977 * radian / second
hertz = 6.283185307179586 * radian / second = Hz
newton = kilogram * metre / second^2 = N
kilonewton = 1000 * newton = kN
meganewton = 1e6 * newton = MN
kilogramforce = 9.80665 * newton = kgf
poundforce = 4.4482216152605 * newton = lbf
ounceforce = 0.27801385095378125 * newton = ozf
pascal = newton / metre^2 = Pa
hectopascal = 100 * pascal = hPa
kilopascal = 1000 * pascal = kPa
megapascal = 1e6 * pascal = MPa
gigapascal = 1e9 * pascal = GPa
millipascal = 1e-3 * pascal = mPa
bar = 1e5 * pascal = bars
millibar = 100 * pascal = mbar
atmosphere = 101325 * pascal = atm
psi = 6894.757293168361 * pascal
newtonmetre = newton * metre = Nm
kilonewtonmetre = 1000 * newton * metre = kNm
meganewtonmetre = 1e6 * newton * metre = MNm
watt = newton * metre / second = W
kilowatt = 1000 * watt = kW
megawatt = 1e6 * watt = MW
horsepower = 745.6998715822702 * watt = hp
metrichorsepower = 735.49875 * watt = PS
"""
"""Units as pint reads them too: base dimensions in brackets, products of numbers and units."""

_FACTOR = re.compile(r"([*/]?)\s*(?:([\d.]+(?:e-?\d+)?)|([A-Za-z]+))(?:\^(-?\d))?")
_UNIT = re.compile(r"[A-Za-z]{1,12}(?:\^-?[1-4])?(?:[*/][A-Za-z]{1,12}(?:\^-?[1-4])?){0,3}")
_REVOLUTIONS = {"1/min", "/min", "r/min", "min^-1"}
"""What a rotational speed in revolutions per minute is also written in."""
_WEIGHTS: dict[str, str] = {
    **dict.fromkeys(("lb", "lbs", "pound", "pounds"), "lbf"),
    **dict.fromkeys(("oz", "ounce", "ounces"), "ozf"),
}
"""Names of masses that also stand for the weight of the mass."""
SIGNS = str.maketrans(
    {
        "\u00b0": " deg",
        "\u00b2": "^2",
        "\u00b7": "*",
        "\u22c5": "*",
        "\u00b5": "u",
        "\u03bc": "u",
        "\u2212": "-",
        "\u3000": " ",
        **{chr(0xFF00 - 0x20 + code): chr(code) for code in range(0x21, 0x7F)},
    }
)
"""Signs of print, and the full-width letters of East Asia, in the letters of a keyboard."""
ANGLES = {
    **dict.fromkeys(("度", "град", "градус", "градуса", "градусов"), "deg"),
    **dict.fromkeys(("ラジアン", "弧度", "рад", "радиан", "радиана", "радианов"), "rad"),
    **dict.fromkeys(("回転", "об", "оборот", "оборота", "оборотов"), "turn"),
}
"""Units of angles as Japanese and Russian readers write them; the page has the same."""

Dimensions = frozenset[tuple[str, int]]
"""Base dimensions with their powers."""


class Unit(NamedTuple):
    """What a unit measures, and what one of it is in SI."""

    dimensions: Dimensions
    factor: float


def spelt(unit: str) -> str:
    """A unit as it is written in a Column: products with `*`, powers with `^`.

    >>> spelt("kg m2"), spelt("lb-ft"), spelt("N·m"), spelt("RPM")
    ('kg*m^2', 'lb*ft', 'N*m', 'rpm')
    """
    joined = re.sub(r"\s*([*/^])\s*", r"\1", unit.translate(SIGNS).replace("**", "^").strip())
    joined = re.sub(r"(?<=[A-Za-z])-(?=[A-Za-z])", "*", re.sub(r"\s+", "*", joined))
    joined = re.sub(r"([A-Za-z])(-?[1-4])", r"\1^\2", joined)
    return "rpm" if joined in _REVOLUTIONS or joined.lower() == "rpm" else joined


def in_degrees(unit: str) -> bool:
    """Whether a unit of an angle is the degree.

    >>> in_degrees("deg."), in_degrees("rad"), in_degrees("")
    (True, False, False)
    """
    plain = unit.lower().rstrip(".")
    return ANGLES.get(plain, plain) in ("deg", "degree", "degrees", "°")


def as_weight(unit: str) -> str:
    """A unit with pounds and ounces of force where it has those of mass.

    >>> as_weight("lb*ft")
    'lbf*ft'
    """
    return re.sub(r"[A-Za-z]+", lambda name: _WEIGHTS.get(name[0], name[0]), spelt(unit))


@lru_cache(maxsize=512)
def measured(unit: str) -> Unit:
    """Dimensions and factor of a unit; an angle is no plain number. Raises ValueError.

    >>> measured("kN m").factor, measured("lbf*ft").dimensions == measured("N m").dimensions
    (1000.0, True)
    """
    product = spelt(unit)
    if not _UNIT.fullmatch(product):
        raise ValueError(unit)
    return _product(product)


@lru_cache(maxsize=1)
def definitions() -> dict[str, str]:
    """The definition of every unit by each of its names."""
    lines = (line.split(" = ") for line in DEFINITIONS.strip().splitlines())
    return {name: parts[1] for parts in lines for name in (parts[0], *parts[2:])}


def _product(expression: str) -> Unit:
    """What a product of numbers and units is."""
    powers: Counter[str] = Counter()
    factor = 1.0
    for divided, number, name, power in _FACTOR.findall(expression):
        exponent = int(power or 1) * (-1 if divided == "/" else 1)
        own, size = (frozenset(), float(number)) if number else _named(name)
        factor *= size**exponent
        powers.update({kind: exponent * each for kind, each in own})
    return Unit(frozenset((kind, power) for kind, power in powers.items() if power), factor)


@lru_cache(maxsize=128)
def _named(name: str) -> Unit:
    """What a single unit is; "kilograms" are kilogram. Raises ValueError."""
    known = definitions()
    plural = len(name) > 2 and name.endswith("s")  # but "ms" is no metres
    definition = known.get(name) or (known.get(name[:-1]) if plural else None)
    if definition is None:
        raise ValueError(name)
    if definition.startswith("["):
        return Unit(frozenset({(definition, 1)}), 1.0)
    return _product(definition)
