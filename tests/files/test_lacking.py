"""What a file lacks is named key by key; a flywheel is sized without having one."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.analyses.marine.doubts import doubts
from crankstar.analyses.marine.marine_analysis import marine
from crankstar.analysis.document import Remarks
from crankstar.dynamics.uneven import SAMPLES, driven
from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import over_cycle
from crankstar.studies.answers import torques
from crankstar.studies.assumed_values import assumed_values
from crankstar.tables.assumptions import assumption_lines
from crankstar.tables.gas_rolls import gasless_reason
from crankstar.tables.torque import torque_document

THREE: dict[str, Any] = {
    "format": 1,
    "name": "three",
    "firing_order": [1, 3, 2],
    "cylinder": {
        "bore": "71 mm",
        "stroke": "84 mm",
        "rod_length": "137 mm",
        "reciprocating_mass": "330 g",
        "rotating_mass": "300 g",
    },
    "layout": {"type": "inline", "bore_pitch": "78 mm"},
    "gas": {"imep": "12 bar", "compression_ratio": 10.5},
    "drive": {"inertia": "0.11 kg*m^2"},
}
MASSES = ("cylinder.reciprocating_mass", "cylinder.rotating_mass", "drive.inertia")
SINGLE = THREE | {"firing_order": [1], "layout": {"type": "inline", "throws": ["0 deg"]}}
SET: dict[str, Any] = {
    "format": 1,
    "name": "set",
    "firing_order": [1, 4, 7, 6, 8, 5, 2, 3],
    "cylinder": {
        "bore": "320 mm",
        "stroke": "400 mm",
        "rod_length": "800 mm",
        "reciprocating_mass": "150 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "490 mm"},
    "gas": {"ignition": "compression", "bmep": "22 bar", "intake_pressure": "2.4 bar"},
}


def _without(*paths: str, **changes: Any) -> dict[str, Any]:
    """The three without these keys of its file, others changed."""
    tree = json.loads(json.dumps(THREE)) | changes
    for path in paths:
        table, _dot, key = path.rpartition(".")
        del (tree[table] if table else tree)[key]
    return tree


def _error(run: Run, folder: Path, tree: dict[str, Any], verb: str, *words: str) -> str:
    path = folder / "three.json"
    path.write_text(json.dumps(tree))
    return " ".join(run(verb, str(path), *words).err.split())


@pytest.mark.parametrize(
    ("missing", "keys"),
    [
        ((), "give speed"),
        (("drive.inertia",), "give speed, drive.inertia"),
        (MASSES, "give speed, cylinder.reciprocating_mass, drive.inertia"),
    ],
)
def test_uneven_running_in_a_sweep_names_what_lacks(
    run: Run, tmp_path: Path, missing: tuple[str, ...], keys: str
) -> None:
    words = ("--over", "gas.imep=2..14 bar/2", "--quantity", "irregularity")
    assert _error(run, tmp_path, _without(*missing), "sweep", *words).endswith(keys)


def test_bearings_with_gas_name_what_lacks(run: Run, tmp_path: Path) -> None:
    assert _error(run, tmp_path, THREE, "bearings", "--gas").endswith(": give speed")
    tree = _without(*MASSES, speed="6500 rpm")
    said = _error(run, tmp_path, tree, "bearings", "--gas")
    assert said.endswith(": give cylinder.reciprocating_mass")


def test_a_balance_names_what_its_rolling_moment_of_gas_lacks() -> None:
    said = gasless_reason(engine_of(THREE), speed=None)
    assert said.endswith("not in these numbers: the engine file lacks speed.")
    assert gasless_reason(engine_of(THREE), speed=300.0) == ""
    bare = gasless_reason(engine_of(_without("gas", "cylinder.bore")), speed=300.0)
    assert bare.endswith("the engine file lacks [gas], cylinder.bore.")


def test_moments_of_guides_name_what_they_lack() -> None:
    out = doubts(marine(engine_of(THREE)), None)
    assert "Guide-force moments are those of gas alone: without speed there is no inertia." in out
    lacking = (
        "The file lacks what it takes for N m: {}; moments are in units of the first cylinder."
    )
    assert lacking.format("speed") in out
    out = doubts(marine(engine_of(_without("layout.bore_pitch")), speed=300.0), None)
    assert lacking.format("layout.bore_pitch") in out
    assert not any("gas alone" in line for line in out)
    assert not any(
        "The file lacks" in line for line in doubts(marine(engine_of(THREE), speed=9.0), None)
    )


@pytest.mark.parametrize(
    ("tree", "speed", "said"),
    [
        (THREE, None, "a speed (see --speed)"),
        (THREE, 300.0, ""),
        (_without("drive"), 300.0, "inertia of crankshaft, flywheel and rotor (see --flywheel)"),
    ],
)
def test_torque_says_why_uneven_running_is_not_told(
    tree: dict[str, Any], speed: float | None, said: str
) -> None:
    engine = engine_of(tree)
    found = cycle(engine, speed=speed)
    told = torque_document(engine, found, running=driven(engine, found))
    lines = [line for part in told.parts if isinstance(part, Remarks) for line in part.lines]
    assert (f"Without uneven running: not known: {said}." in lines) == bool(said)
    assert any(table.key == "running" for table in told.tables) != bool(said)
    assert told.facts["without_running"] == (f"not known: {said}" if said else None)


def _uneven(flywheel: float, speed: float) -> float:
    """The degree of irregularity by the energy over a cycle, J(theta) of pistons as points."""
    engine = engine_of(SET)
    found = cycle(engine, speed=speed)
    theta = np.arange(SAMPLES) * 4 * np.pi / SAMPLES
    gas = over_cycle(found, SAMPLES).sum(axis=0)
    own = np.full(SAMPLES, flywheel)
    for cylinder in engine.cylinders:
        at = theta + engine.throw(cylinder).angle
        sine, cosine = 0.2 * np.sin(at), 0.2 * np.cos(at)
        own += 150 * (sine + sine * cosine / np.sqrt(0.8**2 - sine**2)) ** 2
    rest = gas - gas.mean()
    work = np.concatenate([[0.0], np.cumsum(rest[:-1] + rest[1:])]) / 2 * theta[1]
    low, high = -work.min() * (1 + 1e-9), 10 * own.max() * speed**2
    for _ in range(200):  # the energy whose mean speed over time is this one
        energy = (low + high) / 2
        turning = np.sqrt(2 * (energy + work) / own)
        low, high = (energy, high) if np.mean(1 / turning) > 1 / speed else (low, energy)
    return float((turning.max() - turning.min()) / speed)  # pyright: ignore


def test_a_flywheel_is_sized_for_a_set_that_has_none() -> None:
    speed, engine = 750 * np.pi / 30, engine_of(SET)
    wanted = crankstar.genset(engine, speed=speed, irregularity=1 / 250).wanted
    forward = driven(engine, cycle(engine, speed=speed), flywheel=wanted)
    assert forward is not None
    assert forward.irregularity == pytest.approx(1 / 250, rel=1e-9)
    assert _uneven(wanted, speed) == pytest.approx(1 / 250, rel=1e-3)
    torque = crankstar.torque(engine, speed=speed, irregularity=1 / 250)
    assert torque.wheel.inertia == pytest.approx(wanted, rel=1e-12)


def test_the_record_of_a_sized_flywheel_says_that_the_file_has_none() -> None:
    engine, speed = engine_of(SET), 750 * np.pi / 30
    for degree, status in ((1 / 250, "missing"), (None, "left out")):
        answer = torques(engine, partial(cycle, speed=speed), irregularity=degree)
        [none] = [each for each in assumed_values(engine, answer) if each.path == "drive.inertia"]
        assert none.status == status
        told = " ".join(assumption_lines([none]))
        assert ("no flywheel beside the one that is sized" in told) == (degree is not None)


def test_a_set_without_masses_has_no_flywheel_sized(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "set.json"
    path.write_text(json.dumps(SET | {"cylinder": {"bore": "320 mm", "stroke": "400 mm"}}))
    asked = ("--speed", "750 rpm", "--irregularity", "1/250")
    assert "--irregularity has no effect" in " ".join(run("genset", str(path), *asked).err.split())
