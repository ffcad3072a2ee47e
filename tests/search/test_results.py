"""What was found in parts is the same whole, in whatever parts and order it comes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crankstar.stars import results
from crankstar.stars.question import All, Best, Front
from crankstar.stars.results import Results

ASKS = [Front(), Front(2), Front(1), Best(1), Best(5), All(), All(4)]


@st.composite
def finds(draw):
    """Rows as blocks give them: repeated stars, few different values, off by rounding."""
    star = st.tuples(*[st.integers(0, 4)] * 4)
    known = draw(st.lists(star, min_size=5, max_size=30, unique=True))
    grid = st.sampled_from([(0, 2), (1, 1), (2, 0), (2, 2), (1, 2)])
    noise = st.tuples(st.integers(-3, 3), st.integers(-3, 3))
    values = [np.array(draw(grid)) / 3 + np.array(draw(noise)) * 1e-14 for _ in known]
    times = [draw(st.integers(1, 2)) for _ in known]
    which = draw(st.lists(st.integers(0, len(known) - 1), min_size=5, max_size=60))
    return [(known[k], values[k], times[k]) for k in which]


def part(rows):
    return Results(
        np.array([value for _, value, _ in rows]).reshape(-1, 2),
        np.array([star for star, _, _ in rows], np.int8).reshape(-1, 4),
        np.array([2 * times for _, _, times in rows], np.int64),
        np.array([times for _, _, times in rows], np.int64),
        len(rows),
    )


def plain(found):
    return [
        found.values.tolist(),
        found.stars.tolist(),
        found.classes.tolist(),
        found.times.tolist(),
        found.met,
        found.beyond,
    ]


@pytest.mark.parametrize("ask", ASKS)
@given(rows=finds(), data=st.data())
def test_any_parts_in_any_order_make_the_same_whole(ask, rows, data):
    whole = results.merged([part(rows)], ask)
    shuffled = data.draw(st.permutations(rows))
    cuts = sorted(data.draw(st.lists(st.integers(0, len(rows)), max_size=5)))
    parts = [part(shuffled[a:b]) for a, b in zip([0, *cuts], [*cuts, len(rows)], strict=True)]
    out = parts[0]
    for new in parts[1:]:
        out = results.merged([out, new], ask)
    assert plain(results.merged([out], ask)) == plain(whole)
    right = parts[-1]
    for new in reversed(parts[:-1]):
        right = results.merged([new, results.merged([right], ask)], ask)
    assert plain(results.merged([right, results.nothing(2, 4)], ask)) == plain(whole)


@pytest.mark.release
@given(rows=finds(), examples=st.integers(1, 3))
def test_a_front_has_what_nothing_betters_and_counts_all_of_it(rows, examples):
    found = results.merged([part(rows)], Front(examples))
    points = {tuple(np.round(value * 3).astype(int).tolist()) for _, value, _ in rows}
    best = {p for p in points if not any(q != p and q[0] <= p[0] and q[1] <= p[1] for q in points)}
    counts = dict.fromkeys(best, 0)
    for _, value, times in rows:
        point = tuple(np.round(value * 3).astype(int).tolist())
        if point in best:
            counts[point] += times
    got = {
        tuple(np.round(found.values[g[0]] * 3).astype(int).tolist()): int(found.times[g].sum())
        for g in results.groups(found)
    }
    assert got == counts
    assert all(len(group) <= examples for group in results.groups(found))


@given(rows=finds())
def test_a_list_counts_what_it_does_not_keep(rows):
    found = results.merged([part(rows)], All(3))
    assert len(found) == min(3, len({star for star, _, _ in rows}))
    assert int(found.times.sum()) + found.beyond == sum(times for _, _, times in rows)


@pytest.mark.many(first=4)
@pytest.mark.parametrize("ask", ASKS)
@given(rows=finds(), data=st.data())
def test_a_wider_search_that_was_stopped_adds_only_what_is_new(ask, rows, data):
    whole = results.merged([part(rows)], ask)
    again = [rows[k] for k in data.draw(st.lists(st.integers(0, len(rows) - 1), max_size=20))]
    seen = results.best_so_far(whole, results.merged([part(again)], ask), ask)
    if not isinstance(ask, All):  # a list has no wider search
        assert plain(seen)[:4] == plain(whole)[:4]


@pytest.mark.release
@given(rows=finds())
def test_a_harvest_is_the_same_after_it_was_written(rows):
    found = results.merged([part(rows)], All(5))
    assert plain(results.from_json(results.as_json(found), 2, 4)) == plain(found)
