"""The panel Mounts at any speed and any point: worked out in the browser as in Python."""

from __future__ import annotations

import json
import math
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from tests.mounted_engines import BLOCK, FOUNDATION, standing
from tests.web.engine_page import EIGHT, handle
from tests.web.everyone import SCREENS, Scheme, read_by_everyone
from tests.web.test_mounts_panel import _text, cells, checked, number, opened, read

from crankstar import cli
from crankstar.dynamics.mount_analysis import mounts
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import mount_axes
from crankstar.files import toml
from crankstar.spectra import Real

POINTS = [
    {"name": "gearbox end", "up": "20 mm", "z": "-0.6 m"},
    {"name": "head", "up": "420 mm", "right": "60 mm"},
]


@lru_cache
def _contents(based: bool) -> tuple[str, Engine]:
    changes: dict[str, Any] = {"foundation": FOUNDATION} if based else {}
    engine = standing(block={**BLOCK, "points": POINTS}, **changes)
    return _text(engine), engine


def written(folder: Path, *, based: bool = False) -> tuple[Path, Engine]:
    text, engine = _contents(based)
    path = folder / "engine.html"
    path.write_text(text, encoding="utf-8")
    return path, engine


def told(engine: Engine, folder: Path, *words: str) -> dict[str, Any]:
    """What `crankstar mounts ... --json` writes of an engine."""
    place, answer = folder / "engine.toml", folder / "answer.json"
    place.write_text(toml(engine), encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        cli.main(["mounts", str(place), *words, "--json", "-o", str(answer)])
    assert left.value.code in (0, None)
    return json.loads(answer.read_text(encoding="utf-8"))


def numbers(row: list[str]) -> list[float]:
    return [number(cell) for cell in row[1:]]


def at(engine: Engine, rpm: float) -> tuple[Real, Real]:
    """Freedoms [freedom, angle] and forces on what is below [mount, axis, angle] at a speed."""
    found = mounts(engine, speed=rpm * math.pi / 30).at
    assert found is not None
    turning = np.exp(1j * np.multiply.outer(found.orders, np.radians(EIGHT)))
    axes = np.array([mount_axes(each) for each in found.block.mounts])
    forces = np.einsum("kma,mai,kt->mit", found.mount_force[0], axes, turning)
    return np.real(found.motion[0].T @ turning), np.real(forces)


@pytest.mark.release
@pytest.mark.parametrize("rpm", [811, 3210, 6111])
def test_tables_at_any_speed_are_those_of_the_command(tmp_path: Path, page: Page, rpm: int) -> None:
    path, engine = written(tmp_path)
    opened(page, path, f"a=0&tab=mounts&mounts.rpm={rpm}")
    answer = told(engine, tmp_path, "--speed", f"{rpm} rpm")
    _heads, *rows = cells(page, f"Points at {rpm} rpm")
    assert [row[0] for row in rows[:3]] == ["gearbox end", "head", "centre of mass"]
    keys = ("displacement_rms", "velocity_rms", "acceleration_rms")
    for row, point in zip(rows[:2], answer["points_at_speed"], strict=True):
        assert numbers(row) == pytest.approx([point[key] for key in keys], rel=6e-4)
    _heads, *rows = cells(page, f"Force in the mounts at {rpm} rpm")
    keys = ("rms", "peak", "transmissibility", "heat")
    for row, mount in zip(rows, answer["mounts_at_speed"], strict=True):
        assert row[0] == mount["name"]
        assert numbers(row) == pytest.approx([mount[key] for key in keys], rel=2e-3)
    page.get_by_text(f"Amplitudes of the point by order at {rpm} rpm").click()
    rows = page.locator(".mounts-of details[open] table").evaluate(
        "table => [...table.rows].slice(1).map(row => [...row.cells].map(c => c.textContent))"
    )
    assert len(rows) == len(answer["orders"])
    for row, order in zip(rows, answer["orders"], strict=True):
        sizes = [order[key]["amplitude"] for key in ("up", "right", "z")]
        assert number(row[0]) == order["order"]
        assert numbers(row) == pytest.approx([*sizes, order["force_rms"]], rel=6e-4, abs=1e-6)


@pytest.mark.release
@pytest.mark.parametrize("based", [True, False])
def test_the_stage_moves_as_python_says_at_any_speed(
    tmp_path: Path, page: Page, based: bool
) -> None:
    path, engine = written(tmp_path, based=based)
    opened(page, path, "a=0&tab=mounts")
    rest = read(page, [0.0])[0]["mounts"]
    opened(page, path, "a=0&tab=mounts&mounts.show=forced&mounts.rpm=2345&mounts.times=300")
    checked(engine, rest, read(page), *at(engine, 2345))


@pytest.mark.release
def test_every_point_has_its_curves_over_the_speed(tmp_path: Path, page: Page) -> None:
    path, engine = written(tmp_path, based=True)
    opened(page, path, "a=0&tab=mounts&mounts.rpm=2500")
    found = mounts(engine, speeds=[2499.9 * math.pi / 30, 2500 * math.pi / 30]).over
    assert found is not None
    for name, place, of in (
        ("head", (0.42, 0.06, 0.0), 0),
        ("foundation: centre of mass", found.block.centres[1], 1),
        ("rear", (-0.02, 0.0, -0.48), 0),
    ):
        page.get_by_role("combobox", name="Point").select_option(label=name)
        figure = page.locator(".over-speed", has_text=f"Vibration of the point {name}, rms")
        size = number(figure.locator("output").inner_text())
        velocity = np.sqrt((np.abs(found.velocity(place, of=of)[1]) ** 2).sum() / 2)
        assert size == pytest.approx(1e3 * velocity, rel=0.02)
        course = page.locator(
            ".cycle-curves", has_text=f"Displacement of the point {name} at 2500 rpm"
        )
        values = [number(each) for each in course.locator("output").all_inner_texts()]
        now = np.real(found.displacement(place, of=of)[1].sum(axis=0))
        assert values == pytest.approx(1e6 * now, abs=6e-3)


@pytest.mark.release
def test_speed_and_point_are_chosen_by_keys_typed_and_linked(tmp_path: Path, page: Page) -> None:
    path, _engine = written(tmp_path)
    opened(page, path, "a=30&tab=mounts&mounts.rpm=3000")
    slider = page.get_by_role("slider", name="Speed of the engine")
    field = page.get_by_role("spinbutton", name="Speed of the engine, rpm")
    driven = page.get_by_role("combobox", name="Driven at")
    slider.focus()
    page.keyboard.press("ArrowRight")
    expect(field).to_have_value("3001")
    expect(driven.locator("option:checked")).to_have_text("3001 rpm")
    field.fill("99999")
    field.press("Enter")
    expect(field).to_have_value("6500")
    field.fill("2222")
    field.press("Enter")
    expect(slider).to_have_value("2222")
    page.get_by_role("combobox", name="Point").select_option(label="head")
    page.wait_for_function(
        "() => ['mounts.rpm=2222', 'mounts.point=1'].every(each => location.hash.includes(each))"
    )
    opened(page, path, page.evaluate("location.hash.slice(1)"))
    expect(field).to_have_value("2222")
    expect(page.get_by_role("heading", name="Points at 2222 rpm")).to_be_visible()
    driven.select_option("0")
    note = handle(page, "exhibits[0].mounts.vibrations[0]")
    expect(field).to_have_value(f"{note['speed_rpm']:.0f}")
    page.wait_for_function("() => !location.hash.includes('mounts.rpm')")


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_any_speed_is_read_by_everyone_on_every_screen(
    tmp_path: Path, page: Page, width: int, scheme: Scheme
) -> None:
    path, _engine = written(tmp_path, based=width == 320)
    state = "a=30&tab=mounts&mounts.show=forced&mounts.rpm=3210&mounts.point=1"
    read_by_everyone(page, path, state, width=width, scheme=scheme)
