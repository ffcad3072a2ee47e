"""Numbers without a unit in engine files: what they are counted in, and which are refused."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from contextlib import suppress
from math import isfinite, prod
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

from crankstar.engine.quantities import GREATEST_RELATIVE, LEAST, Quantity
from crankstar.files import units
from crankstar.files.plus_minus import nominal
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen

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
            raise units.fault("unit.not-finite", value, quantity)
        missing = quantity.relative_to & relative
        if not missing:
            _refuse_bare(value, quantity, measured)
            _refuse_alone(value, quantity, written)
            return units.si(value, quantity)
        rest = remaining(quantity, missing)
        if rest is not None and units.is_of(value, rest):
            return units.si(value, rest)
        number, has_unit = units.parsed(value, quantity)
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
    if not scales or abs(value) > units.greatest_bare(quantity):
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
        relative=units.text(value * factor, quantity, digits=6),
        absolute=units.text(value, quantity, digits=6),
    )


def _refuse_alone(value: Any, quantity: Quantity, written: Mapping[str, Written]) -> None:
    """Refuse a number without a unit in a file that gives units."""
    if not written:
        return
    number, has_unit = units.parsed(value, quantity)
    if has_unit or not number or abs(number) > units.greatest_bare(quantity):
        return
    if quantity.least and number < 0:
        return  # no size at all
    beside = written.get(_ALIKE.get(quantity.dimension, quantity.dimension))
    if beside is None:
        if quantity.dimension in _EVIDENT:
            return
        raise units.fault("unit.missing", value, quantity)
    own = f"{number:.15g}"
    like, absolute = (f"{own} {unit}" for unit in (beside.unit, units.si_unit(quantity)))
    alike = [
        each
        for each in dict.fromkeys((like, absolute))
        if 1 / SAME_SIZE <= abs(units.parsed(each, quantity)[0] / beside.size) <= SAME_SIZE
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
        unit = units.unit_of(nominal(value)) if isinstance(value, str) else ""
        if unit and units.is_of(f"1 {unit}", quantity) and units.greatest_bare(quantity):
            dimension = _ALIKE.get(quantity.dimension, quantity.dimension)
            with suppress(ValueFaultError):
                if dimension not in out and (size := units.parsed(nominal(value), quantity)[0]):
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
        relative=units.text(value * factor, rest, digits=6),
        absolute=units.text(value, rest, digits=6),
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
