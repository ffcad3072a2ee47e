"""Rods with gas, inertia and slave rods: statics of every rod at once (`tests/equilibrium`)."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import Phase, given, settings
from tests.equilibrium import assert_statics
from tests.whole_engines import loaded_engines

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle

CASES = Path(__file__).parents[1] / "cases"


def test_every_rod_of_any_engine_with_gas_is_in_equilibrium() -> None:
    @settings(max_examples=12, deadline=None, phases=[Phase.explicit, Phase.generate])
    @given(loaded=loaded_engines())
    def holds(loaded: tuple[Engine, Cycle]) -> None:
        assert_statics(*loaded)

    holds()


def test_bearings_guides_and_heads_of_a_radial_carry_its_inertia() -> None:
    engine = crankstar.load(CASES / "radial-clockwise.toml")
    assert_statics(engine, cycle(engine))


def test_the_slave_rods_of_a_radial_push_their_pin_once() -> None:
    engine = crankstar.load(CASES / "radial-clockwise.toml")
    loads = bearing_loads(engine, cycle=cycle(engine))
    assert float(spectra.peaks(loads.pin)[0]) == pytest.approx(25_502, rel=1e-4)
    assert spectra.peaks(loads.load).tolist() == pytest.approx([12_751, 12_751], rel=1e-4)
    assert float(spectra.peaks(loads.big_end)[0]) == pytest.approx(25_502, rel=1e-4)


@pytest.mark.parametrize("name", ["pratt-whitney-wasp", "radial-9"])
def test_a_master_rod_carries_its_slaves_on_its_big_end(name: str) -> None:
    loads = bearing_loads(crankstar.load(name))
    assert spectra.peaks(loads.big_end) == pytest.approx(spectra.peaks(loads.pin), rel=1e-9)
