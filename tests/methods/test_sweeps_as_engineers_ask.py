"""Sweeps: bank angles, rods, values that are also set, lines of best pairs, words of charts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import crankstar
import crankstar.cli
from crankstar import load
from crankstar.charts.crank_angle import angle_ticks
from crankstar.charts.pair_sweeps import contours
from crankstar.charts.sweeps import swept as chart
from crankstar.files.catalog import names, tree_of
from crankstar.files.forms import form_of
from crankstar.mechanics.balance import balance, total
from crankstar.studies.best_pair import best_pair
from crankstar.studies.best_value import best
from crankstar.studies.numeric_keys import _numeric
from crankstar.studies.sweep import sweep, watched
from crankstar.studies.variants import SweepError
from crankstar.tables.field_names import NAMES
from crankstar.tables.pair_sweeps import best_sentence
from crankstar.tables.sweeps import amplitudes, sweep_document

SWEEP: Any = crankstar.sweep
WATCHED: Any = crankstar.watched


def force(name: str, **changes: str) -> float:
    """The forward vector of first order of an engine with values set."""
    engine = load(name, changes=changes)
    return float(abs(total(balance(engine, orders=[1])).force.forward[0]))


def test_the_bank_angle_of_explicit_banks_moves_both_about_their_middle() -> None:
    made = sweep("harley-45", "layout.bank_angle=0..180 deg/19", changes=BARE)
    values = watched(made, "force.forward", order=1).values
    for angle, value in zip(made.values.tolist(), values.tolist(), strict=True):
        ends = {"layout.banks[1].bearing": angle / 2, "layout.banks[2].bearing": -angle / 2}
        own = force("harley-45", **BARE, **{key: f"{end} deg" for key, end in ends.items()})
        assert value == pytest.approx(own, rel=1e-9)


BARE: Any = {"layout.bank_offset": 0}


def test_a_bank_angle_needs_two_banks_that_are_not_varied_besides() -> None:
    for name, over, told in (
        ("i4", ["layout.bank_angle=0..9 deg/3"], "is not a field"),
        ("napier-lion", ["layout.bank_angle=0..9 deg/3"], "is not a field"),
        ("v2-90", ["layout.bank_angle=0..9/3"], "has no unit"),
        (
            "v2-90",
            ["layout.bank_angle=0..9 deg/3", "layout.banks[1].bearing=0..9 deg/3"],
            "without their bearings",
        ),
    ):
        with pytest.raises(SweepError, match=told):
            sweep(name, over)


@pytest.mark.release
def test_a_rod_ratio_takes_the_place_of_the_rod_length_of_the_file() -> None:
    assert "rod_length" in tree_of("ford-coyote")[1]["cylinder"]
    ratios = sweep("ford-coyote", "cylinder.rod_ratio=3..4/3")
    radius = 92.7 / 2
    lengths = sweep("ford-coyote", f"cylinder.rod_length={3 * radius}..{4 * radius} mm/3")
    own, other = (watched(each, "force", order=4).values for each in (ratios, lengths))
    assert own == pytest.approx(other, rel=1e-9)
    assert own[0] > own[-1] > 0


@pytest.mark.parametrize(
    ("over", "changes"),
    [
        ("cylinder.rod_ratio=3..4/3", {"cylinder.rod_ratio": 3.5}),
        ("cylinder.rod_ratio=3..4/3", {"cylinder.rod_length": "150 mm"}),
        ("speed=1000..2000 rpm/3", {"speed": "1000 rpm"}),
        ("balance_factor=0..1/3", {"balance_factor": 0.5}),
    ],
)
def test_a_value_that_is_set_and_varied_is_refused(over: str, changes: dict[str, Any]) -> None:
    with pytest.raises(SweepError, match="leave one of the two out"):
        sweep("ford-coyote", over, changes=changes)


@pytest.mark.release
def test_a_line_of_best_pairs_is_not_called_the_best_one() -> None:
    line = sweep("single", ["balance_factor=0..1/12", "cylinder.rod_ratio=3..5/16"])
    curve = watched(line, "force.forward", order=1)
    found = best_pair(line, curve)
    assert found.ridge
    assert "the best pairs lie on a line" in best_sentence(line, curve, found)
    words = json.dumps(contours(line, [curve], best=[found]).spec).replace('", "', " ")
    assert "along a line" in words
    assert "best at" not in words
    slanted = sweep("v2-90", [f"layout.banks[{n}].bearing=0..170 deg/18" for n in (1, 2)])
    assert best_pair(slanted, watched(slanted, "force", order=1)).ridge  # at right angles
    point = sweep("v2-90", ["balance_factor=0..1/12", "layout.bank_angle=40..130 deg/14"])
    assert not best_pair(point, watched(point, "force", order=1)).ridge


def test_charts_of_sweeps_have_the_words_of_the_field_and_marks_of_a_clock() -> None:
    one = sweep("i4", "layout.throws[2]=0..360 deg/37")
    words = json.dumps(chart(one, [watched(one, "force")]).spec)
    assert "Force over angle of throw 2" in words
    assert "angle of throw 2 [deg]" in words
    assert "layout.throws" not in words
    assert "[0, 45, 90, 135, 180, 225, 270, 315, 360]" in words
    assert angle_ticks(low=0, high=90) == [0, 15, 30, 45, 60, 75, 90]
    assert angle_ticks(low=0, high=720)[1] == 90


@pytest.mark.release
def test_every_number_of_an_engine_file_has_a_name() -> None:
    paths = {
        path for name in names() for path in _numeric(form_of(tree_of(name)[1]), tree_of(name)[1])
    }
    keys = {path.rpartition(".")[2].partition("[")[0] for path in paths}
    assert keys - {*NAMES} == set()


def test_a_sweep_says_what_newtons_need_or_at_which_speed_they_are() -> None:
    for name, told in (
        ("i4", "For newtons, add to the file: cylinder.stroke"),
        ("man-s50mc-c", "cylinder.reciprocating_mass, layout.bore_pitch"),
    ):
        made = sweep(name, "balance_factor=0..1/3")
        curve = watched(made, "force")
        document = sweep_document(made, [curve], [best(made, curve)])
        assert any(told in line for part in document.parts for line in getattr(part, "lines", ()))


def test_the_columns_of_a_frame_are_those_of_the_csv() -> None:
    made = crankstar.sweep("ford-coyote", "cylinder.rod_length=140..150 mm/3")
    frame = made.to_frame()
    csv = amplitudes(made, [watched(made, "force")]).tables
    heads = [f"{c.key} [{c.unit}]" if c.unit == "mm" else c.key for c in next(iter(csv)).columns]
    assert heads[:2] == ["engine", "cylinder.rod_length [mm]"]
    assert [head for head in frame.columns if head != "phase_deg"] == heads


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: SWEEP(None), "sweep: missing .*'over'"),
        (lambda: SWEEP(None, "x=0..1"), "a path or a dict of keys, not None"),
        (lambda: SWEEP("i4", None), "over takes text .* not None"),
        (lambda: SWEEP("i4", "x", None), "sweep: too many"),
        (lambda: WATCHED(None), "watched: missing .*'what'"),
        (lambda: WATCHED(None, "force"), "takes a Sweep.* not None"),
        (lambda: WATCHED(crankstar.load("i4"), "force"), "not Engine"),
    ],
)
def test_a_call_with_nothing_is_told_what_is_wanted(call: Any, told: str) -> None:
    with pytest.raises(TypeError, match=told):
        call()


@pytest.mark.release
def test_a_file_that_is_written_is_named_on_standard_error(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for words in (
        ["sweep", "i4", "--over", "balance_factor=0..1/3", "-o", "it.csv"],
        ["sweep", "i4", "--over", "balance_factor=0..1/3", "-o", "it.svg"],
        ["plot", "i4", "spectrum", "-o", "it.json"],
        ["export", "i4", "-o", "it.py"],
    ):
        with pytest.raises(SystemExit):
            crankstar.cli.main(words)
        out, told = capsys.readouterr()
        assert (out, told.splitlines()[0]) == ("", f"Wrote {words[-1]}")
