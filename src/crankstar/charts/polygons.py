"""Force and couple polygons: the vectors of an order head to tail, and their resultant."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from crankstar.charts.drawing import (
    HALF,
    ORANGE,
    TEXT,
    WIDTH,
    Panel,
    checked_angle,
    figure,
    named,
    numbers_text,
)
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label
from crankstar.charts.plane import (
    BAR,
    Arrow,
    Dot,
    Frame,
    Plane,
    empty,
    picture,
    round_frame,
    scale_bar,
)
from crankstar.charts.stars import nothing, turns_of
from crankstar.charts.vectors import COLOURS, Quantity, Star, Stars, angle_text, stars
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE


def polygon(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    theta: float = 0.0,
    reference: Reference | None = None,
    speed: float | None = None,
) -> Chart:
    """The polygon of the vectors of an order, by cylinder, at the crank angle `theta` (radians).

    Where it does not close, the resultant is drawn with its length and its plane at theta = 0: the
    angle from the cylinder axis (crank 1) in the direction of rotation for cylinders in a row, else
    its bearing. Vectors and units are those of `vector_star`. Raises ChartError.
    """
    shown = stars(engine, order=order, quantity=quantity, reference=reference, speed=speed)
    theta = checked_angle(theta)
    panels = polygon_panels(shown, theta=theta, reach=polygon_reach(shown))
    return figure(
        [panels],
        title=polygon_heading(shown),
        subtitle=[named(engine)],
        theta=theta,
        turns=turns_of(shown.order),
    )


HEADINGS = {
    "force": N_("Force polygon of order {order}, in {unit}"),
    "couple": N_("Couple polygon of order {order}, in {unit}"),
}


def polygon_heading(shown: Stars) -> str:
    """Quantity, order and unit."""
    return _(HEADINGS[shown.quantity], order=f"{shown.order:g}", unit=shown.unit)


def polygon_reach(shown: Stars) -> float:
    """The radius of the circle about the largest polygon."""
    return max((_circle(_corners(star))[1] for star in shown.stars), default=0.0)


def polygon_panels(
    shown: Stars, *, theta: float, reach: float | None = None, width: float | None = None
) -> list[Panel]:
    """The one or two panels of a polygon, scaled for a circle of `reach`, else each for its own."""
    width = width or (WIDTH if len(shown.stars) == 1 else HALF)
    reaches = [_circle(_corners(star))[1] if reach is None else reach for star in shown.stars]
    frames = [round_frame(one, width=width, margin=24, below=BAR) for one in reaches]
    return [
        _panel(shown, star, frame, theta) for star, frame in zip(shown.stars, frames, strict=True)
    ]


def _corners(star: Star) -> list[complex]:
    corners = [0j]
    for vector in star.vectors:
        corners.append(corners[-1] + vector.value)
    return corners


def _circle(points: Sequence[complex]) -> tuple[complex, float]:
    """Nearly the smallest circle about points, by ever shorter steps to the farthest."""
    places = np.array(points)
    ups, rights = np.real(places), np.imag(places)
    centre = complex(ups.max() + ups.min(), rights.max() + rights.min()) / 2
    for step in range(2, 300):
        farthest = places[np.argmax(np.abs(places - centre))]
        centre += complex(farthest - centre) / step
    return centre, float(np.abs(places - centre).max())


def is_closed(star: Star) -> bool:
    """Whether the resultant of a star is zero beside its vectors."""
    longest = max((abs(vector.value) for vector in star.vectors), default=0.0)
    return abs(star.resultant) <= NEGLIGIBLE * longest


def result_text(shown: Stars, star: Star) -> str:
    """Closed, or the length and the plane of the resultant."""
    if is_closed(star):
        return _("closed")
    return _(
        "resultant {size} {unit}\n{angle}",
        size=number(abs(star.resultant)),
        unit=shown.unit,
        angle=angle_text(shown, star.resultant),
    )


def _panel(shown: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    if not star.vectors:
        return picture(
            Plane(notes=(empty(frame, nothing(shown, star)),)), frame, theta=theta, title=star.title
        )
    corners = _corners(star)
    centre, _ = _circle(corners)
    moved = [corner - centre for corner in corners]
    arrows = [
        Arrow(end, start, rate=star.rate, colour=COLOURS[vector.kind])
        for vector, (start, end) in zip(star.vectors, pairwise(moved), strict=True)
    ]
    if not is_closed(star):
        # under the sides, so that their heads stay visible where they overlap
        arrows.insert(
            0, Arrow(moved[0] + star.resultant, moved[0], rate=star.rate, colour=ORANGE, width=4)
        )
    dots = (Dot(moved[0], rate=star.rate, colour=COLOURS[star.vectors[0].kind], size=36),)
    bar, length = scale_bar(frame, shown.unit)
    labels = _side_labels(star, moved, frame.scale)
    title = "\n".join(filter(None, (star.title, result_text(shown, star))))
    return picture(
        Plane(tuple(arrows), (bar,), dots, tuple(labels), (length,)),
        frame,
        theta=theta,
        title=title,
    )


def _side_labels(star: Star, corners: Sequence[complex], scale: float) -> list[Label]:
    """A label outside the middle of every side; overlapping sides share one."""
    area = sum((a * b.conjugate()).imag for a, b in pairwise([*corners, corners[0]]))
    outward = 1j if area >= 0 else -1j
    sides: dict[tuple[complex, complex], list[int]] = {}
    for index, (start, end) in enumerate(pairwise(corners)):
        key = min(
            ((a, b) for a, b in sides if abs(a - start) + abs(b - end) < 2 / scale),
            default=(start, end),
            key=lambda side: abs(side[0]),
        )
        sides.setdefault(key, []).append(index)
    out = []
    for (start, end), at in sides.items():
        way = (end - start) / abs(end - start)
        cylinders = [int(star.vectors[i].name) for i in at if star.vectors[i].kind == "cylinder"]
        others = [star.vectors[i].name for i in at if star.vectors[i].kind != "cylinder"]
        text = ", ".join([*([numbers_text(cylinders)] if cylinders else []), *others])
        colour = COLOURS[star.vectors[at[0]].kind]
        out.append(
            Label(text, (start + end) / 2, outward * way, star.rate, colour=colour, size=TEXT)
        )
    return out
