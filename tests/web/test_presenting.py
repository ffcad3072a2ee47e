"""Before an audience, by keys alone, on small screens and on paper."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect
from tests.tools import path_of
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import handle, opened

Build = Callable[..., Path]
ENGINE = "v8-cross-plane"
LETTERS = """() => Math.min(...[...document.querySelectorAll(
        '.now dt, .panel td, .panel p, .time input')]
    .filter(e => e.checkVisibility() && e.getBoundingClientRect().height > 4)
    .map(e => parseFloat(getComputedStyle(e).fontSize) * (e.currentCSSZoom ?? 1)))"""
"""The smallest letters that are shown, in pixels of the screen."""


@pytest.mark.release
def test_a_presentation_is_large_and_without_controls(built_page: Build, page: Page) -> None:
    page.set_viewport_size({"width": 1920, "height": 1080})
    opened(page, built_page(ENGINE), "a=40&tab=orders")
    usual = page.evaluate(LETTERS)
    page.keyboard.press("p")
    assert handle(page, "state").get("present") is True
    for hidden in (".tools", ".layers", ".tabs", ".pace"):
        expect(page.locator(hidden)).to_be_hidden()
    for shown in (".canvas", ".now", ".panel", ".time"):
        expect(page.locator(shown).first).to_be_visible()
    assert page.evaluate(LETTERS) >= max(22, 1.7 * usual)
    assert too_wide(page) == []
    assert barriers(page) == []
    page.keyboard.press("]")
    expect(page.locator("[data-panel]")).not_to_have_attribute("data-panel", "orders")
    page.keyboard.press("[")
    expect(page.locator("[data-panel]")).to_have_attribute("data-panel", "orders")
    page.keyboard.press("Escape")
    expect(page.locator(".tools")).to_be_visible()


@pytest.mark.release
def test_a_link_opens_a_presentation_and_a_button_ends_it(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=40&present=1")
    expect(page.locator(".tools")).to_be_hidden()
    page.get_by_role("button", name="End presentation").click()
    expect(page.locator(".tools")).to_be_visible()
    page.wait_for_function("() => !location.hash.includes('present')")


@pytest.mark.release
def test_a_click_on_the_enlarged_sheet_enlarges_the_view_below_it(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": 1920, "height": 1080})
    opened(page, built_page(ENGINE), "a=40&present=1&camera=sheet")
    side = next(pane for pane in handle(page, "read().panes") if pane["camera"] == "side")
    box = page.locator(".canvas").bounding_box()
    assert box is not None
    scale = page.locator(".canvas").evaluate("e => e.getBoundingClientRect().width / e.clientWidth")
    assert scale > 1.5
    x, y = (side[at] + side[long] / 2 for at, long in (("x", "width"), ("y", "height")))
    page.mouse.click(box["x"] + scale * x, box["y"] + scale * y)
    page.wait_for_function("() => location.hash.includes('camera=side')")


@pytest.mark.release
def test_full_screen_comes_and_goes_by_a_key_and_a_button(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=40")
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement?.matches('.crankstar')")
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement === null")
    page.get_by_role("button", name="Full screen").click()
    page.wait_for_function("() => document.fullscreenElement !== null")
    page.evaluate("() => document.exitFullscreen()")


@pytest.mark.release
def test_the_first_stop_of_the_keyboard_leads_to_the_panels(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=40")
    page.keyboard.press("Tab")
    skip = page.get_by_role("button", name="Skip to the panels")
    expect(skip).to_be_focused()
    box = skip.bounding_box()
    assert box is not None
    assert box["width"] > 100  # it is seen while it has the focus
    page.keyboard.press("Enter")
    expect(page.get_by_role("tab", name="Orders")).to_be_focused()


@pytest.mark.release
def test_a_key_lists_the_keys_and_letters_typed_are_no_keys(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=40")
    page.keyboard.press("?")
    keys = page.get_by_role("dialog", name="Keys")
    expect(keys).to_contain_text("full screen")
    assert barriers(page) == []
    page.keyboard.press("Escape")
    expect(keys).to_have_count(0)
    page.locator(".time .field input").focus()
    page.keyboard.type("p")
    expect(page.locator(".tools")).to_be_visible()


NAMED = """() => [...document.querySelectorAll('.tools > button')].map(button => {
    const name = button.querySelector('span')
    const { width, height } = name.getBoundingClientRect()
    return [name.textContent, width > 15 && height > 8, parseFloat(getComputedStyle(name).fontSize)]
})"""


@pytest.mark.release
@pytest.mark.parametrize("width", [390, 320])
def test_on_a_phone_every_button_in_the_head_shows_its_name(
    width: int, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    opened(page, built_page(ENGINE), "a=40")
    assert too_wide(page) == []
    named = page.evaluate(NAMED)
    assert len(named) == 6
    assert [name for name, shown, size in named if not shown or size < 12] == []


@pytest.mark.release
def test_a_table_says_that_it_scrolls_and_keeps_its_orders(built_page: Build, page: Page) -> None:
    page.set_viewport_size({"width": 320, "height": 640})
    opened(page, built_page(ENGINE), "a=40&tab=orders")
    table = page.locator(".scroller").first
    expect(table).to_contain_text("The table scrolls sideways")
    box = table.locator(".scroll")
    assert box.get_attribute("tabindex") == "0"
    order = table.locator("tbody tr:not(.group) th").first
    before = order.bounding_box()
    box.evaluate("e => { e.scrollLeft = 1000 }")
    expect(table).to_have_class("scroller before")
    assert order.bounding_box() == before
    page.set_viewport_size({"width": 1600, "height": 900})
    expect(table).not_to_contain_text("scrolls")
    assert box.get_attribute("tabindex") is None


@pytest.mark.release
@pytest.mark.parametrize(
    "size", [(844, 390), (720, 450)], ids=["a phone held across", "enlarged to 200 %"]
)
def test_where_it_is_low_the_engine_stands_beside_its_panel(
    size: tuple[int, int], built_page: Build, page: Page
) -> None:
    width, height = size
    page.set_viewport_size({"width": width, "height": height})
    opened(page, built_page(ENGINE), "a=40")
    assert too_wide(page) == []
    stage, panel, play = (
        page.locator(part).first.bounding_box() for part in (".canvas", ".panel", ".play")
    )
    assert stage is not None
    assert panel is not None
    assert play is not None
    assert stage["height"] > 120
    assert panel["x"] >= stage["x"] + stage["width"] - 2
    assert panel["height"] > 200
    assert play["y"] + play["height"] <= height
    assert barriers(page) == []


@pytest.mark.release
@pytest.mark.parametrize("tab", ["orders", "stars"])
def test_it_prints_one_sheet_and_what_else_is_open(
    tab: str, built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ENGINE, figures=True), f"a=40&theme=dark&tab={tab}")
    page.pdf(path=tmp_path / "sheet.pdf", format="A4")
    poppler = Path(path_of("poppler"))
    paper = str(tmp_path / "sheet.pdf")
    subprocess.run(
        [poppler.with_name("pdftoppm"), "-r", "60", "-png", paper, tmp_path / "p"], check=True
    )
    text = subprocess.run(
        [poppler.with_name("pdftotext"), "-layout", "-l", "1", paper, "-"],
        check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    pages = sorted(tmp_path.glob("p-*.png"))
    assert (len(pages) == 1) == (tab == "orders")
    assert "V8, cross-plane crank" in text
    assert "3.1623 ∠ 63.43°" in text
    assert "No secondary couple" in text
    assert "At θ = 40° of 720°" in text
    with Image.open(pages[0]) as sheet:
        pixels = np.asarray(sheet.convert("RGB"), int)
    assert np.median(pixels) == 255  # black on white
    height = len(pixels)
    drawing = pixels[int(0.1 * height) : int(0.38 * height)]
    red = (drawing[..., 0] > 150) & (drawing[..., 1] < 110) & (drawing[..., 2] < 110)
    assert red.mean() > 0.005  # the crankshaft is on paper
    expect(page.locator(".on-paper")).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize("width", [1280, 1440, 1024])
def test_an_audience_needs_not_scroll_the_orders_sideways(
    width: int, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 768})
    opened(page, built_page("radial-9"), "a=40&present=1")
    expect(page.get_by_text("The table scrolls sideways")).to_be_hidden()
    scroller = page.locator(".panel .scroll")
    assert scroller.evaluate("table => table.scrollWidth - table.clientWidth") <= 0
    expect(page.locator("table.orders thead th").nth(2)).to_be_visible()
    assert page.evaluate(LETTERS) >= 16
