"""The report in a browser: no complaints, wide and narrow, light and dark, on paper."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from playwright.sync_api import Page

from crankstar.files import catalog, engine_of
from crankstar.report import Subject, report


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    _, tree = catalog.tree_of("audi-25-tfsi")
    out = tmp_path_factory.mktemp("report") / "audi.html"
    out.write_text(
        report(
            Subject(
                engine_of(tree, name="audi"), tree, "crankstar report audi-25-tfsi -o report.html"
            )
        ),
        encoding="utf-8",
    )
    return out


@pytest.mark.release
@pytest.mark.parametrize(
    ("width", "scheme"),
    [
        (400, "light"),
        (1600, "dark"),
        *(
            pytest.param(*one, marks=pytest.mark.release)
            for one in ((400, "dark"), (1600, "light"))
        ),
    ],
)
def test_a_report_fits_the_window_and_takes_its_colours(
    page: Page, place: Path, width: int, scheme: str
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    page.emulate_media(color_scheme=scheme)  # pyright: ignore[reportArgumentType]
    page.goto(place.as_uri())
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    # its style sheet is in force under its own policy: the ground is that of the scheme
    ground = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert ground == {"light": "rgb(255, 255, 255)", "dark": "rgb(20, 25, 31)"}[scheme]
    assert page.evaluate(
        "[...document.querySelectorAll('main > section svg')].every(svg => "
        "svg.getBoundingClientRect().width > 60)"
    )
    assert page.evaluate(
        "[...document.querySelectorAll('math')].every(math => "
        "math.getBoundingClientRect().height > 5)"
    )


MEETING = """() => [...document.querySelectorAll('figure svg')].flatMap(svg => {
  const texts = [...svg.querySelectorAll('text')].filter(
    text => text.textContent.trim() && text.getAttribute('opacity') !== '0')
    .map(text => ({ words: text.textContent, box: text.getBoundingClientRect() }));
  const meet = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2
    && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 5;
  return texts.flatMap((one, i) => texts.slice(i + 1).filter(other => meet(one.box, other.box))
    .map(other => svg.querySelector('title').textContent + ': ' + one.words + ' | ' + other.words));
})"""


ON_AN_AXIS = """() => [...document.querySelectorAll('figure svg')].flatMap(svg => {
  const upright = [...svg.querySelectorAll('path')]
    .map(path => path.getBoundingClientRect()).filter(b => b.width < 3 && b.height > 150);
  const angles = [...svg.querySelectorAll('text')].filter(text => text.textContent.includes('°'));
  return angles.filter(text => upright.some(axis => {
    const box = text.getBoundingClientRect(), middle = (axis.left + axis.right) / 2;
    return box.left < middle - 1 && box.right > middle + 1
      && box.bottom > axis.top && box.top < axis.bottom;
  })).map(text => svg.querySelector('title').textContent + ': ' + text.textContent);
})"""


@pytest.mark.release
@pytest.mark.parametrize("name", ["jumo-205", "single"])
def test_words_in_the_spectra_and_paths_do_not_lie_over_each_other(
    page: Page, name: str, tmp_path: Path
) -> None:
    """As drawn in the browser's own font, which is wider than the charts assume."""
    _, tree = catalog.tree_of(name)
    out = tmp_path / "report.html"
    out.write_text(
        report(Subject(engine_of(tree, name=name), tree, "crankstar report")), encoding="utf-8"
    )
    page.set_viewport_size({"width": 1280, "height": 900})
    page.goto(out.as_uri())
    met = page.evaluate(MEETING)
    assert [
        one for one in met if ": spectrum" in one or ": hodograph" in one or ": over-turn" in one
    ] == []
    assert [one for one in page.evaluate(ON_AN_AXIS) if ": hodograph" in one] == []


@pytest.mark.release
def test_a_reader_who_does_not_see_it_finds_headings_and_names(page: Page, place: Path) -> None:
    page.goto(place.as_uri())
    levels = page.evaluate(
        "[...document.querySelectorAll('h1, h2, h3, h4')].map(h => Number(h.tagName[1]))"
    )
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after - before <= 1 for before, after in pairwise(levels))
    assert page.evaluate(
        "[...document.querySelectorAll('svg')].every(svg => "
        "svg.querySelector('title')?.textContent)"
    )
    assert page.evaluate(
        "[...document.querySelectorAll('[tabindex]')].every(part => "
        "part.getAttribute('aria-label'))"
    )


@pytest.mark.release
def test_on_paper_no_figure_and_no_line_is_wider_than_the_page(page: Page, place: Path) -> None:
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 673, "height": 980})  # A4 less its margins, in px
    page.goto(place.as_uri())
    parts = "[...document.querySelectorAll('figure, table, .line, pre')]"
    assert (
        page.evaluate(f"{parts}.filter(part => part.getBoundingClientRect().right > 674).length")
        == 0
    )
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
