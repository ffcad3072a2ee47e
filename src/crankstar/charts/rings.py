"""The firing ring: the cylinders round a circle at the crank angles at which they fire."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from math import pi, radians
from typing import TYPE_CHECKING

import numpy as np

from crankstar.charts.drawing import GREY, PALETTE, TEXT, VERMILION, WIDTH, checked_angle, figure, numbers_text, text_width
from crankstar.charts.labels import Label
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, Stroke, empty, picture, round_frame
from crankstar.charts.strokes import NO_ORDER, found_cycle, spacing
from crankstar.engine import Engine
from crankstar.strokes import EVEN, ExhaustGroup, WorkingCycle, exhaust_groups, exhaust_intervals
from crankstar.succession import followers, in_succession, neighbours
from crankstar.wording import number

if TYPE_CHECKING:
    import altair

ASIDE = 0.07
"""How far outside the ring the first bank stands, in its radius."""
RADII = (0.93, 0.86, 0.8, 0.74, 0.68, 0.62, 0.56, 0.5, 0.44)
"""Where the dots of the other banks may stand."""
CLEAR = 0.1
"""How far the dots of a bank keep from the lines of another, and banks from each other."""
MARGIN = 58.0
"""Px about the ring for numbers."""
LINE = 18.0
"""Px of a line of the key."""
BETWEEN = 8.0
"""Px between labels beside each other: where there is less, the crank angles are left out."""


def firing_ring(engine: Engine, *, theta: float = 0.0) -> altair.VConcatChart:
    """The cylinders at their firing angles round a circle, clockwise: once round is one cycle, 720 or 360 deg.

    The cylinders of a bank (or manifold) have a colour and a distance from the middle, and the lines between them show how evenly
    their exhausts follow each other; thin lines lead to the numbers of those within the ring. Where neighbours fire one after the
    other the ring is thick. The pointer stands at the crank angle `theta` (radians). Raises ChartError.
    """
    theta = checked_angle(theta)
    found = found_cycle(engine)
    turns = round(engine.cycle_angle / 360)
    title = f"Firing ring, {engine.cycle_angle:.0f} deg once round"
    if found is None:
        pointer = _pointer(1.0, turns)
        frame = round_frame(1.0, width=WIDTH, margin=MARGIN)
        plane = Plane((pointer,), (_arc(0.0, 360.0),), notes=(empty(frame, NO_ORDER)._replace(anchor=-0.2 + 0j),))
        return figure([[picture(plane, frame, theta=theta)]], title=title, subtitle=[engine.name], theta=theta, turns=turns)
    groups = _groups(engine)
    frame = round_frame(1.0, width=WIDTH, margin=MARGIN, below=LINE * (len(groups) + 0.5) if len(groups) > 1 else 0.0)
    pairs = in_succession(found.firing, neighbours(engine))
    share = 360 / found.cycle_deg
    fires = {one.number: one.fires_deg * share for one in found.chambers}
    thick = [_arc(fires[step.first], fires[step.first] + step.interval_deg * share, width=6.0) for step in pairs]
    rings = _rings([[fires[step.first] for step in exhaust_intervals(found, group.chambers)] for group in groups])
    strokes, dots = [_arc(0.0, 360.0), *thick, *_ticks()], []
    for place, points in enumerate(rings):
        colour = _colour(place)
        dots += [Dot(point, colour=colour, size=110) for point in points]
        leaders = [(point, point / abs(point) * (1 + ASIDE)) for point in points if abs(point) < 1]
        strokes += [Stroke(ends, colour=colour, width=0.7) for ends in leaders]
        if len(points) > 1 and len(groups) <= len(PALETTE):
            strokes.append(Stroke((*points, points[0]), colour=colour, width=1.5))
    pointer = _pointer(min(abs(point) for points in rings for point in points), turns)
    labels = tuple(_labels(found, groups, fires, frame))
    plane = Plane((pointer,), tuple(strokes), tuple(dots), labels, tuple(_key(found, groups, frame)))
    subtitle = [engine.name, _evenness(found)] + (["thick: neighbours that fire one after the other"] if pairs else [])
    return figure([[picture(plane, frame, theta=theta)]], title=title, subtitle=subtitle, theta=theta, turns=turns)


def _pointer(within: float, turns: int) -> Arrow:
    """The hand that is at the crank angle, and ends short of the innermost dots."""
    return Arrow(complex(max(within - 0.15, 0.3)), rate=1 / turns, colour=VERMILION, width=2)


def _rings(bearings: Sequence[Sequence[float]]) -> list[list[complex]]:
    """The dots of each bank, given their bearings in degrees, at a distance at which they stand off the lines of the others."""
    if len(bearings) == 1 or len(bearings) > len(PALETTE):
        radii = [1 + (ASIDE if place % 2 == 0 else -ASIDE) * (len(bearings) > 1) for place in range(len(bearings))]
        return [[radius * exp(1j * radians(one)) for one in own] for radius, own in zip(radii, bearings, strict=True)]
    out: list[list[complex]] = []
    for own in bearings:
        ways = [exp(1j * radians(one)) for one in own]
        free = [one for one in RADII if all(abs(one - abs(other[0])) >= CLEAR for other in out)] if out else [1 + ASIDE]
        tried = [[radius * way for way in ways] for radius in free]
        room = [min((min(_room(points, other), _room(other, points)) for other in out), default=CLEAR) for points in tried]
        out.append(next((points for points, gap in zip(tried, room, strict=True) if gap >= CLEAR), tried[int(np.argmax(room))]))
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
        return (ExhaustGroup("all cylinders", tuple(number for group in groups for number in group.chambers)),)
    return groups


def _colour(place: int) -> str:
    return PALETTE[place % len(PALETTE)]


def _evenness(found: WorkingCycle) -> str:
    steps = followers(found.firing)
    if len(steps) > 1 and max(step.interval_deg for step in steps) > found.cycle_deg - EVEN:
        return f"all fire together, every {number(found.cycle_deg)} deg"
    return f"{'even' if found.firing.even else 'odd'} firing, {spacing(steps)}"


def _arc(start: float, end: float, *, width: float = 1.0) -> Stroke:
    """A part of the ring, from and to in degrees of bearing."""
    bearings = np.radians(np.linspace(start, end, max(2, round(abs(end - start) / 3) + 1)))
    return Stroke(tuple(complex(point) for point in np.exp(1j * bearings)), width=width)


def _ticks() -> list[Stroke]:
    """Marks at the quarters of the cycle."""
    return [Stroke((0.9 * exp(1j * radians(bearing)), exp(1j * radians(bearing))), width=1.0) for bearing in (0, 90, 180, 270)]


def _labels(found: WorkingCycle, groups: Sequence[ExhaustGroup], fires: dict[int, float], frame: Frame) -> list[Label]:
    """The numbers outside the ring, with crank angles where there is room; cylinders that fire together share a label."""
    colours = {chamber: _colour(place) for place, group in enumerate(groups) for chamber in group.chambers}
    together: dict[float, list[int]] = {}
    for chamber in found.firing.order:
        together.setdefault(round(fires[chamber], 3), []).append(chamber)
    angles = [f"{number(found.chamber(chambers[0]).fires_deg, 720.0, digits=4)}°" for chambers in together.values()]
    room = 2 * pi * (1 + ASIDE) * frame.scale / len(together)
    out, spelt = [], max(text_width(angle) for angle in angles) + BETWEEN <= room
    for (bearing, chambers), angle in zip(together.items(), angles, strict=True):
        text = numbers_text(chambers) + (f"\n{angle}" if spelt else "")
        way = exp(1j * radians(bearing))
        colour = colours[chambers[0]] if len({colours[one] for one in chambers}) == 1 else GREY
        out.append(Label(text, (1 + ASIDE) * way, way, colour=colour, size=TEXT, gap=13 if spelt else 9))
    return out


def _key(found: WorkingCycle, groups: Sequence[ExhaustGroup], frame: Frame) -> list[Label]:
    """The groups in their colours below the ring, with the intervals between their exhausts."""
    if len(groups) == 1:
        return []
    out = []
    for place, group in enumerate(groups):
        steps = exhaust_intervals(found, group.chambers)
        text = f"{group.name}: {spacing(steps)}" if len(steps) > 1 else group.name
        height = frame.bottom + (LINE * (len(groups) - place - 0.5)) / frame.scale
        out.append(Label(text, complex(height, 0.0), 0j, colour=_colour(place)))
    return out
