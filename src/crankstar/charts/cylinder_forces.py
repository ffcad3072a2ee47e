"""The forces of each cylinder at chosen crank angles: orders, rotating masses, and their sum."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import cycle, pairwise
from math import degrees, pi
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import panel_width, relative_width
from crankstar.charts.drawing import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    VERMILION,
    ChartError,
    Panel,
    brief,
    checked_angle,
    checked_order,
    figure,
    heading,
    layered,
)
from crankstar.charts.estimates import estimate_lines
from crankstar.charts.grammar import COLOUR, Chart, field, of_rows, span
from crankstar.charts.labels import Label
from crankstar.charts.letters import SMALL, TEXT, text_width
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, picture
from crankstar.charts.resting import of_vectors
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.balance import Balance, balance
from crankstar.spectra import Complex, Real

NAMED = 3
"""Greatest number of cylinders with room for the word `cylinder`."""
COLOURS = (VERMILION, BLUE, PURPLE, ORANGE)
"""Of the first, second and further orders."""
LONGEST = 62.0
"""px: the longest arrow."""
STEP, GREATEST_STEP = 13.0, 32.0
"""px between the feet of the arrows of a cylinder."""
LONGEST_OBLIQUE = 44.0
"""px: the same where cylinders are not upright, so that it ends before their neighbours."""
PLACE, PLACE_OBLIQUE = 72.0, 82.0
"""px for a cylinder in a row, where all are upright and where they are not."""
MOST_IN_ROW = 9
"""Cylinders up to which a crank angle has one row; more have rows of equal length."""


class Forces(NamedTuple):
    """Forces of a cylinder: of its orders [order, angle] and its rotating masses [angle]."""

    name: str
    orders: Complex
    rotating: Complex

    @property
    def net(self) -> Complex:
        """The sum."""
        return self.orders.sum(axis=0) + self.rotating


def cylinder_forces(
    engine: Engine, *, angles: Sequence[float] = (0.0, pi / 2, pi), orders: Sequence[float] = (1, 2)
) -> tuple[Forces, ...]:
    """The forces of each cylinder on the block at crank angles (radians), in m r w^2.

    The rotating mass of a throw and the weights next to it are shared by its cylinders; a shaft
    without cylinders has an entry of its own. Of these orders only. Raises ChartError.
    """
    wanted = sorted({checked_order(order) for order in orders})
    if not wanted or not len(angles):
        raise ChartError(_("give at least one order and one crank angle"))
    result = balance(engine)
    theta = np.array([checked_angle(angle) for angle in angles])
    values = np.stack([spectra.value(spectra.selected(result.force, one), theta) for one in wanted])
    shares = _shares(engine, result)
    out = []
    for name, share in shares.items():
        own = [row for row, part in enumerate(result.parts) if str(part.cylinder) == name]
        rotating = share @ values.sum(axis=0)
        out.append(Forces(name, values[:, own].sum(axis=1), rotating))
    return tuple(out)


def _shares(engine: Engine, result: Balance) -> dict[str, Real]:
    """The share [part] of each cylinder, and of each shaft without one, in the rotating masses."""
    out = {str(cylinder.number): np.zeros(len(result.parts)) for cylinder in engine.cylinders}
    rows = [row for row, part in enumerate(result.parts) if part.cylinder is None]
    places = [throw.z for shaft in engine.shafts for throw in shaft.throws]
    places += [weight.z for shaft in engine.shafts for weight in shaft.weights]
    for row, z in zip(rows, places, strict=True):
        shaft = result.parts[row].shaft
        gaps = {
            str(cylinder.number): abs(engine.throw(cylinder).z - z)
            for cylinder in engine.cylinders
            if cylinder.shaft == shaft
        } or {shaft: 0.0}
        least = min(gaps.values()) * (1 + 1e-9) + 1e-12
        near = [name for name, gap in gaps.items() if gap <= least]
        for name in near:
            out.setdefault(name, np.zeros(len(result.parts)))[row] = 1 / len(near)
    return out


def force_arrows(
    engine: Engine, *, angles: Sequence[float] = (0.0, pi / 2, pi), orders: Sequence[float] = (1, 2)
) -> Chart:
    """The forces of each cylinder from the front at crank angles (radians), in m r w^2.

    First order red, rotating masses grey, second order blue, their sum green and thick; the numbers
    are the lengths. Shafts with one cylinder each are side by side as in the engine, other
    cylinders in rows.
    """
    forces = cylinder_forces(engine, angles=angles, orders=orders)
    name = _rotating(engine) if any(np.any(one.rotating) for one in forces) else ""
    names = [_("order {order}", order=f"{order:g}") for order in sorted(set(orders))]
    key = [*zip(names, cycle(COLOURS), strict=False), (name, GREY), (_("net"), GREEN)]
    places, longest, wide = _places(engine, len(forces))
    vectors = [np.array([*one.orders, one.rotating, one.net]) for one in forces]
    scale = longest / (max(float(np.abs(each).max()) for each in vectors) or 1.0)
    panels = []
    for at, angle in enumerate(angles):
        feet = [[*zip(each[:, at].tolist(), key, strict=True)] for each in vectors]
        down, up = _reach([each[:, at] for each in vectors], places, longest / scale)
        below = complex(down + 24 / scale)
        lowest = min(place.real for place in places) / scale - below.real
        frame = Frame(0.0, wide / scale, lowest - 10 / scale, up + 26 / scale, scale)
        plane = _plane(places, feet, frame)
        notes = [
            Label(_foot_text(one.name, len(forces)), place / scale - below, 0j)
            for one, place in zip(forces, places, strict=True)
        ]
        title = _(
            "crank at {angle}°, total {force}",
            angle=number(round(degrees(angle), 6)),
            force=components_text(sum(complex(one.net[at]) for one in forces)),
        )
        panels.append([picture(replace(plane, notes=tuple(notes)), frame, title=title)])
    title = _("Forces of each cylinder, in m r ω²")
    shown = [entry for entry in key if entry[0]]
    return figure(
        [[_key(shown)], *panels],
        title=title,
        subtitle=[*heading(engine), *estimate_lines([engine])],
        rests=of_vectors([engine], "force", speed=None, orders=orders),
    )


def _reach(
    vectors: Sequence[Complex], places: Sequence[complex], longest: float
) -> tuple[float, float]:
    """How far vectors reach below and above their feet; rows in one panel all have the longest."""
    if len({place.real for place in places}) > 1:
        return longest, longest
    ups = np.real(np.concatenate(vectors))
    return max(0.0, -float(ups.min())), max(0.0, float(ups.max()))


def _foot_text(name: str, count: int) -> str:
    """The number of a cylinder, spelt out where there are few; the name of a shaft."""
    return _("cylinder {number}", number=name) if name.isdigit() and count <= NAMED else name


def _rotating(engine: Engine) -> str:
    """The name of the grey arrows in this engine."""
    weights = any(shaft.weights for shaft in engine.shafts)
    masses = any(throw.turning_mass for shaft in engine.shafts for throw in shaft.throws)
    if weights and masses:
        return _("rotating masses")
    return _("rotating mass") if masses else _("counterweight")


def _places(engine: Engine, count: int) -> tuple[list[complex], float, float]:
    """The middle of the feet of each group, as the shafts are placed or in rows.

    With the longest arrow and the width of the panel, all in px.
    """
    rights = [engine.shaft(cylinder.shaft).right for cylinder in engine.cylinders]
    heights = {engine.shaft(cylinder.shaft).up for cylinder in engine.cylinders}
    left, room = min(rights), panel_width() - 140
    if len(set(rights)) == count > 1 and len(heights) == 1:
        span = max(rights) - left
        if min(b - a for a, b in pairwise(sorted(rights))) / span * room >= 50:
            places = [1j * ((right - left) / span * room + 70) for right in rights]
            return places, LONGEST, panel_width()
    upright = all(abs(cylinder.bearing) < 1e-9 for cylinder in engine.cylinders)
    place, longest = (PLACE, LONGEST) if upright else (PLACE_OBLIQUE, LONGEST_OBLIQUE)
    rows = -(-count // MOST_IN_ROW)
    row = -(-count // rows)
    wide = max(panel_width(), row * place * relative_width())
    step = wide / row
    places = [complex(-(i // row) * 2.7 * longest, (i % row + 0.5) * step) for i in range(count)]
    return places, longest, wide


def _plane(
    places: Sequence[complex],
    feet: Sequence[Sequence[tuple[complex, tuple[str, str]]]],
    frame: Frame,
) -> Plane:
    """The arrows of each place beside each other, with their lengths, where they have a name."""
    arrows: list[Arrow] = []
    labels: list[Label] = []
    dots: list[Dot] = []
    rights = sorted({round(place.imag, 6) for place in places})
    room = min([b - a for a, b in pairwise(rights)], default=frame.width)
    for place, each in zip(places, feet, strict=True):
        own = [(vector, colour) for vector, (name, colour) in each if name]
        # room for the lengths where neighbours leave it
        step = min(GREATEST_STEP, max(STEP, room / (len(own) + 1)))
        for at, (vector, colour) in enumerate(own):
            base = (place + 1j * (at - (len(own) - 1) / 2) * step) / frame.scale
            dots.append(Dot(0j, base, 0.0, GREY, 10))
            size = abs(vector)
            if size * frame.scale >= 1:
                width = 4.0 if colour == GREEN else 2.0
                arrows.append(Arrow(vector, place=base, colour=colour, width=width))
                end, way = base + vector, vector / size
                labels.append(Label(brief(size), end, way, colour=colour, size=SMALL, gap=3))
    return Plane(tuple(arrows), (), tuple(dots), tuple(labels))


def components_text(vector: complex) -> str:
    """A vector by its components.

    >>> components_text(0.25 - 2j), components_text(0j)
    ('0.25 up, 2 left', '0')
    """
    up, right = (brief(abs(size)) for size in (vector.real, vector.imag))
    shown = []
    if abs(vector.real) > ROUNDING:
        shown.append(_("{size} up", size=up) if vector.real > 0 else _("{size} down", size=up))
    if abs(vector.imag) > ROUNDING:
        sideways = _("{size} right", size=right)
        shown.append(sideways if vector.imag > 0 else _("{size} left", size=right))
    return ", ".join(shown) or "0"


ROUNDING = 1e-6
"""m r w^2: components below this are not written."""


SQUARE, APART, ROW = 9.0, 14.0, 14.0
"""px of the names of the arrows: before a name, between two of them, and a row."""


def _key(entries: Sequence[tuple[str, str]]) -> Panel:
    """The names of the arrows in their colours."""
    rows: list[dict[str, Any]] = []
    end, line = 0.0, 0
    for name, colour in entries:
        width = SQUARE + text_width(name)
        if end and end + width > panel_width():
            end, line = 0.0, line + 1
        rows.append({"x": end, "y": -(line + 0.5) * ROW, "text": name, "colour": colour})
        end += width + APART
    height = (line + 1) * ROW
    x = field("x:Q", scale=span(0, panel_width()), axis=None)
    y = field("y:Q", scale=span(-height, 0), axis=None)
    base = of_rows(rows)
    marks = base.mark("point", shape="square", filled=True, size=90, opacity=1)
    words = base.mark("text", align="left", dx=9, fontSize=TEXT, baseline="middle")
    channels = {"x": x, "y": y, "color": COLOUR}
    layers = [marks.encode(**channels), words.encode(**channels, text=field("text:N"))]
    return layered(layers, width=panel_width(), height=height)
