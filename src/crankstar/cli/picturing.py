"""Verbs that draw: plot, sweep."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    ReferencePoint,
    Settings,
    Speed,
    loaded_engine,
    loaded_values,
    option,
    together,
)
from crankstar.cli.output import display, working, write_bytes, write_result
from crankstar.cli.tabulating import give
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, TABLES, form_of, usual_place
from crankstar.options.values import RequestError


@app.command
def plot(
    engine: EngineName,
    chart: Annotated[
        str,
        Parameter(
            help="crank-star, vector-star, polygon, hodograph, over-turn, spectrum, shaft, "
            "stroke-chart, firing-ring, forces, bearing-loads, bending or balance-shafts."
        ),
    ],
    /,
    *,
    beside: Annotated[
        list[str] | None,
        option("--beside", "On the same axes, without --speed in m r w^2; repeatable."),
    ] = None,
    orders: Annotated[str | None, option("--orders", "A chart of one order takes one.")] = None,
    quantity: Annotated[
        str | None,
        option(
            "--quantity",
            "For over-turn also roll or torque; for bearing-loads main-bearing, main-journal, "
            "crank-pin or crank-pin-journal (journals turn with the crankshaft).",
        ),
    ] = None,
    model: Annotated[str | None, option("--model")] = None,
    theta: Annotated[
        str | None, option("--theta", "Of the drawing; several for the chart forces.")
    ] = None,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    estimate: Estimating = False,
    theme: Annotated[str | None, option("--theme")] = None,
    width: Annotated[str | None, option("--width")] = None,
    height: Annotated[str | None, option("--height")] = None,
    dpi: Annotated[float | None, option("--dpi")] = None,
    font_size: Annotated[float | None, option("--font-size")] = None,
    output: Annotated[
        str | None,
        option(
            "--output",
            ".svg, .png, .pdf, .html (with a slider for the crank angle) or .json; default: "
            "ENGINE-CHART.svg.",
        ),
    ] = None,
) -> None:
    """Draw a chart of an engine: stars, paths, curves, spectra, strokes, forces, bearing loads."""
    drawing = chart_request.charts()
    figure = drawing.CHARTS[request.choice("chart", chart, drawing.CHARTS)]
    suffix = chart_request.suffix(output, drawing.SUFFIXES)
    paper = chart_request.paper(
        suffix, theme=theme, width=width, height=height, dpi=dpi, font_size=font_size
    )
    _turning, *each = together(
        partial(request.speed, speed),
        partial(loaded_values, engine, settings, estimate=estimate),
        *(partial(loaded_values, name, None, estimate=estimate) for name in beside or ()),
    )
    loaded, *others = [one.engine for one in each]
    if others and not figure.compares:
        raise RequestError(
            "--beside: {chart} shows one engine; charts of several are {charts}",
            chart=chart,
            charts=", ".join(name for name, known in drawing.CHARTS.items() if known.compares),
        )
    options = chart_request.options(
        figure,
        loaded,
        orders=orders,
        quantity=quantity,
        model=model,
        theta=theta,
        speed=speed,
        reference=reference,
        alone=not others,
    )
    with working(_("Drawing {chart} ...", chart=chart)):
        draw = (
            partial(drawing.side_by_side, [loaded, *others], chart, **options)
            if others
            else partial(figure.draw, loaded, **options)
        )
        title = _("{engine}: {chart}", engine=loaded.name, chart=_(figure.about))
        with drawing.over_ranges(one.spread for one in each):
            made = drawing.printed(draw, paper, title=title)
        content = drawing.saved_print(made, suffix, title=title)
    write_result(content, output, usual_place(engine, chart, kind=suffix))


@app.command
def sweep(
    engine: EngineName,
    /,
    *,
    over: Annotated[str, option("--over")],
    quantity: Annotated[
        str, option("--quantity", "Also roll, torque, couple.pitch, couple.yaw, force.forward, ...")
    ] = "force",
    orders: Annotated[str | None, option("--orders", "Default: the sum of all orders.")] = None,
    greatest: Annotated[bool, option("--greatest")] = False,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Annotated[
        str | None,
        option("--output", "A chart (.svg, .png, .pdf, .html, .json), .csv, or the table."),
    ] = None,
) -> None:
    """Vary a value of an engine: force and couple over it, and the best value."""
    from crankstar.studies import sweep as sweeps
    from crankstar.studies.best_value import best
    from crankstar.studies.ranges import over_request
    from crankstar.tables import sweeps as tables

    kind = PurePath(output or "").suffix.lower().removeprefix(".")
    picture = kind in (*PICTURES, "json") and not (json or csv)
    drawing = chart_request.charts() if picture else None
    form = "" if drawing else form_of(output, TABLES, json=json, csv=csv)
    wanted: Sequence[float | None] = request.orders(orders, []) or [None]
    if orders is not None and wanted == [None]:
        raise RequestError(
            "--orders all: omit --orders for the sum of all orders, or give orders such as 1,2"
        )
    names = request.listed(quantity)
    if not names:
        raise RequestError("--quantity: give at least one quantity, such as force,couple")
    point = reference and request.reference(reference, loaded_engine(engine, settings))
    asked = over_request(over)
    with working(_("Sweeping {path} ...", path=one_line(asked.path))) as tell:
        swept = sweeps.swept(
            engine,
            over=asked.path,
            values=asked.values,
            unit=asked.unit,
            changes=request.settings(settings),
            reference=point or None,
            speed="file" if speed is None else request.speed(speed),
            tell=lambda done, of: tell(
                _(
                    "Sweeping {path}: engine {done} of {count} ...",
                    path=one_line(asked.path),
                    done=done,
                    count=of,
                )
            ),
        )
        curves = [sweeps.watched(swept, name, order=number) for name in names for number in wanted]
        bests = [best(swept, curve, greatest=greatest) for curve in curves]
    if drawing is not None:
        labels = ", ".join(curve.label for curve in curves)
        title = _(
            "{engine}: {curves} over {path}",
            engine=swept.engine.name,
            curves=labels,
            path=swept.path,
        )
        picture = drawing.swept(swept, curves, best=bests)
        write_bytes(drawing.saved(picture, kind, title=title), output)
    elif form == "txt":
        display(tables.sweep_document(swept, curves, bests, greatest=greatest), output)
    else:
        give(tables.answer(swept, curves, bests), output, form=form)
