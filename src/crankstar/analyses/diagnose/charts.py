"""The suspects of a diagnosis as bars, and what was measured beside what the likeliest explains."""

from __future__ import annotations

import json

from crankstar.analyses.diagnose.diagnosis import Diagnosis
from crankstar.analyses.diagnose.document import NAMES, suspect_text, suspects_of
from crankstar.analyses.diagnose.figures import explained
from crankstar.analyses.diagnose.question import Question
from crankstar.analyses.diagnose.readings import AXES
from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import BLUE, GREY, ChartError, Panel, figure, layered
from crankstar.charts.grammar import Chart, constant, field, of_rows, span
from crankstar.charts.letters import SMALL, text_width
from crankstar.charts.resting import Rests
from crankstar.charts.vector_diagrams import Diagram, Named, diagram_panels
from crankstar.language.messages import _
from crankstar.language.numbers import number, order_text

BARS, READINGS = 8, 4
"""Suspects and readings that are drawn: the likeliest, and the greatest."""
ROW = 22.0
"""px of a bar with its gap."""
LEAST = 90.0
"""px of the longest bar at least."""
ROOM = 1.25
"""The room of names over their width as it is measured here."""


def picture(found: Diagnosis, question: Question) -> Chart:
    """The chart of a diagnosis. Raises ChartError."""
    del question
    return suspect_chart(found)


def suspect_chart(found: Diagnosis) -> Chart:
    """Explained share of the likeliest faults; vectors of the greatest readings. Raises ChartError.

    A vector is a velocity at the phase that was measured: 0 deg up, 90 deg to the right.
    """
    if not found.suspects:
        raise ChartError(_("no fault changes anything at these readings"))
    order = sorted(range(len(found.readings)), key=lambda at: -abs(found.difference[at]))
    diagrams: list[Diagram] = []
    for at in order[:READINGS]:
        each = found.readings[at]
        title = _(
            "line {line}: order {order}, {direction}",
            line=each.line,
            order=order_text(each.order),
            direction=_(NAMES[AXES[each.axis]]),
        )
        diagrams.append(
            Diagram(
                title,
                (
                    Named(_("measured"), 1e3 * complex(found.difference[at])),
                    Named(_("explained"), 1e3 * complex(found.suspects[0].rows[at])),
                ),
            )
        )
    return figure(
        [[_bars(found)], *diagram_panels(diagrams)],
        title=_("Which fault explains the measurement"),
        subtitle=[
            found.engine.name,
            _("vectors: the difference in mm/s, its phase clockwise from up"),
        ],
        rests=Rests(
            [found.engine],
            lambda engine: explained(engine, found.readings, point=found.point),
            "diagnose",
        ),
    )


def _bars(found: Diagnosis) -> Panel:
    """A bar for each of the likeliest faults, its name before it."""
    some = suspects_of(found)[:BARS] or found.suspects[:1]
    rows = [
        {
            "fault": f"{index}",
            "name": suspect_text(each, found),
            "to": max(100 * each.explained, 0.0),
            "text": f"{number(max(100 * each.explained, 0.0), 100.0, digits=3)} %",
        }
        for index, each in enumerate(some, 1)
    ]
    names = [row.pop("name") for row in rows]
    wide = max(text_width(name, SMALL) for name in names) + 12
    axis = {
        "labelExpr": f"{json.dumps(names, ensure_ascii=False)}[datum.value - 1]",
        "labelLimit": ROOM * wide,
        "labelFontSize": SMALL,
        "minExtent": ROOM * wide,
        "domain": False,
        "ticks": False,
    }
    y = field("fault:N", sort=None, title=None, axis=axis)
    x = field("to:Q", title=_("explained, %"), scale=span(0, 118), axis={"values": [0, 50, 100]})
    bars = of_rows(rows).mark("bar", size=12).encode(x=x, y=y, color=constant(BLUE))
    numbers = of_rows(rows).mark("text", fontSize=SMALL, color=GREY, align="left", dx=4)
    layers = [bars, numbers.encode(x=x, y=y, text=field("text:N"))]
    return layered(
        layers, width=max(panel_width() + 60 - ROOM * wide, LEAST), height=ROW * len(rows)
    )
