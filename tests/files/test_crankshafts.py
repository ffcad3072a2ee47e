"""Main bearings, webs, weights and balance shafts in engine files, and files written back."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.catalog import EVERY_ENGINE
from tests.commands import Run
from tests.texts import EXPLICIT

import crankstar
from crankstar.engine.copies import with_shaft, with_throws_turned, with_values
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings, pin_groups, webs
from crankstar.engine.records import Shaft, Weight
from crankstar.files import EngineFileError, engine_of, rewritten, toml, tree_of
from crankstar.files.catalog import tree_of as catalog_tree
from crankstar.language.faults import where
from crankstar.remedy import with_counterweights, with_web_weights, without_counterweights
from crankstar.server import tasks

FOUR = """
name = "four"
firing_order = [1, 3, 4, 2]
[cylinder]
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "480 g"
rotating_mass = "500 g"
[layout]
type = "inline"
bore_pitch = "100 mm"
"""


def four(crankshaft: str, more: str = "") -> Engine:
    return engine_of(tree_of(f"{FOUR}[[crankshaft]]\n{crankshaft}\n{more}"))


def faults(crankshaft: str, more: str = "") -> dict[str, str]:
    with pytest.raises(EngineFileError) as refused:
        four(crankshaft, more)
    return {where(fault.path): fault.code for fault in refused.value.faults}


@pytest.mark.parametrize(
    ("crankshaft", "path", "code"),
    [
        ('bearings = ["10 mm"]', "crankshaft[1].bearings", "bearings.too-few"),
        ("bearing_count = 1", "crankshaft[1].bearing_count", "at-least"),
        ("bearing_count = 6", "crankshaft[1].bearing_count", "bearings.too-many"),
        (
            'bearings = ["0.2 m", "-0.2 m", "0 m"]',
            "crankshaft[1].bearings[3]",
            "bearings.out-of-order",
        ),
        ('bearings = ["0.2 m", "0.199 m"]', "crankshaft[1].bearings[2]", "bearings.overlap"),
        ('bearings = ["0.2 m", "0.2 m"]', "crankshaft[1].bearings[2]", "bearings.overlap"),
        ('bearings = ["0.2 m", "-3.6 m"]', "crankshaft[1].bearings[2]", "bearings.outside"),
        ('bearings = ["0.2 m", "0.05 m"]', "crankshaft[1].bearings[2]", "bearings.on-a-pin"),
        (
            'bearings = ["0.2 m", "-0.2 m"]\nbearing_count = 2',
            "crankshaft[1].bearing_count",
            "bearings.counted-twice",
        ),
        (
            'bearings = ["0.2 m", "-0.2 m"]\nwebs = ["0.2 m", "0.1 m", "0 m", "-0.1 m", "-0.18 m"]',
            "crankshaft[1].webs[1]",
            "webs.on-a-bearing",
        ),
        (
            'webs = ["0.18 m", "0.15 m", "0.1 m", "0 m", "-0.1 m", "-0.18 m"]',
            "crankshaft[1].webs[2]",
            "webs.on-a-pin",
        ),
        ('webs = ["0.1 m", "0.18 m"]', "crankshaft[1].webs[2]", "webs.out-of-order"),
        ('webs = ["0.18 m", "0.1 m"]', "crankshaft[1].webs", "webs.missing"),
        ('webs = ["0.6 m", "0.1 m"]', "crankshaft[1].webs[1]", "webs.outside"),
        (
            'bending_stiffness = "400 kN*m^2"',
            "crankshaft[1].bending_stiffness",
            "bearings.one-stiffness",
        ),
        ('bearing_stiffness = "3 mm"', "crankshaft[1].bearing_stiffness", "unit.other-dimension"),
        (
            'weight = [{ unbalance = "1 g*m", throw = 5 }]',
            "crankshaft[1].weight[1].throw",
            "weight.no-such-throw",
        ),
        ('weight = [{ unbalance = "1 g*m" }]', "crankshaft[1].weight[1]", "weight.no-place"),
        ("[[crankshaft]]", "crankshaft", "crankshaft.too-many"),
    ],
)
def test_bearings_and_weights_that_cannot_be_are_refused(
    crankshaft: str, path: str, code: str
) -> None:
    assert {key: value.split(".example")[0] for key, value in faults(crankshaft).items()} == {
        path: code
    }


def test_mistakes_of_all_shafts_are_reported_at_once() -> None:
    told = faults(
        'bearings = ["0.2 m", "-3.6 m"]\nweight = [{ unbalance = "1 g*m" }]',
        '[[balance_shaft]]\nbearings = ["1 mm"]',
    )
    assert told == {
        "crankshaft[1].weight[1]": "weight.no-place",
        "crankshaft[1].bearings[2]": "bearings.outside",
        "balance_shaft[1].bearings": "bearings.too-few",
    }


def test_the_explicit_form_names_the_shaft_of_a_bearing() -> None:
    tree = tree_of(EXPLICIT)
    tree["shaft"][0]["bearings"] = ["0.2 m", "0.3 m"]
    with pytest.raises(EngineFileError) as refused:
        engine_of(tree)
    assert "shaft[1].bearings[2]" in str(refused.value)


@pytest.mark.parametrize(
    ("count", "places"),
    [
        (2, [0.2, -0.2]),
        (3, [0.2, 0.0, -0.2]),
        (4, [0.2, 0.1, -0.1, -0.2]),
        (5, [0.2, 0.1, 0.0, -0.1, -0.2]),
    ],
)
def test_a_number_of_bearings_is_spread_over_the_throws(count: int, places: list[float]) -> None:
    engine = four(f"bearing_count = {count}")
    assert main_bearings(engine, engine.shafts[0]) == pytest.approx(places)
    between = webs(engine, engine.shafts[0])
    beside = {round(float(z), 9) for z in np.arange(-0.175, 0.2, 0.05)}
    shared = {0.1, 0.0, -0.1} - {round(z, 9) for z in places}
    lost = {round(z + side, 9) for z in shared for side in (-0.025, 0.025)}
    assert {round(z, 9) + 0.0 for z in between} == (beside - lost) | shared


def test_more_bearings_than_throws_stand_between_split_pins() -> None:
    bank = {"name": "a", "bearing": "30 deg", "cylinders": [1, 3, 5]}
    banks = [bank, {"name": "b", "bearing": "-30 deg", "cylinders": [2, 4, 6]}]
    layout = {"type": "vee", "banks": banks, "throws": ["0 deg", "120 deg", "240 deg"]}
    layout |= {"pin_split": "60 deg", "bank_offset": 0.2}
    engine = engine_of({"name": "split pins", "layout": layout})
    shaft = engine.shafts[0]
    assert len(main_bearings(engine, shaft)) == 4
    more = with_values(shaft, bearing_count=7)
    engine = with_values(engine, shafts=(more,))
    places = main_bearings(engine, more)
    assert len(places) == 7
    assert list(places) == sorted(places, reverse=True)
    assert [len(group.throws) for group in pin_groups(engine, more)] == [1] * 6


def test_an_overhung_throw_has_one_web_and_one_counterweight() -> None:
    text = '[[crankshaft]]\nbearings = ["-30 mm", "-90 mm"]\nwebs = ["-14 mm"]\n'
    engine = engine_of(
        tree_of(
            'name = "single"\nfiring_order = [1]\n[cylinder]\nstroke = "60 mm"\n'
            'rotating_mass = "100 g"\nreciprocating_mass = "200 g"\n[layout]\ntype = "inline"\n'
            + text
        )
    )
    assert [group.webs for group in pin_groups(engine, engine.shafts[0])] == [(-0.014, -0.014)]
    (weight,) = with_web_weights(engine, factor=0.5).shafts[0].weights
    assert weight.z == -0.014
    assert weight.unbalance == pytest.approx(0.2 * 0.03)


def test_a_short_weight_is_placed_from_its_pin_and_turns_with_it() -> None:
    tree = tree_of(
        FOUR
        + '[[crankshaft]]\nweight = [{ throw = 2, unbalance = "1 g*m" }, '
        + '{ z = "-60 mm", unbalance = "1 g*m", angle = "90 deg" }]'
    )
    first, second = engine_of(tree).shafts[0].weights
    assert (first.z, second.z) == pytest.approx((0.05, -0.06))
    assert np.degrees([first.angle, second.angle]) % 360 == pytest.approx([0, 270], abs=1e-9)
    tree["firing_order"] = []
    tree["layout"]["throws"] = ["0 deg", "100 deg", "180 deg", "0 deg"]
    first, second = engine_of(tree).shafts[0].weights
    assert np.degrees([first.angle, second.angle]) % 360 == pytest.approx([280, 270], abs=1e-9)


def test_a_balance_shaft_of_a_short_file_is_a_shaft_like_any_other() -> None:
    engine = four(
        "",
        '[[balance_shaft]]\nspeed_ratio = 2\nup = "50 mm"\nbearings = ["0.1 m", "-0.1 m"]\n'
        'weight = [{ angle = "180 deg", unbalance = "2 g*m", z = "10 mm" }]',
    )
    shaft = engine.shafts[1]
    assert (shaft.name, float(shaft.speed_ratio), shaft.up) == ("balance shaft", 2.0, 0.05)
    assert main_bearings(engine, shaft) == (0.1, -0.1)
    assert (shaft.weights[0].unbalance, shaft.weights[0].z) == pytest.approx((0.002, 0.01))


def assert_same(engine: Engine, other: Engine) -> None:
    one, two = (crankstar.balance(e, reference=crankstar.Reference(0.1)) for e in (engine, other))
    for name in ("force", "couple", "axis_moment", "torque"):
        a, b = getattr(crankstar.total(one), name), getattr(crankstar.total(two), name)
        size = max(1.0, np.abs(a.forward).max(initial=0), np.abs(a.backward).max(initial=0))
        assert np.abs(a.forward - b.forward).max(initial=0) < 1e-9 * size
        assert np.abs(a.backward - b.backward).max(initial=0) < 1e-9 * size


@pytest.mark.many(first=7)
@EVERY_ENGINE
def test_a_balanced_engine_is_written_in_the_form_of_its_file(name: str) -> None:
    _, tree = catalog_tree(name)
    before = engine_of(tree)
    changed: list[Engine] = [
        without_counterweights(before),
        with_web_weights(before, factor=0.4),
        with_counterweights(before, factor=0.5),
    ]
    weight = Weight(unbalance=0.3, angle=0.7, z=0.1)
    shaft = Shaft(name="balancer", speed_ratio=Fraction(-1, 2), right=0.1, weights=(weight,))
    changed.append(with_shaft(changed[-1], shaft))
    for engine in changed:
        back = rewritten(tree, engine)
        assert ("layout" in back) == ("layout" in tree)
        assert_same(engine_of(back), engine)
        assert back.get("layout") == tree.get("layout")


@pytest.mark.release
@settings(max_examples=20, deadline=None)
@given(angles=st.lists(st.integers(-180, 180), min_size=3, max_size=3))
def test_turned_throws_are_written_into_the_layout(angles: list[int]) -> None:
    _, tree = catalog_tree("triple-120")
    before = engine_of(tree)
    turns = {("crank", number): np.radians(angle) for number, angle in enumerate(angles, 1)}
    engine = with_throws_turned(with_counterweights(before, factor=0.5), turns, firing_order=())
    back = rewritten(tree, engine)
    assert_same(engine_of(back), engine)


def test_what_a_short_file_cannot_say_is_written_in_the_explicit_form() -> None:
    _, tree = catalog_tree("i4")
    engine = engine_of(tree)
    first = with_values(engine.cylinders[0], offset=0.1)
    longer = with_values(engine, cylinders=(first, *engine.cylinders[1:]))
    back = rewritten(tree, longer)
    assert "layout" not in back
    assert engine_of(back) == longer


def test_bearings_survive_the_explicit_form() -> None:
    engine = four(
        'bearings = ["0.2 m", "0 m", "-0.2 m"]\nbending_stiffness = "400 kN*m^2"\n'
        'bearing_stiffness = "500 kN/mm"'
    )
    again = engine_of(tree_of(toml(engine))).shafts[0]
    assert again.bearings == (0.2, 0.0, -0.2)
    assert again.bending_stiffness == pytest.approx(4e5)
    assert again.bearing_stiffness == pytest.approx(5e8)


@pytest.mark.release
def test_balance_writes_a_short_file_that_analyze_reads(run: Run) -> None:
    run("balance", "v8-cross-plane", "--recommended", "-o", "balanced.toml")
    text = run("show", "balanced.toml").out
    assert "weight 8" in text
    from pathlib import Path

    written: dict[str, Any] = tree_of(Path("balanced.toml").read_text(encoding="utf-8"))
    assert written["layout"] == catalog_tree("v8-cross-plane")[1]["layout"]
    assert len(written["crankshaft"][0]["weight"]) == 8


def test_show_marks_assumed_bearings(run: Run) -> None:
    lines = [line.split() for line in run("show", "i4").out.splitlines() if "main bearings" in line]
    assert lines == [["crank", "main", "bearings", "5", "2,", "1,", "0,", "-1,", "-2", "assumed"]]
    given = run("show", "i4", "--set", "crankshaft=[{bearings=[2, 0, -2]}]").out
    assert any(line.split()[-3:] == ["from", "the", "file"] for line in given.splitlines())


def test_the_page_fits_an_engine_and_keeps_banks_and_throws() -> None:
    import json

    _, tree = catalog_tree("v8-cross-plane")
    answer = json.loads(tasks.fitted(tree, {"factor": 0.5, "weights": "webs"}))
    file = answer["exhibit"]["file"]
    assert file["layout"] == tree["layout"]
    assert len(file["crankshaft"][0]["weight"]) == 8
    assert "shaft" not in file
