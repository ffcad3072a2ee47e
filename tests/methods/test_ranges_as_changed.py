"""What the record says of a range against the engine file changed by hand: each a slip of its own.

Of sweeps, of torsion without a table [gas], of a resonance that leaves the speeds, of operating
points, of weights by a factor, of a charge that a load decides, of radial engines.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from tests.lacking import FIVE, GENSET
from tests.twisting_engines import TORSION

from crankstar.analyses.torsion.figures import twist
from crankstar.analysis.assumptions import Answer, Assumption
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.catalog import load
from crankstar.mechanics.gas import cycle
from crankstar.studies.answers import amplitudes, rests_on, torques
from crankstar.studies.sweep import sweep, watched
from crankstar.studies.sweep_answers import judged

DIESEL: dict[str, Any] = {
    key: size for key, size in GENSET.items() if key not in ("format", "drive")
} | {
    "name": "four",
    "firing_order": [1, 3, 4, 2],
    "cylinder": {**GENSET["cylinder"], "rotating_mass": "0 kg"},
    "gas": {"ignition": "compression", "compression_ratio": 17},
}


def record(engine: Engine, answer: Answer) -> Mapping[str, Assumption]:
    return {each.path: each for each in rests_on(engine, answer)}


def with_throws(**more: Any) -> Engine:
    """The five with throws of its own, which a sweep then takes as they are."""
    throws = [f"{angle} deg" for angle in (0, 216, 144, 72, 288)]
    return engine_of({**FIVE, **more, "layout": {**FIVE["layout"], "throws": throws}}, name="five")


@pytest.mark.many(first=1)
@pytest.mark.parametrize("what", ["roll_with_gas", "peak_pressure"])
def test_a_sweep_of_gas_rests_on_the_engine_with_its_firing_order(what: str) -> None:
    made = sweep(with_throws(), "speed=1000..3000 rpm/3")
    found = judged(made, [watched(made, what)])
    assert found.at == "speed = 3000 rpm"
    assert found.engine.firing_order == (1, 2, 4, 5, 3)
    rows = record(found.engine, found.answer)
    assert rows["gas"].status == "missing"
    figure = what.partition("_with")[0].replace("_", " ")
    moved = [row.moved for row in rows.values() if row.moved is not None]
    assert moved
    assert {own.quantity for own in moved} == {figure}


def test_a_peak_pressure_is_swept_where_the_engine_itself_would_stop() -> None:
    light = engine_of({**FIVE, "drive": {"inertia": "0.001 kg*m^2"}}, name="light")
    made = sweep(light, "speed=200..300 rpm/2")
    found = judged(made, [watched(made, "peak_pressure")])
    assert ("peak pressure", None) in found.answer.figures(found.engine)


def test_a_natural_frequency_that_is_swept_rests_on_no_damping_and_no_gas() -> None:
    over, changes = "cylinder.rod_length=140mm..150mm/2", {"torsion": TORSION}
    made = sweep("audi-25-tfsi", over, changes=changes)
    found = judged(made, [watched(made, "torsion_frequency")])
    assert not [path for path in record(found.engine, found.answer) if "gas" in path]


@pytest.mark.release
def test_a_crankshaft_is_twisted_by_the_range_of_a_usual_cycle_too() -> None:
    """A file without [gas] and one that has nothing but its compression ratio say the same.

    At a speed of petrol engines: a slow one without [gas] is taken for a Diesel.
    """
    fast = {**FIVE, "speed": "6000 rpm", "torsion": TORSION}
    whole = engine_of({**fast, "gas": {"compression_ratio": 10.0}}, name="a")
    bare = engine_of(fast, name="b")
    there, here = (record(each, twist(each)) for each in (whole, bare))
    for path in ("gas.combustion_duration", "gas.imep"):
        assert here[path].moved == there[path].moved
        assert here[path].effect > 0.01


@pytest.mark.release
def test_a_resonance_is_computed_where_it_is_though_it_leaves_the_speeds() -> None:
    engine = load("audi-25-tfsi", changes={"torsion": TORSION})
    found = torsion(engine, speeds=np.linspace(200.0, 500.0, 61))
    first = next(each for each in found.noted if each.mode == 1)
    top = 1.02 * found.modes[0].speed / first.order
    answer = twist(engine, speeds=[0.8 * top, top])
    key = next(key for key in answer.figures(engine) if key[0] == "resonant amplitude")
    stiff = load("audi-25-tfsi", changes={"torsion": {**TORSION, "stiffness": "0.9 MN*m/rad"}})
    order = key[1] or 1.0
    alone = torsion(stiff, speeds=[torsion(stiff).modes[0].speed / order]).response
    assert alone is not None
    assert alone.speeds[0] > top
    place = int(np.argmin(np.abs(alone.orders - order)))
    size = np.degrees(abs(alone.turns[0, place, found.free_end]))
    assert answer.figures(stiff)[key] == pytest.approx(size, rel=1e-9)


def test_a_mount_that_nothing_loads_has_no_transmissibility() -> None:
    """A four pushes up and rolls: a third mount behind the middle of two is hardly loaded."""
    rubber = [
        {"name": name, "right": f"{right} m", "z": f"{z} m", "stiffness": "100 N/mm"}
        for name, right, z in (("left", -0.3, 0.0), ("right", 0.3, 0.0), ("rear", 0.0, -0.4))
    ]
    tree = {**DIESEL, "block": {"mass": "120 kg"}, "mounts": rubber}
    tree["layout"] = {**DIESEL["layout"], "throws": ["0 deg", "180 deg", "180 deg", "0 deg"]}
    over = mounts(engine_of(tree, name="x"), speeds=[100.0, 300.0]).over
    assert over is not None
    assert np.isnan(over.transmissibility[:, 2]).all()
    assert np.isfinite(over.transmissibility[:, :2]).all()


@pytest.mark.parametrize("number", [1, 2])
def test_a_value_of_one_operating_point_moves_that_point_alone(number: int) -> None:
    points = [
        {"name": "low", "speed": "1000 rpm", "imep": "6 bar"},
        {"name": "high", "speed": "5000 rpm", "imep": "12 bar"},
    ]
    tree = {**FIVE, "gas": {"compression_ratio": 10.0, "point": points}}
    path = f"gas.point[{number}].imep"
    doubted = {path: {"status": "unverified", "source": "guess"}}

    def roll(share: float) -> float:
        changed = [dict(point) for point in points]
        size = float(changed[number - 1]["imep"].split()[0])
        changed[number - 1]["imep"] = f"{share * size} bar"
        engine = engine_of({**tree, "gas": {**tree["gas"], "point": changed}}, name="x")
        answer = torques(engine, lambda each: cycle(each, speed=300.0))
        return answer.figures(engine)[key]

    engine = engine_of({**tree, "provenance": doubted}, name="x")
    own = record(engine, torques(engine, lambda each: cycle(each, speed=300.0)))[path].moved
    assert own is not None
    key = (own.quantity, own.order)
    assert (own.low, own.high) == pytest.approx((roll(0.99), roll(1.01)), rel=1e-9)


@pytest.mark.parametrize(
    "more",
    [
        {"rotating_mass": "500 g"},
        {"rod": {"mass": "0.6 kg", "centre": "40 mm", "inertia": "0.002 kg*m^2"}},
    ],
)
def test_weights_by_a_factor_go_with_an_estimated_reciprocating_mass(more: dict[str, Any]) -> None:
    given = {"status": "estimated", "source": "x", "range": [0.8, 1.2]}
    tree = {**FIVE, "cylinder": {**FIVE["cylinder"], **more}, "balance_factor": 0.5}
    engine = engine_of({**tree, "provenance": {"cylinder.reciprocating_mass": given}}, name="x")
    own = record(engine, amplitudes(engine, gas=True))["cylinder.reciprocating_mass"]
    moved, vary = own.moved, own.vary
    assert moved is not None
    assert vary is not None
    for share in (0.8, 1.2):
        cylinder = {**tree["cylinder"], "reciprocating_mass": f"{480 * share} g"}
        changed = engine_of({**tree, "cylinder": cylinder}, name="x")
        wanted = amplitudes(changed).figures(changed)
        found = amplitudes(engine).figures(vary(engine, share))
        for key in (("couple", 1.0), ("couple", 2.0), ("force", 1.0), ("roll", 1.0)):
            assert found.get(key, 0.0) == pytest.approx(wanted.get(key, 0.0), rel=1e-9, abs=1e-6)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("imep", ["11.7 bar", "11.9 bar"])
def test_no_other_value_brings_a_charger_in_or_takes_one_away(imep: str) -> None:
    """At 11.7 bar the air just suffices and the pressure is 1 bar, at 11.9 bar it is 1.68 bar."""
    tree = {**DIESEL, "gas": {**DIESEL["gas"], "imep": imep}}
    engine = engine_of(tree, name="x")
    rows = record(engine, torques(engine, cycle))
    charge = cycle(engine).values["intake_pressure"]
    held = {key: cycle(engine).values[key] for key in ("intake_pressure", "exhaust_pressure")}
    pressure = {key: f"{size} Pa" for key, size in held.items()}
    fixed = engine_of({**tree, "gas": {**tree["gas"], **pressure}}, name="x")
    other = record(fixed, torques(fixed, cycle))
    for path in ("gas.gamma", "gas.wiebe_a", "valves.exhaust_opens"):
        own, still = rows[path].moved, other[path].moved
        assert own is not None
        assert still is not None
        assert own.effect < 2 * still.effect, path
    own = rows["gas.intake_pressure"]
    assert own.low is not None
    assert own.high is not None
    assert own.low < 1.02 < 1.6 < own.high, charge


def test_masses_of_a_radial_count_as_in_its_file() -> None:
    sizes = {"cylinder.bore": "105 mm", "cylinder.stroke": "130 mm", "speed": "2000 rpm"}
    masses = {"cylinder.reciprocating_mass": "2.4 kg"}
    engine = load("radial-9", changes={**sizes, **masses, "layout.knuckle_radius": "45 mm"})
    own = record(engine, amplitudes(engine, gas=True))["cylinder.rotating_mass"]
    assert own.moved is not None
    assert own.high is not None
    pins = dict(own.values)["pins"]
    added = {"cylinder.rotating_mass": f"{own.high} kg", "cylinder.throw_mass": f"{pins[1]} kg"}
    changed = load(
        "radial-9", changes={**sizes, **masses, "layout.knuckle_radius": "45 mm", **added}
    )
    key = (own.moved.quantity, own.moved.order)
    assert amplitudes(changed).figures(changed)[key] == pytest.approx(own.moved.high, rel=1e-9)


def test_the_type_of_an_engine_is_that_of_its_highest_speed_and_its_ignition() -> None:
    full = load("audi-25-tfsi")
    idle = load("audi-25-tfsi", changes={"speed": "800 rpm"})
    ends = [
        (own.low, own.high)
        for each in (full, idle)
        for own in [record(each, amplitudes(each, gas=True))["cylinder.rotating_mass"]]
    ]
    assert ends[0] == ends[1]
