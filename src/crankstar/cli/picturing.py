"""Verbs that draw: plot, sweep."""

from __future__ import annotations

from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import (
    ORDER_NAMES,
    Csv,
    EngineName,
    Json,
    ReferencePoint,
    Settings,
    Speed,
    flag,
    loaded_engine,
    output,
    text,
)
from crankstar.cli.output import display, working, write_bytes
from crankstar.cli.tabulating import form_of, give
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.values import RequestError


@app.command
def plot(
    engine: EngineName,
    chart: Annotated[
        str,
        Parameter(
            help="crank-star, vector-star, polygon, hodograph, over-turn, spectrum, shaft, "
            "stroke-chart, firing-ring or forces."
        ),
    ],
    /,
    *,
    beside: Annotated[
        list[str] | None,
        Parameter(
            help="Another engine on the same axes (without --speed in m r w^2); repeatable.",
            negative=(),
        ),
    ] = None,
    order: Annotated[
        str | None,
        text(
            "Crank order, such as 2, or several for charts of several, such as 1,2.", *ORDER_NAMES
        ),
    ] = None,
    quantity: Annotated[
        str | None, Parameter(help="force or couple; for over-turn also roll or torque.")
    ] = None,
    theta: Annotated[
        str | None, text('Crank angle of the drawing, such as "30 deg"; several for forces.')
    ] = None,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Annotated[
        str | None,
        output(
            "File to write: .svg, .png, .pdf, .html (with a slider for the crank angle) or .json."
        ),
    ] = None,
) -> None:
    """Draw a chart of an engine: stars, polygons, paths, curves, spectra, strokes, forces."""
    drawing = chart_request.charts()
    if chart not in drawing.CHARTS:
        raise RequestError(
            _(
                "there is no chart {chart}; there are: {charts}",
                chart=one_line(chart),
                charts=", ".join(drawing.CHARTS),
            )
        )
    figure = drawing.CHARTS[chart]
    suffix = chart_request.suffix(output, drawing.SUFFIXES)
    loaded, others = (
        loaded_engine(engine, settings),
        [loaded_engine(name, None) for name in beside or ()],
    )
    if others and not figure.compares:
        possible = ", ".join(name for name, known in drawing.CHARTS.items() if known.compares)
        raise RequestError(
            _(
                "--beside: {chart} shows one engine; charts of several are {charts}",
                chart=chart,
                charts=possible,
            )
        )
    options = chart_request.options(
        figure,
        loaded,
        order=order,
        quantity=quantity,
        theta=theta,
        speed=speed,
        reference=reference,
        alone=not others,
    )
    with working(_("drawing {chart} ...", chart=chart)):
        try:
            made = (
                drawing.side_by_side([loaded, *others], chart, **options)
                if others
                else figure.draw(loaded, **options)
            )
            title = _("{engine}: {chart}", engine=loaded.name, chart=_(figure.about))
            content = drawing.saved(made, suffix, title=title)
        except drawing.ChartError as error:
            raise RequestError(str(error)) from None
    write_bytes(content, output)


@app.command
def sweep(
    engine: EngineName,
    /,
    *,
    over: Annotated[
        str,
        Parameter(
            help="Value of the engine file to vary, such as balance_factor=0..1, "
            '"layout.banks[1].bearing=0..90 deg/91" (91 values) or "balance_factor=0, 0.5, 0.75".'
        ),
    ],
    watch: Annotated[
        str,
        Parameter(
            help="Quantities to compute: force, couple, roll, torque, couple.pitch, couple.yaw, "
            "force.forward, ..., joined by commas."
        ),
    ] = "force",
    order: Annotated[
        str | None,
        text("Crank orders, such as 1,2 (default: the sum of all orders).", *ORDER_NAMES),
    ] = None,
    greatest: Annotated[bool, flag("Find the greatest value instead of the least.")] = False,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Annotated[
        str | None,
        output("File to write: a chart (.svg, .png, .pdf, .html, .json), .csv, or the table."),
    ] = None,
) -> None:
    """Vary a value of an engine: force and couple over it, and the best value."""
    from crankstar.studies import sweep as sweeps
    from crankstar.studies.best_value import best
    from crankstar.studies.ranges import over_request
    from crankstar.tables import sweeps as tables

    changes = dict(request.setting(text) for text in settings or [])
    kind = PurePath(output or "").suffix.lower().removeprefix(".")
    picture = kind in ("svg", "png", "pdf", "html", "json") and not (json or csv)
    drawing = chart_request.charts() if picture else None
    form = "" if drawing else form_of(output, json=json, csv=csv)
    wanted = request.orders(order, []) if order is not None else None
    if order is not None and not wanted:
        raise RequestError(
            _("--order all: omit --order for the sum of all orders, or give orders such as 1,2")
        )
    point = (
        request.reference(reference, loaded_engine(engine, settings))
        if reference is not None
        else None
    )
    try:
        asked = over_request(over)
        with working(f"sweeping {asked.path} ...") as tell:
            found = sweeps.swept(
                engine,
                over=asked.path,
                values=asked.values,
                unit=asked.unit,
                changes=changes,
                reference=point,
                speed="file" if speed is None else request.speed(speed),
                tell=lambda done, of: tell(
                    f"sweeping {one_line(asked.path)}: engine {done} of {of} ..."
                ),
            )
            names = [name.strip() for name in watch.split(",") if name.strip()]
            curves = [
                sweeps.watched(found, name, order=one)
                for name in names
                for one in (wanted or [None])
            ]
            if not curves:
                raise RequestError(_("--watch: give at least one quantity, such as force,couple"))
            bests = [best(found, curve, greatest=greatest) for curve in curves]
    except sweeps.SweepError as error:
        raise RequestError(str(error)) from None
    if drawing is not None:
        title = (
            f"{found.engine.name}: {', '.join(curve.label for curve in curves)} over {found.path}"
        )
        write_bytes(
            drawing.saved(drawing.swept(found, curves, best=bests), kind, title=title), output
        )
    elif form == "txt":
        display(tables.sweep_document(found, curves, bests, greatest=greatest), output)
    else:
        give(tables.answer(found, curves, bests), output, form=form)
