"""Text with a unit to an SI number, and back.

A bare number is SI (radians for angles), and is refused where nobody can have meant that: a stroke
of 82.5 m, an angle of 90 rad, a speed without unit. The units are those of `language.units`; where
a force or a moment is wanted, pounds and ounces are their weight.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

from crankstar.engine.quantities import GREATEST_LENGTH, Quantity
from crankstar.files.plus_minus import nominal
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen
from crankstar.language.units import ANGLES, SIGNS, as_weight, definitions, measured

_NUMBER = re.compile(
    r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)
_AT = re.compile(r"\s+at\s+|\s*@\s*", re.IGNORECASE)
"""Between a mass and its radius."""
_WEIGHED, _ACROSS = Quantity("mass", "38 g"), Quantity("length", "100 mm")
_SCALES = {
    **dict.fromkeys(("degc", "c", "\u2103", "celsius"), (273.15, 1.0)),
    **dict.fromkeys(("degf", "f", "\u2109", "fahrenheit"), (459.67, 5 / 9)),
}
"""Scales of temperature: what is added to a number, and the kelvins of a degree."""
_GAUGE = re.compile(r"([A-Za-z]+?)\s*[-_(]?\s*(?:gauge|g|ü|\(g\))\)?", re.IGNORECASE)
_ABSOLUTE = re.compile(r"([A-Za-z]+?)\s*[-_(]?\s*(?:abs|absolute|a)\)?", re.IGNORECASE)
"""Units of pressure with a letter behind them: "barg", "psig", "bar (g)"; "bara"."""
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
    "volume": _Kind("metre^3", "m^3", 0.0, 100.0),
    "density": _Kind("kilogram/metre^3", "kg/m^3", 0.0, 1e5),
    "force": _Kind("newton", "N", 1e12, 1e12),
    "couple": _Kind("newton*metre", "N m", 1e12, 1e12),
    "stiffness": _Kind("newton/metre", "N/m", 1e13, 1e13),
    "damping": _Kind("newton*second/metre", "N*s/m", 1e10, 1e10),
    "receptance": _Kind("metre/newton", "m/N", 10.0, 10.0),
    "bending stiffness": _Kind("newton*metre^2", "N*m^2", 1e13, 1e13),
    "pressure": _Kind("pascal", "Pa", 0.0, 1e9),
    "viscosity": _Kind("pascal*second", "Pa*s", 1e3, 1e3),
    "power": _Kind("watt", "W", 0.0, 1e9),
    "elastic modulus": _Kind("pascal", "Pa", 0.0, 1e13),
    "torsional stiffness": _Kind("newton*metre/radian", "N*m/rad", 1e13, 1e13),
    "torsional damping": _Kind("newton*metre*second/radian", "N*m*s/rad", 1e10, 1e10),
    "temperature": _Kind("kelvin", "K", 0.0, 5000.0),
    "speed along a line": _Kind("metre/second", "m/s", 0.0, 1e4),
    "acceleration": _Kind("metre/second^2", "m/s^2", 0.0, 1e6),
    "area": _Kind("metre^2", "m^2", 1e4, 1e4),
}
_OTHERS = {"time": "second", "mass per length": "kilogram/metre"}
_SHOWN = {
    "angle": (57.29577951308232, "deg"),
    "length": (1000.0, "mm"),
    "length along the crankshaft": (1000.0, "mm"),
    "mass": (1.0, "kg"),
    "moment of inertia": (1.0, "kg*m^2"),
    "unbalance": (1.0, "kg*m"),
    "rotational speed": (9.549296585513721, "rpm"),
    "volume": (1e6, "cm^3"),
    "density": (0.001, "g/cm^3"),
    "force": (1.0, "N"),
    "couple": (1.0, "N m"),
    "stiffness": (1.0, "N/m"),
    "damping": (1.0, "N*s/m"),
    "receptance": (1.0, "m/N"),
    "bending stiffness": (1.0, "N*m^2"),
    "pressure": (1e-5, "bar"),
    "elastic modulus": (1e-9, "GPa"),
    "viscosity": (1e3, "mPa*s"),
    "power": (1e-3, "kW"),
    "torsional stiffness": (1.0, "N*m/rad"),
    "torsional damping": (1.0, "N*m*s/rad"),
    "temperature": (1.0, "K"),
    "speed along a line": (1.0, "m/s"),
    "acceleration": (1.0, "m/s^2"),
    "area": (1e6, "mm^2"),
}


def si(value: Any, quantity: Quantity) -> float:
    """The SI number of a value from a file; raises ValueFaultError with the right form.

    >>> round(si("3.25 in", Quantity("length", "82.5 mm")), 6)
    0.08255
    >>> round(si("38 g at 4 in", Quantity("unbalance", "850 g*mm")) * 1e6, 1)  # g mm
    3860.8
    >>> si("82 kg", Quantity("length", "82.5 mm"))  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    crankstar...ValueFaultError: the value is "82 kg", a mass; a length is needed, such as "82.5 mm"
    """
    number, has_unit = parsed(value, quantity)
    kind = _KINDS[quantity.dimension]
    if not has_unit and abs(number) > kind.greatest_bare:
        raise implausible(value, number, quantity)
    if abs(number) > kind.greatest:
        raise fault("unit.too-large", value, quantity)
    if 0 < abs(number) < quantity.least:
        raise fault("unit.too-small", value, quantity)
    return number


def without_tolerance(value: Any, quantity: Quantity) -> float:
    """The SI number of a value as it stands in a file, with a tolerance or without.

    Raises ValueFaultError.

    >>> without_tolerance("650 g +- 2 g", Quantity("mass", "650 g"))
    0.65
    """
    return si(nominal(value), quantity)


def is_bare(text: str) -> bool:
    """Whether text is a number without a unit, other than nought."""
    try:
        return float(text) != 0
    except ValueError:
        return False


def unit_of(text: str) -> str:
    """The unit behind a number; empty without one, and where there is no number.

    >>> unit_of("-1e9 mm"), unit_of("5"), unit_of("mm")
    ('mm', '', '')
    """
    match = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    return match[2] if match else ""


def which(unit: str, quantities: Sequence[Quantity]) -> int | None:
    """Which of these quantities a unit measures, by its place among them; None of them.

    >>> which("in/s", [Quantity("length", "1 mm"), Quantity("speed along a line", "1 mm/s")])
    1
    """
    try:
        own = measured(unit.translate(SIGNS).replace("**", "^")).dimensions
    except ValueError:
        return None
    kinds = [measured(_KINDS[each.dimension].unit).dimensions for each in quantities]
    return kinds.index(own) if own in kinds else None


def is_of(value: Any, quantity: Quantity) -> bool:
    """Whether text is a number with a unit of this quantity."""
    return isinstance(value, str) and which(unit_of(value), [quantity]) is not None


def fault(code: str, value: Any, quantity: Quantity, **values: Any) -> ValueFaultError:
    """What is wrong with a value of a quantity, with an example of one that is right."""
    example = f'"{quantity.example}"'
    return ValueFaultError(
        code, value=seen(value), dimension=quantity.dimension, example=example, **values
    )


def implausible(value: Any, number: float, quantity: Quantity) -> ValueFaultError:
    """A number larger than any real one: it was meant in the unit that people write."""
    kind, own = _KINDS[quantity.dimension], unit_of(str(value))
    one = parsed(f"1 {own}", quantity)[0] if own else 1.0
    factor, meant = _SHOWN[quantity.dimension]
    if not kind.greatest_bare or factor == 1.0:
        return fault("unit.missing", value, quantity)
    return ValueFaultError(
        "unit.implausible",
        number=float(f"{number / one:.15g}"),
        unit=own or kind.short,
        greatest=float(f"{kind.greatest_bare / one:.5g}"),
        meant=meant,
    )


def parsed(value: Any, quantity: Quantity) -> tuple[float, bool]:
    """The SI number and whether it had a unit."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise fault("unit.needed", value, quantity)
    if not isinstance(value, str):
        if not abs(value) <= _GREATEST_NUMBER:
            raise fault("unit.needed", value, quantity)
        return float(value), False
    text = value.translate(SIGNS).replace("**", "^")
    if quantity.dimension == "unbalance" and len(text) <= _LONGEST and _AT.search(text):
        return _mass_at_radius(text, value, quantity), True
    match = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise fault("unit.not-a-number", value, quantity)
    number, unit = float(match.group(1)), match.group(2)
    if re.search(r"\d\s*(\.\.|…)", text):
        raise fault("unit.range", value, quantity)
    if re.match(r",\d", unit):
        raise fault("unit.decimal-comma", value, quantity)
    if abs(number) > _GREATEST_NUMBER:
        raise fault("unit.too-large", value, quantity)
    if quantity.dimension == "temperature":
        zero, degree = _SCALES.get(unit.lower().replace(" ", ""), (0.0, 0.0))
        if degree:
            return (number + zero) * degree, True
    if quantity.dimension == "angle":
        unit = ANGLES.get(unit.lower().rstrip("."), unit)
    if quantity.dimension == "pressure":
        unit = _absolute(unit, value, quantity)
    return (number * _factor(unit, value, quantity), True) if unit else (number, False)


def _absolute(unit: str, value: str, quantity: Quantity) -> str:
    """A unit of pressure without the letter that says absolute. Raises for gauge pressures."""
    for form in (_GAUGE, _ABSOLUTE):
        found = form.fullmatch(unit)
        if found and which(unit, [quantity]) is None and which(found[1], [quantity]) is not None:
            if form is _GAUGE:
                raise fault("unit.gauge", value, quantity, unit=seen(found[1]))
            return found[1]
    return unit


def _mass_at_radius(text: str, value: str, quantity: Quantity) -> float:
    """The unbalance of a mass at a radius, as balancing machines show it: "38 g at 4 in"."""
    parts = _AT.split(text)
    if len(parts) != 2:
        raise fault("unit.not-a-number", value, quantity)
    (mass, weighed), (radius, long) = map(parsed, parts, (_WEIGHED, _ACROSS))
    if not (weighed and long):
        raise fault("unit.missing", value, quantity)
    if radius < 0:
        raise fault("unit.not-a-number", value, quantity)
    return mass * radius


def _factor(unit: str, value: str, quantity: Quantity) -> float:
    """What one of `unit` is in SI.

    Raises ValueFaultError where it is not known or measures something else.
    """
    wanted = measured(_KINDS[quantity.dimension].unit).dimensions
    try:
        unit_given = measured(unit)
        if unit_given.dimensions != wanted and measured(as_weight(unit)).dimensions == wanted:
            unit_given = measured(as_weight(unit))
    except ValueError:
        near = {name.lower(): name for name in definitions()}.get(unit.lower())
        if near:
            raise fault(
                "unit.misspelt", value, quantity, unit=seen(unit), meant=f'"{near}"'
            ) from None
        raise fault("unit.unknown", value, quantity, unit=seen(unit)) from None
    if unit_given.dimensions != wanted:
        if quantity.dimension == "unbalance" and unit_given.dimensions == measured("kg").dimensions:
            raise fault("unit.radius-missing", value, quantity)
        named = [(name, kind.unit) for name, kind in _KINDS.items()] + list(_OTHERS.items())
        kinds = (name for name, of in named if measured(of).dimensions == unit_given.dimensions)
        raise fault("unit.other-dimension", value, quantity, measured=next(kinds, "other"))
    return unit_given.factor


def si_unit(quantity: Quantity) -> str:
    """The SI unit of a quantity, as in "kg*m^2"."""
    return _KINDS[quantity.dimension].short


def greatest_bare(quantity: Quantity) -> float:
    """The greatest number of a quantity without a unit, in its SI unit; 0 where it needs one."""
    return _KINDS[quantity.dimension].greatest_bare


def greatest(quantity: Quantity) -> float:
    """The greatest number of a quantity of an engine, in its SI unit."""
    return _KINDS[quantity.dimension].greatest


def text(number: float, quantity: Quantity, *, digits: int = 15) -> str:
    """An SI number as text with the unit a reader expects.

    Reading it back gives the number to rounding.

    >>> text(0.0825, Quantity("length", "82.5 mm"))
    '82.5 mm'
    """
    factor, unit = _SHOWN[quantity.dimension]
    if quantity.dimension == "mass" and 0 < abs(number) < 1:
        factor, unit = 1000.0, "g"
    rounded = float(f"{number * factor:.{digits}g}")
    return f"{rounded:.15g} {unit}"
