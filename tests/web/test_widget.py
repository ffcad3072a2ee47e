"""The widget as in a notebook: the bundle through anywidget, a model answered by Python."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from tests.web.engine_page import EIGHT, farthest_off

import crankstar
from crankstar.page import widget as notebook
from crankstar.page.standalone import bundle

# What anywidget gives to `render`: a model with traits that are heard when they change, and
# messages to the kernel.
HARNESS = """async source => {
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }))
    const { render } = (await import(url)).default
    class Model {
        heard = []
        saved = {}
        constructor(values) { this.values = values }
        get(name) { return this.values[name] }
        set(name, value) {
            if (this.values[name] === value) return
            this.values[name] = value
            this.tell(`change:${name}`, value)
        }
        save_changes() { this.saved = { ...this.values } }
        on(event, told) { this.heard.push([event, told]) }
        off(event, told) {
            this.heard = this.heard.filter(pair => pair[0] !== event || pair[1] !== told)
        }
        tell(event, content) {
            for (const [name, told] of [...this.heard]) if (name === event) told(content)
        }
        async send(content) { this.tell('msg:custom', await kernel(content)) }
    }
    window.cells = []
    window.show = async values => {
        const el = document.body.appendChild(document.createElement('div'))
        const model = new Model(values)
        const end = await render({ model, el })
        window.cells.push({ el, model, end })
        await el.crankstar.ready
    }
}"""
Show = Callable[..., Any]


@pytest.fixture
def show(page: Page, tmp_path: Path) -> Iterator[Show]:
    """Show a widget in the next cell of a page, with its own traits; Python answers."""
    blank = tmp_path / "notebook.html"
    blank.write_text(
        "<!doctype html><html lang='en'><title>notebook</title><body></body></html>",
        encoding="utf-8",
    )
    page.set_viewport_size({"width": 1000, "height": 900})
    page.goto(blank.as_uri())
    shown: list[Any] = []
    page.expose_function("kernel", lambda question: notebook.answer(shown[-1]._subjects, question))
    page.evaluate(HARNESS, bundle())

    def put(*names: str, **traits: Any) -> Any:
        widget = crankstar.widget(*names)
        shown.append(widget)
        own = {name: getattr(widget, name) for name in ("data", "state", "theta", "playing")}
        page.evaluate("values => show(values)", {**own, **traits})
        return widget

    yield put
    for widget in shown:
        widget.close()


def cell(page: Page, expression: str, index: int = 0) -> Any:
    """What JavaScript says of a cell: `el`, `model`, `page` (the handle)."""
    return page.evaluate(
        (
            "([index]) => "
            f"{{ const {{ el, model, end }} = cells[index]; const page = el.crankstar; "
            f"return {expression} }}"
        ),
        [index],
    )


@pytest.mark.release
def test_it_opens_as_the_traits_say_and_goes_where_python_says(show: Show, page: Page) -> None:
    show("v8-cross-plane", theta=77.0, state="camera=front&tab=verdict")
    assert cell(page, "[page.theta, page.playing]") == [77, False]
    expect(page.get_by_role("tab", name="Verdict")).to_have_attribute("aria-selected", "true")
    cell(page, "model.set('theta', 450)")
    assert cell(page, "page.theta") == 450
    cell(page, "model.set('theta', -30)")
    assert cell(page, "[page.theta, model.saved.theta]") == [690, 690], (
        "within the cycle, and Python is told"
    )
    cell(page, "model.set('state', 'tab=strokes')")
    expect(page.get_by_role("tab", name="Strokes")).to_have_attribute("aria-selected", "true")
    assert cell(page, "page.theta") == 690


@pytest.mark.release
def test_every_piston_is_where_python_says(show: Show, page: Page) -> None:
    show("audi-25-tfsi")
    read = cell(
        page, f"{EIGHT}.map(angle => {{ model.set('theta', angle); return page.read().pistons }})"
    )
    found = [{int(number): place for number, place in at.items()} for at in read]
    assert farthest_off(crankstar.load("audi-25-tfsi"), found) < 1e-6


@pytest.mark.release
def test_it_plays_and_stops_from_both_sides(show: Show, page: Page) -> None:
    show("v8-cross-plane")
    page.get_by_role("button", name="Play").click()
    assert cell(page, "[page.playing, model.saved.playing]") == [True, True]
    page.wait_for_function("() => cells[0].el.crankstar.theta > 1")
    page.get_by_role("button", name="Stop").click()
    assert cell(page, "[page.playing, model.saved.playing]") == [False, False]
    assert cell(page, "model.saved.theta === page.theta && page.theta > 1")
    cell(page, "model.set('playing', true)")
    assert cell(page, "page.playing")
    cell(page, "model.set('theta', 12.5)")
    assert cell(page, "[page.playing, page.theta, model.saved.playing]") == [False, 12.5, False]


@pytest.mark.release
def test_figures_and_derivations_are_asked_of_the_kernel(show: Show, page: Page) -> None:
    show("v8-cross-plane", state="tab=forces")
    expect(
        page.get_by_role("tabpanel").locator("svg[role=img], svg.marks, canvas").first
    ).to_be_visible()
    assert cell(page, "document.querySelectorAll('script').length") == 0
    page.get_by_role("tab", name="Derivation").click()
    expect(page.get_by_role("tabpanel").locator("math").first).to_be_visible()


@pytest.mark.release
def test_two_on_one_page_do_not_know_each_other(show: Show, page: Page) -> None:
    show("v8-cross-plane", theta=30.0)
    show("single", theta=60.0)
    cell(page, "model.set('theta', 200)", 1)
    assert [cell(page, "page.theta", index) for index in (0, 1)] == [30, 200]
    names = [cell(page, "page.exhibits[0].name", index) for index in (0, 1)]
    assert names == [crankstar.load(name).name for name in ("v8-cross-plane", "single")]
    # keys belong to the cell in which they are pressed
    page.locator("div >> nth=0").get_by_role("button", name="Play").first.focus()
    page.keyboard.press(".")
    assert [cell(page, "page.theta", index) for index in (0, 1)] == [31, 200]


@pytest.mark.release
def test_another_engine_takes_the_place_of_the_first(show: Show, page: Page) -> None:
    widget = show("v8-cross-plane", theta=30.0)
    widget.show("single")
    page.evaluate(
        "async data => { cells[0].model.set('data', data); await cells[0].el.crankstar.ready }",
        widget.data,
    )
    assert cell(page, "page.exhibits[0].name") == crankstar.load("single").name
    assert cell(page, "page.theta") == 30


@pytest.mark.release
def test_nothing_is_left_when_the_cell_is_cleared(show: Show, page: Page) -> None:
    page.emulate_media(reduced_motion="no-preference")
    show("v8-cross-plane", playing=True)
    page.wait_for_function("() => cells[0].el.crankstar.theta > 1")
    cell(page, "end()")
    assert cell(page, "[el.childNodes.length, model.heard.length, 'crankstar' in el]") == [
        0,
        0,
        False,
    ]
    assert page.evaluate("document.adoptedStyleSheets.length") == 0


@pytest.mark.release
@pytest.mark.usefixtures("show")
def test_data_that_cannot_be_read_are_answered_with_a_sentence(page: Page) -> None:
    page.evaluate(
        "() => show({ data: 'no engine', state: '', theta: 0, playing: false }).catch(() => 0)"
    )
    expect(page.locator(".failed")).not_to_be_empty()
