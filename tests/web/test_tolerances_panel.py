"""The panel Tolerances: the numbers of `crankstar tolerance`, where a file has tolerances."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from tests.texts import SHORT, spoilt
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import opened
from tests.web.overflow import overflows

from crankstar import cli
from crankstar.files import engine_of
from crankstar.page.library import held
from crankstar.page.standalone import document
from crankstar.tables.built_facts import BUILDS

TOLERANT: dict[str, Any] = spoilt(
    SHORT,
    name="four with tolerances",
    firing_order=[1, 3, 4, 2],
    speed="6000 rpm",
    cylinder={
        "bore": "86 mm",
        "stroke": "86 mm +- 0.05 mm",
        "rod_length": "143 mm",
        "reciprocating_mass": "650 g +- 2 g",
        "rotating_mass": "450 g +- 3 g",
    },
    layout={"type": "inline", "bore_pitch": "94 mm +- 0.1 mm"},
)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("tolerances") / "engine.html"
    place.write_text(document(held([engine_of(TOLERANT)], files_given=[TOLERANT])), "utf-8")
    return place


def rows(page: Page, title: str) -> list[list[str]]:
    table = page.locator("[role=tabpanel] section.table").filter(
        has=page.get_by_role("heading", name=title, exact=True)
    )
    return table.locator("table").evaluate(
        "table => [...table.rows].slice(1).map(row => [...row.cells].map(c => c.textContent))"
    )


def test_the_panel_has_the_numbers_of_the_command(path: Path, page: Page, tmp_path: Path) -> None:
    file, answer = tmp_path / "engine.json", tmp_path / "answer.json"
    file.write_text(json.dumps(TOLERANT), encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        cli.main(["tolerance", str(file), "--builds", str(BUILDS), "--json", "-o", str(answer)])
    assert left.value.code in (0, None)
    told = json.loads(answer.read_text(encoding="utf-8"))
    opened(page, path, "a=0&tab=tolerances")
    by_order = {(row["signal"], row["order"]): row for row in told["orders"]}
    signals = {"force": "force", "couple": "couple", "rolling moment": "roll"}
    shown = rows(page, "Scatter of each order")
    assert {row[0] for row in shown} == set(signals)
    for name, order, nominal, rms, *_quantiles, worst, unit in shown:
        row = by_order[signals[name], float(order)]
        factor = 1e3 if unit.startswith("k") else 1.0
        sizes = [factor * float(each) for each in (nominal, rms, worst)]
        expected = [row[key] for key in ("nominal", "rms", "worst")]
        assert sizes == pytest.approx(expected, rel=6e-4, abs=1e-6)
    matters = {path: cells for path, *cells in rows(page, "Which tolerance matters")}
    share = {
        each["tolerance"]: each["share"]
        for each in told["shares"]
        if (each["signal"], each["order"]) == ("force", 1.0)
    }
    assert max(share, key=lambda each: share[each]) == "cylinder.rotating_mass"
    for tolerance, part in share.items():
        assert float(matters[tolerance][0]) == pytest.approx(100 * part, abs=0.06)
    expect(page.locator("[role=tabpanel] .figures svg")).to_have_count(1)


def test_an_engine_without_tolerances_has_no_such_panel(built_page: Any, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=tolerances")
    expect(page.get_by_role("tab", name="Twist")).to_have_count(1)
    expect(page.get_by_role("tab", name="Tolerances")).to_have_count(0)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("width", "scheme"), [(320, "dark"), (390, "light"), (1024, "dark"), (1440, "light")]
)
def test_the_panel_of_tolerances_is_read_by_everyone_on_every_screen(
    path: Path, page: Page, width: int, scheme: Any
) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    page.emulate_media(color_scheme=scheme)
    opened(page, path, "a=30&tab=tolerances")
    expect(page.locator("[role=tabpanel] .figures svg")).to_have_count(1)
    assert too_wide(page) == []
    assert overflows(page) == []
    assert barriers(page) == []


def test_the_panel_is_reached_by_keys(path: Path, page: Page) -> None:
    opened(page, path, "a=0&tab=sound")
    page.get_by_role("tab", name="Sound").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("tab", name="Tolerances")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_role("heading", name="Which tolerance matters")).to_be_visible()
