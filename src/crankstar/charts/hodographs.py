"""Hodographs: the path of the head of a force or couple vector over a period."""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from math import degrees, pi
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.crank_angle import waves
from crankstar.charts.drawing import (
    BLUE,
    GREY,
    SMALL,
    VERMILION,
    WIDTH,
    Panel,
    checked_angle,
    checked_order,
    figure,
    named,
)
from crankstar.charts.grammar import Chart, field, of_rows
from crankstar.charts.labels import Label
from crankstar.charts.plane import (
    HEAD,
    Axes,
    Dot,
    Frame,
    Plane,
    Stroke,
    coordinates,
    empty,
    picture,
    round_frame,
)
from crankstar.charts.vectors import Quantity, checked_quantity
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Spectrum

MOST_TURNS = 12
"""Greatest number of turns of a drawn path; geared shafts can need very many."""
TITLES = {
    "force": (N_("Path of the force of order {order}"), N_("Path of the force, all orders")),
    "couple": (N_("Path of the couple of order {order}"), N_("Path of the couple, all orders")),
}
AXES = {
    "force": (N_("force right ({unit})"), N_("force up ({unit})")),
    "couple": (N_("couple right ({unit})"), N_("couple up ({unit})")),
}
NONE = {
    "force": (N_("no force of order {order}"), N_("no force")),
    "couple": (N_("no couple of order {order}"), N_("no couple")),
}


class Course(NamedTuple):
    """The vector whose path is drawn, and its period in turns of the crankshaft."""

    name: str
    quantity: Quantity
    order: float | None
    unit: str
    spectrum: Spectrum
    turns: int

    @property
    def reach(self) -> float:
        """The greatest length of the vector."""
        return spectra.peak(self.spectrum).value


def course(
    engine: Engine,
    *,
    quantity: Quantity = "force",
    order: float | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
) -> Course:
    """Force or couple of the whole engine, of one order or of all together."""
    checked_quantity(quantity)
    result = balance(engine, speed=speed, reference=reference)
    whole = getattr(total(result), quantity)
    if order is not None:
        whole = spectra.selected(whole, checked_order(order))
    whole = present(whole, _scale(getattr(result, quantity)))
    return Course(
        engine.name,
        quantity,
        order,
        unit_text(result.units._asdict()[quantity]),
        whole,
        spectra.period(whole),
    )


def _scale(shares: Spectrum) -> float:
    """The sum of the sizes of all parts, the measure of a negligible sum."""
    return float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))


def present(spectrum: Spectrum, scale: float) -> Spectrum:
    """The orders of a spectrum that are not negligible beside `scale`."""
    kept = np.maximum(np.abs(spectrum.forward), np.abs(spectrum.backward)) > NEGLIGIBLE * scale
    return Spectrum(
        spectrum.orders[kept], spectrum.forward[kept], spectrum.backward[kept], spectrum.sense
    )


def hodograph(
    engine: Engine,
    *,
    quantity: Quantity = "force",
    order: float | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
    theta: float = 0.0,
) -> Chart:
    """The path of force or couple over a period, marked every 90 degrees of the crank.

    A dot is at `theta` (radians). One order is an ellipse, drawn with its semi-axes; without an
    order the sum of all is drawn. Equal scales, in units of m r w^2 or, at a `speed` (rad/s), in N
    and N m. Raises ChartError.
    """
    shown = course(engine, quantity=quantity, order=order, speed=speed, reference=reference)
    theta = checked_angle(theta)
    title = course_title(shown)
    panel = course_panel(shown, reach=shown.reach, theta=theta)
    return figure(
        [[panel]],
        title=title,
        subtitle=[named(engine)],
        theta=theta,
        turns=min(shown.turns, MOST_TURNS),
    )


def course_title(shown: Course) -> str:
    """Quantity and order."""
    return _of_order(shown, TITLES)


def _of_order(shown: Course, forms: Mapping[str, tuple[str, str]]) -> str:
    """The form of a sentence for the quantity, with its order or without one."""
    single, whole = forms[shown.quantity]
    return _(whole) if shown.order is None else _(single, order=f"{shown.order:g}")


def course_panel(
    shown: Course, *, reach: float, theta: float, width: float | None = None, title: str = ""
) -> Panel:
    """One hodograph on axes that reach as far as `reach` from the origin."""
    frame = round_frame(reach, width=width or WIDTH - 10, margin=34)
    axes = Axes(*(_(title, unit=shown.unit) for title in AXES[shown.quantity]))
    cross = [
        Stroke((1j * frame.left, 1j * frame.right), width=0.6),
        Stroke((frame.bottom + 0j, frame.top + 0j), width=0.6),
    ]
    if not shown.spectrum.orders.size:
        note = empty(frame, _of_order(shown, NONE))._replace(direction=1, gap=8)
        return picture(
            Plane(strokes=tuple(cross), notes=(note,)), frame, theta=theta, axes=axes, title=title
        )
    angles = np.linspace(0, 2 * pi * min(shown.turns, MOST_TURNS), _samples(shown))
    path = spectra.value(shown.spectrum, angles)
    ends, words = _ellipse_axes(shown) if shown.order is not None else ([], [])
    marks, angles_text = _marks(shown, frame.scale)
    now = _now(shown, frame, axes)
    plane = Plane(
        strokes=(*cross, *ends, Stroke(tuple(path.tolist()), BLUE, 2.0)),
        dots=tuple(marks),
        labels=(*words, *angles_text),
    )
    return picture(
        plane,
        frame,
        theta=theta,
        axes=axes,
        title=title,
        more=[*_direction(shown, frame, axes), *now],
    )


def _samples(shown: Course) -> int:
    highest = float(shown.spectrum.orders.max()) * min(shown.turns, MOST_TURNS)
    return int(min(max(180, 24 * highest), 4000)) + 1


def _ellipse_axes(shown: Course) -> tuple[list[Stroke], list[Label]]:
    """The axes of the ellipse of one order, and the lengths of its semi-axes."""
    shape = spectra.ellipse(complex(shown.spectrum.forward[0]), complex(shown.spectrum.backward[0]))
    way = exp(1j * shape.bearing)
    strokes, labels = [], []
    circle = shape.semi_major - shape.semi_minor <= NEGLIGIBLE * shape.semi_major
    for length, direction in ((shape.semi_major, way), (shape.semi_minor, -1j * way)):
        if length <= NEGLIGIBLE * shape.semi_major:
            continue
        strokes.append(Stroke((-length * direction, length * direction), GREY, 1.2, dashed=True))
        if direction == way or not circle:
            labels.append(
                Label(
                    number(length) if length >= 1e3 else number(length, digits=4),
                    0.5 * length * direction,
                    1j * direction,
                    colour=GREY,
                )
            )
    return strokes, labels


def _marks(shown: Course, scale: float) -> tuple[list[Dot], list[Label]]:
    """Dots every 90 degrees of the crankshaft with their angles; coinciding dots share a label."""
    turns = shown.turns if shown.turns <= 2 else 1
    angles = np.arange(0, 4 * turns) * pi / 2
    places = spectra.value(shown.spectrum, angles).tolist()
    groups: list[list[int]] = []
    for index, place in enumerate(places):
        home = next((group for group in groups if abs(places[group[0]] - place) * scale < 3), None)
        home.append(index) if home is not None else groups.append([index])
    dots = [Dot(places[group[0]], colour=BLUE, size=40) for group in groups]
    labels = []
    for group in groups:
        place = places[group[0]]
        text = ", ".join(f"{degrees(angles[i]):.0f}°" for i in group[:4]) + (
            " …" if len(group) > 4 else ""
        )
        labels.append(
            Label(
                text,
                place,
                place / abs(place) if abs(place) * scale > 1 else 1 + 0j,
                colour=BLUE,
                size=SMALL,
                gap=8.0,
            )
        )
    return dots, labels


def _direction(shown: Course, frame: Frame, axes: Axes) -> list[Any]:
    """An arrow head on the path in the direction of motion; none on a straight line."""
    spectrum = shown.spectrum
    if (
        shown.order is not None
        and spectra.ellipse(complex(spectrum.forward[0]), complex(spectrum.backward[0])).sense == 0
    ):
        return []
    slowest = float(
        spectrum.orders[np.argmax(np.abs(spectrum.forward) + np.abs(spectrum.backward))]
    )
    at = pi / 4 / slowest if slowest != 1 else pi / 4
    before, place, after = (
        complex(spectra.value(spectrum, at + step)) for step in (-1e-4, 0, 1e-4)
    )
    way = after - before
    if abs(way) == 0 or _returns(shown, place, way):
        return []
    tip = place + 7 / frame.scale * way / abs(way)
    row = {"x2": tip.imag, "y2": tip.real, "bearing": degrees(float(np.angle(way)))}
    x, y = coordinates(frame, axes)
    mark = of_rows([row]).mark(
        "point", shape=HEAD, filled=True, opacity=1, strokeWidth=0, size=240, color=BLUE
    )
    return [mark.encode(x=x, y=y, angle=field("bearing:Q", scale=None))]


def _returns(shown: Course, place: complex, way: complex) -> bool:
    """Whether the path also passes a place in the opposite direction."""
    angles = np.linspace(0, 2 * pi * min(shown.turns, MOST_TURNS), 4 * _samples(shown))
    path = spectra.value(shown.spectrum, angles)
    steps = np.diff(path)
    near = np.abs(path[:-1] - place) <= 2 * np.abs(steps)
    along = np.real(np.conj(way / abs(way)) * steps)
    return bool(np.any(near & (along < -0.9 * np.abs(steps)) & (np.abs(steps) > 0)))


def _now(shown: Course, frame: Frame, axes: Axes) -> list[Any]:
    """The vector at the parameter theta: a line from the origin and a dot at its head."""
    x, y = coordinates(frame, axes)
    spectrum = shown.spectrum
    up = waves(spectrum.orders, spectra.vertical(spectrum))
    right = waves(spectrum.orders, spectra.horizontal(spectrum))
    base = of_rows([{"from": 0}]).calculate(x2=right, y2=up)
    line = base.mark("rule", color=VERMILION, strokeWidth=1.5).encode(
        x=x, y=y, x2=field("from"), y2=field("from")
    )
    dot = base.mark(
        "point", color=VERMILION, filled=True, opacity=1, size=110, shape="circle"
    ).encode(x=x, y=y)
    return [line, dot]
