"""The server's page and API description in a browser: nothing inline or from elsewhere."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import parse_qs

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.web.browsing import HANG, SETTLED, watched
from tests.web.serving import Server, serving

from crankstar.files.catalog import names

HOSTILE = "</script><img src=x onerror=alert(1)>"
TOURS = re.findall(
    r"state: '([^']+)'",
    (Path(__file__).parents[2] / "web" / "src" / "ui" / "tours.ts").read_text(encoding="utf-8"),
)
JS = "text/javascript"
READY = "() => document.querySelector('[data-crankstar]').crankstar.ready"


def opened(page: Page, server: Server) -> None:
    page.goto(server.address)
    page.evaluate(READY)


@pytest.mark.release
def test_the_page_shows_the_engine_it_was_started_with(page: Page, server: Server) -> None:
    opened(page, server)
    names = page.evaluate(
        "document.querySelector('[data-crankstar]').crankstar.exhibits.map(one => one.name)"
    )
    assert names == ["V8, cross-plane crank, 90 deg"]
    reading = page.evaluate("document.querySelector('[data-crankstar]').crankstar.read()")
    assert len(reading["pistons"]) == 8


@pytest.mark.release
def test_every_panel_opens_under_the_policy_of_the_server(page: Page, server: Server) -> None:
    """The page fixture fails for whatever the policy refuses, because the console reports it."""
    opened(page, server)
    tabs = page.get_by_role("tab").all()
    assert len(tabs) >= 8
    for tab in tabs:
        tab.click()
        page.evaluate(SETTLED, HANG)
    page.get_by_role("tab", name="Derivation").click()
    page.wait_for_selector("math")
    page.get_by_role("tab", name="Stars").click()
    page.wait_for_selector("svg.marks")


@pytest.mark.release
def test_the_script_of_figures_is_read_when_the_first_is_wanted(page: Page, server: Server) -> None:
    """Until then it is not asked for; where it does not come, the figure says so and asks again."""
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    opened(page, server)
    page.evaluate("() => document.querySelector('[data-crankstar]').crankstar.settled()")
    assert any("/app.js" in url for url in asked)
    assert not any("/figures.js" in url for url in asked)
    page.route("**/figures.js*", lambda route: route.fulfill(status=200, body="", content_type=JS))
    page.get_by_role("tab", name="Stars").click()
    failed = page.get_by_text("The script that draws figures cannot be read.").first
    expect(failed).to_be_visible()
    page.unroute("**/figures.js*")
    page.get_by_role("button", name="Try again").first.click()
    expect(page.locator("svg.marks").first).to_be_visible()
    assert page.locator("script").count() == 1, "what has been read is not left in the page"
    before = len([url for url in asked if "/figures.js" in url])
    page.get_by_role("tab", name="Forces").click()
    expect(page.locator("svg.marks").first).to_be_visible()
    assert len([url for url in asked if "/figures.js" in url]) == before, "it is read once"


@pytest.mark.release
def test_a_file_is_handed_out_as_a_download(page: Page, server: Server) -> None:
    opened(page, server)
    with page.expect_download() as waited:
        page.evaluate(
            """() => {
                const link = document.createElement('a')
                link.href = URL.createObjectURL(new Blob(['name = "mine"']))
                link.download = 'mine.toml'
                link.click()
            }"""
        )
    assert waited.value.suggested_filename == "mine.toml"


@pytest.mark.release
def test_a_script_that_is_written_into_the_page_does_not_run(
    browser: Browser, server: Server
) -> None:
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        opened(page, server)
        page.evaluate(
            """() => {
                const part = document.createElement('div')
                part.setAttribute('onclick', 'document.title = "broken"')
                part.click()
            }"""
        )
        assert page.title() != "broken"
    assert len(complaints) == 1
    assert "Content Security Policy directive" in complaints[0]


@pytest.mark.release
def test_a_hostile_name_is_text_on_the_page(page: Page) -> None:
    with serving("i4", "--set", f"name={HOSTILE}") as server:
        opened(page, server)
        assert page.get_by_text(HOSTILE).count() >= 1
        assert page.locator("img[src='x']").count() == 0


@pytest.mark.release
def test_the_api_is_described_without_a_network(page: Page, server: Server) -> None:
    page.goto(server.address + "docs")
    page.wait_for_selector("#operations-engines-exhibit_api_exhibit_post")
    for route in ("exhibit", "chart", "derivation", "fitted", "toml", "read", "search"):
        assert page.get_by_text(f"/api/{route}", exact=True).count() >= 1
    page.locator("#operations-server-health_api_health_get button").first.click()
    page.get_by_role("button", name="Execute").click()
    page.wait_for_selector("text=Server response")
    assert page.get_by_text('"state": "well"').count() >= 1


@pytest.mark.release
def test_the_guide_explains_and_shows_its_examples(page: Page, server: Server) -> None:
    opened(page, server)
    page.locator(".orders .term").first.click()
    expect(page.get_by_role("tooltip")).to_be_visible()
    page.get_by_role("button", name="Guide").click()
    card = page.get_by_role("complementary", name="What am I looking at?")
    card.get_by_role("button", name="Frame and signs").click()
    page.wait_for_function("() => document.querySelector('.frame-and-signs').naturalWidth > 0")
    card.get_by_role("button", name="The guide").click()
    for _ in range(4):
        card.get_by_role("button", name="Next").click()
    card.get_by_role("button", name="Why does a flat-plane V8 buzz?").click()
    expect(page.locator("h1")).to_have_count(2)
    expect(page.locator("h1").nth(0)).to_have_text("V8, flat-plane crank, 90 deg")
    expect(page.locator("h1").nth(1)).to_have_text("V8, cross-plane crank, 90 deg")
    expect(page.get_by_role("tab", name="Compare")).to_have_attribute("aria-selected", "true")
    expect(card).to_have_count(0)


@pytest.mark.parametrize("state", TOURS)
def test_every_example_of_the_guide_is_of_engines_that_there_are(state: str) -> None:
    words = parse_qs(state)
    assert {*words.get("engine", []), *words.get("beside", [])} <= set(names())
    assert "of" in words or words["tab"] == ["sound"]
    assert words.get("of") in (None, ["force"], ["couple"])


@pytest.mark.release
@pytest.mark.parametrize(("language", "word"), [("ja", "判定"), ("ru", "Заключение")])
def test_the_server_tells_of_engines_in_the_language_of_the_page(
    language: str, word: str, page: Page, server: Server
) -> None:
    page.goto(f"{server.address}#engine=harley-45&a=0&tab=about")
    page.evaluate(READY)
    page.evaluate("window.first = true")
    page.locator(f"[data-panel=about] input[value={language}]").click()
    there = "document.querySelector('[data-crankstar]')?.crankstar"
    page.wait_for_function(f"() => !window.first && {there}")  # opened again
    page.evaluate(READY)
    page.locator("[data-tab=verdict]").click()
    verdict = page.get_by_role("tabpanel")
    expect(verdict).to_contain_text(word)
    expect(verdict).not_to_contain_text("force")
    page.locator("[data-tab=edit]").click()
    page.locator(".editor .form .field").first.wait_for()
    labels = page.locator(".editor .form label").all_inner_texts()
    assert not [label for label in labels if re.search("[a-z]{4}", label)]


@pytest.mark.release
def test_an_engine_that_a_link_opens_is_where_its_history_begins(
    page: Page, server: Server
) -> None:
    page.goto(f"{server.address}#engine=harley-45&a=0&tab=edit")
    page.locator(".editor .form .field").first.wait_for()
    expect(page.locator("h1")).to_contain_text("Harley")
    expect(page.get_by_role("button", name="Undo")).to_be_disabled()
