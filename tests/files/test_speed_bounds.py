"""Ranges of speeds have one limit in all commands, and the bounds of a single speed."""

from __future__ import annotations

from typing import Any

import pytest
from tests.commands import Run

import crankstar
from crankstar.studies.sweep import watched
from crankstar.tables import over_speeds

TOO_MANY = "600..6000 rpm/2001"


@pytest.mark.parametrize("command", ["analyze", "mounts", "torsion"])
def test_as_many_speeds_as_anywhere(command: str, run: Run) -> None:
    told = run(command, "i4", "--speeds", TOO_MANY)
    assert told.code == 2
    assert told.err.strip() == f"crankstar: --speeds {TOO_MANY}: give up to 2000 speeds"


@pytest.mark.parametrize("command", ["analyze", "mounts", "torsion"])
def test_a_range_begins_where_a_speed_may(command: str, run: Run) -> None:
    """The least is 1e-7 rad/s, below 1e-6 rpm (1.05e-7 rad/s)."""
    told = run(command, "i4", "--speeds", "1e-300..1e-299 rpm/3")
    assert "1e-300 rpm, too small for an engine; give one such as 6000 rpm" in told.err
    with pytest.raises(ValueError, match="too small for an engine"):
        crankstar.sweep("i4", "speed=9e-7..1 rpm/2")
    assert crankstar.sweep("i4", "speed=1e-6..1 rpm/2").values[0] == 1e-6


def test_a_long_range_asks_for_each_curve_no_more_often(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its unit was looked up anew for each of 2000 speeds: two minutes."""
    asked: list[str] = []

    def counted(sweep: Any, what: str, **more: Any) -> Any:
        asked.append(what)
        return watched(sweep, what, **more)

    monkeypatch.setattr(over_speeds, "watched", counted)
    numbers: list[int] = []
    for count in (3, 30):
        asked.clear()
        assert run("analyze", "i4", "--speeds", f"600..6000 rpm/{count}", "--json").code == 0
        numbers.append(len(asked))
    assert numbers[0] == numbers[1] > 0
