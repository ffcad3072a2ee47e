"""Values of combustion, oil and materials that no engine has are asked about."""

from __future__ import annotations

from typing import Any

import pytest
from tests.commands import Run

from crankstar.files.catalog import load, names
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.usual_values import oil_doubts

OIL = {
    "viscosity": "8 mPa*s",
    "main": {"diameter": "58 mm", "length": "22 mm", "clearance": "25 um"},
    "pin": {"diameter": "47.8 mm", "length": "20 mm", "clearance": "25 um"},
}
CRANK = {
    "journal_diameter": "58 mm",
    "journal_length": "25 mm",
    "pin_diameter": "47.8 mm",
    "pin_length": "22 mm",
    "web_thickness": "18 mm",
    "web_width": "80 mm",
}
TWISTING = {"inertia": "0.03 kg*m^2", "dimensions": CRANK}
BURNING: dict[str, Any] = {"gas.combustion_duration": "60 deg", "drive.inertia": "0.3 kg*m^2"}


def told(changes: dict[str, Any]) -> list[str]:
    """The paths of what is doubted of an engine with these values, beside what it had."""
    start = {"oil": OIL, "torsion": TWISTING, **BURNING}
    before = [fault.sentence for fault in doubts(load("audi-25-tfsi", changes=start))]
    after = doubts(load("audi-25-tfsi", changes=start | changes))
    return [".".join(map(str, each.path)) for each in after if each.sentence not in before]


@pytest.mark.quick
@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("gas.wiebe_a", 0.005),
        ("gas.intake_temperature", "16 K"),
        ("gas.wall_temperature", "1350 K"),
        ("gas.crankcase_pressure", "20 bar"),
        ("gas.exhaust_pressure", "0.075 bar"),
        ("gas.combustion_duration", "0.06 deg"),
        ("drive.inertia", "300 kg*m^2"),
        ("oil.viscosity", "0.008 mPa*s"),
        ("oil.main.diameter", "58 m"),
        ("oil.pin.length", "0.02 mm"),
        ("oil.pin.clearance", "0.0025 mm"),
        ("torsion.dimensions.shear_modulus", "80 MPa"),
    ],
)
def test_a_value_that_no_engine_has_is_asked_about_by_its_key(path: str, value: Any) -> None:
    assert told({path: value}) == [path]


@pytest.mark.quick
def test_an_operating_point_is_asked_about_by_its_number() -> None:
    point = {"name": "idle", "speed": "750 rpm", "imep": "1.4 bar", "exhaust_pressure": "100 Pa"}
    assert "gas.point.0.exhaust_pressure" in told({"gas.point": [point]})


def test_nothing_of_the_catalog_is_asked_about() -> None:
    for name in names():
        found = [*doubts(load(name)), *oil_doubts(load(name))]
        assert not {"doubt.usual", "doubt.great-flywheel"} & {fault.code for fault in found}


@pytest.mark.quick
def test_it_is_told_with_its_unit(run: Run) -> None:
    out = run("torque", "audi-25-tfsi", "--set", "gas.wall_temperature=1350 K").out
    wanted = "gas.wall_temperature is 1350 K; hardly any engine has less than 250 K or more than"
    assert wanted in " ".join(out.split())
