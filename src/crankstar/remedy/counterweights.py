"""Counterweights on the crankshafts, from a balance factor: all of the rotating mass, and a share of the reciprocating.

A weight opposite a pin takes away `rotating + factor * reciprocating` times the radius from the vector that turns with the
crank. Put into planes instead, weights do the same if on each shaft their unbalances u_j and their moments agree:

    sum u_j = U,    sum z_j u_j = V,

U and V those of weights at the throws. Of all solutions the one with the least sum of |u_j|^2 is taken; two planes are enough.
"""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import isfinite

import numpy as np

from crankstar.engine import Engine
from crankstar.records import Shaft, Weight
from crankstar.remedy.loads import Load, bobweight, loads
from crankstar.remedy.planes import end_webs, spans

GREATEST_FACTOR = 1.5
CLOSEST = 1e-3
"""Bore pitches between two planes, at least."""
NEGLIGIBLE = 1e-12
"""Share of the greatest unbalance below which a weight is left out."""


class RemedyError(ValueError):
    """A remedy that cannot be, as one sentence that says what can."""


def with_counterweights(engine: Engine, *, factor: float, planes: Sequence[float] | None = None) -> Engine:
    """The engine with counterweights instead of those that its crankshafts have.

    `factor` is the share of all the reciprocating mass on each pin, 0 to 1.5, that is balanced besides all of the rotating
    mass. `planes` are places along the shaft (z, m or bore pitches as the engine counts); without them a weight stands
    opposite every pin. Shafts without throws keep their weights. Raises RemedyError.

    >>> from crankstar import balance, load, phasor, total
    >>> first = phasor.selected(total(balance(with_counterweights(load("v2-90"), factor=0.5))).force, 1)
    >>> bool(abs(first.forward[0]) + abs(first.backward[0]) < 1e-12)  # half of both pistons leaves a 90 degree V-twin nothing
    True
    """
    if planes is None:
        return _balanced(engine, factor, lambda _, own: _opposite(own, factor))
    possible_planes(engine, planes)
    return _balanced(engine, factor, lambda _, own: _in_planes(own, factor, planes))


def with_web_weights(engine: Engine, *, factor: float, ends_only: bool = False) -> Engine:
    """The same with the weights on the webs: each throw's on its own two, or with `ends_only` all on the outermost two.

    >>> from crankstar.catalog import load
    >>> len(with_web_weights(load("v8-cross-plane"), factor=0.5).shafts[0].weights)  # two to a throw
    8
    """

    def weights(shaft: Shaft, own: Sequence[Load]) -> list[Weight]:
        if ends_only:
            return _in_planes(own, factor, end_webs(engine, shaft))
        by_throw = [
            _in_planes([pin for pin in own if pin.throw in span.throws], factor, span.webs) for span in spans(engine, shaft)
        ]
        return [weight for pair in by_throw for weight in pair]

    return _balanced(engine, factor, weights)


def _balanced(engine: Engine, factor: float, weights: Callable[[Shaft, list[Load]], list[Weight]]) -> Engine:
    if not isfinite(factor) or not 0 <= factor <= GREATEST_FACTOR:
        raise RemedyError(f"the balance factor is {factor:g}; give a share of the reciprocating mass from 0 to {GREATEST_FACTOR:g}")
    pins = loads(engine)
    shafts = []
    for shaft in engine.shafts:
        own = [pin for pin in pins if pin.shaft == shaft.name]
        shafts.append(shaft.model_copy(update={"weights": tuple(weights(shaft, own))}) if own else shaft)
    return engine.model_copy(update={"shafts": tuple(shafts)})


def without_counterweights(engine: Engine) -> Engine:
    """The engine with bare crankshafts; shafts without throws keep their weights."""
    shafts = tuple(shaft.model_copy(update={"weights": ()}) if shaft.throws else shaft for shaft in engine.shafts)
    return engine.model_copy(update={"shafts": shafts})


def possible_planes(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places along the shaft that are too few, double or beyond it. Raises RemedyError."""
    if len(planes) < 2 or len(set(planes)) < len(planes):
        raise RemedyError(f"{len(set(planes))} plane{'s' if len(set(planes)) != 1 else ''} given; name two or more, all different")
    apart(engine, planes)
    on_the_shaft(engine, planes)


def on_the_shaft(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places beyond the crankshaft. Raises RemedyError."""
    places = [throw.z for shaft in engine.shafts for throw in shaft.throws] + [cylinder.z for cylinder in engine.cylinders]
    front, rear = max(places), min(places)
    room = engine.pitch
    beyond = [plane for plane in planes if not isfinite(plane) or not rear - room <= plane <= front + room]
    if beyond:
        unit = "bore pitches" if "pitch" in engine.relative else "m"
        raise RemedyError(
            f"the plane z = {beyond[0]:g} {unit} lies beyond the crankshaft, which has its pins and cylinders from z = {rear:g} to "
            f"{front:g} {unit}; give planes up to one bore pitch ({room:g} {unit}) beyond them"
        )


def apart(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse planes that are no numbers, or so near to each other that weights in them would be huge. Raises RemedyError."""
    if not all(isfinite(plane) for plane in planes):
        raise RemedyError("a plane has no place along the shaft; give each as a finite number")
    ordered = sorted(planes)
    if any(b - a < CLOSEST * engine.pitch for a, b in pairwise(ordered)):
        raise RemedyError(
            f"two planes are the same or nearer to each other than {CLOSEST:g} bore pitches; give planes that are all different"
        )


def _opposite(pins: Sequence[Load], factor: float) -> list[Weight]:
    vectors = [-bobweight(pin, factor) * pin.radius * exp(1j * pin.angle) for pin in pins]
    return turned_weights(vectors, [pin.z for pin in pins])


def _in_planes(pins: Sequence[Load], factor: float, planes: Sequence[float]) -> list[Weight]:
    vectors = np.array([-bobweight(pin, factor) * pin.radius * exp(1j * pin.angle) for pin in pins])
    moment = complex((vectors * [pin.z for pin in pins]).sum())
    return turned_weights(least_weights(force=complex(vectors.sum()), moment=moment, planes=planes), planes)


def least_weights(*, force: complex, moment: complex, planes: Sequence[float]) -> list[complex]:
    """Unbalances u_j in planes z_j with sum u_j = force and sum z_j u_j = moment, and the least sum of |u_j|^2.

    They are the pseudo-inverse of the two conditions; z and the moment count from one point.
    """
    places = np.array(planes, float)
    middle = float(np.mean(places))  # moments about the middle of the planes, so that both conditions count alike
    reach = float(np.max(np.abs(places - middle)))
    conditions = np.array([np.ones(places.size), (places - middle) / reach])
    wanted = np.array([force, (moment - middle * force) / reach])
    return [complex(one) for one in np.linalg.pinv(conditions) @ wanted]


def turned_weights(vectors: Sequence[complex], places: Sequence[float], *, negligible: float = NEGLIGIBLE) -> list[Weight]:
    """Weights from their unbalance vectors (up + i right at theta = 0); those that are nothing beside the greatest are left out."""
    greatest = max(map(abs, vectors), default=0.0)
    return [
        Weight(unbalance=abs(vector), angle=phase(vector), z=place)
        for vector, place in zip(vectors, places, strict=True)
        if abs(vector) > negligible * greatest
    ]
