"""The panel Mounts, and the block that moves on them: they show the numbers of the command."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect
from scipy.spatial.transform import Rotation
from tests.mounted_engines import BLOCK, FOUNDATION, HEAVY, SOFT, standing
from tests.report.reading import plain
from tests.web.engine_page import CARD, EIGHT, HANDLE, handle
from tests.web.engine_page import opened as at_once
from tests.web.everyone import Scheme, read_by_everyone
from tests.web.test_twist_panel import FLAT

from crankstar import cli
from crankstar.dynamics.mount_analysis import mounts
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import mount_axes
from crankstar.files import toml
from crankstar.page import exhibition
from crankstar.page.standalone import document
from crankstar.spectra import Real

Told = Callable[..., dict[str, Any]]
READ = (
    "angles => angles.map(a => { const page = HANDLE; page.theta = a; const read = page.read(); "
    "return { mounts: read.mounts, times: read.magnification } })"
).replace("HANDLE", HANDLE)
SQUARE: list[dict[str, Any]] = [
    {
        "name": f"{side} {end}",
        "up": BLOCK["up"],
        "right": f"{-15 + 300 * side} mm",
        "z": f"{-40 + 200 * end} mm",
        "stiffness": ["200 N/mm", "90 N/mm", "90 N/mm"],
    }
    for side in (-1, 1)
    for end in (-1, 1)
]
"""Four alike mounts about the centre of mass: the block goes straight up in a mode."""


def opened(page: Page, path: Path, state: str) -> None:
    """The page, loaded anew: an address of which only the end is another one is not."""
    page.goto("about:blank")
    at_once(page, path, state)


@lru_cache
def _contents(rotation: str, based: bool, soft: bool) -> tuple[str, Engine]:
    """The page of the five on mounts, and the engine."""
    changes: dict[str, Any] = {"rotation": rotation}
    if based:
        changes["foundation"] = FOUNDATION
    if soft:
        changes |= {"mounts": SOFT, "gas": None, **HEAVY}
    engine = standing(**changes)
    return _text(engine), engine


def _text(engine: Engine) -> str:
    empty = [{"charts": {}, "derivations": {}}]
    shown = exhibition([engine], relatives=False).model_dump(mode="json")
    return document({"exhibition": shown, "libraries": empty, "fitted": empty})


def written_of(
    folder: Path, rotation: str = "clockwise", *, based: bool = False, soft: bool = False
) -> tuple[Path, Engine]:
    text, engine = _contents(rotation, based, soft)
    path = folder / "engine.html"
    path.write_text(text, encoding="utf-8")
    return path, engine


@pytest.fixture
def told(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Told:
    """What `crankstar mounts ... --json` prints of an engine."""

    def run(engine: Engine, *words: str) -> dict[str, Any]:
        place = tmp_path / "engine.toml"
        place.write_text(toml(engine), encoding="utf-8")
        with pytest.raises(SystemExit) as left:
            cli.main(["mounts", str(place), *words, "--json"])
        assert left.value.code in (0, None)
        return json.loads(capsys.readouterr().out)

    return run


def read(page: Page, angles: list[float] = EIGHT) -> list[dict[str, Any]]:
    """The mounts as they are drawn at each angle (degrees)."""
    return page.evaluate(READ, angles)


def carried(place: Real, centre: Real, freedoms: Real, times: float) -> Real:
    """Where a body carries a point (up, right, z): truly turned by magnified small angles."""
    up, right, along, yaw, pitch, roll = times * freedoms
    # about right, up and z: the front goes up by a turn backwards about the axis to the right
    turn = Rotation.from_rotvec([-pitch, yaw, -roll])
    y, x, z = place - centre
    x, y, z = turn.apply([x, y, z])
    return centre + np.array([y + up, x + right, z + along])


def checked(
    engine: Engine,
    rest: list[dict[str, Any]],
    drawn: list[dict[str, Any]],
    motion: Real,
    forces: Real,
) -> None:
    """Upper ends go with the block, lower ones with what is below; forces [mount, axis, angle]."""
    block = mounts(engine).block
    for step, now in enumerate(drawn):
        for index, (mount, was) in enumerate(zip(now["mounts"], rest, strict=True)):
            base = motion[6:, step] if len(motion) > 6 else np.zeros(6)
            above, below = (motion[:6, step], base) if index < 3 else (base, np.zeros(6))
            centres = [block.centres[0 if index < 3 else 1], block.centres[-1]]
            for end, centre, own in zip(("upper", "lower"), centres, (above, below), strict=True):
                wanted = carried(np.array(was[end]), centre, own, now["times"])
                assert mount[end] == pytest.approx(wanted, abs=1e-6), (step, mount["name"], end)
            size = np.abs(forces).max()
            assert mount["force"] == pytest.approx(forces[index, :, step], abs=1e-6 * size)


def driven(engine: Engine, shown: dict[str, Any], angles: list[float]) -> tuple[Real, Real]:
    """All freedoms [freedom, angle] and forces on what is below [mount, axis, angle]."""
    found = mounts(engine, point=shown["point"], speed=shown["speed_rpm"] * math.pi / 30).at
    assert found is not None
    turning = np.exp(1j * np.multiply.outer(found.orders, np.radians(angles)))
    axes = np.array([mount_axes(each) for each in found.block.mounts])
    forces = np.einsum("kma,mai,kt->mit", found.mount_force[0], axes, turning)
    return np.real(found.motion[0].T @ turning), np.real(forces)


@pytest.mark.release
@pytest.mark.parametrize(
    ("rotation", "based", "means"),
    [
        ("clockwise", False, "webgl"),
        ("counter-clockwise", True, "webgl"),
        ("counter-clockwise", False, "flat"),
    ],
)
def test_mounts_are_drawn_where_the_block_carries_them(
    tmp_path: Path, page: Page, rotation: str, based: bool, means: str
) -> None:
    path, engine = written_of(tmp_path, rotation, based=based)
    if means == "flat":
        page.add_init_script(FLAT)
    opened(page, path, "a=0&tab=mounts")
    assert handle(page, "means") == means
    (still,) = read(page, [30.0])
    rest = still["mounts"]
    assert still["times"] == 0
    for mount, own in zip(rest, mounts(engine).block.mounts, strict=True):
        middle = (np.array(mount["upper"]) + np.array(mount["lower"])) / 2
        assert middle == pytest.approx([own.up, own.right, own.z], abs=1e-7)
    for place in (0, 2):
        state = f"mounts.show=forced&mounts.at={place}&mounts.times=300"
        page.evaluate(f"location.hash = 'a=0&tab=mounts&{state}'")
        expect(page.get_by_role("combobox", name="Driven at")).to_have_value(str(place))
        expect(page.get_by_role("radio", name="moving as it is driven")).to_be_checked()
        shown = handle(page, f"exhibits[0].mounts.vibrations[{place}]")
        motion, forces = driven(engine, shown, EIGHT)
        drawn = read(page)
        assert drawn[0]["times"] == 300
        checked(engine, rest, drawn, motion, forces)


@pytest.mark.release
@pytest.mark.parametrize("based", [True, False])
def test_in_a_mode_the_block_swings_once_a_turn(tmp_path: Path, page: Page, based: bool) -> None:
    path, engine = written_of(tmp_path, based=based)
    opened(page, path, "a=0&tab=mounts")
    rest = read(page, [0.0])[0]["mounts"]
    found = mounts(engine)
    low, high = (handle(page, f"exhibits[0].scene.{end}") for end in ("low", "high"))
    ends = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1).T - found.point
    for number in (1, 5):
        state = f"mounts.show=mode&mounts.mode={number}&mounts.times=40"
        page.evaluate(f"location.hash = 'a=0&tab=mounts&{state}'")
        expect(page.get_by_role("combobox", name="Mode", exact=True)).to_have_value(str(number))
        mode = found.modes[number - 1]
        up, right, along, yaw, pitch, roll = mode.shape[:6]
        u, r, z = ends.T
        moves = np.array(
            [up + z * pitch - r * roll, right + z * yaw + u * roll, along - r * yaw - u * pitch]
        )
        most = np.linalg.norm(moves, axis=0).max()
        if based:
            most = max(most, float(np.linalg.norm(mode.shape[6:9])))
        size = 1e-3 / most
        swing = np.cos(np.radians(EIGHT))
        motion = np.multiply.outer(size * mode.shape, swing)
        axes = np.array([mount_axes(each) for each in found.block.mounts])
        stiff = found.block.along * found.block.stiffening(mode.speed)[:, None]
        along_axes = stiff * (found.block.arms @ mode.shape) * size
        forces = np.multiply.outer(np.einsum("ma,mai->mi", along_axes, axes), swing)
        checked(engine, rest, read(page), motion, forces)


@pytest.mark.release
@pytest.mark.parametrize("means", ["webgl", "flat"])
def test_the_picture_of_the_block_is_moved_as_much_as_is_said(
    tmp_path: Path, page: Page, means: str
) -> None:
    """Bouncing by 1 mm times 100, it is drawn 100 mm higher, and no other part of it moves."""
    engine = standing(mounts=SQUARE)
    number = 1 + int(np.argmax([mode.energy[0] for mode in mounts(engine).modes]))
    assert mounts(engine).modes[number - 1].energy[0] > 0.9999
    path = tmp_path / "engine.html"
    path.write_text(_text(engine), encoding="utf-8")
    page.add_init_script(FLAT if means == "flat" else CARD)
    hidden = "camera=front&force=0&couple=0&roll=0&glow=0&a=0&tab=mounts"

    def picture(show: str) -> Any:
        opened(page, path, f"{hidden}&mounts.mode={number}&mounts.times=20&mounts.show={show}")
        (pane,) = handle(page, "read().panes")
        box = page.locator(".stage .canvas").bounding_box()
        assert box
        shot = page.screenshot(clip={**box})
        image = np.asarray(Image.open(io.BytesIO(shot)).convert("RGB")).astype(int)
        # the lower part of the bore and the crank, beside which no mount stands
        x, y = round(pane["origin"][0]), round(pane["origin"][1])
        half = round(0.03 * pane["scale"])
        strip = image[y - round(0.12 * pane["scale"]) : y + round(0.05 * pane["scale"])]
        assert strip.shape[0] > 20
        rows = image[:, x - half : x + half]
        return rows, pane["scale"], y

    still, scale, level = picture("still")
    moved, other, base = picture("mode")
    sign = -1 if handle(page, f"exhibits[0].mounts.modes[{number - 1}].shape[0]") < 0 else 1
    assert abs(other / scale - 1) < 0.35
    # the same strip, each in its own scale about the crank axis, 20 mm apart
    heights = np.linspace(-0.03, 0.1, 60)
    before = still[np.round(level - heights * scale).astype(int)].mean(axis=(1, 2))
    after = moved[np.round(base - (heights + sign * 0.02) * other).astype(int)].mean(axis=(1, 2))
    unmoved = moved[np.round(base - heights * other).astype(int)].mean(axis=(1, 2))
    assert np.abs(before - after).mean() < 0.35 * np.abs(before - unmoved).mean()


@pytest.mark.release
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_on_soft_mounts_the_block_moves_as_in_free_whirl(
    tmp_path: Path, page: Page, rotation: str
) -> None:
    path, _engine = written_of(tmp_path, rotation, soft=True)
    opened(page, path, "a=0&tab=mounts&whirl=5000")
    free, drawn = handle(page, "read().paths"), read(page)
    opened(page, path, "a=0&tab=mounts&mounts.show=forced&mounts.times=5000")
    mounted, moved = handle(page, "read().paths"), read(page)
    assert [now["times"] for now in (*drawn, *moved)] == [5000] * 16
    for end in ("front", "rear"):
        whirled = np.array(free[end])
        assert np.all(np.ptp(whirled, axis=0) > 1e-6), "up and to the right"
        assert np.array(mounted[end]) == pytest.approx(whirled, abs=1e-6 * np.abs(whirled).max())
    for one, other in zip(drawn, moved, strict=True):
        for mount, same in zip(one["mounts"], other["mounts"], strict=True):
            assert mount["upper"] == pytest.approx(same["upper"], abs=1e-6)
            assert mount["lower"] == pytest.approx(same["lower"], abs=1e-9)


def cells(page: Page, title: str) -> list[list[str]]:
    """The rows of a table of the panel by its title, heads first."""
    table = page.locator(".mounts-of section.table", has=page.get_by_role("heading", name=title))
    return table.locator("table").first.evaluate(
        "table => [...table.rows].map(row => [...row.cells].map(cell => cell.textContent))"
    )


def number(text: str) -> float:
    return float(plain(text.strip()).removeprefix("+"))


@pytest.mark.release
def test_every_number_of_the_panel_is_that_of_the_command(
    tmp_path: Path, page: Page, told: Told
) -> None:
    path, engine = written_of(tmp_path)
    opened(page, path, "a=0&tab=mounts")
    answer = told(engine)
    _heads, *rows = cells(page, "Natural modes")
    for row, mode in zip(rows, answer["modes"], strict=True):
        frequency = mode["frequency_hz"]
        assert [number(cell) for cell in row[1:3]] == pytest.approx(
            [frequency, 60 * frequency], rel=6e-5
        )
        assert [number(cell) for cell in row[4:]] == pytest.approx(
            [100 * share for share in mode["energy"]], abs=0.06
        )
    bars = page.locator(".energy-bars ol > li").evaluate_all(
        "rows => rows.map(row => [...row.querySelectorAll('.energy-bar i')].map("
        "bar => [bar.className.trim(), bar.getBoundingClientRect().width "
        "/ bar.parentElement.getBoundingClientRect().width]))"
    )
    names = ("up", "right", "along", "yaw", "pitch", "roll")
    for row, mode in zip(bars, answer["modes"], strict=True):
        widths = dict(row)
        for name, share in zip(names, mode["energy"], strict=True):
            assert widths.get(f"free-{name}", 0) == pytest.approx(share, abs=2e-3)
    loads = page.locator(".load-bars .number").all_inner_texts()
    expected = [row["load"] for row in answer["mounts"]]
    assert [number(each) for each in loads] == pytest.approx(expected, rel=6e-4)
    _heads, *rows = cells(page, "Axes")
    for row, axis in zip(rows, answer["axes"], strict=True):
        keys = ("up", "right", "z", "angle_deg", "advance")
        assert [number(cell) for cell in row[1:]] == pytest.approx(
            [axis[key] for key in keys], rel=6e-4, abs=1e-6
        )


@pytest.mark.release
def test_curves_over_the_speed_have_their_dot_where_the_engine_runs(
    tmp_path: Path, page: Page, told: Told
) -> None:
    path, engine = written_of(tmp_path)
    opened(page, path, "a=0&tab=mounts")
    for place in (0, 1, 2):
        page.get_by_role("combobox", name="Driven at").select_option(str(place))
        shown = handle(page, f"exhibits[0].mounts.vibrations[{place}]")
        rpm = shown["speed_rpm"]
        # over the speeds without the name of a point, as the curves are
        row = told(engine, "--speeds", f"{rpm!r}..{1.001 * rpm!r} rpm/2")["speeds"][0]
        values = page.locator(".over-speed output").all_inner_texts()
        wanted = [row["velocity_rms"], row["displacement_rms"], row["force_rms"]]
        assert [number(each) for each in values] == pytest.approx(
            [*wanted, *row["transmissibility"]], rel=0.02
        )
        dots = page.locator(".over-speed").first.evaluate(
            "figure => { const [svg, dot] = ['svg', '.plot-dot'].map("
            "each => figure.querySelector(each).getBoundingClientRect());"
            "return [(dot.x + dot.width / 2 - svg.x) / svg.width,"
            "(dot.y + dot.height / 2 - svg.y) / svg.height] }"
        )
        over = handle(page, "exhibits[0].mounts.over")
        velocity = handle(page, "exhibits[0].mounts.points[0].velocity")
        low, high = over["speeds_rpm"][0], over["speeds_rpm"][-1]
        assert dots[0] == pytest.approx((shown["speed_rpm"] - low) / (high - low), abs=0.01)
        share = 1 - 1e-3 * row["velocity_rms"] / (1.06 * max(velocity))
        assert dots[1] == pytest.approx(share, abs=0.02)


@pytest.mark.release
def test_courses_run_with_the_crank_and_add_up_all_orders(tmp_path: Path, page: Page) -> None:
    path, engine = written_of(tmp_path, "counter-clockwise")
    opened(page, path, "a=0&tab=mounts&mounts.at=2")
    shown = handle(page, "exhibits[0].mounts.vibrations[2]")
    motion, forces = driven(engine, shown, EIGHT)
    ground = forces.sum(axis=0)
    for step, angle in enumerate(EIGHT):
        handle(page, f"theta = {angle}")
        values = page.locator(".cycle-curves:not(.over-speed) output").all_inner_texts()
        told_numbers = [number(each) for each in values]
        # the point is the centre of mass, unless another is asked for
        assert told_numbers[:3] == pytest.approx(1e6 * motion[:3, step], abs=6e-3)
        assert told_numbers[3:] == pytest.approx(ground[:, step], abs=6e-3)


@pytest.mark.release
def test_an_engine_without_mounts_has_no_such_panel(built_page: Any, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=mounts&mounts.show=forced")
    expect(page.get_by_role("tab", name="Twist")).to_have_count(1)
    expect(page.get_by_role("tab", name="Mounts")).to_have_count(0)
    assert handle(page, "read().mounts") == []
    assert handle(page, "read().magnification") == 0


@pytest.mark.release
def test_what_moves_the_block_is_reached_by_keys_and_linked(tmp_path: Path, page: Page) -> None:
    path, _engine = written_of(tmp_path)
    opened(page, path, "a=30&tab=mounts")
    page.get_by_role("radio", name="as it stands").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("radio", name="moving in a mode")).to_be_checked()
    slider = page.get_by_role("slider", name="Magnification")
    slider.focus()
    before = slider.get_attribute("aria-valuetext")
    page.keyboard.press("PageUp")
    assert slider.get_attribute("aria-valuetext") != before
    page.get_by_role("button", name="Mode 3").press("Enter")
    page.wait_for_function(
        "() => ['mounts.show=mode', 'mounts.mode=3', 'mounts.times=']"
        ".every(each => location.hash.includes(each))"
    )
    drawn = handle(page, "read().mounts")
    opened(page, path, page.evaluate("location.hash.slice(1)"))
    assert handle(page, "read().mounts") == drawn


@pytest.mark.release
@pytest.mark.parametrize(("width", "scheme"), [(390, "light"), (320, "dark"), (1280, "dark")])
def test_the_panel_of_mounts_is_read_by_everyone_on_every_screen(
    tmp_path: Path, page: Page, width: int, scheme: Scheme
) -> None:
    path, _engine = written_of(tmp_path, based=width == 320)
    for show in ("mode", "forced"):
        state = f"a=30&tab=mounts&mounts.show={show}"
        read_by_everyone(page, path, state, width=width, scheme=scheme)
