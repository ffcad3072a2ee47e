"""What `analyze --speeds` prints: amplitudes over the speed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from crankstar.cli.options import command_text, engine_read, once, read_engine, sheet_tree, together
from crankstar.cli.tabulating import give, resting_on
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.ranges import speeds_of

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine


def over_speeds(
    engine: str,
    speeds: str,
    orders: str | None,
    reference: str | None,
    settings: list[str] | None,
    read_form: Callable[[], str],
    output: str | None,
    single: Mapping[str, object],
    *,
    estimate: bool,
) -> None:
    """Print the amplitudes at each of the speeds in a form of TABLES.

    `single` are the options of one speed, which have no effect.
    """
    from crankstar.mechanics.balance import balance
    from crankstar.mechanics.occurring_orders import check_orders
    from crankstar.studies.answers import amplitudes
    from crankstar.studies.sweep import sweep
    from crankstar.tables import over_speeds as tables
    from crankstar.tables.ranges import ranged

    load = once(partial(read_engine, engine, settings, estimate=estimate, speed=speeds))

    def read_orders() -> list[float] | None:
        if orders is None:
            return None
        wanted = request.orders(orders, balance(load().engine).force.orders.tolist())
        check_orders(load().engine, wanted or (), gas=False)
        return wanted

    form, found, wanted, *_checked = together(
        read_form,
        load,
        read_orders,
        partial(request.refuse_unused, single, beside="--speeds"),
        partial(speeds_of, speeds),
        partial(request.orders, orders, []),
        lambda: points.reference(reference, engine_read(load)),
    )
    loaded, spread = found.engine, found.spread
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
