"""The verb that draws: plot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import (
    FLAT,
    EngineName,
    Estimating,
    Looks,
    ReferencePoint,
    Settings,
    Speed,
    mark_speed,
    once,
    option,
    or_none,
    read_engine,
    together,
)
from crankstar.cli.output import complain, working, writable, write_result
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import _
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import usual_place
from crankstar.options.values import RequestError


def plot(
    engine: EngineName,
    chart: Annotated[
        str,
        Parameter(
            help="crank-star, vector-star, polygon, hodograph, over-turn, amplitudes, spectrum, "
            "shaft, stroke-chart, firing-ring, exhaust-orders, torque, pressure, side-thrust, "
            "guide-moments, forces, bearing-loads, bending, balance-shafts, torsion-modes, "
            "campbell, torsion-response, torsion-star, mount-layout, mount-modes, "
            "mount-response or transmissibility."
        ),
    ],
    /,
    *,
    beside: Annotated[
        list[str] | None,
        option(
            "--beside", "On the same axes, at one speed, or in m r w^2 without sizes; repeatable."
        ),
    ] = None,
    orders: Annotated[str | None, option("--orders", "A chart of one order takes one.")] = None,
    quantity: Annotated[
        str | None,
        option(
            "--quantity",
            "For over-turn also roll or torque; for bearing-loads main-bearing, main-journal, "
            "crank-pin or crank-pin-journal (journals turn with the crankshaft); for torque "
            "together, cylinders, loads or orders; for pressure volume or angle; for "
            "torsion-response amplitude, stress or torque; for torsion-star mode-1, mode-2 or "
            "mode-3; for mount-response velocity, displacement, "
            "acceleration, hand-arm, force or mounts.",
        ),
    ] = None,
    model: Annotated[str | None, option("--model")] = None,
    theta: Annotated[
        str | None, option("--theta", "For the drawing; several for the chart forces.")
    ] = None,
    speed: Speed = None,
    speeds: Annotated[
        str | None,
        option(
            "--speeds",
            "For amplitudes, campbell, torsion-response, mount-response, transmissibility.",
        ),
    ] = None,
    reference: ReferencePoint = None,
    gas: Annotated[bool, option("--gas", "For bearing-loads.")] = False,
    point: Annotated[
        str | None, option("--point", "For charts of gas, torsion, mounts, and amplitudes.")
    ] = None,
    at: Annotated[str | None, option("--at", "For mount-response and mount-layout.")] = None,
    off: Annotated[str | None, option("--off", "For charts of gas.")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    looks: Annotated[Looks, FLAT] = Looks(),  # noqa: B008  # it is frozen
    output: Annotated[
        str | None,
        option(
            "--output",
            ".svg, .png, .pdf, .html (with a slider for the crank angle) or .json; default: "
            "ENGINE-CHART.svg.",
        ),
    ] = None,
) -> None:
    """Draw a chart of an engine: stars, paths, curves, spectra, gas, loads, torsion, mounts."""
    drawing = chart_request.charts()
    if engine in drawing.CHARTS and chart not in drawing.CHARTS:
        engine, chart = chart, engine  # the two the other way round
    words: dict[str, Any] = {
        "orders": orders,
        "quantity": quantity,
        "model": model,
        "theta": theta,
        "speed": speed,
        "speeds": speeds,
        "reference": reference,
        "gas": gas,
        "point": point,
        "off": off,
        "at": at,
        "alone": not beside,
    }
    known = drawing.CHARTS.get(chart)
    chains = known is None or known.of_chains
    read_suffix = once(partial(_suffix, output, drawing.SUFFIXES))
    load = once(
        partial(read_engine, engine, settings, estimate=estimate, speed=speed, chains=chains)
    )

    def source() -> Engine | Chain | None:
        return or_none(lambda: load().source)

    name, suffix, paper, options, _beside, *each = together(
        partial(request.choice, "chart", chart, drawing.CHARTS),
        read_suffix,
        lambda: chart_request.paper(or_none(read_suffix) or "", **asdict(looks)),
        lambda: chart_request.options(known, source(), **words),
        partial(_refuse_beside, known, beside),
        load,
        *(partial(read_engine, name, estimate=estimate, speed=speed) for name in beside or ()),
    )
    figure = drawing.CHARTS[name]
    loaded, *others = [one.source for one in each]
    if isinstance(loaded, Engine):
        mark_speed(speed, loaded, *others)
    if "off" in figure.options and ("gas" not in figure.options or "gas" in options):
        from crankstar.mechanics.gas import check_gas

        check_gas(loaded)
    with working(_("Drawing {chart} ...", chart=chart)):
        draw = (
            partial(drawing.side_by_side, [loaded, *others], chart, **options)
            if others
            else partial(drawing.draw, chart, loaded, **options)
        )
        title = _("{engine}: {chart}", engine=loaded.name, chart=_(figure.about))
        with drawing.over_ranges(one.spread for one in each):
            made = drawing.printed(draw, paper, title=title)
        if made.chart.lacking:
            raise RequestError(made.chart.lacking)
        content = drawing.saved_print(made, suffix, title=title)
    write_result(content, output, usual_place(engine, chart, kind=suffix))
    for line in made.chart.notes:
        complain(line)


def _suffix(output: str | None, possible: tuple[str, ...]) -> str:
    """How the picture is written. Raises RequestError, OutputError where it cannot be written."""
    suffix = chart_request.suffix(output, possible)
    if output is not None:
        writable(output)
    return suffix


def _refuse_beside(figure: Any, beside: Sequence[str] | None) -> None:
    """Refuse other engines in a chart of one. Raises RequestError."""
    if beside and figure is not None and not figure.compares:
        charts = chart_request.charts().CHARTS
        raise RequestError(
            "--beside: {chart} shows one engine; charts of several are {charts}",
            chart=figure.name,
            charts=", ".join(name for name, known in charts.items() if known.compares),
        )
