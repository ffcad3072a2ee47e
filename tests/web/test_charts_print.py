"""Charts on paper: no text on another, none cut off, none left out, measured in a browser."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Page
from tests.measured import Measured, measured

import crankstar
from crankstar import charts
from crankstar.engine.engine import Engine
from crankstar.remedy import with_counterweights

OFTEN = (
    "single",
    "i4",
    "v8-cross-plane",
    "napier-deltic",
    "radial-9",
    "kr250-racer",
    "jumo-205",
    "vw-vr6",
    "audi-25-tfsi",
    "man-s90mc-c",
)
ENGINES = [
    pytest.param(name, marks=[pytest.mark.long] * (name not in OFTEN)) for name in crankstar.names()
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
    seen = measured(page, [*drawings.values()])
    faults = {
        name: (picture.collisions(), picture.cut())
        for name, picture in zip(drawings, seen, strict=True)
        if picture.collisions() or picture.cut()
    }
    assert faults == {}
    assert sum(len(picture.texts) for picture in seen) > 100
    return seen


@pytest.mark.parametrize("name", ENGINES)
def test_no_text_of_a_chart_stands_on_another_or_is_cut(name: str, page: Page) -> None:
    assert_clear(pictures(crankstar.load(name)), page)


def test_weights_do_not_crowd_the_texts_of_a_chart(page: Page) -> None:
    for name in ("v8-cross-plane", "napier-deltic"):
        assert_clear(pictures(with_counterweights(crankstar.load(name), factor=0.5)), page)


def test_texts_that_collide_or_are_cut_are_seen(page: Page) -> None:
    drawing = (
        '<svg width="90" height="40"><text x="5" y="15">force</text>'
        '<text x="20" y="18">couple</text><text x="70" y="35">moment</text></svg>'
    )
    (picture,) = measured(page, [drawing])
    assert picture.collisions() == [("force", "couple")]
    assert picture.cut() == ["moment"]


def numbers(picture: Measured) -> set[int]:
    """The numbers of all labels that name cylinders, ranges spelt out."""
    out: set[int] = set()
    for text in picture.texts:
        if re.fullmatch(r"[\d, –]+", text.text):
            for part in text.text.split(","):
                first, _dash, last = part.strip().partition("–")
                out |= set(range(int(first), int(last or first) + 1))
    return out


@pytest.mark.parametrize("name", ["napier-deltic", "radial-9", "v8-cross-plane", "jumo-205"])
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
