"""Bearing loads of engines built to their tolerances, by `bearing_loads` of each engine."""

from math import pi
from typing import Any

import numpy as np
import pytest
from tests.laws.test_tolerances import MASSES, errors_of

from crankstar import spectra
from crankstar.analyses.tolerance.error_sources import sources_of
from crankstar.analyses.tolerance.linear_law import (
    amplitudes,
    bearing_lines,
    bearing_signals,
    moved,
)
from crankstar.analyses.tolerance.scatter import scatter
from crankstar.dynamics.bearing_variants import bearing_forces, bearing_names
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files import changed, engine_of
from crankstar.files.catalog import load, tree_of
from crankstar.files.tolerances import tolerances_of
from crankstar.mechanics.balance import scales
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Complex
from crankstar.studies.part_weights import with_parts

ORDERS = [1.0, 2.0, 4.0]
SPEED = 6000 * pi / 30
BOTH = {**MASSES, "cylinder.rotating_mass": "400 g +- 6 g"}


def seen(engine: Engine) -> tuple[Complex, Complex]:
    """The vectors of each bearing and order by `bearing_loads`, at SPEED."""
    own = spectra.selected(bearing_loads(engine, speed=SPEED).load, ORDERS)
    return own.forward, own.backward


@pytest.mark.parametrize(
    "name",
    ["i4", "i6", "v8-cross-plane", "ford-essex-42", "napier-deltic", "kr250-racer", "merlin"],
)
def test_a_batch_of_one_has_the_loads_that_bearings_prints(name: str) -> None:
    engine = load(name)
    found = bearing_forces(engine, mechanism(engine), orders=ORDERS)
    factor = scales(engine, SPEED)[0].force
    loads = bearing_loads(engine, speed=SPEED)
    size = float(spectra.amplitude(spectra.selected(loads.load, 1.0)).__abs__().max())
    for own, said in zip(found, seen(engine), strict=True):
        assert factor * own == pytest.approx(said, abs=1e-9 * size + 1e-12)
    assert list(bearing_names(engine)) == [(own.shaft, own.number) for own in loads.bearings]


@pytest.mark.parametrize(
    ("path", "text", "step"),
    [
        ("cylinder.reciprocating_mass", "500 g +- 3 g", "500.5 g"),
        ("cylinder.rotating_mass", "400 g +- 3 g", "400.5 g"),
        ("cylinder.stroke", "90 mm +- 0.1 mm", "90.001 mm"),
        ("cylinder.rod_length", "150 mm +- 0.1 mm", "150.001 mm"),
        ("layout.throws[2]", "240 deg +- 0.3 deg", "240.001 deg"),
        ("layout.throws[4]", "120 deg +- 0.3 deg", "120.001 deg"),
    ],
)
def test_the_law_of_a_bearing_is_the_change_of_its_load(path: str, text: str, step: str) -> None:
    """The errors of a value together are a change of the value in the file."""
    plain = {
        "cylinder.reciprocating_mass": "500 g",
        "cylinder.rotating_mass": "400 g",
        "cylinder.stroke": "90 mm",
        "cylinder.rod_length": "150 mm",
    }
    tree = tree_of("i6")[1]
    del tree["cylinder"]["rod_ratio"], tree["provenance"]
    tree, other = (changed(tree, {**plain, path: value}) for value in (text, step))
    del other["firing_order"]  # which a throw that is off by a little has not
    engine = engine_of(tree)
    errors = sources_of(tree, tolerances_of(tree), engine).errors
    lines = bearing_lines(engine, errors, orders=ORDERS, scale=scales(engine, SPEED)[0])
    before, after = seen(engine), seen(engine_of(other))
    unit = {"g": 1e-3, "mm": 1e-3, "deg": pi / 180}[text.split()[-1]]
    size = (float(step.split()[0]) - float(text.split()[0])) * unit
    for place, line in enumerate(lines.values()):
        for rates, a, b in zip(line.rates, before, after, strict=True):
            change = (b - a)[place] / size
            assert rates.sum(axis=0) == pytest.approx(change, rel=1e-3, abs=1e-3 * abs(b).max())
    assert [*lines] == [f"bearing {number}" for number in range(1, 8)]


@pytest.mark.release
def test_engines_built_one_by_one_scatter_by_the_law() -> None:
    """Pistons and big ends drawn at random, each engine put together and its bearings asked."""
    found = scatter("i4", changes=BOTH, speed=SPEED, orders=ORDERS, count=2000, bearings=True)
    engine, random, count = found.engine, np.random.default_rng(5), 400
    first = np.stack(seen(engine))
    squares = np.zeros(first.shape[1:])
    sizes = np.zeros((count, *first.shape[1:]))
    for built in range(count):
        heavier = {"piston": random.normal(0.0, 0.001, 4), "big_end": random.normal(0.0, 0.002, 4)}
        own = np.stack(seen(with_parts(engine, heavier)))
        squares += 2 * (np.abs(own - first) ** 2).sum(axis=0) / count
        sizes[built] = np.abs(own).sum(axis=0)
    for place, name in enumerate(bearing_signals(engine)):
        for column, order in enumerate(ORDERS):
            row = found.of(name, order)
            assert row.rms == pytest.approx(squares[place, column] ** 0.5, rel=0.15)
            assert row.rms_found == pytest.approx(row.rms, rel=0.06)
            most = np.quantile(sizes[:, place, column], 0.95)
            assert row.one_in_20 == pytest.approx(most, abs=row.rms)
            assert row.nominal == pytest.approx(float(np.abs(first[:, place, column]).sum()))


def test_random_engines_have_the_loads_of_their_arrays() -> None:
    """With errors of places and angles: what is left out of the law is of second order."""
    changes: dict[str, Any] = {
        **BOTH,
        "layout.bore_pitch": "100 mm +- 0.2 mm",
        "layout.throws[2]": "180 deg +- 0.2 deg",
    }
    engine, errors = errors_of("i4", changes)
    scale = scales(engine, SPEED)[0]
    lines = bearing_lines(engine, errors, orders=ORDERS, scale=scale)
    bounds = np.array([error.bound for error in errors])
    sizes = np.random.default_rng(3).uniform(-1, 1, (20, bounds.size)) * bounds
    exact = bearing_forces(engine, moved(mechanism(engine), errors, sizes), orders=ORDERS)
    for place, line in enumerate(lines.values()):
        for own, nominal, rates in zip(exact, *line, strict=True):
            straight = nominal + sizes @ rates
            most = float(np.abs(own).max()) * scale.force
            assert scale.force * own[:, place] == pytest.approx(straight, abs=3e-5 * most)
    assert float(amplitudes(lines["bearing 3"].nominal)[0]) > 0


def test_bearings_are_told_where_they_are_asked_for() -> None:
    plain = scatter("i4", changes=BOTH, count=1000, orders=[1])
    assert not [row for row in plain.rows if row.signal.startswith("bearing")]
    deltic = load("napier-deltic")
    assert len({name.rsplit(" ", 1)[0] for name in bearing_signals(deltic)}) == 3
    alone = with_values(deltic, name="deltic")
    assert bearing_signals(alone) == bearing_signals(deltic)


def test_a_shaft_may_have_a_dot_in_its_name() -> None:
    weights = [{"unbalance": "5 kg*mm", "z": z, "angle": "0 deg"} for z in ("0.1 m", "-0.1 m")]
    shaft = {"name": "no. 2", "speed_ratio": -1, "weight": weights}
    units = {"layout.bore_pitch": "100 mm", "cylinder.stroke": "90 mm"}
    changes = {**BOTH, **units, "balance_shaft": [shaft]}
    found = scatter("i4", changes=changes, speed=SPEED, count=1000, orders=[1], bearings=True)
    assert found.of("bearing no. 2 1", 1.0).nominal > 0
    assert found.of("bearing crank 1", 1.0).rms > 0
