"""The drawn engine: its parts stand where they move, its arrows are the sums, its films loop."""

from __future__ import annotations

import io
import os
import re
import signal
import subprocess
import sys
from math import cos, pi, sin, sqrt
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE
from tests.holding import PATIENCE, awaited

import crankstar
from crankstar import spectra
from crankstar.mechanics import remains
from crankstar.page.scene import scene
from crankstar.pictures.arrows import load_of
from crankstar.pictures.drawings import Picture, drawing, drawings
from crankstar.pictures.films import Pace, film, rasters
from crankstar.pictures.looks import look_of
from crankstar.pictures.motions import motion_of, turns_of
from crankstar.pictures.ordering import painted_order
from crankstar.pictures.panes import SIGHTS

SPACE = "{http://www.w3.org/2000/svg}"
ANGLES = [0.0, 0.7, 2.0, 3.9, 5.5]


def read(svg: str) -> ElementTree.Element:
    return ElementTree.fromstring(svg)  # noqa: S314 - our own


def corners(path: str) -> np.ndarray:
    return np.array(
        [[float(x) for x in pair] for pair in re.findall(r"(-?[\d.e-]+) (-?[\d.e-]+)", path)]
    )


def outlines(svg: str) -> dict[int, np.ndarray]:
    """The outline of every piston, px, by the number of its cylinder."""
    return {
        int((group.get("data-part") or "").split()[1]): corners(
            next(iter(group.iter(f"{SPACE}path"))).get("d") or ""
        )
        for group in read(svg).iter(f"{SPACE}g")
        if group.get("data-part")
    }


def test_pistons_of_a_drawing_stand_where_the_slider_crank_puts_them() -> None:
    """Their places in the side view, read back, against r cos t + sqrt(l^2 - r^2 sin^2 t)."""
    engine = crankstar.load("triumph-675")
    shown = Picture(view="side", width=1600, height=1200)
    drawn = [outlines(svg) for svg in drawings(engine, ANGLES, shown)]
    for cylinder in engine.cylinders:
        throw = engine.throw(cylinder)
        radius, length, angle = throw.radius, cylinder.rod_length, throw.angle
        px = np.ptp(drawn[0][cylinder.number][:, 0]) / (0.98 * (cylinder.bore or 0))
        heights = [
            radius * cos(psi) + sqrt(length**2 - (radius * sin(psi)) ** 2)
            for psi in (angle + engine.sense * theta for theta in ANGLES)
        ]
        foots = [-outline[cylinder.number][:, 1].max() / px for outline in drawn]
        moved = np.array(foots) - foots[0]
        assert moved == pytest.approx(np.array(heights) - heights[0], abs=0.3 / px)


@EVERY_ENGINE
def test_rods_of_a_motion_have_their_length_and_pistons_their_axes(name: str) -> None:
    engine = crankstar.load(name)
    drawn = scene(engine)
    moving = motion_of(engine, drawn, np.array(ANGLES))
    for row, c in enumerate(drawn.cylinders):
        shaft = drawn.shafts[c.shaft]
        home = complex(shaft.up, shaft.right)
        assert abs(moving.piston[row] - moving.big_end[row]) == pytest.approx(c.rod_length)
        along = (moving.piston[row] - home) / np.exp(1j * c.bearing)
        assert np.imag(along) == pytest.approx(c.offset, abs=1e-9 * c.rod_length)
        if c.master < 0:
            pin = c.crank_radius * np.exp(1j * (c.throw_angle + moving.shaft[c.shaft]))
            assert moving.big_end[row] == pytest.approx(home + pin)


@pytest.mark.many(first=9)
@EVERY_ENGINE
@pytest.mark.parametrize("view", SIGHTS)
def test_nothing_of_a_drawing_is_cut_off(name: str, view: str) -> None:
    engine = crankstar.load(name)
    how = Picture(view=view)  # pyright: ignore[reportArgumentType]
    for svg in drawings(engine, [0.0, 2.0], how):
        assert "nan" not in svg
        views = len([*read(svg).iter(f"{SPACE}path")])
        assert views > 5
        paths = re.findall(r'd="(M[^"lHhc]*)"', svg)
        spots = np.vstack([corners(path) for path in paths if " " in path])
        assert spots.min() >= -1
        assert spots[:, 0].max() <= how.width + 1
        assert spots[:, 1].max() <= how.height + 1
        numbers = {c.number for c in scene(engine).cylinders}
        written = {
            number
            for text in read(svg).iter(f"{SPACE}text")
            if re.fullmatch(r"[\d·–]+", text.text or "")
            for word in (text.text or "").split("·")
            for first, _run, last in (word.partition("–"),)
            for number in range(int(first), int(last or first) + 1)
        }
        assert written == numbers


def test_the_views_of_a_sheet_are_in_third_angle_projection_and_aligned() -> None:
    """The side at the right of the front, the plan above the side: pistons stand in line."""
    svg = drawing(crankstar.load("v8-cross-plane"), Picture(view="sheet", arrows=()))
    groups = {g.get("data-view"): g for g in read(svg).iter(f"{SPACE}g") if g.get("data-view")}
    at = {
        name: {
            part.get("data-part"): corners(next(iter(part.iter(f"{SPACE}path"))).get("d") or "")
            for part in group.iter(f"{SPACE}g")
            if part.get("data-part")
        }
        for name, group in groups.items()
    }
    for part in at["front"]:
        front, side, plan = (at[name][part] for name in ("front", "side", "plan"))
        assert side[:, 0].min() > front[:, 0].max()
        assert plan[:, 1].max() < side[:, 1].min()
        assert np.ptp(plan[:, 0]) == pytest.approx(np.ptp(side[:, 0]), abs=0.2)
        assert plan[:, 0].mean() == pytest.approx(side[:, 0].mean(), abs=0.2)


@pytest.mark.parametrize("view", ["front", "side", "plan", "isometric"])
def test_no_view_is_a_mirror_image(view: str) -> None:
    look = look_of(view, pi / 4)  # pyright: ignore[reportArgumentType]
    assert np.linalg.det(np.array(look)) == pytest.approx(1)


def test_a_picture_without_a_heading_has_neither_name_nor_angle() -> None:
    svg = drawing(crankstar.load("single"), Picture(heading=False, arrows=()))
    assert [text.text for text in read(svg).iter(f"{SPACE}text")] == ["1"]


@pytest.mark.parametrize("name", ["v8-cross-plane", "i4", "triumph-675", "kr250-racer"])
def test_arrows_are_the_sums_of_the_analysis_in_shares_of_their_greatest(name: str) -> None:
    engine = crankstar.load(name)
    theta = np.linspace(0, 2 * pi, 90)
    load = load_of(engine, scene(engine), theta)
    sums = remains.summed(crankstar.balance(engine, speed=engine.speed))
    for kind, _value, unit in load.values:
        arrow = next(arrow for arrow in load.arrows if arrow.kind == kind)
        exact = spectra.value(getattr(sums, kind), theta)
        at = np.abs(exact).argmax()
        factor = arrow.vector[at] / exact[at]
        assert factor.imag == pytest.approx(0, abs=1e-3 * abs(factor))
        assert np.abs(arrow.vector - factor * exact).max() < 2e-2 * np.abs(arrow.vector).max()
        assert np.abs(arrow.vector).max() <= 1 + 1e-3
        assert unit
    pair = [arrow.vector for arrow in load.arrows if arrow.kind == "couple"]
    if pair:
        assert pair[0] == pytest.approx(-pair[1])


def test_only_arrows_and_orders_that_are_asked_for_are_drawn() -> None:
    engine = crankstar.load("i4")
    assert 'class="force"' in drawing(engine)
    assert 'class="force"' not in drawing(engine, Picture(orders=(1.0,)))
    assert 'class="force"' not in drawing(engine, Picture(arrows=("couple",)))


def test_a_nearer_body_is_painted_over_a_farther_one_whatever_their_middles() -> None:
    """A long thin box whose middle is behind that of a cube stands before it all the same."""
    box = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0.0, 1)])
    long = np.array([(x, y, z) for x in (0, 1) for y in (-9.0, 1) for z in (1.1, 1.2)])
    look = look_of("isometric", pi / 4)
    normals = np.array([(0, 0, 1), look.right, look.up], float)
    for first in (True, False):
        order = painted_order(
            np.vstack([box, long] if first else [long, box]),
            np.array([0, 8]),
            normals,
            look.back,
            np.array([0, 1]),
            np.zeros(2),
        )
        assert order == ([0, 1] if first else [1, 0])


@pytest.mark.release
@pytest.mark.parametrize("name", ["i4", "merlin", "square-four", "napier-deltic", "gm-3800"])
def test_a_film_ends_one_step_before_it_begins(name: str) -> None:
    engine = crankstar.load(name)
    pace = Pace(1.0, 12.0)
    angles = pace.angles(engine)
    step = angles[1]
    whole = 2 * pi * turns_of(engine)
    assert np.diff([*angles, whole]) == pytest.approx(step)
    assert sum(pace.times(engine)) == 1000 * turns_of(engine)
    how = Picture(letters=False)
    first, after = drawings(engine, [0.0, whole], how)
    shown = [np.asarray(picture, float) for picture in rasters((first, after))]
    assert np.abs(shown[0] - shown[1]).mean() < 0.02


@pytest.mark.many(first=1)
@pytest.mark.parametrize("kind", ["gif", "webp", "png"])
def test_a_film_has_every_picture_and_goes_on_for_ever(kind: str) -> None:
    from PIL import Image, ImageSequence

    engine = crankstar.load("single")
    content = film(engine, kind, picture=Picture(width=160, height=120), pace=Pace(0.6, 10.0))
    with Image.open(io.BytesIO(content)) as made:
        assert getattr(made, "n_frames", 1) == 6
        assert made.size == (160, 120)
        assert made.info["loop"] == 0
        frames, times = set(), []
        for frame in ImageSequence.Iterator(made):
            frames.add(frame.convert("RGB").tobytes())
            times.append(frame.info["duration"])
    assert sum(times) == 600
    assert len(frames) == 6


@pytest.mark.release
def test_an_mp4_has_every_picture_at_its_rate() -> None:
    import imageio_ffmpeg

    engine = crankstar.load("single")
    content = film(engine, "mp4", picture=Picture(width=161, height=121), pace=Pace(1.0, 10.0))
    assert content[4:8] == b"ftyp"
    assert imageio_ffmpeg.get_ffmpeg_version()


def test_a_raster_is_as_large_as_it_was_asked_for() -> None:
    shown = next(rasters([drawing(crankstar.load("single"), Picture(width=300, height=200))]))
    assert shown.size == (300, 200)
    assert shown.getpixel((1, 198)) == (255, 255, 255)
    dark = next(rasters([drawing(crankstar.load("single"), Picture(theme="dark"))]))
    assert dark.getpixel((1, 1)) == (0x14, 0x18, 0x1D)


HELD = """
import threading
from pathlib import Path
from crankstar.pictures import films

told = films._told

def held(*arguments):
    for each in told(*arguments):
        yield each
        if [*Path().glob("drafts/*/film.mp4")]:
            Path("../held").touch()
            threading.Event().wait()

films._told = held
from crankstar.__main__ import main
main()
"""
"""A film of which no more is drawn once its file has been begun."""


@pytest.mark.release
@pytest.mark.parametrize(("sent", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, -15)])
def test_an_interrupted_film_leaves_no_word_and_no_file(
    tmp_path: Path, sent: int, code: int
) -> None:
    folder = tmp_path / "folder"
    (folder / "drafts").mkdir(parents=True)
    words = "animate", "i4", "-o", "x.mp4", "--seconds", "20"
    process = subprocess.Popen(
        [sys.executable, "-c", HELD, *words],
        cwd=folder,
        env={**os.environ, "TMPDIR": str(folder / "drafts")},
        start_new_session=True,
        stderr=subprocess.PIPE,
    )
    try:
        awaited((tmp_path / "held").exists)
        os.killpg(process.pid, sent)
        assert process.communicate(timeout=PATIENCE)[1] == b""
        assert process.returncode == code
    finally:
        process.kill()
    assert [path.name for path in folder.rglob("*")] == ["drafts"]
