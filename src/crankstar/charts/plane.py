"""The clock plane as a picture with equal scales.

Arrows and labels that turn with the crank, lines, dots, a scale bar.

All places are complex, `up + i*right`, as the engine is seen from the front: x of the picture is
the imaginary part, y the real part. What turns is given at theta = 0 with its rate, in turns
clockwise per turn of the reference crankshaft; the picture works out where it is at the parameter
`theta`.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, floor, log10, pi
from typing import Any, NamedTuple

from crankstar.charts.drawing import BLUE, GREY, Panel, checked_angle, layered
from crankstar.charts.grammar import COLOUR, DISC, Channel, Layer, field, of_rows, own, span
from crankstar.charts.labels import GAP, Box, Label, apart, box, extent
from crankstar.charts.letters import text_width

HEAD = "M0 0L-0.62 2L0.62 2Z"
"""An arrow head with its tip at the origin, pointing up."""
HEAD_SIZE = 110.0
"""Area of the square that is the unit of HEAD, px^2; the head is sqrt(HEAD_SIZE) long."""
HEAD_STYLE = {"shape": HEAD, "filled": True, "opacity": 1, "strokeWidth": 0}
LEADER_DOT = 24.0
"""Size of the dot on the line to which a leader goes, px^2."""
SHORTEST = 0.5
"""px: shorter arrows are not drawn."""


class Arrow(NamedTuple):
    """A vector from `place + start` to `place + end`; start and end turn with `rate`."""

    end: complex
    start: complex = 0j
    place: complex = 0j
    rate: float = 0.0
    colour: str = BLUE
    width: float = 2.0
    head: bool = True


class Stroke(NamedTuple):
    """A line through points that stand still; labels may stand on one that is `faint`."""

    points: tuple[complex, ...]
    colour: str = GREY
    width: float = 1.0
    dashed: bool = False
    faint: bool = False


class Dot(NamedTuple):
    """A mark at `place + at`; `at` turns with `rate`."""

    at: complex
    place: complex = 0j
    rate: float = 0.0
    colour: str = BLUE
    size: float = 60.0


class Frame(NamedTuple):
    """What part of the plane is shown, and its scale in px per unit."""

    left: float
    right: float
    bottom: float
    top: float
    scale: float

    @property
    def middle(self) -> complex:
        """Of the shown part."""
        return complex(self.top + self.bottom, self.right + self.left) / 2

    @property
    def width(self) -> float:
        """Px."""
        return (self.right - self.left) * self.scale

    @property
    def height(self) -> float:
        """Px."""
        return (self.top - self.bottom) * self.scale


@dataclass(frozen=True)
class Plane:
    """The drawn contents; `notes` are fixed labels, `labels` make room for each other.

    Of each of `choices` one label is drawn, the first if it has as much room as the others. `clear`
    are places that further layers draw on and labels leave free.
    """

    arrows: tuple[Arrow, ...] = ()
    strokes: tuple[Stroke, ...] = ()
    dots: tuple[Dot, ...] = ()
    labels: tuple[Label, ...] = ()
    notes: tuple[Label, ...] = ()
    clear: tuple[Stroke | Dot, ...] = ()
    choices: tuple[Sequence[Label], ...] = ()


class Axes(NamedTuple):
    """Titles of the axes to the right and upward."""

    right: str
    up: str


def round_frame(reach: float, *, width: float, margin: float, below: float = 0.0) -> Frame:
    """A frame about the origin for all within `reach`; `margin` px, and `below` px at the foot."""
    scale = (width / 2 - margin) / (reach or 1.0)
    half = width / 2 / scale
    return Frame(-half, half, -half - below / scale, half, scale)


def scale_bar(frame: Frame, unit: str) -> tuple[Stroke, Label]:
    """A bar of a round length at the foot of a frame, and what it is long."""
    longest = min(90.0, frame.width / 3) / frame.scale
    power = 10.0 ** floor(log10(longest))
    length = power * max(step for step in (1, 2, 5) if step * power <= longest * (1 + 1e-9))
    corner = complex(frame.bottom + 8 / frame.scale, frame.left + 2 / frame.scale)
    tick = 4 / frame.scale
    ends = (corner, corner + 1j * length)
    points = (ends[0] + tick, ends[0], ends[1], ends[1] + tick)
    text = Label(f"{length:.6g} {unit}", ends[1], 0j)
    middle = ends[1] + 1j * (extent(text)[0] + GAP + 2) / frame.scale
    return Stroke(points, width=1.5), text._replace(anchor=middle)


BAR = 26.0
"""px at the foot of a frame for the scale bar."""


def empty(frame: Frame, text: str) -> Label:
    """A text in the middle of a picture that has nothing else to show."""
    return Label(text, frame.middle, 0j)


def picture(
    plane: Plane,
    frame: Frame,
    *,
    theta: float = 0.0,
    axes: Axes | None = None,
    title: str = "",
    more: Sequence[Any] = (),
) -> Panel:
    """The plane as a layered chart (one panel); `theta` (radians) is where labels are kept apart.

    `more` are further layers.
    """
    checked_angle(theta)
    x, y = coordinates(frame, axes)
    scale = frame.scale
    shown = [arrow for arrow in plane.arrows if abs(arrow.end - arrow.start) * scale > SHORTEST]
    segments = [_segment(arrow, theta) for arrow in shown]
    unseen = [each for each in plane.clear if isinstance(each, Stroke)]
    faint: list[tuple[complex, complex]] = []
    for stroke in (*plane.strokes, *unseen):
        (faint if stroke.faint else segments).extend(pairwise(stroke.points))
    aside = 3 if axes is None else 0
    moved = apart(
        (*map(tuple, plane.choices), *((label,) for label in plane.labels)),
        theta=theta,
        scale=scale,
        strokes=tuple((start * scale, end * scale) for start, end in segments),
        within=Box(frame.middle * scale, frame.width / 2 + aside, frame.height / 2),
        around=(
            *(box(note, theta=theta, scale=scale) for note in plane.notes),
            *(around(dot, scale) for dot in plane.clear if isinstance(dot, Dot)),
        ),
        faint=tuple((start * scale, end * scale) for start, end in faint),
    )
    labels = [*plane.notes, *moved]
    layers = [*_lines(plane.strokes, x, y), *_arrow_layers(shown, scale, x, y)]
    if plane.dots:
        places = turning(plane.dots, _turned("2", "at"))
        dots = places.mark("point", **DISC)
        layers.append(dots.encode(x=x, y=y, color=COLOUR, size=own("size:Q")))
    layers += more
    if labels or not layers:
        layers += _texts(labels or [Label("", 0j, 0j)], scale, x, y)
    return layered(layers, width=frame.width, height=frame.height, title=title)


def coordinates(frame: Frame, axes: Axes | None) -> tuple[Channel, Channel]:
    """The channels x and y of all layers of a picture."""
    across = {"scale": span(frame.left, frame.right) | {"zero": False}, "axis": None}
    upward = {"scale": span(frame.bottom, frame.top) | {"zero": False}, "axis": None}
    if axes is not None:
        across |= {"title": axes.right, "axis": {"values": _ticks(frame)}}
        upward |= {"title": axes.up, "axis": {"tickCount": max(3, int(frame.height / 60))}}
    return field("x2:Q", **across), field("y2:Q", **upward)


def _ticks(frame: Frame) -> list[float]:
    """Round values along the foot of a frame, as close as their numbers allow."""
    power = 10.0 ** floor(log10((frame.right - frame.left) / 20))
    for step in (power * factor for factor in (1, 2, 5, 10, 20, 50)):
        places = range(ceil(frame.left / step), floor(frame.right / step) + 1)
        values = [float(f"{place * step:.9g}") for place in places]
        wide = max((text_width(f"−{value:.9g}") for value in values), default=0.0)
        if step * frame.scale > wide + BETWEEN_TICKS or len(values) <= 3:
            return values
    return [0.0]


BETWEEN_TICKS = 12.0
"""px between the numbers of an axis."""


def _segment(arrow: Arrow, theta: float) -> tuple[complex, complex]:
    phase = exp(1j * arrow.rate * theta)
    return arrow.place + arrow.start * phase, arrow.place + arrow.end * phase


def around(dot: Dot, scale: float) -> Box:
    """The square about a dot that stands still, px."""
    half = (dot.size / pi) ** 0.5
    return Box((dot.place + dot.at) * scale, half, half)


def _lines(strokes: Sequence[Stroke], x: Channel, y: Channel) -> list[Layer]:
    """The lines that are not dashed, then those that are."""
    layers = []
    for dashed in (False, True):
        rows = [
            {"x2": point.imag, "y2": point.real, "line": line, "at": at, "colour": stroke.colour}
            | {"width": stroke.width}
            for line, stroke in enumerate(strokes)
            if stroke.dashed is dashed
            for at, point in enumerate(stroke.points)
        ]
        mark = of_rows(rows).mark("line", strokeDash=[4, 3] if dashed else [1, 0])
        order = {"detail": field("line:N"), "order": field("at:Q")}
        if rows:
            layers.append(mark.encode(x=x, y=y, **order, color=COLOUR, strokeWidth=own("width:Q")))
    return layers


def turning(
    items: Sequence[Any],
    formulas: dict[str, str],
    more: Callable[[Any], dict[str, Any]] = lambda _: {},
) -> Layer:
    """The items and `more` of each as rows; of a complex number `at` two fields, atUp and atRight.

    Then the cosine c and the sine s of the turn of each, and what formulas make of them. A figure
    without rotation needs no parameter.
    """
    rows = []
    for item in items:
        row: dict[str, Any] = {}
        for name, value in (item._asdict() | more(item)).items():
            if isinstance(value, complex):
                row |= {f"{name}Up": value.real, f"{name}Right": value.imag}
            else:
                row[name] = value
        rows.append(row)
    turn = TURN if any(item.rate for item in items) else {"c": "1", "s": "0"}
    return of_rows(rows).calculate(**turn, **formulas)


TURN = {"c": "cos(datum.rate * theta * PI / 180)", "s": "sin(datum.rate * theta * PI / 180)"}
"""A vector (up, right) turned clockwise: up c - right s, up s + right c."""


def _turned(point: str, vector: str) -> dict[str, str]:
    """Expressions x1, y1 for point 1 of a row: a vector that turns about the place of the row."""
    up, right = f"datum.{vector}Up", f"datum.{vector}Right"
    return {
        f"x{point}": f"datum.placeRight + {up} * datum.s + {right} * datum.c",
        f"y{point}": f"datum.placeUp + {up} * datum.c - {right} * datum.s",
    }


def _arrow_layers(arrows: Sequence[Arrow], scale: float, x: Channel, y: Channel) -> list[Layer]:
    """The lines of arrows, each ended within its head, so that the tip stays sharp; the heads."""

    def head(arrow: Arrow) -> dict[str, float]:
        length = abs(arrow.end - arrow.start) * scale
        full = HEAD_SIZE**0.5 * (1.0 if arrow.width < 3 else 1.3)
        px = min(full, 0.7 * length) if arrow.head else 0.0
        return {"head": px**2, "cut": 0.8 * px / length}

    if not arrows:
        return []
    base = turning(arrows, _turned("1", "start") | _turned("2", "end"), head)
    shaft = base.calculate(
        xe="datum.x2 - (datum.x2 - datum.x1) * datum.cut",
        ye="datum.y2 - (datum.y2 - datum.y1) * datum.cut",
    )
    lines = shaft.mark("rule").encode(
        x={**x, "field": "x1"},
        y={**y, "field": "y1"},
        x2=field("xe"),
        y2=field("ye"),
        color=COLOUR,
        strokeWidth=own("width:Q"),
    )
    if not any(arrow.head for arrow in arrows):
        return [lines]
    pointed = base.calculate(bearing="atan2(datum.x2 - datum.x1, datum.y2 - datum.y1) * 180 / PI")
    heads = pointed.mark("point", **HEAD_STYLE)
    style = {"color": COLOUR, "angle": own("bearing:Q"), "size": own("head:Q")}
    return [lines, heads.encode(x=x, y=y, **style)]


def _texts(labels: Sequence[Label], scale: float, x: Channel, y: Channel) -> list[Layer]:
    """The labels away from their points, farther to the sides than up and down: text is wide.

    Those that are led have a thin line from the point to the nearest edge of the text.
    """

    def room(label: Label) -> dict[str, float]:
        halves = [half / scale for half in extent(label)]
        across, upright = (half + label.gap / scale for half in halves)
        return {"across": across, "upright": upright, "wide": halves[0], "high": halves[1]}

    up, right = "datum.directionUp", "datum.directionRight"
    moved = {
        "offRight": f"datum.across * ({up} * datum.s + {right} * datum.c)",
        "offUp": f"datum.upright * ({up} * datum.c - {right} * datum.s)",
        "x3": "datum.x2 + datum.offRight",
        "y3": "datum.y2 + datum.offUp",
    }
    edge = {"x4": _beyond("x2", "offRight", "wide"), "y4": _beyond("y2", "offUp", "high")}
    base = turning(labels, _turned("2", "anchor"), room).calculate(**moved)
    words = base.mark("text", baseline="middle", align="center", lineBreak="\n").encode(
        x={**x, "field": "x3"},
        y={**y, "field": "y3"},
        text=field("text:N"),
        color=COLOUR,
        size=own("size:Q"),
    )
    led = [label for label in labels if label.led]
    if not led:
        return [words]
    leaders = turning(led, _turned("2", "anchor"), room).calculate(**moved, **edge)
    ends = {"x2": field("x4"), "y2": field("y4")}
    drawn = [leaders.mark("rule", strokeWidth=0.7).encode(x=x, y=y, **ends, color=COLOUR)]
    if any(label.beside for label in led):
        sides = [label for label in led if label.beside]
        dots = turning(sides, _turned("2", "anchor")).mark("point", **DISC, size=LEADER_DOT)
        drawn.append(dots.encode(x=x, y=y, color=COLOUR))
    return [*drawn, words]


def _beyond(point: str, off: str, half: str) -> str:
    """An expression for a point that is moved off, but stops at the edge of a text."""
    size = f"abs(datum.{off})"
    return f"datum.{point} + datum.{off} / max({size}, 1e-12) * max({size} - datum.{half}, 0)"


def label_margin(labels: Sequence[str]) -> float:
    """Px that the widest of labels needs beyond the tip of an arrow, up to a third of a panel."""
    return min(max((text_width(text) for text in labels), default=0.0) + 2 * GAP + 4, 70.0)
