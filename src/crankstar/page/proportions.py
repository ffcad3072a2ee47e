"""Dimensions for a drawing that an engine file does not give: bores, pitches, radii.

All lengths are in the unit of the scene: metres, or crank radii of an engine without sizes. Ratios
are those of ordinary engines (pins about half a bore thick, bores a fifth apart); the physics does
not use them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from math import cos, hypot, inf, sin

import numpy as np

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder
from crankstar.language.faults import listed
from crankstar.language.messages import _
from crankstar.spectra import Complex, Real

SAMPLES = 360
"""Crank angles over a turn; travels are then exact to 1e-5 of the stroke."""
BORE_TO_STROKE = 1.0
PITCH, PIN_GAP, ROD = 1.18, 0.55, 0.26
"""Bores: pitch of the cylinders, of the pins of neighbouring throws, and the width of a rod."""
PIN, JOURNAL = 0.26, 0.31
"""Bores: radii of crank pin and main journal."""
PIN_OF_THROW, JOURNAL_OF_THROW, PIN_OF_KNUCKLE = 0.55, 0.8, 0.62
"""Greatest radii of pin and journal in crank radii, of the pin in distances of a knuckle pin."""
CROWN, SKIRT = 0.42, 0.34
"""Bores: from the piston pin up to the crown and down to the edge."""
CROSSHEAD = 2.5
"""Bores: engines of a longer stroke have a crosshead."""


@dataclass(frozen=True)
class Proportions:
    """Sizes for a drawing, in the unit of the scene, by cylinder [C].

    `along` is the engine's unit of z in that unit; `travel` [C, 2] the least and greatest distance
    of the piston pin from the shaft; `pistons`, `big_ends` [C, sample] places about the own shaft.
    """

    along: float
    bores: Real
    travel: Real
    pistons: Complex
    big_ends: Complex
    crowns: Real
    skirts: Real
    assumed: tuple[str, ...]

    @property
    def bore(self) -> float:
        """The smallest bore, from which the sizes of shafts are taken."""
        return float(self.bores.min())


def proportions(engine: Engine) -> Proportions:
    """The sizes for a drawing of an engine, given or assumed."""
    links = motion.linkage(engine)
    moved = motion.rods(links, np.arange(SAMPLES) * (2 * np.pi / SAMPLES))
    axis = np.exp(1j * links.bearing)[:, None]
    along_axis = (moved.piston.place / axis).real
    roots = [engine.cylinders[index].bearing for index in motion.roots(links.master)]
    frame = np.exp(1j * np.array(roots))[:, None]
    travel = np.stack([along_axis.min(axis=1), along_axis.max(axis=1)], axis=1)
    assumed: list[str] = []
    bores = _bores(engine, assumed)
    along = _along(engine, bores, assumed)
    crowns, skirts = _pistons(engine, bores, travel)
    strokes = travel[:, 1] - travel[:, 0]
    if np.any(strokes > CROSSHEAD * bores):
        assumed.append(
            _(
                "An engine with so long a stroke has a crosshead; here the rod is drawn up to "
                "the piston."
            )
        )
    return Proportions(
        along,
        bores,
        travel,
        moved.piston.place * frame,
        moved.big_end.place * frame,
        crowns,
        skirts,
        tuple(assumed),
    )


def _bores(engine: Engine, assumed: list[str]) -> Real:
    """Bores as given, else equal to the stroke where the next cylinder leaves room."""
    known = {"pitch", "radius"}.isdisjoint(engine.relative)
    widths = []
    for cylinder in engine.cylinders:
        room = inf
        if known:
            room = (
                min(
                    (_distance(engine, cylinder, other) for other in _alike(engine, cylinder)),
                    default=inf,
                )
                / PITCH
            )
        widths.append(
            cylinder.bore or min(2 * BORE_TO_STROKE * engine.throw(cylinder).radius, room)
        )
    missing = [cylinder.number for cylinder in engine.cylinders if cylinder.bore is None]
    if len(missing) == len(engine.cylinders):
        assumed.append(_("The file gives no bore; the bore is drawn about equal to the stroke."))
    elif missing:
        assumed.append(
            _(
                "The file gives no bore for cylinders {cylinders}; it is drawn about equal to the "
                "stroke.",
                cylinders=listed(missing),
            )
        )
    return np.array(widths)


def _alike(engine: Engine, cylinder: Cylinder) -> Iterator[Cylinder]:
    """The other cylinders whose axes are parallel and point the same way."""
    for other in engine.cylinders:
        if other is not cylinder and _parallel(other, cylinder):
            yield other


def _parallel(one: Cylinder, other: Cylinder) -> bool:
    return abs(2 * sin((one.bearing - other.bearing) / 2)) < 1e-6


def _distance(engine: Engine, first: Cylinder, second: Cylinder) -> float:
    """Between two parallel axes; infinite where they are the same."""
    distance = hypot(_aside(engine, first) - _aside(engine, second), first.z - second.z)
    return distance if distance > 1e-9 else inf


def _aside(engine: Engine, cylinder: Cylinder) -> float:
    """How far a cylinder's axis passes clockwise of the reference crank axis."""
    shaft = engine.shaft(cylinder.shaft)
    return shaft.right * cos(cylinder.bearing) - shaft.up * sin(cylinder.bearing) + cylinder.offset


def _along(engine: Engine, bores: Real, assumed: list[str]) -> float:
    """The engine's unit of length along the crankshaft, in the unit of the scene."""
    if {"pitch", "radius"}.isdisjoint(engine.relative):
        return 1.0
    bore = float(bores.max())
    needed = [0.0]
    for first, second in combinations(engine.cylinders, 2):
        gap = abs(first.z - second.z)
        if gap < 1e-9:
            continue
        parallel = (
            _parallel(first, second) and abs(_aside(engine, first) - _aside(engine, second)) < bore
        )
        same_pin = (first.shaft, first.throw) == (second.shaft, second.throw)
        on_shaft = PIN_GAP if first.shaft == second.shaft else 0.0
        needed.append((PITCH if parallel else ROD if same_pin else on_shaft) * bore / gap)
    if "pitch" in engine.relative:
        assumed.append(_("The file gives no bore pitch; it is drawn as short as the bores allow."))
    elif "radius" in engine.relative and max(needed):
        assumed.append(
            _("The file gives no stroke; the cylinders are drawn as close as their bores allow.")
        )
    return max(needed) or PITCH * bore / (engine.bore_pitch or 1.0)


def _pistons(engine: Engine, bores: Real, travel: Real) -> tuple[Real, Real]:
    """From the piston pin to crown and skirt, with clearance to facing pistons and the shaft."""
    crowns = CROWN * bores
    for pistons in engine.chambers.values():
        if len(pistons) != 2:
            continue
        index = [engine.cylinders.index(piston) for piston in pistons]
        facing = np.exp(1j * pistons[0].bearing) + np.exp(1j * pistons[1].bearing)
        if abs(facing) > 1e-6:
            continue  # side by side, as in a U
        places = [engine.shaft(piston.shaft) for piston in pistons]
        between = abs(complex(places[0].up - places[1].up, places[0].right - places[1].right))
        room = between - float(travel[index, 1].sum())
        crowns[index] = np.minimum(
            crowns[index], max(0.45 * room, 0.05 * float(bores[index].min()))
        )
    return crowns, np.minimum(SKIRT * bores, 0.3 * np.maximum(travel[:, 0], 1e-3 * bores))
