"""A load course that leaves out a part of the cycle is refused, with what would be right."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np
import pytest
from tests.texts import SHORT, spoilt

from crankstar.engine.drive import Drive
from crankstar.engine.gas_checks import drive_faults
from crankstar.files import EngineFileError, engine_of

TURN, WAVE = [0, 90, 180, 270], [1, 1.5, 1, 0.5]


def course(angles: Sequence[float], values: Sequence[float]) -> dict[str, Any]:
    return {"load_angle": [f"{each} deg" for each in angles], "load_torque": [*values]}


def read(angles: Sequence[float], values: Sequence[float]) -> Any:
    return engine_of(spoilt(SHORT, drive=course(angles, values)))


def test_the_course_of_one_turn_is_refused_with_the_angles_of_the_second() -> None:
    with pytest.raises(EngineFileError) as told:
        read(TURN, WAVE)
    said = str(told.value)
    assert "has a gap of 450 deg, from 270 to 720 deg" in said
    assert "give them again for the second, at 360, 450, 540, 630 deg" in said


def test_given_twice_it_is_a_course_of_the_first_order() -> None:
    """By its Fourier sum: no half order, where the straight line over the gap made one of 0.25."""
    engine = read([*TURN, *(each + 360 for each in TURN)], [*WAVE, *WAVE])
    drive = engine.drive
    theta = np.arange(4096) * (4 * pi / 4096)

    def half_order(angles: Sequence[float], values: Sequence[float]) -> float:
        line = np.interp(theta, [*np.radians(angles), 4 * pi], [*values, values[0]])
        return float(2 * abs(np.mean(line * np.exp(-0.5j * theta))))

    assert half_order(np.degrees(drive.load_angle).tolist(), [*drive.load_torque]) < 1e-9
    assert half_order([*map(float, TURN)], WAVE) > 0.1


@pytest.mark.parametrize(
    ("angles", "refused"),
    [
        ([0, 360], False),  # few values, but of the whole cycle
        ([0, 180, 360, 540], False),
        ([0, 180, 360], True),
        ([0, 90, 180, 270, 360], True),
        ([100, 200, 300, 400, 500, 600], True),  # around the end: 220, of 100 the others
        ([0, 300, 400, 500, 600, 700], True),
        ([90], False),
        ([0, 720], False),  # one straight line over the whole cycle
    ],
)
def test_a_gap_of_more_than_half_a_turn(angles: list[float], refused: bool) -> None:
    if refused:
        with pytest.raises(EngineFileError, match="has a gap of"):
            read(angles, [1.0] * len(angles))
    else:
        assert read(angles, [1.0] * len(angles)).drive.load_torque


def test_of_a_two_stroke_one_turn_is_the_cycle() -> None:
    drive = Drive(load_angle=tuple(np.radians(TURN)), load_torque=tuple(WAVE))
    assert not [*drive_faults(drive, cycle="two-stroke", crankshafts=["crankshaft"])]
