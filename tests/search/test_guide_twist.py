"""The guide-force moment X as a goal of a search: by brute force through whole engines."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest
from tests.marine import marine_engine

from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.guide_moments import guide_moments
from crankstar.options.search import search_of
from crankstar.options.words import SearchWords
from crankstar.stars.answer import answer_to
from crankstar.stars.engine_stars import stars_of, twisting_of, with_star
from crankstar.stars.faults import SearchError
from crankstar.stars.star import Star

FIVE = marine_engine(firing_order=[1, 4, 3, 2, 5])


def of_engine(engine: Engine, order: float) -> float:
    found = guide_moments(engine, cycle(engine))
    return float(np.abs(found.x)[found.orders == order][0])


def stars(cylinders: int) -> list[Star]:
    return [(0, *rest) for rest in permutations(range(1, cylinders))]


@pytest.mark.release
@pytest.mark.parametrize("order", [1, 2, 3, 4, 6])
def test_x_of_a_star_is_x_of_the_engine_with_it(order: int) -> None:
    own = stars_of(FIVE)
    goal = twisting_of(FIVE, own, Fraction(order))
    for star in stars(5):
        wanted = of_engine(with_star(FIVE, own, star), order)
        assert goal.length(star) == pytest.approx(wanted, rel=1e-5)


@pytest.mark.release
@pytest.mark.parametrize("cycle_name", ["two-stroke", "four-stroke"])
def test_the_best_by_x_is_the_best_of_all_engines(cycle_name: str) -> None:
    engine = marine_engine(firing_order=[1, 2, 4, 5, 3], cycle=cycle_name)
    own = stars_of(engine)
    order = "1.5" if cycle_name == "four-stroke" else "3"
    search = search_of(engine, SearchWords(minimise=f"X{order}", best="1"), speed=engine.speed)
    [row] = answer_to(search.question).rows
    everything = [of_engine(with_star(engine, own, star), float(order)) for star in stars(5)]
    assert row.values[0] == pytest.approx(min(everything), rel=1e-5)


@pytest.mark.release
def test_a_limit_on_x_leaves_only_what_keeps_it() -> None:
    words = SearchWords(minimise="M2", limit=["X3=300 kN m"], all=True)
    search = search_of(FIVE, words, speed=FIVE.speed)
    found = answer_to(search.question)
    own = stars_of(FIVE)
    kept = [star for star in stars(5) if of_engine(with_star(FIVE, own, star), 3) <= 300e3]
    assert found.stars == len(kept) > 0


def test_of_a_number_x_of_a_two_stroke_is_the_star_of_couples() -> None:
    search = search_of(7, SearchWords(cycle="two-stroke", minimise="M1,X1"))
    first, second = search.question.objectives
    for star in [(0, 2, 5, 4, 3, 6, 1), (0, 1, 2, 3, 4, 5, 6)]:
        [(_weight, couple)], [(_other, twist)] = first.terms, second.terms
        assert twist.length(star) == pytest.approx(couple.length(star))


@pytest.mark.parametrize(
    ("about", "words", "code"),
    [
        (7, {"cycle": "two-stroke", "minimise": "X1.5"}, "two-stroke-x"),
        (6, {"minimise": "X1.5"}, "half-x"),
        (7, {"minimise": "X3V"}, "no-quantity"),
        (FIVE, {"minimise": "X5"}, "alike-order"),
        (marine_engine(gas=None), {"minimise": "X3"}, "x-gas"),
        (marine_engine(layout={"type": "inline"}), {"minimise": "X3"}, "x-pitch"),
        (FIVE, {"minimise": "X60"}, "x-none"),
        (FIVE, {"minimise": "M1", "limit": ["X3=300 N"]}, "amount"),
    ],
)
def test_what_x_cannot_be_is_a_fault(
    about: int | Engine, words: dict[str, object], code: str
) -> None:
    with pytest.raises(SearchError) as raised:
        search_of(about, SearchWords(**words), speed=getattr(about, "speed", None))  # pyright: ignore[reportArgumentType]
    assert [fault.code for fault in raised.value.faults] == [code]
