"""Each printed load of a bearing, pin or wall counts for what an answer on loads rests on."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from crankstar import spectra
from crankstar.analysis.assumptions import moved
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.studies.assumed_values import assumed_values
from crankstar.studies.load_answers import bearing_peaks

DIESEL: dict[str, Any] = {
    "name": "in-line four Diesel",
    "firing_order": [1, 3, 4, 2],
    "speed": "4000 rpm",
    "cylinder": {
        "bore": "81 mm",
        "stroke": "95.5 mm",
        "rod_length": "144 mm",
        "reciprocating_mass": "790 g",
        "rotating_mass": "640 g",
    },
    "layout": {"type": "inline", "bore_pitch": "88 mm"},
    "gas": {
        "ignition": "compression",
        "compression_ratio": 16.5,
        "bmep": "14 bar",
        "intake_pressure": "2.2 bar",
    },
}
SPEED, RADIUS = 4000 * pi / 30, 0.04775


def _burnt(engine: Engine) -> Cycle:
    return cycle(engine)


def test_counterweights_are_told_by_the_bearing_that_they_move_most() -> None:
    """The middle of five, between two throws that point one way, and not the one of most gas."""
    engine = engine_of(DIESEL)
    answer = bearing_peaks(engine, _burnt, kinds=("main bearing ",))
    asked = ("crankshaft.weight", "cylinder.throw_mass")
    some = [each for each in assumed_values(engine, answer) if each.path in asked]
    found = {each.path: each for each in moved(engine, some, answer)}
    loads = bearing_loads(engine, cycle=cycle(engine))
    peaks = spectra.peaks(loads.load)
    assert int(np.argmax(peaks)) in (1, 3)

    # a counterweight at each of both throws, half of whose force is on each bearing beside it
    theta = np.linspace(0, 4 * pi, 8001)
    middle = spectra.value(loads.load[2], theta)
    mass = 0.640 + 0.5 * 0.790
    along = np.exp(1j * (theta + pi)) * RADIUS * SPEED**2  # throws 2 and 3, at half a turn
    weighed = found["crankshaft.weight"].moved
    assert weighed is not None
    assert weighed.quantity == "main bearing 3"
    assert weighed.now == pytest.approx(float(peaks[2]))
    assert weighed.high == pytest.approx(np.abs(middle - mass * along).max(), rel=1e-4)
    assert weighed.effect == pytest.approx((weighed.high - weighed.now) / peaks.max(), rel=1e-6)

    pins = found["cylinder.throw_mass"].moved
    assert pins is not None
    heaviest = float(found["cylinder.throw_mass"].high or 0)
    number = int(pins.quantity.removeprefix("main bearing "))
    places = {1: [1], 2: [1, -1], 3: [-1, -1], 4: [-1, 1], 5: [1]}  # throws beside each bearing
    own = spectra.value(loads.load[number - 1], theta)
    own = own - sum(places[number]) / 2 * heaviest * along  # along is that of throws 2 and 3
    ends = [pins.low, pins.high]
    assert min(abs(end - float(np.abs(own).max())) for end in ends) < 1e-4 * pins.now


def test_the_same_number_on_two_crankshafts_goes_with_the_shaft() -> None:
    """A square four has two crankshafts with two pins each."""
    from crankstar.files.catalog import load

    engine = load("square-four")
    figures = bearing_peaks(engine, lambda _: None, kinds=("crank pin ",)).figures(engine)
    loads = bearing_loads(engine)
    shafts = [pin.shaft for pin in loads.pins]
    names = [f"crank pin {pin.throw} ({pin.shaft})" for pin in loads.pins]
    assert len(set(shafts)) == 2
    assert [name for name, _order in figures] == names
    assert [*figures.values()] == pytest.approx(spectra.peaks(loads.pin).tolist())
