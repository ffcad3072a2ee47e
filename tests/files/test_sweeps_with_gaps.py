"""A sweep whose first value cannot fire says so of that value, and rests on one that can."""

import json
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.studies.sweep_answers import judged

TANDEM = """\
name = "tandem"
cycle = "two-stroke"
firing_order = [1, 2]
speed = "6000 rpm"
[cylinder]
bore = "54 mm"
stroke = "54 mm"
rod_length = "110 mm"
reciprocating_mass = "250 g"
rotating_mass = "200 g"
[gas]
compression_ratio = 10
imep = "8 bar"
[[layout.cranks]]
name = "front"
banks = [{cylinders=[1]}]
[[layout.cranks]]
name = "rear"
up = "120 mm"
speed_ratio = "-1"
lag = "180 deg"
banks = [{cylinders=[2]}]
[layout]
type = "tandem"
bore_pitch = "90 mm"
"""
LAG = "layout.cranks[2].lag"


@pytest.mark.release
@pytest.mark.parametrize(("over", "gap"), [("0..180 deg/3", 0), ("180..0 deg/3", 2)])
def test_a_value_that_cannot_fire_is_named(tmp_path: Path, run: Run, over: str, gap: int) -> None:
    """Both pistons are at dead centre together at 0 deg; the torque of two pulses elsewhere.

    The mean torque of a two-stroke engine is p_i V / 2 pi, whatever the angle between the cranks.
    """
    file = tmp_path / "tandem.toml"
    file.write_text(TANDEM)
    told = run("sweep", str(file), "--over", f"{LAG}={over}", "--quantity", "mean_torque", "--json")
    out = json.loads(told.out)
    mean = 8e5 * 2 * np.pi / 4 * 0.054**3 / (2 * np.pi)
    values = [row["mean_torque"] for row in out["values"]]
    assert values.pop(gap) is None
    assert values == pytest.approx([mean, mean], rel=1e-6)
    [reason] = [line for line in out["doubts"] if line.startswith("No mean_torque")]
    assert f"at {LAG} = 0 deg: tandem does not fire in the order of the file" in reason
    assert reason.endswith("give firing_angles.")
    assert "needs a firing order" not in told.err


@pytest.mark.parametrize(("over", "at"), [("0..180 deg/3", "90 deg"), ("60..0 deg/3", "60 deg")])
def test_it_rests_on_the_nearest_value_that_fires(tmp_path: Path, over: str, at: str) -> None:
    file = tmp_path / "tandem.toml"
    file.write_text(TANDEM)
    made = crankstar.sweep(str(file), f"{LAG}={over}")
    own = judged(made, [crankstar.watched(made, "torque_with_gas")])
    assert own.at == f"{LAG} = {at}"
    assert own.engine.firing_order == (1, 2)
