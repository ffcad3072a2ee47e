"""Drawn parts stand where the parts are, without overlap, for every engine of the catalog."""

from __future__ import annotations

import json
from collections.abc import Iterator
from itertools import combinations, pairwise
from math import isfinite, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.catalog import EVERY_ENGINE
from tests.newton import placed
from tests.strategies import OF_ANY_KIND

from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.page.proportions import proportions
from crankstar.page.records import CylinderShown, Scene, ShaftShown, Web
from crankstar.page.scene import STEEL, scene
from crankstar.remedy import fitting
from crankstar.remedy.fitting import ShaftPlaces

ROUNDING = 1e-9
STEPS = 97
"""Crank angles at which parts are looked for: a prime, so that no symmetry hides one."""


def drawn(name: str) -> tuple[Engine, Scene]:
    engine = load(name)
    return engine, scene(engine)


def turning(engine: Engine) -> np.ndarray:
    turns = max(shaft.speed_ratio.denominator for shaft in engine.shafts)
    return np.arange(STEPS * turns) * (2 * np.pi / STEPS)


def numbers(value: Any) -> Iterator[float]:
    if isinstance(value, dict):
        for item in value.values():
            yield from numbers(item)
    elif isinstance(value, list | tuple):
        for item in value:
            yield from numbers(item)
    elif isinstance(value, float):
        yield value


def where(engine: Engine, number: int) -> tuple[np.ndarray, np.ndarray]:
    """Big-end pin and piston pin of a cylinder, (x, y) over the crank angle, by plane geometry."""
    cylinder = next(c for c in engine.cylinders if c.number == number)
    shaft = engine.shaft(cylinder.shaft)
    pin, piston, _ = placed(engine, cylinder, turning(engine))
    return pin + np.array([shaft.right, shaft.up]), piston + np.array([shaft.right, shaft.up])


@EVERY_ENGINE
def test_all_parts_stay_in_the_box_and_no_number_is_missing(name: str) -> None:
    engine, found = drawn(name)
    assert all(isfinite(number) for number in numbers(found.model_dump()))
    assert len(found.model_dump_json()) < 60_000
    low, high = np.array(found.low), np.array(found.high)
    slack = ROUNDING * np.abs(high - low).max()
    assert np.all(low < high)
    for cylinder in found.cylinders:
        radius = found.shafts[cylinder.shaft].throws[cylinder.throw].pin_radius
        pin, piston = where(engine, cylinder.number)
        axis = np.array([np.sin(cylinder.bearing), np.cos(cylinder.bearing)])
        for points, margin in (
            (pin, radius),
            (piston, 0.0),
            (piston + cylinder.pin_height * axis, 0.0),
        ):
            for column, place in ((0, 1), (1, 0)):
                assert points[:, column].min() - margin >= low[place] - slack
                assert points[:, column].max() + margin <= high[place] + slack
        assert low[2] - slack <= cylinder.z - cylinder.bore / 2
        assert cylinder.z + cylinder.bore / 2 <= high[2] + slack
    for shaft in found.shafts:
        reach = max([shaft.journal_radius, *(weight.outer_radius for weight in shaft.weights)])
        assert low[0] - slack <= shaft.up - reach
        assert shaft.up + reach <= high[0] + slack
        assert low[1] - slack <= shaft.right - reach
        assert shaft.right + reach <= high[1] + slack
        assert low[2] - slack <= shaft.z_from < shaft.z_to <= high[2] + slack


@EVERY_ENGINE
def test_pistons_stay_in_their_bores(name: str) -> None:
    engine, found = drawn(name)
    for cylinder in found.cylinders:
        shaft = found.shafts[cylinder.shaft]
        _, piston = where(engine, cylinder.number)
        axis = np.array([np.sin(cylinder.bearing), np.cos(cylinder.bearing)])
        along = (piston - np.array([shaft.right, shaft.up])) @ axis
        slack = 1e-4 * cylinder.crank_radius  # the scene follows them in 360 steps
        assert cylinder.skirt > 0
        assert cylinder.pin_height > 0
        assert along.min() - cylinder.skirt >= cylinder.bore_from - slack
        assert along.max() + cylinder.pin_height < cylinder.bore_to


@EVERY_ENGINE
def test_rods_webs_and_pins_keep_out_of_each_others_way(name: str) -> None:
    _, found = drawn(name)
    for index, shaft in enumerate(found.shafts):
        rods = [c for c in found.cylinders if c.shaft == index]
        assert_webs_are_clear(shaft, rods)
        for one, other in combinations([c for c in rods if c.rod != "slave"], 2):
            if {one.rod, other.rod} == {"fork", "blade"} and one.throw == other.throw:
                continue
            assert (
                abs(one.rod_z - other.rod_z)
                >= (one.rod_width + other.rod_width) / 2 - ROUNDING * one.bore
            )
        for throw in shaft.throws:
            assert throw.pin_from < throw.z < throw.pin_to
            assert throw.pin_radius < throw.radius
        for rod in rods:
            throw = shaft.throws[rod.throw]
            assert throw.pin_from <= rod.rod_z - rod.rod_width / 2
            assert rod.rod_z + rod.rod_width / 2 <= throw.pin_to


def assert_webs_are_clear(shaft: ShaftShown, rods: list[CylinderShown]) -> None:
    slack = 1e-9 * (shaft.z_to - shaft.z_from)
    for web in shaft.webs:
        assert web.z_from < web.z_to
        for rod in rods:
            apart = max(
                web.z_from - (rod.rod_z + rod.rod_width / 2),
                rod.rod_z - rod.rod_width / 2 - web.z_to,
            )
            assert apart >= -slack
    ordered: list[Web] = sorted(shaft.webs, key=lambda web: web.z_from)
    assert all(one.z_to <= other.z_from + slack for one, other in pairwise(ordered))
    assert {web.throw for web in shaft.webs} == set(range(len(shaft.throws)))


@EVERY_ENGINE
def test_cylinders_of_a_bank_stand_beside_each_other(name: str) -> None:
    _, found = drawn(name)
    for one, other in combinations(found.cylinders, 2):
        if (
            one.shaft == other.shaft
            and abs(one.bearing - other.bearing) < 1e-9
            and abs(one.offset - other.offset) < 1e-9
        ):
            assert abs(one.z - other.z) > (one.bore + other.bore) / 2


def with_everything(name: str) -> Engine:
    """An engine with counterweights on its webs and all balance shafts of orders 1 and 2."""
    engine = fitting.by_factor(load(name), factor=0.7, weights="webs")
    try:
        return fitting.with_shafts(engine, ratios="all", places=ShaftPlaces())
    except fitting.RemedyError:
        return engine


@EVERY_ENGINE
def test_counterweights_hit_neither_pistons_nor_other_shafts(name: str) -> None:
    found = scene(with_everything(name))
    for index, shaft in enumerate(found.shafts):
        own = [c.bore_from for c in found.cylinders if c.shaft == index]
        for weight in shaft.weights:
            assert weight.inner_radius < weight.outer_radius
            assert 0 < weight.half_angle <= np.pi / 2
            assert all(weight.outer_radius < end for end in own)
            for place, other in enumerate(found.shafts):
                distance = abs(complex(shaft.up - other.up, shaft.right - other.right))
                reach = max([other.journal_radius, *(w.outer_radius for w in other.weights)])
                assert place == index or weight.outer_radius + reach < distance


def test_a_counterweight_is_as_large_as_steel_makes_it() -> None:
    """U = integral of r cos(phi) over the sector, times density and thickness, on a fine grid."""
    engine = fitting.by_factor(load("subaru-ej25"), factor=0.5, weights="webs")
    shaft = scene(engine).shafts[0]
    assert {"mass", "radius"}.isdisjoint(engine.relative)
    for weight in shaft.weights:
        radii = np.linspace(weight.inner_radius, weight.outer_radius, 2001)
        turns = np.linspace(-weight.half_angle, weight.half_angle, 2001)
        made = (
            np.trapezoid(radii**2, radii)
            * np.trapezoid(np.cos(turns), turns)
            * STEEL
            * weight.thickness
        )
        assert made == pytest.approx(weight.unbalance, rel=1e-5)
    vectors = [weight.unbalance * np.exp(1j * weight.angle) for weight in shaft.weights]
    arms = [weight.z for weight in shaft.weights]
    meant = [weight.unbalance * np.exp(1j * weight.angle) for weight in engine.shafts[0].weights]
    assert sum(vectors) == pytest.approx(sum(meant), abs=1e-12)
    assert len(arms) <= len(shaft.webs)


@EVERY_ENGINE
def test_weights_that_are_drawn_pull_as_those_of_the_shafts_do(name: str) -> None:
    engine = with_everything(name)
    for shown, shaft in zip(scene(engine).shafts, engine.shafts, strict=True):
        drawn_ = sum(weight.unbalance * np.exp(1j * weight.angle) for weight in shown.weights)
        meant = sum(weight.unbalance * np.exp(1j * weight.angle) for weight in shaft.weights)
        assert abs(drawn_ - meant) <= 1e-12 * sum(weight.unbalance for weight in shaft.weights)


@EVERY_ENGINE
def test_gears_mesh_and_turn_as_their_shafts_do(name: str) -> None:
    found = scene(with_everything(name))
    for first, second in zip(found.gears[::2], found.gears[1::2], strict=True):
        one, other = found.shafts[first.shaft], found.shafts[second.shaft]
        distance = abs(complex(one.up - other.up, one.right - other.right))
        assert first.radius + second.radius == pytest.approx(distance)
        assert first.radius * one.speed_ratio == pytest.approx(-second.radius * other.speed_ratio)
        assert first.teeth * second.radius == pytest.approx(second.teeth * first.radius)
        assert min(first.teeth, second.teeth) >= 8
        assert first.z == second.z
        for shaft, gear in ((one, first), (other, second)):
            assert shaft.z_from <= gear.z <= shaft.z_to
        assert all(
            abs(first.z - other.z) >= first.thickness
            for other in found.gears
            if other not in (first, second)
        )
        behind = [c.rod_z - c.rod_width / 2 for c in found.cylinders]
        behind += [w.z - w.thickness / 2 for shaft in found.shafts for w in shaft.weights]
        assert first.z + first.thickness / 2 < min(behind)


def test_two_pistons_in_one_cylinder_do_not_meet() -> None:
    close = load("jumo-205")
    reach = close.first.rod_length + close.throw(close.first).radius
    nearer = close.shafts[1].model_copy(update={"up": -2 * reach - 0.01})
    for engine in (
        load("napier-deltic"),
        close,
        close.model_copy(update={"shafts": (close.shafts[0], nearer)}),
    ):
        found = scene(engine)
        shown = {c.number: c for c in found.cylinders}
        for one, other in engine.chambers.values():
            (_, a), (_, b) = where(engine, one.number), where(engine, other.number)
            crowns = shown[one.number].pin_height + shown[other.number].pin_height
            assert np.hypot(*(a - b).T).min() > crowns


def test_places_along_the_shaft_are_those_of_the_file_where_it_gives_them() -> None:
    engine, found = drawn("audi-25-tfsi")
    assert found.length_unit == "m"
    assert [c.z for c in found.cylinders] == [c.z for c in engine.cylinders]
    assert found.assumed == ()
    assert proportions(load("i4")).along == pytest.approx(
        1.18 * 2
    )  # a bore of two crank radii, and room between


def test_what_the_file_does_not_say_is_told() -> None:
    _, found = drawn("v8-cross-plane")
    assert any("gives no bore;" in sentence for sentence in found.assumed)
    assert any("gives no bore pitch;" in sentence for sentence in found.assumed)
    loose = scene(with_everything("i4"))
    assert any("no place for the balance shafts balancer" in sentence for sentence in loose.assumed)
    assert all(
        sentence[0].isupper() and sentence.endswith(".")
        for sentence in (*found.assumed, *loose.assumed)
    )


def test_forks_and_blades_slaves_and_masters_are_told_apart() -> None:
    kinds = {
        name: {c.number: c.rod for c in drawn(name)[1].cylinders}
        for name in ("merlin", "pratt-whitney-wasp", "i4", "napier-lion")
    }
    assert sorted(kinds["merlin"].values()) == ["blade"] * 6 + ["fork"] * 6
    assert sorted(kinds["pratt-whitney-wasp"].values()) == ["master"] + ["slave"] * 8
    assert set(kinds["i4"].values()) == {"plain"}
    assert set(kinds["napier-lion"].values()) == {"plain"}


@pytest.mark.release
@settings(max_examples=150)
@given(st.one_of(*OF_ANY_KIND.values()))
def test_any_engine_at_all_can_be_drawn(engine: Engine) -> None:
    found = scene(engine)
    assert all(isfinite(number) for number in numbers(found.model_dump()))
    json.loads(found.model_dump_json())
    assert all(one < other for one, other in zip(found.low, found.high, strict=True))
    for shaft in found.shafts:
        assert all(web.z_from < web.z_to for web in shaft.webs)
        assert all(
            0 <= w.inner_radius < w.outer_radius and sin(w.half_angle) > 0 and w.thickness > 0
            for w in shaft.weights
        )
    for cylinder in found.cylinders:
        assert cylinder.rod_width > 0
        assert cylinder.bore > 0
        assert cylinder.skirt > 0
        assert cylinder.bore_from < cylinder.bore_to


def test_weights_that_are_drawn_beside_their_places_are_told() -> None:
    """The webs of a boxer of two are nearer than a bearing between its pins would allow."""
    note = "Counterweights are drawn on the nearest webs; the numbers use their true places."
    for name, expected in {"boxer-2": True, "v8-cross-plane": False, "triple-120": False}.items():
        found = fitting.recommended(load(name))
        assert found is not None
        shown = scene(found.after)
        couple = sum(w.unbalance * np.exp(1j * w.angle) * w.z for w in shown.shafts[0].weights)
        meant = (
            sum(w.unbalance * np.exp(1j * w.angle) * w.z for w in found.after.shafts[0].weights)
            * proportions(found.after).along
        )
        assert bool(abs(couple - meant) > 0.03 * abs(meant)) is expected
        assert (note in shown.assumed) is expected
