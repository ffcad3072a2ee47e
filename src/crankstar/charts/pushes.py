"""What pushes on each cylinder at chosen crank angles: first order, counterweight, second order, and all of them together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import degrees, pi
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from crankstar import phasor
from crankstar.balance import Balance, balance
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
    of_rows,
)
from crankstar.charts.labels import Label
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, picture
from crankstar.engine import Engine
from crankstar.phasor import Complex
from crankstar.wording import number

if TYPE_CHECKING:
    import altair

NET = "net"
NAMED = 3
"""So many cylinders have room for the word."""
COLOURS = (VERMILION, BLUE, PURPLE, ORANGE)
"""Of the first, second and further orders."""
LONGEST = 62.0
"""px: the longest arrow."""
STEP, GREATEST_STEP = 13.0, 32.0
"""px between the feet of the arrows of a cylinder."""
ROW, ROW_OBLIQUE = 6, 4
"""Places in a row of cylinders, where all are upright and where they are not."""


class Push(NamedTuple):
    """Vectors [angle] on one cylinder: a row for each order of its moving parts, the turning parts, and all of them."""

    name: str
    orders: Complex
    turning: Complex

    @property
    def net(self) -> Complex:
        """The sum."""
        return self.orders.sum(axis=0) + self.turning


def pushes(engine: Engine, *, angles: Sequence[float] = (0.0, pi / 2, pi), orders: Sequence[float] = (1, 2)) -> tuple[Push, ...]:
    """What each cylinder and what turns with it push on the block at crank angles (radians), in m r w^2.

    What a throw carries that turns, its own mass and the weights next to it, is shared by its cylinders; a shaft without
    cylinders has a push of its own. Only the given orders count. Raises ChartError.
    """
    wanted = [checked_order(order) for order in orders]
    if not wanted or not len(angles):
        raise ChartError("no order or no crank angle is given; name at least one of each")
    result = balance(engine)
    theta = np.array([checked_angle(angle) for angle in angles])
    force = phasor.selected(result.force, sorted(set(wanted)))
    single = [
        phasor.Spectrum(force.orders[i : i + 1], force.forward[:, i : i + 1], force.backward[:, i : i + 1], force.sense)
        for i in range(force.orders.size)
    ]
    values = np.stack([phasor.value(one, theta) for one in single])  # [order, part, angle]
    out = []
    shared = _shares(engine, result)
    for cylinder in engine.cylinders:
        own = [row for row, part in enumerate(result.parts) if part.cylinder == cylinder.number]
        turning = sum((values[:, row].sum(axis=0) * share for row, share in shared[cylinder.number]), np.zeros(theta.size, complex))
        out.append(Push(str(cylinder.number), values[:, own].sum(axis=1), turning))
    with_cylinders = {cylinder.shaft for cylinder in engine.cylinders}
    for shaft in engine.shafts:
        rows = [row for row, part in enumerate(result.parts) if part.shaft == shaft.name and part.cylinder is None]
        if shaft.name not in with_cylinders and rows:
            out.append(Push(shaft.name, np.zeros((len(single), theta.size), complex), values[:, rows].sum(axis=(0, 1))))
    return tuple(out)


def _shares(engine: Engine, result: Balance) -> dict[int, list[tuple[int, float]]]:
    """For each cylinder the rows of what turns with it, each with the share that is the cylinder's."""
    out: dict[int, list[tuple[int, float]]] = {cylinder.number: [] for cylinder in engine.cylinders}
    rows = [row for row, part in enumerate(result.parts) if part.cylinder is None]
    places = [(s, t.z) for s in engine.shafts for t in s.throws] + [(s, w.z) for s in engine.shafts for w in s.weights]
    for row, (shaft, z) in zip(rows, places, strict=True):
        own = [cylinder for cylinder in engine.cylinders if cylinder.shaft == shaft.name]
        if not own:
            continue
        gap = min(abs(engine.throw(cylinder).z - z) for cylinder in own)
        near = [cylinder for cylinder in own if abs(engine.throw(cylinder).z - z) <= gap * (1 + 1e-9) + 1e-12]
        for cylinder in near:
            out[cylinder.number].append((row, 1 / len(near)))
    return out


def force_arrows(
    engine: Engine, *, angles: Sequence[float] = (0.0, pi / 2, pi), orders: Sequence[float] = (1, 2)
) -> altair.VConcatChart:
    """The forces on each cylinder at crank angles (radians), a panel for each, seen from the front, in m r w^2.

    First order red, counterweight grey (all that turns), second order blue, what they make together green and thick; the
    numbers are the lengths. Shafts with one cylinder each stand side by side as in the engine, other cylinders in rows.
    """
    found = pushes(engine, angles=angles, orders=orders)
    places = _places(engine, found)
    greatest = max(float(max(np.abs(one.net).max(), np.abs(one.turning).max(), np.abs(one.orders).max())) for one in found) or 1.0
    frame = _frame(places, greatest)
    names = [f"order {order:g}" for order in sorted(set(orders))]
    panels = [[_panel(found, places, i, frame, degrees(angle))] for i, angle in enumerate(angles)]
    key = [*zip(names, COLOURS, strict=False), (_turning(engine), GREY), (NET, GREEN)]
    return figure([[_key(key)], *panels], title="Forces on each cylinder, in m r ω²", subtitle=[named(engine)])


def _turning(engine: Engine) -> str:
    """What the grey arrows are in this engine."""
    weights = any(shaft.weights for shaft in engine.shafts)
    masses = any(throw.rotating_mass for shaft in engine.shafts for throw in shaft.throws)
    return "turning masses" if weights and masses else "rotating mass" if masses else "counterweight"


def _places(engine: Engine, found: Sequence[Push]) -> list[complex]:
    """Where the cylinders' arrows start, px: as the shafts stand, or in rows."""
    shafts = [engine.shaft(c.shaft) for c in engine.cylinders]
    count = len(found)
    side = [complex(shaft.up, shaft.right) for shaft in shafts]
    own = len(set(side)) == len(side) == count and count > 1 and len({place.real for place in side}) == 1
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


def _panel(found: Sequence[Push], places: Sequence[complex], at: int, frame: Frame, angle: float) -> Panel:
    arrows: list[Arrow] = []
    labels: list[Label] = []
    dots: list[Dot] = []
    notes: list[Label] = []
    for one, place in zip(found, places, strict=True):
        own = [(row[at], COLOURS[i % len(COLOURS)], 2.0) for i, row in enumerate(one.orders)]
        own.insert(1, (one.turning[at], GREY, 2.0))
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
            labels.append(Label(text, base + complex(vector), complex(vector) / size, colour=colour, size=SMALL, gap=3))
        notes.append(
            Label(
                f"cylinder {one.name}" if one.name.isdigit() and len(found) <= NAMED else one.name,
                (place - LONGEST - 14) / frame.scale,
                0j,
                colour=GREY,
                size=TEXT,
            )
        )
    plane = Plane(tuple(arrows), (), tuple(dots), tuple(labels), tuple(notes))
    together = sum(complex(one.net[at]) for one in found)
    return picture(plane, frame, title=f"crank at {number(round(angle, 6))}°, in all {sides(together)}")


def sides(vector: complex) -> str:
    """A vector by its sides: 0.5 down and 1 left.

    >>> sides(0.25 - 2j), sides(0j)
    ('0.25 up and 2 left', '0')
    """
    parts = [(vector.real, "up", "down"), (vector.imag, "right", "left")]
    told = [f"{brief(abs(size))} {more if size > 0 else less}" for size, more, less in parts if abs(size) > 1e-6]
    return " and ".join(told) or "0"


def _key(entries: Sequence[tuple[str, str]]) -> Panel:
    """A row of words in the colours of the arrows."""
    import altair as alt

    widths = [7.0 * len(name) + 22 for name, _ in entries]
    starts = [sum(widths[:i]) for i in range(len(widths))]
    rows = [{"x": start, "text": name, "colour": colour} for start, (name, colour) in zip(starts, entries, strict=True)]
    x = alt.X("x:Q", scale=alt.Scale(domain=[0, WIDTH], nice=False), axis=None)
    colour = alt.Color("colour:N", scale=None)
    base = of_rows(rows)
    marks = base.mark_point(shape="square", filled=True, size=90, opacity=1).encode(x=x, color=colour)
    words = base.mark_text(align="left", dx=9, fontSize=TEXT, baseline="middle").encode(x=x, text=alt.Text("text:N"), color=colour)
    return layered([marks, words], width=WIDTH, height=14)
