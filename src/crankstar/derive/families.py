"""Families of engines: closed forms in which a dimension stays a letter.

* `alpha`: any V engine whose two banks share their crank pins, half the bank angle left open.
* `phi`: a twin with parallel cylinders, its second crank phi behind the first.
* `n`: n cylinders in line on evenly spaced cranks: n cos(k theta) where n divides k, else nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import pi

from crankstar.derive.algebra import cyclotomic, rational, wave
from crankstar.derive.algebra.formula import (
    NOUGHT,
    THETA,
    Applied,
    Formula,
    Pi,
    Ratio,
    Symbol,
    angle,
    cosine,
    number,
    product,
    summed,
)
from crankstar.derive.bodies import alike
from crankstar.derive.chapters import Chapter
from crankstar.derive.positions import arms
from crankstar.derive.records import (
    GREATEST_ORDER,
    DerivationError,
    Line,
    Quantity,
    Step,
    heading,
    unit_formula,
    unit_symbol,
)
from crankstar.derive.vee_family import vee
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.quoting import given

PHI, COUNT = Symbol("phi"), Symbol("n")


def family(engine: Engine, order: float | Fraction, quantity: Quantity, *, symbol: str) -> Chapter:
    """The closed form of one order for all engines that differ from this one in one dimension only.

    `symbol` is `alpha`, `phi` or `n`. Raises DerivationError where the engine has no such
    dimension.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.derive.algebra.typeset import text
    >>> up = family(load("v2-90"), 1, "force", symbol="alpha").steps[-1].lines[0]
    >>> text(up.chain[-1])
    '2 cos² α cos(θ − α)'
    """
    if symbol not in tuple(FAMILIES):
        raise DerivationError(
            _(
                "{symbol} cannot be kept as a symbol; choose from {symbols}.",
                symbol=given(symbol),
                symbols=", ".join(FAMILIES),
            )
        )
    if isinstance(order, bool) or order not in range(1, GREATEST_ORDER + 1):
        raise DerivationError(
            _(
                "The order is {order}; a family has whole orders from 1 to {greatest}.",
                order=repr(order),
                greatest=GREATEST_ORDER,
            )
        )
    if quantity not in ("force", "couple"):
        raise DerivationError(
            _(
                "The {quantity} has no symbolic form; use --quantity force, or leave --symbolic "
                "out.",
                quantity=quantity,
            )
        )
    alike(engine)
    title, subject, steps_of = FAMILIES[symbol]
    with cyclotomic.precision(cyclotomic.DIGITS):
        steps = steps_of(engine, int(order), quantity)
    return _chapter(engine, int(order), quantity, (_(title), _(subject)), steps)


def _chapter(
    engine: Engine, order: int, quantity: Quantity, named: tuple[str, str], steps: list[Step]
) -> Chapter:
    title, subject = named
    symbols = {symbol.name: float(value) for symbol, value in arms(engine).values.items()}
    if order > 1 and order % 2:
        words = _(
            "The pistons of a centred crank have no harmonic of order {order}: nothing remains, "
            "whatever the angles.",
            order=order,
        )
        steps = [Step(_("No such harmonic"), (words,))]
    counted = Line(unit_symbol(order), (unit_formula(order),), label=_("unit"))
    unit = _("Numbers are counted in the unit below; rotating masses are left out.")
    first = Step(_("The family"), (subject, unit), (counted,))
    whole = f"{heading(Fraction(order), quantity)}, {title}"
    return Chapter(engine.name, whole, order, symbols, (first, *steps))


def _twin(engine: Engine, order: int, quantity: Quantity) -> list[Step]:
    """Two parallel cylinders, the second crank phi behind: cos x + cos(x - k phi).

    The couple is their difference times half the pitch.
    """
    cylinders = engine.cylinders
    if (
        len(cylinders) != 2
        or len({c.throw for c in cylinders}) != 2
        or len({rational.turn(c.bearing) for c in cylinders}) != 1
    ):
        raise DerivationError(
            _(
                "phi is the angle between the cranks of two parallel cylinders on one shaft; this "
                "engine is not such a twin."
            )
        )
    behind = product(-order, PHI)
    half = Ratio(product(order, PHI), number(2)) if order % 2 else product(order // 2, PHI)
    inside, middle = product(order, THETA), product(-1, half)
    first, second = cosine(inside), cosine(summed(inside, behind))
    if quantity == "force":
        chain: tuple[Formula, ...] = (
            summed(first, second),
            product(2, cosine(half), cosine(summed(inside, middle))),
        )
    else:
        placed = arms(engine).cylinder
        arm, other = (wave.form(placed[place]) for place in sorted(placed))
        sines = Applied("sin", half), Applied("sin", summed(inside, middle))
        chain = (summed(product(arm, first), product(other, second)), product(-2, arm, *sines))
        if arm == other:
            chain = (NOUGHT,)
    letter, bearing = Symbol("F" if quantity == "force" else "M"), cylinders[0].bearing * 180 / pi
    along = Line(letter, chain, "signal", (), bearing, _("along the cylinders"))
    words = (
        "cos x + cos y = 2 cos((x − y)/2) cos((x + y)/2); "
        "cos x − cos y = −2 sin((x − y)/2) sin((x + y)/2)."
    )
    return [Step(_("The closed form"), (words,), (along,))]


def _row(engine: Engine, order: int, quantity: Quantity) -> list[Step]:
    """The n cylinders of a row on evenly spaced cranks."""
    turns = sorted(
        ((rational.turn(engine.throw(c).angle) or Fraction(0)) % 1) for c in engine.cylinders
    )
    count = len(turns)
    even = [(turn - turns[0]) % 1 for turn in turns] == [Fraction(i, count) for i in range(count)]
    if not even or len({rational.turn(c.bearing) for c in engine.cylinders}) != 1:
        raise DerivationError(
            _(
                "n is the number of cylinders in one row on evenly spaced cranks; this engine is "
                "not of that kind."
            )
        )
    if quantity == "couple":
        raise DerivationError(
            _(
                "The couple of n cylinders in a row depends on the numbering of the cranks; use "
                "--quantity force, or leave --symbolic out."
            )
        )
    part = Ratio(product(order, Pi()), COUNT)
    geometric = Ratio(Applied("sin", angle(Fraction(order, 2))), Applied("sin", part))
    words = (
        _(
            "The cranks stand at the n-th parts of a turn, so in order k the vectors stand k/n of "
            "a turn apart, whatever the numbering: a geometric series, with the sum n where n "
            "divides k and else sin(kπ)/sin(kπ/n) = 0."
        ),
        _(
            "Here k = {order}: of all rows only those with n = {divisors} have a force of this "
            "order.",
            order=order,
            divisors=", ".join(str(n) for n in range(1, order + 1) if order % n == 0),
        ),
    )
    whole = count if order % count == 0 else 0
    chain = (COUNT,) if whole else (geometric, NOUGHT)
    if whole:
        label = _("n = {count}: n divides {order}", count=count, order=order)
    else:
        label = _("n = {count}: n does not divide {order}", count=count, order=order)
    force = product(whole, _start(engine, order))
    bearing = engine.first.bearing * 180 / pi
    along = Line(Symbol("F"), (force,), "signal", (), bearing, _("along the cylinders"))
    return [Step(_("The closed form"), words, (Line(Symbol("S"), chain, label=label), along))]


def _start(engine: Engine, order: int) -> Formula:
    """The cosine of the first cylinder."""
    first = engine.first
    angles = engine.throw(first).angle, first.bearing
    crank, axis = (rational.turn(radians) or Fraction(0) for radians in angles)
    return cosine(summed(product(order, THETA), angle(engine.sense * order * (crank - axis))))


FAMILIES: dict[str, tuple[str, str, Callable[[Engine, int, Quantity], list[Step]]]] = {
    "alpha": (
        N_("V of bank angle 2α"),
        N_("V engines of bank angle 2α, their banks on common pins."),
        vee,
    ),
    "phi": (
        N_("twin whose second crank stands φ behind the first"),
        N_("Twins whose second crank stands φ behind the first."),
        _twin,
    ),
    "n": (
        N_("row of n cylinders on evenly spaced cranks"),
        N_("Rows of n cylinders on evenly spaced cranks."),
        _row,
    ),
}
"""The title, the subject and the steps of each family."""
