"""Objectives of a star: vector sums over its cylinders, and neighbours in succession.

A vector sum of order k is

    V = scale * sum over cylinders j of w_j exp(i 2 pi t(d_j)),

d_j the direction of cylinder j. With w = 1 and t = k d/n it is F_k, the sum of the unit forces of
order k; with w_j = z_j, the distance from the middle, it is M_k, that of their couples; with w_j
the amplitude of cylinder j in a torsional mode shape and t = k (firing angle)/360 deg it tells how
strongly gas torque of order k (halves for a four-stroke engine) drives that mode. The weights and
turns are rational, so that a sum is a number of a cyclotomic field: whether it is zero is decided,
not estimated.

Source: C. F. Taylor, The Internal Combustion Engine in Theory and Practice, vol. 2, chapter 8, for
F_k and M_k; J. P. Den Hartog, Mechanical Vibrations, section 5.4 (star diagrams of torsional
vibration).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

import numpy as np

from crankstar.derive.algebra import cyclotomic
from crankstar.spectra import ROUNDING
from crankstar.stars.faults import error
from crankstar.stars.star import Star, Stars

Side = Literal["", "V", "H"]
"""What of a vector counts: its greatest value over a turn, or what acts up or to the right."""
SAME = 1e-9
"""Lengths nearer than this, in the unit of the weights, are equal; rounding is below 1e-13.

Zeros are proved separately.
"""


@dataclass(frozen=True)
class VectorSum:
    """scale * sum of w_j exp(i 2 pi t(d_j)): weights by cylinder, parts of a turn by direction.

    parts: of an engine whose sum of all parts is not of this form, the two vectors of the parts
    that stay, then of each cylinder; the first turns by +t(d_j) - t(d_1), the second by its
    negative. Their sum is `of_engine`, of which `side` counts.
    """

    name: str
    order: Fraction
    weights: tuple[Fraction, ...]
    turns: tuple[Fraction, ...]
    scale: float = 1.0
    unit: str = ""
    parts: tuple[tuple[complex, complex], ...] = ()
    side: Side = ""

    @property
    def short(self) -> str:
        """The name without what is left out: F, M or T with its order."""
        return self.name.partition(" ")[0]

    def exact(self, star: Star) -> cyclotomic.Number:
        """The sum for a star without its scale, exactly."""
        total = cyclotomic.rational(0)
        for weight, direction in zip(self.weights, star, strict=True):
            total = total + cyclotomic.root(self.turns[direction]).times(weight)
        return total

    def length(self, star: Star) -> float:
        """How long the sum is for a star, exact zeros as zero."""
        exact = self.exact(star)
        return 0.0 if exact.zero else self.scale * abs(complex(exact))

    def of_engine(self, star: Star, later_deg: Sequence[float] | None = None) -> float:
        """The largest value over a turn of all parts of an engine; see `engine_stars`.

        `later_deg`: by how many degrees each cylinder comes later than the star says.
        """
        if not self.parts:
            return self.length(star)
        later = later_deg or (0.0,) * len(star)
        turns = [
            float(self.turns[direction]) + float(self.order) * angle / 360
            for direction, angle in zip(star, later, strict=True)
        ]
        vectors = np.array(self.parts)
        angles = 2 * np.pi * np.array([0.0, *(turn - turns[0] for turn in turns)])
        sums = (vectors * np.exp(np.outer(angles, [1j, -1j]))).sum(axis=0)
        size = float(sizes(sums, self.side))
        return size if size > ROUNDING * np.abs(vectors).sum() else 0.0


@dataclass(frozen=True)
class Objective:
    """The root of the sum of squares of some weighted vector sums, to be minimised.

    neighbours: what each pair of neighbours that fire in succession adds; 1 without terms is their
    number.
    """

    name: str
    terms: tuple[tuple[float, VectorSum], ...] = ()
    neighbours: float = 0.0
    unit: str = ""


@dataclass(frozen=True)
class Limit:
    """A vector sum with a greatest length (0: it vanishes, which is proved) and a least one."""

    sum: VectorSum
    greatest: float
    least: float = 0.0


def sizes(vectors: np.ndarray, side: Side = "") -> np.ndarray:
    """The greatest value over a turn of two vectors [..., 2] that turn against each other.

    That is |f| + |b|; of what acts up (V) |f + conj(b)|, and to the right (H) |f - conj(b)|.

    >>> [float(sizes(np.array([0.75, 0.25]), side)) for side in ("", "V", "H")]
    [1.0, 1.0, 0.5]
    """
    one, other = vectors[..., 0], vectors[..., 1].conj()
    if side:
        return np.abs(one + other if side == "V" else one - other)
    return np.abs(one) + np.abs(other)


def force(stars: Stars, order: int) -> VectorSum:
    """F_k, the sum of the unit forces of an order."""
    alike = (Fraction(1),) * stars.cylinders
    return VectorSum(f"F{order}", Fraction(order), alike, _turns(stars, order), unit=_unit(order))


def couple(stars: Stars, order: int) -> VectorSum:
    """M_k, the sum of the couples of unit forces of an order about the middle.

    >>> seven = Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7)))
    >>> round(couple(seven, 1).length((0, 1, 2, 3, 4, 5, 6)), 4)
    8.0667
    """
    unit = f"{_unit(order)}*a"
    return VectorSum(f"M{order}", Fraction(order), stars.positions, _turns(stars, order), unit=unit)


def torsion(stars: Stars, *, order: Fraction, shape: Sequence[Fraction]) -> VectorSum:
    """T_k, the sum of a torsional mode's amplitudes, each turned by order times firing angle.

    order: per turn, a multiple of 1/2 in a four-stroke engine; shape: amplitude at each cylinder
    from the front. Raises SearchError where the star does not determine the firing order
    (four-stroke, even number) and the order is not whole.
    """
    if len(shape) != stars.cylinders:
        raise error("mode_shape", "shape-count", given=len(shape), cylinders=stars.cylinders)
    check_torsion(stars, order)
    angles = stars.firing_deg() or stars.angles_deg
    turns = tuple(order * angle / 360 % 1 for angle in angles)
    return VectorSum(f"T{float(order):g}", order, tuple(shape), turns)


def twisting(stars: Stars, order: Fraction) -> VectorSum:
    """X_k, the sum of the couples of guide forces of an order with their arms along the engine.

    In units of the couple of one cylinder, times a pitch, over the rod length. Raises SearchError
    where the star does not determine the firing order and the order is not whole.

    >>> seven = Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7)))
    >>> star = (0, 2, 5, 4, 3, 6, 1)  # 1-7-2-5-4-3-6
    >>> [round(twisting(seven, Fraction(k)).length(star), 4) for k in (1, 3, 7)]  # 1, 3: as M1, M3
    [0.2673, 9.8447, 0.0]
    """
    name = f"X{float(order):g}"
    if stars.cycle == "two-stroke" and order.denominator != 1:
        raise error("", "two-stroke-x", name=name)
    if stars.step == 0 and order.denominator != 1:
        raise error("", "half-x", name=name)
    angles = stars.firing_deg() or stars.angles_deg
    turns = tuple(order * angle / 360 % 1 for angle in angles)
    return VectorSum(name, order, stars.positions, turns)


def check_torsion(stars: Stars, order: Fraction) -> None:
    """Raises SearchError where an order of torsion does not exist, or the star leaves it open."""
    if stars.cycle == "two-stroke" and order.denominator != 1:
        raise error("", "two-stroke-torsion", name=f"T{float(order):g}")
    if stars.step == 0 and order.denominator != 1:
        raise error("", "half-torsion", name=f"T{float(order):g}")


def _unit(order: int) -> str:
    """The unit of a force whose harmonic A_k is not known; A_1 is 1."""
    return "m*r*w^2" if order == 1 else f"m*r*w^2*A_{order}"


def _turns(stars: Stars, order: int) -> tuple[Fraction, ...]:
    return tuple(order * angle / 360 % 1 for angle in stars.angles_deg)


def neighbours() -> Objective:
    """The number of neighbours in succession; where two share each direction, in the best order."""
    return Objective("neighbours", neighbours=1.0)


def of(vector: VectorSum) -> Objective:
    """A vector sum as an objective."""
    return Objective(vector.name, ((1.0, vector),), unit=vector.unit)
