"""Balance shafts: a shaft that takes away the whole vector that turns at its speed.

In order k = |n| an engine's force is a vector F turning one way and one turning the other; a shaft of speed ratio n turns
with one of them. Weights u_j on it, in planes z_j, push with n^2 w^2 u_j. They cancel force and couple about z0 where

    n^2 sum u_j = -F,    n^2 sum (z_j - z0) u_j = -M,

and of all such weights those with the least sum of |u_j|^2 are taken. A straight line of force (the second order of a four)
needs two shafts, of ratio 2 and -2, half each: F. W. Lanchester's pair. Where a shaft lies changes force and couple not at
all, but its push has an arm about the crankshaft, and so a rolling moment, which the Balance of the new engine shows.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from crankstar import phasor
from crankstar.balance import default_reference
from crankstar.engine import GREATEST_SHAFTS, Engine
from crankstar.mechanism import mechanism, spectra, total
from crankstar.records import Shaft, Weight
from crankstar.remedy.counterweights import NEGLIGIBLE, RemedyError, least_weights

GREATEST_RATIO = 8


def with_balance_shaft(
    engine: Engine, *, ratio: Fraction | int, planes: Sequence[float], up: float = 0.0, right: float = 0.0
) -> Engine:
    """The engine with one more shaft, at `up`, `right` of the crankshaft (m or crank radii), with weights in these planes.

    `ratio` is its speed per turn of the crankshaft, negative against it; `planes` are two or more places along it. Raises
    RemedyError, also where there is nothing for it to balance.

    >>> from crankstar import balance, load, phasor, total
    >>> pair = with_balance_shaft(with_balance_shaft(load("i4"), ratio=2, planes=[1, -1]), ratio=-2, planes=[1, -1])
    >>> second = phasor.selected(total(balance(pair)).force, 2)
    >>> bool(abs(second.forward[0]) + abs(second.backward[0]) < 1e-15)  # F. W. Lanchester's pair
    True
    """
    ratio = Fraction(ratio)
    if ratio == 0 or abs(ratio) > GREATEST_RATIO:
        raise RemedyError(
            f"a balance shaft with speed ratio {ratio} is not possible; give one from -{GREATEST_RATIO} to {GREATEST_RATIO}, not 0"
        )
    if len(set(planes)) < 2:
        raise RemedyError("a balance shaft needs two planes or more, all different, for its weights")
    if len(engine.shafts) >= GREATEST_SHAFTS:
        raise RemedyError(f"the engine has {len(engine.shafts)} shafts already; more than {GREATEST_SHAFTS} are not possible")
    reference = default_reference(engine)
    sums = total(spectra(mechanism(engine), reference=reference))
    way = "forward" if ratio > 0 else "backward"
    force, couple = (complex(getattr(phasor.selected(one, [abs(float(ratio))]), way)[0]) for one in (sums.force, sums.couple))
    squared = float(ratio) ** 2
    vectors = least_weights(force=-force / squared, moment=-couple / squared, planes=[plane - reference.z for plane in planes])
    scale = max(map(abs, vectors))
    pushed = _pushed(engine, abs(float(ratio))) / squared
    if scale <= NEGLIGIBLE * pushed or scale == 0:
        turning = "with" if ratio > 0 else "against"
        raise RemedyError(
            f"nothing of order {abs(ratio)} turns {turning} the crankshaft: a shaft with speed ratio {ratio} has no use"
        )
    weights = tuple(
        Weight(unbalance=abs(vector), angle=phase(vector), z=plane)
        for vector, plane in zip(vectors, planes, strict=True)
        if abs(vector) > NEGLIGIBLE * scale
    )
    shaft = Shaft(name=_name(engine, ratio), speed_ratio=ratio, up=up, right=right, weights=weights)
    return engine.model_copy(update={"shafts": (*engine.shafts, shaft)})


def end_planes(engine: Engine) -> tuple[float, float]:
    """Where balance weights stand unless told otherwise: half a bore pitch beyond the first and the last cylinder."""
    places = [cylinder.z for cylinder in engine.cylinders]
    return max(places) + engine.pitch / 2, min(places) - engine.pitch / 2


def _pushed(engine: Engine, order: float) -> float:
    """What all parts push together in an order, without regard to direction, at 1 rad/s: the measure of what is nothing."""
    parts = phasor.selected(spectra(mechanism(engine)).force, [order])
    return float((np.abs(parts.forward) + np.abs(parts.backward)).sum())


def _name(engine: Engine, ratio: Fraction) -> str:
    names = {shaft.name for shaft in engine.shafts}
    name = f"balancer {ratio}"
    count = 2
    while name in names:
        name, count = f"balancer {ratio}, {count}", count + 1
    return name
