"""The tables [[mounts]] and [foundation], products of inertia, and every mistake in them."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.texts import SHORT, spoilt

import crankstar
from crankstar import mounts
from crankstar.files import EngineFileError, engine_of, toml, tree_of, tree_text
from crankstar.files.catalog import load
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.mass_doubts import body_doubts

BLOCK = {
    "mass": "138 kg",
    "up": "112 mm",
    "inertia_up": "9.6 kg*m^2",
    "inertia_right": "10.4 kg*m^2",
    "inertia_z": "4.1 kg*m^2",
}
RUBBER = ["200 N/mm", "80 N/mm", "80 N/mm"]


def mount(name: str, up: str = "0 mm", right: str = "0 mm", z: str = "0 mm", **more: Any) -> dict:
    """A mount at a place."""
    return {"name": name, "up": up, "right": right, "z": z, "stiffness": RUBBER, **more}


THREE = [
    mount("left", right="-300 mm", z="100 mm", bearing="45 deg"),
    mount("right", right="300 mm", z="100 mm", bearing="-45 deg", loss_factor=0.08),
    mount(
        "rear",
        z="-350 mm",
        stiffness="150 N/mm",
        damping="120 N*s/m",
        rubber=[{"frequency": "25 Hz", "factor": 1.2}, {"frequency": "100 Hz", "factor": 1.5}],
    ),
]
INERTIAS = ("inertia_up", "inertia_right", "inertia_z")
GROUND: dict[str, Any] = {
    "mass": "900 kg",
    "inertia_up": "80 kg*m^2",
    "inertia_right": "90 kg*m^2",
    "inertia_z": "60 kg*m^2",
    "mounts": [
        mount(f"{right} {z}", right=right, z=z, stiffness="5 kN/mm")
        for right in ("-0.5 m", "0.5 m")
        for z in ("-0.6 m", "0.6 m")
    ],
}


def mistakes(**tables: Any) -> list[tuple[str, str]]:
    """Where the faults of an engine with such tables are, and which."""
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(SHORT, **tables))
    return [(".".join(map(str, fault.path)), fault.code) for fault in refusal.value.faults]


def test_mounts_are_the_same_written_and_read_back() -> None:
    engine = engine_of(spoilt(SHORT, block=BLOCK, mounts=THREE, foundation=GROUND))
    again = engine_of(tree_of(toml(engine)))
    assert again.mounts == engine.mounts
    assert again.foundation == engine.foundation
    assert engine.mounts[0].along == (200e3, 80e3, 80e3)
    assert engine.mounts[0].assumed
    assert not engine.mounts[2].assumed


@pytest.mark.parametrize(
    ("tables", "found"),
    [
        ({"mounts": [mount("one")]}, [("mounts", "mounts.one")]),
        ({"mounts": [mount("one"), mount("two")]}, [("mounts", "mounts.one-place")]),
        (
            {"mounts": [mount(z, z=z, up="20 mm") for z in ("-200 mm", "0 mm", "200 mm")]},
            [("mounts", "mounts.free")],
        ),
        (
            {"mounts": [mount("a"), mount("a", stiffness=["1 N/mm", "1 N/mm"])]},
            [("mounts.1.name", "mounts.same-name"), ("mounts.1.stiffness", "mounts.length")],
        ),
        (
            {"mounts": [*THREE[:2], mount("rear", z="-1 m", stiffness="0 N/mm")]},
            [("mounts.2.stiffness", "mounts.no-stiffness")],
        ),
        (
            {
                "mounts": [
                    *THREE[:2],
                    mount("rear", z="-1 m", rubber=[{"frequency": "9 Hz", "factor": 1}] * 2),
                ]
            },
            [("mounts.2.rubber", "mounts.rubber-order")],
        ),
        ({"foundation": GROUND}, [("foundation", "foundation.alone")]),
        (
            {"mounts": THREE, "foundation": {**GROUND, "mounts": []}},
            [("foundation.mounts", "foundation.no-mounts")],
        ),
        (
            {"mounts": THREE, "foundation": {**GROUND, "inertia_z": "600 kg*m^2"}},
            [("foundation.inertia_z", "block.inertia-impossible")],
        ),
        (
            {"block": {"mass": "138 kg", "product_up_z": "1 kg*m^2"}},
            [("block.product_up_z", "block.products-alone")],
        ),
        (
            {"block": {**BLOCK, "product_up_z": "-8 kg*m^2"}},
            [("block.product_up_z", "block.products-impossible")],
        ),
        ({"block": {**BLOCK, "mass": "1.9 kg"}}, [("block.mass", "block.too-light")]),
        (
            {
                "mounts": THREE,
                "foundation": {**GROUND, "mounts": [*GROUND["mounts"], mount("left", z="9 mm")]},
            },
            [("foundation.mounts.4.name", "foundation.mounts-name")],
        ),
        (
            {
                "block": {**BLOCK, "points": [{"name": "rail"}]},
                "mounts": THREE,
                "foundation": {**GROUND, "points": [{"name": "foot"}, {"name": "rail"}]},
            },
            [("foundation.points.1.name", "foundation.points-name")],
        ),
    ],
)
def test_a_mistake_in_mounts_is_named_where_it_is(
    tables: dict[str, Any], found: list[tuple[str, str]]
) -> None:
    assert mistakes(**tables) == found


def test_mounts_on_a_line_name_the_freedom_that_is_left() -> None:
    line = [mount(z, z=z) for z in ("-200 mm", "0 mm", "200 mm")]
    with pytest.raises(EngineFileError, match=r"free to move in: roll; add a mount"):
        engine_of(spoilt(SHORT, mounts=line))


def test_negative_damping_and_unknown_units_are_told_at_once() -> None:
    wrong = [
        *THREE[:1],
        {**THREE[1], "loss_factor": -0.1, "damping": "-5 N*s/m", "stiffness": "3 furlong"},
        {**THREE[2], "damping": "3 N/mm"},
    ]
    where = [place for place, _ in mistakes(mounts=wrong)]
    assert sorted(where) == [
        "mounts.1.damping",
        "mounts.1.loss_factor",
        "mounts.1.stiffness",
        "mounts.2.damping",
    ]


def test_an_engine_without_masses_has_no_mounts() -> None:
    tree = spoilt(SHORT, mounts=THREE)
    del tree["cylinder"]["reciprocating_mass"], tree["cylinder"]["rotating_mass"]
    with pytest.raises(EngineFileError, match=r"give cylinder\.reciprocating_mass"):
        engine_of(tree)


ONE: dict[str, Any] = {
    "name": "a single",
    "cycle": "four-stroke",
    "firing_order": [1],
    "cylinder": {
        "stroke": "80 mm",
        "rod_length": "140 mm",
        "reciprocating_mass": "400 g",
        "rotating_mass": "300 g",
    },
    "layout": {"type": "inline", "throws": ["0 deg"]},
    "mounts": THREE,
}
STAR = {"type": "radial", "rows": [{"throw": "0 deg", "cylinders": [1, 2, 3]}]}


@pytest.mark.parametrize("layout", [ONE["layout"], STAR, {"type": "inline"}])
def test_cylinders_at_one_place_need_no_bore_pitch(layout: dict[str, Any]) -> None:
    tree = {**ONE, "layout": layout, "block": {**BLOCK, "z": "-40 mm"}}
    if layout == STAR:
        tree["firing_order"] = [1, 3, 2]
    engine = engine_of(tree)
    assert engine.relative == ()
    assert [each.z for each in engine.mounts] == pytest.approx([0.1, 0.1, -0.35])
    pitched = engine_of({**tree, "layout": {**layout, PITCHES[str(layout["type"])]: "90 mm"}})
    assert [each.z for each in pitched.mounts] == [each.z for each in engine.mounts]
    assert engine_of(tree_of(toml(engine))).mounts == engine.mounts


PITCHES = {"inline": "bore_pitch", "radial": "row_pitch"}


def test_cylinders_at_several_places_still_need_a_bore_pitch() -> None:
    tree = {**ONE, "firing_order": [1, 2], "layout": {"type": "inline", "throws": ["0 deg"] * 2}}
    with pytest.raises(EngineFileError, match="bore_pitch"):
        engine_of(tree)


def test_a_block_is_heavier_than_its_pistons_and_rods() -> None:
    """By the parts themselves, of rigid rods too; without masses nothing is said of it."""
    rods = {"cylinder.rod": {"mass": "550 g", "centre": "40 mm"}}
    five = load("audi-25-tfsi", changes=rods)
    least = sum(each.reciprocating_mass + 0.55 for each in five.cylinders)
    load("audi-25-tfsi", changes={**rods, "block": {"mass": f"{least * 1.001} kg"}})
    with pytest.raises(EngineFileError, match="no more than the pistons and rods"):
        load("audi-25-tfsi", changes={**rods, "block": {"mass": f"{least * 0.999} kg"}})
    load("i4", changes={"block": {"mass": 1.0}})


@pytest.mark.parametrize(
    ("tables", "found"),
    [
        ({}, []),
        ({"foundation": {**GROUND, "mass": "1 g"}}, ["doubt.foundation-mass"]),
        (
            {
                "foundation": {
                    **GROUND,
                    "inertia_up": "0.1 kg*m^2",
                    "inertia_right": "0.1 kg*m^2",
                    "inertia_z": "0.1 kg*m^2",
                }
            },
            ["doubt.slender"],
        ),
        ({"block": BLOCK | dict.fromkeys(INERTIAS, "1e-3 kg*m^2")}, ["doubt.slender"]),
        ({"block": BLOCK | {"mass": "38 kg"}}, ["doubt.block-mass"]),
        ({"block": BLOCK | {"mass": "138 t"}}, ["doubt.block-mass", "doubt.slender"]),
    ],
)
def test_a_body_that_hardly_can_be_is_a_doubt(tables: dict[str, Any], found: list[str]) -> None:
    own = {"block": BLOCK, "mounts": THREE, "foundation": GROUND, **tables}
    engine = engine_of(spoilt(SHORT, **own))
    assert [fault.code for fault in body_doubts(engine)] == found
    assert [each for each in doubts(engine) if each.code.startswith("doubt.piston")] == []


def test_a_doubtful_mass_of_the_block_is_tried_at_that_of_cars() -> None:
    """40 to 130 kg per litre, by hand from bore and stroke."""
    own = engine_of(spoilt(SHORT, block=BLOCK | {"mass": "38 kg"}, mounts=THREE))
    [doubt] = [each for each in mounts(own).to_dict()["rests_on"] if each["path"] == "block.mass"]
    volume = sum(
        pi / 4 * (each.bore or 0.0) ** 2 * 2 * own.throw(each).radius for each in own.cylinders
    )
    assert (doubt["low"], doubt["high"]) == pytest.approx((40e3 * volume, 130e3 * volume), rel=5e-3)
    assert doubt["moves"]["low"] < doubt["moves"]["high"]


@pytest.mark.release
@pytest.mark.parametrize(("mass", "doubted"), [(185, True), (120, False), (800, True)])
def test_the_mass_of_a_motorcycle_is_no_mass_of_its_engine(
    run: Run, tmp_path: Path, mass: int, *, doubted: bool
) -> None:
    """185 kg on 0.496 l are 373 kg per litre; the weight is tried at 20 to 65 kg."""
    block = {**BLOCK, "mass": f"{mass} kg"}
    for key in INERTIAS:
        block.pop(key, None)
    tree: dict[str, Any] = {
        "name": "single",
        "firing_order": [1],
        "speed": "4500 rpm",
        "cylinder": {
            "bore": "90 mm", "stroke": "78 mm", "rod_length": "140 mm",
            "reciprocating_mass": "520 g", "rotating_mass": "600 g",
        },
        "layout": {"type": "inline", "throws": [0]},
        "block": block,
        "mounts": THREE,
    }  # fmt: skip
    own = engine_of(tree)
    assert ["doubt.block-mass"] * doubted == [fault.code for fault in body_doubts(own)]
    path = tmp_path / "single.json"
    path.write_text(json.dumps(tree))
    litres = pi / 4 * 0.9**2 * 0.78
    assert ("kg per litre" in run("check", str(path)).out) == doubted
    rows = json.loads(run("analyze", str(path), "--json").out)["rests_on"]
    found = [each for each in rows if each["path"] == "block.mass"]
    assert len(found) == doubted
    on_mounts = [each for each in mounts(own).to_dict()["rests_on"] if each["path"] == "block.mass"]
    assert len(on_mounts) == doubted
    if doubted:
        moves = found[0]["moves"]
        force = crankstar.spectra.peak(
            crankstar.total(crankstar.balance(own, speed=own.speed)).force
        ).value
        weights = [9.80665 * each for each in (mass, 130 * litres, 40 * litres)]
        assert [moves["now"], moves["low"], moves["high"]] == pytest.approx(
            [force / weight for weight in weights], rel=5e-3
        )
        assert on_mounts[0]["moves"]["effect"] > 0.01


@pytest.mark.release
def test_a_slip_of_unit_in_masses_is_told(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "own.toml"
    own = {"block": BLOCK, "mounts": THREE, "foundation": {**GROUND, "mass": "0.9 kg"}}
    heavy = spoilt(SHORT, **own)
    heavy["block"] = {**BLOCK, "mass": "900 t"}
    heavy["cylinder"] = {**heavy["cylinder"], "reciprocating_mass": "100 t"}
    place.write_text(tree_text(heavy))
    ran = run("check", str(place))
    told = " ".join((ran.out + ran.err).split())
    assert "cylinder.reciprocating_mass: 100000 kg go up and down, more than a solid bar" in told
    assert "foundation.mass is 0.9 kg, less than the pistons and rods" in told
    shown = " ".join(run("mounts", str(place), "--speed", "900 rpm").out.split())
    assert "foundation.mass is 0.9 kg, less than the pistons and rods" in shown
