"""What every step of a derivation knows, and the lines they have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import radians

from crankstar.derive import positions
from crankstar.derive.addition import sum_as_product
from crankstar.derive.algebra import cyclotomic, enclosure, wave
from crankstar.derive.algebra.formula import Decimal, Formula, Symbol, number, product
from crankstar.derive.algebra.radicals import closed
from crankstar.derive.algebra.wave import Form, Wave, joined
from crankstar.derive.bodies import Bodies
from crankstar.derive.body import Body
from crankstar.derive.records import Line, Quantity
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.excitation import Reference


@dataclass(frozen=True)
class Task:
    """What all steps know: the engine, the order, its parts and their arms, and the sums.

    `bodies` are the parts with their pushes, `moving` the same for the quantity: times their arms
    for a couple.
    """

    engine: Engine
    order: Fraction
    quantity: Quantity
    bodies: Bodies
    moving: tuple[Body, ...]
    arms: positions.Arms
    reference: Reference | None
    speed: float | None
    power: int

    @property
    def letter(self) -> str:
        """F or M."""
        return "F" if self.quantity == "force" else "M"

    @cached_property
    def up(self) -> Wave:
        """The amplitude of the signal upwards."""
        return joined(body.up for body in self.moving)

    @cached_property
    def right(self) -> Wave:
        """The amplitude of the signal to the right."""
        return joined(body.right for body in self.moving)

    @cached_property
    def vectors(self) -> tuple[Wave, Wave]:
        """The vectors that turn with the crank and against it."""
        return wave.vectors(self.up, self.right, sense=self.engine.sense)

    @property
    def has_arms(self) -> bool:
        """Whether any part that pushes stands off the reference plane."""
        return any(arm_of(self.arms, body) for body in self.moving)


def arm_of(arms: positions.Arms, body: Body) -> Form:
    """How far in front of the reference plane a part stands."""
    if body.cylinder is not None:
        return arms.cylinder[body.cylinder]
    return (arms.weight if body.kind == "weight" else arms.throw)[body.shaft, body.place]


def rows(moving: Sequence[Body]) -> tuple[int, ...]:
    """The rows of a Balance that the parts account for.

    None where a row is shared with a part that is not among them.
    """
    shares = Counter((row, body.sharing) for body in moving for row in body.rows)
    if any(count < sharing for (_, sharing), count in shares.items()):
        return ()
    return tuple(row for row, _ in shares)


def degrees_text(value: float) -> str:
    """An angle in degrees as a reader sees it."""
    return f"{value:.6g}°".replace("-", "−")


def sides(
    task: Task,
    name: str,
    up: Wave,
    right: Wave,
    rows: tuple[int, ...],
    label: str,
    arm: Formula | None = None,
) -> list[Line]:
    """A push as its components up and to the right."""
    both = (
        (up, "up", 0.0, _("{part}, up", part=label)),
        (right, "right", 90.0, _("{part}, right", part=label)),
    )
    return [
        Line(
            Symbol(task.letter, f"{name}, {side}"),
            (wave.signal(own, task.order),),
            "signal",
            rows,
            bearing,
            labelled,
            arm=arm,
        )
        for own, side, bearing, labelled in both
    ]


def share(body: Body, *, up: bool) -> Formula:
    """The share of a push along a cylinder that goes up or right: cosine or sine of its bearing."""
    if body.bearing is None:
        return _decimal_share(body.bearing_deg, up=up)
    return closed((cyclotomic.cosine if up else cyclotomic.sine)(body.bearing)).formula


def _decimal_share(bearing_deg: float, *, up: bool) -> Formula:
    with cyclotomic.precision(cyclotomic.DIGITS):
        axis = enclosure.angle_of(radians(bearing_deg))
        return Decimal(axis.real if up else axis.imag)


def paired(parts: Sequence[tuple[Formula, Wave]], order: Fraction) -> list[Formula]:
    """Two signals of one size as a product of cosines, where that shows more than the sum."""
    pieces = [
        (factor, piece)
        for factor, own in parts
        for piece in wave.pieces(own)
        if factor != number(0)
    ]
    if len(pieces) != 2:
        return []
    first, second = (product(factor, piece.size) for factor, piece in pieces)
    p, q = (piece.phase for _, piece in pieces)
    if p is None or q is None:
        return []
    if first == product(-1, second):
        second, q = first, q + Fraction(1, 2)
    # Opposite signals simply cancel, and equal ones simply add.
    if first != second or (p - q) % Fraction(1, 2) == 0:
        return []
    return [sum_as_product(first, p, q, order)]
