"""Exact numbers: zeros, closed forms, enclosures and print, against the arithmetic of mpmath."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import permutations
from math import gcd, lcm
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, fmpz_poly
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from tests.exactly import MP, NOTHING, SOMETHING, evaluated, from_ball, mp, piston_harmonic, unit
from tests.strategies import maybe

from crankstar.derive.algebra import cyclotomic, enclosure, evaluation, formula, typeset, wave
from crankstar.derive.algebra import radicals as radical
from crankstar.derive.algebra.cyclotomic import Number, rational, root
from crankstar.derive.algebra.enclosure import Ball, Link
from crankstar.derive.algebra.formula import Decimal, Formula, Symbol
from crankstar.derive.algebra.styles import latex_text
from crankstar.engine import motion

ONE = rational(1)
CLOSE = MP.mpf(10) ** -47
POINT = 10**70
"""Fixed-point sums of whole numbers: no rounding but that of the roots of unity themselves."""

# -- zeros of whole batches


def crank_stars(count: int) -> np.ndarray:
    """All numberings of an even star, cylinder 1 at 0: [(count - 1)!, count]."""
    return np.array([(0, *rest) for rest in permutations(range(1, count))])


def polygons(exponents: np.ndarray, weights: np.ndarray, order: int) -> np.ndarray:
    """Coefficients [..., order] of sums of weights [..., n] times zeta^exponents [..., n]."""
    out = np.zeros((*exponents.shape[:-1], order), dtype=np.int64)
    for place in range(exponents.shape[-1]):
        hit = np.arange(order) == exponents[..., place, None] % order
        out += hit * np.broadcast_to(weights, exponents.shape)[..., place, None]
    return out


def nothing(coefficients: np.ndarray) -> np.ndarray:
    """In seventy digits: whether |z| < 1e-50, with no value between 1e-50 and 1e-40."""
    order = coefficients.shape[-1]
    with MP.workdps(80):
        turns = [unit(Fraction(place, order)) for place in range(order)]
        real = np.array([int(MP.nint(turn.real * POINT)) for turn in turns], object)
        imaginary = np.array([int(MP.nint(turn.imag * POINT)) for turn in turns], object)
    values = coefficients.astype(object)
    squares = (values @ real) ** 2 + (values @ imaginary) ** 2
    low, high = (int(bound**2 * POINT**2) for bound in (NOTHING, SOMETHING))
    none, some = squares < low, squares > high
    assert np.all(none | some), "a sum is neither zero nor far from it"
    return none.astype(bool)


def couples(stars: np.ndarray, order: int, positions: Sequence[int] | np.ndarray) -> np.ndarray:
    return polygons(order * stars, np.asarray(positions), stars.shape[-1])


def evenly(count: int) -> list[int]:
    """Twice the positions in front of the middle."""
    return [count - 1 - 2 * place for place in range(count)]


def as_number(coefficients: np.ndarray) -> Number:
    order = len(coefficients)
    return cyclotomic.total(
        root(Fraction(place, order)).times(int(value))
        for place, value in enumerate(coefficients)
        if value
    )


@pytest.mark.many(first=5)
@pytest.mark.parametrize("count", range(1, 9))
def test_zero_forces_and_couples_of_all_crank_stars_are_those_of_seventy_digits(count: int) -> None:
    stars = crank_stars(count)
    for order in range(1, 7):
        for weights in (evenly(count), [1] * count):
            batch = couples(stars, order, weights)
            found = cyclotomic.vanishing(batch)
            assert np.array_equal(found, nothing(batch))
            some = slice(None) if count <= 6 else slice(order, None, 97)
            assert [as_number(one).zero for one in batch[some]] == found[some].tolist()


@pytest.mark.release
@pytest.mark.parametrize("count", [7, 8])
def test_numbers_one_by_one_are_zero_where_whole_batches_are(count: int) -> None:
    stars = crank_stars(count)
    for order in range(1, 7):
        batch = couples(stars, order, evenly(count))
        assert [as_number(one).zero for one in batch] == cyclotomic.vanishing(batch).tolist()


@pytest.mark.parametrize(
    ("count", "zeros"),
    [
        (2, [0, 1, 0, 1]),
        (3, [0, 0, 2, 0]),
        (4, [0, 2, 0, 6]),
        (5, [0] * 4),
        (6, [4, 8, 0, 8]),
        (7, [0] * 4),
        (8, [0, 96, 0, 576]),
    ],
)
def test_so_many_stars_have_no_couple_of_the_first_four_orders(
    count: int, zeros: list[int]
) -> None:
    stars = crank_stars(count)
    assert [
        int(cyclotomic.vanishing(couples(stars, k, evenly(count))).sum()) for k in (1, 2, 3, 4)
    ] == zeros


@given(st.integers(3, 14), st.data())
def test_stars_of_cylinders_at_uneven_places_vanish_exactly_where_seventy_digits_do(
    count: int, data: Any
) -> None:
    positions = data.draw(st.lists(st.integers(-300, 300), min_size=count, max_size=count))
    seed = data.draw(st.integers(0, 2**32 - 1))
    stars = np.array(
        [np.random.default_rng([seed, place]).permutation(count) for place in range(40)]
    )
    # beside them one that does vanish: opposite throws with equal arms
    if count % 2 == 0:
        stars[0] = np.arange(count)
        positions[count // 2 :] = positions[: count // 2]
    for order in (1, 2, 4):
        batch = couples(stars, order, positions)
        assert np.array_equal(cyclotomic.vanishing(batch), nothing(batch))


@pytest.mark.many(first=7)
@pytest.mark.parametrize("part", [24, 40, 21])
@pytest.mark.parametrize("order", [1, 2, 4])
def test_bearings_and_star_of_a_vee_vanish_together_exactly_where_seventy_digits_do(
    part: int, order: int
) -> None:
    rng = np.random.default_rng([part, order])
    throws = rng.choice([0, part // 4, part // 2, 3 * part // 4, part // 3], size=(400, 4))
    throws[::3, 2:] = (throws[::3, 1::-1] + part // 2) % part  # some that may cancel in pairs
    bearings = np.concatenate(
        [np.full((400, 4), part // 8), np.full((400, 4), part - part // 8)], axis=1
    )
    pins = np.concatenate([throws, throws], axis=1)
    arms = np.array([3, 1, -1, -3, 3, 1, -1, -3])
    for sense in (1, -1):
        for weights in (arms, np.ones(8, int)):
            batch = polygons(bearings + sense * order * (pins - bearings), weights, part)
            found = cyclotomic.vanishing(batch)
            assert np.array_equal(found, nothing(batch))


@pytest.mark.parametrize("kind", [np.int8, np.int64, np.uint8, np.uint64, object])
def test_zeros_are_decided_whatever_the_kind_of_whole_numbers(kind: Any) -> None:
    three = np.array([[1, 0, 1, 0, 1, 0], [2, 0, 1, 0, 1, 0]]).astype(kind)
    assert cyclotomic.vanishing(three).tolist() == [True, False]


@pytest.mark.parametrize("kind", [np.int64, np.uint64, object])
@pytest.mark.parametrize("great", [2**53, 2**61, 2**62 + 1])
def test_great_whole_numbers_that_differ_by_one_do_not_cancel(kind: Any, great: int) -> None:
    pairs = np.array([[great, great], [great + 1, great]], dtype=object).astype(kind)
    assert cyclotomic.vanishing(pairs).tolist() == [True, False]


def test_sums_that_would_run_over_are_not_zero() -> None:
    """They come to 2^64 in the first power, which 64 bits hold as nought."""
    sides = np.array([1, 1, -1, -1, -1, 1]) * 2**62
    assert not cyclotomic.vanishing(sides)


def test_zeros_of_numbers_with_a_fraction_are_not_decided() -> None:
    with pytest.raises(TypeError, match="whole coefficients"):
        cyclotomic.vanishing(np.array([0.5, 0.5]))


# -- the fields


class Both:
    """A number, and its value in sixty digits."""

    def __init__(self, order: int, terms: Sequence[tuple[Fraction, int]]) -> None:
        self.number = cyclotomic.total(
            root(Fraction(place, order)).times(size) for size, place in terms
        )
        self.value = sum(
            (mp(size) * unit(Fraction(place, order)) for size, place in terms), MP.mpc(0)
        )
        self.terms, self.order = terms, order

    def __repr__(self) -> str:
        return " + ".join(f"({size}) z{self.order}^{place}" for size, place in self.terms) or "0"


FRACTIONS = st.builds(Fraction, st.integers(-9, 9), st.sampled_from([1, 1, 2, 3, 7]))
WHOLE = st.integers(-4, 4).map(Fraction)


def sums(
    least: int, most: int, sizes: st.SearchStrategy[Fraction] = FRACTIONS
) -> st.SearchStrategy[Both]:
    """Sums of up to five roots of unity of one order."""

    def of(order: int) -> st.SearchStrategy[Both]:
        term = st.tuples(sizes, st.integers(-order, order))
        return st.lists(term, max_size=5).map(lambda terms: Both(order, terms))

    return st.integers(least, most).flatmap(of)


def assert_is(number: Number | acb, expected: Any, close: Any = CLOSE) -> None:
    with cyclotomic.precision(50):
        ball = number.enclosed() if isinstance(number, Number) else number
    found = MP.mpc(from_ball(ball.real), from_ball(ball.imag))
    assert abs(found - expected) <= close * (1 + abs(expected))


@pytest.mark.release
@given(sums(1, 60), sums(1, 60))
def test_sums_products_and_conjugates_are_those_of_complex_numbers(a: Both, b: Both) -> None:
    assert_is(a.number + b.number, a.value + b.value)
    assert_is(a.number - b.number, a.value - b.value)
    assert_is(a.number * b.number, a.value * b.value)
    assert_is(-a.number, -a.value)
    assert_is(a.number.conjugate, MP.conj(a.value))
    assert_is(cyclotomic.real(a.number), a.value.real)
    assert_is(cyclotomic.imaginary(a.number), a.value.imag)
    assert_is(cyclotomic.total([a.number, b.number, a.number]), 2 * a.value + b.value)
    assert abs(complex(a.number) - complex(a.value)) < 1e-13


@pytest.mark.release
@given(sums(1, 60), sums(1, 60), sums(1, 12))
def test_numbers_make_a_commutative_ring(a: Both, b: Both, c: Both) -> None:
    x, y, z = a.number, b.number, c.number
    assert x + y == y + x
    assert x * y == y * x
    assert (x + z) + x == x + (z + x)
    assert (x * z) * x == x * (z * x)
    assert z * (x + y) == z * x + z * y
    assert (x - x).zero
    assert x * ONE == x
    assert (x * y).conjugate == x.conjugate * y.conjugate
    assert (x * x.conjugate).conjugate == x * x.conjugate


@settings(max_examples=15)
@given(sums(1, 60), sums(1, 40))
def test_what_is_divided_and_multiplied_again_is_what_it_was(a: Both, b: Both) -> None:
    if b.number.zero:
        with pytest.raises(ZeroDivisionError, match="exact zero"):
            _ = a.number / b.number
        return
    quotient = a.number / b.number
    assert quotient * b.number == a.number
    assert_is(quotient, a.value / b.value)


@given(sums(1, 60))
def test_a_number_is_zero_where_sixty_digits_say_so_and_the_batch_too(a: Both) -> None:
    size = abs(a.value)
    assert size < NOTHING or size > SOMETHING
    assert a.number.zero == (size < NOTHING)
    scale = lcm(*(size.denominator for size, _ in a.terms))
    coefficients = np.zeros(a.order, dtype=np.int64)
    for size, place in a.terms:
        coefficients[place % a.order] += int(size * scale)
    assert bool(cyclotomic.vanishing(coefficients)) == a.number.zero
    reduced = coefficients @ cyclotomic.reduction(a.order)
    assert_is(as_number(coefficients), a.value * scale)
    basis = sum(
        (int(value) * unit(Fraction(place, a.order)) for place, value in enumerate(reduced)),
        MP.mpc(0),
    )
    assert abs(basis - a.value * scale) < CLOSE * (1 + abs(basis))


@given(st.integers(2, 60), st.integers(0, 59), st.integers(1, 9))
def test_a_closed_polygon_is_zero_in_every_field(order: int, shift: int, size: int) -> None:
    sides = [root(Fraction(place + shift, order)).times(size) for place in range(order)]
    assert cyclotomic.total(sides).zero
    assert cyclotomic.total(sides[1:]) == -sides[0]
    assert not cyclotomic.total(sides[1:]).zero


@settings(max_examples=30)
@given(sums(1, 30))
def test_the_minimal_polynomial_has_the_number_as_root_and_no_factors(a: Both) -> None:
    found = cyclotomic.minimal_polynomial(a.number)
    polynomial = fmpz_poly(list(found))
    assert found[-1] > 0
    assert gcd(*found) == 1
    assert polynomial.degree() == len(cyclotomic.conjugates(a.number))
    if polynomial.degree() > 0:
        _, factors = polynomial.factor()
        assert [exponent for _, exponent in factors] == [1]
    with MP.workdps(200):
        value = sum(
            (mp(size) * unit(Fraction(place, a.order)) for size, place in a.terms), MP.mpc(0)
        )
        terms = [coefficient * value**power for power, coefficient in enumerate(found)]
        assert abs(sum(terms, MP.mpc(0))) <= MP.mpf(10) ** -150 * (
            1 + sum(abs(term) for term in terms)
        )


@given(sums(1, 60), st.integers(1, 4))
@example(Both(3, [(Fraction(1), 1), (Fraction(1), 2)]), 1)  # minus one, written in another field
@example(Both(5, []), 3)
def test_a_number_equals_itself_in_whatever_field_it_is_written_and_so_is_no_key(
    a: Both, times: int
) -> None:
    other = a.number + root(Fraction(1, a.order * times)) - root(Fraction(1, a.order * times))
    assert other == a.number
    with pytest.raises(TypeError, match="unhashable"):
        hash(other)
    if a.number.rational is not None:
        assert rational(a.number.rational) == a.number


@given(sums(1, 60))
def test_a_number_is_rational_where_all_its_conjugates_are_one(a: Both) -> None:
    others = cyclotomic.conjugates(a.number)
    assert (a.number.rational is not None) == (len(others) == 1)
    for other, power in others:
        assert a.number.moved(power) == other
    if a.number.rational is not None:
        assert abs(mp(a.number.rational) - a.value) < CLOSE * (1 + abs(a.value))


# -- closed forms


def shown(number: Formula) -> str:
    return typeset.text(number)


def bearing_of(number: Number) -> Any:
    return evaluated(radical.bearing(number))


@pytest.mark.release
@settings(max_examples=60)
@given(sums(3, 24, WHOLE))
def test_closed_forms_have_fifty_digits_of_the_number(a: Both) -> None:
    scale = CLOSE * (1 + abs(a.value))
    assert abs(evaluated(radical.closed(cyclotomic.real(a.number))) - a.value.real) < scale
    assert abs(evaluated(radical.closed(cyclotomic.imaginary(a.number))) - a.value.imag) < scale
    assert abs(evaluated(radical.length(a.number)) - abs(a.value)) < scale
    assume(not a.number.zero)
    found = bearing_of(a.number)
    true = MP.pi if abs(a.value.imag) < NOTHING and a.value.real < 0 else MP.arg(a.value)
    assert abs(found - true) < CLOSE * 10
    turn = radical.bearing_turn(a.number)
    if turn is not None:
        assert Fraction(-1, 2) < turn <= Fraction(1, 2)
        assert abs(2 * MP.pi * mp(turn) - true) < CLOSE


@pytest.mark.release
@pytest.mark.parametrize("order", [5, 8, 10, 12, 16, 24])
def test_two_vectors_have_the_length_and_bearing_that_they_have(order: int) -> None:
    """Among them square roots of sums that can be taken apart: sqrt(4 - 2 sqrt 3) = sqrt 3 - 1."""
    for place in range(1, order):
        for one, other in ((1, 1), (1, -1), (2, 1), (1, -2), (2, 3)):
            a = Both(order, [(Fraction(one), 0), (Fraction(other), place)])
            assert abs(evaluated(radical.length(a.number)) - abs(a.value)) < CLOSE
            assert (
                abs(evaluated(radical.closed(a.number * a.number.conjugate)) - abs(a.value) ** 2)
                < 10 * CLOSE
            )
            if not a.number.zero:
                assert abs(MP.expj(bearing_of(a.number)) - a.value / abs(a.value)) < CLOSE
                assert -MP.pi < bearing_of(a.number) <= MP.pi


@pytest.mark.release
def test_negative_numbers_made_of_vectors_that_are_not_point_to_plus_half_a_turn() -> None:
    beside = 0
    for order in range(3, 41):
        for place in range(1, order // 2 + 1):
            number = cyclotomic.total(
                [root(Fraction(place, order)), root(Fraction(-place, order)), rational(-3)]
            )
            beside += complex(number).imag < 0
            assert radical.bearing_turn(number) == Fraction(1, 2)
            assert abs(bearing_of(number) - MP.pi) < CLOSE
            assert radical.bearing_turn(-number) == 0
    assert beside > 10  # rounding puts some of them on the other side of the cut


@pytest.mark.parametrize(
    ("degrees", "printed"),
    [
        ("45", "√2/2"), ("30", "√3/2"), ("15", "(√6 + √2)/4"), ("75", "(√6 − √2)/4"),
        ("36", "(√5 + 1)/4"), ("72", "(√5 − 1)/4"),
        ("22.5", "√(2 + √2)/2"), ("67.5", "√(2 − √2)/2"), ("60", "1/2"), ("90", "0"), ("180", "−1"),
        ("135", "−√2/2"),
        ("54", "√(10 − 2√5)/4"),
    ],
)  # fmt: skip
def test_cosines_are_printed_as_in_the_tables(degrees: str, printed: str) -> None:
    turn = Fraction(degrees) / 360
    found = radical.closed(cyclotomic.cosine(turn))
    assert abs(evaluated(found) - unit(turn).real) < CLOSE
    told = re.sub(r"^\((√\(.*\))\)/", r"\1/", shown(found))
    assert told.replace("(1 + √5)", "(√5 + 1)") == printed


@pytest.mark.parametrize(
    ("number", "printed"),
    [
        (rational(3) + root(Fraction(1, 4)), "√10"),
        ((ONE + root(Fraction(1, 6))).times(2), "2√3"),
        (root(Fraction(1, 8)).times(8), "8"),
        (ONE + root(Fraction(1, 8)), "√(2 + √2)"),
        (cyclotomic.cosine(Fraction(1, 8)).times(8), "4√2"),
    ],
)
def test_lengths_are_printed_as_in_the_tables(number: Number, printed: str) -> None:
    assert shown(radical.length(number)) == printed


def test_the_best_two_stroke_eight_has_the_couple_that_is_known() -> None:
    order = (1, 8, 2, 6, 4, 5, 3, 7)
    couple = cyclotomic.total(
        root(Fraction(-order.index(cylinder), 8)).times(Fraction(evenly(8)[cylinder - 1], 2))
        for cylinder in range(1, 9)
    )
    found = radical.length(couple)
    assert shown(found) == "√(20 − 14√2)"
    assert abs(evaluated(found) - MP.sqrt(20 - 14 * MP.sqrt(2))) < CLOSE


I = root(Fraction(1, 4))  # noqa: E741
QUADRANTS = [
    (rational(up) + I.times(right), f"{up}{right:+}i")
    for up in (-3, -2, -1, 0, 1, 2, 3)
    for right in (-3, -2, -1, 0, 1, 2, 3)
    if up or right
]


@pytest.mark.parametrize(
    "number", [number for number, _ in QUADRANTS], ids=[name for _, name in QUADRANTS]
)
def test_bearings_lie_beyond_minus_and_up_to_plus_half_a_turn(number: Number) -> None:
    value = MP.mpc(complex(number))
    found = bearing_of(number)
    assert -MP.pi < found <= MP.pi
    assert abs(found - (MP.pi if value.imag == 0 and value.real < 0 else MP.arg(value))) < CLOSE


def test_the_bearing_of_a_knight_move_is_an_arctangent() -> None:
    assert shown(radical.bearing(ONE + I.times(2))) in ("atan 2", "arctan 2")


@pytest.mark.parametrize("quarter", range(4))
@pytest.mark.parametrize("order", [1, 3, 5, 7, 8, 9, 11, 24])
def test_exact_quarter_turns_are_seen_through_any_sum(order: int, quarter: int) -> None:
    """A real number made of vectors that are not, turned onto the axes: its ball straddles them."""
    real = cyclotomic.total(
        [root(Fraction(1, order)), root(Fraction(-1, order)), rational(3)]
    )  # 3 + 2 cos > 0
    turned = real * root(Fraction(quarter, 4))
    assert (
        radical.bearing_turn(turned)
        == [Fraction(0), Fraction(1, 4), Fraction(1, 2), Fraction(-1, 4)][quarter]
    )
    assert shown(radical.bearing(turned)) == ["0", "π/2", "π", "−π/2"][quarter]
    with cyclotomic.precision(50):
        ball = Ball(turned.enclosed() + acb(arb(0, 1e-60), arb(0, 1e-60)))
    assert wave.turn_of(ball) == radical.bearing_turn(turned)
    found = wave.bearing(ball)
    assert shown(found) == ["0", "π/2", "π", "−π/2"][quarter]


@pytest.mark.parametrize(
    "aside",
    [Fraction(1), Fraction(-1), Fraction(1, 10**9), Fraction(-1, 10**9), Fraction(-1, 10**30)],
)
def test_a_hair_beside_the_branch_cut_is_on_the_side_where_it_is(aside: Fraction) -> None:
    number = rational(-1000) + I.times(aside)
    value = MP.mpc(-1000, mp(aside))
    assert radical.bearing_turn(number) is None
    assert abs(bearing_of(number) - MP.arg(value)) < CLOSE
    assert abs(evaluated(wave.bearing(Ball(enclosed(number)))) - MP.arg(value)) < CLOSE


def enclosed(number: Number) -> acb:
    with cyclotomic.precision(50):
        return number.enclosed()


@pytest.mark.parametrize(
    "value",
    [
        Fraction(10**12 + 1, 10**12),
        Fraction(10**13 - 1, 3 * 10**13),
        Fraction(1, 3) + Fraction(1, 2**50),
    ],
)
def test_a_long_fraction_is_not_printed_as_a_short_one(value: Fraction) -> None:
    """Cut with dots after it, or in full: never as if it were another number."""
    printed = shown(radical.closed(rational(value)))
    assert "…" in printed or Fraction(printed) == value


def test_the_digits_of_a_decimal_are_all_certain() -> None:
    for order in (7, 9, 11, 13, 14, 18, 22):
        for place in range(1, order // 2):
            number = cyclotomic.cosine(Fraction(place, order))
            found = radical.closed(number)
            if formula.has_decimal(found):
                assert isinstance(found, Decimal)
                assert_cut(typeset.figures(found), unit(Fraction(place, order)).real)
                assert len(cyclotomic.minimal_polynomial(number)) - 1 == len(
                    cyclotomic.conjugates(number)
                )


def assert_cut(figures: str | None, value: Any) -> None:
    """The figures are those of the number, cut off; rounded only where a cut is undecided."""
    assert figures is not None  # the first digit is certain
    places = len(figures.partition(".")[2])
    cut, near = int(MP.floor(abs(value) * 10**places)), int(MP.nint(abs(value) * 10**places))
    if abs(abs(value) * 10**places - near) < MP.mpf("1e-5" if places else "0.11"):
        shown = int(figures.lstrip("-").replace(".", ""))
        assert shown in (cut, near)
        cut = shown
    digits = str(cut).rjust(places + 1, "0")
    expected = digits if places == 0 else f"{digits[:-places]}.{digits[-places:]}"
    assert figures == ("-" if value < 0 else "") + expected


@given(
    st.integers(-(10**24), 10**24).filter(bool),
    st.integers(-8, 30),
    st.integers(1, 20),
    st.integers(20, 45),
)
@example(-9999999999999999999999, 22, 7, 40)
@example(10**20, 20, 12, 40)
@example(9007199254740993 * 1000 + 500, 3, 7, 40)  # more than a double holds
@example(999999992143320000000, 0, 1, 24)  # no cut of a whole number is certain
def test_the_figures_of_any_ball_are_those_of_all_numbers_in_it(
    above: int, power: int, digits: int, sure: int
) -> None:
    with cyclotomic.precision(60):
        ball = arb(above) / arb(10) ** power
        wide = arb(ball.mid(), abs(ball.mid()) * arb(10) ** -sure)
        assume(wide.rad() < 0.1)  # the digits before the point are certain
        figures = typeset.figures(Decimal(wide, digits))
    true = MP.mpf(above) / MP.mpf(10) ** power
    for value in (
        true,
        true * (1 + MP.mpf(10) ** -(sure + 1)),
        true * (1 - MP.mpf(10) ** -(sure + 1)),
    ):
        assert_cut(figures, value)


def test_a_number_that_is_not_known_well_has_fewer_figures() -> None:
    """12.9788888 +- 2e-6 deg: 12.97889 is a number that it may be, and not its figures."""
    with cyclotomic.precision(60):
        ball = arb("12.9788888031", "2e-6")
    assert typeset.figures(Decimal(ball, 7)) == "12.9788"


# -- enclosures


def link(
    length: Fraction,
    offset: Fraction = Fraction(0),
    bearing: float = 0.0,
    knuckle: tuple[Fraction, float] = (Fraction(0), 0.0),
) -> Link:
    return Link(
        length=length,
        offset=offset,
        bearing=bearing,
        knuckle_radius=knuckle[0],
        knuckle_angle=knuckle[1],
    )


def assert_holds(ball: arb, value: Any, *, least: Any = None) -> None:
    """The ball holds the value (known to 55 digits), and is small."""
    middle, radius = from_ball(ball), from_ball(ball.rad())
    assert abs(middle - value) <= radius + MP.mpf(10) ** -54 * (1 + abs(value))
    if least is not None:
        assert radius < least


RATIOS = st.builds(Fraction, st.integers(200, 800), st.just(100))


@pytest.mark.release
@settings(max_examples=15)
@given(RATIOS, st.sampled_from([1, 2, 3, 4, 6, 8, 12, 24]))
@example(Fraction(2), 24)
@example(Fraction(50), 2)
def test_harmonics_of_a_centred_crank_are_enclosed(ratio: Fraction, order: int) -> None:
    ball = enclosure.coefficient(ratio, order)
    assert_holds(ball, piston_harmonic(ratio, order), least=MP.mpf(10) ** -40)


@pytest.mark.parametrize(
    ("ratio", "order"), [(Fraction(4), 2), (Fraction(7, 2), 4), (Fraction(2), 6)]
)
def test_harmonics_are_the_integrals_of_the_acceleration(ratio: Fraction, order: int) -> None:
    """Minus x'' in closed form, by quadrature: no Fourier sum."""
    length = mp(ratio)

    def push(psi: Any) -> Any:
        sine, cosine = MP.sin(psi), MP.cos(psi)
        height = MP.sqrt(length**2 - sine**2)
        return (cosine + (cosine**2 - sine**2) / height + sine**2 * cosine**2 / height**3) * MP.cos(
            order * psi
        )

    whole = MP.quad(push, [place * MP.pi / 8 for place in range(9)]) * 2 / MP.pi
    assert abs(from_ball(enclosure.coefficient(ratio, order)) - whole) < MP.mpf(10) ** -40


@pytest.mark.release
@settings(max_examples=15)
@given(
    RATIOS,
    st.builds(Fraction, st.integers(-80, 80), st.just(100)),
    st.sampled_from([1, 2, 3, 4, 5, 12]),
)
def test_harmonics_of_an_offset_cylinder_are_enclosed(
    ratio: Fraction, offset: Fraction, order: int
) -> None:
    length = ratio * (1 + abs(offset))
    found = enclosure.harmonic((link(length, offset),), order)
    expected = piston_harmonic(length, order, offset)
    assert_holds(found.piston.real, expected.real, least=MP.mpf(10) ** -40)
    assert_holds(found.piston.imag, expected.imag, least=MP.mpf(10) ** -40)
    pin = MP.mpc(1) if order == 1 else MP.mpc(0)
    assert_holds(found.up.real, pin.real)
    assert_holds(found.right.imag, -pin.real)
    assert_holds(found.right.real, MP.mpf(0))


@pytest.mark.release
@settings(max_examples=6)
@given(
    st.sampled_from([Fraction(4), Fraction(7, 2), Fraction(9, 2)]),
    st.sampled_from([Fraction(1, 4), Fraction(1, 3), Fraction(1, 2)]),
    st.integers(-12, 12).map(lambda n: Fraction(n, 24)),
    st.integers(-12, 12).map(lambda n: Fraction(n, 24)),
    st.sampled_from([Fraction(0), Fraction(1, 5)]),
    st.sampled_from([1, 2, 3, 4, 6]),
)
def test_harmonics_of_a_slave_rod_are_enclosed(
    ratio: Fraction,
    knuckle: Fraction,
    at: Fraction,
    bearing: Fraction,
    offset: Fraction,
    order: int,
) -> None:
    slave = Fraction(5)
    rods = (
        link(ratio),
        link(slave, offset, float(bearing) * 2 * np.pi, (knuckle, float(at) * 2 * np.pi)),
    )
    found = enclosure.harmonic(rods, order)
    along, up, right = MP.mpc(0), MP.mpc(0), MP.mpc(0)
    count = 480
    for step in range(count):
        pin = unit(Fraction(step, count))
        master = MP.mpc(MP.sqrt(mp(ratio) ** 2 - pin.imag**2), -pin.imag) / mp(ratio)
        joint = pin + mp(knuckle) * unit(at) * master
        seen = joint / unit(bearing)
        place = seen.real + MP.sqrt(mp(slave) ** 2 - (seen.imag - mp(offset)) ** 2)
        back = MP.conj(unit(Fraction(order * step, count))) * 2 / count * order**2
        along, up, right = along + place * back, up + joint.real * back, right + joint.imag * back
    for ball, value in ((found.piston, along), (found.up, up), (found.right, right)):
        assert_holds(ball.real, value.real, least=MP.mpf(10) ** -40)
        assert_holds(ball.imag, value.imag, least=MP.mpf(10) ** -40)


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("ratio", [Fraction(10), Fraction(20), Fraction(100, 7)])
def test_the_series_in_lambda_misses_the_enclosed_harmonic_by_less_than_its_next_term(
    order: int, ratio: Fraction
) -> None:
    lam = 1 / ratio
    ball = from_ball(enclosure.coefficient(ratio, order))
    for power in (order - 1, order + 1, order + 5):
        partial = sum(motion.series_coefficient(order, p) * lam**p for p in range(power + 1))
        rest = (
            abs(motion.series_coefficient(order, power + 2)) * lam ** (power + 2) / (1 - 4 * lam**2)
        )
        missing = abs(ball - mp(partial))
        assert mp(rest) / 4 < missing <= mp(rest)


@pytest.mark.parametrize(
    "ratio", [Fraction(3, 2), Fraction(2), Fraction(4), Fraction(10), Fraction(40)]
)
def test_small_harmonics_have_no_false_digit(ratio: Fraction) -> None:
    found = np.real(motion.piston_harmonics(crank_radius=1, rod_length=float(ratio)))
    for order in range(2, min(found.size, 13), 2):
        exact = float(from_ball(enclosure.coefficient(ratio, order)))
        assert found[order] == pytest.approx(exact, rel=2e-11, abs=0), order  # ten are shown


@pytest.mark.parametrize("ratio", [Fraction(11, 10), Fraction(2), Fraction(4), Fraction(40)])
@pytest.mark.parametrize("order", [1, 2, 3, 8, 24])
def test_the_harmonic_of_a_centred_crank_is_that_of_its_enclosed_motion(
    ratio: Fraction, order: int
) -> None:
    with cyclotomic.precision(50):
        sampled = enclosure.harmonic((link(ratio, Fraction(0)),), order).piston.real
        assert enclosure.coefficient(ratio, order).overlaps(sampled)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("clearance", ["1.001", "1.0011", "1.003", "1.02", "1.05"])
@pytest.mark.parametrize("offset", ["0", "0.5"])
def test_rods_that_nearly_lock_are_enclosed_or_refused(clearance: str, offset: str) -> None:
    length = Fraction(clearance) * (1 + Fraction(offset))
    try:
        found = enclosure.harmonic((link(length, Fraction(offset)),), 2)
    except ValueError as error:
        assert "too near to locking" in str(error)  # noqa: PT017
        return
    count, whole = 4096, MP.mpc(0)
    for step in range(count):
        turn = unit(Fraction(step, count))
        whole += (
            turn.real + MP.sqrt(mp(length) ** 2 - (turn.imag - mp(Fraction(offset))) ** 2)
        ) * MP.conj(turn**2)
    assert_holds(found.piston.real, (whole * 8 / count).real, least=MP.mpf(10) ** -40)
    assert_holds(found.piston.imag, (whole * 8 / count).imag, least=MP.mpf(10) ** -40)


# -- print

HOSTILE = [
    *(
        "</script>",
        r"$\{}_^%&#~",
        "left & right",
        "bank #1",
        "100 %",
        "a_b^c",
        "<mi>x</mi>",
        "\\end{document}",
        "～${}",
    ),
    *("\"'", "]]>", "\\"),
]
RATIONALS = st.builds(Fraction, st.integers(-60, 60), st.sampled_from([1, 1, 2, 3, 8, 1001])).map(
    formula.number
)
DECIMALS = st.builds(
    lambda n, d: Decimal(arb(n) / 1024, d),
    st.integers(-5000, 5000).filter(bool),
    st.integers(3, 12),
)
LETTERS = ["a", "b", "A", "theta", "lambda", "F", "M", "psi", "A′"]
SYMBOLS = st.builds(
    Symbol, st.sampled_from(LETTERS), st.sampled_from(["", "2", "up", "+", "−", *HOSTILE])
)
LEAVES = st.one_of(
    RATIONALS,
    DECIMALS,
    SYMBOLS,
    st.just(formula.Pi()),
    st.builds(formula.Degrees, RATIONALS | DECIMALS),
)


def grown(children: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.one_of(
        st.lists(children, min_size=1, max_size=4).map(lambda parts: formula.summed(*parts)),
        st.lists(children, min_size=1, max_size=4).map(lambda parts: formula.product(*parts)),
        st.builds(formula.Root, children),
        st.builds(formula.Power, children, st.integers(2, 12)),
        st.builds(formula.Ratio, children, children),
        st.builds(formula.Applied, st.sampled_from(["cos", "sin", "atan"]), children),
        st.builds(formula.Polar, children, children),
        children.map(formula.negative),
    )


TREES = st.recursive(LEAVES, grown, max_leaves=14)


def assert_balanced(text: str, pairs: str = "()") -> None:
    depth = 0
    for letter in text:
        depth += (letter == pairs[0]) - (letter == pairs[1])
        assert depth >= 0, text
    assert depth == 0, text


def names_in(tree: Any) -> Iterator[Symbol]:
    if isinstance(tree, Symbol):
        yield tree
    for name in getattr(tree, "__slots__", ()):
        inner = getattr(tree, name)
        for part in inner if isinstance(inner, tuple) else (inner,):
            if hasattr(part, "__slots__") and not isinstance(part, (Fraction, arb)):
                yield from names_in(part)


@pytest.mark.release
@settings(max_examples=100)
@given(TREES)
def test_brackets_of_every_print_are_balanced(tree: Formula) -> None:
    if not any(symbol.below in HOSTILE for symbol in names_in(tree)):
        assert_balanced(typeset.text(tree))
    told = typeset.latex(tree)
    plain = re.sub(
        r"\\[\\{}$&#_%]",
        "",
        re.sub(r"\\textbackslash\{\}|\\text(asciicircum|asciitilde|less|greater)\{\}", "", told),
    )
    assert_balanced(plain, "{}")
    assert plain.count(r"\left(") == plain.count(r"\right)")
    outside = re.sub(r"\\text\{[^{}]*\}", "", plain)
    assert not set(outside) & set("$%#&~"), told
    for inside in re.findall(r"\\text\{([^{}]*)\}", plain):
        assert not set(inside) & set("$%#&~_^\\<>{}"), told


@pytest.mark.release
@settings(max_examples=100)
@given(TREES)
def test_mathml_is_xml_and_says_the_names_as_they_are(tree: Formula) -> None:
    parsed = ET.fromstring(f"<math>{typeset.mathml(tree)}</math>")  # noqa: S314
    assert {element.tag for element in parsed.iter()} <= {
        "math", "mi", "mn", "mo", "mrow", "mfrac", "msqrt", "msup", "msub", "mtext", "mspace",
    }  # fmt: skip
    said = "".join(parsed.itertext())
    for symbol in names_in(tree):
        assert symbol.below in said
    for tag, parts in (("mfrac", 2), ("msup", 2), ("msub", 2)):
        assert all(len(element) == parts for element in parsed.iter(tag))


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_are_text_in_latex(name: str) -> None:
    told = back = latex_text(name)
    words = {"backslash": "\0", "asciicircum": "^", "asciitilde": "~", "less": "<", "greater": ">"}
    for word, letter in words.items():
        back = back.replace(f"\\text{word}{{}}", letter)
    for letter in "{}$&#_%":
        back = back.replace(f"\\{letter}", letter)
    back = back.replace("\0", "\\")
    assert back in (name, name.encode("ascii", "replace").decode())
    assert f"\\text{{{told}}}" in typeset.latex(Symbol("F", name))


SIZES = st.builds(Fraction, st.integers(1, 12), st.sampled_from([1, 2, 3, 4, 7])).map(
    lambda size: size
)
ROOTS = st.sampled_from([2, 3, 5, 6, 10]).map(lambda n: formula.Root(formula.number(n)))
ANGLES = st.integers(-23, 23).map(lambda n: formula.angle(Fraction(n, 48)))


@st.composite
def cosines(draw: Any) -> Formula:
    """Sums like those of derivations: numbers, roots, letters, and a cosine last."""
    terms = []
    for _ in range(draw(st.integers(1, 4))):
        inside = formula.summed(
            formula.product(draw(st.integers(1, 6)), formula.THETA), draw(ANGLES)
        )
        front = [
            draw(maybe(ROOTS)),
            draw(maybe(st.sampled_from([Symbol("a"), Symbol("b"), Symbol("A", "2")]))),
        ]
        factor = formula.Applied(draw(st.sampled_from(["cos", "sin"])), inside)
        sign = draw(st.sampled_from([1, -1]))
        terms.append(
            formula.product(
                sign * draw(SIZES), *(part for part in front if part is not None), factor
            )
        )
    return formula.summed(*terms)


@pytest.mark.release
@settings(max_examples=100)
@given(cosines())
def test_formulas_come_to_the_same_in_floats_in_balls_and_in_sixty_digits(tree: Formula) -> None:
    symbols = {"a": 1.25, "b": 0.75, "A_2": 0.375, "theta": 0.875}
    exactly = evaluated(tree, {name: MP.mpf(value) for name, value in symbols.items()})
    assert abs(evaluation.value(tree, symbols) - exactly) < 1e-12
    with cyclotomic.precision(50):
        ball = evaluation.enclosed(tree, {name: arb(value) for name, value in symbols.items()})
    assert_holds(ball, exactly, least=MP.mpf(10) ** -40)
