"""The exhaust orders of an engine in closed form, and the proof of those that are zero.

The pulses of a group give order q the sum S_q of exp(-i q theta_j) over its firing angles theta_j.
Where every theta_j is a rational part of a turn, q theta_j is too, so S_q is a number of a
cyclotomic field: it is zero if and only if its reduced polynomial is, and |S_q| is the square root
of S_q times its conjugate, in radicals where they exist. No tolerance is used.

Source: as `firing.exhaust_orders` for the sums, and `algebra.cyclotomic` for their field.
"""

from __future__ import annotations

from fractions import Fraction
from math import radians
from typing import NamedTuple

from crankstar.derive.algebra import cyclotomic, radicals, rational, typeset
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.formula import Formula
from crankstar.derive.records import DerivationError
from crankstar.engine.engine import Engine
from crankstar.firing.exhaust_orders import USUAL_HIGHEST, checked
from crankstar.firing.strokes import ExhaustGroup, exhaust_groups
from crankstar.language.messages import _


class ExactOrder(NamedTuple):
    """One order of one group: `total` is S_q, `length` the closed form of |S_q| (pulses)."""

    group: ExhaustGroup
    order: Fraction
    total: Number
    length: Formula

    @property
    def zero(self) -> bool:
        """Whether there is nothing of this order: decided, not estimated."""
        return self.total.zero

    @property
    def text(self) -> str:
        """|S_q| as a reader sees it: `√(4 + 2√2)`."""
        return typeset.text(self.length)


def exact_exhaust_orders(
    engine: Engine, *, highest: float = USUAL_HIGHEST
) -> tuple[ExactOrder, ...]:
    """Every order up to `highest` of every exhaust group, exactly; of several also of the engine.

    Raises as `exhaust_orders`, and DerivationError where an angle of firing is no rational part of
    a turn (slave rods, offset cylinders).

    >>> from crankstar.files.catalog import load
    >>> bank = exact_exhaust_orders(load("v8-cross-plane"), highest=2.5)[:5]
    >>> [(str(each.order), each.text) for each in bank]
    [('1/2', '√(4 − 2√2)'), ('1', '0'), ('3/2', '√(4 + 2√2)'), ('2', '0'), ('5/2', '√(4 + 2√2)')]

    These are 2√2 sin 22.5 deg and 2√2 cos 22.5 deg.
    """
    fired = checked(engine, highest=highest)
    parts = {
        number: part_of_turn(number, angle)
        for number, angle in zip(fired.order, fired.angles_deg, strict=True)
    }
    groups = exhaust_groups(engine)
    if len(groups) > 1:
        groups = (*groups, ExhaustGroup(_("whole engine"), fired.order))
    step = Fraction(360) / Fraction(fired.cycle_deg).limit_denominator(1000)
    count = int(highest / step + Fraction(1, 10**9))
    return tuple(
        _order(group, step * index, parts) for group in groups for index in range(1, count + 1)
    )


def part_of_turn(number: int, angle_deg: float) -> Fraction:
    """The firing angle of a cylinder as a part of a turn. Raises DerivationError."""
    part = rational.turn(radians(angle_deg))
    if part is None:
        raise DerivationError(
            "cylinder {number} fires at {angle} deg, which is no rational part of a turn; closed "
            "forms need one, and the table of `crankstar strokes` has the numbers",
            number=number,
            angle=f"{angle_deg:.9g}",
        )
    return part


def _order(group: ExhaustGroup, order: Fraction, parts: dict[int, Fraction]) -> ExactOrder:
    total = cyclotomic.total(cyclotomic.root(-order * parts[number]) for number in group.chambers)
    return ExactOrder(group, order, total, radicals.length(total))
