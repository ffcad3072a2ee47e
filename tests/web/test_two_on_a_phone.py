"""Two engines on a phone and on paper: nothing cut off, nothing over something else."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from tests.front_end import WEB
from tests.tools import path_of
from tests.web.browsing import too_wide
from tests.web.engine_page import opened

import crankstar

Build = Callable[..., Path]
ONE, OTHER = "v8-flat-plane", "v8-cross-plane"
WRITTEN = """const fill = CanvasRenderingContext2D.prototype.fillText
window.writings = []
CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
  const { a, e, f } = this.getTransform()
  const { actualBoundingBoxLeft: left, actualBoundingBoxRight: right,
    actualBoundingBoxAscent: up, actualBoundingBoxDescent: down } = this.measureText(text)
  const box = this.canvas.getBoundingClientRect()
  window.writings.push({ text, canvas: [this.canvas.width, this.canvas.height],
    left: a * (x - left) + e, right: a * (x + right) + e,
    top: a * (y - up) + f, bottom: a * (y + down) + f })
  fill.call(this, text, x, y)
}"""
"""Keeps each label that is written on a canvas, with its box in pixels."""
ACROSS = """() => {
  const { top, bottom } = document.querySelector('.stages').getBoundingClientRect()
  const panel = document.querySelector('.panels').getBoundingClientRect()
  const card = document.querySelector('.guide').getBoundingClientRect()
  return [panel.top - bottom, card.top - panel.top]
}"""


def writings(page: Page) -> list[dict[str, Any]]:
    return page.evaluate("() => window.writings")


@pytest.mark.release
@pytest.mark.parametrize("camera", ["front", "isometric", "orbit"])
@pytest.mark.parametrize("width", [390, 320])
def test_labels_of_two_small_stages_keep_clear_of_edges_and_each_other(
    width: int, camera: str, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 844 if width == 390 else 640})
    page.add_init_script(WRITTEN)
    opened(page, built_page(ONE, OTHER), f"a=40&camera={camera}")
    labels = writings(page)
    numbers = [label for label in labels if re.fullmatch(r"[\d ·…]+", label["text"])]
    assert len(numbers) >= 4
    for label in numbers:
        across, _ = label["canvas"]
        assert 4 <= label["left"] < label["right"] <= across - 4, label
        assert label["top"] >= 0, label
    axes = [one for one in labels if one["text"] in ("x right", "y up", "z front")]
    scales = [one for one in labels if "ω" in one["text"]]
    assert len(axes) >= 6
    lowest = max(one["bottom"] for one in axes)
    assert lowest + 3 <= min(one["top"] for one in scales)


@pytest.mark.release
def test_the_words_of_the_whirl_have_room_in_every_language(built_page: Build, page: Page) -> None:
    page.set_viewport_size({"width": 320, "height": 640})
    page.add_init_script(WRITTEN)
    for language in ("en", "ja", "ru"):
        page.goto("about:blank")
        opened(page, built_page(ONE, OTHER), f"a=40&whirl=1&lang={language}")
        inset = [one for one in writings(page) if one["canvas"][0] <= 140]
        assert len(inset) >= 8
        for label in inset:
            across, high = label["canvas"]
            assert -0.5 <= label["left"] < label["right"] <= across + 0.5, label
            assert label["bottom"] <= high, label


@pytest.mark.release
def test_a_figure_that_is_too_wide_says_that_it_scrolls(built_page: Build, page: Page) -> None:
    page.set_viewport_size({"width": 320, "height": 640})
    opened(page, built_page(OTHER, figures=True), "a=40&tab=remedies")
    figure = page.locator(".figure:not(.empty)").first
    figure.scroll_into_view_if_needed()
    expect(figure).to_contain_text("The figure scrolls sideways")
    assert figure.locator(".scroll").get_attribute("tabindex") == "0"
    assert too_wide(page) == []
    page.set_viewport_size({"width": 1600, "height": 900})
    expect(figure).not_to_contain_text("scrolls")


@pytest.mark.release
def test_two_engines_are_printed_on_one_sheet(
    built_page: Build, page: Page, tmp_path: Path
) -> None:
    opened(page, built_page(ONE, OTHER), "a=40&tab=orders")
    paper = tmp_path / "sheet.pdf"
    page.pdf(path=paper, format="A4")
    poppler = Path(path_of("poppler"))
    text = subprocess.run(
        [poppler.with_name("pdftotext"), "-layout", paper, "-"],
        check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    assert text.count("\f") == 1
    assert "At θ = 40° of 720°" in text
    assert text.count("Layout") == 2


def test_the_drawing_of_the_frame_has_the_forces_of_the_stage() -> None:
    drawing = (Path(crankstar.__file__).parent / "report" / "frame.svg").read_text("utf-8")
    stage = (WEB / "src" / "stage" / "palette.ts").read_text("utf-8")
    forces = [colour.lower() for colour in re.findall(r"\bforce: 0x(\w{6})", stage)]
    assert re.findall(r"\.force \{ color: #(\w{6})", drawing) == forces


@pytest.mark.release
def test_the_guide_opens_the_panel_it_speaks_of_and_goes_back(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    opened(page, built_page(OTHER), "a=40&tab=cylinders")
    page.get_by_role("button", name="Guide").click()
    panel = page.locator("[data-panel]")
    for _ in range(3):
        expect(panel).to_have_attribute("data-panel", "cylinders")
        page.locator(".guide-steps .primary").click()
    expect(panel).to_have_attribute("data-panel", "orders")
    below, above = page.evaluate(ACROSS)
    assert below >= -1  # not behind the stage
    assert above > 40  # nor behind the card
    page.locator(".guide-steps .primary").click()
    expect(panel).to_have_attribute("data-panel", "verdict")
    page.locator(".guide-head button").click()
    expect(panel).to_have_attribute("data-panel", "cylinders")


@pytest.mark.release
@pytest.mark.parametrize(("width", "height"), [(320, 640), (812, 375)])
def test_the_choice_of_views_keeps_its_room_beside_the_section(
    width: int, height: int, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": height})
    opened(page, built_page(ONE), "a=40&camera=front")
    expect(page.locator(".layers .section")).to_be_visible()
    box = page.locator(".cameras").bounding_box()
    assert box
    assert box["width"] > 200
