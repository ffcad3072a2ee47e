"""Verbs that print what is known of engines.

list, show, analyze, compare, verdict.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    Orders,
    Output,
    ReferencePoint,
    Settings,
    Speed,
    Theta,
    beside,
    engine_read,
    engine_suffix,
    mark_speed,
    once,
    option,
    read_engine,
    sheet_tree,
    together,
    write_tree,
)
from crankstar.cli.output import complain, display, working, writable_form
from crankstar.cli.speed_ranges import over_speeds
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.records import GREATEST_CYLINDERS
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import TABLES, named
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine
    from crankstar.mechanics.balance import Grouping
    from crankstar.options.sources import Loaded


def list_engines(
    *,
    cylinders: Annotated[int | None, option("--cylinders")] = None,
    layout: Annotated[str | None, option("--layout")] = None,
) -> None:
    """List the engines of the catalog."""
    from crankstar.files.catalog import summaries
    from crankstar.tables.engines import catalog

    rows = summaries()
    layouts = sorted({row.layout for row in rows})
    together(
        partial(request.within, "--cylinders", cylinders, most=GREATEST_CYLINDERS),
        lambda: layout is None or request.choice("--layout", layout, layouts),
    )
    matching = [
        row for row in rows if cylinders in (None, row.cylinders) and layout in (None, row.layout)
    ]
    if not matching:
        raise RequestError("the catalog has no such engine; `crankstar list` shows all")
    display(catalog(matching))


def show(
    engine: EngineName,
    /,
    *,
    explicit: Annotated[bool, option("--explicit")] = False,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Show an engine: throws, cylinders, dead centres, firing order and source of each value."""
    from crankstar.files import explicit as part_by_part
    from crankstar.files.carried_tolerances import carried
    from crankstar.tables.engines import description
    from crankstar.tables.ranges import ranged

    loaded, form = together(
        partial(read_engine, engine, settings),
        partial(engine_suffix, output) if explicit else partial(writable_form, output, TABLES),
    )
    if explicit:
        write_tree(carried(part_by_part(loaded.engine), loaded.tree), output)
    else:
        tree = sheet_tree(engine, settings, loaded)
        with words_for(form):
            shown = ranged(description, loaded.spread, loaded.engine)
        give(shown, output, form=form, tree=tree)


def analyze(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    orders: Orders = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    estimate: Estimating = False,
    theta: Theta = None,
    by: Annotated[str | None, option("--by")] = None,
    vectors: Annotated[bool, option("--vectors")] = False,
    speeds: Annotated[str | None, option("--speeds", "Amplitudes over the speed.")] = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute inertia forces, couples, roll and torque of an engine, order by order."""
    from crankstar.mechanics.balance import balance
    from crankstar.studies.answers import amplitudes as of_amplitudes
    from crankstar.tables import analysis as tables
    from crankstar.tables.ranges import ranged

    read_form = once(partial(writable_form, output, TABLES, json=json, csv=csv))
    if speeds is not None:
        single = {"--speed": speed, "--theta": theta, "--vectors": vectors, "--by": by}
        over_speeds(
            engine, speeds, orders, reference, settings, read_form, output, single,
            estimate=estimate,
        )  # fmt: skip
        return
    load = once(partial(read_engine, engine, settings, estimate=estimate, speed=speed))

    form, _used, found, turning, point, angles, grouping, *_checked = together(
        read_form,
        lambda: _refuse_sheet(read_form(), theta=theta, vectors=vectors, by=by),
        load,
        partial(request.speed, speed),
        lambda: points.reference(reference, engine_read(load)),
        partial(request.angles, theta),
        partial(request.grouping, by),
        partial(request.orders, orders, []),
        lambda: request.refuse_foreign(orders, [load().engine], gas=False),
    )
    rows: tuple[Any, ...] = ()
    loaded, spread = found.engine, found.spread
    mark_speed(speed, loaded)
    answered = partial(of_amplitudes, loaded, speed=turning, both=True)
    if form != "txt":
        first = balance(loaded, reference=point)
        picked = request.orders(orders, first.force.orders.tolist())
        numbers = partial(
            _numbers, form, speed=turning, reference=reference, orders=picked, by=grouping
        )
        rests = resting_on(form, loaded, answered) if form == "json" else None
        document = ranged(numbers, spread, loaded, rests=rests)
        if form != "xlsx":
            give(document, output, form=form)
            return
        rows = tuple(document.tables)
    shown = tables.analysis(loaded, speed=turning, reference=point)
    wanted = request.orders(orders, shown.normalised.force.orders.tolist()) or ()

    def sheet(each: Engine) -> Document:
        point = points.reference(reference, each)
        shown = tables.analysis(each, speed=turning, reference=point).of(wanted)
        return tables.document(shown, angles=angles, by=grouping, vectors=vectors)

    document = ranged(sheet, spread, loaded, rests=resting_on(form, loaded, answered))
    if form == "xlsx":
        tree = sheet_tree(engine, settings, found, estimate=estimate)
        give(replace(document, parts=(*document.parts, *rows)), output, form=form, tree=tree)
    else:
        display(document, output)


def _numbers(
    form: str,
    engine: Engine,
    *,
    speed: float | None,
    reference: str | None,
    orders: list[float] | None,
    by: Grouping | None,
) -> Document:
    """The amplitudes of an engine in a form that programs read."""
    from crankstar.mechanics.balance import balance
    from crankstar.tables.amplitudes import amplitudes
    from crankstar.tables.balance_orders import answer

    at = engine.speed if speed is None else speed
    result = balance(engine, speed=at, reference=points.reference(reference, engine))
    if form != "json":
        return amplitudes(engine, result, orders=orders, by=by)
    return answer(engine, result, orders=orders)


def _refuse_sheet(form: str, *, theta: str | None, vectors: bool, by: str | None) -> None:
    """Refuse what a sheet for readers alone has. Raises RequestError."""
    if form not in ("txt", "xlsx"):
        own = by if form == "json" else None
        unused = {"--theta": theta, "--vectors": vectors, "--by": own}
        request.refuse_unused(unused, beside=f"--{form}")


def compare(
    first: EngineName,
    second: EngineName,
    /,
    *others: EngineName,
    speed: Speed = None,
    orders: Orders = None,
    reference: ReferencePoint = None,
    settings: Annotated[
        list[str] | None, option("--set", "2:KEY=VALUE changes the second engine only.")
    ] = None,
    json: Json = False,
    csv: Csv = False,
    estimate: Estimating = False,
    output: Output = None,
) -> None:
    """Compare engines side by side: force, couple, roll and torque, absolute and relative."""
    from crankstar.mechanics.operating_points import speed_beside
    from crankstar.studies.answers import compared, rests_on
    from crankstar.tables import comparison as tables
    from crankstar.tables.analysis import analysis
    from crankstar.tables.compared_speeds import speed_head
    from crankstar.tables.ranges import ranged_side_by_side

    names = (first, second, *others)
    changes = once(partial(request.settings_of_each, settings, len(names)))

    def read(number: int) -> Loaded:
        own = beside(changes, partial(tree_of, names[number]))[number]
        return read_engine(names[number], own, estimate=estimate, speed=speed)

    loads = [once(partial(read, number)) for number in range(len(names))]
    form, asked, _orders, *loaded = together(
        partial(writable_form, output, TABLES, json=json, csv=csv),
        partial(request.speed, speed),
        partial(request.orders, orders, []),
        *loads,
        *(lambda load=load: points.reference(reference, engine_read(load)) for load in loads),
        lambda: request.refuse_foreign(orders, [load().engine for load in loads], gas=False),
    )
    loaded = loaded[: len(names)]
    engines = [each.engine for each in loaded]
    mark_speed(speed, *engines)
    turning = speed_beside(engines, asked)
    whole = analysis(engines[0], speed=turning)
    wanted = request.orders(orders, whole.normalised.force.orders.tolist()) or ()
    own = tables.told_apart(
        [engine.name for engine in engines],
        [named(name) for name in names],
        [one_line(name) for name in names],
        [", ".join(texts) for texts in changes()],
    )
    made = tables.comparison if form in ("txt", "xlsx") else tables.answer

    def sheet(each: Sequence[Engine]) -> Document:
        shown = [
            analysis(engine, speed=turning, reference=points.reference(reference, engine))
            for engine in each
        ]
        return made([analysed.of(wanted) for analysed in shown], own)

    document = ranged_side_by_side(sheet, [each.spread for each in loaded], engines)
    if form not in ("csv", "parquet"):
        own_unit = any(analysis(one, speed=turning).real is None for one in engines)
        burning = all(one.gas is not None for one in engines)
        assumed = asked is None and turning is not None
        answer = partial(
            compared, speed=turning, own_unit=own_unit, gas=burning, speed_assumed=assumed
        )
        with working(_("Trying what is assumed ...")):
            rests = [rests_on(one, answer(one)) for one in engines]
        document = tables.resting(document, rests, own)
    elif "at_speed" in document.facts:
        speeds = [each.speed if turning is None else turning for each in engines]
        complain(speed_head(engines, own, speeds))
    give(tables.with_shares(document, engines), output, form=form)
