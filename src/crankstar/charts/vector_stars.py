"""The vectors of an order as a star, and head to tail as a polygon with their resultant."""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from crankstar.charts.canvas import USUAL_WIDTH, abreast, half_width, panel_width
from crankstar.charts.choices import order_shown
from crankstar.charts.comparison import compared
from crankstar.charts.drawing import ORANGE, Panel
from crankstar.charts.estimates import range_text, size_range
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label, beside, gathered
from crankstar.charts.letters import together
from crankstar.charts.plane import (
    BAR,
    Arrow,
    Dot,
    Frame,
    Plane,
    Stroke,
    empty,
    label_margin,
    picture,
    round_frame,
    scale_bar,
)
from crankstar.charts.resting import of_resultants
from crankstar.charts.sums import Engines, Quantity, several
from crankstar.charts.vectors import COLOURS, Star, Stars, Vector, angle_text, in_one_unit, stars
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, numbers_text
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.tables.cells import rough

MANY, VERY_MANY, WIDER = 9, 20, 1.35
"""Labels of a star above which it has a row for itself, and a wider one, by this factor."""
SHARES = (0.5, 0.35, 0.65, 0.2, 0.8)
"""Places along a side for its label, in the order in which they are tried."""
TOGETHER = 3.0
"""px: tips closer than this share a label."""
STARS = {
    "force": N_("Force of order {order}, in {unit}"),
    "couple": N_("Couple of order {order}, in {unit}"),
}
POLYGONS = {
    "force": N_("Force polygon of order {order}, in {unit}"),
    "couple": N_("Couple polygon of order {order}, in {unit}"),
}
RESULTANTS = N_(
    "Estimated masses or lengths: the vectors are those of the typical values, a resultant has its "
    "range."
)
NONE = {"force": N_("no force of order {order}"), "couple": N_("no couple of order {order}")}


def vector_star(
    engine: Engines,
    *,
    order: float | None = None,
    quantity: Quantity | None = None,
    theta: float = 0.0,
    reference: Reference | None = None,
    speed: float | None = None,
) -> Chart:
    """The star of the vectors of an order at the crank angle `theta` (radians).

    Without a name, order and quantity are the lowest of which something is left.

    One vector for each cylinder, throw and weight.

    Cylinders in a row have the textbook's star, whose vectors' parts along the cylinders are the
    forces; others have one star of the vectors that turn with the crank and one of those against
    it. In m r w^2 |A_k| (times a for couples), or, at a `speed` (rad/s), in N and N m. Vectors that
    coincide share a label. Several engines stand side by side on one scale. Raises ChartError.
    """
    engines = several(engine)
    systems = _systems(engines, order=order, quantity=quantity, reference=reference, speed=speed)
    every = [star for shown in systems for star in shown.stars]
    tips = [_tip_labels(star, TOGETHER / 1000) for star in every]
    labels = [label.text for own in tips for label in own]
    width = _width(systems, max(map(len, tips)))
    share = 0.55 if width <= half_width() else 1.0
    frame = round_frame(
        max(abs(vector.value) for star in every for vector in star.vectors) if labels else 0.0,
        width=width,
        margin=max(share * label_margin(labels), 26),
        below=BAR,
    )
    return _figure(
        engines,
        systems,
        _star_panel,
        frame,
        STARS,
        resultant=False,
        theta=theta,
        speed=speed,
        reference=reference,
    )


def polygon(
    engine: Engines,
    *,
    order: float | None = None,
    quantity: Quantity | None = None,
    theta: float = 0.0,
    reference: Reference | None = None,
    speed: float | None = None,
) -> Chart:
    """The polygon of the vectors of an order, by cylinder, at the crank angle `theta` (radians).

    Without a name, order and quantity are the lowest of which something is left.

    Where it does not close, the resultant is drawn with its length and its plane at theta = 0: the
    angle from the cylinder axis (crank 1) in the direction of rotation for cylinders in a row, else
    its bearing. Vectors and units are those of `vector_star`; several engines stand side by side on
    one scale. Raises ChartError.
    """
    engines = several(engine)
    systems = _systems(engines, order=order, quantity=quantity, reference=reference, speed=speed)
    reach = max(_circle(_corners(star))[1] for shown in systems for star in shown.stars)
    width = _width(systems, max(len(star.vectors) for shown in systems for star in shown.stars))
    margin = 24 if width <= half_width() else 44
    frame = round_frame(reach, width=width, margin=margin, below=BAR)
    return _figure(
        engines,
        systems,
        _polygon_panel,
        frame,
        POLYGONS,
        resultant=not all(is_closed(star) for shown in systems for star in shown.stars),
        theta=theta,
        speed=speed,
        reference=reference,
    )


def _systems(
    engines: Sequence[Engine],
    *,
    order: float | None,
    quantity: Quantity | None,
    reference: Reference | None,
    speed: float | None,
) -> list[Stars]:
    """The vectors of each engine, all in one unit: in m r w^2 where only some have |A_k| = 1."""
    choice = order_shown(engines, quantity, order, reference=reference)
    options: dict[str, Any] = {
        "order": choice.order,
        "quantity": choice.quantity,
        "reference": reference,
    }
    systems = [stars(engine, speed=speed, **options) for engine in engines]
    if speed is None and len({shown.unit for shown in systems}) > 1:
        systems = [stars(engine, speed=speed, divided=False, **options) for engine in engines]
    return in_one_unit(systems)


def _width(systems: Sequence[Stars], labels: int) -> float:
    """Px of a panel; of many labels one that has its own row, or more, unless half is enough."""
    least = (WIDER if labels > VERY_MANY else 1.0) * USUAL_WIDTH
    across = abreast(len(systems))
    if across == 1 and len(systems[0].stars) == 2 and half_width() >= least:
        return half_width()
    if labels > VERY_MANY:
        return WIDER * panel_width()
    alone = across == len(systems[0].stars) == 1
    return panel_width() if alone or labels > MANY else half_width()


def _figure(
    engines: Sequence[Engine],
    systems: Sequence[Stars],
    panel: Callable[[Stars, Star, Frame, float], Panel],
    frame: Frame,
    titles: dict[str, str],
    *,
    resultant: bool,
    theta: float,
    speed: float | None,
    reference: Reference | None,
) -> Chart:
    """A panel for every star; `resultant` says that one is drawn."""
    rows = [[panel(shown, star, frame, theta) for star in shown.stars] for shown in systems]
    below = frame.width > half_width() + 1
    blocks = [[[one] for one in row] if below else [row] for row in rows]
    order, unit = systems[0].order, systems[0].unit
    return compared(
        engines,
        blocks,
        title=_(titles[systems[0].quantity], order=f"{order:g}", unit=together(unit)),
        speed=speed,
        theta=theta,
        turns=Fraction(order).limit_denominator(10_000).denominator,
        ranges=_(RESULTANTS),
        rests=of_resultants(
            engines,
            systems[0].quantity,
            drawn=resultant,
            speed=speed,
            orders=[order],
            reference=reference,
        ),
    )


def _star_panel(shown: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    if not star.vectors:
        return _nothing(shown, star, frame, theta)
    edge = frame.right * 0.98
    cross = [Stroke((-edge * way, edge * way), width=0.6) for way in (1 + 0j, 1j)]
    if shown.axis is not None:
        way = exp(1j * shown.axis)
        cross.append(Stroke((-edge * way, edge * way), width=1.2, dashed=True))
    bar, text = scale_bar(frame, shown.unit)
    arrows = [
        Arrow(v.value, rate=star.rate, colour=COLOURS[v.kind])
        for v in sorted(star.vectors, key=lambda v: -abs(v.value))
    ]
    longest = abs(arrows[0].end)
    labels = _tip_labels(star, min(TOGETHER / frame.scale / longest, 1.0))
    plane = Plane(tuple(arrows), (*cross, bar), (), tuple(labels), (text,))
    return picture(plane, frame, theta=theta, title=star.title)


def _nothing(shown: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    """A panel without vectors."""
    note = _(NONE[shown.quantity], order=f"{shown.order:g}")
    text = empty(frame, "\n".join(filter(None, (note, star.title))))
    return picture(Plane(notes=(text,)), frame, theta=theta, title=star.title)


def _tip_labels(star: Star, near: float) -> list[Label]:
    """Labels beyond the heads of the vectors, longest first.

    Vectors share one whose heads are within `near`, a share of the longest vector.
    """
    values = [vector.value for vector in star.vectors]
    groups = gathered(values, near * max(map(abs, values), default=0.0))
    groups.sort(key=lambda group: -abs(values[group[0]]))
    out = []
    for group in groups:
        value, vectors = values[group[0]], [star.vectors[i] for i in group]
        out.append(_label(vectors, value, value / abs(value), star.rate, most=2))
    return out


def _label(
    vectors: Sequence[Vector], anchor: complex, way: complex, rate: float, *, most: int = 99
) -> Label:
    """The names of vectors at a place, up to `most` of those that are not cylinders."""
    cylinders = [int(vector.name) for vector in vectors if vector.kind == "cylinder"]
    others = [vector.name for vector in vectors if vector.kind != "cylinder"]
    text = ", ".join([*([numbers_text(cylinders)] if cylinders else []), *others[:most]])
    text += " …" if len(others) > most else ""
    return Label(text, anchor, way, rate, colour=COLOURS[vectors[0].kind])


def _corners(star: Star) -> tuple[complex, ...]:
    return tuple(accumulate((vector.value for vector in star.vectors), initial=0j))


@lru_cache(maxsize=64)  # the frame of all stars asks for each, then its own panel
def _circle(points: tuple[complex, ...]) -> tuple[complex, float]:
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
    ends = size_range(star.resultant, star.ends)
    if is_closed(star):
        words = _("closed")
        return f"{words}{range_text(ends)} {shown.unit}" if ends else words
    size = number(abs(star.resultant))
    return _(
        "resultant {size} {unit}\n{angle}",
        size=f"{rough(abs(star.resultant))}{range_text(ends)}" if ends else size,
        unit=together(shown.unit),
        angle=angle_text(shown, star.resultant),
    )


def _polygon_panel(shown: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    if not star.vectors:
        return _nothing(shown, star, frame, theta)
    corners = _corners(star)
    centre = _circle(corners)[0]
    moved = [corner - centre for corner in corners]
    arrows = [
        Arrow(end, start, rate=star.rate, colour=COLOURS[vector.kind])
        for vector, (start, end) in zip(star.vectors, pairwise(moved), strict=True)
    ]
    if not is_closed(star):
        # under the sides, so that their heads stay visible where they overlap
        end = moved[0] + star.resultant
        arrows.insert(0, Arrow(end, moved[0], rate=star.rate, colour=ORANGE, width=4))
    dots = (Dot(moved[0], rate=star.rate, colour=COLOURS[star.vectors[0].kind], size=36),)
    bar, length = scale_bar(frame, shown.unit)
    sides = _side_labels(star, moved, frame.scale, theta)
    title = "\n".join(filter(None, (star.title, result_text(shown, star))))
    plane = Plane(tuple(arrows), (bar,), dots, notes=(length,), choices=tuple(sides))
    return picture(plane, frame, theta=theta, title=title)


def _side_labels(
    star: Star, corners: Sequence[complex], scale: float, theta: float
) -> list[list[Label]]:
    """Labels of every side, of which one is taken; overlapping sides share them.

    Outside its middle, or inside, or nearer to an end.
    """
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
        vectors, across = [star.vectors[i] for i in at], outward * (end - start) / abs(end - start)
        out.append(
            [
                beside(_label(vectors, start + share * (end - start), way, star.rate), theta=theta)
                for share in SHARES
                for way in (across, -across)
            ]
        )
    return out
