"""Derivations in a browser: every formula set, no network, nothing over the edge."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

import crankstar
from crankstar.derive import derivation, documents

ORDERS = (1, 2, 4, 6)
QUICK = {"v8-cross-plane", "vw-vr6", "kr250-racer", "sinitsyn-7-first"}
ENGINES = [
    name if name in QUICK else pytest.param(name, marks=pytest.mark.release)
    for name in crankstar.names()
]
LOOK = """() => [...document.querySelectorAll('math')].map(math => {
  const box = math.getBoundingClientRect();
  const known = ':not(mrow, mi, mn, mo, mtext, mfrac, msqrt, msub, msup, mspace, mtable, mtr, mtd)';
  return {
    width: box.width, height: box.height, told: math.getAttribute('alttext') || '',
    unknown: math.querySelectorAll(known).length, namespace: math.namespaceURI,
  };
})"""


def written(name: str, folder: Path) -> Path:
    engine = crankstar.load(name)
    chapters = [
        derivation(engine, order, quantity) for order in ORDERS for quantity in ("force", "couple")
    ]
    place = folder / f"{name}.html"
    place.write_text(documents.html(chapters), encoding="utf-8")
    return place


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ENGINES)
def test_every_formula_is_set(page: Page, tmp_path: Path, name: str) -> None:
    page.goto(written(name, tmp_path).as_uri())
    formulas = page.evaluate(LOOK)
    assert len(formulas) > 8 * 6
    for formula in formulas:
        assert formula["namespace"] == "http://www.w3.org/1998/Math/MathML"
        assert formula["unknown"] == 0, formula["told"]
        assert formula["width"] > 4, formula["told"]
        assert formula["height"] > 4, formula["told"]
        assert formula["told"]


@pytest.mark.release
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_page_fits_and_is_legible_in_any_light(page: Page, tmp_path: Path, scheme: str) -> None:
    page.emulate_media(color_scheme=scheme)  # pyright: ignore[reportArgumentType]
    page.goto(written("v8-cross-plane", tmp_path).as_uri())
    for width in (400, 900, 1600):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    ink, ground = page.evaluate(
        "['color', 'backgroundColor'].map(key => getComputedStyle(document.body)[key])"
    )
    light = [sum(map(int, colour.strip("rgb()").split(",")[:3])) / 765 for colour in (ink, ground)]
    assert abs(light[0] - light[1]) > 0.6
    assert (light[1] > 0.5) == (scheme == "light")


@pytest.mark.release
def test_the_page_shows_what_the_derivation_says(page: Page, tmp_path: Path) -> None:
    page.goto(written("v8-flat-plane", tmp_path).as_uri())
    section = page.locator("section", has=page.get_by_role("heading", name="Secondary force"))
    told = section.locator("math").evaluate_all(
        "all => all.map(math => math.getAttribute('alttext'))"
    )
    assert "F_right = −4√2 cos 2θ" in told
    assert (
        section.locator(".note").first.inner_text().startswith("Cylinders 1, 3, 5, 7 are in phase")
    )
