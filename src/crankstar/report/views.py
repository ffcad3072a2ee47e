"""Views of an engine from the front, the right side and above, as drawings to one scale.

The crankshafts are red; text and lines take the colour of the page.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from math import sin
from typing import NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import numbers_text
from crankstar.page.records import (
    CylinderShown,
    GearShown,
    Scene,
    ShaftShown,
    ThrowShown,
    WeightShown,
)
from crankstar.report.projections import (
    FRONT,
    PLAN,
    RING,
    SIDE,
    Look,
    Part,
    Pen,
    axes,
    style,
    third_angle,
)
from crankstar.spectra import Complex

RED, GREEN = "#d1382a", "#009e73"
"""Crankshafts, as in the documents; balance shafts."""
WIDTH, HEIGHT, SMALL_HEIGHT = 660.0, 400.0, 260.0
"""px: greatest width and height of all views, and the height of two."""
MARGIN, GAP, LETTERS, AXES = 32.0, 20.0, 13, 30.0
"""px around a view, between two, the size of letters, the axes below a view."""
ROD = (1.45, 0.75)
"""Half the width of a rod at its big and at its small end, in radii of its pin."""
LEAST = 14.0
"""px: least bore of a numbered cylinder in the side views."""


class Placed(NamedTuple):
    """The big end and the piston pin of a cylinder in the clock plane, `up + i right`."""

    big_end: complex
    piston: complex


class Label(NamedTuple):
    """The numbers of cylinders, about a middle, and how wide they are, px."""

    x: float
    y: float
    wide: float
    text: str


def placed(engine: Engine) -> tuple[Placed, ...]:
    """Rods and pistons at theta = 0, by cylinder."""
    links = motion.linkage(engine)
    axes_of_roots = [engine.cylinders[root].bearing for root in motion.roots(links.master)]
    pairs = list(zip(engine.cylinders, axes_of_roots, strict=True))
    moved = motion.rods(links, [engine.throw(cylinder).angle - axis for cylinder, axis in pairs])
    out = []
    for index, (cylinder, axis) in enumerate(pairs):
        shaft, frame = engine.shaft(cylinder.shaft), np.exp(1j * axis)
        big_end, piston = (
            complex(shaft.up, shaft.right) + complex(part.place[index, index] * frame)
            for part in (moved.big_end, moved.piston)
        )
        out.append(Placed(big_end, piston))
    return tuple(out)


def orthographic(engine: Engine, scene: Scene) -> str:
    """The engine in third-angle projection at theta = 0 as an SVG, with the symbol of it.

    From the front; from the right side at its right; from above, above it: edges are aligned.
    """
    return _aligned(engine, scene, (FRONT, SIDE, PLAN), WIDTH, HEIGHT)


def small_views(engine: Engine, scene: Scene) -> str:
    """The engine from the front and from the right side, aligned, for a front page."""
    return _aligned(engine, scene, (FRONT, SIDE), WIDTH, SMALL_HEIGHT)


def _aligned(
    engine: Engine, scene: Scene, looks: Sequence[Look], width: float, height: float
) -> str:
    """Views in third-angle projection to one scale; the side view right of, the plan above."""
    up, right, along = (high - low for low, high in zip(scene.low, scene.high, strict=True))
    margins = 4 * MARGIN + GAP
    tall, below = (up + along, 2 * AXES) if PLAN in looks else (up, AXES)
    scale = min((width - margins) / (right + along), (height - margins - below) / tall)
    moving = placed(engine)
    across = right * scale + 2 * MARGIN
    above = along * scale + 2 * MARGIN + AXES + GAP if PLAN in looks else 0.0
    places = {FRONT: (0.0, above), SIDE: (across + GAP, above), PLAN: (0.0, 0.0)}
    drawn, ends = [], [0.0, 0.0]
    for look in looks:
        view, reach = _view(scene, moving, look, scale, engine.name, places[look])
        drawn.append(view)
        ends += reach
    size = (across + GAP + along * scale + 2 * MARGIN, above + up * scale + 2 * MARGIN + AXES)
    if PLAN in looks:
        drawn.append(third_angle(x=across + GAP + MARGIN, y=MARGIN))
    name = _("{engine} from the front and the right side", engine=engine.name)
    if PLAN in looks:
        name = _("{engine} from the front, the right side and above", engine=engine.name)
    left, wide = min(ends), max(*ends, size[0]) - min(ends)
    return (
        f'<svg role="img" xmlns="http://www.w3.org/2000/svg" width="{wide:.0f}" '
        f'height="{size[1]:.0f}" viewBox="{left:.0f} 0 {wide:.0f} {size[1]:.0f}" '
        f'font-family="sans-serif" font-size="{LETTERS}" stroke-linejoin="round">'
        f"<title>{escape(name)}</title>{''.join(drawn)}</svg>"
    )


def _view(
    scene: Scene,
    moving: Sequence[Placed],
    look: Look,
    scale: float,
    name: str,
    place: tuple[float, float],
) -> tuple[str, list[float]]:
    """A view as a group whose upper left corner is at `place`, and the ends of its labels, px."""
    corners = [look.turned(*scene.low), look.turned(*scene.high)]
    (left, _right), (bottom, top) = (sorted(corner[at] for corner in corners) for at in (0, 1))
    height = (top - bottom) * scale + 2 * MARGIN + AXES
    pen = Pen(look, scale, MARGIN - left * scale, MARGIN + top * scale)
    parts = sorted(_parts(scene, moving, pen), key=lambda part: part.near)
    title = escape(_(look.title, engine=name))
    labels = list(_numbers(scene, pen))
    texts = "".join(
        f'<text x="{label.x:.1f}" y="{label.y:.1f}" text-anchor="middle" fill="currentColor">'
        f"{label.text}</text>"
        for label in labels
    )
    ends = [place[0] + label.x + side * label.wide / 2 for label in labels for side in (-1, 1)]
    svg = (
        f'<g class="view" transform="translate({place[0]:.1f} {place[1]:.1f})">'
        f"<title>{title}</title>{''.join(part.svg for part in parts)}"
        f"{texts}{axes(look, height)}</g>"
    )
    return svg, ends


def _parts(scene: Scene, moving: Sequence[Placed], pen: Pen) -> Iterator[Part]:
    for shaft in scene.shafts:
        yield from _shaft(shaft, pen)
    for gear in scene.gears:
        yield _gear(scene, gear, pen)
    hidden = _hidden(scene) if pen.look is FRONT else set()
    for cylinder, place in zip(scene.cylinders, moving, strict=True):
        yield from _cylinder(scene, cylinder, place, pen, hidden=cylinder.number in hidden)


def _hidden(scene: Scene) -> set[int]:
    """The cylinders behind another one, which are drawn in outline."""
    foremost: dict[tuple[int, float, float], CylinderShown] = {}
    for one in scene.cylinders:
        bank = (one.shaft, round(one.bearing, 6), round(one.offset, 6))
        foremost[bank] = max(foremost.get(bank, one), one, key=lambda cylinder: cylinder.z)
    return {one.number for one in scene.cylinders} - {one.number for one in foremost.values()}


def _shaft(shaft: ShaftShown, pen: Pen) -> Iterator[Part]:
    """Journals, webs, pins and weights; a crankshaft is red."""
    axis = complex(shaft.up, shaft.right)
    colour = RED if shaft.kind == "crankshaft" else GREEN
    journal, plate, solid = (style(colour, fill=fill, line=0.9) for fill in (0.45, 0.28, 0.8))
    yield pen.disc(axis, (shaft.z_from, shaft.z_to), journal, radius=shaft.journal_radius)
    for web in shaft.webs:
        throw = shaft.throws[web.throw]
        yield pen.outline(_web(shaft, throw), (web.z_from, web.z_to), plate)
    for throw in shaft.throws:
        pin = axis + throw.radius * complex(np.exp(1j * throw.angle))
        yield pen.disc(pin, (throw.pin_from, throw.pin_to), solid, radius=throw.pin_radius)
    for weight in shaft.weights:
        yield _weight(axis, weight, pen, plate)


def _web(shaft: ShaftShown, throw: ThrowShown) -> Complex:
    """The rim of a plate round the journal and the pin."""
    axis = complex(shaft.up, shaft.right)
    pin = axis + throw.radius * np.exp(1j * throw.angle)
    return np.concatenate(
        [axis + 1.25 * shaft.journal_radius * RING, pin + 1.3 * throw.pin_radius * RING]
    )


def _weight(axis: complex, weight: WeightShown, pen: Pen, style: str) -> Part:
    """A sector of a disc."""
    turns = weight.angle + np.linspace(-weight.half_angle, weight.half_angle, 25)
    ends = (weight.z - weight.thickness / 2, weight.z + weight.thickness / 2)
    outer, inner = (
        axis + radius * np.exp(1j * turns) for radius in (weight.outer_radius, weight.inner_radius)
    )
    rim = np.concatenate([outer, inner[::-1]])
    if pen.look is not FRONT:
        return pen.outline(rim, ends, style)
    across, down, _ = pen.at(rim, z=ends[1])
    path = "L".join(f"{x:.1f} {y:.1f}" for x, y in zip(across, down, strict=True))
    return Part(ends[1], f'<path d="M{path}Z" {style}/>')


def _gear(scene: Scene, gear: GearShown, pen: Pen) -> Part:
    shaft = scene.shafts[gear.shaft]
    ends = (gear.z - gear.thickness / 2, gear.z + gear.thickness / 2)
    dashed = style("currentColor", fill=0, line=0.8, dash="3 2")
    return pen.disc(complex(shaft.up, shaft.right), ends, dashed, radius=gear.radius)


def _cylinder(
    scene: Scene, one: CylinderShown, place: Placed, pen: Pen, *, hidden: bool
) -> Iterator[Part]:
    """The bore as an outline, the piston and the rod."""
    axis = complex(np.exp(1j * one.bearing))
    foot = _foot(scene, one)
    thin = style("currentColor", fill=0, line=0.7)
    yield pen.barrel(
        foot, (one.bore_from, one.bore_to), thin, axis=axis, radius=one.bore / 2, z=one.z
    )
    high = ((place.piston - foot) / axis).real
    body = (high - one.skirt, high + one.pin_height)
    line = 0.4 if hidden else 0.9
    grey = style("currentColor", fill=0 if hidden else 0.16, line=line)
    yield pen.barrel(foot, body, grey, axis=axis, radius=0.49 * one.bore, z=one.z)
    width = (one.rod_z - one.rod_width / 2, one.rod_z + one.rod_width / 2)
    faint = style("currentColor", fill=0.03 if hidden else 0.3, line=line)
    yield pen.outline(_rod(scene, one, place), width, faint)


def _foot(scene: Scene, one: CylinderShown) -> complex:
    """The point of a cylinder axis next to its shaft."""
    shaft = scene.shafts[one.shaft]
    return complex(shaft.up, shaft.right) + one.offset * 1j * complex(np.exp(1j * one.bearing))


def _rod(scene: Scene, one: CylinderShown, place: Placed) -> Complex:
    """The rim of a rod: round both its pins."""
    size = scene.shafts[one.shaft].throws[one.throw].pin_radius * (1.0 if one.master < 0 else 0.7)
    return np.concatenate(
        [place.big_end + ROD[0] * size * RING, place.piston + ROD[1] * size * RING]
    )


def _numbers(scene: Scene, pen: Pen) -> Iterator[Label]:
    """The numbers of the cylinders beyond their heads, without overlaps."""
    groups: dict[tuple[float, float, float], list[int]] = {}
    for one in scene.cylinders:
        if pen.look is FRONT or one.bore * pen.scale >= LEAST:
            x, y, _ = pen.at(_label(scene, one, pen), z=one.z)
            aside = round(sin(one.bearing), 6) if pen.look is FRONT else 0.0
            groups.setdefault((round(float(x), 1), round(float(y), 1), aside), []).append(
                one.number
            )
    written: list[Label] = []
    for (x, y, aside), numbers in groups.items():
        text = numbers_text(numbers)
        wide = 0.6 * LETTERS * len(text)
        # long labels clear of an inclined bank
        label = Label(x + aside * (wide - LETTERS) / 2, y + LETTERS * 0.35, wide, text)
        if all(
            abs(label.x - other.x) > (wide + other.wide) / 2 or abs(label.y - other.y) > LETTERS
            for other in written
        ):
            written.append(label)
            yield label


def _label(scene: Scene, one: CylinderShown, pen: Pen) -> complex:
    """The place of the number of a cylinder: beyond its head, or beside an opposed-piston bore."""
    axis = complex(np.exp(1j * one.bearing))
    if sum(other.chamber == one.chamber for other in scene.cylinders) < 2:
        return _foot(scene, one) + (one.bore_to + LETTERS / pen.scale) * axis
    middle = _foot(scene, one) + (0.6 * one.bore_from + 0.4 * one.bore_to) * axis
    if pen.look is not FRONT:
        return middle
    out = middle - complex(scene.low[0] + scene.high[0], scene.low[1] + scene.high[1]) / 2
    side = 1j * axis if (out / (1j * axis)).real >= 0 else -1j * axis
    return middle + (0.5 * one.bore + 1.8 * LETTERS / pen.scale) * side
