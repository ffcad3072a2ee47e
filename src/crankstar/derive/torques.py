"""The inertia torque of a crankshaft with equal cylinders, order by order.

A piston of mass m gives the crankshaft minus the change of its kinetic energy with the crank angle,

    T = -d(m v^2/2)/dtheta = -m r^2 w^2 sum of B_k sin(k psi),     v = -r w sum of a_n sin(n psi),

a_n = A_n/n the harmonics of its velocity, psi the angle of the crank from top dead centre. So

    B_k = k/4 sum over i + j = k of a_i a_j - k/2 sum over n >= 1 of a_n a_(n + k).

For an odd k both sums are finite. Of A_n it is known that |A_n| <= sqrt(8) L n^2 q^n for rods of L
crank radii, q = L - sqrt(L^2 - 1): the travel of the piston is analytic where |sin psi| < L, and at
most sqrt(2) L there. This bounds the rest of the second sum. Rotating masses give no torque at
constant speed. Pistons that move towards the crank axis give the block no moment about it, so that
the rolling moment, clockwise, is -s T, s the sense of rotation.

Source: L. N. Trefethen and J. A. C. Weideman, The exponentially convergent trapezoidal rule, SIAM
Review 56 (2014), section 3, for the bound of the harmonics.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from crankstar.derive.addition import Term, addition, distinct, lag
from crankstar.derive.algebra import cyclotomic, enclosure, rational, wave
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.algebra.formula import (
    Applied,
    Decimal,
    Formula,
    Power,
    Symbol,
    angle,
    product,
    summed,
)
from crankstar.derive.banks import cylinder_label, turned
from crankstar.derive.bodies import alike, bodies
from crankstar.derive.chapters import Chapter
from crankstar.derive.real import exactly, series_line, size
from crankstar.derive.records import GREATEST_ORDER, DerivationError, Kind, Line, Step, heading
from crankstar.derive.steps import theta
from crankstar.derive.task import rows
from crankstar.engine.engine import Engine
from crankstar.engine.motion import series_coefficient
from crankstar.language.messages import _, passage
from crankstar.mechanics.balance import unit_unbalance

SHOWN = 3
"""Products of harmonics that are written of an endless sum."""
GREATEST_HARMONIC = 2000


def inertia_torque(
    engine: Engine, order: int | Fraction, *, speed: float | None = None, power: int = 7
) -> Chapter:
    """The inertia torque of one order of an engine, from one cylinder to the rolling moment.

    The engine has one crankshaft with equal cylinders in line with it, and rods without mass of
    their own; `order` is a whole number from 1 to 24. Counted in m r^2 w^2 B_k; newton metres are
    for `speed` (rad/s), else for the speed of the engine file; the series of B_k goes to
    lambda**power. Raises DerivationError.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.derive.algebra.typeset import text
    >>> sums = inertia_torque(load("i4"), 2).steps[2].lines
    >>> [text(line.chain[-1]) for line in sums]  # the torque, and the rolling moment
    ['−4 sin 2θ', '4 sin 2θ']
    """
    alike(engine)
    if isinstance(order, bool) or order not in range(1, GREATEST_ORDER + 1):
        raise DerivationError(
            _(
                "The order is {order}; the inertia torque has whole orders from 1 to {greatest}.",
                order=order,
                greatest=GREATEST_ORDER,
            )
        )
    k, parts = int(order), bodies(engine, Fraction(1))
    pistons = [body for body in parts.moving if not body.turning]
    with cyclotomic.precision(cyclotomic.DIGITS):
        lines: list[Line] = []
        terms: list[Term] = []
        for body in pistons:
            if body.lag is None or body.dead_centre is None or body.cylinder is None:
                raise TypeError("an exact derivation has exact phases")
            inside = wave.phased(Fraction(k), angle(lag(k * body.lag)))
            forms = [turned(Fraction(k), body.dead_centre)] if body.dead_centre else []
            chain = distinct(product(-1, Applied("sin", form)) for form in [*forms, inside])
            label, name = cylinder_label(engine, body), Symbol("T", str(body.cylinder))
            lines.append(Line(name, chain, "torque", rows([body]), label=label))
            terms.append(Term(body.cylinder, {(): Fraction(-1)}, k * body.lag))
        sums = addition(terms, Fraction(k), moments=True, function="sin")
        note, every = passage(sums.notes), rows(pistons)
        total = [Line(Symbol("T"), sums.chain, "torque", every, label=_("torque"), note=note)]
        if len(engine.shafts) == 1:
            roll = product(-engine.sense, sums.chain[-1])
            label = _("rolling moment on the block")
            total.append(Line(Symbol("R"), (roll,), "roll", every, label=label))
        steps = (
            _law(k),
            Step(_("Every cylinder"), (), tuple(lines)),
            _sum(total, zero=not sums.wave),
            _real(engine, k, total, sums.wave, speed=speed, power=power),
        )
    title = heading(Fraction(k), "torque")
    return Chapter(engine.name, title, None, {}, steps, theta(engine, parts.moving))


def _law(k: int) -> Step:
    """The torque of one piston, and the unit of what follows."""
    psi = Symbol("psi")
    waves = (product(Symbol("B", str(n)), Applied("sin", product(n, psi))) for n in (1, 2, 3, 4))
    unit = product(Symbol("m"), Power(Symbol("r"), 2), Power(Symbol("omega"), 2))
    lines = (
        Line(Symbol("T"), (product(-1, unit, summed(*waves, Symbol("…"))),), label=_("law")),
        Line(Symbol("D", str(k)), (product(unit, Symbol("B", str(k))),), label=_("unit")),
    )
    words = (
        _(
            "A piston exerts the torque T on the crankshaft, positive in the direction of "
            "rotation: minus the derivative of its kinetic energy with respect to the crank "
            "angle. ψ is the angle of the crank from top dead centre. Rotating masses exert no "
            "torque at constant speed."
        ),
        _(
            "The following lines are of order {order}, counted in the unit {unit}; θ is the crank "
            "angle.",
            order=k,
            unit=f"m r² ω² B_{k}",
        ),
    )
    return Step(_("One cylinder"), words, lines)


def _sum(total: list[Line], *, zero: bool) -> Step:
    """The torque of all cylinders, and what the block feels."""
    words = [
        _("There is no inertia torque of this order: the sum is exactly zero.")
        if zero
        else _("All cylinders act on one crankshaft, so their torques simply add.")
    ]
    if len(total) > 1 and not zero:
        words.append(
            _(
                "The flywheel takes this torque, and the block feels its reaction: the rolling "
                "moment, positive clockwise, seen from the front."
            )
        )
    return Step(_("All cylinders"), tuple(words), tuple(total))


def _real(
    engine: Engine, k: int, total: list[Line], whole: wave.Wave, *, speed: float | None, power: int
) -> Step:
    """The torque in letters, its harmonic, and newton metres where the file gives enough."""
    title = _("The real engine")
    if not whole:
        return Step(title, (_("Nothing of this order remains, at any speed."),))
    (amount,) = whole.values()
    first, symbol = engine.first, Symbol("B", str(k))
    radius = engine.throw(first).radius
    ratio = rational.ratio(first.rod_length / radius)
    ball = torque_harmonic(ratio, k)
    largest = value(wave.length(amount)) * abs(float(ball.mid())) * unit_unbalance(engine) * radius
    kind: Kind = "plain"
    lines = [
        Line(line.name, (product(Symbol("D", str(k)), line.chain[-1]),), kind, label=line.label)
        for line in total
    ]
    lines.append(Line(symbol, (in_harmonics(k),), label=_("by the harmonics of the acceleration")))
    lines.append(series_line(symbol, [(n, _coefficient(k, n)) for n in range(power + 1)]))
    lines.append(Line(symbol, (Decimal(ball, 12),), label=exactly(engine, ratio)))
    words = size(engine, "torque", engine.speed if speed is None else speed, largest)
    return Step(title, (words,), tuple(lines))


def in_harmonics(order: int) -> Formula:
    """B_k by the A_n: products of two, A_1 = 1 left out; endless for an even k.

    >>> from crankstar.derive.algebra.typeset import text
    >>> text(in_harmonics(1)), text(in_harmonics(3))
    ('−0.25 A₂', '0.75 A₂ − 0.375 A₄')
    """
    k = Fraction(order)
    terms = [
        product(k / 4 * (1 if i == order - i else 2) / (i * (order - i)), _pair(i, order - i))
        for i in range(1, order // 2 + 1)
        if _there(i) and _there(order - i)
    ]
    endless = [
        product(-k / 2 / (n * (n + order)), _pair(n, n + order))
        for n in range(1, 2 * SHOWN)
        if _there(n) and _there(n + order)
    ]
    return summed(*terms, *endless, *([] if order % 2 else [Symbol("…")]))


def _there(n: int) -> bool:
    """Whether the pistons of a centred crank have this harmonic."""
    return n == 1 or n % 2 == 0


def _pair(i: int, j: int) -> Formula:
    """The product of two harmonics, A_1 being 1."""
    if i == j and i > 1:
        return Power(Symbol("A", str(i)), 2)
    return product(1, *(Symbol("A", str(n)) for n in (i, j) if n > 1))


def _coefficient(order: int, power: int) -> Fraction:
    """The factor of lambda**power in B_k."""

    def both(i: int, j: int) -> Fraction:
        powers = range(power + 1)
        halves = ((series_coefficient(i, p), series_coefficient(j, power - p)) for p in powers)
        return sum((a * b for a, b in halves), Fraction(0)) / (i * j)

    finite = sum((both(i, order - i) for i in range(1, order)), Fraction(0))
    endless = sum((both(n, n + order) for n in range(1, power + 2)), Fraction(0))
    return Fraction(order, 4) * finite - Fraction(order, 2) * endless


def torque_harmonic(rod_ratio: Fraction, order: int) -> arb:
    """B_k of a centred crank as a ball, rod_ratio = l/r > 1.

    Raises DerivationError where the rods come too near to locking.

    >>> print(torque_harmonic(Fraction(4), 1).str(12, radius=False))
    -0.0635062605767
    """
    with cyclotomic.precision(cyclotomic.DIGITS):
        length = enclosure.arb_of(rod_ratio)
        q = length - (length**2 - 1).sqrt()

        def both(i: int, j: int) -> arb:
            of_both = (enclosure.coefficient(rod_ratio, n) / n for n in (i, j))
            return next(of_both) * next(of_both)

        total = sum((both(i, order - i) for i in range(1, order)), arb(0)) * order / 4
        total -= both(1, 1 + order) * order / 2
        for n in range(2, GREATEST_HARMONIC, 2) if order % 2 == 0 else ():
            total -= both(n, n + order) * order / 2
            near, far = n + 2, n + 2 + order
            share = (1 + arb(2) / near) ** 2 * q**4
            rest = 4 * order * length**2 * near * far * q ** (near + far)
            if share < 1 and rest / (1 - share) < arb(10) ** -cyclotomic.DIGITS:
                return total + arb(0, float((rest / (1 - share)).upper()))
        if order % 2:
            return total
    raise DerivationError(
        _("The inertia torque cannot be enclosed: the rods come too near to locking.")
    )
