"""Figures as pictures: they compile for every engine; scales are equal, labels do not overlap.

Each has one parameter, the crank angle.
"""

from __future__ import annotations

import inspect
import json
import re
import subprocess
import sys
from functools import cache, partial
from itertools import combinations
from typing import Any
from xml.etree import ElementTree

import altair
import jsonschema_rs
import numpy as np
import pytest
from altair.vegalite.v6.schema.core import load_schema
from tests.catalog import EVERY_NAME
from tests.charted import rows_drawn
from tests.methods.test_charts import ENGINES, drawn, kind, lanchester, panels

import crankstar
from crankstar import charts
from crankstar.charts.drawing import HALO
from crankstar.charts.letters import text_width
from crankstar.charts.saving import saved_print
from crankstar.charts.themes import THEMES
from crankstar.engine.basis import Sizes
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import Basis, inline
from crankstar.language.numbers import number, numbers_text
from crankstar.remedy import with_balance_shaft, with_counterweights

OFTEN = (
    "single",
    "v8-cross-plane",
    "vw-vr6",
    "napier-deltic",
    "jumo-205",
    "radial-9",
    "kr250-racer",
)
SELDOM = (
    "i4",
    "sinitsyn-7-second",
    "boxer-6",
    "square-four",
    "napier-lion",
    "man-s90mc-c",
    "audi-25-tfsi",
)
SPREAD = [*OFTEN, *(pytest.param(name, marks=pytest.mark.release) for name in SELDOM)]
EVERY_CHART = pytest.mark.parametrize("name", charts.CHARTS)
TURNING = [name for name, figure in charts.CHARTS.items() if "theta" in figure.options]
PLANES = (
    "crank-star",
    "vector-star",
    "polygon",
    "hodograph",
    "forces",
    "firing-ring",
    "bearing-loads",
)
OVER_A_CYCLE = ("stroke-chart", "firing-ring")


def variants(figure: charts.Figure) -> list[dict[str, Any]]:
    """Options that between them draw all a figure can."""
    out: list[dict[str, Any]] = [{}]
    if "order" in figure.options:
        out += [
            {"order": order, "quantity": quantity}
            for order in (1, 2, 1.5)
            for quantity in figure.quantities
        ]
    elif figure.quantities:
        out += [{"quantity": quantity} for quantity in figure.quantities]
    return [{**one, **({"theta": 0.4} if "theta" in figure.options else {})} for one in out]


def compiled(engine: Engine, figure: charts.Figure) -> None:
    for options in variants(figure):
        sound(charts.saved(figure.draw(engine, **options), "svg", title=engine.name))


def parameters(spec: Any) -> list[dict[str, Any]]:
    """All parameters anywhere in a description."""
    if isinstance(spec, list):
        return [found for one in spec for found in parameters(one)]
    if not isinstance(spec, dict):
        return []
    inner = [found for key, one in spec.items() if key != "params" for found in parameters(one)]
    return [*spec.get("params", []), *inner]


def words_of(picture: bytes) -> str:
    """All that is written in an SVG."""
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", picture.decode()))


def sound(picture: bytes) -> None:
    assert picture.startswith(b"<svg")
    assert not re.search(rb"NaN|undefined", picture)


def huge() -> Engine:
    """A row of 256 cylinders."""
    name = (
        "Two hundred and fifty-six cylinders in one row, which nobody would build, with a "
        "name that goes on and on"
    )
    return inline(Basis(name=name), throws=tuple(0.1 * place for place in range(256)))


@pytest.mark.many(first=12)
@EVERY_CHART
@pytest.mark.parametrize(
    "engine",
    [
        *OFTEN[:4],
        *(pytest.param(name, marks=pytest.mark.release) for name in (*OFTEN[4:], *SELDOM)),
    ],
)
def test_every_figure_can_be_drawn_of_every_kind_of_engine(name: str, engine: str) -> None:
    options = {"theta": 0.4} if "theta" in charts.CHARTS[name].options else {}
    sound(
        charts.saved(
            charts.CHARTS[name].draw(crankstar.load(engine), **options), "svg", title=engine
        )
    )


@pytest.mark.release
@EVERY_CHART
@pytest.mark.parametrize("engine", EVERY_NAME)
def test_every_figure_can_be_drawn_of_the_whole_catalog(name: str, engine: str) -> None:
    compiled(crankstar.load(engine), charts.CHARTS[name])


@pytest.mark.many(first=1)
@EVERY_CHART
def test_figures_of_an_engine_with_balance_shafts_and_weights(name: str) -> None:
    compiled(with_counterweights(lanchester(), factor=0.5), charts.CHARTS[name])


def test_the_unbalances_of_all_balance_shafts_are_in_one_unit() -> None:
    basis = Basis(
        name="twin",
        cycle="four-stroke",
        cylinder=Sizes(stroke=0.08, rod_length=0.14, reciprocating_mass=0.45, rotating_mass=0.0),
    )
    twin = inline(basis, throws=(0.0, 0.0), bore_pitch=0.09)
    for ratio in (-1, 2):
        twin = with_balance_shaft(twin, ratio=ratio, planes=[0.0])
    text = str(charts.CHARTS["balance-shafts"].draw(twin).to_dict())
    assert re.findall(r"unbalance \S+ (\S+ \S+) at", text) == ["kg mm", "kg mm"]
    assert "arms of the weights in mm" in text


@EVERY_CHART
def test_every_figure_takes_the_options_it_is_said_to_take(name: str) -> None:
    figure = charts.CHARTS[name]
    taken = inspect.signature(figure.draw).parameters.values()
    assert sorted(one.name for one in taken if one.kind is one.KEYWORD_ONLY) == sorted(
        figure.options
    )
    assert figure.about
    assert figure.compares == (
        name in ("hodograph", "over-turn", "spectrum", "vector-star", "polygon")
    )


@pytest.mark.many(first=12)
@EVERY_CHART
@pytest.mark.parametrize("engine", ["v8-cross-plane", "i4", "kr250-racer"])
def test_what_depends_on_the_crank_angle_has_one_parameter_for_it_in_degrees(
    name: str, engine: str
) -> None:
    options = {"theta": 0.5} if name in TURNING else {}
    loaded = crankstar.load(engine)
    spec = charts.CHARTS[name].draw(loaded, **options).to_dict()
    found = parameters(spec)
    last = loaded.cycle_angle if name in OVER_A_CYCLE else 360
    assert len(found) == (1 if name in TURNING else 0)
    if found:
        assert spec["params"] == found
        assert found[0]["name"] == "theta"
        assert found[0]["value"] == pytest.approx(np.degrees(0.5))
        assert (found[0]["bind"]["input"], found[0]["bind"]["min"], found[0]["bind"]["max"]) == (
            "range",
            0,
            last,
        )


@pytest.mark.release
@pytest.mark.parametrize(
    "name", [name for name, figure in charts.CHARTS.items() if figure.compares]
)
def test_engines_side_by_side_have_common_axes_and_one_parameter(name: str) -> None:
    engines = [crankstar.load(one) for one in ("v8-cross-plane", "v8-flat-plane", "i4")]
    options = {"order": 2, "quantity": "force"} if name in ("polygon", "vector-star") else {}
    chart = charts.side_by_side(engines, name, **options)
    spec = chart.to_dict()
    assert len(parameters(spec)) == (0 if name == "spectrum" else 1)
    assert len(rows_drawn(spec)) == 2  # two in the first row, one in the second
    domains: dict[Any, set[Any]] = {}
    for panel in panels(spec):
        layer = next(
            one
            for one in panel["layer"]
            if "y" in one.get("encoding", {}) and "field" in one["encoding"]["y"]
        )
        encoding = layer["encoding"]
        scale = (
            *encoding["x"]["scale"]["domain"],
            *encoding["y"]["scale"]["domain"],
            panel["width"],
        )
        title = str(encoding["y"].get("title"))
        domains.setdefault(title, set()).add(scale)
    assert all(len(found) == 1 for found in domains.values()), domains
    assert all(
        engine.name.split(",")[0] in json.dumps(spec, ensure_ascii=False) for engine in engines
    )
    assert charts.saved(chart, "svg", title="three").startswith(b"<svg")


@pytest.mark.parametrize("name", ["vector-star", "polygon"])
def test_engines_of_which_only_one_has_an_offset_are_compared_in_one_unit(name: str) -> None:
    engines = [crankstar.load(one) for one in ("v8-cross-plane", "vw-vr6")]
    spec = charts.side_by_side(engines, name, order=1, quantity="force").to_dict()
    assert " ".join(spec["title"]["text"]).endswith("in m r ω², each in its own m, r and a")


@pytest.mark.many(first=22)
@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("engine", ["v8-cross-plane", "i4", "kr250-racer", "napier-deltic"])
def test_what_shows_geometry_has_equal_scales(name: str, engine: str) -> None:
    shown = 0
    for panel in panels(charts.CHARTS[name].draw(crankstar.load(engine)).to_dict()):
        for layer in panel["layer"]:
            encoding = layer["encoding"]
            if "y" in encoding and "x" in encoding:
                (left, right), (bottom, top) = (encoding[axis]["scale"]["domain"] for axis in "xy")
                assert panel["width"] / (right - left) == pytest.approx(
                    panel["height"] / (top - bottom), rel=1e-4
                )
                shown += 1
    assert shown


@pytest.mark.many(first=12)
@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize(
    "engine", [*ENGINES, "napier-deltic", pytest.param("huge", marks=pytest.mark.release)]
)
@pytest.mark.parametrize("order", [1, pytest.param(2, marks=pytest.mark.release)])
def test_labels_do_not_cover_each_other(name: str, engine: str, order: int) -> None:
    figure = charts.CHARTS[name]
    options: dict[str, Any] = (
        {"order": order, "quantity": "couple"} if "order" in figure.options else {}
    )
    if "theta" in figure.options:
        options["theta"] = 0.35 * order
    chart = figure.draw(huge() if engine == "huge" else crankstar.load(engine), **options)
    for panel, layers in zip(panels(chart.to_dict()), drawn(chart), strict=True):
        boxes = []
        for layer, rows in layers:
            if kind(layer) != "text" or layer["encoding"]["x"].get("field") != "x3":
                continue
            (left, right), (bottom, _) = (
                layer["encoding"][axis]["scale"]["domain"] for axis in "xy"
            )
            scale = panel["width"] / (right - left)
            for row in rows:
                middle = ((row.x3 - left) * scale, (row.y3 - bottom) * scale)
                boxes.append(
                    (
                        middle,
                        text_width(row.text, row.size) / 2,
                        0.5 * row.size * (1 + row.text.count("\n")),
                        row.text,
                    )
                )
        for (one, width, height, text), (other, width2, height2, text2) in combinations(boxes, 2):
            apart = (
                abs(one[0] - other[0]) >= width + width2
                or abs(one[1] - other[1]) >= height + height2
            )
            assert apart, (text, text2)


@pytest.mark.parametrize(
    ("engine", "name", "options", "words"),
    [
        ("i4", "vector-star", {"order": 3}, "no force of order 3"),
        ("i4", "polygon", {"order": 3}, "no force of order 3"),
        ("v8-cross-plane", "hodograph", {"order": 1, "quantity": "force"}, "no force of order 1"),
        ("i4", "over-turn", {}, "no horizontal force"),
        ("boxer-6", "spectrum", {}, "no force"),
        ("napier-lion", "stroke-chart", {}, "The file gives no firing order."),
        ("napier-lion", "firing-ring", {}, "The file gives no firing order."),
    ],
)
def test_nothing_to_draw_is_said(
    engine: str, name: str, options: dict[str, Any], words: str
) -> None:
    picture = charts.saved(
        charts.CHARTS[name].draw(crankstar.load(engine), **options), "svg", title="x"
    )
    assert words in words_of(picture)


@pytest.mark.release
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.release] * (name in ("forces", "vector-star")))
        for name in charts.CHARTS
    ],
)
def test_long_names_are_folded_and_not_cut(name: str) -> None:
    engine = huge()
    picture = charts.saved(charts.CHARTS[name].draw(engine), "svg", title="x")
    assert engine.name in words_of(picture)
    width = float(re.findall(r'viewBox="0 0 (\d+)', picture.decode())[0])
    wide = name in ("forces", "bearing-loads")  # nine cylinders, or four bearings, in a row
    assert width < (840 if wide else 470)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda e: charts.vector_star(e, order=0), "the order is 0; it must be greater than 0"),
        (lambda e: charts.polygon(e, order=-1), "the order is -1"),
        (lambda e: charts.hodograph(e, order=float("nan")), "the order is nan"),
        (lambda e: charts.over_turn(e, orders=[1, 0]), "the order is 0"),
        (
            lambda e: charts.CHARTS["hodograph"].draw(e, quantity="roll"),
            "'roll' is not a quantity of this figure",
        ),
        (
            lambda e: charts.CHARTS["over-turn"].draw(e, quantity="noise"),
            "give one of force, couple, roll, torque",
        ),
        (lambda e: charts.crank_star(e, theta=float("inf")), "the crank angle is inf"),
        (lambda e: charts.force_arrows(e, angles=()), "at least one order and one crank angle"),
        (
            lambda e: charts.side_by_side([e], "shaft"),
            "cannot be drawn side by side; give one of vector-star, polygon, hodograph",
        ),
        (lambda _: charts.side_by_side([], "hodograph"), "no engine is given"),
        (
            lambda e: charts.side_by_side(
                [e, crankstar.load("audi-25-tfsi")], "hodograph", speed=300.0
            ),
            r"have different units \(m r ω², N\)",
        ),
        (
            lambda e: charts.saved(charts.crank_star(e), "gif", title="x"),
            r"'gif'; the file name must end in .svg, .png",
        ),
    ],
)
def test_what_cannot_be_drawn_is_said_in_a_sentence(call: Any, words: str) -> None:
    with pytest.raises(charts.ChartError, match=words):
        call(crankstar.load("i4"))


@pytest.mark.release
def test_a_figure_can_be_saved_in_five_forms() -> None:
    chart = charts.hodograph(crankstar.load("v8-flat-plane"), order=2, theta=0.5)
    beginnings = {"svg": b"<svg", ".PNG": b"\x89PNG", "pdf": b"%PDF", "json": b"{"}
    for suffix, begins in beginnings.items():
        assert charts.saved(chart, suffix, title="a < b").startswith(begins)
    svg = charts.saved(chart, "svg", title="a < b").decode()
    assert "<title>a &lt; b</title>" in svg
    assert "crank angle" not in svg  # nothing is left of the slider
    assert json.loads(charts.saved(chart, "json", title="t"))["description"] == "t"
    page = charts.saved(chart, "html", title="a < b").decode()
    assert "<title>a &lt; b</title>" in page
    assert "vega-lite" in page.split("-->")[0]
    assert "BSD-3-Clause" in page.split("-->")[0]
    assert not re.search(r'<(?:script|link)[^>]*(?:src|href)="', page)


@pytest.mark.release
@pytest.mark.parametrize("engine", ["audi-25-tfsi", "vw-vr6", "kr250-racer", "man-s90mc-c"])
def test_axes_write_numbers_as_the_tables_do(engine: str) -> None:
    shown = crankstar.load(engine)
    drawn_charts = (
        charts.over_turn(shown, speed=600.0),
        charts.spectrum(shown, speed=600.0),
        charts.over_turn(shown),
    )
    for chart in drawn_charts:
        svg = charts.saved(chart, "svg", title="t").decode()
        labels = re.findall(r">−?(\d[\d.,]*)</text>", svg)
        values = {label: float(label.replace(",", "")) for label in labels}
        assert len(labels) > 6
        # below 1e-4 Python writes an exponent, Vega below 1e-6
        plain = {label: value for label, value in values.items() if value == 0 or value >= 1e-4}
        assert [*plain] == [number(value) for value in plain.values()]


@pytest.mark.many(first=1)
@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("name", ["spectrum", "bearing-loads", "polygon"])
def test_letters_of_a_picture_keep_clear_of_the_lines_below_them(
    name: str, theme: charts.themes.ThemeName
) -> None:
    engine = crankstar.load("v8-cross-plane")
    draw = partial(charts.CHARTS[name].draw, engine)
    made = charts.printed(draw, charts.Paper(theme), title="x")
    letters = re.findall(r'<text[^>]*font-size="1[2-9]px"[^>]*stroke="[^"]*"[^>]*>', made.drawing)
    assert len(letters) >= 3
    for letter in letters:
        assert f'stroke="{THEMES[theme].ground}"' in letter
        assert 'paint-order="stroke"' in letter
    page = saved_print(made, "html", title="x").decode()
    style = f'text[stroke="{HALO}"] {{ stroke: {THEMES[theme].ground}; paint-order: stroke }}'
    assert style in page
    assert HALO in saved_print(made, "json", title="x").decode()  # without a ground it is not seen


def test_numbers_are_told_briefly() -> None:
    assert numbers_text([8, 1]) == "1, 8"
    assert numbers_text(list(range(1, 257))) == "1–256"
    assert len(numbers_text(list(range(1, 257, 2)))) < 20


@cache
def vega_lite() -> jsonschema_rs.Validator:
    """The schema that Altair brings, whose names of definitions are no addresses, with others."""
    tree = load_schema()
    names = {json.dumps(name): str(index) for index, name in enumerate(tree["definitions"])}
    tree["definitions"] = {names[json.dumps(n)]: d for n, d in tree["definitions"].items()}
    text = json.dumps(tree)
    for name, index in names.items():
        text = text.replace(f'"#/definitions/{name[1:]}', f'"#/definitions/{index}"')
    return jsonschema_rs.validator_for(json.loads(text))


@pytest.mark.many(first=1)
@pytest.mark.parametrize("engine", ["v2-90", "napier-deltic"])
@pytest.mark.parametrize("name", charts.CHARTS)
def test_every_figure_keeps_to_the_schema_of_vega_lite(name: str, engine: str) -> None:
    chart = charts.CHARTS[name].draw(crankstar.load(engine))
    tree = json.loads(json.dumps(chart.to_dict()))
    vega_lite().validate(tree)
    part = next(key for key in ("layer", "hconcat", "vconcat", "concat", "mark") if key in tree)
    assert not vega_lite().is_valid({**tree, part: {"type": "star"}})


@pytest.mark.release
def test_a_notebook_shows_a_figure_without_a_network_or_by_the_renderer_of_altair() -> None:
    chart = charts.crank_star(crankstar.load("v2-90"))
    own = chart._repr_mimebundle_()
    assert own["application/vnd.vegalite.v6+json"] == chart.to_dict()
    drawing = ElementTree.fromstring(own["image/svg+xml"])  # noqa: S314
    addresses = [v for each in drawing.iter() for k, v in each.attrib.items() if "href" in k]
    assert drawing.tag.endswith("svg")
    assert not any("://" in each for each in addresses)
    with altair.renderers.enable("html"):
        assert "text/html" in chart._repr_mimebundle_()
    with altair.renderers.enable("mimetype"):
        data, *_metadata = chart._repr_mimebundle_()
        of_altair, *_metadata = chart.to_altair()._repr_mimebundle_()
        assert data.keys() == of_altair.keys()
        assert any(shown == chart.to_dict() for shown in data.values())


def test_the_figures_load_their_makers_only_when_they_are_drawn() -> None:
    code = (
        "import sys, crankstar.charts; print([m for m in ('altair', 'vl_convert', 'pandas') "
        "if m in sys.modules])"
    )
    assert (
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        ).stdout.strip()
        == "[]"
    )
