"""The documents as built: opened from disk without network, on wide and narrow screens."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from playwright.sync_api import Page
from tests.web.browsing import too_wide

pytestmark = pytest.mark.release

ROOT = Path(__file__).parents[2]
BUILT = ROOT / ".venv" / "site"
TELEPHONE = 400
"""Pixels across."""


def in_order(nav: list[Any]) -> Iterator[str]:
    """The pages of a navigation, whatever sections it has."""
    for entry in nav:
        for value in entry.values() if isinstance(entry, dict) else [entry]:
            if isinstance(value, list):
                yield from in_order(value)
            else:
                yield value


PAGES = [
    name.removesuffix(".md")
    for name in in_order(yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"])
]


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The documents of `make docs`, built here if they changed since."""
    sources = [
        ROOT / "mkdocs.yml",
        *(path for path in (ROOT / "docs").rglob("*.*") if path.suffix != ".pyc"),
    ]
    index = BUILT / "index.html"
    if index.exists() and index.stat().st_mtime > max(path.stat().st_mtime for path in sources):
        return BUILT
    folder = tmp_path_factory.mktemp("site")
    command = [
        sys.executable,
        "-m",
        "mkdocs",
        "build",
        "--strict",
        "--quiet",
        "--site-dir",
        str(folder),
    ]
    subprocess.run(command, cwd=ROOT, env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, check=True)
    return folder


OFTEN = (*("index", "how-to/analyse", "explanation/theory", "reference/command-line"),)


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.release] * (name not in OFTEN)) for name in PAGES],
)
def test_every_page_opens_from_disk_with_one_title_and_fits_a_telephone(
    name: str, site: Path, page: Page
) -> None:
    page.goto((site / f"{name}.html").as_uri())
    assert page.locator("h1").count() == 1
    assert page.locator("h1").is_visible()
    assert page.title()
    page.set_viewport_size({"width": TELEPHONE, "height": 800})
    assert too_wide(page) == []


@pytest.mark.parametrize(
    "word",
    [
        "M1V",
        *(
            pytest.param(w, marks=pytest.mark.release)
            for w in ("secondary", "overbalance", "pandas")
        ),
    ],
)
def test_the_search_box_of_a_page_from_disk_finds(word: str, site: Path, page: Page) -> None:
    page.goto((site / "explanation" / "theory.html").as_uri())
    page.locator("input.md-search__input").press_sequentially(word)
    results = page.locator(".md-search-result__link")
    results.first.wait_for(state="attached")
    addresses = [str(link.get_attribute("href")) for link in results.all()]
    assert all(address.startswith(site.as_uri()) for address in addresses)
    found = page.locator(".md-search-result__list").inner_text()
    assert word.lower() in found.lower()


def test_the_search_box_finds_nothing_for_a_word_that_is_nowhere(site: Path, page: Page) -> None:
    page.goto((site / "index.html").as_uri())
    page.locator("input.md-search__input").press_sequentially("zwitterion")
    page.get_by_text("No matching documents").wait_for(state="attached")


SIZES = """() => [...document.querySelectorAll('math')].map(formula => {
    const box = formula.getBoundingClientRect()
    const ratio = formula.querySelector('mfrac')
    const [above, below] = ratio ? [...ratio.children] : []
    const raised = [...formula.querySelectorAll('msup')].map(one =>
        one.children[0].getBoundingClientRect().top - one.children[1].getBoundingClientRect().top)
    return {
        width: box.width, height: box.height,
        stacked: ratio
            ? below.getBoundingClientRect().top - above.getBoundingClientRect().bottom : 1,
        raised: Math.min(1, ...raised.map(size => size + 3)),
    }
})"""


def test_formulas_are_drawn_with_fractions_stacked_and_powers_raised(
    site: Path, page: Page
) -> None:
    page.goto((site / "explanation" / "theory.html").as_uri())
    shown = page.evaluate(SIZES)
    assert len(shown) > 60
    for formula in shown:
        assert formula["width"] > 3
        assert formula["height"] > 5
        assert formula["stacked"] >= -1
        assert formula["raised"] >= 0
    texts = page.locator("article").inner_text()
    assert "\\frac" not in texts
    assert "$" not in texts
