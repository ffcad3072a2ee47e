"""The workshop of the page: controls set what they say, curves are those of `crankstar sweep`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE

import crankstar
from crankstar.files import catalog, changed, engine_of
from crankstar.mechanics.balance import balance
from crankstar.page.controls import controls
from crankstar.page.sliders import sliders
from crankstar.page.workshop import USUAL, presets, workshop
from crankstar.page.workshop_records import Control
from crankstar.studies.variants import SweepError


def tree_of(name: str) -> dict[str, Any]:
    return catalog.tree_of(name)[1]


def set_to(tree: dict[str, Any], control: Control, value: float) -> dict[str, Any]:
    """The file after a control was moved, as the page does it."""
    changes: dict[str, Any] = {}
    for setting in control.sets:
        number = setting.factor * value + setting.added
        changes[setting.path] = f"{number!r} {control.unit}" if control.unit else number
    if "throws" in tree.get("layout", {}):
        tree = {key: given for key, given in tree.items() if not key.startswith("firing_")}
    return changed(tree, changes)


@pytest.mark.release
@pytest.mark.parametrize("name", ["v2-90", "i2-270", "subaru-ej25", "gm-3800", "square-four"])
def test_a_curve_is_what_the_command_line_sweeps(name: str) -> None:
    listed = sliders(tree_of(name))
    assert listed
    for slider in listed:
        try:
            swept = crankstar.sweep(name, slider.range)
        except SweepError:  # the file does not give the number, which the page writes into it
            assert slider.key in ("layout.pin_split", "balance_factor")
            continue
        there = np.isin(np.round(slider.values, 9), np.round(swept.values, 9))
        for curve in slider.curves:
            own = crankstar.watched(swept, curve.what, order=curve.order)
            ours = np.array(curve.results)[there]
            assert ours.size == own.values.size
            assert ours == pytest.approx(own.values, rel=1e-9, abs=1e-12 * max(own.values))


@pytest.mark.release
@EVERY_ENGINE
def test_every_slider_begins_at_the_engine_that_is_there(name: str) -> None:
    """The result at the present value is that of the analysis."""
    engine, tree = engine_of(tree_of(name)), tree_of(name)
    result = balance(engine, speed=engine.speed)
    total = crankstar.total(result)
    for slider in sliders(tree):
        assert min(slider.values) <= slider.present <= max(slider.values)
        for curve in slider.curves:
            assert min(curve.results) <= curve.present <= max(curve.results)
            if curve.what == "roll" or curve.unit not in ("m r ω²", "m r ω² a", "N", "N m"):
                continue
            spectrum = getattr(total, curve.what)
            place = np.flatnonzero(spectrum.orders == curve.order)
            size = float((abs(spectrum.forward) + abs(spectrum.backward))[place].sum())
            assert curve.present == pytest.approx(size, rel=1e-6, abs=1e-9 * max(curve.results))


@pytest.mark.many(first=17)
@EVERY_ENGINE
def test_every_control_sets_its_number_and_makes_an_engine(name: str) -> None:
    tree = tree_of(name)
    engine = engine_of(tree)
    for control in controls(engine, tree):
        assert control.low <= control.value <= control.high, control
        same = engine_of(set_to(tree, control, control.value))
        assert [c.bearing for c in same.cylinders] == pytest.approx(
            [c.bearing for c in engine.cylinders]
        )
        moved = set_to(tree, control, control.value + control.step)
        again = {each.key: each for each in controls(engine_of(moved), moved)}
        assert again[control.key].value == pytest.approx(control.value + control.step)


def test_banks_more_than_half_a_turn_apart_have_an_angle_too() -> None:
    tree = tree_of("v2-90")
    for bank, bearing in zip(tree["layout"]["banks"], ("100 deg", "-100 deg"), strict=True):
        bank["bearing"] = bearing
    engine = engine_of(tree)
    (angle,) = (each for each in controls(engine, tree) if each.key == "layout.bank_angle")
    assert angle.value == pytest.approx(160)
    same = engine_of(set_to(tree, angle, angle.value))
    again, bearings = ([np.exp(1j * c.bearing) for c in e.cylinders] for e in (same, engine))
    assert again == pytest.approx(bearings)


@pytest.mark.release
def test_every_usual_layout_is_an_engine_that_fires() -> None:
    shown = presets()
    assert [preset.key for preset in shown] == [*USUAL]
    for preset in shown:
        engine = engine_of(preset.tree)
        assert len(engine.chambers) == preset.cylinders
        assert len(engine.firing_order) == preset.cylinders, preset.key
        assert workshop(preset.tree).cylinders == preset.cylinders


def test_an_explicit_engine_has_no_layout_to_change() -> None:
    shown = workshop(tree_of("napier-deltic"))
    assert (shown.fewer, shown.more, shown.cranks) == (None, None, ())
    assert [control.key for control in shown.controls] == ["speed"]
