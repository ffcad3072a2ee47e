"""The drawing sheet: four views in line and to one scale, each enlarged at a click, the section."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Position, ViewportSize, expect
from tests.web.engine_page import CARD, FRAMES, drawn, farthest_off, handle, opened

from crankstar.files.catalog import load, names

Build = Callable[..., Path]
ENGINE = "v8-flat-plane"
STAGE = "canvas[role=img]"
WIDE: ViewportSize = {"width": 1440, "height": 900}
PHONE: ViewportSize = {"width": 390, "height": 844}
WRITTEN = """(() => {
  const { fillText, clearRect } = CanvasRenderingContext2D.prototype
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
    const size = this.measureText(text)
    const box = [x - size.actualBoundingBoxLeft, y - size.actualBoundingBoxAscent,
                 x + size.actualBoundingBoxRight, y + size.actualBoundingBoxDescent]
    ;(this.canvas.texts ??= []).push([text, box])
    fillText.call(this, text, x, y)
  }
  CanvasRenderingContext2D.prototype.clearRect = function (...rect) {
    this.canvas.texts = []
    clearRect.apply(this, rect)
  }
})()"""
"""Texts are kept with the canvas they are written on, each with its box, pixels."""
TEXTS = "() => document.querySelector('.canvas canvas[aria-hidden]').texts"
CANVAS = """() => [
  document.querySelector('.canvas').clientHeight,
  document.querySelectorAll('input[name$=camera][value=sheet]').length]"""
"""Height of the stage, and whether the sheet can be chosen."""
OFTEN = ("v8-cross-plane",)


def panes(page: Page) -> dict[str, dict[str, Any]]:
    """The views on the stage by camera."""
    return {pane["camera"]: pane for pane in handle(page, "read().panes")}


def colliding(texts: list[tuple[str, list[float]]], width: float, height: float) -> list[str]:
    """Texts that overlap or leave the stage."""
    out = [
        text for text, (x1, y1, x2, y2) in texts if x1 < 0 or y1 < 0 or x2 > width or y2 > height
    ]
    for (one, a), (other, b) in combinations(texts, 2):
        across = min(a[2], b[2]) - max(a[0], b[0])
        upward = min(a[3], b[3]) - max(a[1], b[1])
        if across > 0.5 and upward > 0.5:
            out.append(f"{one} | {other}")
    return out


@pytest.mark.release
def test_a_wide_page_opens_with_four_views_to_one_scale_and_in_line(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size(WIDE)
    opened(page, built_page(ENGINE), "a=40")
    shown = panes(page)
    assert set(shown) == {"isometric", "plan", "front", "side"}
    front, side, plan = (shown[name] for name in ("front", "side", "plan"))
    assert front["scale"] == pytest.approx(side["scale"], rel=1e-12)
    assert plan["scale"] == pytest.approx(side["scale"], rel=1e-12)
    assert (front["y"], front["height"]) == pytest.approx((side["y"], side["height"]))
    assert (plan["x"], plan["width"]) == pytest.approx((side["x"], side["width"]))
    assert farthest_off(load(ENGINE), drawn(page)) < 1e-6


@pytest.mark.release
def test_a_click_on_a_view_enlarges_it_and_another_one_goes_back(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size(WIDE)
    opened(page, built_page(ENGINE), "a=40")
    for camera in ("front", "plan", "side", "isometric"):
        pane = panes(page)[camera]
        middle: Position = {"x": pane["x"] + pane["width"] / 2, "y": pane["y"] + pane["height"] / 2}
        page.locator(STAGE).click(position=middle)
        handle(page, "settled()")
        assert handle(page, "state.camera") == camera
        assert set(panes(page)) == {camera}
        expect(page.get_by_role("radio", name=camera, exact=False).first).to_be_checked()
        page.locator(STAGE).click(position=middle)
        handle(page, "settled()")
        assert len(panes(page)) == 4


@pytest.mark.release
def test_on_a_phone_one_view_is_seen_and_a_swipe_shows_the_next(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size(PHONE)
    opened(page, built_page(ENGINE), "a=40")
    assert set(panes(page)) == {"isometric"}
    expect(page.get_by_role("radio", name="Sheet")).to_have_count(0)
    swipe = """(canvas, [from, to]) => {
        const place = { pointerType: 'touch', isPrimary: true, bubbles: true, clientY: 200 }
        canvas.dispatchEvent(new PointerEvent('pointerdown', { ...place, clientX: from }))
        canvas.dispatchEvent(new PointerEvent('pointerup', { ...place, clientX: to }))
    }"""
    seen = []
    for _ in range(4):
        page.locator(STAGE).evaluate(swipe, [300, 120])
        handle(page, "settled()")
        seen += list(panes(page))
    assert sorted(seen) == ["front", "isometric", "plan", "side"]
    page.locator(STAGE).evaluate(swipe, [120, 300])
    handle(page, "settled()")
    assert list(panes(page)) == [seen[2]]


@pytest.mark.release
def test_a_section_leaves_out_what_is_before_it_and_says_where_it_is(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CARD)
    page.add_init_script(WRITTEN)
    page.set_viewport_size(WIDE)
    path = built_page(ENGINE)
    opened(page, path, "a=40&force=0&couple=0")
    slider = page.get_by_label("Section")
    slider.focus()
    seen = [page.locator(STAGE).screenshot()]
    for numbers in ("1 · 2", "3 · 4", "5 · 6", "7 · 8"):
        page.keyboard.press("ArrowRight")
        handle(page, "settled()")
        texts = [text for text, _ in page.evaluate(TEXTS)]
        assert f"Section A–A: cylinders {numbers}" in texts
        assert texts.count("A") == 4, "both ends of the line in plan and side view"
        picture = page.locator(STAGE).screenshot()
        assert picture not in seen
        seen.append(picture)
    assert handle(page, "state.section") == 4
    assert handle(page, "theta") == pytest.approx(40), "the key belongs to the slider"
    opened(page, path, "a=40&force=0&couple=0&camera=front&section=4")
    assert [text for text, _ in page.evaluate(TEXTS)][:2] == ["7", "8"]


@pytest.mark.release
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in OFTEN else pytest.mark.release)
        for name in sorted(names())
    ],
)
def test_no_label_of_the_sheet_collides(name: str, built_page: Build, page: Page) -> None:
    page.add_init_script(WRITTEN)
    page.set_viewport_size(WIDE)
    path = built_page(name)
    for state in ("a=40", "a=40&section=1", "a=40&camera=front", "a=40&camera=isometric"):
        opened(page, path, state)
        box = page.locator(STAGE).bounding_box()
        assert box
        texts = page.evaluate(TEXTS)
        assert texts
        assert colliding(texts, box["width"], box["height"]) == [], state


@pytest.mark.release
@pytest.mark.parametrize("camera", ["sheet", "front", "isometric"])
def test_the_paths_of_the_whirl_stand_beside_the_engine_and_say_how_much_is_exaggerated(
    camera: str, built_page: Build, page: Page
) -> None:
    page.add_init_script(WRITTEN)
    page.set_viewport_size(WIDE)
    opened(page, built_page(ENGINE), f"a=40&camera={camera}&whirl=250")
    stage = page.locator(STAGE).bounding_box()
    inset = page.locator(".canvas canvas[aria-hidden]").nth(1)
    box = inset.bounding_box()
    assert stage
    assert box
    for pane in panes(page).values():
        assert stage["x"] + pane["x"] + pane["width"] <= box["x"]
    texts = [text for text, _ in inset.evaluate("canvas => canvas.texts")]
    assert texts[-1] == "exaggerated × 250"


@pytest.mark.release
def test_on_a_phone_the_paths_of_the_whirl_stand_beside_the_engine_too(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size(PHONE)
    opened(page, built_page(ENGINE), "a=40&whirl=250")
    stage = page.locator(STAGE).bounding_box()
    box = page.locator(".canvas canvas[aria-hidden]").nth(1).bounding_box()
    assert stage
    assert box
    (pane,) = panes(page).values()
    assert stage["x"] + pane["x"] + pane["width"] <= box["x"]


@pytest.mark.release
@pytest.mark.parametrize("language", [pytest.param("en", marks=pytest.mark.release), "ru"])
def test_a_window_of_any_height_comes_to_rest(language: str, built_page: Build, page: Page) -> None:
    """The switches of the sheet take the height that decides whether there is a sheet."""
    page.set_viewport_size({"width": 1280, "height": 900})
    opened(page, built_page("v8-flat-plane"), f"a=0&lang={language}")
    views = set()
    for height in range(900, 600, -20):
        page.set_viewport_size({"width": 1280, "height": height})
        before = page.evaluate(CANVAS)  # once the page has settled
        page.evaluate(FRAMES, 4)
        assert page.evaluate(CANVAS) == before, height
        views.add(before[1])
    assert views == {0, 1}
