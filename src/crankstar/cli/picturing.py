"""Verbs that draw: plot, sweep."""

from __future__ import annotations

from pathlib import PurePath
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar import chart_request, request
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, ReferencePoint, Settings, Speed, loaded_engine
from crankstar.output import display, working, write, write_bytes
from crankstar.quantity import one_line
from crankstar.request import RequestError


@app.command
def plot(
    engine: EngineName,
    chart: Annotated[
        str,
        Parameter(
            help="crank-star, vector-star, polygon, hodograph, over-turn, spectrum, shaft, stroke-chart, firing-ring or forces"
        ),
    ],
    /,
    *,
    beside: Annotated[
        list[str] | None, Parameter(help="another engine to draw beside it on the same axes; may be given again", negative=())
    ] = None,
    order: Annotated[
        str | None,
        Parameter(
            name=["--order", "--orders"],
            allow_leading_hyphen=True,
            help="the crank order, as in 2; several where the chart takes them, as in 1,2",
        ),
    ] = None,
    quantity: Annotated[str | None, Parameter(help="force or couple; over-turn also roll and torque")] = None,
    theta: Annotated[
        str | None,
        Parameter(help='the crank angle at which it is drawn, as in "30 deg"; forces takes several', allow_leading_hyphen=True),
    ] = None,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Annotated[
        str | None,
        Parameter(
            name=["--output", "-o"], help="file to write: .svg, .png, .pdf, .html (with a slider for the crank angle) or .json"
        ),
    ] = None,
) -> None:
    """Draw an engine: crank star, vector stars, polygons, hodographs, curves over a turn, spectra, shaft, forces, strokes."""
    drawing = chart_request.charts()
    if chart not in drawing.CHARTS:
        raise RequestError(f"there is no chart {one_line(chart)}; there are: {', '.join(drawing.CHARTS)}")
    figure = drawing.CHARTS[chart]
    suffix = chart_request.suffix(output, drawing.SUFFIXES)
    loaded, others = loaded_engine(engine, settings), [loaded_engine(name, None) for name in beside or ()]
    if others and not figure.compares:
        can = ", ".join(one.name for one in drawing.CHARTS.values() if one.compares)
        raise RequestError(f"--beside: {chart} cannot be drawn side by side; what can is {can}")
    options = chart_request.options(
        figure, loaded, order=order, quantity=quantity, theta=theta, speed=speed, reference=reference, alone=not others
    )
    with working(f"drawing {chart} ..."):
        try:
            with drawing.swiftly():
                made: Any = drawing.side_by_side([loaded, *others], chart, **options) if others else figure.draw(loaded, **options)
            content = drawing.saved(made, suffix, title=f"{loaded.name}: {figure.about}")
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
            help="the number of the engine file to vary and its values, as in balance_factor=0..1, "
            '"layout.banks[1].bearing=0..90 deg/91" (91 values) or "balance_factor=0, 0.5, 0.75"'
        ),
    ],
    watch: Annotated[
        str, Parameter(help="what to watch, as in force or force,couple.forward; also roll, torque, couple.pitch, couple.yaw")
    ] = "force",
    order: Annotated[
        str | None,
        Parameter(
            name=["--order", "--orders"], allow_leading_hyphen=True, help="of these orders, as in 1,2; else all orders together"
        ),
    ] = None,
    greatest: Annotated[bool, Parameter(help="the best value is where it is greatest, not least", negative=())] = False,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    csv: Annotated[bool, Parameter(help="all values as CSV", negative=())] = False,
    output: Annotated[
        str | None,
        Parameter(name=["--output", "-o"], help="file to write: a chart (.svg, .png, .pdf, .html, .json), .csv, or the table"),
    ] = None,
) -> None:
    """Vary one number of an engine: what becomes of force and couple, and which value is best."""
    from crankstar import sweep as sweeps
    from crankstar.sweep_table import csv_text, sweep_table

    changes = dict(request.setting(text) for text in settings or [])
    kind = PurePath(output or "").suffix.lower().removeprefix(".")
    drawing = chart_request.charts() if kind in ("svg", "png", "pdf", "html", "json") else None
    wanted = request.orders(order, []) if order is not None else None
    if order is not None and not wanted:
        raise RequestError("--order all: leave it out for all orders together, or name orders as in 1,2")
    point = request.reference(reference, loaded_engine(engine, settings)) if reference is not None else None
    try:
        asked = sweeps.over_request(over)
        with working(f"sweeping {asked.path} ...") as tell:
            found = sweeps.swept(
                engine,
                over=asked.path,
                values=asked.values,
                unit=asked.unit,
                changes=changes,
                reference=point,
                speed=request.speed(speed),
                tell=lambda done, of: tell(f"sweeping {one_line(asked.path)}: engine {done} of {of} ..."),
            )
            names = [name.strip() for name in watch.split(",") if name.strip()]
            curves = [sweeps.watched(found, name, order=one) for name in names for one in (wanted or [None])]
            if not curves:
                raise RequestError("--watch: name what to watch, as in force or force,couple")
            bests = [sweeps.best(found, curve, greatest=greatest) for curve in curves]
    except sweeps.SweepError as error:
        raise RequestError(str(error)) from None
    if csv or kind == "csv":
        write(csv_text(found, curves), output)
    elif drawing is not None:
        title = f"{found.engine.name}: {', '.join(curve.label for curve in curves)} over {found.path}"
        write_bytes(drawing.saved(drawing.swept(found, curves, best=bests), kind, title=title), output)
    else:
        display(sweep_table(found, curves, bests, greatest=greatest), output)
