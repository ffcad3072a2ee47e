"""The page at an angle against momentum: numbers, dots, the motion of the free block."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page
from tests.newton import Road, road
from tests.report.reading import plain
from tests.web.engine_page import handle, opened, written_of

from crankstar.engine.engine import Engine
from crankstar.engine.records import Block
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, scales
from crankstar.page import exhibit

Build = Callable[..., Path]
WEIGHTY = Block(
    mass=30.0, up=0.7, right=-0.9, z=0.6, inertia_up=200.0, inertia_right=90.0, inertia_z=140.0
)
"""Heavier on one side than on the other, and not round."""


def walked(engine: Engine) -> tuple[Road, np.ndarray]:
    """The bodies, and [force up, right, couple up, right, roll] over theta in the page's units."""
    found = road(engine, reference=balance(engine).reference, speed=1.0)
    force, moment, torque = (
        np.sum([push[index] for push in found.pushes], axis=0).astype(float) for index in range(3)
    )
    scale, _ = scales(engine, engine.speed)
    roll = -moment[:, 2] - engine.sense * torque
    told = np.stack([force[:, 1], force[:, 0], -moment[:, 0], moment[:, 1], roll])
    told -= told.mean(axis=1, keepdims=True)
    return found, told * np.array(
        [[scale.force], [scale.force], [scale.couple], [scale.couple], [scale.moment]]
    )


def between(samples: np.ndarray, grid: np.ndarray, theta: np.ndarray | float) -> np.ndarray:
    """Periodic samples between the steps of their grid, by their spectrum."""
    period = grid[1] * len(grid)
    k = np.fft.fftfreq(len(grid), 1 / len(grid)) * 2 * np.pi / period
    waves = np.exp(1j * np.multiply.outer(np.asarray(theta), k))
    return np.real(waves @ np.fft.fft(samples)) / len(grid)


def number(text: str) -> float:
    return float(plain(text).replace("\u2007", "").lstrip("+"))


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "name",
    [
        "jumo-205",
        *(
            pytest.param(name, marks=pytest.mark.release)
            for name in ("kr250-racer", "pratt-whitney-wasp", "vw-vr6")
        ),
    ],
)
def test_the_numbers_at_an_angle_are_the_rates_of_change_of_momentum(
    name: str, built_page: Build, page: Page
) -> None:
    engine = load(name)
    found, told = walked(engine)
    most = np.abs(told).max(axis=1)
    for degrees in (20.0, 110.0, 331.0):
        page.goto(
            "about:blank"
        )  # else only the address changes, and numbers are read before they follow
        opened(page, built_page(name), f"a={degrees}")
        said = [number(text) for text in page.locator("section.now output").all_inner_texts()]
        theta = math.radians(degrees)
        expected = [float(between(row, found.theta.astype(float), theta)) for row in told]
        for value, wanted, greatest in zip(said, expected, most, strict=True):
            assert abs(value - wanted) < 1e-3 * greatest + 1e-5, (degrees, said, expected)


@pytest.mark.release
@pytest.mark.parametrize(
    "rotation", ["counter-clockwise", pytest.param("clockwise", marks=pytest.mark.release)]
)
def test_a_free_block_moves_against_its_moving_parts(
    rotation: str, tmp_path: Path, page: Page
) -> None:
    """The centre of mass and the angular momentum about the transverse axes are constant.

    The crank keeps turning.
    """
    engine = load("v8-cross-plane").model_copy(
        update={"block": WEIGHTY, "rotation": rotation, "firing_order": ()}
    )
    shown = exhibit(engine, relatives=False)
    up, right, z = shown.whirl.centre
    along = z / 0.6
    found, told = walked(engine)
    theta, places = (
        found.theta.astype(float),
        [body.centre.astype(float) + np.array(body.axis) for body in found.bodies],
    )
    moved = [
        body.mass * (place - place.mean(axis=0))
        for body, place in zip(found.bodies, places, strict=True)
    ]
    shift = -np.sum(moved, axis=0) / WEIGHTY.mass
    arms = [body.z * along - z for body in found.bodies]
    # x to the right is turned about the vertical, y up about the axis to the right
    tilt = -np.sum([m * arm for m, arm in zip(moved, arms, strict=True)], axis=0) / np.array(
        [200.0, 90.0]
    )
    opened(page, written_of(tmp_path, engine), "a=0&whirl=1")
    paths = handle(page, "read().paths")
    shaft = shown.scene.shafts[0]
    for name, end in (("front", shaft.z_to), ("rear", shaft.z_from)):
        steps = np.arange(len(paths[name])) * (2 * np.pi / 120)
        at = shift + tilt * (end - z)
        expected = [between(at[:, axis], theta, steps) for axis in (1, 0)]
        drawn = np.array(paths[name]).T
        # the roll, which is small here, moves the axis about the centre of mass beside it
        rolled = np.abs(told[4]).max() / WEIGHTY.inertia_z * math.hypot(up, right)
        assert np.abs(drawn - expected).max() < rolled + 1e-3 * np.abs(at).max()
        assert rolled < 0.02 * np.abs(at).max()
