"""Every rod with its piston is in equilibrium under its inertia, the wall, and the pins."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.typing import NDArray
from tests.catalog import EVERY_ENGINE
from tests.newton import direction, placed, road
from tests.strategies import OF_ANY_KIND

import crankstar
from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import pin_loads

Array = NDArray[Any]
TOLERANCE = 1e-9
"""Of the greatest force of a rod, at the length of crank and rod."""


def vectors(values: Any) -> Array:
    """Vectors (x, y) of the clock plane's up + i right [..., 2]."""
    return np.stack([values.imag, values.real], axis=-1)


def cross(arm: Array, force: Array) -> Array:
    return arm[..., 0] * force[..., 1] - arm[..., 1] * force[..., 0]


def assert_in_equilibrium(engine: Engine, angles: int = 24) -> None:
    """Forces and moments on every rod with its piston, from the momentum of its bodies."""
    walked = road(engine, reference=Reference(0.0), speed=1.0)
    few = np.unique(np.linspace(0, len(walked.theta) - 1, angles).astype(int))
    theta = walked.theta[few]
    loads = pin_loads(mechanism(engine))
    places = {cylinder.number: row for row, cylinder in enumerate(engine.cylinders)}
    guide, own = (
        vectors(spectra.value(load, theta.astype(float))) for load in (loads.guide, loads.pin)
    )
    slaves: dict[int, list[Cylinder]] = {number: [] for number in places}
    for cylinder in engine.cylinders:
        if cylinder.articulated:
            slaves[cylinder.articulated.master].append(cylinder)

    def on_pin(cylinder: Cylinder) -> Array:
        return own[places[cylinder.number]] + sum(map(on_pin, slaves[cylinder.number]), 0.0)

    for cylinder in engine.cylinders:
        shaft = engine.shaft(cylinder.shaft)
        axis = np.array([shaft.right, shaft.up])
        pin, piston, _ = placed(engine, cylinder, theta)
        wall = guide[places[cylinder.number]]
        force, moment = -on_pin(cylinder) - wall, -cross(pin + axis, on_pin(cylinder))
        moment = moment - cross(piston + axis, wall)
        for slave in slaves[cylinder.number]:
            knuckle = placed(engine, slave, theta)[0] + axis
            force, moment = force + on_pin(slave), moment + cross(knuckle, on_pin(slave))
        size = np.abs(on_pin(cylinder)).max() + np.abs(wall).max()
        for body, push in zip(walked.bodies, walked.pushes, strict=True):
            if body.cylinder == cylinder.number:
                force, moment = force + push.force[few, :2], moment + push.moment[few, 2]
                size = max(size, float(np.abs(push.force).max()))
        reach = np.abs(piston + axis).max() + np.abs(pin + axis).max()
        assert np.abs(force).max() <= TOLERANCE * size
        assert np.abs(moment).max() <= TOLERANCE * size * reach
        assert np.abs(wall @ direction(np.array(cylinder.bearing))).max() <= TOLERANCE * size


@EVERY_ENGINE
def test_the_rods_of_every_engine_of_the_catalog_are_in_equilibrium(name: str) -> None:
    assert_in_equilibrium(crankstar.load(name))


def test_offset_rods_of_a_crankshaft_that_turns_backward_are_in_equilibrium() -> None:
    """What presses on the wall all the time has the sign of the square of the speed."""
    engine = crankstar.load("kr250-racer", changes={"cylinder.offset": "4 mm"})
    assert {shaft.speed_ratio for shaft in engine.shafts} == {1, -1}
    assert_in_equilibrium(engine)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("kind", OF_ANY_KIND)
def test_the_rods_of_any_engine_are_in_equilibrium(kind: str) -> None:
    @settings(max_examples=15, deadline=None)
    @given(engine=OF_ANY_KIND[kind])
    def holds(engine: Engine) -> None:
        assert_in_equilibrium(engine)

    holds()
