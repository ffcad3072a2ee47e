"""The panel Ship of a large two-stroke engine: the numbers of `crankstar marine`; its section."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect
from tests.marine import SEVEN, WEIGHTED
from tests.report.reading import Reader
from tests.web.engine_page import opened
from tests.web.everyone import SCREENS, Scheme, read_by_everyone

from crankstar import cli
from crankstar.analyses.marine.large_engines import ship_engine
from crankstar.files import engine_of
from crankstar.page.library import held
from crankstar.page.standalone import document
from crankstar.report import Subject, report

SHIP: dict[str, Any] = {**SEVEN, **WEIGHTED}
SMALL: dict[str, Any] = {**SHIP, "cylinder": {**SHIP["cylinder"], "bore": "190 mm"}}
LACKING = {
    "four-stroke": {**SHIP, "cycle": "four-stroke"},
    "small": SMALL,
    "without gas": {**SHIP, "gas": None},
    "without masses": {
        **SEVEN,
        "cylinder": {
            key: value for key, value in SEVEN["cylinder"].items() if key != "reciprocating_mass"
        },
    },
    "without a speed": {key: value for key, value in SHIP.items() if key != "speed"},
}


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("ship") / "engine.html"
    place.write_text(document(held([engine_of(SHIP)], files_given=[SHIP])), encoding="utf-8")
    return place


def told(folder: Path) -> dict[str, Any]:
    """What `crankstar marine ... --json` writes."""
    file, answer = folder / "engine.json", folder / "answer.json"
    file.write_text(json.dumps(SHIP), encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        cli.main(["marine", str(file), "--json", "-o", str(answer)])
    assert left.value.code in (0, None)
    return json.loads(answer.read_text(encoding="utf-8"))


def size(cell: str) -> float:
    """The amplitude of a cell such as 329.8 ∠ 64.29°, kN m in N m."""
    return 1e3 * float(cell.split("∠")[0])


def compared(answer: dict[str, Any], tables: dict[str, list[list[str]]]) -> None:
    """External moments M_kV and M_kH and guide-force moments H and X, order by order."""
    for key, title, names in (
        ("moments", "External moments at 104 rpm", ("vertical", "horizontal")),
        ("guide", "Guide-force moments", ("h", "x")),
    ):
        rows = {row["order"]: row for row in answer[key]}
        shown = {float(row[0]): row[1:3] for row in tables[title]}
        assert {1.0, 2.0, 4.0} <= set(shown) <= set(rows)
        for order, cells in shown.items():
            expected = [rows[order][name]["amplitude"] for name in names]
            assert [size(cell) for cell in cells] == pytest.approx(expected, rel=6e-4, abs=1e-3)


@pytest.mark.release
def test_the_panel_has_the_moments_of_the_command(path: Path, page: Page, tmp_path: Path) -> None:
    opened(page, path, "a=0&tab=marine")
    panel = page.locator("[role=tabpanel]")
    expect(panel.locator(".figures svg")).to_have_count(1)
    tables = panel.locator("section.table:has(table)").evaluate_all(
        "all => all.map(each => [each.querySelector('h3').textContent,"
        "[...each.querySelectorAll('tbody tr')].map("
        "row => [...row.cells].map(cell => cell.textContent))])"
    )
    compared(told(tmp_path), dict(tables))


@pytest.mark.release
def test_the_report_has_a_section_with_the_same_moments(tmp_path: Path) -> None:
    read = Reader(report(Subject(engine_of(SHIP), SHIP, "crankstar report ship.toml")))
    assert "marine" in [tag.attributes.get("id") for tag in read.tags]
    titles = [title for title in read.tables if title.endswith("Guide-force moments")]
    assert len(titles) == 1, "not in the section on gas too"
    tables = {
        title: body[1:]
        for name, body in read.tables.items()
        for title in ("External moments at 104 rpm", "Guide-force moments")
        if name.endswith(title)
    }
    compared(told(tmp_path), tables)


@pytest.mark.parametrize("name", LACKING)
def test_other_engines_have_neither_panel_nor_section(name: str) -> None:
    assert ship_engine(engine_of(SHIP)) is not None
    assert ship_engine(engine_of(LACKING[name])) is None


@pytest.mark.release
def test_an_engine_of_a_car_has_no_such_panel(built_page: Any, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=marine")
    expect(page.get_by_role("tab", name="Twist")).to_have_count(1)
    expect(page.get_by_role("tab", name="Ship")).to_have_count(0)


@pytest.mark.release
@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_the_panel_of_a_ship_is_read_by_everyone_on_every_screen(
    path: Path, page: Page, width: int, scheme: Scheme
) -> None:
    read_by_everyone(page, path, "a=30&tab=marine", width=width, scheme=scheme, figures=1)
