"""Engines built to the tolerances of the file: how they scatter, and which tolerance matters."""

from __future__ import annotations

from crankstar.analyses.tolerance.as_built import as_built
from crankstar.analyses.tolerance.document import scatter_document
from crankstar.charts.canvas import drawn_on
from crankstar.charts.grammar import Chart
from crankstar.language.messages import _
from crankstar.report.gallery import ACROSS, Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject


def tolerances(subject: Subject, gallery: Gallery) -> str:
    """Empty where the engine file has no tolerances."""
    found = as_built(subject.engine, subject.tree, speed=subject.speed)
    if found is None:
        return ""
    from crankstar.analyses.tolerance.charts import scatter_chart

    def chart() -> Chart:
        with drawn_on(ACROSS):
            return scatter_chart(found)

    _heading, *parts = scatter_document(found).parts  # it stands on the first page
    caption = _(
        "Left, how many engines have which amplitude; right, the share of each tolerance in the "
        "variance."
    )
    drawn = gallery.drawn("scatter", caption, chart, "wide")
    return section(
        _("Built to tolerances"), parts_html(parts) + figures([drawn]), name="tolerances"
    )
