"""No text is cut off, runs out of its box or lies on another, in any language and width."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.web.browsing import watched
from tests.web.engine_page import READY, opened
from tests.web.overflow import overflows
from tests.web.serving import serving

from crankstar.language.messages import LANGUAGES

ENGINE = "v8-cross-plane"
WIDE, MIDDLE, NARROW, NARROWEST = 1440, 1024, 390, 320
RELEASE = pytest.mark.release
SERVED = [
    ("ru", (WIDE, MIDDLE, NARROW)),
    ("en", (WIDE, NARROW)),
    ("ja", (WIDE, NARROW)),
    *(pytest.param(language, (MIDDLE, NARROWEST), marks=RELEASE) for language in LANGUAGES),
]
"""Russian has the longest words."""
FOLDED = ("about", "edit")
"""Tabs with parts that are folded away."""
STEPS = 5
"""Of the guide; behind them is the drawing of the frame."""
SEARCH = ".editor button:has(+ dialog)"
UNFOLD = "document.querySelectorAll('.crankstar details').forEach(one => { one.open = true })"
BREAKAGES = {
    "cut off": ".crankstar .tabs button { width: 40px; overflow: hidden; white-space: nowrap }",
    "below the edge": ".crankstar .now { height: 10px; overflow: hidden }",
    "too long": ".crankstar h1 { width: 60px; white-space: nowrap }",
    "on each other": ".crankstar .tabs button { margin-right: -30px }",
    "sideways": ".crankstar .body { min-width: 2000px }",
}


def touched(page: Page, place: str) -> None:
    """Presses what may lie under something else at this width."""
    page.locator(place).first.dispatch_event("click")


def faults(page: Page, widths: tuple[int, ...]) -> dict[tuple[int, str], list[str]]:
    """What overflows on each tab, in each step of the guide and in the search, by width."""
    tabs = [tab.get_attribute("data-tab") for tab in page.locator("[data-tab]").all()]
    assert len(tabs) >= 10
    found = {}
    for width in widths:
        page.set_viewport_size({"width": width, "height": 900})
        for tab in tabs:
            touched(page, f'[data-tab="{tab}"]')
            if tab == "edit":
                page.locator(".editor .form .field").first.wait_for()
            if tab in FOLDED:
                page.evaluate(UNFOLD)
            found[width, f"tab {tab}"] = overflows(page)
        found |= {(width, place): told for place, told in _overlays(page, tabs)}
    return {place: told for place, told in found.items() if told}


def _overlays(page: Page, tabs: list[str | None]) -> Iterator[tuple[str, list[str]]]:
    if "edit" in tabs:
        touched(page, '[data-tab="edit"]')
        page.locator(SEARCH).wait_for()
        touched(page, SEARCH)
        page.evaluate(UNFOLD)
        yield "search", overflows(page)
        page.evaluate("document.querySelector('dialog[open]').close()")
    touched(page, '[data-tab="orders"]')
    touched(page, ".head .tools button")
    for step in range(1, STEPS + 1):
        yield f"guide {step}", overflows(page)
        if step < STEPS:
            touched(page, ".guide-steps .primary")
    touched(page, ".guide-steps [aria-pressed]")
    yield "frame and signs", overflows(page)
    touched(page, ".guide-head button")


@contextmanager
def served(browser: Browser, language: str, width: int) -> Iterator[Page]:
    complaints: list[str] = []
    with (
        serving(ENGINE, "--lang", language) as server,
        watched(browser, complaints, width=width, height=900) as page,
    ):
        page.goto(f"{server.address}#a=0&theme=light")
        page.evaluate(READY)
        yield page
    assert complaints == []


@pytest.mark.release
@pytest.mark.parametrize(("language", "widths"), SERVED)
def test_nothing_overflows_on_a_served_page(
    language: str, widths: tuple[int, ...], browser: Browser
) -> None:
    with served(browser, language, widths[0]) as page:
        assert faults(page, widths) == {}


@pytest.mark.release
@pytest.mark.parametrize("widths", [(NARROW,), pytest.param((WIDE, NARROWEST), marks=RELEASE)])
def test_nothing_overflows_on_the_page_of_a_file(
    widths: tuple[int, ...], built_page: Callable[..., Path], page: Page
) -> None:
    page.set_viewport_size({"width": widths[0], "height": 900})
    opened(page, built_page(ENGINE))
    for language in LANGUAGES:
        page.evaluate(f"location.hash = 'a=0&lang={language}'")
        page.wait_for_function(f"document.documentElement.lang === '{language}'")
        assert faults(page, widths) == {}, language


@pytest.mark.release
@pytest.mark.parametrize("style", BREAKAGES.values(), ids=BREAKAGES)
def test_a_text_that_overflows_is_found(
    style: str, built_page: Callable[..., Path], page: Page
) -> None:
    opened(page, built_page(ENGINE))
    page.evaluate(
        """style => {
            const sheet = new CSSStyleSheet()
            sheet.replaceSync(style)
            document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet]
        }""",
        style,
    )
    assert overflows(page) != []
