"""Hodographs: the path that the head of a force or a couple runs through in a period."""

from __future__ import annotations

from cmath import exp
from math import degrees, pi
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from crankstar import phasor
from crankstar.balance import balance, total
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
    of_rows,
)
from crankstar.charts.labels import Label
from crankstar.charts.plane import HEAD, Axes, Dot, Frame, Plane, Stroke, coordinates, empty, picture, round_frame
from crankstar.charts.vectors import NOTHING, Quantity, checked_quantity
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.phasor import Spectrum
from crankstar.wording import number, unit_text

if TYPE_CHECKING:
    import altair

MOST_TURNS = 12
"""Turns of the crankshaft that a path is drawn for; geared shafts can need very many."""


class Course(NamedTuple):
    """The vector whose path is drawn, its period in turns of the crankshaft, and what it is."""

    name: str
    quantity: Quantity
    order: float | None
    unit: str
    spectrum: Spectrum
    turns: int

    @property
    def reach(self) -> float:
        """The greatest length of the vector."""
        return phasor.peak(self.spectrum).value


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
        whole = phasor.selected(whole, checked_order(order))
    whole = present(whole, _scale(getattr(result, quantity)))
    return Course(engine.name, quantity, order, unit_text(result.units._asdict()[quantity]), whole, phasor.period(whole))


def _scale(shares: Spectrum) -> float:
    """The greatest that all parts push together, whatever the direction: the measure of what is nothing."""
    return float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))


def present(spectrum: Spectrum, scale: float) -> Spectrum:
    """The orders of a spectrum that can be told from nothing beside `scale`."""
    kept = np.maximum(np.abs(spectrum.forward), np.abs(spectrum.backward)) > NOTHING * scale
    return Spectrum(spectrum.orders[kept], spectrum.forward[kept], spectrum.backward[kept], spectrum.sense)


def hodograph(
    engine: Engine,
    *,
    quantity: Quantity = "force",
    order: float | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
    theta: float = 0.0,
) -> altair.VConcatChart:
    """The path of force or couple over a period, with marks every 90 degrees of the crank and a dot at `theta` (radians).

    One order is an ellipse, drawn with its axes and their half lengths; without an order all of them are taken together.
    Equal scales, in units of m r w^2 or, at a `speed` (rad/s), in N and N m. Raises ChartError.
    """
    found = course(engine, quantity=quantity, order=order, speed=speed, reference=reference)
    theta = checked_angle(theta)
    title = course_title(found)
    panel = course_panel(found, reach=found.reach, theta=theta)
    return figure([[panel]], title=title, subtitle=[named(engine)], theta=theta, turns=min(found.turns, MOST_TURNS))


def course_title(found: Course) -> str:
    """What is drawn, of which order."""
    which = "all orders" if found.order is None else f"order {found.order:g}"
    return f"Path of the {found.quantity}, {which}"


def course_panel(found: Course, *, reach: float, theta: float, width: float | None = None, title: str = "") -> Panel:
    """One hodograph on axes that reach as far as `reach` from the origin."""
    import altair as alt

    frame = round_frame(reach, width=width or WIDTH - 10, margin=34)
    axes = Axes(f"{found.quantity} right ({found.unit})", f"{found.quantity} up ({found.unit})")
    cross = [Stroke((1j * frame.left, 1j * frame.right), width=0.6), Stroke((frame.bottom + 0j, frame.top + 0j), width=0.6)]
    if not found.spectrum.orders.size:
        which = "" if found.order is None else f" of order {found.order:g}"
        note = empty(frame, f"no {found.quantity}{which}")._replace(direction=1, gap=8)
        return picture(Plane(strokes=tuple(cross), notes=(note,)), frame, theta=theta, axes=axes, title=title)
    angles = np.linspace(0, 2 * pi * min(found.turns, MOST_TURNS), _samples(found))
    path = phasor.value(found.spectrum, angles)
    ends, words = _ellipse_axes(found) if found.order is not None else ([], [])
    marks, told = _marks(found, frame.scale)
    now = _now(alt, found, frame, axes)
    plane = Plane(strokes=(*cross, *ends, Stroke(tuple(path.tolist()), BLUE, 2.0)), dots=tuple(marks), labels=(*words, *told))
    return picture(plane, frame, theta=theta, axes=axes, title=title, more=[*_direction(alt, found, frame, axes), *now])


def _samples(found: Course) -> int:
    highest = float(found.spectrum.orders.max()) * min(found.turns, MOST_TURNS)
    return int(min(max(180, 24 * highest), 4000)) + 1


def _ellipse_axes(found: Course) -> tuple[list[Stroke], list[Label]]:
    """The axes of one order's ellipse and the half lengths beside their ends."""
    shape = phasor.ellipse(complex(found.spectrum.forward[0]), complex(found.spectrum.backward[0]))
    way = exp(1j * shape.bearing)
    strokes, labels = [], []
    circle = shape.semi_major - shape.semi_minor <= NOTHING * shape.semi_major
    for length, direction in ((shape.semi_major, way), (shape.semi_minor, -1j * way)):
        if length <= NOTHING * shape.semi_major:
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


def _marks(found: Course, scale: float) -> tuple[list[Dot], list[Label]]:
    """Dots every 90 degrees of the crankshaft and their angles; places run through again share a label."""
    turns = found.turns if found.turns <= 2 else 1
    angles = np.arange(0, 4 * turns) * pi / 2
    places = phasor.value(found.spectrum, angles).tolist()
    groups: list[list[int]] = []
    for index, place in enumerate(places):
        home = next((group for group in groups if abs(places[group[0]] - place) * scale < 3), None)
        home.append(index) if home is not None else groups.append([index])
    dots = [Dot(places[group[0]], colour=BLUE, size=40) for group in groups]
    labels = []
    for group in groups:
        place = places[group[0]]
        text = ", ".join(f"{degrees(angles[i]):.0f}°" for i in group[:4]) + (" …" if len(group) > 4 else "")
        labels.append(
            Label(text, place, place / abs(place) if abs(place) * scale > 1 else 1 + 0j, colour=BLUE, size=SMALL, gap=8.0)
        )
    return dots, labels


def _direction(alt: Any, found: Course, frame: Frame, axes: Axes) -> list[Any]:
    """A head on the path between two marks that tells which way it is run through; none on a line run to and fro."""
    spectrum = found.spectrum
    if found.order is not None and phasor.ellipse(complex(spectrum.forward[0]), complex(spectrum.backward[0])).sense == 0:
        return []
    slowest = float(spectrum.orders[np.argmax(np.abs(spectrum.forward) + np.abs(spectrum.backward))])
    at = pi / 4 / slowest if slowest != 1 else pi / 4
    before, place, after = (complex(phasor.value(spectrum, at + step)) for step in (-1e-4, 0, 1e-4))
    way = after - before
    if abs(way) == 0 or _returns(found, place, way):
        return []
    tip = place + 7 / frame.scale * way / abs(way)
    row = {"x2": tip.imag, "y2": tip.real, "bearing": degrees(float(np.angle(way)))}
    x, y = coordinates(frame, axes)
    mark = of_rows([row]).mark_point(shape=HEAD, filled=True, opacity=1, strokeWidth=0, size=240, color=BLUE)
    return [mark.encode(x=x, y=y, angle=alt.Angle("bearing:Q", scale=None))]


def _returns(found: Course, place: complex, way: complex) -> bool:
    """Whether the path runs back through a place in the opposite direction."""
    angles = np.linspace(0, 2 * pi * min(found.turns, MOST_TURNS), 4 * _samples(found))
    path = phasor.value(found.spectrum, angles)
    steps = np.diff(path)
    near = np.abs(path[:-1] - place) <= 2 * np.abs(steps)
    along = np.real(np.conj(way / abs(way)) * steps)
    return bool(np.any(near & (along < -0.9 * np.abs(steps)) & (np.abs(steps) > 0)))


def expressions(spectrum: Spectrum) -> tuple[str, str]:
    """Up and right of a vector as expressions of the parameter theta (degrees)."""
    up, right = phasor.vertical(spectrum), phasor.horizontal(spectrum)
    return tuple(  # pyright: ignore[reportReturnType]
        " + ".join(
            f"({c.real:.12g}) * cos({order:.12g} * theta * PI / 180) - ({c.imag:.12g}) * sin({order:.12g} * theta * PI / 180)"
            for order, c in zip(spectrum.orders.tolist(), amplitudes.tolist(), strict=True)
        )
        or "0"
        for amplitudes in (up, right)
    )


def _now(alt: Any, found: Course, frame: Frame, axes: Axes) -> list[Any]:
    """The vector at the parameter theta: a line from the origin and a dot at its head."""
    x, y = coordinates(frame, axes)
    up, right = expressions(found.spectrum)
    base = of_rows([{"from": 0}]).transform_calculate(x2=right, y2=up)
    line = base.mark_rule(color=VERMILION, strokeWidth=1.5).encode(x=x, y=y, x2=alt.X2("from:Q"), y2=alt.Y2("from:Q"))
    dot = base.mark_point(color=VERMILION, filled=True, opacity=1, size=110, shape="circle").encode(x=x, y=y)
    return [line, dot]
