"""The drawn engine in a browser: cameras, the free view, the whirl, places of pins."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page
from tests.web.browsing import drag
from tests.web.engine_page import CARD, COUNTED, drawn, farthest_off, handle, opened

from crankstar.files.catalog import load

Build = Callable[..., Path]
ENGINE = "audi-25-tfsi"
QUIET = "a=40&force=0&couple=0"
ONE_MOVE = """() => {
    const page = document.querySelector('[data-crankstar]').crankstar
    page.theta = 41
    page.read()
    const canvas = document.querySelector('canvas[role=img]')
    return [window.corners, canvas.width === canvas.clientWidth]
}"""
FINELY = """() => {
    const canvas = document.querySelector('canvas[role=img]')
    return canvas.width === 2 * canvas.clientWidth
}"""
CHANGES = (
    "camera=plan",
    "glass=0",
    "glow=0",
    "theme=dark",
    "force=1",
    "force=1&each=cylinders",
    "force=1&scale=2",
    "couple=1",
    "whirl=1000",
    "fitted=1",
)


def stage(page: Page) -> Locator:
    """The element the engine is drawn on."""
    return page.locator("canvas[role=img]")


def seen(page: Page) -> bytes:
    """The picture of the stage as it is now."""
    return stage(page).screenshot()


@pytest.mark.release
def test_every_camera_draws_something_else_and_comes_back_to_the_same(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CARD)
    path = built_page(ENGINE)
    pictures: dict[str, bytes] = {}
    descriptions = set()
    for camera in ("front", "plan", "side", "isometric", "orbit", "front"):
        opened(page, path, f"{QUIET}&camera={camera}")
        page.reload()
        page.wait_for_function("document.querySelector('[data-crankstar]')?.crankstar")
        picture = seen(page)
        assert pictures.setdefault(camera, picture) == picture
        descriptions.add(stage(page).get_attribute("aria-label"))
    assert len(set(pictures.values())) == len(descriptions) == 5


@pytest.mark.release
def test_what_changes_is_drawn_and_what_does_not_is_not_drawn_again(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CARD)
    page.add_init_script(COUNTED)
    opened(page, built_page(ENGINE), "a=40&force=0&couple=0")
    for change in CHANGES:
        before = page.evaluate("drawings")
        page.evaluate(f"location.hash = 'a=40&{change}'")
        after = page.evaluate("drawings")
        assert after > before, change
        page.get_by_role("tab", name="Strokes").click()
        page.get_by_role("tab", name="Orders").click()
        assert page.evaluate("drawings") == after, change
    before = page.evaluate("drawings")
    page.locator(".stage .canvas").evaluate("place => { place.style.width = 'calc(100% - 0.3px)' }")
    assert page.evaluate("drawings") > before, (
        "what has another size, though the same in whole pixels, is empty until it is drawn"
    )


@pytest.mark.release
def test_keys_and_dragging_turn_the_free_view_and_home_puts_it_back(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CARD)
    opened(page, built_page(ENGINE), f"{QUIET}&camera=orbit")
    begun = seen(page)
    stage(page).focus()
    page.keyboard.press("ArrowRight")
    turned = seen(page)
    assert turned != begun
    assert handle(page, "theta") == pytest.approx(40), (
        "the key belongs to the view, not to the crank"
    )
    page.keyboard.press("Home")
    stage(page).blur()
    assert seen(page) == begun
    box = stage(page).bounding_box()
    assert box
    drag(page, *((box["x"] + across, box["y"] + 150) for across in (200, 220, 240, 260)))
    assert seen(page) != begun


@pytest.mark.release
def test_on_the_fixed_cameras_the_wheel_scrolls_the_page_and_turns_nothing(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), f"{QUIET}&camera=front")
    prevented = (
        "canvas => !canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: 9, cancelable: true }))"
    )
    assert stage(page).evaluate(prevented) is False
    opened(page, built_page(ENGINE), f"{QUIET}&camera=orbit")
    assert stage(page).evaluate(prevented) is True


@pytest.mark.release
def test_the_whirl_moves_all_that_is_drawn_and_is_taken_away_from_what_is_read(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), f"{QUIET}&camera=side")
    still = seen(page)
    opened(page, built_page(ENGINE), f"{QUIET}&camera=side&whirl=300")
    assert seen(page) != still
    assert farthest_off(load(ENGINE), drawn(page)) < 1e-6


@pytest.mark.parametrize(
    "name",
    [
        "napier-deltic",
        *(pytest.param(n, marks=pytest.mark.release) for n in ("audi-25-tfsi", "radial-9")),
    ],
)
def test_crank_pins_are_drawn_where_their_shafts_carry_them(
    name: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page(name), "a=77")
    engine = load(name)
    read = handle(page, "read().pins")
    for shaft, pins in zip(engine.shafts, read, strict=True):
        assert len(pins) == len(shaft.throws)
        for throw, (up, right, _) in zip(shaft.throws, pins, strict=True):
            bearing = throw.angle + engine.sense * float(shaft.speed_ratio) * math.radians(77)
            place = (
                shaft.up + throw.radius * math.cos(bearing),
                shaft.right + throw.radius * math.sin(bearing),
            )
            assert math.dist((up, right), place) < 2e-6 * throw.radius


@pytest.mark.release
def test_a_graphics_card_that_goes_away_and_comes_back_leaves_the_same_picture(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CARD)
    opened(page, built_page(ENGINE), f"{QUIET}&camera=front")
    before = seen(page)
    taken = """async canvas => {
        const card = canvas.getContext('webgl2').getExtension('WEBGL_lose_context')
        const happened = name => new Promise(
            done => canvas.addEventListener(name, done, { once: true }))
        const [lost, found] = [happened('webglcontextlost'), happened('webglcontextrestored')]
        card.loseContext()
        await lost
        setTimeout(() => card.restoreContext())
        await found
    }"""
    stage(page).evaluate(taken)
    assert seen(page) == before


CORNERS = """const clear = WebGL2RenderingContext.prototype.clear
window.corners = 0
WebGL2RenderingContext.prototype.clear = function (...what) {
  window.corners = 0; clear.apply(this, what)
}
const drawn = WebGL2RenderingContext.prototype.drawElementsInstanced
WebGL2RenderingContext.prototype.drawElementsInstanced = function (...what) {
  window.corners += what[1] * what[4]; drawn.apply(this, what)
}"""
"""How many corners of triangles the last drawing of the stage had."""


@pytest.mark.release
def test_without_a_graphics_card_what_moves_is_drawn_coarsely_and_finely_once_it_rests(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(CORNERS)
    opened(page, built_page(ENGINE), f"{QUIET}&camera=front")
    page.wait_for_function(FINELY)
    fine, pistons = seen(page), handle(page, "read().pistons")
    corners = page.evaluate("corners")
    # in one script: what rests is drawn finely when it is asked for
    rough, coarse = page.evaluate(ONE_MOVE)
    assert coarse
    assert 0 < rough < 0.7 * corners
    handle(page, "theta = 40")
    page.wait_for_function(FINELY)
    assert page.evaluate("corners") == corners
    assert seen(page) == fine
    assert handle(page, "read().pistons") == pistons


PAPER = """() => {
    dispatchEvent(new Event('beforeprint'))
    const shown = [...document.querySelectorAll('.canvas canvas')]
    const [paper, ...others] = shown.filter(canvas => canvas.style.visibility !== 'hidden')
    const { data } = paper.getContext('2d').getImageData(0, 0, paper.width, paper.height)
    let painted = 0
    for (let at = 3; at < data.length; at += 4) painted += data[at] > 0
    dispatchEvent(new Event('afterprint'))
    return [painted / (paper.width * paper.height), others.length]
}"""
"""The share of the printed picture that is painted, and how many other canvases are printed."""


@pytest.mark.release
@pytest.mark.parametrize("theme", ["light", pytest.param("dark", marks=pytest.mark.release)])
def test_what_is_printed_shows_the_engine(theme: str, built_page: Build, page: Page) -> None:
    page.add_init_script(CARD)
    opened(page, built_page(ENGINE), f"a=40&theme={theme}")
    before = seen(page)
    painted, others = page.evaluate(PAPER)
    assert painted > 0.1
    assert others == 0
    assert b"/Subtype /Image" in page.pdf()
    assert seen(page) == before
