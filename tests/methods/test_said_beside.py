"""What stands beside a number so that it is read aright: net forces, temperatures, assumptions."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from tests.mounted_engines import standing

import crankstar
from crankstar.derive import derivation
from crankstar.dynamics.mount_analysis import mounts
from crankstar.files.catalog import load
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.studies.sweep import sweep, watched
from crankstar.tables.resting_derivations import with_record
from crankstar.tables.sweep_notes import notes
from crankstar.tables.torque import work_table


def test_the_force_of_mounts_in_a_sweep_is_said_to_be_net() -> None:
    """By momentum: what pushes the block less what its 165 kg take, as no single mount bears it."""
    made = sweep(standing(), "speed=1500..3000 rpm/2")
    curve = watched(made, "mount_force")
    over = mounts(standing(), speeds=[100 * np.pi]).over
    assert over is not None
    taken = -165 * over.vibration[..., None] ** 2 * over.motion[..., :3]
    net = over.excitation.push[..., :3] - taken
    expected = np.sqrt((np.abs(net) ** 2).sum() / 2)
    assert curve.values[-1] == pytest.approx(expected, rel=1e-6)
    singles = [np.sqrt((np.abs(over.mount_force[:, :, k]) ** 2).sum() / 2) for k in range(3)]
    assert not np.isclose(singles, expected, rtol=0.01).any()
    assert "net force on the ground" in " ".join(str(part) for part in notes(made, [curve]))


def test_the_air_fuel_ratio_says_the_temperature_that_it_goes_with() -> None:
    """air = p V / (R T): the ratio goes with 1/T, 340 K where the file gives none.

    A warmer charge has another gamma, so that the load needs a little other heat.
    """
    gas = {"gas.process": "heat-release", "gas.compression_ratio": 10.0, "gas.imep": "8 bar"}
    gas |= {"gas.intake_pressure": "1 bar", "gas.variable_gamma": True}
    bore = {"cylinder.bore": "86 mm", "cylinder.stroke": "86 mm"}
    ratios = []
    for warm in ({}, {"gas.intake_temperature": "300 K"}):
        engine = load("i4", changes={**bore, **gas, **warm})
        found = cycle(engine)
        assert found.air_fuel_ratio is not None
        ratios.append(found.air_fuel_ratio)
        rows = [row[0] for row in work_table(found, gas_torque(found)).rows]
        said = "300" if warm else "340"
        assert f"air-fuel ratio (charge of {said} K)" in rows
    assert ratios[1] / ratios[0] == pytest.approx(340 / 300, rel=0.02)


def test_a_derivation_says_first_what_its_newtons_rest_on_most() -> None:
    five = crankstar.load("audi-25-tfsi")
    bare = derivation(five, 1, "couple")
    whole = with_record(bare, five, order=Fraction(1), quantity="couple")
    gravest, *rest = whole.steps[0].words
    assert tuple(rest) == bare.steps[0].words
    assert gravest.endswith(whole.steps[-1].words[0])
    assert "cylinder.rotating_mass" in gravest
    assert [step.title for step in whole.steps[:-1]] == [step.title for step in bare.steps]
