"""Values of combustion, oil and crankshafts that hardly any engine has: slips of a unit or a digit.

The ends are wide and our judgement: from model engines to marine diesels nothing lies outside.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import radians
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.oil import PlainBearing
from crankstar.language.faults import Fault

Path = tuple[str | int, ...]


class Usual(NamedTuple):
    """The ends of a value in SI units, and a unit to write it in, which is `factor` of SI."""

    low: float
    high: float
    unit: str = ""
    factor: float = 1.0


COMBUSTION: Mapping[str, Usual] = {
    "wiebe_a": Usual(2.3, 10.0),  # exp(-2.3) is a tenth that does not burn
    "intake_temperature": Usual(220.0, 500.0, "K"),
    "wall_temperature": Usual(250.0, 900.0, "K"),
    "crankcase_pressure": Usual(0.3e5, 6e5, "bar", 1e5),
    "exhaust_pressure": Usual(0.3e5, 10e5, "bar", 1e5),
    "combustion_start": Usual(radians(-90), radians(60), "deg", radians(1)),
    "combustion_duration": Usual(radians(5), radians(250), "deg", radians(1)),
}
"""Of the keys of the table [gas] and of its operating points."""
VISCOSITY = Usual(1e-3, 3.0, "mPa*s", 1e-3)
"""Water has 1 mPa s; oil at a cold start some hundred times that of a warm engine."""
JOURNAL = 0.15, 2.0
"""Ends of the diameter of a journal or a pin over the bore, or over the stroke without one."""
SHELL = 0.1, 2.5
"""Ends of the length of a bearing over its diameter."""
GAP = 1e-4, 3e-3
"""Ends of the radial clearance over the diameter."""
MODULUS = Usual(20e9, 120e9, "GPa", 1e9)
"""Shear moduli: cast iron has 40 GPa and more, steel 80."""
STRENGTH = Usual(150e6, 2500e6, "MPa", 1e6)
"""Tensile strengths of cast iron and of the best steel."""
HEAVIEST_FLYWHEEL = 3000.0
"""Inertia of the drive over that of rods and pistons; flywheels of slow single cylinders: 500."""


def combustion_doubts(given: Mapping[str, Any], place: Callable[[str], Path]) -> Iterator[Fault]:
    """Of the given values of an operating point, each at its `place`.

    >>> [fault.values["least"] for fault in combustion_doubts({"wiebe_a": 0.5}, lambda k: (k,))]
    [2.3]
    """
    for key, usual in COMBUSTION.items():
        if given.get(key) is not None:
            yield from _outside(place(key), given[key], usual)


def oil_doubts(engine: Engine) -> Iterator[Fault]:
    """Of the plain bearings and their oil: by the bore, each length by its diameter.

    >>> from crankstar.files.catalog import load
    >>> own = {"oil": {"main": {"diameter": "580 mm", "length": "22 mm"}}}
    >>> [fault.path for fault in oil_doubts(load("audi-25-tfsi", changes=own))]
    [('oil', 'main', 'diameter')]
    """
    oil = engine.oil
    if oil is None or "radius" in engine.relative:
        return
    if oil.viscosity is not None:
        yield from _outside(("oil", "viscosity"), oil.viscosity, VISCOSITY)
    first = engine.first
    size = first.bore or 2 * engine.throw(first).radius
    for name, each in (("main", oil.main), ("pin", oil.pin)):
        if each is not None:
            yield from _of_bearing(("oil", name), each, size)


def _of_bearing(path: Path, own: PlainBearing, size: float) -> Iterator[Fault]:
    for key, value, ends, base, unit, factor in (
        ("diameter", own.diameter, JOURNAL, size, "mm", 1e-3),
        ("length", own.length, SHELL, own.diameter, "mm", 1e-3),
        ("clearance", own.clearance, GAP, own.diameter, "um", 1e-6),
    ):
        if value is None:
            continue
        low, high = (float(f"{end * base:.2g}") for end in ends)
        yield from _outside((*path, key), value, Usual(low, high, unit, factor))
        if key == "diameter" and not low <= value <= high:
            return  # the others go by it


def material_doubts(engine: Engine) -> Iterator[Fault]:
    """Of what a crankshaft is made of: its shear modulus and its tensile strength.

    >>> from crankstar.files.catalog import load
    >>> [*material_doubts(load("audi-25-tfsi"))]
    []
    """
    own = engine.torsion
    if own is None:
        return
    if own.dimensions is not None and own.dimensions.shear_modulus is not None:
        path = ("torsion", "dimensions", "shear_modulus")
        yield from _outside(path, own.dimensions.shear_modulus, MODULUS)
    if own.fatigue is not None:
        path = ("torsion", "fatigue", "tensile_strength")
        yield from _outside(path, own.fatigue.tensile_strength, STRENGTH)


def _outside(path: Path, value: float, usual: Usual) -> Iterator[Fault]:
    """That a value is below or above what engines have."""
    if usual.low <= value <= usual.high:
        return
    numbers = {"value": value, "least": usual.low, "most": usual.high}
    written = {key: float(f"{each / usual.factor:.6g}") for key, each in numbers.items()}
    if usual.unit:
        yield Fault(path, "doubt.usual", written | {"unit": usual.unit.replace("*", " ")})
    else:
        yield Fault(path, "doubt.ratio", written)
