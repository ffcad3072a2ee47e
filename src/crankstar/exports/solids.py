"""The moving parts of an engine at a crank angle as solids: glTF (.glb) and STL; needs trimesh.

The frame is that of glTF: x to the right, y up, z to the front of the engine, metres (crank radii
where the file has no sizes: `assumed` lists it). Every shaft, rod and piston is a node with its
name; a rod's node is its big end, a piston's its pin, y along the rod or the cylinder. Sizes that
the file does not give are those of the page, listed in the asset of a glTF file (`extras.assumed`).
STL has no units and no names: it is in millimetres, as CAD programs expect, and refused where no
length is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi
from typing import Any, NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError, _
from crankstar.language.numbers import number
from crankstar.page.records import Scene, ShaftShown
from crankstar.page.scene import scene

FACETS = 64
"""Flat sides of a round part."""
EYE, SMALL_EYE = 1.45, 0.2
"""Outer radius of a rod's big end in pin radii, of its small end in bores."""
MILLIMETRES = 1000.0
Frame = np.ndarray


class ExportError(MessageError):
    """A file that would need what the engine file does not give."""


class Solid(NamedTuple):
    """A named group of closed meshes, and the frame (4 x 4) in which they stand."""

    name: str
    frame: Frame
    meshes: tuple[Any, ...]


def solids(engine: Engine, *, theta: float = 0.0) -> list[Solid]:
    """The moving parts at the crank angle `theta` (radians): shafts, then rods and pistons.

    Raises ImportError without trimesh.
    """
    drawn = scene(engine)
    out = [
        Solid(shaft.name, _frame(shaft.up, shaft.right, 0.0, _turn(engine, shaft, theta)), meshes)
        for shaft in drawn.shafts
        for meshes in [tuple(_shaft(shaft))]
    ]
    return [*out, *_moving(engine, drawn, theta)]


def assumed(engine: Engine) -> tuple[str, ...]:
    """What the solids are drawn with that the file does not give, a sentence each.

    >>> from crankstar.files.catalog import load
    >>> assumed(load("i4"))[0]
    'The file gives no stroke: lengths are in crank radii, of any size in millimetres.'
    """
    unit = _("The file gives no stroke: lengths are in crank radii, of any size in millimetres.")
    drawn = scene(engine)
    return (*((unit,) if "radius" in engine.relative else ()), *drawn.assumed, *_shapes(drawn))


def _shapes(drawn: Scene) -> Iterator[str]:
    """A sentence on the sizes that no file gives: those of the first crankshaft."""
    cranks = [shaft for shaft in drawn.shafts if shaft.throws]
    webs = [web.z_to - web.z_from for shaft in cranks for web in shaft.webs]
    if not webs:
        return
    first = cranks[0]
    yield _(
        "Shapes are for looking at: journals of {journal}, pins of {pin} across, webs {web} thick "
        "at least, rods, pistons and weights have usual proportions to the bore or the throw.",
        journal=_length(2 * first.journal_radius, drawn.length_unit),
        pin=_length(2 * first.throws[0].pin_radius, drawn.length_unit),
        web=_length(min(webs), drawn.length_unit),
    )


def _length(value: float, unit: str) -> str:
    """A length of the scene for a reader, in mm where it is in metres.

    >>> _length(0.0523, "m"), _length(0.5, "crank radii")
    ('52.3 mm', '0.5 crank radii')
    """
    return f"{number(MILLIMETRES * value)} mm" if unit == "m" else f"{number(value)} {_(unit)}"


def glb_bytes(engine: Engine, *, theta: float = 0.0) -> bytes:
    """The solids as a binary glTF file, a node for each part."""
    import trimesh

    whole = trimesh.Scene()
    for solid in solids(engine, theta=theta):
        mesh = trimesh.util.concatenate(solid.meshes)
        whole.add_geometry(mesh, node_name=solid.name, geom_name=solid.name, transform=solid.frame)
    lacking = list(assumed(engine))

    def with_record(tree: dict[str, Any]) -> None:
        tree["asset"]["extras"] = {"assumed": lacking}

    content: Any = whole.export(file_type="glb", tree_postprocessor=with_record)
    return bytes(content)


def stl_bytes(engine: Engine, *, theta: float = 0.0) -> bytes:
    """The solids as a binary STL file, in millimetres; raises ExportError where none is known."""
    import trimesh

    if "radius" in engine.relative:
        raise ExportError(
            "an STL file is in millimetres, and the engine file has no lengths: give "
            "cylinder.stroke (in the explicit form, every length with its unit), or write .glb, "
            "in crank radii"
        )

    placed = [
        mesh.copy().apply_transform(solid.frame)
        for solid in solids(engine, theta=theta)
        for mesh in solid.meshes
    ]
    content: Any = trimesh.util.concatenate(placed).apply_scale(MILLIMETRES).export(file_type="stl")
    return bytes(content)


def _turn(engine: Engine, shaft: ShaftShown, theta: float) -> float:
    return engine.sense * shaft.speed_ratio * theta


def _frame(up: float, right: float, z: float, bearing: float) -> Frame:
    """The frame at a place, its y axis at a bearing clockwise from up."""
    c, s = np.cos(bearing), np.sin(bearing)
    return np.array([[c, s, 0, right], [-s, c, 0, up], [0, 0, 1, z], [0, 0, 0, 1.0]])


def _shaft(shaft: ShaftShown) -> Iterator[Any]:
    """Journals, pins, webs and weights of a shaft, in its own frame."""
    radius = shaft.journal_radius
    spans = []
    for index, throw in enumerate(shaft.throws):
        pin = throw.radius * np.exp(1j * throw.angle)
        yield _round(throw.pin_radius, pin, throw.pin_from, throw.pin_to)
        webs = [web for web in shaft.webs if web.throw == index]
        for web in webs:
            outline = _hull(0j, radius * 1.1, pin, throw.pin_radius * 1.3)
            yield _prism(outline, web.z_from, web.z_to)
        ends = [z for web in webs for z in (web.z_from, web.z_to)]
        spans.append((min([throw.pin_from, *ends]), max([throw.pin_to, *ends])))
    z = shaft.z_from
    for rear, front in sorted(spans):
        if rear - z > 1e-9 * radius:
            yield _round(radius, 0j, z, rear)
        z = max(z, front)
    yield _round(radius, 0j, z, shaft.z_to)
    for weight in shaft.weights:
        half = weight.thickness / 2
        angles = weight.angle + weight.half_angle * np.linspace(-1, 1, FACETS // 2)
        yield _sector(
            weight.inner_radius, weight.outer_radius, angles, weight.z - half, weight.z + half
        )


def _moving(engine: Engine, drawn: Scene, theta: float) -> Iterator[Solid]:
    """Rod and piston of each cylinder."""
    links = motion.linkage(engine)
    roots = motion.roots(links.master)
    for row, (cylinder, shown) in enumerate(zip(engine.cylinders, drawn.cylinders, strict=True)):
        shaft = drawn.shafts[shown.shaft]
        root = engine.cylinders[roots[row]].bearing
        psi = shown.throw_angle + _turn(engine, shaft, theta) - root
        moved = motion.rods(links, np.array([psi]))
        home, frame = complex(shaft.up, shaft.right), np.exp(1j * root)
        big_end = home + frame * complex(moved.big_end.place[row, 0])
        piston = home + frame * complex(moved.piston.place[row, 0])
        bearing = float(np.angle(piston - big_end))
        pin = shaft.throws[shown.throw].pin_radius
        eye = min(EYE * pin, 0.45 * shown.rod_length) * (0.6 if shown.master >= 0 else 1.0)
        outline = _hull(0j, eye, complex(shown.rod_length, 0), min(SMALL_EYE * shown.bore, eye))
        half = shown.rod_width / 2
        yield Solid(
            f"rod {cylinder.number}",
            _frame(big_end.real, big_end.imag, shown.rod_z, bearing),
            (_prism(outline, -half, half),),
        )
        mesh = _round(shown.bore / 2, 0j, -shown.skirt, shown.pin_height)
        # the axis of the cylinder of revolution, z, becomes the y of the piston
        mesh.apply_transform(np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]]))
        place = _frame(piston.real, piston.imag, shown.z, cylinder.bearing)
        yield Solid(f"piston {cylinder.number}", place, (mesh,))


def _circle(centre: complex, radius: float, angles: np.ndarray) -> np.ndarray:
    return centre + radius * np.exp(1j * angles)


def _round(radius: float, centre: complex, rear: float, front: float) -> Any:
    """A cylinder along z between two places."""
    return _prism(_circle(centre, radius, np.arange(FACETS) * (2 * pi / FACETS)), rear, front)


def _hull(first: complex, one: float, second: complex, other: float) -> np.ndarray:
    """The outline of two circles and the belt round them, clockwise."""
    distance = abs(second - first)
    if distance <= abs(one - other):
        centre, radius = (first, one) if one >= other else (second, other)
        return _circle(centre, radius, np.arange(FACETS) * (2 * pi / FACETS))
    toward = float(np.angle(second - first))
    touch = float(np.arccos((one - other) / distance))
    far = _circle(second, other, toward + np.linspace(-touch, touch, FACETS // 2))
    near = _circle(first, one, toward + np.linspace(touch, 2 * pi - touch, FACETS // 2))
    return np.concatenate([far, near])


def _prism(outline: np.ndarray, rear: float, front: float) -> Any:
    """A convex outline up + i right, clockwise, from one place along z to another."""
    count = outline.size
    middle = outline.mean()
    ring = np.arange(count)
    after = (ring + 1) % count
    faces = _walls(ring, after, count)
    faces += [*zip([2 * count] * count, ring, after, strict=True)]
    faces += [*zip([2 * count + 1] * count, after + count, ring + count, strict=True)]
    return _mesh(
        [*outline, *outline, middle, middle],
        [rear] * count + [front] * count + [rear, front],
        faces,
    )


def _sector(inner: float, outer: float, angles: np.ndarray, rear: float, front: float) -> Any:
    """A sector of a ring."""
    out, back = _circle(0j, outer, angles), _circle(0j, inner, angles)[::-1]
    outline = np.concatenate([out, back])
    count, half = outline.size, angles.size
    ring = np.arange(count)
    faces = _walls(ring, (ring + 1) % count, count)
    for k in range(half - 1):
        a, b, c, d = k, k + 1, count - 2 - k, count - 1 - k
        faces += [(a, b, c), (a, c, d)]
        faces += [(a + count, c + count, b + count), (a + count, d + count, c + count)]
    return _mesh([*outline, *outline], [rear] * count + [front] * count, faces)


def _walls(ring: np.ndarray, after: np.ndarray, count: int) -> list[tuple[int, ...]]:
    first = [*zip(ring, ring + count, after, strict=True)]
    return [*first, *zip(after, ring + count, after + count, strict=True)]


def _mesh(points: Sequence[complex], z: Sequence[float], faces: Sequence[Any]) -> Any:
    """A closed mesh, its faces outward."""
    import trimesh

    vertices = np.column_stack([np.imag(points), np.real(points), z])
    mesh = trimesh.Trimesh(vertices, np.array(faces, int), process=False)
    if mesh.volume < 0:
        mesh.invert()
    return mesh
