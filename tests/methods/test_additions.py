"""Cosines of one direction added as by hand: what a closed polygon is said to be."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from crankstar.derive.addition import Term, addition

pytestmark = pytest.mark.quick


@pytest.mark.parametrize("opposite", [(), (2,), (1, 3), (1, 2, 3)])
def test_a_vector_of_negative_weight_is_counted_the_other_way_round(
    opposite: tuple[int, ...],
) -> None:
    """-cos(theta + phase) is cos(theta + phase + pi): three vectors at 120 deg, however written."""
    terms = [
        Term(
            number,
            {(): Fraction(-1 if number in opposite else 1)},
            Fraction(number, 3) + Fraction(number in opposite, 2),
        )
        for number in (1, 2, 3)
    ]
    weights = np.array([float(term.weight[()]) for term in terms])
    vectors = weights * np.exp(2j * np.pi * np.array([float(term.phase) for term in terms]))
    apart = np.angle(np.roll(vectors, -1) / vectors, deg=True)
    assert apart == pytest.approx(120)
    found = addition(terms, Fraction(1), moments=False)
    assert found.wave == {}
    assert abs(vectors.sum()) < 1e-15
    assert len(found.notes) == 1
    assert "1, 2, 3 are equally long and 120° apart" in found.notes[0]
