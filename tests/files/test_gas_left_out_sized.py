"""Gas that a file lacks a bore for, and a load with a course, have a size in every answer."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

from crankstar.files import engine_of, toml
from crankstar.mechanics.gas import cycle

FIVE: dict[str, Any] = {
    "name": "diesel five, no bore",
    "firing_order": [1, 2, 4, 5, 3],
    "speed": "4000 rpm",
    "cylinder": {
        "stroke": "92 mm",
        "rod_length": "150 mm",
        "reciprocating_mass": "780 g",
        "rotating_mass": "700 g",
    },
    "gas": {"ignition": "compression", "compression_ratio": 18, "imep": "14 bar"},
    "torsion": {
        "bare_inertia": ["0.012 kg*m^2"],
        "stiffness": ["0.9 MN*m/rad"],
        "disc": [
            {"name": "wheel", "inertia": "0.2 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
        ],
    },
    "layout": {"type": "inline", "bore_pitch": "100 mm"},
}
BORE = 0.08
GIVEN: dict[str, Any] = {**FIVE, "cylinder": {**FIVE["cylinder"], "bore": "80 mm"}}


def _row(run: Run, folder: Path, tree: dict[str, Any], path: str, *words: str) -> dict[str, Any]:
    place = folder / "own.toml"
    place.write_text(toml(engine_of(tree)))
    files = [str(place)] * (2 if words[0] == "compare" else 1)
    told = json.loads(run(words[0], *files, *words[1:], "--json").out)
    return next(row for row in told["rests_on"] if row["path"] == path)


def _order(number: float) -> float:
    """The torque of gas of this order of five cylinders, by the work of their pressure, N m."""
    own = cycle(engine_of(GIVEN))
    theta = np.linspace(0, 4 * np.pi, own.pressure.shape[1], endpoint=False)
    radius, rod = 0.046, 0.15
    side = np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    travel = radius * np.sin(theta) * (1 + radius * np.cos(theta) / side)
    wave = np.fft.fft(np.pi / 4 * BORE**2 * (own.pressure[0] - own.crankcase) * travel)
    return float(5 * 2 * abs(wave[round(2 * number)]) / theta.size)


@pytest.mark.parametrize("command", ["marine", "guide"])
def test_guide_moments_have_the_gas_of_a_usual_bore(command: str, run: Run, tmp_path: Path) -> None:
    """No inertia has order 2.5, so that its moment goes with the piston area."""
    words = ["guide", "--numbers", "5"] if command == "guide" else [command]
    row = _row(run, tmp_path, FIVE, "gas", *words)
    assert row["lacks"] == "cylinder.bore"
    for end in ("low", "high"):
        expected = _order(2.5) * (row[end] / (1e3 * BORE)) ** 2
        assert row["moves"][end] == pytest.approx(expected, rel=2e-3)


@pytest.mark.release
def test_bearings_and_torsion_have_it_too(run: Run, tmp_path: Path) -> None:
    row = _row(run, tmp_path, FIVE, "gas", "bearings")
    assert row["moves"]["quantity"].startswith("main bearing ")
    assert row["moves"]["high"] > row["moves"]["low"] > row["moves"]["now"] > 0
    row = _row(run, tmp_path, FIVE, "gas", "torsion")
    assert row["moves"]["quantity"] in ("torsional amplitude", "torsional torque")
    assert row["moves"]["high"] > row["moves"]["low"] > 0


@pytest.mark.many(first=1)
@pytest.mark.parametrize("command", ["marine", "compare"])
def test_a_load_with_a_course_is_named(command: str, run: Run, tmp_path: Path) -> None:
    """A load 1 + cos rolls a shared frame by the mean torque, which is imep V / 4 pi."""
    angles = [f"{each} deg" for each in range(0, 720, 5)]
    course = [1 + float(np.cos(np.radians(each))) for each in range(0, 720, 5)]
    tree = {**GIVEN, "drive": {"load_angle": angles, "load_torque": course}}
    moves = _row(run, tmp_path, tree, "drive.load_torque", command)["moves"]
    mean = 14e5 * 5 * np.pi / 4 * BORE**2 * 0.092 / (4 * np.pi)
    assert (moves["quantity"], moves["order"]) == ("roll", 1.0)
    assert moves["high"] == pytest.approx(mean, rel=2e-3)
