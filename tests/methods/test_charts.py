"""Figures as data: the numbers drawn are those of the Balance at the chosen crank angle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import pi
from typing import Any

import numpy as np
import pytest

import crankstar
from crankstar import charts, spectra
from crankstar.charts.cylinder_forces import cylinder_forces
from crankstar.charts.resting import FOOT
from crankstar.charts.vectors import harmonic
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Reference, Totals, rolling_moment
from crankstar.remedy import with_balance_shaft, with_counterweights

ENGINES = (
    "sinitsyn-7-first",
    "v8-cross-plane",
    "v8-flat-plane",
    "kr250-racer",
    "audi-25-tfsi",
    "honda-b18c",
    "radial-9",
    "brough-golden-dream",
)
EVERY_ENGINE = pytest.mark.parametrize("name", ENGINES)
VERMILION, BLUE, GREY, ORANGE, GREEN = "#d55e00", "#2b83c6", "#808080", "#e69f00", "#009e73"


class Row(dict[str, Any]):
    """A row of a figure's data whose fields are read as in an expression of Vega."""

    __getattr__ = dict.__getitem__


def panels(spec: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """The panels of a figure that have layers, without its foot."""
    for key in ("vconcat", "hconcat", "concat"):
        for inner in spec.get(key, []):
            if inner.get("name") != FOOT:
                yield from panels(inner)
    if "layer" in spec:
        yield spec


def layers(
    panel: dict[str, Any], datasets: dict[str, Any], theta: float
) -> list[tuple[dict[str, Any], list[Row]]]:
    """The layers of a panel with their rows as Vega works them out at `theta` degrees."""
    functions = {name: getattr(math, name) for name in ("cos", "sin", "sqrt", "atan2", "floor")}
    functions |= {"abs": abs, "max": max}
    out = []
    for layer in panel["layer"]:
        data = layer.get("data", {})
        rows = [Row(row) for row in data.get("values", datasets.get(data.get("name", ""), []))]
        for step in layer.get("transform", []):
            for row in rows:
                names = {**functions, "PI": pi, "theta": theta, "datum": row}
                row[step["as"]] = eval(step["calculate"], {"__builtins__": {}}, names)  # noqa: S307  (our own expressions)
        out.append((layer, rows))
    return out


def kind(layer: dict[str, Any]) -> str:
    """The mark of a layer."""
    return layer["mark"]["type"] if isinstance(layer["mark"], dict) else layer["mark"]


def drawn(
    chart: Any, *, theta: float | None = None
) -> list[list[tuple[dict[str, Any], list[Row]]]]:
    """The layers of every panel, at the parameter's own value or another one (degrees)."""
    spec = chart.to_dict()
    own = next((p["value"] for p in spec.get("params", []) if p["name"] == "theta"), 0.0)
    return [
        layers(panel, spec.get("datasets", {}), own if theta is None else theta)
        for panel in panels(spec)
    ]


def arrows(
    panel: list[tuple[dict[str, Any], list[Row]]], colour: str | None = None
) -> list[complex]:
    """The arrows of a panel as vectors, up + i*right."""
    rows = [
        row for layer, found in panel if kind(layer) == "rule" for row in found if "endUp" in row
    ]
    return [
        complex(row.y2 - row.y1, row.x2 - row.x1) for row in rows if colour in (None, row.colour)
    ]


def close(one: Any, other: Any, scale: float = 1.0) -> bool:
    return bool(np.allclose(one, other, rtol=0, atol=1e-9 * max(scale, 1e-30)))


def pushed(spectrum: spectra.Spectrum) -> float:
    """The total push of all parts in any direction; orders below 1e-9 of it are not drawn."""
    return 10 * float((np.abs(spectrum.forward) + np.abs(spectrum.backward)).sum())


def lanchester(heights: tuple[float, float] = (0.0, 0.0)) -> Engine:
    first = with_balance_shaft(
        crankstar.load("i4"), ratio=2, planes=[1, -1], up=heights[0], right=2
    )
    return with_balance_shaft(first, ratio=-2, planes=[1, -1], up=heights[1], right=-2)


@pytest.mark.many(first=75)
@EVERY_ENGINE
@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("quantity", ["force", "couple"])
@pytest.mark.parametrize("theta", [0.0, 0.7])
def test_the_vectors_of_a_star_add_up_to_the_balance(
    name: str, order: int, quantity: Any, theta: float
) -> None:
    engine = crankstar.load(name)
    whole = spectra.selected(getattr(total(balance(engine)), quantity), order)
    factor, _ = harmonic(engine, order)
    found = [
        sum(arrows(panel), 0j)
        for panel in drawn(charts.vector_star(engine, order=order, quantity=quantity, theta=theta))
    ]
    spin = np.exp(1j * engine.sense * order * theta)
    forward, backward = whole.forward[0] / factor * spin, whole.backward[0] / factor / spin
    scale = (
        float(np.abs(spectra.selected(getattr(balance(engine), quantity), order).forward).sum())
        / factor
    )
    if len(found) == 1:  # what stands along the cylinders is the force
        bearing = np.exp(1j * engine.first.bearing)
        assert close((found[0] / bearing).real * bearing, forward + backward, scale)
        assert close(found[0], 2 * forward, scale)
    else:
        assert close(found, [forward, backward], scale)


@pytest.mark.release
def test_only_a_row_of_cylinders_whose_pistons_alone_push_has_the_textbook_star() -> None:
    def count(engine: Engine, order: int) -> int:
        return len(drawn(charts.vector_star(engine, order=order)))

    assert count(crankstar.load("i4"), 2) == 1
    assert count(crankstar.load("honda-b18c"), 2) == 1
    assert count(crankstar.load("v8-flat-plane"), 2) == 2
    assert count(lanchester(), 2) == 2
    assert count(lanchester(), 4) == 1
    assert count(crankstar.load("kr250-racer"), 1) == 2


@pytest.mark.parametrize(
    ("name", "order", "length", "angle"),
    [
        ("sinitsyn-6-valve", 1, 2 * math.sqrt(3), 30.0),
        ("sinitsyn-6-loop", 2, 2 * math.sqrt(3), -30.0),
        ("sinitsyn-7-first", 1, 0.8516, -70.55),
        ("sinitsyn-7-first", 2, 5.5222, -57.23),
        ("sinitsyn-7-second", 1, 0.2673, -64.29),
        ("sinitsyn-7-second", 2, 1.0056, -38.57),
    ],
)
def test_the_resultants_of_the_moment_polygons_of_sinitsyn_stand_at_his_angles(
    name: str, order: int, length: float, angle: float
) -> None:
    """Source: V. A. Sinitsyn, balance of single-shaft engines."""
    chart = charts.polygon(crankstar.load(name), order=order, quantity="couple")
    (panel,) = drawn(chart)
    (resultant,) = arrows(panel, ORANGE)
    assert abs(resultant) == pytest.approx(length, abs=5e-5)
    bearing = math.degrees(np.angle(resultant))
    assert bearing == pytest.approx(angle, abs=5e-3)
    (spec,) = panels(chart.to_dict())
    words = " ".join(spec["title"]["text"])
    assert f"resultant {abs(resultant):.5g} m r ω² {'A2 ' if order == 2 else ''}a" in words
    assert f"{round(bearing, 2):g}° from crank 1".replace("-", "−") in words


def test_the_plane_of_a_resultant_is_told_in_the_direction_of_rotation() -> None:
    engine = crankstar.load("man-s90mc-c")
    assert engine.sense < 0
    chart = charts.polygon(engine, order=2, quantity="couple")
    (resultant,) = arrows(drawn(chart)[0], ORANGE)
    (spec,) = panels(chart.to_dict())
    assert (
        f"{-math.degrees(np.angle(resultant)):.2f}° from crank 1".replace("-", "−")
        in spec["title"]["text"]
    )


@pytest.mark.parametrize(
    ("name", "order"),
    [("sinitsyn-6-valve", 2), ("sinitsyn-6-loop", 1), ("sinitsyn-8-four-stroke-1", 1), ("i6", 2)],
)
def test_a_polygon_without_a_resultant_says_that_it_closes(name: str, order: int) -> None:
    chart = charts.polygon(crankstar.load(name), order=order, quantity="couple")
    (panel,) = drawn(chart)
    assert arrows(panel, ORANGE) == []
    assert len(arrows(panel)) > 2
    assert abs(sum(arrows(panel))) < 1e-12
    (spec,) = panels(chart.to_dict())
    assert spec["title"]["text"] == ["closed"]


@EVERY_ENGINE
@pytest.mark.parametrize("theta", [0.0, 1.1])
def test_a_polygon_runs_head_to_tail_and_its_resultant_is_that_of_the_balance(
    name: str, theta: float
) -> None:
    engine = crankstar.load(name)
    whole = spectra.selected(total(balance(engine)).couple, 1)
    spin = np.exp(1j * engine.sense * theta)
    found = drawn(charts.polygon(engine, order=1, quantity="couple", theta=theta))
    wanted = (
        [2 * whole.forward[0] * spin]
        if len(found) == 1
        else [whole.forward[0] * spin, whole.backward[0] / spin]
    )
    for panel, resultant in zip(found, wanted, strict=True):
        rows = [
            row for layer, found in panel if kind(layer) == "rule" for row in found if "x1" in row
        ]
        sides = [row for row in rows if row.colour != ORANGE]
        for one, following in pairwise(sides):
            assert close([one.x2, one.y2], [following.x1, following.y1])
        assert close(sum(arrows(panel, ORANGE), 0j), resultant)
        assert close(
            sum((complex(row.y2 - row.y1, row.x2 - row.x1) for row in sides), 0j), resultant
        )


def from_line(row: Row, start: complex, end: complex) -> float:
    """The distance of a text, without the blank of its line, from a line."""
    line = start + (end - start) * np.linspace(0.0, 1.0, 400)
    across = np.maximum(np.abs(line.imag - row.x3) - row.wide, 0.0)
    upright = np.maximum(np.abs(line.real - row.y3) - 0.8 * row.high, 0.0)
    return float(np.hypot(across, upright).min())


@pytest.mark.many(first=6)
@pytest.mark.parametrize(
    ("name", "order", "quantity"),
    [
        ("sinitsyn-7-second", 1, "couple"),
        ("man-s90mc-c", 1, "couple"),
        ("v8-cross-plane", 1, "couple"),
        ("radial-9", 1, "force"),
        ("radial-9", 2, "force"),
    ],
)
@pytest.mark.parametrize("theta", [0.0, 0.7])
def test_a_label_of_a_polygon_is_nearest_to_its_own_side_or_has_a_line_to_it(
    name: str, order: int, quantity: Any, theta: float
) -> None:
    chart = charts.polygon(crankstar.load(name), order=order, quantity=quantity, theta=theta)
    seen = 0
    for panel in drawn(chart):
        rows = [row for layer, found in panel if kind(layer) == "rule" for row in found]
        lines = [(complex(r.y1, r.x1), complex(r.y2, r.x2)) for r in rows if "endUp" in r]
        dots = {
            (row.x2, row.y2)
            for layer, found in panel
            if kind(layer) == "point"
            for row in found
            if "text" in row
        }
        texts = [row for layer, found in panel if kind(layer) == "text" for row in found]
        for row in (row for row in texts if row.colour != GREY):
            point, seen = complex(row.y2, row.x2), seen + 1
            long = max(abs(end - start) for start, end in lines)
            # the sides through the place of the label: its own and those that lie on it
            own = [abs(point - a) + abs(point - b) - abs(b - a) < 1e-6 * long for a, b in lines]
            assert any(own)
            if row.led:
                assert (row.x2, row.y2) in dots
                continue
            away = [from_line(row, a, b) for a, b in lines]
            nearest = min(far for far, through in zip(away, own, strict=True) if through)
            others = [far for far, through in zip(away, own, strict=True) if not through]
            assert nearest <= min(others, default=math.inf), row.text
    assert seen > 4


@pytest.mark.many(first=7)
@EVERY_ENGINE
@pytest.mark.parametrize("quantity", ["force", "couple"])
@pytest.mark.parametrize("speed", [None, pytest.param(500.0, marks=pytest.mark.release)])
def test_a_hodograph_is_the_path_of_the_vector_and_its_dot_is_where_the_vector_is(
    name: str, quantity: Any, speed: float | None
) -> None:
    engine = crankstar.load(name)
    reference = Reference(0.03)
    whole = getattr(total(balance(engine, speed=speed, reference=reference)), quantity)
    greatest = spectra.peak(whole).value
    parts = pushed(getattr(balance(engine, speed=speed, reference=reference), quantity))
    chart = charts.hodograph(engine, quantity=quantity, speed=speed, reference=reference, theta=0.3)
    for degrees in (None, 0.0, 133.0):
        (panel,) = drawn(chart, theta=degrees)
        dots = [row for layer, rows in panel for row in rows if "from" in row]
        at = math.radians(math.degrees(0.3) if degrees is None else degrees)
        if dots:
            assert close(complex(dots[0].y2, dots[0].x2), complex(spectra.value(whole, at)), parts)
        else:
            assert greatest <= 1e-9 * parts
    path = [
        row
        for layer, rows in drawn(chart)[0]
        if kind(layer) == "line"
        for row in rows
        if row.colour == BLUE
    ]
    if path:
        values = np.array([complex(row.y2, row.x2) for row in path])
        turns = spectra.period(
            spectra.selected(
                whole,
                [
                    o
                    for o, f in zip(
                        whole.orders, np.abs(whole.forward) + np.abs(whole.backward), strict=True
                    )
                    if f > 1e-9 * greatest
                ],
            )
        )
        assert close(
            values, spectra.value(whole, np.linspace(0, 2 * pi * turns, len(values))), parts
        )
        assert np.abs(values).max() == pytest.approx(greatest, rel=1e-2)


@pytest.mark.parametrize(
    ("name", "order", "quantity"),
    [
        ("v8-cross-plane", 1, "couple"),
        ("v8-flat-plane", 2, "force"),
        ("v6-60-six-throws", 1, "couple"),
        ("ducati-90", 2, "force"),
        ("kr250-racer", 1, "force"),
        ("harley-45", 1, "force"),
    ],
)
def test_the_axes_of_a_hodograph_are_those_of_the_ellipse(
    name: str, order: int, quantity: Any
) -> None:
    engine = crankstar.load(name)
    whole = spectra.selected(getattr(total(balance(engine)), quantity), order)
    shape = spectra.ellipse(complex(whole.forward[0]), complex(whole.backward[0]))
    (panel,) = drawn(charts.hodograph(engine, order=order, quantity=quantity))
    dashed = [
        rows
        for layer, rows in panel
        if kind(layer) == "line" and layer["mark"]["strokeDash"] == [4, 3]
    ]
    ends = [complex(row.y2, row.x2) for rows in dashed for row in rows]
    axes = [(b - a) / 2 for a, b in zip(ends[::2], ends[1::2], strict=True)]
    assert axes[0] == pytest.approx(shape.semi_major * np.exp(1j * shape.bearing))
    if shape.semi_minor > 1e-9:
        assert abs(axes[1]) == pytest.approx(shape.semi_minor)
        assert abs((axes[0].conjugate() * axes[1]).real) < 1e-12
    else:
        assert len(axes) == 1
    texts = {row.text for layer, rows in panel if kind(layer) == "text" for row in rows}
    assert f"{shape.semi_major:.4g}" in texts


@pytest.mark.parametrize(
    ("name", "quantity"),
    [("gm-3800", "couple"), ("napier-deltic", "couple"), ("harley-45", "force")],
)
def test_the_length_of_a_semi_axis_stands_at_its_end_and_not_at_the_vector(
    name: str, quantity: Any
) -> None:
    engine = crankstar.load(name)
    whole = spectra.selected(getattr(total(balance(engine)), quantity), 1)
    shape = spectra.ellipse(complex(whole.forward[0]), complex(whole.backward[0]))
    (panel,) = drawn(charts.hodograph(engine, order=1, quantity=quantity))
    texts = {row.text: row for layer, rows in panel if kind(layer) == "text" for row in rows}
    vector = complex(spectra.value(whole, 0.0))
    for length, way in ((shape.semi_major, 1.0), (shape.semi_minor, 1j)):
        text = texts[f"{length:.4g}"]
        tip = complex(text.y2, text.x2)
        assert abs(tip) == pytest.approx(length)
        assert abs((tip * np.exp(-1j * shape.bearing) / way).imag) < 1e-9 * length
        assert abs(tip - vector) >= abs(tip + vector) * 0.999
        assert abs(complex(text.y3, text.x3)) > length


@pytest.mark.many(first=13)
@EVERY_ENGINE
@pytest.mark.parametrize(
    "quantity", ["force", "couple", "roll", pytest.param("torque", marks=pytest.mark.release)]
)
def test_the_curves_over_a_turn_are_the_balance(name: str, quantity: Any) -> None:
    engine = crankstar.load(name)
    sums, parts = total(balance(engine)), balance(engine)
    whole = rolling_moment(sums) if quantity == "roll" else getattr(sums, quantity)
    chart = charts.over_turn(engine, quantity=quantity, theta=0.3)
    values = [
        lambda at: np.real(spectra.value(whole, at)),
        lambda at: np.imag(spectra.value(whole, at)),
    ]
    each = Totals(parts.force, parts.couple, parts.axis_moment, parts.torque)
    shares = pushed(rolling_moment(each) if quantity == "roll" else getattr(each, quantity))
    found = drawn(chart)
    assert len(found) == (2 if quantity in ("force", "couple") else 1)
    for panel, value in zip(found, values, strict=False):
        rows = [
            row
            for layer, rows in panel
            if kind(layer) == "line"
            for row in rows
            if row.what == "all orders"
        ]
        at = np.radians([row.x for row in rows])
        assert close([row.y for row in rows], value(at), shares)
        dots = [row for layer, rows in panel if kind(layer) == "point" for row in rows]
        assert dots[0].x == pytest.approx(math.degrees(0.3))
        assert close(dots[0].y, value(0.3), shares)


def test_each_order_over_a_turn_is_drawn_by_itself() -> None:
    engine = crankstar.load("triple-120")
    couple = total(balance(engine)).couple
    up, _ = drawn(charts.over_turn(engine, quantity="couple", orders=[2]))
    rows = [
        row for layer, rows in up if kind(layer) == "line" for row in rows if row.what == "order 2"
    ]
    second = spectra.selected(couple, 2)
    assert len(rows) > 50
    assert close(
        [row.y for row in rows], np.real(spectra.value(second, np.radians([row.x for row in rows])))
    )
    assert not [
        row for layer, rows in up if kind(layer) == "line" for row in rows if row.what == "order 1"
    ]


@pytest.mark.release
def test_geared_shafts_are_drawn_over_their_whole_period() -> None:
    engine = with_counterweights(crankstar.load("single"), factor=0.5)
    shaft = engine.shafts[0].model_copy(update={"name": "half", "speed_ratio": Fraction(1, 2)})
    slow = engine.model_copy(update={"shafts": (*engine.shafts, shaft)})
    spec = charts.over_turn(slow).to_dict()
    assert spec["params"][0]["bind"]["max"] == 720
    up = drawn(charts.over_turn(slow))[0]
    assert max(
        row.x for layer, rows in up if kind(layer) == "line" for row in rows
    ) == pytest.approx(720)


@EVERY_ENGINE
def test_the_bars_of_a_spectrum_are_the_vectors_of_the_balance(name: str) -> None:
    engine = crankstar.load(name)
    sums = total(balance(engine, speed=400.0))
    for panel, quantity in zip(
        drawn(charts.spectrum(engine, speed=400.0)), ("force", "couple", "roll"), strict=True
    ):
        spectrum = rolling_moment(sums) if quantity == "roll" else getattr(sums, quantity)
        for row in (row for layer, rows in panel if kind(layer) == "bar" for row in rows):
            one = spectra.selected(spectrum, float(row.order))
            ahead, against = abs(one.forward[0]), abs(one.backward[0])
            ends = {
                "with the crank": (0, ahead),
                "against the crank": (ahead, ahead + against),
                "roll": (0, 2 * ahead),
            }
            assert (row["from"], row.to) == pytest.approx(ends[row.what])


@pytest.mark.release
def test_the_forces_on_each_cylinder_of_the_first_racer_are_those_of_the_essay() -> None:
    """Source: the essay's table of the Kawasaki KR250, with the exact second order, not 1/4."""
    second = harmonic(crankstar.load("kr250-racer"), 2)[0]
    assert second == pytest.approx(0.2540, abs=5e-5)
    at_top, at_right, at_bottom = drawn(charts.force_arrows(crankstar.load("kr250-racer")))[-3:]
    assert close(sum(arrows(at_top, GREEN)), 2 * second)
    assert abs(sum(arrows(at_right, GREEN)).imag) == pytest.approx(1.0)
    assert sum(arrows(at_right, GREEN)).real == pytest.approx(-2 * second)
    assert close(sum(arrows(at_bottom, GREEN)), 2 * second)
    assert close(arrows(at_top, VERMILION), [1, -1])
    assert close(arrows(at_top, GREY), [-0.5, 0.5])
    assert close(arrows(at_top, BLUE), [second, second])
    simultaneous = drawn(charts.force_arrows(crankstar.load("kr250-racer-simultaneous")))[-3:]
    assert [
        round(sum(arrows(panel, GREEN), 0j).real - s * 2 * second, 9)
        for panel, s in zip(simultaneous, (1, -1, 1), strict=True)
    ] == [1, 0, -1]
    production = drawn(charts.force_arrows(crankstar.load("kr250-production")))[-3:]
    assert close(sum(arrows(production[1], GREEN)), -2 * second)


@EVERY_ENGINE
def test_the_forces_on_the_cylinders_add_up_to_those_of_the_engine(name: str) -> None:
    engine = with_counterweights(crankstar.load(name), factor=0.4)
    found = cylinder_forces(engine, angles=(0.3, 2.0), orders=(1, 2))
    wanted = spectra.value(spectra.selected(total(balance(engine)).force, [1, 2]), [0.3, 2.0])
    assert close(sum((one.net for one in found), np.zeros(2, complex)), wanted, 10)


def test_a_bare_shaft_is_drawn_as_long_as_the_engine() -> None:
    engine = crankstar.load("i4")
    bare = Shaft(name="camshaft", speed_ratio=Fraction(1, 2))
    crank, camshaft = drawn(
        charts.shaft_elevation(engine.model_copy(update={"shafts": (*engine.shafts, bare)}))
    )
    ((left, right),) = [(row.x, row.x2) for _, rows in camshaft for row in rows if "upper" in row]
    numbers = [row.x for layer, rows in crank if kind(layer) == "text" for row in rows if row.y > 0]
    assert left < min(numbers) < max(numbers) < right


def test_a_balance_shaft_pushes_by_itself() -> None:
    found = cylinder_forces(lanchester(), angles=(0.3,), orders=(1, 2))
    assert [one.name for one in found][4:] == ["balancer 2", "balancer -2"]
    assert abs(complex(sum((one.net[0] for one in found), 0j))) < 1e-12


@pytest.mark.many(first=5)
@pytest.mark.parametrize("name", ["v8-cross-plane", "honda-b18c", "napier-deltic", "kr250-racer"])
@pytest.mark.parametrize("theta", [0.0, 0.9])
def test_the_pins_of_a_crank_star_are_where_the_crank_angle_turns_them(
    name: str, theta: float
) -> None:
    engine = crankstar.load(name)
    (panel,) = drawn(charts.crank_star(engine, theta=theta))
    wanted = [
        throw.radius * np.exp(1j * (throw.angle + engine.sense * float(shaft.speed_ratio) * theta))
        for shaft in engine.shafts
        for throw in shaft.throws
    ]
    assert close(arrows(panel, BLUE), wanted)
    texts = " ".join(row.text for layer, rows in panel if kind(layer) == "text" for row in rows)
    assert all(
        str(place) in texts for shaft in engine.shafts for place in range(1, len(shaft.throws) + 1)
    )


@pytest.mark.many(first=1)
@pytest.mark.parametrize("theta", [0.0, 0.9])
def test_the_heights_of_the_pins_in_an_elevation_are_true(theta: float) -> None:
    engine = crankstar.load("yamaha-r1-crossplane")
    (panel,) = drawn(charts.shaft_elevation(engine, theta=theta))
    rows = [
        row
        for layer, rows in panel
        for row in rows
        if row.get("lower") == 1 and row.get("upper") == 1
    ]
    wanted = [math.cos(throw.angle + engine.sense * theta) for throw in engine.shafts[0].throws]
    heights = np.array([row.y1 for row in rows])
    assert close(heights / 42.0, wanted)
    places = [(row.x + row.x2) / 2 for row in rows]
    assert places == sorted(
        places
    )  # the first cylinder stands at the front, and the front is at the left
    arms = [row.text for layer, rows in panel if kind(layer) == "text" for row in rows if row.y < 0]
    assert arms == ["1.5", "0.5", "−0.5", "−1.5"]
    moved = drawn(charts.shaft_elevation(engine, reference=Reference(engine.cylinders[0].z)))[0]
    assert [
        row.text for layer, rows in moved if kind(layer) == "text" for row in rows if row.y < 0
    ] == ["0", "−1", "−2", "−3"]
