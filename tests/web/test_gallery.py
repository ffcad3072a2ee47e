"""The gallery of the catalog on the server: pictures that turn, filters, ways there and back."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.server.test_watching import RIGHT
from tests.web.browsing import barriers, too_wide, watched
from tests.web.serving import Server, serving

from crankstar.files.catalog import names, summaries
from crankstar.site.miniatures import LOOKS

READY = "() => document.querySelector('[data-crankstar]').crankstar.ready"
DROPPED = """([text, name]) => {
    const files = new DataTransfer()
    files.items.add(new File([text], name))
    for (const kind of ['dragover', 'drop'])
        document.body.dispatchEvent(
            new DragEvent(kind, { dataTransfer: files, bubbles: true, cancelable: true }))
}"""


@pytest.fixture
def gallery(page: Page, server: Server) -> Page:
    page.goto(f"{server.address}gallery")
    expect(page.get_by_label("Search")).to_be_visible()
    return page


@pytest.mark.release
def test_every_engine_of_the_catalog_has_a_card_that_leads_to_it(gallery: Page) -> None:
    links = gallery.locator(".cards a").evaluate_all("all => all.map(a => a.getAttribute('href'))")
    titles = gallery.locator(".cards .title").all_text_contents()
    assert titles == sorted(titles, key=str.casefold)
    every = {f"/#engine={entry.name}": entry.title for entry in summaries()}
    assert len(links) == len(every) == len(titles)
    assert dict(zip(links, titles, strict=True)) == every


@pytest.mark.release
def test_filters_leave_the_engines_that_are_wanted(gallery: Page) -> None:
    gallery.get_by_label("Layout").select_option("vee")
    gallery.get_by_label("Cylinders").select_option("8")
    wanted = [e.title for e in summaries() if (e.layout, e.cylinders) == ("vee", 8)]
    assert gallery.locator(".cards li:visible .title").all_text_contents() == wanted
    assert gallery.locator("output").inner_text() == f"{len(wanted)} / {len(names())}"
    gallery.get_by_label("Search").fill("FORD coyote")
    assert gallery.locator(".cards li:visible .title").all_text_contents() == [
        "Ford Coyote 5.0 V8 (Mustang)"
    ]
    gallery.get_by_label("Search").fill("coyote steam")
    expect(gallery.get_by_text("No engine matches.")).to_be_visible()


@pytest.mark.release
def test_one_goes_to_an_engine_by_keyboard_and_back_to_what_was_left(gallery: Page) -> None:
    gallery.get_by_label("Search").fill("boxer six")
    gallery.locator(".cards li:visible a").focus()
    gallery.keyboard.press("Enter")
    gallery.wait_for_url("**/#engine=boxer-6")
    gallery.evaluate(READY)
    expect(gallery.get_by_role("heading", level=1)).to_have_text("Boxer six")
    gallery.go_back()
    assert gallery.locator(".cards li:visible").count() == 1
    gallery.go_forward()
    gallery.evaluate(READY)
    gallery.get_by_role("link", name="All engines").click()
    gallery.wait_for_url("**/gallery")
    assert gallery.locator(".cards li:visible").count() == len(names())


@pytest.mark.release
def test_pictures_that_are_seen_turn_unless_less_motion_is_wished(gallery: Page) -> None:
    first = gallery.locator("img").first
    expect(first).to_have_js_property("naturalWidth", 240)
    assert sources(gallery, "turning") == []
    gallery.emulate_media(reduced_motion="no-preference", color_scheme="dark")
    gallery.reload()
    shown = f"{gallery.url.split('/gallery')[0]}/pictures/{names()[0]}-dark-turning.webp"
    expect(first).to_have_js_property("currentSrc", shown)
    assert sources(gallery, f"/{names()[-1]}-dark-turning") == []


def sources(page: Page, part: str) -> list[str]:
    """The pictures that are shown and have this in their address."""
    shown = page.locator("img").evaluate_all("all => all.map(one => one.currentSrc)")
    return [address for address in shown if part in address]


@pytest.mark.release
def test_the_gallery_is_for_everyone(gallery: Page) -> None:
    found: dict[str, list[str]] = {}
    for width in (390, 1024):
        for colours in ("light", "dark"):
            gallery.set_viewport_size({"width": width, "height": 800})
            gallery.emulate_media(color_scheme=colours)
            found[f"{width} {colours}"] = [*barriers(gallery), *too_wide(gallery)]
    assert {name: told for name, told in found.items() if told} == {}


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize(("language", "heading"), [("ja", "エンジン"), ("ru", "Двигатели")])
def test_the_gallery_speaks_other_languages(
    page: Page, server: Server, language: str, heading: str
) -> None:
    page.goto(f"{server.address}gallery?lang={language}")
    expect(page.get_by_role("heading", level=1)).to_have_text(heading)
    page.locator(".cards a").first.click()
    page.wait_for_url(re.compile(rf"\?lang={language}#engine="))
    page.evaluate(READY)
    page.locator("a.above").click()
    page.wait_for_url(f"**/gallery?lang={language}")


@pytest.mark.release
def test_the_gallery_and_the_page_are_in_the_language_that_the_browser_prefers(
    browser: Browser, server: Server
) -> None:
    context = browser.new_context(locale="ja-JP")
    with context, context.new_page() as page:
        page.goto(f"{server.address}gallery")
        expect(page.get_by_role("heading", level=1)).to_have_text("エンジン")
        page.locator(".cards a").first.click()
        page.wait_for_url("**/#engine=*")
        page.evaluate(READY)
        assert page.evaluate("document.documentElement.lang") == "ja"
        page.locator("a.above").click()
        page.get_by_role("link", name="English").click()
        expect(page.get_by_role("heading", level=1)).to_have_text("Engines")
        assert page.locator(".languages [aria-current]").inner_text() == "English"


@pytest.mark.release
def test_a_server_that_is_told_its_language_keeps_to_it(browser: Browser) -> None:
    complaints: list[str] = []
    with serving("--language", "ru") as server, watched(browser, complaints) as page:
        page.goto(f"{server.address}gallery")
        expect(page.get_by_role("heading", level=1)).to_have_text("Двигатели")
    assert complaints == []


@pytest.mark.release
def test_an_engine_file_that_is_dropped_is_opened(gallery: Page) -> None:
    gallery.evaluate(DROPPED, [RIGHT, "mine.toml"])
    gallery.wait_for_url("**/#engine=~*")
    gallery.evaluate(READY)
    expect(gallery.get_by_role("heading", level=1)).to_have_text("Mine")


@pytest.mark.release
def test_the_mistakes_of_a_file_that_is_chosen_are_told(browser: Browser, server: Server) -> None:
    complaints: list[str] = []  # the browser reports every refusal
    with watched(browser, complaints) as page:
        page.goto(f"{server.address}gallery")
        wrong = {"name": "mine.toml", "mimeType": "", "buffer": b'format = 1\nname = "Mine"\n'}
        page.locator("input[type=file]").set_input_files(wrong)  # pyright: ignore[reportArgumentType]
        told = page.get_by_role("alert")
        expect(told.get_by_role("heading")).to_have_text("mine.toml")
        assert told.get_by_role("listitem").count() >= 1
        assert page.url.endswith("/gallery")
    assert [told for told in complaints if "422" not in told] == []


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("pictures/i4-light.webp", 200),
        ("pictures/no-such-engine-light.webp", 404),
        ("pictures/i4.webp", 404),
        ("pictures/..%2f..%2fetc%2fpasswd-light.webp", 404),
    ],
)
def test_pictures_are_of_the_catalog_and_of_nothing_else(
    server: Server, path: str, status: int
) -> None:
    answer = server.ask(path)
    assert answer.status == status
    if status == 200:
        assert answer.heads["content-type"] == "image/webp"
        assert answer.body[8:12] == b"WEBP"


@pytest.mark.release
def test_a_miniature_is_small(server: Server) -> None:
    sizes = {
        name: max(len(server.ask(f"pictures/{name}{look.suffix}").body) for look in LOOKS)
        for name in ("napier-deltic", "radial-9", "merlin")
    }
    assert {name: size for name, size in sizes.items() if not 1000 < size <= 60_000} == {}
