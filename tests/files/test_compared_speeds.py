"""Engines side by side: the head says at which speed each is computed, and why."""

from __future__ import annotations

import json
import re
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

from crankstar import charts
from crankstar.files import engine_of
from crankstar.studies.answers import compared, rests_on
from crankstar.tables.assumptions import side_by_side
from crankstar.tables.comparison import compare

LOWEST = (
    "All at 2000 rpm, the lowest of those in the files: one: none; two: 3000 rpm; three: 2000 rpm."
)


def _tree(name: str, speed: str | None) -> dict[str, Any]:
    own = {} if speed is None else {"speed": speed}
    return {
        "format": 1,
        "name": name,
        "firing_order": [1, 3, 2],
        "cylinder": {
            "bore": "71 mm",
            "stroke": "84 mm",
            "rod_length": "137 mm",
            "reciprocating_mass": "330 g",
        },
        "layout": {"type": "inline", "bore_pitch": "78 mm"},
        **own,
    }


TREES = [_tree("one", None), _tree("two", "3000 rpm"), _tree("three", "2000 rpm")]


def test_the_head_says_the_speed_and_why_in_every_form(run: Run, tmp_path: Path) -> None:
    engines = [engine_of(tree) for tree in TREES]
    assert compare(*engines).parts[0].lines == (LOWEST,)  # pyright: ignore
    subtitle = charts.side_by_side(engines, "spectrum").to_dict()["title"]["subtitle"]
    assert LOWEST in " ".join(subtitle)
    paths = [tmp_path / f"{tree['name']}.json" for tree in TREES]
    for path, tree in zip(paths, TREES, strict=True):
        path.write_text(json.dumps(tree))
    ran = run("compare", *map(str, paths), "--csv")
    assert LOWEST in " ".join(ran.err.split())
    rows = [line.split(",") for line in ran.out.splitlines()]
    place = rows[0].index("file_speed_rpm")
    assert [row[place] for row in rows if row[0] == "engines"] == ["", "3000.0", "2000.0"]


@pytest.mark.parametrize(
    ("speeds", "asked", "said"),
    [
        ((3000, 2000), None, "Each at the speed of its file: one: 3000 rpm; two: 2000 rpm."),
        ((3000, 3000), None, "All at 3000 rpm, the speed of each file."),
        ((None, None), None, "All at 1000 rpm, assumed, for no file has a speed."),
        ((None, None), 4000, "All at 4000 rpm, as asked for; no file has a speed."),
        (
            (None, 3000),
            4000,
            "All at 4000 rpm, as asked for; in the files: one: none; two: 3000 rpm.",
        ),
    ],
)
def test_each_reason_has_its_sentence(
    speeds: tuple[int | None, ...], asked: int | None, said: str
) -> None:
    engines = [
        engine_of(_tree(name, None if rpm is None else f"{rpm} rpm"))
        for name, rpm in zip(("one", "two"), speeds, strict=True)
    ]
    told = compare(*engines, speed=None if asked is None else asked * pi / 30)
    assert told.parts[0].lines == (said,)  # pyright: ignore


def test_a_speed_of_the_file_is_not_assumed_and_the_largest_effect_stands_first() -> None:
    """Forces go with the square of the speed: at 3000 rpm 2.25 times what they are at 2000."""
    engines = [engine_of(tree) for tree in TREES]
    speed = 2000 * pi / 30
    found = [
        rests_on(each, compared(each, speed=speed, gas=False, speed_assumed=True))
        for each in engines
    ]
    [assumed], [own], none = [[a for a in each if a.path == "speed"] for each in found]
    assert none == []
    assert (assumed.status, own.status) == ("assumed", "left out")
    assert own.moved is not None
    assert own.moved.high / own.moved.now == pytest.approx(2.25, rel=1e-12)
    assert own.reason == "3000 rpm in the file, all are at 2000 rpm"
    first, rest = side_by_side(found, ["one", "two", "three"])
    head = [line for part in first for line in part.lines]
    assert not any(line.startswith("speed") for part in rest for line in part.lines)
    assert sum(line.startswith("speed: ") for line in head) == 2
    largest = max((each for every in found for each in every), key=lambda each: each.effect)
    assert any(line.startswith(f"{largest.path}: ") for line in head)


def test_a_speed_that_no_file_has_is_called_estimated(tmp_path: Path, run: Run) -> None:
    trees = {"one": _tree("one", "3000 rpm"), "two": _tree("two", None)}
    for name, tree in trees.items():
        (tmp_path / f"{name}.json").write_text(json.dumps(tree), encoding="utf-8")
    out = " ".join(run("compare", "one.json", "two.json", "--estimate").out.split())
    said = r"Each at the speed of its file: one: 3000 rpm; two: (\d+) rpm, estimated\."
    found = re.search(said, out)
    assert found is not None
    assert 10 < 2 * 0.084 * int(found[1]) / 60 < 25  # m/s, the mean piston speed of any engine
    alone = " ".join(run("compare", "two.json", "two.json", "--estimate").out.split())
    assert "the speed of each file" not in alone
