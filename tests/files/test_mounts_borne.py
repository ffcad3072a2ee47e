"""A mount that bears next to nothing has no transmissibility; what the best mounts rest on."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.charted import bare_canvas
from tests.commands import Run

import crankstar
from crankstar import charts
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.files import engine_of, toml
from crankstar.page.mounts import mounts_shown
from crankstar.spectra import Complex, Real

SIDE, REAR, FRONT = 0.25, -0.25, 0.45
STIFF = {"left": (250e3, 90e3, 90e3), "right": (250e3, 90e3, 90e3), "front": (300e3, 1e5, 1e5)}
PLACES = {"left": (-SIDE, REAR), "right": (SIDE, REAR), "front": (0.0, FRONT)}
BOXER: dict[str, Any] = {
    "name": "boxer six on three mounts",
    "firing_order": [1, 6, 2, 4, 3, 5],
    "speed": "6000 rpm",
    "cylinder": {
        "bore": "100 mm",
        "stroke": "76.4 mm",
        "rod_length": "127 mm",
        "reciprocating_mass": "620 g",
        "rotating_mass": "500 g",
    },
    "layout": {
        "type": "boxer",
        "banks": [
            {"bearing": "-90 deg", "cylinders": [1, 2, 3]},
            {"bearing": "90 deg", "cylinders": [4, 5, 6]},
        ],
        "throws": ["0 deg", "120 deg", "240 deg"],
        "bore_pitch": "118 mm",
        "bank_offset": "38 mm",
    },
    "gas": {"compression_ratio": 11.3, "imep": "11 bar"},
    "block": {"mass": "210 kg", "up": "40 mm"},
    "mounts": [
        {
            "name": name,
            "right": f"{right} m",
            "z": f"{z} m",
            "stiffness": [f"{each / 1e3} N/mm" for each in STIFF[name]],
        }
        for name, (right, z) in PLACES.items()
    ],
}
SPEEDS = 2 * np.pi / 60 * np.array([600.0, 1500.0, 6600.0])


def boxer(**more: Any) -> crankstar.Engine:
    return engine_of({**BOXER, **more})


def rigid_forces(push: Complex, centre: tuple[float, float, float], front: float = 0.0) -> Real:
    """Of springs in the axes up, right, z: their forces under what does not move the block much.

    rms over the orders of `push` [order, freedom] [mount]: k B (sum of B' k B)^-1 Q. `front` is how
    high the one in front stands.
    """
    rows: list[Real] = []
    for name, (right, along) in PLACES.items():
        up, x, z = np.array([front if name == "front" else 0.0, right, along]) - centre
        cross = np.array([[0, -z, x], [z, 0, -up], [-x, up, 0]])  # r x, columns
        rows.append(np.hstack([np.eye(3), -cross]))
    arms = np.vstack(rows)
    stiff = np.diag([size for each in STIFF.values() for size in each])
    forces = push @ np.linalg.solve(arms.T @ stiff @ arms, arms.T @ stiff)
    return np.sqrt((np.abs(forces.reshape(-1, 3, 3)) ** 2).sum(axis=(0, 2)) / 2)


def test_the_mount_on_the_axis_of_roll_has_no_ratio() -> None:
    """By the springs themselves: the one in front would bear less than a thousandth."""
    found = crankstar.mounts(boxer(), speeds=SPEEDS).value
    over = found.over
    for speed in SPEEDS:
        at = int(np.searchsorted(over.speeds, speed))
        slow = rigid_forces(over.excitation.push[at], over.block.centres[0])
        assert slow[2] < 1e-3 * slow[0]
        real = np.sqrt((np.abs(over.mount_force[at]) ** 2).sum(axis=(0, 2)) / 2)
        assert over.transmissibility[at, :2] == pytest.approx(real[:2] / slow[:2], rel=1e-9)
        assert np.isnan(over.transmissibility[at, 2])


@pytest.mark.parametrize("height", [0.01, 1.0])
def test_from_a_hundredth_of_the_greatest_force_on_it_counts(height: float) -> None:
    """The higher it stands, the more of the roll it bears sideways."""
    own = [*BOXER["mounts"][:2], {**BOXER["mounts"][2], "up": f"{height} m"}]
    over = crankstar.mounts(boxer(mounts=own), speeds=[SPEEDS[0]]).value.over
    slow = rigid_forces(over.excitation.push[0], over.block.centres[0], height)
    assert (slow[2] > 0.01 * slow.max()) == (height > 0.5)
    assert np.isfinite(over.transmissibility[0, 2]) == (height > 0.5)


@pytest.mark.release
def test_every_view_leaves_it_out_and_says_so(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "boxer.toml"
    path.write_text(toml(boxer()), encoding="utf-8")
    asked = ("mounts", str(path), "--speeds", "600, 1500, 6600 rpm", "--speed", "1500 rpm")
    text = run(*asked).out
    note = "bear less than 1 % of what another bears, if nothing had inertia: front."
    assert " ".join(text.split()).count(note) == 2
    tables = json.loads(run(*asked, "--json").out)
    assert tables["speeds"][0]["transmissibility"][2] is None
    assert [row["transmissibility"] is None for row in tables["mounts_at_speed"]] == [0, 0, 1]
    assert "maximum transmissibility" not in text.split("Mounts\n")[0]


@pytest.mark.usefixtures(bare_canvas.__name__)
def test_chart_page_and_figures_leave_it_out() -> None:
    engine = boxer()
    drawn = str(charts.transmissibility_chart(engine, speeds=SPEEDS.tolist()).to_dict())
    assert "'what': 'front'" not in drawn
    assert "'what': 'left, right'" in drawn
    shown = mounts_shown(engine)
    assert shown is not None
    assert shown.over is not None
    assert set(shown.over.transmissibility[2]) == {None}
    figures = on_mounts(engine, speeds=SPEEDS).figures(engine)
    over = crankstar.mounts(engine, speeds=SPEEDS).value.over
    assert figures["transmissibility", None] == pytest.approx(np.nanmax(over.transmissibility))


@pytest.mark.many(first=1)
@pytest.mark.parametrize("aim", ["force", "rms mounts", "roll"])
def test_the_best_mounts_rest_first_on_what_moves_their_aim(
    run: Run, tmp_path: Path, aim: str
) -> None:
    """The value that the first assumption moves is the one that the table prints as found."""
    path = tmp_path / "boxer.toml"
    path.write_text(toml(boxer()), encoding="utf-8")
    asked = ("--minimise", aim, "--stiffness", "50..400 N/mm", "--starts", "1")
    at = () if aim == "roll" else ("--speeds", "600, 900 rpm")
    ran = run("isolate", str(path), *asked, *at, "--json")
    assert not ran.err
    told = json.loads(ran.out)
    first = told["rests_on"][0]
    assert first["moves"]["quantity"].startswith("least ")
    assert first["moves"]["now"] == pytest.approx(told["after"], rel=1e-6)
