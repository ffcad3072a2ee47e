"""Stars: the throws of the crankshafts seen from the front, and the vectors of an order."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from math import lcm, pi

import numpy as np

from crankstar.charts.drawing import (
    BLUE,
    GREY,
    HALF,
    TEXT,
    WIDTH,
    Panel,
    checked_angle,
    figure,
    named,
    numbers_text,
)
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label
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
from crankstar.charts.vectors import COLOURS, Quantity, Star, Stars, Vector, heading, stars
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import N_, _
from crankstar.mechanics.excitation import Reference
from crankstar.remedy.loads import loads

TOGETHER = 3.0
"""px: tips closer than this share a label."""
WEIGHTS = 0.62
"""Where counterweights are marked, in crank radii."""
HUB = 0.5
"""Radius of the arrow of rotation, in crank radii."""
AXIS = 1.5
"""Drawn length of the cylinder axes, crank radii."""
MOST_SPELT = 8
"""Labels in a crank star up to which they also name the cylinders."""
ROOM = 90.0
"""Px above and below the stars together, for their labels."""
APART = 3.4
"""Greatest drawn distance of neighbouring shafts, crank radii."""
NONE = {"force": N_("no force of order {order}"), "couple": N_("no couple of order {order}")}


def crank_star(engine: Engine, *, theta: float = 0.0) -> Chart:
    """The throws of every crankshaft seen from the front, at the crank angle `theta` (radians).

    Throws on one ray share a label: their numbers, then those of their cylinders where these
    differ. Thin lines are the cylinder axes, grey dots the counterweights; the arrow at the hub is
    the direction of rotation.
    """
    theta = checked_angle(theta)
    panel, moved = crank_panel(engine, theta=theta)
    subtitle = [engine.name]
    if moved:
        subtitle.append(_("distances between shafts not to scale"))
    title = _("Crank star, seen from the front")
    turns = turns_together(engine)
    return figure([[panel]], title=title, subtitle=subtitle, theta=theta, turns=turns)


def crank_panel(
    engine: Engine, *, theta: float, width: float = WIDTH, room: float = ROOM, title: str = ""
) -> tuple[Panel, bool]:
    """The crank star as a panel, and whether its shafts are drawn closer together."""
    radius = max(throw.radius for shaft in engine.shafts for throw in shaft.throws)
    places, moved = _places(engine, radius)
    axes = _axes(engine, places, radius)
    arrows, dots, labels, strokes = [], [], [], []
    for shaft in engine.shafts:
        centre, rate = places[shaft.name], engine.sense * float(shaft.speed_ratio)
        pins = [throw.radius * exp(1j * throw.angle) for throw in shaft.throws]
        arrows += [Arrow(pin, place=centre, rate=rate, width=3, head=False) for pin in pins]
        dots += [Dot(pin, centre, rate, BLUE, 130) for pin in pins]
        marks = {
            round(weight.angle, 6): weight.angle for weight in shaft.weights if weight.unbalance
        }
        dots += [
            Dot(WEIGHTS * radius * exp(1j * angle), centre, rate, GREY, 170)
            for angle in marks.values()
        ]
        labels += _throw_labels(engine, shaft, centre, rate)
        hub, arrow = _rotation(centre, HUB * radius, 1 if rate > 0 else -1)
        strokes.append(hub)
        arrows.append(arrow)
        dots.append(Dot(0j, centre, 0.0, GREY, 40))
    if len(labels) > MOST_SPELT:
        labels = [label._replace(text=label.text.split("\n")[0]) for label in labels]
    frame = _crank_frame(
        list(places.values()),
        radius,
        [label.text for label in labels],
        axes,
        width=width,
        room=room,
    )
    plane = Plane(tuple(arrows), (*axes, *strokes), tuple(dots), tuple(labels))
    return picture(plane, frame, theta=theta, title=title), moved


def turns_together(engine: Engine) -> int:
    """Turns of the reference crankshaft after which all shafts are back at the start."""
    return lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))


def _throw_labels(engine: Engine, shaft: Shaft, centre: complex, rate: float) -> list[Label]:
    pins = [pin for pin in loads(engine) if pin.shaft == shaft.name]
    out = []
    for ray in _gathered(
        [pin.radius * exp(1j * pin.angle) for pin in pins],
        0.02 * max((p.radius for p in pins), default=1.0),
    ):
        throws = [pins[i].throw for i in ray]
        cylinders = sorted(number for i in ray for number in pins[i].cylinders)
        tip = pins[ray[0]].radius * exp(1j * pins[ray[0]].angle)
        text = numbers_text(throws)
        if cylinders != sorted(throws):
            text = f"{text} ({numbers_text(cylinders) if cylinders else _('none')})"
        out.append(Label(text, tip, tip / abs(tip), rate, centre, gap=11))
    return out


def _gathered(tips: Sequence[complex], near: float) -> list[list[int]]:
    """Indices of points that lie together."""
    groups: list[list[int]] = []
    for index, tip in enumerate(tips):
        home = next((group for group in groups if abs(tips[group[0]] - tip) <= near), None)
        if home is None:
            groups.append([index])
        else:
            home.append(index)
    return groups


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
    bearings = np.linspace(-pi * 0.6, pi * 0.5, 30) * sense
    points = tuple(centre + radius * complex(np.exp(1j * bearing)) for bearing in bearings)
    tip = centre + radius * exp(1j * sense * (bearings[-1] * sense + 0.6))
    return Stroke(points, width=2), Arrow(tip, points[-1], colour=GREY, width=3)


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
    half, upright = width / 2 / scale, max(high + star + room / scale, high + axis + 8 / scale) / 2
    return Frame(
        middle.imag - half, middle.imag + half, middle.real - upright, middle.real + upright, scale
    )


def _places(engine: Engine, radius: float) -> tuple[dict[str, complex], bool]:
    """Where the stars of the shafts stand, and whether they had to be moved together to be seen."""
    places = {shaft.name: complex(shaft.up, shaft.right) for shaft in engine.shafts}
    apart = [abs(a - b) for a, b in combinations(places.values(), 2) if a != b]
    shrunk = min(1.0, APART * radius / min(apart)) if apart else 1.0
    return {name: place * shrunk for name, place in places.items()}, shrunk < 1.0


def vector_star(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    theta: float = 0.0,
    reference: Reference | None = None,
    speed: float | None = None,
) -> Chart:
    """The star of the vectors of an order at the crank angle `theta` (radians).

    One vector for each cylinder, throw and weight.

    Cylinders in a row have the textbook's star, whose vectors' parts along the cylinders are the
    forces; others have one star of the vectors that turn with the crank and one of those against
    it. In m r w^2 |A_k| (times a for couples), or, at a `speed` (rad/s), in N and N m. Vectors that
    coincide share a label. Raises ChartError.
    """
    shown = stars(engine, order=order, quantity=quantity, reference=reference, speed=speed)
    theta = checked_angle(theta)
    return figure(
        [star_panels(shown, reach=shown.reach, theta=theta)],
        title=heading(shown),
        subtitle=[named(engine)],
        theta=theta,
        turns=turns_of(shown.order),
    )


def turns_of(order: float) -> int:
    """Period of an order in turns of the crankshaft."""
    return Fraction(order).limit_denominator(10_000).denominator


def star_margin(shown: Stars) -> float:
    """Px around a star for its labels."""
    return max(
        label_margin([label.text for star in shown.stars for label in tip_labels(star, 1e9)])
        * 0.55,
        26,
    )


def star_panels(
    shown: Stars,
    *,
    reach: float,
    theta: float,
    width: float | None = None,
    margin: float | None = None,
) -> list[Panel]:
    """The one or two panels of a star on a scale that shows vectors up to `reach`."""
    width = width or (WIDTH if len(shown.stars) == 1 else HALF)
    margin = star_margin(shown) if margin is None else margin
    frame = round_frame(reach, width=width, margin=margin, below=BAR)
    return [_star_panel(shown, star, frame, theta) for star in shown.stars]


def _star_panel(shown: Stars, star: Star, frame: Frame, theta: float) -> Panel:
    edge = frame.right * 0.98
    cross = [Stroke((-edge + 0j, edge + 0j), width=0.6), Stroke((-1j * edge, 1j * edge), width=0.6)]
    if shown.axis is not None:
        way = exp(1j * shown.axis)
        cross.append(Stroke((-edge * way, edge * way), width=1.2, dashed=True))
    if not star.vectors:
        note = empty(frame, nothing(shown, star))
        return picture(Plane(notes=(note,)), frame, theta=theta, title=star.title)
    bar, text = scale_bar(frame, shown.unit)
    arrows = [
        Arrow(v.value, rate=star.rate, colour=COLOURS[v.kind])
        for v in sorted(star.vectors, key=lambda v: -abs(v.value))
    ]
    labels = tip_labels(star, frame.scale)
    plane = Plane(tuple(arrows), (*cross, bar), (), tuple(labels), (text,))
    return picture(plane, frame, theta=theta, title=star.title)


def nothing(shown: Stars, star: Star) -> str:
    """The note in a figure without vectors."""
    note = _(NONE[shown.quantity], order=f"{shown.order:g}")
    return "\n".join(filter(None, (note, star.title)))


def tip_labels(star: Star, scale: float) -> list[Label]:
    """Labels beyond the heads of the vectors, longest first; coinciding vectors share one."""
    longest = max((abs(v.value) for v in star.vectors), default=0.0)
    near = min(TOGETHER / scale, longest) if scale < 1e8 else 1e-3 * longest
    groups = _gathered([vector.value for vector in star.vectors], near)
    groups.sort(key=lambda group: -abs(star.vectors[group[0]].value))
    return [_label([star.vectors[i] for i in group], star.rate) for group in groups]


def _label(vectors: Sequence[Vector], rate: float) -> Label:
    value = vectors[0].value
    cylinders = [int(vector.name) for vector in vectors if vector.kind == "cylinder"]
    others = [vector.name for vector in vectors if vector.kind != "cylinder"]
    text = ", ".join([*([numbers_text(cylinders)] if cylinders else []), *others[:2]])
    text += " …" if len(others) > 2 else ""
    colour = COLOURS[vectors[0].kind]
    return Label(text, value, value / abs(value), rate, colour=colour, size=TEXT)
