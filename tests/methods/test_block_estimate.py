"""Moments of inertia of a block from its mass and outer size: bodies of points, files, faults."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from tests.files.test_mounts import THREE, mistakes
from tests.strategies import number
from tests.texts import SHORT, spoilt

import crankstar
from crankstar.dynamics.whirl import body
from crankstar.engine.block import inertia_in_box
from crankstar.files import engine_of
from crankstar.files.box import ranges
from crankstar.files.estimate import estimated

BOX: dict[str, Any] = {"mass": "150 kg", "length": "600 mm", "width": "520 mm", "height": "640 mm"}
SIDES = (0.64, 0.52, 0.6)
COUNT = 80


def about(points: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Moments of inertia of points (up, right, z) about their three axes."""
    squares = weights @ points**2
    return squares.sum() - squares


def grid(count: int) -> np.ndarray:
    """Places in the middle of cells of the unit cube about nought."""
    line = (np.arange(count) + 0.5) / count - 0.5
    return np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)


def test_a_box_an_ellipsoid_and_walls_are_those_of_points() -> None:
    """A second road: masses on a grid; for walls the difference of two boxes."""
    sides = np.array(SIDES)
    own = inertia_in_box(150.0, sides=SIDES)
    cells = grid(COUNT) * sides
    full = np.full(len(cells), 150.0 / len(cells))
    assert about(cells, full) == pytest.approx(own.typical, rel=1e-3)
    inside = ((2 * cells / sides) ** 2).sum(axis=1) <= 1
    some = np.where(inside, 150.0 / inside.sum(), 0.0)
    assert about(cells, some) == pytest.approx(own.low, rel=5e-3)
    thin = 1e-5
    volumes = [float(np.prod(sides - t)) for t in (0.0, thin)]
    outer, inner = (
        np.array(inertia_in_box(v, sides=tuple(sides - t)).typical)
        for v, t in zip(volumes, (0.0, thin), strict=True)
    )
    walls = 150.0 * (outer - inner) / (volumes[0] - volumes[1])
    assert walls == pytest.approx(own.high, rel=1e-3)


@given(sides=number(0.1, 2.0).flatmap(lambda a: number(0.1, 2.0).map(lambda b: (a, b, 0.5))))
def test_the_estimate_lies_between_its_ends_and_is_a_body(sides: tuple[float, ...]) -> None:
    own = inertia_in_box(10.0, sides=sides)
    for low, typical, high in zip(own.low, own.typical, own.high, strict=True):
        assert low < typical < high
    for each in own:
        assert max(each) <= sum(each) - max(each) + 1e-12


def test_a_block_with_mass_and_size_is_a_box_and_says_so() -> None:
    found = body(engine_of(spoilt(SHORT, block=BOX, mounts=THREE)))
    assert found.inertia == pytest.approx(inertia_in_box(150.0, sides=SIDES).typical)
    [said] = found.assumed
    assert "a homogeneous box of the outer size" in said
    assert "0.6 to" in said
    given_ones = {"inertia_up": "9 kg*m^2", "inertia_right": "9 kg*m^2", "inertia_z": "5 kg*m^2"}
    measured = body(engine_of(spoilt(SHORT, block=BOX | given_ones)))
    assert measured.inertia == (9, 9, 5)
    assert not measured.assumed


def test_estimate_fills_the_inertia_of_a_block_with_its_range() -> None:
    made = estimated(spoilt(SHORT, block=BOX, mounts=THREE))
    filled = {each.path: each for each in made.filled}
    own = inertia_in_box(150.0, sides=SIDES)
    for place, axis in enumerate(("up", "right", "z")):
        value = filled[f"block.inertia_{axis}"]
        assert value.typical == pytest.approx(own.typical[place], rel=1e-3)
        assert value.low == pytest.approx(own.low[place])
        assert value.high == pytest.approx(own.high[place])
    engine = engine_of(made.tree)
    assert engine.provenance["block.inertia_z"].status == "estimated"
    assert "block.inertia_z" not in ranges(made.tree)  # forces do not depend on it
    plain = {"mass": "150 kg"}
    assert not [f for f in estimated(spoilt(SHORT, block=plain)).filled if "block" in f.path]


def test_one_side_alone_is_a_fault() -> None:
    found = mistakes(block={"mass": "150 kg", "length": "600 mm"})
    assert found == [("block.width", "block.size-missing"), ("block.height", "block.size-missing")]


@pytest.mark.release
def test_mounts_of_an_estimated_block_say_that_it_is(tmp_path: Path) -> None:
    made = estimated(spoilt(SHORT, block=BOX, mounts=THREE))
    place = tmp_path / "made.json"
    place.write_text(json.dumps(made.tree), encoding="utf-8")
    from crankstar.analyses.mounts.document import document as mounts_document
    from crankstar.analyses.mounts.question import Question

    engine = crankstar.load(str(place))
    document = mounts_document(engine, crankstar.mounts(engine).value, Question())
    assert "Estimated" in str(document)
    assert "block.inertia_z" in str(document)
