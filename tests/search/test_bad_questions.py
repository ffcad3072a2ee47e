"""Questions that are not possible are refused, each fault with its code."""

from dataclasses import replace
from fractions import Fraction
from math import inf, nan
from typing import Any

import pytest
from tests import exhaustive

from crankstar.stars.answer import answer_to, succeeding
from crankstar.stars.equivalence import Equivalence, equivalent, question
from crankstar.stars.faults import SearchError
from crankstar.stars.question import All, Best, Front, FunctionObjective, Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, Objective, couple, of

SEVEN = Stars(7, "two-stroke", exhaustive.halves(7))
EIGHT = Stars(8, "four-stroke", exhaustive.halves(8))


def stars(
    cylinders: int = 7, cycle: Any = "two-stroke", positions: Any = None, **more: Any
) -> Stars:
    return Stars(
        cylinders,
        cycle,
        exhaustive.halves(max(cylinders, 0)) if positions is None else positions,
        **more,
    )


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ({"cylinders": 0}, "cylinders"),
        ({"cylinders": -1}, "cylinders"),
        ({"cylinders": 25}, "cylinders"),
        ({"cycle": "three-stroke"}, "cycle"),
        ({"positions": (Fraction(1),)}, "positions"),
        ({"positions": (nan,) * 7}, "position"),
        ({"symmetric": True}, "symmetric"),
        ({"fixed": ((9, 0),)}, "fixed-cylinder"),
        ({"fixed": ((1, 9),)}, "fixed-direction"),
        ({"fixed": ((1, -1),)}, "fixed-direction"),
        ({"fixed": ((1, 0), (1, 2))}, "fixed-twice"),
        ({"fixed": ((1, 0), (2, 0))}, "fixed-crowded"),
        (
            {"cylinders": 8, "cycle": "four-stroke", "symmetric": True, "fixed": ((1, 0), (8, 1))},
            "fixed-mirror",
        ),
    ],
)
def test_stars_that_cannot_be_are_refused(words, code):
    with pytest.raises(SearchError) as raised:
        stars(**words)
    assert code in [fault.code for fault in raised.value.faults]


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"ask": Best(0)}, "list-size"),
        ({"ask": All(-1)}, "list-size"),
        ({"ask": Front(0)}, "list-size"),
        ({"neighbours_at_most": nan}, "neighbours"),
        ({"limits": (Limit(couple(SEVEN, 2), nan),)}, "limit-range"),
        ({"limits": (Limit(couple(SEVEN, 2), 1.0, 2.0),)}, "limit-range"),
        ({"limits": (Limit(couple(EIGHT, 2), 1.0),)}, "other-stars"),
        (
            {"functions": (FunctionObjective("any", lambda star: float(star[0]), greatest=nan),)},
            "function-limit",
        ),
        (
            {"ask": Best(3), "objectives": (of(couple(SEVEN, 1)), of(couple(SEVEN, 2)))},
            "several-objectives",
        ),
        ({"ask": Best(3), "objectives": ()}, "no-objective"),
    ],
)
def test_questions_that_cannot_be_are_refused(changes, code):
    plain = Question(SEVEN, (of(couple(SEVEN, 1)),))
    with pytest.raises(SearchError) as raised:
        replace(plain, **changes)
    assert code in [fault.code for fault in raised.value.faults]


@pytest.mark.parametrize("star", [(0, 1, 2), (0, 1, 2, 3, 4, 5, 9_999_999), (0, 1, 2, 3, 4, 5, 5)])
def test_what_is_no_star_has_no_neighbours(star):
    with pytest.raises(SearchError, match="star"):
        succeeding(SEVEN, star)


def test_every_mistake_of_the_stars_is_told():
    with pytest.raises(SearchError) as told:
        Stars(7, "two-stroke", (Fraction(1),), fixed=((9, 0), (1, 9)))
    assert len(told.value.faults) == 3


@pytest.mark.parametrize(
    ("function", "told"), [(lambda _: nan, "finite"), (lambda _: 1 / 0, "ZeroDivisionError")]
)
def test_a_function_that_fails_is_named_with_its_star(function, told):
    asked = Question(
        SEVEN,
        (),
        limits=(Limit(couple(SEVEN, 1), 1.0),),
        functions=(FunctionObjective("mine", function),),
    )
    with pytest.raises(SearchError, match=f"mine.*{told}"):
        answer_to(asked)


@pytest.mark.release
def test_least_lengths_leave_out_what_is_shorter():
    rows = exhaustive.stars(7, 1)
    sizes = exhaustive.lengths(rows, exhaustive.arms(7), 1, 7)
    asked = Question(
        SEVEN, (of(couple(SEVEN, 1)),), (Limit(couple(SEVEN, 1), 5.0, 3.0),), ask=All()
    )
    assert answer_to(asked).stars == ((sizes >= 3.0) & (sizes <= 5.0)).sum()


@pytest.mark.release
def test_a_class_of_many_stars_within_wide_limits_is_listed_alone():
    eleven = stars(11)
    same = Equivalence((couple(eleven, 1), couple(eleven, 2)), tuple(range(11)))
    found = equivalent(answer_to(question(eleven, same, ())), same)
    assert (found.stars, len(found.rows)) == (2, 1)


def test_a_question_without_objectives_lists_what_keeps_the_limits():
    found = answer_to(
        Question(SEVEN, (), (Limit(couple(SEVEN, 1), 0.3),), neighbours_at_most=inf, ask=All())
    )
    assert {row.values for row in found.rows} == {()}
    assert Objective("none").terms == ()
