"""The nearest place outside of circles: against a fine grid, and where `balance` puts a shaft."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from tests.commands import Run

from crankstar.files.catalog import load
from crankstar.remedy import clashes
from crankstar.remedy.clear_places import Box, Circle, nearest_clear

PLACES = st.floats(-4, 4)
STEPS = 161


@st.composite
def boxes(draw: st.DrawFn) -> Box:
    """A box, perhaps a line or a point."""
    up, right = (sorted([draw(PLACES), draw(PLACES)]) for _ in range(2))
    return Box((up[0], up[1]), (right[0], right[1]))


@example(wanted=0.3 + 0.4j, box=Box((-4, 4), (-4, 4)), circles=[Circle(0j, 2.0)])
@example(wanted=0.1 + 0j, box=Box((-4, 4), (-4, 4)), circles=[Circle(0j, 2.0), Circle(1 + 1j, 2.0)])
@given(
    wanted=st.builds(complex, PLACES, PLACES),
    box=boxes(),
    circles=st.lists(
        st.builds(Circle, st.builds(complex, PLACES, PLACES), st.floats(0.1, 4)), max_size=3
    ),
)
def test_no_place_of_a_fine_grid_is_nearer(
    wanted: complex, box: Box, circles: list[Circle]
) -> None:
    up, right = (np.linspace(*span, STEPS) for span in box)
    grid = (up[:, None] + 1j * right).ravel()
    clear = np.all([abs(grid - c.centre) >= c.radius for c in circles], axis=0) | ~np.any(
        [abs(grid - c.centre) < c.radius for c in circles] or [np.zeros(grid.size, bool)], axis=0
    )
    found = nearest_clear(wanted, box, circles)
    if found is None:
        assert not clear.any()
        return
    assert box.up[0] - 1e-7 <= found.real <= box.up[1] + 1e-7
    assert box.right[0] - 1e-7 <= found.imag <= box.right[1] + 1e-7
    assert all(abs(found - c.centre) >= c.radius - 1e-7 for c in circles)
    if clear.any():
        assert abs(found - wanted) <= abs(grid[clear] - wanted).min() + 1e-7


@pytest.mark.parametrize("box", ["-3..3, -3..3", "-2..-0.5, 0..4"])
def test_balance_keeps_a_single_shaft_clear_where_its_box_allows(
    box: str, run: Run, tmp_path: Path
) -> None:
    place = str(tmp_path / "twin.toml")
    printed = run(
        "balance", "i2-360", "--factor", "0.5", "--shafts", "-1", "--box", box, "-o", place
    )
    assert printed.code == 0
    assert clashes(load(place)) == ()
    assert "Less would remain with" in " ".join(printed.out.split())


def test_a_box_without_a_clear_place_is_kept_and_said(run: Run, tmp_path: Path) -> None:
    place = str(tmp_path / "twin.toml")
    words = ("--factor", "0.5", "--shafts", "-1", "--box", "-1..1, -1..1")
    printed = run("balance", "i2-360", *words, "-o", place)
    assert "would be inside what that crankshaft sweeps" in " ".join(printed.out.split())
    assert [clash.crank for clash in clashes(load(place))] == [True]


@pytest.mark.release
def test_a_place_has_one_roll_over_the_ranges_of_estimates(run: Run) -> None:
    """The sentence and the table tell the range of the same shaft at the same place."""
    words = ("--estimate", "--factor", "0.5", "--shafts", "-1", "--box", "-110..-60 mm, 40..100 mm")
    printed = " ".join(run("balance", "bmw-f800", *words).out.split())
    told = printed.split("clear of cranks and other shafts, is about ")[1].split(" N m")[0]
    row = printed.split("Remaining unbalance")[1].split("1 rolling moment without gas N m ")[1]
    assert row.split(")")[1].strip() == told.removesuffix(", estimated)")
