"""Panels, figures, numbers and switches follow the crank angle; links restore the view."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect
from tests.report.reading import plain
from tests.web.browsing import too_wide
from tests.web.engine_page import FRAMES, handle, opened, turns_on

from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.page import exhibition
from crankstar.page.library import held
from crankstar.page.standalone import INCOMPLETE, document

Build = Callable[..., Path]
CROSS, FLAT = "v8-cross-plane", "v8-flat-plane"
HOSTILE = '</script><img src=x onerror="document.title=1"><b>V8</b>'


def number(text: str | None) -> float:
    """A number of the page, its minus a true minus."""
    return float(plain(text or "").strip("\N{FIGURE SPACE} "))


def numbers(page: Page) -> dict[str, float]:
    """The numbers below the stage."""
    fields = page.get_by_label("At this crank angle").locator("output").all_text_contents()
    names = ("Force up", "Force right", "Couple up", "Couple right", "Rolling moment")
    return dict(zip(names, map(number, fields), strict=True))


def turned(page: Page, degrees: float) -> None:
    """Turns the engine."""
    handle(page, f"theta = {degrees}")


def tab(page: Page, name: str) -> Locator:
    """Opens a panel and waits for its figures."""
    page.get_by_role("tab", name=name, exact=True).click()
    expect(page.locator("[aria-busy=true]")).to_have_count(0)
    return page.get_by_role("tabpanel")


@pytest.mark.release
@pytest.mark.parametrize(
    "name",
    [
        CROSS,
        *(
            pytest.param(name, marks=pytest.mark.release)
            for name in ("audi-25-tfsi", "kr250-racer")
        ),
    ],
)
def test_the_numbers_below_the_stage_are_those_of_python(
    name: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page(name))
    engine = load(name)
    result = balance(engine, speed=engine.speed)
    sums = total(result)
    for angle in (0.0, 40.0, 123.4, 451.0):
        turned(page, angle)
        seen = numbers(page)
        for label, spectrum, parts in (
            ("Force", sums.force, result.force),
            ("Couple", sums.couple, result.couple),
        ):
            shown = 1e-3 * spectra.peak(spectrum).value + 1e-6 * float(abs(parts.forward).sum())
            vector = complex(spectra.value(spectrum, math.radians(angle)))
            assert complex(seen[f"{label} up"], seen[f"{label} right"]) == pytest.approx(
                vector, abs=shown
            )


@pytest.mark.release
def test_the_roll_of_an_engine_whose_cylinders_do_not_roll_by_themselves_is_told(
    built_page: Build, page: Page
) -> None:
    """Five in line: the block rolls in order 5 alone, where a flywheel takes up the torque."""
    opened(page, built_page("audi-25-tfsi"))
    sums = total(balance(load("audi-25-tfsi"), speed=load("audi-25-tfsi").speed))
    fifth = spectra.amplitude(spectra.selected(sums.torque, [5.0]))[0]
    for angle in (10.0, 25.0):
        turned(page, angle)
        rolls = -(fifth * cmath.exp(5j * math.radians(angle))).real
        assert numbers(page)["Rolling moment"] == pytest.approx(rolls, abs=0.02 * abs(fifth))


@pytest.mark.release
def test_only_the_chosen_order_is_counted(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS), "a=40&orders=4")
    assert numbers(page)["Couple up"] == 0
    page.get_by_role("button", name="Couple, order 1: show alone").click()
    assert handle(page, "state.orders") == [1]
    assert abs(numbers(page)["Couple up"]) > 0.5
    page.get_by_role("button", name="Couple, order 1: show alone").click()
    assert handle(page, "state.orders") is None


@pytest.mark.release
def test_the_dot_in_the_table_is_where_the_vector_points(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS), "a=0&tab=orders")
    couple = total(balance(load(CROSS))).couple
    first = spectra.selected(couple, [1.0])
    dot = page.locator("tr", has=page.get_by_role("button", name="Couple, order 1")).locator(
        "circle"
    )
    for angle in (0, 40, 200):
        turned(page, angle)
        vector = complex(spectra.value(first, math.radians(angle)))
        right, up = (float(dot.get_attribute(name) or "nan") for name in ("cx", "cy"))
        assert complex(-up, right) == pytest.approx(vector / abs(vector), abs=2e-3)


CENTRES = "all => all.map(one => [one.cx.baseVal.value, one.cy.baseVal.value])"


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", [CROSS, pytest.param("kr250-racer", marks=pytest.mark.release)])
def test_loads_on_bearings_are_those_of_python_at_every_angle(
    name: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page(name), "a=0&tab=bearings")
    engine = load(name)
    loads = bearing_loads(engine, speed=engine.speed)
    for choice, spectrum, shafts in (
        ("main bearings", loads.load, [bearing.shaft for bearing in loads.bearings]),
        ("crank pins, from the rods", loads.pin, [pin.shaft for pin in loads.pins]),
    ):
        page.get_by_role("radio", name=choice, exact=True).check()
        largest = float(spectra.peaks(spectrum).max())
        for frame in ("block", "turning with the shaft"):
            page.get_by_role("radio", name=frame, exact=True).check()
            heads = page.locator(".polar-loads .now circle")
            expect(heads).to_have_count(len(shafts))
            for angle in (0.0, 77.0, 250.5):
                turned(page, angle)
                places = heads.evaluate_all(CENTRES)
                for row, (shaft, (right, up)) in enumerate(zip(shafts, places, strict=True)):
                    rate = engine.sense * float(engine.shaft(shaft).speed_ratio)
                    vector = complex(spectra.value(spectrum[row], math.radians(angle)))
                    if frame != "block":
                        vector *= cmath.exp(-1j * rate * math.radians(angle))
                    assert complex(-up, right) == pytest.approx(vector / largest, abs=2e-3)
        peaks = page.locator(".polar-loads .peak").evaluate_all(CENTRES)
        for place, top in zip(peaks, spectra.peaks(spectrum).tolist(), strict=True):
            if top > 1e-9 * largest:
                assert math.hypot(*place) == pytest.approx(top / largest, abs=1e-3)


@pytest.mark.release
def test_loads_with_gas_are_those_of_the_first_operating_point(
    built_page: Build, page: Page
) -> None:
    engine = load("audi-25-tfsi")
    opened(page, built_page("audi-25-tfsi"), "a=0&tab=bearings&bearings.gas=with")
    spectrum = bearing_loads(engine, cycle=cycle(engine)).load
    largest = float(spectra.peaks(spectrum).max())
    expect(page.get_by_text("operating point full, 6500 rpm")).to_be_visible()
    heads = page.locator(".polar-loads .now circle")
    for angle in (16.0, 160.0, 594.0):
        turned(page, angle)
        for row, (right, up) in enumerate(heads.evaluate_all(CENTRES)):
            vector = complex(spectra.value(spectrum[row], math.radians(angle)))
            assert complex(-up, right) == pytest.approx(vector / largest, abs=2e-3)
    expect(page.get_by_role("heading", name="Wear of journals and pins")).to_be_visible()


@pytest.mark.release
def test_figures_follow_the_crank_angle(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS, figures=True), "a=0&of=couple")
    tab(page, "Forces")
    places = []
    for angle in (90, 180, 270):
        turned(page, angle)
        over = page.locator(
            "[data-chart='over-turn:quantity=couple'] .mark-rule line[stroke='#d55e00']"
        )
        shifts = over.evaluate_all("lines => lines.map(line => line.getAttribute('transform'))")
        places.append(max(float(re.findall(r"translate\(([-\d.]+)", shift)[0]) for shift in shifts))
    assert places[2] - places[1] == pytest.approx(places[1] - places[0], rel=0.01)
    assert places[1] - places[0] > 20


@pytest.mark.release
def test_a_figure_out_of_view_rests_while_the_engine_turns_and_is_right_after(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": 1280, "height": 600})
    opened(page, built_page(CROSS, figures=True), "a=0&of=couple&tab=stars")
    figures = page.locator(".figure .drawing")
    drawn = "all => all.map(drawing => drawing.innerHTML)"
    first = figures.evaluate_all(drawn)
    handle(page, "play()")
    turns_on(page)
    moved = figures.evaluate_all(drawn)
    assert moved[0] != first[0]
    assert moved[-1] == first[-1]
    handle(page, "stop()")
    stopped = figures.evaluate_all(drawn)
    angle = handle(page, "theta")
    turned(page, angle + 50)
    turned(page, angle)
    assert figures.evaluate_all(drawn) == stopped != moved


@pytest.mark.release
def test_a_figure_keeps_its_size_while_it_turns(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS, figures=True), "a=0&of=couple")
    tab(page, "Stars")
    sizes: set[tuple[str, ...]] = set()
    for angle in range(0, 720, 45):
        turned(page, angle)
        places = page.locator(".figure .role-title-text text").evaluate_all(
            "texts => texts.map(text => text.getBoundingClientRect().left.toFixed(0))"
        )
        boxes = page.locator(".figure svg.marks").evaluate_all(
            "all => all.map(svg => svg.getAttribute('viewBox'))"
        )
        sizes.add((*places, *boxes))
    assert len(sizes) == 1


@pytest.mark.release
def test_a_link_shows_the_same_again(built_page: Build, page: Page) -> None:
    page.emulate_media(reduced_motion="no-preference")
    file = built_page(CROSS)
    opened(page, file, "")
    page.get_by_role("radio", name="Front").check()
    page.get_by_role("tab", name="Verdict").click()
    page.get_by_role("combobox", name="Forces").select_option("cylinders")
    page.get_by_role("button", name="Stop").click()
    field = page.get_by_label("Crank angle: type degrees")
    field.fill("450")
    field.press("Enter")
    page.wait_for_function("() => location.hash.includes('a=450')")
    before = handle(page, "state")
    link = page.url
    page.goto("about:blank")
    page.goto(link)
    page.evaluate("async () => await document.querySelector('[data-crankstar]').crankstar.ready")
    assert handle(page, "state") == before
    assert (before["camera"], before["tab"], before["angle"], before["each"]) == (
        "front",
        "verdict",
        450,
        "cylinders",
    )
    expect(page.get_by_role("tab", name="Verdict")).to_have_attribute("aria-selected", "true")


@pytest.mark.release
def test_a_page_that_plays_does_not_write_its_angle_all_the_time(
    built_page: Build, page: Page
) -> None:
    page.emulate_media(reduced_motion="no-preference")
    opened(page, built_page(CROSS), "")
    page.evaluate(
        "() => { window.written = 0; const old = history.replaceState; "
        "history.replaceState = function(...all)"
        " { window.written += 1; return old.apply(this, all) } }"
    )
    page.evaluate(FRAMES, 10)
    turns_on(page)
    assert page.evaluate("window.written") == 0
    assert "a=" not in page.url


@pytest.mark.release
def test_the_address_that_is_changed_by_hand_is_followed(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS), "a=10&tab=orders")
    page.evaluate("location.hash = 'a=77&tab=about&camera=side&whatever=<b>'")
    page.wait_for_function(
        "() => document.querySelector('[data-crankstar]').crankstar.theta === 77"
    )
    assert handle(page, "state.camera") == "side"
    expect(page.get_by_role("tab", name="About")).to_have_attribute("aria-selected", "true")


@pytest.mark.release
def test_weights_take_the_couple_from_a_cross_plane_crank_in_all_parts(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(CROSS, figures=True), "a=40&orders=1")
    panel = tab(page, "Balancing")
    before = numbers(page)
    assert math.hypot(before["Couple up"], before["Couple right"]) == pytest.approx(
        math.sqrt(10), rel=1e-3
    )
    panel.get_by_role("radio", name="with weights and shafts").check()
    page.wait_for_function(
        "() => document.querySelector('[data-crankstar]').crankstar.exhibits[0].remedies.length > 0"
    )
    after = numbers(page)
    assert math.hypot(after["Couple up"], after["Couple right"]) < 1e-3
    expect(panel.get_by_role("heading", name="Bobweights")).to_be_visible()
    both = panel.locator("figure[data-chart='spectrum:fitted']")
    expect(both).to_have_count(1)
    expect(both.locator("svg")).to_be_visible()
    expect(panel.locator("[data-chart=spectrum]")).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize(
    ("language", "play", "roll"),
    [("ja", "再生", "ローリングモーメント"), ("ru", "Пуск", "Опрокидывающий момент")],
)
def test_the_page_is_shown_in_the_language_of_its_address(
    language: str, play: str, roll: str, built_page: Build, page: Page
) -> None:
    file = built_page(CROSS)
    page.goto(f"{file.as_uri()}?lang={language}#a=0")
    page.evaluate("() => document.querySelector('[data-crankstar]').crankstar.ready")
    assert page.locator("html").get_attribute("lang") == language
    expect(page.get_by_role("button", name=play)).to_be_visible()
    expect(page.locator("section.now")).to_contain_text(roll)
    page.set_viewport_size({"width": 390, "height": 844})
    assert too_wide(page) == []
    page.evaluate("location.hash = 'a=1&lang=en'")
    expect(page.get_by_role("button", name="Play")).to_be_visible()
    assert page.locator("html").get_attribute("lang") == "en"


@pytest.mark.release
def test_every_panel_names_the_engine_it_shows_and_shows_either(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(CROSS, FLAT), "a=40&tab=orders")
    panel = page.get_by_role("tabpanel")
    for name in ("Orders", "Stars", "Forces", "Strokes", "Verdict", "Balancing", "Whirl"):
        page.get_by_role("tab", name=name, exact=True).click()
        expect(panel.get_by_role("group", name="Engine").get_by_role("radio")).to_have_count(3)
    page.get_by_role("tab", name="Orders", exact=True).click()
    first = panel.locator("table").inner_text()
    for name in (load(CROSS).name, load(FLAT).name):
        expect(panel.get_by_role("columnheader", name=name)).to_be_visible()
    panel.get_by_role("radio", name=load(FLAT).name).check()
    expect(panel.locator("table")).not_to_have_text(first, use_inner_text=True)
    assert handle(page, "state.panel") == "2"


@pytest.mark.release
def test_two_engines_stand_side_by_side(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS, FLAT), "a=40&tab=compare")
    heads = page.get_by_role("columnheader").all_text_contents()
    assert heads == ["order", load(CROSS).name, load(FLAT).name, "difference, second − first"]
    forces = page.locator("table.orders tbody").filter(has_text="Force")
    line = forces.get_by_role("row", name=re.compile("^Force, order 2"))
    expect(line).to_contain_text("horizontal line")
    expect(page.locator(".stage canvas").first).to_be_visible()
    assert page.locator(".stage").count() == 2
    page.set_viewport_size({"width": 390, "height": 844})
    names, drawings = (
        [place.bounding_box() for place in page.locator(f".stage .{part}").all()]
        for part in ("label", "canvas")
    )
    assert all(
        name and drawing and name["y"] + name["height"] <= drawing["y"]
        for name, drawing in zip(names, drawings, strict=True)
    )
    assert len({drawing["height"] for drawing in drawings if drawing}) == 1
    page.get_by_role("checkbox", name="Show both engines").uncheck()
    assert page.locator(".stage").count() == 1


@pytest.mark.release
def test_derivations_are_typeset(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS, figures=True), "a=0&of=couple&orders=1")
    panel = tab(page, "Derivation")
    expect(panel.locator("math").first).to_be_visible()
    assert panel.locator("math").count() > 10
    expect(
        panel.get_by_role("heading", name=re.compile("couple", re.IGNORECASE)).first
    ).to_be_visible()


@pytest.mark.release
def test_the_whirl_is_switched_on_at_a_size_that_is_seen_and_its_estimate_is_named(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(CROSS), "a=0&tab=whirl")
    panel = page.get_by_role("tabpanel")
    expect(panel.get_by_text("Estimate:").first).to_be_visible()
    assert handle(page, "state.whirl") == 0
    panel.get_by_role("checkbox", name="Show the whirl on the stage").check()
    assert handle(page, "state.whirl") >= 1
    panel.get_by_role("checkbox", name="Show the whirl on the stage").uncheck()
    assert handle(page, "state.whirl") == 0
    page.evaluate("location.hash = 'a=90&tab=whirl&whirl=1000'")
    expect(page.get_by_role("tabpanel")).to_contain_text("1000 ×")


@pytest.mark.release
def test_colours_are_changed_by_a_button_and_kept(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS), "a=0")
    button = page.get_by_role("button", name=re.compile("^Colours"))
    button.click()
    button.click()
    assert handle(page, "state.theme") == "dark"
    expect(page.locator(".crankstar.dark")).to_have_count(1)
    page.wait_for_function("() => location.hash.includes('theme=dark')")


@pytest.mark.release
def test_a_figure_that_is_not_there_says_so_and_can_be_asked_for_again(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(CROSS), "a=0&tab=stars")
    place = page.locator("[data-chart=crank-star]")
    expect(place).to_contain_text("This file does not hold the figure.")
    place.get_by_role("button", name="Try again").click()
    expect(place).to_contain_text("This file does not hold the figure.")


@pytest.mark.release
def test_names_are_text_everywhere(tmp_path: Path, page: Page) -> None:
    engine = load("v2-90").model_copy(update={"name": HOSTILE})
    file = tmp_path / "hostile.html"
    file.write_text(document(held([engine])), encoding="utf-8")
    opened(page, file, "a=0")
    title = page.title()
    for each in page.get_by_role("tab").all():
        each.click()
        expect(page.locator("[aria-busy=true]")).to_have_count(0)
        assert page.locator("[data-crankstar] :is(img, b)").count() == 0
    assert page.title() == title
    expect(page.get_by_role("heading", level=1)).to_have_text(HOSTILE)


@pytest.mark.release
@pytest.mark.parametrize(
    "share", [0.999, *(pytest.param(share, marks=pytest.mark.release) for share in (0.1, 0.5))]
)
def test_a_file_that_is_cut_short_says_what_to_do(
    share: float, built_page: Build, tmp_path: Path, page: Page
) -> None:
    whole = built_page(CROSS).read_bytes()
    file = tmp_path / "cut.html"
    file.write_bytes(whole[: int(share * len(whole))])
    page.goto(file.as_uri())
    expect(page.locator("body")).to_contain_text(INCOMPLETE)


@pytest.mark.release
def test_a_complete_file_does_not_say_that_it_is_incomplete(built_page: Build, page: Page) -> None:
    opened(page, built_page(CROSS))
    expect(page.locator("body")).not_to_contain_text(INCOMPLETE)


@cache
def written() -> str:
    """The page file of an engine, without what its figures are drawn with."""
    return document(
        {
            "exhibition": exhibition([load(CROSS)]).model_dump(mode="json"),
            "libraries": [],
            "fitted": [],
        }
    )


@pytest.mark.release
@pytest.mark.parametrize(
    ("found", "instead", "told"),
    [
        (
            "<data>",
            '{"exhibition": {"engines": [{"scene": null}]}, "libraries": [], "fitted": []}',
            "cannot be read",
        ),
        ("<data>", "", "cannot be read"),
        pytest.param("<data>", "null", "cannot be read", marks=pytest.mark.release),
        pytest.param(
            "<data>",
            '{"exhibition": {"engines": []}, "libraries": [], "fitted": []}',
            "cannot be read",
            marks=pytest.mark.release,
        ),
        pytest.param(r'(?<="data": ").{900}', "", "cannot be read", marks=pytest.mark.release),
        (r'(?<="data": ".{900}).{4}', "!!!!", "cannot be read"),
        (r'(?<="data": ".{900}).*?</script>', "</script>", "cannot be read"),
    ],
)
def test_a_file_without_its_data_says_what_to_do(
    found: str, instead: str, told: str, tmp_path: Path, page: Page
) -> None:
    file = tmp_path / "cut.html"
    data = r'(?<=id="crankstar-data">).*?(?=</script>)'
    cut, count = re.subn(
        found.replace("<data>", data), instead, written(), count=1, flags=re.DOTALL
    )
    assert count
    file.write_text(cut, encoding="utf-8")
    page.goto(file.as_uri())
    expect(page.locator(".failed")).to_contain_text(told)
    expect(page.locator(".failed")).to_contain_text("crankstar page ENGINE -o FILE.html")
