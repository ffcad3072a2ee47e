"""The harmonics A_k of a piston before any engine: from the crank drive to A_2, A_4, A_6.

A piston on a centred crank with a plain rod stands at

    x = r cos psi + sqrt(l^2 - r^2 sin^2 psi) = r (cos psi + sqrt(1 - lambda^2 sin^2 psi)/lambda)

above the crank axis, psi the crank angle from top dead centre, lambda = r/l. The root is a binomial
series in u = lambda^2 sin^2 psi; each power of the sine is a sum of cosines; collected by cosine
they give x = r (cos psi + sum of x_k cos k psi), and twice differentiated A_k = k^2 x_k, since the
force on the block is -m x'' = m r w^2 (cos psi + sum of A_k cos k psi). All coefficients are exact
fractions: the root of a power series and powers of a polynomial, by python-flint. The same A_k is
the integral

    A_k = 2 k^2/(pi lambda) integral from 0 to pi of sqrt(1 - lambda^2 sin^2 psi) cos k psi dpsi.

Source: any textbook on balancing; the errata list those that misprint it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from math import lcm

from flint import ctx, fmpq_poly, fmpq_series

from crankstar.derive.algebra import cyclotomic, enclosure, rational
from crankstar.derive.algebra.formula import (
    Applied,
    Decimal,
    Formula,
    Integral,
    Pi,
    Power,
    Ratio,
    Root,
    Sum,
    Symbol,
    cosine,
    number,
    product,
    summed,
)
from crankstar.derive.chapters import Chapter
from crankstar.derive.real import exactly, series, series_line
from crankstar.derive.records import GREATEST_ORDER, DerivationError, Line, Series, Step
from crankstar.engine.engine import Engine
from crankstar.language.messages import _

PSI, RATIO, RADIUS, ROD, SMALL = (Symbol(name) for name in ("psi", "lambda", "r", "l", "u"))
REST = Symbol("…")
GREATEST_SHOWN = 8
"""The highest harmonic whose series is written out."""


def motion_chapter(engine: Engine, *, power: int = 7) -> Chapter:
    """The harmonics A_2, A_4, ... of a centred crank drive, step by step, to lambda**power.

    Exact fractions; the last step has the value at the rod ratio of the engine's first cylinder,
    where that has a plain rod on a centred crank. `power` is from 1 to 24. Raises DerivationError.

    >>> from crankstar.derive.algebra.typeset import text
    >>> from crankstar.files.catalog import load
    >>> lines = motion_chapter(load("i4")).steps[4].lines
    >>> [text(line.chain[-1]) for line in lines if line.series][:2]
    ['λ + λ³/4 + 15λ⁵/128 + 35λ⁷/512 + …', '−λ³/4 − 3λ⁵/16 − 35λ⁷/256 + …']
    """
    if isinstance(power, bool) or power not in range(1, GREATEST_ORDER + 1):
        raise DerivationError(
            _(
                "The power is {power}; give a power of λ from 1 to {greatest}.",
                power=repr(power),
                greatest=GREATEST_ORDER,
            )
        )
    terms = (power + 1) // 2
    orders = range(2, min(2 * terms, GREATEST_SHOWN) + 1, 2)
    steps = (
        _place(),
        _root(terms),
        _cosines(terms),
        _collected(orders, terms),
        _harmonics(orders, terms),
        _exactly(engine, orders),
    )
    return Chapter(
        engine=engine.name,
        title=_("The motion of one piston"),
        harmonic=None,
        symbols={},
        steps=steps,
        meanings={
            "x": _("distance of the piston pin from the crank axis"),
            "psi": _("angle of the crank from the cylinder"),
            "l": _("length of the connecting rod"),
            "u": _("short for λ² sin² ψ"),
        },
    )


def root_coefficients(count: int) -> tuple[Fraction, ...]:
    """The coefficients of 1, u, ..., u**count in sqrt(1 - u).

    >>> [str(value) for value in root_coefficients(4)]
    ['1', '-1/2', '-1/8', '-1/16', '-5/128']
    """
    with _terms(count + 1):
        root = fmpq_series([1, -1]).sqrt()
        return tuple(Fraction(int(c.p), int(c.q)) for c in (root[n] for n in range(count + 1)))


@contextmanager
def _terms(count: int) -> Iterator[None]:
    """Power series with this many terms."""
    before, ctx.cap = ctx.cap, count
    try:
        yield
    finally:
        ctx.cap = before


def cosine_coefficients(half: int) -> tuple[Fraction, ...]:
    """The coefficients of 1, cos 2 psi, cos 4 psi, ... in (sin psi)**(2 half).

    With z = exp(2 i psi), sin^2 psi is -(z - 1)^2/(4 z); the coefficient of z^k in its power is
    half of that of cos 2 k psi.

    >>> [str(value) for value in cosine_coefficients(2)]
    ['3/8', '-1/2', '1/8']
    """
    powers = fmpq_poly([1, -2, 1]) ** half / (-4) ** half
    values = [Fraction(int(c.p), int(c.q)) for c in (powers[half + k] for k in range(half + 1))]
    return (values[0], *(2 * value for value in values[1:]))


def place_coefficients(order: int, terms: int) -> Series:
    """The powers of lambda in x_k, k = `order`, with their coefficients, from so many terms.

    >>> [(power, str(value)) for power, value in place_coefficients(2, 2)]
    [(1, '1/4'), (3, '1/16')]
    """
    roots = root_coefficients(terms)
    return tuple(
        (2 * j - 1, roots[j] * cosine_coefficients(j)[order // 2])
        for j in range(max(order // 2, 1), terms + 1)
    )


def _sine(exponent: int) -> Formula:
    return Power(Applied("sin", PSI), exponent)


def _lean() -> Formula:
    """The root that the crank drive brings: sqrt(1 - lambda^2 sin^2 psi)."""
    return Root(Sum((number(1), product(-1, Power(RATIO, 2), _sine(2)))))


def _place() -> Step:
    rod = Root(Sum((Power(ROD, 2), product(-1, Power(RADIUS, 2), _sine(2)))))
    short = product(RADIUS, Sum((cosine(PSI), Ratio(_lean(), RATIO))))
    lines = (
        Line(Symbol("x"), (Sum((product(RADIUS, cosine(PSI)), rod)),), label=_("from the drawing")),
        Line(RATIO, (Ratio(RADIUS, ROD),), label=_("rod ratio")),
        Line(Symbol("x"), (short,), label=_("with it")),
    )
    words = _(
        "The crank pin is r cos ψ above the crank axis and r sin ψ beside the cylinder axis. The "
        "rod is the hypotenuse of a right triangle; Pythagoras gives its side along the cylinder "
        "axis."
    )
    return Step(_("The place of the piston"), (words,), lines)


def _root(terms: int) -> Step:
    values = root_coefficients(terms)
    written = [_term(value, SMALL, n) for n, value in enumerate(values)]
    lines = (
        Line(SMALL, (product(Power(RATIO, 2), _sine(2)),), label=_("short")),
        Line(
            Root(Sum((number(1), product(-1, SMALL)))),
            (summed(*written, REST),),
            "series",
            label=_("binomial series"),
        ),
    )
    words = _(
        "The root is a power series in u, by the binomial theorem for the exponent 1/2. It "
        "converges since λ < 1."
    )
    return Step(_("The root as a series"), (words,), lines)


def _term(value: Fraction, letter: Formula, power: int) -> Formula:
    """One term of a power series: -5 u^4/128."""
    if power == 0:
        return number(value)
    raised = letter if power == 1 else Power(letter, power)
    above = product(abs(value.numerator), raised)
    size = above if value.denominator == 1 else Ratio(above, number(value.denominator))
    return product(1 if value > 0 else -1, size)


def _cosines(terms: int) -> Step:
    lines: list[Line] = []
    for half in range(1, terms + 1):
        values = cosine_coefficients(half)
        common = lcm(*(value.denominator for value in values))
        written = [
            product(common * value, cosine(product(2 * k, PSI)) if k else 1)
            for k, value in enumerate(values)
        ]
        whole = Ratio(Sum(tuple(written)), number(common))
        lines.append(Line(_sine(2 * half), (whole,)))
    words = _(
        "An even power of the sine is a sum of cosines of even multiples of the angle. So a "
        "centred crank has no odd harmonics above the first."
    )
    return Step(_("Powers of the sine as cosines"), (words,), tuple(lines))


def _collected(orders: range, terms: int) -> Step:
    places = [product(Symbol("x", str(k)), cosine(product(k, PSI))) for k in orders]
    whole = product(RADIUS, summed(cosine(PSI), Symbol("x", "0"), *places, REST))
    lines = [Line(Symbol("x"), (whole,), "series", label=_("sum of cosines"))]
    lines += [
        Line(Symbol("x", str(k)), (series(place_coefficients(k, terms), RATIO),), "series")
        for k in orders
    ]
    words = _(
        "The series of the root, divided by λ, is sorted by the cosines. The constant x_0 is a "
        "place and has no acceleration."
    )
    return Step(_("Sorted by cosines"), (words,), tuple(lines))


def _harmonics(orders: range, terms: int) -> Step:
    force = product(Symbol("m"), RADIUS, Power(Symbol("omega"), 2))
    own = [product(Symbol("A", str(k)), cosine(product(k, PSI))) for k in orders]
    lines = [
        Line(
            Symbol("F"),
            (product(force, summed(cosine(PSI), *own, REST)),),
            "series",
            label=_("force on the block"),
        )
    ]
    for k in orders:
        letter = Symbol("A", str(k))
        lines.append(
            Line(letter, (product(k * k, Symbol("x", str(k))),), label=_("differentiated"))
        )
        powers = [(power, k * k * value) for power, value in place_coefficients(k, terms)]
        lines.append(series_line(letter, powers))
    words = _(
        "The block feels minus the mass times the acceleration of the piston. At constant speed "
        "two differentiations of cos kψ by time give −k² ω² cos kψ, so A_k is k² times x_k."
    )
    return Step(_("The harmonics of the force"), (words,), tuple(lines))


def _exactly(engine: Engine, orders: range) -> Step:
    lines: list[Line] = []
    words = [
        _(
            "The same number without a series: the Fourier coefficient of the root. crankstar "
            "computes with the exact value, never with a series cut off."
        )
    ]
    ratio = _rod_ratio(engine)
    if ratio is None:
        words.append(
            _(
                "The first cylinder of this engine has an articulated rod or misses the crank "
                "axis, so its own harmonics differ; `crankstar derive --orders` encloses them."
            )
        )
    for k in orders:
        front = Ratio(number(2 * k * k), product(Pi(), RATIO))
        inner = product(_lean(), cosine(product(k, PSI)))
        whole = product(front, Integral(inner, PSI, number(0), Pi()))
        letter = Symbol("A", str(k))
        lines.append(Line(letter, (whole,), label=_("as an integral")))
        if ratio is not None:
            ball = enclosure.coefficient(ratio, k)
            lines.append(Line(letter, (Decimal(ball, 12),), label=exactly(engine, ratio)))
    return Step(_("The exact harmonic"), tuple(words), tuple(lines))


def _rod_ratio(engine: Engine) -> Fraction | None:
    """l/r of the first cylinder; None where its harmonics are not those of a centred crank."""
    first = engine.first
    if first.offset or first.articulated:
        return None
    with cyclotomic.precision(cyclotomic.DIGITS):
        return rational.ratio(first.rod_length / engine.throw(first).radius)
