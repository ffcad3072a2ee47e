"""A printed formula beside the true one: over one turn, with momentum; over the rod length."""

from __future__ import annotations

from typing import Any

import numpy as np

from crankstar.charts.drawing import GREY, OURS, PRINTED, styled
from crankstar.charts.grammar import Chart, field, of_rows
from crankstar.spectra import Real

JUDGED = 48
"""About so many points of momentum in a turn: enough to see each crest of the sixth order."""
FLAT = 1e-6
"""Share of the greatest value below which a curve is drawn as zero."""


def judged(*, theta: Real, printed: Real, ours: Real, momentum: Real, axis: str) -> Chart:
    """Printed (dashed, or diamonds at single angles), ours (solid), momentum (circles) over a turn.

    `theta` [sample] in radians from 0 to a turn; the other three [sample] in the unit that `axis`,
    the title of the upright axis, names; NaN where nothing is printed.
    """
    degrees = np.degrees(theta)
    scale = max(float(np.nanmax(np.abs(values))) for values in (printed, ours, momentum))
    reach = 1.1 * scale
    x = field(
        "x:Q",
        title="crank angle θ (degrees)",
        axis={"values": list(range(0, 361, 90))},
        scale={"domain": [0, 360]},
    )
    y = field(
        "y:Q", title=axis, axis={"tickCount": 5}, scale={"domain": [-reach, reach], "nice": False}
    )
    step = max(1, (theta.size - 1) // JUDGED)
    single = bool(np.isnan(printed).any())
    names = ("printed", "true", "momentum")
    stated, derived, judged = (
        np.where(np.abs(values) < FLAT * scale, 0.0, values) for values in (printed, ours, momentum)
    )
    layers = [
        _line(_rows(degrees, derived, names[1]), x, y, names),
        _points(_rows(degrees[::step], judged[::step], names[2]), x, y, names, single=single),
    ]
    rows = _rows(degrees, stated, names[0])
    layers.append(
        _points(rows, x, y, names, single=True, size=130) if single else _line(rows, x, y, names)
    )
    return styled(*layers)


def over_rods(*, ratio: Real, printed: Real, ours: Real) -> Chart:
    """Errors of two series, per cent, over rods of `ratio` strokes: printed (dashed), ours (solid).

    `printed`, `ours` [sample] are relative errors; their magnitude is drawn, on a logarithmic axis.
    """
    sizes = [100 * np.maximum(np.abs(values), 1e-8) for values in (printed, ours)]
    ends = [float(ratio[0]), float(ratio[-1])]
    powers = {
        "values": [10.0**power for power in range(-5, 4)],
        "labelExpr": "toString(datum.value)",
    }
    x = field(
        "x:Q",
        title="rod length over stroke, L = l/S",
        axis={"tickCount": 5},
        scale={"domain": ends, "nice": False},
    )
    y = field("y:Q", title="error (per cent)", axis=powers, scale={"type": "log"})
    names = ("printed", "true")
    layers = [
        _line(_rows(ratio, values, name), x, y, names)
        for values, name in zip(sizes, names, strict=True)
    ]
    return styled(*layers)


def _rows(x: Real, y: Real, name: str) -> list[dict[str, Any]]:
    kept = ~np.isnan(y)
    return [
        {"x": float(a), "y": float(b), "what": name} for a, b in zip(x[kept], y[kept], strict=True)
    ]


def _key() -> Any:
    return {
        "orient": "top",
        "title": None,
        "symbolSize": 110,
        "symbolStrokeWidth": 2.4,
        "symbolFillColor": "transparent",
    }


def _colour(names: tuple[str, ...]) -> Any:
    scale = {"domain": list(names), "range": [PRINTED, OURS, GREY][: len(names)]}
    return field("what:N", scale=scale, legend=_key())


def _line(rows: list[dict[str, Any]], x: Any, y: Any, names: tuple[str, ...]) -> Any:
    dashes = {"domain": list(names), "range": [[7, 4], [1, 0], [1, 0]][: len(names)]}
    mark = of_rows(rows).mark("line", strokeWidth=2.4)
    return mark.encode(
        x=x, y=y, color=_colour(names), strokeDash=field("what:N", scale=dashes, legend=_key())
    )


def _points(
    rows: list[dict[str, Any]],
    x: Any,
    y: Any,
    names: tuple[str, ...],
    *,
    single: bool,
    size: int = 34,
) -> Any:
    mark = of_rows(rows).mark("point", size=size, filled=False, strokeWidth=1.6, opacity=1)
    forms = {
        "domain": list(names),
        "range": ["diamond" if single else "stroke", "stroke", "circle"],
    }
    return mark.encode(
        x=x, y=y, color=_colour(names), shape=field("what:N", scale=forms, legend=_key())
    )
