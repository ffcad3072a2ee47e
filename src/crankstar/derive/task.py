"""What every step of a derivation knows, and the lines they have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import radians

from crankstar.derive import positions
from crankstar.derive.addition import distinct, sum_as_product
from crankstar.derive.algebra import cyclotomic, enclosure, wave
from crankstar.derive.algebra.formula import Decimal, Formula, Symbol, number, product, summed
from crankstar.derive.algebra.radicals import closed
from crankstar.derive.algebra.wave import Form, Wave
from crankstar.derive.bodies import Bodies, Body, Push, pushed
from crankstar.derive.records import Line, Quantity
from crankstar.engine.engine import Engine
from crankstar.language.messages import _


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
    speed: float | None
    power: int

    @property
    def letter(self) -> str:
        """F or M."""
        return "F" if self.quantity == "force" else "M"

    @cached_property
    def push(self) -> Push:
        """The amplitudes of the whole engine upwards and to the right."""
        return pushed(self.moving)

    @cached_property
    def vectors(self) -> tuple[Wave, Wave]:
        """The vectors that turn with the crank and against it."""
        return wave.vectors(*self.push, sense=self.engine.sense)

    def arm(self, body: Body) -> Formula | None:
        """The arm of a part in a couple."""
        return wave.form(arm_of(self.arms, body)) if self.quantity == "couple" else None


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
    members: Sequence[Body],
    part: str = "",
    *,
    arm: Formula | None = None,
    before: Callable[[int], Iterable[Formula]] = lambda _side: (),
) -> list[Line]:
    """The push of parts up and to the right; `before` are formulas equal to side 0 and side 1."""
    labels = _("up"), _("right")
    if part:
        labels = _("{part}, up", part=part), _("{part}, right", part=part)
    lines: list[Line] = []
    for side, whole in enumerate(pushed(members)):
        below = ", ".join(filter(None, (name, ("up", "right")[side])))
        lines.append(
            Line(
                Symbol(task.letter, below),
                distinct([*before(side), wave.signal(whole, task.order)]),
                "signal",
                rows(members),
                90.0 * side,
                labels[side],
                arm=arm,
            )
        )
    return lines


def resolved(task: Task, parts: Sequence[tuple[Body, Wave]], side: int) -> list[Formula]:
    """Pushes along the cylinders of bodies, resolved into up (0) or right (1), and added."""
    shares = [(_share(body, side), along) for body, along in parts]
    signals = (product(factor, wave.signal(along, task.order)) for factor, along in shares)
    return [summed(*signals), *_paired(shares, task.order)]


def _share(body: Body, side: int) -> Formula:
    """The share of a push along a cylinder that goes up or right: cosine or sine of its bearing."""
    if body.bearing is not None:
        return closed((cyclotomic.cosine, cyclotomic.sine)[side](body.bearing))
    with cyclotomic.precision(cyclotomic.DIGITS):
        axis = enclosure.angle_of(radians(body.bearing_deg))
        return Decimal((axis.real, axis.imag)[side])


def _paired(parts: Sequence[tuple[Formula, Wave]], order: Fraction) -> list[Formula]:
    """Two signals of one size as a product of cosines, where that shows more than the sum."""
    pieces = [
        (product(factor, piece.size), piece.phase)
        for factor, along in parts
        for piece in wave.pieces(along)
        if factor != number(0)
    ]
    if len(pieces) != 2:
        return []
    (first, p), (second, q) = pieces
    if p is None or q is None:
        return []
    if first == product(-1, second):
        second, q = first, q + Fraction(1, 2)
    # Opposite signals simply cancel, and equal ones simply add.
    if first != second or (p - q) % Fraction(1, 2) == 0:
        return []
    return [sum_as_product(first, p, q, order)]
