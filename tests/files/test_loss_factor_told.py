"""The loss factor of the shafts is assumed, and said, also where no resonance makes it matter."""

import json
from pathlib import Path

import pytest
from tests.commands import Run

STIFF = """
name = "two"
cycle = "four-stroke"
speed = "1500 rpm"
[cylinder]
stroke = "90 mm"
rod_length = "145 mm"
reciprocating_mass = "480 g"
[layout]
type = "inline"
throws = ["0 deg", "180 deg"]
bore_pitch = "91 mm"
[torsion]
bare_inertia = "0.01 kg*m^2"
stiffness = "0.5 MN*m/rad"
[[torsion.disc]]
name = "flywheel"
inertia = "0.1 kg*m^2"
to = "rear"
"""
LINE = """
name = "line"
[[disc]]
name = "a"
inertia = "1 kg*m^2"
[[disc]]
name = "b"
inertia = "2 kg*m^2"
stiffness = "1 kN*m/rad"
to = "a"
"""


@pytest.mark.release
def test_heat_of_an_assumed_loss_factor_says_so(run: Run, tmp_path: Path) -> None:
    """Far below resonance a shaft turns as its stiffness says, and loses eta k x^2 w / 2."""
    (tmp_path / "two.toml").write_text(STIFF, encoding="utf-8")
    heats = []
    asked = ("torsion", "two.toml", "--speeds", "1400..1500rpm")
    for more in ((), ("--set", "torsion.loss_factor=0.04")):
        out = json.loads(run(*asked, *more, "--json").out)
        heats.append([row["heat"] for row in out["heat"]])
        [*told] = (row for row in out["rests_on"] if row["path"] == "torsion.loss_factor")
        assert [(row["value"], row["moves"]) for row in told] == ([] if more else [(0.02, None)])
    assert heats[1] == pytest.approx([2 * heat for heat in heats[0]], rel=5e-3)
    assert "Assumed: torsion.loss_factor (0.02)." in run(*asked).out
    assert "loss_factor" not in run("verdict", "two.toml").out  # it shows none, nor their heat


def test_a_drive_line_at_no_speed_says_so(run: Run, tmp_path: Path) -> None:
    (tmp_path / "line.toml").write_text(LINE, encoding="utf-8")
    assert "Assumed: loss_factor (0.02)." in run("torsion", "line.toml").out
    given = LINE.replace('name = "line"', 'name = "line"\nloss_factor = 0.02')
    (tmp_path / "line.toml").write_text(given, encoding="utf-8")
    assert "Assumed" not in run("torsion", "line.toml").out
