"""Panels and their tabs: one row of them, what is chosen goes into links, paths to one scale."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from tests.web.engine_page import handle, opened

from crankstar.language import glossary

Build = Callable[..., Path]
ENGINE = "v8-flat-plane"
DRAWN = """() =>
  [...document.querySelectorAll('table.orders tbody tr:not(.group)')].flatMap(row => {
    const path = row.querySelector('svg.path .line')
    const order = row.querySelector('th button')?.textContent
    const group = row.parentElement.querySelector('th').firstChild.textContent.trim()
    if (!order) return []
    const long = path?.tagName === 'ellipse' ? path.getAttribute('rx') * 1
      : path ? (path.getAttribute('d').match(/H([\\d.]+)/) ?? [0, 0])[1] * 1 : 0
    return [[group, Number(order), long, getComputedStyle(row.cells[2]).color]]
})"""


@pytest.mark.release
@pytest.mark.parametrize("width", [1440, 1024, 390])
def test_tabs_stand_in_one_row_and_the_chosen_one_is_seen(
    width: int, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    opened(page, built_page(ENGINE), "a=0&tab=about")
    tabs = page.get_by_role("tab").all()
    boxes = [tab.bounding_box() for tab in tabs]
    assert len({box["y"] for box in boxes if box}) == 1
    chosen = page.locator("[role=tab][aria-selected=true]")
    expect(chosen).to_have_attribute("data-tab", "about")
    box = chosen.bounding_box()
    assert box
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= width
    overflowing = page.locator("[role=tablist]").evaluate(
        "row => row.scrollWidth > row.clientWidth"
    )
    assert page.locator(".strip .back").is_visible() == overflowing


@pytest.mark.release
def test_what_is_chosen_in_a_panel_goes_into_the_link_and_comes_back(
    built_page: Build, page: Page
) -> None:
    path = built_page(ENGINE)
    opened(page, path, "a=0&tab=bearings")
    page.get_by_role("radio", name="crank pins, from the rods").check()
    expect(page.locator(".polar-loads")).to_have_attribute("data-on", "pin")
    page.wait_for_function("() => location.hash.includes('bearings.on=pin')")
    state = page.evaluate("location.hash.slice(1)")
    opened(page, path, state)
    expect(page.locator(".polar-loads")).to_have_attribute("data-on", "pin")


@pytest.mark.release
def test_paths_of_a_quantity_are_drawn_to_one_scale_and_little_ones_are_pale(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), "a=0")
    drawn = page.evaluate(DRAWN)
    rows = handle(page, "exhibits[0].table")
    names = {"Force": "force", "Couple": "couple"}
    compared = 0
    for group, order, long, colour in drawn:
        quantity = names.get(group)
        if quantity is None:
            continue
        sizes = {row["order"]: row["size"] for row in rows if row["quantity"] == quantity}
        share = sizes[order] / max(sizes.values())
        assert long == pytest.approx(share if share >= 0.004 else 0, abs=1e-9), (group, order)
        pale = colour == page.locator(".soft.small").first.evaluate(
            "p => getComputedStyle(p).color"
        )
        assert pale == (share < 0.01)
        compared += 1
    assert compared >= 5


@pytest.mark.release
def test_the_guide_points_at_the_parts_of_the_page_one_after_the_other(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), "a=0")
    page.get_by_role("button", name="Guide").click()
    card = page.get_by_role("complementary", name="What am I looking at?")
    seen = []
    for step in range(1, 6):
        expect(card.get_by_role("heading", level=2)).to_contain_text(f"{step}/5")
        (pointed,) = page.locator(".shown-by-guide").all()
        seen.append(pointed.get_attribute("class"))
        if step < 5:
            card.get_by_role("button", name="Next").click()
    assert len(set(seen)) == 5
    commands = card.locator("code").all_inner_texts()
    assert f"crankstar page {ENGINE} --beside v8-cross-plane -o example.html" in commands
    assert len(commands) == 5
    card.get_by_role("button", name="Frame and signs").click()
    drawn = card.get_by_role("img").evaluate("img => [img.complete, img.naturalWidth]")
    assert drawn[1] > 0, drawn
    page.keyboard.press("Escape")
    expect(card).to_have_count(0)
    expect(page.locator(".shown-by-guide")).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize("width", [1440, 390])
def test_a_word_with_a_dotted_line_is_explained_as_in_the_glossary(
    width: int, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    opened(page, built_page(ENGINE), "a=0")
    meanings = {term.term: term.meanings["en"] for term in glossary.terms()}
    for word, term in (
        ("order", "order"),
        ("Couple", "couple"),
        ("pitch MV", "rocking couple, pitch"),
    ):
        shown = page.locator(".orders .term", has_text=word).first
        shown.scroll_into_view_if_needed()
        shown.click()
        box = page.get_by_role("tooltip")
        expect(box).to_contain_text(meanings[term])
        place = box.bounding_box()
        assert place
        assert place["x"] >= 0
        assert place["x"] + place["width"] <= width
        assert 0 <= place["y"] <= 844 - place["height"]
        assert shown.get_attribute("aria-description") == meanings[term]
        page.keyboard.press("Escape")
        expect(box).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize(
    ("tab", "word", "term"),
    [
        ("orders", "m r ω²", "unit of force, m r ω²"),
        ("orders", "m r ω² a", "unit of couple, m r ω² a"),
        ("verdict", "secondary", "primary, secondary"),
        ("verdict", "Lanchester balancer", "Lanchester balancer"),
    ],
)
def test_units_and_words_of_the_verdict_are_explained(
    tab: str, word: str, term: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page("v8-cross-plane"), f"a=0&tab={tab}")
    (meaning,) = [each.meanings["en"] for each in glossary.terms() if each.term == term]
    page.locator(".term").get_by_text(word, exact=True).first.click()
    expect(page.get_by_role("tooltip")).to_contain_text(meaning)
    page.keyboard.press("Escape")


@pytest.mark.release
@pytest.mark.parametrize("language", ["ja", "ru"])
def test_terms_are_named_and_explained_in_the_language_of_the_page(
    language: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), f"a=0&lang={language}")
    (term,) = [each for each in glossary.terms() if each.term == "order"]
    page.locator(".orders .term").first.click()
    name = term.japanese if language == "ja" else term.russian
    expect(page.get_by_role("tooltip").locator("strong")).to_have_text(name)
    expect(page.get_by_role("tooltip")).to_contain_text(term.meanings[language])
    assert term.meanings[language] != term.meanings["en"]


@pytest.mark.release
def test_a_link_to_a_panel_that_the_engine_lacks_says_so(built_page: Build, page: Page) -> None:
    opened(page, built_page(ENGINE), "a=0&tab=mounts")
    panel = page.get_by_role("tabpanel", name="Orders")
    expect(panel.get_by_role("status")).to_have_text(
        "Nothing to show under Mounts for this engine on this page; Orders is open instead."
    )
    page.get_by_role("tab", name="Stars").click()
    expect(page.get_by_role("tabpanel", name="Stars").get_by_role("status")).to_have_count(0)
    opened(page, built_page(ENGINE), "a=0&tab=nonsense")
    expect(panel).to_be_visible()
    expect(panel.get_by_role("status")).to_have_count(0)


@pytest.mark.release
def test_numbers_and_letters_of_the_orders_are_set_as_in_print(
    built_page: Build, page: Page
) -> None:
    """As in the sentences of the verdict: no 4.2e-05, and M_V has its V below the line."""
    opened(page, built_page(ENGINE), "a=0")
    table = page.locator("table.orders")
    expect(table.get_by_role("row").filter(has_text="4.2075·10⁻⁵")).to_have_count(1)
    expect(table).not_to_contain_text("e−0")
    assert table.locator("sub").all_inner_texts() == ["V", "H"]
    expect(table).not_to_contain_text("_")


def test_the_verdict_begins_with_what_remains_and_says_nothing_twice(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), "a=0&tab=verdict")
    panel = page.get_by_role("tabpanel", name="Verdict")
    subjects = panel.locator("dt").all_text_contents()
    assert subjects[:4] == ["force", "couple", "rolling moment", "remedy"]
    facts = handle(page, "exhibits[0].verdict")
    assert len(panel.locator("dd p").all()) == len(facts)
    expect(panel.get_by_text("Fires 1-8-5-4-7-2-3-6 every 90 deg.")).to_have_count(1)
    expect(panel.locator(".doubt", has_text="cylinder.rod_ratio")).to_have_count(1)


@pytest.mark.release
@pytest.mark.parametrize(("width", "words"), [(390, "swipe on a touch screen"), (1440, "Click a")])
def test_the_guide_speaks_of_the_views_that_are_there(
    width: int, words: str, built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    opened(page, built_page(ENGINE), "a=0")
    page.get_by_role("button", name="Guide").click()
    expect(page.get_by_role("complementary", name="What am I looking at?")).to_contain_text(words)


@pytest.mark.release
def test_numbers_bear_the_colour_of_their_arrow_while_it_is_drawn(
    built_page: Build, page: Page
) -> None:
    """The key to the arrows where no names fit beside their scales, as in Russian on a phone."""
    page.set_viewport_size({"width": 320, "height": 640})
    opened(page, built_page(ENGINE), "a=0&lang=ru")
    marks = page.locator(".now dt .mark")
    colours = marks.evaluate_all("all => all.map(mark => getComputedStyle(mark).color)")
    assert colours == ["rgb(15, 109, 181)", "rgb(176, 79, 140)", "rgb(138, 106, 0)"]
    opened(page, built_page(ENGINE), "a=0&lang=ru&couple=0")
    expect(marks).to_have_count(2)


@pytest.mark.release
def test_the_polar_diagrams_of_bearings_say_what_their_circles_are(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ENGINE), "a=0&tab=bearings")
    panel = page.get_by_role("tabpanel", name="Bearings")
    expect(panel).to_contain_text("The outer circle is the greatest of these loads")
    # nothing is drawn over a label, and tables stand apart
    assert panel.locator("svg").first.evaluate("svg => svg.lastElementChild.tagName") == "text"
    boxes = [table.bounding_box() for table in panel.locator("section.table").all()]
    (first, second) = [box for box in boxes if box]
    assert second["y"] - first["y"] - first["height"] >= 12


@pytest.mark.release
def test_what_balance_shafts_leave_does_not_shrink_the_arrows_of_other_panels(
    built_page: Build, page: Page
) -> None:
    """Shafts leave a roll 28 times as great: to one scale only where one switches between both."""
    page.set_viewport_size({"width": 1440, "height": 900})
    path = built_page(ENGINE)
    shown = "() => document.querySelector('.canvas canvas[aria-hidden]').toDataURL()"
    opened(page, path, "a=30")
    before = page.evaluate(shown)
    page.get_by_role("tab", name="Balancing").click()
    expect(page.get_by_role("radio", name="with weights and shafts")).to_be_visible()
    assert page.evaluate(shown) != before
    page.get_by_role("tab", name="Stars").click()
    assert page.evaluate(shown) == before
