"""Gear wheels between counter-rotating shafts: radii from their speed ratio and distance."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.page.records import GearShown

FEWEST_TEETH, MOST_TEETH = 14, 400
FARTHEST = 4.5
"""Greatest distance of two meshing shafts, in reaches of a crank; farther ones need a gear train,
which is not drawn."""
MODULE = 0.045
"""Bores: pitch circle diameter to a tooth."""


class Place(NamedTuple):
    """Where a shaft is drawn."""

    up: float
    right: float

    def distance(self, other: Place) -> float:
        """Between two axes."""
        return abs(complex(self.up - other.up, self.right - other.right))


class Mesh(NamedTuple):
    """Two shafts geared to each other, and the radii of the wheels."""

    first: int
    second: int
    radii: tuple[float, float]


def gears(
    engine: Engine, places: Sequence[Place], *, reach: float, bore: float, behind: float
) -> tuple[tuple[GearShown, ...], tuple[str, ...]]:
    """Wheels behind the engine (z below `behind`), each pair in a plane, and notes."""
    if len(engine.shafts) < 2:
        return (), ()
    meshes, undriven = _meshes(engine, places, reach)
    thickness = 0.22 * bore
    wheels: list[GearShown] = []
    for row, mesh in enumerate(meshes):
        z = behind - thickness * (0.8 + 1.3 * row)
        teeth = _teeth(engine, mesh, bore)
        for shaft, radius, count in zip((mesh.first, mesh.second), mesh.radii, teeth, strict=True):
            wheels.append(
                GearShown(shaft=shaft, radius=radius, z=z, thickness=thickness, teeth=count)
            )
    if not undriven:
        return tuple(wheels), ()
    names = ", ".join(engine.shafts[index].name for index in undriven)
    return tuple(wheels), (
        _("The gears, idlers or chains of these shafts are not drawn: {shafts}.", shafts=names),
    )


def _meshes(engine: Engine, places: Sequence[Place], reach: float) -> tuple[list[Mesh], list[int]]:
    """A tree of meshing pairs from the reference shaft, nearest first, and the shafts not in it."""
    joined, meshes = {0}, []
    waiting = set(range(1, len(engine.shafts)))
    while waiting:
        pairs = [
            (places[driver].distance(places[driven]), driver, driven)
            for driver in sorted(joined)
            for driven in sorted(waiting)
            if engine.shafts[driver].speed_ratio * engine.shafts[driven].speed_ratio < 0
        ]
        pairs = [pair for pair in pairs if 1e-6 * reach < pair[0] < FARTHEST * reach]
        if not pairs:
            break
        distance, driver, driven = min(pairs)
        ratio = abs(engine.shafts[driven].speed_ratio / engine.shafts[driver].speed_ratio)
        radii = distance * float(ratio / (1 + ratio)), distance * float(1 / (1 + ratio))
        meshes.append(Mesh(driver, driven, radii))
        joined.add(driven)
        waiting.discard(driven)
    return meshes, sorted(waiting)


def _teeth(engine: Engine, mesh: Mesh, bore: float) -> tuple[int, int]:
    """Numbers of teeth in the ratio of the radii, teeth of an ordinary size."""
    ratio: Fraction = abs(
        engine.shafts[mesh.second].speed_ratio / engine.shafts[mesh.first].speed_ratio
    )
    wanted = 2 * mesh.radii[0] / (MODULE * bore)
    times = max(
        1,
        round(wanted / ratio.numerator),
        -(-FEWEST_TEETH // min(ratio.numerator, ratio.denominator)),
    )
    times = max(1, min(times, MOST_TEETH // max(ratio.numerator, ratio.denominator)))
    return times * ratio.numerator, times * ratio.denominator
