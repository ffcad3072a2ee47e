"""All stars with the same moments: engineers choose among them by what the moments do not tell.

Two stars are alike if each of some sums is equally long for both, which is decided in whole numbers (`proof`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from crankstar.search import proof
from crankstar.search.findings import Findings
from crankstar.search.kernels import SAME
from crankstar.search.question import All, Question
from crankstar.search.stars import Star, Stars
from crankstar.search.sums import Limit, Objective, VectorSum

SLACK = 1e-7
"""Share of a length by which the limits of the search are opened; what is alike is decided exactly."""


@dataclass(frozen=True)
class Likeness:
    """Which stars are wanted: those whose sums are as long as those of a star, exactly; or within so much of given lengths."""

    sums: tuple[VectorSum, ...]
    star: Star | None = None
    near: tuple[tuple[float, float], ...] = ()


def question(stars: Stars, likeness: Likeness, objectives: Sequence[Objective]) -> Question:
    """The question that has all of them in its answer: no sum is longer or shorter than wanted.

    >>> from fractions import Fraction
    >>> from crankstar.search.findings import findings
    >>> from crankstar.search.sums import couple
    >>> seven = Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7)))
    >>> same = Likeness((couple(seven, 1), couple(seven, 2)), star=(0, 2, 5, 3, 4, 1, 6))
    >>> chosen(findings(question(seven, same, ())), same).stars
    4
    """
    star = likeness.star
    wanted = likeness.near if star is None else [(vector.length(star), 0.0) for vector in likeness.sums]
    limits = tuple(
        Limit(vector, length + off + SLACK * length, max(0.0, length - off - SLACK * length))
        for vector, (length, off) in zip(likeness.sums, wanted, strict=True)
    )
    return Question(stars, tuple(objectives), limits, ask=All())


def chosen(answer: Findings, likeness: Likeness) -> Findings:
    """Those of the answer that are wanted."""
    rows = [row for row in answer.rows if _near(row.star, likeness)]
    if likeness.star is not None and rows:
        kinds = proof.alike(likeness.sums, [likeness.star, *(row.star for row in rows)])
        rows = [row for row, kind in zip(rows, kinds[1:], strict=True) if kind == kinds[0]]
    return replace(answer, rows=tuple(rows), stars=sum(row.stars for row in rows))


def _near(star: Star, likeness: Likeness) -> bool:
    lengths = [vector.length(star) for vector in likeness.sums] if likeness.near else []
    return all(abs(length - wanted) <= off + SAME for length, (wanted, off) in zip(lengths, likeness.near, strict=True))
