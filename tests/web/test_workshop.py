"""The workshop of the Edit panel in a real browser, by a real `crankstar serve`."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from html import unescape
from math import cos, radians, sin
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, Route, expect
from tests.web.browsing import barriers, drag, release, watched
from tests.web.serving import Server
from tests.web.test_editing import REFUSED, bank_angles, eventually, on_stage

import crankstar
from crankstar.files import catalog
from crankstar.files.rearranged import rearranged
from crankstar.tables.html import typeset

PANES = "document.querySelector('[data-crankstar]').crankstar.read().panes"


@pytest.fixture
def bench(browser: Browser, server: Server) -> Iterator[Page]:
    """The page of the shared server with the workshop open, the V8 at rest, no complaints."""
    complaints: list[str] = []
    with watched(browser, complaints, width=1280, height=900) as page:
        opened(page, server)
        yield page
    told = [line for line in complaints if not REFUSED.search(line)]
    if told:
        pytest.fail("\n".join(["the page complains:", *dict.fromkeys(told)]), pytrace=False)


def opened(page: Page, server: Server, state: str = "tab=edit&a=0") -> None:
    page.goto(f"{server.address}#{state}")
    ready(page)


def ready(page: Page) -> None:
    """The server has said what can be changed in the engine, and what the sliders leave."""
    page.locator(".bench .control").first.wait_for()
    page.locator(".bench .legend:not(.waiting)").first.wait_for()


def file_of(page: Page) -> dict[str, Any]:
    return on_stage(page)["file"]


def control(page: Page, key: str) -> Locator:
    return page.locator(f'[data-control="{key}"]')


@pytest.mark.release
@pytest.mark.parametrize("share", [0.02, 0.98])
def test_what_a_held_slider_says_covers_no_label(bench: Page, share: float) -> None:
    row = bench.locator(".bench .control:has(.sweep)").first
    slider = row.get_by_role("slider")
    slider.scroll_into_view_if_needed()
    place = slider.bounding_box()
    assert place is not None
    across, down = place["x"] + share * place["width"], place["y"] + place["height"] / 2
    drag(bench, (across, down), (across + 1, down), hold=True)
    told = row.locator(".readout").bounding_box()
    label, sweep = row.locator("label").bounding_box(), row.locator(".sweep").bounding_box()
    release(bench)
    assert told is not None
    assert label is not None
    assert sweep is not None
    assert told["y"] >= label["y"] + label["height"]
    assert told["x"] >= sweep["x"] - 1
    assert told["x"] + told["width"] <= sweep["x"] + sweep["width"] + 1


@pytest.mark.release
@pytest.mark.many(first=1)
def test_another_number_of_cylinders_is_an_engine_that_fires(bench: Page) -> None:
    bench.get_by_role("button", name="10 cylinders").click()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 10)
    wanted = rearranged(catalog.tree_of("v8-cross-plane")[1], cylinders=10)
    assert file_of(bench) == wanted.tree
    expect(bench.locator(".bench .decided")).to_contain_text(wanted.sentences[0])
    expect(bench.locator("h1")).to_have_text("V10, 90 deg")
    orders = bench.get_by_role("group", name="Firing order")
    other = orders.locator('[aria-pressed="false"]').first
    text = other.inner_text()
    other.click()
    eventually(lambda: "-".join(map(str, file_of(bench)["firing_order"])), text)
    expect(bench.locator("h1")).to_have_text("V10, 90 deg, edited")
    bench.get_by_role("button", name="Undo").click()
    bench.get_by_role("button", name="Undo").click()
    expect(bench.locator("h1")).to_have_text("V8, cross-plane crank, 90 deg")


@pytest.mark.release
def test_a_usual_layout_is_one_click_away(bench: Page) -> None:
    bench.get_by_text("Usual layouts").click()
    bench.get_by_role("button", name="Twin 270°").click()
    eventually(lambda: file_of(bench)["layout"].get("throws"), ["0 deg", "90 deg"])
    expect(bench.locator("h1")).to_have_text("Parallel twin, 270 deg")
    expect(control(bench, "layout.throws[2]")).to_be_visible()
    expect(control(bench, "layout.bank_angle")).to_have_count(0)


@pytest.mark.release
def test_a_slider_moves_both_banks_and_its_curve_is_that_of_the_sweep(bench: Page) -> None:
    slider = bench.get_by_role("slider", name="Bank angle")
    slider.focus()
    bench.keyboard.press("ArrowLeft")
    bearings = lambda: [bank["bearing"] for bank in file_of(bench)["layout"]["banks"]]  # noqa: E731
    eventually(bearings, ["44.5 deg", "-44.5 deg"])
    bench.keyboard.press("Shift+ArrowLeft")
    eventually(lambda: file_of(bench)["layout"]["banks"][0]["bearing"], "44.45 deg")
    expect(slider).to_have_attribute("aria-valuetext", "88.9°")
    ready(bench)
    legend = control(bench, "layout.bank_angle").locator(".legend li").first
    expect(legend).to_contain_text("Primary couple")
    swept = crankstar.sweep("v8-cross-plane", "layout.bank_angle=0, 88.9 deg")
    size = crankstar.watched(swept, "couple", order=1).values[1]
    expect(legend.locator("b")).to_have_text(f"{float(f'{size:.4g}'):g} m r ω² a")
    fact = next(fact for fact in on_stage(bench)["verdict"] if fact["subject"] == "couple")
    expect(bench.locator(".bench .remains")).to_contain_text(unescape(typeset(fact["sentence"])))


@pytest.mark.release
def test_a_number_that_is_typed_takes_any_unit_of_its_kind(bench: Page) -> None:
    box = control(bench, "cylinder.rod_ratio").get_by_role("textbox")
    box.fill("3,5")
    eventually(lambda: file_of(bench)["cylinder"]["rod_ratio"], 3.5)
    split = control(bench, "layout.pin_split").get_by_role("textbox")
    split.fill("0.1 rad")
    eventually(lambda: file_of(bench)["layout"].get("pin_split"), "0.1 rad")
    box.fill("４.５")  # of a Japanese keyboard
    eventually(lambda: file_of(bench)["cylinder"]["rod_ratio"], 4.5)
    box.fill("350%")
    eventually(lambda: file_of(bench)["cylinder"]["rod_ratio"], 3.5)


@pytest.mark.release
def test_what_is_no_value_is_said_beside_its_box_and_changes_nothing(bench: Page) -> None:
    before = file_of(bench)
    angle = control(bench, "layout.bank_angle")
    box = angle.get_by_role("textbox")
    for nonsense in ("abc", "45 kg", ""):
        box.fill(nonsense)
        expect(box).to_have_attribute("aria-invalid", "true")
        expect(angle.get_by_role("alert")).to_contain_text("Type one such as 90 deg")
    assert file_of(bench) == before
    box.fill("60")
    expect(angle.get_by_role("alert")).to_have_count(0)
    box.press("Enter")
    box.fill("75")
    eventually(lambda: file_of(bench)["layout"]["banks"][0]["bearing"].split()[0], "37.5")
    bench.get_by_role("button", name="Undo").click()
    eventually(lambda: file_of(bench)["layout"]["banks"][0]["bearing"].split()[0], "30")


@pytest.mark.release
def test_a_throw_is_dragged_on_the_star_and_rests_at_angles_that_make_sense(bench: Page) -> None:
    pin = bench.get_by_role("slider", name="Crank pin 2")
    pin.scroll_into_view_if_needed()
    star = bench.locator(".bench .star svg").bounding_box()
    knob = pin.locator(".knob").bounding_box()
    assert star is not None
    assert knob is not None
    middle = (star["x"] + star["width"] / 2, star["y"] + star["height"] / 2)
    press = (knob["x"] + knob["width"] / 2, knob["y"] + knob["height"] / 2)
    way = (radians(45 + angle) for angle in (100, 118))  # of pin 1, and nearly 120
    places = ((middle[0] + 60 * sin(angle), middle[1] - 60 * cos(angle)) for angle in way)
    drag(bench, press, *places, hold=True)
    expect(bench.locator(".bench .star figcaption")).to_have_text("Pin 2: 120°")
    release(bench)
    eventually(lambda: file_of(bench)["layout"]["throws"][1], "120 deg")
    pin.focus()
    bench.keyboard.press("Shift+ArrowRight")
    eventually(lambda: file_of(bench)["layout"]["throws"][1], "120.1 deg")
    expect(bench.locator(".mistakes")).to_have_count(0)


@pytest.mark.release
def test_a_bank_is_dragged_on_the_front_view(bench: Page) -> None:
    pane = next(each for each in bench.evaluate(PANES) if each["camera"] == "front")
    box = bench.locator(".stage .canvas").bounding_box()
    assert box is not None
    head = on_stage(bench)["scene"]["cylinders"][0]["bore_to"] * pane["scale"] * 0.8

    def place(bearing: float) -> tuple[float, float]:
        x, y = pane["origin"]
        angle = radians(bearing)
        return box["x"] + x + head * sin(angle), box["y"] + y - head * cos(angle)

    drag(bench, place(45), place(38), place(31), hold=True)
    expect(bench.locator(".stage-readout")).to_have_text("Bank angle: 60°")
    release(bench)
    eventually(lambda: bank_angles(bench), [30, -30])
    expect(bench.locator(".stage-readout")).to_have_count(0)
    bench.get_by_role("button", name="Undo").click()
    eventually(lambda: bank_angles(bench), [45, -45])


@pytest.mark.release
def test_the_heading_is_renamed_with_a_click(bench: Page) -> None:
    bench.get_by_role("heading", level=1).get_by_role("button").click()
    bench.get_by_role("textbox", name="Name of the engine").fill("mine")
    bench.keyboard.press("Enter")
    expect(bench.locator("h1")).to_have_text("mine")
    eventually(lambda: file_of(bench)["name"], "mine")


@pytest.mark.release
def test_the_history_leads_back_to_any_step(bench: Page) -> None:
    for count in (10, 12):
        bench.get_by_role("button", name=f"{count} cylinders").click()
        eventually(lambda: len(on_stage(bench)["cylinders"]), count)
        ready(bench)
    bench.get_by_text(re.compile(r"^History")).click()
    steps = bench.locator(".steps li button")
    expect(steps).to_have_count(3)
    steps.nth(1).click()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 10)
    expect(steps.nth(1)).to_have_attribute("aria-current", "step")


@pytest.mark.release
def test_back_and_forward_step_through_panels_and_edits(bench: Page) -> None:
    bench.get_by_role("button", name="10 cylinders").click()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 10)
    eventually(lambda: "engine=" in bench.evaluate("location.hash"), wanted=True)
    bench.get_by_role("tab", name="Verdict").click()
    eventually(lambda: "tab=verdict" in bench.evaluate("location.hash"), wanted=True)
    bench.go_back()
    expect(bench.get_by_role("tab", name="Edit")).to_have_attribute("aria-selected", "true")
    assert len(on_stage(bench)["cylinders"]) == 10
    bench.go_back()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 8)
    bench.go_forward()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 10)
    bench.go_forward()
    expect(bench.get_by_role("tab", name="Verdict")).to_have_attribute("aria-selected", "true")
    # what was looked at again is no further step of the history
    bench.get_by_role("tab", name="Edit").click()
    bench.get_by_text(re.compile(r"^History")).click()
    expect(bench.locator(".steps li")).to_have_count(2)


@pytest.mark.release
def test_engines_are_kept_shown_beside_exported_deleted_and_taken_in_again(
    bench: Page, tmp_path: Path
) -> None:
    shelf = bench.locator(".shelf")
    bench.get_by_text(re.compile(r"^Kept engines")).click()
    shelf.get_by_role("button", name="Keep this engine").click()
    rows = shelf.locator("li")
    expect(rows).to_have_count(1)
    shelf.get_by_role("button", name=re.compile("^Beside: V8")).click()
    expect(bench.locator("h1")).to_have_count(2)
    with bench.expect_download() as download:
        shelf.get_by_role("button", name="Export all").click()
    place = tmp_path / "engines.json"
    download.value.save_as(place)
    assert json.loads(place.read_text())["engines"][0]["tree"] == file_of(bench)
    shelf.get_by_role("button", name=re.compile("^Rename: V8")).click()
    shelf.get_by_role("textbox", name="Name").fill("kept one")
    bench.keyboard.press("Enter")
    shelf.get_by_role("button", name="Delete: kept one").click()
    expect(rows).to_have_count(0)
    shelf.get_by_role("button", name="Undo the deletion").click()
    expect(rows).to_have_count(1)
    bench.get_by_label("File of kept engines to import").set_input_files(place)
    expect(rows).to_have_count(2)
    bench.reload()
    bench.get_by_text("Kept engines (2)").click()
    shelf.get_by_role("button", name="Open: kept one").click()
    expect(bench.locator("h1").first).to_have_text("kept one")


@pytest.mark.release
def test_a_store_that_is_full_is_said(bench: Page) -> None:
    bench.evaluate(
        "() => { Storage.prototype.setItem = () => { throw new DOMException('', "
        "'QuotaExceededError') } }"
    )
    bench.get_by_text(re.compile(r"^Kept engines")).click()
    bench.get_by_role("button", name="Keep this engine").click()
    expect(bench.locator(".shelf [role=status]")).to_contain_text("store is full")


@pytest.mark.release
def test_the_engine_that_was_edited_last_is_offered_again(bench: Page, server: Server) -> None:
    bench.get_by_role("button", name="10 cylinders").click()
    kept = "() => localStorage.getItem('crankstar.last') !== null"
    eventually(lambda: bench.evaluate(kept), wanted=True)
    bench.goto("about:blank")
    opened(bench, server)
    bench.get_by_text(re.compile(r"^Kept engines")).click()
    bench.get_by_role("button", name="Your last engine: V10, 90 deg").click()
    eventually(lambda: len(on_stage(bench)["cylinders"]), 10)


@pytest.mark.release
def test_the_workshop_can_be_read_and_used_by_everyone(bench: Page) -> None:
    for title in ("Usual layouts", "History (1)"):
        bench.get_by_text(title).click()
    bench.get_by_text(re.compile(r"^Kept engines")).click()
    bench.get_by_role("button", name="Keep this engine").click()
    bench.get_by_role("button", name="Twin 270°").wait_for()
    for colours in ("light", "dark"):
        bench.emulate_media(color_scheme=colours)
        assert barriers(bench) == []


@pytest.mark.release
def test_the_star_is_there_before_the_curves_of_the_sliders(
    browser: Browser, server: Server
) -> None:
    """What takes long is told, and what is there already can be worked on."""
    with watched(browser, []) as page:
        held: list[Route] = []

        def hold(route: Route) -> None:
            held.append(route)

        page.route("**/api/arrangements", hold)
        page.goto(f"{server.address}#tab=edit&a=0")
        bench = page.get_by_role("region", name="Workshop")
        told = bench.get_by_text("Working out throws, firing orders and sliders")
        expect(told).to_be_visible()
        page.route("**/api/sliders", hold)
        held.pop(0).continue_()
        bench.locator(".star").wait_for()
        expect(told).to_have_count(0)
        for route in held:
            route.continue_()
        ready(page)


@pytest.mark.release
def test_a_link_to_an_unknown_engine_says_so_in_one_sentence(
    browser: Browser, server: Server
) -> None:
    with watched(browser, []) as page:
        page.goto(f"{server.address}#engine=nonesuch")
        told = page.get_by_role("alert")
        told.wait_for()
        expect(told).to_contain_text(
            "“nonesuch”, which cannot be shown: there is no such engine in the catalog"
        )
        expect(told.locator("code")).to_have_text("crankstar list")


@pytest.mark.release
def test_a_pin_that_is_dragged_is_not_framed(bench: Page) -> None:
    pin = bench.locator(".star .pin:not(.fixed)").last
    pin.scroll_into_view_if_needed()
    knob = pin.locator(".knob").bounding_box()
    assert knob is not None
    drag(bench, (knob["x"] + knob["width"] / 2, knob["y"] + knob["height"] / 2), hold=True)
    try:
        assert pin.evaluate("pin => getComputedStyle(pin).outlineStyle") == "none"
    finally:
        release(bench)
