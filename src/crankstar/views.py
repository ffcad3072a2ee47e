"""Still views of an engine as drawings: from the front, from the side, from above, from its scene and without a browser.

Each view looks along one axis of the frame: `front` against z, `side` from the right, with the front of the engine at the
left, `plan` from above, with the front at the left and what is right below. All three have one scale, so that they can stand
beside each other as on a drawing. The crankshafts are red; text and lines take the colour of the page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from html import escape
from math import pi, sin, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from crankstar.charts.drawing import numbers_text
from crankstar.exhibit.records import CylinderShown, GearShown, Scene, ShaftShown, ThrowShown, WeightShown
from crankstar.phasor import Complex, Real

RED, GREEN = "#d1382a", "#009e73"
"""Crankshafts, as in the documents; balance shafts."""
WIDTH, HEIGHT = 650.0, 400.0
"""px that the front and the side view have beside each other, and that any of them may be high."""
MARGIN, GAP, LETTERS = 32.0, 20.0, 13
"""px round a view, between two, and the size of letters."""
ROD = (1.45, 0.75)
"""Half the width of a rod at its big and at its small end, in radii of its pin."""
RING: Complex = np.exp(2j * pi * np.arange(24) / 24)
"""The corners that stand for a circle."""
LEAST = 14.0
"""px of the diameter of a cylinder in which its number is written."""


class Placed(NamedTuple):
    """Where a cylinder's moving parts stand in the clock plane, `up + i right`: the big end of its rod, its piston pin."""

    big_end: complex
    piston: complex


class Look(NamedTuple):
    """A direction of sight: a point [up, right, z] as (to the right of the drawing, upward on it, towards the viewer)."""

    name: str
    turned: Callable[[Any, Any, Any], tuple[Any, Any, Any]]
    axes: tuple[tuple[str, float, float], ...]


FRONT = Look("from the front", lambda up, right, z: (right, up, z), (("up", 0, 1), ("right", 1, 0)))
SIDE = Look("from the right side, the front at the left", lambda up, right, z: (-z, up, right), (("up", 0, 1), ("z", -1, 0)))
PLAN = Look("from above, the front at the left", lambda up, right, z: (-z, -right, up), (("right", 0, -1), ("z", -1, 0)))


class Part(NamedTuple):
    """A drawn part: how near it is to the viewer, and its SVG."""

    near: float
    svg: str


def placed(scene: Scene) -> tuple[Placed, ...]:
    """Where each cylinder's rod and piston stand at theta = 0, in the order of the scene.

    A rod of length l on a pin p (in the frame of the cylinder's axis: along, across) reaches the axis at the offset e:
    piston = along + sqrt(l^2 - (e - across)^2).
    """
    out: dict[int, Placed] = {}

    def of(index: int) -> Placed:
        if index not in out:
            one = scene.cylinders[index]
            shaft = scene.shafts[one.shaft]
            centre, axis = complex(shaft.up, shaft.right), np.exp(1j * one.bearing)
            if one.master < 0:
                big_end = centre + one.crank_radius * np.exp(1j * one.throw_angle)
            else:
                master = of(one.master)
                along_rod = (master.piston - master.big_end) / abs(master.piston - master.big_end)
                big_end = master.big_end + one.knuckle_radius * np.exp(1j * one.knuckle_angle) * along_rod
            pin = (big_end - centre) / axis
            reach = pin.real + sqrt(one.rod_length**2 - (one.offset - pin.imag) ** 2)
            out[index] = Placed(complex(big_end), complex(centre + axis * complex(reach, one.offset)))
        return out[index]

    return tuple(of(index) for index in range(len(scene.cylinders)))


def views(scene: Scene, *, name: str) -> tuple[str, str, str]:
    """The engine from the front, from the side and from above at theta = 0, as SVGs; `name` for those who do not see them."""
    spans = [high - low for low, high in zip(scene.low, scene.high, strict=True)]
    tall = max(spans[0], spans[1])
    scale = min((WIDTH - GAP - 4 * MARGIN) / (spans[1] + spans[2]), (HEIGHT - 2 * MARGIN) / tall)
    moving = placed(scene)
    front, side, plan = (_view(scene, moving, look, scale, name) for look in (FRONT, SIDE, PLAN))
    return front, side, plan


def _view(scene: Scene, moving: Sequence[Placed], look: Look, scale: float, name: str) -> str:
    corners = [look.turned(*scene.low), look.turned(*scene.high)]
    (left, right), (bottom, top) = (sorted(corner[place] for corner in corners) for place in (0, 1))
    width, height = (right - left) * scale + 2 * MARGIN, (top - bottom) * scale + 2 * MARGIN
    pen = Pen(look, scale, MARGIN - left * scale, MARGIN + top * scale)
    parts = sorted(_parts(scene, moving, pen), key=lambda part: part.near)
    return (
        f'<svg role="img" xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.0f} {height:.0f}" font-family="sans-serif" font-size="{LETTERS}" stroke-linejoin="round">'
        f"<title>{escape(name)} {look.name}</title>{''.join(part.svg for part in parts)}"
        f"{''.join(_numbers(scene, pen))}{_axes(look, height)}</svg>"
    )


class Pen(NamedTuple):
    """Draws what stands in space on a flat drawing, in px."""

    look: Look
    scale: float
    x0: float
    y0: float

    def at(self, place: ArrayLike, *, z: ArrayLike) -> tuple[Real, Real, Real]:
        """Points of the clock plane at z: x, y, and how near."""
        spot: Complex = np.asarray(place, complex)
        across, upward, near = self.look.turned(np.real(spot), np.imag(spot), np.asarray(z, float))
        return self.x0 + across * self.scale, self.y0 - upward * self.scale, near

    def outline(self, rim: Complex, ends: tuple[float, float], style: str) -> Part:
        """What a solid covers that has this rim at both ends along z: its convex hull."""
        return self.hull(np.concatenate([rim, rim]), np.repeat(ends, rim.size), style)

    def hull(self, places: Complex, z: Real, style: str) -> Part:
        """What a convex solid with these corners covers."""
        x, y, near = self.at(places, z=z)
        shape = np.broadcast_shapes(x.shape, y.shape)
        hull = _hull(np.stack([np.broadcast_to(x, shape), np.broadcast_to(y, shape)], axis=-1))
        path = "L".join(f"{x:g} {y:g}" for x, y in hull)
        return Part(float(np.mean(near)), f'<path d="M{path}Z" {style}/>')

    def disc(self, centre: complex, ends: tuple[float, float], style: str, *, radius: float) -> Part:
        """A round body along z: a circle from the front, a rectangle from elsewhere."""
        if self.look is FRONT:
            x, y, near = self.at(centre, z=max(ends))
            return Part(float(near), f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" {style}/>')
        return self.outline(centre + radius * np.array([1, 1j, -1, -1j]), ends, style)

    def barrel(self, centre: complex, along: tuple[float, float], style: str, *, axis: complex, radius: float, z: float) -> Part:
        """A round body along an axis of the clock plane."""
        places = [centre + axis * (end + 1j * radius * np.imag(RING)) for end in along]
        return self.hull(np.concatenate(places), np.tile(z + radius * np.real(RING), 2), style)


def _style(colour: str, *, fill: float, line: float = 1.0, dash: str = "") -> str:
    body = f'fill="{colour}" fill-opacity="{fill:g}"' if fill else 'fill="none"'
    return f'{body} stroke="{colour}" stroke-width="{line:g}"' + (f' stroke-dasharray="{dash}"' if dash else "")


def _parts(scene: Scene, moving: Sequence[Placed], pen: Pen) -> Iterator[Part]:
    for shaft in scene.shafts:
        yield from _shaft(shaft, pen)
    for gear in scene.gears:
        yield _gear(scene, gear, pen)
    hidden = _hidden(scene) if pen.look is FRONT else set()
    for cylinder, place in zip(scene.cylinders, moving, strict=True):
        yield from _cylinder(scene, cylinder, place, pen, hidden=cylinder.number in hidden)


def _hidden(scene: Scene) -> set[int]:
    """The cylinders that stand behind another one, which are drawn in outline, so that the foremost can be made out."""
    foremost: dict[tuple[int, float, float], CylinderShown] = {}
    for one in scene.cylinders:
        bank = (one.shaft, round(one.bearing, 6), round(one.offset, 6))
        foremost[bank] = max(foremost.get(bank, one), one, key=lambda found: found.z)
    return {one.number for one in scene.cylinders} - {one.number for one in foremost.values()}


def _shaft(shaft: ShaftShown, pen: Pen) -> Iterator[Part]:
    """Journals, webs, pins and weights; a crankshaft is red."""
    axis = complex(shaft.up, shaft.right)
    colour = RED if shaft.kind == "crankshaft" else GREEN
    solid = _style(colour, fill=0.45, line=0.9)
    yield pen.disc(axis, (shaft.z_from, shaft.z_to), solid, radius=shaft.journal_radius)
    for web in shaft.webs:
        throw = shaft.throws[web.throw]
        yield pen.outline(_web(shaft, throw), (web.z_from, web.z_to), _style(colour, fill=0.28, line=0.9))
    for throw in shaft.throws:
        pin = axis + throw.radius * np.exp(1j * throw.angle)
        yield pen.disc(complex(pin), (throw.pin_from, throw.pin_to), _style(colour, fill=0.8, line=0.9), radius=throw.pin_radius)
    for weight in shaft.weights:
        yield _weight(axis, weight, pen, _style(colour, fill=0.28, line=0.9))


def _web(shaft: ShaftShown, throw: ThrowShown) -> Complex:
    """The rim of a plate round the journal and the pin."""
    axis = complex(shaft.up, shaft.right)
    pin = axis + throw.radius * np.exp(1j * throw.angle)
    return np.concatenate([axis + 1.25 * shaft.journal_radius * RING, pin + 1.3 * throw.pin_radius * RING])


def _weight(axis: complex, weight: WeightShown, pen: Pen, style: str) -> Part:
    """A sector of a disc."""
    turns = weight.angle + np.linspace(-weight.half_angle, weight.half_angle, 25)
    ends = (weight.z - weight.thickness / 2, weight.z + weight.thickness / 2)
    outer, inner = (axis + radius * np.exp(1j * turns) for radius in (weight.outer_radius, weight.inner_radius))
    rim = np.concatenate([outer, inner[::-1]])
    if pen.look is not FRONT:
        return pen.outline(rim, ends, style)
    across, down, _ = pen.at(rim, z=ends[1])
    path = "L".join(f"{x:.1f} {y:.1f}" for x, y in zip(across, down, strict=True))
    return Part(ends[1], f'<path d="M{path}Z" {style}/>')


def _gear(scene: Scene, gear: GearShown, pen: Pen) -> Part:
    shaft = scene.shafts[gear.shaft]
    ends = (gear.z - gear.thickness / 2, gear.z + gear.thickness / 2)
    dashed = _style("currentColor", fill=0, line=0.8, dash="3 2")
    return pen.disc(complex(shaft.up, shaft.right), ends, dashed, radius=gear.radius)


def _cylinder(scene: Scene, one: CylinderShown, place: Placed, pen: Pen, *, hidden: bool) -> Iterator[Part]:
    """The bore as an outline, the piston and the rod."""
    axis = complex(np.exp(1j * one.bearing))
    foot = _foot(scene, one)
    thin = _style("currentColor", fill=0, line=0.7)
    yield pen.barrel(foot, (one.bore_from, one.bore_to), thin, axis=axis, radius=one.bore / 2, z=one.z)
    high = ((place.piston - foot) / axis).real
    body = (high - one.skirt, high + one.pin_height)
    line = 0.4 if hidden else 0.9
    grey = _style("currentColor", fill=0 if hidden else 0.16, line=line)
    yield pen.barrel(foot, body, grey, axis=axis, radius=0.49 * one.bore, z=one.z)
    width = (one.rod_z - one.rod_width / 2, one.rod_z + one.rod_width / 2)
    yield pen.outline(_rod(scene, one, place), width, _style("currentColor", fill=0.03 if hidden else 0.3, line=line))


def _foot(scene: Scene, one: CylinderShown) -> complex:
    """Where the axis of a cylinder passes its shaft."""
    shaft = scene.shafts[one.shaft]
    return complex(shaft.up, shaft.right) + one.offset * 1j * complex(np.exp(1j * one.bearing))


def _rod(scene: Scene, one: CylinderShown, place: Placed) -> Complex:
    """The rim of a rod: round both its pins."""
    size = scene.shafts[one.shaft].throws[one.throw].pin_radius * (1.0 if one.master < 0 else 0.7)
    return np.concatenate([place.big_end + ROD[0] * size * RING, place.piston + ROD[1] * size * RING])


def _numbers(scene: Scene, pen: Pen) -> Iterator[str]:
    """The number of each cylinder beyond its head, of those that stand behind one another together; none over another."""
    groups: dict[tuple[float, float, float], list[int]] = {}
    for one in scene.cylinders:
        if pen.look is FRONT or one.bore * pen.scale >= LEAST:
            x, y, _ = pen.at(_label(scene, one, pen), z=one.z)
            aside = round(sin(one.bearing), 6) if pen.look is FRONT else 0.0
            groups.setdefault((round(float(x), 1), round(float(y), 1), aside), []).append(one.number)
    written: list[tuple[float, float, float]] = []
    for (x, y, aside), numbers in groups.items():
        told = numbers_text(numbers)
        wide = 0.6 * LETTERS * len(told)
        x += aside * (wide - LETTERS) / 2  # noqa: PLW2901 - long numbers of a bank that leans stand clear of it
        if all(abs(x - other) > (wide + width) / 2 or abs(y - above) > LETTERS for other, above, width in written):
            written.append((x, y, wide))
            yield f'<text x="{x:.1f}" y="{y + LETTERS * 0.35:.1f}" text-anchor="middle" fill="currentColor">{told}</text>'


def _label(scene: Scene, one: CylinderShown, pen: Pen) -> complex:
    """Where the number of a cylinder stands: beyond its head, or, where two pistons meet, beside the bore or on it."""
    axis = complex(np.exp(1j * one.bearing))
    if sum(other.chamber == one.chamber for other in scene.cylinders) < 2:
        return _foot(scene, one) + (one.bore_to + LETTERS / pen.scale) * axis
    middle = _foot(scene, one) + (0.6 * one.bore_from + 0.4 * one.bore_to) * axis
    if pen.look is not FRONT:
        return middle
    out = middle - complex(scene.low[0] + scene.high[0], scene.low[1] + scene.high[1]) / 2
    side = 1j * axis if (out / (1j * axis)).real >= 0 else -1j * axis
    return middle + (0.5 * one.bore + 1.8 * LETTERS / pen.scale) * side


def _axes(look: Look, height: float) -> str:
    """The axes of the frame in a lower corner."""
    long = 26.0
    flip = any(dx < 0 for _, dx, _ in look.axes)
    x, y = (14.0 + long if flip else 12.0), height - 12.0
    if any(dy < 0 for *_, dy in look.axes):
        y -= long
    drawn = ""
    for name, dx, dy in look.axes:
        end_x, end_y = x + dx * long, y - dy * long
        back_x, back_y = end_x - 4 * dx, end_y + 4 * dy
        tip = f"M{back_x - 3 * dy:g} {back_y - 3 * dx:g}L{end_x:g} {end_y:g}L{back_x + 3 * dy:g} {back_y + 3 * dx:g}"
        drawn += f'<path d="M{x:g} {y:g}L{end_x:g} {end_y:g}{tip}" fill="none" stroke="currentColor" stroke-width="1"/>'
        side = f'x="{end_x + 5:g}" y="{end_y + 9 * (dy <= 0) + 1:g}"' if dy else f'x="{end_x - 2 * (dx < 0):g}" y="{end_y - 5:g}"'
        drawn += f'<text {side} font-size="11" fill="currentColor">{name}</text>'
    return drawn


def _hull(points: Real) -> list[tuple[float, float]]:
    """The convex hull of points [point, xy] to a tenth of a px, by A. M. Andrew's monotone chain."""
    ordered = sorted({(x, y) for x, y in np.round(points, 1).tolist()})
    if len(ordered) < 3:
        return ordered

    def half(way: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        out: list[tuple[float, float]] = []
        for x, y in way:
            while len(out) > 1 and (out[-1][0] - out[-2][0]) * (y - out[-2][1]) <= (out[-1][1] - out[-2][1]) * (x - out[-2][0]):
                out.pop()
            out.append((x, y))
        return out[:-1]

    return half(ordered) + half(ordered[::-1])
