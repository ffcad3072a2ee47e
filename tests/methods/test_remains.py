"""What counts as zero, and which orders are shown, of engines whose balance is known."""

from __future__ import annotations

import numpy as np
import pytest

from crankstar.analyses.verdict.facts import verdict
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.files import engine_of
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.bounds import size
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import (
    orders_drawn,
    orders_pushed,
    orders_shown,
    orders_turning,
    remains,
    sizes,
    summed,
)
from crankstar.page.exhibits import exhibit
from crankstar.spectra import total as total_of
from crankstar.tables.comparison import compare
from crankstar.tables.peaks import part_peaks


def test_a_couple_with_an_arm_of_rounding_is_none() -> None:
    single = load("single")
    for arm, couple in ((1e-14, 0.0), (1e-3, 1e-3)):
        sums = summed(balance(single, reference=Reference(arm)))
        assert abs(size(sums.couple, 1) - couple) < 1e-15
        assert size(sums.force, 1) == 1.0


def test_what_cancels_is_exactly_zero_and_what_remains_is_kept() -> None:
    result = balance(load("i4"))
    sums = summed(result)
    assert not sizes(sums.couple).any()
    assert not remains(sums.couple)
    assert remains(sums.force)
    assert abs(size(sums.roll, 2) - 2.0) < 0.01
    assert size(sums.roll, 1) == 0.0


def test_the_block_of_a_six_rolls_at_order_3_at_which_no_piston_pushes() -> None:
    result = balance(load("i6"))
    assert orders_pushed(result) == (1, 2, 4, 6)
    assert orders_turning(result, summed(result)) == (1, 2, 3, 4, 6)


def test_a_high_order_is_shown_from_a_thousandth_of_the_greatest() -> None:
    """Four even two-stroke cylinders roll at orders 4, 8, 12; short rods."""
    short = Sizes(rod_ratio=2.2)
    four = inline(Basis(name="four", cycle="two-stroke", firing_order=(1, 3, 2, 4), cylinder=short))
    result = balance(four)
    sums = summed(result)
    greatest = size(sums.roll, 4)
    assert 1e-3 < size(sums.roll, 8) / greatest < 1e-2
    assert size(sums.roll, 12) / greatest < 1e-3
    assert {order for order in orders_shown(result, sums) if order > 6} == {8}


def test_a_minor_order_is_not_drawn_but_the_first_two_always_are() -> None:
    result = balance(load("i4"))
    sums = summed(result)
    assert orders_drawn(result, sums, "force", (1, 2, 4, 6)) == (1, 2)
    assert orders_drawn(result, sums, "force", (1, 2, 4, 6), minor=-1) == (1, 2, 4, 6)


def test_the_greatest_roll_is_shown_however_high_its_order() -> None:
    """The block of a two-stroke seven rolls at order 7 and its multiples only."""
    result = balance(load("man-s90mc-c"))
    sums = summed(result)
    rolls = sizes(sums.roll)
    assert sums.roll.orders[int(np.argmax(rolls))] == 7
    assert 7.0 in orders_turning(result, sums)


@pytest.mark.parametrize("bearings", [(0.0,), (45.0, -45.0)])
def test_a_peak_that_is_rounding_is_nought_where_none_is_said(bearings: tuple[float, ...]) -> None:
    pins = 36
    banks = [
        {
            "bearing": f"{bearing} deg",
            "cylinders": list(range(pins * place + 1, pins * (place + 1) + 1)),
        }
        for place, bearing in enumerate(bearings)
    ]
    throws = [f"{720 * pin / pins % 360:g} deg" for pin in range(pins)]
    tree = {
        "format": 1,
        "name": "long",
        "cylinder": {"rod_ratio": 3.5},
        "layout": {"type": "vee", "banks": banks, "throws": throws},
    }
    result = balance(engine_of(tree))
    sums = summed(result)
    assert not remains(sums.torque)
    peaks = part_peaks(result, sums)
    assert peaks["roll"][0] == peaks["vertical"][0] == peaks["horizontal"][0] == 0.0


@pytest.mark.parametrize("name", ["i6", "triumph-675", "v12-60", "boxer-6", "v8-cross-plane"])
def test_the_greatest_order_that_remains_has_figures_and_a_derivation(name: str) -> None:
    """By the spectrum itself, whatever the rule of the page is."""
    result, shown = balance(load(name)), exhibit(load(name), relatives=False)
    for quantity in ("force", "couple"):
        parts = getattr(result, quantity)
        remaining = sizes(total_of(parts))
        if remaining.max() < 1e-9 * sizes(parts).max():
            continue
        greatest = float(parts.orders[remaining.argmax()])
        figures = {each.figure for each in shown.charts if each.order == greatest}
        assert figures == {"vector-star", "polygon", "hodograph"}, quantity
        derived = {each.quantity for each in shown.derivations if each.order == greatest}
        assert derived == {"force", "couple"}


def _vee(offset: str) -> Engine:
    """A V6 of 90 degrees on split pins, its cylinders beside the crank axis by `offset`."""
    return engine_of(
        {
            "format": 1,
            "name": "V6",
            "speed": "5200 rpm",
            "firing_order": [1, 2, 3, 4, 5, 6],
            "cylinder": {
                "stroke": "86.4 mm",
                "rod_length": "150 mm",
                "reciprocating_mass": "560 g",
                "rod": {"mass": "620 g", "centre": "42 mm"},
                "offset": offset,
            },
            "layout": {
                "type": "vee",
                "bore_pitch": "107 mm",
                "throws": ["0 deg", "120 deg", "240 deg"],
                "pin_split": "30 deg",
                "banks": [
                    {"bearing": "-45 deg", "cylinders": [1, 3, 5]},
                    {"bearing": "45 deg", "cylinders": [2, 4, 6]},
                ],
            },
        }
    )


def test_forces_through_the_crank_axis_have_no_moment_about_it() -> None:
    """All masses are at points of which the forces go through the axis; rods are two masses."""
    centred = _vee("0 mm")
    result = balance(centred, speed=centred.speed)
    assert not remains(summed(result).axis_moment)
    assert not any("about the crank axis" in fact.sentence for fact in verdict(centred))
    heads = [part.title for part in compare(centred, _vee("0 mm")).tables]
    assert "Rolling moment" in heads
    axis = next(table for table in compare(centred, centred).tables if table.key == "axis_moment")
    assert not axis.rows
    # the same by m r^2 w^2, of which a residue is no share
    assert centred.speed is not None
    whole = 6 * (0.56 + 0.62) * 0.0432**2 * centred.speed**2
    assert abs(total(result).axis_moment.forward).max() < 1e-15 * whole


def test_a_hundredth_of_a_millimetre_beside_the_axis_is_a_moment() -> None:
    """Of one piston: minus offset times m x'' with x the height over the axis, by differences."""
    tree = {
        "format": 1,
        "name": "one",
        "speed": "3000 rpm",
        "firing_order": [1],
        "cylinder": {
            "stroke": "86 mm",
            "rod_length": "140 mm",
            "reciprocating_mass": "500 g",
            "offset": "0.01 mm",
        },
        "layout": {"type": "inline", "throws": ["0 deg"]},
    }
    engine = engine_of(tree)
    assert engine.speed is not None
    theta = np.arange(4096) * 2 * np.pi / 4096
    height = 0.043 * np.cos(theta) + np.sqrt(0.14**2 - (0.043 * np.sin(theta) - 1e-5) ** 2)
    wave = np.fft.rfft(height) / 2048
    sums = summed(balance(engine, speed=engine.speed))
    for order in (1, 2):
        expected = 1e-5 * 0.5 * engine.speed**2 * order**2 * abs(wave[order])
        assert size(sums.axis_moment, order) == pytest.approx(expected, rel=1e-6)
