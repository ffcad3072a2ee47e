"""Every formula of a derivation equals the Balance of the parts it names.

The last formulas equal the definition in 50 digits.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from fractions import Fraction
from math import inf, nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.catalog import EVERY_ENGINE
from tests.exactly import (
    MP,
    Amplitudes,
    defined,
    evaluated,
    followed,
    is_nothing,
    moved,
    mp,
    orders_of,
    piston_harmonic,
    radians_of,
    short_engines,
    snapped,
    vectors,
)
from tests.holding import PATIENCE
from tests.judged import Judged, lines
from tests.strategies import OF_ANY_KIND

from crankstar import spectra
from crankstar.derive import Derivation, DerivationError, derivation
from crankstar.derive.algebra import evaluation, formula, wave
from crankstar.derive.bodies import bodies
from crankstar.derive.positions import arms
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Rod, Shaft, Throw
from crankstar.files import catalog
from crankstar.mechanics.balance import Reference

QUANTITIES = ("force", "couple")
THETAS = (0.0, 0.7, 2.9)
EIGHTH, TWELFTH, QUARTER = Fraction(1, 8), Fraction(1, 12), Fraction(1, 4)
WHOLE = ("Pistons and rotating masses together", "The resultant")
"""Titles of the steps that tell of the whole engine."""


def faults(judged: Judged) -> list[str]:
    """The formulas that do not come to the Balance."""
    told, out = judged.told, []
    every = tuple(range(len(judged.forward)))
    for title, line in lines(told):
        rows = line.rows or (
            every if title in WHOLE else ()
        )  # a rigid rod is in no row alone, but in the whole
        for place, tree in enumerate(line.chain):
            if line.kind in ("forward", "backward"):
                wrong = abs(
                    evaluation.value(tree, told.symbols) * told.scale
                    - judged.vector(line.kind, rows)
                )
            elif line.kind == "signal" and rows:
                wrong = max(
                    abs(
                        evaluation.value(tree, {**told.symbols, "theta": theta}) * told.scale
                        - judged.signal(line.bearing_deg, rows, theta)
                    )
                    for theta in THETAS
                )
            else:
                continue
            if wrong > judged.allowed:
                out.append(
                    f"{title}: {line.label}, {place}: {wrong:.3g} wrong, "
                    f"{judged.allowed:.3g} allowed"
                )
    return out


def checked(
    engine: Engine, order: Fraction | float, quantity: Any, reference: Reference | None = None
) -> Derivation:
    told = derivation(engine, order, quantity, reference=reference)
    assert faults(Judged.of(engine, told, reference)) == []
    return told


@pytest.mark.many(first=9)
@EVERY_ENGINE
def test_every_line_of_every_engine_of_the_catalog_comes_to_the_balance(name: str) -> None:
    engine = catalog.load(name)
    for order in (1, 2, 4, 6):
        for quantity in QUANTITIES:
            checked(engine, order, quantity)


REFERENCES = st.none() | st.sampled_from([0.0, 0.25, -0.35, 0.123456]).map(Reference)


@given(st.data(), short_engines(), st.sampled_from(QUANTITIES), REFERENCES)
def test_every_line_of_an_engine_with_short_numbers_comes_to_the_balance(
    data: Any, engine: Engine, quantity: Any, reference: Any
) -> None:
    told = checked(engine, data.draw(orders_of(engine)), quantity, reference)
    assert told.why == ""


@given(
    st.data(),
    st.sampled_from(sorted(OF_ANY_KIND)),
    st.sampled_from([8, 12, 24, 36, 14, 360]),
    st.sampled_from(QUANTITIES),
)
def test_every_line_of_any_engine_with_angles_at_parts_of_a_turn_comes_to_the_balance(
    data: Any, kind: str, part: int, quantity: Any
) -> None:
    engine = snapped(data.draw(OF_ANY_KIND[kind]), part)
    checked(engine, data.draw(orders_of(engine)), quantity, data.draw(REFERENCES))


@given(st.data(), st.sampled_from(sorted(OF_ANY_KIND)), st.sampled_from(QUANTITIES))
def test_every_line_of_any_engine_comes_to_the_balance(data: Any, kind: str, quantity: Any) -> None:
    engine = data.draw(OF_ANY_KIND[kind])
    try:
        checked(engine, data.draw(orders_of(engine)), quantity, data.draw(REFERENCES))
    except DerivationError as error:
        if "too near to locking" not in str(error):
            raise


def changed(engine: Engine, **cylinder: Any) -> Engine:
    return engine.model_copy(
        update={"cylinders": tuple(c.model_copy(update=cylinder) for c in engine.cylinders)}
    )


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize(
    "carried",
    [{"rod": Rod(mass=0.4, centre=0.05, inertia=0.001)}, {"big_end_mass": 0.3}],
    ids=["a rod as a rigid body", "a big end apart from the throw"],
)
def test_what_the_crank_end_of_a_rod_does_belongs_to_its_cylinder_and_its_place(
    carried: dict[str, Any], order: int, quantity: Any
) -> None:
    """In a vee with a bank offset the big ends are not in the middle of their pin."""
    engine = changed(
        row([Fraction(0), Fraction(1, 4), Fraction(3, 4), Fraction(1, 2)], (-EIGHTH, EIGHTH)),
        **carried,
    )
    told = checked(engine, order, quantity)
    symbols, scale = exact_symbols(engine, told, None)
    assert_closed_forms_are(
        told, symbols, scale, defined(engine, Fraction(order), quantity), 1, CLOSE
    )


def test_a_bank_offset_that_is_no_short_decimal_of_the_pitch_is_not_rounded() -> None:
    checked(row([Fraction(0), Fraction(1, 3)], (-TWELFTH, TWELFTH), bore_pitch=0.07), 1, "couple")


# -- in fifty digits

CLOSE = MP.mpf(10) ** -46


def exact_symbols(
    engine: Engine, told: Derivation, reference: Reference | None
) -> tuple[dict[str, Any], Any]:
    """The values of a derivation's letters, and of what it is counted in, in sixty digits."""
    values = {symbol.name: mp(value) for symbol, value in arms(engine, reference).values.items()}
    found = bodies(engine, told.order)
    values |= {
        symbol.name: piston_harmonic(ratio, j) for symbol, (j, ratio) in found.values.items()
    }
    scale = (
        MP.mpf(1)
        if not told.harmonic or found.rod_ratio is None
        else piston_harmonic(found.rod_ratio, told.harmonic)
    )
    return values, scale


def assert_closed_forms_are(
    told: Derivation, symbols: dict[str, Any], scale: Any, truth: Amplitudes, sense: int, close: Any
) -> None:
    for theta in ("0", "0.7", "2.9"):
        turn = MP.expj(mp(told.order) * MP.mpf(theta))
        for own, expected in ((told.up, truth.up), (told.right, truth.right)):
            found = (
                evaluated(wave.signal(own, told.order), {**symbols, "theta": MP.mpf(theta)}) * scale
            )
            assert abs(found - (expected * turn).real) < close
    for own, expected in zip((told.forward, told.backward), vectors(truth, sense), strict=True):
        assert abs(evaluated(wave.vector(own), symbols) * scale - expected) < close


@given(st.data(), short_engines(), st.sampled_from(QUANTITIES), REFERENCES)
def test_closed_forms_are_the_definition_in_fifty_digits(
    data: Any, engine: Engine, quantity: Any, reference: Any
) -> None:
    order = data.draw(orders_of(engine))
    told = derivation(engine, order, quantity, reference=reference)
    symbols, scale = exact_symbols(engine, told, reference)
    assert_closed_forms_are(
        told, symbols, scale, defined(engine, order, quantity, reference), engine.sense, CLOSE
    )


@pytest.mark.release
@settings(max_examples=6)
@given(st.data(), short_engines(plain=False), st.sampled_from(QUANTITIES), REFERENCES)
def test_rods_on_knuckle_pins_and_off_the_centre_push_as_their_motion_says(
    data: Any, engine: Engine, quantity: Any, reference: Any
) -> None:
    order = data.draw(orders_of(engine))
    told = derivation(engine, order, quantity, reference=reference)
    symbols, scale = (
        exact_symbols(engine, told, reference) if not told.why else (dict[str, Any](), MP.mpf(1))
    )
    symbols |= {symbol.name: mp(value) for symbol, value in arms(engine, reference).values.items()}
    truth = followed(engine, moved(engine), order, quantity, reference)
    assert_closed_forms_are(told, symbols, scale, truth, engine.sense, MP.mpf(10) ** -38)


@pytest.mark.parametrize(
    "name",
    ["v8-cross-plane", "v6-60-six-throws", "sinitsyn-8-two-stroke", "napier-lion", "audi-25-tfsi"],
)
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_engines_of_the_catalog_have_the_closed_forms_of_their_definition(
    name: str, quantity: Any
) -> None:
    engine = catalog.load(name)
    for order in map(Fraction, (1, 2, 4, 6)):
        told = derivation(engine, order, quantity)
        symbols, scale = exact_symbols(engine, told, None)
        assert_closed_forms_are(
            told, symbols, scale, defined(engine, order, quantity), engine.sense, CLOSE
        )


# -- zero, and nearly zero


def row(
    throws: Sequence[Fraction], bearings: Sequence[Fraction] = (Fraction(0),), **own: Any
) -> Engine:
    """Equal cylinders a pitch apart, one per throw and bearing; two banks half a pitch apart."""
    count, pins = len(throws), []
    for index, turn in enumerate(throws):
        pins.append(Throw(angle=radians_of(turn), radius=0.05, z=(count - 1 - 2 * index) / 20))
    cylinders = [
        Cylinder(
            number=1 + bank * count + index,
            shaft="crank",
            throw=index + 1,
            bearing=radians_of(bearing),
            z=(count - 1 - 2 * index) / 20 - bank * 0.03,
            rod_length=0.2,
            reciprocating_mass=0.5,
        )
        for bank, bearing in enumerate(bearings)
        for index in range(count)
    ]
    shaft = Shaft(name="crank", throws=tuple(pins))
    return Engine.model_validate(
        {"name": "row", "bore_pitch": 0.1, "shafts": (shaft,), "cylinders": tuple(cylinders), **own}
    )


@st.composite
def stars(draw: Any) -> list[Fraction]:
    count = draw(st.integers(1, 8))
    return [Fraction(place, count) for place in draw(st.permutations(range(count)))]


BANKS = st.sampled_from([(0,), (0,), (-EIGHTH, EIGHTH), (-TWELFTH, TWELFTH), (QUARTER, -QUARTER)])


@settings(max_examples=60)
@given(
    stars(), BANKS, st.sampled_from([1, 2, 2, 4, 6, 8]), st.sampled_from(QUANTITIES), st.booleans()
)
def test_a_derivation_says_zero_where_sixty_digits_say_so(
    throws: list[Fraction],
    bearings: tuple[Fraction, ...],
    order: int,
    quantity: Any,
    backwards: bool,
) -> None:
    engine = row(throws, bearings, rotation="counter-clockwise" if backwards else "clockwise")
    told = derivation(engine, order, quantity)
    truth = defined(engine, Fraction(order), quantity)
    nothing = is_nothing(truth.up) and is_nothing(truth.right)
    assert told.why == ""
    if (set(told.symbols) <= {"a", "b"} and len(told.symbols) < 2) or quantity == "force":
        assert told.zero == nothing
        assert [not own for own in (told.up, told.right)] == [
            is_nothing(truth.up),
            is_nothing(truth.right),
        ]
        assert [not own for own in (told.forward, told.backward)] == [
            is_nothing(one) for one in vectors(truth, engine.sense)
        ]
    else:
        assert nothing or not told.zero  # with these lengths a and b may happen to cancel


@pytest.mark.parametrize(
    ("throws", "order", "quantity"),
    [
        ((0, 4, 4, 0), 1, "force"),
        ((0, 4, 4, 0), 1, "couple"),
        ((0, 2, 6, 4), 2, "force"),
        ((0, 2, 6, 4), 2, "couple"),
    ],
)
def test_a_hundredth_of_a_degree_is_not_zero(
    throws: Sequence[int], order: int, quantity: Any
) -> None:
    even = [Fraction(turn, 8) for turn in throws]
    if (throws, order, quantity) != ((0, 2, 6, 4), 2, "couple"):
        assert derivation(row(even), order, quantity).zero
    uneven = [even[0] + Fraction(1, 36_000), *even[1:]]
    engine = row(uneven)
    told = derivation(engine, order, quantity)
    assert not told.zero
    assert told.why == ""
    truth = defined(engine, Fraction(order), quantity)
    assert abs(truth.up) > 1e-5
    symbols, scale = exact_symbols(engine, told, None)
    assert_closed_forms_are(told, symbols, scale, truth, 1, CLOSE)


@pytest.mark.release
@settings(max_examples=10)
@given(st.sampled_from([2, 3, 4, 5, 6, 8]), st.data(), st.sampled_from([1, 2]))
def test_no_star_stays_balanced_when_one_throw_is_turned_a_little(
    count: int, data: Any, order: int
) -> None:
    throws = [Fraction(place, count) for place in data.draw(st.permutations(range(count)))]
    moved_by = [turn + Fraction(int(index == 1), 36_000) for index, turn in enumerate(throws)]
    even, uneven = derivation(row(throws), order), derivation(row(moved_by), order)
    assert even.zero == (order % count != 0)
    assert not uneven.zero


# -- what cannot be derived, and what is long
# --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "order",
    [0, -1, 25, nan, inf, -inf, "2", None, 10**400, -(10**400), 1e-300, 2 + 0j, [2], 0.1234567],
    ids=lambda order: repr(order)[:12],
)
def test_an_order_that_cannot_be_is_told_in_a_sentence(order: Any) -> None:
    with pytest.raises(
        DerivationError, match=r"^The order is .*; give a (crank order|number) above 0 and up to 24"
    ):
        derivation(catalog.load("i4"), order)


@pytest.mark.parametrize("quantity", ["roll", "torque", "", None, 1, ["force"]])
def test_a_quantity_without_derivation_is_told_in_a_sentence(quantity: Any) -> None:
    with pytest.raises(
        DerivationError, match=r"^There is no derivation of .*; the quantity can be force or couple"
    ):
        derivation(catalog.load("i4"), 2, quantity)


@pytest.mark.release
@pytest.mark.parametrize(
    ("count", "part", "bearings"),
    [
        (64, 64, (0,)),
        (32, 64, (Fraction(-1, 8), Fraction(1, 8))),
        (256, 256, (0,)),
        (128, 360, (Fraction(-1, 12), Fraction(1, 12))),
    ],
    ids=["64 in line", "64 in a vee", "256 in line", "256 in a vee"],
)
def test_very_long_engines_are_derived(
    count: int, part: int, bearings: tuple[Fraction, ...]
) -> None:
    shuffled = np.random.default_rng(count).permutation(part)[:count]
    engine = row([Fraction(int(turn), part) for turn in shuffled], bearings)
    for order, quantity in ((1, "force"), (2, "couple")):
        told = derivation(engine, order, quantity)  # pyright: ignore[reportArgumentType]
        assert faults(Judged.of(engine, told)) == []


@pytest.mark.release
def test_masses_of_many_figures_are_derived() -> None:
    """Their squares are whole numbers too large to factor.

    The derivation runs in a process of its own, because nothing else can end it.
    """
    code = """
from fractions import Fraction
from tests.laws.test_derivations import checked, row
engine = row([Fraction(n, 24) for n in (0, 5, 11, 16)])
masses = (0.5123457, 0.6234571, 0.7345679, 0.8234567)
cylinders = tuple(
    cylinder.model_copy(update={"reciprocating_mass": mass})
    for cylinder, mass in zip(engine.cylinders, masses, strict=True)
)
for quantity in ("force", "couple"):
    checked(engine.model_copy(update={"cylinders": cylinders}), 1, quantity)
"""
    root = Path(__file__).parents[2]
    subprocess.run([sys.executable, "-c", code], check=True, cwd=root, timeout=PATIENCE)


# -- the shape of the whole, and the real engine
# -----------------------------------------------------------------------


@EVERY_ENGINE
def test_what_is_said_of_the_real_engine_is_what_it_does(name: str) -> None:
    engine = catalog.load(name)
    for order in (1, 2, 4):
        for quantity in QUANTITIES:
            told = derivation(engine, order, quantity)
            judged, every = (
                Judged.of(engine, told),
                tuple(range(len(Judged.of(engine, told).forward))),
            )
            path = spectra.ellipse(
                judged.vector("forward", every), judged.vector("backward", every)
            )
            unit = next(line.name for title, line in lines(told) if line.label == "unit")
            assert isinstance(unit, formula.Symbol)
            names = {**told.symbols, unit.name: told.scale}
            for title, line in lines(told):
                if title == "The real engine" and line.label in ("up", "right"):
                    bearing = 0.0 if line.label == "up" else 90.0
                    found = evaluation.value(line.chain[0], {**names, "theta": 0.7})
                    assert abs(found - judged.signal(bearing, every, 0.7)) <= judged.allowed
                below = line.name.below if isinstance(line.name, formula.Symbol) else ""
                if title == "The resultant" and below in ("long", "short"):
                    expected = path.semi_major if below == "long" else path.semi_minor
                    assert (
                        abs(
                            evaluation.value(line.chain[0], told.symbols) * abs(told.scale)
                            - expected
                        )
                        <= 2 * judged.allowed
                    )


@pytest.mark.many(first=7)
@pytest.mark.parametrize("name", ["v8-cross-plane", "audi-25-tfsi", "gm-3800", "merlin"])
@pytest.mark.parametrize("power", [1, 3, 7, 11])
def test_the_series_is_that_of_the_motion(name: str, power: int) -> None:
    engine = catalog.load(name)
    first = engine.first
    ratio = engine.throw(first).radius / first.rod_length
    for order in (2, 4):
        told = derivation(engine, order, "couple", power=power)
        for _, line in lines(told):
            if line.kind == "series" and line.chain[0] != formula.NOUGHT:
                found = evaluation.value(line.chain[0], {"lambda": ratio, "…": 0.0})
                assert found == pytest.approx(
                    float(motion.series(order, ratio=ratio, highest_power=power)), rel=1e-12
                )


def test_the_law_of_one_cylinder_is_that_of_its_motion() -> None:
    engine = catalog.load("v8-cross-plane")
    first = engine.first
    exact = motion.piston_harmonics(
        crank_radius=engine.throw(first).radius, rod_length=first.rod_length
    )
    law = next(line for _, line in lines(derivation(engine, 4)) if line.label == "law")
    names = {
        "m": 2.0,
        "r": 3.0,
        "omega": 5.0,
        "psi": 0.7,
        "A_2": exact[2].real,
        "A_4": exact[4].real,
        "…": 0.0,
    }
    expected = 2 * 3 * 25 * float(sum((exact[k] * np.exp(1j * k * 0.7)).real for k in (1, 2, 4)))
    assert evaluation.value(law.chain[0], names) == pytest.approx(expected, rel=1e-12)
