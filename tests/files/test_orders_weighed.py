"""`crankstar orders --minimise`: firing orders sorted by gas torque, roll or twist."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.commands import Run


def test_orders_are_sorted_by_the_twist_that_is_asked_for(run: Run) -> None:
    arguments = ("orders", "bmw-m52b28", "--minimise", "twist", "--orders", "0.5")
    rows = json.loads(run(*arguments, "--json").out)["orders"]
    twists = [row["twist"]["0.5"] for row in rows]
    assert twists == sorted(twists)
    assert rows[0]["order"] == [1, 5, 3, 6, 2, 4]
    assert rows[0]["row"] == 1


def test_a_row_of_the_sorted_orders_is_written(run: Run, tmp_path: Path) -> None:
    arguments = ("orders", "yamaha-r1-crossplane", "--any", "--minimise", "roll")
    told = json.loads(run(*arguments, "--orders", "0.5", "--json").out)["orders"]
    assert told[0]["roll"]["0.5"] < told[-1]["roll"]["0.5"]
    place = str(tmp_path / "quiet.toml")
    assert run(*arguments, "--orders", "0.5", "--row", "1", "-o", place).code == 0
    torque = json.loads(run("torque", place, "--json", "--orders", "0.5").out)["orders"][0]
    size = (torque["gas"][0] ** 2 + torque["gas"][1] ** 2) ** 0.5
    assert size == pytest.approx(told[0]["roll"]["0.5"], rel=1e-6)


def test_a_point_of_the_file_gives_the_size_of_a_cylinder(run: Run) -> None:
    arguments = ("orders", "bmw-m52b28", "--minimise", "twist", "--orders", "0.5", "--json")
    idle, full = (
        json.loads(run(*arguments, "--point", point).out)["orders"][0]["twist"]["0.5"]
        for point in ("idle", "full")
    )
    assert idle < full / 3


def test_without_sizes_orders_are_counted_in_one_cylinder(run: Run) -> None:
    shown = " ".join(run("orders", "i6", "--minimise", "twist").out.split())
    assert "Counted in one cylinder." in shown
    assert "N m" not in shown


def test_a_mode_shape_takes_the_place_of_the_even_twist(run: Run) -> None:
    arguments = ("orders", "i4", "--minimise", "twist", "--orders", "2", "--json")
    even = json.loads(run(*arguments).out)["orders"][0]["twist"]["2"]
    rigid = json.loads(run(*arguments, "--mode-shape", "1,1,1,1").out)["orders"][0]["twist"]["2"]
    assert even == pytest.approx(0, abs=1e-9)
    assert rigid == pytest.approx(4)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("i4", "--orders", "1"), "--minimise"),
        (("i4", "--minimise", "noise"), "torque"),
        (("i4", "--minimise", "twist", "--orders", "0.3"), "multiples of 0.5"),
        (("i4", "--minimise", "twist", "--mode-shape", "1,2"), "4 numbers"),
        (("i4", "--minimise", "torque", "--mode-shape", "1,2,3,4"), "twist"),
        (("i4", "--minimise", "torque", "--point", "full"), "bore"),
        (("bmw-g650", "--minimise", "twist"), "one place"),
        (("bmw-s65", "--minimise", "twist", "--point", "nowhere"), "no operating point"),
    ],
)
def test_a_wrong_request_to_weigh_orders_is_told(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    result = run("orders", *arguments)
    assert result.code == 2
    assert words in " ".join(result.err.split())
    assert "Traceback" not in result.err
