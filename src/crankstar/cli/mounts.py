"""The verb mounts: how an engine shakes on its mounts."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    Json,
    Output,
    Settings,
    Speed,
    loaded_engine,
    once,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.speed_ranges import speeds_of
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.gas import gas_orders

HELP = "Name from the catalog, or engine file with [[mounts]]; - for standard input."


def mounts(
    engine: Annotated[str, Parameter(help=HELP)],
    /,
    *,
    point: Annotated[str | None, option("--point")] = None,
    speed: Speed = None,
    speeds: Annotated[str | None, option("--speeds", "Default: those of the file.")] = None,
    at: Annotated[str | None, option("--at")] = None,
    orders: Annotated[str | None, option("--orders", "Default: up to 24.")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute how an engine shakes on its mounts: modes, motion of a point, forces passed on."""
    from crankstar.dynamics.mount_analysis import mounts as analysis
    from crankstar.studies.response_answers import on_mounts
    from crankstar.tables.mounts import mounts_document
    from crankstar.tables.ranges import resting

    if speed is not None and ".." in speed and speeds is None:
        speed, speeds = None, speed
    load = once(partial(loaded_engine, engine, settings))
    form, loaded, turning, over, wanted, place = together(
        partial(form_of, output, TABLES, json=json, csv=csv),
        load,
        partial(request.speed, speed),
        partial(speeds_of, speeds),
        partial(gas_orders, None if orders and orders.strip() == "all" else orders),
        lambda: request.block_point(at, load()),
    )
    with working(_("Computing the vibration on the mounts ...")), words_for(form):
        found = analysis(
            loaded, point=point or "", speed=turning, speeds=over, orders=wanted, at=place
        )
        machine = form not in ("txt", "xlsx")
        document = mounts_document(
            loaded, found, machine=machine, every=form != "txt", every_order=wanted is not None
        )
        state: dict[str, Any] = {
            "point": point or "",
            "speed": turning,
            "speeds": over,
            "at": place,
        }
        document = resting(document, resting_on(form, loaded, partial(on_mounts, loaded, **state)))
    give(document, output, form=form)
