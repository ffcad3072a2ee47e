"""Live editing in a real browser, by a real `crankstar serve`."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Literal

import pytest
from playwright.sync_api import Browser, Locator, Page, expect
from tests.web.browsing import HANG, barriers, drag, release, too_wide, watched
from tests.web.engine_page import CARD, COUNTED
from tests.web.serving import Server, serving

from crankstar import files

HOLDER = "document.querySelector('[data-crankstar]').crankstar"
REFUSED = re.compile(r"console error: Failed to load resource: .* 422 ")
"""Chromium reports every refusal; these tests are about engines that are refused."""
BEARING = "edit:layout.banks[1].bearing"
HOSTILE = "</script><img src=x onerror=alert(1)>"
COLOURS: tuple[Literal["light", "dark"], ...] = ("light", "dark")
WIDTHS = (400, 900, 1600)


@pytest.fixture
def editing(browser: Browser, server: Server) -> Iterator[Page]:
    """The page of the shared server with the editor open, the engine at rest, no complaints."""
    with edited(browser, server) as page:
        yield page


@pytest.fixture
def held_search(browser: Browser) -> Iterator[Page]:
    """The dialog of the search of seven cylinders, on a server whose searches end when stopped."""
    with serving(held=True) as server, edited(browser, server) as page:
        page.get_by_role("button", name="Find a better crank").click()
        dialog = page.get_by_role("dialog")
        dialog.get_by_role("spinbutton", name="Number of cylinders").fill("7")
        yield page


@contextmanager
def edited(browser: Browser, server: Server) -> Iterator[Page]:
    complaints: list[str] = []
    with watched(browser, complaints, width=1000, height=700) as page:
        opened(page, server)
        yield page
    told = [line for line in complaints if not REFUSED.search(line)]
    if told:
        pytest.fail("\n".join(["the page complains:", *dict.fromkeys(told)]), pytrace=False)


def opened(page: Page, server: Server, state: str = "tab=edit&a=0") -> None:
    page.goto(f"{server.address}#{state}")
    page.locator(".editor .form .field").first.wait_for()


def field(page: Page, path: str) -> Locator:
    return page.locator(f'[id="{path if path.startswith("edit:") else f"edit:{path}"}"]')


def on_stage(page: Page) -> dict[str, Any]:
    """The exhibit of the engine on the stage."""
    return page.evaluate(f"{HOLDER}.exhibits[0]")


def eventually(what: Callable[[], Any], wanted: Any) -> None:
    """Asks, each time when the page has settled, until it is as wanted."""
    end = time.monotonic() + HANG / 1000
    while (seen := what()) != wanted:
        assert time.monotonic() < end, f"{seen!r} has not become {wanted!r}"


def bank_angles(page: Page) -> list[float]:
    """Bearings of the cylinders on the stage, whole degrees."""
    degrees = "cylinder => Math.round(cylinder.bearing * 180 / Math.PI)"
    return page.evaluate(f"[...new Set({HOLDER}.exhibits[0].scene.cylinders.map({degrees}))]")


def dropped(page: Page, text: str, name: str = "engine.toml") -> None:
    """Drops a file on the page."""
    page.evaluate(
        """([text, name]) => {
            const data = new DataTransfer()
            data.items.add(new File([text], name))
            for (const kind of ['dragenter', 'dragover', 'drop'])
                document.body.dispatchEvent(new DragEvent(
                    kind, { dataTransfer: data, bubbles: true, cancelable: true }))
        }""",
        [text, name],
    )


@pytest.mark.release
def test_a_bank_angle_that_is_typed_moves_the_bank(editing: Page) -> None:
    assert bank_angles(editing) == [45, -45]
    field(editing, BEARING).fill("30 deg")
    eventually(lambda: bank_angles(editing), [30, -45])
    assert on_stage(editing)["file"]["layout"]["banks"][0]["bearing"] == "30 deg"


@pytest.mark.release
def test_a_bare_number_takes_the_unit_that_was_there(editing: Page) -> None:
    field(editing, BEARING).fill("60")
    eventually(lambda: bank_angles(editing), [60, -45])
    assert on_stage(editing)["file"]["layout"]["banks"][0]["bearing"] == "60 deg"
    field(editing, BEARING).blur()
    expect(field(editing, BEARING)).to_have_value("60 deg")


@pytest.mark.release
def test_of_changes_that_come_faster_than_answers_the_last_is_on_the_stage(editing: Page) -> None:
    editing.evaluate(
        """id => {
            const box = document.getElementById(id)
            for (let angle = 20; angle < 45; angle++) {
                box.value = `${angle} deg`
                box.dispatchEvent(new Event('input', { bubbles: true }))
            }
        }""",
        BEARING,
    )
    assert bank_angles(editing) == [44, -45]
    assert on_stage(editing)["file"]["layout"]["banks"][0]["bearing"] == "44 deg"


@pytest.mark.release
def test_a_change_is_drawn_once(editing: Page) -> None:
    # so wide that another name leaves the stage its size
    editing.set_viewport_size({"width": 1280, "height": 800})
    editing.add_init_script(CARD)
    editing.add_init_script(COUNTED)
    editing.reload()
    for path, key, text in ((BEARING, "layout", "40 deg"), ("edit:name", "name", "another name")):
        field(editing, path).scroll_into_view_if_needed()
        tree, drawings = on_stage(editing)["file"][key], editing.evaluate("drawings")
        field(editing, path).fill(text)
        eventually(lambda key=key, tree=tree: on_stage(editing)["file"][key] != tree, wanted=True)
        assert editing.evaluate("drawings") == drawings + 1, text


@pytest.mark.release
def test_what_is_wrong_stands_beside_its_field_and_the_engine_stays(editing: Page) -> None:
    before = on_stage(editing)
    field(editing, BEARING).fill("forty five")
    sentence = field(editing, f"{BEARING}-wrong")
    expect(sentence).to_contain_text('is "forty five", not a number with a unit')
    expect(field(editing, BEARING)).to_have_attribute("aria-invalid", "true")
    assert (
        f"{BEARING}-wrong"
        in (field(editing, BEARING).get_attribute("aria-describedby") or "").split()
    )
    assert on_stage(editing) == before
    field(editing, BEARING).fill("40 deg")
    expect(sentence).to_have_count(0)
    eventually(lambda: bank_angles(editing), [40, -45])


@pytest.mark.release
def test_the_list_of_mistakes_leads_to_fields_even_where_they_are_folded(editing: Page) -> None:
    editing.locator("summary", has_text="Valves or ports").click()
    opens = field(editing, "valves.intake_opens")
    opens.fill("early")
    expect(editing.locator(".mistakes")).to_contain_text("valves.intake_opens")
    field(editing, "name").focus()
    editing.locator("summary", has_text="Valves or ports").click()
    expect(opens).to_be_hidden()
    editing.locator(".mistakes button", has_text="valves.intake_opens").click()
    expect(opens).to_be_focused()


@pytest.mark.release
def test_undo_and_redo_by_buttons_and_keys(editing: Page) -> None:
    undo = editing.get_by_role("button", name="Undo")
    redo = editing.get_by_role("button", name="Redo")
    expect(undo).to_be_disabled()
    field(editing, BEARING).fill("30 deg")
    field(editing, BEARING).blur()
    field(editing, "edit:layout.banks[2].bearing").fill("-30 deg")
    eventually(lambda: bank_angles(editing), [30, -30])
    undo.click()
    eventually(lambda: bank_angles(editing), [30, -45])
    expect(field(editing, "edit:layout.banks[2].bearing")).to_have_value("-45 deg")
    redo.click()
    eventually(lambda: bank_angles(editing), [30, -30])
    expect(redo).to_be_disabled()
    editing.keyboard.press("Control+z")
    editing.keyboard.press("Control+z")
    eventually(lambda: bank_angles(editing), [45, -45])
    editing.keyboard.press("Control+Shift+Z")
    eventually(lambda: bank_angles(editing), [30, -45])


@pytest.mark.release
def test_a_drag_moves_the_engine_while_it_lasts_and_is_one_step(editing: Page) -> None:
    slider = field(editing, BEARING).locator("xpath=..").locator("input[type=range]")
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    assert box is not None
    middle = box["y"] + box["height"] / 2
    places = [(box["x"] + share * box["width"], middle) for share in (0.625, 0.55, 0.5, 0.45)]
    drag(editing, *places[:2], hold=True)
    angles = [bank_angles(editing)[0]]
    for place in places[2:]:
        editing.mouse.move(*place)
        angles.append(bank_angles(editing)[0])
    assert 45 > angles[0] > angles[1] > angles[2]
    release(editing)
    expect(editing.locator(".editor")).to_have_attribute("aria-busy", "false")
    last = on_stage(editing)["file"]["layout"]["banks"][0]["bearing"]
    assert last == field(editing, BEARING).input_value() != "45 deg"
    editing.get_by_role("button", name="Undo").click()
    eventually(lambda: bank_angles(editing), [45, -45])
    expect(editing.get_by_role("button", name="Undo")).to_be_disabled()


@pytest.mark.release
def test_a_throw_is_turned_by_its_wheel_with_the_mouse_and_the_keys(editing: Page) -> None:
    wheel = editing.get_by_role("slider", name="Throw 2, wheel")
    wheel.scroll_into_view_if_needed()
    box = wheel.bounding_box()
    assert box is not None
    across, down = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    drag(editing, (across + 12, down), (across + 10, down + 10))
    eventually(lambda: on_stage(editing)["file"]["layout"]["throws"][1], "135 deg")
    wheel.focus()
    editing.keyboard.press("ArrowRight")
    eventually(lambda: on_stage(editing)["file"]["layout"]["throws"][1], "136 deg")
    expect(wheel).to_have_attribute("aria-valuetext", "136 degrees clockwise from up")


@pytest.mark.release
def test_a_firing_order_that_no_longer_fits_is_left_out_with_one_click(editing: Page) -> None:
    field(editing, "edit:layout.throws[2]").fill("180 deg")
    expect(field(editing, "edit:firing_order-wrong")).to_contain_text("cannot fire")
    editing.get_by_role("button", name="Remove the firing order").click()
    eventually(lambda: on_stage(editing)["file"]["layout"]["throws"][1], "180 deg")
    expect(editing.locator(".mistakes")).to_have_count(0)


@pytest.mark.release
def test_throws_are_added_moved_and_removed(editing: Page) -> None:
    throws = lambda: [  # noqa: E731
        box.input_value() for box in editing.locator("[id='edit:layout.throws'] input").all()
    ]
    editing.get_by_role("button", name="Throw 2: move up").click()
    assert throws() == ["90 deg", "0 deg", "-90 deg", "180 deg"]
    editing.get_by_role("button", name="Throw 4: remove").click()
    expect(field(editing, "edit:layout.throws-wrong")).to_be_visible()
    editing.get_by_role("button", name="Add throw").click()
    assert throws() == ["90 deg", "0 deg", "-90 deg", "-90 deg"]


@pytest.mark.release
def test_an_engine_of_the_catalog_is_chosen_with_keys_alone(editing: Page) -> None:
    box = editing.get_by_role("combobox", name="Engine of the catalog")
    box.focus()
    editing.keyboard.type("two-stroke tandem racer")
    options = editing.get_by_role("listbox", name="Engines").get_by_role("option")
    count = options.count()
    assert count > 1
    editing.keyboard.press("ArrowDown")
    chosen = editing.locator('[role=option][aria-selected="true"]')
    expect(chosen).to_have_count(1)
    assert box.get_attribute("aria-activedescendant") == chosen.get_attribute("id")
    title = chosen.locator(".title").inner_text()
    editing.keyboard.press("Enter")
    expect(editing.locator("h1")).to_have_text(title)
    expect(editing.get_by_label("Type", exact=True)).to_have_value("tandem")


@pytest.mark.release
def test_another_layout_begins_as_an_engine(editing: Page) -> None:
    for kind in ("inline", "boxer", "radial", "opposed", "tandem"):
        editing.get_by_label("Type", exact=True).select_option(kind)
        eventually(lambda: on_stage(editing)["file"]["layout"]["type"], kind)
        expect(editing.locator(".mistakes")).to_have_count(0)


@pytest.mark.release
def test_the_explicit_form_is_the_same_engine_part_by_part(editing: Page) -> None:
    before = on_stage(editing)
    editing.get_by_label("Type", exact=True).select_option("explicit")
    eventually(lambda: len(on_stage(editing)["file"].get("shaft", [])), 1)
    after = on_stage(editing)
    assert [len(shaft["throw"]) for shaft in after["file"]["shaft"]] == [4]
    greatest = [[row["greatest"] for row in exhibit["table"]] for exhibit in (before, after)]
    assert greatest[0] == greatest[1]
    editing.get_by_role("button", name="Add weight").click()
    expect(field(editing, "edit:shaft[1].weight[1].unbalance")).to_be_visible()


@pytest.mark.release
def test_every_key_of_the_schema_has_a_field(editing: Page, server: Server) -> None:
    schema = server.ask("api/schema").json
    for _ in range(2):  # what was folded holds folds itself
        editing.evaluate(
            "() => document.querySelectorAll('.editor details:not([open])').forEach(one "
            "=> one.open = true)"
        )
    defined = schema["$defs"]
    wanted = [("", key) for key in defined["ShortVee"]["properties"] if key != "format"]
    wanted += [("layout.", key) for key in defined["Vee"]["properties"]]
    wanted += [("layout.banks[1].", key) for key in defined["Bank"]["properties"]]
    wanted += [("cylinder.", key) for key in defined["Sizes"]["properties"]]
    missing = [
        f"{above}{key}" for above, key in wanted if not field(editing, f"{above}{key}").count()
    ]
    assert not missing


@pytest.mark.release
def test_a_file_is_opened_by_a_drop_wherever_one_looks(editing: Page, server: Server) -> None:
    editing.get_by_role("tab", name="Verdict").click()
    text = server.ask("api/toml", {"engine": "kr250-racer"}).json["toml"]
    editing.evaluate(
        """() => {
            const data = new DataTransfer()
            data.items.add(new File([''], 'x.toml'))
            document.body.dispatchEvent(
                new DragEvent('dragenter', { dataTransfer: data, bubbles: true }))
        }"""
    )
    expect(editing.locator(".edit-dropzone")).to_be_visible()
    dropped(editing, text)
    expect(editing.locator(".edit-dropzone")).to_have_count(0)
    expect(editing.locator("h1")).to_have_text("Kawasaki KR250 racer, counter-rotating, 180 deg")
    expect(
        editing.get_by_role("status").filter(has_text="engine.toml is now in the form")
    ).to_be_visible()


@pytest.mark.release
def test_a_file_that_is_no_engine_is_told_of_and_changes_nothing(editing: Page) -> None:
    before = on_stage(editing)
    dropped(
        editing,
        (
            'format = 1\nname = "x"\n[layout]\ntype = "vee"\nthrows = ["0 deg"]\nbanks = [{ '
            'bearing = "xx" }]\n'
        ),
    )
    expect(editing.locator(".mistakes")).to_contain_text("layout.banks[1]")
    expect(editing.locator("[aria-invalid=true]")).to_have_count(0)
    expect(editing.locator(".mistakes")).to_have_count(1)
    expect(editing.locator(".mistakes")).to_be_in_viewport()
    dropped(editing, "no [toml", "broken.toml")
    expect(editing.locator(".mistakes")).to_contain_text("TOML")
    assert on_stage(editing) == before
    dropped(editing, "x" * 1_000_001, "huge.toml")
    expect(editing.locator(".note")).to_contain_text("huge.toml is too large")


@pytest.mark.release
def test_what_is_saved_is_what_is_on_the_stage(editing: Page, tmp_path: Path) -> None:
    field(editing, BEARING).fill("36 deg")
    eventually(lambda: bank_angles(editing), [36, -45])
    with editing.expect_download() as download:
        editing.get_by_role("button", name="Save as TOML").click()
    assert download.value.suggested_filename == "v8-cross-plane-crank-90-deg-edited.toml"
    place = tmp_path / "saved.toml"
    download.value.save_as(place)
    tree = files.tree_of(place.read_text(encoding="utf-8"), name="saved.toml")
    assert tree == on_stage(editing)["file"]
    assert files.engine_of(tree, name="saved.toml").name == "V8, cross-plane crank, 90 deg, edited"


@pytest.mark.release
def test_a_hostile_name_is_text_everywhere(editing: Page) -> None:
    editing.on("dialog", lambda dialog: pytest.fail(f"the page says {dialog.message}"))
    tree = on_stage(editing)["file"]
    tree["name"] = HOSTILE
    tree["layout"]["banks"][0]["name"] = HOSTILE
    tree["provenance"][HOSTILE] = {"status": "published", "source": HOSTILE}
    dropped(editing, json.dumps(tree), f"{HOSTILE}.json".replace("/", ""))
    expect(editing.locator(".mistakes")).to_contain_text(HOSTILE)
    del tree["provenance"][HOSTILE]
    dropped(editing, json.dumps(tree))
    expect(editing.locator("h1")).to_have_text(HOSTILE)
    expect(editing.locator("summary", has_text=HOSTILE)).to_be_visible()
    editing.get_by_role("button", name="Find a better crank").click()
    expect(editing.get_by_role("dialog")).to_contain_text(HOSTILE)
    assert editing.locator("img").count() == 0


@pytest.mark.release
def test_a_row_of_a_search_becomes_the_engine(editing: Page) -> None:
    editing.get_by_role("button", name="Find a better crank").click()
    dialog = editing.get_by_role("dialog", name="Find a better crank")
    dialog.get_by_role("spinbutton", name="Number of cylinders").fill("7")
    dialog.get_by_role("button", name="Search").click()
    rows = dialog.locator("tbody tr")
    rows.first.wait_for()
    assert rows.count() == 4
    expect(rows.nth(1)).to_contain_text("1-7-2-5-4-3-6")
    expect(dialog).to_contain_text("Proved complete")
    dialog.get_by_role("button", name="Put row 2 on the stage").click()
    expect(dialog).to_be_hidden()
    eventually(lambda: on_stage(editing)["file"]["firing_order"], [1, 7, 2, 5, 4, 3, 6])
    editing.get_by_role("button", name="Undo").click()
    eventually(lambda: bank_angles(editing), [45, -45])


@pytest.mark.release
def test_a_search_is_cancelled(held_search: Page) -> None:
    dialog = held_search.get_by_role("dialog")
    dialog.get_by_role("button", name="Search").click()
    dialog.get_by_role("progressbar").wait_for()
    dialog.get_by_role("button", name="Cancel").click()
    expect(dialog.get_by_role("status")).to_contain_text("Cancelled")
    expect(dialog.get_by_role("progressbar")).to_have_count(0)
    expect(dialog.get_by_role("button", name="Search")).to_be_enabled()


@pytest.mark.release
def test_a_search_that_nobody_waits_for_is_stopped(held_search: Page) -> None:
    dialog = held_search.get_by_role("dialog")
    with held_search.expect_response(lambda answer: answer.url.endswith("/api/search")) as begun:
        dialog.get_by_role("button", name="Search").click()
    dialog.get_by_role("progressbar").wait_for()
    address = f"{begun.value.url}/{begun.value.json()['id']}"
    held_search.goto("about:blank")
    eventually(lambda: held_search.request.get(address).json()["state"], "cancelled")


@pytest.mark.release
def test_a_balance_factor_that_is_no_number_is_told_and_fits_nothing(editing: Page) -> None:
    before = on_stage(editing)["file"]
    editing.get_by_placeholder("best").fill("half")
    editing.get_by_role("button", name="Fit", exact=True).click()
    expect(editing.locator(".editor .note")).to_contain_text("“half” is not a number")
    assert on_stage(editing)["file"] == before


@pytest.mark.release
def test_a_search_that_cannot_be_is_refused_in_a_sentence(editing: Page) -> None:
    editing.get_by_role("button", name="Find a better crank").click()
    dialog = editing.get_by_role("dialog")
    dialog.get_by_label("Others").fill("M2,Q9")
    dialog.get_by_text("Constraints", exact=True).click()
    vanishing = dialog.get_by_label("Must be zero")
    vanishing.fill("neighbours")
    dialog.get_by_text("Constraints", exact=True).click()
    expect(vanishing).not_to_be_visible()
    dialog.get_by_role("button", name="Search").click()
    expect(dialog.get_by_role("group", name="Minimise").get_by_role("alert")).to_contain_text("Q9")
    expect(vanishing).to_be_visible()
    expect(vanishing).to_have_attribute("aria-invalid", "true")
    expect(vanishing).to_have_accessible_description(re.compile("neighbours"))
    expect(dialog.get_by_role("progressbar")).to_have_count(0)


@pytest.mark.release
def test_fitting_puts_weights_on_and_undo_takes_them_off(editing: Page) -> None:
    layout = on_stage(editing)["file"]["layout"]
    editing.get_by_label("Counterweights", exact=True).select_option("at the ends")
    editing.get_by_role("button", name="Fit", exact=True).click()
    eventually(
        lambda: len(on_stage(editing)["file"].get("crankshaft", [{}])[0].get("weight", [])), 2
    )
    assert on_stage(editing)["file"]["layout"] == layout
    expect(field(editing, "edit:crankshaft[1].weight[1].unbalance")).to_be_attached()
    note = editing.locator(".editor .note")
    expect(note).to_contain_text("Fitted")
    expect(note).to_be_in_viewport()
    expect(note).to_be_focused()
    editing.get_by_role("button", name="Undo").click()
    eventually(lambda: "crankshaft" in on_stage(editing)["file"], False)


@pytest.mark.release
def test_the_editor_and_its_search_can_be_read_and_used(editing: Page) -> None:
    for colours in COLOURS:
        editing.emulate_media(color_scheme=colours)
        assert barriers(editing) == []
    editing.get_by_role("button", name="Find a better crank").click()
    for colours in COLOURS:
        editing.emulate_media(color_scheme=colours)
        assert barriers(editing) == []


@pytest.mark.release
def test_nothing_reaches_over_the_edge(browser: Browser, server: Server) -> None:
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        for engine in ("v8-cross-plane", "napier-deltic", "radial-9"):
            opened(page, server, f"tab=edit&a=0&engine={engine}")
            page.reload()
            page.locator(".editor .form .field").first.wait_for()
            assert not beyond(page)
        page.get_by_role("button", name="Find a better crank").click()
        assert not beyond(page)
    assert not complaints


def beyond(page: Page) -> list[str]:
    """Elements cut off or beyond an edge, except text for screen readers only."""
    return [f"{width}: {line}" for width in WIDTHS for line in beyond_at(page, width)]


def beyond_at(page: Page, width: int) -> list[str]:
    page.set_viewport_size({"width": width, "height": 700})
    return [line for line in too_wide(page) if not re.match(r"\w+\.(unseen|aside|chooser)\b", line)]
