"""Questions that cannot be are refused in a sentence, not answered."""

from dataclasses import replace
from fractions import Fraction
from math import inf, nan
from typing import Any

import pytest
from tests import exhaustive

from crankstar.search.findings import findings, succeeding
from crankstar.search.likeness import Likeness, chosen, question
from crankstar.search.question import All, Best, Front, Judge, Question
from crankstar.search.stars import SearchError, Stars
from crankstar.search.sums import Limit, Objective, couple, of

SEVEN = Stars(7, "two-stroke", exhaustive.halves(7))
EIGHT = Stars(8, "four-stroke", exhaustive.halves(8))


def stars(cylinders: int = 7, cycle: Any = "two-stroke", positions: Any = None, **more: Any) -> Stars:
    return Stars(cylinders, cycle, exhaustive.halves(max(cylinders, 0)) if positions is None else positions, **more)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ({"cylinders": 0}, "from 1 to 24"),
        ({"cylinders": -1}, "from 1 to 24"),
        ({"cylinders": 25}, "from 1 to 24"),
        ({"cycle": "three-stroke"}, "two-stroke, four-stroke"),
        ({"positions": (Fraction(1),)}, "1 positions are given for 7"),
        ({"positions": (nan,) * 7}, "no finite number"),
        ({"symmetric": True}, "symmetric cranks"),
        ({"fixed": ((9, 0),)}, "cylinder 9 is fixed"),
        ({"fixed": ((1, 9),)}, "direction 9"),
        ({"fixed": ((1, -1),)}, "direction -1"),
        ({"fixed": ((1, 0), (1, 2))}, "directions 0 and 2"),
        ({"fixed": ((1, 0), (2, 0))}, "given to 2 throws"),
        ({"cylinders": 8, "cycle": "four-stroke", "symmetric": True, "fixed": ((1, 0), (8, 1))}, "the same direction"),
    ],
)
def test_stars_that_cannot_be_are_refused(words, told):
    with pytest.raises(SearchError, match=told):
        stars(**words)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"ask": Best(0)}, "at least 1"),
        ({"ask": All(-1)}, "at least 1"),
        ({"ask": Front(0)}, "at least 1"),
        ({"neighbours_at_most": nan}, "from 0 up"),
        ({"limits": (Limit(couple(SEVEN, 2), nan),)}, "cannot be from"),
        ({"limits": (Limit(couple(SEVEN, 2), 1.0, 2.0),)}, "cannot be from 2 to 1"),
        ({"limits": (Limit(couple(EIGHT, 2), 1.0),)}, "a sum over other stars"),
        ({"judges": (Judge("any", lambda star: float(star[0]), greatest=nan),)}, "at most nan"),
        ({"ask": Best(3), "objectives": (of(couple(SEVEN, 1)), of(couple(SEVEN, 2)))}, "has one objective"),
        ({"ask": Best(3), "objectives": ()}, "by nothing"),
    ],
)
def test_questions_that_cannot_be_are_refused(changes, told):
    plain = Question(SEVEN, (of(couple(SEVEN, 1)),))
    with pytest.raises(SearchError, match=told):
        replace(plain, **changes)


@pytest.mark.parametrize("star", [(0, 1, 2), (0, 1, 2, 3, 4, 5, 9_999_999), (0, 1, 2, 3, 4, 5, 5)])
def test_what_is_no_star_has_no_neighbours(star):
    with pytest.raises(SearchError, match="the star"):
        succeeding(SEVEN, star)


def test_every_mistake_of_the_stars_is_told():
    with pytest.raises(SearchError) as told:
        Stars(7, "two-stroke", (Fraction(1),), fixed=((9, 0), (1, 9)))
    assert len(told.value.faults) == 3


@pytest.mark.parametrize(("function", "told"), [(lambda _: nan, "finite"), (lambda _: 1 / 0, "ZeroDivisionError")])
def test_a_function_that_fails_is_named_with_its_star(function, told):
    asked = Question(SEVEN, (), limits=(Limit(couple(SEVEN, 1), 1.0),), judges=(Judge("mine", function),))
    with pytest.raises(SearchError, match=f"mine.*{told}"):
        findings(asked)


def test_least_lengths_leave_out_what_is_shorter():
    rows = exhaustive.stars(7, 1)
    sizes = exhaustive.lengths(rows, exhaustive.arms(7), 1, 7)
    asked = Question(SEVEN, (of(couple(SEVEN, 1)),), (Limit(couple(SEVEN, 1), 5.0, 3.0),), ask=All())
    assert findings(asked).stars == ((sizes >= 3.0) & (sizes <= 5.0)).sum()


def test_a_class_of_many_stars_within_wide_limits_is_listed_alone():
    eleven = stars(11)
    same = Likeness((couple(eleven, 1), couple(eleven, 2)), tuple(range(11)))
    found = chosen(findings(question(eleven, same, ())), same)
    assert (found.stars, len(found.rows)) == (2, 1)


def test_a_question_without_objectives_lists_what_keeps_the_limits():
    found = findings(Question(SEVEN, (), (Limit(couple(SEVEN, 1), 0.3),), neighbours_at_most=inf, ask=All()))
    assert {row.values for row in found.rows} == {()}
    assert Objective("none").terms == ()
