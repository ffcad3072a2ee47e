"""The layout of mounts in the editor: put, dragged, moved by keys, taken away, undone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, expect
from tests.mounted_engines import standing
from tests.web.browsing import barriers, drag, too_wide, watched
from tests.web.engine_page import HANDLE
from tests.web.overflow import overflows
from tests.web.serving import Server
from tests.web.test_editing import REFUSED, dropped

from crankstar.dynamics.mount_analysis import mounts
from crankstar.files import engine_of, toml
from crankstar.files.catalog import load


@pytest.fixture
def laying(browser: Browser, server: Server) -> Iterator[Page]:
    """The page of the shared server with the editor open, without complaints."""
    complaints: list[str] = []
    with watched(browser, complaints, width=1200, height=900) as page:
        page.goto(f"{server.address}#tab=edit&a=0")
        page.locator(".editor .form .field").first.wait_for()
        yield page
    told = [line for line in complaints if not REFUSED.search(line)]
    assert told == []


def file_of(page: Page) -> dict[str, Any]:
    """The engine on the stage as a file."""
    return page.evaluate(f"() => {HANDLE}.exhibits[0].file")


def waiting(page: Page, condition: str) -> None:
    """Until something holds of the `file` of the engine on the stage."""
    known = f"const file = {HANDLE}.exhibits[0].file"
    page.wait_for_function(f"() => {{ {known}; return {condition} }}")


def unfolded(page: Page) -> Locator:
    """The layout, its group open."""
    expect(page.locator('[id="edit:name"]')).to_have_value(file_of(page)["name"])
    group = page.locator("details", has=page.locator("> summary", has_text="Block and mounts"))
    group.evaluate("own => { own.open = true }")
    layout = page.locator(".mount-layout")
    expect(layout).to_be_visible()
    layout.scroll_into_view_if_needed()
    return layout


def handle_of(page: Page, side: str, thing: str) -> Locator:
    return page.locator(f'.mount-layout .of-{side} [data-thing="{thing}"]')


def place(page: Page, side: str, thing: str) -> list[float]:
    """Millimetres up, right and to the front, as a reader hears them."""
    label = handle_of(page, side, thing).get_attribute("aria-label") or ""
    return [float(each) for each in re.findall(r"(-?[\d.]+) mm", label)]


def dragged(page: Page, side: str, thing: str, right: float, down: float) -> None:
    """Drags a thing of a view by so many pixels, finely."""
    box = handle_of(page, side, thing).locator("rect, circle:not(.grip)").first.bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.keyboard.down("Shift")
    drag(page, (x, y), (x + right / 2, y + down / 2), (x + right, y + down))
    page.keyboard.up("Shift")


def pixels(page: Page, side: str) -> float:
    """Pixels to a millimetre of a view."""
    return page.locator(f".mount-layout .of-{side} svg").evaluate(
        "svg => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width"
    ) * (300 / frame_width(page, side))


def frame_width(page: Page, side: str) -> float:
    """Millimetres that a view is broad, by two mounts whose places are known."""
    first, second = (
        handle_of(page, side, thing).evaluate("own => own.transform.baseVal[0].matrix.e")
        for thing in ("mount 0", "mount 1")
    )
    one, other = place(page, side, "mount 0"), place(page, side, "mount 1")
    return 300 * (other[1] - one[1]) / (second - first)


@pytest.mark.release
def test_an_engine_without_mass_is_asked_for_it_and_put_on_mounts(laying: Page) -> None:
    page = laying
    dropped(page, toml(load("audi-25-tfsi")))
    waiting(page, "file.name.startsWith('Audi')")
    layout = unfolded(page)
    expect(layout.get_by_text("How heavy is the engine?")).to_be_visible()
    estimate = layout.get_by_role("button", name="Take the estimate")
    told = float(re.findall(r"[\d.]+", estimate.inner_text())[0])
    body = page.evaluate(f"() => {HANDLE}.exhibits[0].whirl.mass")
    assert told == pytest.approx(body, rel=5e-3)
    estimate.click()
    waiting(page, "file.block?.mass !== undefined")
    assert file_of(page)["provenance"]["block.mass"]["status"] == "placeholder"
    expect(layout.get_by_text("How heavy is the engine?")).to_have_count(0)
    page.get_by_role("button", name="Undo").click()
    box = layout.get_by_label("Mass of the engine")
    box.fill("171.5")
    box.press("Enter")
    waiting(page, "file.block?.mass === '171.5 kg'")
    layout.get_by_role("button", name="Put it on four mounts").click()
    waiting(page, "file.mounts?.length === 4")
    engine = engine_of(file_of(page))
    bounce = next(mode for mode in mounts(engine).modes if mode.energy[0] > 0.9)
    assert 7 < bounce.frequency < 11
    expect(page.get_by_role("tab", name="Mounts")).to_have_count(1)


def test_a_mount_is_dragged_and_undone(laying: Page) -> None:
    page = laying
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    unfolded(page)
    was = place(page, "front", "mount 1")
    assert was == [40, 310, 90]
    scale = pixels(page, "front")
    dragged(page, "front", "mount 1", -40, 24)
    up, right, along = place(page, "front", "mount 1")
    assert (up, right) == pytest.approx((40 - 24 / scale, 310 - 40 / scale), abs=2)
    assert along == 90
    waiting(page, f"file.mounts[1].right === '{right:g} mm'")
    assert file_of(page)["mounts"][1]["up"] == f"{up:g} mm"
    page.get_by_role("button", name="Undo").click()
    assert place(page, "front", "mount 1") == was


@pytest.mark.release
def test_a_mount_is_dragged_in_each_view_and_undone(laying: Page) -> None:
    page = laying
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    unfolded(page)
    dragged(page, "front", "mount 1", -40, 24)
    up, right, along = place(page, "front", "mount 1")
    # the plan has z to the left and right downward
    dragged(page, "plan", "mount 1", 30, 20)
    _up, across, front = place(page, "plan", "mount 1")
    assert across > right
    assert front < along
    page.get_by_role("button", name="Show the side view").click()
    dragged(page, "side", "mount 2", -25, -25)
    upward, level, ahead = place(page, "side", "mount 2")
    assert upward > -20
    assert ahead > -480
    assert level == 0
    page.get_by_role("button", name="Undo").click()
    assert place(page, "side", "mount 2") == [-20, 0, -480]
    page.get_by_role("button", name="Undo").click()
    page.get_by_role("button", name="Undo").click()
    assert place(page, "front", "mount 1") == [40, 310, 90]
    page.get_by_role("button", name="Redo").click()
    assert place(page, "front", "mount 1") == [up, right, along]
    waiting(page, f"file.mounts[1].right === '{right:g} mm' && file.mounts[1].z === '90 mm'")


@pytest.mark.release
def test_keys_move_mounts_and_the_centre_of_mass(laying: Page) -> None:
    page = laying
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    unfolded(page)
    handle_of(page, "front", "mount 0").focus()
    for key in ("ArrowUp", "ArrowUp", "Shift+ArrowRight", "ArrowLeft"):
        page.keyboard.press(key)
    assert place(page, "front", "mount 0") == [50, -324, 110]
    handle_of(page, "plan", "centre").focus()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("Shift+ArrowDown")
    assert place(page, "plan", "centre") == [90, -14, -35]
    waiting(page, "file.block.z === '-35 mm'")
    assert file_of(page)["block"]["right"] == "-14 mm"
    centre = page.evaluate(f"() => {HANDLE}.exhibits[0].mounts.centres[0]")
    assert centre == pytest.approx([0.09, -0.014, -0.035])


@pytest.mark.release
def test_mounts_are_added_removed_and_changed_by_number(laying: Page) -> None:
    page = laying
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    layout = unfolded(page)
    layout.get_by_role("button", name="Add a mount").click()
    waiting(page, "file.mounts?.length === 4")
    added = file_of(page)["mounts"][3]
    assert added["name"] == "mount 4"
    assert (added["right"], added["z"]) == ("200 mm", "-480 mm")
    handle_of(page, "front", "mount 1").focus()
    layout.get_by_role("button", name="Remove right").click()
    waiting(page, "file.mounts?.length === 3")
    assert [mount["name"] for mount in file_of(page)["mounts"]] == ["left", "rear", "mount 4"]
    handle_of(page, "plan", "mount 2").focus()
    layout.get_by_role("button", name="Numbers of mount 4").click()
    box = page.locator('[id="edit:mounts[3].right"]')
    box.fill("250 mm")
    waiting(page, "file.mounts[2].right === '250 mm'")
    assert place(page, "front", "mount 2")[1] == 250
    stiff = page.locator('[id="edit:mounts[3].stiffness"]')
    stiff.fill("175 N/mm, 80 N/mm, 60")
    waiting(page, "file.mounts[2].stiffness?.[2] === '60 N/m'")
    assert file_of(page)["mounts"][2]["stiffness"] == ["175 N/mm", "80 N/mm", "60 N/m"]
    stiff.fill("90 N/mm")
    waiting(page, "file.mounts[2].stiffness === '90 N/mm'")
    bearing = page.locator('[id="edit:mounts[3].bearing"]')
    bearing.fill("-30 deg")
    waiting(page, "file.mounts[2].bearing === '-30 deg'")
    axes = page.evaluate(f"() => {HANDLE}.exhibits[0].mounts.mounts[2].axes[0]")
    assert axes[1] < -0.3


@pytest.mark.release
def test_a_mount_is_dragged_on_the_stage(laying: Page) -> None:
    page = laying
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    page.get_by_role("radio", name="Front").check(force=True)
    page.wait_for_function(f"() => {HANDLE}.read().panes.every(each => each.camera === 'front')")
    (pane,) = page.evaluate(f"() => {HANDLE}.read().panes")
    box = page.locator(".stage .canvas").bounding_box()
    assert box
    x = box["x"] + pane["origin"][0] + 0.310 * pane["scale"]
    y = box["y"] + pane["origin"][1] - 0.040 * pane["scale"]
    drag(page, (x, y), (x - 10, y + 15), (x - 20, y + 30))
    waiting(page, "file.mounts[1].right !== '310 mm'")
    now = file_of(page)["mounts"][1]
    right, up = (float(now[key].split()[0]) for key in ("right", "up"))
    assert right == pytest.approx(310 - 20e3 / pane["scale"], abs=3)
    assert up == pytest.approx(40 - 30e3 / pane["scale"], abs=3)
    assert now["z"] == "90 mm"


@pytest.mark.release
def test_an_engine_in_its_own_units_says_what_it_lacks(laying: Page) -> None:
    page = laying
    dropped(page, toml(load("v12-60")))
    waiting(page, "file.name === 'V12, 60 deg'")
    expect(page.locator('[id="edit:name"]')).to_have_value("V12, 60 deg")
    page.locator("summary", has_text="Block and mounts").first.click()
    expect(page.get_by_text("Mounts need masses and lengths in units")).to_be_visible()


@pytest.mark.release
@pytest.mark.parametrize(("width", "scheme"), [(390, "dark"), (320, "light"), (1280, "dark")])
def test_the_layout_is_used_by_everyone_on_every_screen(
    laying: Page, width: int, scheme: Any
) -> None:
    page = laying
    page.set_viewport_size({"width": width, "height": 800})
    page.emulate_media(color_scheme=scheme)
    dropped(page, toml(standing()))
    waiting(page, "file.mounts?.length === 3")
    unfolded(page)
    assert too_wide(page) == []
    assert overflows(page) == []
    assert barriers(page) == []
