"""EXUDYN, a multibody program, finds the forces that this package finds."""

from __future__ import annotations

import re
import runpy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crankstar import load, spectra
from crankstar.engine.engine import Engine
from crankstar.exports.exudyn import exudyn_script
from crankstar.files import engine_of
from crankstar.files.estimate import estimated
from crankstar.mechanics.excitation import Reference, part_spectra, rolling_moment, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy import with_balance_shaft, with_counterweights

SPEED = 200.0
POINT = Reference(0.03, 0.02, -0.01)
CYLINDER = {"stroke": "80 mm", "rod_length": "140 mm", "reciprocating_mass": "500 g"}


def engine_file(layout: dict[str, Any], **cylinder: Any) -> Engine:
    return engine_of({"name": "engine", "layout": layout, "cylinder": {**CYLINDER, **cylinder}})


def offset_single() -> Engine:
    """An offset cylinder, its rod a rigid body, a heavy throw and a counterweight."""
    rod = {"mass": "600 g", "centre": "45 mm", "inertia": "0.002 kg*m^2"}
    one = engine_file(
        {"type": "inline", "throws": ["0 deg"], "bore_pitch": "90 mm"},
        offset="12 mm",
        rod=rod,
        rotating_mass="700 g",
    )
    return with_counterweights(one, factor=0.6, planes=[0.03, -0.05])


def with_two_balance_shafts() -> Engine:
    triple = engine_file(
        {"type": "inline", "throws": ["0 deg", "240 deg", "120 deg"], "bore_pitch": "90 mm"}
    )
    triple = with_counterweights(triple, factor=0.5)
    return with_balance_shaft(triple, ratio=-1, planes=[0.1, -0.1])


def radial() -> Engine:
    return engine_file(
        {
            "type": "radial",
            "rows": [{"cylinders": [1, 2, 3], "bearing": "10 deg"}],
            "knuckle_radius": "25 mm",
        },
        rotating_mass="300 g",
    )


ENGINES = {
    "offset single with a rigid rod": offset_single,
    "three with a balance shaft": with_two_balance_shafts,
    "radial with slave rods": radial,
    "geared, counter-rotating": lambda: load("kr250-racer"),
    "opposed pistons": lambda: load("jumo-205"),
    "four in line": lambda: load("i4"),
    "V8": lambda: load("v8-cross-plane"),
    "large radial": lambda: load("radial-9"),
}
LONG = {"V8", "large radial", "opposed pistons", "four in line"}
CASES = [pytest.param(name, marks=[pytest.mark.release] * (name in LONG)) for name in ENGINES]


def expected(engine: Engine) -> dict[str, tuple[np.ndarray, np.ndarray, float]]:
    """Orders, amplitudes, and the greatest amplitude of any one part, by quantity."""
    parts = part_spectra(mechanism(engine), reference=POINT)
    sums = total(parts)
    pairs = {
        "force_vertical": (spectra.vertical, "force"),
        "force_horizontal": (spectra.horizontal, "force"),
        "couple_vertical": (spectra.vertical, "couple"),
        "couple_horizontal": (spectra.horizontal, "couple"),
        "torque": (spectra.amplitude, "torque"),
        "axis_moment": (spectra.amplitude, "axis_moment"),
        "roll": (spectra.amplitude, "roll"),
    }
    whole = {**sums._asdict(), "roll": rolling_moment(sums)}
    single = {**parts._asdict(), "roll": rolling_moment(parts)}
    out = {}
    for name, (amplitude, quantity) in pairs.items():
        sizes = np.abs(single[quantity].forward) + np.abs(single[quantity].backward)
        values = SPEED**2 * amplitude(whole[quantity])
        out[name] = (whole[quantity].orders, values, SPEED**2 * float(sizes.max()))
    return out


@pytest.mark.release
@pytest.mark.parametrize("name", CASES)
def test_forces_couples_and_moments_of_a_multibody_model_are_ours(
    name: str, tmp_path: Path
) -> None:
    engine = ENGINES[name]()
    script = exudyn_script(engine, speed=SPEED, reference=POINT)
    assert "crankstar" not in "".join(line for line in script.splitlines() if "import" in line)
    file = tmp_path / "model.py"
    file.write_text(script.replace("STEPS_PER_TURN = 2000", "STEPS_PER_TURN = 1000"), "utf-8")
    model = runpy.run_path(str(file))
    for quantity, (orders, values, greatest) in expected(engine).items():
        there, found = model["amplitudes"](model["results"][quantity])
        ours = np.zeros(there.size, complex)
        for order, value in zip(orders, values, strict=True):
            ours[np.isclose(there, order, atol=1e-9)] = value
        # the step of the integration shows in high orders, of which there are small ones only
        assert np.abs(found - ours).max() < 1e-4 * greatest, quantity
        assert greatest > 0


def estimated_twin() -> Engine:
    """A twin whose rods are rigid bodies, with weights on webs and on a shaft, as estimated."""
    file = {
        "name": "twin",
        "cycle": "four-stroke",
        "cylinder": {"bore": "92 mm", "stroke": "75 mm"},
        "layout": {"type": "inline", "throws": ["0 deg", "270 deg"]},
    }
    twin = with_counterweights(engine_of(dict(estimated(file).tree)), factor=0.5)
    return with_balance_shaft(twin, ratio=-1, planes=[0.1, -0.1])


@pytest.mark.parametrize("build", [estimated_twin, offset_single, with_two_balance_shafts, radial])
def test_bodies_of_a_multibody_model_are_physical(
    build: Callable[[], Engine], capfd: pytest.CaptureFixture[str]
) -> None:
    """Second moments of mass are positive, so no moment of inertia exceeds the two others."""
    script = exudyn_script(build(), speed=SPEED)
    model: dict[str, Any] = {}
    exec(script.partition("MBS.Assemble()")[0], model)  # noqa: S102 - as it is written
    assert "triangle" not in capfd.readouterr().out
    system, count = model["MBS"], 0
    for number in range(system.systemData.NumberOfObjects()):
        body = system.GetObject(number)
        if body["objectType"] != "RigidBody":
            continue
        xx, yy, zz, yz, xz, xy = body["inertia"]
        about = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        centre = body["centerOfMass"]
        second = np.eye(3) * np.trace(about) / 2 - about
        moments = second - body["mass"] * np.outer(centre, centre)  # about the centre of mass
        slack = 1e-12 * np.trace(about)
        assert np.linalg.eigvalsh(moments).min() >= -slack
        assert max(xx, yy, zz) <= (xx + yy + zz) / 2 * (1 - 1e-4) + 1e-300
        count += 1
    assert count >= 3


def test_a_model_says_which_of_its_values_are_estimated() -> None:
    head = exudyn_script(estimated_twin()).partition("SPEED = ")[0]
    assert "ESTIMATED" in head
    assert re.search(r"#   cylinder\.rod\.mass, 0\.\d+ to [12]\.\d+ times the value here", head)
    assert "ESTIMATED" not in exudyn_script(offset_single())
