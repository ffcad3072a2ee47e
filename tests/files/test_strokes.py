"""The verb strokes: assumed angles, ports and valves, engines without a firing order."""

from __future__ import annotations

import json
from collections.abc import Callable
from math import sqrt
from pathlib import Path

import pytest
from tests.commands import Run

from crankstar.files import changed, tree_text
from crankstar.files.catalog import tree_of


@pytest.mark.parametrize(
    ("name", "cycle"),
    [("man-s90mc-c", "two-stroke"), ("jumo-205", "two-stroke"), ("merlin", "four-stroke")],
)
def test_assumed_angles_are_said_to_be_those_of_the_cycle_and_not_of_a_kind_of_vehicle(
    run: Run, name: str, cycle: str
) -> None:
    out = run("strokes", name).out
    assert f"Assumed angles are typical of {cycle} engines" in out
    assert "road" not in out


def test_a_two_stroke_engine_may_have_exhaust_valves(run: Run) -> None:
    assert "Exhaust opens 85 deg (assumed)" in run("strokes", "man-s90mc-c").out
    assert "Exhaust opens 50 deg (assumed)" in run("strokes", "i4").out


def test_without_a_firing_order_the_verb_that_lists_them_is_named(
    refused: Callable[..., str],
) -> None:
    told = refused("strokes", "napier-lion")
    assert "firing_order is missing" in told
    assert "`crankstar orders` lists the orders that the crank can fire" in told


def test_strokes_into_a_file_named_json_are_json(run: Run, tmp_path: Path) -> None:
    run("strokes", "i4", "-o", "strokes.json")
    assert json.loads((tmp_path / "strokes.json").read_text(encoding="utf-8"))["cycle_deg"] == 720


def test_strokes_have_no_picture(refused: Callable[..., str]) -> None:
    assert "the name must end in .txt, .csv, .json" in refused("strokes", "i4", "-o", "strokes.svg")


def test_strokes_list_the_orders_of_banks_and_engine(run: Run) -> None:
    rows = json.loads(run("strokes", "v8-cross-plane", "--json").out)["exhaust_orders"]
    assert [row["name"] for row in rows] == ["bank odd", "bank even", "whole engine"]
    assert rows[0]["pulses"]["1.5"] == pytest.approx(sqrt(4 + 2 * sqrt(2)))
    assert rows[1]["pulses"]["2"] == 0
    assert rows[2]["pulses"] == {**dict.fromkeys(rows[0]["pulses"], 0), "4": 8}
    assert "Exhaust orders" in run("strokes", "v8-cross-plane").out


def test_cylinders_with_exhausts_of_their_own_have_one_row_together(run: Run) -> None:
    rows = json.loads(run("strokes", "v2-90", "--json").out)["exhaust_orders"]
    assert [row["name"] for row in rows] == ["whole engine"]
    assert rows[0]["pulses"]["1"] == pytest.approx(sqrt(2))
    (row,) = json.loads(run("strokes", "single", "--json").out)["exhaust_orders"]
    assert set(row["pulses"].values()) == {1}


@pytest.mark.parametrize("verb", ["strokes", "show", "verdict", "check"])
def test_crankshafts_of_different_speed_have_no_firing_order_in_any_verb(
    run: Run, tmp_path: Path, verb: str
) -> None:
    name, tree = tree_of("kr250-racer")
    other = changed(tree, {"layout.cranks[2].speed_ratio": "1/3"}, name=name)
    (tmp_path / "x.toml").write_text(tree_text(other), encoding="utf-8")
    told = " ".join("".join(run(verb, "x.toml")[1:]).split())
    assert "cylinder 2 is at top dead centre every 1080 deg" in told
    assert "1-2" not in told
