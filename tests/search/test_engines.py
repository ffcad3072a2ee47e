"""The Engine of a star: it fires as the star says, and shakes as its vector sums say."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from tests import exhaustive
from tests.rules.test_catalog import covers, leaves

from crankstar import spectra
from crankstar.files import engine_of, toml, tree_of
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Reference
from crankstar.stars.answer import succeeding
from crankstar.stars.engines import engine, firing_order
from crankstar.stars.faults import SearchError
from crankstar.stars.star import Stars
from crankstar.stars.sums import couple, force

CASES = [(n, "two-stroke") for n in (1, 2, 3, 5, 6, 7, 8)] + [
    (n, "four-stroke") for n in (1, 2, 3, 4, 5, 6, 7, 8, 10)
]
UNEQUAL = tuple(
    Fraction(text)
    for text in ("3.2", "2.2", "1.2", "-0.8", "-1.8", "-2.8", "-3.8", "-5", "-6", "-7")
)


def drawn(stars, count=12):
    rows = exhaustive.stars(stars.directions, stars.sharing)
    return [tuple(row) for row in rows[:: max(1, len(rows) // count)].tolist()]


def space(cylinders: int, cycle: Any, positions=None):
    return Stars(cylinders, cycle, positions or exhaustive.halves(cylinders))


def second_harmonic(ratio: float) -> float:
    """A_2 of the acceleration of a piston, in r w^2, from samples of its travel."""
    theta = 2 * np.pi * np.arange(256) / 256
    travel = np.cos(theta) + np.sqrt(ratio**2 - np.sin(theta) ** 2)
    return 4 * abs(np.fft.rfft(travel)[2]) / 128


def amplitude(spectrum, order):
    """Of what acts along the upright cylinders."""
    return abs(spectra.vertical(spectra.selected(spectrum, order))[0])


@pytest.mark.many(first=6)
@pytest.mark.parametrize(("cylinders", "cycle"), CASES)
@pytest.mark.parametrize("unequal", [False, True])
def test_the_engine_of_a_star_shakes_as_its_vector_sums_say(cylinders, cycle, unequal):
    stars = space(cylinders, cycle, UNEQUAL[:cylinders] if unequal else None)
    for star in drawn(stars):
        sums = total(
            balance(
                engine(stars, star),
                reference=Reference(float(-(stars.positions[0] + stars.positions[-1]) / 2)),
            )
        )
        for order, harmonic in ((1, 1.0), (2, second_harmonic(4.0))):
            assert amplitude(sums.couple, order) == pytest.approx(
                harmonic * couple(stars, order).length(star), abs=1e-9
            )
            assert amplitude(sums.force, order) == pytest.approx(
                harmonic * force(stars, order).length(star), abs=1e-9
            )


@pytest.mark.many(first=3)
@pytest.mark.parametrize(("cylinders", "cycle"), CASES)
def test_the_engine_of_a_star_fires_evenly_in_the_order_of_its_directions(cylinders, cycle):
    stars = space(cylinders, cycle)
    for star in drawn(stars):
        built = engine(stars, star)
        fired = firing(built)
        assert fired.even
        assert fired.order == built.firing_order == firing_order(stars, star)
        directions = [star[number - 1] for number in fired.order]
        onward = {(then - first) % stars.directions for first, then in pairwise(directions)}
        assert onward <= {
            (1 if cycle == "two-stroke" or stars.sharing == 2 else 2) % stars.directions
        }


@pytest.mark.parametrize("cylinders", [2, 4, 6, 8])
def test_where_directions_are_shared_the_order_is_the_best_and_first_of_all(cylinders):
    stars = space(cylinders, "four-stroke")
    n = stars.directions
    for star in drawn(stars, 40):
        pairs = [[j for j, d in enumerate(star, 1) if d == (star[0] + k) % n] for k in range(n)]
        orders = []
        for choice in product((0, 1), repeat=n):
            order = tuple(pair[c] for c, pair in zip(choice, pairs, strict=True))
            order += tuple(pair[1 - c] for c, pair in zip(choice, pairs, strict=True))
            if order[0] == 1:
                orders.append((sum(abs(a - b) == 1 for a, b in pairwise([*order, 1])), order))
        assert firing_order(stars, star) == min(orders)[1]
        assert min(orders)[0] == succeeding(stars, star)


@pytest.mark.parametrize(
    ("cylinders", "cycle"),
    [(1, "two-stroke"), (7, "two-stroke"), (5, "four-stroke"), (6, "four-stroke")],
)
def test_an_engine_of_a_star_is_written_read_again_and_says_where_its_values_come_from(
    cylinders, cycle
):
    stars = space(cylinders, cycle, UNEQUAL[:cylinders])
    star = drawn(stars)[-1]
    built = engine(stars, star)
    text = toml(built)
    assert total(balance(engine_of(tree_of(text)))).couple.forward == pytest.approx(
        total(balance(built)).couple.forward, abs=1e-9
    )
    written = tomllib.loads(text)
    told = written.pop("provenance")
    words = {"format", "name", "cycle", "source"}
    paths = [
        path
        for path in leaves(written)
        if path not in words and not path.endswith((".name", ".bank"))
    ]
    assert [path for path in paths if not any(covers(key, path) for key in told)] == []
    assert [key for key in told if not any(covers(key, path) for path in paths)] == []


def test_the_name_tells_cylinders_cycle_and_firing_order_unless_another_is_given():
    stars = space(7, "two-stroke")
    assert engine(stars, (0, 6, 2, 3, 4, 1, 5)).name == "7 cylinders, two-stroke, 1-6-3-4-5-7-2"
    assert engine(stars, (0, 6, 2, 3, 4, 1, 5), name="seven").name == "seven"


def test_throws_that_come_later_stand_behind():
    stars = space(3, "two-stroke")
    built = engine(stars, (0, 1, 2), later_deg=(1.0, 3.0, 0.0))
    assert np.degrees([throw.angle for throw in built.shafts[0].throws]) == pytest.approx(
        [0, -122, 121]
    )
    assert firing(built).intervals_deg == pytest.approx((122, 117, 121))


@pytest.mark.parametrize(
    ("star", "message"),
    [((0, 1, 2), "has 3 throws for 4 cylinders"), ((0, 1, 2, 3), "from 0 to 1 occurs 2 times")],
)
def test_what_is_no_star_is_refused(star, message):
    with pytest.raises(SearchError, match=message):
        engine(space(4, "four-stroke"), star)


def test_an_angle_for_each_cylinder_or_none():
    with pytest.raises(SearchError, match="2 angles are given for 3 cylinders"):
        engine(space(3, "two-stroke"), (0, 1, 2), later_deg=(0.0, 1.0))
