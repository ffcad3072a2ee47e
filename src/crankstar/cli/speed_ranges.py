"""What `analyze --speeds` prints: amplitudes over the speed."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from crankstar.cli.options import command_text, read_engine, sheet_tree, together
from crankstar.cli.tabulating import give, resting_on
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.ranges import refuse_one

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine


def over_speeds(
    engine: str,
    speeds: str,
    orders: str | None,
    reference: str | None,
    settings: list[str] | None,
    form: str,
    output: str | None,
    *,
    estimate: bool,
) -> None:
    """Print the amplitudes at each of the speeds in a form of TABLES."""
    from crankstar.mechanics.balance import balance
    from crankstar.mechanics.occurring_orders import check_orders
    from crankstar.studies.answers import amplitudes
    from crankstar.studies.sweep import sweep
    from crankstar.tables import over_speeds as tables
    from crankstar.tables.ranges import ranged

    refuse_one(speeds)
    request.speeds(speeds)
    found, _read = together(
        partial(read_engine, engine, settings, estimate=estimate, speed=speeds),
        partial(request.orders, orders, []),
    )
    loaded, spread = found.engine, found.spread
    present = balance(loaded).force.orders.tolist() if orders is not None else []
    wanted = request.orders(orders, present)
    check_orders(loaded, wanted or (), gas=False)
    words = {"amplitudes": [""], "--set": settings, "--speeds": [speeds]}
    chart = command_text("plot", engine, words | ({"--estimate": [""]} if estimate else {}))

    def made(build: str, each: Engine) -> Document:
        point = points.reference(reference, each)
        swept = sweep(each, f"speed={speeds}", reference=point)
        if build == "txt":
            return tables.document(each, swept, orders=wanted, chart=chart)
        return (tables.answer if build == "json" else tables.tidy)(each, swept, orders=wanted)

    rests = resting_on(form, loaded, partial(amplitudes, loaded))
    document = ranged(partial(made, form), spread, loaded, rests=rests)
    if form == "xlsx":
        readable = ranged(partial(made, "txt"), spread, loaded, rests=rests)
        document = replace(readable, parts=(*readable.parts, *document.tables))
    tree = sheet_tree(engine, settings, found, estimate=estimate) if form == "xlsx" else None
    give(document, output, form=form, tree=tree)
