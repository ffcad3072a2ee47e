"""A site of engines: complete, small, whole from disk, and whole without a script."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.web.browsing import too_wide
from tests.web.engine_page import READY, handle

from crankstar.files.catalog import names, tree_of
from crankstar.site.building import build
from crankstar.site.pages import Subject

ENGINES = ("boxer-2", "radial-9", "single")
ADDRESSES = ("href", "src", "srcset", "data-figures")


class Links(HTMLParser):
    """Every address in a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        del tag
        self.found += [value for key, value in attrs if key in ADDRESSES and value]


def written(folder: Path, engines: tuple[str, ...]) -> Path:
    subjects = [Subject(name, tree_of(name)[1], name) for name in engines]
    build(subjects, folder / "site", tell=lambda _done, _of, _name: None)
    return folder / "site"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("site"), ENGINES)


def whole(site: Path) -> None:
    """Fail where a link of a page leads nowhere, or a file is too large."""
    for page in site.rglob("*.html"):
        links = [link for link in Links(page.read_text("utf-8")).found if link != "data:,"]
        assert links
        for link in links:
            assert (page.parent / unquote(link.split("#")[0])).resolve().is_file(), (page, link)
        assert page.stat().st_size < 2_000_000
    sizes = {path.name: path.stat().st_size for path in site.rglob("*.webp")}
    assert {name for name, size in sizes.items() if size > 60_000} == set()
    assert [path for path in site.rglob("*") if path.name.startswith(".")] == []


@pytest.mark.release
def test_every_link_of_a_site_leads_to_a_file_of_it(site: Path) -> None:
    whole(site)
    assert {path.stem for path in (site / "engines").iterdir()} == {*ENGINES}
    index = (site / "index.html").read_text("utf-8")
    assert re.findall(r'<a href="engines/(.*?)\.html">', index) == [*ENGINES]
    for script in ("crankstar", "figures"):
        assert len([*site.glob(f"{script}-*.js")]) == 1


@pytest.mark.release
def test_a_site_opens_from_disk_and_its_engines_turn(site: Path, page: Page) -> None:
    page.goto((site / "index.html").as_uri())
    page.get_by_label("Layout").select_option("radial")
    assert page.locator(".cards li:visible").count() == 1
    page.locator(".cards li:visible a").click()
    page.wait_for_url("**/radial-9.html")
    page.evaluate(READY)
    assert len(handle(page, "read().pistons")) == 9
    page.get_by_role("tab", name="Stars").click()
    page.wait_for_selector("svg.marks")
    page.get_by_role("link", name="All engines").click()
    page.wait_for_url("**/index.html")
    page.wait_for_function("() => [...document.images].every(one => one.currentSrc)")
    shown = page.locator("img").evaluate_all("all => all.map(one => one.currentSrc)")
    assert shown == [(site / f"pictures/{name}-light.webp").as_uri() for name in ENGINES]


@pytest.mark.release
def test_a_gallery_turns_and_is_whole_without_a_script(site: Path, browser: Browser) -> None:
    context = browser.new_context(java_script_enabled=False, color_scheme="dark")
    try:
        page = context.new_page()
        page.goto((site / "index.html").as_uri())
        expect(page.locator(".cards li")).to_have_count(len(ENGINES))
        expect(page.get_by_text("Boxer twin")).to_be_visible()
        expect(page.get_by_label("Search")).to_be_hidden()
        source = page.locator("picture").first.locator("source").last
        expect(source).to_have_attribute("srcset", "pictures/boxer-2-dark-turning.webp")
    finally:
        context.close()


@pytest.mark.release
def test_a_gallery_of_a_site_fits_a_telephone(site: Path, page: Page) -> None:
    """What axe looks for is looked for in the same gallery on the server."""
    page.set_viewport_size({"width": 390, "height": 800})
    page.goto((site / "index.html").as_uri())
    assert too_wide(page) == []


@pytest.mark.release
def test_the_site_of_the_catalog_is_whole_and_not_large(tmp_path: Path) -> None:
    site = written(tmp_path, names())
    whole(site)
    assert {path.stem for path in (site / "engines").iterdir()} == {*names()}
    assert sum(path.stat().st_size for path in site.rglob("*") if path.is_file()) < 40_000_000
