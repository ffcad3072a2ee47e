"""The exhibit of an engine: analysis, tables, figures and derivations by key, the file."""

from __future__ import annotations

import gzip
import json
import re
from base64 import b64decode, b64encode
from fractions import Fraction
from hashlib import sha256
from html.parser import HTMLParser
from math import radians
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, reject, settings
from hypothesis import strategies as st
from tests.catalog import EVERY_ENGINE
from tests.newton import road
from tests.strategies import OF_ANY_KIND, RELEASE, engines

from crankstar.analyses.strokes import RECORD as STROKES
from crankstar.charts import CHARTS, ChartError
from crankstar.derive import DerivationError
from crankstar.derive import derivation as derived
from crankstar.derive.documents import html_parts
from crankstar.engine import motion
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import unfit
from crankstar.engine.records import Shaft, Weight
from crankstar.files import EngineFileError, engine_of
from crankstar.files.catalog import load, names, tree_of
from crankstar.mechanics.balance import balance, scales
from crankstar.mechanics.excitation import Reference
from crankstar.page import exhibit, exhibition, fitted
from crankstar.page import standalone as page
from crankstar.page import widget as notebook
from crankstar.page.figures import NoSuchKeyError, chart, derivation
from crankstar.page.keys import BEFORE_AND_AFTER
from crankstar.page.library import held, packed
from crankstar.page.records import Exhibit, Exhibition, Vectors
from crankstar.page.standalone import PageError, document
from crankstar.remedy.counterweights import with_web_weights
from crankstar.remedy.fitting import recommended
from crankstar.tables.balance_orders import answer
from crankstar.tables.machine import tree as public_tree

SOME = [
    "v8-cross-plane",
    "audi-25-tfsi",
    "pratt-whitney-wasp",
    "kr250-racer",
    "jumo-205",
    "vw-vr6",
    "single",
]
HOSTILE = "</script><img src=x onerror=alert(1)>\"'&--><!--<script>"


def told(name: str) -> Exhibit:
    return exhibit(load(name), relatives=False)


@pytest.mark.release
def test_the_speed_of_the_page_is_that_of_the_file_with_and_without_masses() -> None:
    with_speed = [engine for engine in map(load, names()) if engine.speed is not None]
    massless = [engine for engine in with_speed if "mass" in engine.relative]
    assert massless
    for engine in [*massless[:6], *with_speed[:3]]:
        shown = exhibit(engine, relatives=False)
        assert shown.speed_rpm == pytest.approx((engine.speed or 0) * 30 / np.pi)
        assert (shown.units.force == "N") is {"mass", "radius"}.isdisjoint(engine.relative)


@pytest.mark.release
def test_engines_in_different_units_are_compared_by_their_first_cylinders() -> None:
    engine = load("audi-25-tfsi")
    in_newtons, relative = (
        told("audi-25-tfsi"),
        exhibit(engine.model_copy(update={"speed": None}), relatives=False),
    )
    assert relative.units.force == "m r ω²"
    assert (relative.scale.force, relative.scale.couple) == (1.0, 1.0)
    for quantity in ("force", "couple"):
        vectors = [getattr(shown.total, quantity).forward for shown in (in_newtons, relative)]
        scaled = np.array(vectors[0]) / getattr(in_newtons.scale, quantity)
        assert scaled == pytest.approx(np.array(vectors[1]), abs=1e-12)
    assert in_newtons.scale.length == engine.throw(engine.first).radius
    assert told("v8-cross-plane").scale.length == 1.0


@pytest.mark.release
def test_the_strokes_have_the_same_colours_on_the_stage_and_in_the_chart() -> None:
    engine = load("v8-cross-plane")
    colours = exhibition([engine], relatives=False).stroke_colours
    marks = json.dumps(CHARTS["stroke-chart"].draw(engine).to_dict())
    for colour in (colours.intake, colours.exhaust, colours.power):
        red, green, blue = (int(colour[place : place + 2], 16) for place in (1, 3, 5))
        assert f"rgba({red}, {green}, {blue}, " in marks


def at(vectors: Vectors, orders: tuple[float, ...], sense: int, theta: Any) -> Any:
    """A vector of the clock plane at one crank angle or many, summed as records.py describes."""
    parts = zip(orders, vectors.forward, vectors.backward, strict=True)
    return sum(
        complex(*f) * np.exp(1j * sense * k * theta) + complex(*b) * np.exp(-1j * sense * k * theta)
        for k, f, b in parts
    )


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", SOME)
def test_the_sums_are_those_of_the_public_answer(name: str) -> None:
    engine, shown = load(name), told(name)
    public = public_tree(answer(engine, balance(engine, speed=engine.speed), orders=shown.orders))
    assert shown.orders == tuple(row["order"] for row in public["orders"])
    for place, row in enumerate(public["orders"]):
        for quantity in ("force", "couple"):
            found = getattr(shown.total, quantity)
            largest = max(abs(complex(*pair)) for pair in (*found.forward, *found.backward)) or 1.0
            for way in ("forward", "backward"):
                assert getattr(found, way)[place] == pytest.approx(
                    tuple(row[quantity][way]), abs=1e-8 * largest
                )


@pytest.mark.release
@settings(max_examples=200 if RELEASE else 3)
@given(engines(known=True), st.floats(0, 12))
def test_arrows_are_what_the_bodies_do_but_for_orders_that_are_left_out(
    engine: Engine, theta: float
) -> None:
    """Total, and piston, rod and big end of each cylinder, by momentum.

    Momentum has all orders; those that the page omits are subtracted.
    """
    certain = {"speed": 1.0, "provenance": {}}  # ranges at random make impossible engines
    shown = exhibit(engine.model_copy(update=certain), relatives=False)
    walked = road(engine, reference=Reference(0.0), speed=1.0)
    turns = round(float(walked.theta[1] * len(walked.theta) / (2 * np.pi)))
    number = len(walked.theta)
    largest = max(float(np.abs(push.force).max()) for push in walked.pushes)

    def of(chosen: list[int]) -> complex:
        force = np.sum(
            [walked.pushes[i].force[:, 1] + 1j * walked.pushes[i].force[:, 0] for i in chosen],
            axis=0,
        )
        spectrum = np.fft.fft(force.astype(complex)) / number
        orders = np.fft.fftfreq(number, 1 / number) / turns
        kept = np.any(np.isclose(np.abs(orders)[:, None], np.array(shown.orders)), axis=1)
        return complex(np.sum(spectrum[kept] * np.exp(1j * orders[kept] * theta)))

    everything = of(list(range(len(walked.bodies))))
    assert (
        abs(at(shown.total.force, shown.orders, shown.sense, theta) - everything) < 1e-7 * largest
    )
    for cylinder in shown.cylinders:
        own = [i for i, body in enumerate(walked.bodies) if body.cylinder == cylinder.number]
        expected = of(own) if own else 0.0
        assert abs(at(cylinder.force, shown.orders, shown.sense, theta) - expected) < 1e-7 * largest


@pytest.mark.many(first=4)
@EVERY_ENGINE
def test_orders_that_are_left_out_are_not_missed(name: str) -> None:
    """The page's force, couple and roll are the negative rates of change of momentum, to 0.1 %.

    Also where all the lower orders are in balance, and where two cranks turn against each other.
    """
    engine = load(name).model_copy(update={"speed": 1.0})
    shown, place = exhibit(engine, relatives=False), balance(engine).reference
    walked = road(engine, reference=place, speed=1.0)
    theta = walked.theta.astype(float)
    scale, _ = scales(engine, 1.0)

    def summed(values: list[np.ndarray], size: float, floor: float) -> tuple[np.ndarray, float]:
        told = np.sum(values, axis=0)
        told = (told - told.mean()) * size
        return told, max(
            float(np.abs(told).max()),
            floor * size * max(float(np.abs(one).max()) for one in values),
        )

    pushes = walked.pushes
    force, most = summed(
        [push.force[:, 1] + 1j * push.force[:, 0] for push in pushes], scale.force, 1e-6
    )
    assert (
        np.abs(at(shown.total.force, shown.orders, shown.sense, theta) - force).max() < 1e-3 * most
    )
    # a moment about the axis to the right is minus the couple up, one about the vertical the couple
    # to the right
    couple, most = summed(
        [-push.moment[:, 0] + 1j * push.moment[:, 1] for push in pushes], scale.couple, 1e-6
    )
    assert np.abs(
        at(shown.total.couple, shown.orders, shown.sense, theta) - couple
    ).max() < 1e-3 * max(most, 1e-9)
    roll, most = summed(
        [-push.moment[:, 2] - shown.sense * push.torque for push in pushes], scale.moment, 1e-6
    )
    told = sum(
        np.real(complex(*pair) * np.exp(1j * k * theta))
        for k, pair in zip(shown.orders, shown.total.roll, strict=True)
    )
    assert np.abs(told - roll).max() < 1e-3 * most


def test_without_a_pitch_what_lies_along_the_shaft_is_counted_as_it_is_drawn() -> None:
    """A triple whose middle lies two pitches before z = 0.

    Places are in the unit of the scene, the couple in that of the file.
    """
    engine = load("triple-120")
    throws = tuple(
        throw.model_copy(update={"z": throw.z + 2.0}) for throw in engine.shafts[0].throws
    )
    shaft = engine.shafts[0].model_copy(update={"throws": throws})
    cylinders = tuple(
        cylinder.model_copy(update={"z": cylinder.z + 2.0}) for cylinder in engine.cylinders
    )
    shown = exhibit(
        engine.model_copy(update={"shafts": (shaft,), "cylinders": cylinders}), relatives=False
    )
    places = {cylinder.number: cylinder.z for cylinder in shown.scene.cylinders}
    pitch = places[1] - places[2]
    assert pitch > 2.0  # crank radii: a bore is as wide as the stroke
    assert {part.number: part.z for part in shown.cylinders} == pytest.approx(places)
    assert (shown.reference_z, shown.whirl.centre[2]) == pytest.approx((places[2], places[2]))
    assert (shown.units.couple, shown.couple_length) == ("m r ω² a", pytest.approx(pitch))
    for place, order in enumerate(
        shown.orders
    ):  # a round bar tilts along the couple, which is by `pitch` greater in crank radii
        for way in ("forward", "backward"):
            couple = np.array(getattr(shown.total.couple, way)[place]) * pitch
            tilt = np.array(getattr(shown.whirl.tilt, way)[place])
            assert tilt == pytest.approx(-couple / (shown.whirl.inertia[0] * order**2), abs=1e-12)


def test_turns_bring_every_shaft_and_the_firing_back() -> None:
    engine = load("i4")
    slow = Shaft(
        name="slow", speed_ratio=Fraction(-2, 3), weights=(Weight(unbalance=0.1, angle=0.0, z=0.0),)
    )
    shown = exhibit(engine.model_copy(update={"shafts": (*engine.shafts, slow)}), relatives=False)
    ratios = [Fraction(shaft.speed_ratio).limit_denominator(1000) for shaft in shown.scene.shafts]
    back = [
        turns
        for turns in range(1, 20)
        if turns % 2 == 0 and all((turns * ratio).denominator == 1 for ratio in ratios)
    ]
    assert shown.turns == back[0] == 6


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", [*SOME, "bmw-r1200", "v2-90"])
def test_ellipses_of_the_table_are_the_paths_of_the_vectors(name: str) -> None:
    shown = told(name)
    theta = np.linspace(0, 2 * np.pi, 721)
    for row in shown.table:
        if row.quantity not in ("force", "couple"):
            assert row.semi_axes is None
            continue
        place = shown.orders.index(row.order)
        vectors = getattr(shown.total, row.quantity)
        f, b = complex(*vectors.forward[place]), complex(*vectors.backward[place])
        path = f * np.exp(1j * shown.sense * theta) + b * np.exp(-1j * shown.sense * theta)
        assert row.semi_axes is not None
        assert row.semi_axes == pytest.approx(
            (np.abs(path).max(), np.abs(path).min()), abs=6e-3 * (np.abs(path).max() + 1e-12)
        )
        flat = row.semi_axes[1] < 1e-9 * row.semi_axes[0] or row.path == "none"
        if not flat and row.semi_axes[0] > 1.001 * row.semi_axes[1] and row.direction is not None:
            far = path[np.abs(path).argmax()]
            assert abs(np.sin(np.angle(far) - row.direction)) < 0.02


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", SOME)
def test_of_each_quantity_the_greatest_order_comes_first_and_what_is_zero_last(name: str) -> None:
    shown = told(name)
    for quantity in ("force", "couple", "roll", "torque"):
        rows = [row for row in shown.table if row.quantity == quantity]
        signals = getattr(shown.total, quantity)
        sizes = [
            np.hypot(*signals[place])
            if isinstance(signals, tuple)
            else np.hypot(*signals.forward[place]) + np.hypot(*signals.backward[place])
            for place in map(shown.orders.index, (row.order for row in rows))
        ]
        assert len(rows) == len(shown.orders)
        assert [row.remains for row in rows] == [size > 0 for size in sizes]
        assert sizes == sorted(sizes, reverse=True)


@pytest.mark.many(first=2)
@pytest.mark.parametrize("name", SOME)
def test_strokes_are_those_of_the_public_answer(name: str) -> None:
    engine, shown = load(name), told(name)
    if not engine.firing_order:
        assert shown.stroke_windows == ()
        return
    public = public_tree(STROKES.told(engine, STROKES.question.value()))
    windows = {
        (one.chamber, one.stroke): [one.from_deg, one.to_deg - 720 * (one.to_deg > 720)]
        if engine.cycle == "four-stroke"
        else [one.from_deg, one.to_deg - 360 * (one.to_deg > 360)]
        for one in shown.stroke_windows
    }
    expected = {
        (one["number"], stroke): window
        for one in public["cylinders"]
        for stroke, window in one["strokes"].items()
    }
    assert {key: pytest.approx(window) for key, window in windows.items()} == expected
    (table,) = [
        table for table in shown.strokes if table.title.startswith("Strokes and valve events")
    ]
    assert len(table.rows) == len(public["cylinders"])
    assert all(len(row) == len(table.heads) for row in table.rows)


def test_what_a_notebook_says_of_strokes_is_all_there() -> None:
    """No line of the terminal's tables is lost on the way."""
    from crankstar.tables.html import document_html

    engine = load("v8-cross-plane")
    plain = re.sub(
        r"\s+",
        " ",
        re.sub(r"<[^>]+>", " ", document_html(STROKES.told(engine, STROKES.question.value()))),
    )
    shown = told("v8-cross-plane").strokes
    said = " ".join([*(t.title for t in shown), *(line for t in shown for line in t.notes)])
    for words in (
        "Exhaust pulses",
        "Blow-down into an open exhaust",
        "Neighbours that fire in succession",
        "Assumed angles",
    ):
        assert words in plain
        assert words in said


def greatest(vectors: Vectors, place: int) -> float:
    return abs(complex(*vectors.forward[place])) + abs(complex(*vectors.backward[place]))


@pytest.mark.release
def test_the_fitted_engine_is_quiet_in_what_it_was_fitted_for() -> None:
    four, eight = fitted(load("i4")), fitted(load("v8-cross-plane"))
    assert four is not None
    assert eight is not None
    assert greatest(told("i4").total.force, 1) > 1.0
    assert greatest(four.total.force, 1) < 1e-9
    assert greatest(told("v8-cross-plane").total.couple, 0) == pytest.approx(10**0.5, rel=1e-6)
    assert greatest(eight.total.couple, 0) < 1e-9
    assert [shaft.kind for shaft in four.scene.shafts] == [
        "crankshaft",
        "balance shaft",
        "balance shaft",
    ]
    assert [shaft.speed_ratio for shaft in four.scene.shafts] == [1.0, 2.0, -2.0]
    assert any(table.title == "Remaining unbalance" for table in eight.remedies)
    assert fitted(load("i6")) is None
    for shown in (four, eight):  # its file is what one goes on working with
        again = exhibit(engine_of(shown.file), relatives=False)
        assert [(row.label, row.greatest) for row in again.table] == [
            (row.label, row.greatest) for row in shown.table
        ]
        assert [len(shaft.weights) for shaft in again.scene.shafts] == [
            len(shaft.weights) for shaft in shown.scene.shafts
        ]


@pytest.mark.release
@pytest.mark.parametrize(("name", "unit"), [("audi-25-tfsi", "N"), ("i4", "m r ω²")])
def test_figures_are_in_the_units_of_the_numbers_beside_them(name: str, unit: str) -> None:
    assert told(name).units.force == unit
    made = chart(load(name), "over-turn:quantity=force")
    assert made["title"]["text"] == [f"Force over the crank angle, in {unit}"]


@pytest.mark.release
@settings(max_examples=200 if RELEASE else 5)
@given(st.one_of(*OF_ANY_KIND.values()))
def test_any_engine_at_all_has_an_exhibit_and_perhaps_a_fitted_one(engine: Engine) -> None:
    assume(not motion.unreachable(engine) and not unfit(engine))  # as for every engine of a file
    try:
        shown = exhibition([engine], relatives=False)
    except EngineFileError as error:  # ranges of estimates at whose ends it is no engine
        if any(not fault.code.startswith("provenance.wide") for fault in error.faults):
            raise
        reject()
    again = Exhibition.model_validate_json(shown.model_dump_json())
    assert again == shown
    json.loads(json.dumps(shown.model_dump(mode="json"), allow_nan=False))


LARGE = [pytest.param(name, marks=pytest.mark.release) for name in ("v8-cross-plane", "vw-vr6")]


@pytest.mark.release
@pytest.mark.parametrize("name", ["kr250-racer", "single", *LARGE])
def test_every_key_of_an_exhibit_can_be_asked_for(name: str) -> None:
    engine, shown = load(name), told(name)
    assert len({key.key for key in shown.charts}) == len(shown.charts)
    for key in shown.charts:
        made = chart(engine, key.key)
        parameters = {parameter["name"]: parameter for parameter in made.get("params", ())}
        assert ("theta" in parameters) is (key.figure != "spectrum")
        assert all("bind" not in parameter for parameter in parameters.values())
        assert "vega-lite/v6" in made["$schema"]
    for key in shown.derivations:
        made_html = derivation(engine, key.key)
        assert "<math" in made_html
        assert " style=" not in made_html


@pytest.mark.parametrize(
    "key",
    [
        *(
            "",
            "nothing",
            "force:2",
            "../secret",
            "shaft:order=1",
            "crank-star:theta=1",
            "polygon:angle=3",
        ),
        *(
            "polygon:order=x:quantity=force",
            "polygon:quantity=roll",
            "over-turn:quantity=",
            "polygon:order=nan",
            "polygon:order=-1",
        ),
    ],
)
def test_a_figure_that_is_not_there_is_refused_in_a_sentence(key: str) -> None:
    with pytest.raises((NoSuchKeyError, ChartError)) as refused:
        chart(load("i4"), key)
    assert len(str(refused.value)) > 20


def test_before_and_after_stand_on_common_axes() -> None:
    engine = load("v8-cross-plane")
    made = chart(engine, BEFORE_AND_AFTER)
    blocks = [
        [panel["layer"] for panel in column["vconcat"]] for column in made["vconcat"][0]["hconcat"]
    ]
    before_and_after = zip(*blocks, strict=True)
    for pair in before_and_after:
        domains = [
            [layer["encoding"][channel]["scale"]["domain"] for channel in "xy"]
            for layer in (layers[0] for layers in pair)
        ]
        assert domains[0] == domains[1]
    assert [len(block) for block in blocks] == [3, 3]
    heights: list[dict[str, float]] = []
    for values in (layer["data"]["values"] for block in blocks for layer, *_ in block):
        if values and "what" in values[0]:
            heights.append({})
            for row in values:
                heights[-1][row["order"]] = max(row["to"], heights[-1].get(row["order"], 0.0))
    # sqrt(10) turns with the crank and half of the reciprocating mass takes it away; the fourth
    # order stays what it was
    before = next(one for one in heights if one.get("1", 0.0) > 1)
    assert before["1"] == pytest.approx(10**0.5)
    assert any("1" not in one and one["4"] == pytest.approx(before["4"]) for one in heights)
    said = json.dumps(made)
    assert "as it is" in said
    assert "with weights and shafts" in said


@pytest.mark.release
def test_where_nothing_is_fitted_there_is_no_before_and_after() -> None:
    with pytest.raises(NoSuchKeyError, match="needs no counterweights"):
        chart(load("i6"), BEFORE_AND_AFTER)
    assert BEFORE_AND_AFTER not in held([load("i6")])["libraries"][0]["charts"]


@pytest.mark.parametrize(
    "key",
    [
        "",
        "force",
        "force:",
        "force:x",
        "force:0",
        "force:-1",
        "force:1e9",
        "force:1/0",
        "roll:1",
        "force:٢x",
    ],
)
def test_a_derivation_that_is_not_there_is_refused_in_a_sentence(key: str) -> None:
    with pytest.raises((NoSuchKeyError, DerivationError)) as refused:
        derivation(load("i4"), key)
    assert len(str(refused.value)) > 20


@given(st.text(max_size=40))
def test_no_key_at_all_is_answered_with_a_traceback(key: str) -> None:
    engine = load("single")
    for ask in (chart, derivation):
        with pytest.raises((NoSuchKeyError, ChartError, DerivationError)):
            ask(engine, key + "?")


class Reader(HTMLParser):
    """What a browser finds in a page: the elements, and the texts of its scripts."""

    def __init__(self) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self._inside: str | None = None

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        self._inside = tag if tag in ("script", "title") else None
        if tag == "script":
            self.scripts.append("")

    def handle_data(self, data: str) -> None:
        if self._inside == "script":
            self.scripts[-1] += data

    def handle_endtag(self, tag: str) -> None:
        del tag
        self._inside = None


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    return reader


DRAWING = "figures = '</script>'\n"


@pytest.fixture
def small_bundle(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> str:
    """A front-end of a few words that says all that could end a script."""
    script = (
        "const x = '</script>', y = '<!-- <script>', z = `</SCRIPT >`, r = /<\\/script/; "
        "export default {}\n"
    )
    path = tmp_path / "crankstar.js"
    path.write_text(script, encoding="utf-8")
    path.with_name("figures.js").write_text(DRAWING, encoding="utf-8")
    monkeypatch.setattr(page, "BUNDLE", path)
    return script


def hostile() -> Engine:
    return load("i4").model_copy(update={"name": HOSTILE, "source": HOSTILE})


def tree() -> dict[str, Any]:
    shown = exhibition([hostile()], relatives=False).model_dump(mode="json")
    return {"exhibition": shown, "libraries": [{"charts": {}, "derivations": {}}], "fitted": [None]}


@pytest.mark.release
def test_nothing_in_a_name_becomes_an_element_of_the_page(small_bundle: str) -> None:
    found = read(document(tree()))
    tags = [tag for tag, _ in found.elements]
    assert tags.count("script") == 4
    assert "img" not in tags
    assert all(
        not name.startswith("on") and name != "style"
        for _, attributes in found.elements
        for name in attributes
    )
    assert len(found.scripts) == 4
    held_there = json.loads(found.scripts[0])
    assert held_there["encoding"] == "gzip+base64"
    assert json.loads(gzip.decompress(b64decode(held_there["data"]))) == tree()
    assert gzip.decompress(b64decode(found.scripts[1])).decode() == DRAWING
    assert gzip.decompress(b64decode(found.scripts[2])).decode() == small_bundle


@pytest.mark.release
def test_the_policy_allows_its_scripts_alone_and_asks_nothing_of_the_network(
    small_bundle: str,
) -> None:
    text = document(tree())
    found = read(text)
    (policy,) = [
        a["content"]
        for tag, a in found.elements
        if a.get("http-equiv") == "Content-Security-Policy"
    ]
    allowed = [
        f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'"
        for script in (found.scripts[3], small_bundle, DRAWING)
    ]
    assert policy is not None
    assert f"script-src {' '.join(allowed)};" in policy
    assert policy.startswith("default-src 'none';")
    assert "unsafe" not in policy
    assert not re.search(r"https?://", text)
    assert not any({"src", "href"} & attributes.keys() for _, attributes in found.elements)
    (language,) = [a.get("lang") for tag, a in found.elements if tag == "html"]
    assert language == "en"


def test_without_a_bundle_it_is_said_how_to_build_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Any
) -> None:
    monkeypatch.setattr(page, "BUNDLE", tmp_path / "none.js")
    with pytest.raises(PageError, match=r"python web/bundle\.py"):
        document(tree())


@pytest.mark.release
def test_a_file_has_every_figure_and_derivation_of_its_engines_with_it() -> None:
    steps: list[tuple[int, int, str]] = []
    made = held([load("i4")], sources=["i4"], tell=lambda *step: steps.append(step))
    shown = Exhibition.model_validate(made["exhibition"])
    for library, one in (
        (made["libraries"][0], shown.engines[0]),
        (made["fitted"][0], shown.fitted[0]),
    ):
        assert one is not None
        both = {BEFORE_AND_AFTER} if library is made["libraries"][0] else set()
        assert set(library["charts"]) == {key.key for key in one.charts} | both
        assert set(library["derivations"]) == {key.key for key in one.derivations}
    better = recommended(load("i4"))
    assert better is not None
    assert made["libraries"][0]["charts"]["spectrum"] == chart(load("i4"), "spectrum")
    assert made["fitted"][0]["charts"]["spectrum"] == chart(better.after, "spectrum")
    assert [done for done, _, _ in steps] == list(range(steps[0][1]))
    assert len(packed(made)) < 500_000


def test_a_notebook_is_answered_for_the_engine_that_it_asks_about() -> None:
    engines = load("i4"), load("v8-cross-plane")
    subjects = tuple(
        notebook.Subject(engine, tree_of(name)[1], name)
        for engine, name in zip(engines, ("i4", "v8-cross-plane"), strict=True)
    )
    better = recommended(engines[1])
    assert better is not None
    for index, is_fitted, engine in (
        (0, False, engines[0]),
        (1, False, engines[1]),
        (1, True, better.after),
    ):
        question = {
            "id": 3,
            "engine": index,
            "fitted": is_fitted,
            "what": "chart",
            "key": "crank-star",
        }
        assert notebook.answer(subjects, question) == {
            "id": 3,
            "value": chart(engine, "crank-star"),
        }
    for wrong in (
        None,
        [],
        {},
        {**question, "engine": 2},
        {**question, "engine": "x"},
        {**question, "what": "cake"},
    ):
        assert notebook.answer(subjects, wrong)["sentence"].startswith("The notebook cannot answer")


@pytest.mark.release
def test_all_engines_have_a_name_for_every_line_under_it() -> None:
    for name in names():
        shown = told(name)
        assert shown.heading[0].lower().startswith(shown.file.get("cycle", "four-stroke"))
        assert all(line.strip() == line and "\n" not in line for line in shown.heading)
        assert shown.cycle_deg in (360.0, 720.0)
        assert shown.turns * 360 >= shown.cycle_deg
        assert radians(shown.cycle_deg) > 0


def names_of(*engines: Engine, sources: tuple[str, ...] = ()) -> list[tuple[str, Any]]:
    shown = exhibition(engines, sources=sources, relatives=False)
    return [(one.name, one.file["name"]) for one in shown.engines]


@pytest.mark.release
def test_engines_of_one_name_side_by_side_are_told_apart() -> None:
    one, other = load("i4"), load("v2-90").model_copy(update={"name": load("i4").name})
    assert names_of(one, load("v2-90")) == [(name, name) for name in (one.name, load("v2-90").name)]
    assert [name for name, _ in names_of(one, other, sources=("a.toml", "b.toml"))] == [
        f"{one.name} (a.toml)",
        f"{one.name} (b.toml)",
    ]
    assert [name for name, _ in names_of(one, other, sources=("a.toml", "a.toml"))] == [
        f"{one.name} (1)",
        f"{one.name} (2)",
    ]
    assert [name for _, name in names_of(one, other)] == [one.name, one.name]


@pytest.mark.release
def test_the_page_knows_which_weights_turn_with_a_throw() -> None:
    """A file may leave it out; then a weight belongs to the nearest throw."""
    engine = load("v8-cross-plane")
    weighted = with_web_weights(engine, factor=0.5)
    bare = [with_values(weight, throw=None) for weight in weighted.shafts[0].weights]
    shaft = with_values(weighted.shafts[0], weights=tuple(bare))
    for of in (weighted, with_values(weighted, shafts=(shaft,))):
        (numbers,) = exhibit(of, relatives=False).weight_throws
        assert [numbers.count(number) for number in range(1, 5)] == [2, 2, 2, 2]
        assert len(numbers) == len(of.shafts[0].weights)


@pytest.mark.release
@pytest.mark.parametrize("name", ["v8-cross-plane", "napier-deltic", "kr250-racer"])
def test_weights_have_no_part_in_the_derivation_of_an_order_they_do_not_exert(name: str) -> None:
    """Derived for the page without them; here with them, as the command line does."""
    weighted = with_web_weights(load(name), factor=0.4)
    for key, order in (("force:1", 1), ("force:2", 2), ("couple:2", 2), ("couple:4", 4)):
        quantity = "force" if key.startswith("force") else "couple"
        (own,) = html_parts([derived(weighted, order, quantity)])
        assert derivation(weighted, key) == own
        assert (derivation(load(name), key) == own) is (order > 1)
