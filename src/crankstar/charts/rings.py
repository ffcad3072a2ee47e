"""The firing ring: the cylinders round a circle at the crank angles at which they fire."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from math import radians
from typing import TYPE_CHECKING

import numpy as np

from crankstar.charts.drawing import GREY, PALETTE, TEXT, VERMILION, WIDTH, checked_angle, figure, numbers_text
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
"""How far outside or inside the ring the banks stand by turns, in its radius."""
MARGIN = 58.0
"""Px about the ring for numbers."""
LINE = 18.0
"""Px of a line of the key."""
MOST_SPELT = 10
"""Cylinders on a ring whose crank angles are written beside them."""


def firing_ring(engine: Engine, *, theta: float = 0.0) -> altair.VConcatChart:
    """The cylinders at their firing angles round a circle, clockwise: once round is one cycle, 720 or 360 deg.

    The cylinders of a bank (or manifold) have a colour and a side of the ring, and the lines between them show how evenly their
    exhausts follow each other. Where neighbours fire one after the other the ring is thick. The pointer stands at the crank angle
    `theta` (radians). Raises ChartError.
    """
    theta = checked_angle(theta)
    found = found_cycle(engine)
    turns = round(engine.cycle_angle / 360)
    title = f"Firing ring, {engine.cycle_angle:.0f} deg once round"
    pointer = Arrow(0.78 + 0j, rate=1 / turns, colour=VERMILION, width=2)
    if found is None:
        frame = round_frame(1.0, width=WIDTH, margin=MARGIN)
        plane = Plane((pointer,), (_arc(0.0, 360.0),), notes=(empty(frame, NO_ORDER)._replace(anchor=-0.2 + 0j),))
        return figure([[picture(plane, frame, theta=theta)]], title=title, subtitle=[engine.name], theta=theta, turns=turns)
    groups = _groups(engine)
    frame = round_frame(1.0, width=WIDTH, margin=MARGIN, below=LINE * (len(groups) + 0.5) if len(groups) > 1 else 0.0)
    pairs = in_succession(found.firing, neighbours(engine))
    share = 360 / found.cycle_deg
    fires = {one.number: one.fires_deg * share for one in found.chambers}
    thick = [_arc(fires[step.first], fires[step.first] + step.interval_deg * share, width=6.0) for step in pairs]
    strokes, dots = [_arc(0.0, 360.0), *thick, *_ticks()], []
    for place, group in enumerate(groups):
        colour, radius = _colour(place), 1 + (ASIDE if place % 2 == 0 else -ASIDE) * (len(groups) > 1)
        points = [radius * exp(1j * radians(fires[step.first])) for step in exhaust_intervals(found, group.chambers)]
        dots += [Dot(point, colour=colour, size=110) for point in points]
        if len(points) > 1 and len(groups) <= len(PALETTE):
            strokes.append(Stroke((*points, points[0]), colour=colour, width=1.5))
    plane = Plane((pointer,), tuple(strokes), tuple(dots), tuple(_labels(found, groups, fires)), tuple(_key(found, groups, frame)))
    subtitle = [engine.name, _evenness(found)] + (["thick: neighbours that fire one after the other"] if pairs else [])
    return figure([[picture(plane, frame, theta=theta)]], title=title, subtitle=subtitle, theta=theta, turns=turns)


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


def _labels(found: WorkingCycle, groups: Sequence[ExhaustGroup], fires: dict[int, float]) -> list[Label]:
    """The numbers outside the ring; cylinders that fire together share a label."""
    colours = {chamber: _colour(place) for place, group in enumerate(groups) for chamber in group.chambers}
    together: dict[float, list[int]] = {}
    for chamber in found.firing.order:
        together.setdefault(round(fires[chamber], 3), []).append(chamber)
    out, spelt = [], len(together) <= MOST_SPELT
    for bearing, chambers in together.items():
        angle = found.chamber(chambers[0]).fires_deg
        text = numbers_text(chambers) + (f"\n{number(angle, 720.0, digits=4)}°" if spelt else "")
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
