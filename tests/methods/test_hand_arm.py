"""The weighting for the hand, and points of block and frame that are weighted by it."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest
from scipy import signal
from tests.files.test_mounts import BLOCK, GROUND, THREE
from tests.texts import SHORT, spoilt

import crankstar
from crankstar.dynamics.hand_arm import hand_arm_weighting
from crankstar.dynamics.mount_response import rms
from crankstar.engine.rigid_block import moved
from crankstar.files import engine_of

BANDS = np.arange(8, 32)
"""Numbers n of the third-octave bands, whose middle is 10^(n/10) Hz: 6.3 to 1250 Hz."""
WEIGHTS = (
    *("0.727", "0.873", "0.951", "0.958", "0.896", "0.782", "0.647", "0.519", "0.411", "0.324"),
    *("0.256", "0.202", "0.160", "0.127", "0.101", "0.0799", "0.0634", "0.0503", "0.0398"),
    *("0.0314", "0.0245", "0.0186", "0.0135", "0.00894"),
)
"""As annex 3 of the notice of the Japanese Ministry of Health, Labour and Welfare prints them."""
GAS = {"imep": "4 bar", "compression_ratio": 10, "speed": "900 rpm"}
SPEEDS = np.array([80.0, 300.0])
GRIP = (0.5, 0.35, 0.2)


def mounted(**more: Any) -> crankstar.Engine:
    return engine_of(spoilt(SHORT, **{"block": BLOCK, "mounts": THREE, "gas": GAS, **more}))


def test_the_weights_of_all_bands_are_the_printed_ones_to_their_digits() -> None:
    found = hand_arm_weighting(2 * np.pi * 10 ** (BANDS / 10))
    for printed, value in zip(WEIGHTS, found, strict=True):
        digits = len(printed.partition(".")[2])
        assert f"{value:.{digits}f}" == printed


def test_the_weighting_is_that_of_the_filter_as_poles_and_zeros() -> None:
    """A second road: the transfer function as polynomials, by scipy."""
    one, two, three = 2 * np.pi * 10**0.8, 2 * np.pi * 10**3.1, 100.0
    low = [1, one * np.sqrt(2), one**2]
    high = [1, two * np.sqrt(2), two**2]
    top = np.polymul([two**2, 0, 0], [three**2 / three, three**2])
    bottom = np.polymul(np.polymul(low, high), [1, three / 0.64, three**2])
    at = np.geomspace(1.0, 2e4, 200)
    _w, response = signal.freqs(top, bottom, worN=cast("Any", at))
    assert hand_arm_weighting(at) == pytest.approx(np.abs(response), rel=1e-9)
    assert hand_arm_weighting(np.zeros(1)) == pytest.approx([0.0])


def test_weighted_acceleration_is_that_of_each_order_filtered() -> None:
    over = crankstar.mounts(mounted(), speeds=SPEEDS).over
    assert over is not None
    total = np.zeros(over.speeds.size)
    for place, order in enumerate(over.orders):
        frequency = order * over.speeds
        size = np.abs(over.displacement(GRIP)[:, place]) * frequency[:, None] ** 2
        total += ((hand_arm_weighting(frequency)[:, None] * size) ** 2).sum(axis=1) / 2
    assert rms(over.hand_arm(GRIP)) == pytest.approx(np.sqrt(total))
    assert np.all(rms(over.hand_arm(GRIP)) < rms(over.acceleration(GRIP)))


@pytest.mark.release
def test_acceleration_is_the_second_derivative_of_the_course() -> None:
    over = crankstar.mounts(mounted(), speeds=SPEEDS[:1]).over
    assert over is not None
    time = np.linspace(0, 4 * np.pi / SPEEDS[0], 40001)
    waves = np.exp(1j * np.multiply.outer(over.orders * SPEEDS[0], time))
    course = np.real(over.displacement(GRIP)[0].T @ waves)
    step = time[1] - time[0]
    twice = (course[:, 2:] - 2 * course[:, 1:-1] + course[:, :-2]) / step**2
    wanted = np.real(over.acceleration(GRIP)[0].T @ waves)[:, 1:-1]
    assert twice == pytest.approx(wanted, abs=2e-3 * np.abs(wanted).max())


@pytest.mark.release
def test_a_point_of_the_frame_moves_with_the_frame() -> None:
    points = [{"name": "grip", "up": "500 mm", "right": "350 mm", "z": "200 mm"}]
    engine = mounted(foundation={**GROUND, "points": points})
    over = crankstar.mounts(engine, speeds=SPEEDS).over
    assert over is not None
    below = over.motion[..., 6:] @ moved(np.array(GRIP) - over.block.centres[1]).T
    assert over.displacement(GRIP, of=1) == pytest.approx(below)
    assert rms(over.displacement(GRIP, of=1)) != pytest.approx(rms(over.displacement(GRIP)))


@pytest.mark.release
def test_stiff_mounts_carry_the_frame_along_with_the_block() -> None:
    stiff = [{**each, "stiffness": "1e6 N/mm", "rubber": []} for each in THREE]
    found = crankstar.mounts(mounted(mounts=stiff, foundation=GROUND), speeds=SPEEDS)
    over = found.over
    assert over is not None
    asked = np.searchsorted(over.speeds, found.asked)  # not at the peaks between them
    frame, block = rms(over.velocity(GRIP, of=1)), rms(over.velocity(GRIP))
    assert frame[asked] == pytest.approx(block[asked], rel=2e-2)
