"""Text with a unit to an SI number, and back.

A bare number is SI (radians for angles), and is refused where nobody can have meant that: a stroke
of 82.5 m, an angle of 90 rad, a speed without unit. The units are those of `language.units`; where
a force or a moment is wanted, pounds and ounces are their weight.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from math import isfinite, prod
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

from crankstar.engine.quantities import GREATEST_LENGTH, GREATEST_RELATIVE, LEAST, Quantity
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
    number, has_unit = _read(value, quantity)
    kind = _KINDS[quantity.dimension]
    if not has_unit and abs(number) > kind.greatest_bare:
        raise implausible(value, number, quantity)
    if abs(number) > kind.greatest:
        raise _fault("unit.too-large", value, quantity)
    if 0 < abs(number) < quantity.least:
        raise _fault("unit.too-small", value, quantity)
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


NOTHING_MEASURED: Mapping[str, tuple[str, float]] = MappingProxyType({})
"""No unit of itself of which a file gives the size with a unit."""


class Written(NamedTuple):
    """The first value of a dimension that a file gives with a unit: key path, unit, SI size."""

    key: str
    unit: str
    size: float


SAME_SIZE = 100.0
"""Factor within which two sizes of one dimension in an engine are mostly alike."""
NOTHING_WRITTEN: Mapping[str, Written] = MappingProxyType({})
"""No value with a unit."""


def reader(
    relative: frozenset[str],
    *,
    because: Literal["unknown", "relative"] = "unknown",
    measured: Mapping[str, tuple[str, float]] = NOTHING_MEASURED,
    written: Mapping[str, Written] = NOTHING_WRITTEN,
) -> Callable[[Any, Quantity], float]:
    """The reader of one file's values; those in `relative` are bare numbers in units of themselves.

    `because`: the file does not give it, or says in `relative` that it is not known. `measured` are
    units of itself that it gives with a unit, by name the key and the SI size: a bare number beside
    one may be counted in it, from when it was not known, and is refused. `written` are the values
    with a unit by dimension: a bare number beside one of its own may be in that unit or in SI, one
    beside others alone lacks its unit, unless it is evident; both are refused.
    """

    def read(value: Any, quantity: Quantity) -> float:
        if isinstance(value, float) and not isfinite(value):
            raise _fault("unit.not-finite", value, quantity)
        missing = quantity.relative_to & relative
        if not missing:
            _refuse_bare(value, quantity, measured)
            _refuse_alone(value, quantity, written)
            return si(value, quantity)
        rest = remaining(quantity, missing)
        if rest is not None and is_of(value, rest):
            return si(value, rest)
        number, has_unit = _read(value, quantity)
        if rest is not None and not has_unit:
            _refuse_mixed(value, quantity, rest, measured)
        if has_unit and number != 0:
            raise ValueFaultError(f"unit.{because}-{min(missing)}", value=seen(value))
        if abs(number) > GREATEST_RELATIVE or 0 < abs(number) < quantity.least:
            raise ValueFaultError("unit.bare-out-of-range", value=seen(value))
        return number

    return read


def _refuse_bare(value: Any, quantity: Quantity, measured: Mapping[str, tuple[str, float]]) -> None:
    """Refuse a bare number that may be SI, or counted in a size that the file gives with a unit."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not value:
        return
    scales = sorted(quantity.relative_to & measured.keys())
    if not scales or abs(value) > _KINDS[quantity.dimension].greatest_bare:
        return  # which is refused for its size
    if quantity.least and value < 0:
        return  # no size at all
    key = measured[scales[0]][0]
    powers = POWERS.get(quantity.dimension, {})
    factor = prod(measured[scale][1] ** powers.get(scale, 1) for scale in scales)
    raise ValueFaultError(
        f"unit.bare-beside-{scales[0]}",
        value=seen(value),
        key=key,
        relative=text(value * factor, quantity, digits=6),
        absolute=text(value, quantity, digits=6),
    )


def _refuse_alone(value: Any, quantity: Quantity, written: Mapping[str, Written]) -> None:
    """Refuse a number without a unit in a file that gives units."""
    if not written:
        return
    number, has_unit = _read(value, quantity)
    if has_unit or not number or abs(number) > _KINDS[quantity.dimension].greatest_bare:
        return
    if quantity.least and number < 0:
        return  # no size at all
    beside = written.get(_ALIKE.get(quantity.dimension, quantity.dimension))
    if beside is None:
        if quantity.dimension in _EVIDENT:
            return
        raise _fault("unit.missing", value, quantity)
    own = f"{number:.15g}"
    like, absolute = (f"{own} {unit}" for unit in (beside.unit, _KINDS[quantity.dimension].short))
    alike = [
        each
        for each in dict.fromkeys((like, absolute))
        if 1 / SAME_SIZE <= abs(_read(each, quantity)[0] / beside.size) <= SAME_SIZE
    ]
    one = (
        {"reading": alike[0]} if len(alike) == 1 else {"reading": like} if like == absolute else {}
    )
    raise ValueFaultError(
        "unit.bare-beside-one" if one else "unit.bare-beside-unit",
        value=seen(value),
        key=beside.key,
        like=like,
        absolute=absolute,
        **one,
    )


def written(pairs: Iterable[tuple[str, Any, Quantity]]) -> dict[str, Written]:
    """The first value with a unit of each dimension, of the key, value and quantity of a file.

    Where a number needs a unit in any case, as a speed does, that it has one says nothing; a value
    that cannot be read, which is refused where it is, does not either.

    >>> written([("torsion.stiffness", "1.2 MN*m/rad", Quantity("torsional stiffness", "1 N*m"))])
    {'torsional stiffness': Written(key='torsion.stiffness', unit='MN*m/rad', size=1200000.0)}
    """
    out: dict[str, Written] = {}
    for key, value, quantity in pairs:
        unit = unit_of(nominal(value)) if isinstance(value, str) else ""
        if unit and is_of(f"1 {unit}", quantity) and _KINDS[quantity.dimension].greatest_bare:
            dimension = _ALIKE.get(quantity.dimension, quantity.dimension)
            with suppress(ValueFaultError):
                if dimension not in out and (size := _read(nominal(value), quantity)[0]):
                    out[dimension] = Written(key, unit, size)
    return out


_ALIKE = {"length along the crankshaft": "length"}
_EVIDENT = ("angle", "length", "length along the crankshaft", "mass")
"""Dimensions of which a slip of unit shows: a bare number is SI where no other has a unit."""


def _refuse_mixed(
    value: Any, quantity: Quantity, rest: Quantity, measured: Mapping[str, tuple[str, float]]
) -> None:
    """Refuse a bare number of a mass and a length of which the file gives one with a unit."""
    scale = next(iter(quantity.relative_to & measured.keys()), None)
    if scale is None or isinstance(value, bool) or not isinstance(value, int | float) or not value:
        return
    if quantity.least and value < 0:
        return  # no size at all
    key, size = measured[scale]
    factor = size ** POWERS[quantity.dimension][scale]
    raise ValueFaultError(
        f"unit.bare-per-{'mass' if scale == 'radius' else 'radius'}",
        value=seen(value),
        key=key,
        relative=text(value * factor, rest, digits=6),
        absolute=text(value, rest, digits=6),
    )


def remaining(quantity: Quantity, missing: Collection[str]) -> Quantity | None:
    """What is left of a mass times lengths over the one of both that is not known; else None.

    >>> from crankstar.engine.quantities import UNBALANCE
    >>> remaining(UNBALANCE, {"mass"}).dimension, remaining(UNBALANCE, {"radius"}).dimension
    ('length', 'mass')
    """
    if len(missing) != 1 or len(quantity.relative_to) == 1:
        return None
    return _REMAINING.get((quantity.dimension, next(iter(missing))))


def is_of(value: Any, quantity: Quantity) -> bool:
    """Whether text is a number with a unit of this quantity."""
    return isinstance(value, str) and which(unit_of(value), [quantity]) is not None


_REMAINING = {
    ("unbalance", "mass"): Quantity("length", "20 mm", least=LEAST),
    ("unbalance", "radius"): Quantity("mass", "500 g", least=LEAST),
    ("moment of inertia", "mass"): Quantity("area", "800 mm^2", least=LEAST**2),
    ("moment of inertia", "radius"): Quantity("mass", "500 g", least=LEAST),
}
"""By dimension and what is not known: an unbalance over a mass is a length."""
POWERS: Mapping[str, Mapping[str, int]] = MappingProxyType(
    {
        "mass": {"mass": 1},
        "unbalance": {"mass": 1, "radius": 1},
        "moment of inertia": {"mass": 1, "radius": 2},
        "bending stiffness": {"pitch": 2},
        "stiffness": {"pitch": -1},
    }
)
"""Powers of the units m, r and a in a quantity; lengths have their own unit once.

A bending stiffness E I is in N a^2 and a support in N/a where the bore pitch a is not known: what
the loads depend on, E I/(k a^3), is a ratio without a unit.
"""


def _fault(code: str, value: Any, quantity: Quantity, **values: Any) -> ValueFaultError:
    example = f'"{quantity.example}"'
    return ValueFaultError(
        code, value=seen(value), dimension=quantity.dimension, example=example, **values
    )


def implausible(value: Any, number: float, quantity: Quantity) -> ValueFaultError:
    """A number larger than any real one: it was meant in the unit that people write."""
    kind, own = _KINDS[quantity.dimension], unit_of(str(value))
    one = _read(f"1 {own}", quantity)[0] if own else 1.0
    factor, meant = _SHOWN[quantity.dimension]
    if not kind.greatest_bare or factor == 1.0:
        return _fault("unit.missing", value, quantity)
    return ValueFaultError(
        "unit.implausible",
        number=float(f"{number / one:.15g}"),
        unit=own or kind.short,
        greatest=float(f"{kind.greatest_bare / one:.5g}"),
        meant=meant,
    )


def _read(value: Any, quantity: Quantity) -> tuple[float, bool]:
    """The SI number and whether it had a unit."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise _fault("unit.needed", value, quantity)
    if not isinstance(value, str):
        if not abs(value) <= _GREATEST_NUMBER:
            raise _fault("unit.needed", value, quantity)
        return float(value), False
    text = value.translate(SIGNS).replace("**", "^")
    if quantity.dimension == "unbalance" and len(text) <= _LONGEST and _AT.search(text):
        return _mass_at_radius(text, value, quantity), True
    match = _NUMBER.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise _fault("unit.not-a-number", value, quantity)
    number, unit = float(match.group(1)), match.group(2)
    if re.search(r"\d\s*(\.\.|…)", text):
        raise _fault("unit.range", value, quantity)
    if re.match(r",\d", unit):
        raise _fault("unit.decimal-comma", value, quantity)
    if abs(number) > _GREATEST_NUMBER:
        raise _fault("unit.too-large", value, quantity)
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
                raise _fault("unit.gauge", value, quantity, unit=seen(found[1]))
            return found[1]
    return unit


def _mass_at_radius(text: str, value: str, quantity: Quantity) -> float:
    """The unbalance of a mass at a radius, as balancing machines show it: "38 g at 4 in"."""
    parts = _AT.split(text)
    if len(parts) != 2:
        raise _fault("unit.not-a-number", value, quantity)
    (mass, weighed), (radius, long) = map(_read, parts, (_WEIGHED, _ACROSS))
    if not (weighed and long):
        raise _fault("unit.missing", value, quantity)
    if radius < 0:
        raise _fault("unit.not-a-number", value, quantity)
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
            raise _fault(
                "unit.misspelt", value, quantity, unit=seen(unit), meant=f'"{near}"'
            ) from None
        raise _fault("unit.unknown", value, quantity, unit=seen(unit)) from None
    if unit_given.dimensions != wanted:
        if quantity.dimension == "unbalance" and unit_given.dimensions == measured("kg").dimensions:
            raise _fault("unit.radius-missing", value, quantity)
        named = [(name, kind.unit) for name, kind in _KINDS.items()] + list(_OTHERS.items())
        kinds = (name for name, of in named if measured(of).dimensions == unit_given.dimensions)
        raise _fault("unit.other-dimension", value, quantity, measured=next(kinds, "other"))
    return unit_given.factor


def si_unit(quantity: Quantity) -> str:
    """The SI unit of a quantity, as in "kg*m^2"."""
    return _KINDS[quantity.dimension].short


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
