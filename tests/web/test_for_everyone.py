"""The page for everyone: narrow, wide, light, dark, by keyboard, read aloud, without WebGL."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, Locator, Page, expect
from tests.tools import path_of
from tests.web.browsing import ARGUMENTS, barriers, root, too_wide, watched
from tests.web.engine_page import drawn, farthest_off, handle, opened

from crankstar.files.catalog import load

Build = Callable[..., Path]
ENGINE = "v8-cross-plane"
RULES: dict[Literal["light", "dark"], tuple[str, ...]] = {"light": (), "dark": ("color-contrast",)}
"""All of them, and once more those that depend on colours."""
FOCUSED = """() => {
    const element = document.activeElement
    if (!element || element === document.body) return null
    const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(element)
    const { width, height } = element.getBoundingClientRect()
    const seen = (outlineStyle !== 'none' && parseFloat(outlineWidth) >= 1) || boxShadow !== 'none'
    const label = element.ariaLabel || element.labels?.[0]?.innerText
    const name = (label || element.innerText || element.title || '').trim()
    return { element: element.outerHTML.slice(0, 80), name, seen, there: width * height > 0 }
}"""


def tabs(page: Page) -> list[Locator]:
    return page.get_by_role("tab").all()


@pytest.mark.release
def test_no_panel_reaches_over_an_edge(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE, figures=True))
    found = {}
    for width in (400, 1600):
        page.set_viewport_size({"width": width, "height": 800})
        for tab in tabs(page):
            tab.click()
            found[tab.inner_text(), width] = too_wide(page)
    assert len(found) >= 16
    assert {name: told for name, told in found.items() if told} == {}


@pytest.mark.release
@pytest.mark.parametrize(
    ("language", "width"),
    [
        ("en", 1440),
        ("ja", 390),
        *(
            pytest.param(language, width, marks=pytest.mark.release)
            for language in ("en", "ja", "ru")
            for width in (1440, 1024, 390, 320)
            if (language, width) not in {("en", 1440), ("ja", 390)}
        ),
    ],
)
def test_everything_has_a_name_and_can_be_read(
    language: str, width: int, built_page: Build, page: Page
) -> None:
    """axe-core's rules, contrast of colours among them, on every panel."""
    page.set_viewport_size({"width": width, "height": 900})
    opened(page, built_page(ENGINE, figures=True), f"a=0&lang={language}")
    found = {}
    for colours, rules in RULES.items():
        page.emulate_media(color_scheme=colours)
        for tab in tabs(page):
            tab.click()
            found[tab.inner_text(), colours] = barriers(page, *rules)
    assert len(found) >= 16
    assert {name: told for name, told in found.items() if told} == {}


@pytest.mark.release
@pytest.mark.parametrize(("colours", "brightness"), [("light", (0.8, 1.0)), ("dark", (0.0, 0.2))])
def test_it_is_light_or_dark_as_the_system_is(
    colours: Literal["light", "dark"],
    brightness: tuple[float, float],
    built_page: Build,
    page: Page,
) -> None:
    page.emulate_media(color_scheme=colours)
    opened(page, built_page(ENGINE))
    background = page.evaluate(
        "() => getComputedStyle(document.querySelector('.crankstar')).backgroundColor"
    )
    shade = (
        max(int(part) for part in background.removeprefix("rgb(").removesuffix(")").split(",")[:3])
        / 255
    )
    assert brightness[0] <= shade <= brightness[1]


@pytest.mark.release
def test_by_keyboard_alone(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=0")
    stops = []
    for _ in range(150):
        page.keyboard.press("Tab")
        stop = page.evaluate(FOCUSED)
        if stop is None or (stops and stop == stops[0]):
            break
        stops.append(stop)
    else:
        pytest.fail("the keyboard is caught")
    assert [stop for stop in stops if not (stop["seen"] and stop["there"] and stop["name"])] == []
    names = " / ".join(stop["name"] for stop in stops)
    assert all(name in names for name in ("Play", "Crank angle", "Orders"))


def test_keys_turn_the_engine_and_choose_panels(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=0")
    page.keyboard.press(".")
    assert handle(page, "theta") == pytest.approx(1)
    page.keyboard.press(",")
    assert handle(page, "theta") == pytest.approx(0)
    page.keyboard.press("Space")
    assert handle(page, "playing")
    page.keyboard.press("Space")
    assert not handle(page, "playing")
    first = page.get_by_role("tab").first
    first.focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("tab").nth(1)).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_role("tab").nth(1)).to_have_attribute("aria-selected", "true")


@pytest.fixture
def flat_page(browser: Browser) -> Iterator[Page]:
    """A page in a Chromium that has no WebGL, watched as every page is."""
    complaints: list[str] = []
    own = browser.browser_type.launch(
        executable_path=path_of("chromium"),
        chromium_sandbox=not root(),
        args=[*ARGUMENTS, "--disable-webgl", "--disable-3d-apis"],
    )
    with watched(own, complaints) as page:
        yield page
    own.close()
    assert complaints == []


@pytest.mark.release
def test_without_webgl_it_is_drawn_flat_and_the_panels_work(
    built_page: Build, flat_page: Page
) -> None:
    opened(flat_page, built_page(ENGINE, figures=True))
    assert handle(flat_page, "means") == "flat"
    assert farthest_off(load(ENGINE), drawn(flat_page)) < 1e-6
    for tab in tabs(flat_page):
        tab.click()
        expect(tab).to_have_attribute("aria-selected", "true")
        expect(flat_page.locator("[aria-busy=true]")).to_have_count(0)
    for camera in ("front", "plan", "side", "isometric"):
        flat_page.get_by_role("radio", name=camera).or_(
            flat_page.get_by_role("button", name=camera)
        ).first.click()
