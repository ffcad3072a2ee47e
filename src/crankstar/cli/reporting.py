"""The verb that writes it all down: report."""

from __future__ import annotations

import shlex
from typing import Annotated

from cyclopts import Parameter

from crankstar import chart_request, request
from crankstar.catalog import load, tree_of
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, Speed
from crankstar.output import kind_of, working, writable, write, write_bytes
from crankstar.request import RequestError

KINDS = ("html", "pdf")


@app.command(name="report")
def write_report(
    engine: EngineName,
    /,
    *,
    output: Annotated[str | None, Parameter(name=["--output", "-o"], help="file to write: .html, or .pdf through Chromium")] = None,
    speed: Speed = None,
    orders: Annotated[
        str | None,
        Parameter(
            name=["--orders", "--order"],
            allow_leading_hyphen=True,
            help="crank orders, as in 1,2,4,6 or all, each drawn and derived in full; else those up to 6 that matter",
        ),
    ] = None,
    beside: Annotated[str | None, Parameter(help="another engine, compared with it order by order")] = None,
    settings: Settings = None,
) -> None:
    """Write a report: data, views, strokes, orders, derivations, diagrams, verdict, remedies, sources."""
    chart_request.charts()
    kind = kind_of(output, KINDS, what="a report")
    from crankstar import report
    from crankstar.files import changed, engine_of

    if output is not None:
        writable(output)
    shown, tree = tree_of(engine)
    changes = dict(request.setting(text) for text in settings or ())
    loaded = engine_of(tree, name=shown, changes=changes)
    other = load(beside) if beside is not None else None
    turning = request.speed(speed)
    given = {"--speed": [speed], "--orders": [orders], "--beside": [beside and request.named(beside)], "--set": settings or []}
    words = [word for option, values in given.items() for value in values if value is not None for word in (option, value)]
    matter = report.Matter(
        loaded,
        changed(tree, changes, name=shown),
        shlex.join(["crankstar", "report", request.named(engine), *words, "-o", f"report.{kind}"]),
        turning,
        None,
        other,
    )
    wanted = request.orders(orders, list(matter.shown.normalised.force.orders.tolist()))
    matter = matter.about(orders=tuple(wanted) if wanted else None)
    try:
        by = report.browser() if kind == "pdf" else ""
        with working("writing the report ...") as tell:
            page = report.report(matter, tell=tell)
            if kind == "html":
                return write(page, output)
            tell("printing ...")
            content = report.pdf(page, by=by)
    except report.PrintingError as error:
        raise RequestError(str(error)) from None
    return write_bytes(content, output)
