"""The panel Tolerances: the numbers of `crankstar tolerance`, where a file has tolerances."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from tests.tolerant import TOLERANT
from tests.web.engine_page import opened
from tests.web.everyone import SCREENS, Scheme, read_by_everyone

from crankstar import cli
from crankstar.analyses.tolerance import RECORD
from crankstar.files import engine_of
from crankstar.page.library import held
from crankstar.page.standalone import document


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


@pytest.mark.release
def test_the_panel_has_the_numbers_of_the_command(path: Path, page: Page, tmp_path: Path) -> None:
    file, answer = tmp_path / "engine.json", tmp_path / "answer.json"
    file.write_text(json.dumps(TOLERANT), encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        cli.main(
            [
                "tolerance",
                str(file),
                "--builds",
                str(RECORD.views["builds"]),
                "--json",
                "-o",
                str(answer),
            ]
        )
    assert left.value.code in (0, None)
    told = json.loads(answer.read_text(encoding="utf-8"))
    opened(page, path, "a=0&tab=tolerance")
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


@pytest.mark.release
def test_an_engine_without_tolerances_has_no_such_panel(built_page: Any, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=tolerance")
    expect(page.get_by_role("tab", name="Twist")).to_have_count(1)
    expect(page.get_by_role("tab", name="Tolerances")).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_the_panel_of_tolerances_is_read_by_everyone_on_every_screen(
    path: Path, page: Page, width: int, scheme: Scheme
) -> None:
    read_by_everyone(page, path, "a=30&tab=tolerance", width=width, scheme=scheme, figures=1)


@pytest.mark.release
def test_the_panel_is_reached_by_keys(path: Path, page: Page) -> None:
    opened(page, path, "a=0&tab=sound")
    page.get_by_role("tab", name="Sound").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("tab", name="Tolerances")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.get_by_role("heading", name="Which tolerance matters")).to_be_visible()
