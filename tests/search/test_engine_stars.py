"""Sums of a real engine are the amplitudes of its Balance, for any star of its throws."""

from fractions import Fraction

import numpy as np
import pytest
from tests import exhaustive
from tests.search.asked import seven

from crankstar import spectra
from crankstar.engine.copies import with_values
from crankstar.files.catalog import load
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.remedy import fitting
from crankstar.stars.answer import answer_to
from crankstar.stars.engine_stars import (
    couple_of,
    force_of,
    rms_couple,
    star_of,
    stars_of,
    with_star,
)
from crankstar.stars.engines import firing_order
from crankstar.stars.faults import SearchError
from crankstar.stars.question import Best, Question


def amplitude(spectrum, order):
    """The largest value of an order over a turn."""
    found = spectra.selected(spectrum, order)
    return abs(complex(found.forward[0])) + abs(complex(found.backward[0]))


@pytest.mark.many(first=3)
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


def test_a_crankshaft_geared_to_another_shaft_is_refused():
    engine = with_values(load("i4"), firing_order=())
    (shaft,) = engine.shafts
    output = with_values(shaft, name="output", throws=(), weights=())
    geared = with_values(engine, shafts=(output, with_values(shaft, speed_ratio=-2, up=-0.2)))
    with pytest.raises(SearchError, match="geared"):
        stars_of(geared)


def test_an_engine_that_is_not_in_line_is_refused():
    for name in ("v8-cross-plane", "kr250-racer"):
        with pytest.raises(SearchError):
            stars_of(load(name))


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


def test_where_throws_differ_only_the_pistons_are_counted_and_the_name_says_so():
    engine = with_values(load("i6"), firing_order=())
    (shaft,) = engine.shafts
    heavy = (with_values(shaft.throws[0], rotating_mass=1.0), *shaft.throws[1:])
    uneven = with_values(engine, shafts=(with_values(shaft, throws=heavy),))
    assert force_of(uneven, stars_of(uneven), 1).name == "F1 (pistons)"
    assert force_of(uneven, stars_of(uneven), 2).name == "F2"


def test_what_cancels_among_all_parts_is_exactly_zero() -> None:
    """Weights on the end webs of a marine seven, which take the forward couple away."""
    engine = fitting.by_factor(load("man-s90mc-c"), factor=0.5, weights="ends")
    weighted = fitting.with_shafts(engine, ratios=[Fraction(-1)], places=fitting.ShaftPlaces())
    stars = stars_of(weighted)
    star = star_of(weighted, stars)
    assert star is not None
    assert couple_of(weighted, stars, 1).of_engine(star) == 0.0
