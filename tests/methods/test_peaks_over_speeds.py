"""Peaks over a range of speeds: of the range, whatever the steps that were asked for."""

from __future__ import annotations

import tomllib
from math import pi

import numpy as np
import pytest
from tests.texts import spoilt

from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_excitation import Excitation, excitation
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.files import engine_of
from crankstar.spectra import Real

SIX = """
format = 1
name = "Diesel six genset"
cycle = "four-stroke"
firing_order = [1, 5, 3, 6, 2, 4]
speed = "1500 rpm"
[cylinder]
bore = "137 mm"
stroke = "165 mm"
rod_length = "265 mm"
reciprocating_mass = "5 kg"
[layout]
type = "inline"
bore_pitch = "170 mm"
[gas]
ignition = "compression"
imep = "20 bar"
intake_pressure = "1 bar"
[torsion]
inertia = "0.45 kg*m^2"
stiffness = "2.5e6 N*m/rad"
diameter = "105 mm"
[[torsion.disc]]
name = "flywheel"
inertia = "12 kg*m^2"
to = "rear"
stiffness = "3.2e6 N*m/rad"
[[torsion.disc]]
name = "generator"
inertia = "8 kg*m^2"
to = "flywheel"
stiffness = "4.5e4 N*m/rad"
"""
"""A six that drives a generator, as a file."""


def by_matrices(chain: TorsionChain, push: Excitation, speeds: Real) -> Real:
    """The greatest torque of each section, of M, K + i H and C and a fine grid of crank angles."""
    inertia, _stiffness, damping = chain.matrices()
    lossy = chain.complex_stiffness()
    theta = np.linspace(0, 4 * pi, 2881)
    out = np.zeros((speeds.size, len(chain.sections)))
    for row, speed in enumerate(speeds):
        driving = push.torque(np.array([speed]))[0]
        course = np.zeros((len(chain.sections), theta.size))
        for place, order in enumerate(push.orders):
            w = order * speed
            turn = np.linalg.solve(
                lossy - w**2 * inertia + 1j * w * damping, chain.transform.T @ driving[:, place]
            )
            wave = np.exp(1j * order * theta)
            for index, own in enumerate(chain.sections):
                twist = turn[chain.freedom[own.after]] - turn[chain.freedom[own.before]]
                course[index] += np.real(own.stiffness * (1 + 1j * own.loss_factor) * twist * wave)
        out[row] = np.abs(course).max(axis=1)
    return out


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("loss", "greatest", "rpm"), [(None, 29.2303e3, 1018.4), (0.005, 104.1356e3, 1018.6)]
)
def test_the_peak_over_a_range_is_that_of_the_range_and_not_of_its_grid(
    loss: float | None, greatest: float, rpm: float
) -> None:
    engine = engine_of(tomllib.loads(SIX))
    if loss is not None:
        engine = engine_of(spoilt(SIX, torsion__loss_factor=loss))
    peaks = []
    for step in (100, 130, 10):
        found = torsion(engine, speeds=np.arange(500.0, 1801.0, step) * pi / 30)
        assert found.response is not None
        place = int(found.response.peak[:, 4].argmax())
        peaks.append(float(found.response.peak[place, 4]))
        assert found.speeds[place] * 30 / pi == pytest.approx(rpm, abs=0.1)
    assert peaks == pytest.approx([greatest] * 3, rel=1e-5)
    found = torsion(engine, speeds=np.array([500.0, 1800.0]) * pi / 30)
    assert found.response is not None
    dense = np.linspace(rpm - 0.5, rpm + 0.5, 21) * pi / 30
    push = excitation(found.chain, engine, found.cycle)
    other = by_matrices(found.chain, push, dense)[:, 4].max()
    assert found.response.peak[:, 4].max() == pytest.approx(other, rel=1e-4)


def test_critical_speeds_and_half_power_points_belong_to_every_grid() -> None:
    found = torsion(engine_of(tomllib.loads(SIX)), speeds=np.array([500.0, 1800.0]) * pi / 30)
    assert {each.speed for each in found.criticals} <= {*found.speeds.tolist()}
    loss = found.chain.sections[0].loss_factor
    strongest = found.strongest
    assert strongest is not None
    for side in (-1, 1):
        half = strongest.speed * (1 + side * loss / 2)
        assert np.abs(found.speeds / half - 1).min() < 1e-9


@pytest.mark.release
def test_a_coarse_grid_bars_what_a_fine_one_bars() -> None:
    limited = engine_of(spoilt(SIX, torsion__shear_limit="60 MPa"))
    coarse, fine = (
        torsion(limited, speeds=np.linspace(500.0, 1800.0, count) * pi / 30).barred
        for count in (2, 1301)
    )
    assert len(coarse) == len(fine) > 3
    for one, other in zip(coarse, fine, strict=True):
        assert one.section == other.section
        assert (one.low, one.high) == pytest.approx((other.low, other.high), rel=1e-5)
