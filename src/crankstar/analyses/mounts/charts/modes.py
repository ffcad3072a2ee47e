"""The natural modes of a block on its mounts: which share of each is in which freedom."""

from __future__ import annotations

from crankstar.analyses.mounts.charts.words import about, rests
from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import DEEP, GREY, PALE, figure, layered
from crankstar.charts.gas_curves import without
from crankstar.charts.grammar import Chart, constant, field, of_rows, span
from crankstar.charts.letters import SMALL, text_width
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mounted_block import SIX, MountError
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import FREEDOMS
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.tables.mount_points import FREEDOM_NAMES

TITLE = N_("Natural modes on the mounts")
ROW = 34.0
"""px: the height of a mode."""
LEAST = 0.5
"""Percent: less is left blank."""


def mount_mode_chart(engine: Engine) -> Chart:
    """A row for each mode, from low to high, with the share of each freedom in its kinetic energy.

    A mode with nearly all of it in one freedom is decoupled. On a foundation that gives way, the
    last column is the share of the foundation. An engine without mounts has a figure that says so.
    """
    title = _(TITLE)
    try:
        found = mounts(engine, orders=())
    except MountError as error:
        return without(engine, title=title, reason=str(error))
    heads = [_(FREEDOM_NAMES[name]) for name in FREEDOMS]
    if found.block.freedoms > SIX:
        heads.append(_("foundation"))
    rows = []
    for index, mode in enumerate(found.modes):
        energy = [float(each) * 100 for each in mode.energy]
        shares = energy[:SIX] + ([sum(energy[SIX:])] if len(energy) > SIX else [])
        rows += [
            {
                "x": column + 0.5,
                "y": index + 0.5,
                "x1": column + 0.04,
                "x2": column + 0.96,
                "y1": index + 0.05,
                "y2": index + 0.95,
                "share": round(share, 3),
                "text": f"{share:.0f}" if abs(share) >= LEAST else "",
            }
            for column, share in enumerate(shares)
        ]
    count = len(found.modes)
    words = [f"{number(float(f'{mode.frequency:.3g}'))} Hz" for mode in found.modes]
    beside = max(map(text_width, words)) + 12
    cell = (panel_width() - beside) / len(heads)
    x = field("x:Q", scale=span(0, len(heads)), axis=None)
    y = field("y:Q", scale=span(count, 0), axis=None)
    colour = field("share:Q", scale={"domain": [0, 100], "range": [PALE, DEEP]}, legend=None)
    cells = of_rows(rows).mark("rect").encode(
        x={**x, "field": "x1"}, y={**y, "field": "y1"}, x2=field("x2"), y2=field("y2"), color=colour
    )  # fmt: skip
    texts = of_rows([row for row in rows if row["text"]]).mark(
        "text", fontSize=13, color=GREY, baseline="middle"
    )
    names = [{"y": index + 0.5, "text": text} for index, text in enumerate(words)]
    left = of_rows(names).mark("text", fontSize=13, color=GREY, align="right", baseline="middle")
    tops = [{"x": index + 0.5, "text": text} for index, text in enumerate(heads)]
    small = min(13, *(int(SMALL * cell / max(text_width(t, SMALL), 1.0)) for t in heads))
    head = of_rows(tops).mark("text", fontSize=max(small, 9), color=GREY, baseline="bottom")
    panel = layered(
        [
            cells,
            texts.encode(x=x, y=y, text=field("text:N")),
            left.encode(x=constant(-8), y=y, text=field("text:N")),
            head.encode(x=x, y=constant(-6), text=field("text:N")),
        ],
        width=panel_width() - beside,
        height=ROW * count,
    )
    told = [
        *about(engine, found, shaken=False),
        _("share of each freedom in the kinetic energy, %, about the centre of mass"),
    ]
    return figure([[panel]], title=title, subtitle=told, rests=rests(engine))
