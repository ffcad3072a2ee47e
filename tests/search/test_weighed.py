"""Sums of a real engine are the amplitudes that its Balance has, for any star its throws are turned to."""

import numpy as np
import pytest
from tests import exhaustive

from crankstar import phasor
from crankstar.balance import balance, total
from crankstar.catalog import load
from crankstar.firing import firing
from crankstar.search.engines import firing_order
from crankstar.search.findings import findings
from crankstar.search.question import Best, Question
from crankstar.search.stars import SearchError
from crankstar.search.weighed import couple_of, force_of, rms_couple, stars_of, with_star


def amplitude(spectrum, order):
    """Of a wave along a line, from its half that turns against the crank, where no turning mass is."""
    found = phasor.selected(spectrum, order)
    return 2 * abs(complex(found.backward[0]))


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
                assert vector.length(tuple(row)) == pytest.approx(amplitude(spectrum, order), rel=1e-9, abs=1e-9 * vector.scale)


def test_unequal_pistons_weigh_what_they_weigh():
    engine = load("i6")
    heavier = tuple(
        cylinder.model_copy(update={"reciprocating_mass": cylinder.reciprocating_mass * (1 + 0.1 * cylinder.number)})
        for cylinder in engine.cylinders
    )
    uneven = type(engine).model_validate(engine.model_copy(update={"cylinders": heavier}).model_dump())
    stars = stars_of(uneven)
    star = (0, 1, 2, 0, 2, 1)
    result = total(balance(with_star(uneven, stars, star)))
    for order in (1, 2):
        assert force_of(uneven, stars, order).length(star) == pytest.approx(amplitude(result.force, order), rel=1e-9)
        assert couple_of(uneven, stars, order).length(star) == pytest.approx(amplitude(result.couple, order), rel=1e-9)


def test_the_rms_couple_is_that_over_a_turn():
    engine = load("sinitsyn-7-first")
    stars = stars_of(engine)
    found = findings(Question(stars, (rms_couple(engine, stars),), ask=Best(2)))
    for row in found.rows:
        couple = total(balance(with_star(engine, stars, row.star))).couple
        squares = sum((amplitude(couple, order) ** 2) / 2 for order in (1, 2, 4, 6))
        assert row.values[0] == pytest.approx(np.sqrt(squares), rel=1e-9)


def test_an_engine_that_is_not_in_line_is_refused():
    for name in ("v8-cross-plane", "kr250-racer"):
        with pytest.raises(SearchError):
            stars_of(load(name))
