"""The rolling moment when a flywheel takes the torque, by statics: side thrust times height."""

from __future__ import annotations

import numpy as np
import pytest

from crankstar import spectra, total
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.layouts import inline
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import rolling_moment


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("offset", [0.0, 0.008, -0.005])
def test_the_block_is_rolled_by_the_side_thrust_of_the_piston(rotation: str, offset: float) -> None:
    radius, rod, mass, speed = 0.04, 0.14, 0.5, 600.0
    sizes = Sizes(
        stroke=2 * radius, rod_length=rod, reciprocating_mass=mass, rotating_mass=0.4, offset=offset
    )
    engine = inline(Basis(name="single", rotation=rotation, cylinder=sizes), throws=(0.0,))  # pyright: ignore[reportArgumentType]
    count = 256
    theta = np.arange(count) * (2 * np.pi / count)
    psi = engine.shafts[0].throws[0].angle + engine.sense * theta
    across = radius * np.sin(psi) - offset  # the pin, to the right of the cylinder axis
    lean = np.sqrt(rod**2 - across**2)
    height = radius * np.cos(psi) + lean
    turns = np.fft.fftfreq(count, 1 / count)
    acceleration = np.fft.ifft(-(turns**2) * np.fft.fft(height)).real * speed**2
    # The rod must push the piston by m x'' along the axis; it leans, so it pushes it aside, and the
    # piston the wall.
    thrust = mass * acceleration * -across / lean
    # The pin force passes on: about the crank axis the wall's moment is height times thrust, and
    # the offset adds nothing
    # of the axial force, which acts between rod and piston and not on the wall.
    found = np.real(spectra.value(rolling_moment(total(balance(engine, speed=speed))), theta))
    assert np.max(np.abs(found - height * thrust)) <= 1e-9 * np.max(np.abs(height * thrust))
