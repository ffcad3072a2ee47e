"""The verb that computes loads on main bearings: bearings."""

from __future__ import annotations

from typing import Annotated, cast, get_args

from crankstar.cli.application import app
from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Orders,
    Output,
    Settings,
    Speed,
    engine_and_speed,
    option,
)
from crankstar.cli.tabulating import give
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of


@app.command
def bearings(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    model: Annotated[str, option("--model")] = "determinate",
    orders: Orders = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute loads on main bearings and crank pins, guide forces, bending of the crankshaft."""
    from crankstar.dynamics.bearings import Model
    from crankstar.tables.bearings import bearing_document

    form = form_of(output, TABLES, json=json, csv=csv)
    request.choice("--model", model, get_args(Model))
    loaded, turning = engine_and_speed(engine, settings, speed)
    document = bearing_document(
        loaded,
        speed=turning,
        model=cast("Model", model),
        orders=lambda present: request.orders(orders, present),
        machine=form != "txt",
    )
    give(document, output, form=form)
