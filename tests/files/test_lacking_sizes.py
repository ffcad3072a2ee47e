"""What blocks gas or inertia is tried with what `estimate` would fill in, and has its size."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.test_estimated_conditions import FIVE
from tests.files.test_estimated_speed import GENSET

import crankstar
from crankstar import spectra
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analysis.assumptions import moved
from crankstar.dynamics.mount_analysis import mounts

FOUR = """name = "four without masses"
firing_order = [1, 3, 4, 2]
speed = "6500 rpm"
[cylinder]
bore = "86 mm"
stroke = "86 mm"
rod_length = "140 mm"
[layout]
type = "inline"
bore_pitch = "94 mm"
[gas]
bmep = "11 bar"
"""
MOUNTS = """
[[mounts]]
name = "left"
right = "-350 mm"
up = "100 mm"
stiffness = ["180 N/mm"]
[[mounts]]
name = "right"
right = "350 mm"
up = "100 mm"
stiffness = ["180 N/mm"]
[[mounts]]
name = "rear"
z = "-600 mm"
up = "-50 mm"
stiffness = ["150 N/mm"]
"""


def _row(run: Run, path: str, *words: str) -> dict[str, Any]:
    """What an answer says of one key path of what it rests on."""
    told: dict[str, Any] = json.loads(run(*words, "--json").out)
    return next(row for row in told["rests_on"] if row["path"] == path)


def _roll(
    engine: crankstar.Engine, order: float, *, mass: float, speed: float, places: list[float]
) -> float:
    """The size of gas and inertia torque of an order: F dx/da at each cylinder, summed in time.

    `places` are the crank angles by which the cylinders follow the first; x is the height of the
    piston, r cos a + (l^2 - r^2 sin^2 a)^(1/2), and the force on it -m w^2 d2x/da2.
    """
    turn = np.arange(4096) * 4 * pi / 4096
    gas = np.real(
        spectra.value(crankstar.gas_torque(crankstar.cycle(engine, speed=speed)).total, turn)
    )
    r, length = engine.throw(engine.first).radius, engine.first.rod_length
    torque = np.zeros(turn.size)
    for place in places:
        a = turn - place
        root = np.sqrt(length**2 - (r * np.sin(a)) ** 2)
        first = -r * np.sin(a) - r**2 * np.sin(2 * a) / (2 * root)
        second = np.gradient(np.r_[first, first[0]], 4 * pi / 4096)[:-1]
        second[0] = (first[1] - first[-1]) / (2 * 4 * pi / 4096)
        torque -= mass * speed**2 * second * first
    waves = np.fft.rfft(gas + torque) / turn.size * 2
    return float(np.abs(waves[round(2 * order)]))


def test_gas_without_a_bore_is_that_of_usual_bores(run: Run, tmp_path: Path) -> None:
    """The rolling moment of order 2.5, of which inertia has nothing, goes with the bore squared."""
    place = tmp_path / "five.toml"
    place.write_text(FIVE)
    row = _row(run, "gas", "analyze", str(place))
    most = row["moves"]
    assert (row["status"], row["lacks"], row["unit"]) == ("left out", "cylinder.bore", "mm")
    filled: dict[str, Any] = json.loads(run("estimate", str(place), "--json").out)
    bore = next(each for each in filled["filled"] if each["path"] == "cylinder.bore")
    assert (row["low"], row["high"]) == (
        pytest.approx(1e3 * bore["low"], rel=2e-3),
        pytest.approx(1e3 * bore["high"], rel=2e-3),
    )
    assert (most["quantity"], most["order"], most["now"]) == ("roll", 2.5, 0)
    assert most["high"] / most["low"] == pytest.approx((row["high"] / row["low"]) ** 2, rel=1e-6)
    changes = {"cylinder.bore": f"{row['high']} mm"}
    engine = crankstar.load(str(place), changes=changes)
    alone = _roll(engine, 2.5, mass=0.0, speed=100 * pi, places=[])
    assert most["high"] == pytest.approx(alone, rel=1e-6)
    said = " ".join(run("analyze", str(place)).out.split())
    low, high = (f"{row[end]:.3g}" for end in ("low", "high"))
    assert f"With a bore of {low} mm to {high} mm (type diesel) the rolling moment of " in said
    assert "not in these numbers" in said


def test_gas_without_a_speed_is_that_of_usual_speeds(run: Run, tmp_path: Path) -> None:
    """Gas and inertia together in N m, while the inertia alone counts in m r w^2."""
    place = tmp_path / "gen.toml"
    place.write_text(GENSET)
    row = _row(run, "gas", "analyze", str(place))
    most = row["moves"]
    assert (row["lacks"], row["unit"], most["unit"]) == ("speed", "rpm", "N*m")
    assert (row["low"], row["high"]) == (pytest.approx(687.5), pytest.approx(990.0))
    engine = crankstar.load(str(place))
    evenly = [n * pi / 2 for n in range(8)]
    sizes = [
        _roll(engine, 4, mass=150.0, speed=row[end] * pi / 30, places=evenly)
        for end in ("low", "high")
    ]
    assert most["order"] == 4
    assert min(sizes) >= most["low"] * (1 - 1e-4)
    assert max(sizes) == pytest.approx(most["high"], rel=1e-3)


def test_inertia_without_masses_is_that_of_usual_masses(run: Run, tmp_path: Path) -> None:
    """With a mass on each piston the second order of gas and inertia, by a road of its own."""
    place = tmp_path / "four.toml"
    place.write_text(FOUR)
    row = _row(run, "cylinder.reciprocating_mass", "torque", str(place))
    most = row["moves"]
    assert (row["status"], row["unit"], most["order"]) == ("left out", "kg", 2)
    engine, speed = crankstar.load(str(place)), 6500 * pi / 30
    evenly = [n * pi for n in range(4)]
    now, low, high = (
        _roll(engine, 2, mass=mass, speed=speed, places=evenly)
        for mass in (0.0, row["low"], row["high"])
    )
    assert most["now"] == pytest.approx(now, rel=1e-4)
    assert most["high"] == pytest.approx(max(low, high), rel=1e-3)
    assert most["effect"] == pytest.approx((max(low, high) - now) / max(low, high), rel=1e-3)
    assert row["low"] < 0.468 + 0.3 * 0.498 < row["high"]  # of a 2JZ, of the same bore


def test_what_gas_without_a_bore_does_to_mounts_has_its_size(tmp_path: Path) -> None:
    """A block of known mass moves at both ends of the bore as in a file with that bore."""
    place = tmp_path / "five.toml"
    place.write_text(FIVE + MOUNTS + '[block]\nmass = "190 kg"\n')
    speeds = (75.0, 80.0)
    engine = crankstar.load(str(place))
    answer = on_mounts(engine, speeds=speeds)
    (row,) = moved(engine, answer.choices, answer)
    most = row.moved
    assert most is not None
    assert dict(row.values)["lacks"] == "cylinder.bore"
    assert most.quantity == "mount moment"
    sizes: list[float] = []
    for bore in (row.low, row.high):
        changes = {"cylinder.bore": f"{bore} mm"}
        found = mounts(crankstar.load(str(place), changes=changes), speeds=speeds)
        assert found.over is not None
        waves = np.abs(found.over.ground_force[..., 3:]) ** 2 / 2
        sizes.append(float(np.sqrt(waves.sum(axis=(1, 2))).max()))
    assert most.high == pytest.approx(max(sizes), rel=1e-3)
    assert most.low == pytest.approx(min(sizes), rel=1e-3)
    assert most.now < most.low


def test_what_cannot_be_estimated_stays_without_a_size(run: Run, tmp_path: Path) -> None:
    """A mean pressure at the brake needs a speed beside the bore: neither alone gives a cycle."""
    place = tmp_path / "five.toml"
    place.write_text(FIVE.replace('speed = "3000 rpm"\n', ""))
    assert _row(run, "gas", "analyze", str(place))["moves"] is None
    assert "Not in the rolling moment: gas (" in " ".join(run("analyze", str(place)).out.split())
