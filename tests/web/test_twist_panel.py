"""The panel Twist and the crank that twists: they show the numbers of the command."""

from __future__ import annotations

import io
import json
import math
import re
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect
from tests import newton
from tests.report.reading import plain
from tests.twisting_engines import CLOCKWISE, COUNTER_CLOCKWISE, FLYWHEEL, twisting
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import CARD, EIGHT, HANDLE, handle, opened
from tests.web.overflow import overflows
from tests.web.serving import Server
from tests.web.test_editing import dropped

from crankstar import cli
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.engine.engine import Engine
from crankstar.files import toml
from crankstar.files.catalog import load
from crankstar.page import exhibition
from crankstar.page.standalone import document
from crankstar.spectra import Real

Told = Callable[..., dict[str, Any]]
READ = (
    "angles => angles.map(a => { const page = HANDLE; page.theta = a; const read = page.read(); "
    "return { pins: read.pins[0], pistons: read.pistons, heat: read.heat } })"
).replace("HANDLE", HANDLE)
FLAT = """const get = HTMLCanvasElement.prototype.getContext
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind === 'webgl2' ? null : get.call(this, kind, ...more)
}"""
"""Chromium as without WebGL."""


@lru_cache
def _contents(engine: Engine) -> str:
    """The page of an engine, without figures and relatives, which take the longest."""
    empty = [{"charts": {}, "derivations": {}}]
    shown = exhibition([engine], relatives=False).model_dump(mode="json")
    return document({"exhibition": shown, "libraries": empty, "fitted": empty})


def written_of(folder: Path, engine: Engine) -> Path:
    path = folder / "engine.html"
    path.write_text(_contents(engine), encoding="utf-8")
    return path


@pytest.fixture
def told(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Told:
    """What `crankstar torsion ... --json` prints of an engine."""

    def run(engine: Engine, *words: str) -> dict[str, Any]:
        place = tmp_path / "engine.toml"
        place.write_text(toml(engine), encoding="utf-8")
        with pytest.raises(SystemExit) as left:
            cli.main(["torsion", str(place), *words, "--json"])
        assert left.value.code in (0, None)
        return json.loads(capsys.readouterr().out)

    return run


def read(page: Page, angles: list[float] = EIGHT) -> list[dict[str, Any]]:
    """What is drawn at each angle (degrees)."""
    return page.evaluate(READ, angles)


def driven(engine: Engine, point: str, speed: float, angles: list[float]) -> tuple[Real, Real]:
    """Turn of each throw, radians, and stress of each shaft at its throws, Pa [.., angle].

    From the whole response, mass by mass: the page is sent a part of it.
    """
    found = torsion(engine, point=point, speed=speed).at
    assert found is not None
    chain = found.chain
    turning = np.exp(1j * np.multiply.outer(found.orders, np.radians(angles)))
    turns = np.real(found.turns[0].T @ turning)[list(chain.throws)]
    stress = [
        np.real(found.torque[0, :, n] @ turning) / (chain.sections[n].modulus or math.nan)
        for n in chain.along
        if "ring" not in chain.section_name(n)
    ]
    return turns, np.array(stress)


def free(engine: Engine, number: int, order: float, angles: list[float]) -> Real:
    """The turn of each throw in a mode whose greatest turn is one degree [throw, angle]."""
    found = torsion(engine)
    shape = found.modes[number - 1].shape
    size = np.radians(1) * shape[list(found.chain.throws)] / np.abs(shape).max()
    return np.multiply.outer(size, np.cos(order * np.radians(angles)))


def checked_places(
    engine: Engine, drawn: list[dict[str, Any]], ahead: Real, sense: int, angles: list[float]
) -> None:
    """Pins and pistons stand where a crank with its throws so far ahead puts them."""
    throws = engine.shafts[0].throws
    for step, (angle, now) in enumerate(zip(angles, drawn, strict=True)):
        for place, (throw, (up, right, _z)) in enumerate(zip(throws, now["pins"], strict=True)):
            bearing = throw.angle + sense * (math.radians(angle) + ahead[place, step])
            off = math.atan2(right, up) - bearing
            assert abs(math.remainder(off, 2 * math.pi)) < 1e-6, (angle, place)
        for cylinder in engine.cylinders:
            turned = np.array([math.radians(angle) + ahead[cylinder.throw - 1, step]])
            _, [[x, y]], _ = newton.placed(engine, cylinder, turned)
            up, right, _z = now["pistons"][str(cylinder.number)]
            assert (right, up) == pytest.approx((float(x), float(y)), abs=1e-6 * throws[0].radius)


@pytest.mark.release
@pytest.mark.parametrize(
    ("name", "sense", "means"),
    [(CLOCKWISE, 1, "webgl"), (COUNTER_CLOCKWISE, -1, "webgl"), (COUNTER_CLOCKWISE, -1, "flat")],
)
def test_each_throw_is_ahead_by_its_turn_times_the_magnification(
    tmp_path: Path, page: Page, name: str, sense: int, means: str
) -> None:
    engine = twisting(name)
    if means == "flat":
        page.add_init_script(FLAT)
    assert (engine.sense > 0) == (sense > 0)
    opened(page, written_of(tmp_path, engine), "a=0&tab=twist&twist.show=forced&twist.times=30")
    assert handle(page, "means") == means
    shown = handle(page, "exhibits[0].torsion.vibrations[0]")
    turns, _stress = driven(engine, shown["point"], shown["speed_rpm"] * math.pi / 30, EIGHT)
    assert 30 * np.abs(turns).max() > 0.02
    checked_places(engine, read(page), 30 * turns, sense, EIGHT)
    page.evaluate("location.hash = 'a=0&tab=twist&twist.show=mode&twist.mode=2&twist.times=7'")
    expect(page.get_by_role("radio", name="twisting in a mode")).to_be_checked()
    order = float(page.get_by_role("combobox", name="Order", exact=True).input_value())
    checked_places(engine, read(page), 7 * free(engine, 2, order, EIGHT), sense, EIGHT)
    met = torsion(engine).modes[1].speed / order * 30 / math.pi
    expect(page.get_by_text(f"times a turn, as at {round(met)} rpm")).to_have_count(1)
    page.get_by_role("radio", name="as it is", exact=True).check()
    checked_places(engine, read(page), np.zeros((len(engine.shafts[0].throws), 8)), sense, EIGHT)


@pytest.mark.release
@pytest.mark.parametrize("name", [CLOCKWISE, COUNTER_CLOCKWISE])
def test_the_colours_of_the_crank_go_with_the_stress(
    tmp_path: Path, page: Page, told: Told, name: str
) -> None:
    engine = twisting(name)
    opened(page, written_of(tmp_path, engine), "a=0&tab=twist&twist.show=forced")
    shown = handle(page, "exhibits[0].torsion.vibrations[0]")
    _turns, stress = driven(engine, shown["point"], shown["speed_rpm"] * math.pi / 30, EIGHT)
    colours = np.array([now["heat"] for now in read(page)]).transpose(1, 0, 2)
    size, light = np.abs(stress).ravel(), (colours @ [0.21, 0.72, 0.07]).ravel()
    order = np.argsort(size)
    assert stress.shape == colours.shape[:2]
    assert np.all(np.diff(light[order]) < 1e-6), "more stress, darker"
    assert np.ptp(light) > 0.3
    point = ["--point", shown["point"]] if shown["point"] else []
    answer = told(engine, "--speed", f"{shown['speed_rpm']!r} rpm", *point)
    most = max(row["stress"] for row in answer["sections_at_speed"] if row["stress"])
    legend = page.locator(".heat-legend").inner_text()
    assert float(re.findall(r"([\d.]+) MPa", legend)[0]) == pytest.approx(most, rel=6e-4)


@pytest.mark.release
def test_the_picture_has_the_colours_that_are_told(tmp_path: Path, page: Page) -> None:
    """The journals between the throws, seen from the side, at the swing of a mode."""
    engine = twisting(CLOCKWISE)
    hidden = "force=0&couple=0&roll=0&glass=0&glow=0"
    state = f"a=0&camera=side&{hidden}&tab=twist&twist.show=mode&twist.mode=2&twist.times=1"
    opened(page, written_of(tmp_path, engine), state)
    now = handle(page, "read()")
    (pane,) = now["panes"]
    scene = handle(page, "exhibits[0].scene")
    z = [throw["z"] for throw in scene["shafts"][0]["throws"]]
    box = page.locator(".stage .canvas").bounding_box()
    assert box
    shot = page.screenshot(clip={**box})
    picture = np.asarray(Image.open(io.BytesIO(shot)).convert("RGB"), float) / 255
    there: list[Real] = []
    for front, rear in pairwise(z):
        across = pane["origin"][0] - pane["scale"] * (front + rear) / 2
        found = picture[round(pane["origin"][1]), round(across)]
        there.append(found / found.max())
    expected = [np.array(each) / max(each) for each in now["heat"][1:-1]]
    assert np.array(there) == pytest.approx(np.array(expected), abs=0.12)
    apart = [np.abs(np.array(a) - b).max() for a, b in pairwise(expected)]
    assert max(apart) > 0.3


@pytest.mark.release
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_a_twisted_throw_is_drawn_where_a_crank_so_far_ahead_has_it(
    tmp_path: Path, page: Page, rotation: str
) -> None:
    """Of a single cylinder the outlines at 40 degrees, 15 ahead, are those at 55 degrees."""
    own = {"inertia": "0.01 kg*m^2", "disc": [FLYWHEEL]}
    changes = {"rotation": rotation, "torsion": own, "firing_order": [1]}
    path = written_of(tmp_path, load("single", changes=changes))
    hidden = "camera=front&force=0&couple=0&roll=0&glass=0&glow=0&tab=twist&twist.times=20"
    ahead = math.degrees(20 * free(load("single", changes=changes), 1, 1.0, [40.0])[0, 0])
    assert ahead > 15
    page.add_init_script(CARD)

    def outlines(angle: float, show: str) -> Any:
        opened(page, path, f"a={angle:.9f}&{hidden}&twist.show={show}")
        box = page.locator(".stage .canvas").bounding_box()
        assert box
        picture = np.asarray(Image.open(io.BytesIO(page.screenshot(clip={**box}))).convert("RGB"))
        return (np.abs(picture.astype(int) - picture[-1, -1].astype(int)).max(axis=-1) > 40)[60:]

    twisted = outlines(40, "mode")
    off = [np.mean(twisted != outlines(40 + way * ahead, "still")) for way in (1, 0, -1)]
    assert off[0] < 0.1 * min(off[1:]), off


def cells(page: Page, title: str) -> list[list[str]]:
    """The rows of a table of the panel by its title, heads first."""
    table = page.locator(".torsion-of section.table", has=page.get_by_role("heading", name=title))
    return table.locator("table").first.evaluate(
        "table => [...table.rows].map(row => [...row.cells].map(cell => cell.textContent))"
    )


def numbers(row: list[str]) -> list[float]:
    """The numbers of a row."""
    return [float(plain(cell)) for cell in row]


@pytest.mark.release
def test_every_number_of_the_panel_is_that_of_the_command(
    tmp_path: Path, page: Page, told: Told
) -> None:
    engine = twisting(CLOCKWISE)
    opened(page, written_of(tmp_path, engine), "a=0&tab=twist")
    answer = told(engine)
    _heads, *rows = cells(page, "Natural frequencies")
    for row, mode in zip(rows, answer["modes"], strict=False):
        expected = (mode["mode"], mode["frequency_hz"], 60 * mode["frequency_hz"])
        assert numbers(row[:3]) == pytest.approx(expected, rel=1e-5)
    options = (
        page.get_by_role("combobox", name="Mode", exact=True).locator("option").all_inner_texts()
    )
    assert [float(each.split(": ")[1].split()[0]) for each in options] == pytest.approx(
        [mode["frequency_hz"] for mode in answer["modes"]], rel=6e-4
    )
    page.get_by_text("Every critical speed").click()
    fold = page.locator("details.amplitudes", has_text="Every critical speed")
    rows = fold.locator("tbody tr").evaluate_all(
        "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))"
    )
    keys = ("mode", "order", "speed_rpm", "vector_sum", "torque", "equilibrium_deg")
    assert len(rows) == len(answer["criticals"]) > 20
    for row, critical in zip(rows, answer["criticals"], strict=True):
        assert numbers(row) == pytest.approx([critical[key] for key in keys], rel=6e-5, abs=1e-9)
    shown = handle(page, "exhibits[0].torsion.vibrations")
    for place, each in enumerate(shown):
        page.get_by_role("combobox", name="Driven at").select_option(str(place))
        between = "%" in each["point"]  # of two points by the speed
        words = [] if between else ["--point", each["point"]]
        own = told(engine, *words, "--speed", f"{each['speed_rpm']!r} rpm")["sections_at_speed"]
        _heads, *rows = cells(page, "Vibration at")
        by_name = {row[0]: row[1:] for row in rows}
        for section in own:
            values = [section[key] for key in ("torque", "torque_sum", "stress", "stress_sum")]
            told_numbers = numbers([cell for cell in by_name[section["name"]] if cell.strip()])
            known = [value for value in values if value is not None]
            assert told_numbers == pytest.approx(known, rel=6e-5)


@pytest.mark.release
def test_an_engine_without_torsion_says_what_to_add(built_page: Any, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=twist&twist.show=mode")
    expect(page.locator("p.needs")).to_contain_text("give the table [torsion] in the engine file")
    expect(page.get_by_role("radio", name="as it is", exact=True)).to_have_count(0)
    assert handle(page, "read().heat") == []


@pytest.mark.release
def test_without_a_driving_force_there_are_modes_and_the_torque_in_them(
    tmp_path: Path, page: Page
) -> None:
    bare = {key: value for key, value in FLYWHEEL.items() if key != "diameter"}
    own = {"inertia": "0.03 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [bare]}
    engine = load("i6", changes={"torsion": own})
    opened(page, written_of(tmp_path, engine), "a=90&tab=twist&twist.show=mode")
    expect(page.get_by_role("radio", name="twisting as it is driven")).to_have_count(0)
    expect(page.locator(".heat-legend")).to_contain_text("Torque at 1°")
    expect(page.get_by_text("It swings once a turn")).to_have_count(1)
    heat = handle(page, "read().heat")
    assert len(heat) == 7
    # at a quarter of a swing nothing is twisted, and what is not known is grey
    assert all(colour == pytest.approx(heat[1], abs=1e-3) for colour in heat[1:])
    assert np.ptp(heat[0]) < 0.1 < np.ptp(heat[1])


@pytest.mark.release
def test_what_is_chosen_of_the_twist_is_reached_by_keys_and_linked(
    tmp_path: Path, page: Page
) -> None:
    path = written_of(tmp_path, twisting(COUNTER_CLOCKWISE))
    opened(page, path, "a=30&tab=twist")
    page.get_by_role("radio", name="as it is", exact=True).focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("radio", name="twisting in a mode")).to_be_checked()
    slider = page.get_by_role("slider", name="Magnification")
    slider.focus()
    before = slider.get_attribute("aria-valuetext")
    page.keyboard.press("PageUp")
    assert slider.get_attribute("aria-valuetext") != before
    page.get_by_role("combobox", name="Mode", exact=True).select_option("3")
    page.wait_for_function(
        "() => ['twist.show=mode', 'twist.mode=3', 'twist.times=']"
        ".every(each => location.hash.includes(each))"
    )
    drawn = handle(page, "read().pins[0]")
    opened(page, path, page.evaluate("location.hash.slice(1)"))
    assert handle(page, "read().pins[0]") == drawn


@pytest.mark.release
def test_an_edited_engine_twists_as_edited_with_its_figures(page: Page, server: Server) -> None:
    page.goto(f"{server.address}#a=30&tab=twist&twist.show=mode&twist.mode=2")
    expect(page.locator("p.needs")).to_be_visible()
    for stiffness in ("0.6 MN*m/rad", "0.3 MN*m/rad"):
        engine = twisting(CLOCKWISE, stiffness=stiffness)
        dropped(page, toml(engine))
        expect(page.get_by_role("tab", name="Edit")).to_have_attribute("aria-selected", "true")
        page.get_by_role("tab", name="Twist").click()
        mode = torsion(engine).modes[1]
        frequency = f"2: {mode.frequency:.4g} Hz"
        chosen = page.get_by_role("combobox", name="Mode", exact=True).locator("option:checked")
        expect(chosen).to_have_text(frequency)
        order = page.get_by_role("combobox", name="Order", exact=True).input_value()
        star = page.locator(f'figure[data-chart="torsion-star:orders={order}:quantity=mode-2"]')
        expect(star).to_have_attribute("aria-busy", "false")
        expect(star.locator("svg, canvas").first).to_be_visible()
        for figure in ("torsion-modes", "campbell", "torsion-response:quantity=stress"):
            drawn = page.locator(f'figure[data-chart="{figure}"]')
            expect(drawn).to_have_attribute("aria-busy", "false")
            expect(drawn.locator(".wait")).to_have_count(0)
        angles = [30.0]
        ahead = 10 * free(engine, 2, float(order), angles)
        checked_places(engine, read(page, angles), ahead, 1, angles)


@pytest.mark.release
@pytest.mark.parametrize(("width", "scheme"), [(390, "light"), (320, "dark"), (1280, "dark")])
def test_the_panel_is_read_by_everyone_on_every_screen(
    tmp_path: Path, page: Page, width: int, scheme: Any
) -> None:
    page.set_viewport_size({"width": width, "height": 800})
    page.emulate_media(color_scheme=scheme)
    path = written_of(tmp_path, twisting(CLOCKWISE))
    for show in ("mode", "forced"):
        opened(page, path, f"a=30&tab=twist&twist.show={show}")
        assert too_wide(page) == []
        assert overflows(page) == []
        assert barriers(page) == []
