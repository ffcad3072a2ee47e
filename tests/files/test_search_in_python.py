"""`crankstar.search`: the answer of the command as a function gives it, and what it refuses."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pandas
import pytest
from tests.commands import Run

import crankstar


def test_a_search_says_in_python_what_the_command_says(run: Run) -> None:
    found = crankstar.search(7, cycle="two-stroke", minimise=["M1", "M2"])
    printed = json.loads(
        run("search", "7", "--cycle", "two-stroke", "--minimise", "M1,M2", "--json").out
    )
    assert json.loads(json.dumps(found.to_dict())) == printed
    frame = found.to_frame()
    assert len(frame) == len(found) == len(printed["rows"])
    assert frame.attrs["certificate"]["complete"]
    orders = ["-".join(map(str, row["firing_order"])) for row in printed["rows"]]
    assert [*frame["firing_order"]] == orders


def test_the_moments_of_a_row_are_those_of_its_crank() -> None:
    """Sums over the throws by hand, and the couple of the engine that the row makes."""
    found = crankstar.search(6, cycle="two-stroke", minimise="M1,M2", fix={1: 0})
    assert isinstance(found.to_frame(), pandas.DataFrame)
    for place, row in enumerate(found.answer.rows[:3], 1):
        angles = -2 * np.pi * np.array(row.star) / 6
        places = np.arange(6) - 2.5
        by_hand = [abs((places * np.exp(1j * order * angles)).sum()) for order in (1, 2)]
        assert [*row.values] == pytest.approx(by_hand, abs=1e-9)
        couple = crankstar.total(crankstar.balance(found.to_engine(place), units="relative")).couple
        first = crankstar.spectra.selected(couple, 1)
        size = abs(first.forward).max() + abs(first.backward).max()
        assert size == pytest.approx(by_hand[0], rel=1e-6, abs=1e-9)


def test_an_engine_is_searched_in_its_own_units() -> None:
    found = crankstar.search("audi-25-tfsi", speed=100.0, best=3, minimise=["M2"])
    assert found.engine is not None
    assert [column for column in found.to_frame() if column.startswith("M2")] == ["M2_N_m"]
    fast = crankstar.search("audi-25-tfsi", speed=200.0, best=3, minimise=["M2"])
    ratios = [
        b.values[0] / a.values[0] for a, b in zip(found.answer.rows, fast.answer.rows, strict=True)
    ]
    assert ratios == pytest.approx([4.0] * 3)
    assert found.to_engine().name.startswith(found.engine.name)


@pytest.mark.parametrize(
    ("asked", "error", "said"),
    [
        ({"minimise": "Q7"}, ValueError, '"Q7"'),
        ({"best": 0}, ValueError, "best"),
        ({"workers": 0}, ValueError, "workers"),
        ({"cycle": "three"}, TypeError, "two-stroke"),
        ({"speed": 3.0}, TypeError, "speed"),
        ({"limit": {"M1": -1}}, ValueError, "limit"),
    ],
)
def test_what_cannot_be_searched_is_refused(
    asked: dict[str, Any], error: type[Exception], said: str
) -> None:
    with pytest.raises(error, match=said):
        crankstar.search(5, **asked)


def test_a_row_that_is_not_there_is_refused() -> None:
    found = crankstar.search(5, cycle="two-stroke")
    for wrong in (0, len(found) + 1):
        with pytest.raises(ValueError, match=str(wrong)):
            found.to_engine(wrong)
    with pytest.raises(ValueError, match="front, stars"):
        found.plot("rose")  # pyright: ignore[reportArgumentType]


def test_progress_is_told_to_the_end() -> None:
    noted: list[Any] = []
    found = crankstar.search(7, cycle="two-stroke", minimise=["M1"], tell=noted.append)
    assert noted
    assert noted[-1].done == noted[-1].blocks
    assert found.answer.certificate.complete
