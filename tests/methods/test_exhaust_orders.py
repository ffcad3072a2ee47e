"""Orders of the exhaust: two roads to them, closed forms, table, chart, verdict."""

from __future__ import annotations

from fractions import Fraction
from math import cos, radians, sin, sqrt

import numpy as np
import pytest
from tests.methods.test_charts_pictures import words_of

import crankstar
from crankstar import charts
from crankstar.analyses.verdict.facts import verdict
from crankstar.derive.algebra.cyclotomic import cosine, rational, sine
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.exhaust import exact_exhaust_orders
from crankstar.derive.records import DerivationError
from crankstar.firing.exhaust_orders import exhaust_orders
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import exhaust_groups
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError
from crankstar.mechanics.exhaust_pulses import exhaust_pulses

CROSS, FLAT = "v8-cross-plane", "v8-flat-plane"
LOW, HIGH = 2 * sqrt(2) * sin(radians(22.5)), 2 * sqrt(2) * cos(radians(22.5))
EVEN = ("i4", "i6", "triple-120", "audi-25-tfsi", "sinitsyn-7-first-four-stroke", "jumo-205")


def test_a_bank_of_a_cross_plane_eight_has_the_known_orders() -> None:
    found = exhaust_orders(crankstar.load(CROSS), highest=4)
    assert found.orders.tolist() == [0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4]
    for sums in np.abs(found.sums):
        assert sums == pytest.approx([LOW, 0, HIGH, 0, HIGH, 0, LOW, 4], abs=1e-12)
        assert sums[[1, 3, 5]].tolist() == [0, 0, 0]  # exactly
    assert np.abs(found.whole).tolist() == [0, 0, 0, 0, 0, 0, 0, 8]


def test_a_bank_of_a_flat_plane_eight_has_even_orders_only() -> None:
    found = exhaust_orders(crankstar.load(FLAT))
    for sums in found.sums:
        assert found.orders[sums != 0].tolist() == [2, 4, 6, 8]
        assert np.abs(sums[sums != 0]) == pytest.approx([4, 4, 4, 4])


@pytest.mark.parametrize(
    "name", [CROSS, FLAT, "v4-90", "vw-vr6", "i2-270", "kr250-racer", "merlin"]
)
def test_the_sums_are_the_spectrum_of_a_comb_of_firings(name: str) -> None:
    engine = crankstar.load(name)
    found, fired = exhaust_orders(engine, highest=8), firing(engine)
    steps = 72_000
    for group, sums in zip(exhaust_groups(engine), found.sums, strict=True):
        comb = np.zeros(steps)
        for number, angle in zip(fired.order, fired.angles_deg, strict=True):
            if number in group.chambers:
                comb[round(angle / fired.cycle_deg * steps) % steps] += 1
        lines = np.fft.rfft(comb)[1 : sums.size + 1]
        assert lines == pytest.approx(sums, abs=0.02)  # a comb of a hundredth of a degree


@pytest.mark.parametrize("name", EVEN)
def test_even_firings_have_multiples_of_their_order_only(name: str) -> None:
    engine = crankstar.load(name)
    own = len(engine.chambers) * 360 / engine.cycle_angle
    found = exhaust_orders(engine, highest=4 * own)
    there = np.isclose(found.orders / own % 1, 0)
    assert (found.whole[~there] == 0).all()
    assert np.abs(found.whole[there]) == pytest.approx(np.full(4, len(engine.chambers)))


def test_orders_need_firings_and_a_highest_order() -> None:
    with pytest.raises(EngineError, match="firing_order is missing"):
        exhaust_orders(crankstar.load("napier-lion"))
    for highest in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(MessageError, match="the highest order of the exhaust is"):
            exhaust_orders(crankstar.load("i4"), highest=highest)
        with pytest.raises(MessageError, match="the highest order of the exhaust is"):
            exact_exhaust_orders(crankstar.load("i4"), highest=highest)


def test_a_cross_plane_bank_is_proved_to_have_no_order_two() -> None:
    found = exact_exhaust_orders(crankstar.load(CROSS))
    banks = [each for each in found if len(each.group.chambers) == 4]
    assert len(banks) == 2 * 16
    for each in banks:
        assert each.zero == (each.order in (1, 2, 3, 5, 6, 7))
        square = each.total * each.total.conjugate
        if each.order in (Fraction(3, 2), Fraction(5, 2)):
            twice = cosine(Fraction(1, 16)) * cosine(Fraction(1, 16))
            assert square == rational(8) * twice  # 2 sqrt2 cos 22.5 deg
            assert each.text == "√(4 + 2√2)"
        if each.order in (Fraction(1, 2), Fraction(7, 2)):
            assert square == rational(8) * sine(Fraction(1, 16)) * sine(Fraction(1, 16))
            assert each.text == "√(4 − 2√2)"


@pytest.mark.parametrize("name", EVEN)
def test_an_even_engine_is_proved_to_have_multiples_of_its_order_only(name: str) -> None:
    engine = crankstar.load(name)
    own = Fraction(len(engine.chambers) * 360, round(engine.cycle_angle))
    found = exact_exhaust_orders(engine, highest=float(3 * own))
    assert len(found) == 3 * len(engine.chambers)
    assert all(each.zero == ((each.order / own).denominator != 1) for each in found)
    assert all(each.text == str(len(engine.chambers)) for each in found if not each.zero)


@pytest.mark.parametrize("name", [CROSS, "v4-90", "i2-270", "harley-45", "v12-60"])
def test_closed_forms_are_the_sums(name: str) -> None:
    engine = crankstar.load(name)
    found, exact = exhaust_orders(engine, highest=6), exact_exhaust_orders(engine, highest=6)
    sums = np.abs(np.vstack([found.sums, found.whole]))[: len(exact) // found.orders.size]
    assert [value(each.length) for each in exact] == pytest.approx(sums.ravel(), abs=1e-12)


def test_angles_of_slave_rods_have_no_closed_form() -> None:
    with pytest.raises(DerivationError, match="no rational part of a turn"):
        exact_exhaust_orders(crankstar.load("radial-9"))


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        (CROSS, "Exhaust of each bank: orders 0.5, 1.5, 2.5, 3.5 beside 4."),
        ("v4-90", "Exhaust of each bank: orders 0.5, 1.5 beside 2."),
        (FLAT, None),
        ("i4", None),
    ],
)
def test_the_verdict_names_the_orders_of_uneven_banks(name: str, sentence: str | None) -> None:
    facts = verdict(crankstar.load(name), relatives=False)
    told = " ".join(fact.sentence for fact in facts if fact.about == "firing")
    assert (sentence in told) if sentence else ("Exhaust of" not in told)


def test_manifolds_of_a_file_are_named_in_the_verdict() -> None:
    joined = crankstar.load(CROSS, changes={"valves.manifolds": [[1, 3, 5, 7], [8, 4, 6, 2]]})
    told = " ".join(fact.sentence for fact in verdict(joined, relatives=False))
    assert "Exhaust of each manifold: orders 0.5, 1.5, 2.5, 3.5 beside 4." in told


def test_the_chart_has_a_bar_for_every_order_that_is_there() -> None:
    chart = charts.exhaust_order_chart(crankstar.load(CROSS)).to_dict()
    panels = [panel for panel in chart["vconcat"] if "title" in panel]
    assert [panel["title"]["text"] for panel in panels] == [
        ["bank odd"],
        ["bank even"],
        ["whole engine"],
    ]
    rows = panels[0]["layer"][0]["data"]["values"]
    assert [row["order"] for row in rows[:5]] == ["0.5", "1.5", "2.5", "3.5", "4"]
    assert [row["text"] for row in rows[:5]] == ["1.1", "2.6", "2.6", "1.1", "4"]
    assert rows[1]["to"] == pytest.approx(HIGH)


@pytest.mark.release
def test_an_engine_without_firing_order_has_no_bars() -> None:
    chart = charts.exhaust_order_chart(crankstar.load("napier-lion"))
    assert "The file gives no firing order." in words_of(charts.saved(chart, "svg", title="x"))


def test_pulses_of_the_cycle_are_the_unit_pulses_times_that_of_one_cylinder() -> None:
    """In both banks by the same factor, whose size is that of the pulse itself, integrated."""
    engine = crankstar.load("gm-l76")
    found = exhaust_pulses(engine, crankstar.cycle(engine, imep=9e5), highest=6)
    unit = exhaust_orders(engine, highest=6)
    there = np.abs(unit.sums) > 0
    factors = np.where(there, found.sums / np.where(there, unit.sums, 1), np.nan)
    assert np.all(np.abs(found.sums[~there]) == 0)
    both = there.all(axis=0)
    assert np.abs(factors[0, both] - factors[1, both]).max() < 1e-9 * np.abs(found.sums).max()


@pytest.mark.parametrize("name", ["single", "i2-270"])
def test_pulses_of_the_cycle_are_those_of_an_integral_over_the_open_exhaust(name: str) -> None:
    """Valves of the file, the trapezium rule over the opening, a spline through the pressure."""
    valves = {"exhaust_opens": "60 deg", "exhaust_closes": "10 deg"}
    sizes = {"cylinder.stroke": "90 mm", "cylinder.bore": "86 mm"}
    changes = {**sizes, **{f"valves.{name}": angle for name, angle in valves.items()}}
    engine = crankstar.load(name, changes=changes)
    cycle = crankstar.cycle(engine, imep=8e5)
    found = exhaust_pulses(engine, cycle, highest=4)
    angle = np.linspace(np.radians(120.0), np.radians(370.0), 40_001)
    samples = np.arange(cycle.pressure.shape[-1] + 1) * (4 * np.pi / cycle.pressure.shape[-1])
    closed = np.append(cycle.pressure[0], cycle.pressure[0, 0])
    pressure = np.interp(angle, samples, closed) - 1.05e5
    pulse = pressure * np.sin(np.pi * (angle - angle[0]) / (angle[-1] - angle[0])) ** 2
    for order, amplitude in zip(found.orders, found.whole, strict=True):
        delays = np.exp(-1j * order * cycle.volumes.fires).sum()
        turned = pulse * np.exp(-1j * order * angle) * delays
        step = np.diff(angle)
        wanted = ((turned[1:] + turned[:-1]) / 2 * step).sum() / (2 * np.pi)
        assert abs(amplitude - wanted) < 2e-3 * np.abs(found.whole).max()
