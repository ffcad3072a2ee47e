"""What is independent in the tolerances of a file: an error of one part each, and what it moves.

A tolerance of a value that several parts share is one error for each part: a mass of [cylinder]
for each cylinder, the stroke for each throw, the bore pitch for each distance between two
neighbours, a knuckle radius for each slave rod, the angle of split pins for each pin. A tolerance
of a value that one part has, or that holds a bank, a row or a shaft as a whole, is one error.

How the arrays of an engine go with an error is a straight law: written down for what belongs to a
cylinder, read off neighbouring engines for the rest. Weights keep the size they have; a counter-
weight goes with its throw. The crank angle is that of the crankshaft itself, so that an error of
cylinder 1 does not move the zero of all the others.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from crankstar.analyses.tolerance.pitch_errors import Arrays, Moves, homes_of, of_pitches, throw_of
from crankstar.engine.cylinder_parts import ENDS, RECIPROCATING, ROTATING
from crankstar.engine.engine import Engine
from crankstar.engine.motion import roots
from crankstar.engine.records import Cylinder
from crankstar.files import engine_of
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Tree
from crankstar.files.tolerances import Tolerance, without_tolerances
from crankstar.files.units import si_unit
from crankstar.language.messages import _
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Real
from crankstar.studies.variants import ANGLES, arrays_of

STEP = 1e-4
"""Share of a value by which the neighbouring engines differ; radians for angles."""
LEAST_STEP = 1e-6
CLOSE = 1e-9
"""Share of the greatest change below which a change is rounding."""


class ErrorSource(NamedTuple):
    """An independent error: of which tolerance, of which part, its bound, what a unit of it moves.

    `moves` are changes of the arrays of the engine, by name, for an error of one SI unit.
    """

    path: str
    part: str
    bound: float
    moves: Arrays


class Sources(NamedTuple):
    """The independent errors of an engine, and the tolerances that move no force."""

    errors: tuple[ErrorSource, ...]
    idle: tuple[str, ...]


def sources_of(
    tree: Tree, tolerances: Mapping[str, Tolerance], engine: Engine, *, name: str = "the engine"
) -> Sources:
    """The independent errors of an engine by the tolerances of its tree.

    >>> from crankstar.files.catalog import load, tree_of
    >>> from crankstar.files.tolerances import tolerances_of
    >>> tree = tree_of("honda-b18c")[1]
    >>> tree["cylinder"]["stroke"] = "87.2 mm +- 0.02 mm"
    >>> own = sources_of(tree, tolerances_of(tree), load("honda-b18c"))
    >>> [error.part for error in own.errors]
    ['throw 1', 'throw 2', 'throw 3', 'throw 4']
    """
    machine = mechanism(engine)
    found: list[ErrorSource] = []
    idle: list[str] = []
    plain = _plain(tree)
    for path, own in tolerances.items():
        errors: list[ErrorSource] = []
        if own.bound > 0:
            parts = _of_cylinders(tree, own, engine, machine)
            if parts is None:
                parts = _of_layout(plain, own, engine, name)
            errors = [ErrorSource(path, part, own.bound, moves) for part, moves in parts if moves]
        found += errors
        if not errors:
            idle.append(path)
    return Sources(tuple(found), tuple(idle))


_BESIDE = ("gas", "torsion", "mounts", "foundation", "block", "oil", "drive", "valves")
"""Tables on which no inertia force depends."""


def _plain(tree: Tree) -> Tree:
    """The tree of the engine alone; where it has throws, without the order in which it fires.

    An error turns a throw, after which the engine does not fire at the very angles of its order.
    """
    left_out = {"provenance", *_BESIDE}
    layout = tree.get("layout", {})
    if layout.get("type") != "inline" or "throws" in layout:
        left_out |= {"firing_order", "firing_angles"}
    return {k: v for k, v in without_tolerances(tree).items() if k not in left_out}


def _of_cylinders(tree: Tree, own: Tolerance, engine: Engine, machine: Mechanism) -> Moves | None:
    """The errors of a value of [cylinder] or [[cylinders]]; None of any other."""
    match own.keys:
        case ("cylinder", *keys):
            places = [
                index
                for index, cylinder in enumerate(engine.cylinders)
                if not _overridden(tree, cylinder.number, keys)
                and not (keys == ["rod_length"] and cylinder.articulated and _slave_length(tree))
            ]
        case ("cylinders", int(index), *keys):
            if is_explicit(tree):
                places = [index]
            else:
                number = tree["cylinders"][index].get("number")
                places = [i for i, c in enumerate(engine.cylinders) if c.number == number]
        case _:
            return None
    if keys == ["stroke"]:
        return _of_strokes(places, engine, machine)
    out = []
    for place in places:
        part = _("cylinder {number}", number=engine.cylinders[place].number)
        out.append((part, _moved(tuple(map(str, keys)), place, engine, machine)))
    return out


def _overridden(tree: Tree, number: int, keys: Sequence[str | int]) -> bool:
    """Whether a cylinder, or its bank, has a value of its own at these keys."""
    layout = tree.get("layout", {})
    banks = [b for own in (layout, *layout.get("cranks", ())) for b in own.get("banks", ())]
    if [*keys] == ["offset"] and any(number in b["cylinders"] and "offset" in b for b in banks):
        return True
    for other in tree.get("cylinders") or ():
        if other.get("number") == number:
            place: Any = other
            for key in keys:
                if key == "rod" and key in place:
                    return True
                place = place.get(key) if isinstance(place, dict) else None
            return place is not None
    return False


def _slave_length(tree: Tree) -> bool:
    return "slave_rod_length" in tree.get("layout", {})


def _of_strokes(places: Sequence[int], engine: Engine, machine: Mechanism) -> Moves:
    """Half of an error of the stroke is the crank radius of each throw."""
    on = np.array([throw_of(engine, index) for index in range(len(engine.cylinders))])
    throws = [throw for shaft in engine.shafts for throw in shaft.throws]
    out = []
    for index in dict.fromkeys(int(on[place]) for place in places):
        moves = {
            "links.crank_radius": np.where(on == index, 0.5, 0.0),
            "unbalance": _one(machine.unbalance.size, index, 0.5 * throws[index].turning_mass),
        }
        out.append((_("throw {number}", number=index + 1), moves))
    return out


def _one(size: int, index: int, value: float = 1.0) -> Real:
    out = np.zeros(size)
    out[index] = value
    return out


_OF_ROD = {"mass": "rod_mass", "centre": "rod_centre", "inertia": "rod_inertia"}
_PLAIN = {
    "reciprocating_mass": "reciprocating_mass",
    "big_end_mass": "big_end_mass",
    "rod_length": "links.rod_length",
    "offset": "links.offset",
    "z": "z",
}
_KNUCKLE = {"radius": "links.knuckle_radius", "angle": "links.knuckle_angle"}


def _moved(keys: tuple[str, ...], index: int, engine: Engine, machine: Mechanism) -> Arrays:
    """What a unit of a value of one cylinder moves; nothing where no force depends on it."""
    cylinder, count = engine.cylinders[index], len(engine.cylinders)
    own = _one(count, index)
    match keys:
        case (name,) if name in _PLAIN:
            return {_PLAIN[name]: own} | _implied(cylinder, name, own)
        case ("bearing",):
            return _turned_bearing(index, machine)
        case ("rotating_mass",) | ("throw_mass",):
            return _turning(keys[0], index, engine, machine)
        case ("rod", name) if cylinder.rod is not None:
            return {_OF_ROD[name]: own} | _implied(cylinder, name, own)
        case ("articulated", name) if name in _KNUCKLE:
            return {_KNUCKLE[name]: own}
        case ("parts", name) if cylinder.rod is not None and name in ENDS:
            rest = cylinder.rod_length - cylinder.rod.centre
            arm = rest if name == "small_end" else -cylinder.rod.centre
            moved = {"rod_mass": own, "rod_centre": own * arm / cylinder.rod.mass}
            if cylinder.rod.inertia is None:  # two masses at the ends remain two
                moved["rod_inertia"] = own * arm**2
            return moved
        case ("parts", name) if name in RECIPROCATING:
            return {"reciprocating_mass": own}
        case ("parts", name) if name in ROTATING:
            return _turning("rotating_mass", index, engine, machine)
    return {}


def _implied(cylinder: Cylinder, name: str, own: Real) -> Arrays:
    """What a unit of a value moves of m c (l - c), the inertia of a rod that is given none."""
    rod, length = cylinder.rod, cylinder.rod_length
    if rod is None or rod.inertia is not None:
        return {}
    rates = {
        "mass": rod.centre * (length - rod.centre),
        "centre": rod.mass * (length - 2 * rod.centre),
        "rod_length": rod.mass * rod.centre,
    }
    return {"rod_inertia": own * rates[name]} if name in rates else {}


def _turning(key: str, index: int, engine: Engine, machine: Mechanism) -> Arrays:
    """A mass at the crank pin; of one rod, where its big end is."""
    cylinder = engine.cylinders[index]
    if key == "rotating_mass":
        return {"big_end_mass": _one(len(engine.cylinders), index)}
    radius = engine.throw(cylinder).radius
    return {"unbalance": _one(machine.unbalance.size, throw_of(engine, index), radius)}


def _turned_bearing(index: int, machine: Mechanism) -> Arrays:
    """The axis of a cylinder; that of a master rod's cylinder carries the motion of its slaves."""
    root = np.array(roots(machine.links.master))
    own = _one(root.size, index)
    if root[index] != index:
        return {"links.bearing": own}
    return {"bearing": (root == index) * 1.0, "links.bearing": own - (root == index)}


_Z = ("z", "unbalance_z")
_PINS = ("throw_angle", "unbalance_angle")
_WEIGHT = ("unbalance", "unbalance_angle")
_KINDS: dict[str, tuple[str, ...]] = {
    "bearing": ("bearing", "links.bearing", "place"),
    "offset": ("links.offset",),
    "set_back": _Z,
    "bank_offset": _Z,
    "positions": _Z,
    "z": _Z,
    "throws": _PINS,
    "throw": _PINS,
    "pin_angle": _PINS,
    "pin_split": _PINS,
    "lag": _PINS,
    "angle": (*_PINS, *_WEIGHT),
    "phase": _WEIGHT,
    "unbalance": _WEIGHT,
    "radius": ("links.crank_radius", "unbalance"),
    "rotating_mass": ("unbalance",),
    "throw_mass": ("unbalance",),
    "up": ("place",),
    "right": ("place",),
    "crank_distance": ("place",),
    "knuckle_radius": ("links.knuckle_radius",),
    "slave_rod_length": ("links.rod_length",),
}
"""The arrays that go with a value of a layout or of a shaft, by its last key."""
_BY_THROW = ("pin_angle", "pin_split")
_BY_CYLINDER = ("knuckle_radius", "slave_rod_length")
_MASSES = ("unbalance", "rotating_mass", "throw_mass")
"""They may be nought, and all goes with them in a straight line: no step below."""
_TABLES = ("layout", "shaft", "shafts", "crankshaft", "balance_shaft")


def _of_layout(plain: Tree, own: Tolerance, engine: Engine, name: str) -> Moves:
    """The errors of a value of the layout, of a shaft or of a weight."""
    if own.keys[0] not in _TABLES:
        return []
    last = next(key for key in reversed(own.keys) if isinstance(key, str))
    if last in ("bore_pitch", "row_pitch"):
        return of_pitches(plain, engine)
    if last not in _KINDS:
        return []

    def built(value: float) -> Mechanism:
        return mechanism(
            engine_of(plain, name=name, changes={own.path: _written(value, own, plain)})
        )

    moves = _rates(own, built, _KINDS[last], one_sided=last in _MASSES)
    if last in _BY_THROW:
        return _split_by_throw(moves, engine)
    if last in _BY_CYLINDER:
        return [
            (_("cylinder {number}", number=cylinder.number), _masked(moves, index))
            for index, cylinder in enumerate(engine.cylinders)
            if any(values[index] for values in moves.values())
        ]
    return [("", moves)]


def _written(value: float, own: Tolerance, plain: Tree) -> str | float:
    """A value as its file has it, bare or with a unit."""
    place: Any = plain
    for key in own.keys:
        place = place[key]
    return f"{value!r} {si_unit(own.quantity)}" if isinstance(place, str) else value


def _rates(
    own: Tolerance, built: Callable[[float], Mechanism], names: Sequence[str], *, one_sided: bool
) -> Arrays:
    """How fast these arrays go with the value."""
    step = max(abs(own.value) * STEP, LEAST_STEP)
    if own.quantity.dimension == "angle":
        step = STEP
    low, high = (own.value if one_sided else own.value - step), own.value + step
    first, second = (arrays_of(built(value)) for value in (low, high))
    out: Arrays = {}
    for array in names:
        change = second[array] - first[array]
        if array in ANGLES:
            change = (change + np.pi) % (2 * np.pi) - np.pi
        rate = change / (high - low)
        greatest = np.abs(rate).max(initial=0.0)
        rate = np.where(np.abs(rate) > CLOSE * greatest, rate, 0.0)
        if greatest * own.bound > CLOSE * max(float(np.abs(first[array]).max(initial=0.0)), 1e-6):
            out[array] = rate
    return out


def _split_by_throw(moves: Arrays, engine: Engine) -> Moves:
    """The turn of several pins as one of each pin, with its cylinders and its weights."""
    on = np.array([throw_of(engine, index) for index in range(len(engine.cylinders))])
    homes = homes_of(engine)
    out = []
    for index in dict.fromkeys(on.tolist()):
        own = {
            "throw_angle": np.where(on == index, moves.get("throw_angle", 0.0), 0.0),
            "unbalance_angle": np.where(homes == index, moves.get("unbalance_angle", 0.0), 0.0),
        }
        if np.any(own["throw_angle"]):
            out.append((_("throw {number}", number=index + 1), own))
    return out


def _masked(moves: Arrays, index: int) -> Arrays:
    return {
        name: np.where(np.arange(values.size) == index, values, 0.0)
        for name, values in moves.items()
    }
