"""Solids read back from glTF and STL stand where the parts are, closed, of the right volume."""

from __future__ import annotations

import io
from math import pi, sin
from typing import Any

import numpy as np
import pytest
import trimesh
from tests.newton import placed

from crankstar import load
from crankstar.exports.solids import FACETS, glb_bytes, solids, stl_bytes
from crankstar.page.scene import scene

NAMES = ("i4", "v8-cross-plane", "radial-9", "kr250-racer", "jumo-205", "audi-25-tfsi")
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
