"""The first modes of a crankshaft or drive line: how far each mass turns, and where none does."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from crankstar.analyses.torsion.charts.words import hertz, named_lines, refused, rests
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import BLUE, GREY, VERMILION, Panel, figure, layered
from crankstar.charts.grammar import DISC, Channel, Chart, field, of_rows, own, span
from crankstar.charts.letters import TEXT, text_width
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_modes import Mode, torsion_modes
from crankstar.dynamics.torsion_system import TorsionChain, TorsionError
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import N_, _, _n

TITLE = N_("Mode shapes of torsion")
MOST = 3
HEIGHT = 96.0
ROOM = 1.12
LEAST, GREATEST = 18.0, 150.0
"""px^2: the dots of a mass that is nought beside the others, and of the greatest."""
LONGEST = 180.0
"""px: of the name of a mass."""
SLANTED, COSINE = 0.87, 0.5
"""The height and the width of a slanted name over its length."""
EDGE = 0.4
"""Of the step between two masses: from the first and the last one to the edges of a panel."""


def mode_shapes(source: Engine | Chain) -> Chart:
    """The first three modes, one below the other: the turn of each mass, front to rear.

    The shape is 1 at the first mass, and that of a geared mass is referred to the crankshaft, so
    that a shaft is a straight line and a node where this crosses nought. A dot is as large as the
    inertia. Masses that turn together are one. An engine without a table [torsion] has a figure
    that says so.
    """
    title = _(TITLE)
    try:
        chain = torsion_chain(source)
    except TorsionError as error:
        return refused(source, title=title, reason=str(error))
    modes = torsion_modes(chain)[:MOST]
    if not modes:
        reason = _("Nothing twists: all masses are rigidly coupled, or by a fluid alone.")
        return refused(source, title=title, reason=reason)
    subtitle = [*named_lines(source), _("turn of each mass, 1 at the first that a shaft holds")]
    if np.any(chain.ratio != 1):
        subtitle.append(_("Geared masses: their turn referred to the crankshaft."))
    if chain.estimated:
        subtitle.append(
            _("The stiffness between the throws is estimated from their dimensions by a formula.")
        )
    panels = [[_panel(chain, mode, foot=mode is modes[-1])] for mode in modes]
    return figure(panels, title=title, subtitle=subtitle, rests=rests(source))


def _panel(chain: TorsionChain, mode: Mode, *, foot: bool) -> Panel:
    places = chain.freedom
    turns = mode.shape / chain.ratio
    reach = ROOM * float(np.abs(turns).max())
    x = _across(chain, foot=foot)
    y = field(
        "y:Q",
        scale=span(-reach, reach),
        title=None,
        axis={"tickCount": 3, "minExtent": _beside(chain)},
    )
    ends = [(each.before, each.after, each.stiffness == 0) for each in chain.sections]
    shafts = [
        {
            "x": places[one],
            "y": _rounded(turns[one]),
            "x2": places[other],
            "y2": _rounded(turns[other]),
            "dash": [4, 3] if fluid else [1, 0],
        }
        for one, other, fluid in ends
    ]
    lines = of_rows(shafts).mark("rule", color=BLUE, strokeWidth=2)
    dash = field("dash", type="nominal", scale=None)
    layers = [
        of_rows([{"y": 0}]).mark("rule", color=GREY, strokeWidth=1, opacity=0.5).encode(y=y),
        lines.encode(x=x, y=y, x2=field("x2"), y2=field("y2"), strokeDash=dash),
        of_rows(_masses(chain, turns)).mark("point", **DISC, color=BLUE).encode(
            x=x, y=y, size=own("size:Q")
        ),
    ]  # fmt: skip
    nodes = [
        {"x": round(places[n.before] + n.share * (places[n.after] - places[n.before]), 6), "y": 0}
        for n in mode.nodes
    ]
    if nodes:
        mark = of_rows(nodes).mark(
            "point", shape="diamond", filled=True, opacity=1, size=70, color=VERMILION
        )
        layers.append(mark.encode(x=x, y=y))
    head = _n(
        "mode {number}: {frequency} Hz, {count} node",
        "mode {number}: {frequency} Hz, {count} nodes",
        len(mode.nodes),
        number=mode.number,
        frequency=hertz(mode.speed),
        count=len(mode.nodes),
    )
    return layered(layers, width=panel_width(), height=curve_height(HEIGHT), title=head)


def _rounded(value: float) -> float:
    return float(f"{value:.6g}")


def _masses(chain: TorsionChain, turns: np.ndarray) -> list[dict[str, Any]]:
    """A row for each freedom: its place, turn and size."""
    inertia = chain.inertias()[0]
    top = float(inertia.max())
    return [
        {
            "x": freedom,
            "y": _rounded(turns[chain.freedom.index(freedom)]),
            "size": round(LEAST + (GREATEST - LEAST) * float(inertia[freedom]) / top, 2),
        }
        for freedom in range(chain.freedoms)
    ]


def mass_names(chain: TorsionChain) -> list[str]:
    """The masses of each freedom, by name."""
    return [
        " + ".join(n for n, own in zip(chain.names, chain.freedom, strict=True) if own == freedom)
        for freedom in range(chain.freedoms)
    ]


def _beside(chain: TorsionChain) -> float:
    """Room (px) for the numbers left of a panel, and for slanted names that reach beyond its edge.

    Those are measured with narrower letters than those of a reader's screen.
    """
    names = mass_names(chain)
    slot = panel_width() / (len(names) - 1 + 2 * EDGE)
    reach = max(
        COSINE * min(text_width(name, TEXT), LONGEST) + TEXT / 2 - (at + EDGE) * slot
        for at, name in enumerate(names)
    )
    return max(34.0, round(reach, 1))


def _across(chain: TorsionChain, *, foot: bool) -> Channel:
    names = mass_names(chain)
    last = len(names) - 1
    slot = panel_width() / (len(names) or 1)
    longest = max(text_width(name, TEXT) for name in names)
    level = longest < 0.9 * slot
    step = max(1, round(18 / slot))
    axis: dict[str, Any] = {
        "values": list(range(0, last + 1, step)),
        "labelExpr": f"{json.dumps(names, ensure_ascii=False)}[datum.value]",
        "labels": foot,
        "labelLimit": LONGEST,
        "labelOverlap": False,
        "labelAngle": 0 if level else -60,
        "grid": True,
    }
    if not level:
        axis |= {"labelAlign": "right", "labelBaseline": "middle"}
        if foot:  # measured with other letters than those of a reader's screen
            axis["minExtent"] = SLANTED * min(longest, LONGEST) + 1.5 * TEXT
    return field("x:Q", scale={**span(-EDGE, last + EDGE), "zero": False}, title=None, axis=axis)
