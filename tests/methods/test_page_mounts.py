"""What the page is sent of mounts is what the analysis says, and what the command prints."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest
from tests.mounted_engines import BLOCK, FOUNDATION, HEAVY, MOUNTS, SOFT, standing
from tests.texts import SHORT, spoilt

from crankstar import spectra
from crankstar.analyses.mounts.document import document as mounts_document
from crankstar.analyses.mounts.question import Question
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mount_excitation import mount_excitation
from crankstar.dynamics.mount_response import MountResponse, mount_response, rms
from crankstar.dynamics.mounted_block import GRAVITY, mounted_block
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import mount_axes
from crankstar.engine.rigid_block import moved as points_moved
from crankstar.files import engine_of
from crankstar.files.catalog import load
from crankstar.language.shown_units import read_choice, shown_in
from crankstar.page.exhibits import exhibit
from crankstar.page.mount_records import Mounts, MountVibration, Spring
from crankstar.page.mounts import mount_numbers, mounts_shown
from crankstar.page.orders import free_response
from crankstar.page.records import Vectors
from crankstar.spectra import Complex, Real

RPM = 30 / np.pi
THETA = np.linspace(0, 4 * np.pi, 97)


def sent(engine: Engine) -> Mounts:
    """The record of an engine that has one."""
    shown = mounts_shown(engine)
    assert shown is not None
    return shown


def course(orders: Any, amplitudes: Complex) -> Real:
    """Waves [wave, order] over the crank angle, as the page adds them up [wave, angle]."""
    return np.real(amplitudes @ np.exp(1j * np.multiply.outer(np.array(orders), THETA)))


def waves(pairs: Any) -> Complex:
    return np.array([[complex(*pair) for pair in wave] for wave in pairs])


class Answer(NamedTuple):
    """Motion [freedom, order], and force of each mount [mount, (up, right, along), order]."""

    motion: Complex
    forces: Complex


def answered(shown: Mounts, vibration: MountVibration) -> Answer:
    """The steady vibration from nothing but what the page is sent, order by order."""
    driving = shown.driving
    assert driving is not None
    mass, speed = np.array(driving.mass), vibration.speed_rpm / RPM
    arms = np.array([spring.arms for spring in driving.springs])
    axes = np.array([mount.axes for mount in shown.mounts])
    gas = np.zeros(len(shown.orders), complex)
    if vibration.gas is not None:
        gas = waves([vibration.gas])[0]
    elif driving.gas_speeds:
        gas = np.array(
            [np.interp(speed, driving.gas_speeds, each) for each in waves(driving.gas).T]
        )
    push = np.zeros((len(mass), gas.size), complex)
    push[:6] = speed**2 * waves(driving.inertia)
    push[5] += gas
    motion, forces = np.zeros_like(push), np.zeros((len(arms), 3, gas.size), complex)
    for place, order in enumerate(shown.orders):
        w = order * speed
        rates = np.array([_rate(spring, w) for spring in driving.springs])
        stiff = np.einsum("mai,ma,maj->ij", arms, rates, arms) - w**2 * mass
        motion[:, place] = np.linalg.solve(stiff, push[:, place])
        forces[:, :, place] = np.einsum("ma,mai->mi", rates * (arms @ motion[:, place]), axes)
    return Answer(motion, forces)


def _rate(spring: Spring, w: float) -> Complex:
    at, factors = np.array([(0.0, 1.0), *spring.stiffening]).T
    factor = np.interp(w, at, factors)
    lossy = factor * (1 + 1j * spring.loss) * np.array(spring.stiffness)
    return lossy + 1j * w * np.array(spring.damping)


def shaken(engine: Engine, speed_rpm: float, point: str) -> MountResponse:
    """The whole response at a speed, with every order."""
    block = mounted_block(engine)
    at = np.array([speed_rpm / RPM])
    return mount_response(block, mount_excitation(block, engine, speeds=at, point=point))


@pytest.mark.many(first=1)
@pytest.mark.parametrize("foundation", [None, FOUNDATION])
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_a_vibration_is_that_of_all_orders_at_its_speed(
    rotation: str, foundation: dict[str, Any] | None
) -> None:
    engine = standing(rotation=rotation, foundation=foundation)
    shown = sent(engine)
    freedoms = 6 if foundation is None else 12
    assert [each.point for each in shown.vibrations[:3]] == ["full", "most torque", "idle"]
    for vibration in shown.vibrations:
        whole = shaken(engine, vibration.speed_rpm, vibration.point)
        turning = np.exp(1j * np.multiply.outer(whole.orders, THETA))
        expected = np.real(whole.motion[0].T @ turning)
        answer = answered(shown, vibration)
        seen = course(shown.orders, answer.motion)
        assert len(seen) == freedoms
        scale = np.abs(expected).max(axis=1, keepdims=True)
        assert np.all(np.abs(seen - expected) <= 1e-8 * scale + 1e-15)
        for index, mount in enumerate(whole.block.mounts):
            own: Complex = whole.mount_force[0, :, index] @ mount_axes(mount)
            force = np.real(own.T @ turning)
            told = course(shown.orders, answer.forces[index])
            assert told == pytest.approx(force, abs=1e-8 * np.abs(force).max())


def test_forces_of_the_mounts_hold_and_shake_the_block() -> None:
    """Newton's second law of the record alone: the mass that is sent, its motion, its forces."""
    engine = standing()
    shown = sent(engine)
    for vibration in shown.vibrations[:2]:
        whole = shaken(engine, vibration.speed_rpm, vibration.point)
        push = np.real(whole.excitation.push[0].T @ _turning(whole.orders))
        rates = (np.array(shown.orders) * vibration.speed_rpm / RPM) ** 2
        answer = answered(shown, vibration)
        ground = course(shown.orders, answer.forces.sum(axis=0))
        momentum = 165.0 * course(shown.orders, -rates * answer.motion[:3])
        assert momentum + ground == pytest.approx(push[:3], abs=1e-6 * np.abs(ground).max())


def _turning(orders: Real) -> Complex:
    return np.exp(1j * np.multiply.outer(orders, THETA))


@pytest.mark.release
def test_modes_are_those_of_the_analysis_with_the_forces_of_their_shape() -> None:
    engine = standing(foundation=FOUNDATION)
    shown, found = sent(engine), mounts(engine)
    assert len(shown.modes) == len(found.modes) == 12
    for told, mode in zip(shown.modes, found.modes, strict=True):
        assert told.frequency_hz == pytest.approx(mode.frequency, rel=1e-12)
        assert sum(told.energy) == pytest.approx(1)
        assert told.shape == pytest.approx(mode.shape)
        # the mounts of the block pull at its mass: sum of forces = w^2 times momentum
        upper = np.sum(told.forces[:3], axis=0)
        wanted = mode.speed**2 * (found.block.mass @ mode.shape)[:3]
        assert upper == pytest.approx(wanted, abs=1e-6 * np.abs(told.forces).max())


def test_loads_at_rest_bear_the_weight_and_no_moment() -> None:
    shown = sent(standing())
    loads = np.array([each.load for each in shown.mounts])
    assert loads.sum(axis=0) == pytest.approx([-165.0 * GRAVITY, 0, 0], abs=1e-6)
    places = np.array([each.place for each in shown.mounts]) - np.array(shown.centres[0])
    moments = sum(points_moved(place).T @ load for place, load in zip(places, loads, strict=True))
    assert np.asarray(moments)[3:] == pytest.approx(0, abs=1e-6)
    assert not any(each.below for each in shown.mounts)


def test_over_the_speed_the_page_draws_what_the_command_writes() -> None:
    engine = standing()
    shown, found = sent(engine), mounts(engine)
    table = next(
        each
        for each in mounts_document(engine, found, Question()).for_machines.tables
        if each.key == "speeds"
    )
    keys = [column.key for column in table.columns]
    rows: list[dict[str, Any]] = [dict(zip(keys, row, strict=True)) for row in table.rows]
    assert shown.over is not None
    for own, key, factor in (
        (shown.over.speeds_rpm, "speed_rpm", 1),
        (shown.points[0].displacement, "displacement_rms", 1e6),
        (shown.points[0].velocity, "velocity_rms", 1e3),
        (shown.over.force, "force_rms", 1),
    ):
        assert factor * np.array(own) == pytest.approx([row[key] for row in rows], rel=1e-8)
    for index, line in enumerate(shown.over.transmissibility):
        assert list(line) == pytest.approx([row["transmissibility"][index] for row in rows])


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_on_soft_mounts_the_block_whirls_as_a_free_one(rotation: str) -> None:
    """Without gas: the whirl of the page knows the moving parts alone."""
    engine = standing(rotation=rotation, mounts=SOFT, gas=None, **HEAVY)
    shown = sent(engine)
    (vibration,) = [each for each in shown.vibrations if each.speed_rpm == pytest.approx(6500)]
    assert vibration.gas is None
    assert shown.driving is not None
    assert shown.driving.gas == shown.driving.gas_speeds == ()
    free = free_response(engine, shown.orders, along=1.0)
    sense = 1 if engine.sense > 0 else -1

    def plane(vectors: Vectors) -> Real:
        """Up and right over the crank angle."""
        turning = np.exp(sense * 1j * np.multiply.outer(np.array(shown.orders), THETA))
        ahead, back = (
            np.array([complex(*each) for each in way])
            for way in (vectors.forward, vectors.backward)
        )
        whole: Complex = ahead @ turning + back @ turning.conj()
        return np.array([np.real(whole), np.imag(whole)])

    up, right, along, yaw, pitch, roll = course(shown.orders, answered(shown, vibration).motion)
    shift, tilt = plane(free.shift), plane(free.tilt)
    (turn,) = course(shown.orders, waves([free.turn]))
    reach = max(np.abs(shift).max(), np.abs(tilt).max(), np.abs(turn).max())
    assert reach > 1e-6
    assert np.abs(tilt).max(axis=1) == pytest.approx(reach, rel=0.9), "pitch and yaw"
    for own, whirled in ((up, shift[0]), (right, shift[1]), (pitch, tilt[0]), (yaw, tilt[1])):
        assert own == pytest.approx(whirled, abs=1e-6 * reach)
    assert roll == pytest.approx(turn, abs=1e-6 * reach)
    assert along == pytest.approx(0, abs=1e-6 * reach)


def test_peaks_are_sent_where_the_range_has_them() -> None:
    engine = engine_of(
        spoilt(
            SHORT,
            block={"mass": "200 kg"},
            mounts=MOUNTS,
            gas={"imep": "4 bar", "compression_ratio": 10, "speed": "900 rpm"},
        )
    )
    shown = sent(engine)
    assert shown.over is not None
    velocity, speeds = np.array(shown.points[0].velocity), np.array(shown.over.speeds_rpm)
    peaks = [each.speed_rpm for each in shown.vibrations if each.peak]
    assert peaks
    for peak in peaks:
        place = int(np.argmin(np.abs(speeds - peak)))
        assert velocity[place] == velocity[place - 1 : place + 2].max()
        down = [velocity[:place][::-1], velocity[place + 1 :]]
        ends = [np.append(np.flatnonzero(side > velocity[place]), side.size)[0] for side in down]
        foot = max(side[: int(end) + 1].min() for side, end in zip(down, ends, strict=True))
        assert velocity[place] - foot > 0.1 * velocity.max(), "it stands out of what is beside it"
    assert speeds[velocity.argmax()] == pytest.approx(
        max(peaks, key=lambda p: velocity[int(np.argmin(np.abs(speeds - p)))])
    )


def test_without_mounts_nothing_is_sent_and_without_a_speed_no_vibration() -> None:
    assert mounts_shown(load("v8-cross-plane")) is None
    assert mount_numbers(load("v8-cross-plane")) is None
    still = engine_of(spoilt(SHORT, block={"mass": "200 kg"}, mounts=MOUNTS))
    shown, numbers = sent(still), mount_numbers(still)
    assert shown.over is None
    assert shown.driving is None
    assert all(point.velocity == () for point in shown.points)
    assert shown.vibrations == shown.orders == ()
    assert len(shown.modes) == 6
    assert numbers is not None
    assert numbers.speeds.rows == ()
    assert "Without a speed nothing shakes it" in " ".join(numbers.notes)


@pytest.mark.release
def test_points_are_those_of_the_file_then_centres_then_mounts() -> None:
    grips = [
        {"name": name, "up": up} for name, up in (("left grip", "1 m"), ("right grip", "0.9 m"))
    ]
    raft = {**FOUNDATION, "points": [{"name": "deck", "z": "0.5 m"}]}
    engine = standing(block={**BLOCK, "points": grips}, foundation=raft)
    shown, found = sent(engine), mounts(engine)
    assert [(point.name, point.below) for point in shown.points] == [
        ("left grip", False),
        ("right grip", False),
        ("centre of mass", False),
        ("foundation: deck", True),
        ("foundation: centre of mass", True),
        ("left", False),
        ("right", False),
        ("rear", False),
    ]
    assert shown.points[0].place == found.point
    assert found.over is not None
    deck = found.over.velocity(shown.points[3].place, of=1)
    assert shown.points[3].velocity == pytest.approx(rms(deck), rel=1e-8)


@pytest.mark.release
def test_an_exhibit_has_the_mounts_in_chosen_units() -> None:
    engine = standing()
    assert exhibit(engine, relatives=False).mounts == sent(engine)
    with shown_in(read_choice("us")):
        numbers = mount_numbers(engine)
    assert numbers is not None
    assert numbers.force_unit.label == numbers.load_unit.label == "lbf"
    assert numbers.force_unit.factor == pytest.approx(1 / 4.4482216152605)
    loads = [float(row[-1]) for row in numbers.mounts.rows]
    assert sum(loads) == pytest.approx(165 * GRAVITY / 4.4482216152605, rel=0.02)


def test_orders_left_out_are_rounding() -> None:
    """Order by order, what is not sent is too little to be seen."""
    engine = standing()
    shown = sent(engine)
    whole = shaken(engine, shown.vibrations[0].speed_rpm, shown.vibrations[0].point)
    left = ~np.isin(whole.orders, shown.orders)
    size = np.abs(whole.motion[0]).max(axis=0)
    assert np.all(np.abs(whole.motion[0][left]) <= 1e-10 * size)
    assert spectra.distinct(np.array(shown.orders)).size == len(shown.orders)
