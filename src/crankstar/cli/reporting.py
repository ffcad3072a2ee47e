"""The verb that writes the printed report: report."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.charts.fonts import missing_letters
from crankstar.cli.options import (
    EngineName,
    Estimating,
    Settings,
    Speed,
    command_text,
    once,
    option,
    or_none,
    read_engine,
    together,
)
from crankstar.cli.output import complain, working, writable, write_result
from crankstar.language.messages import _, language
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import STANDARD_OUTPUT, form_of, named, refuse_terminal, usual_place

KINDS = ("html", "pdf")
SHOWN = 12
"""Letters without a font that are named."""


def write_report(
    engine: EngineName,
    /,
    *,
    output: Annotated[
        str | None,
        option("--output", ".html, or .pdf, which needs Chromium; default: ENGINE-report.html."),
    ] = None,
    speed: Speed = None,
    orders: Annotated[
        str | None,
        option(
            "--orders",
            "They are drawn and derived in full. Default: those up to 6 with the largest force or "
            "couple.",
        ),
    ] = None,
    beside: Annotated[
        list[str] | None, option("--beside", "Compared order by order; one only.")
    ] = None,
    full: Annotated[bool, option("--full")] = False,
    settings: Settings = None,
    estimate: Estimating = False,
) -> None:
    """Write a report: data, verdict, views, strokes, orders, diagrams, remedies, derivations."""
    chart_request.charts()
    from crankstar import report

    read_kind = once(partial(form_of, output, KINDS))
    usual = usual_place(engine, "report", kind=or_none(read_kind) or KINDS[0])
    names = (beside or [])[:1]
    kind, second, turning, _terminal, _place, _orders, loaded, *others = together(
        read_kind,
        partial(request.single, "--beside", beside),
        partial(request.speed, speed),
        partial(refuse_terminal, output, KINDS),
        partial(writable, usual if output is None else output),
        partial(request.orders, orders, []),
        partial(read_engine, engine, settings, estimate=estimate, speed=speed),
        *(partial(read_engine, name, estimate=estimate, speed=speed) for name in names),
    )
    beside_it = others[0] if others else None
    options = {
        "--speed": speed and [speed],
        "--orders": orders and [orders],
        "--beside": second and [named(second)],
        "--full": [""] if full else None,
        "--set": settings,
        "--estimate": [""] if estimate else None,
        "--language": None if language() == "en" else [language()],
        "-o": [named(output) if output not in STANDARD_OUTPUT else usual],
    }
    command = command_text("report", named(engine), options)
    subject = report.Subject(
        loaded.engine,
        loaded.tree,
        command,
        turning,
        beside=beside_it and beside_it.engine,
        full=full,
        spreads=(loaded.spread, beside_it and beside_it.spread),
    )
    wanted = request.orders(orders, list(subject.shown.normalised.force.orders.tolist()))
    subject = subject.with_orders(tuple(wanted) if wanted else None)
    by = report.browser() if kind == "pdf" else ""
    with working(_("Writing the report ...")) as tell:
        page = report.report(subject, tell=tell)
        content = page
        if kind == "pdf":
            tell(_("Printing ..."))
            content = report.printed(page, by=by)
    write_result(content, output, usual)
    for letters in missing_letters(page):
        complain(
            _(
                "No font here has the letters {letters}, so they do not print; install one, or "
                'pip install "crankstar[fonts]".',
                letters=letters if len(letters) <= SHOWN else f"{letters[:SHOWN]} ...",
            )
        )
