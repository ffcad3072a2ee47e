"""The firing ring: the cylinders round a circle at the crank angles at which they fire."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from math import pi, radians

import numpy as np

from crankstar.analyses.strokes.charts.timing_diagram import NO_ORDER, cycle_of, spacing
from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import GREY, PALETTE, VERMILION, figure, heading
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label
from crankstar.charts.letters import TEXT, folded, text_width
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, Stroke, empty, picture, round_frame
from crankstar.charts.resting import of_firing
from crankstar.engine.engine import Engine
from crankstar.firing.strokes import (
    EVEN,
    ExhaustGroup,
    WorkingCycle,
    exhaust_groups,
    exhaust_intervals,
)
from crankstar.firing.succession import Follower, followers, in_succession, neighbours
from crankstar.language.messages import _
from crankstar.language.numbers import number, numbers_text

ASIDE = 0.07
"""How far outside the ring the dots of the first bank are, in radii of the ring."""
RADII = (0.93, 0.86, 0.8, 0.74, 0.68, 0.62, 0.56, 0.5, 0.44)
"""Possible radii of the dots of the other banks."""
CLEAR = 0.1
"""Clearance of the dots of a bank from the lines of another, and between banks."""
MARGIN = 58.0
"""Px about the ring for numbers."""
LINE = 18.0
"""Px of a line of the key."""
BETWEEN = 8.0
"""Px between neighbouring labels; without this room the crank angles are left out."""


def firing_ring(engine: Engine, *, theta: float = 0.0) -> Chart:
    """The cylinders at their firing angles round a circle, clockwise; one cycle is once round.

    Each bank (or manifold) has a colour and a radius, its lines show how evenly its exhausts follow
    each other, thin lines lead to the numbers. The ring is thick where neighbours fire in
    succession. The pointer is at the crank angle `theta` (radians). Raises ChartError.
    """
    cycle = cycle_of(engine)
    turns = round(engine.cycle_angle / 360)
    if cycle is None:
        frame = round_frame(1.0, width=panel_width(), margin=MARGIN)
        note = empty(frame, _(NO_ORDER))._replace(anchor=-0.2 + 0j)
        plane, words = Plane((_pointer(1.0, turns),), (_arc(0.0, 360.0),), notes=(note,)), []
    else:
        groups = _groups(engine)
        words = _key_texts(cycle, groups)
        below = LINE * (sum(map(len, words)) + 0.5) if words else 0.0
        frame = round_frame(1.0, width=panel_width(), margin=MARGIN, below=below)
        pairs = in_succession(cycle.firing, neighbours(engine))
        plane = _ring(cycle, groups, pairs, frame)
        words = [_evenness(cycle)]
        words += [_("thick: neighbours that fire in succession")] if pairs else []
    return figure(
        [[picture(plane, frame, theta=theta)]],
        title=_("Firing ring over {cycle} deg", cycle=f"{engine.cycle_angle:.0f}"),
        subtitle=[*heading(engine), *words],
        theta=theta,
        turns=turns,
        rests=of_firing(engine),
    )


def _ring(
    cycle: WorkingCycle, groups: Sequence[ExhaustGroup], pairs: Sequence[Follower], frame: Frame
) -> Plane:
    """The ring with a polygon, dots and leaders for each group; thick between `pairs`."""
    share = 360 / cycle.cycle_deg
    fires = {chamber.number: chamber.fires_deg * share for chamber in cycle.chambers}
    strokes = [_arc(0.0, 360.0)]
    strokes += [
        _arc(fires[step.first], fires[step.first] + step.interval_deg * share, width=6.0)
        for step in pairs
    ]
    strokes += [Stroke((0.9 * way, way)) for way in (1 + 0j, 1j, -1 + 0j, -1j)]
    rings = _rings(
        [
            [fires[step.first] for step in exhaust_intervals(cycle, group.chambers)]
            for group in groups
        ]
    )
    dots: list[Dot] = []
    for index, points in enumerate(rings):
        colour = _colour(index)
        dots += [Dot(point, colour=colour, size=110) for point in points]
        strokes += [
            Stroke((point, point / abs(point) * (1 + ASIDE)), colour=colour, width=0.7)
            for point in points
            if abs(point) < 1
        ]
        if len(points) > 1 and len(groups) <= len(PALETTE):
            strokes.append(Stroke((*points, points[0]), colour=colour, width=1.5))
    pointer = _pointer(min(abs(dot.at) for dot in dots), cycle.cycle_deg / 360)
    labels, key = _labels(cycle, groups, fires, frame), _key(cycle, groups, frame)
    return Plane((pointer,), tuple(strokes), tuple(dots), tuple(labels), tuple(key))


def _pointer(within: float, turns: float) -> Arrow:
    """The pointer at the crank angle, which ends short of the innermost dots."""
    return Arrow(complex(max(within - 0.15, 0.3)), rate=1 / turns, colour=VERMILION, width=2)


def _rings(bearings: Sequence[Sequence[float]]) -> list[list[complex]]:
    """The dots of each bank at these bearings (degrees), clear of the lines of the others."""
    ways = [[exp(1j * radians(bearing)) for bearing in own] for own in bearings]
    if len(ways) == 1 or len(ways) > len(PALETTE):
        aside = ASIDE * (len(ways) > 1)
        return [
            [(1 + aside * (-1) ** index) * way for way in own] for index, own in enumerate(ways)
        ]
    out: list[list[complex]] = [[(1 + ASIDE) * way for way in ways[0]]]

    def room(points: Sequence[complex]) -> float:
        return min(min(_room(points, other), _room(other, points)) for other in out)

    for own in ways[1:]:
        free = [
            radius for radius in RADII if all(abs(radius - abs(one[0])) >= CLEAR for one in out)
        ]
        tried = [[radius * way for way in own] for radius in free]
        clear = (points for points in tried if room(points) >= CLEAR)
        out.append(next(clear, None) or max(tried, key=room))
    return out


def _room(dots: Sequence[complex], corners: Sequence[complex]) -> float:
    """The least distance of dots from the lines round a polygon."""
    ends = np.array([*corners, corners[0]])
    along = ends[:-1, None] + (ends[1:] - ends[:-1])[:, None] * np.linspace(0, 1, 50)
    return float(np.abs(along.ravel()[:, None] - np.array(dots)).min())


def _groups(engine: Engine) -> tuple[ExhaustGroup, ...]:
    """Banks or manifolds; all cylinders as one where each has an exhaust of its own."""
    groups = exhaust_groups(engine)
    if all(len(group.chambers) == 1 for group in groups) and len(groups) > len(PALETTE):
        return (
            ExhaustGroup(
                _("all cylinders"), tuple(number for group in groups for number in group.chambers)
            ),
        )
    return groups


def _colour(index: int) -> str:
    return PALETTE[index % len(PALETTE)]


def _evenness(cycle: WorkingCycle) -> str:
    steps = followers(cycle.firing)
    if len(steps) > 1 and max(step.interval_deg for step in steps) > cycle.cycle_deg - EVEN:
        return _("all fire together, every {interval} deg", interval=number(cycle.cycle_deg))
    if cycle.firing.even:
        return _("even firing, {intervals}", intervals=spacing(steps))
    return _("odd firing, {intervals}", intervals=spacing(steps))


def _arc(start: float, end: float, *, width: float = 1.0) -> Stroke:
    """A part of the ring, from and to in degrees of bearing."""
    bearings = np.radians(np.linspace(start, end, max(2, round(abs(end - start) / 3) + 1)))
    return Stroke(tuple(complex(point) for point in np.exp(1j * bearings)), width=width)


def _labels(
    cycle: WorkingCycle, groups: Sequence[ExhaustGroup], fires: dict[int, float], frame: Frame
) -> list[Label]:
    """The cylinder numbers outside the ring, with crank angles where there is room.

    Cylinders that fire together share a label.
    """
    colours = {
        chamber: _colour(index) for index, group in enumerate(groups) for chamber in group.chambers
    }
    together: dict[float, list[int]] = {}
    for chamber in cycle.firing.order:
        together.setdefault(round(fires[chamber], 3), []).append(chamber)
    angles = [
        f"{number(cycle.chamber(chambers[0]).fires_deg, 720.0, digits=4)}°"
        for chambers in together.values()
    ]
    room = 2 * pi * (1 + ASIDE) * frame.scale / len(together)
    out, with_angles = [], max(text_width(angle) for angle in angles) + BETWEEN <= room
    for (bearing, chambers), angle in zip(together.items(), angles, strict=True):
        text = numbers_text(chambers) + (f"\n{angle}" if with_angles else "")
        way = exp(1j * radians(bearing))
        own = {colours[chamber] for chamber in chambers}
        colour = own.pop() if len(own) == 1 else GREY
        gap = 13 if with_angles else 9
        out.append(Label(text, (1 + ASIDE) * way, way, colour=colour, size=TEXT, gap=gap))
    return out


def _key_texts(cycle: WorkingCycle, groups: Sequence[ExhaustGroup]) -> list[list[str]]:
    """The name of each group and the intervals between its exhausts, in lines."""
    if len(groups) == 1:
        return []
    texts = []
    for group in groups:
        steps = exhaust_intervals(cycle, group.chambers)
        text = f"{group.name}: {spacing(steps)}" if len(steps) > 1 else group.name
        texts.append(folded(text, width=panel_width()))
    return texts


def _key(cycle: WorkingCycle, groups: Sequence[ExhaustGroup], frame: Frame) -> list[Label]:
    """The groups in their colours below the ring, with the intervals between their exhausts."""
    texts = _key_texts(cycle, groups)
    left = sum(map(len, texts))
    out = []
    for index, lines in enumerate(texts):
        for line in lines:
            left -= 1
            height = frame.bottom + LINE * (left + 0.5) / frame.scale
            out.append(Label(line, complex(height, 0.0), 0j, colour=_colour(index)))
    return out
