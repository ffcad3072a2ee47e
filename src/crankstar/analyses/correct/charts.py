"""The unbalance of a rotor and what corrects it, plane by plane."""

from __future__ import annotations

from cmath import rect

from crankstar.analyses.correct.question import Question
from crankstar.analyses.correct.solving import Corrections
from crankstar.charts.grammar import Chart
from crankstar.language.messages import _
from crankstar.options import charts as chart_request


def vectors(result: Corrections, _question: Question) -> Chart:
    """The heavy spot and what is added, as vectors (g mm)."""
    drawing = chart_request.charts()
    diagrams = [
        drawing.Diagram(
            _("plane {number}", number=at),
            (
                drawing.Named(_("heavy spot"), 1e6 * complex(own)),
                *(
                    drawing.Named(_("add"), 1e6 * rect(each.unbalance, each.angle))
                    for each in added
                ),
            ),
        )
        for at, (own, added) in enumerate(zip(result.unbalance, result.added, strict=True), 1)
    ]
    about = _("unbalance in g mm; 0 deg is up, angles run clockwise")
    title = _("Correction in two planes")
    return drawing.polar_vectors(diagrams, title=title, subtitle=[about])
