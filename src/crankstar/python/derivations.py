"""The derivation of an order in Python, with what its newtons rest on."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from crankstar.derive.steps import derivation as derived
from crankstar.options.sources import engine_named
from crankstar.tables.resting_derivations import with_record

if TYPE_CHECKING:
    from crankstar.derive.chapters import Derivation
    from crankstar.derive.steps import Quantity
    from crankstar.mechanics.excitation import Reference
    from crankstar.options.sources import EngineLike


def derivation(
    engine: EngineLike,
    order: float | Fraction,
    quantity: Quantity = "force",
    *,
    reference: Reference | None = None,
    speed: float | None = None,
    power: int = 7,
) -> Derivation:
    """The derivation of one order of the force or the couple of an engine, step by step.

    `order` is a crank order above 0 and up to 24; the couple is taken about the middle of the
    cylinders' span unless a `reference` is given; numbers in newtons are for `speed` (rad/s), else
    for the speed of the engine file, and end with what they rest on; the series of A_k goes to
    lambda**power. Raises DerivationError.

    >>> import crankstar
    >>> crankstar.derivation("v8-cross-plane", 2).zero
    True
    >>> last = crankstar.derivation("audi-25-tfsi", 1, "couple").steps[-1]
    >>> last.title, last.words[0].partition(":")[0]
    ('What it rests on', 'cylinder.rotating_mass')
    """
    own = engine_named(engine, "derivation")
    made = derived(own, order, quantity, reference=reference, speed=speed, power=power)
    about = {"quantity": quantity, "speed": speed, "reference": reference}
    return with_record(made, own, order=Fraction(order), **about)
