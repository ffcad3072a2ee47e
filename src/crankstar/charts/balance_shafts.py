"""Balance shafts where they lie: from the front beside the crankshaft, and from the side.

From the front, at equal scales: each shaft at its place, its sense of rotation, and its unbalance
as an arrow, as long as it is great, at the crank angle theta. The dashed circle is what the crank
sweeps (`remedy.clearance`). From the side: where its weights stand along it.
"""

from __future__ import annotations

from cmath import exp, phase
from collections.abc import Iterator, Sequence
from math import degrees, pi
from typing import NamedTuple

import numpy as np

from crankstar.charts.canvas import panel_width
from crankstar.charts.crank_stars import turns_together
from crankstar.charts.drawing import BLUE, GREEN, GREY, Panel, brief, figure, heading
from crankstar.charts.elevations import along_of, arms_unit, shaft_panel, sized_for_estimates
from crankstar.charts.estimates import ends_of, estimate_lines, size_range
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label, gathered
from crankstar.charts.letters import SMALL, together
from crankstar.charts.plane import Arrow, Dot, Frame, Plane, Stroke, picture
from crankstar.charts.resting import of_layout
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import default_reference
from crankstar.remedy.clearance import balance_shafts, crank_sweep
from crankstar.tables.scales import scales

HUB = 0.34
"""Radius of the arrow of rotation, in crank radii."""
LONGEST = 0.95
"""Length of the greatest unbalance, in crank radii."""
RANGES = N_(
    "Estimated masses or lengths: unbalances that rest on them are marked; places and arms may "
    "rest on them too."
)
ENDS = {"front": N_("front"), "rear": N_("rear")}
UNBALANCES = {
    "": N_("unbalance {size} at {angle}° when θ = 0"),
    "front": N_("front: unbalance {size} at {angle}° when θ = 0"),
    "rear": N_("rear: unbalance {size} at {angle}° when θ = 0"),
}
"""The unbalance in a direction, which may be that of one end of the shaft."""
MARGIN = 34.0
"""px around the shafts, for their names."""


class Pull(NamedTuple):
    """Weights of a shaft in one direction: up + i right at theta = 0, and the planes z."""

    unbalance: complex
    planes: tuple[float, ...]


def balance_shaft_chart(engine: Engine, *, theta: float = 0.0) -> Chart:
    """The balance shafts from the front and from the side, at the crank angle `theta` (radians).

    Each with its speed ratio, sense, place, unbalance and bearing at theta = 0. An engine without
    balance shafts is drawn with that said.
    """
    own = balance_shafts(engine)
    along = along_of(engine)
    rows: list[list[Panel]] = [[_front(engine, own, theta)]]
    zero = default_reference(engine).z
    ends = [balance_shafts(each) for each in ends_of(engine)]
    for index, shaft in enumerate(own):
        words = _words(engine, shaft, [end[index] for end in ends])
        rows.append([shaft_panel(engine, shaft, along, zero, name=words)])
    about = heading(engine)
    if own:
        about.append(
            _("arrows: unbalance, crank green; thin arrows: sense of rotation; dashed: crank sweep")
        )
        about.append(
            _(
                "below, from the side, front at the left, with the arms of the weights in {unit}",
                unit=together(unit_text(arms_unit(engine))),
            )
        )
    else:
        about.append(_("without balance shafts; `crankstar balance --shafts needed` adds them"))
    about += estimate_lines([engine], drawn=_(RANGES))
    turns = turns_together(engine)
    title = _("Balance shafts, seen from the front")
    rests = of_layout(engine)
    return figure(rows, title=title, subtitle=about, theta=theta, turns=turns, rests=rests)


def pulls(shaft: Shaft) -> list[Pull]:
    """The weights of a shaft, those in one direction together.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_balance_shaft
    >>> twin = with_balance_shaft(load("i2-360"), ratio=-1, planes=[0.5, -0.5])
    >>> [(round(abs(pull.unbalance), 6), pull.planes) for pull in pulls(twin.shafts[-1])]
    [(1.0, (0.5, -0.5))]
    """
    weights = [weight for weight in shaft.weights if weight.unbalance]
    ways = [exp(1j * weight.angle) for weight in weights]
    return [
        Pull(
            sum((weights[i].unbalance * ways[i] for i in group), 0j),
            tuple(weights[i].z for i in group),
        )
        for group in gathered(ways, 1e-6)
    ]


def ends_named(own: Sequence[Pull]) -> list[str]:
    """`front` and `rear` where each of two directions is that of one end of a shaft, else empty.

    >>> ends_named([Pull(1j, (0.5,)), Pull(-1j, (2.0, 1.0))]), ends_named([Pull(1j, (0.5, -0.5))])
    (['rear', 'front'], [''])
    """
    if len(own) != 2:
        return [""] * len(own)
    one, other = own
    if min(one.planes) > max(other.planes):
        return ["front", "rear"]
    return ["rear", "front"] if min(other.planes) > max(one.planes) else ["", ""]


def _front(engine: Engine, own: Sequence[Shaft], theta: float) -> Panel:
    """Crank and balance shafts from the front."""
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    radius = max(throw.radius for shaft in cranks for throw in shaft.throws)
    greatest = max((abs(pull.unbalance) for shaft in own for pull in pulls(shaft)), default=1.0)
    arrows: list[Arrow] = []
    strokes: list[Stroke] = []
    dots: list[Dot] = []
    labels: list[Label] = []
    ends: list[Label] = []
    reach: list[tuple[complex, float]] = []
    for shaft in [*cranks, *own]:
        place, rate = complex(shaft.up, shaft.right), engine.sense * float(shaft.speed_ratio)
        hub, head = _rotation(place, HUB * radius, 1 if rate > 0 else -1)
        strokes.append(hub)
        arrows.append(head)
        dots.append(Dot(0j, place, 0.0, GREY, 40))
        if shaft.throws:
            sweep = crank_sweep(engine, shaft)
            ring = place + sweep * np.exp(1j * np.linspace(0, 2 * pi, 91))
            strokes.append(Stroke(tuple(ring.tolist()), width=0.8, dashed=True))
            pins = {round(throw.angle, 9): throw.radius for throw in shaft.throws}
            arrows += [
                Arrow(size * exp(1j * angle), place=place, rate=rate, colour=GREEN, head=False)
                for angle, size in pins.items()
            ]
            reach.append((place, sweep))
            continue
        ways = pulls(shaft)
        for pull, end in zip(ways, ends_named(ways), strict=True):
            long = LONGEST * radius * pull.unbalance / (greatest or 1.0)
            arrows.append(Arrow(long, place=place, rate=rate, colour=BLUE, width=3.0))
            if end:
                way = long / abs(long)
                ends.append(Label(_(ENDS[end]), long, way, rate, place, BLUE, SMALL))
        reach.append((place, LONGEST * radius))
    for group in gathered([complex(shaft.up, shaft.right) for shaft in own], 0.02 * radius):
        at = complex(own[group[0]].up, own[group[0]].right)
        words = ", ".join(own[i].name for i in group)
        labels.append(Label(words, at, -1 + 0j, gap=LONGEST * 12))
    frame = _frame(reach)
    if not own:
        labels.append(Label(_("no balance shafts"), complex(cranks[0].up, cranks[0].right), 1j))
    plane = Plane(tuple(arrows), tuple(strokes), tuple(dots), (*labels, *ends))
    return picture(plane, frame, theta=theta)


def _frame(reach: Sequence[tuple[complex, float]]) -> Frame:
    """The frame of all that is within these circles."""
    low = complex(*(min(getattr(at, part) - r for at, r in reach) for part in ("real", "imag")))
    high = complex(*(max(getattr(at, part) + r for at, r in reach) for part in ("real", "imag")))
    width = panel_width()
    span = high - low
    scale = min((width - 2 * MARGIN) / span.imag, (1.1 * width - 2 * MARGIN) / span.real)
    middle, half = (low.imag + high.imag) / 2, width / 2 / scale
    room = MARGIN / scale
    return Frame(middle - half, middle + half, low.real - room, high.real + room, scale)


def _rotation(centre: complex, radius: float, sense: int) -> tuple[Stroke, Arrow]:
    """An arc about a shaft with a head that shows its sense of rotation."""
    ring = centre + radius * np.exp(1j * np.linspace(-0.5 * pi, 0.5 * pi, 30) * sense)
    *points, begin = ring.tolist()
    tip = centre + radius * exp(1j * sense * (0.5 * pi + 0.5))
    return Stroke((*points, begin), width=1.4), Arrow(tip, begin, colour=GREY, width=2)


def _words(engine: Engine, shaft: Shaft, ends: Sequence[Shaft]) -> str:
    """Name, ratio, sense, place, and unbalance of each direction with its bearing.

    `ends` are the shaft in the middle and at the corners of the ranges of the engine.
    """
    size = number(abs(float(shaft.speed_ratio)))
    turn = (
        _("{ratio} × crank speed, with the crank", ratio=size)
        if shaft.speed_ratio > 0
        else _("{ratio} × crank speed, against the crank", ratio=size)
    )
    across = scales(engine).across
    up, right = shaft.up, shaft.right
    if sized_for_estimates(engine):
        up, right = (float(f"{each:.3g}") for each in (up, right))
    place = _("{up} up, {right} right", up=across.text(up), right=across.text(right))
    return "\n".join([f"{shaft.name}: {turn}", place, *_unbalances(engine, shaft, ends)])


def _unbalances(engine: Engine, shaft: Shaft, ends: Sequence[Shaft]) -> Iterator[str]:
    """Unbalance and bearing at theta = 0 of each direction of weights, with its range.

    The unbalances of all shafts are in one unit.
    """
    scale = scales(engine).unbalance
    sizes = [abs(pull.unbalance) for each in balance_shafts(engine) for pull in pulls(each)]
    unit, factor = shown(scale.unit, max(sizes, default=0.0) * scale.factor)

    def written(value: float, digits: int) -> str:
        return f"{number(value * scale.factor * factor, digits=digits)} {unit_text(unit)}"

    own, rough = pulls(shaft), sized_for_estimates(engine)
    others = [each for each in map(pulls, ends) if len(each) == len(own)]
    for end, pull, *at_ends in zip(ends_named(own), own, *others, strict=True):
        size = abs(pull.unbalance)
        between = size_range(pull.unbalance, [end.unbalance for end in at_ends])
        text = written(size, 3 if rough or between is not None else 4)
        if between is not None:
            low, high = (written(each, 3) for each in between)
            text = f"{text} {_('({low} to {high})', low=low, high=high)}"
        elif rough:
            text = _("{sentence} (estimated)", sentence=text)
        angle = brief(round(degrees(phase(pull.unbalance)), 6) + 0.0)
        yield _(UNBALANCES[end], size=text, angle=angle)
