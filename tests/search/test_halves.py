"""The size of a search is counted before it starts; beyond memory it is refused."""

import time

import pytest
from tests.search.asked import every_kind, front, space

from crankstar.search import estimates
from crankstar.search.faults import SearchError
from crankstar.search.halves import check, halves
from crankstar.search.question import Question
from crankstar.search.run import searched
from crankstar.search.sums import couple, of

FIXED = [
    Question(space(n, cycle, fixed=fixed), (of(couple(space(n, cycle), 1)),))
    for n, cycle, fixed in [
        (8, "two-stroke", ((1, 0), (4, 3))),
        (10, "four-stroke", ((2, 1),)),
        (12, "four-stroke", ((1, 0), (2, 0))),
    ]
]


@pytest.mark.parametrize("question", [*every_kind().values(), *FIXED, front(2), front(3)])
def test_there_are_as_many_blocks_as_are_counted_and_they_hold_all_stars(question):
    ready = halves(question)
    n = question.stars.directions
    assert len(ready.blocks) == ready.block_count
    assert (ready.blocks[:, :n] + ready.blocks[:, n:-1] == ready.counts).all()
    assert len({row[:n].tobytes() for row in ready.blocks}) == len(ready.blocks)
    outers, inners = (ready.blocks[:, part] for part in (slice(0, n), slice(n, -1)))
    stars = sum(
        int(times) * _rows(outer) * _rows(inner)
        for outer, inner, times in zip(outers, inners, ready.blocks[:, -1], strict=True)
    )
    assert stars == question.stars.count
    assert ready.outer_rows == max(map(_rows, outers))
    assert ready.inner_rows == max(map(_rows, inners))


def _rows(share):
    rows, left = 1, int(share.sum())
    for count in share.tolist():
        for k in range(count):
            rows = rows * (left - k) // (k + 1)
        left -= count
    return rows


@pytest.mark.parametrize(
    ("cylinders", "cycle", "fixed"),
    [(21, "two-stroke", 2), (22, "two-stroke", 3), (24, "two-stroke", 5), (24, "four-stroke", 5)],
)
def test_halves_beyond_memory_are_refused_at_once_with_ways_out(cylinders, cycle, fixed):
    stars = space(cylinders, cycle)
    question = Question(stars, (of(couple(stars, 1)),))
    began = time.monotonic()
    with pytest.raises(
        SearchError, match=f"4,000,000 can be held at once. Fix at least {fixed} throws"
    ) as told:
        searched(question)
    assert time.monotonic() - began < 1
    assert ("symmetric" in str(told.value)) == (cycle == "four-stroke")
    throws = tuple((k + 1, k % stars.directions) for k in range(fixed))
    check(Question(space(cylinders, cycle, fixed=throws), question.objectives))


@pytest.mark.parametrize("cylinders", [16, 20, 24])
def test_an_estimate_is_made_in_short_time_and_grows_with_the_question(cylinders):
    estimates.estimate(front(8))
    began = time.monotonic()
    seconds = estimates.estimate(front(cylinders))
    assert time.monotonic() - began < 5
    assert seconds > 5 * estimates.estimate(front(cylinders - 2))
    assert estimates.memory(front(cylinders)) > estimates.memory(front(cylinders - 2)) > 150e6
    assert estimates.memory(front(16)) < 500e6
