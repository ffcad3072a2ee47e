"""Crank stars: fronts, lists and counts are those of all permutations; zeros are proved."""

from fractions import Fraction
from itertools import pairwise, permutations
from typing import Any

import numpy as np
import pytest
from tests import exhaustive

from crankstar.stars.answer import answer_to, succeeding
from crankstar.stars.question import All, Best, Front, FunctionObjective, Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, Objective, couple, force, neighbours, of, torsion

CASES = [(n, "two-stroke") for n in range(2, 9)] + [
    (n, "four-stroke") for n in (2, 3, 4, 5, 6, 7, 8, 10)
]


def space(cylinders, cycle: Any = "two-stroke", **more):
    return Stars(cylinders, cycle, exhaustive.halves(cylinders), **more)


def rows(stars):
    return exhaustive.stars(stars.directions, stars.sharing)


def sizes(stars, order):
    return exhaustive.lengths(
        rows(stars), exhaustive.arms(stars.cylinders), order, stars.directions
    )


def rounded(findings_):
    return {
        tuple(round(value, 6) + 0.0 for value in row.values): row.stars for row in findings_.rows
    }


@pytest.mark.parametrize(("cylinders", "cycle"), CASES)
def test_stars_and_their_classes_are_as_many_as_permutations_show(cylinders, cycle):
    stars = space(cylinders, cycle)
    found = rows(stars)
    assert stars.count == len(found)
    assert stars.classes(reversed_=False) == exhaustive.classes(found, stars.directions, ends=False)
    assert stars.classes() == exhaustive.classes(found, stars.directions, ends=True)


@pytest.mark.many(first=48)
@pytest.mark.parametrize(("cylinders", "cycle"), CASES)
@pytest.mark.parametrize("orders", [(1, 2), (1, 3), (2,), (1, 2, 3)])
def test_the_front_and_its_counts_are_those_of_all_permutations(cylinders, cycle, orders):
    stars = space(cylinders, cycle)
    found = answer_to(Question(stars, tuple(of(couple(stars, order)) for order in orders)))
    assert found.certificate.complete
    assert rounded(found) == exhaustive.front(*(sizes(stars, order) for order in orders))


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("cylinders", "cycle"),
    [(7, "two-stroke"), (8, "two-stroke"), (7, "four-stroke"), (8, "four-stroke")],
)
def test_the_front_with_neighbours_in_succession_is_that_of_all_permutations(cylinders, cycle):
    stars = space(cylinders, cycle)
    beside = np.array(
        [
            exhaustive.neighbours(row, directions=stars.directions, step=stars.step)
            for row in rows(stars).tolist()
        ]
    )
    found = answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2)), neighbours())))
    assert rounded(found) == exhaustive.front(sizes(stars, 1), sizes(stars, 2), beside)


def test_unequal_pitches_lose_the_symmetry_of_the_ends_and_nothing_else():
    places = tuple(Fraction(text) for text in ("3.2", "2.2", "1.2", "-0.8", "-1.8", "-2.8", "-3.8"))
    stars = Stars(7, "two-stroke", places)
    found = answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2)))))
    arms = np.array([float(place) for place in places])
    wanted = exhaustive.front(
        *(exhaustive.lengths(rows(stars), arms, order, 7) for order in (1, 2))
    )
    assert rounded(found) == wanted
    assert stars.classes() == exhaustive.classes(rows(stars), 7, ends=False)


@pytest.mark.parametrize("count", [1, 7, 40])
@pytest.mark.parametrize(("cylinders", "cycle"), [(7, "two-stroke"), (8, "four-stroke")])
def test_the_best_are_the_first_of_all_classes(count, cylinders, cycle):
    stars = space(cylinders, cycle)
    objective = Objective("both", ((1.0, couple(stars, 1)), (2.0, couple(stars, 2))))
    found = answer_to(Question(stars, (objective,), ask=Best(count)))
    values = np.sqrt(sizes(stars, 1) ** 2 + 4 * sizes(stars, 2) ** 2)
    every = {
        exhaustive.image_class(row, stars.directions, ends=True): value
        for row, value in zip(rows(stars).tolist(), values, strict=True)
    }
    assert [row.values[0] for row in found.rows] == pytest.approx(
        sorted(every.values())[:count], abs=1e-9
    )
    assert len({row.star for row in found.rows}) == min(count, len(every))
    assert all(every[row.star] == pytest.approx(row.values[0], abs=1e-9) for row in found.rows)


def test_limits_leave_what_keeps_them():
    stars = space(8)
    question = Question(
        stars,
        (of(couple(stars, 1)),),
        limits=(Limit(couple(stars, 2), 3.0),),
        neighbours_at_most=1,
        ask=All(),
    )
    found = answer_to(question)
    beside = np.array(
        [exhaustive.neighbours(row, directions=8, step=1) for row in rows(stars).tolist()]
    )
    good = (sizes(stars, 2) <= 3.0) & (beside <= 1)
    assert found.stars == sum(row.stars for row in found.rows) == good.sum()
    assert {row.star for row in found.rows} == {
        exhaustive.image_class(row, 8, ends=True) for row in rows(stars)[good].tolist()
    }
    assert all(one.values[0] <= other.values[0] + 1e-12 for one, other in pairwise(found.rows))


def test_fixed_throws_stay_and_the_rest_is_counted_without_symmetry():
    stars = space(7, fixed=((1, 0), (4, 3)))
    found = answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2)))))
    every = np.array([row for row in permutations(range(7)) if row[0] == 0 and row[3] == 3])
    columns = [exhaustive.lengths(every, exhaustive.arms(7), order, 7) for order in (1, 2)]
    assert stars.count == len(every)
    assert rounded(found) == exhaustive.front(*columns)
    assert all(
        star[0] == 0 and star[3] == 3 for row in found.rows for star in (row.star, *row.like)
    )


def test_symmetric_cranks_have_no_couples_and_are_judged_by_the_rest():
    stars = space(8, "four-stroke", symmetric=True)
    found = answer_to(Question(stars, (neighbours(),), ask=All()))
    every = [row for row in rows(stars).tolist() if row == row[::-1]]
    assert found.stars == len(every) == 6
    wanted = sorted(exhaustive.neighbours(row, directions=4, step=0) for row in every)
    assert sorted(row.neighbours for row in found.rows for _ in range(row.stars)) == wanted


def test_torsional_sums_follow_the_firing_angles():
    shape = [Fraction(n, 10) for n in (10, 9, 7, 4, 0, -5, -9)]
    for cycle, order in (("two-stroke", Fraction(3)), ("four-stroke", Fraction(5, 2))):
        stars = space(7, cycle)
        found = answer_to(
            Question(stars, (of(torsion(stars, order=order, shape=shape)), of(couple(stars, 1))))
        )
        angles = {
            d: k / 7 * (1 if cycle == "two-stroke" else 2)
            for k, d in enumerate(k * stars.step % 7 for k in range(7))
        }
        turned = np.array([[angles[d] for d in row] for row in rows(stars).tolist()]) * 7
        driven = exhaustive.lengths(turned, [float(x) for x in shape], float(order), 7)
        assert rounded(found) == exhaustive.front(driven, sizes(stars, 1))


def test_a_python_function_judges_too():
    stars = space(7)

    def spread(star):
        return float(abs(star[0] - star[6]))

    found = answer_to(
        Question(
            stars,
            (of(couple(stars, 1)),),
            functions=(FunctionObjective("spread", spread),),
            limits=(Limit(couple(stars, 2), 4.0),),
        )
    )
    good = sizes(stars, 2) <= 4.0
    wanted = exhaustive.front(
        sizes(stars, 1)[good], np.array([spread(row) for row in rows(stars)[good].tolist()])
    )
    assert rounded(found) == wanted


def test_forces_of_evenly_spaced_throws_vanish_but_for_multiples_of_their_number():
    stars = space(6)
    for order in range(1, 13):
        found = answer_to(Question(stars, (of(force(stars, order)),), ask=Best(3)))
        assert {row.values[0] for row in found.rows} == ({0.0} if order % 6 else {6.0})


@pytest.mark.parametrize("cycle", ["two-stroke", "four-stroke"])
def test_neighbours_in_succession_are_counted_as_in_a_list(cycle):
    for cylinders in range(3, 9):
        stars = space(cylinders, cycle)
        for row in rows(stars)[::7].tolist():
            assert succeeding(stars, tuple(row)) == exhaustive.neighbours(
                row, directions=stars.directions, step=stars.step
            )


def test_six_cylinders_without_first_order_have_at_least_2_root_3_of_the_second_and_one_star():
    stars = space(6)
    front = answer_to(
        Question(stars, (of(couple(stars, 2)),), limits=(Limit(couple(stars, 1), 0),))
    )
    (row,) = front.rows
    assert row.values[0] == pytest.approx(2 * 3**0.5, abs=1e-12)
    assert (row.classes, row.stars) == (1, 2)
    every = answer_to(
        Question(stars, (of(couple(stars, 2)),), limits=(Limit(couple(stars, 1), 0),), ask=All())
    )
    assert sum(
        couple(stars, 1).exact(star).zero for row in every.rows for star in [row.star]
    ) == len(every.rows)


def test_the_front_of_seven_is_the_published_one():
    stars = space(7)
    found = answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2)))))
    wanted = [(0.0765, 9.149), (0.2673, 1.0056), (2.1937, 0.8223), (3.7808, 0.0765)]
    assert [row.values for row in found.rows] == [
        pytest.approx(point, abs=5e-4) for point in wanted
    ]


def test_96_of_5040_stars_of_eight_have_no_second_order_and_0_4483_is_the_least_first():
    stars = space(8)
    assert stars.count == 5040
    found = answer_to(
        Question(stars, (of(couple(stars, 1)),), limits=(Limit(couple(stars, 2), 0),), ask=All())
    )
    assert found.stars == 96
    assert found.rows[0].values[0] == pytest.approx((20 - 14 * 2**0.5) ** 0.5, abs=1e-12)


def test_what_cannot_be_is_proved_not_to_be():
    stars = space(6)
    limits = (Limit(couple(stars, 1), 0), Limit(couple(stars, 2), 3.0))
    for ask in (Front(), Best(3), All()):
        found = answer_to(Question(stars, (of(couple(stars, 3)),), limits=limits, ask=ask))
        assert found.contradicted


@pytest.mark.parametrize("ask", [Front(), Best(5), All()])
@pytest.mark.parametrize(
    ("cylinders", "cycle"),
    [(6, "two-stroke"), (8, "two-stroke"), (7, "four-stroke"), (8, "four-stroke")],
)
def test_the_certificate_counts_the_stars_in_its_strips(cylinders, cycle, ask):
    stars = space(cylinders, cycle)
    objectives = (
        (of(couple(stars, 1)), of(couple(stars, 2)))
        if isinstance(ask, Front)
        else (of(couple(stars, 1)),)
    )
    limits = (Limit(couple(stars, 2), 2.5),) if isinstance(ask, All) else ()
    proof = answer_to(Question(stars, objectives, limits, ask=ask)).certificate
    inside = np.zeros(stars.count, bool)
    for vector, length in proof.regions:
        inside |= sizes(stars, int(vector.name[1:])) <= length
    assert (proof.met, proof.of) == (inside.sum(), stars.count)
