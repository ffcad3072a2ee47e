"""The crankshaft from the side: pins and webs, cylinders and weights along it, and their arms."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, degrees, pi, radians, sin
from typing import Any, NamedTuple

from crankstar.charts.drawing import (
    BLUE,
    GREY,
    SMALL,
    TEXT,
    VERMILION,
    WIDTH,
    Panel,
    checked_angle,
    figure,
    layered,
    numbers_text,
    text_width,
)
from crankstar.charts.grammar import Chart, field, of_rows
from crankstar.charts.stars import turns_together
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference

ROW = 150.0
"""Height of the row of one shaft, px."""
PIN, JOURNAL = 7.0, 7.0
"""Thickness of pins and journals, px."""
HIGH, DIMENSION, CYLINDER = 42.0, -64.0, 62.0
"""px above the axis: a pin that points up, the line of arms, the cylinder numbers."""
EXPRESSION = (
    "datum.up * cos(datum.rate * theta * PI / 180)"
    " - datum.right * sin(datum.rate * theta * PI / 180)"
)
"""The height of a point of a shaft that is `up`, `right` of its axis at theta = 0."""


class Along(NamedTuple):
    """Places along the engine on the screen, front at the left: (front - z) * scale + margin."""

    front: float
    scale: float
    margin: float

    def at(self, z: float) -> float:
        """Px from the left edge."""
        return (self.front - z) * self.scale + self.margin


def shaft_elevation(
    engine: Engine, *, reference: Reference | None = None, theta: float | None = None
) -> Chart:
    """Every shaft from the side at the crank angle `theta` (radians), the front at the left.

    The height of a pin is the upward component of its crank radius. By default the first throw is
    20 degrees past up, where cranks at right angles have different heights. Above are the cylinder
    numbers, below the arms of the throws (or weights) about the reference plane (dashed).
    """
    theta = _askew(engine) if theta is None else checked_angle(theta)
    reference = reference or default_reference(engine)
    places = (
        [c.z for c in engine.cylinders]
        + [t.z for s in engine.shafts for t in s.throws]
        + [w.z for s in engine.shafts for w in s.weights]
    )
    span = max(places) - min(places)
    margin = 40.0
    along = Along(
        max(places), (WIDTH - 2 * margin) / span if span else 1.0, margin if span else WIDTH / 2
    )
    several = len(engine.shafts) > 1
    rows = [
        [_shaft_panel(engine, shaft, along, reference.z, name=shaft.name if several else "")]
        for shaft in engine.shafts
    ]
    if "pitch" in engine.relative:
        title = _("Crankshaft from the side, front at the left; arms in bore pitches")
    else:
        title = _("Crankshaft from the side, front at the left; arms in mm")
    return figure(
        rows,
        title=title,
        subtitle=[
            engine.name,
            _("at θ = {theta}°, heights to scale", theta=f"{degrees(theta):.4g}"),
        ],
        theta=theta,
        turns=turns_together(engine),
    )


def _askew(engine: Engine) -> float:
    """The crank angle at which the first throw is 20 degrees past up."""
    first = next((throw for shaft in engine.shafts for throw in shaft.throws), None)
    return 0.0 if first is None else engine.sense * (radians(20) - first.angle) % (2 * pi)


def _shaft_panel(engine: Engine, shaft: Shaft, along: Along, zero: float, *, name: str) -> Panel:
    radius = max((throw.radius for throw in shaft.throws), default=1.0)
    bars = [
        *_journals(engine, shaft, along),
        *_throws(engine, shaft, along, radius),
        *_weights(engine, shaft, along),
    ]
    texts = [*_cylinder_numbers(engine, shaft, along), *_arms(engine, shaft, along, zero)]
    lines = _dimension(shaft, along, zero)
    x = field("x:Q", scale={"domain": [0, WIDTH], "nice": False, "zero": False}, axis=None)
    scale = {"domain": [DIMENSION - 24, ROW + DIMENSION - 24], "nice": False, "zero": False}
    y = field("y1:Q", scale=scale, axis=None)
    colour = field("colour:N", scale=None)
    height = field("y:Q", scale=scale, axis=None)
    ends = {"x2": field("x2"), "y2": field("y2"), "color": colour}
    dash = field("dash:N", scale=None)
    still = (
        of_rows(lines).mark("rule", strokeWidth=1).encode(x=x, y=height, strokeDash=dash, **ends)
    )
    moving = (
        of_rows(bars)
        .calculate(h=EXPRESSION)
        .calculate(y1="datum.h * datum.lower", y2="datum.h * datum.upper")
        .mark("rule", strokeCap="butt", opacity=1)
        .encode(x=x, y=y, strokeWidth=field("width:Q", scale=None), **ends)
    )
    words = of_rows(texts).mark("text", baseline="middle")
    words = words.encode(
        x=x, y=height, text=field("text:N"), size=field("size:Q", scale=None), color=colour
    )
    return layered([still, moving, words], width=WIDTH, height=ROW, title=name)


def _bar(
    x: float,
    x2: float,
    *,
    vector: complex,
    between: tuple[float, float],
    rate: float,
    colour: str,
    width: float,
) -> dict[str, Any]:
    """A bar from x to x2 (px) between two shares of the height of a turning vector (px)."""
    return {
        "x": x,
        "x2": x2,
        "up": vector.real,
        "right": vector.imag,
        "rate": rate,
        "lower": between[0],
        "upper": between[1],
        "colour": colour,
        "width": width,
    }


def _half_pin(shaft: Shaft, along: Along) -> float:
    """Half the length of a pin on the screen, limited by its closest neighbours, px."""
    places = sorted({throw.z for throw in shaft.throws})
    gaps = [(b - a) * along.scale for a, b in pairwise(places)]
    return max(1.5, min([13.0, *(0.27 * gap for gap in gaps)]))


def _rate(engine: Engine, shaft: Shaft) -> float:
    return engine.sense * float(shaft.speed_ratio)


def _journals(engine: Engine, shaft: Shaft, along: Along) -> list[dict[str, Any]]:
    """The journals along the axis, interrupted at the pins."""
    half = _half_pin(shaft, along)
    points = [along.at(place) for place in sorted({t.z for t in shaft.throws}, reverse=True)]
    places = [along.at(weight.z) for weight in shaft.weights]
    if not points and not places:  # a bare shaft, which only turns: as long as the engine
        places = [along.at(cylinder.z) for cylinder in engine.cylinders]
    edges = [min([*points, *places]) - half - 16]
    for point in points:
        edges += [point - half, point + half]
    edges.append(max([*points, *places]) + half + 16)
    pairs = zip(edges[::2], edges[1::2], strict=True)
    return [
        _bar(a, b, vector=0j, between=(0, 0), rate=_rate(engine, shaft), colour=GREY, width=JOURNAL)
        for a, b in pairs
        if b > a
    ]


def _throws(engine: Engine, shaft: Shaft, along: Along, radius: float) -> list[dict[str, Any]]:
    half, rate = _half_pin(shaft, along), _rate(engine, shaft)
    out = []
    for throw in shaft.throws:
        vector = HIGH * throw.radius / radius * complex(cos(throw.angle), sin(throw.angle))
        x = along.at(throw.z)
        web = {"vector": vector, "rate": rate, "colour": BLUE, "width": min(5.0, 1.2 * half)}
        out += [_bar(side, side, between=(0, 1), **web) for side in (x - half, x + half)]
        out.append(
            _bar(
                x - half - 2,
                x + half + 2,
                vector=vector,
                between=(1, 1),
                rate=rate,
                colour=BLUE,
                width=PIN,
            )
        )
    return out


def _weights(engine: Engine, shaft: Shaft, along: Along) -> list[dict[str, Any]]:
    """Weights as bars in their direction; the heavier, the broader."""
    greatest = max((weight.unbalance for weight in shaft.weights), default=0.0)
    out = []
    for weight in shaft.weights:
        if weight.unbalance > 0:
            vector = 0.7 * HIGH * complex(cos(weight.angle), sin(weight.angle))
            x, width = along.at(weight.z), 4 + 8 * weight.unbalance / greatest
            out.append(
                {
                    **_bar(
                        x,
                        x,
                        vector=vector,
                        between=(0, 1),
                        rate=_rate(engine, shaft),
                        colour=GREY,
                        width=width,
                    ),
                    "of": "weight",
                }
            )
    return out


def _cylinder_numbers(engine: Engine, shaft: Shaft, along: Along) -> list[dict[str, Any]]:
    """The cylinder numbers at their places; cylinders too close together share a label."""
    own = sorted((c for c in engine.cylinders if c.shaft == shaft.name), key=lambda c: -c.z)
    groups: list[list[Any]] = []
    for cylinder in own:
        x = along.at(cylinder.z)
        if groups and x - _middle(groups[-1], along) < _room(groups[-1], cylinder):
            groups[-1].append(cylinder)
        else:
            groups.append([cylinder])
    return [
        {
            "x": _middle(g, along),
            "y": CYLINDER,
            "text": numbers_text([c.number for c in g]),
            "size": TEXT,
            "colour": GREY,
        }
        for g in groups
    ]


def _middle(group: Sequence[Any], along: Along) -> float:
    return sum(along.at(cylinder.z) for cylinder in group) / len(group)


def _room(group: Sequence[Any], cylinder: Any) -> float:
    texts = (numbers_text([c.number for c in group]), str(cylinder.number))
    return sum(text_width(text) for text in texts) / 2 + 6


def _stations(shaft: Shaft) -> list[float]:
    return sorted({round(item.z, 12) for item in (shaft.throws or shaft.weights)}, reverse=True)


def _dimension(shaft: Shaft, along: Along, zero: float) -> list[dict[str, Any]]:
    """The reference plane, and the line of arms with its ticks."""
    at = along.at(zero)
    plane = {
        "x": at,
        "x2": at,
        "y": DIMENSION - 4,
        "y2": CYLINDER - 10,
        "colour": VERMILION,
        "dash": [3, 3],
    }
    ends = [along.at(z) for z in _stations(shaft)] + [at]
    line = {
        "x": min(ends),
        "x2": max(ends),
        "y": DIMENSION,
        "y2": DIMENSION,
        "colour": GREY,
        "dash": [1, 0],
    }
    ticks = [
        {
            "x": end,
            "x2": end,
            "y": DIMENSION - 4,
            "y2": DIMENSION + 4,
            "colour": GREY,
            "dash": [1, 0],
        }
        for end in ends[:-1]
    ]
    return [plane, line, *ticks]


def _arms(engine: Engine, shaft: Shaft, along: Along, zero: float) -> list[dict[str, Any]]:
    """The arms below their ticks, where there is room."""
    scale = 1.0 if "pitch" in engine.relative else 1000.0
    out: list[dict[str, Any]] = []
    taken = -1e9
    for z in _stations(shaft):
        text = number(round((z - zero) * scale, 9), 1.0, digits=4).replace("-", "−")
        x, half = along.at(z), text_width(text, SMALL) / 2
        if x - half > taken + 3:
            out.append({"x": x, "y": DIMENSION - 14, "text": text, "size": SMALL, "colour": GREY})
            taken = x + half
    return out
