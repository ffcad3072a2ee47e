"""Counterweights on the crankshafts from a balance factor, the share of the reciprocating mass.

A weight opposite a pin takes `rotating + factor * reciprocating` times the radius from the vector
that turns with the crank. Weights in other planes have the same effect if on each shaft their
unbalances u_j and their moments agree:

    sum u_j = U,    sum z_j u_j = V,

U and V those of weights at the throws. Of all solutions the one with the least sum of |u_j|^2 is
taken; two planes are enough.
"""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import isfinite

import numpy as np

from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import end_webs, pin_groups
from crankstar.engine.records import Shaft, Weight
from crankstar.language.messages import MessageError
from crankstar.remedy.loads import Load, bobweight, loads

GREATEST_FACTOR = 1.5
CLOSEST = 1e-3
"""Bore pitches between two planes, at least."""
NEGLIGIBLE = 1e-12
"""Share of the greatest unbalance below which a weight is left out."""


class RemedyError(MessageError):
    """A remedy that is impossible; the message says what is possible."""


def with_counterweights(
    engine: Engine, *, factor: float, planes: Sequence[float] | None = None
) -> Engine:
    """The engine with counterweights instead of those that its crankshafts have.

    `factor` is the share of all the reciprocating mass on each pin, 0 to 1.5, that is balanced
    besides all of the rotating mass. `planes` are places along the shaft (z, m or bore pitches as
    the engine counts); without them a weight stands opposite every pin. Shafts without throws keep
    their weights. Raises RemedyError.

    >>> from crankstar import balance, load, spectra, total
    >>> weighted = with_counterweights(load("v2-90"), factor=0.5)
    >>> first = spectra.selected(total(balance(weighted)).force, 1)

    A factor of one half leaves a 90 degree V-twin no first-order force:

    >>> bool(abs(first.forward[0]) + abs(first.backward[0]) < 1e-12)
    True
    """
    if planes is None:
        return _balanced(engine, factor, lambda _shaft, own: _opposite(own, factor))
    possible_planes(engine, planes)
    return _balanced(engine, factor, lambda _shaft, own: _in_planes(own, factor, planes))


def with_web_weights(engine: Engine, *, factor: float, ends_only: bool = False) -> Engine:
    """The engine with counterweights on the two webs of each throw; `ends_only`, on the end webs.

    >>> from crankstar.files.catalog import load
    >>> len(with_web_weights(load("v8-cross-plane"), factor=0.5).shafts[0].weights)  # two a throw
    8
    """

    def weights(shaft: Shaft, own: Sequence[Load]) -> list[Weight]:
        if ends_only:
            return _in_planes(own, factor, end_webs(engine, shaft))
        by_throw = [
            _in_planes(
                [pin for pin in own if pin.throw in group.throws],
                factor,
                tuple(dict.fromkeys(group.webs)),  # an overhung throw may have one web
                throw=group.throws[0] if len(group.throws) == 1 else None,
            )
            for group in pin_groups(engine, shaft)
        ]
        return [weight for pair in by_throw for weight in pair]

    return _balanced(engine, factor, weights)


def _balanced(
    engine: Engine, factor: float, weights: Callable[[Shaft, list[Load]], list[Weight]]
) -> Engine:
    if not isfinite(factor) or not 0 <= factor <= GREATEST_FACTOR:
        raise RemedyError(
            "the balance factor is {factor}; give a share of the reciprocating mass from 0 to "
            "{greatest}",
            factor=f"{factor:g}",
            greatest=f"{GREATEST_FACTOR:g}",
        )
    pins = loads(engine)
    own = {
        shaft.name: [pin for pin in pins if pin.shaft == shaft.name]
        for shaft in engine.shafts
        if shaft.throws
    }
    return with_weights(engine, {name: weights(engine.shaft(name), on) for name, on in own.items()})


def without_counterweights(engine: Engine) -> Engine:
    """The engine with bare crankshafts; shafts without throws keep their weights."""
    return with_weights(engine, {shaft.name: () for shaft in engine.shafts if shaft.throws})


def possible_planes(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places along the shaft that are too few, double or beyond it. Raises RemedyError."""
    if len(planes) < 2 or len(set(planes)) < len(planes):
        raise RemedyError("give two planes or more, all different")
    apart(engine, planes)
    on_the_shaft(engine, planes)


def on_the_shaft(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places beyond the crankshaft. Raises RemedyError."""
    places = [throw.z for shaft in engine.shafts for throw in shaft.throws] + [
        cylinder.z for cylinder in engine.cylinders
    ]
    front, rear = max(places), min(places)
    room = engine.pitch
    beyond = [
        plane for plane in planes if not isfinite(plane) or not rear - room <= plane <= front + room
    ]
    if beyond:
        unit = "bore pitches" if "pitch" in engine.relative else "m"
        raise RemedyError(
            "the plane z = {plane} {unit} is beyond the crankshaft, whose pins and "
            "cylinders lie "
            "between z = {rear} and {front} {unit}; a plane may be up to one bore pitch "
            "({pitch} "
            "{unit}) beyond them",
            plane=f"{beyond[0]:g}",
            unit=unit,
            rear=f"{rear:g}",
            front=f"{front:g}",
            pitch=f"{room:g}",
        )


def apart(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse planes that are not finite, or so close that their weights would be huge.

    Raises RemedyError.
    """
    if not all(isfinite(plane) for plane in planes):
        raise RemedyError("a plane has no position along the shaft; give a finite number")
    ordered = sorted(planes)
    if any(b - a < CLOSEST * engine.pitch for a, b in pairwise(ordered)):
        raise RemedyError(
            "two planes are closer than {closest} bore pitches; give planes that are all different",
            closest=f"{CLOSEST:g}",
        )


def _opposite(pins: Sequence[Load], factor: float) -> list[Weight]:
    vectors = [-bobweight(pin, factor) * pin.radius * exp(1j * pin.angle) for pin in pins]
    return turned_weights(vectors, [pin.z for pin in pins], throws=[pin.throw for pin in pins])


def _in_planes(
    pins: Sequence[Load], factor: float, planes: Sequence[float], *, throw: int | None = None
) -> list[Weight]:
    """Weights in these planes, of this throw if they are all its own."""
    vectors = np.array([-bobweight(pin, factor) * pin.radius * exp(1j * pin.angle) for pin in pins])
    moment = complex((vectors * [pin.z for pin in pins]).sum())
    return turned_weights(
        least_weights(force=complex(vectors.sum()), moment=moment, planes=planes),
        planes,
        throws=[throw] * len(planes),
    )


def least_weights(*, force: complex, moment: complex, planes: Sequence[float]) -> list[complex]:
    """Unbalances u_j in planes z_j with sum u_j = force, sum z_j u_j = moment, least sum |u_j|^2.

    They are the pseudo-inverse of the two conditions; z and the moment count from one point.
    """
    places = np.array(planes, float)
    middle = float(np.mean(places))  # with moments about it, both conditions count alike
    reach = float(np.max(np.abs(places - middle))) or 1.0  # one plane has no reach
    conditions = np.array([np.ones(places.size), (places - middle) / reach])
    wanted = np.array([force, (moment - middle * force) / reach])
    return [complex(unbalance) for unbalance in np.linalg.pinv(conditions) @ wanted]


def turned_weights(
    vectors: Sequence[complex],
    places: Sequence[float],
    *,
    throws: Sequence[int | None] | None = None,
    negligible: float = NEGLIGIBLE,
) -> list[Weight]:
    """Weights from their unbalance vectors (up + i right at theta = 0), and the throws they have.

    Those negligible beside the greatest are left out.
    """
    greatest = max(map(abs, vectors), default=0.0)
    return [
        Weight(unbalance=abs(vector), angle=phase(vector), z=place, throw=throw)
        for vector, place, throw in zip(
            vectors, places, throws or [None] * len(places), strict=True
        )
        if abs(vector) > negligible * greatest
    ]
