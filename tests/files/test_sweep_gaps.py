"""Values of a sweep that have no result leave a gap; the others stand."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.charts.contour_lines import level_lines
from crankstar.mechanics.gas import cycle
from crankstar.studies import best_value
from crankstar.studies.best_pair import best_pair, front
from crankstar.studies.best_value import best
from crankstar.studies.gas_results import one_by_one
from crankstar.studies.sweep import Curve, Sweep, sweep, watched
from crankstar.studies.variants import SweepError

PEAKED: dict[str, Any] = {"gas": {"peak_pressure": "60 bar"}}
OVER = "gas.peak_pressure=10..80 bar/15"
WORDS = ("sweep", "honda-b18c", "--set", 'gas={peak_pressure="60 bar"}', "--over", OVER)


def compressed(ratio: float = 10.0) -> float:
    """The peak (Pa) of compression alone, below which no load has its peak."""
    own = {"gas": {"imep": "9 bar", "compression_ratio": ratio}}
    return cycle(crankstar.load("honda-b18c", changes=own), motored=True).peak


@pytest.mark.release
def test_a_value_without_a_result_is_a_gap_and_the_others_are_as_before() -> None:
    made = sweep("honda-b18c", OVER, changes=PEAKED)
    curve = watched(made, "mean_torque")
    lost = made.values * 1e5 < compressed()
    assert 0 < lost.sum() < lost.size
    assert np.isnan(curve.values).tolist() == lost.tolist()
    assert [gap.place for gap in curve.gaps] == np.flatnonzero(lost).tolist()
    alone = watched(
        sweep("honda-b18c", "gas.peak_pressure=20..80 bar/13", changes=PEAKED), "mean_torque"
    )
    assert curve.values[~lost].tolist() == alone.values.tolist()
    assert curve.top == alone.values.max()
    least = best(made, curve)
    assert (least.value, least.result) == (20.0, alone.values[0])


def pairs() -> tuple[Sweep, Curve, Curve]:
    made = sweep("honda-b18c", [OVER, "gas.compression_ratio=8..12/3"], changes=PEAKED)
    return made, watched(made, "mean_torque"), watched(made, "peak_pressure")


def test_of_two_numbers_too_and_no_pair_of_the_front_is_in_a_gap() -> None:
    made, torque, peak = pairs()
    edges = [compressed(ratio) for ratio in made.axes[1].values]
    lost = made.axes[0].values[:, None] * 1e5 < np.array(edges)
    assert np.isnan(torque.values).tolist() == lost.tolist()
    for one in front(made, torque, peak):
        assert np.isfinite(one.results).all()
        assert one.values[0] * 1e5 >= compressed(one.values[1])


@pytest.mark.release
def test_the_best_pair_is_at_the_edge_of_the_gap() -> None:
    made, _torque, peak = pairs()
    pair = best_pair(made, peak)
    bar, ratio = pair.values
    assert bar * 1e5 >= compressed(ratio) * (1 - 1e-3)
    assert pair.result == pytest.approx(bar * 1e5, rel=1e-6)
    assert pair.result < np.nanmin(peak.values)


def test_where_no_value_has_a_result_there_is_no_sweep() -> None:
    none = sweep("honda-b18c", "gas.peak_pressure=5..9 bar/3", changes=PEAKED)
    with pytest.raises(SweepError, match=r"value 1 of 3: the load is 5 bar"):
        watched(none, "mean_torque")


@pytest.mark.release
def test_a_gap_is_blank_in_every_table_and_told_why(run: Run, tmp_path: Path) -> None:
    words = [*WORDS, "--quantity", "mean_torque,peak_pressure"]
    shown = run(*words)
    assert shown.code == 0, shown.err
    said = " ".join(shown.out.split())
    assert (
        "No mean_torque, peak_pressure at 2 of 15 values, from gas.peak_pressure = 10 bar" in said
    )
    [blank] = [line for line in shown.out.splitlines() if line.split() == ["10"]]
    assert blank.strip() == "10"
    told = json.loads(run(*words, "--json").out)
    assert [row["mean_torque"] for row in told["values"][:2]] == [None, None]
    assert told["values"][2]["mean_torque"] > 0
    assert told["doubts"][0].startswith("No mean_torque, peak_pressure at 2 of 15 values")
    table = run(*words, "--csv")
    assert table.out.splitlines()[1].endswith(",10.0,,mean_torque,axial,,N*m")
    assert "nan" not in table.out
    assert "No mean_torque" in table.err
    chart = run(*words, "-o", str(tmp_path / "gap.json"))
    assert chart.code == 0


def test_an_engine_that_cannot_be_is_a_gap_among_those_that_can() -> None:
    own = crankstar.load("honda-b18c")
    cases = [(own, 1.0), SweepError("no such engine"), (own, 3.0)]
    values, gaps = one_by_one(lambda: cases, lambda _own, speed: speed or 0.0, "it", shape=(3,))
    assert values[[0, 2]].tolist() == [1.0, 3.0]
    assert np.isnan(values[1])
    assert gaps == ((1, "no such engine"),)


def test_no_level_line_runs_beside_a_point_without_a_value() -> None:
    x = np.arange(4.0)
    z = np.add.outer(x, 0 * x)
    z[0, 0] = np.nan
    lines = level_lines(x, x, z, 0.5)
    assert [len(line) for line in lines] == [3]
    assert min(y for _x, y in lines[0]) == 1.0


def test_the_best_value_beside_a_gap_within_the_range_is_at_its_edge(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of |x - 0.5| without results from 0.4 to 0.6, both excluded: 0.1 at 0.4 and at 0.6."""

    def gapped(of: Sweep, what: str, *, order: float | None = None) -> Curve:
        off = np.abs(of.values - 0.5)
        return Curve(what, order, np.where(off < 0.1 - 1e-9, np.nan, off), "", what)

    monkeypatch.setattr(best_value, "watched", gapped)
    made = sweep("v2-90", "balance_factor=0..1/9")
    least = best_value.best(made, gapped(made, "it"))
    assert least.result == pytest.approx(0.1, abs=1e-6)
    assert {round(each, 4) for each in (least.value, *least.also)} <= {0.4, 0.6}
