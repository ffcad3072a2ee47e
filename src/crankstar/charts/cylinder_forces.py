"""The forces of each cylinder at chosen crank angles: orders, rotating masses, and their sum."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import degrees, pi
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.drawing import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    SMALL,
    TEXT,
    VERMILION,
    WIDTH,
    ChartError,
    Panel,
    brief,
    checked_angle,
    checked_order,
    figure,
    layered,
    named,
)
from crankstar.charts.grammar import Chart, field, of_rows
from crankstar.charts.labels import Label
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, picture
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.balance import Balance, balance
from crankstar.spectra import Complex

NAMED = 3
"""Greatest number of cylinders with room for the word `cylinder`."""
COLOURS = (VERMILION, BLUE, PURPLE, ORANGE)
"""Of the first, second and further orders."""
LONGEST = 62.0
"""px: the longest arrow."""
STEP, GREATEST_STEP = 13.0, 32.0
"""px between the feet of the arrows of a cylinder."""
ROW, ROW_OBLIQUE = 6, 4
"""Places in a row of cylinders, where all are upright and where they are not."""


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
    wanted = [checked_order(order) for order in orders]
    if not wanted or not len(angles):
        raise ChartError(_("give at least one order and one crank angle"))
    result = balance(engine)
    theta = np.array([checked_angle(angle) for angle in angles])
    force = spectra.selected(result.force, sorted(set(wanted)))
    single = [
        spectra.Spectrum(
            force.orders[i : i + 1],
            force.forward[:, i : i + 1],
            force.backward[:, i : i + 1],
            force.sense,
        )
        for i in range(force.orders.size)
    ]
    values = np.stack([spectra.value(one, theta) for one in single])  # [order, part, angle]
    out = []
    shared = _shares(engine, result)
    for cylinder in engine.cylinders:
        own = [row for row, part in enumerate(result.parts) if part.cylinder == cylinder.number]
        rotating = sum(
            (values[:, row].sum(axis=0) * share for row, share in shared[cylinder.number]),
            np.zeros(theta.size, complex),
        )
        out.append(Forces(str(cylinder.number), values[:, own].sum(axis=1), rotating))
    with_cylinders = {cylinder.shaft for cylinder in engine.cylinders}
    for shaft in engine.shafts:
        rows = [
            row
            for row, part in enumerate(result.parts)
            if part.shaft == shaft.name and part.cylinder is None
        ]
        if shaft.name not in with_cylinders and rows:
            out.append(
                Forces(
                    shaft.name,
                    np.zeros((len(single), theta.size), complex),
                    values[:, rows].sum(axis=(0, 1)),
                )
            )
    return tuple(out)


def _shares(engine: Engine, result: Balance) -> dict[int, list[tuple[int, float]]]:
    """For each cylinder the rows of its rotating masses with its share of each."""
    out: dict[int, list[tuple[int, float]]] = {cylinder.number: [] for cylinder in engine.cylinders}
    rows = [row for row, part in enumerate(result.parts) if part.cylinder is None]
    places = [(s, t.z) for s in engine.shafts for t in s.throws] + [
        (s, w.z) for s in engine.shafts for w in s.weights
    ]
    for row, (shaft, z) in zip(rows, places, strict=True):
        own = [cylinder for cylinder in engine.cylinders if cylinder.shaft == shaft.name]
        if not own:
            continue
        gap = min(abs(engine.throw(cylinder).z - z) for cylinder in own)
        near = [
            cylinder
            for cylinder in own
            if abs(engine.throw(cylinder).z - z) <= gap * (1 + 1e-9) + 1e-12
        ]
        for cylinder in near:
            out[cylinder.number].append((row, 1 / len(near)))
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
    places = _places(engine, forces)
    greatest = (
        max(
            float(max(np.abs(one.net).max(), np.abs(one.rotating).max(), np.abs(one.orders).max()))
            for one in forces
        )
        or 1.0
    )
    frame = _frame(places, greatest)
    names = [_("order {order}", order=f"{order:g}") for order in sorted(set(orders))]
    panels = [[_panel(forces, places, i, frame, degrees(angle))] for i, angle in enumerate(angles)]
    key = [*zip(names, COLOURS, strict=False), (_rotating(engine), GREY), (_("net"), GREEN)]
    title = _("Forces of each cylinder, in m r ω²")
    return figure([[_key(key)], *panels], title=title, subtitle=[named(engine)])


def _rotating(engine: Engine) -> str:
    """The name of the grey arrows in this engine."""
    weights = any(shaft.weights for shaft in engine.shafts)
    masses = any(throw.rotating_mass for shaft in engine.shafts for throw in shaft.throws)
    if weights and masses:
        return _("rotating masses")
    return _("rotating mass") if masses else _("counterweight")


def _places(engine: Engine, forces: Sequence[Forces]) -> list[complex]:
    """The origins of the arrows of the cylinders, px: as the shafts are placed, or in rows."""
    shafts = [engine.shaft(c.shaft) for c in engine.cylinders]
    count = len(forces)
    side = [complex(shaft.up, shaft.right) for shaft in shafts]
    own = (
        len(set(side)) == len(side) == count
        and count > 1
        and len({place.real for place in side}) == 1
    )
    if own:
        rights = [place.imag for place in side]
        span = max(rights) - min(rights)
        gap = min(b - a for a, b in zip(sorted(rights), sorted(rights)[1:], strict=False))
        if gap / span * (WIDTH - 140) >= 50:
            return [1j * ((right - min(rights)) / span * (WIDTH - 140) + 70) for right in rights]
    row = ROW if all(abs(cylinder.bearing) < 1e-9 for cylinder in engine.cylinders) else ROW_OBLIQUE
    across = min(count, row)
    step = WIDTH / across
    return [complex(-(i // row) * 2.7 * LONGEST, (i % row + 0.5) * step) for i in range(count)]


def _frame(places: Sequence[complex], greatest: float) -> Frame:
    scale = LONGEST / greatest
    lowest = min(place.real for place in places)
    return Frame(0.0, WIDTH / scale, (lowest - LONGEST - 24) / scale, (LONGEST + 40) / scale, scale)


def _step(places: Sequence[complex], arrows: int) -> float:
    """Px between the arrows of a cylinder: room for their numbers where neighbours leave it."""
    rights = sorted({round(place.imag, 6) for place in places})
    room = min([b - a for a, b in pairwise(rights)], default=WIDTH)
    return min(GREATEST_STEP, max(STEP, room / (arrows + 1)))


def _panel(
    forces: Sequence[Forces], places: Sequence[complex], at: int, frame: Frame, angle: float
) -> Panel:
    arrows: list[Arrow] = []
    labels: list[Label] = []
    dots: list[Dot] = []
    notes: list[Label] = []
    for one, place in zip(forces, places, strict=True):
        own = [(row[at], COLOURS[i % len(COLOURS)], 2.0) for i, row in enumerate(one.orders)]
        own.insert(1, (one.rotating[at], GREY, 2.0))
        own.append((one.net[at], GREEN, 4.0))
        feet = (np.arange(len(own)) - (len(own) - 1) / 2) * _step(places, len(own))
        for (vector, colour, width), foot in zip(own, feet.tolist(), strict=True):
            base = (place + 1j * foot) / frame.scale
            dots.append(Dot(0j, base, 0.0, GREY, 10))
            size = abs(vector)
            if size * frame.scale < 1:
                continue
            arrows.append(Arrow(complex(vector), place=base, colour=colour, width=width))
            text = brief(size)
            labels.append(
                Label(
                    text,
                    base + complex(vector),
                    complex(vector) / size,
                    colour=colour,
                    size=SMALL,
                    gap=3,
                )
            )
        notes.append(
            Label(
                _("cylinder {number}", number=one.name)
                if one.name.isdigit() and len(forces) <= NAMED
                else one.name,
                (place - LONGEST - 14) / frame.scale,
                0j,
                colour=GREY,
                size=TEXT,
            )
        )
    plane = Plane(tuple(arrows), (), tuple(dots), tuple(labels), tuple(notes))
    together = sum(complex(one.net[at]) for one in forces)
    title = _(
        "crank at {angle}°, total {force}",
        angle=number(round(angle, 6)),
        force=components_text(together),
    )
    return picture(plane, frame, title=title)


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
        sideways = (
            _("{size} right", size=right) if vector.imag > 0 else _("{size} left", size=right)
        )
        shown.append(sideways)
    return ", ".join(shown) or "0"


ROUNDING = 1e-6
"""m r w^2: components below this are not written."""


def _key(entries: Sequence[tuple[str, str]]) -> Panel:
    """The names of the arrows in their colours."""
    widths = [7.0 * len(name) + 22 for name, _ in entries]
    starts = [sum(widths[:i]) for i in range(len(widths))]
    rows = [
        {"x": start, "text": name, "colour": colour}
        for start, (name, colour) in zip(starts, entries, strict=True)
    ]
    x = field("x:Q", scale={"domain": [0, WIDTH], "nice": False}, axis=None)
    colour = field("colour:N", scale=None)
    base = of_rows(rows)
    marks = base.mark("point", shape="square", filled=True, size=90, opacity=1).encode(
        x=x, color=colour
    )
    words = base.mark("text", align="left", dx=9, fontSize=TEXT, baseline="middle").encode(
        x=x, text=field("text:N"), color=colour
    )
    return layered([marks, words], width=WIDTH, height=14)
