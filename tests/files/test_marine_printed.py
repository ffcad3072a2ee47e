"""What marine and guide print, read back: every number with its unit is that of the JSON."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.marine import marine_engine
from tests.terminal_tables import Read, blocks

from crankstar.files import toml

FOOT, POUND, GRAVITY = 0.3048, 0.45359237, 9.80665
POUND_FOOT = FOOT * POUND * GRAVITY
"""N m: exact by the international agreement of 1959."""
UNITS = {
    "": 1.0,
    "N": 1.0,
    "kN": 1e3,
    "lbf": POUND * GRAVITY,
    "N m": 1.0,
    "kN m": 1e3,
    "lbf ft": POUND_FOOT,
    "kW": 1e3,
    "hp": 550 * POUND_FOOT,
    "N m/kW": 1.0,
    "lbf ft/hp": POUND_FOOT / (0.55 * POUND_FOOT),
    "mm": 1.0,
    "in": 25.4,
    "kg m": 1.0,
    "Hz": 1.0,
    "rpm": 1.0,
}
"""How many of the unit of the JSON one of each has."""
KEYS = {
    "External moments": {
        "order": "order",
        "M_V before": "vertical_before",
        "M_H before": "horizontal_before",
        "M_V, vertical": "vertical",
        "M_H, horizontal": "horizontal",
        "force, vertical": "force_vertical",
        "force, horizontal": "force_horizontal",
        "M_V about the node": "at_node",
        "over the power": "unbalance",
        "compensator": "compensator",
    },
    "Compensators": {
        "order": "order",
        "place along the crankshaft": "z",
        "mass x radius of each of two": "unbalance",
        "force, vertical": "force",
    },
    "Guide-force moments": {
        "order": "order",
        "H-moment": "h",
        "X-moment": "x",
        "top bracings, H": "bracing_h",
        "each end, X": "bracing_x",
    },
    "External moments over the speeds": {
        "speed": "speed_rpm",
        "M_1V": "m1v",
        "M_1H": "m1h",
        "M_2V": "m2v",
        "M_4V": "m4v",
    },
    "Family": {
        "cylinders": "cylinders",
        "firing order": "firing_order",
        "chosen": "chosen",
        "M_1V": "m1v",
        "M_1H": "m1h",
        "M_2V": "m2v",
        "M_4V": "m4v",
        "power": "power",
        "M_2V over the power": "unbalance",
        "compensator": "compensator",
        "greatest H": "h",
        "greatest X": "x",
        "vector sum": "torsion_sum",
        "torsion shape": "torsion_shape",
        "natural frequency": "natural_frequency",
    },
}
FIGURES = {"unbalance": 6e-3, "torsion_sum": 6e-4}
"""By how much a number of three or four figures may differ; others have five."""
DRIVE: dict[str, Any] = {
    "inertia": "9 t*m^2",
    "stiffness": "1100 MN*m/rad",
    "disc": [
        {"name": "propeller", "inertia": "40 t*m^2", "to": "rear", "stiffness": "60 MN*m/rad"}
    ],
}


def file_of(folder: Path) -> str:
    path = folder / "seven.toml"
    path.write_text(toml(marine_engine(torsion=DRIVE)))
    return str(path)


def size(value: Any) -> float:
    return value["amplitude"] if isinstance(value, dict) else value


def check(column: Read, key: str, rows: list[dict[str, Any]]) -> None:
    assert len(column.cells) == len(rows)
    scale = max((abs(size(row[key])) for row in rows if column.unit), default=0)
    for cell, row in zip(column.cells, rows, strict=True):
        value = row[key]
        if isinstance(value, str):
            assert cell == value
        elif isinstance(value, list):
            assert cell == "-".join(map(str, value))
        else:
            number, _angle, phase = cell.partition(" ∠ ")
            rel = FIGURES.get(key, 6e-5)
            read = float(number) * UNITS[column.unit]
            assert read == pytest.approx(size(value), rel=rel, abs=1e-9 * scale)
            if phase:
                assert float(phase.removesuffix("°")) == pytest.approx(value["phase_deg"], abs=6e-3)


def checked(text: str, found: dict[str, Any], titles: dict[str, str]) -> set[str]:
    """The keys of which a column was read and is as in the JSON; titles of tables to their keys."""
    done: set[str] = set()
    for title, parts in blocks(text).items():
        name = title.partition(" at ")[0]
        rows = found[titles[name]]
        if name == "Guide-force moments":  # readers get those of note
            shown = {float(order) for order in parts[0][0].cells}
            rows = [row for row in rows if row["order"] in shown]
        for block in parts:
            before = ""
            for column in block:
                after_moment = {"greatest H": "h_order", "greatest X": "x_order"}
                key = after_moment[before] if column.heading == "of order" else ""
                key = key or KEYS[name][column.heading]
                check(column, key, rows)
                done.add(key)
                before = column.heading
    return done


def moments_of(text: str) -> set[str]:
    """The units in which moments are printed."""
    return {
        column.unit
        for parts in blocks(text).values()
        for block in parts
        for column in block
        if column.heading.startswith(("M_", "greatest", "H-moment", "X-moment"))
    } - {"N m/kW", "lbf ft/hp"}


@pytest.mark.release
@pytest.mark.parametrize(
    ("units", "moment"), [((), "kN m"), (("--units", "N m"), "N m"), (("--units", "us"), "lbf ft")]
)
@pytest.mark.parametrize("width", ["80", "240"])
def test_the_family_is_printed_as_it_is_in_json(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    units: tuple[str, ...],
    moment: str,
    width: str,
) -> None:
    monkeypatch.setenv("COLUMNS", width)
    asked = ("guide", file_of(tmp_path), "--numbers", "5,7", "--first-order", "equal")
    found = json.loads(run(*asked, "--json").out)
    text = run(*asked, *units).out
    done = checked(text, found, {"Family": "members"})
    assert done == {*KEYS["Family"].values(), "h_order", "x_order"}
    assert moments_of(text) == {moment}


@pytest.mark.release
@pytest.mark.parametrize(
    ("units", "moment"), [((), "kN m"), (("--units", "N m"), "N m"), (("--units", "us"), "lbf ft")]
)
def test_marine_moments_are_printed_as_they_are_in_json(
    run: Run, tmp_path: Path, units: tuple[str, ...], moment: str
) -> None:
    asked = ("marine", file_of(tmp_path), "--first-order", "0.3", "--compensate", "2: 4.5 m")
    asked += ("--node", "-28 m", "--bracing", "5 m, 6 m", "--speeds", "40..104 rpm by 16")
    found = json.loads(run(*asked, "--json").out)
    text = run(*asked, *units).out
    titles = {
        "External moments": "moments",
        "Compensators": "compensators",
        "Guide-force moments": "guide",
        "External moments over the speeds": "speeds",
    }
    done = checked(text, found, titles)
    assert done == {key for name in titles for key in KEYS[name].values()}
    assert moments_of(text) == {moment}


@pytest.mark.release
def test_a_small_engine_has_the_units_of_a_project_guide_too(run: Run) -> None:
    text = run("marine", "audi-25-tfsi", "--set", "cylinder.reciprocating_mass=0.6 kg").out
    assert moments_of(text) == {"kN m"}
    csv = run("guide", "audi-25-tfsi", "--numbers", "5", "--csv").out
    assert "kN" not in csv
