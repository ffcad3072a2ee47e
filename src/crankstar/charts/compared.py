"""A printed formula beside the true one: over one turn with momentum as the judge, and over the length of the rod."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from crankstar.charts.drawing import GREY, OURS, PRINTED, of_rows, styled
from crankstar.phasor import Real

if TYPE_CHECKING:
    import altair

JUDGED = 48
"""About so many points of momentum in a turn: enough to see each crest of the sixth order."""
FLAT = 1e-6
"""Share of the greatest value below which a curve is drawn as zero."""


def judged(*, theta: Real, printed: Real, ours: Real, momentum: Real, axis: str) -> altair.LayerChart:
    """Printed (dashed, or diamonds where it is said at single angles only), ours (solid) and momentum (circles) over a turn.

    `theta` [sample] in radians from 0 to a turn; the other three [sample] in the unit that `axis`, the title of the upright
    axis, names; NaN where nothing is printed.
    """
    import altair as alt

    degrees = np.degrees(theta)
    scale = max(float(np.nanmax(np.abs(values))) for values in (printed, ours, momentum))
    reach = 1.1 * scale
    x = alt.X(
        "x:Q", title="crank angle θ (degrees)", axis=alt.Axis(values=list(range(0, 361, 90))), scale=alt.Scale(domain=[0, 360])
    )
    y = alt.Y("y:Q", title=axis, axis=alt.Axis(tickCount=5), scale=alt.Scale(domain=[-reach, reach], nice=False))
    step = max(1, (theta.size - 1) // JUDGED)
    single = bool(np.isnan(printed).any())
    names = ("printed", "true", "momentum")
    said, derived, judged = (np.where(np.abs(values) < FLAT * scale, 0.0, values) for values in (printed, ours, momentum))
    layers = [
        _line(alt, _rows(degrees, derived, names[1]), x, y, names),
        _points(alt, _rows(degrees[::step], judged[::step], names[2]), x, y, names, single=single),
    ]
    rows = _rows(degrees, said, names[0])
    layers.append(_points(alt, rows, x, y, names, single=True, size=130) if single else _line(alt, rows, x, y, names))
    return styled(alt.layer(*layers))


def over_rods(*, ratio: Real, printed: Real, ours: Real) -> altair.LayerChart:
    """By how many per cent two series miss the exact harmonic, over rods of `ratio` strokes: printed (dashed), ours (solid).

    `printed`, `ours` [sample] are relative errors; their magnitude is drawn, on a logarithmic axis.
    """
    import altair as alt

    sizes = [100 * np.maximum(np.abs(values), 1e-8) for values in (printed, ours)]
    ends = [float(ratio[0]), float(ratio[-1])]
    powers = alt.Axis(values=[10.0**power for power in range(-5, 4)], labelExpr="toString(datum.value)")
    x = alt.X("x:Q", title="rod length over stroke, L = l/S", axis=alt.Axis(tickCount=5), scale=alt.Scale(domain=ends, nice=False))
    y = alt.Y("y:Q", title="error (per cent)", axis=powers, scale=alt.Scale(type="log"))
    names = ("printed", "true")
    return styled(
        alt.layer(*(_line(alt, _rows(ratio, values, name), x, y, names) for values, name in zip(sizes, names, strict=True)))
    )


def _rows(x: Real, y: Real, name: str) -> list[dict[str, Any]]:
    kept = ~np.isnan(y)
    return [{"x": float(a), "y": float(b), "what": name} for a, b in zip(x[kept], y[kept], strict=True)]


def _key(alt: Any) -> Any:
    return alt.Legend(orient="top", title=None, symbolSize=110, symbolStrokeWidth=2.4, symbolFillColor="transparent")


def _colour(alt: Any, names: tuple[str, ...]) -> Any:
    scale = alt.Scale(domain=list(names), range=[PRINTED, OURS, GREY][: len(names)])
    return alt.Color("what:N", scale=scale, legend=_key(alt))


def _line(alt: Any, rows: list[dict[str, Any]], x: Any, y: Any, names: tuple[str, ...]) -> Any:
    dashes = alt.Scale(domain=list(names), range=[[7, 4], [1, 0], [1, 0]][: len(names)])
    mark = of_rows(rows).mark_line(strokeWidth=2.4)
    return mark.encode(x=x, y=y, color=_colour(alt, names), strokeDash=alt.StrokeDash("what:N", scale=dashes, legend=_key(alt)))


def _points(alt: Any, rows: list[dict[str, Any]], x: Any, y: Any, names: tuple[str, ...], *, single: bool, size: int = 34) -> Any:
    mark = of_rows(rows).mark_point(size=size, filled=False, strokeWidth=1.6, opacity=1)
    forms = alt.Scale(domain=list(names), range=["diamond" if single else "stroke", "stroke", "circle"])
    return mark.encode(x=x, y=y, color=_colour(alt, names), shape=alt.Shape("what:N", scale=forms, legend=_key(alt)))
