"""Verbs that print what is known of engines: list, show, analyze, compare, verdict, strokes."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Annotated, Any

from crankstar.cli.application import app
from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Orders,
    Output,
    ReferencePoint,
    Settings,
    Speed,
    Theta,
    command_text,
    engine_and_speed,
    engine_tree,
    loaded_engine,
    option,
    together,
)
from crankstar.cli.output import display, write
from crankstar.cli.tabulating import give
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.values import RequestError


@app.command(name="list")
def list_engines(
    *,
    cylinders: Annotated[int | None, option("--cylinders")] = None,
    layout: Annotated[str | None, option("--layout")] = None,
) -> None:
    """List the engines of the catalog."""
    from crankstar.files.catalog import summaries
    from crankstar.tables.engines import catalog

    rows = summaries()
    if layout is not None:
        request.choice("--layout", layout, sorted({row.layout for row in rows}))
    matching = [
        row for row in rows if cylinders in (None, row.cylinders) and layout in (None, row.layout)
    ]
    if not matching:
        raise RequestError("the catalog has no such engine; `crankstar list` shows all")
    display(catalog(matching))


@app.command
def show(
    engine: EngineName,
    /,
    *,
    explicit: Annotated[bool, option("--explicit")] = False,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Show an engine: throws, cylinders, dead centres, firing order and source of each value."""
    from crankstar.files import toml
    from crankstar.tables.engines import description

    loaded = loaded_engine(engine, settings)
    if explicit:
        write(toml(loaded), output)
    else:
        tree = engine_tree(engine, settings, loaded)
        give(description(loaded), output, form=form_of(output, TABLES), tree=tree)


@app.command
def analyze(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    orders: Orders = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    theta: Theta = None,
    by: Annotated[str | None, option("--by")] = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute inertia forces, couples, roll and torque of an engine, order by order."""
    from crankstar.mechanics.balance import balance
    from crankstar.tables import analysis as tables
    from crankstar.tables.amplitudes import amplitudes
    from crankstar.tables.balance_orders import answer

    form = form_of(output, TABLES, json=json, csv=csv)
    rows: tuple[Any, ...] = ()
    if form not in ("txt", "xlsx"):
        unused = {"--theta": theta, "--by": by if form == "json" else None}
        request.refuse_unused(unused, beside=f"--{form}")
    loaded, turning = engine_and_speed(engine, settings, speed)
    point = request.reference(reference, loaded)
    if form != "txt":
        result = balance(
            loaded, speed=loaded.speed if turning is None else turning, reference=point
        )
        wanted = request.orders(orders, result.force.orders.tolist())
        if form != "json":
            document = amplitudes(loaded, result, orders=wanted, by=request.grouping(by))
        else:
            document = answer(loaded, result, orders=wanted)
        if form != "xlsx":
            give(document, output, form=form)
            return
        rows = document.parts
    shown = tables.analysis(loaded, speed=turning, reference=point)
    shown = shown.of(request.orders(orders, shown.normalised.force.orders.tolist()) or ())
    angles, grouping = request.angles(theta), request.grouping(by)
    document = tables.document(shown, angles=angles, by=grouping)
    if form == "xlsx":
        tree = engine_tree(engine, settings, loaded)
        give(replace(document, parts=(*document.parts, *rows)), output, form=form, tree=tree)
    else:
        display(document, output)


@app.command
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
    output: Output = None,
) -> None:
    """Compare engines side by side: force, couple, roll and torque, absolute and relative."""
    from crankstar.tables import comparison as tables
    from crankstar.tables.analysis import analysis

    form = form_of(output, TABLES, json=json, csv=csv)
    names = (first, second, *others)
    turning, changes = together(
        partial(request.speed, speed), partial(request.settings_of_each, settings, len(names))
    )
    engines = together(*map(partial(partial, loaded_engine), names, changes))
    shown = [
        analysis(engine, speed=turning, reference=request.reference(reference, engine))
        for engine in engines
    ]
    wanted = request.orders(orders, shown[0].normalised.force.orders.tolist()) or ()
    shown = [analysed.of(wanted) for analysed in shown]
    own = tables.told_apart(
        [engine.name for engine in engines],
        [request.named(name) for name in names],
        [", ".join(texts) for texts in changes],
    )
    made = tables.comparison if form in ("txt", "xlsx") else tables.answer
    give(made(shown, own), output, form=form)


@app.command
def verdict(
    engine: EngineName, /, *, speed: Speed = None, settings: Settings = None, output: Output = None
) -> None:
    """State in short sentences which orders balance, which remain, and what would cure them."""
    from crankstar.remedy.fitting import recommended
    from crankstar.tables import verdict as tables
    from crankstar.tables.table import remarks

    loaded, turning = engine_and_speed(engine, settings, speed)
    facts = tables.verdict(loaded, speed=turning)
    document = tables.verdict_document(loaded, facts)
    if recommended(loaded) is not None:
        how = _(
            "To fit the recommended remedy and see what remains: {command}",
            command=f"{command_text('balance', engine, {'--set': settings})} --recommended",
        )
        document = replace(document, parts=(*document.parts, *remarks(how)))
    give(document, output, form=form_of(output, ("txt", "xlsx")))


@app.command
def strokes(
    engine: EngineName, /, *, settings: Settings = None, json: Json = False, output: Output = None
) -> None:
    """Print strokes, valve events and exhaust intervals of each cylinder; find exhaust overlaps."""
    from crankstar.language.faults import EngineError
    from crankstar.tables.strokes import strokes as document

    form = form_of(output, TABLES, json=json)
    loaded = loaded_engine(engine, settings)
    try:
        give(document(loaded), output, form=form)
    except EngineError as error:
        raise RequestError(f"{one_line(engine)}: {error}") from None
