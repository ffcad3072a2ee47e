"""Counterweights on the crankshafts from a balance factor, the share of the reciprocating mass.

A weight opposite a pin takes its bobweight, `rotating + factor * reciprocating`, and the throw's
own mass, times the radius, from the vector that turns with the crank. Weights in other planes have
the same effect if on each shaft their unbalances u_j and their moments agree:

    sum u_j = U,    sum z_j u_j = V,

U and V those of weights at the throws. Of all solutions the one with the least sum of |u_j|^2 is
taken; two planes are enough. Crankshafts keep the weights that they have, and the new ones take
over what those leave (`kept`), unless they are to be bare.
"""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import isfinite
from typing import NamedTuple

import numpy as np

from crankstar.engine.arguments import check_number, check_planes, is_number
from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import end_webs, pin_groups
from crankstar.engine.records import Shaft, Weight
from crankstar.language.messages import MessageError
from crankstar.remedy.kept import Group, least_weights, relief, vectors
from crankstar.remedy.loads import Load, bobweight, loads

LEAST_FACTOR, GREATEST_FACTOR = -1.0, 3.0
"""Of balance factors: beyond all that engines are built with."""
BEYOND = 3.0
"""Bore pitches from the last pin or cylinder to a plane, at most: a damper, a flywheel."""
CLOSEST = 1e-3
"""Bore pitches between two planes, at least."""
NEGLIGIBLE = 1e-12
"""Share of the greatest unbalance below which a weight is left out."""


class RemedyError(MessageError):
    """A remedy that is impossible; the message says what is possible."""


class Share(NamedTuple):
    """What a group of throws needs: unbalances (up + i right) at its places z, and its throws."""

    needed: tuple[complex, ...]
    group: Group


def with_counterweights(
    engine: Engine, *, factor: float, planes: Sequence[float] | None = None, bare: bool = False
) -> Engine:
    """The engine with counterweights beside those that its crankshafts have; `bare`: instead.

    `factor` is the share of all the reciprocating mass on each pin that is balanced besides all of
    the rotating mass, by the weights that are there and by the new ones together: one half for
    most V8s, 0.52 with an overbalance of two per cent, from -1 to 3. `planes` are places along the
    shaft (z, m or bore pitches as the engine counts); without them a weight stands opposite every
    pin. Shafts without throws keep their weights. Raises RemedyError.

    >>> from crankstar import load, spectra, total
    >>> from crankstar.mechanics.balance import balance
    >>> weighted = with_counterweights(load("v2-90"), factor=0.5)
    >>> first = spectra.selected(total(balance(weighted)).force, 1)

    A factor of one half leaves a 90 degree V-twin no first-order force:

    >>> bool(abs(first.forward[0]) + abs(first.backward[0]) < 1e-12)
    True

    With these weights the crankshaft needs no more of them; for the whole of the mass it needs as
    many again:

    >>> with_counterweights(weighted, factor=0.5) == weighted
    True
    >>> more = with_counterweights(weighted, factor=1)
    >>> [round(weight.unbalance, 9) for weight in more.shafts[0].weights]
    [1.0, 1.0]
    """
    if not is_number(factor):
        check_number("factor", factor)
    if planes is None:
        return _balanced(engine, factor, lambda _shaft, own: _opposite(own, factor), bare=bare)
    possible_planes(engine, planes)
    return _balanced(
        engine, factor, lambda _shaft, own: [_in_planes(own, factor, planes)], bare=bare
    )


def with_web_weights(
    engine: Engine, *, factor: float, ends_only: bool = False, bare: bool = False
) -> Engine:
    """The engine with counterweights on the two webs of each throw; `ends_only`, on the end webs.

    Crankshafts keep the weights that they have unless they are to be `bare`.

    >>> from crankstar.files.catalog import load
    >>> len(with_web_weights(load("v8-cross-plane"), factor=0.5).shafts[0].weights)  # two a throw
    8
    """

    def shares(shaft: Shaft, own: Sequence[Load]) -> list[Share]:
        if ends_only:
            return [_in_planes(own, factor, end_webs(engine, shaft))]
        return [
            _in_planes(
                [pin for pin in own if pin.throw in group.throws],
                factor,
                tuple(dict.fromkeys(group.webs)),  # an overhung throw may have one web
                throws=group.throws,
            )
            for group in pin_groups(engine, shaft)
        ]

    return _balanced(engine, factor, shares, bare=bare)


def _balanced(
    engine: Engine, factor: float, shares: Callable[[Shaft, list[Load]], list[Share]], *, bare: bool
) -> Engine:
    if not isfinite(factor) or not LEAST_FACTOR <= factor <= GREATEST_FACTOR:
        raise RemedyError(
            "the balance factor is {factor}; give a share of the reciprocating mass from {least} "
            "to {greatest}",
            factor=f"{factor:g}",
            least=f"{LEAST_FACTOR:g}",
            greatest=f"{GREATEST_FACTOR:g}",
        )
    pins = loads(engine)
    weights: dict[str, list[Weight]] = {}
    for shaft in engine.shafts:
        if shaft.throws:
            own = shares(shaft, [pin for pin in pins if pin.shaft == shaft.name])
            weights[shaft.name] = (
                _bare(own) if bare else [*shaft.weights, *_more(engine, shaft, own)]
            )
    return with_weights(engine, weights)


def _bare(shares: Sequence[Share]) -> list[Weight]:
    """The weights of a crankshaft without any: those negligible in their group are left out."""
    return [
        weight
        for needed, group in shares
        for weight in turned_weights(
            needed, group.places, throws=[_throw(group)] * len(group.places)
        )
    ]


def _more(engine: Engine, shaft: Shaft, shares: Sequence[Share]) -> list[Weight]:
    """The weights that a crankshaft needs beside its own."""
    if not shaft.weights:
        return _bare(shares)
    groups = [group for _needed, group in shares]
    needed = [vector for share in shares for vector in share.needed]
    relieved = relief(engine, shaft, groups)
    return turned_weights(
        [vector - less for vector, less in zip(needed, relieved, strict=True)],
        [place for group in groups for place in group.places],
        throws=[_throw(group) for group in groups for _place in group.places],
        beside=max(map(abs, [*needed, *vectors(shaft.weights)])),
    )


def _throw(group: Group) -> int | None:
    """The throw of the weights of a group, if it is of one."""
    return group.throws[0] if group.throws is not None and len(group.throws) == 1 else None


def without_counterweights(engine: Engine) -> Engine:
    """The engine with bare crankshafts; shafts without throws keep their weights."""
    return with_weights(engine, {shaft.name: () for shaft in engine.shafts if shaft.throws})


def possible_planes(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places along the shaft that are too few, double or beyond it. Raises RemedyError."""
    check_planes(planes)
    if len(planes) < 2 or len(set(planes)) < len(planes):
        raise RemedyError("give two planes or more, all different")
    apart(engine, planes)
    on_the_shaft(engine, planes)


def on_the_shaft(engine: Engine, planes: Sequence[float]) -> None:
    """Refuse places far beyond the crankshaft, its damper and its flywheel. Raises RemedyError."""
    rear, front = _ends(engine)
    room = BEYOND * engine.pitch
    beyond = [plane for plane in planes if not _within(engine, plane)]
    if beyond:
        unit = "bore pitches" if "pitch" in engine.relative else "m"
        raise RemedyError(
            "the plane z = {plane} {unit} is beyond the crankshaft, whose pins and cylinders lie "
            "between z = {rear} and {front} {unit}; a plane may be up to {beyond} bore pitches "
            "({room} {unit}) beyond them, as on a vibration damper or flywheel",
            plane=f"{beyond[0]:g}",
            unit=unit,
            rear=f"{rear:g}",
            front=f"{front:g}",
            beyond=f"{BEYOND:g}",
            room=f"{room:g}",
        )


def _ends(engine: Engine) -> tuple[float, float]:
    """The last and the first pin or cylinder along the crankshafts."""
    pins = [throw.z for shaft in engine.shafts for throw in shaft.throws]
    places = [*pins, *(cylinder.z for cylinder in engine.cylinders)]
    return min(places), max(places)


def _within(engine: Engine, plane: float) -> bool:
    """Whether a weight may be there, on the crankshaft, its damper or its flywheel."""
    (rear, front), room = _ends(engine), BEYOND * engine.pitch
    return isfinite(plane) and rear - room <= plane <= front + room


def weights_beyond(engine: Engine) -> list[tuple[str, float]]:
    """Weights of crankshafts farther from them than any damper or flywheel: name and z of each.

    Balance shafts may lie apart from the engine, as in a generator set.

    >>> from crankstar.engine.copies import with_weights
    >>> from crankstar.files.catalog import load
    >>> far = Weight(unbalance=0.1, angle=0.0, z=40.0)
    >>> weights_beyond(with_weights(load("i4"), {"crank": [far]}))
    [('crank', 40.0)]
    """
    return [
        (shaft.name, weight.z)
        for shaft in engine.shafts
        if shaft.throws
        for weight in shaft.weights
        if not _within(engine, weight.z)
    ]


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


def _opposite(pins: Sequence[Load], factor: float) -> list[Share]:
    """A weight opposite every pin."""
    return [Share((_needed(pin, factor),), Group((pin.z,), (pin.throw,))) for pin in pins]


def _needed(pin: Load, factor: float) -> complex:
    return -(pin.own + bobweight(pin, factor)) * pin.radius * exp(1j * pin.angle)


def _in_planes(
    pins: Sequence[Load],
    factor: float,
    planes: Sequence[float],
    *,
    throws: tuple[int, ...] | None = None,
) -> Share:
    """The least weights in these planes, of these throws if they are all their own.

    What rounding leaves of pins that balance each other is none.
    """
    needed = np.array([_needed(pin, factor) for pin in pins])
    moment = complex((needed * [pin.z for pin in pins]).sum())
    least = least_weights(force=complex(needed.sum()), moment=moment, planes=planes)
    noise = NEGLIGIBLE * float(np.max(np.abs(needed), initial=0.0))
    kept = tuple(unbalance if abs(unbalance) > noise else 0j for unbalance in least)
    return Share(kept, Group(tuple(planes), throws))


def turned_weights(
    vectors: Sequence[complex],
    places: Sequence[float],
    *,
    throws: Sequence[int | None] | None = None,
    negligible: float = NEGLIGIBLE,
    beside: float = 0.0,
) -> list[Weight]:
    """Weights from their unbalance vectors (up + i right at theta = 0), and the throws they have.

    Those negligible beside the greatest, or `beside` an unbalance, are left out.
    """
    greatest = max(map(abs, [*vectors, beside]))
    return [
        Weight(unbalance=abs(vector), angle=phase(vector), z=place, throw=throw)
        for vector, place, throw in zip(
            vectors, places, throws or [None] * len(places), strict=True
        )
        if abs(vector) > negligible * greatest
    ]
