"""The size of a search is counted before it starts; beyond memory it is refused."""

from types import SimpleNamespace

import pytest
from tests.search.asked import every_kind, front, space

from crankstar.stars import estimates, run
from crankstar.stars.faults import SearchError
from crankstar.stars.halves import check, halves
from crankstar.stars.question import Question
from crankstar.stars.regions import regions
from crankstar.stars.run import searched
from crankstar.stars.sums import couple, of

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
def test_halves_beyond_memory_are_refused_with_ways_out_before_they_are_formed(
    cylinders, cycle, fixed, monkeypatch
):
    stars = space(cylinders, cycle)
    question = Question(stars, (of(couple(stars, 1)),))
    monkeypatch.setattr(run, "halves", lambda _: pytest.fail("halves were formed"))
    with pytest.raises(
        SearchError, match=f"4,000,000 can be held at once. Fix at least {fixed} throws"
    ) as told:
        searched(question)
    assert ("symmetric" in str(told.value)) == (cycle == "four-stroke")
    throws = tuple((k + 1, k % stars.directions) for k in range(fixed))
    check(Question(space(cylinders, cycle, fixed=throws), question.objectives))


@pytest.mark.parametrize("cylinders", [16, 20, 24])
def test_an_estimate_times_few_blocks_and_grows_with_the_question(cylinders, monkeypatch):
    """By a clock that goes as far in every block as the cost of the block is reckoned."""
    clock = [0.0]

    def timed(part):
        ready = halves(part.question)
        share = (part.stop - part.start) / ready.block_count
        clock[0] += share * estimates.cost(part.question, ready, part.regions)

    monkeypatch.setattr(estimates, "results_of", timed)
    monkeypatch.setattr(estimates, "time", SimpleNamespace(perf_counter=lambda: clock[0]))
    monkeypatch.setattr(estimates, "_warm", lambda: None)
    seconds = estimates.estimate(front(cylinders))
    assert clock[0] < 2 * estimates.SAMPLE_SECONDS
    whole = halves(front(cylinders))
    cost = estimates.cost(front(cylinders), whole, regions(front(cylinders), whole))
    assert seconds == pytest.approx(cost)
    assert seconds > 5 * estimates.estimate(front(cylinders - 2))
    assert estimates.memory(front(cylinders)) > estimates.memory(front(cylinders - 2)) > 150e6
    assert estimates.memory(front(16)) < 500e6
