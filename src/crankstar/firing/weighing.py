"""Firing orders weighed by what they make of gas torque: of its sum, or of its twist.

Alike cylinders give the same order k of gas torque, each from its firing angle theta_j. With the
amplitude a_j of a shape at each cylinder the sum is

    S_k = |sum over j of a_j exp(-i k theta_j)|

`torque`: a_j = 1, the torque of a rigid crankshaft, and the roll of the block, its reaction. For a
whole k it does not depend on the firing order at all, since a cylinder that fires a turn later has
the same exp(-i k theta_j): the crank decides. Half orders change their sign by it. Where an order
fires evenly they vanish, so that only orders that fire unevenly differ in torque.

`twist`: a_j goes from one end of the crankshaft to the other, evenly with the place z of the
cylinder about the middle of all, 1 at the farthest: the gas torque that turns the front of the
crankshaft, or of the block, against its rear. It is nearly the first torsional mode that has its
node in the middle, and differs between orders that fire evenly. Another shape of a mode is given
by its amplitudes.

Source: J. P. Den Hartog, Mechanical Vibrations, section 5.4, for the star diagrams of torsion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Literal

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.firing.intervals import Firing
from crankstar.firing.orders import Order
from crankstar.language.messages import MessageError
from crankstar.spectra import Real

Weight = Literal["torque", "roll", "twist"]
WEIGHTS: tuple[Weight, ...] = ("torque", "roll", "twist")
Shape = Mapping[int, float]
"""The amplitude of each chamber."""
NOTHING = 1e-9
"""Share of the sum of all amplitudes below which a sum is nought."""


class WeighingError(MessageError):
    """Firing orders that cannot be weighed, and why."""


@dataclass(frozen=True)
class Weighed:
    """Firing orders, least first, with their sums.

    `sums` [order of firing][crank order], `whole` [order of firing] the root of the sum of squares,
    all of `crank_orders`; in N m where `sizes` are those of a cylinder, else in the order of one.
    """

    orders: tuple[Order, ...]
    crank_orders: tuple[float, ...]
    sums: tuple[tuple[float, ...], ...]
    whole: tuple[float, ...]


def even_shape(engine: Engine) -> Shape:
    """The amplitude 1 of every chamber: a rigid crankshaft."""
    return dict.fromkeys(engine.chambers, 1.0)


def twist_shape(engine: Engine) -> Shape:
    """Amplitudes that go evenly with the place along the crankshaft, 1 at the farthest.

    Raises WeighingError where all chambers stand at one place.

    >>> from crankstar.files.catalog import load
    >>> [round(each, 3) for each in twist_shape(load("i4")).values()]
    [1.0, 0.333, -0.333, -1.0]
    """
    places = {
        number: sum(piston.z for piston in pistons) / len(pistons)
        for number, pistons in engine.chambers.items()
    }
    middle = sum(places.values()) / len(places)
    farthest = max(abs(place - middle) for place in places.values())
    if not farthest:
        raise WeighingError(
            "all cylinders stand at one place along the crankshaft, so that nothing twists it; "
            "weigh the torque"
        )
    return {number: (place - middle) / farthest for number, place in places.items()}


def vector_sums(
    shape: Sequence[float] | Real, phases: Real, orders: Sequence[float] | Real
) -> Real:
    """|sum a_j exp(i k phi_j)| [order], `shape` [cylinder] the a_j, `phases` the phi_j.

    A six, straight and in a mode with one node: order 3, in which all cylinders push together,
    does nothing to a mode whose halves turn against each other, and order 4.5 does.

    >>> fires = np.radians([0, 480, 240, 600, 120, 360])
    >>> mode = np.cos(np.pi * (np.arange(6) + 0.5) / 6)
    >>> vector_sums(np.ones(6), fires, [3, 4.5]).round(3).tolist()
    [6.0, 0.0]
    >>> vector_sums(mode, fires, [3, 4.5]).round(3).tolist()
    [0.0, 3.864]
    """
    waves = np.exp(1j * np.multiply.outer(np.asarray(orders, float), phases))
    shares = np.asarray(shape, float)
    sums = np.abs(waves @ shares)
    return np.where(sums > NOTHING * np.abs(shares).sum(), sums, 0.0)


def sums_of(firing: Firing, shape: Shape, crank_orders: Sequence[float]) -> list[float]:
    """S_k of a firing order, for each crank order.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.firing.intervals import firing
    >>> twin = load("i2-270")
    >>> [round(each, 4) for each in sums_of(firing(twin), even_shape(twin), (0.5, 1, 2))]
    [0.7654, 1.4142, 0.0]
    """
    amplitudes = [shape[number] for number in firing.order]
    return vector_sums(amplitudes, np.radians(firing.angles_deg), crank_orders).tolist()


def weighed(
    orders: Sequence[Order],
    shape: Shape,
    crank_orders: Sequence[float],
    sizes: Sequence[float] | None = None,
) -> Weighed:
    """Firing orders by the sum of these crank orders, least first; equal ones as they were.

    `sizes` [crank order] is the amplitude of one cylinder in each of them, N m; 1 without.
    """
    factors = [1.0] * len(crank_orders) if sizes is None else sizes
    rows = [
        tuple(
            size * each
            for size, each in zip(factors, sums_of(order.firing, shape, crank_orders), strict=True)
        )
        for order in orders
    ]
    whole = [sqrt(sum(each**2 for each in row)) for row in rows]
    scale = max(whole, default=0.0) or 1.0
    best = sorted(range(len(rows)), key=lambda place: round(whole[place] / scale, 9))
    return Weighed(
        tuple(orders[place] for place in best),
        tuple(crank_orders),
        tuple(rows[place] for place in best),
        tuple(whole[place] for place in best),
    )
