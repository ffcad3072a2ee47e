"""The bending moment along a crankshaft: its greatest over the turn, and when it is greatest.

The length of the vector M(z, theta) of `dynamics.bearings`, which is the same in the frame of the
block and in the one that turns with the shaft. The envelope is its greatest over the turn at each
place z; the dashed line is the moment at the one crank angle at which it is greatest of all,
measured in the direction in which it is so. Each with counterweights and without: forces on the
block can cancel though the shaft that hands them on is bent.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from math import ceil, degrees, floor, log10
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import (
    BLUE,
    GREY,
    LINES,
    VERMILION,
    Panel,
    brief,
    figure,
    heading,
    layered,
)
from crankstar.charts.estimates import ends_of, estimate_lines, range_text, size_range
from crankstar.charts.grammar import Chart, Layer, field, of_rows, span
from crankstar.charts.letters import SMALL, text_width, together
from crankstar.charts.resting import Rests
from crankstar.dynamics.bearings import Bending, Model, bending_moment
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings
from crankstar.engine.records import Shaft
from crankstar.language.faults import EngineError
from crankstar.language.messages import N_, _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics import bounds
from crankstar.mechanics.bounds import bounds_kept
from crankstar.remedy.counterweights import RemedyError, with_web_weights, without_counterweights
from crankstar.spectra import Real
from crankstar.studies.answer_parts import in_own_unit, narrowed
from crankstar.studies.load_answers import IN_LOADS

FACTOR = 0.5
"""Balance factor of the weights that are compared where the engine file gives none."""
STATES = {
    None: N_("in the end bearings alone: what the crankshaft bears inside"),
    "determinate": N_("hinged at each main bearing"),
    "continuous": N_("one beam on all main bearings"),
}
RANGES = N_(
    "Estimated masses or lengths: peaks have their ranges; lines are those of the typical values."
)
HEIGHT = 112.0
"""Height of a panel, px."""
NUMBERS = 50.0
"""px for the numbers of the axis, the same in every panel, with room for wider letters."""
FOOT = 0.16
"""Share of a panel below its axis, for the bearings and the throws."""


class Course(NamedTuple):
    """A bending moment along a shaft [place]: its envelope, and what it is at its worst moment.

    `reach` is the range of its greatest value, if the engine has ranges.
    """

    label: str
    colour: str
    z: Real
    envelope: Real
    momentary: Real
    theta: float
    unit: str
    reach: tuple[float, float] | None = None

    @property
    def greatest(self) -> float:
        """Of all places and crank angles."""
        return float(self.envelope.max(initial=0.0))


def bending_chart(
    engine: Engine, *, model: Model | None = None, speed: float | None = None
) -> Chart:
    """The bending moment along every crankshaft, with its counterweights and without.

    Panels: the shaft in its two end bearings, and in all main bearings by the `model`, or by both
    models where none is named and there is one crankshaft. The engine is compared with bare
    crankshafts; one without counterweights with usual ones, on all webs by a balance factor of a
    half. N m at `speed` (rad/s), without one m r w^2 a. Raises ChartError.
    """
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    models: tuple[Model, ...] = (model,) if model else ("determinate", "continuous")
    states: list[Model | None] = [None, *(models if len(cranks) == 1 else models[:1])]
    pairs = list(_compared(engine))
    others = [own for own in map(list, map(_compared, ends_of(engine))) if len(own) == len(pairs)]
    rows = list(zip(pairs, *others, strict=True))
    blocks: list[tuple[Shaft, Model | None, list[Course]]] = [
        (shaft, state, [_course(own, ends, shaft.name, state, speed) for own, *ends in rows])
        for shaft in cranks
        for state in states
    ]  # fmt: skip
    courses = [course for _shaft, _state, each in blocks for course in each]
    largest = max(course.greatest for course in courses)
    said = shown(courses[0].unit, largest)
    panels = [
        _panel(engine, shaft, state, each, said.factor, several=len(cranks) > 1, first=not index)
        for index, (shaft, state, each) in enumerate(blocks)
    ]
    title = _("Bending moment of the crank, in {unit}", unit=together(unit_text(said.unit)))
    about = _("solid: greatest over the turn; dashed: at the crank angle of its peak")
    marks = _("triangles: main bearings; numbers: throws; front at the left")
    lines = [
        *heading(engine, speed=speed),
        about,
        marks,
        *estimate_lines([engine], drawn=_(RANGES)),
    ]
    rests = Rests([engine], partial(_bent, speed=speed, models=states), "bearings")
    return figure([[panel] for panel in panels], title=title, subtitle=lines, rests=rests)


def _bent(_engine: Engine, *, speed: float | None, models: Sequence[Model | None]) -> Answer:
    """What the figure says; an engine without counterweights is compared with usual ones."""
    made = bent(speed=speed, models=models)
    made = in_own_unit(made) if speed is None else made
    return narrowed(made, ["end bending", "main bending"], given=["crankshaft.weight"])


class Compared(NamedTuple):
    """An engine in words, and the colour of its lines."""

    label: str
    colour: str
    engine: Engine


def _compared(engine: Engine) -> Iterator[Compared]:
    """The engine without and with counterweights, in words; one engine where these are the same."""
    bare = without_counterweights(engine)
    weighted = any(shaft.weights for shaft in engine.shafts if shaft.throws)
    yield Compared(_("without weights"), VERMILION, bare)
    if weighted:
        yield Compared(_("with its weights"), BLUE, engine)
        return
    try:
        usual = with_web_weights(engine, factor=FACTOR)
    except (RemedyError, EngineError):  # too many weights for a crankshaft, or none fit
        return
    label = _("with weights, balance factor {factor}", factor=f"{FACTOR:g}")
    yield Compared(label, BLUE, usual)


def _course(
    own: Compared, ends: Sequence[Compared], shaft: str, state: Model | None, speed: float | None
) -> Course:
    bendings = [
        bending_moment(each.engine, shaft=shaft, speed=speed, model=state) for each in (own, *ends)
    ]
    with bounds_kept():
        tops = [bounds.highest(bending.moment) for bending in bendings]
    course = course_of(bendings[0], label=own.label, colour=own.colour)
    return course._replace(reach=size_range(tops[0], tops[1:]))


def course_of(bending: Bending, *, label: str = "", colour: str = BLUE) -> Course:
    """The envelope of a bending moment, and the moment along the shaft when it is greatest.

    >>> from crankstar.files.catalog import load
    >>> course = course_of(bending_moment(load("i4")))
    >>> bool(np.isclose(course.greatest, np.abs(course.momentary).max()))
    True
    """
    envelope = spectra.peaks(bending.moment)
    worst = int(np.argmax(envelope >= envelope.max() * (1 - 1e-9)))
    top = spectra.peak(bending.moment[worst])
    momentary = np.zeros(envelope.shape)
    if top.value:
        vectors = spectra.value(bending.moment, top.theta)
        momentary = np.real(np.conj(top.vector / top.value) * vectors)
    z = np.asarray(bending.z)
    return Course(label, colour, z, envelope, momentary, top.theta, bending.unit)


def _panel(
    engine: Engine,
    shaft: Shaft,
    state: Model | None,
    courses: Sequence[Course],
    factor: float,
    *,
    several: bool,
    first: bool,
) -> Panel:
    """One state of one shaft: the courses over z, front at the left, the bearings below."""
    width, height = panel_width(), curve_height(HEIGHT)
    z = courses[0].z
    room = 0.03 * (z[0] - z[-1]) or 1.0
    along = {"scale": span(z[0] + room, z[-1] - room) | {"zero": False}, "axis": None}
    top = 1.06 * factor * max(course.greatest for course in courses) or 1.0
    low = min(0.0, factor * min(float(course.momentary.min()) for course in courses))
    foot = low - FOOT * (top - low)
    scale = span(foot, top) | {"zero": False}
    upward = {
        "scale": scale,
        "title": None,
        "axis": {"values": _ticks(low, top), "minExtent": NUMBERS},
    }
    labels = [course.label for course in courses]
    colours = {"domain": labels, "range": [course.colour for course in courses]}
    legend = {**LINES, "columns": 1, "labelLimit": width} if first else None
    x = field("z:Q", **along)
    y = field("value:Q", **upward)
    colour = field("label:N", scale=colours, legend=legend)
    layers: list[Layer] = [
        of_rows([{"z": z[0] + room, "z2": z[-1] - room, "value": 0.0}])
        .mark("rule", color=GREY, strokeWidth=1)
        .encode(x=x, x2=field("z2"), y=y)
    ]
    for name, dash, thick in (("envelope", [1, 0], 2.2), ("momentary", [5, 3], 1.3)):
        rows = [
            {"z": place, "value": value * factor, "label": course.label}
            for course in courses
            for place, value in zip(course.z.tolist(), getattr(course, name).tolist(), strict=True)
        ]
        line = of_rows(rows).mark("line", strokeDash=dash, strokeWidth=thick)
        layers.append(line.encode(x=x, y=y, color=colour))
    layers += _places(engine, shaft, x, upward, (foot, low, top), width / (z[0] - z[-1] + 2 * room))
    return layered(
        layers,
        width=width,
        height=height,
        title=_head(shaft, state, courses, factor, several=several),
    )


def _ticks(low: float, top: float) -> list[float]:
    """Round values between the least and the greatest, three to six of them."""
    power = 10.0 ** floor(log10((top - low) / 3))
    step = next(s * power for s in (1, 2, 5, 10) if (top - low) / (s * power) < 4.5)
    return [float(f"{n * step:.9g}") for n in range(ceil(low / step), floor(top / step) + 1)]


def _head(
    shaft: Shaft, state: Model | None, courses: Sequence[Course], factor: float, *, several: bool
) -> str:
    """What a panel shows, and the peak of each course with its crank angle."""
    words = _(STATES[state])
    if several:
        words = f"{shaft.name}, {words}"
    peaks = " / ".join(
        _("{size} at {angle}°", size=f"{brief(course.greatest * factor)}{_range(course, factor)}",
          angle=brief(round(degrees(course.theta), 6)))
        if course.greatest else "0"
        for course in courses
    )  # fmt: skip
    return "\n".join([words, _("peak {peaks}", peaks=peaks)])


def _range(course: Course, factor: float) -> str:
    """The range of the peak of a course."""
    reach = course.reach
    return range_text(reach and (reach[0] * factor, reach[1] * factor))


def _places(
    engine: Engine,
    shaft: Shaft,
    x: dict[str, Any],
    upward: dict[str, Any],
    ends: tuple[float, float, float],
    scale: float,
) -> Iterator[Layer]:
    """The main bearings as triangles below the axis, and the numbers of the throws between them."""
    foot, low, _top = ends
    y = field("y:Q", **upward)
    bearings = [{"z": place, "y": low} for place in main_bearings(engine, shaft)]
    shape = {"shape": "triangle-up", "filled": True, "opacity": 1, "color": GREY, "size": 60}
    yield of_rows(bearings).mark("point", **shape, yOffset=6).encode(x=x, y=y)
    numbers: list[dict[str, Any]] = []
    taken = -1e9
    for number, throw in sorted(enumerate(shaft.throws, 1), key=lambda each: -each[1].z):
        half = text_width(str(number), SMALL) / 2 + 2
        at = -throw.z * scale
        if at - half > taken:
            numbers.append({"z": throw.z, "y": foot, "text": str(number)})
            taken = at + half
    words = of_rows(numbers).mark("text", baseline="bottom", fontSize=SMALL, color=GREY)
    yield words.encode(x=x, y=y, text=field("text:N"))


def bent(*, speed: float | None = None, models: Sequence[Any] = (None,)) -> Answer:
    """The greatest bending moment of a crankshaft in its end bearings (None), or by models in all.

    At a `speed` (rad/s), else at that of each engine.
    """

    def bendings(each: Engine, model: Any) -> list[Any]:
        own = each.speed if speed is None else speed
        return [
            bending_moment(each, shaft=shaft.name, speed=own, model=model)
            for shaft in each.shafts
            if shaft.throws
        ]

    def figures(each: Engine) -> Figures:
        out: dict[Figure, float] = {}
        for model in models:
            name = "end bending" if model is None else "main bending"
            peaks = [spectra.peaks(one.moment).max(initial=0.0) for one in bendings(each, model)]
            out[name, None] = max(out.get((name, None), 0.0), *map(float, peaks))
        return out

    return Answer(
        figures=figures,
        unit=lambda _quantity, each: bendings(each, None)[0].unit,
        uses=("inertia", "bearings"),
        gasless=IN_LOADS,
    )
