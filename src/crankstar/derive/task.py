"""What every step of a derivation knows, and the lines they have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import radians

from crankstar.derive import cyclotomic, enclosure, positions, wave
from crankstar.derive.bodies import Bodies, Body
from crankstar.derive.formula import Decimal, Formula, Symbol, number, product
from crankstar.derive.gather import sum_as_product
from crankstar.derive.radical import closed
from crankstar.derive.records import Line, Quantity
from crankstar.derive.wave import Form, Wave, joined
from crankstar.engine import Engine
from crankstar.mechanism import Reference


@dataclass(frozen=True)
class Task:
    """What all steps know: the engine, the order, the parts with their arms, what is asked, and the sums."""

    engine: Engine
    order: Fraction
    quantity: Quantity
    found: Bodies
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
    number = body.crank_end_of if body.cylinder is None else body.cylinder
    if number is not None:
        return arms.cylinder[number]
    return (arms.weight if body.name.startswith("weight") else arms.throw)[body.shaft, body.place]


def rows(moving: Sequence[Body]) -> tuple[int, ...]:
    """The rows of a Balance that the parts account for; none where a row is shared with a part that is not among them."""
    found = Counter((row, body.sharing) for body in moving for row in body.rows)
    if any(count < sharing for (_, sharing), count in found.items()):
        return ()
    return tuple(row for row, _ in found)


def degrees_text(value: float) -> str:
    """An angle in degrees as a reader sees it."""
    return f"{value:.6g}°".replace("-", "−")


def sides(
    task: Task, name: str, up: Wave, right: Wave, rows: tuple[int, ...], label: str, arm: Formula | None = None
) -> list[Line]:
    """A push as its parts up and to the right."""
    both = ((up, "up", 0.0), (right, "right", 90.0))
    return [
        Line(
            Symbol(task.letter, f"{name}, {side}"),
            (wave.signal(own, task.order),),
            "signal",
            rows,
            bearing,
            f"{label}, {side}",
            arm=arm,
        )
        for own, side, bearing in both
    ]


def share(body: Body, *, up: bool) -> Formula:
    """What part of a push along a cylinder goes up, or to the right: the cosine or the sine of its bearing."""
    if body.bearing is None:
        return _decimal_share(body.bearing_deg, up=up)
    return closed((cyclotomic.cosine if up else cyclotomic.sine)(body.bearing)).formula


def _decimal_share(bearing_deg: float, *, up: bool) -> Formula:
    with cyclotomic.precision(cyclotomic.DIGITS):
        axis = enclosure.angle_of(radians(bearing_deg))
        return Decimal(axis.real if up else axis.imag)


def paired(parts: Sequence[tuple[Formula, Wave]], order: Fraction) -> list[Formula]:
    """Two signals of one size as a product of cosines, where that shows more than the sum."""
    pieces = [(factor, piece) for factor, own in parts for piece in wave.pieces(own) if factor != number(0)]
    if len(pieces) != 2:
        return []
    sizes = [product(factor, piece.size) for factor, piece in pieces]
    phases = [piece.phase for _, piece in pieces]
    if phases[0] is None or phases[1] is None:
        return []
    first, second = sizes
    p, q = phases[0], phases[1]
    if first == product(-1, second):
        second, q = first, q + Fraction(1, 2)
    # Opposite signals simply cancel, and equal ones simply add.
    return [sum_as_product(first, p, q, order)] if first == second and (p - q) % Fraction(1, 2) != 0 else []
