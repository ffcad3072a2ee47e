"""The inertia of the crankshaft is a value of the file: its own crankpins are in it once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.lacking import GENSET

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.uneven import driven, flywheel_for
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.kinetic import inertia

SIX: dict[str, Any] = {
    **GENSET,
    "torsion": {"bare_inertia": "0.03 kg*m^2", "stiffness": "3 MN*m/rad"},
}


def six(throw_mass: float) -> Engine:
    """The six with crankpins of this mass, kg."""
    return engine_of({**SIX, "cylinder": {**SIX["cylinder"], "throw_mass": f"{throw_mass} kg"}})


def by_integration() -> float:
    """Pistons and big ends of the six, kg m^2: the mean of m (dx/dtheta)^2 by differences."""
    radius, rod, count = 0.075, 0.25, 7200
    theta = np.arange(count) * 2 * np.pi / count
    way = radius * np.cos(theta) + np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    speed = (np.roll(way, -1) - np.roll(way, 1)) * count / (4 * np.pi)
    return 6 * (4.0 * float(np.mean(speed**2)) + 3.5 * radius**2)


@pytest.mark.parametrize("throw_mass", [0.0, 1.8])
def test_the_crankpins_are_in_the_inertia_that_the_file_gives(throw_mass: float) -> None:
    engine = six(throw_mass)
    theta = np.arange(720) * np.pi / 360
    assert inertia(engine, theta).mean() == pytest.approx(by_integration(), rel=1e-6)
    run = driven(engine, cycle(engine))
    assert run is not None
    assert run.inertia == pytest.approx(6 + by_integration(), rel=1e-6)
    assert run.inertia == pytest.approx(6.1872, abs=5e-5)


def test_heavier_crankpins_ask_for_no_other_flywheel() -> None:
    sizes = [flywheel_for(one, cycle(one), irregularity=0.005) for one in (six(0.0), six(1.8))]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-12)


@pytest.mark.parametrize("throw_mass", [0.0, 1.8])
def test_throws_that_twist_have_their_crankpins_in_the_bare_crankshaft(throw_mass: float) -> None:
    throws = torsion_chain(six(throw_mass)).inertias()[0]
    assert throws == pytest.approx(0.03 + np.full(6, by_integration() / 6), rel=1e-6)
