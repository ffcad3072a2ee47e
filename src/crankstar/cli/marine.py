"""The verb marine: external and guide-force moments, as project guides print them."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    Output,
    Settings,
    Speed,
    engine_over_ranges,
    engine_place,
    once,
    option,
    together,
    write_engine,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.gas import gas_orders
from crankstar.options.ranges import speeds_of

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine
    from crankstar.studies.marine import MarineAnalysis


def marine(
    engine: EngineName,
    /,
    *,
    point: Annotated[str | None, option("--point")] = None,
    speed: Speed = None,
    speeds: Annotated[
        str | None, option("--speeds", "External moments go with its square.")
    ] = None,
    rated_power: Annotated[str | None, option("--rated-power")] = None,
    first_order: Annotated[str | None, option("--first-order")] = None,
    compensate: Annotated[list[str] | None, option("--compensate")] = None,
    phase_error: Annotated[str | None, option("--phase-error")] = None,
    node: Annotated[str | None, option("--node")] = None,
    bracing: Annotated[str | None, option("--bracing")] = None,
    orders: Annotated[
        str | None, option("--orders", "Of both tables. Default: those of note.")
    ] = None,
    save: Annotated[str | None, option("--save")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute external and guide-force moments as project guides have them, and compensators."""
    from crankstar.options import marine as asked
    from crankstar.options.readers import horizontal_share
    from crankstar.studies.answers import external
    from crankstar.studies.marine import marine as analysis
    from crankstar.tables.marine import marine_document
    from crankstar.tables.marine_doubts import missing_guide, missing_units
    from crankstar.tables.ranges import ranged

    load = once(partial(engine_over_ranges, engine, settings, estimate=estimate))
    form, ((loaded, spread), tree), turning, over, wanted, share, *rest = together(
        partial(form_of, output, TABLES, json=json, csv=csv),
        load,
        partial(request.speed, speed),
        partial(speeds_of, speeds),
        partial(gas_orders, orders),
        lambda: None if first_order is None else horizontal_share(first_order),
        partial(asked.power, rated_power),
        partial(asked.phase_error, phase_error),
        partial(asked.bracing, bracing),
        lambda: asked.compensations(compensate, load()[0].engine),
        lambda: asked.node(node, load()[0].engine),
        partial(engine_place, save, option="--save"),
        partial(asked.refuse_unused, compensate, first_order, phase_error, save),
    )
    watts, late, braced, places, hull, *_checked = rest

    def found(each: Engine) -> MarineAnalysis:
        return analysis(
            each,
            point=point or "",
            speed=turning,
            speeds=over,
            rated_power=watts,
            horizontal_share=share,
            compensate=places,
            node=hull,
            phase_error=late,
            orders="all" if orders and orders.strip() == "all" else wanted,
        )

    def sheet(each: Engine) -> Document:
        made = found(each)
        if lacking := missing_guide(made):
            request.refuse_unused({"--bracing": bracing}, why=lacking)
        if lacking := missing_units(made):
            still = {} if made.after.speed is not None else {"--speeds": speeds}
            request.refuse_unused(still | {"--rated-power": rated_power}, why=lacking)
        return marine_document(made, bracing=braced)

    with working(_("Computing the moments ...")), words_for(form):
        rests = resting_on(form, loaded, partial(external, loaded, found))
        document = ranged(sheet, spread, loaded, rests=rests)
    if save is not None:
        write_engine(found(loaded).engine, tree, save, option="--save")
    give(document, output, form=form)
