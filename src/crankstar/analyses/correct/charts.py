"""The unbalance of a rotor and what corrects it, plane by plane."""

from __future__ import annotations

from cmath import rect

from crankstar.analyses.correct.question import Question
from crankstar.analyses.correct.solving import Corrections
from crankstar.charts.grammar import Chart
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.options import charts as chart_request


def vectors(result: Corrections, _question: Question) -> Chart:
    """The heavy spot and what is added, as vectors: g mm, or g at the radius that is asked for."""
    drawing = chart_request.charts()
    radius = result.radius
    factor = 1e6 if radius is None else 1e3 / radius
    diagrams = [
        drawing.Diagram(
            _("plane {number}", number=at),
            (
                drawing.Named(_("heavy spot"), factor * complex(own)),
                *(
                    drawing.Named(_("add"), factor * rect(each.unbalance, each.angle))
                    for each in added
                ),
            ),
        )
        for at, (own, added) in enumerate(zip(result.unbalance, result.added, strict=True), 1)
    ]
    about = _("unbalance in g mm; 0 deg is up, angles run clockwise")
    if radius is not None:
        about = _(
            "mass in g at a radius of {radius} mm; 0 deg is up, angles run clockwise",
            radius=number(1e3 * radius),
        )
    title = _("Correction in two planes")
    return drawing.polar_vectors(diagrams, title=title, subtitle=[about])
