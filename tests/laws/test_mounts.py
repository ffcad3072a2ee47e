"""A block on its mounts: closed forms, the free block as a limit, energy, time integration."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation
from tests.strategies import number
from tests.texts import SHORT, spoilt

from crankstar import spectra
from crankstar.dynamics import whirl
from crankstar.dynamics.mount_excitation import MountExcitation, mount_excitation
from crankstar.dynamics.mount_modes import elastic_axis, mount_modes, torque_roll_axis
from crankstar.dynamics.mount_response import MountResponse, mount_response, peak, rms
from crankstar.dynamics.mounted_block import MountedBlock, MountError, mounted_block, settled
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.mount_checks import second_moments
from crankstar.engine.mounts import Foundation, Mount
from crankstar.engine.records import Block
from crankstar.engine.rigid_block import gathered, held, mass_matrix, mount_axes, moved
from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque

MASS, UP, RIGHT, Z = 140.0, 9.6, 10.4, 4.1
BLOCK: dict[str, Any] = {
    "mass": MASS,
    "up": 0.11,
    "right": -0.02,
    "z": 0.03,
    "inertia_up": UP,
    "inertia_right": RIGHT,
    "inertia_z": Z,
}
PRODUCTS = {"product_up_right": 0.3, "product_up_z": -0.8, "product_right_z": 0.4}
LOOSE: list[dict[str, Any]] = [
    {
        "name": "left",
        "up": 0.02,
        "right": -0.3,
        "z": 0.1,
        "stiffness": [2e5, 8e4, 6e4],
        "bearing": 0.6,
        "lean": 0.2,
        "twist": 0.4,
        "loss_factor": 0.12,
    },
    {
        "name": "right",
        "up": 0.06,
        "right": 0.32,
        "z": 0.12,
        "stiffness": [1.8e5, 9e4, 7e4],
        "bearing": -0.7,
        "damping": [150.0, 60.0, 90.0],
    },
    {"name": "rear", "up": -0.03, "z": -0.4, "stiffness": [1.5e5], "loss_factor": 0.05},
]
GAS = {"imep": "8 bar", "compression_ratio": 10}
SPEEDS = np.array([65.0, 180.0, 400.0])


PLAIN = engine_of(spoilt(SHORT))
BURNING = engine_of(spoilt(SHORT, gas=GAS))


def v8(
    mounts: list[dict[str, Any]],
    *,
    block: dict[str, Any] = BLOCK,
    foundation: dict[str, Any] | None = None,
    gas: bool = False,
) -> Engine:
    """A V8 on such mounts."""
    return with_values(
        BURNING if gas else PLAIN,
        block=Block(**block),
        mounts=tuple(Mount(**each) for each in mounts),
        foundation=None if foundation is None else Foundation(**foundation),
    )


def shaken(engine: Engine, speeds: np.ndarray = SPEEDS) -> MountResponse:
    """Its response to all orders."""
    block = mounted_block(engine)
    return mount_response(block, mount_excitation(block, engine, speeds=speeds))


def square(right: float, z: float, **more: Any) -> list[dict[str, Any]]:
    """Four alike mounts about the centre of mass of the block, at its height."""
    return [
        {
            "name": f"{i} {j}",
            "up": BLOCK["up"],
            "right": BLOCK["right"] + i * right,
            "z": BLOCK["z"] + j * z,
            **more,
        }
        for i in (-1, 1)
        for j in (-1, 1)
    ]


def test_four_alike_mounts_have_six_modes_in_closed_form() -> None:
    a, b, k = 0.3, 0.2, (2e5, 9e4, 7e4)
    modes = mount_modes(mounted_block(v8(square(a, b, stiffness=list(k)))))
    squares = {
        0: 4 * k[0] / MASS,
        1: 4 * k[1] / MASS,
        2: 4 * k[2] / MASS,
        3: 4 * (k[1] * b**2 + k[2] * a**2) / UP,
        4: 4 * k[0] * b**2 / RIGHT,
        5: 4 * k[0] * a**2 / Z,
    }
    for freedom, value in squares.items():
        [own] = [mode for mode in modes if mode.energy[freedom] > 0.999]
        assert own.speed**2 == pytest.approx(value, rel=1e-9)
        assert own.energy.sum() == pytest.approx(1, rel=1e-12)
        assert own.damping == pytest.approx(0.05, rel=1e-9)  # half the loss factor


def test_mounts_of_a_v_focus_where_their_axes_say() -> None:
    """Two inclined pairs: the elastic axis lies at a height above them that is known.

    In the plane, with ratio L of compression to shear stiffness, mounts at a from the middle that
    point inward by an angle t: their elastic centre is a (L - 1) tan t / (L tan^2 t + 1) above.
    """
    a, tilt, k, s = 0.25, 0.7, 3e5, 1e5
    mounts = [
        {
            "name": f"{side} {z}",
            "right": side * a,
            "z": z,
            "stiffness": [k, s, s],
            "bearing": -side * tilt,
        }
        for side in (-1, 1)
        for z in (-0.2, 0.2)
    ]
    axis = elastic_axis(mounted_block(v8(mounts, block={**BLOCK, "right": 0.0, "z": 0.0})))
    ratio, t = k / s, np.tan(tilt)
    assert axis.point[0] == pytest.approx(a * (ratio - 1) * t / (ratio * t**2 + 1), rel=1e-9)
    assert abs(axis.direction[2]) == pytest.approx(1, rel=1e-12)
    assert axis.advance == pytest.approx(0, abs=1e-12)


def test_a_point_moves_as_a_turned_body_does() -> None:
    """In a right-handed frame x right, y up, z front: yaw about y, pitch, roll against x, z."""
    rng = np.random.default_rng(1)
    for _ in range(20):
        up, right, z = place = rng.normal(size=3)
        shift, (yaw, pitch, roll) = rng.normal(size=3), 1e-6 * rng.normal(size=3)
        turned = Rotation.from_rotvec([-pitch, yaw, -roll]).apply([right, up, z])
        now = turned[1] + shift[0], turned[0] + shift[1], turned[2] + shift[2]
        assert moved(place) @ [*shift, yaw, pitch, roll] + place == pytest.approx(now, abs=1e-10)


def test_the_mass_matrix_is_the_kinetic_energy_of_points() -> None:
    rng = np.random.default_rng(2)
    masses, at = rng.uniform(1, 3, 30), rng.normal(size=(30, 3))
    at -= masses @ at / masses.sum()
    spread = (masses[:, None, None] * at[:, :, None] * at[:, None, :]).sum(axis=0)
    inertia = np.trace(spread) - np.diag(spread)
    products = (spread[0, 1], spread[0, 2], spread[1, 2])
    mass = mass_matrix(masses.sum(), inertia=inertia, products=products)
    motion = moved(at)
    points = np.einsum("p,pai,paj->ij", masses, motion, motion)
    assert mass == pytest.approx(points, abs=1e-10)
    assert second_moments(inertia, products) == pytest.approx(spread, abs=1e-10)


@given(number(-3, 3), number(-1.5, 1.5), number(-3, 3))
def test_axes_of_a_mount_are_square_to_each_other(b: float, lean: float, twist: float) -> None:
    axes = mount_axes(Mount(name="a", stiffness=(1.0,), bearing=b, lean=lean, twist=twist))
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)
    same = Mount(name="a", up=0.2, right=0.1, z=0.4, stiffness=(5.0,))
    turned = Mount(**{**same.model_dump(), "bearing": b, "lean": lean, "twist": twist})
    one, other = (
        gathered(held([each], centre=(0, 0, 0)), values=np.array([each.along]))
        for each in (same, turned)
    )
    assert one == pytest.approx(other, abs=1e-11)


@pytest.mark.parametrize("products", [{}, PRODUCTS])
def test_soft_mounts_leave_the_free_block(products: dict[str, float]) -> None:
    soft = [
        {**each, "stiffness": [1e-10 * k for k in each["stiffness"]], "damping": []}
        for each in LOOSE
    ]
    engine = v8(soft, block={**BLOCK, **products})
    found = shaken(engine)
    push = found.excitation.push
    squared = (found.vibration**2)[..., None]
    momentum = -squared * (found.motion @ found.block.mass)  # its rate of change is the force
    scale = np.abs(push).max(axis=(1, 2), keepdims=True)
    assert np.abs(momentum - push).max() < 1e-6 * scale.max()
    if products:
        return
    free = whirl.response(engine, of=whirl.body(engine), orders=tuple(found.orders.tolist()))
    wanted = [
        spectra.vertical(free.shift),
        spectra.horizontal(free.shift),
        np.zeros(found.orders.size),
        spectra.horizontal(free.tilt),
        spectra.vertical(free.tilt),
        spectra.amplitude(free.turn),
    ]
    for speed in range(SPEEDS.size):
        for freedom, values in enumerate(wanted):
            size = max(np.abs(values).max(), 1e-3 * np.abs(found.motion).max())
            assert np.abs(found.motion[speed, :, freedom] - values).max() < 1e-6 * size


@pytest.mark.parametrize("ground", [None, 3e6])
def test_what_the_forces_put_in_the_mounts_turn_into_heat(ground: float | None) -> None:
    found = shaken(v8(LOOSE, gas=True, foundation=None if ground is None else raft(ground)))
    assert found.power == pytest.approx(found.heat.sum(axis=1), rel=1e-9)
    assert (found.heat >= 0).all()


def raft(stiffness: float, **more: Any) -> dict[str, Any]:
    """A foundation on four springs."""
    springs = [
        {"name": f"{r} {z}", "up": -0.4, "right": r, "z": z, "stiffness": [stiffness]}
        for r in (-0.6, 0.6)
        for z in (-0.5, 0.5)
    ]
    return {
        "mass": 700.0,
        "up": -0.4,
        "inertia_up": 60.0,
        "inertia_right": 50.0,
        "inertia_z": 40.0,
        "mounts": springs,
        **more,
    }


def test_the_steady_answer_solves_the_motion_in_time() -> None:
    """Started on the harmonic answer, an integration of M q'' + C q' + K q = Q(t) stays on it."""
    fluid = [{**each, "loss_factor": 0.0, "damping": [180.0, 90.0, 120.0]} for each in LOOSE]
    ground = raft(2e6)
    ground["mounts"] = [{**each, "damping": [900.0]} for each in ground["mounts"]]
    engine = v8(fluid, block={**BLOCK, **PRODUCTS}, gas=True, foundation=ground)
    block = mounted_block(engine)
    w = 130.0
    push = mount_excitation(block, engine, speeds=np.array([w]), orders=[0.5, 1, 1.5, 2, 4])
    found = mount_response(block, push)
    assert not np.imag(block.lossy(1.0)).any()
    rates = w * push.orders

    def signal(amplitudes: np.ndarray, t: float) -> np.ndarray:
        return np.real(np.exp(1j * rates * t) @ amplitudes)

    force = np.concatenate([push.push[0], np.zeros((5, 6))], axis=1)
    speed = 1j * rates[:, None] * found.motion[0]
    n = block.freedoms

    def slope(t: float, state: np.ndarray) -> np.ndarray:
        rest = signal(force, t) - block.damping @ state[n:] - block.stiffness @ state[:n]
        return np.concatenate([state[n:], np.linalg.solve(block.mass, rest)])

    start = np.concatenate([signal(found.motion[0], 0.0), signal(speed, 0.0)])
    times = np.linspace(0, 4 * np.pi / w, 9)
    run = solve_ivp(slope, (0, times[-1]), start, t_eval=times, rtol=1e-10, atol=1e-14)
    for index, t in enumerate(times):
        wanted = signal(found.motion[0], t)
        assert run.y[:n, index] == pytest.approx(wanted, abs=1e-6 * np.abs(wanted).max())


@given(st.lists(number(-1, 1), min_size=6, max_size=6).filter(lambda q: max(map(abs, q)) > 0.1))
def test_rayleighs_quotient_lies_between_the_modes(shape: list[float]) -> None:
    block = mounted_block(v8(LOOSE, block={**BLOCK, **PRODUCTS}))
    modes = mount_modes(block)
    q = np.array(shape)
    quotient = (q @ block.stiffness @ q) / (q @ block.mass @ q)
    assert modes[0].speed ** 2 * (1 - 1e-9) <= quotient <= modes[-1].speed ** 2 * (1 + 1e-9)


def test_modes_are_square_to_each_other_in_mass_and_stiffness() -> None:
    block = mounted_block(v8(LOOSE, block={**BLOCK, **PRODUCTS}, foundation=raft(2e6)))
    modes = mount_modes(block)
    shapes = np.array([mode.shape for mode in modes])
    assert shapes @ block.mass @ shapes.T == pytest.approx(np.eye(12), abs=1e-9)
    squares = [mode.speed**2 for mode in modes]
    assert shapes @ block.stiffness @ shapes.T == pytest.approx(
        np.diag(squares), rel=1e-9, abs=1e-3
    )


def turned(angle: float) -> MountedBlock:
    """The block, its products and its mounts turned clockwise about the crankshaft."""
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    products = list(PRODUCTS.values())
    spread = turn @ second_moments((UP, RIGHT, Z), products) @ turn.T
    inertia = np.trace(spread) - np.diag(spread)
    centre = turn @ [BLOCK["up"], BLOCK["right"], BLOCK["z"]]
    mounts = []
    for each in LOOSE:
        up, right, z = turn @ [each["up"], each.get("right", 0.0), each["z"]]
        place = {"up": up, "right": right, "z": z, "bearing": each.get("bearing", 0.0) + angle}
        mounts.append({**each, **place})
    block = {
        "mass": MASS,
        **dict(zip(("up", "right", "z"), centre.tolist(), strict=True)),
        **dict(zip(("inertia_up", "inertia_right", "inertia_z"), inertia.tolist(), strict=True)),
        **dict(zip(PRODUCTS, (spread[0, 1], spread[0, 2], spread[1, 2]), strict=True)),
    }
    return mounted_block(v8(mounts, block=block))


def test_turning_engine_and_mounts_together_changes_no_mode() -> None:
    one, other = mount_modes(turned(0.0)), mount_modes(turned(0.9))
    for left, right in zip(one, other, strict=True):
        assert left.speed == pytest.approx(right.speed, rel=1e-9)
        assert left.energy[5] == pytest.approx(right.energy[5], abs=1e-9)
    before, after = torque_roll_axis(turned(0.0)), torque_roll_axis(turned(0.9))
    assert before.from_crank == pytest.approx(after.from_crank, rel=1e-9)


def test_a_mirrored_block_shakes_as_in_a_mirror() -> None:
    """Right becomes left: yaw, roll and the rightward motion change sign, nothing else."""
    keys = {"right", "bearing", "product_up_right", "product_right_z"}

    def mirrored(table: dict[str, Any]) -> dict[str, Any]:
        return {key: -value if key in keys else value for key, value in table.items()}

    mirror = np.array([1, -1, 1, -1, 1, -1])
    here = v8([{**each, "twist": 0.0} for each in LOOSE], block={**BLOCK, **PRODUCTS})
    there = v8(
        [mirrored({**each, "twist": 0.0}) for each in LOOSE], block=mirrored({**BLOCK, **PRODUCTS})
    )
    block = mounted_block(here)
    push = mount_excitation(block, here, speeds=SPEEDS)
    back = MountExcitation(SPEEDS, push.orders, push.inertia * mirror, push.gas * mirror)
    one = mount_response(block, push)
    other = mount_response(mounted_block(there), back)
    assert other.motion == pytest.approx(one.motion * mirror, abs=1e-12)
    assert other.transmissibility == pytest.approx(one.transmissibility, rel=1e-9)


def test_a_foundation_of_rock_is_none() -> None:
    rigid, rock = shaken(v8(LOOSE)), shaken(v8(LOOSE, foundation=raft(1e12)))
    size = np.abs(rigid.motion).max()
    assert rock.motion[..., :6] == pytest.approx(rigid.motion, abs=1e-6 * size)
    assert rock.mount_force[:, :, :3] == pytest.approx(
        rigid.mount_force, abs=1e-5 * np.abs(rigid.mount_force).max()
    )


def test_a_foundation_under_a_block_is_two_masses_in_a_row() -> None:
    k, base = 1e5, 2e6
    raft_mass = 700.0
    place = {"right": BLOCK["right"], "z": BLOCK["z"], "up": BLOCK["up"]}
    own = raft(base, **place)
    springs = square(0.5, 0.6, stiffness=[base], loss_factor=0.0)
    own["mounts"] = [{**each, "name": f"ground {each['name']}"} for each in springs]
    engine = v8(square(0.3, 0.2, stiffness=[k], loss_factor=0.0), foundation=own)
    block = mounted_block(engine)
    push = np.zeros((1, 6), complex)
    push[0, 0] = 1.0
    w = np.array([90.0])
    found = mount_response(block, MountExcitation(w, np.array([1.0]), np.zeros((1, 6)), push[None]))
    top = np.array([[4 * k - MASS * w[0] ** 2, -4 * k], [-4 * k, 0]])
    top[1, 1] = 4 * k + 4 * base - raft_mass * w[0] ** 2
    upper, lower = np.linalg.solve(top, [1.0, 0.0])
    assert found.motion[0, 0, 0] == pytest.approx(upper, rel=1e-9)
    assert found.motion[0, 0, 6] == pytest.approx(lower, rel=1e-9)
    assert found.ground_force[0, 0, 0] == pytest.approx(4 * base * lower, rel=1e-9)


def test_forces_and_moments_on_the_ground_are_those_that_hold_the_block() -> None:
    """Force put in less mass times acceleration, about the centre of mass, goes to the ground."""
    found = shaken(v8(LOOSE, gas=True, block={**BLOCK, **PRODUCTS}))
    squared = (found.vibration**2)[..., None]
    rest = found.excitation.push + squared * (found.motion @ found.block.mass)
    assert found.ground_force == pytest.approx(rest, abs=1e-9 * np.abs(rest).max())


def test_the_block_sits_down_under_its_weight_in_balance() -> None:
    block = mounted_block(v8(LOOSE, foundation=raft(2e6)))
    _, loads = settled(block)
    standing = block.mounts[: block.of_block]
    arms = held(standing, centre=block.centres[0])
    whole = np.einsum("ma,maf->f", loads[: block.of_block], arms)
    assert whole == pytest.approx([-MASS * 9.80665, 0, 0, 0, 0, 0], abs=1e-8)


def test_a_mode_of_mounts_that_stiffen_is_at_its_own_frequency() -> None:
    """With s = 1 + a w the bounce solves m w^2 = 4 k (1 + a w)."""
    k, a = 2e5, 2e-3
    rubber = {"stiffness": [k], "rubber": [{"frequency": 1000.0, "factor": 1 + 1000.0 * a}]}
    modes = mount_modes(mounted_block(v8(square(0.3, 0.2, **rubber))))
    bounce = (4 * k * a + np.sqrt((4 * k * a) ** 2 + 16 * MASS * k)) / (2 * MASS)
    [own] = [mode for mode in modes if mode.energy[0] > 0.99]
    assert own.speed == pytest.approx(bounce, rel=1e-9)
    found = shaken(v8(square(0.3, 0.2, **rubber)))
    assert found.power == pytest.approx(found.heat.sum(axis=1), rel=1e-9)


def test_sizes_over_a_cycle_are_those_of_its_course() -> None:
    found = shaken(v8(LOOSE, gas=True))
    point = (0.4, 0.1, 0.2)
    amplitudes = found.displacement(point)
    theta = np.linspace(0, 4 * np.pi, 72001)[:-1]
    course = np.real(
        np.einsum("to,soa->sta", np.exp(1j * np.outer(theta, found.orders)), amplitudes)
    )
    lengths = np.sqrt((course**2).sum(axis=-1))
    assert rms(amplitudes) == pytest.approx(np.sqrt((lengths**2).mean(axis=1)), rel=1e-9)
    assert peak(amplitudes, orders=found.orders) == pytest.approx(lengths.max(axis=1), rel=3e-6)


def test_gas_leans_against_the_turning_crankshaft() -> None:
    """A steady push of the gas clockwise on the shaft rolls the block counter-clockwise."""
    engine = v8(LOOSE, gas=True)
    block = mounted_block(engine)
    push = mount_excitation(block, engine, speeds=SPEEDS)
    torque = spectra.amplitude(gas_torque(cycle(engine, speed=float(SPEEDS[-1]))).total)
    fires = np.isclose(push.orders, 4.0)
    found = push.gas[0, fires, 5].item()
    wanted = torque[np.isclose(np.arange(1, torque.size + 1) / 2, 4.0)].item()
    assert found == pytest.approx(-wanted, rel=1e-9)
    assert abs(wanted) > 1
    assert replace(push, gas=0 * push.gas).push[0, fires, 5] != pytest.approx(found, rel=1e-3)


def test_points_of_the_two_axes_stay_where_they_are() -> None:
    """Under a moment about the crankshaft: of the free block, and of the block on its mounts."""
    block = mounted_block(v8(LOOSE, block={**BLOCK, **PRODUCTS}))
    moment = np.array([0, 0, 0, 0, 0, 1.0])
    for axis, motion in (
        (torque_roll_axis(block), np.linalg.solve(block.mass, moment)),
        (elastic_axis(block), np.linalg.solve(block.stiffness, moment)),
    ):
        turn = np.linalg.norm(motion[3:])
        for along in (-0.7, 0.0, 1.3):
            point = axis.point + along * axis.direction - block.centres[0]
            still = axis.advance * turn * axis.direction
            assert moved(point) @ motion == pytest.approx(still, abs=1e-9 * float(turn))
    assert elastic_axis(block).advance != 0


def test_the_torque_roll_axis_leans_to_the_long_axis_of_the_block() -> None:
    """A block that is long upward to the front has a positive product of up and z."""
    block = mounted_block(v8(LOOSE, block={**BLOCK, "product_up_z": 1.0}))
    up, right, along = torque_roll_axis(block).direction
    assert up * along > 0
    assert right == 0


def test_a_body_turned_in_space_by_springs_moves_as_the_six_freedoms_say() -> None:
    """Another road: a body with its rotation in space, x right, y up, z front, in small motion."""
    fluid = [{**each, "loss_factor": 0.0, "damping": [180.0, 90.0, 120.0]} for each in LOOSE]
    engine = v8(fluid, block={**BLOCK, **PRODUCTS}, gas=True)
    block = mounted_block(engine)
    w, tiny = 110.0, 1e-4
    push = mount_excitation(block, engine, speeds=np.array([w]), orders=[0.5, 1, 2, 4])
    push = replace(push, inertia=tiny * push.inertia, gas=tiny * push.gas)
    found = mount_response(block, push)
    across = [1, 0, 2]  # from up, right, z to x, y, z
    sign = np.array([-1.0, 1.0, -1.0])  # pitch, yaw, roll as turns about x, y, z
    spread = second_moments((UP, RIGHT, Z), list(PRODUCTS.values()))[np.ix_(across, across)]
    inertia = np.trace(spread) * np.eye(3) - spread
    places = np.array([[m.right, m.up, m.z] for m in block.mounts])
    places = places - block.centres[0][across]
    axes = np.array([mount_axes(m)[:, across] for m in block.mounts])

    def signal(amplitudes: np.ndarray, t: float) -> np.ndarray:
        values = np.real(np.exp(1j * w * push.orders * t) @ amplitudes)
        return np.concatenate([values[across], sign * values[[4, 3, 5]]])

    def slope(t: float, state: np.ndarray) -> np.ndarray:
        shift, turn, speed, spin = state.reshape(4, 3)
        body = Rotation.from_rotvec(turn)
        force = signal(push.push[0], t)
        for place, own, k, c in zip(places, axes, block.along, block.viscous, strict=True):
            arm = body.apply(place)
            stretch = own @ (arm + shift - place)
            pull = -own.T @ (k * stretch + c * (own @ (speed + np.cross(spin, arm))))
            force = force + np.concatenate([pull, np.cross(arm, pull)])
        about = body.as_matrix() @ inertia @ body.as_matrix().T
        rate = np.linalg.solve(about, force[3:] - np.cross(spin, about @ spin))
        return np.concatenate([speed, spin, force[:3] / MASS, rate])  # small: turn' = spin

    rates = 1j * w * push.orders[:, None] * found.motion[0]
    start = np.concatenate([signal(found.motion[0], 0.0), signal(rates, 0.0)])
    times = np.linspace(0, 4 * np.pi / w, 5)
    run = solve_ivp(slope, (0, times[-1]), start, t_eval=times, rtol=1e-8, atol=1e-14)
    for index, t in enumerate(times):
        wanted = signal(found.motion[0], t)
        assert run.y[:6, index] == pytest.approx(wanted, abs=2e-4 * np.abs(wanted).max())


def test_resonance_without_damping_is_refused() -> None:
    """Four springs of 100 N/mm under 160 kg, shaken at exactly 50 rad/s."""
    springs = [
        {"name": f"{r} {z}", "right": r, "z": z, "stiffness": [1e5], "loss_factor": 0.0}
        for r in (-0.25, 0.25)
        for z in (-0.25, 0.25)
    ]
    own = {**BLOCK, "mass": 160.0, "up": 0.0, "right": 0.0, "z": 0.0}
    push = np.zeros((1, 1, 6), complex)
    push[..., 0] = 1.0
    shaking = MountExcitation(np.array([50.0]), np.array([1.0]), np.zeros((1, 6)), push)
    with pytest.raises(MountError, match="resonate without end"):
        mount_response(mounted_block(v8(springs, block=own)), shaking)
