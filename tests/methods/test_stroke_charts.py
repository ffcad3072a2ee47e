"""The stroke chart and the firing ring as data: the working cycle at every crank angle."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import pi, radians
from typing import Any

import numpy as np
import pytest
from tests.methods.test_charts import Row, drawn, kind, panels
from tests.methods.test_charts_pictures import words_of

import crankstar
from crankstar import charts
from crankstar.analyses.strokes.charts.timing_diagram import BLOW_DOWN, EXHAUST, INTAKE, POWER
from crankstar.analyses.verdict.facts import verdict
from crankstar.charts.drawing import GREY
from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import Basis
from crankstar.engine.layouts import tandem
from crankstar.firing.numbering import with_order
from crankstar.firing.orders import even_orders
from crankstar.firing.strokes import exhaust_groups, exhaust_intervals, working_cycle
from crankstar.language.messages import spoken

ENGINES = (
    "v8-cross-plane",
    "v8-flat-plane",
    "i4",
    "audi-25-tfsi",
    "kr250-racer",
    "radial-9",
    "merlin",
    "napier-deltic",
    "jumo-205",
)
EVERY_ENGINE = pytest.mark.parametrize("name", ENGINES)


def spans(chart: Any) -> list[Row]:
    """The spans of all panels."""
    return [
        row
        for panel in drawn(chart)
        for layer, rows in panel
        if kind(layer) == "rect"
        for row in rows
    ]


@EVERY_ENGINE
def test_the_spans_of_a_stroke_chart_are_those_of_the_working_cycle(name: str) -> None:
    engine = crankstar.load(name)
    found = working_cycle(engine)
    rows = spans(charts.stroke_chart(engine))
    assert all(0 <= row.x < row.end <= found.cycle_deg for row in rows)
    for one in found.chambers:
        whole = {INTAKE: one.intake, BLOW_DOWN: one.blow_down, POWER: one.strokes[0].window}
        for what, window in whole.items():
            own = [row for row in rows if row.cylinder == one.number and row.what == what]
            assert sum(row.end - row.x for row in own) == pytest.approx(window.length_deg, abs=1e-5)
            assert min(abs(row.x - window.start_deg % found.cycle_deg) for row in own) < 1e-5
        open_for = [
            row for row in rows if row.cylinder == one.number and row.what in (EXHAUST, BLOW_DOWN)
        ]
        assert sum(row.end - row.x for row in open_for) == pytest.approx(
            one.exhaust.length_deg, abs=1e-5
        )


@EVERY_ENGINE
def test_every_cylinder_has_one_row_and_fires_where_it_is_marked(name: str) -> None:
    engine = crankstar.load(name)
    found = working_cycle(engine)
    rows = spans(charts.stroke_chart(engine))
    for panel in drawn(charts.stroke_chart(engine)):
        (marks,) = [found_rows for layer, found_rows in panel if kind(layer) == "point"]
        (own,) = [found_rows for layer, found_rows in panel if kind(layer) == "rect"]
        numbers = {int(row.y): row.cylinder for row in own}
        assert {int(mark.y) for mark in marks} == set(numbers)
        for mark in marks:
            assert mark.x % found.cycle_deg == found.chamber(numbers[int(mark.y)]).fires_deg
    assert {row.cylinder for row in rows} == set(engine.chambers)


def test_intake_is_blue_and_exhaust_red_and_banks_stand_apart() -> None:
    chart = charts.stroke_chart(crankstar.load("v8-cross-plane"))
    found = list(panels(chart.to_dict()))
    assert [panel["title"]["text"][0] for panel in found] == [
        "bank odd: exhausts 270-180-90-180 deg apart",
        "bank even: exhausts 90-180-270-180 deg apart",
    ]
    scale = found[0]["layer"][0]["encoding"]["color"]["scale"]
    colours = dict(zip(scale["domain"], scale["range"], strict=True))
    assert colours[INTAKE] == "rgba(43, 131, 198, 1)"
    assert colours[BLOW_DOWN] == "rgba(213, 94, 0, 1)"
    assert colours[EXHAUST] == "rgba(213, 94, 0, 0.5)"


@pytest.mark.release
def test_what_is_assumed_is_marked_in_the_chart_and_what_is_given_is_not() -> None:
    words = words_of(charts.saved(charts.stroke_chart(crankstar.load("i4")), "svg", title="x"))
    assert "exhaust 50°* before BDC to 15°* after TDC" in words
    assert "* assumed; not in the engine file" in words
    own = {
        "intake_opens": "10 deg",
        "intake_closes": "40 deg",
        "exhaust_opens": "60 deg",
        "exhaust_closes": "5 deg",
    }
    words = words_of(
        charts.saved(
            charts.stroke_chart(crankstar.load("i4", changes={"valves": own})), "svg", title="x"
        )
    )
    assert "exhaust 60° before BDC to 5° after TDC" in words
    assert "assumed" not in words


@pytest.mark.parametrize(
    ("theta", "at"), [(0.0, 0.0), (1.0, 57.29577951), (4 * pi, 720.0), (4 * pi + 1.0, 57.29577951)]
)
def test_the_rule_stands_at_the_crank_angle_within_the_cycle(theta: float, at: float) -> None:
    for panel in drawn(charts.stroke_chart(crankstar.load("v8-cross-plane"), theta=theta)):
        (rule,) = [rows[0] for layer, rows in panel if kind(layer) == "rule"]
        assert rule.x == pytest.approx(at, abs=1e-4)


def angle_of(up: float, right: float, cycle: float) -> float:
    """The crank angle of a place on the ring."""
    return float(np.degrees(np.arctan2(right, up)) % 360 * cycle / 360)


@EVERY_ENGINE
def test_the_dots_of_a_firing_ring_stand_at_the_firing_angles(name: str) -> None:
    engine = crankstar.load(name)
    found = working_cycle(engine)
    (panel,) = drawn(charts.firing_ring(engine))
    dots = [
        row
        for layer, rows in panel
        if kind(layer) == "point" and "angle" not in layer["encoding"]
        for row in rows
    ]
    fires = sorted(angle % found.cycle_deg for angle in found.firing.angles_deg)
    shown = sorted(
        (angle_of(dot.atUp, dot.atRight, found.cycle_deg) + 1e-6) % found.cycle_deg for dot in dots
    )
    assert shown == pytest.approx(fires, abs=1e-4)
    groups = exhaust_groups(engine)
    if len(groups) > 1:
        colours = [
            {
                dot.colour
                for dot in dots
                if any(close(dot, found.chamber(n).fires_deg, found.cycle_deg) for n in g.chambers)
            }
            for g in groups
        ]
        assert all(len(one) == 1 for one in colours)
        assert len(set().union(*colours)) == len(groups)


@pytest.mark.parametrize(
    "name",
    [
        "v8-cross-plane",
        "v8-flat-plane",
        "merlin",
        "v12-60",
        "napier-deltic",
        "gm-3800",
        "napier-lion",
    ],
)
def test_the_dots_of_a_bank_stand_off_the_lines_of_the_others(name: str) -> None:
    engine = crankstar.load(name)
    if not engine.firing_order:
        engine = with_order(engine, even_orders(engine)[0].firing)
    (panel,) = drawn(charts.firing_ring(engine))
    dots = [
        row
        for layer, rows in panel
        if kind(layer) == "point" and "angle" not in layer["encoding"]
        for row in rows
    ]
    lines: dict[tuple[str, int], list[complex]] = {}
    for layer, rows in panel:
        if kind(layer) == "line":
            for row in rows:
                lines.setdefault((row.colour, row.line), []).append(complex(row.y2, row.x2))
    polygons = [
        (colour, points)
        for (colour, _), points in lines.items()
        if colour != GREY and len(points) > 2
    ]
    assert len(polygons) == len(exhaust_groups(engine))
    for colour, points in polygons:
        along = np.concatenate([np.linspace(a, b, 200) for a, b in pairwise(points)])
        others = [complex(dot.atUp, dot.atRight) for dot in dots if dot.colour != colour]
        assert min(abs(along - other).min() for other in others) > 0.08
    radii = [{round(abs(point), 6) for point in points} for _, points in polygons]
    assert all(len(one) == 1 for one in radii)
    assert len(set().union(*radii)) == len(radii)


@pytest.mark.parametrize(
    "name", ["i4", "v8-cross-plane", "merlin", "napier-deltic", "pratt-whitney-wasp"]
)
def test_crank_angles_stand_beside_the_numbers_of_a_ring(name: str) -> None:
    engine = crankstar.load(name)
    found = working_cycle(engine)
    (panel,) = drawn(charts.firing_ring(engine))
    texts = [row.text for layer, rows in panel if kind(layer) == "text" for row in rows]
    fires = {one.number: one.fires_deg for one in found.chambers}
    assert {text.split("\n")[0] for text in texts if "\n" in text} == {
        str(number) for number in fires
    }
    for text in texts:
        if "\n" in text:
            number, angle = text.split("\n")
            assert float(angle.removesuffix("°")) == pytest.approx(fires[int(number)], abs=0.06)


def close(dot: Row, fires: float, cycle: float) -> bool:
    return (
        abs((angle_of(dot.atUp, dot.atRight, cycle) - fires + cycle / 2) % cycle - cycle / 2) < 1e-4
    )


@pytest.mark.parametrize("theta", [0.0, 1.0, 9.0])
def test_the_pointer_of_a_firing_ring_is_once_round_in_a_cycle(theta: float) -> None:
    for name in ("v8-cross-plane", "kr250-racer"):
        engine = crankstar.load(name)
        (panel,) = drawn(charts.firing_ring(engine, theta=theta))
        (tip,) = [
            row for layer, rows in panel if kind(layer) == "rule" for row in rows if "endUp" in row
        ]
        assert angle_of(tip.y2, tip.x2, engine.cycle_angle) == pytest.approx(
            np.degrees(theta) % engine.cycle_angle
        )


def test_neighbours_that_fire_one_after_the_other_have_a_thick_arc_and_no_others() -> None:
    (panel,) = drawn(charts.firing_ring(crankstar.load("v8-cross-plane")))
    thick = [row for layer, rows in panel if kind(layer) == "line" for row in rows if row.width > 4]
    assert [angle_of(row.y2, row.x2, 720) for row in (thick[0], thick[-1])] == pytest.approx(
        [450, 540]
    )
    (panel,) = drawn(charts.firing_ring(crankstar.load("i6")))
    assert not [
        row for layer, rows in panel if kind(layer) == "line" for row in rows if row.width > 4
    ]


def test_the_key_of_a_ring_tells_the_intervals_of_the_exhausts() -> None:
    engine = crankstar.load("v8-cross-plane")
    words = words_of(charts.saved(charts.firing_ring(engine), "svg", title="x"))
    odd = exhaust_intervals(working_cycle(engine), exhaust_groups(engine)[0].chambers)
    assert f"bank odd: {'-'.join(f'{step.interval_deg:.0f}' for step in odd)} deg apart" in words
    assert "even firing, every 90 deg" in words
    together = words_of(
        charts.saved(
            charts.firing_ring(crankstar.load("kr250-racer-simultaneous")), "svg", title="x"
        )
    )
    assert "all fire together, every 360 deg" in together


def test_crankshafts_of_different_speed_are_refused_in_a_sentence() -> None:
    second = Crank(
        banks=(Bank(cylinders=(2,)),), right=3.0, speed_ratio=Fraction(1, 2), lag=radians(50)
    )
    engine = tandem(
        Basis(name="x", firing_order=(1, 2)), cranks=(Crank(banks=(Bank(cylinders=(1,)),)), second)
    )
    for figure in (charts.stroke_chart, charts.firing_ring):
        with pytest.raises(charts.ChartError, match="all crankshafts must turn equally fast"):
            figure(engine)


@pytest.mark.release
@pytest.mark.parametrize(("language", "left"), [("ja", "バンク left"), ("ru", "ряд left")])
def test_exhaust_groups_are_named_in_the_language(language: str, left: str) -> None:
    engine = crankstar.load("toyota-1uz-fe")
    assert exhaust_groups(engine)[0].name == "bank left"
    with spoken(language):
        assert exhaust_groups(engine)[0].name == left
        assert any(left in fact.sentence for fact in verdict(engine, relatives=False))
        ring = charts.saved(charts.firing_ring(engine), "svg", title="x")
        assert left in words_of(ring)
