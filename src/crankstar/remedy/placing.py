"""Where balance shafts must lie so that the block rolls least, or not at all.

A balance shaft at the place P (up + i right of the crankshaft) with the force f that turns at s k
theta, s = 1 with the reference crankshaft and -1 against it, has the moment about the crank axis

    Im(conj(P) f exp(i s k theta)) = Re(c exp(i k theta)),    c = -i conj(P) f  for s = 1,
                                                              c = i P conj(f)   for s = -1,

clockwise, of a reference crankshaft that turns clockwise. So the rolling moment of order k is
affine in the places of the shafts of speed ratio k and -k. One shaft with a force can have any
moment: there is exactly one place P* at which order k has no roll, and everywhere else

    |roll of order k| = |f| |P - P*|.

In a box that does not contain P* the best place is the point of the box nearest to it. Shafts of
one ratio that share the force equally count as one at the mean of their places. A pair of ratios k
and -k has a line of such places for each of the two: of all that leave the least roll in their
boxes, the ones nearest to the places they had are taken.

The roll is taken about the centre of mass of the block where the file gives one, else about the
crank axis; where no force of the order is left, it is the same about every axis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import isfinite
from typing import NamedTuple

import numpy as np

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.bounds import length
from crankstar.mechanics.excitation import Reference
from crankstar.remedy.clear_places import Box, nearest_clear
from crankstar.remedy.clearance import kept_clear
from crankstar.remedy.counterweights import RemedyError
from crankstar.remedy.rolling import ZERO, push, roll, roll_of
from crankstar.spectra import Real

MOST_SHAFTS = 4
"""Shafts of one order that can be placed together: 3^8 faces of their boxes."""


class Placing(NamedTuple):
    """The places of the shafts of one order, up + i right, and the roll that they leave.

    `on_axis` is the roll with the shafts on the crank axis, which a symmetric pair leaves too,
    `roll` that in these places, kg m^2 at 1 rad/s. `without_roll` is the place at which the mean
    of the shafts' places would leave none; None for shafts of both senses, or without force.
    `inside` is a place that would leave less, but lies in what a crank sweeps or in another shaft;
    None where there is none.
    """

    order: Fraction
    shafts: tuple[str, ...]
    places: tuple[complex, ...]
    without_roll: complex | None
    on_axis: float
    roll: float
    inside: complex | None = None


def roll_reference(engine: Engine) -> Reference:
    """The centre of mass of the block where the file gives one, else the crank axis."""
    middle = default_reference(engine)
    if engine.block is None:
        return middle
    z = middle.z if engine.block.z is None else engine.block.z
    return Reference(z, engine.block.up, engine.block.right)


def placed(
    engine: Engine,
    *,
    shafts: Sequence[str],
    boxes: Sequence[Box],
    reference: Reference | None = None,
    like: Engine | None = None,
    clear: bool = False,
) -> tuple[Engine, tuple[Placing, ...]]:
    """The engine with these balance shafts at the places in their boxes that leave least roll.

    One box is for all of them, else each has its own. With `clear` a shaft that is the only one of
    its order keeps clear of cranks and other shafts where its box allows it; with `like` they are
    where they are in that engine. Raises RemedyError.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_balance_shaft, with_web_weights
    >>> half = with_web_weights(load("i2-360"), factor=0.5)
    >>> twin = with_balance_shaft(half, ratio=-1, planes=[0])
    >>> room = Box(up=(-3, -2), right=(-1, 1))
    >>> after, (order,) = placed(twin, shafts=["balancer -1"], boxes=[room])
    >>> order.places[0], round(order.without_roll.real, 4)  # the latter amid the crank
    ((-2+0j), 0.127)
    >>> round(order.roll / abs(order.places[0] - order.without_roll), 9)  # the force of the shaft
    1.0
    """
    own = [Box(*box) for box in boxes] * (len(shafts) if len(boxes) == 1 else 1)
    if len(own) != len(shafts):
        raise RemedyError(
            "{boxes} boxes for {count} balance shafts; give one for all, or one for each",
            boxes=len(boxes),
            count=len(shafts),
        )
    for box in own:
        _possible(box, engine.across)
    by_order: dict[Fraction, list[tuple[Shaft, Box]]] = {}
    for name, box in zip(shafts, own, strict=True):
        shaft = engine.shaft(name)
        by_order.setdefault(abs(shaft.speed_ratio), []).append((shaft, box))
    placings: list[Placing] = []
    for order, group in by_order.items():
        if len(group) > MOST_SHAFTS:
            raise RemedyError(
                "{count} balance shafts of order {order} are too many to place together; the "
                "greatest number is {greatest}",
                count=len(group),
                order=order,
                greatest=MOST_SHAFTS,
            )
        about = reference or roll_reference(engine)
        engine, placing = _placed(engine, order, group, about, like, clear=clear)
        placings.append(placing)
    return engine, tuple(placings)


def _possible(box: Box, unit: str) -> None:
    for least, most in box:
        if not (isfinite(least) and isfinite(most) and least <= most):
            raise RemedyError(
                "a box reaches from {least} to {most} {unit}; give the smaller length first",
                least=f"{least:g}",
                most=f"{most:g}",
                unit=unit,
            )


def _placed(
    engine: Engine,
    order: Fraction,
    group: Sequence[tuple[Shaft, Box]],
    reference: Reference,
    like: Engine | None,
    *,
    clear: bool,
) -> tuple[Engine, Placing]:
    low = np.array([edge for _, box in group for edge in (box.up[0], box.right[0])])
    high = np.array([edge for _, box in group for edge in (box.up[1], box.right[1])])
    there = np.clip([edge for shaft, _ in group for edge in (shaft.up, shaft.right)], low, high)
    columns = [
        roll_of(engine, force=push(shaft), ratio=shaft.speed_ratio, place=place)
        for shaft, _ in group
        for place in (1.0, 1j)
    ]
    matrix = np.array([np.real(columns), np.imag(columns)])
    names = [shaft.name for shaft, _ in group]

    def roll_at(at: Real) -> complex:
        moved = with_places(engine, dict(zip(names, at.reshape(-1, 2), strict=True)))
        return roll(moved, order, reference)

    on_axis = roll_at(np.zeros_like(there))
    start = roll_at(there)
    sought = there + _least(matrix, start, low - there, high - there)
    best = [_cleared(place) for place in sought.reshape(-1, 2)]
    free = _without_roll(matrix, start, there, {shaft.speed_ratio for shaft, _ in group})
    chosen = best
    if like is not None:
        chosen = [complex(there.up, there.right) for there in map(like.shaft, names)]
    elif clear and len(group) == 1 and free is not None:
        nearest = nearest_clear(free, group[0][1], kept_clear(engine, names[0]))
        chosen = best if nearest is None else [_cleared(np.array([nearest.real, nearest.imag]))]
    scale = max(abs(on_axis), float(np.abs(matrix).max() * np.abs(np.append(low, high)).max()))

    def left(places: Sequence[complex]) -> float:
        wave = roll_at(np.array([edge for at in places for edge in (at.real, at.imag)]))
        return length(wave) if abs(wave) > ZERO * scale else 0.0

    at = {name: (place.real, place.imag) for name, place in zip(names, chosen, strict=True)}
    placing = Placing(order, tuple(names), tuple(chosen), free, length(on_axis), left(chosen))
    if like is None and left(best) < placing.roll * (1 - ZERO):
        placing = placing._replace(inside=best[0])
    return with_places(engine, at), placing


def _without_roll(
    matrix: Real, start: complex, there: Real, ratios: set[Fraction]
) -> complex | None:
    """The place at which the mean of shafts of one ratio and equal forces leaves no roll."""
    forces = np.abs(matrix[0, 0::2] + 1j * matrix[1, 0::2])
    if len(ratios) > 1 or not forces.min() > ZERO * forces.max() > 0:
        return None
    if float(np.ptp(forces)) > ZERO * forces.max():
        return None
    move = np.linalg.solve(forces.size * matrix[:, :2], -np.array([start.real, start.imag]))
    return _cleared(there.reshape(-1, 2).mean(axis=0) + move)


def _cleared(place: Real) -> complex:
    """A place, up + i right, without rounding errors."""
    return complex(
        *(value if abs(value) > ZERO * np.abs(place).max() else 0.0 for value in place.tolist())
    )


def _least(matrix: Real, start: complex, low: Real, high: Real) -> Real:
    """The shortest move d between `low` and `high` of those with the least |start + matrix d|.

    The best move has some coordinates at their limits; the others are the least-squares solution
    of the shortest length. All choices of limits are tried, so the least is global.
    """
    wanted = -np.array([start.real, start.imag])
    room = ZERO * float(max((high - low).max(), np.abs(np.append(low, high)).max()))
    moves: list[Real] = []
    for ends in product((None, 0, 1), repeat=low.size):
        free = np.array([end is None for end in ends])
        move = np.where([end == 1 for end in ends], high, low)
        move[free] = 0.0
        if free.any():
            inner = matrix[:, free]
            move[free] = np.linalg.pinv(inner, rcond=1e-9) @ (wanted - matrix @ move)
        if np.all(move >= low - room) and np.all(move <= high + room):
            moves.append(np.clip(move, low, high))
    left = np.array([np.linalg.norm(matrix @ move - wanted) for move in moves])
    size = float(np.abs(matrix).max(initial=0.0) * np.abs(np.append(low, high)).max())
    best = np.flatnonzero(left <= left.min() + ZERO * (abs(start) + size))
    return min((moves[index] for index in best), key=lambda move: float(np.linalg.norm(move)))


def with_places(engine: Engine, places: Mapping[str, Sequence[float] | Real]) -> Engine:
    """The engine with the shafts of these names at these places, up and right."""
    return with_values(
        engine,
        shafts=tuple(
            with_values(shaft, up=float(places[shaft.name][0]), right=float(places[shaft.name][1]))
            if shaft.name in places
            else shaft
            for shaft in engine.shafts
        ),
    )
