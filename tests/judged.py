"""A derivation beside the Balance of its engine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.derive import Derivation, Line
from crankstar.derive.algebra import rational
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Reference, balance


@dataclass
class Judged:
    """A derivation beside the Balance of its engine, both in m r w^2 (times the bore pitch)."""

    engine: Engine
    told: Derivation
    forward: np.ndarray
    backward: np.ndarray
    allowed: float

    @classmethod
    def of(cls, engine: Engine, told: Derivation, reference: Reference | None = None) -> Judged:
        result = balance(engine, reference=reference)
        spectrum = getattr(result, told.quantity)
        one = spectra.selected(spectrum, float(told.order))
        forward, backward = one.forward[:, 0], one.backward[:, 0]
        most = (np.abs(spectrum.forward) + np.abs(spectrum.backward)).max(initial=0)
        largest = (np.abs(forward) + np.abs(backward)).max()
        arms = 1.0
        if told.quantity == "couple":  # a place is rounded as it is read, however small the force
            arms = max(abs(z - result.reference.z) for z in places(engine)) / engine.pitch
            most = max(most, arms)
        # a motion that is sampled, known to rounding, has k^2 times that of acceleration
        sampled = any(cylinder.articulated for cylinder in engine.cylinders)
        sharper = max(1.0, float(told.order) ** 2 / 4) if sampled else 1.0
        each = 1e-14 * max(most, 1.0) * sharper
        # an angle that is no rational part of a revolution is a ball of 1.3e-12 rad; rods near to
        # locking make it a hundred times as large (5e-10 at order 3); its middle is no better
        if sampled and any(rational.turn(angle) is None for angle in angles(engine)):
            each += 1e-9 * float(told.order) ** 2
        return cls(engine, told, forward, backward, 1e-12 * largest + each * len(result.parts))

    def vector(self, kind: str, rows: tuple[int, ...]) -> complex:
        return complex((self.forward if kind == "forward" else self.backward)[list(rows)].sum())

    def signal(self, bearing_deg: float, rows: tuple[int, ...], theta: float) -> float:
        turn = np.exp(1j * self.engine.sense * float(self.told.order) * theta)
        pushed = self.vector("forward", rows) * turn + self.vector("backward", rows) / turn
        return float((pushed * np.exp(-1j * np.radians(bearing_deg))).real)


def angles(engine: Engine) -> Iterator[float]:
    """Of throws, cylinders and knuckle pins."""
    yield from (throw.angle for shaft in engine.shafts for throw in shaft.throws)
    yield from (cylinder.bearing for cylinder in engine.cylinders)
    yield from (c.articulated.angle for c in engine.cylinders if c.articulated is not None)


def places(engine: Engine) -> list[float]:
    turning = [thing.z for s in engine.shafts for thing in (*s.throws, *s.weights)]
    return [*turning, *(c.z for c in engine.cylinders)]


def lines(told: Derivation) -> Iterator[tuple[str, Line]]:
    for step in told.steps:
        for line in step.lines:
            yield step.title, line
