"""The verb guide: a family of engines, as the page of a project guide."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.options import (
    Csv,
    EngineName,
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
from crankstar.cli.search_options import not_compiled
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.words import SearchWords

GOALS = "M1,M2"


def guide(
    engine: EngineName,
    /,
    *,
    numbers: Annotated[str | None, option("--numbers", "Default: 5..12.")] = None,
    given: Annotated[list[str] | None, option("--given")] = None,
    minimise: Annotated[
        str | None, option("--minimise", "As in `search`, together; default: M1,M2.")
    ] = None,
    limit: Annotated[list[str] | None, option("--limit", "As in `search`.")] = None,
    chain_drive: Annotated[str | None, option("--chain-drive")] = None,
    first_order: Annotated[str | None, option("--first-order")] = None,
    point: Annotated[str | None, option("--point")] = None,
    speed: Speed = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """List engines with the cylinders of one in rows of 5 to 12, with the best firing orders."""
    try:
        from crankstar.options import guide as asked
        from crankstar.studies.engine_family import engine_family
        from crankstar.studies.published_orders import published_orders
    except ImportError as error:
        raise not_compiled(error) from None
    from crankstar.options.marine import horizontal_share
    from crankstar.studies.answers import amplitudes
    from crankstar.tables.engine_family import family_document
    from crankstar.tables.ranges import resting

    words = SearchWords(minimise=minimise, limit=limit or [], best="1")
    load = once(partial(loaded_engine, engine, settings))
    count = once(partial(asked.numbers_of_cylinders, numbers))
    form, loaded, turning, counts, share, orders, drive, goals = together(
        partial(form_of, output, TABLES, json=json, csv=csv),
        load,
        partial(request.speed, speed),
        count,
        partial(horizontal_share, first_order),
        lambda: asked.firing_orders(given, count()),
        lambda: asked.chain_drive(chain_drive, load(), count()),
        partial(asked.goals, words),
    )
    with working(_("Searching firing orders ...")), words_for(form):
        members = engine_family(
            loaded,
            numbers=counts,
            given=orders,
            published=published_orders(loaded.cycle, counts),
            options=goals,
            drive=drive,
            point=point or "",
            speed=turning,
            horizontal_share=share,
        )
        document = family_document(
            loaded,
            members,
            goals="; ".join([minimise or GOALS, *(limit or [])]),
            horizontal_share=share,
            drive=drive,
        )
        answered = partial(amplitudes, loaded, point=point or "", speed=turning)
        document = resting(document, resting_on(form, loaded, answered))
    give(document, output, form=form)
