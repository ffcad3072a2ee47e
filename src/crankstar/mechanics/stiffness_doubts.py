"""Stiffnesses of a crankshaft with which hardly any engine turns: slips of unit.

Each is a `Fault`, a place with a sentence, as in `doubts`, which has these too. Those of the mounts
are in `dynamics.mount_doubts`, since what a block does on them is computed there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import pi
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.engine.torsion import Torsion
from crankstar.language.faults import Fault
from crankstar.mechanics.kinetic import carried_inertias

Path = tuple[str | int, ...]
SLOWEST_CRANK = 20.0
"""m/s: crank radius times the first natural frequency (rad/s) of the throws by themselves.

In engines of one shape it is the same for all sizes, as the speed of sound is: 100 to 500 of
engines of vehicles, about 50 of twelve throws of the largest ships. Our judgement.
"""
LOWEST_CRANK = 2.0
"""Hz: the same where the crank radius is not known; the longest of all crankshafts has 5."""
SHEAR_WAVE = 3200.0
"""m/s in steel, sqrt(G/rho): no shaft of length L twists faster than pi times that over L."""
LOWEST_DISC = 0.5
"""Hz: a car that shuffles on its drive shafts has 1 to 2."""
ELASTIC = 2.06e11
"""Pa: of steel."""
LEAST_BEAM, MOST_BEAM = 0.25, 2.5
"""Diameter of the solid shaft of steel as stiff as a crankshaft over the bore of its cylinders.

A crank of a car has about 0.6 to 1, one of a slow ship's engine, by its throws, 0.5. Our judgement.
"""
LEAST_SUPPORT, MOST_SUPPORT = 1e-3, 1.0
"""Stiffness of a main bearing with its wall over E times that bore: 0.005 to 0.1. Our judgement."""


def twist_doubts(engine: Engine, own: Torsion) -> Iterator[Fault]:
    """Throws that vibrate slower or faster by themselves, discs and couplings slower, than any do.

    >>> from crankstar.engine.torsion import Disc
    >>> from crankstar.files.catalog import load
    >>> ring = Disc(name="ring", inertia=1.0, to="rear", stiffness=1.0)
    >>> [fault.code for fault in twist_doubts(load("i4"), Torsion(discs=[ring]))]
    ['doubt.soft-disc']
    """
    for index, disc in enumerate(own.discs):
        yield from _slow(("disc", index), disc.stiffness, disc.inertia)
    if not (own.inertia or own.bare_inertia):
        return
    if {"mass", "radius"} & {*engine.relative} and not own.inertia:
        return
    inertia = [*own.inertia] or (carried_inertias(engine) + np.array(own.bare_inertia)).tolist()
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    starts = np.cumsum([0, *(len(crank.throws) for crank in cranks)]).tolist()
    each = [
        inertia[start:end] if len(inertia) > 1 else [inertia[0]] * (end - start)
        for start, end in pairwise(starts)
    ]
    whole = {crank.name: sum(own) for crank, own in zip(cranks, each, strict=True)}
    for index, coupling in enumerate(own.couplings):
        yield from _slow(("coupling", index), coupling.stiffness, whole[coupling.crankshaft])
    if own.stiffness:
        yield from _crank_doubts(engine, own, cranks, each)


def _slow(place: Path, stiffness: float | None, inertia: float) -> Iterator[Fault]:
    """A shaft on which what it carries vibrates slower than on any."""
    frequency = ((stiffness or 0.0) / inertia) ** 0.5 / (2 * pi)
    if 0 < frequency < LOWEST_DISC:
        values = _vibrating(stiffness or 0.0, frequency, LOWEST_DISC)
        values["inertia"] = float(f"{inertia:.4g}")
        yield Fault(("torsion", *place, "stiffness"), "doubt.soft-disc", values)


def _crank_doubts(
    engine: Engine, own: Torsion, cranks: Sequence[Shaft], inertia: Sequence[Sequence[float]]
) -> Iterator[Fault]:
    """The first crankshaft whose throws, of these inertias, vibrate too slow or too fast."""
    gap = 0
    for crank, masses in zip(cranks, inertia, strict=True):
        count = len(crank.throws)
        gaps = [number if len(own.stiffness) > 1 else 0 for number in range(gap, gap + count - 1)]
        gap += count - 1
        if count == 1:
            continue
        stiff = [own.stiffness[each] for each in gaps]
        frequency = _first_frequency(masses, stiff)
        radius = None if "radius" in engine.relative else min(each.radius for each in crank.throws)
        least = LOWEST_CRANK if radius is None else SLOWEST_CRANK / (2 * pi * radius)
        if frequency < least:
            values = _vibrating(min(stiff), frequency, least)
            yield Fault(("torsion", "stiffness"), "doubt.soft-crank", values)
            return
        places = [each.z for each in crank.throws]
        length = max(places) - min(places)
        if "pitch" in engine.relative or not length:
            continue
        most = SHEAR_WAVE / (2 * length)
        if frequency > most:
            values = _vibrating(max(stiff), frequency, most)
            yield Fault(("torsion", "stiffness"), "doubt.stiff-crank", values)
            return


def _vibrating(stiffness: float, frequency: float, bound: float) -> dict[str, Any]:
    rounded = {"frequency": frequency, "bound": bound}
    own = {name: float(f"{value:.3g}") for name, value in rounded.items()}
    return {"value": stiffness, **own}


def _first_frequency(inertia: Sequence[float], stiffness: Sequence[float]) -> float:
    """The first natural frequency (Hz) of masses in a row with these stiffnesses between them."""
    roots = 1 / np.sqrt(inertia)
    matrix = np.zeros((len(inertia), len(inertia)))
    for index, own in enumerate(stiffness):
        matrix[index : index + 2, index : index + 2] += own * np.array([[1, -1], [-1, 1]])
    squares = np.linalg.eigvalsh(matrix * np.multiply.outer(roots, roots))
    return float(np.sqrt(squares[1]) / (2 * pi))


def beam_doubts(engine: Engine) -> Iterator[Fault]:
    """A crankshaft as a beam, and its main bearings, softer or stiffer than any of its size.

    E I = E pi d^4/64 of a solid shaft of diameter d.

    >>> from crankstar.files.catalog import load
    >>> own = {"bending_stiffness": "400 N*m^2", "bearing_stiffness": "500 kN/mm"}
    >>> slip = load("audi-25-tfsi", changes={"crankshaft": [own]})
    >>> [(fault.code, fault.values["diameter"]) for fault in beam_doubts(slip)]
    [('doubt.crank-beam', 14.1)]
    """
    if {"pitch", "radius"} & {*engine.relative}:
        return
    for index, shaft in enumerate(engine.shafts):
        beam, support = shaft.bending_stiffness, shaft.bearing_stiffness
        own = [each for each in engine.cylinders if engine.throw(each) in shaft.throws]
        size = max((each.bore or 2 * engine.throw(each).radius for each in own), default=0.0)
        if not (beam and support and size):
            continue
        diameter = (64 * beam / (pi * ELASTIC)) ** 0.25
        if not LEAST_BEAM <= diameter / size <= MOST_BEAM:
            values = {
                "value": beam,
                "diameter": float(f"{1e3 * diameter:.3g}"),
                **_ends(LEAST_BEAM * size * 1e3, MOST_BEAM * size * 1e3, size),
            }
            yield Fault(("crankshaft", index, "bending_stiffness"), "doubt.crank-beam", values)
        stiff = ELASTIC * size * 1e-3
        if not LEAST_SUPPORT <= support * 1e-3 / stiff <= MOST_SUPPORT:
            values = {
                "value": support * 1e-3,
                **_ends(LEAST_SUPPORT * stiff, MOST_SUPPORT * stiff, size),
            }
            yield Fault(("crankshaft", index, "bearing_stiffness"), "doubt.crank-support", values)


def _ends(low: float, high: float, size: float) -> dict[str, float]:
    """Bounds in two figures, and the size (m) that they are for in mm."""
    return {"low": float(f"{low:.2g}"), "high": float(f"{high:.2g}"), "size": 1e3 * size}
