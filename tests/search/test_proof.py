"""Zeros and equal lengths of many stars in whole numbers are those of exact numbers."""

from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from tests import exhaustive

from crankstar.stars import proof
from crankstar.stars.answer import answer_to
from crankstar.stars.equivalence import Equivalence, equivalent, question
from crankstar.stars.star import Stars
from crankstar.stars.sums import VectorSum, couple, torsion


@pytest.mark.many(first=2)
@pytest.mark.parametrize("cylinders", [5, 6, 8])
def test_zeros_of_many_stars_are_those_of_one_at_a_time(cylinders):
    stars = Stars(cylinders, "two-stroke", exhaustive.halves(cylinders))
    rows = [tuple(row) for row in exhaustive.stars(cylinders, 1).tolist()][::7]
    for order in (1, 2, 3):
        vector = couple(stars, order)
        assert proof.vanishing(vector, rows).tolist() == [vector.exact(row).zero for row in rows]


@pytest.mark.many(first=2)
@pytest.mark.parametrize("cylinders", [5, 6, 7])
def test_equal_lengths_of_many_stars_are_those_of_one_at_a_time(cylinders):
    stars = Stars(cylinders, "four-stroke", exhaustive.halves(cylinders))
    rows = [tuple(row) for row in exhaustive.stars(stars.directions, stars.sharing).tolist()][:40]
    vector = couple(stars, 1)
    keys = [tuple(row) for row in proof.squares(vector, rows).tolist()]
    exact = [vector.exact(row) for row in rows]
    for one, other in combinations(range(len(rows)), 2):
        same = (exact[one] * exact[one].conjugate - exact[other] * exact[other].conjugate).zero
        assert (keys[one] == keys[other]) == same


def test_weights_beyond_64_bits_are_added_up_exactly():
    weights = tuple(Fraction(10**12 + number, 7) for number in range(6))
    vector = VectorSum("big", Fraction(1), weights, tuple(Fraction(d, 6) for d in range(6)))
    rows = [tuple(row) for row in exhaustive.stars(6, 1).tolist()]
    assert proof.vanishing(vector, rows).tolist() == [vector.exact(row).zero for row in rows]
    assert len(set(proof.alike([vector], rows).tolist())) == len(
        {exact_square(vector, row) for row in rows}
    )


def exact_square(vector, row):
    exact = vector.exact(row)
    return (exact * exact.conjugate).key


@pytest.mark.many(first=2)
@pytest.mark.parametrize("cylinders", [6, 7, 8])
def test_all_stars_alike_are_those_of_all_permutations(cylinders):
    stars = Stars(cylinders, "two-stroke", exhaustive.halves(cylinders))
    rows = exhaustive.stars(cylinders, 1)
    lengths = [
        exhaustive.lengths(rows, exhaustive.arms(cylinders), order, cylinders) for order in (1, 2)
    ]
    for place in range(0, len(rows), len(rows) // 6):
        star = tuple(rows[place].tolist())
        same = Equivalence((couple(stars, 1), couple(stars, 2)), star)
        found = equivalent(answer_to(question(stars, same, ())), same)
        wanted = np.logical_and.reduce(
            [np.abs(column - column[place]) < 1e-9 for column in lengths]
        )
        assert found.stars == wanted.sum()
        assert found.rows[0].star == star
        assert {exhaustive.image_class(row.star, cylinders, ends=True) for row in found.rows} == {
            exhaustive.image_class(row, cylinders, ends=True) for row in rows[wanted].tolist()
        }


def test_torsion_of_half_orders_is_exact_too():
    stars = Stars(5, "four-stroke", exhaustive.halves(5))
    even = torsion(stars, order=Fraction(1, 2), shape=[Fraction(1)] * 5)
    rows = [tuple(row) for row in exhaustive.stars(5, 1).tolist()]
    assert proof.vanishing(even, rows).all()
