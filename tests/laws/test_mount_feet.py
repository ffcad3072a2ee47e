"""Mounts on feet that give way by a receptance: second body, series of springs, energy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.files.test_mounts import BLOCK, GROUND, THREE, mistakes
from tests.texts import SHORT, spoilt

import crankstar
from crankstar.dynamics.mount_excitation import MountExcitation
from crankstar.dynamics.mount_response import MountResponse, mount_response, rms
from crankstar.dynamics.mounted_block import mounted_block
from crankstar.engine.mounts import FootReceptance
from crankstar.files import engine_of, toml, tree_of

SPEEDS = np.geomspace(10.0, 900.0, 60)
BODY = {"inertia_up": "40 kg*m^2", "inertia_right": "40 kg*m^2", "inertia_z": "30 kg*m^2"}
FOOT = [
    {"frequency": "10 Hz", "amplitude": "0.4 um/N", "lag": "15 deg"},
    {
        "frequency": "80 Hz",
        "amplitude": ["2 um/N", "0.1 um/N", "0.05 um/N"],
        "lag": ["90 deg", "0 deg", "180 deg"],
    },
    {"frequency": "300 Hz", "amplitude": "0.2 um/N", "lag": "170 deg"},
]


def mounted(mounts: list[dict[str, Any]], **more: Any) -> crankstar.Engine:
    return engine_of(spoilt(SHORT, block=BLOCK, mounts=mounts, **more))


def corners(**more: Any) -> list[dict[str, Any]]:
    """Four alike mounts in the plane of the centre of mass, about it."""
    at = [(r, z) for r in (-0.3, 0.3) for z in (-0.2, 0.2)]
    rubber = {"up": "0.112 m", "stiffness": "150 N/mm", "loss_factor": 0.1}
    return [{"name": f"{r} {z}", "right": f"{r} m", "z": f"{z} m", **rubber, **more} for r, z in at]


def lifted(engine: crankstar.Engine) -> MountResponse:
    """The answer to a force of 1 N straight up through the centre of mass, at each frequency."""
    up = np.zeros((SPEEDS.size, 1, 6), complex)
    up[..., 0] = 1.0
    none = np.zeros((1, 6))
    return mount_response(mounted_block(engine), MountExcitation(SPEEDS, np.ones(1), none, up))


def test_a_foundation_and_its_receptance_are_one_under_a_force_straight_up() -> None:
    """A second body below four mounts, against the receptance that each foot of it has."""
    z0 = mounted_block(mounted(corners())).centres[0][2]
    own = [{**each, "z": f"{float(each['z'].split()[0]) + z0} m"} for each in corners()]
    mass, stiffness, eta = 400.0, 4e6, 0.05
    below = {"up": "0 m", "stiffness": f"{stiffness / 4} N/m", "loss_factor": eta}
    ground = [{**each, **below, "name": f"below {each['name']}"} for each in own]
    body = {"mass": f"{mass} kg", "z": f"{z0} m", **BODY}
    moving = lifted(mounted(own, foundation={**body, "mounts": ground}))
    at = np.linspace(5.0, 950.0, 1000)
    shared = 4 / (stiffness * (1 + 1j * eta) - at**2 * mass)  # four feet move it together
    foot = [
        {
            "frequency": f"{f} rad/s",
            "amplitude": f"{abs(a)} m/N",
            "lag": f"{max(-np.angle(a), 0.0)} rad",
        }
        for f, a in zip(at, shared, strict=True)
    ]
    yielding = lifted(mounted([{**each, "foot": foot} for each in own]))
    wanted = moving.motion[:, 0, 0]
    assert yielding.motion[:, 0, 0] == pytest.approx(wanted, abs=5e-3 * np.abs(wanted).max())
    assert np.allclose(yielding.motion[:, 0, 0], wanted, rtol=2e-2)
    passed = rms(moving.mount_force[:, :, 0])
    assert rms(yielding.mount_force[:, :, 0]) == pytest.approx(passed, rel=2e-2)


def test_at_rest_a_foot_is_a_spring_in_series() -> None:
    soft = [{"frequency": "1 rad/s", "amplitude": "5 um/N"}]
    engine = mounted(corners(foot=soft, loss_factor=0))
    up = np.zeros((1, 1, 6), complex)
    up[..., 0] = 1.0
    still = MountExcitation(np.array([1e-3]), np.ones(1), np.zeros((1, 6)), up)
    found = mount_response(mounted_block(engine), still)
    series = 1 / (1 / 150e3 + 5e-6)
    assert found.motion[0, 0, 0] == pytest.approx(1 / (4 * series), rel=1e-6)


def test_feet_that_hardly_give_way_are_none() -> None:
    hard = [{"frequency": "100 rad/s", "amplitude": "1e-14 m/N"}]
    with_feet = lifted(mounted([{**each, "foot": hard} for each in THREE]))
    assert with_feet.motion == pytest.approx(lifted(mounted(THREE)).motion, rel=1e-6)


def test_what_the_forces_put_in_goes_into_mounts_and_feet() -> None:
    gas = {"imep": "8 bar", "compression_ratio": 10}
    engine = mounted([{**each, "foot": FOOT} for each in THREE], gas=gas)
    over = crankstar.mounts(engine, speeds=[70.0, 200.0, 500.0]).over
    assert over is not None
    force = over.mount_force
    moved = over.block.receptance(over.vibration) * force
    rate = 1j * over.vibration[..., None, None] * moved
    sunk = np.real(force * np.conj(rate)).sum(axis=(1, 2, 3)) / 2
    assert np.all(sunk > 0)
    assert over.heat.sum(axis=1) + sunk == pytest.approx(over.power, rel=1e-9)


def test_receptances_lie_straight_between_those_given() -> None:
    block = mounted_block(mounted([{**each, "foot": FOOT} for each in THREE]))
    low, high = (np.array(each.along) for each in block.mounts[0].foot[:2])
    middle = 2 * np.pi * 45.0
    assert block.receptance(middle)[0] == pytest.approx((low + high) / 2)
    assert block.receptance(1.0)[0] == pytest.approx(low)
    assert FootReceptance(frequency=1.0, amplitude=(1.0,)).along == (1, 1, 1)


def test_feet_are_the_same_written_and_read_back() -> None:
    engine = mounted([{**each, "foot": FOOT} for each in THREE])
    again = engine_of(tree_of(toml(engine)))
    assert again.mounts == engine.mounts


@pytest.mark.parametrize(
    ("foot", "path", "code"),
    [
        (FOOT[::-1], "mounts.0.foot", "mounts.foot-order"),
        ([{**FOOT[0], "lag": "-30 deg"}], "mounts.0.foot.0.lag", "mounts.foot-lag"),
        (
            [{**FOOT[0], "amplitude": ["1 um/N", "1 um/N"]}],
            "mounts.0.foot.0.amplitude",
            "mounts.length",
        ),
    ],
)
def test_receptances_that_cannot_be_are_faults(foot: Any, path: str, code: str) -> None:
    own = [{**THREE[0], "foot": foot}, *THREE[1:]]
    assert mistakes(block=BLOCK, mounts=own) == [(path, code)]


def test_feet_and_a_foundation_are_one_too_many() -> None:
    own = [{**THREE[0], "foot": FOOT}, *THREE[1:]]
    found = mistakes(block=BLOCK, mounts=own, foundation=GROUND)
    assert found == [("foundation", "mounts.foot-and-foundation")]
