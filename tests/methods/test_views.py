"""Still views: parts are where the exact motion puts them, whole, and on one scale."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE

import crankstar
from crankstar.engine.copies import with_values
from crankstar.page.scene import scene
from crankstar.report.projections import FRONT, PLAN, SIDE
from crankstar.report.views import orthographic, placed, small_views

ENGINES = (
    "v8-cross-plane",
    "audi-25-tfsi",
    "pratt-whitney-wasp",
    "jumo-205",
    "kr250-production",
    "napier-deltic",
    "vw-vr6",
    "bmw-s65",
)
SPACE = "{http://www.w3.org/2000/svg}"


@EVERY_ENGINE
def test_rods_have_their_length_and_pistons_are_on_their_axes(name: str) -> None:
    engine = crankstar.load(name)
    for cylinder, place in zip(engine.cylinders, placed(engine), strict=True):
        shaft = engine.shaft(cylinder.shaft)
        along = (place.piston - complex(shaft.up, shaft.right)) / np.exp(1j * cylinder.bearing)
        assert along.imag == pytest.approx(cylinder.offset, abs=1e-9 * cylinder.rod_length)
        assert abs(place.piston - place.big_end) == pytest.approx(cylinder.rod_length, rel=1e-9)
        if cylinder.articulated is None:
            radius = abs(place.big_end - complex(shaft.up, shaft.right))
            assert radius == pytest.approx(engine.throw(cylinder).radius, rel=1e-9)


@pytest.mark.many(first=6)
@pytest.mark.parametrize("name", ENGINES)
def test_nothing_is_cut_off_and_numbers_are_there(name: str) -> None:
    engine = crankstar.load(name)
    for draw, axes in (
        (orthographic, [["up", "right"], ["up", "z"], ["right", "z"]]),
        (small_views, [["up", "right"], ["up", "z"]]),
    ):
        drawing = draw(engine, scene(engine))
        root = ElementTree.fromstring(drawing)  # noqa: S314 - our own
        _, _, width, height = map(float, (root.get("viewBox") or "").split())
        assert "nan" not in drawing
        views = [group for group in root.iter(f"{SPACE}g") if group.get("class") == "view"]
        for view in views:
            left, top = places(view)
            for path in view.iter(f"{SPACE}path"):
                for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path.get("d") or ""):
                    assert -0.5 <= left + float(x) <= width + 0.5
                    assert -0.5 <= top + float(y) <= height + 0.5
            title = view.find(f"{SPACE}title")
            assert title is not None
            assert (title.text or "").startswith(engine.name)
        assert [[text.text for text in view.iter(f"{SPACE}text")][-2:] for view in views] == axes


def places(view: ElementTree.Element) -> tuple[float, float]:
    """Where the upper left corner of a view is."""
    numbers = re.findall(r"-?[\d.]+", view.get("transform") or "")
    return float(numbers[0]), float(numbers[1])


def test_views_are_in_third_angle_projection_and_aligned() -> None:
    """The view from the right is at the right, the one from above is above; edges correspond."""
    engine = crankstar.load("v8-cross-plane")
    shown = scene(engine)
    root = ElementTree.fromstring(orthographic(engine, shown))  # noqa: S314 - our own
    front, side, plan = (group for group in root.iter(f"{SPACE}g") if group.get("class") == "view")
    assert places(side)[0] > places(front)[0]
    assert places(side)[1] == places(front)[1]
    assert places(plan)[0] == places(front)[0]
    assert places(plan)[1] < places(front)[1]
    # the same point has one height in front and side view, and one place across in plan and front
    for point in ((0.1, 0.2, 0.3), shown.low, shown.high):
        assert FRONT.turned(*point)[1] == SIDE.turned(*point)[1]
        assert FRONT.turned(*point)[0] == PLAN.turned(*point)[0]
    # what is nearest to the front view is the front of the engine
    assert SIDE.turned(0, 0, 1)[0] < SIDE.turned(0, 0, 0)[0]
    assert PLAN.turned(0, 0, 1)[1] < PLAN.turned(0, 0, 0)[1]
    (symbol,) = (g for g in root.iter(f"{SPACE}g") if g.get("class") == "projection")
    circles = [float(circle.get("cx") or 0) for circle in symbol.iter(f"{SPACE}circle")]
    cone = next(symbol.iter(f"{SPACE}path")).get("d") or ""
    corners = [(float(x), float(y)) for x, y in re.findall(r"[ML](\d+) (\d+)", cone)]
    assert max(circles) < min(x for x, _ in corners)  # third angle: circles at the left
    assert abs(corners[0][1] - 14) < abs(corners[1][1] - 14)  # of the small end, which faces them


def test_the_views_look_along_the_axes_of_the_frame() -> None:
    """Screen right, up and towards the viewer are right-handed: no view is a mirror image."""
    for look in (FRONT, SIDE, PLAN):
        # up, right, z as right-handed axes x = right, y = up, z to the front
        rows = np.array([look.turned(*unit) for unit in ((0, 1, 0), (1, 0, 0), (0, 0, 1))])
        assert np.linalg.det(rows) == pytest.approx(1)
    assert SIDE.turned(0, 0, 1)[0] < 0  # the front at the left
    assert PLAN.turned(1, 0, 0)[2] > 0  # from above


def test_the_pistons_of_a_v8_are_drawn_at_the_heights_of_the_cosine() -> None:
    """Cylinder 1 is at the top; 90 degrees on, cos = 0; the front view has eight pistons."""
    engine = crankstar.load("v8-cross-plane")
    drawn = scene(engine)
    heights = []
    for cylinder, place in zip(drawn.cylinders, placed(engine), strict=True):
        along = place.piston / np.exp(1j * cylinder.bearing)
        psi = cylinder.throw_angle - cylinder.bearing
        want = cylinder.crank_radius * np.cos(psi) + np.sqrt(
            cylinder.rod_length**2 - (cylinder.crank_radius * np.sin(psi)) ** 2
        )
        assert along.imag == pytest.approx(0, abs=1e-12)
        heights.append(along.real - want)
    assert np.abs(heights).max() < 1e-12


def test_the_name_of_an_engine_is_text_in_a_drawing() -> None:
    engine = with_values(crankstar.load("single"), name="</title><script>")
    for draw in (orthographic, small_views):
        assert "<script" not in draw(engine, scene(engine))


def test_the_numbers_of_a_bank_are_within_the_drawing() -> None:
    """All four of a bank of a V8 stand at the left of its front view; the first was cut off."""
    engine = crankstar.load("v8-flat-plane")
    for draw in (orthographic, small_views):
        root = ElementTree.fromstring(draw(engine, scene(engine)))  # noqa: S314 - our own
        left = float((root.get("viewBox") or "").split()[0])
        (label,) = [text for text in root.iter(f"{SPACE}text") if text.text == "1, 3, 5, 7"]
        assert float(label.get("x") or "nan") - 30 >= left
