"""A derivation as data: steps in sentences, each with formulas that can be evaluated."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal

from crankstar.derive.algebra.formula import Formula, Power, Symbol, product
from crankstar.language.messages import N_, MessageError, _

Quantity = Literal["force", "couple", "torque"]
Kind = Literal["signal", "forward", "backward", "torque", "roll", "series", "plain"]
Series = tuple[tuple[int, Fraction], ...]

GREATEST_ORDER = 24


class DerivationError(MessageError):
    """A derivation that cannot be given, as one sentence that says what can."""


@dataclass(frozen=True)
class Line:
    """Formulas that are equal: `name = chain[0] = chain[1] = ...`.

    A `signal` is the component along `bearing_deg` (degrees clockwise from up) of what the rows
    `rows` of a Balance push, at crank angle theta; `forward` and `backward` are vectors. Both are
    counted in the unit of the derivation. A `torque` is that of the rows, a `roll` their rolling
    moment. A `series` is an approximation, the powers of lambda up to a chosen one: `series` holds
    these powers with their coefficients. A `plain` line is a definition, or a number of the real
    engine. `arm` is the arm of what the line is about, shown with its label.
    """

    name: Formula | None
    chain: tuple[Formula, ...]
    kind: Kind = "plain"
    rows: tuple[int, ...] = ()
    bearing_deg: float = 0.0
    label: str = ""
    note: str = ""
    arm: Formula | None = None
    series: Series = ()


@dataclass(frozen=True)
class Step:
    """One step: its title, what is done in sentences, and the formulas."""

    title: str
    words: tuple[str, ...]
    lines: tuple[Line, ...] = ()


@dataclass(frozen=True)
class Readable:
    """Steps under a title.

    Counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None. `symbols` has the
    values of the letters that have one for this engine (lengths in bore pitches, harmonics),
    `meanings` says what letters are in this engine.
    """

    engine: str
    title: str
    harmonic: int | None
    symbols: dict[str, float]
    steps: tuple[Step, ...]
    meanings: dict[str, str] = field(default_factory=dict)


def unit_symbol(harmonic: int | None) -> Symbol:
    """The letter for m r w^2 A_j, which each notation writes in its own way."""
    return Symbol("C", "" if harmonic is None else str(harmonic))


def unit_formula(harmonic: int | None) -> Formula:
    """In letters: m r w^2 A_k."""
    factors: list[Formula] = [Symbol("m"), Symbol("r"), Power(Symbol("omega"), 2)]
    if harmonic is not None and harmonic > 1:
        factors.append(Symbol("A", str(harmonic)))
    return product(*factors)


def heading(order: Fraction, quantity: Quantity) -> str:
    """The title of an order of a quantity.

    >>> heading(Fraction(2), "force"), heading(Fraction(1, 2), "couple")
    ('Secondary force', 'Couple of order 1/2')
    """
    of_order, *named = HEADINGS[quantity]
    if order.denominator == 1 and order <= len(named):
        return _(named[int(order) - 1])
    return _(of_order, order=order)


HEADINGS: dict[Quantity, tuple[str, ...]] = {
    "force": (N_("Force of order {order}"), N_("Primary force"), N_("Secondary force")),
    "couple": (N_("Couple of order {order}"), N_("Primary couple"), N_("Secondary couple")),
    "torque": (N_("Inertia torque of order {order}"),),
}
"""The titles of each quantity: of any order, and of the orders that have names."""
