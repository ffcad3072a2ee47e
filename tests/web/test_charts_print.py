"""Charts on paper: no text on another, none cut off, none left out, measured in a browser."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page
from tests.charted import rows_drawn
from tests.commands import Run
from tests.files.conftest import refused, run
from tests.measured import FAMILIES, Measured, contrast, measured
from tests.methods.test_diagnosis import four, heavy, lines, seen

import crankstar
from crankstar import charts
from crankstar.analyses.diagnose.charts import suspect_chart
from crankstar.analyses.diagnose.diagnosis import diagnosed
from crankstar.analyses.tolerance.charts import scatter_chart
from crankstar.charts.themes import THEMES
from crankstar.engine.engine import Engine
from crankstar.language.messages import spoken
from crankstar.remedy import with_counterweights

__all__ = ["refused", "run"]

OFTEN = ("v8-cross-plane", "kr250-racer", "vw-vr6")
ENGINES = [
    pytest.param(name, marks=[pytest.mark.release] * (name not in OFTEN))
    for name in crankstar.names()
]
STARS = ("vector-star", "polygon", "forces", "crank-star")


def variants(figure: charts.Figure) -> list[dict[str, Any]]:
    """A figure as it is by default, and with its first orders and every quantity."""
    out: list[dict[str, Any]] = [{}]
    if "order" in figure.options:
        orders = [
            {"order": order, "quantity": name} for order in (1, 2) for name in figure.quantities
        ]
        return [*out, *orders]
    return [*out, *({"quantity": name} for name in figure.quantities[1:])]


def pictures(engine: Engine) -> dict[str, str]:
    """Every figure of an engine as an SVG, by its name and options."""
    return {
        f"{name} {options}": charts.svg(figure.draw(engine, **options), name)
        for name, figure in charts.CHARTS.items()
        for options in variants(figure)
    }


def assert_clear(drawings: dict[str, str], page: Page) -> list[Measured]:
    """No text collides or is cut in any of the fonts; the pictures in those that they name."""
    seen: list[Measured] = []
    for family in (*FAMILIES[1:], ""):
        seen = measured(page, [*drawings.values()], family)
        faults = {
            name: (picture.collisions(), picture.cut())
            for name, picture in zip(drawings, seen, strict=True)
            if picture.collisions() or picture.cut()
        }
        assert faults == {}, family
    assert sum(len(picture.texts) for picture in seen) > 6 * len(seen)
    return seen


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_no_text_of_a_chart_stands_on_another_or_is_cut(name: str, page: Page) -> None:
    assert_clear(pictures(crankstar.load(name)), page)


@pytest.mark.release
@pytest.mark.parametrize(
    "name", ["v8-cross-plane", pytest.param("napier-deltic", marks=pytest.mark.release)]
)
def test_weights_do_not_crowd_the_texts_of_a_chart(name: str, page: Page) -> None:
    assert_clear(pictures(with_counterweights(crankstar.load(name), factor=0.5)), page)


@pytest.mark.release
def test_texts_that_collide_or_are_cut_are_seen(page: Page) -> None:
    drawing = (
        '<svg width="90" height="40"><text x="5" y="15">force</text>'
        '<text x="20" y="18">couple</text><text x="70" y="35">moment</text></svg>'
    )
    (picture,) = measured(page, [drawing])
    assert picture.collisions() == [("force", "couple")]
    assert picture.cut() == ["moment"]


@pytest.mark.release
@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("name", ["kr250-racer", "v8-cross-plane"])
def test_the_japanese_names_of_forces_stand_apart(name: str, family: str, page: Page) -> None:
    with spoken("ja"):
        drawing = charts.svg(charts.force_arrows(crankstar.load(name)), "x")
    (picture,) = measured(page, [drawing], family)
    assert picture.collisions() == []
    assert picture.cut() == []
    assert sum("1次" in each.text for each in picture.texts) == 1


def numbers(picture: Measured) -> set[int]:
    """The numbers of all labels that name cylinders, ranges spelt out."""
    out: set[int] = set()
    for text in picture.texts:
        if re.fullmatch(r"[\d, –]+", text.text):
            for part in text.text.split(","):
                first, _dash, last = part.strip().partition("–")
                out |= set(range(int(first), int(last or first) + 1))
    return out


@pytest.mark.release
@pytest.mark.parametrize(
    "name",
    [
        "radial-9",
        "v8-cross-plane",
        *(pytest.param(name, marks=pytest.mark.release) for name in ("napier-deltic", "jumo-205")),
    ],
)
def test_every_cylinder_is_named_in_its_star_and_polygon(name: str, page: Page) -> None:
    engine = crankstar.load(name)
    drawings = [
        charts.svg(draw(engine, order=order, quantity="force"), "x")
        for draw in (charts.vector_star, charts.polygon)
        for order in (1, 2)
    ]
    drawings.append(charts.svg(charts.force_arrows(engine), "x"))
    every = {cylinder.number for cylinder in engine.cylinders}
    for picture in measured(page, drawings):
        assert numbers(picture) >= every


@pytest.mark.release
@pytest.mark.parametrize(
    ("name", "kind", "title"),
    [
        ("v8-cross-plane", "hodograph", "Path of the couple, all orders"),
        ("v8-cross-plane", "vector-star", "Couple of order 1, in m r ω² a"),
        ("v8-cross-plane", "over-turn", "Couple over the crank angle, in m r ω² a"),
        ("i4", "vector-star", "Force of order 2, in m r ω² A2"),
        ("i4", "hodograph", "Path of the force, all orders"),
        ("audi-25-tfsi", "polygon", "Couple polygon of order 1, in"),
        ("single", "polygon", "Force polygon of order 1, in m r ω²"),
    ],
)
def test_by_default_a_chart_shows_what_is_left(
    name: str, kind: str, title: str, page: Page
) -> None:
    figure = charts.CHARTS[kind].draw(crankstar.load(name))
    (picture,) = measured(page, [charts.svg(figure, "x")])
    assert picture.texts[0].text.startswith(title) or any(
        text.text.startswith(title) for text in picture.texts
    )
    assert not any(re.match("no (force|couple) of", text.text) for text in picture.texts)


def test_a_chart_of_an_engine_without_force_and_couple_says_so(page: Page) -> None:
    engine = crankstar.load("boxer-6")
    (picture,) = measured(page, [charts.svg(charts.hodograph(engine, order=1), "x")])
    assert "no force and no couple of order 1" in {text.text for text in picture.texts}


PAPERS = [
    charts.Paper("light"),
    charts.Paper("dark", width=0.120),
    charts.Paper("print", width=0.084, font_size=8.0),
    charts.Paper("print", height=0.110, font_size=10.0),
]
TALL = (
    *("stroke-chart", "spectrum", "forces", "bending", "balance-shafts", "amplitudes"),
    "bearing-loads",
)
"""Charts that are taller than 110 mm with letters of 10 pt."""


@pytest.mark.release
@pytest.mark.parametrize(
    "paper",
    [
        pytest.param(paper, id=str(paper), marks=[pytest.mark.release] * (place in (0, 3)))
        for place, paper in enumerate(PAPERS)
    ],
)
@pytest.mark.parametrize(
    "name", ["v8-cross-plane", pytest.param("napier-deltic", marks=pytest.mark.release)]
)
def test_text_on_paper_is_large_and_dark_enough(name: str, paper: charts.Paper, page: Page) -> None:
    engine = crankstar.load(name)
    drawings = {}
    for kind, figure in charts.CHARTS.items():
        if (
            name == "napier-deltic"
            and kind in (*STARS, "shaft", "bearing-loads", "exhaust-orders", "side-thrust")
            and paper != PAPERS[0]
        ):
            continue  # needs a page of its own
        if (paper.height is not None and kind in TALL) or (paper.width and kind == "forces"):
            continue
        made = charts.printed(partial(figure.draw, engine), paper, title=kind)
        drawings[kind] = made.scaled("mm")
    ground = bytes.fromhex(THEMES[paper.theme].ground[1:])
    for kind, picture in zip(drawings, assert_clear(drawings, page), strict=True):
        for text in picture.texts:
            assert text.size * 72 / 96 >= paper.font_size - 0.01 >= 7.99, (kind, text)
            assert text.opacity == 1
            assert contrast(text.colour, (ground[0], ground[1], ground[2])) >= 4.5, (kind, text)
        for side, stated in ((picture.width, paper.width), (picture.height, paper.height)):
            assert stated is None or side == pytest.approx(stated / 0.0254 * 96, abs=0.1)


@pytest.mark.release
@pytest.mark.parametrize(("width", "across"), [(0.254, 2), (0.120, 1)])
def test_two_stars_lie_side_by_side_where_the_paper_is_wide(
    width: float, across: int, page: Page
) -> None:
    engine = crankstar.load("napier-deltic")
    slide = charts.Paper("light", width=width, height=0.143 if across == 2 else None)
    made = charts.printed(partial(charts.vector_star, engine), slide, title="star")
    assert [len(row.get("hconcat", [row])) for row in rows_drawn(made.chart.to_dict())] == (
        [2] if across == 2 else [1, 1]
    )
    (picture,) = assert_clear({"star": made.scaled("mm")}, page)
    assert min(text.size for text in picture.texts) * 72 / 96 >= slide.font_size - 0.01


def test_contrast_is_that_of_the_guideline() -> None:
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21)
    assert contrast((118, 118, 118), (255, 255, 255)) == pytest.approx(4.54, abs=0.01)
    for name, theme in THEMES.items():
        ground, *colours = (
            (int(text[1:3], 16), int(text[3:5], 16), int(text[5:], 16))
            for text in (theme.ground, *theme.colours.values())
        )
        assert min(contrast(colour, ground) for colour in colours) >= 4.5, name


@pytest.mark.release
def test_a_picture_has_the_size_and_the_dots_that_are_asked_for(run: Run, tmp_path: Path) -> None:
    sized = ("plot", "i4", "hodograph", "--width", "4 in", "--height", "90 mm")
    assert run(*sized, "-o", "x.svg").code == 0
    head = (tmp_path / "x.svg").read_text(encoding="utf-8")[:200]
    assert 'width="101.6mm" height="90mm"' in head
    assert run(*sized, "--dpi", "300", "-o", "x.png").code == 0
    picture = (tmp_path / "x.png").read_bytes()
    assert struct.unpack(">II", picture[16:24]) == (1200, 1062)  # whole dots of 1062.99
    at = picture.index(b"pHYs")
    assert struct.unpack(">I", picture[at + 4 : at + 8]) == (round(300 / 0.0254),)
    assert run(*sized, "-o", "x.pdf").code == 0
    box = re.search(rb"/MediaBox \[([^]]*)\]", (tmp_path / "x.pdf").read_bytes())
    assert box is not None
    assert [float(side) for side in box[1].split()] == pytest.approx(
        [0, 0, 288, 90 / 25.4 * 72], abs=0.1
    )


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--width", "2"], "give a length from 20 mm to 2 m"),
        (["--width", "1 kg"], "--width"),
        (["--font-size", "6"], "give a number from 8 to 72"),
        (["--width", "25 mm"], "the chart does not fit on this size with letters of 9 pt"),
        (["--theme", "blue"], "choose from light, dark, print"),
        (["--dpi", "300"], "--dpi has no effect with .svg"),
        (["--width", "90 mm", "-o", "x.html"], "--width has no effect with .html"),
    ],
)
def test_sizes_that_cannot_be_printed_are_refused(
    options: list[str], words: str, refused: Callable[..., str], tmp_path: Path
) -> None:
    place = [] if "-o" in options else ["-o", "x.svg"]
    assert words in refused("plot", "i4", "spectrum", *options, *place)
    assert not [*tmp_path.iterdir()]


@pytest.mark.release
def test_names_of_faults_and_of_tolerances_are_not_cut(page: Page) -> None:
    masses = {"cylinder.reciprocating_mass": "500 g +- 3 g", "cylinder.stroke": "90 mm"}
    found = crankstar.tolerance("i6", changes=masses | {"speed": "6000 rpm"}, builds=1000).value
    suspects = diagnosed(four(), lines(seen(heavy(3, "reciprocating_mass", "708.4 g"))))
    drawings = {
        "suspects": charts.svg(suspect_chart(suspects), ""),
        "scatter": charts.svg(scatter_chart(found, quantities=("force",)), ""),
    }
    for name, picture in zip(drawings, measured(page, [*drawings.values()]), strict=True):
        assert not picture.cut(), name
