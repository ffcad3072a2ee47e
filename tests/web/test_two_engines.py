"""Two engines on one page: every panel shows both, to one scale, and by how much they differ."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from tests.report.reading import plain
from tests.web.engine_page import opened

from crankstar import spectra
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, of_parts, total

Build = Callable[..., Path]
ONE, OTHER = "v8-cross-plane", "v8-flat-plane"
THETA = 40.0


def number(text: str) -> float:
    """The number that a cell begins with."""
    found = re.search(r"[+-]?\d+\.?\d*(e[+-]\d+)?", plain(text))
    assert found, text
    return float(found.group())


@pytest.mark.release
def test_the_difference_now_is_that_of_the_two_balances(built_page: Build, page: Page) -> None:
    opened(page, built_page(ONE, OTHER, figures=False), f"a={THETA}&tab=orders")
    blocks = page.locator(".now .numbers")
    expect(blocks).to_have_count(3)
    shown = [number(text) for text in blocks.nth(2).locator("output").all_inner_texts()]
    at = math.radians(THETA)
    values = []
    for name in (ONE, OTHER):
        whole = total(balance(load(name)))
        force, couple = (
            complex(spectra.value(each, np.array([at]))[0]) for each in (whole.force, whole.couple)
        )
        values.append([force.real, force.imag, couple.real, couple.imag])
    expected = np.subtract(values[1], values[0])
    assert shown[:4] == pytest.approx(expected.tolist(), abs=2e-3)


@pytest.mark.release
def test_the_orders_of_both_stand_beside_each_other_with_their_difference(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(ONE, OTHER, figures=False), "a=0&tab=orders")
    group = page.locator("table.orders tbody").filter(has_text="Couple").first
    row = group.locator("tr:not(.group)").first
    cells = row.locator("td").all_inner_texts()
    assert number(cells[0]) == pytest.approx(math.sqrt(10), rel=1e-4)
    assert number(cells[1]) == 0
    assert number(cells[2]) == pytest.approx(-math.sqrt(10), rel=1e-4)
    row.click()
    expect(row).to_have_class("chosen")
    page.wait_for_function("() => location.hash.includes('orders=1')")
    page.get_by_role("radio", name="V8, flat-plane crank, 90 deg").check()
    expect(page.locator("table.orders")).not_to_contain_text("difference")
    page.wait_for_function("() => location.hash.includes('panel=2')")


@pytest.mark.release
@pytest.mark.parametrize("tab", ["cylinders", "bearings", "verdict", "whirl", "strokes"])
def test_a_panel_shows_both_engines_under_their_names(
    tab: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page(ONE, OTHER, figures=False), f"a=0&tab={tab}")
    names = page.locator(".panel .of-engine > h3").all_inner_texts()
    assert names == [load(name).name for name in (ONE, OTHER)]
    page.get_by_role("radio", name=names[1]).check()
    expect(page.locator(".panel .of-engine")).to_have_count(0)


@pytest.mark.release
def test_rows_of_cylinders_and_banks_are_the_forces_of_the_analysis(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(OTHER, figures=False), f"a={THETA}&tab=cylinders")
    engine = load(OTHER)
    result = balance(engine)
    at = np.array([math.radians(THETA)])
    forces = {
        cylinder.number: complex(
            spectra.value(of_parts(result, cylinder=cylinder.number).force, at)[0]
        )
        for cylinder in engine.cylinders
    }
    sums = {f"bank {name}": sum(forces[n] for n in own) for name, own in engine.banks.items()}
    whole = complex(spectra.value(total(result).force, at)[0])
    expected = {**{str(n): force for n, force in forces.items()}, **sums, "engine": whole}
    rows = page.locator("table.pulls tbody tr").all()
    assert len(rows) == len(expected)
    for row in rows:
        name = row.locator("th").inner_text()
        *_, up, right = row.locator("output").all_inner_texts()
        force = expected.pop(name)
        assert [number(up), number(right)] == pytest.approx([force.real, force.imag], abs=1e-3)
    assert not expected


@pytest.mark.release
def test_a_long_name_above_its_numbers_is_whole_where_there_is_room(
    built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": 1440, "height": 900})
    opened(page, built_page("kr250-racer", "kr250-production"), "a=0")
    names = page.locator(".now .whose").evaluate_all(
        "all => all.map(name => name.scrollWidth - name.clientWidth)"
    )
    assert names == [0, 0, 0]


@pytest.mark.release
def test_numbers_leave_two_engines_room_on_a_low_window(built_page: Build, page: Page) -> None:
    page.set_viewport_size({"width": 1024, "height": 768})
    opened(page, built_page("v8-flat-plane", "v8-cross-plane"), "a=0")
    box = page.locator(".stages").bounding_box()
    assert box
    assert box["height"] >= 250
    last = page.locator(".now .numbers").last
    last.scroll_into_view_if_needed()
    expect(last).to_be_in_viewport(ratio=1)
