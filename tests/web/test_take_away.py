"""What a reader takes away: pictures, films, tables, files, the code of a frame."""

from __future__ import annotations

import csv
import io
import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence
from playwright.sync_api import Locator, Page, expect
from tests.web.browsing import HANG, barriers, too_wide
from tests.web.engine_page import CARD, READY, handle, opened, written_of
from tests.web.serving import Server

from crankstar import files
from crankstar.files import catalog

Build = Callable[..., Path]
ENGINE = "v8-cross-plane"
NAME = "V8, cross-plane crank, 90 deg"
SVG = "{http://www.w3.org/2000/svg}"
STAGE = (
    "() => { const s = document.querySelector('.canvas'); return [s.clientWidth, s.clientHeight] }"
)
HEAD = 50
"""Height of the head of a picture, in pixels of the page."""
SEEN = """async data => {
    const video = document.createElement('video')
    video.muted = true
    video.src = URL.createObjectURL(await (await fetch(data)).blob())
    await new Promise((done, failed) => {
        video.onloadeddata = done
        video.onerror = () => failed(video.error)
    })
    const canvas = document.createElement('canvas')
    canvas.width = 160, canvas.height = 120
    const to = canvas.getContext('2d', { willReadFrequently: true })
    const frames = []
    for (const frame of [0, 1, 23]) {
        await new Promise(done => {
            video.requestVideoFrameCallback(done) // when it is presented
            video.currentTime = (frame + 0.5) / 24 * video.duration
        })
        to.drawImage(video, 0, 0, 160, 120)
        frames.push([...to.getImageData(0, 0, 160, 120).data])
    }
    return { seconds: video.duration, width: video.videoWidth, frames }
}"""


def dialog(page: Page) -> Locator:
    """The dialog of the page, opened by its key."""
    page.keyboard.press("e")
    shown = page.get_by_role("dialog", name="Export")
    expect(shown).to_be_visible()
    return shown


def taken(page: Page, button: Locator, folder: Path) -> Path:
    """The file that a button saves."""
    with page.expect_download(timeout=HANG) as download:
        button.click()
    place = folder / download.value.suggested_filename
    download.value.save_as(place)
    return place


def ink(picture: Image.Image) -> float:
    """The share of a picture that is not as its upper left corner."""
    pixels = np.asarray(picture.convert("RGB"), int)
    return float((np.abs(pixels - pixels[0, 0]).max(axis=2) > 24).mean())


@pytest.mark.release
def test_the_stage_is_saved_sharp_with_its_name_and_angle(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    page.add_init_script(CARD)
    page.set_viewport_size({"width": 1000, "height": 560})
    opened(page, built_page(ENGINE), "a=40&camera=side&glow=0")
    width, height = page.evaluate(STAGE)
    before = handle(page, "read().pistons")
    window = dialog(page)
    sizes = {}
    for density in (2, 4):
        place = taken(page, window.locator(f"[data-file=png-{density}]"), tmp_path)
        assert place.name == f"v8-cross-plane-crank-90-deg-side-40deg-{density}x.png"
        with Image.open(place) as picture:
            sizes[density] = picture.size
            assert 0.03 < ink(picture) < 0.7
            # the head is written, and nothing reaches into it
            assert 0.005 < ink(picture.crop((0, 0, picture.width, HEAD * density - 4))) < 0.2
    for density, size in sizes.items():
        assert size == pytest.approx((density * width, density * (height + HEAD)), abs=1)
    assert handle(page, "read().pistons") == before


@pytest.mark.release
def test_a_dark_ground_is_chosen_apart_from_the_page(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE), "a=40&theme=light")
    window = dialog(page)
    window.get_by_role("radio", name="dark").check(force=True)
    with Image.open(taken(page, window.locator("[data-file=png-2]"), tmp_path)) as picture:
        assert int(np.asarray(picture.convert("RGB"))[1, 1].max()) < 40
    background = page.evaluate(
        "() => getComputedStyle(document.querySelector('.crankstar')).backgroundColor"
    )
    assert background == "rgb(251, 251, 250)"


@pytest.mark.release
def test_the_svg_of_a_sheet_has_every_part_and_no_style(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE), "a=40&whirl=200")
    place = taken(page, dialog(page).locator("[data-file=svg]"), tmp_path)
    assert place.name == "v8-cross-plane-crank-90-deg-sheet-40deg.svg"
    root = ET.parse(place).getroot()  # noqa: S314  # our own file
    assert root.findtext(f"{SVG}title") == NAME
    texts = [element.text for element in root.iter(f"{SVG}text")]
    assert NAME in texts
    assert "Sheet, θ = 40° of 720°" in texts
    groups = [element.get("aria-label", "") for element in root.iter(f"{SVG}g")]
    views = [name for name in groups if name.startswith("view ")]
    assert sorted(views) == ["view front", "view isometric", "view plan", "view side"]
    pistons = [name for name in groups if name.startswith("piston ")]
    assert {*pistons} == {f"piston {number}" for number in range(1, 9)}
    assert len(pistons) == 8 * len(views)
    assert "arrows" in groups
    drawn = place.read_text(encoding="utf-8")
    assert "NaN" not in drawn
    assert not re.search(r"style=|<style|<script|href=|rgb\(", drawn)


@pytest.mark.release
def test_the_svg_puts_pistons_where_the_stage_has_them(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    """From the front, by the middle of each piston's outline, to a pixel."""
    opened(page, built_page(ENGINE), "a=77&camera=front&force=0&couple=0&roll=0")
    read = handle(page, "read()")
    [pane] = read["panes"]
    place = taken(page, dialog(page).locator("[data-file=svg]"), tmp_path)
    root = ET.parse(place).getroot()  # noqa: S314
    middles = {}
    for group in root.iter(f"{SVG}g"):
        name = group.get("aria-label", "")
        if name.startswith("piston "):
            numbers = re.findall(r"[-\d.]+", group[0].get("d", ""))
            points = np.array(numbers, float).reshape(-1, 2)
            middles[name.split()[1]] = (points.min(axis=0) + points.max(axis=0)) / 2
    assert middles.keys() == read["pistons"].keys()
    # of one bank, for the pin is not in the middle of its piston
    for one, other in (("1", "3"), ("2", "4"), ("1", "7"), ("6", "8")):
        (up1, right1, _), (up2, right2, _) = read["pistons"][one], read["pistons"][other]
        on_stage = np.array([right2 - right1, up1 - up2]) * pane["scale"]
        assert middles[other] - middles[one] == pytest.approx(on_stage, abs=1.0)


@pytest.mark.release
def test_figures_and_tables_of_the_panel_are_saved(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE, figures=True), "a=40&tab=stars&theme=dark")
    page.wait_for_selector("figure svg")
    window = dialog(page)
    window.get_by_role("radio", name="light").check(force=True)
    place = taken(page, window.get_by_role("button", name="Crank star: SVG"), tmp_path)
    assert place.name == "v8-cross-plane-crank-90-deg-stars-crank-star-40deg.svg"
    root = ET.parse(place).getroot()  # noqa: S314
    shown = page.locator("figure svg").first.evaluate("svg => svg.querySelectorAll('text').length")
    texts = [*root.iter(f"{SVG}text")]
    assert len(texts) == shown > 4
    # letters have a fallback of their own, and are dark on the light ground
    assert all("sans-serif" in text.get("font-family", "") for text in texts)
    assert not [text for text in texts if text.get("fill") in ("#ececea", "currentColor")]
    picture = taken(page, window.get_by_role("button", name="Crank star: PNG"), tmp_path)
    with Image.open(picture) as image:
        assert min(image.size) > 400
        assert np.asarray(image.convert("RGB"))[2, 2].tolist() == [255, 255, 255]
        assert 0.005 < ink(image) < 0.5
    page.keyboard.press("Escape")
    page.get_by_role("tab", name="Orders").click()
    table = taken(page, dialog(page).get_by_role("button", name="Orders: CSV"), tmp_path)
    rows = [*csv.reader(io.StringIO(table.read_text(encoding="utf-8-sig")))]
    assert rows[0] == ["", "order", "path", "greatest", "vertical", "horizontal"]
    couple = next(row for row in rows if row[0].startswith("Couple"))
    assert couple[1:5] == ["1", "circle with the crank", "3.1623", "3.1623 ∠ 63.43°"]


@pytest.mark.release
def test_every_table_to_take_away_has_a_name_of_its_own(
    page: Page, built_page: Callable[..., Path]
) -> None:
    opened(page, built_page(ENGINE, figures=True), "a=40")
    for tab in page.get_by_role("tab").all():
        tab.click()
        shown = dialog(page).locator("ul.exports li > span").all_inner_texts()
        names = [text.removeprefix("Table: ") for text in shown if text.startswith("Table: ")]
        assert len({*names}) == len(names)
        assert not [name for name in names if re.fullmatch(r"(table)?( \d+)?", name.lower())]
        page.keyboard.press("Escape")


@pytest.mark.release
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_the_amplitudes_are_those_of_analyze(rotation: str, page: Page, tmp_path: Path) -> None:
    tree = {**catalog.tree_of(ENGINE)[1], "rotation": rotation}
    tree.pop("firing_order")  # which is possible in one sense only
    file = tmp_path / "engine.json"
    file.write_text(json.dumps(tree), encoding="utf-8")
    opened(page, written_of(tmp_path, files.engine_of(tree)))
    place = taken(page, dialog(page).locator("[data-file=amplitudes]"), tmp_path)
    ours = _amplitudes(place.read_text(encoding="utf-8-sig"))
    told = subprocess.run(
        [sys.executable, "-m", "crankstar", "analyze", file, "--csv"],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    theirs = _amplitudes(told)
    both = {key for key in theirs if key[1] != "axis_moment"}
    assert both <= ours.keys()
    assert len(both) > 30
    for key in both:
        assert abs(ours[key] - theirs[key]) < 1e-9, key
    assert max(map(abs, theirs.values())) > 1


def _amplitudes(text: str) -> dict[tuple[float, str, str], complex]:
    found = {}
    for row in csv.DictReader(io.StringIO(text)):
        size, phase = float(row["amplitude"]), np.radians(float(row["phase_deg"]))
        key = float(row["order"]), row["quantity"], row["direction"]
        found[key] = complex(size * np.exp(1j * phase))
    return found


def small(page: Page, path: Path, state: str, *, seconds: float) -> Locator:
    """The dialog over a small stage, so that a film of so many seconds is made soon."""
    page.set_viewport_size({"width": 700, "height": 520})
    page.add_init_script(CARD)
    opened(page, path, state)
    window = dialog(page)
    window.get_by_label("Seconds").fill(str(seconds))
    return window


@pytest.mark.release
@pytest.mark.parametrize("kind", ["webm", pytest.param("mp4", marks=pytest.mark.release)])
def test_a_film_is_one_turn_that_ends_where_it_began(
    kind: str, built_page: Build, page: Page, tmp_path: Path
) -> None:
    # about its top dead centre a single moves as fast before as after
    state = "a=40&camera=front&glow=0&force=0&couple=0&roll=0"
    window = small(page, built_page("single"), state, seconds=0.8)
    button = window.locator(f"[data-file={kind}]")
    if kind == "mp4" and button.count() == 0:
        pytest.skip("this browser records no MP4")
    place = taken(page, button, tmp_path)
    assert place.name == f"single-cylinder-engine-front-turn.{kind}"
    data = f"data:video/{kind};base64,{_base64(place)}"
    blank = tmp_path / "blank.html"
    blank.write_text("<title>a film</title>")
    page.goto(blank.as_uri())
    seen = page.evaluate(SEEN, data)
    assert seen["seconds"] == pytest.approx(0.8, abs=0.02)
    assert seen["width"] > 300
    first, second, last = (np.array(frame, float) for frame in seen["frames"])
    assert first.std() > 10
    step = np.abs(second - first).mean()
    assert 0 < np.abs(first - last).mean() < 1.5 * step


def _base64(place: Path) -> str:
    from base64 import b64encode

    return b64encode(place.read_bytes()).decode()


@pytest.mark.release
def test_a_gif_is_the_turn_without_a_seam_and_the_page_is_as_before(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    window = small(page, built_page(ENGINE), "a=40&camera=front", seconds=0.6)
    place = taken(page, window.locator("[data-file=gif]"), tmp_path)
    assert handle(page, "theta") == pytest.approx(40)
    assert not handle(page, "playing")
    with Image.open(place) as film:
        assert film.info["loop"] == 0
        frames = [np.asarray(frame.convert("L"), float) for frame in ImageSequence.Iterator(film)]
        assert len(frames) == 12
        assert film.info["duration"] == 50
    step = [
        np.abs(one - other).mean()
        for one, other in zip(frames, [*frames[1:], frames[0]], strict=True)
    ]
    assert min(step) > 0
    assert step[-1] < 2 * float(np.median(step))


@pytest.mark.release
def test_a_film_can_be_cancelled(built_page: Build, page: Page) -> None:
    window = small(page, built_page(ENGINE), "a=40&camera=front", seconds=30)
    window.locator("[data-file=gif]").click()
    expect(window.get_by_role("progressbar")).to_be_visible()
    window.get_by_role("button", name="Cancel").click()
    expect(window.get_by_role("status")).to_have_text("Cancelled.")
    expect(window.get_by_role("progressbar")).to_have_count(0)
    expect(window.locator("[data-file=gif]")).to_be_enabled()
    assert handle(page, "theta") == pytest.approx(40)


@pytest.mark.release
def test_two_engines_stand_side_by_side_in_a_picture(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE, "single"), "a=40&camera=front")
    place = taken(page, dialog(page).locator("[data-file=svg]"), tmp_path)
    root = ET.parse(place).getroot()  # noqa: S314
    labels = [group.get("aria-label", "") for group in root.iter(f"{SVG}g")]
    assert sum(label.startswith("engine ") for label in labels) == 2
    assert sum(label.startswith("piston ") for label in labels) == 9


@pytest.mark.release
def test_the_engine_file_is_saved_and_commands_write_the_rest(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE))
    window = dialog(page)
    place = taken(page, window.get_by_role("button", name="JSON"), tmp_path)
    saved = json.loads(place.read_text(encoding="utf-8"))
    assert saved == handle(page, "exhibits[0].file")
    commands = window.locator("code").all_inner_texts()
    assert f"crankstar export {place.name} -o {place.stem}.glb" in commands
    assert f"crankstar report {place.name} -o {place.stem}-report.html" in commands


@pytest.mark.release
def test_a_file_page_works_in_a_frame_at_the_view_of_its_code(
    built_page: Build, page: Page
) -> None:
    path = built_page(ENGINE)
    opened(page, path, "a=40&tab=verdict&camera=front")
    code = dialog(page).get_by_role("textbox", name="Code of the frame").input_value()
    assert unescape(code).count(f'src="{path.name}#a=40&camera=front&tab=verdict"') == 1
    around = path.with_name("around.html")
    around.write_text(f"<!DOCTYPE html><title>around</title>{code}", encoding="utf-8")
    page.goto(around.as_uri())
    frame = page.frame_locator("iframe")
    expect(frame.get_by_role("tab", name="Verdict")).to_have_attribute("aria-selected", "true")
    expect(frame.locator(".time .field input")).to_have_value("40")
    expect(frame.locator(".canvas canvas").first).to_be_visible()


@pytest.mark.release
def test_the_server_sends_files_and_cannot_be_framed(
    server: Server, page: Page, tmp_path: Path
) -> None:
    page.goto(f"{server.address}#a=30&camera=front")
    page.evaluate(READY)
    window = dialog(page)
    solids = taken(page, window.locator("[data-file=glb]"), tmp_path)
    assert solids.name == "v8-cross-plane-30deg.glb"
    assert solids.read_bytes()[:4] == b"glTF"
    sheet = taken(page, window.locator("[data-file=xlsx]"), tmp_path)
    assert sheet.name == "v8-cross-plane.xlsx"
    report = taken(page, window.locator("[data-file=report]"), tmp_path)
    assert report.name == "v8-cross-plane-report.html"
    assert NAME in report.read_text(encoding="utf-8")
    expect(window.get_by_role("textbox", name="Code of the frame")).to_have_value(
        re.compile("v8-cross-plane.html")
    )
    heads = server.ask("").heads
    assert "frame-ancestors 'none'" in heads["content-security-policy"]


@pytest.mark.release
def test_the_dialog_is_for_everyone(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE, figures=True), "a=40&tab=stars")
    page.get_by_role("button", name="Export").focus()
    page.keyboard.press("Enter")
    window = page.get_by_role("dialog", name="Export")
    expect(window).to_be_visible()
    found = {"light": barriers(page)}
    page.set_viewport_size({"width": 320, "height": 640})
    found["narrow"] = [*barriers(page), *too_wide(page)]
    page.emulate_media(color_scheme="dark")
    found["dark"] = barriers(page, "color-contrast")
    assert {name: told for name, told in found.items() if told} == {}
    page.keyboard.press("Escape")
    expect(window).to_have_count(0)
    expect(page.get_by_role("button", name="Export")).to_be_focused()
