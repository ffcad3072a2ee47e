"""A load course and friction: known without a speed, and never the other way round."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.dynamics.load_reaction import load_reaction
from crankstar.dynamics.uneven import driven, load_taken
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.operating_points import GasError
from crankstar.tables.torque import assumed_notes, notes

SPEED = 100 * pi
SWEPT = 4 * pi / 4 * 0.082**2 * 0.09


def four(**changed: object) -> Engine:
    """An in-line four that drives a pump of two strokes a turn, 1 to 3 and back every half turn."""
    gas: dict[str, object] = {
        "compression_ratio": 10.8,
        "imep": "10 bar",
        "friction_pressure": "1 bar",
    }
    return engine_of(
        {
            "name": "NS",
            "firing_order": [1, 3, 4, 2],
            "cylinder": {
                "bore": "82 mm",
                "stroke": "90 mm",
                "rod_length": "145 mm",
                "reciprocating_mass": "480 g",
            },
            "layout": {"type": "inline", "bore_pitch": "91 mm"},
            "gas": {key: each for key, each in {**gas, **changed}.items() if each is not None},
            "drive": {
                "inertia": "0.14 kg*m^2",
                "load_angle": ["0 deg", "180 deg", "360 deg", "540 deg"],
                "load_torque": [1, 3, 1, 3],
            },
        }
    )


def first(engine: Engine, found: Cycle) -> float:
    """The amplitude of the reaction of order 1, N m; 0 where there is none."""
    reaction = load_reaction(engine, found)
    if reaction is None:
        return 0.0
    return abs(complex(spectra.amplitude(spectra.selected(reaction, [1.0]))[0]))


def right(bmep: float) -> float:
    """Of a triangle between half and one and a half times the brake torque, by its own series."""
    return bmep * SWEPT / (4 * pi) * 4 / pi**2


@pytest.mark.parametrize("speed", [None, SPEED])
@pytest.mark.parametrize(("friction", "lost"), [("1 bar", 1e5), (None, 0.0)])
def test_the_reaction_of_a_load_needs_no_speed(
    speed: float | None, friction: str | None, lost: float
) -> None:
    said = {"friction": "none"} if friction is None else {}
    engine = four(friction_pressure=friction, **said)
    found = cycle(engine, speed=speed)
    assert first(engine, found) == pytest.approx(right(10e5 - lost), rel=1e-9)
    assert found.friction == lost
    assert found.bmep == pytest.approx(10e5 - lost)


def test_a_friction_that_needs_a_speed_is_not_nought_without_one() -> None:
    engine = four(friction_pressure=None, friction="spark-ignition")
    found = cycle(engine)
    assert (found.friction, found.bmep) == (None, None)
    told = crankstar.torque(engine).to_dict()
    assert told["brake_torque"] is None
    assert any("Friction is left out of the load" in each for each in notes(engine, cycle(engine)))


@pytest.mark.parametrize("known", [{"friction_pressure": "1 bar"}, {"friction": "none"}])
def test_a_brake_load_needs_no_speed_where_friction_needs_none(known: dict[str, str]) -> None:
    lost = 1e5 if "friction_pressure" in known else 0.0
    engine = four(imep=None, bmep="9 bar", **{"friction_pressure": None, **known})
    assert cycle(engine).imep == pytest.approx(9e5 + lost, rel=1e-9)
    assert cycle(engine).imep == pytest.approx(cycle(engine, speed=SPEED).imep, rel=1e-12)


def test_a_brake_load_whose_friction_goes_with_the_speed_names_both_remedies() -> None:
    with pytest.raises(GasError) as caught:
        cycle(four(imep=None, bmep="9 bar", friction_pressure=None))
    assert '--speed "3000 rpm"' in str(caught.value)
    assert "gas.friction_pressure" in str(caught.value)


@pytest.mark.parametrize("imep", ["0.5 bar", "1 bar", "1.5 bar"])
def test_a_load_takes_work_or_its_course_is_left_out(imep: str) -> None:
    engine = four(imep=imep)
    found = cycle(engine, speed=SPEED)
    brake = float(imep.split()[0]) * 1e5 - 1e5
    assert first(engine, found) == pytest.approx(right(max(brake, 0.0)), rel=1e-9, abs=1e-9)
    left_out = "The course of the load is left out"
    said = assumed_notes(engine, found)
    assert any(each.startswith(left_out) for each in said) == (brake <= 1e-3)
    codes = [fault.code for fault in doubts(engine)]
    assert ("doubt.no-work" in codes) == (brake < -1e-3)
    running = driven(engine, found)
    assert running is not None
    assert (np.ptp(running.load) > 1e-9) == (brake > 1e-3)


def test_an_engine_that_is_turned_from_outside_drives_nothing() -> None:
    engine = four()
    found = cycle(engine, speed=SPEED, motored=True)
    assert load_reaction(engine, found) is None
    running = driven(engine, found)
    assert running is not None
    assert np.ptp(running.load) < 1e-9


def test_a_motored_engine_that_its_charge_would_turn_has_no_course() -> None:
    """3 bar in and 1 bar out push it on; it is still turned from outside, and drives no load."""
    own = {
        "drive": {"load_torque": [2, 0], "load_angle": ["0 deg", "360 deg"]},
        "gas.friction_pressure": "0.1 bar",
        "gas.intake_pressure": "3 bar",
        "gas.exhaust_pressure": "1 bar",
    }
    engine = crankstar.load("honda-b18c", changes=own)
    found = cycle(engine, motored=True)
    assert float(gas_torque(found).mean.sum()) > 0
    assert load_taken(engine, found) is None
    assert load_taken(engine, cycle(engine)) is not None
