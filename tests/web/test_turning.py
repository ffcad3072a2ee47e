"""The engine turns: play, stop, go to an angle; every piston is where Python puts it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from tests.web.engine_page import FRAMES, drawn, farthest_off, handle, opened, turns_on

from crankstar.files.catalog import load

Build = Callable[..., Path]
LAYOUTS = [
    "v8-cross-plane",
    "pratt-whitney-wasp",
    "jumo-205",
    *(pytest.param(name, marks=pytest.mark.release) for name in ("audi-25-tfsi", "kr250-racer")),
]


@pytest.mark.release
def test_it_plays_when_it_is_opened_and_stops_and_plays_again(
    built_page: Build, page: Page
) -> None:
    page.emulate_media(reduced_motion="no-preference")
    opened(page, built_page("v8-cross-plane"), "")
    turns_on(page)
    page.get_by_role("button", name="Stop").click()
    stood = handle(page, "theta")
    assert not handle(page, "playing")
    page.evaluate(FRAMES, 10)
    assert handle(page, "theta") == stood
    page.get_by_role("button", name="Play").click()
    turns_on(page)


@pytest.mark.release
def test_it_does_not_start_by_itself_where_motion_is_not_wished(
    built_page: Build, page: Page
) -> None:
    page.emulate_media(reduced_motion="reduce")
    opened(page, built_page("v8-cross-plane"), "")
    assert not handle(page, "playing")
    assert handle(page, "theta") == 0
    page.get_by_role("button", name="Play").click()
    turns_on(page)  # a wish that is said is followed


TYPED = {
    "450": 450.0,
    "-30": 690.0,
    "90 deg": 90.0,
    "1.5 rad": math.degrees(1.5),
    "2.25 turns": 90.0,
    "４５．５": 45.5,
    "90度": 90.0,
    "－３０　度": 690.0,
    "120 град": 120.0,
    "120 град.": 120.0,
    "1,5 рад": math.degrees(1.5),
    "1.25 оборота": 450.0,
}


@pytest.mark.release
def test_it_goes_to_a_typed_angle(built_page: Build, page: Page) -> None:
    page.emulate_media(reduced_motion="no-preference")
    opened(page, built_page("v8-cross-plane"), "")
    field = page.get_by_label("Crank angle: type degrees")
    for typed, degrees in TYPED.items():
        field.fill(typed)
        field.press("Enter")
        assert not handle(page, "playing")
        assert handle(page, "theta") == pytest.approx(degrees, abs=1e-9)
        page.get_by_role("button", name="Play").click()
        assert handle(page, "playing")


@pytest.mark.release
def test_what_is_no_angle_is_answered_and_moves_nothing(built_page: Build, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=90")
    field = page.get_by_label("Crank angle: type degrees")
    field.fill("a quarter")
    field.press("Enter")
    expect(field).to_have_attribute("aria-invalid", "true")
    expect(field).to_have_accessible_description(re.compile("450|deg"))
    assert handle(page, "theta") == 90


@pytest.mark.release
@pytest.mark.parametrize("name", LAYOUTS)
def test_every_piston_is_where_python_says(name: str, built_page: Build, page: Page) -> None:
    opened(page, built_page(name))
    assert farthest_off(load(name), drawn(page)) < 1e-6


@pytest.mark.release
def test_two_engines_turn_at_the_same_angle(built_page: Build, page: Page) -> None:
    opened(page, built_page("v8-cross-plane", "v8-flat-plane"), "tab=compare")
    for index, name in enumerate(("v8-cross-plane", "v8-flat-plane")):
        assert farthest_off(load(name), drawn(page, index=index)) < 1e-6


@pytest.mark.release
@pytest.mark.parametrize("end", ["front", pytest.param("rear", marks=pytest.mark.release)])
def test_the_axis_of_a_cross_plane_crank_whirls_in_a_circle(
    end: str, built_page: Build, page: Page
) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&whirl=1000")
    path = [complex(up, right) for up, right in handle(page, f"read().paths.{end}")]
    assert len(path) >= 36
    centre = sum(path) / len(path)
    radii = [abs(point - centre) for point in path]
    assert min(radii) > 0
    assert max(radii) / min(radii) < 1.01
