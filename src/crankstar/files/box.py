"""The ranges of the estimated values of a file, and the trees in their middle and at their ends.

Each value lies anywhere in its range whatever the others are. Every amplitude is linear in each
mass, in the centre and the inertia of a rod and in the bore pitch while the others are held, so
that over the whole box of ranges none exceeds the greatest at a corner.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple

from pydantic import ValidationError

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, MASS
from crankstar.engine.records import Provenance
from crankstar.files import units
from crankstar.files.changes import keys_of
from crankstar.files.errors import EngineFileError, refused
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import SpreadsheetTree, Tree, copied
from crankstar.files.read import engine_of
from crankstar.language.faults import Fault, ValueFaultError

CONDITIONS = (
    *("speed", "cylinder.bore", "cylinder.stroke"),
    *(f"block.inertia_{axis}" for axis in ("up", "right", "z")),
)
"""Estimated values whose range is not carried into forces: these hold at that size and speed, and
whatever the inertia of the block is."""
MOST_RANGES = 8
"""Values with a range that one file may have: twice as many corners with each."""


ROD = "cylinder.rod"
"""What the inertia of a rod moves with: that of two masses at its ends, of its mass and centre."""


class Range(NamedTuple):
    """Lowest and highest of a value, as multiples of it; the value it is proportional to."""

    low: float
    high: float
    moves_with: str = ""


class Box(NamedTuple):
    """The trees in the middle and at the corners of the ranges of a file."""

    middle: Tree
    corners: tuple[Tree, ...]


class Spread(NamedTuple):
    """An engine as given, in the middle of the ranges of its estimated values, at their corners."""

    engine: Engine
    middle: Engine
    corners: tuple[Engine, ...]

    @property
    def ends(self) -> tuple[Engine, ...]:
        """Those in the middle and at the corners."""
        return (self.middle, *self.corners)

    @property
    def engines(self) -> tuple[Engine, ...]:
        """All of them, the engine as given first."""
        return (self.engine, self.middle, *self.corners)


def spread(
    tree: Tree, *, name: str = "the engine", changes: Mapping[str, Any] | None = None
) -> Spread | None:
    """The engines of a tree over the ranges of its estimated values; None where it has none.

    Raises EngineFileError, which names the ranges at whose ends it is no engine.
    """
    ends = box(tree, name=name)
    if ends is None:
        return None
    own = engine_of(tree, name=name, changes=changes)
    try:
        middle, *corners = (
            engine_of(each, name=name, changes=changes) for each in (ends.middle, *ends.corners)
        )
    except EngineFileError as error:
        raise _too_wide(tree, name, changes, error) from None
    return Spread(own, middle, tuple(corners))


def _too_wide(
    tree: Tree, name: str, changes: Mapping[str, Any] | None, error: EngineFileError
) -> EngineFileError:
    """The error of ranges at whose ends there is no engine; `error` is that of some of them."""
    faults: list[Fault] = []
    for path, ends in ranges(tree).items():
        for end in (ends.low, ends.high):
            try:
                engine_of(scaled(tree, {path: end}), name=name, changes=changes)
            except EngineFileError as alone:
                values = {"end": end, "mistake": alone.faults[0].sentence}
                faults.append(Fault(("provenance", path, "range"), "provenance.wide", values))
    if not faults:
        values = {"mistake": error.faults[0].sentence}
        faults.append(Fault(("provenance",), "provenance.wide-together", values))
    cells = tree.cells if isinstance(tree, SpreadsheetTree) else None
    return EngineFileError(name, faults, cells)


def ranges(tree: Mapping[str, Any]) -> dict[str, Range]:
    """The estimated values of a file on which a force depends, with their ranges.

    >>> ranges({"provenance": {"cylinder.rod.mass": {"status": "estimated", "range": [0.8, 1.25]}}})
    {'cylinder.rod.mass': Range(low=0.8, high=1.25, moves_with='')}
    """
    sources = tree.get("provenance")
    entries = sources.items() if isinstance(sources, dict) else ()
    out: dict[str, Range] = {}
    for path, entry in entries:
        try:
            source = Provenance.model_validate(entry)
        except ValidationError:  # which reading the file tells
            continue
        if source.status == "estimated" and source.range and path not in CONDITIONS:
            out[path] = Range(*source.range, source.moves_with or "")
    return out


def box(tree: Tree, *, name: str = "the engine") -> Box | None:
    """The trees in the middle and at the corners of the ranges; None where there are no ranges.

    Raises EngineFileError where there are more than MOST_RANGES.
    """
    # in one order, however a file lists them: corners of engines that are compared go together
    own = dict(sorted(ranges(tree).items()))
    if not own:
        return None
    if len(own) > MOST_RANGES:
        values = {"count": len(own), "greatest": MOST_RANGES, "paths": [*own]}
        raise refused(name, "too-many-ranges", **values)
    middle = {path: (ends.low + ends.high) / 2 for path, ends in own.items()}
    corners = product(*((ends.low, ends.high) for ends in own.values()))
    return Box(
        scaled(tree, middle),
        tuple(scaled(tree, dict(zip(own, sizes, strict=True))) for sizes in corners),
    )


def scaled(tree: Tree, factors: Mapping[str, float]) -> Tree:
    """The tree with estimated values times their factors; what moves with them follows.

    >>> tree = {"cylinder": {"bore": "80 mm", "reciprocating_mass": "400 g"}, "provenance": {
    ...     "cylinder.reciprocating_mass": {"status": "estimated", "range": [0.8, 1.25]}}}
    >>> scaled(tree, {"cylinder.reciprocating_mass": 1.25})["cylinder"]
    {'bore': '80 mm', 'reciprocating_mass': '500.0 g'}
    """
    out = copied(tree)
    for path, ends in ranges(tree).items():
        factor = factors.get(path, 1.0) * factors.get(ends.moves_with, 1.0)
        for table, key in _places(out, path):
            table[key] = _times(table[key], factor)
    for path, ends in ranges(tree).items():
        if ends.moves_with == ROD:
            _follow(tree, out, path)
    return out


def _follow(tree: Tree, out: Tree, path: str) -> None:
    """Let the inertia of each rod move with that of two masses at its ends."""
    pairs = zip(_places(tree, ROD), _places(out, ROD), strict=True)
    *_outer, last = keys_of(path)
    for (before, key), (after, _key) in pairs:
        own = two_masses(before)
        if own > 0 and last in after[key]:
            after[key][last] = _times(after[key][last], two_masses(after) / own)


def two_masses(cylinder: Mapping[str, Any]) -> float:
    """Moment of inertia of two masses at the ends of a cylinder's rod, m b (l - b), in kg m^2.

    m the mass of the rod, b its centre from the big end, l its length; 0 where one is not given.

    >>> rod = {"mass": "500 g", "centre": "40 mm"}
    >>> two_masses({"stroke": "80 mm", "rod_ratio": 3.5, "rod": rod})
    0.002
    """
    try:
        rod = cylinder["rod"]
        centre = units.without_tolerance(rod["centre"], LENGTH)
        length = (
            units.without_tolerance(cylinder["rod_length"], LENGTH)
            if "rod_length" in cylinder
            else cylinder["rod_ratio"] * units.without_tolerance(cylinder["stroke"], LENGTH) / 2
        )
        return units.without_tolerance(rod["mass"], MASS) * centre * (length - centre)
    except (KeyError, TypeError, ValueFaultError):
        return 0.0


def _places(tree: Tree, path: str) -> Iterator[tuple[Any, Any]]:
    """What holds a value, and its key; in the explicit form every part of which it is said."""
    first, *rest = path.split(".")
    if not is_explicit(tree) or first not in ("cylinder", "cylinders", "layout"):
        yield from _place(tree, keys_of(path))
        return
    shafts = tree.get("shaft", [])
    throws = [throw for shaft in shafts for throw in shaft.get("throw", [])]
    if rest == ["bore_pitch"]:
        weights = [weight for shaft in shafts for weight in shaft.get("weight", [])]
        yield from _place(tree, ["bore_pitch"])
        for part in (*tree["cylinders"], *throws, *weights):
            yield from _place(part, ["z"])
        return
    for part in throws if rest in (["rotating_mass"], ["throw_mass"]) else tree["cylinders"]:
        yield from _place(part, rest)


def _place(tree: Any, keys: Sequence[str | int]) -> Iterator[tuple[Any, Any]]:
    if not keys:
        return
    *outer, last = keys
    try:
        for key in outer:
            tree = tree[key]
        value = tree[last]
    except (KeyError, IndexError, TypeError):
        return
    if isinstance(value, str | int | float) or last == "rod":
        yield tree, last


def _times(value: Any, factor: float) -> Any:
    """A value of a file, with or without a unit, times a factor."""
    if not isinstance(value, str):
        return value * factor
    return re.sub(
        r"^\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?", lambda number: repr(float(number[0]) * factor), value
    )
