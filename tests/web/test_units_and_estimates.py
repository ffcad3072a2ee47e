"""The units of the page and the masses it estimates, as they are seen in a browser."""

from __future__ import annotations

import re
import tomllib
from html import unescape
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from tests.files.test_estimate_one_range import TWIN
from tests.report.reading import plain
from tests.web.browsing import too_wide
from tests.web.engine_page import handle, opened
from tests.web.serving import Server

from crankstar import cli, spectra
from crankstar.analyses.verdict.facts import verdict
from crankstar.dynamics.bearings import bearing_loads
from crankstar.dynamics.whirl import body
from crankstar.files import engine_of
from crankstar.files.box import spread
from crankstar.files.catalog import load, tree_of
from crankstar.files.estimate import estimated
from crankstar.language.shown_units import read_choice, shown_in
from crankstar.mechanics.balance import balance
from crankstar.mechanics.remains import summed
from crankstar.page.library import held
from crankstar.page.standalone import document
from crankstar.page.widget import Subject, answer
from crankstar.tables.html import typeset

POUND = 4.4482216152605
FOOT = 0.3048
READY = "() => document.querySelector('[data-crankstar]').crankstar.ready"


@pytest.fixture(scope="module")
def file_page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of an engine with masses, figures and all."""
    path = tmp_path_factory.mktemp("units") / "subaru.html"
    name, tree = tree_of("subaru-ej25")
    path.write_text(document(held([engine_of(tree, name=name)], files_given=[tree])), "utf-8")
    return path


def settled(page: Page) -> None:
    page.evaluate("() => document.querySelector('[data-crankstar]').crankstar.settled()")


def greatest(page: Page, quantity: str) -> list[float]:
    """The greatest values of a quantity in the table of orders."""
    group = page.locator("table.orders tbody").filter(has=page.get_by_text(quantity, exact=False))
    cells = group.first.locator("td.right").all_text_contents()
    return [float(plain(re.sub(r" \(.*", "", text))) for text in cells]


@pytest.mark.release
@pytest.mark.many(first=1)
def test_a_file_changes_its_units_in_every_panel(file_page: Path, page: Page) -> None:
    opened(page, file_page)
    metric = greatest(page, "Rolling moment")
    page.get_by_label("Units").select_option("us")
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("lbf ft")
    pounds = greatest(page, "Rolling moment")
    assert pounds == pytest.approx([size / POUND / FOOT for size in metric], rel=2e-4)
    assert page.locator(".now").get_by_text("lbf ft").count() == 2
    engine = load("subaru-ej25")
    roll = summed(balance(engine, speed=engine.speed)).roll
    assert handle(page, "state.units") == "us"
    assert max(pounds) * POUND * FOOT == pytest.approx(float(2 * abs(roll.forward).max()), rel=1e-3)
    page.get_by_role("tab", name="Verdict").click()
    with shown_in(read_choice("us")):
        facts = [fact.sentence for fact in verdict(engine)]
    shown = page.locator(".facts p").all_text_contents()
    assert any("lbf ft" in sentence for sentence in facts)
    assert sorted(shown) == sorted(unescape(typeset(fact)) for fact in facts)
    page.get_by_role("tab", name="Forces").click()
    settled(page)
    assert "lbf" in page.locator("figure .drawing").first.inner_text()
    page.get_by_role("tab", name="Bearings").click()
    expect(page.get_by_role("tabpanel")).to_contain_text("weights, in lbf;")
    loads = spectra.peaks(bearing_loads(engine, speed=engine.speed).load).tolist()
    captions = page.locator(".polar-loads figcaption").all_inner_texts()
    assert [text.endswith("no load") for text in captions] == [load < 1e-9 for load in loads]
    numbers = re.findall(r"\n([\d.]+) at", "".join(captions))
    pounds = [load / POUND for load in loads if load > 1e-9]
    assert [float(text) for text in numbers] == pytest.approx(pounds, rel=5e-4)
    expect(page.get_by_role("columnheader", name="greatest [lbf]")).to_have_count(2)
    page.get_by_role("tab", name="Whirl").click()
    expect(page.get_by_role("tabpanel")).to_contain_text("lb in²")
    expect(page.get_by_role("tabpanel")).not_to_contain_text("mm")


@pytest.mark.release
def test_the_choice_is_in_the_link_and_kept(file_page: Path, page: Page) -> None:
    opened(page, file_page, "a=0&units=us")
    settled(page)
    expect(page.get_by_label("Units")).to_have_value("us")
    expect(page.locator("table.orders")).to_contain_text("lbf ft")
    page.goto("about:blank")
    opened(page, file_page)
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("lbf ft")
    page.get_by_label("Units").select_option("si")
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("N m")


@pytest.mark.release
def test_units_that_a_file_does_not_hold_are_refused_in_a_sentence(
    file_page: Path, page: Page
) -> None:
    opened(page, file_page, "a=0&units=stone")
    expect(page.get_by_role("alert")).to_contain_text("does not hold the units stone")
    expect(page.locator("table.orders")).to_contain_text("N m")
    assert handle(page, "state.units") == ""


@pytest.mark.release
def test_a_file_written_in_other_units_offers_them(tmp_path: Path, page: Page) -> None:
    path = tmp_path / "other.html"
    with shown_in(read_choice("kN, kN m")):
        path.write_text(document(held([load("subaru-ej25")])), "utf-8")
    opened(page, path)
    choices = page.get_by_label("Units").locator("option").all_text_contents()
    assert choices == ["SI", "US customary", "kN, kN m"]
    expect(page.locator("table.orders")).to_contain_text("kN m")
    page.get_by_label("Units").select_option("us")
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("lbf ft")


@pytest.mark.release
def test_the_server_estimates_masses_and_shows_any_units(page: Page, server: Server) -> None:
    page.goto(f"{server.address}#a=0&engine=kr250-racer")
    page.evaluate(READY)
    expect(page.get_by_role("heading", name="KR250")).to_be_visible()
    expect(page.locator("table.orders")).to_contain_text("m r ω²")
    page.get_by_role("button", name="Estimate masses").click()
    expect(page.locator(".badge").first).to_have_text("estimated")
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("Force N")
    text = page.locator("table.orders td.right").first.inner_text()
    tree = estimated(tree_of("kr250-racer")[1]).tree
    ends = spread(tree)
    assert ends is not None
    sizes = [
        float((abs(force.forward) + abs(force.backward)).max())
        for each in ends.engines
        for force in [summed(balance(each, speed=each.speed)).force]
    ]
    low, high = map(float, re.findall(r"[\d.]+", text)[1:])
    assert low == pytest.approx(min(sizes), rel=5e-3)
    assert high == pytest.approx(max(sizes), rel=5e-3)
    page.get_by_label("Units").select_option(label="Others …")
    page.get_by_placeholder("kN, kN m").fill("kN, kN m")
    page.keyboard.press("Enter")
    settled(page)
    expect(page.locator("table.orders")).to_contain_text("Force kN")


@pytest.mark.release
def test_what_the_server_estimates_is_saved_with_its_marks(server: Server) -> None:
    tree = server.ask("api/estimate", {"engine": "kr250-racer"}).json["tree"]
    text = server.ask("api/toml", {"engine": tree}).json["toml"]
    sources = tomllib.loads(text)["provenance"]
    assert sources["cylinder.rod.mass"]["status"] == "estimated"
    explicit = server.ask("api/explicit", {"engine": tree}).json["tree"]
    marked = {p for p, s in explicit["provenance"].items() if s["status"] == "estimated"}
    assert "cylinder.rod.mass" in marked
    fitted = server.ask("api/fitted", {"engine": tree}).json["exhibit"]
    assert any(path.endswith("weight.unbalance") for path in fitted["estimated"])
    assert fitted["table"][0]["estimated"] or any(row["estimated"] for row in fitted["table"])


def test_the_server_says_what_cannot_be_estimated_or_shown(server: Server) -> None:
    refused = server.ask("api/estimate", {"engine": "man-s90mc-c"})
    assert refused.status == 422
    assert "crosshead" in refused.json["problems"][0]["message"]
    wrong = server.ask("api/exhibit", {"engine": "i4", "units": "stone"})
    assert wrong.status == 422
    assert wrong.json["problems"][0]["path"] == "units"
    assert "stone" in wrong.json["problems"][0]["message"]


@pytest.mark.release
def test_the_kernel_answers_in_units_and_estimates() -> None:
    name, tree = tree_of("toyota-2jz")
    subject = Subject(engine_of(tree, name=name), tree, name)
    request = {"id": 1, "engine": 0, "fitted": False, "key": "", "units": "us"}
    done = answer((subject,), {**request, "what": "estimate"})["value"]
    assert isinstance(done, Subject)
    shown = answer((done,), {**request, "what": "exhibit"})["value"]
    assert shown["units"]["force"] == "lbf"
    assert shown["estimated"]
    assert "lbf" in str(answer((done,), {**request, "what": "chart", "key": "spectrum"})["value"])
    wrong = answer((subject,), {**request, "what": "exhibit", "units": "stone"})
    assert "stone" in wrong["sentence"]


@pytest.mark.release
def test_a_page_with_estimates_shows_them_and_their_ranges(tmp_path: Path, page: Page) -> None:
    path = tmp_path / "estimated.html"
    tree = estimated(tree_of("vw-vr6")[1]).tree
    path.write_text(document(held([engine_of(tree)], files_given=[tree])), "utf-8")
    opened(page, path)
    expect(page.locator(".name .badge")).to_have_text("estimated")
    assert re.search(r"\(.+ to .+\)", page.locator(".now .range").first.inner_text())
    page.get_by_role("tab", name="Bearings").click()
    expect(page.get_by_role("tabpanel").locator(".badge")).to_have_text("estimated, with ranges")
    ends = spread(tree)
    assert ends is not None
    loads = [spectra.peaks(bearing_loads(e, speed=e.speed).load) / 1000 for e in ends.engines]
    for index, text in enumerate(page.locator(".polar-loads figcaption").all_inner_texts()):
        low, high = map(float, re.findall(r"\n[\d.]+ \(([\d.]+) to ([\d.]+)\) at", text)[0])
        assert low == pytest.approx(min(float(own[index]) for own in loads), rel=5e-3)
        assert high == pytest.approx(max(float(own[index]) for own in loads), rel=5e-3)
    page.get_by_role("tab", name="Whirl").click()
    masses = [body(engine, along=1.0).mass for engine in ends.engines]
    text = page.get_by_role("tabpanel").inner_text()
    # by the displacement, which bore and stroke give
    assert masses == pytest.approx([masses[0]] * len(masses), rel=1e-12)
    assert float(re.findall(r"Mass: ([\d.]+) kg", text)[0]) == pytest.approx(masses[0], rel=5e-3)
    assert re.search(r"front end\t[\d.]+ \([\d.]+ to [\d.]+\) mm", text)
    page.get_by_role("tab", name="Forces").click()
    settled(page)
    assert "the band is" in page.locator("figure .drawing").first.inner_text()
    page.get_by_role("tab", name="Balancing").click()
    settled(page)
    expect(page.get_by_role("tabpanel")).to_contain_text("sized for their own masses")
    page.set_viewport_size({"width": 390, "height": 844})
    found = {}
    for tab in page.get_by_role("tab").all():
        tab.click()
        found[tab.inner_text()] = too_wide(page)
    assert len(found) > 8
    assert {name: told for name, told in found.items() if told} == {}


@pytest.mark.release
def test_a_row_that_is_zero_for_estimated_masses_has_its_range_and_a_dot_in_the_middle(
    tmp_path: Path, page: Page
) -> None:
    twin, quiet, path = (str(tmp_path / name) for name in ("twin.toml", "quiet.toml", "quiet.html"))
    Path(twin).write_text(TWIN)
    for words in (
        ["balance", twin, "--estimate", "--factor", "0.5", "--shafts", "all", "-o", quiet],
        ["page", quiet, "-o", path],
    ):
        with pytest.raises(SystemExit):
            cli.main(words)
    opened(page, Path(path))
    rows = page.locator("table.orders tbody tr").filter(has=page.locator("svg.path"))
    dots: dict[str, tuple[str, bool, float, float]] = {}
    for row in rows.all():
        circle = row.locator("svg.path circle")
        cx, cy = (float(circle.get_attribute(name) or 0) for name in ("cx", "cy"))
        still = circle.get_attribute("class") == "still"
        dots[f"{len(dots)}"] = (row.locator("td.right").inner_text(), still, cx, cy)
    zero = [dot for dot in dots.values() if dot[1]]
    assert zero
    assert all(re.match(r"0 \(0 to [\d.]+\)", text) for text, *_rest in zero)
    assert {(cx, cy) for _text, _still, cx, cy in zero} == {(0.0, 0.0)}
    moving = [dot for dot in dots.values() if not dot[1]]
    assert all(-1.01 <= cx <= 1.01 and -1.01 <= cy <= 1.01 for _t, _s, cx, cy in moving)
    assert "None of orders 1," not in page.locator("table.orders").inner_text()
    for line in page.locator(".now .range").all_inner_texts():
        assert all(len(part) < 9 for part in re.findall(r"[\d.]+", line))
