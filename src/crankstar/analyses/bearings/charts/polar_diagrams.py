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
from math import degrees, pi
from typing import Literal, NamedTuple, get_args

import numpy as np

from crankstar import spectra
from crankstar.analysis.assumptions import MAIN_OF, PIN_OF
from crankstar.charts.canvas import BETWEEN, figure_width, half_width
from crankstar.charts.crank_angle import waves
from crankstar.charts.drawing import BLUE, ORANGE, VERMILION, Panel, brief, figure, heading
from crankstar.charts.estimates import ends_of, estimate_lines, peak_range, range_text
from crankstar.charts.gas_curves import about as about_gas
from crankstar.charts.grammar import DISC, Chart, Layer, field, of_rows
from crankstar.charts.labels import Label, gathered
from crankstar.charts.letters import SMALL, folded, together
from crankstar.charts.plane import Dot, Frame, Plane, Stroke, coordinates, empty, picture
from crankstar.charts.polar_grid import Grid, ground, polar_grid, values
from crankstar.charts.resting import of_loads
from crankstar.charts.sums import MOST_TURNS, checked_quantity
from crankstar.dynamics.bearings import BearingLoads, Model, bearing_loads
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import N_, _
from crankstar.language.numbers import numbers_text, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Complex, Peak, Spectrum

Loaded = Literal["main-bearing", "main-journal", "crank-pin", "crank-pin-journal"]
"""What the load acts on: bearings or pins in the frame of the block, or turning with the shaft."""
OF_LOADS = {name: MAIN_OF if name.startswith("main") else PIN_OF for name in get_args(Loaded)}
"""The loads of a figure by their name in the record of what an answer rests on."""
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
MARKS = N_("ring: the greatest load; line: the load at θ; dots: θ = 0°, 90°, 180°, 270°")
PATHS = N_(
    "Estimated masses or lengths: greatest loads have their ranges; paths and circles are those of "
    "the typical values."
)
MODELS = {
    "determinate": N_("crankshaft hinged at each main bearing"),
    "continuous": N_("crankshaft as one beam on all main bearings"),
}
MANY = 9
"""Panels up to which three stand in a row; of more, four."""
MOST = 48
"""Greatest number of panels, unless another one is asked for."""
WIDER = 1.25
"""Width of three panels in a row, in widths of a figure."""
NARROWEST = 130.0
"""px: least width of a panel; where panels would be narrower, fewer stand in a row."""
DOT, SUMMIT, NOW = 28.0, 150.0, 60.0
"""Sizes of the dots every 90 degrees, of the ring at the greatest load, and of the dot at theta,
px^2."""
GAP = 9.0
"""px between the middle of a dot and its crank angle."""
SAMPLES = 181
VISIBLE = 1e-4
"""Share of the greatest order below which an order does not move the drawn vector."""


class Loading(NamedTuple):
    """A loaded bearing or pin: its shaft, its words, its load, its peak, and the dashed directions.

    `ends` are the loads in the middle and at the corners of the ranges of an estimated engine.
    """

    shaft: Shaft
    name: str
    load: Spectrum
    top: Peak
    directions: tuple[float, ...]
    ends: tuple[Spectrum, ...] = ()


@dataclass(frozen=True)
class Scale:
    """What all panels share: the grid, and the factor to the shown unit."""

    grid: Grid
    factor: float

    @property
    def frame(self) -> Frame:
        """Of a panel."""
        return self.grid.frame


def polar_loads(
    engine: Engine,
    *,
    quantity: Loaded = "main-bearing",
    model: Model = "determinate",
    speed: float | None = None,
    theta: float = 0.0,
    most: int = MOST,
    gas: bool = False,
    point: str | None = None,
    off: Sequence[int] = (),
) -> Chart:
    """The load on each main bearing, or of the rods on each crank pin, over a turn of the crank.

    With `gas` over a cycle, at an operating point, with cylinders that are `off`.

    `quantity`: in the frame of the block, or turning with the shaft (`main-journal`,
    `crank-pin-journal`). A dot every 90 degrees of the reference crankshaft; a ring at the
    greatest load, whose length and crank angle stand above. The line goes to the load at `theta`
    (radians). One scale, in N at `speed` (rad/s), without one in m r w^2. Of more than
    `most` loads the greatest are drawn. Raises ChartError.
    """
    checked_quantity(quantity, Loaded)

    def make(each: Engine) -> Cycle | None:
        return cycle(each, point=point or "", speed=speed, off=off) if gas else None

    found = make(engine)
    loads = bearing_loads(engine, speed=speed, model=model, cycle=found)
    others = [
        bearing_loads(each, speed=speed, model=model, cycle=found) for each in ends_of(engine)
    ]
    every = list(_loadings(engine, loads, others, quantity))
    loadings = _greatest(every, most)
    # each shaft begins a row, unless these are the greatest of all shafts
    groups = _by_shaft(loadings) if len(loadings) == len(every) else [loadings]
    largest = max(loading.top.value for loading in loadings)
    said = shown(loads.unit, largest)
    columns, side = _columns(max(map(len, groups)), most=3 if len(loadings) <= MANY else 4)
    turning = quantity in TURNING
    scale = Scale(polar_grid(largest * said.factor, side=side), said.factor)
    rows = [
        [
            _panel(loading, head, scale, largest, turning=turning, theta=theta)
            for loading, head in zip(row, _heads(row, scale, largest, side), strict=True)
        ]
        for row in _rows(groups, columns)
    ]
    about = [
        _(MODELS[model]) if quantity.startswith("main") else "",
        _(MARKS) if largest else "",
        _("the {count} greatest of {all}", count=most, all=len(every)) if len(every) > most else "",
        _(DASHED[quantity]) if DASHED[quantity] and any(one.directions for one in loadings) else "",
    ]
    lines = ["; ".join(filter(None, about)), *estimate_lines([engine], drawn=_(PATHS))]
    return figure(
        rows,
        title=_(TITLES[quantity], unit=together(unit_text(said.unit))),
        subtitle=[
            *(heading(engine, speed=speed) if found is None else about_gas(engine, found)),
            *filter(None, lines),
        ],
        theta=theta,
        turns=max(_turns(loading, turning=turning) for loading in loadings),
        rests=of_loads(engine, make, OF_LOADS[quantity], speed=speed, model=model),
    )


def _columns(count: int, *, most: int) -> tuple[int, float]:
    """How many of so many panels stand in a row, and the width of each, px."""
    if count <= 2:
        return count, half_width()
    row = WIDER * figure_width() * (1 if most == 3 else 4 / 3)
    columns = min(count, most)
    while columns > 2 and (row - BETWEEN * (most - 1)) / most < NARROWEST:
        most -= 1
        columns = min(count, most)
    return columns, (row - BETWEEN * (most - 1)) / most


def _loadings(
    engine: Engine, loads: BearingLoads, others: Sequence[BearingLoads], quantity: Loaded
) -> Iterator[Loading]:
    """The loaded bearings or pins, shaft by shaft from the front; `others` at ends of ranges."""
    several = len({bearing.shaft for bearing in loads.bearings}) > 1
    turning = quantity in TURNING
    if quantity.startswith("main"):
        tops = spectra.tops(loads.load)
        for index, bearing in enumerate(loads.bearings):
            shaft = engine.shaft(bearing.shaft)
            ahead = [t for t in shaft.throws if t.z > bearing.z]
            behind = [t for t in shaft.throws if t.z <= bearing.z]
            near = [*ahead[-1:], *behind[:1]] if turning else []
            words = _("bearing {number}", number=bearing.number)
            name = f"{shaft.name}: {words}" if several else words
            angles = tuple(dict.fromkeys(round(throw.angle, 9) for throw in near))
            ends = tuple(other.load[index] for other in others)
            yield Loading(shaft, name, loads.load[index], tops[index], angles, ends)
        return
    several = len({pin.shaft for pin in loads.pins}) > 1
    bearings = {cylinder.number: cylinder.bearing for cylinder in engine.cylinders}
    tops = spectra.tops(loads.pin)
    for index, pin in enumerate(loads.pins):
        shaft = engine.shaft(pin.shaft)
        words = _("pin {number}", number=pin.throw)
        if list(pin.cylinders) != [pin.throw]:
            words = f"{words} ({numbers_text(pin.cylinders)})"
        name = f"{shaft.name}: {words}" if several else words
        axes = (round(bearings[number], 9) for number in pin.cylinders)
        angles = (shaft.throws[pin.throw - 1].angle,) if turning else tuple(dict.fromkeys(axes))
        ends = tuple(other.pin[index] for other in others)
        yield Loading(shaft, name, loads.pin[index], tops[index], angles, ends)


def _head(loading: Loading, scale: Scale, largest: float, side: float) -> list[str]:
    """The name of a panel, and its greatest load with the crank angle, in lines."""
    top = loading.top
    if top.value <= NEGLIGIBLE * largest:
        return folded(loading.name, width=side)
    angle = brief(round(degrees(top.theta), 6))
    between = peak_range(
        spectra.scaled(loading.load, scale.factor),
        [spectra.scaled(end, scale.factor) for end in loading.ends],
    )
    size = f"{brief(top.value * scale.factor)}{range_text(between)}"
    words = _("{size} at {angle}°", size=size, angle=angle)
    return [*folded(loading.name, width=side), *folded(words, width=side)]


def _angles(turns: int) -> np.ndarray:
    return np.linspace(0, 2 * pi * turns, SAMPLES * turns)


def _greatest(loadings: Sequence[Loading], most: int) -> list[Loading]:
    """The greatest loads, up to `most`, in their order."""
    if len(loadings) <= most:
        return list(loadings)
    peaks = [loading.top.value for loading in loadings]
    top = max(peaks) or 1.0
    kept = sorted(range(len(peaks)), key=lambda place: -round(peaks[place] / top, 9))[:most]
    return [loadings[place] for place in sorted(kept)]


def _by_shaft(loadings: Sequence[Loading]) -> list[list[Loading]]:
    names = dict.fromkeys(loading.shaft.name for loading in loadings)
    return [[one for one in loadings if one.shaft.name == name] for name in names]


def _rows(groups: Sequence[list[Loading]], columns: int) -> Iterator[list[Loading]]:
    """The loads in rows; each group begins a row."""
    for own in groups:
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
    top = loading.top
    if top.value <= NEGLIGIBLE * largest:
        nothing = Plane(notes=(empty(frame, _("no load")),))
        return picture(nothing, frame, theta=theta, title=head)
    strokes = list(ground(scale.grid, loading.directions))
    turns = _turns(loading, turning=turning)

    def at(angles: np.ndarray) -> list[complex]:
        vectors = load_vectors(loading, angles, turning=turning) * scale.factor
        return [complex(vector) for vector in vectors]

    path = Stroke(tuple(at(_angles(turns))), BLUE, 1.8)
    dots, labels = _marks(at(np.arange(4) * (pi / 2)), scale)
    summit, here = at(np.array([top.theta, theta]))
    line, now, ring = Stroke((0j, here)), Dot(here, size=NOW), Dot(summit, size=SUMMIT)
    lines = [path, line, *(stroke for stroke in strokes if not stroke.faint)]
    plane = Plane(
        strokes=(*strokes, path),
        dots=tuple(dots),
        labels=tuple(labels),
        notes=tuple(values(scale.grid, lines, [*dots, now, ring])),
        clear=(line, now, ring, *dots),
    )
    more = [_ring(summit, scale), *_now(loading, scale, turning=turning)]
    return picture(plane, frame, theta=theta, title=head, more=more)


def _marks(places: Sequence[complex], scale: Scale) -> tuple[list[Dot], list[Label]]:
    """Dots at 0, 90, 180 and 270 degrees of the reference crankshaft; one label where they meet."""
    dots: list[Dot] = []
    labels: list[Label] = []
    for group in gathered(places, 4 / scale.frame.scale):
        place = places[group[0]]
        text = ", ".join(f"{90 * index}°" for index in group)
        way = place / abs(place) if abs(place) * scale.frame.scale > 2 else 1 + 0j
        dots.append(Dot(place, size=DOT))
        labels.append(Label(text, place, way, colour=BLUE, size=SMALL, gap=GAP))
    return dots, labels


def _ring(summit: complex, scale: Scale) -> Layer:
    """A ring at the greatest load, which is seen about the dot of the load at theta as well."""
    x, y = coordinates(scale.frame, None)
    mark = of_rows([{"x2": summit.imag, "y2": summit.real}])
    style = {**DISC, "filled": False, "size": SUMMIT, "strokeWidth": 2.2, "color": ORANGE}
    return mark.mark("point", **style).encode(x=x, y=y)


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
    return [line, base.mark("point", **DISC, color=VERMILION, size=NOW).encode(x=x, y=y)]
