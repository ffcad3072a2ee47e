"""Torsional vibration with a cylinder that does not fire, or weakly: half orders, by two roads."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.mechanics.gas_torque import piston_torque
from crankstar.spectra import amplitude, selected

SIX = str(Path(__file__).parents[1] / "cases" / "torsion-six.toml")
ONE_BAR = {"gas.intake_pressure": "1 bar"}
"""The charge for which the values beside the case were computed."""


def test_a_dead_cylinder_twists_the_coupling_of_a_generating_set() -> None:
    """Values of the case, computed from a pressure trace in which cylinder 3 is motored."""
    found = crankstar.torsion(SIX, off=[3], speed="1500 rpm", changes=ONE_BAR)
    at = found.sections_at_speed.to_frame().iloc[-1]
    assert at["torque_N_m"] == pytest.approx(1055.8, rel=1e-4)
    assert found.heat.to_frame()["heat_W"].iloc[-1] == pytest.approx(16.218, rel=1e-4)
    fast = crankstar.torsion(SIX, off=[3], speed="1778.7 rpm", changes=ONE_BAR)
    assert fast.heat.to_frame()["heat_W"].max() == pytest.approx(3.85e3, rel=2e-3)


def test_half_orders_are_those_of_an_equation_solved_by_hand() -> None:
    """(K - k^2 w^2 M + i k w C) turns = torque, in matrices of the chain, order by order."""
    speed = 1500 * pi / 30
    engine = crankstar.load(SIX, changes=ONE_BAR)
    found = crankstar.torsion(engine, off=[3], weaker={5: 0.3}, speed=speed)
    chain = torsion_chain(engine)
    burnt = crankstar.cycle(engine, off=[3], weaker={5: 0.3}, speed=speed)
    at = found.at
    for order in (0.5, 1.0, 2.5, 3.0):
        [index] = np.flatnonzero(at.orders == order)
        driving = at.driving[0, index]
        gas = amplitude(selected(piston_torque(engine, burnt), [order]))[:, 0]
        alone = np.zeros(len(chain.names), complex)
        np.add.at(alone, list(chain.cylinders), gas)
        inertia = driving - alone  # order 0.5 and 2.5 have none: all of it is gas
        if order % 1:
            assert np.abs(inertia).max() < 1e-9 * np.abs(alone).max()
        moved = at.turns[0, index]
        forces = np.zeros(len(chain.names), complex)
        for place, section in enumerate(chain.sections):
            torque = at.torque[0, index, place]
            forces[section.before] += section.ratio * torque
            forces[section.after] -= torque
        rate = -((order * speed) ** 2) * chain.inertia * moved
        damping = 1j * order * speed * chain.absolute_damping * moved
        assert np.abs(rate + damping - forces - driving).max() < 1e-6 * np.abs(driving).max()


def test_over_a_range_the_same_cylinders_are_off_as_at_one_speed() -> None:
    """The gas between the speeds of a range is that of the misfire, half orders too."""
    load = {"off": [3], "weaker": {5: 0.3}}
    swept = crankstar.torsion(SIX, speeds=[100.0, 157.0], **load).value.response
    alone = crankstar.torsion(SIX, speed=157.0, **load).value.at
    [index] = np.flatnonzero(swept.speeds == 157.0)
    half = np.flatnonzero(swept.orders == 0.5)
    assert np.abs(alone.torque[0, half]).max() > 100
    assert np.allclose(swept.torque[index], alone.torque[0], rtol=1e-6, atol=1e-6)


@pytest.mark.release
def test_it_is_an_option_of_the_command_and_a_fact_of_its_answer(run: Run) -> None:
    words = ("torsion", SIX, "--speed", "1500 rpm", "--json")
    out = json.loads(run(*words, "--off", "3", "--weaker", "5=30%").out)
    assert (out["off"], out["weaker"]) == ([3], {"5": 0.3})
    assert run(*words, "--off", "3", "--weaker", "3=30%").code == 2
    assert run(*words, "--off", "9").code == 2
