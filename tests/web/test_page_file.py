"""A page of `crankstar page` opened from disk: small, without network, its own script only."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.web.browsing import watched
from tests.web.engine_page import READY, handle, opened

from crankstar import cli
from crankstar.files.catalog import load
from crankstar.page.standalone import INCOMPLETE, NO_SCRIPT

GREATEST = 2_000_000
"""Bytes of a page."""
Build = Callable[..., Path]


@pytest.mark.release
def test_the_file_of_a_v12_is_small_and_opens(tmp_path: Path, page: Page) -> None:
    place = tmp_path / "v12.html"
    with pytest.raises(SystemExit) as left:
        cli.main(["page", "v12-60", "-o", str(place)])
    assert left.value.code == 0
    assert place.stat().st_size < GREATEST
    opened(page, place, "a=90&tab=stars")
    assert page.title() == load("v12-60").name
    page.wait_for_selector(".vega-embed svg, svg.marks, figure svg")
    assert handle(page, "theta") == 90


@pytest.mark.release
def test_without_scripts_it_says_what_it_needs(browser: Browser, built_page: Build) -> None:
    context = browser.new_context(java_script_enabled=False)
    try:
        quiet = context.new_page()
        quiet.goto(built_page("single").as_uri())
        assert NO_SCRIPT in quiet.inner_text("body")
        assert quiet.inner_text("h1") == load("single").name
    finally:
        context.close()


@pytest.mark.release
def test_no_other_script_runs_in_it_and_nothing_is_loaded(
    browser: Browser, built_page: Build, tmp_path: Path
) -> None:
    """Scripts, handlers, styles and pictures written into the file are refused by its policy."""
    worse = tmp_path / "worse.html"
    injected = (
        "<script>window.broken = 1</script><img src=x onerror='window.broken = 2'><script src='https://example.org/x.js'></script>"
        "<p id=told style='color: rgb(1, 2, 3)'>text</p>"
    )
    text = built_page("single").read_text(encoding="utf-8")
    worse.write_text(text.replace("<noscript>", f"{injected}<noscript>", 1), encoding="utf-8")
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        page.goto(worse.as_uri())
        page.evaluate(READY)
        assert page.evaluate("() => window.broken") is None
        assert (
            page.evaluate("() => getComputedStyle(document.querySelector('#told')).color")
            != "rgb(1, 2, 3)"
        )
        refused = page.evaluate(
            "() => fetch('https://example.org/').then(() => 'loaded', () => 'refused')"
        )
        assert refused == "refused"
    assert any("Content Security Policy" in complaint for complaint in complaints)


@pytest.mark.release
def test_a_file_read_in_another_language_says_how_it_is_written_in_that(
    built_page: Build, page: Page
) -> None:
    place = built_page("single")
    opened(page, place, "a=0&tab=about")
    told = page.get_by_text("--lang")
    assert told.count() == 0
    page.get_by_role("radio", name="Русский").check()
    assert "--lang ru" in told.inner_text()
    verdict = page.get_by_role("tab").filter(has_text="Заключение")
    assert verdict.count() == 1
    assert told.inner_text().startswith("Заключение,"), "a panel is called what its tab is"
    page.get_by_role("radio", name="English").check()
    assert told.count() == 0


@pytest.mark.release
@pytest.mark.parametrize("kept", ["H4sIAAAA", "no base64!"])
def test_a_page_whose_script_is_damaged_says_so_and_is_not_waited_for(
    built_page: Build, page: Page, tmp_path: Path, kept: str
) -> None:
    """The fixture fails for an error that nobody has taken."""
    text = built_page("single").read_text(encoding="utf-8")
    damaged = tmp_path / "damaged.html"
    packed = re.compile(r'(id="crankstar-script">)[^<]+')
    damaged.write_text(packed.sub(rf"\g<1>{kept}", text), encoding="utf-8")
    page.goto(damaged.as_uri())
    outcome = page.evaluate(f"({READY})().then(() => 'ready', () => 'refused')")
    assert outcome == "refused"
    assert INCOMPLETE in page.inner_text("body")


@pytest.mark.release
def test_a_script_may_hold_the_page_before_its_own_script_has_come(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(
        "addEventListener('DOMContentLoaded', () => {"
        " window.held = document.querySelector('[data-crankstar]').crankstar })"
    )
    page.goto(f"{built_page('v8-cross-plane').as_uri()}#a=40")
    assert page.evaluate("async () => { await held.ready; return held.theta }") == 40


@pytest.mark.release
def test_formulas_are_set_in_the_font_that_the_page_carries(built_page: Build, page: Page) -> None:
    opened(page, built_page("single", figures=True), "a=0&tab=derivation")
    page.wait_for_selector(".typeset math")
    page.wait_for_function("() => [...document.fonts].some(font => font.status === 'loaded')")
    faces = page.evaluate("() => [...document.fonts].map(font => font.family)")
    assert [face.strip('"') for face in faces] == ["crankstar math"]
    wide = (
        "family => { const text = document.createElement('span'); text.textContent = 'rω²λψ';"
        " text.style.font = `40px ${family}`; document.body.append(text);"
        " const { width } = text.getBoundingClientRect(); text.remove(); return width }"
    )
    first = page.locator(".typeset math").first.evaluate("it => getComputedStyle(it).fontFamily")
    assert first.split(",")[0].strip('"') == "crankstar math"
    assert page.evaluate(wide, '"crankstar math", monospace') != page.evaluate(wide, "monospace")
