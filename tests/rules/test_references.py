"""Bare numbers of the catalog keep what they count in when a size that is missing is added."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, catalog, engine_of, explicit
from crankstar.files.forms import is_explicit
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.lacking import pitch_key

ADDED = {"pitch": "100 mm", "radius": "80 mm", "mass": "500 g"}


def additions(engine: Engine) -> dict[str, str]:
    """The keys that the program says are missing, by what the file does not give."""
    keys = {"pitch": pitch_key(engine), "radius": "cylinder.stroke"}
    keys["mass"] = "cylinder.reciprocating_mass"
    return {scale: keys[scale] for scale in engine.relative}


def lacking() -> list[tuple[str, tuple[str, ...]]]:
    """Engines of the catalog with each quantity that they lack, and with all."""
    out: list[tuple[str, tuple[str, ...]]] = []
    for name in catalog.names():
        tree = catalog.tree_of(name)[1]
        missing = () if is_explicit(tree) else engine_of(tree).relative
        out += [(name, (scale,)) for scale in missing]
        out += [(name, missing)] if len(missing) > 1 else []
    return out


@pytest.mark.parametrize(("name", "scales"), lacking())
def test_sizes_that_are_added_leave_an_engine_of_the_catalog_as_it_is(
    name: str, scales: tuple[str, ...]
) -> None:
    """In m r w^2 and m r w^2 a its forces, couples and rolling moments are what they were."""
    tree: Any = catalog.tree_of(name)[1]
    engine = engine_of(tree)
    keys = additions(engine)
    whole = engine_of(tree, changes={keys[scale]: ADDED[scale] for scale in scales})
    assert not {*scales} & {*whole.relative}
    one, other = (total(balance(each, orders=[1.0, 2.0, 3.0])) for each in (engine, whole))
    for quantity in ("force", "couple", "torque"):
        before, after = (getattr(each, quantity) for each in (one, other))
        size = max(float(np.abs(before.forward).max()), 1e-3)
        assert after.forward == pytest.approx(before.forward, abs=1e-9 * size)
        assert after.backward == pytest.approx(before.backward, abs=1e-9 * size)


def test_the_flat_plane_eight_with_its_sizes_rocks_as_it_should() -> None:
    """Its banks are 0.2 bore pitches apart, 20 mm: the secondary couple is 113.46 N m."""
    added = {
        "layout.bore_pitch": "100 mm",
        "cylinder.stroke": "80 mm",
        "cylinder.reciprocating_mass": "500 g",
    }
    engine = engine_of(catalog.tree_of("v8-flat-plane")[1], changes=added)
    places = sorted({cylinder.z for cylinder in engine.cylinders})
    assert np.diff(places) == pytest.approx([0.02, 0.08] * 3 + [0.02])
    couple = total(balance(engine, speed=6000 * np.pi / 30)).couple
    second = couple.orders == 2
    size = np.abs(couple.forward[second]) + np.abs(couple.backward[second])
    assert size == pytest.approx(113.46, rel=1e-4)


def test_a_bare_length_beside_a_size_with_a_unit_is_refused() -> None:
    """Metres, or bore pitches as before the pitch was given: who wrote it knows."""
    tree: Any = catalog.tree_of("v8-flat-plane")[1]
    tree = {**tree, "layout": {**tree["layout"], "bore_pitch": "100 mm"}}
    with pytest.raises(EngineFileError) as caught:
        engine_of(tree)
    [fault] = caught.value.faults
    assert (fault.code, fault.path) == ("unit.bare-beside-pitch", ("layout", "bank_offset"))
    assert (fault.values["relative"], fault.values["absolute"]) == ("20 mm", "200 mm")
    in_metres = {**tree, "layout": {**tree["layout"], "bore_pitch": 0.1}}
    assert engine_of(in_metres).bore_pitch == 0.1  # all bare: all in SI units


WHOLE = {
    "name": "four",
    "cylinder": {"bore": 2.1, "rod_length": 3.5, "rotating_mass": 0.8, "throw_mass": 0.3},
    "layout": {"type": "inline", "throws": ["0 deg", "180 deg", "180 deg", "0 deg"]},
    "cylinders": [{"number": 2, "offset": 0.2, "rotating_mass": 0.9}],
    "crankshaft": [
        {
            "bearings": [2.0, 1.0, 0.0, -1.0, -2.0],
            "bending_stiffness": 3.0,
            "bearing_stiffness": 5.0,
            "weight": [{"unbalance": 0.4, "z": 1.5}],
        }
    ],
}
"""A short file that has no size of its own, with numbers of every kind."""
SIZES = {
    "layout.bore_pitch": "100 mm",
    "cylinder.stroke": "80 mm",
    "cylinder.reciprocating_mass": "500 g",
}


def loads(engine: Engine) -> np.ndarray:
    """The loads on the main bearings as one beam on springs, in m r w^2."""
    found = bearing_loads(engine, model="continuous", speed=1.0).load
    return np.concatenate([found.forward, found.backward]) / unit_force(engine)


def unit_force(engine: Engine) -> float:
    """One m r w^2, at 1 rad/s."""
    mass = 1.0 if "mass" in engine.relative else 0.5
    return mass * (1.0 if "radius" in engine.relative else 0.04)


def test_a_beam_on_springs_is_the_same_with_its_sizes() -> None:
    """E I/(k a^3) has no unit: 3 N a^2 over 5 N/a stays what it is for a pitch of 100 mm."""
    bare = engine_of(WHOLE)
    whole = engine_of(WHOLE, changes=SIZES)
    shaft = whole.shafts[0]
    assert shaft.bending_stiffness == pytest.approx(3.0 * 0.1**2)
    assert shaft.bearing_stiffness == pytest.approx(5.0 / 0.1)
    assert loads(whole) == pytest.approx(loads(bare), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("place", "value", "code", "relative", "absolute"),
    [
        (("cylinder", "bore"), 2.1, "unit.bare-beside-radius", "84 mm", "2100 mm"),
        (("cylinder", "rod_length"), 0.3, "unit.bare-beside-radius", "12 mm", "300 mm"),
        (("cylinder", "rotating_mass"), 0.8, "unit.bare-beside-mass", "400 g", "800 g"),
    ],
)
def test_a_bare_number_beside_its_size_with_a_unit_is_refused_whatever_it_is(
    place: tuple[str, str], value: float, code: str, relative: str, absolute: str
) -> None:
    cylinder = {"stroke": "80 mm", "rod_length": "140 mm", "reciprocating_mass": "500 g"}
    tree: Any = {"name": "one", "cylinder": cylinder, "layout": {"type": "inline", "throws": [0]}}
    engine_of(tree)
    tree[place[0]][place[1]] = value
    with pytest.raises(EngineFileError) as caught:
        engine_of(tree)
    [fault] = caught.value.faults
    assert (fault.code, fault.path) == (code, place)
    assert (fault.values["relative"], fault.values["absolute"]) == (relative, absolute)


def test_parts_with_units_are_a_mass_that_bare_masses_are_scaled_by() -> None:
    tree: Any = {
        "name": "one",
        "cylinder": {"stroke": "80 mm", "rotating_mass": 0.8},
        "layout": {"type": "inline", "throws": [0]},
    }
    parts = {"cylinder.parts.piston": "400 g", "cylinder.parts.pin": "100 g"}
    engine = engine_of(tree, changes=parts)
    assert engine.throw(engine.first).rotating_mass == pytest.approx(0.4)
    with pytest.raises(EngineFileError) as caught:
        engine_of({**tree, "cylinder": {**tree["cylinder"], "parts": {"piston": "500 g"}}})
    assert [fault.code for fault in caught.value.faults] == ["unit.bare-beside-mass"]


def test_the_rear_shaft_of_a_square_four_stays_four_crank_radii_away() -> None:
    engine = engine_of(catalog.tree_of("square-four")[1], changes={"cylinder.stroke": "80 mm"})
    assert max(abs(shaft.right) for shaft in engine.shafts) == pytest.approx(0.16)


V_TWIN: Any = {
    "name": "twin",
    "speed": "6000 rpm",
    "cylinder": {"bore": "90 mm", "stroke": "80 mm", "rod_length": "140 mm"},
    "layout": {
        "type": "vee",
        "throws": [0],
        "bank_offset": "20 mm",
        "banks": [
            {"bearing": "45 deg", "cylinders": [1]},
            {"bearing": "-45 deg", "cylinders": [2]},
        ],
    },
}


def with_unbalance(value: Any, **cylinder: Any) -> Any:
    weight = [{"throw": 1, "unbalance": value}]
    own = {key: size for key, size in {**V_TWIN["cylinder"], **cylinder}.items() if size}
    layout = {**V_TWIN["layout"], "bank_offset": 0}
    return {**V_TWIN, "cylinder": own, "layout": layout, "crankshaft": [{"weight": weight}]}


@pytest.mark.parametrize(
    ("cylinder", "code", "relative", "absolute"),
    [
        ({}, "unit.bare-per-mass", "20 mm", "500 mm"),
        (
            {"reciprocating_mass": "500 g", "stroke": "", "bore": "", "rod_length": ""},
            "unit.bare-per-radius",
            "250 g",
            "500 g",
        ),
    ],
)
def test_a_bare_unbalance_beside_one_of_its_two_sizes_is_refused_with_both_readings(
    cylinder: Any, code: str, relative: str, absolute: str
) -> None:
    """Half of m r, r = 40 mm or m = 500 g, or half a metre times m, half a kilogram times r."""
    with pytest.raises(EngineFileError) as caught:
        engine_of(with_unbalance(0.5, **cylinder))
    [fault] = caught.value.faults
    assert fault.path == ("crankshaft", 0, "weight", 0, "unbalance")
    values = (fault.code, fault.values["relative"], fault.values["absolute"])
    assert values == (code, relative, absolute)
    engine = engine_of(with_unbalance(relative, **cylinder))
    # a 90 deg V twin has a primary vector of m r that turns with the crank: half of it is left
    force = total(balance(engine)).force
    assert abs(force.forward[force.orders.tolist().index(1.0)]) == pytest.approx(0.5, rel=1e-9)


def test_an_unbalance_over_an_unknown_mass_is_written_and_kept_when_the_mass_is_added() -> None:
    tree = with_unbalance("20 mm")
    engine = engine_of(tree)
    written = explicit(engine)
    assert written["shaft"][0]["weight"][0]["unbalance"] == "20 mm"
    assert engine_of(written).shafts[0].weights == engine.shafts[0].weights
    whole = engine_of(tree, changes={"cylinder.reciprocating_mass": "500 g"})
    assert whole.shafts[0].weights[0].unbalance == pytest.approx(0.5 * 0.04 / 2)


def test_an_inertia_over_an_unknown_mass_is_an_area() -> None:
    tree = {**V_TWIN, "firing_order": [1, 2], "drive": {"inertia": 2.0}}
    with pytest.raises(EngineFileError) as caught:
        engine_of(tree)
    [fault] = caught.value.faults
    assert (fault.code, fault.values["relative"]) == ("unit.bare-per-mass", "3200 mm^2")
    engine = engine_of({**tree, "drive": {"inertia": "3200 mm^2"}})
    assert engine.drive is not None
    assert engine.drive.inertia == pytest.approx(2.0 * 0.04**2)


@pytest.mark.parametrize("places", [["0.05 m", "-0.05 m"], ["50 mm", "-50 mm"]])
def test_bearings_of_a_v_twin_may_be_a_stroke_beyond_its_crankpin(places: list[Any]) -> None:
    mass = {**V_TWIN["cylinder"], "reciprocating_mass": "500 g"}
    tree = {**V_TWIN, "cylinder": mass, "crankshaft": [{"bearings": places}]}
    assert engine_of(tree).shafts[0].bearings == pytest.approx((0.05, -0.05))
    tree["crankshaft"] = [{"bearings": ["250 mm", "-250 mm"]}]
    with pytest.raises(EngineFileError) as caught:
        engine_of(tree)
    assert [fault.code for fault in caught.value.faults] == ["bearings.outside"] * 2


def test_bare_parts_beside_one_with_a_unit_are_named_and_no_sum_of_them() -> None:
    cylinder = {"stroke": "80 mm", "parts": {"piston": "400 g", "pin": 0.1, "big_end": 0.5}}
    tree: Any = {"name": "one", "cylinder": cylinder, "layout": {"type": "inline", "throws": [0]}}
    with pytest.raises(EngineFileError) as caught:
        engine_of(tree)
    faults = caught.value.faults
    assert [fault.path for fault in faults] == [
        ("cylinder", "parts", "pin"),
        ("cylinder", "parts", "big_end"),
    ]
    assert {fault.values["key"] for fault in faults} == {"cylinder.parts"}
