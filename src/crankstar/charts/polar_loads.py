"""Polar diagrams of the loads on main bearings and crank pins over a turn, to one scale.

The load is what a journal pushes on its bearing, or the rods on their crank pin, from inertia and
weights (`dynamics.bearings`). In the frame of the block the head of the vector L(theta) goes round
the bearing shell; in the frame that turns with its shaft, at n turns per turn of the reference
crankshaft in the sense s,

    L(theta) exp(-i s n theta),

it goes round the journal: where it is far out, the same side of the journal wears. Both frames
stand alike at theta = 0, and lengths are the same in both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import cos, degrees, floor, log10, pi, sin
from typing import Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import BETWEEN, figure_width, half_width
from crankstar.charts.crank_angle import waves
from crankstar.charts.drawing import (
    BLUE,
    ORANGE,
    VERMILION,
    Panel,
    brief,
    figure,
    named,
    numbers_text,
)
from crankstar.charts.grammar import DISC, Chart, Layer, field, of_rows
from crankstar.charts.labels import Label, gathered
from crankstar.charts.letters import SMALL, folded
from crankstar.charts.plane import Dot, Frame, Plane, Stroke, coordinates, empty, picture
from crankstar.charts.sums import MOST_TURNS, checked_quantity
from crankstar.dynamics.bearings import BearingLoads, Model, bearing_loads
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import N_, _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Complex, Spectrum

Loaded = Literal["main-bearing", "main-journal", "crank-pin", "crank-pin-journal"]
"""What the load acts on: bearings or pins in the frame of the block, or turning with the shaft."""
TURNING = ("main-journal", "crank-pin-journal")
TITLES = {
    "main-bearing": N_("Loads on the main bearings, in {unit}"),
    "main-journal": N_("Loads on the main bearings, turning with the crankshaft, in {unit}"),
    "crank-pin": N_("Loads of the rods on the crank pins, in {unit}"),
    "crank-pin-journal": N_(
        "Loads of the rods on the crank pins, turning with the crankshaft, in {unit}"
    ),
}
DASHED = {
    "main-bearing": "",
    "main-journal": N_("dashed: the throws beside it at θ = 0"),
    "crank-pin": N_("dashed: the cylinder axes"),
    "crank-pin-journal": N_("dashed: the throw at θ = 0"),
}
MODELS = {
    "determinate": N_("crankshaft hinged at each main bearing"),
    "continuous": N_("crankshaft as one beam on all main bearings"),
}
MANY = 9
"""Panels up to which three stand in a row; of more, four."""
MOST = 48
"""Greatest number of panels; of more loads the greatest are drawn."""
WIDER = 1.25
"""Width of three panels in a row, in widths of a figure."""
ASIDE, ABOVE = 31.0, 19.0
"""px beside, and above and below the paths, for the crank angles at their dots."""
TALLEST = 1.3
"""Greatest height of a panel, in its widths."""
SAMPLES = 361
VISIBLE = 1e-4
"""Share of the greatest order below which an order does not move the drawn vector."""


class Loading(NamedTuple):
    """A loaded bearing or pin: its shaft, its words, its load, and the dashed directions."""

    shaft: Shaft
    name: str
    load: Spectrum
    directions: tuple[float, ...]


@dataclass(frozen=True)
class Scale:
    """What all panels share: the frame, the circles, px and the factor to the shown unit."""

    frame: Frame
    ring: float
    factor: float


def polar_loads(
    engine: Engine,
    *,
    quantity: Loaded = "main-bearing",
    model: Model = "determinate",
    speed: float | None = None,
    theta: float = 0.0,
) -> Chart:
    """The load on each main bearing, or of the rods on each crank pin, over a turn of the crank.

    `quantity`: in the frame of the block, or turning with the shaft (`main-journal`,
    `crank-pin-journal`). A dot every 90 degrees of the reference crankshaft; a large dot at the
    greatest load, whose length and crank angle stand above. The line goes to the load at `theta`
    (radians). One scale, in N at `speed` (rad/s), without one in m r w^2. Raises ChartError.
    """
    checked_quantity(quantity, Loaded)
    loads = bearing_loads(engine, speed=speed, model=model)
    every = list(_loadings(engine, loads, quantity))
    loadings = _greatest(every)
    largest = max(spectra.peak(loading.load).value for loading in loadings)
    said = shown(loads.unit, largest)
    columns = min(_most(loadings), 3 if len(loadings) <= MANY else 4)
    side = WIDER * (figure_width() - 2 * BETWEEN) / 3 if columns > 2 else half_width()
    turning = quantity in TURNING
    frame = _frame(loadings, said.factor, side=side, turning=turning)
    scale = Scale(frame, _ring(largest * said.factor), said.factor)
    rows = [
        [
            _panel(loading, head, scale, largest, turning=turning, theta=theta)
            for loading, head in zip(row, _heads(row, scale, largest, side), strict=True)
        ]
        for row in _rows(loadings, columns)
    ]
    about = [
        _(MODELS[model]) if quantity.startswith("main") else "",
        _("circles every {step} {unit}", step=brief(scale.ring), unit=unit_text(said.unit))
        if largest
        else "",
        _("large dot: the greatest load") if largest else "",
        _("the {count} greatest of {all}", count=MOST, all=len(every)) if len(every) > MOST else "",
        _(DASHED[quantity]) if DASHED[quantity] and any(one.directions for one in loadings) else "",
    ]
    return figure(
        rows,
        title=_(TITLES[quantity], unit=unit_text(said.unit)),
        subtitle=[named(engine), "; ".join(filter(None, about))],
        theta=theta,
        turns=max(_turns(loading, turning=turning) for loading in loadings),
    )


def _loadings(engine: Engine, loads: BearingLoads, quantity: Loaded) -> Iterator[Loading]:
    """The loaded bearings or pins, shaft by shaft from the front."""
    several = len({bearing.shaft for bearing in loads.bearings}) > 1
    turning = quantity in TURNING
    if quantity.startswith("main"):
        for index, bearing in enumerate(loads.bearings):
            shaft = engine.shaft(bearing.shaft)
            ahead = [t for t in shaft.throws if t.z > bearing.z]
            behind = [t for t in shaft.throws if t.z <= bearing.z]
            near = [*ahead[-1:], *behind[:1]] if turning else []
            words = _("bearing {number}", number=bearing.number)
            name = f"{shaft.name}: {words}" if several else words
            angles = tuple(dict.fromkeys(round(throw.angle, 9) for throw in near))
            yield Loading(shaft, name, loads.load[index], angles)
        return
    several = len({pin.shaft for pin in loads.pins}) > 1
    bearings = {cylinder.number: cylinder.bearing for cylinder in engine.cylinders}
    for index, pin in enumerate(loads.pins):
        shaft = engine.shaft(pin.shaft)
        words = _("pin {number}", number=pin.throw)
        if list(pin.cylinders) != [pin.throw]:
            words = f"{words} ({numbers_text(pin.cylinders)})"
        name = f"{shaft.name}: {words}" if several else words
        axes = (round(bearings[number], 9) for number in pin.cylinders)
        angles = (shaft.throws[pin.throw - 1].angle,) if turning else tuple(dict.fromkeys(axes))
        yield Loading(shaft, name, loads.pin[index], angles)


def _ring(reach: float) -> float:
    """A round step of which one to three circles lie within the reach."""
    if not reach > 0:
        return 1.0
    power = 10.0 ** floor(log10(reach))
    return next(step for step in (0.5 * power, power, 2 * power, 5 * power) if reach < 3.5 * step)


def _head(loading: Loading, scale: Scale, largest: float, side: float) -> list[str]:
    """The name of a panel, and its greatest load with the crank angle, in lines."""
    top = spectra.peak(loading.load)
    if top.value <= NEGLIGIBLE * largest:
        return folded(loading.name, width=side)
    angle = brief(round(degrees(top.theta), 6))
    words = _("{size} at {angle}°", size=brief(top.value * scale.factor), angle=angle)
    return [*folded(loading.name, width=side), *folded(words, width=side)]


def _angles(turns: int) -> np.ndarray:
    return np.linspace(0, 2 * pi * turns, SAMPLES * turns)


def _frame(loadings: Sequence[Loading], factor: float, *, side: float, turning: bool) -> Frame:
    """The frame of all panels: as wide as `side`, and as high as the paths need to one scale."""
    paths = [
        load_vectors(one, _angles(_turns(one, turning=turning)), turning=turning) * factor
        for one in loadings
    ]
    every = np.concatenate([np.zeros(1), *paths])
    across, top, bottom = np.abs(np.imag(every)).max(), np.real(every).max(), np.real(every).min()
    least = 1e-3 * float(np.abs(every).max()) or 1.0
    scale = min(
        (side / 2 - ASIDE) / max(across, least),
        (TALLEST * side - 2 * ABOVE) / max(top - bottom, least),
    )
    half, room = side / 2 / scale, ABOVE / scale
    return Frame(-half, half, float(bottom) - room, float(top) + room, scale)


def _greatest(loadings: Sequence[Loading]) -> list[Loading]:
    """As many of the loads as there is room for, the greatest, in their order."""
    if len(loadings) <= MOST:
        return list(loadings)
    peaks = [spectra.peak(loading.load).value for loading in loadings]
    kept = sorted(range(len(peaks)), key=lambda place: -peaks[place])[:MOST]
    return [loadings[place] for place in sorted(kept)]


def _by_shaft(loadings: Sequence[Loading]) -> list[list[Loading]]:
    names = dict.fromkeys(loading.shaft.name for loading in loadings)
    return [[one for one in loadings if one.shaft.name == name] for name in names]


def _most(loadings: Sequence[Loading]) -> int:
    """The greatest number of loads on one shaft."""
    return max(map(len, _by_shaft(loadings)))


def _rows(loadings: Sequence[Loading], columns: int) -> Iterator[list[Loading]]:
    """The loads in rows; those of each shaft begin a row."""
    for own in _by_shaft(loadings):
        yield from (own[at : at + columns] for at in range(0, len(own), columns))


def _heads(row: Sequence[Loading], scale: Scale, largest: float, side: float) -> list[str]:
    """The heads of the panels of a row, all with as many lines."""
    heads = [_head(loading, scale, largest, side) for loading in row]
    most = max(map(len, heads))
    return ["\n".join([*lines, *[" "] * (most - len(lines))]) for lines in heads]


def _turns(loading: Loading, *, turning: bool) -> int:
    """The drawn period of a load in its frame, in turns of the reference crankshaft."""
    own = spectra.period(loading.load)
    if turning:
        own *= loading.shaft.speed_ratio.denominator
    return min(own, MOST_TURNS)


def load_vectors(loading: Loading, angles: np.ndarray, *, turning: bool) -> Complex:
    """The load at crank angles (radians), in the frame of the block or `turning` with its shaft."""
    rate = loading.load.sense * float(loading.shaft.speed_ratio) if turning else 0.0
    vectors: Complex = spectra.value(loading.load, angles) * np.exp(-1j * rate * angles)
    return vectors


def _panel(
    loading: Loading, head: str, scale: Scale, largest: float, *, turning: bool, theta: float
) -> Panel:
    """The path of one load."""
    frame = scale.frame
    strokes = list(_ground(loading, scale, largest * scale.factor))
    top = spectra.peak(loading.load)
    if top.value <= NEGLIGIBLE * largest:
        nothing = Plane(strokes=tuple(strokes[:2]), notes=(empty(frame, _("no load")),))
        return picture(nothing, frame, theta=theta, title=head)
    turns = _turns(loading, turning=turning)

    def at(angles: np.ndarray) -> list[complex]:
        vectors = load_vectors(loading, angles, turning=turning) * scale.factor
        return [complex(vector) for vector in vectors]

    path = at(_angles(turns))
    dots, labels = _marks(at(np.arange(4) * (pi / 2)), scale)
    summit = Dot(at(np.array([top.theta]))[0], colour=ORANGE, size=90)
    plane = Plane(
        strokes=(*strokes, Stroke(tuple(path), BLUE, 1.8)),
        dots=(*dots, summit),
        labels=tuple(labels),
    )
    more = _now(loading, scale, turning=turning)
    return picture(plane, frame, theta=theta, title=head, more=more)


def _ground(loading: Loading, scale: Scale, reach: float) -> Iterator[Stroke]:
    """The cross, the circles and the dashed directions."""
    frame, ring = scale.frame, scale.ring
    long = reach + 4 / frame.scale
    side = min(long, frame.right)
    yield Stroke((-1j * side, 1j * side), width=0.6)
    yield Stroke((max(-long, frame.bottom) + 0j, min(long, frame.top) + 0j), width=0.6)
    around = np.exp(1j * np.linspace(0, 2 * pi, 181))
    for count in range(1, floor(reach / ring * (1 + 1e-9)) + 1):
        for arc in _inside(count * ring * around, frame):
            yield Stroke(arc, width=0.5)
    for angle in loading.directions:
        way = complex(cos(angle), sin(angle))
        up = frame.top if way.real > 0 else frame.bottom
        reached = min(
            long,
            up / way.real if abs(way.real) > 1e-9 else long,
            frame.right / abs(way.imag) if abs(way.imag) > 1e-9 else long,
        )
        yield Stroke((0j, way * reached), width=1.0, dashed=True)


def _inside(points: Complex, frame: Frame) -> Iterator[tuple[complex, ...]]:
    """The runs of points between the foot and the head of a frame."""
    run: list[complex] = []
    for point in points.tolist():
        if frame.bottom <= point.real <= frame.top and frame.left <= point.imag <= frame.right:
            run.append(point)
            continue
        if len(run) > 1:
            yield tuple(run)
        run = []
    if len(run) > 1:
        yield tuple(run)


def _marks(places: Sequence[complex], scale: Scale) -> tuple[list[Dot], list[Label]]:
    """Dots at 0, 90, 180 and 270 degrees of the reference crankshaft; one label where they meet."""
    dots: list[Dot] = []
    labels: list[Label] = []
    for group in gathered(places, 4 / scale.frame.scale):
        place = places[group[0]]
        text = ", ".join(f"{90 * index}°" for index in group)
        way = place / abs(place) if abs(place) * scale.frame.scale > 2 else 1 + 0j
        dots.append(Dot(place, size=28))
        labels.append(Label(text, place, way, size=SMALL, gap=5.0))
    return dots, labels


def _now(loading: Loading, scale: Scale, *, turning: bool) -> list[Layer]:
    """The load at the parameter theta: a line from the origin, and a dot at its head."""
    load = loading.load
    size = np.abs(load.forward) + np.abs(load.backward)
    kept = size > VISIBLE * size.max()
    exponents = load.sense * load.orders[kept]
    rate = load.sense * float(loading.shaft.speed_ratio) if turning else 0.0
    # the vector is a sum of a exp(i m theta): its parts up and to the right are cosine waves
    rates = np.concatenate([exponents, -exponents]) - rate
    vectors = np.concatenate([load.forward[kept], load.backward[kept]]) * scale.factor
    up, right = waves(rates, vectors), waves(rates, -1j * vectors)
    x, y = coordinates(scale.frame, None)
    base = of_rows([{"from": 0}]).calculate(x2=right, y2=up)
    line = base.mark("rule", color=VERMILION, strokeWidth=1.5).encode(
        x=x, y=y, x2=field("from"), y2=field("from")
    )
    return [line, base.mark("point", **DISC, color=VERMILION, size=60).encode(x=x, y=y)]
