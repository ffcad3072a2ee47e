"""The force polygon and the moment polygon: the vectors of an order head to tail, and what is missing to close it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from crankstar.charts.drawing import HALF, ORANGE, TEXT, WIDTH, Panel, checked_angle, figure, named, numbers_text
from crankstar.charts.labels import Label
from crankstar.charts.plane import BAR, Arrow, Dot, Frame, Plane, empty, picture, round_frame, scale_bar
from crankstar.charts.stars import nothing, turns_of
from crankstar.charts.vectors import COLOURS, NOTHING, Quantity, Star, Stars, angle_text, heading, stars
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.wording import number

if TYPE_CHECKING:
    import altair


def polygon(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    theta: float = 0.0,
    reference: Reference | None = None,
    speed: float | None = None,
) -> altair.VConcatChart:
    """The polygon of the vectors of an order at the crank angle `theta` (radians), in the order of the cylinders.

    It closes, or the resultant is drawn from start to end, with its length and its plane at theta = 0: the angle from the
    axis of the cylinders (crank 1) in the direction of rotation for cylinders in a row, else its bearing, clockwise from up.
    Vectors and units are those of `vector_star`. Raises ChartError.
    """
    found = stars(engine, order=order, quantity=quantity, reference=reference, speed=speed)
    theta = checked_angle(theta)
    panels = polygon_panels(found, theta=theta, reach=polygon_reach(found))
    title = heading(found, "polygon")
    return figure([panels], title=title, subtitle=[named(engine)], theta=theta, turns=turns_of(found.order))


def polygon_reach(found: Stars) -> float:
    """The radius of the greatest circle that a polygon needs."""
    return max((_circle(_corners(star))[1] for star in found.stars), default=0.0)


def polygon_panels(found: Stars, *, theta: float, reach: float | None = None, width: float | None = None) -> list[Panel]:
    """The one or two panels of a polygon on a scale that shows circles up to `reach`; without it each on its own scale."""
    width = width or (WIDTH if len(found.stars) == 1 else HALF)
    reaches = [_circle(_corners(star))[1] if reach is None else reach for star in found.stars]
    frames = [round_frame(one, width=width, margin=24, below=BAR) for one in reaches]
    return [_panel(found, star, frame, theta) for star, frame in zip(found.stars, frames, strict=True)]


def _corners(star: Star) -> list[complex]:
    corners = [0j]
    for vector in star.vectors:
        corners.append(corners[-1] + vector.value)
    return corners


def _circle(points: Sequence[complex]) -> tuple[complex, float]:
    """Centre and radius of the smallest circle about points, near enough: ever shorter steps to the farthest point."""
    places = np.array(points)
    ups, rights = np.real(places), np.imag(places)
    centre = complex(ups.max() + ups.min(), rights.max() + rights.min()) / 2
    for step in range(2, 300):
        farthest = places[np.argmax(np.abs(places - centre))]
        centre += complex(farthest - centre) / step
    return centre, float(np.abs(places - centre).max())


def result_text(found: Stars, star: Star) -> str:
    """Closed, or the length and the plane of the resultant."""
    if abs(star.resultant) <= NOTHING * max((abs(vector.value) for vector in star.vectors), default=0.0):
        return "closes"
    return f"{number(abs(star.resultant))} {found.unit}\n{angle_text(found, star.resultant)}"


def _panel(found: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    if not star.vectors:
        return picture(Plane(notes=(empty(frame, nothing(found, star)),)), frame, theta=theta, title=star.title)
    corners = _corners(star)
    centre, _ = _circle(corners)
    moved = [corner - centre for corner in corners]
    arrows = [
        Arrow(end, start, rate=star.rate, colour=COLOURS[vector.kind])
        for vector, (start, end) in zip(star.vectors, pairwise(moved), strict=True)
    ]
    said = result_text(found, star)
    if said != "closes":
        # under the sides, so that their heads stay in sight where they cover each other
        arrows.insert(0, Arrow(moved[0] + star.resultant, moved[0], rate=star.rate, colour=ORANGE, width=4))
    dots = (Dot(moved[0], rate=star.rate, colour=COLOURS[star.vectors[0].kind], size=36),)
    bar, length = scale_bar(frame, found.unit)
    labels = _side_labels(star, moved, frame.scale)
    title = "\n".join(filter(None, (star.title, said if said == "closes" else f"resultant {said}")))
    return picture(Plane(tuple(arrows), (bar,), dots, tuple(labels), (length,)), frame, theta=theta, title=title)


def _side_labels(star: Star, corners: Sequence[complex], scale: float) -> list[Label]:
    """A label beside the middle of every side, outside; sides that cover each other share one."""
    area = sum((a * b.conjugate()).imag for a, b in pairwise([*corners, corners[0]]))
    outward = 1j if area >= 0 else -1j
    sides: dict[tuple[complex, complex], list[int]] = {}
    for index, (start, end) in enumerate(pairwise(corners)):
        key = min(((a, b) for a, b in sides if abs(a - start) + abs(b - end) < 2 / scale), default=(start, end), key=abs_of)
        sides.setdefault(key, []).append(index)
    out = []
    for (start, end), at in sides.items():
        way = (end - start) / abs(end - start)
        cylinders = [int(star.vectors[i].name) for i in at if star.vectors[i].kind == "cylinder"]
        others = [star.vectors[i].name for i in at if star.vectors[i].kind != "cylinder"]
        text = ", ".join([*([numbers_text(cylinders)] if cylinders else []), *others])
        colour = COLOURS[star.vectors[at[0]].kind]
        out.append(Label(text, (start + end) / 2, outward * way, star.rate, colour=colour, size=TEXT))
    return out


def abs_of(side: tuple[complex, complex]) -> float:
    """A side's place in an order."""
    return abs(side[0])
