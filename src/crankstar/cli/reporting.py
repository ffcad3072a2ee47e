"""The verb that writes the printed report: report."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import (
    ORDER_NAMES,
    EngineName,
    Settings,
    Speed,
    changed_tree,
    command_text,
    output,
    text,
    together,
)
from crankstar.cli.output import working, writable, write, write_bytes
from crankstar.files.catalog import load
from crankstar.language.messages import _
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import form_of

KINDS = ("html", "pdf")


@app.command(name="report")
def write_report(
    engine: EngineName,
    /,
    *,
    output: Annotated[
        str | None, output("File to write: .html, or .pdf, which needs Chromium.")
    ] = None,
    speed: Speed = None,
    orders: Annotated[
        str | None,
        text(
            "Crank orders to draw and derive in full, such as 1,2,4, or all (default: those up to "
            "6 with the largest force or couple).",
            *ORDER_NAMES,
        ),
    ] = None,
    beside: Annotated[
        str | None, Parameter(help="Another engine, compared order by order.")
    ] = None,
    settings: Settings = None,
) -> None:
    """Write a report: data, verdict, views, strokes, orders, diagrams, remedies, derivations."""
    chart_request.charts()
    kind = form_of(output, KINDS)
    from crankstar import report
    from crankstar.files import engine_of

    if output is not None:
        writable(output)
    (name, tree), other, turning = together(
        partial(changed_tree, engine, settings),
        partial(load, beside) if beside is not None else lambda: None,
        partial(request.speed, speed),
    )
    loaded = engine_of(tree, name=name)
    options = {
        "--speed": speed and [speed],
        "--orders": orders and [orders],
        "--beside": beside and [request.named(beside)],
        "--set": settings,
        "-o": [f"report.{kind}"],
    }
    command = command_text("report", request.named(engine), options)
    subject = report.Subject(loaded, tree, command, turning, None, other)
    wanted = request.orders(orders, list(subject.shown.normalised.force.orders.tolist()))
    subject = subject.with_orders(tuple(wanted) if wanted else None)
    by = report.browser() if kind == "pdf" else ""
    with working(_("Writing the report ...")) as tell:
        page = report.report(subject, tell=tell)
        if kind == "html":
            return write(page, output)
        tell(_("Printing ..."))
        content = report.pdf(page, by=by)
    return write_bytes(content, output)
