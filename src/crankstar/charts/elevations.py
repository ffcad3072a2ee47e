"""The crankshaft from the side: pins and webs, cylinders and weights along it, and their arms."""

from __future__ import annotations

from cmath import exp
from itertools import pairwise
from math import degrees, pi, radians
from typing import Any, NamedTuple

from crankstar.charts.canvas import panel_width
from crankstar.charts.crank_stars import turns_together
from crankstar.charts.drawing import BLUE, GREY, VERMILION, Panel, figure, heading, layered
from crankstar.charts.grammar import COLOUR, Chart, field, of_rows, own, span
from crankstar.charts.letters import SMALL, TEXT, text_width, together
from crankstar.charts.plane import turning
from crankstar.charts.resting import of_layout
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft
from crankstar.language.messages import _
from crankstar.language.numbers import number, numbers_text, unit_text
from crankstar.language.shown_units import Shown, shown
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference
from crankstar.tables.ranges import estimated_paths
from crankstar.tables.scales import scales

ROW = 160.0
"""Height of the row of one shaft, px."""
PIN, JOURNAL = 7.0, 7.0
"""Thickness of pins and journals, px."""
LINE, LINES = 15.0, 4
"""Height of a line of arms, px, and the greatest number of lines."""
HIGH, DIMENSION, CYLINDER = 42.0, -64.0, 62.0
"""px above the axis: a pin that points up, the line of arms, the cylinder numbers."""

SIZED = "balance_shaft.weight.unbalance"
"""The key path of the unbalances of balance shafts in an engine file."""


class Bar(NamedTuple):
    """A bar from `x` to `x2` (px), between two shares of the height of a turning vector (px)."""

    x: float
    x2: float
    rate: float
    colour: str
    width: float
    vector: complex = 0j
    lower: float = 0.0
    upper: float = 0.0


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
    theta = _askew(engine) if theta is None else theta
    reference = reference or default_reference(engine)
    along = along_of(engine)
    several = len(engine.shafts) > 1
    rows = [
        [shaft_panel(engine, shaft, along, reference.z, name=shaft.name if several else "")]
        for shaft in engine.shafts
    ]
    if "pitch" in engine.relative:
        title = _("Crankshaft from the side, front at the left; arms in bore pitches")
    else:
        title = _(
            "Crankshaft from the side, front at the left; arms in {unit}",
            unit=together(unit_text(_lengths(engine).unit)),
        )
    height = _("at θ = {theta}°, heights to scale", theta=f"{degrees(theta):.4g}")
    subtitle = [*heading(engine), height, *_arm_range(engine)]
    turns = turns_together(engine)
    rests = of_layout(engine)
    return figure(rows, title=title, subtitle=subtitle, theta=theta, turns=turns, rests=rests)


def _lengths(engine: Engine) -> Shown:
    """The unit of the arms, and the factor from the engine's own lengths along the shaft."""
    along = scales(engine).along
    if along.unit != "mm":  # in bore pitches, or in crank radii
        return Shown(along.unit, along.factor)
    said = shown("mm", 0.0)  # whatever their size: with SI prefixes drawings are in mm
    return Shown(said.unit, 1000.0 * said.factor)


def arms_unit(engine: Engine) -> str:
    """The unit in which the arms of a shaft are written."""
    return _lengths(engine).unit


def sized_for_estimates(engine: Engine) -> bool:
    """Whether the weights of the balance shafts rest on estimates."""
    return SIZED in estimated_paths(engine)


def _digits(engine: Engine, shaft: Shaft) -> int:
    """The figures of an arm: three where it may rest on estimates."""
    rough = "layout.bore_pitch" in estimated_paths(engine)
    return 3 if rough or (not shaft.throws and sized_for_estimates(engine)) else 4


def _arm_range(engine: Engine) -> list[str]:
    """The line that says how far arms may be off that rest on an estimated bore pitch."""
    source = engine.provenance.get("layout.bore_pitch")
    if source is None or source.status != "estimated" or source.range is None:
        return []
    low, high = (number(end, digits=3) for end in source.range)
    return [_("Estimated bore pitch: arms are {low} to {high} times as long.", low=low, high=high)]


def along_of(engine: Engine) -> Along:
    """Places along the engine over the width of a panel."""
    places = [c.z for c in engine.cylinders]
    places += [item.z for shaft in engine.shafts for item in (*shaft.throws, *shaft.weights)]
    length, margin = max(places) - min(places), 40.0
    scale = (panel_width() - 2 * margin) / length if length else 1.0
    return Along(max(places), scale, margin if length else panel_width() / 2)


def _askew(engine: Engine) -> float:
    """The crank angle at which the first throw is 20 degrees past up."""
    first = next((throw for shaft in engine.shafts for throw in shaft.throws), None)
    return 0.0 if first is None else engine.sense * (radians(20) - first.angle) % (2 * pi)


def shaft_panel(engine: Engine, shaft: Shaft, along: Along, zero: float, *, name: str) -> Panel:
    """One shaft from the side under its `name`, its arms about the plane at `zero`."""
    bars = _bars(engine, shaft, along)
    arms, leaders = _arms(engine, shaft, along, zero)
    texts = [*_cylinder_numbers(engine, shaft, along), *arms]
    foot = min([DIMENSION - 24, *(text["y"] - 10 for text in arms)])
    top = ROW + DIMENSION - 24
    x = field("x:Q", scale=span(0, panel_width()) | {"zero": False}, axis=None)
    upward = {"scale": span(foot, top) | {"zero": False}, "axis": None}
    height = field("y:Q", **upward)
    ends = {"x2": field("x2"), "y2": field("y2"), "color": COLOUR}
    still = of_rows([*_dimension(shaft, along, zero), *leaders]).mark("rule", strokeWidth=1)
    moving = (
        turning(bars, {"h": "datum.vectorUp * datum.c - datum.vectorRight * datum.s"})
        .calculate(y1="datum.h * datum.lower", y2="datum.h * datum.upper")
        .mark("rule", strokeCap="butt", opacity=1)
    )
    words = of_rows(texts).mark("text", baseline="middle", color=GREY)
    return layered(
        [
            still.encode(x=x, y=height, strokeDash=own("dash:N"), **ends),
            moving.encode(x=x, y=field("y1:Q", **upward), strokeWidth=own("width:Q"), **ends),
            words.encode(x=x, y=height, text=field("text:N"), size=own("size:Q")),
        ],
        width=panel_width(),
        height=top - foot,
        title=name,
    )


def _bars(engine: Engine, shaft: Shaft, along: Along) -> list[Bar]:
    """The journals along the axis, interrupted at the pins; throws; weights, heavier broader."""
    gaps = [(b - a) * along.scale for a, b in pairwise(sorted({t.z for t in shaft.throws}))]
    half = max(1.5, min([13.0, *(0.27 * gap for gap in gaps)]))
    rate = engine.sense * float(shaft.speed_ratio)
    pins = [along.at(place) for place in sorted({t.z for t in shaft.throws}, reverse=True)]
    places = [along.at(weight.z) for weight in shaft.weights]
    if not pins and not places:  # a bare shaft, which only turns: as long as the engine
        places = [along.at(cylinder.z) for cylinder in engine.cylinders]
    edges = [min([*pins, *places]) - half - 16]
    edges += [edge for pin in pins for edge in (pin - half, pin + half)]
    edges.append(max([*pins, *places]) + half + 16)
    pairs = zip(edges[::2], edges[1::2], strict=True)
    out = [Bar(a, b, rate, GREY, JOURNAL) for a, b in pairs if b > a]
    radius = max((throw.radius for throw in shaft.throws), default=1.0)
    for throw in shaft.throws:
        vector, x = HIGH * throw.radius / radius * exp(1j * throw.angle), along.at(throw.z)
        web = Bar(x - half, x - half, rate, BLUE, min(5.0, 1.2 * half), vector, 0.0, 1.0)
        pin = web._replace(x=x - half - 2, x2=x + half + 2, width=PIN, lower=1.0)
        out += [web, web._replace(x=x + half, x2=x + half), pin]
    greatest = max((weight.unbalance for weight in shaft.weights), default=0.0)
    for weight in shaft.weights:
        if weight.unbalance > 0:
            vector, x = 0.7 * HIGH * exp(1j * weight.angle), along.at(weight.z)
            width = 4 + 8 * weight.unbalance / greatest
            out.append(Bar(x, x, rate, GREY, width, vector, 0.0, 1.0))
    return out


def _cylinder_numbers(engine: Engine, shaft: Shaft, along: Along) -> list[dict[str, Any]]:
    """The cylinder numbers at their places; cylinders too close together share a label."""
    own = sorted((c for c in engine.cylinders if c.shaft == shaft.name), key=lambda c: -c.z)
    groups: list[tuple[float, str, list[Cylinder]]] = []
    for cylinder in own:
        group, near = [cylinder], groups[-1:]
        for x, text, cylinders in near:
            room = (text_width(text) + text_width(str(cylinder.number))) / 2 + 6
            if along.at(cylinder.z) - x < room:
                group = [*cylinders, cylinder]
                groups.pop()
        middle = sum(along.at(c.z) for c in group) / len(group)
        groups.append((middle, numbers_text([c.number for c in group]), group))
    return [{"x": x, "y": CYLINDER, "text": text, "size": TEXT} for x, text, _group in groups]


def _stations(shaft: Shaft) -> list[float]:
    return sorted({round(item.z, 12) for item in (shaft.throws or shaft.weights)}, reverse=True)


def _dimension(shaft: Shaft, along: Along, zero: float) -> list[dict[str, Any]]:
    """The reference plane, and the line of arms with its ticks."""
    at, places = along.at(zero), [along.at(z) for z in _stations(shaft)]
    ends, solid = [*places, at], {"colour": GREY, "dash": [1, 0]}
    dashed = {"colour": VERMILION, "dash": [3, 3]}
    return [
        {"x": at, "x2": at, "y": DIMENSION - 4, "y2": CYLINDER - 10, **dashed},
        {"x": min(ends), "x2": max(ends), "y": DIMENSION, "y2": DIMENSION, **solid},
        *({"x": x, "x2": x, "y": DIMENSION - 4, "y2": DIMENSION + 4, **solid} for x in places),
    ]


def _arms(
    engine: Engine, shaft: Shaft, along: Along, zero: float
) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """The arms below their ticks, lower where one would cover another, with lines down to them."""
    scale, digits = _lengths(engine).factor, _digits(engine, shaft)
    texts: list[dict[str, Any]] = []
    leaders: list[dict[str, Any]] = []
    taken = [-1e9] * LINES
    for z in _stations(shaft):
        text = number(round((z - zero) * scale, 9), 1.0, digits=digits).replace("-", "−")
        x, half = along.at(z), text_width(text, SMALL) / 2
        line = next((at for at, end in enumerate(taken) if x - half > end + 4), None)
        if line is None:
            continue
        taken[line] = x + half
        y = DIMENSION - 14 - LINE * line
        texts.append({"x": x, "y": y, "text": text, "size": SMALL})
        if line:
            # no number of a higher line may stand on the line down to this one
            taken[:line] = [max(end, x) for end in taken[:line]]
            thin = {"colour": GREY, "dash": [1, 0]}
            leaders.append({"x": x, "x2": x, "y": DIMENSION - 4, "y2": y + 8, **thin})
    return texts, leaders
