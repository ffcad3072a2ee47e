"""What an answer does not depend on it does not list, and what its words are about stands first."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.test_mounts_views import written

from crankstar.files import engine_of, toml

THREE: dict[str, Any] = {
    "name": "triple",
    "firing_order": [1, 3, 2],
    "speed": "9000 rpm",
    "cylinder": {
        "bore": "78 mm",
        "stroke": "61 mm",
        "rod_length": "112 mm",
        "reciprocating_mass": "290 g",
        "rod": {"mass": "380 g", "centre": "32 mm"},
    },
    "layout": {"type": "inline", "bore_pitch": "90 mm"},
}
SIX: dict[str, Any] = {
    "name": "six that twists",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "cylinder": {"stroke": "158 mm", "rod_length": "260 mm", "reciprocating_mass": "4.6 kg"},
    "torsion": {
        "bare_inertia": ["0.12 kg*m^2"],
        "stiffness": ["4.2 MN*m/rad"],
        "disc": [
            {"name": "wheel", "inertia": "1.6 kg*m^2", "to": "rear", "stiffness": "6 MN*m/rad"}
        ],
    },
    "layout": {"type": "inline"},
}


def _told(run: Run, folder: Path, tree: dict[str, Any], *words: str) -> dict[str, Any]:
    path = folder / "own.toml"
    path.write_text(toml(engine_of(tree)))
    return json.loads(run(words[0], str(path), *words[1:], "--json").out)


def _first_mode(rotating: float) -> float:
    """The first natural frequency (Hz) of six throws and a wheel, rods as two masses."""
    radius, rod = 0.079, 0.26
    theta = np.linspace(0, 2 * np.pi, 7200, endpoint=False)
    side = np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    travel = radius * np.sin(theta) * (1 + radius * np.cos(theta) / side)
    throw = 0.12 + rotating * radius**2 + 4.6 * float(np.mean(travel**2))
    inertia, springs = [throw] * 6 + [1.6], [4.2e6] * 5 + [6e6]
    stiff = np.zeros((7, 7))
    for place, own in enumerate(springs):
        stiff[place : place + 2, place : place + 2] += own * np.array([[1, -1], [-1, 1]])
    squares = np.linalg.eigvals(np.diag(1 / np.array(inertia)) @ stiff)
    return float(np.sort(np.sqrt(np.abs(squares)))[1]) / (2 * np.pi)


def test_a_bobweight_has_no_inertia_of_rods(run: Run, tmp_path: Path) -> None:
    """Its sizes follow from statics alone, so that no inertia of a rod moves them."""
    found = _told(run, tmp_path, THREE, "bobweight")
    assert "cylinder.rod.inertia" not in [row["path"] for row in found["rests_on"]]
    rod = {**THREE["cylinder"]["rod"], "inertia": "0.0009 kg*m^2"}
    other = _told(
        run, tmp_path, {**THREE, "cylinder": {**THREE["cylinder"], "rod": rod}}, "bobweight"
    )
    big_end = 0.38 * (112 - 32) / 112
    small_end = 0.29 + 0.38 * 32 / 112
    for told in (found, other):
        assert told["bobweights"][0]["bobweight"] == pytest.approx(
            big_end + small_end / 2, rel=1e-9
        )
    rows = _told(run, tmp_path, THREE, "analyze")["rests_on"]
    assert "cylinder.rod.inertia" in [row["path"] for row in rows]


def test_crankpins_are_named_where_they_move_the_figure(run: Run, tmp_path: Path) -> None:
    rows = _told(run, tmp_path, SIX, "torsion")["rests_on"]
    row = next(row for row in rows if row["path"] == "cylinder.rotating_mass")
    assert "throw_mass" not in row
    assert "crankpin" not in row["reason"]
    ends = [_first_mode(row[end]) for end in ("high", "low")]
    assert [row["moves"][end] for end in ("low", "high")] == pytest.approx(ends, rel=1e-6)
    four = {**THREE, "cylinder": {**THREE["cylinder"], "rod": None}}
    rows = _told(run, tmp_path, four, "analyze")["rests_on"]
    row = next(row for row in rows if row["path"] == "cylinder.rotating_mass")
    both = row["high"] + row["throw_mass"][1]  # sqrt(3) m r omega^2 a of a triple
    turning = (9000 * np.pi / 30) ** 2
    least = np.sqrt(3) * both * 0.0305 * turning * 0.09
    first = np.sqrt(3) * 0.29 / 2 * 0.0305 * turning * 0.09
    assert row["moves"]["high"] == pytest.approx(least + 2 * first, rel=1e-6)


def test_a_flywheel_left_out_takes_away_uneven_running_alone(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(toml(engine_of({**THREE, "gas": {"imep": "11 bar"}})))
    out = " ".join(run("torque", str(path)).out.split())
    assert "Not in the file, which takes away the uneven running alone: drive.inertia." in out


def test_a_flywheel_is_not_doubted_where_nothing_turns_by_it(run: Run, tmp_path: Path) -> None:
    light = {**THREE, "drive": {"inertia": "0.0001 kg*m^2"}}
    rows = _told(run, tmp_path, light, "analyze")["rests_on"]
    assert "drive.inertia" not in [row["path"] for row in rows]


@pytest.mark.release
def test_the_point_and_the_speeds_stand_at_the_top(run: Run, tmp_path: Path) -> None:
    out = run("mounts", written(tmp_path)).out
    top = " ".join(out.partition("This rests on:")[0].split())
    assert "Vibration is that of the point" in top
    assert "rpm are assumed, about the one that is known; see --speeds." in top
