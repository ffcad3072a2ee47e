"""The sound of the exhaust: its lines stand at the orders of the exhaust, and nowhere else."""

from __future__ import annotations

import io
import wave
from math import pi

import numpy as np
import pytest

import crankstar
from crankstar.dynamics.sound import (
    LOUDEST,
    RATE,
    REFLECTED,
    SPEED_OF_SOUND,
    WIDTH,
    Ride,
    Sound,
    pulse_order,
    sound,
    wav,
)
from crankstar.firing.exhaust_orders import exhaust_orders
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError

RPM = 3000.0
CYCLE = round(RATE * 120 / RPM)
"""Samples of a cycle of a four-stroke engine: a whole number."""
SPEED = RPM * pi / 30
CROSS, FLAT = "v8-cross-plane", "v8-flat-plane"


def steady(name: str, **pipes: object) -> Sound:
    ride = Ride(SPEED, SPEED, seconds=1.0, **pipes)  # pyright: ignore[reportArgumentType]
    return sound(crankstar.load(name), ride=ride)


def lines(samples: np.ndarray) -> np.ndarray:
    """Amplitudes at the multiples of an eighth of an order, eight cycles of the middle."""
    part = samples[5 * CYCLE : 13 * CYCLE]
    return np.abs(np.fft.rfft(part)) / part.size * 2


def expected(name: str, group: int, length: float = 1.0) -> np.ndarray:
    """|S_q P_q H| of orders 0.5, 1, ... 8, up to a factor."""
    found = exhaust_orders(crankstar.load(name))
    back = round(2 * length / SPEED_OF_SOUND * RATE) / RATE
    pipe = 1 / np.abs(1 + REFLECTED * np.exp(-1j * SPEED * found.orders * back))
    pulse = np.array([abs(pulse_order(order)) for order in found.orders])
    return np.abs(found.sums[group]) * pulse * pipe


@pytest.mark.parametrize("name", [CROSS, FLAT, "v4-90", "vw-vr6", "i4", "i2-270"])
def test_lines_of_a_constant_speed_stand_at_the_exhaust_orders(name: str) -> None:
    heard = steady(name)
    for group, samples in enumerate(heard.samples):
        found = lines(samples)
        between = np.delete(found, np.arange(0, found.size, 8))
        assert between.max() < 1e-9 * found.max()
        wanted = expected(name, group)
        ratio = found[8 : 8 * 16 + 1 : 8] / wanted.max()
        scale = ratio[wanted.argmax()]
        assert ratio == pytest.approx(wanted / wanted.max() * scale, abs=1e-5 * scale)


def test_a_cross_plane_bank_has_order_one_and_a_half_and_no_two() -> None:
    found = lines(steady(CROSS).samples[0])
    assert found[8 * 4] < 1e-6 * found[8 * 3]
    flat = lines(steady(FLAT).samples[0])
    assert flat[8 * 3] < 1e-6 * flat[8 * 4]


def test_order_four_of_both_eights_is_equally_strong_before_scaling() -> None:
    cross, flat = steady(CROSS), steady(FLAT)
    # order 4 has four pulses in both, order 8 too: their ratio is that of pulse and pipe
    ratios = [lines(one.samples[0])[64] / lines(one.samples[0])[128] for one in (cross, flat)]
    assert ratios[0] == pytest.approx(ratios[1], rel=1e-5)
    # 2 of the flat plane against 1.5 of the cross plane, each beside its order 4
    two = lines(flat.samples[0])[32] / lines(flat.samples[0])[64]
    half = lines(cross.samples[0])[24] / lines(cross.samples[0])[64]
    wanted = expected(FLAT, 0)[3] / expected(CROSS, 0)[2]
    assert two / half == pytest.approx(wanted, rel=1e-5)


def test_pipes_of_different_length_bring_orders_back() -> None:
    found = lines(steady("i4", pipes={1: 0.4}).samples[0])
    assert found[8] > 1e-2 * found.max()
    same = lines(steady("i4", pipe=0.4).samples[0])
    assert same[8] < 1e-6 * same.max()


def test_the_pulse_has_the_spectrum_that_is_stated() -> None:
    angles = np.linspace(-WIDTH / 2, WIDTH / 2, 20_001)
    pulse = (1 + np.cos(2 * pi * angles / WIDTH)) / 2
    for order in (0.5, 2, 4, 6, 8, 11):
        line = np.sum(pulse * np.cos(np.radians(order * angles))) / np.sum(pulse)
        assert pulse_order(order) == pytest.approx(line, abs=1e-7)


def test_a_rising_speed_has_a_continuous_phase() -> None:
    ride = Ride(SPEED / 2, SPEED, seconds=2.0)
    time = np.linspace(-0.5, 2.0, 25_001)
    speed = np.gradient(ride.turns(time), time) * 2 * pi
    assert speed[time < -0.001] == pytest.approx(SPEED / 2)
    assert speed[-2] == pytest.approx(SPEED, rel=1e-3)
    heard = sound(crankstar.load(CROSS), ride=ride).samples
    # no step from sample to sample is greater than at the highest speed held
    fast = sound(crankstar.load(CROSS), ride=Ride(SPEED, SPEED, seconds=1.0)).samples
    assert np.abs(np.diff(heard)).max() < 1.3 * np.abs(np.diff(fast)).max()


def test_a_sound_is_the_same_every_time_and_never_clipped() -> None:
    ride = Ride(80.0, 600.0, seconds=1.0)
    first, second = (sound(crankstar.load(CROSS), ride=ride) for _time in range(2))
    assert wav(first) == wav(second)
    assert np.abs(first.samples).max() == pytest.approx(LOUDEST)
    assert (first.samples[:, 0] == 0).all()


@pytest.mark.parametrize(("name", "channels"), [("i4", 1), (CROSS, 2), ("napier-deltic", 2)])
def test_two_groups_are_left_and_right_in_a_file_of_16_bits(name: str, channels: int) -> None:
    with wave.open(io.BytesIO(wav(steady(name)))) as file:
        assert (file.getnchannels(), file.getsampwidth()) == (channels, 2)
        assert (file.getframerate(), file.getnframes()) == (RATE, RATE)


@pytest.mark.release
def test_the_samples_of_a_file_are_those_of_the_sound_of_full_scale() -> None:
    heard = steady(CROSS)
    with wave.open(io.BytesIO(wav(heard))) as file:
        read = np.frombuffer(file.readframes(RATE), "<i2").reshape(-1, 2).T
    assert read / 32767 == pytest.approx(heard.samples, abs=0.51 / 32767)


def test_pipes_whose_pulses_cancel_in_one_channel_are_heard_side_by_side() -> None:
    # three banks fire 20 deg apart, each six times a turn: their sum is steady
    heard = steady("napier-deltic").samples[:, RATE // 4 : -RATE // 4]
    assert np.abs(heard.sum(axis=0)).max() < 1e-2 * np.abs(heard[0]).max()
    turns = SPEED / (2 * pi)
    line = np.exp(-2j * pi * 6 * turns * np.arange(heard.shape[1]) / RATE)
    share = 2 * np.abs(heard @ line) / heard.shape[1]
    assert (share > 0.5).all()


def test_a_sound_needs_firings_and_cylinders_that_are_there() -> None:
    with pytest.raises(EngineError, match="firing_order is missing"):
        sound(crankstar.load("napier-lion"), ride=Ride(SPEED, SPEED))
    with pytest.raises(MessageError, match="no exhaust of a cylinder 9"):
        sound(crankstar.load("i4"), ride=Ride(SPEED, SPEED, pipes={9: 1.0}))
