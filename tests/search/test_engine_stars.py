"""Sums of a real engine are the amplitudes of its Balance, for any star of its throws."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import exhaustive
from tests.strategies import ANGLES, CYCLES, MASSES, ROTATIONS, maybe, number, rigid_rods

from crankstar import spectra
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.copies import with_values
from crankstar.engine.layouts import inline
from crankstar.files.catalog import load
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.search.answer import answer_to
from crankstar.search.engine_stars import couple_of, force_of, rms_couple, stars_of, with_star
from crankstar.search.engines import firing_order
from crankstar.search.faults import SearchError
from crankstar.search.question import Best, Question


def amplitude(spectrum, order):
    """The largest value of an order over a turn."""
    found = spectra.selected(spectrum, order)
    return abs(complex(found.forward[0])) + abs(complex(found.backward[0]))


@pytest.mark.parametrize("name", ["i6", "audi-25-tfsi", "sinitsyn-7-first", "sinitsyn-6-loop"])
@pytest.mark.parametrize("turn", [1, 5])
def test_forces_and_couples_are_those_of_the_balance_at_every_star(name, turn):
    engine = load(name)
    stars = stars_of(engine)
    rows = exhaustive.stars(stars.directions, stars.sharing)
    for row in rows[:: max(1, len(rows) // 5)][:turn].tolist():
        turned = with_star(engine, stars, tuple(row))
        result = total(balance(turned, speed=engine.speed))
        assert turned.firing_order == firing_order(stars, tuple(row))
        assert firing(turned).even
        for order in (1, 2, 4):
            for make, spectrum in ((force_of, result.force), (couple_of, result.couple)):
                vector = make(engine, stars, order, speed=engine.speed)
                assert vector.length(tuple(row)) == pytest.approx(
                    amplitude(spectrum, order), rel=1e-9, abs=1e-9 * vector.scale
                )


def test_unequal_pistons_weigh_what_they_weigh():
    engine = load("i6")
    heavier = tuple(
        cylinder.model_copy(
            update={"reciprocating_mass": cylinder.reciprocating_mass * (1 + 0.1 * cylinder.number)}
        )
        for cylinder in engine.cylinders
    )
    uneven = type(engine).model_validate(
        engine.model_copy(update={"cylinders": heavier}).model_dump()
    )
    stars = stars_of(uneven)
    star = (0, 1, 2, 0, 2, 1)
    result = total(balance(with_star(uneven, stars, star)))
    for order in (1, 2):
        assert force_of(uneven, stars, order).length(star) == pytest.approx(
            amplitude(result.force, order), rel=1e-9
        )
        assert couple_of(uneven, stars, order).length(star) == pytest.approx(
            amplitude(result.couple, order), rel=1e-9
        )


@pytest.mark.parametrize("factor", [None, 0.5, 1.0])
def test_the_rms_couple_is_that_over_a_turn(factor):
    engine = seven(factor)
    stars = stars_of(engine)
    found = answer_to(Question(stars, (rms_couple(engine, stars),), ask=Best(2)))
    for row in found.rows:
        couple = total(balance(with_star(engine, stars, row.star))).couple
        squares = 0.0
        for order in (1, 2, 4, 6):
            part = spectra.selected(couple, order)
            squares += abs(part.forward[0]) ** 2 + abs(part.backward[0]) ** 2
        assert row.values[0] == pytest.approx(np.sqrt(squares), rel=1e-9)


def test_an_engine_that_is_not_in_line_is_refused():
    for name in ("v8-cross-plane", "kr250-racer"):
        with pytest.raises(SearchError):
            stars_of(load(name))


def seven(factor):
    """An in-line seven, two-stroke, with counterweights by a balance factor."""
    behind = (0.0, 1.02, 2.04, 3.06, 4.08, 5.6, 6.62)
    basis = Basis(
        name="seven",
        cycle="two-stroke",
        firing_order=(1, 7, 2, 5, 4, 3, 6),
        speed=105 * np.pi / 30,
        balance_factor=factor,
        cylinder=Sizes(
            stroke=2.4, rod_length=2.46, reciprocating_mass=5500.0, rotating_mass=6800.0
        ),
    )
    return inline(basis, positions=behind)


def test_counterweights_turn_with_the_throws_of_a_star():
    """Half the reciprocating mass balanced: the first-order couple is a circle of half the size."""
    engine = seven(0.5)
    stars = stars_of(engine)
    star = (0, 2, 5, 3, 4, 1, 6)  # fires 1-6-2-4-5-3-7
    promised = couple_of(engine, stars, 1, speed=engine.speed)
    assert promised.length(star) == pytest.approx(914004, abs=1)
    turned = with_star(engine, stars, star)
    couple = spectra.selected(total(balance(turned, speed=engine.speed)).couple, 1)
    assert abs(couple.forward[0]) < 1e-6
    assert abs(couple.backward[0]) == pytest.approx(914004, abs=1)


@settings(max_examples=25, deadline=None)
@given(st.data())
def test_search_promises_what_analyze_finds_in_the_engine_it_writes(data):
    """Equal throws with rotating masses and counterweights, uneven pitches, both senses."""
    count = data.draw(st.integers(2, 7))
    gaps = data.draw(st.lists(number(0.05, 0.5), min_size=count, max_size=count))
    rod = data.draw(maybe(rigid_rods(0.2)))
    basis = Basis(
        name="random",
        cycle=data.draw(CYCLES),
        rotation=data.draw(ROTATIONS),
        balance_factor=data.draw(maybe(number(0.0, 1.5))),
        cylinder=Sizes(
            stroke=0.1,
            rod_length=0.2,
            offset=data.draw(maybe(number(-0.02, 0.02), 0.0)),
            reciprocating_mass=data.draw(MASSES),
            rotating_mass=data.draw(maybe(MASSES, 0.0)),
            rod=rod,
        ),
    )
    places = tuple(sum(gaps[:slot]) for slot in range(count))
    engine = inline(basis, throws=(0.0,) * count, bearing=data.draw(ANGLES), positions=places)
    stars = stars_of(engine)
    listed = exhaustive.stars(stars.directions, stars.sharing)
    star = tuple(listed[data.draw(st.integers(0, len(listed) - 1))].tolist())
    result = total(balance(with_star(engine, stars, star)))
    for order in (1, 2, 4):
        for promise, spectrum in ((force_of, result.force), (couple_of, result.couple)):
            promised = promise(engine, stars, order)
            assert "pistons" not in promised.name
            assert promised.length(star) == pytest.approx(
                amplitude(spectrum, order), rel=1e-9, abs=1e-9 * count * promised.scale
            )


def test_where_throws_differ_only_the_pistons_are_counted_and_the_name_says_so():
    engine = with_values(load("i6"), firing_order=())
    (shaft,) = engine.shafts
    heavy = (with_values(shaft.throws[0], rotating_mass=1.0), *shaft.throws[1:])
    uneven = with_values(engine, shafts=(with_values(shaft, throws=heavy),))
    assert force_of(uneven, stars_of(uneven), 1).name == "F1 (pistons)"
    assert force_of(uneven, stars_of(uneven), 2).name == "F2"
