"""The crank star: the throws of the crankshafts seen from the front."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from itertools import combinations
from math import lcm, pi

import numpy as np

from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import BLUE, GREY, Panel, figure, heading
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label, gathered
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, Stroke, label_margin, picture
from crankstar.charts.resting import of_layout
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import _
from crankstar.language.numbers import numbers_text
from crankstar.remedy.loads import loads

WEIGHTS = 0.62
"""Where counterweights are marked, in crank radii."""
HUB = 0.5
"""Radius of the arrow of rotation, in crank radii."""
ARROW = 0.55 * pi
"""Radians past up at which its head begins."""
AXIS = 1.5
"""Drawn length of the cylinder axes, crank radii."""
MOST_SPELT = 8
"""Labels in a crank star up to which they also name the cylinders."""
ROOM = 90.0
"""Px above and below the stars together, for their labels."""
APART = 3.4
"""Greatest drawn distance of neighbouring shafts, crank radii."""


def crank_star(engine: Engine, *, theta: float = 0.0) -> Chart:
    """The throws of every crankshaft seen from the front, at the crank angle `theta` (radians).

    Throws on one ray share a label: their numbers, then those of their cylinders where these
    differ. Thin lines are the cylinder axes, grey dots the counterweights; the arrow at the hub is
    the direction of rotation.
    """
    panel, moved = crank_panel(engine, theta=theta)
    subtitle = heading(engine)
    if moved:
        subtitle.append(_("distances between shafts not to scale"))
    title = _("Crank star, seen from the front")
    turns = turns_together(engine)
    rests = of_layout(engine)
    return figure([[panel]], title=title, subtitle=subtitle, theta=theta, turns=turns, rests=rests)


def crank_panel(
    engine: Engine, *, theta: float, width: float | None = None, room: float = ROOM, title: str = ""
) -> tuple[Panel, bool]:
    """The crank star as a panel, and whether its shafts are drawn closer together."""
    width = panel_width() if width is None else width
    radius = max(throw.radius for shaft in engine.shafts for throw in shaft.throws)
    places, moved = _places(engine, radius)
    axes = _axes(engine, places, radius)
    arrows, dots, labels, strokes = [], [], [], []
    for shaft in engine.shafts:
        centre, rate = places[shaft.name], engine.sense * float(shaft.speed_ratio)
        pins = [throw.radius * exp(1j * throw.angle) for throw in shaft.throws]
        arrows += [Arrow(pin, place=centre, rate=rate, width=3, head=False) for pin in pins]
        dots += [Dot(pin, centre, rate, BLUE, 130) for pin in pins]
        marks = {round(weight.angle, 6) for weight in shaft.weights if weight.unbalance}
        spots = [WEIGHTS * radius * exp(1j * angle) for angle in sorted(marks)]
        dots += [Dot(place, centre, rate, GREY, 170) for place in spots]
        labels += _throw_labels(engine, shaft, centre, rate)
        hub, arrow = _rotation(centre, HUB * radius, 1 if rate > 0 else -1)
        strokes.append(hub)
        arrows.append(arrow)
        dots.append(Dot(0j, centre, 0.0, GREY, 40))
    if len(labels) > MOST_SPELT:
        labels = [label._replace(text=label.text.split(" (")[0]) for label in labels]
    texts = [label.text for label in labels]
    frame = _crank_frame([*places.values()], radius, texts, axes, width=width, room=room)
    plane = Plane(tuple(arrows), (*axes, *strokes), tuple(dots), tuple(labels))
    return picture(plane, frame, theta=theta, title=title), moved


def turns_together(engine: Engine) -> int:
    """Turns of the reference crankshaft after which all shafts are back at the start."""
    return lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))


def _throw_labels(engine: Engine, shaft: Shaft, centre: complex, rate: float) -> list[Label]:
    pins = [pin for pin in loads(engine) if pin.shaft == shaft.name]
    tips = [pin.radius * exp(1j * pin.angle) for pin in pins]
    out = []
    for ray in gathered(tips, 0.02 * max(map(abs, tips), default=1.0)):
        throws = [pins[i].throw for i in ray]
        cylinders = sorted(number for i in ray for number in pins[i].cylinders)
        tip, text = tips[ray[0]], numbers_text(throws)
        if cylinders != sorted(throws):
            text = f"{text} ({numbers_text(cylinders) if cylinders else _('none')})"
        out.append(Label(text, tip, tip / abs(tip), rate, centre, gap=11))
    return out


def _axes(engine: Engine, places: dict[str, complex], radius: float) -> list[Stroke]:
    """The cylinder axes outward from the shaft, of engines with more than one row."""
    lines = {(c.shaft, round(c.bearing, 6), round(c.offset, 9)) for c in engine.cylinders}
    if len(lines) == 1:
        return []
    out = []
    for name, bearing, offset in sorted(lines):
        way = exp(1j * bearing)
        foot = places[name] + offset * 1j * way
        out.append(Stroke((foot, foot + AXIS * radius * way), width=1, dashed=True))
    return out


def _rotation(centre: complex, radius: float, sense: int) -> tuple[Stroke, Arrow]:
    """A small arc about a hub with a head that shows the direction of rotation."""
    ring = centre + radius * np.exp(1j * np.linspace(-0.6 * pi, ARROW, 30) * sense)
    *points, begin = ring.tolist()
    tip = centre + radius * exp(1j * sense * (ARROW + 0.4))
    return Stroke((*points, begin), width=2), Arrow(tip, begin, colour=GREY, width=3)


def _crank_frame(
    centres: Sequence[complex],
    radius: float,
    texts: Sequence[str],
    axes: Sequence[Stroke],
    *,
    width: float,
    room: float,
) -> Frame:
    ups, rights = [c.real for c in centres], [c.imag for c in centres]
    high, wide = max(ups) - min(ups), max(rights) - min(rights)
    margin, star, axis = label_margin(texts), 2.2 * radius, 2 * AXIS * radius if axes else 0.0
    scale = min(
        (width - 2 * margin) / (wide + star),
        width / (wide + axis or 1e-9),
        (width + 30) / (high + max(axis, star)),
    )
    middle = complex(max(ups) + min(ups), max(rights) + min(rights)) / 2
    half = width / 2 / scale
    upright = max(high + star + room / scale, high + axis + 8 / scale) / 2
    return Frame(
        middle.imag - half, middle.imag + half, middle.real - upright, middle.real + upright, scale
    )


def _places(engine: Engine, radius: float) -> tuple[dict[str, complex], bool]:
    """Where the stars of the shafts stand, and whether they had to be moved together to be seen."""
    places = {shaft.name: complex(shaft.up, shaft.right) for shaft in engine.shafts}
    apart = [abs(a - b) for a, b in combinations(places.values(), 2) if a != b]
    shrunk = min(1.0, APART * radius / min(apart)) if apart else 1.0
    return {name: place * shrunk for name, place in places.items()}, shrunk < 1.0
