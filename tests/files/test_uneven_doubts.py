"""A drive inertia without flywheel and rotor is doubted, with what would be usual."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

from crankstar.dynamics.uneven_doubts import uneven_doubts
from crankstar.files import engine_of, toml
from crankstar.mechanics.gas import cycle

STROKE, ROD, PISTON, BORE, TURNING = 0.155, 0.251, 4.1, 0.126, 50 * np.pi
SET: dict[str, Any] = {
    "name": "genset six",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "speed": "1500 rpm",
    "cylinder": {
        "bore": "126 mm",
        "stroke": "155 mm",
        "rod_length": "251 mm",
        "reciprocating_mass": "4.1 kg",
    },
    "gas": {"ignition": "compression", "bmep": "18 bar"},
    "drive": {"inertia": "0.3 kg*m^2"},
    "layout": {"type": "inline", "bore_pitch": "147 mm"},
}


def _changed(**drive: Any) -> dict[str, Any]:
    return {**SET, "drive": {**SET["drive"], **drive}}


def _swing() -> tuple[float, float]:
    """The change of energy over a cycle (J) and the mean inertia of the pistons, from pressure.

    Six alike 120 deg apart: A p dx/dtheta less its mean, summed up, and m (dx/dtheta)^2 w^2/2.
    """
    own = cycle(engine_of(SET))
    theta = np.linspace(0, 4 * np.pi, 3600, endpoint=False)
    side = ROD**2 - (STROKE / 2 * np.sin(theta)) ** 2
    travel = STROKE / 2 * np.sin(theta) * (1 + STROKE / 2 * np.cos(theta) / np.sqrt(side))
    first = own.pressure[0] - own.crankcase
    torque = np.pi / 4 * BORE**2 * first * travel
    shifted = [np.roll(np.stack([torque, PISTON * travel**2]), 600 * n, axis=1) for n in range(6)]
    gas, inertia = np.sum(shifted, axis=0)
    work = np.cumsum(gas - gas.mean()) * (theta[1] - theta[0])
    energy = work - inertia * TURNING**2 / 2
    return float(np.ptp(energy)), float(inertia.mean())


def _row(run: Run, folder: Path, command: str, tree: dict[str, Any]) -> dict[str, Any] | None:
    path = folder / "own.toml"
    path.write_text(toml(engine_of(tree)))
    told = json.loads(run(command, str(path), "--json").out)
    rows = [row for row in told["rests_on"] if row["path"] == "drive.inertia"]
    return rows[0] if rows else None


def test_the_doubt_says_how_uneven_and_what_would_be_usual() -> None:
    swing, moving = _swing()
    (fault,) = uneven_doubts(engine_of(SET), cycle(engine_of(SET)), generating=True)
    parts = (0.3 + moving) * TURNING**2 / swing
    assert fault.values["parts"] == pytest.approx(parts, rel=0.02)
    assert fault.values["enough"] == pytest.approx(100 * swing / TURNING**2 - moving, rel=0.02)


@pytest.mark.release
@pytest.mark.parametrize(("command", "parts"), [("genset", 100), ("torque", 30)])
def test_genset_and_torque_try_it(command: str, parts: int, run: Run, tmp_path: Path) -> None:
    swing, moving = _swing()
    row = _row(run, tmp_path, command, SET)
    assert row is not None
    assert row["status"] == "doubtful"
    assert row["low"] == row["high"] == pytest.approx(parts * swing / TURNING**2 - moving, rel=0.03)
    assert row["moves"]["quantity"] == "irregularity"
    assert row["moves"]["low"] == pytest.approx(1 / parts, rel=0.03)


def test_a_flywheel_with_rotor_is_not_doubted(run: Run, tmp_path: Path) -> None:
    even = _changed(inertia="5 kg*m^2")
    assert _row(run, tmp_path, "genset", even) is None


def test_the_load_of_a_generator_tells_a_set_everywhere() -> None:
    little = engine_of(_changed(inertia="1.5 kg*m^2"))
    assert not uneven_doubts(little, cycle(little))
    little = engine_of(_changed(inertia="1.5 kg*m^2", load_exponent=-1))
    (fault,) = uneven_doubts(little, cycle(little))
    assert fault.code == "doubt.uneven-set"


def test_other_engines_may_idle_unevenly() -> None:
    engine = engine_of(SET)
    assert not uneven_doubts(engine, cycle(engine, speed=30 * np.pi))  # 4.7 m/s
    assert not uneven_doubts(engine, cycle(engine, off=[2]))
    assert not uneven_doubts(engine, cycle(engine, motored=True))


def test_check_says_it(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(toml(engine_of(SET)))
    told = " ".join(run("check", str(path)).out.split())
    assert "drive.inertia is 0.3 kg m²" in told
    assert "one part in about 6.4" in told
