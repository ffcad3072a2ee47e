"""The report on paper: its pages are few and filled, its contents name them, its letters print."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from tests.report.test_printing import chromium
from tests.report.test_report import subject
from tests.tools import path_of

import crankstar
from crankstar.charts import fonts
from crankstar.language.messages import spoken
from crankstar.report import printed, report
from crankstar.report.numbering import numbered

__all__ = ["chromium"]

MOST_PAGES = 15
MARGIN, A4 = 18, 297
"""mm: the margins above and below, and the height of the paper."""
LEAST_FILLED = 0.5
OFTEN = ("v8-cross-plane", "audi-25-tfsi")
SELDOM = (
    "napier-deltic",
    "radial-9",
    "single",
    "i4",
    "boxer-6",
    "kr250-racer",
    "man-s90mc-c",
    "jumo-205",
    "vw-vr6",
)
ENGINES = [*OFTEN, *(pytest.param(name, marks=pytest.mark.release) for name in SELDOM)]


def on_paper(name: str, chromium: str, folder: Path) -> Path:
    """The short report on an engine as a PDF."""
    place = folder / f"{name}.pdf"
    place.write_bytes(printed(report(subject(name, full=False)), by=chromium))
    return place


def tool(name: str, *arguments: str) -> bytes:
    """What a program of Poppler prints."""
    program = Path(path_of("poppler")).with_name(name)
    return subprocess.run([program, *arguments], capture_output=True, check=True).stdout


def text_of(place: Path) -> list[str]:
    """The text of each page."""
    return tool("pdftotext", "-layout", str(place), "-").decode().split("\f")[:-1]


def filled(place: Path) -> list[float]:
    """How far down each page is printed, as a share of the height between its margins."""
    raw, out = tool("pdftoppm", "-r", "36", "-gray", str(place)), []
    while raw:
        _magic, size, _depth, rest = raw.split(b"\n", 3)
        width, height = map(int, size.split())
        pixels, raw = rest[: width * height], rest[width * height :]
        top, foot = (round(height * part / A4) for part in (MARGIN, A4 - MARGIN))
        inked = [
            row for row in range(top, foot) if min(pixels[row * width : (row + 1) * width]) < 200
        ]
        out.append((max(inked, default=top) - top) / (foot - top))
    return out


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_a_report_has_few_pages_and_no_half_empty_ones(
    name: str, chromium: str, tmp_path: Path
) -> None:
    place = on_paper(name, chromium, tmp_path)
    shares = filled(place)
    assert len(shares) <= MOST_PAGES
    assert [share for share in shares[:-1] if share < LEAST_FILLED] == [], shares
    pages = text_of(place)
    title = crankstar.load(name).name
    for number, page in enumerate(pages, 1):
        lines = [line.strip() for line in page.splitlines() if line.strip()]
        assert re.search(rf"\b{number} ?/ ?{len(pages)}$", lines[-1])
        assert lines[0].startswith(title[:30]) or number == 1


@pytest.mark.release
def test_the_contents_name_the_pages_of_the_sections(chromium: str, tmp_path: Path) -> None:
    pages = text_of(on_paper("i4", chromium, tmp_path))
    listed = re.findall(
        r"(\d+) {1,6}([A-Z][\w, ]+?) +(\d+)(?: |$)", "\n".join(pages[:2]), re.MULTILINE
    )
    wanted = {title: int(page) for _number, title, page in listed}
    assert len(wanted) == 14
    for number, title, page in listed:
        heading = rf"^ *{number} +{title}$"
        assert re.search(heading, pages[int(page) - 1], re.MULTILINE), title


@pytest.mark.release
def test_the_front_page_says_what_it_is_how_it_shakes_and_what_to_do() -> None:
    page = report(subject("audi-25-tfsi", full=False))
    front = page[: page.index('<nav class="contents">')]
    headings = re.findall(r"<h2>([^<]*)</h2>", front)
    assert headings == ["What it is", "How it shakes", "What to do", "What it rests on"]
    assert "1534.3 N m" in front
    assert "balance shaft" in front
    assert "<svg" in front
    without = report(subject("i4", full=False))
    assert without.count("For newtons, add to the file: cylinder.stroke") >= 1
    front = without[: without.index('<nav class="contents">')]
    assert front.count("1-3-4-2") == 1


@pytest.mark.release
def test_figures_and_tables_are_numbered_through_and_referred_to() -> None:
    page = report(subject("v8-cross-plane", full=False))
    for kind, word in (("figure", "Figure"), ("table", "Table")):
        shown = re.findall(rf'id="{kind}-(\d+)"[^>]*><b>{word} (\d+)\.</b>', page)
        assert shown == [(str(n), str(n)) for n in range(1, len(shown) + 1)]
        assert len(shown) > 5
        linked = set(re.findall(rf'href="#{kind}-(\d+)"', page))
        assert linked <= {number for number, _ in shown}
        assert len(linked) > 5
    assert page.count("<figcaption") == page.count("<figure")
    refs = re.findall(r'<p class="refs">(.*?)</p>', page)
    assert refs
    assert not [words for words in refs if "?" in words]


def test_a_section_names_its_figures_with_links() -> None:
    figure = "<figure><figcaption>A star.</figcaption></figure>"
    sections = numbered(
        f'<section id="one"><h2>One</h2>{3 * figure}</section>'
        f'<section id="two"><h2>Two</h2>{figure}</section>'
    )
    words = [re.search(r'<p class="refs">(.*?)</p>', each.body) for each in sections]
    assert [found and found[1] for found in words] == [
        'Figures <a href="#figure-1">1</a>–<a href="#figure-3">3</a>.',
        'Figure <a href="#figure-4">4</a>.',
    ]


@pytest.mark.release
def test_figures_leave_the_name_of_the_engine_to_the_page_but_not_its_sense() -> None:
    page = report(subject("man-s90mc-c", full=False))
    drawn = re.findall(r"<figure[^>]*>(.*?)<figcaption[^>]*>(.*?)</figcaption>", page, re.DOTALL)
    assert len(drawn) > 10
    stars = [drawing for drawing, caption in drawn if "vectors of order" in caption]
    assert stars
    assert all(">turns counter-clockwise<" in drawing for drawing in stars)
    for drawing, caption in drawn:
        words = re.sub(r"<title.*?</title>|<[^>]*>", "", drawing)
        assert ("7S90MC" in words) == ("before and after" in caption), caption
        assert "\N{NO-BREAK SPACE}" not in drawing


@pytest.mark.release
def test_only_the_full_report_has_derivations_and_the_engine_file() -> None:
    short, full = (report(subject("i4", full=full)) for full in (False, True))
    for words in ('id="derivations"', 'class="file"', "harmonic"):
        assert (words in short, words in full) == (False, True), words
    assert "crankstar report --full" in short
    assert "crankstar report --full" not in full


@pytest.mark.release
@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("ja", ("二次慣性力", "バランサーシャフト")),
        pytest.param("ru", ("Сила 2-го порядка", "порядка нет"), marks=pytest.mark.release),
    ],
)
def test_japanese_and_russian_print(
    language: str, words: tuple[str, str], chromium: str, tmp_path: Path
) -> None:
    with spoken(language):
        page = report(subject("i4", full=False))
    script = {"ja": fonts.JAPANESE, "ru": fonts.CYRILLIC}[language]
    assert fonts.font_file(script) is not None, 'pip install "crankstar[fonts]"'
    assert f'font-family: "crankstar {script.family}"' in page
    place = tmp_path / "x.pdf"
    place.write_bytes(printed(page, by=chromium))
    text = re.sub(r"\s+", " ", tool("pdftotext", str(place), "-").decode())
    assert all(word in text for word in words)
    listed = tool("pdffonts", str(place)).decode().splitlines()[2:]
    assert listed
    assert all(re.search(r" yes (?:yes|no) +yes +\d+ +0$", line) for line in listed)


def test_letters_without_any_font_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fonts, "font_file", lambda _: None)
    monkeypatch.setattr(fonts, "lacks", lambda language: language == "ja")
    assert fonts.missing_letters("慣性力 and сила") == ["力性慣"]
    monkeypatch.setattr(fonts, "lacks", lambda _: False)
    assert fonts.missing_letters("慣性力 and сила") == []
