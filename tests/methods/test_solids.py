"""Solids read back from glTF and STL stand where the parts are, closed, of the right volume."""

from __future__ import annotations

import io
import json
import re
from math import cos, pi, sin
from typing import Any

import numpy as np
import pytest
import trimesh
from tests.newton import placed

from crankstar import load
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.exports.solids import (
    FACETS,
    ExportError,
    Solid,
    assumed,
    glb_bytes,
    solids,
    stl_bytes,
)
from crankstar.page.scene import scene
from crankstar.remedy.counterweights import with_counterweights

NAMES = ("i4", "v8-cross-plane", "radial-9", "kr250-racer", "jumo-205", "man-s50mc-c")
TURNING = ("v8-cross-plane", "radial-9", "man-s50mc-c", "napier-deltic")
THETA = 0.7


@pytest.mark.parametrize("name", NAMES)
def test_a_gltf_file_has_every_part_at_its_place(name: str) -> None:
    engine = load(name)
    read: Any = trimesh.load(io.BytesIO(glb_bytes(engine, theta=THETA)), file_type="glb")
    count = len(engine.shafts) + 2 * len(engine.cylinders)
    assert len(read.graph.nodes_geometry) == count
    for cylinder, shown in zip(engine.cylinders, scene(engine).cylinders, strict=True):
        shaft = engine.shaft(cylinder.shaft)
        pin, piston, _ = placed(engine, cylinder, np.array([THETA]))
        home = np.array([shaft.right, shaft.up])
        for part, place, z in (("rod", pin, shown.rod_z), ("piston", piston, shown.z)):
            frame, _geometry = read.graph[f"{part} {cylinder.number}"]
            expected = [*(place[0] + home), z]
            assert frame[:3, 3] == pytest.approx(expected, abs=1e-6 * shown.rod_length)


@pytest.mark.parametrize("name", NAMES)
def test_every_solid_is_closed_and_pistons_have_their_volume(name: str) -> None:
    engine = load(name)
    drawn = {f"piston {shown.number}": shown for shown in scene(engine).cylinders}
    for solid in solids(engine, theta=THETA):
        for mesh in solid.meshes:
            assert mesh.is_watertight
            assert mesh.is_winding_consistent
            assert mesh.volume > 0
        if solid.name in drawn:
            shown = drawn[solid.name]
            area = FACETS / 2 * sin(2 * pi / FACETS) * (shown.bore / 2) ** 2
            expected = area * (shown.pin_height + shown.skirt)
            assert solid.meshes[0].volume == pytest.approx(expected, rel=1e-9)


def in_place(solid: Solid, mesh: Any) -> Any:
    """A mesh of a solid where it stands: right, up, front."""
    return mesh.copy().apply_transform(solid.frame)


def bearing_of(engine: Engine, shaft: Shaft, angle: float) -> complex:
    """The direction up + i right at THETA of what stands at an angle of a shaft."""
    return np.exp(1j * (angle + engine.sense * float(shaft.speed_ratio) * THETA))


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", TURNING)
def test_pins_and_weights_turn_with_their_shafts(name: str) -> None:
    engine = with_counterweights(load(name), factor=0.5)
    shown = {shaft.name: shaft for shaft in scene(engine).shafts}
    stand = {solid.name: solid for solid in solids(engine, theta=THETA)}
    for shaft in engine.shafts:
        home = complex(shaft.up, shaft.right)
        meshes = [in_place(stand[shaft.name], mesh) for mesh in stand[shaft.name].meshes]
        centres = [(complex(*mesh.center_mass[[1, 0]]), mesh.center_mass[2]) for mesh in meshes]
        for throw, drawn in zip(shaft.throws, shown[shaft.name].throws, strict=True):
            pin = home + throw.radius * bearing_of(engine, shaft, throw.angle)
            z = (drawn.pin_from + drawn.pin_to) / 2
            assert any(abs(c - pin) < 1e-6 and abs(at - z) < 1e-6 for c, at in centres)
        drawn_weights = shown[shaft.name].weights
        for weight, (centre, z) in zip(
            drawn_weights, centres[len(centres) - len(drawn_weights) :], strict=True
        ):
            direction = (centre - home) / abs(centre - home)
            assert direction == pytest.approx(bearing_of(engine, shaft, weight.angle), abs=1e-6)
            assert z == pytest.approx(weight.z, abs=1e-6)
        both = (drawn_weights, shaft.weights)
        sums = [sum(w.unbalance * np.exp(1j * w.angle) for w in weights) for weights in both]
        assert sums[0] == pytest.approx(sums[1], abs=1e-12)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", TURNING)
def test_a_rod_reaches_from_its_pin_to_its_piston_whose_crown_is_outward(name: str) -> None:
    engine = load(name)
    stand = {solid.name: solid for solid in solids(engine, theta=THETA)}
    for cylinder, shown in zip(engine.cylinders, scene(engine).cylinders, strict=True):
        rod, piston = stand[f"rod {cylinder.number}"], stand[f"piston {cylinder.number}"]
        pin, gudgeon = (np.array(solid.frame[:3, 3]) for solid in (rod, piston))
        along = (gudgeon - pin)[:2] / np.linalg.norm((gudgeon - pin)[:2])
        reach = in_place(rod, rod.meshes[0]).vertices[:, :2] @ along - pin[:2] @ along
        assert reach.min() < 0 < shown.rod_length < reach.max()
        assert reach.max() + reach.min() < shown.rod_length  # the big end is the larger eye
        width = in_place(rod, rod.meshes[0]).bounds[:, 2]
        assert width.mean() == pytest.approx(shown.rod_z)
        outward = np.array([sin(cylinder.bearing), cos(cylinder.bearing), 0])
        heights = (in_place(piston, piston.meshes[0]).vertices - gudgeon) @ outward
        assert heights.max() == pytest.approx(shown.pin_height)
        assert heights.min() == pytest.approx(-shown.skirt)


def test_weights_have_the_unbalance_that_the_page_draws() -> None:
    engine = load("kr250-racer")
    shaft = scene(engine).shafts[0]
    weight = shaft.weights[-1]
    mesh = solids(engine)[0].meshes[-1]
    arm = 2 / 3 * sin(weight.half_angle) * weight.thickness
    moment = arm * (weight.outer_radius**3 - weight.inner_radius**3)
    centre = complex(mesh.center_mass[1], mesh.center_mass[0])
    assert mesh.volume * centre == pytest.approx(moment * np.exp(1j * weight.angle), rel=2e-3)


def test_stl_is_in_millimetres() -> None:
    engine = load("bmw-r1200")
    whole = trimesh.load(io.BytesIO(stl_bytes(engine)), file_type="stl")
    low, high = np.array(scene(engine).low), np.array(scene(engine).high)
    size = (high - low)[[1, 0, 2]] * 1000
    assert np.all(whole.extents <= size * 1.001)
    assert np.all(whole.extents > 0.6 * size)


def test_millimetres_of_an_engine_without_lengths_are_refused() -> None:
    with pytest.raises(ExportError, match=r"cylinder\.stroke"):
        stl_bytes(load("i4"))
    sized = load("i4", changes={"cylinder.stroke": "80 mm"})
    read: Any = trimesh.load(io.BytesIO(stl_bytes(sized)), file_type="stl")
    assert 80 < read.extents[1] < 600


def test_a_gltf_file_records_what_it_is_drawn_with() -> None:
    content = glb_bytes(load("i4"))
    length = int.from_bytes(content[12:16], "little")
    record = json.loads(content[20 : 20 + length])["asset"]["extras"]["assumed"]
    assert record == list(assumed(load("i4")))
    assert len(record) == 4  # stroke, bore, bore pitch, shapes


def test_the_shapes_that_no_file_gives_are_said_with_their_sizes() -> None:
    """The webs of the sentence are measured in the file: slices with more than the pins in them."""
    engine = load("audi-25-tfsi")
    (said,) = assumed(engine)
    sizes = [float(size) for size in re.findall(r"([0-9.]+) mm", said)]
    journal, pin, web = sizes
    shaft = next(each for each in scene(engine).shafts if each.throws)
    assert journal == pytest.approx(2000 * shaft.journal_radius, abs=0.01)
    solid = next(each for each in solids(engine) if each.name == shaft.name)
    thick = [mesh.extents[2] * 1000 for mesh in solid.meshes]
    across = [1000 * mesh.extents[0] for mesh in solid.meshes]
    assert any(size == pytest.approx(web, abs=0.01) for size in thick)
    assert any(size == pytest.approx(pin, rel=2e-3) for size in across)
    assert any(size == pytest.approx(journal, rel=2e-3) for size in across)
