"""What the page is sent of torque and exhaust adds up to what Python computes."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from tests.marine import marine_engine

from crankstar import spectra
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, OperatingPoint, Trace
from crankstar.files.catalog import load
from crankstar.firing.exhaust_orders import exhaust_orders
from crankstar.language.shown_units import read_choice, shown_in
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.guide_moments import guide_moments
from crankstar.page.cycle_records import Load, Torque
from crankstar.page.torque import MOST_LOADS, exhaust, gas_needs, torque, torque_unit
from crankstar.spectra import Complex


def added_up(shown: Torque, load: Load, off: tuple[int, ...] = ()) -> tuple[Complex, float]:
    """Amplitudes by order and the mean, as the page adds them up."""
    orders = np.array(shown.orders)
    out, mean = np.zeros(orders.size, complex), 0.0
    for chamber in shown.chambers:
        still = chamber.number in off
        wave = (load.still if still else load.burning)[chamber.wave]
        mean += (load.still_mean if still else load.burning_mean)[chamber.wave]
        out += np.array([complex(*pair) for pair in wave]) * np.exp(-1j * orders * chamber.fires)
    return out, mean


def checked(engine: Engine, *, point: str = "", off: tuple[int, ...] = ()) -> Torque:
    """The record, once its waves have been found to be the gas torque."""
    shown = torque(engine)
    assert shown is not None
    (sent,) = (each for each in shown.loads if each.name == point)
    found = gas_torque(cycle(engine, point=point, off=off))
    expected = spectra.amplitude(spectra.selected(found.total, list(shown.orders)))
    amplitude, mean = added_up(shown, sent, off)
    assert amplitude == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())
    assert mean == pytest.approx(float(found.mean.sum()), rel=1e-9)
    return shown


def first(name: str) -> str:
    """The operating point that is sent first; empty where the file has none."""
    gas = load(name).gas
    return gas.points[0].name if gas is not None and gas.points else ""


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("name", "waves"),
    [("ferrari-f136", 1), ("kr250-racer", 2), ("pratt-whitney-wasp", 9), ("jumo-205", 6)],
)
def test_the_waves_of_chambers_add_up_to_the_torque_of_the_engine(name: str, waves: int) -> None:
    shown = checked(load(name), point=first(name))
    assert len(shown.loads[0].burning) == waves
    checked(load(name), point=first(name), off=(1,))


@pytest.mark.release
def test_every_operating_point_is_sent_and_an_assumed_load_only_without_any() -> None:
    engine = load("audi-25-tfsi")
    points = tuple(OperatingPoint(name=f"{bar} bar", imep=bar * 1e5) for bar in range(2, 20))
    shown = checked(with_values(engine, gas=Gas(points=points)), point="3 bar")
    assert [each.name for each in shown.loads] == [each.name for each in points[:MOST_LOADS]]
    assert not any(each.assumed for each in shown.loads)
    own = checked(with_values(engine, gas=Gas(imep=5e5, points=points[:1])), point="2 bar")
    assert [each.name for each in own.loads] == ["", "2 bar"]
    (assumed,) = checked(with_values(engine, gas=None)).loads
    assert assumed.assumed
    assert assumed.notes


def test_a_chamber_with_a_measured_pressure_of_its_own_has_a_wave_of_its_own() -> None:
    engine = load("audi-25-tfsi")
    angle = tuple(((np.arange(720) - 360) * pi / 180).tolist())
    one = 1e5 + 5e6 * np.exp(-(((np.array(angle) - 0.2) / 0.4) ** 2))
    rows = [one, one, 0.9 * one + 1e4, one, one]
    trace = Trace(
        angle=angle,
        pressure=tuple(map(tuple, np.array(rows).tolist())),
        chambers=engine.firing_order,
    )
    shown = checked(with_values(engine, gas=Gas(trace=trace)))
    weak = engine.firing_order[2]
    waves = {chamber.number: chamber.wave for chamber in shown.chambers}
    assert [number for number in waves if waves[number] == waves[weak]] == [weak]
    assert len(shown.loads[0].burning) == 2


def test_an_engine_without_bores_has_no_torque_but_a_sentence_on_what_it_needs() -> None:
    engine = load("v8-cross-plane")
    assert torque(engine) is None
    assert "cylinder.bore" in gas_needs(engine)
    assert gas_needs(load("audi-25-tfsi")) == ""


def test_the_unit_of_torque_is_that_of_the_context() -> None:
    with shown_in(read_choice("us")):
        unit = torque_unit(load("audi-25-tfsi"))
    assert unit.label == "lbf ft"
    assert 1 / unit.factor == pytest.approx(1.3558179483)


def test_the_firings_of_each_pipe_have_the_orders_of_the_exhaust() -> None:
    engine = load("v8-cross-plane")
    heard = exhaust(engine)
    assert heard is not None
    expected = exhaust_orders(engine)
    for pipe, sums in zip(heard.pipes, expected.sums, strict=True):
        phase = np.exp(-1j * np.outer(pipe.fires, expected.orders))
        assert phase.sum(axis=0) == pytest.approx(sums, abs=1e-9)
    assert heard.cycle == pytest.approx(4 * pi)
    assert exhaust(with_values(engine, firing_order=())) is None


def test_a_large_engine_has_its_guide_force_moments_on_the_page() -> None:
    engine = marine_engine()
    shown = torque(engine)
    assert shown is not None
    titles = [table.title for table in shown.loads[0].tables]
    assert titles[-1] == "Guide-force moments"
    found = guide_moments(engine, cycle(engine))
    assert len(shown.loads[0].tables[-1].rows) == len(found.noted())
    small = torque(load("audi-25-tfsi"))
    assert small is not None
    assert all("Guide" not in table.title for table in small.loads[0].tables)
