"""Hodographs: the path of the head of a force or couple vector over a period."""

from __future__ import annotations

from cmath import exp, phase
from math import degrees, pi

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import abreast, half_width, panel_width
from crankstar.charts.choices import Choice, quantity_shown
from crankstar.charts.comparison import compared
from crankstar.charts.crank_angle import waves
from crankstar.charts.drawing import BLUE, GREY, VERMILION, Panel
from crankstar.charts.estimates import axis_ranges, range_text
from crankstar.charts.grammar import DISC, Channel, Chart, Layer, field, of_rows, own
from crankstar.charts.labels import Label, gathered
from crankstar.charts.letters import SMALL
from crankstar.charts.plane import (
    HEAD_STYLE,
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
from crankstar.charts.resting import of_inertia
from crankstar.charts.sums import Engines, Quantity, Sum, in_one_unit, present, several, sums
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE, sizes
from crankstar.spectra import Spectrum
from crankstar.tables.cells import rough

TITLES = {
    "force": (N_("Path of the force of order {order}"), N_("Path of the force, all orders")),
    "couple": (N_("Path of the couple of order {order}"), N_("Path of the couple, all orders")),
}
AXES = {
    "force": (N_("force right ({unit})"), N_("force up ({unit})")),
    "couple": (N_("yaw M_H ({unit})"), N_("pitch M_V ({unit})")),
}
NONE = {
    "force": (N_("no force of order {order}"), N_("no force")),
    "couple": (N_("no couple of order {order}"), N_("no couple")),
}
PATH = N_("Estimated masses or lengths: the path is that of the typical values.")
SEMI_AXES = N_(
    "Estimated masses or lengths: the path is that of the typical values, with the ranges of its "
    "semi-axes."
)
NOW = 110.0
"""Size of the dot at the crank angle theta, px^2."""
MARGIN, SHARE = 34.0, 0.17
"""px around a path, and the share of the width where lengths of semi-axes stand at its sides."""
NEITHER = (N_("no force and no couple of order {order}"), N_("no force and no couple"))


def hodograph(
    engine: Engines,
    *,
    quantity: Quantity | None = None,
    order: float | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
    theta: float = 0.0,
) -> Chart:
    """The path of force or couple over a period, marked every 90 degrees of the crank.

    Without a `quantity` it is the force, or the couple where no force is left.

    A dot is at `theta` (radians). One order is an ellipse, drawn with its semi-axes; without an
    order the sum of all is drawn. Equal scales, in units of m r w^2 or, at a `speed` (rad/s), in N
    and N m. Several engines stand side by side on common axes. Raises ChartError.
    """
    engines = several(engine)
    choice = quantity_shown(engines, quantity, order=order, reference=reference)
    courses = [sums(one, [choice.quantity], speed=speed, reference=reference)[0] for one in engines]
    if order is not None:
        chosen = (spectra.selected(one.spectrum, order) for one in courses)
        pairs = zip(courses, map(present, chosen), strict=True)
        courses = [
            one._replace(
                spectrum=spectrum, ends=tuple(spectra.selected(end, order) for end in one.ends)
            )
            for one, spectrum in pairs
        ]
    courses = in_one_unit(courses)
    width = (panel_width() if abreast(len(engines)) == 1 else half_width()) - 10
    frame = round_frame(
        max(spectra.peak(one.spectrum).value for one in courses),
        width=width,
        margin=MARGIN if order is None else max(MARGIN, SHARE * width),
    )
    axes = Axes(*(_(title, unit=courses[0].unit) for title in AXES[choice.quantity]))
    return compared(
        engines,
        [[[_panel(one, choice, frame, axes, theta)]] for one in courses],
        title=_of_order(TITLES[choice.quantity], order),
        speed=speed,
        theta=theta,
        turns=max(one.turns for one in courses),
        ranges=_(SEMI_AXES if order is not None else PATH),
        rests=of_inertia(
            engines,
            [choice.quantity],
            speed=speed,
            orders=None if order is None else [order],
            reference=reference,
        ),
    )


def _of_order(forms: tuple[str, str], order: float | None) -> str:
    """A sentence with its order, or the one without."""
    single, whole = forms
    return _(whole) if order is None else _(single, order=f"{order:g}")


def _panel(shown: Sum, choice: Choice, frame: Frame, axes: Axes, theta: float) -> Panel:
    order = choice.order
    cross = [
        Stroke((1j * frame.left, 1j * frame.right), width=0.6),
        Stroke((frame.bottom + 0j, frame.top + 0j), width=0.6),
    ]
    if not shown.spectrum.orders.size:
        words = _of_order(NEITHER if choice.nothing else NONE[shown.quantity], order)
        note = empty(frame, words)._replace(direction=1 + 0j, gap=8)
        plane = Plane(strokes=tuple(cross), notes=(note,))
        return picture(plane, frame, theta=theta, axes=axes)
    path = spectra.value(shown.spectrum, np.linspace(0, 2 * pi * shown.turns, _samples(shown)))
    marks, angles_text = _marks(shown, frame.scale)
    now = complex(spectra.value(shown.spectrum, np.array([theta]))[0])
    dots = [mark.at for mark in marks]
    ends, words = ([], []) if order is None else _ellipse_axes(shown, dots, now)
    marked = any(abs(dot - now) * frame.scale < 1 for dot in dots)  # its own label keeps off it
    plane = Plane(
        strokes=(*cross, *ends, Stroke(tuple(path.tolist()), BLUE, 2.0)),
        dots=tuple(marks),
        labels=(*words, *angles_text),
        clear=(Stroke((0j, now)), *(() if marked else (Dot(now, size=NOW),))),
    )
    x, y = coordinates(frame, axes)
    more = [*_direction(shown, order, frame, x, y), *_now(shown.spectrum, x, y)]
    return picture(plane, frame, theta=theta, axes=axes, more=more)


def _samples(shown: Sum) -> int:
    highest = float(shown.spectrum.orders.max()) * shown.turns
    return int(min(max(180, 24 * highest), 4000)) + 1


def _ellipse(spectrum: Spectrum) -> spectra.Ellipse:
    """The path of the first order."""
    return spectra.ellipse(complex(spectrum.forward[0]), complex(spectrum.backward[0]))


def _ellipse_axes(
    whole: Sum, dots: list[complex], now: complex
) -> tuple[list[Stroke], list[Label]]:
    """The axes of the ellipse of one order, and the lengths of its semi-axes with their ranges.

    The length stands beyond that end of an axis which is farther from dots and `now`.
    """
    spectrum = whole.spectrum
    shape = _ellipse(spectrum)
    ranges = iter(axis_ranges(spectrum, whole.ends))
    way = exp(1j * shape.bearing)
    strokes, labels = [], []
    circle = shape.semi_major - shape.semi_minor <= NEGLIGIBLE * shape.semi_major
    for length, direction in ((shape.semi_major, way), (shape.semi_minor, -1j * way)):
        ends = next(ranges, None)
        if length <= NEGLIGIBLE * shape.semi_major:
            continue
        strokes.append(Stroke((-length * direction, length * direction), GREY, 1.2, dashed=True))
        if direction == way or not circle:
            text = number(length, digits=5 if length >= 1e3 else 4)
            text = f"{rough(length)}{range_text(ends)}" if ends else text
            tips = (length * direction, -length * direction)
            tip = max(tips, key=lambda tip: (_room(tip, dots), _room(tip, [now])))
            labels.append(Label(text, tip, tip / length))
    return strokes, labels


def _room(tip: complex, places: list[complex]) -> float:
    """The distance of the nearest place in lengths of the axis; of like ones the first is taken."""
    return round(min(abs(place - tip) for place in places) / abs(tip), 6)


def _marks(shown: Sum, scale: float) -> tuple[list[Dot], list[Label]]:
    """Dots every 90 degrees of the crankshaft with their angles; coinciding dots share a label."""
    angles = np.arange(0, 4 * (shown.turns if shown.turns <= 2 else 1)) * pi / 2
    places = spectra.value(shown.spectrum, angles).tolist()
    dots, labels = [], []
    for group in gathered(places, 3 / scale):
        place = places[group[0]]
        text = ", ".join(f"{degrees(angles[i]):.0f}°" for i in group[:4])
        text += " …" if len(group) > 4 else ""
        way = place / abs(place) if abs(place) * scale > 1 else 1 + 0j
        dots.append(Dot(place, size=40))
        labels.append(Label(text, place, way, colour=BLUE, size=SMALL, gap=8.0))
    return dots, labels


def _direction(
    shown: Sum, order: float | None, frame: Frame, x: Channel, y: Channel
) -> list[Layer]:
    """An arrow head on the path in the direction of motion; none on a straight line."""
    spectrum = shown.spectrum
    if order is not None and _ellipse(spectrum).sense == 0:
        return []
    strongest = float(spectrum.orders[np.argmax(sizes(spectrum))])
    before, place, after = spectra.value(
        spectrum, pi / 4 / strongest + np.array([-1e-4, 0, 1e-4])
    ).tolist()
    way = after - before
    if abs(way) == 0 or _returns(shown, place, way):
        return []
    tip = place + 7 / frame.scale * way / abs(way)
    row = {"x2": tip.imag, "y2": tip.real, "bearing": degrees(phase(way))}
    mark = of_rows([row]).mark("point", **HEAD_STYLE, size=240, color=BLUE)
    return [mark.encode(x=x, y=y, angle=own("bearing:Q"))]


def _returns(shown: Sum, place: complex, way: complex) -> bool:
    """Whether the path also passes a place in the opposite direction."""
    angles = np.linspace(0, 2 * pi * shown.turns, 4 * _samples(shown))
    path = spectra.value(shown.spectrum, angles)
    steps = np.diff(path)
    near = np.abs(path[:-1] - place) <= 2 * np.abs(steps)
    along = np.real(np.conj(way / abs(way)) * steps)
    return bool(np.any(near & (along < -0.9 * np.abs(steps)) & (np.abs(steps) > 0)))


def _now(spectrum: Spectrum, x: Channel, y: Channel) -> list[Layer]:
    """The vector at the parameter theta: a line from the origin and a dot at its head."""
    up = waves(spectrum.orders, spectra.vertical(spectrum))
    right = waves(spectrum.orders, spectra.horizontal(spectrum))
    base = of_rows([{"from": 0}]).calculate(x2=right, y2=up)
    line = base.mark("rule", color=VERMILION, strokeWidth=1.5).encode(
        x=x, y=y, x2=field("from"), y2=field("from")
    )
    dot = base.mark("point", **DISC, color=VERMILION, size=NOW).encode(x=x, y=y)
    return [line, dot]
