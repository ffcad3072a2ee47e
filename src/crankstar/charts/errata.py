"""A printed formula beside the true one: over one turn, with momentum; over the rod length."""

from __future__ import annotations

from math import isnan
from typing import Any

import numpy as np

from crankstar.charts.crank_angle import across
from crankstar.charts.drawing import BLUE, GREY, VERMILION, styled
from crankstar.charts.grammar import Channel, Chart, Layer, field, of_rows, span
from crankstar.language.messages import N_, _
from crankstar.spectra import Real

JUDGED = 48
"""About so many points of momentum in a turn: enough to see each crest of the sixth order."""
FLAT = 1e-6
"""Share of the greatest value below which a curve is drawn as zero."""
PRINTED, OURS, MOMENTUM = N_("printed"), N_("correct formula"), N_("momentum")


def judged(*, theta: Real, printed: Real, ours: Real, momentum: Real, axis: str) -> Chart:
    """Printed (dashed, or diamonds at single angles), ours (solid), momentum (circles) over a turn.

    `theta` [sample] in radians from 0 to a turn; the other three [sample] in the unit that `axis`,
    the title of the upright axis, names; NaN where nothing is printed.
    """
    scale = max(float(np.nanmax(np.abs(values))) for values in (printed, ours, momentum))
    stated, derived, summed = (
        np.where(np.abs(values) < FLAT * scale, 0.0, values) for values in (printed, ours, momentum)
    )
    x = across(1, ticks=90, foot=True)
    y = field("y:Q", title=axis, axis={"tickCount": 5}, scale=span(-1.1 * scale, 1.1 * scale))
    single = bool(np.isnan(printed).any())
    names = (PRINTED, OURS, MOMENTUM)
    shapes = ("diamond" if single else "stroke", "stroke", "circle")
    at, step = np.degrees(theta), max(1, (theta.size - 1) // JUDGED)
    layers = [
        _line(_rows(at, derived, OURS), x, y, names),
        _points(_rows(at[::step], summed[::step], MOMENTUM), x, y, shapes, size=34),
    ]
    rows = _rows(at, stated, PRINTED)
    last = _points(rows, x, y, shapes, size=130) if single else _line(rows, x, y, names)
    return styled(*layers, last)


def over_rods(*, ratio: Real, printed: Real, ours: Real) -> Chart:
    """Errors of two series, per cent, over rods of `ratio` strokes: printed (dashed), ours (solid).

    `printed`, `ours` [sample] are relative errors; their magnitude is drawn, on a logarithmic axis.
    """
    powers = [10.0**power for power in range(-5, 4)]
    x = field(
        "x:Q",
        title=_("rod length over stroke, L = l/S"),
        axis={"tickCount": 5},
        scale=span(float(ratio[0]), float(ratio[-1])),
    )
    y = field(
        "y:Q",
        title=_("error (per cent)"),
        axis={"values": powers, "labelExpr": "toString(datum.value)"},
        scale={"type": "log"},
    )
    names = (PRINTED, OURS)
    return styled(
        *(
            _line(_rows(ratio, 100 * np.maximum(np.abs(values), 1e-8), name), x, y, names)
            for values, name in zip((printed, ours), names, strict=True)
        )
    )


def _rows(x: Real, y: Real, name: str) -> list[dict[str, Any]]:
    """The values that are numbers."""
    pairs = zip(x.tolist(), y.tolist(), strict=True)
    return [{"x": a, "y": b, "what": _(name)} for a, b in pairs if not isnan(b)]


def _named(names: tuple[str, ...], values: list[Any]) -> Channel:
    """A channel with a value for each of the names, and the legend that all of them share."""
    legend = {"symbolSize": 110, "symbolStrokeWidth": 2.4, "symbolFillColor": "transparent"}
    return field(
        "what:N",
        scale={"domain": [_(name) for name in names], "range": values[: len(names)]},
        legend={"orient": "top", "title": None, **legend},
    )


COLOURS = [VERMILION, BLUE, GREY]


def _line(rows: list[dict[str, Any]], x: Channel, y: Channel, names: tuple[str, ...]) -> Layer:
    return (
        of_rows(rows)
        .mark("line", strokeWidth=2.4)
        .encode(
            x=x,
            y=y,
            color=_named(names, COLOURS),
            strokeDash=_named(names, [[7, 4], [1, 0], [1, 0]]),
        )
    )


def _points(
    rows: list[dict[str, Any]], x: Channel, y: Channel, shapes: tuple[str, ...], *, size: int
) -> Layer:
    names = (PRINTED, OURS, MOMENTUM)
    mark = of_rows(rows).mark("point", size=size, filled=False, strokeWidth=1.6, opacity=1)
    return mark.encode(x=x, y=y, color=_named(names, COLOURS), shape=_named(names, list(shapes)))
