"""A scene at a crank angle on a pane, as SVG: filled outlines with thin strokes, far ones first."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from crankstar.page.records import Scene
from crankstar.pictures.bodies import PISTON_PIN, Body, axes_of, bodies_of
from crankstar.pictures.looks import Look
from crankstar.pictures.motions import Motion
from crankstar.pictures.ordering import painted_order
from crankstar.pictures.outlines import strip
from crankstar.pictures.palettes import Palette
from crankstar.pictures.panes import Pane
from crankstar.spectra import Complex, Real

EDGE_ON = 1e-9
SIDE_ON = 0.02
"""Share of its greatest area below which a cap is seen edge-on and not drawn."""
GROOVES = (0.1, 0.2)
"""Bores below the crown at which a piston has grooves for its rings."""


class Painter:
    """What is seen of a scene from one side; it paints it at any of the angles of a motion."""

    def __init__(self, drawn: Scene, look: Look) -> None:
        self._scene, self._look = drawn, look
        self._bodies = [
            seen for body in bodies_of(drawn) for seen in _seen(drawn, body, look) if seen
        ]
        sizes = [body.points.size for body in self._bodies]
        self._starts: NDArray[np.int_] = np.cumsum([0, *sizes[:-1]])
        self._owner = np.repeat(np.arange(len(sizes)), sizes)
        self._points = np.concatenate([body.points for body in self._bodies])
        self._z = np.concatenate([body.z for body in self._bodies])
        self._ranks = np.array([_rank(drawn, body, look) for body in self._bodies])
        shafts = len(drawn.shafts)
        self._families = np.array(
            [body.row if body.carrier == "shaft" else shafts + body.row for body in self._bodies]
        )
        ways = [way for axis in axes_of(drawn.cylinders) for way in (axis, 1j * axis)]
        flat = [(way.imag, way.real, 0.0) for way in (1 + 0j, 1j, *ways)]
        self._normals = np.array([(0, 0, 1), look.right, look.up, *flat], float)

    def painted(self, pane: Pane, moving: Motion, at: int, palette: Palette) -> Iterator[str]:
        """The parts at one of the angles as SVG."""
        origin, way, height = self._stands(moving, at)
        place = origin[self._owner] + way[self._owner] * self._points
        points = _points(place, height[self._owner] + self._z)
        flat = _flat(pane, points)
        nearness = points @ np.array(self._look.back)
        order = painted_order(
            points, self._starts, self._normals, self._look.back, self._families, self._ranks
        )
        ends = [*self._starts[1:].tolist(), flat.size]
        for index in order:
            body, part = self._bodies[index], slice(self._starts[index], ends[index])
            svg = _body(body, flat[part], nearness[part], palette)
            if body.rim is not None:
                svg = self._wheel(body, origin[index], way[index], pane, palette)
            elif body.carrier == "piston":
                svg += self._grooves(body, origin[index], way[index], pane, palette)
                number = self._scene.cylinders[body.row].number
                svg = f'<g data-part="piston {number}">{svg}</g>'
            yield svg

    def _stands(self, moving: Motion, at: int) -> tuple[Complex, Complex, Real]:
        """Of every body its origin, the direction of its bearing 0, and its place along z."""
        origin = np.zeros(len(self._bodies), complex)
        way, height = np.ones_like(origin), np.zeros(origin.size)
        for row, body in enumerate(self._bodies):
            if body.carrier == "shaft":
                shaft = self._scene.shafts[body.row]
                origin[row] = complex(shaft.up, shaft.right)
                way[row] = np.exp(1j * (body.bearing + moving.shaft[body.row, at]))
                continue
            c = self._scene.cylinders[body.row]
            height[row] = c.z
            way[row] = np.exp(1j * c.bearing)
            if body.carrier == "piston":
                origin[row] = moving.piston[body.row, at]
            elif body.carrier == "rod":
                origin[row], way[row] = moving.big_end[body.row, at], moving.rod[body.row, at]
                height[row] = c.rod_z
            else:
                shaft = self._scene.shafts[c.shaft]
                origin[row] = complex(shaft.up, shaft.right) + way[row] * 1j * c.offset
        return origin, way, height

    def _grooves(
        self, body: Body, origin: complex, way: complex, pane: Pane, palette: Palette
    ) -> str:
        """The grooves of the rings, where they are seen."""
        c = self._scene.cylinders[body.row]
        back = np.array(self._look.back)
        turn = np.linspace(-np.pi / 2, np.pi / 2, 13)
        # from the silhouette through the side towards the eye: aside of the axis, and along z
        aside = complex(1j * way)
        lean = back @ np.array([aside.imag, aside.real, 0.0])
        middle = np.arctan2(back[2], lean)
        if np.hypot(back[2], lean) < SIDE_ON:
            return ""
        radius = 0.49 * c.bore
        paths = []
        for depth in GROOVES:
            height = c.pin_height - depth * min(c.bore, 2 * c.pin_height)
            place = origin + way * (height + 1j * radius * np.cos(middle + turn))
            points = _points(place, c.z + radius * np.sin(middle + turn))
            paths.append(_path(_flat(pane, points), closed=False))
        line = f'fill="none" stroke="{palette.edge}" stroke-opacity=".55"'
        return f'<path d="{"".join(paths)}" {line}/>'

    def _wheel(
        self, body: Body, origin: complex, way: complex, pane: Pane, palette: Palette
    ) -> str:
        """A gear: its far cap, the sides of its teeth, its near cap."""
        rim = origin + way * np.asarray(body.rim)
        ends = sorted({*body.z.tolist()}, key=lambda z: z * self._look.back[2])
        far, near = (_flat(pane, _points(rim, np.full(rim.size, z))) for z in (ends[0], ends[-1]))
        side, cap = palette.parts[body.fill]
        walls = np.stack([np.roll(far, 1), far, near, np.roll(near, 1)], axis=1)
        quads = "".join(map(_path, walls)) if abs(self._look.back[2]) < 1 else ""
        out = f'<path d="{quads}" fill="{side}" stroke="{side}"/>'
        return f'{out}<path d="{_path(near)}" fill="{cap}"/>'


def _seen(drawn: Scene, body: Body, look: Look) -> Iterator[Body]:
    """A body as it is seen; where one looks into a piston, its rod comes out of the skirt."""
    if body.carrier != "rod" or _leaning(drawn, body, look) >= -EDGE_ON:
        yield body
        return
    c = drawn.cylinders[body.row]
    reach = c.rod_length - 0.9 * c.skirt
    half = body.points.size // 2
    if body.rank == 1:
        wide, narrow = abs(body.points[0].imag), abs(body.points[2].imag)
        narrow = wide + (narrow - wide) * reach / c.rod_length
        yield body._replace(points=np.tile(strip(low=0, high=reach, wide=wide, narrow=narrow), 2))
    elif float(np.real(body.points[:half]).mean()) < reach - PISTON_PIN * c.bore:
        yield body


def _leaning(drawn: Scene, body: Body, look: Look) -> float:
    """How much the crown of a cylinder's piston faces the eye, from -1 to 1."""
    bearing = drawn.cylinders[body.row].bearing
    return float(np.dot((np.sin(bearing), np.cos(bearing), 0), look.back))


def _rank(drawn: Scene, body: Body, look: Look) -> float:
    """The rank of a body; the rod is before a piston that is seen from its side or from below."""
    if body.carrier == "piston" and _leaning(drawn, body, look) <= EDGE_ON:
        return 0.5
    return body.rank


def _body(body: Body, flat: Complex, nearness: Real, palette: Palette) -> str:
    """The outline of a body, and over it the cap that faces the eye."""
    half = flat.size // 2
    caps = flat[:half], flat[half:]
    way = caps[1].mean() - caps[0].mean()
    outline = _hull(caps[0], way)
    nearer = int(nearness[half:].mean() > nearness[:half].mean())
    near = caps[nearer]
    seen = abs(_area(near)) > SIDE_ON * abs(_area(outline)) and abs(way) > EDGE_ON
    if body.fill == "glass":
        glass = f'fill="{palette.glass}" stroke="{palette.glass}" stroke-opacity=".6"'
        out = f'<path d="{_path(outline)}" {glass} fill-opacity=".1"/>'
        rim = f'<path d="{_path(near)}" {glass} fill-opacity=".08"/>'
        return out + rim if seen else out
    side, cap = palette.parts[body.fill]
    if body.carrier == "piston" and not nearer:
        cap = palette.inside
    if not seen and abs(way) <= EDGE_ON:
        side = cap
    out = f'<path d="{_path(outline)}" fill="{side}"/>'
    return f'{out}<path d="{_path(near)}" fill="{cap}"/>' if seen else out


def _hull(cap: Complex, way: complex) -> Complex:
    """The outline of a convex cap and of the same moved by `way`."""
    if abs(way) < EDGE_ON:
        return cap
    aside = (cap * np.conj(way)).imag
    first, last = int(aside.argmax()), int(aside.argmin())
    ring = np.arange(cap.size)
    one = cap[(first + ring[: (last - first) % cap.size + 1]) % cap.size]
    other = cap[(last + ring[: (first - last) % cap.size + 1]) % cap.size]
    ahead = [float((side * np.conj(way)).real.mean()) for side in (one, other)]
    return np.concatenate([one + way * (ahead[0] > ahead[1]), other + way * (ahead[0] <= ahead[1])])


def _area(outline: Complex) -> float:
    """Twice the area of a polygon."""
    return float(np.imag(np.conj(outline) * np.roll(outline, -1)).sum())


def _points(place: Complex, z: Real) -> Real:
    """Points (x, y, z) of places `up + i right` at z."""
    return np.column_stack([np.imag(place), np.real(place), z])


def _flat(pane: Pane, points: Real) -> Complex:
    """Points on the picture, px to the right `+ i` down."""
    across, down = pane.at(points)
    return across + 1j * down


def _path(flat: Complex, *, closed: bool = True) -> str:
    """A line through points, to a tenth of a px."""
    spots = zip(np.real(flat).round(1).tolist(), np.imag(flat).round(1).tolist(), strict=True)
    return "M" + "L".join([f"{x:g} {y:g}" for x, y in spots]) + "Z" * closed
