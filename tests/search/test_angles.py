"""Uneven angles: gradients, optima against grids and many neighbours, and the Engine with them."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from tests import exhaustive

from crankstar import spectra
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.stars.angles import STARTS, Term, curve, sentence, star_task, terms, uneven
from crankstar.stars.engines import engine
from crankstar.stars.faults import SearchError
from crankstar.stars.star import Stars
from crankstar.stars.sums import couple, torsion


def space(cylinders: int, cycle: Any = "two-stroke", **more: Any) -> Stars:
    return Stars(cylinders, cycle, exhaustive.halves(cylinders), **more)


STARS = {
    "three": (space(3), (0, 1, 2)),
    "four": (space(4), (0, 3, 1, 2)),
    "seven": (space(7), (0, 5, 3, 2, 4, 6, 1)),
    "five, four-stroke": (space(5, "four-stroke"), (0, 3, 1, 4, 2)),
    "eight, four-stroke": (space(8, "four-stroke"), (0, 1, 2, 3, 0, 1, 2, 3)),
}
EVERY = pytest.mark.parametrize("name", STARS)


def lengths(stars: Stars, star: Any, later_deg: np.ndarray, order: int, arms: Any) -> np.ndarray:
    """|sum of arm exp(i order (dead centre + later))|, cylinders last."""
    angle = 2 * np.pi * np.array(star) / stars.directions + np.radians(later_deg)
    return np.abs(np.sum(np.array(arms, float) * np.exp(1j * order * angle), axis=-1))


def worth(
    stars: Stars,
    star: Any,
    later_deg: np.ndarray,
    couples: dict[int, float],
    forces: dict[int, float],
) -> np.ndarray:
    square = sum(
        (w * lengths(stars, star, later_deg, k, stars.positions)) ** 2 for k, w in couples.items()
    )
    square += sum(
        (w * lengths(stars, star, later_deg, k, [1] * stars.cylinders)) ** 2
        for k, w in forces.items()
    )
    return np.sqrt(square)


def deviations(order: Any, later_deg: np.ndarray) -> np.ndarray:
    """By how much each firing interval leaves the even one, firings last."""
    fired = later_deg[..., [number - 1 for number in order]]
    return np.roll(fired, -1, axis=-1) - fired


@EVERY
def test_gradients_are_those_of_finite_differences(name: str) -> None:
    stars, star = STARS[name]
    task = star_task(stars, star, terms(stars, couples={1: 1.0, 2: 0.25}, forces={1: 0.3, 2: 2.0}))
    places = np.random.default_rng(3).normal(size=task.free.shape[1]) * 0.1
    step = 1e-6
    sides = [
        [task.square(places + sign * step * unit)[0] for sign in (1, -1)]
        for unit in np.eye(len(places))
    ]
    assert task.square(places)[1] == pytest.approx(
        [(up - down) / (2 * step) for up, down in sides], rel=1e-6, abs=1e-7
    )


@pytest.mark.many(first=2)
@pytest.mark.parametrize("forces", [{}, {1: 0.7, 2: 0.4}, {1: 3.0}])
@pytest.mark.parametrize(("name", "steps"), [("three", 401), ("four", 61)])
def test_the_optimum_is_that_of_a_grid_over_all_angles(
    name: str, steps: int, forces: dict[int, float]
) -> None:
    stars, star = STARS[name]
    allowed = 12.0
    found = uneven(
        stars, star, terms(stars, couples={1: 1.0, 2: 0.25}, forces=forces), deviation_deg=allowed
    )
    axis = np.linspace(-2 * allowed, 2 * allowed, steps)
    grid = np.stack(np.meshgrid(*[axis] * (stars.cylinders - 1), indexing="ij"), axis=-1).reshape(
        -1, stars.cylinders - 1
    )
    grid = np.column_stack([np.zeros(len(grid)), grid])
    grid = grid[(np.abs(deviations(found.firing_order, grid)) <= allowed + 1e-9).all(axis=-1)]
    least = worth(stars, star, grid, {1: 1.0, 2: 0.25}, forces).min()
    assert found.value <= least + 1e-9
    assert found.value > least - 0.02


@pytest.mark.many(first=2)
@EVERY
@pytest.mark.parametrize("forces", [{}, {1: 1.0}])
def test_no_angles_near_the_optimum_are_better(name: str, forces: dict[int, float]) -> None:
    stars, star = STARS[name]
    found = uneven(
        stars, star, terms(stars, couples={1: 1.0, 2: 0.25}, forces=forces), deviation_deg=4.0
    )
    random = np.random.default_rng(5)
    for size in (1e-4, 1e-2, 0.3):
        near = np.array(found.later_deg) + size * random.normal(size=(4000, stars.cylinders))
        widest = np.abs(deviations(found.firing_order, near)).max(axis=1, keepdims=True)
        near *= np.minimum(1, 4.0 / widest)
        assert worth(stars, star, near, {1: 1.0, 2: 0.25}, forces).min() > found.value - 1e-8


@pytest.mark.parametrize("deviation", [1.0, 2.0, 5.0])
def test_what_weighs_little_is_made_least_as_well(deviation: float) -> None:
    """The middle cylinder has no arm, so only the free forces decide where its throw stands.

    They weigh a millionth of the couples.
    """
    stars, star = space(7), (0, 2, 5, 4, 3, 6, 1)
    forces = {1: 1e-3, 2: 1e-3}
    found = uneven(
        stars,
        star,
        terms(stars, couples={1: 1.0, 2: 1.0}, forces=forces),
        deviation_deg=deviation,
        starts=1,
    )
    place = 3
    assert stars.positions[place] == 0
    swept = np.array(found.later_deg) + np.eye(7)[place] * np.linspace(-1, 1, 2001)[:, None]
    swept = swept[
        np.abs(deviations(found.firing_order, swept)).max(axis=1) <= deviation * (1 + 1e-9)
    ]
    free = worth(stars, star, swept, {}, forces)
    best = swept[np.argmin(free), place]
    assert found.later_deg[place] == pytest.approx(best, abs=1e-3)
    assert best not in (swept[0, place], swept[-1, place])


@EVERY
def test_nothing_moves_where_intervals_must_be_even(name: str) -> None:
    stars, star = STARS[name]
    found = uneven(stars, star, terms(stars, couples={1: 1.0, 2: 1.0}), deviation_deg=0)
    assert found.later_deg == (0.0,) * stars.cylinders
    assert (
        found.after
        == found.before
        == (couple(stars, 1).length(star), couple(stars, 2).length(star), 0.0, 0.0)
    )
    assert found.value == found.value_before
    assert len(set(found.intervals_deg)) == 1
    assert "as in the even star" in sentence(found)


@pytest.mark.many(first=1)
@EVERY
def test_more_freedom_never_ends_worse_and_what_it_brings_is_true(name: str) -> None:
    stars, star = STARS[name]
    allowed = (8.0, 0.0, 1.0, 2.0, 4.0)
    found = curve(
        stars, star, terms(stars, couples={1: 1.0, 2: 0.25}), deviations_deg=allowed, starts=6
    )
    assert [one.deviation_deg for one in found] == sorted(allowed)
    assert all(then.value < one.value for one, then in pairwise(found))
    for one in found:
        later = np.array(one.later_deg)
        assert one.greatest_deviation_deg <= one.deviation_deg + 1e-9
        assert one.value == pytest.approx(
            worth(stars, star, later, {1: 1.0, 2: 0.25}, {}), abs=1e-9
        )
        ones = [1] * stars.cylinders
        true = [
            lengths(stars, star, later, k, arms) for arms in (stars.positions, ones) for k in (1, 2)
        ]
        assert one.after == pytest.approx(true, abs=2e-8)  # zeros are told as zeros
        assert [term.sum.name for term in one.terms] == ["M1", "M2", "F1", "F2"]


@pytest.mark.many(first=3)
@EVERY
def test_the_engine_with_uneven_angles_fires_and_shakes_as_they_say(name: str) -> None:
    stars, star = STARS[name]
    found = uneven(
        stars, star, terms(stars, couples={1: 1.0, 2: 0.25}), deviation_deg=4.0, starts=4
    )
    built = engine(stars, star, later_deg=found.later_deg)
    fired = firing(built)
    assert fired.order == found.firing_order
    assert fired.intervals_deg == pytest.approx(found.intervals_deg, abs=1e-6)
    sums = total(balance(built))
    row = tuple(range(stars.directions)) * stars.sharing
    even = spectra.selected(total(balance(engine(stars, row))).couple, 2)
    second = abs(spectra.vertical(even)[0]) / couple(stars, 2).length(row)
    for spectrum, (one, two) in ((sums.couple, found.after[:2]), (sums.force, found.after[2:])):
        assert abs(spectra.vertical(spectra.selected(spectrum, 1))[0]) == pytest.approx(
            one, abs=1e-9
        )
        assert abs(spectra.vertical(spectra.selected(spectrum, 2))[0]) == pytest.approx(
            second * two, abs=1e-9
        )
    centres = [(angle - found.dead_centres_deg[0]) % 360 for angle in found.dead_centres_deg]
    assert [-np.degrees(throw.angle) % 360 for throw in built.shafts[0].throws] == pytest.approx(
        centres, abs=1e-9
    )


def test_limits_of_the_free_forces_are_kept_and_cost_something() -> None:
    stars, star = STARS["seven"]
    free = uneven(stars, star, terms(stars, couples={1: 1.0}), deviation_deg=5.0)
    held = uneven(
        stars, star, terms(stars, couples={1: 1.0}, forces_at_most={1: 0.1}), deviation_deg=5.0
    )
    none = uneven(
        stars, star, terms(stars, couples={1: 1.0}, forces_at_most={1: 0}), deviation_deg=5.0
    )
    assert free.after[1] > 0.1
    assert held.after[1] == pytest.approx(0.1, abs=1e-7)
    assert none.after[1] == 0
    assert free.value < held.value < none.value < none.value_before


@pytest.mark.release
def test_two_cylinders_of_a_direction_may_part_but_not_in_a_symmetric_crank() -> None:
    stars, star = STARS["eight, four-stroke"]
    found = uneven(stars, star, terms(stars, couples={1: 1.0}), deviation_deg=5.0)
    assert max(abs(found.later_deg[j] - found.later_deg[j + 4]) for j in range(4)) > 1
    whole = space(6, "four-stroke", symmetric=True)
    pairs = uneven(
        whole,
        (0, 1, 2, 2, 1, 0),
        terms(whole, couples={2: 1.0}, forces={3: 1.0}),
        deviation_deg=5.0,
    )
    assert pairs.later_deg == pairs.later_deg[::-1]
    assert pairs.value < pairs.value_before


def test_fixed_throws_stay() -> None:
    stars = space(7, fixed=((1, 0), (4, 2)))
    found = uneven(stars, (0, 5, 3, 2, 4, 6, 1), terms(stars, couples={1: 1.0}), deviation_deg=5.0)
    assert [j for j, later in enumerate(found.later_deg) if later == 0] == [0, 3]


def test_torsion_follows_firing_angles_in_half_orders_too() -> None:
    stars, star = STARS["five, four-stroke"]
    shape = [Fraction(n, 10) for n in (10, 7, 1, -5, -9)]
    driven = torsion(stars, order=Fraction(5, 2), shape=shape)
    found = uneven(stars, star, [Term(driven, Fraction(5, 2))], deviation_deg=6.0)
    fired = dict(zip(found.firing_order, np.cumsum([0, *found.intervals_deg[:-1]]), strict=True))
    true = abs(sum(float(a) * np.exp(2.5j * np.radians(fired[j])) for j, a in enumerate(shape, 1)))
    assert found.after == (pytest.approx(true, abs=1e-9),)
    assert true < 0.96 * found.before[0]


@pytest.mark.release
def test_it_is_said_to_be_a_local_optimum_and_the_same_every_time() -> None:
    stars, star = STARS["seven"]
    wanted = terms(stars, couples={1: 1.0})
    found = uneven(stars, star, wanted, deviation_deg=5.0)
    assert found == uneven(stars, star, wanted, deviation_deg=5.0)
    assert 1 <= found.agreeing <= found.starts == STARTS
    words = f"the best from {STARTS} starting points, {found.agreeing} of which lead to it"
    assert words in sentence(found)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"deviation_deg": -1.0}, "A deviation of -1 deg"),
        ({"deviation_deg": 52.0}, "below the even interval of 51.429 deg"),
        ({"couples": {1: 0.0}}, "at least one vector sum"),
        ({"couples": {1: float("nan")}}, "M1: the weight is nan"),
        ({"forces_at_most": {1: -0.5}}, "F1: the greatest length is -0.5"),
        ({"forces_at_most": {7: 1.0}}, "of even ones keep F7 <= 1"),
        ({"starts": 0}, "0 starting points"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(changes: dict[str, Any], message: str) -> None:
    stars, star = STARS["seven"]
    asked: dict[str, Any] = {"couples": {1: 1.0}} | {
        key: it for key, it in changes.items() if key in ("couples", "forces_at_most")
    }
    said: dict[str, Any] = {"deviation_deg": 2.0} | {
        key: it for key, it in changes.items() if key not in asked
    }
    with pytest.raises(SearchError, match=message):
        uneven(stars, star, terms(stars, **asked), **said)
