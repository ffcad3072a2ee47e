"""The watch over pages sees what it should: otherwise a test that passes means nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.web.browsing import too_wide, watched


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("script", "complaint"),
    [
        ("console.error('gone wrong')", "console error: gone wrong"),
        ("console.warn('take care')", "console warning: take care"),
        ("setTimeout(() => { throw new Error('broken') })", "error on the page: Error: broken"),
        ("Promise.reject(new Error('unkept'))", "error on the page: Error: unkept"),
        (
            "fetch('https://example.org/data.json').catch(() => 0)",
            "request to elsewhere: https://example.org/data.json",
        ),
        (
            "fetch('http://127.0.0.1.example.org/').catch(() => 0)",
            "request to elsewhere: http://127.0.0.1.example.org/",
        ),
        ("new WebSocket('wss://example.org/live')", "request to elsewhere: wss://example.org/live"),
        (
            "document.body.append(Object.assign(new Image(), {src: 'https://example.org/a.png'}))",
            "request to elsewhere: https",
        ),
        (
            "document.body.append(Object.assign(new Image(), {src: 'missing.png'}))",
            "console error: Failed to load resource",
        ),
    ],
)
def test_what_goes_wrong_on_a_page_is_seen(
    script: str, complaint: str, browser: Browser, tmp_path: Path
) -> None:
    file = tmp_path / "page.html"
    file.write_text(
        f"<!doctype html><title>t</title><body><script>{script}</script>", encoding="utf-8"
    )
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        page.goto(file.as_uri())
    assert any(said.startswith(complaint) for said in complaints), complaints


def test_a_page_that_keeps_to_itself_has_no_complaints(page: Page, tmp_path: Path) -> None:
    (tmp_path / "page.js").write_text(
        "console.log('all well'); fetch('data:text/plain,1'); "
        "fetch(URL.createObjectURL(new Blob(['1'])))"
    )
    file = tmp_path / "page.html"
    file.write_text(
        "<!doctype html><title>t</title><h1>t</h1><script src='page.js'></script>", encoding="utf-8"
    )
    page.goto(file.as_uri())
    assert page.locator("h1").inner_text() == "t"


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("body", "complaints"),
    [
        ("<p>all well</p>", []),
        (
            "<div style='width: 500px'>a</div>",
            ["the page is 500 wide, the window 400", "div reaches from 0 to 500 of 400: a"],
        ),
        (
            "<div style='width: 90px; margin-left: -50px'>a</div>",
            ["div reaches from -50 to 40 of 400: a"],
        ),
        (
            "<p style='overflow: hidden; width: 90px'>Unausgeglichenheit</p>",
            ["p hides a part of what it holds: Unausgeglichenheit"],
        ),
        ("<div style='overflow-x: auto'><div style='width: 500px'>a</div></div>", []),
        ("<div style='position: fixed; left: -90px'><p>a drawer</p></div>", []),
    ],
)
def test_what_is_too_wide_is_seen_unless_it_scrolls_by_itself(
    body: str, complaints: list[str], page: Page
) -> None:
    page.set_viewport_size({"width": 400, "height": 300})
    page.set_content(f"<!doctype html><body style='margin: 0'><main>{body}</main>")
    assert too_wide(page) == complaints


def test_a_page_is_read_only_once_it_has_settled(page: Page) -> None:
    page.set_content("<p>before</p>")
    page.evaluate("""() => {
        const [text] = document.querySelectorAll('p')
        const settled = () => new Promise(
            done => setTimeout(() => done(text.textContent = 'after'), 50))
        text.crankstar = { settled }
    }""")
    assert page.locator("p").inner_text() == "after"
