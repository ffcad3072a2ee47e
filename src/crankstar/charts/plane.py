"""The clock plane as a picture with equal scales.

Arrows and labels that turn with the crank, lines, dots, a scale bar.

All places are complex, `up + i*right`, as the engine is seen from the front: x of the picture is
the imaginary part, y the real part. What turns is given at theta = 0 with its rate, in turns
clockwise per turn of the reference crankshaft; the picture works out where it is at the parameter
`theta`.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, log10
from typing import Any, NamedTuple

from crankstar.charts.drawing import BLUE, GREY, Panel, layered, text_width
from crankstar.charts.grammar import field, of_rows
from crankstar.charts.labels import GAP, Box, Label, apart, box, extent

HEAD = "M0 0L-0.62 2L0.62 2Z"
"""An arrow head with its tip at the origin, pointing up."""
HEAD_SIZE = 110.0
"""Area of the square that is the unit of HEAD, px^2; the head is sqrt(HEAD_SIZE) long."""
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
    """A line through points that stand still."""

    points: tuple[complex, ...]
    colour: str = GREY
    width: float = 1.0
    dashed: bool = False


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
    def width(self) -> float:
        """Px."""
        return (self.right - self.left) * self.scale

    @property
    def height(self) -> float:
        """Px."""
        return (self.top - self.bottom) * self.scale


@dataclass(frozen=True)
class Plane:
    """The drawn contents; `notes` are fixed labels, `labels` make room for each other."""

    arrows: tuple[Arrow, ...] = ()
    strokes: tuple[Stroke, ...] = ()
    dots: tuple[Dot, ...] = ()
    labels: tuple[Label, ...] = ()
    notes: tuple[Label, ...] = ()


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
    text = f"{length:.6g} {unit}"
    label = Label(text, anchor=ends[1], direction=1j)
    across, _ = extent(label)
    middle = ends[1] + 1j * (across + GAP + 2) / frame.scale
    return Stroke(points, width=1.5), Label(text, anchor=middle, direction=0j)


BAR = 26.0
"""px at the foot of a frame for the scale bar."""


def empty(frame: Frame, text: str) -> Label:
    """A text in the middle of a picture that has nothing else to show."""
    return Label(
        text,
        anchor=complex((frame.top + frame.bottom) / 2, (frame.left + frame.right) / 2),
        direction=0j,
    )


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
    x, y = coordinates(frame, axes)
    shown = [
        arrow for arrow in plane.arrows if abs(arrow.end - arrow.start) * frame.scale > SHORTEST
    ]
    segments = [_segment(arrow, theta, frame.scale) for arrow in shown]
    segments += [
        (a * frame.scale, b * frame.scale)
        for s in plane.strokes
        for a, b in zip(s.points, s.points[1:], strict=False)
    ]
    inside = Box(
        complex((frame.top + frame.bottom) / 2, (frame.left + frame.right) / 2) * frame.scale,
        frame.width / 2 + (8 if axes is None else 0),
        frame.height / 2,
    )
    around = [box(note, theta=theta, scale=frame.scale) for note in plane.notes]
    moved = apart(
        plane.labels,
        theta=theta,
        scale=frame.scale,
        strokes=segments[:400],
        within=inside,
        around=around,
    )
    labels = [*plane.notes, *moved]
    layers: list[Any] = []
    for dashed in (False, True):
        rows = [
            row
            for i, s in enumerate(plane.strokes)
            if s.dashed is dashed
            for row in _stroke_rows(i, s)
        ]
        if rows:
            layers.append(_lines(rows, x, y, dashed=dashed))
    layers += _arrow_layers(shown, frame, x, y)
    if plane.dots:
        layers.append(_dots(plane.dots, x, y))
    layers += list(more)
    if labels or not layers:
        layers.append(_texts(labels or [Label("", 0j, 0j)], frame, x, y))
    return layered(layers, width=frame.width, height=frame.height, title=title)


def coordinates(frame: Frame, axes: Axes | None) -> tuple[Any, Any]:
    """The channels x and y of all layers of a picture."""
    across = {"domain": [frame.left, frame.right], "nice": False, "zero": False}
    upward = {"domain": [frame.bottom, frame.top], "nice": False, "zero": False}
    if axes is None:
        return field("x2:Q", scale=across, axis=None), field("y2:Q", scale=upward, axis=None)
    ticks = max(3, int(frame.width / 70))
    x = field("x2:Q", scale=across, title=axes.right, axis={"tickCount": ticks})
    return x, field(
        "y2:Q", scale=upward, title=axes.up, axis={"tickCount": max(3, int(frame.height / 60))}
    )


def _segment(arrow: Arrow, theta: float, scale: float) -> tuple[complex, complex]:
    phase = exp(1j * arrow.rate * theta)
    return (arrow.place + arrow.start * phase) * scale, (arrow.place + arrow.end * phase) * scale


def _stroke_rows(index: int, stroke: Stroke) -> list[dict[str, Any]]:
    return [
        {
            "x2": p.imag,
            "y2": p.real,
            "line": index,
            "at": i,
            "colour": stroke.colour,
            "width": stroke.width,
        }
        for i, p in enumerate(stroke.points)
    ]


def _lines(rows: list[dict[str, Any]], x: Any, y: Any, *, dashed: bool) -> Any:
    mark = of_rows(rows).mark("line", strokeDash=[4, 3] if dashed else [1, 0])
    return mark.encode(
        x=x,
        y=y,
        detail=field("line:N"),
        order=field("at:Q"),
        color=field("colour:N", scale=None),
        strokeWidth=field("width:Q", scale=None),
    )


TURN = {"c": "cos(datum.rate * theta * PI / 180)", "s": "sin(datum.rate * theta * PI / 180)"}
"""A vector (up, right) turned clockwise: up c - right s, up s + right c."""


def _turn(rows: Sequence[Arrow] | Sequence[Dot] | Sequence[Label]) -> dict[str, str]:
    """The cosine and sine of the turn of rows; a figure without rotation needs no parameter."""
    return TURN if any(row.rate for row in rows) else {"c": "1", "s": "0"}


def turned(point: str, *, up: str, right: str) -> dict[str, str]:
    """Expressions x1, y1 for point 1 of a row that turns about the place of the row."""
    return {
        f"x{point}": f"datum.x + datum.{up} * datum.s + datum.{right} * datum.c",
        f"y{point}": f"datum.y + datum.{up} * datum.c - datum.{right} * datum.s",
    }


def _arrow_layers(arrows: Sequence[Arrow], frame: Frame, x: Any, y: Any) -> list[Any]:
    if not arrows:
        return []
    rows = [_arrow_row(arrow, frame.scale) for arrow in arrows]
    base = of_rows(rows).calculate(
        **_turn(arrows),
        **turned("1", up="startUp", right="startRight"),
        **turned("2", up="endUp", right="endRight"),
    )
    colour = field("colour:N", scale=None)
    # the line ends within the head, so that the tip stays sharp
    shaft = base.calculate(
        xe="datum.x2 - (datum.x2 - datum.x1) * datum.cut",
        ye="datum.y2 - (datum.y2 - datum.y1) * datum.cut",
    )
    channels = {"x2": field("xe"), "y2": field("ye")}
    begins = {"x": {**x, "field": "x1"}, "y": {**y, "field": "y1"}}
    lines = shaft.mark("rule").encode(
        **begins, **channels, color=colour, strokeWidth=field("width:Q", scale=None)
    )
    if not any(arrow.head for arrow in arrows):
        return [lines]
    pointed = base.calculate(bearing="atan2(datum.x2 - datum.x1, datum.y2 - datum.y1) * 180 / PI")
    heads = pointed.mark("point", shape=HEAD, filled=True, opacity=1, strokeWidth=0).encode(
        x=x,
        y=y,
        color=colour,
        angle=field("bearing:Q", scale=None),
        size=field("head:Q", scale=None),
    )
    return [lines, heads]


def _arrow_row(arrow: Arrow, scale: float) -> dict[str, Any]:
    length = abs(arrow.end - arrow.start) * scale
    full = HEAD_SIZE**0.5 * (1.0 if arrow.width < 3 else 1.3)
    head = min(full, 0.7 * length) if arrow.head else 0.0
    return {
        "x": arrow.place.imag,
        "y": arrow.place.real,
        "rate": arrow.rate,
        "startUp": arrow.start.real,
        "startRight": arrow.start.imag,
        "endUp": arrow.end.real,
        "endRight": arrow.end.imag,
        "colour": arrow.colour,
        "width": arrow.width,
        "head": head**2,
        "cut": 0.8 * head / length,
    }


def _dots(dots: Sequence[Dot], x: Any, y: Any) -> Any:
    rows = [
        {
            "x": dot.place.imag,
            "y": dot.place.real,
            "rate": dot.rate,
            "up": dot.at.real,
            "right": dot.at.imag,
            "colour": dot.colour,
            "size": dot.size,
        }
        for dot in dots
    ]
    base = of_rows(rows).calculate(**_turn(dots), **turned("2", up="up", right="right"))
    return base.mark("point", filled=True, opacity=1, shape="circle").encode(
        x=x, y=y, color=field("colour:N", scale=None), size=field("size:Q", scale=None)
    )


def _texts(labels: Sequence[Label], frame: Frame, x: Any, y: Any) -> Any:
    rows = [_label_row(label, frame.scale) for label in labels]
    base = of_rows(rows).calculate(**_turn(labels), **turned("2", up="up", right="right"))
    # then away from the point, farther to the sides than up and down, as the text is wide
    base = base.calculate(
        x3="datum.x2 + datum.across * (datum.wayUp * datum.s + datum.wayRight * datum.c)",
        y3="datum.y2 + datum.upright * (datum.wayUp * datum.c - datum.wayRight * datum.s)",
    )
    return base.mark("text", baseline="middle", align="center", lineBreak="\n").encode(
        x={**x, "field": "x3"},
        y={**y, "field": "y3"},
        text=field("text:N"),
        color=field("colour:N", scale=None),
        size=field("size:Q", scale=None),
    )


def _label_row(label: Label, scale: float) -> dict[str, Any]:
    across, upright = extent(label)
    return {
        "x": label.place.imag,
        "y": label.place.real,
        "rate": label.rate,
        "up": label.anchor.real,
        "right": label.anchor.imag,
        "wayUp": label.direction.real,
        "wayRight": label.direction.imag,
        "across": (across + label.gap) * label.away / scale,
        "upright": (upright + label.gap) * label.away / scale,
        "text": label.text,
        "colour": label.colour,
        "size": label.size,
    }


def label_margin(labels: Sequence[str]) -> float:
    """Px that the widest of labels needs beyond the tip of an arrow, up to a third of a panel."""
    return min(max((text_width(text) for text in labels), default=0.0) + 2 * GAP + 4, 70.0)
