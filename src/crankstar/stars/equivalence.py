"""All stars with the same moments, among which engineers choose by other criteria.

Two stars are alike if each of some sums is equally long for both, decided in whole numbers
(`proof`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from crankstar.stars import proof
from crankstar.stars.question import All, Question
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import SAME, Limit, Objective, VectorSum

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer

SLACK = 1e-7
"""Share of a length by which the limits of the search are opened; equality is decided exactly."""


@dataclass(frozen=True)
class Equivalence:
    """Stars whose sums are exactly as long as those of a star, or near given lengths."""

    sums: tuple[VectorSum, ...]
    star: Star | None = None
    near: tuple[tuple[float, float], ...] = ()


def question(stars: Stars, wanted_sums: Equivalence, objectives: Sequence[Objective]) -> Question:
    """The question that has all of them in its answer: no sum is longer or shorter than wanted.

    >>> from fractions import Fraction
    >>> from crankstar.stars.answer import answer_to
    >>> from crankstar.stars.sums import couple
    >>> seven = Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7)))
    >>> same = Equivalence((couple(seven, 1), couple(seven, 2)), star=(0, 2, 5, 3, 4, 1, 6))
    >>> equivalent(answer_to(question(seven, same, ())), same).stars
    4
    """
    star = wanted_sums.star
    wanted = (
        wanted_sums.near
        if star is None
        else [(vector.length(star), 0.0) for vector in wanted_sums.sums]
    )
    limits = tuple(
        Limit(vector, length + off + SLACK * length, max(0.0, length - off - SLACK * length))
        for vector, (length, off) in zip(wanted_sums.sums, wanted, strict=True)
    )
    return Question(stars, tuple(objectives), limits, ask=All())


def equivalent(answer: Answer, wanted_sums: Equivalence) -> Answer:
    """The answer with only the equivalent stars: first the one asked for, not its mirror image."""
    rows = [row for row in answer.rows if _near(row.star, wanted_sums)]
    if wanted_sums.star is not None and rows:
        kinds = proof.alike(wanted_sums.sums, [wanted_sums.star, *(row.star for row in rows)])
        rows = [row for row, kind in zip(rows, kinds[1:], strict=True) if kind == kinds[0]]
        own, images = wanted_sums.star, answer.question.images
        asked = images(own)
        rows = [replace(row, star=own) if images(row.star) == asked else row for row in rows]
        rows.sort(key=lambda row: row.star != own)
    return replace(answer, rows=tuple(rows), stars=sum(row.stars for row in rows))


def _near(star: Star, wanted_sums: Equivalence) -> bool:
    lengths = [vector.length(star) for vector in wanted_sums.sums] if wanted_sums.near else []
    return all(
        abs(length - wanted) <= off + SAME
        for length, (wanted, off) in zip(lengths, wanted_sums.near, strict=True)
    )
