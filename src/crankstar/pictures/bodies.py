"""Scene -> the convex bodies that are drawn, each in the frame of what carries it.

A body is a prism between two equal caps: along z (shafts, rods) or along the axis of a cylinder
(pistons, bores). What passes through a web, a rod or a wheel is cut there, so that of two bodies
one is nearly always wholly before the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import atan2, hypot, pi
from typing import Literal, NamedTuple

import numpy as np

from crankstar.page.records import CylinderShown, GearShown, Scene, ShaftShown
from crankstar.pictures.looks import bore_end
from crankstar.pictures.outlines import band, circle, gear, sector, strip
from crankstar.spectra import Complex, Real

Carrier = Literal["shaft", "piston", "rod", "bore"]
PISTON_PIN = 0.125
"""Bores: radius of a piston pin."""
NEAR = 0.03
"""Share of the radii by which the distance of shafts of meshing gears may differ."""
Span = tuple[float, float]


class Body(NamedTuple):
    """A convex body: the points of one cap `up + i right` and along z, then those of the other.

    `row` is the place of its carrier in the scene, `bearing` that at which it sits on its shaft.
    Of bodies that pass through one another that of the lower `rank` is drawn first.
    """

    fill: str
    carrier: Carrier
    row: int
    points: Complex
    z: Real
    rank: int = 0
    bearing: float = 0.0
    rim: Complex | None = None
    """The outline of a cap that is not convex."""


def bodies_of(drawn: Scene) -> list[Body]:
    """Everything of a scene."""
    bearings = tooth_bearings(drawn)
    wheels = [
        _prism(
            circle(1.02 * wheel.radius, corners=40),
            _slab(wheel.z, wheel.thickness),
            ("gear", "shaft", wheel.shaft),
            bearing=bearings[index],
        )._replace(rim=gear(wheel.radius, wheel.teeth))
        for index, wheel in enumerate(drawn.gears)
    ]
    shafts = [body for index in range(len(drawn.shafts)) for body in _shaft(drawn, index)]
    moving = [body for index in range(len(drawn.cylinders)) for body in _cylinder(drawn, index)]
    return [*shafts, *wheels, *moving]


def _shaft(drawn: Scene, index: int) -> Iterator[Body]:
    """Journals, pins, webs and weights of a shaft."""
    shaft = drawn.shafts[index]
    own = (shaft.kind, "shaft", index)
    discs = [_slab(weight.z, weight.thickness) for weight in shaft.weights]
    discs += [_slab(wheel.z, wheel.thickness) for wheel in drawn.gears if wheel.shaft == index]
    cuts = [end for disc in discs for end in disc]
    for span in _cut(_journals(shaft), cuts):
        yield _prism(circle(shaft.journal_radius), span, own)
    for place, throw in enumerate(shaft.throws):
        rods = [
            _slab(c.rod_z, c.rod_width)
            for c in drawn.cylinders
            if (c.shaft, c.throw, c.master) == (index, place, -1)
        ]
        pin = circle(throw.pin_radius, centre=complex(throw.radius * np.exp(1j * throw.angle)))
        for span in _outside((throw.pin_from, throw.pin_to), rods):
            yield _prism(pin, span, own)
    for web in shaft.webs:
        pin = shaft.throws[web.throw]
        cheek = band(
            radius=1.28 * shaft.journal_radius,
            distance=pin.radius,
            bearing=pin.angle,
            other=1.26 * pin.pin_radius,
        )
        yield _prism(cheek, (web.z_from, web.z_to), own, rank=2)
    for weight in shaft.weights:
        rim = sector(outer=weight.outer_radius, bearing=weight.angle, half=weight.half_angle)
        yield _prism(rim, _slab(weight.z, weight.thickness), own)


def _cylinder(drawn: Scene, index: int) -> Iterator[Body]:
    """Bore, rod and piston; a rod with its eyes is several bodies of one carrier."""
    c = drawn.cylinders[index]
    yield _barrel(0.5 * c.bore, (c.bore_from, bore_end(drawn, c)), ("glass", "bore", index))
    pin = drawn.shafts[c.shaft].throws[c.throw].pin_radius
    eye = 0.8 * pin if c.rod == "slave" else 1.36 * pin
    small = min(1.5 * PISTON_PIN * c.bore, 1.2 * eye)
    half = c.rod_width / 2
    own = ("slave" if c.rod in ("slave", "blade") else "rod", "rod", index)
    shank = strip(low=0, high=c.rod_length, wide=0.6 * eye, narrow=0.7 * small)
    yield _prism(shank, (-half / 2, half / 2), own, rank=1)
    yield _prism(circle(small, centre=complex(c.rod_length)), (-half, half), own, rank=2)
    for outline in _knuckles(drawn, index):
        yield _prism(outline, (-half, half), own, rank=2)
    yield _prism(circle(eye), (-half, half), own, rank=2)
    yield _barrel(0.49 * c.bore, (-c.skirt, c.pin_height), ("piston", "piston", index), rank=3)


def _knuckles(drawn: Scene, index: int) -> list[Complex]:
    """What carries the knuckle pins of a master rod."""
    slaves = [c for c in drawn.cylinders if c.master == index]
    if len(slaves) > 3:
        return [circle(max(1.3 * c.knuckle_radius for c in slaves), corners=40)]
    return [
        band(
            radius=0.6 * c.knuckle_radius,
            distance=c.knuckle_radius,
            bearing=c.knuckle_angle,
            other=0.3 * c.knuckle_radius,
        )
        for c in slaves
    ]


def _journals(shaft: ShaftShown) -> list[Span]:
    """Where along z the shaft itself is: everywhere but between the outer faces of its webs."""
    close = 1e-6 * shaft.journal_radius
    taken: list[Span] = []
    for throw in shaft.throws:
        ends = [throw.pin_from, throw.pin_to]
        for web in shaft.webs:
            faces = (web.z_from, web.z_to)
            if any(abs(face - end) < close for face in faces for end in ends[:2]):
                ends += faces
        taken.append((min(ends), max(ends)))
    return _outside((shaft.z_from, shaft.z_to), taken)


def _outside(whole: Span, taken: Iterable[Span]) -> list[Span]:
    """What is left of a span outside of others."""
    left, start = [], whole[0]
    for low, high in sorted(taken):
        if low > start:
            left.append((start, min(low, whole[1])))
        start = max(start, high)
    if whole[1] > start:
        left.append((start, whole[1]))
    return [span for span in left if span[1] - span[0] > 1e-9 * abs(whole[1] - whole[0])]


def _cut(spans: Iterable[Span], places: Iterable[float]) -> Iterator[Span]:
    """The pieces of spans between these places."""
    cuts = sorted({*places})
    for low, high in spans:
        ends = [low, *(cut for cut in cuts if low < cut < high), high]
        yield from pairwise(ends)


def _slab(middle: float, thickness: float) -> Span:
    return middle - thickness / 2, middle + thickness / 2


def _prism(
    outline: Complex,
    span: Span,
    whose: tuple[str, Carrier, int],
    *,
    rank: int = 0,
    bearing: float = 0.0,
) -> Body:
    """A prism along z."""
    z = np.repeat(np.array(span, float), outline.size)
    return Body(*whose, points=np.tile(outline, 2), z=z, rank=rank, bearing=bearing)


def _barrel(radius: float, span: Span, whose: tuple[str, Carrier, int], *, rank: int = 0) -> Body:
    """A cylinder along the axis that its carrier has as its bearing 0."""
    ring = circle(radius)
    points = np.concatenate([height + 1j * np.real(ring) for height in span])
    return Body(*whose, points=points, z=np.tile(np.imag(ring), 2), rank=rank)


def tooth_bearings(drawn: Scene) -> list[float]:
    """The bearing of the first tooth of every gear at theta = 0, so that teeth stand in gaps.

    On the line from gear A to gear B a tooth of A stands `a` of a pitch clockwise of the line, so
    that a tooth of B has to stand `-(a + 1/2)` of its pitch from it.
    """
    bearings: dict[int, float] = {}
    for first in range(len(drawn.gears)):
        waiting = [] if first in bearings else [(first, 0.0)]
        while waiting:
            place, bearing = waiting.pop()
            bearings[place] = bearing
            own = drawn.gears[place]
            for following, other in enumerate(drawn.gears):
                line = None if following in bearings else _line(drawn, own, other)
                if line is not None:
                    share = (bearing - line) * own.teeth / (2 * pi)
                    pitch = 2 * pi / other.teeth
                    waiting.append((following, line + pi - pitch * (share + 0.5)))
    return [bearings[index] for index in range(len(drawn.gears))]


def _line(drawn: Scene, one: GearShown, other: GearShown) -> float | None:
    """The bearing from a gear to another that it meshes with, None if it does not."""
    if one.shaft == other.shaft or abs(one.z - other.z) > (one.thickness + other.thickness) / 2:
        return None
    a, b = drawn.shafts[one.shaft], drawn.shafts[other.shaft]
    both = one.radius + other.radius
    near = abs(hypot(b.up - a.up, b.right - a.right) - both) < NEAR * both
    return atan2(b.right - a.right, b.up - a.up) if near else None


def axes_of(cylinders: Sequence[CylinderShown]) -> list[complex]:
    """The directions of the cylinder axes, each once."""
    bearings = {round(c.bearing % pi, 9) for c in cylinders}
    return [complex(np.exp(1j * bearing)) for bearing in sorted(bearings)]
