"""The verb that computes loads on main bearings: bearings."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, cast, get_args

from crankstar.cli.application import app
from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    Orders,
    Output,
    Settings,
    Speed,
    loaded_values,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.tables.table import Document


@app.command
def bearings(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    model: Annotated[str, option("--model")] = "determinate",
    orders: Orders = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute loads on main bearings and crank pins, guide forces, bending of the crankshaft."""
    from crankstar.dynamics.bearings import Model
    from crankstar.tables.bearings import bearing_document
    from crankstar.tables.ranges import ranged

    form = form_of(output, TABLES, json=json, csv=csv)
    request.choice("--model", model, get_args(Model))
    (loaded, spread), turning = together(
        partial(loaded_values, engine, settings, estimate=estimate), partial(request.speed, speed)
    )

    def sheet(each: Engine) -> Document:
        return bearing_document(
            each,
            speed=each.speed if turning is None else turning,
            model=cast("Model", model),
            orders=lambda present: request.orders(orders, present),
            machine=form != "txt",
        )

    with working(_("Computing the loads ...")):
        document = ranged(sheet, spread, loaded)
    give(document, output, form=form)
