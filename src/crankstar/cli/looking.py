"""Verbs that only look: list, show, analyze, compare, verdict, strokes, derive, errata."""

from __future__ import annotations

from fractions import Fraction
from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar import request
from crankstar.cli.application import app
from crankstar.cli.options import Angles, EngineName, Orders, Output, ReferencePoint, Settings, Speed, loaded_engine
from crankstar.output import STANDARD_OUTPUT, display, terminal_width, working, write
from crankstar.quantity import one_line
from crankstar.request import RequestError

WIDE = 92
"""Columns from which a table shows everything."""


@app.command(name="list")
def list_engines(
    *,
    cylinders: Annotated[int | None, Parameter(help="only engines with so many cylinders")] = None,
    layout: Annotated[
        str | None, Parameter(help="only engines of this layout: inline, vee, boxer, tandem, opposed, radial, explicit")
    ] = None,
) -> None:
    """List the engines of the catalog."""
    from crankstar.catalog import summaries
    from crankstar.description import catalog_table

    rows = summaries()
    kinds = sorted({row.layout for row in rows})
    if layout is not None and layout not in kinds:
        raise RequestError(f"--layout {one_line(layout)}: there is no such layout in the catalog; there are: {', '.join(kinds)}")
    found = [row for row in rows if cylinders in (None, row.cylinders) and layout in (None, row.layout)]
    if not found:
        raise RequestError("no engine of the catalog is like that; `crankstar list` shows all")
    display(catalog_table(found))


@app.command
def show(
    engine: EngineName,
    /,
    *,
    explicit: Annotated[bool, Parameter(help="as a complete engine file in the explicit form", negative=())] = False,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Show an engine: throws, cylinders, dead centres, firing, and where each value comes from."""
    from crankstar.description import description
    from crankstar.files import toml

    loaded = loaded_engine(engine, settings)
    if explicit:
        write(toml(loaded), output)
    else:
        display(description(loaded), output)


@app.command
def analyze(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    orders: Orders = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    at: Angles = None,
    by: Annotated[str | None, Parameter(help="also the share of each: cylinder, bank, shaft or kind (of part)")] = None,
    json: Annotated[bool, Parameter(help="the machine-readable answer, one object", negative=())] = False,
    csv: Annotated[bool, Parameter(help="the same numbers, a row per order", negative=())] = False,
    output: Output = None,
) -> None:
    """Inertia forces, couples and rolling moments of an engine, order by order."""
    from crankstar import answer
    from crankstar.balance import balance

    if json and csv:
        raise RequestError("--json and --csv: ask for one of them")
    if (json or csv) and (at or by):
        raise RequestError("--at and --by belong to the printed tables; leave them out with --json and --csv")
    loaded = loaded_engine(engine, settings)
    turning = request.speed(speed)
    point = request.reference(reference, loaded)
    if json or csv:
        result = balance(loaded, speed=loaded.speed if turning is None else turning, reference=point)
        wanted = request.orders(orders, result.force.orders.tolist())
        if csv:
            write(answer.csv_text(loaded.name, result, orders=wanted), output)
        else:
            write(answer.json_text(answer.tree(loaded.name, result, orders=wanted)), output)
        return
    from crankstar.tables import analysis, report

    shown = analysis(loaded, speed=turning, reference=point)
    wanted = request.orders(orders, shown.normalised.force.orders.tolist())
    shown = shown._replace(orders=tuple(wanted), turning=tuple(wanted)) if wanted else shown
    display(
        report(shown, wide=output is not None or terminal_width() >= WIDE, angles=request.angles(at), by=request.grouping(by)),
        output,
    )


@app.command
def compare(
    first: EngineName, second: EngineName, /, *others: EngineName, speed: Speed = None, orders: Orders = None, output: Output = None
) -> None:
    """Several engines side by side: the greatest force, couple and roll of each order."""
    from crankstar.tables import analysis, comparison

    at = request.speed(speed)
    shown = [analysis(loaded_engine(name, None), speed=at) for name in (first, second, *others)]
    wanted = request.orders(orders, shown[0].normalised.force.orders.tolist())
    display(comparison([one._replace(orders=tuple(wanted), turning=tuple(wanted)) for one in shown] if wanted else shown), output)


@app.command
def verdict(engine: EngineName, /, *, settings: Settings = None, output: Output = None) -> None:
    """The facts in short sentences: which orders are free, which remain, what removes them, how others do."""
    from crankstar.verdict import shown
    from crankstar.verdict import verdict as facts

    loaded = loaded_engine(engine, settings)
    display(shown(loaded, facts(loaded)), output)


@app.command
def strokes(
    engine: EngineName,
    /,
    *,
    settings: Settings = None,
    json: Annotated[bool, Parameter(help="the machine-readable answer, one object", negative=())] = False,
    output: Output = None,
) -> None:
    """Strokes and valve events of each cylinder, exhaust intervals, and which cylinders disturb each other."""
    from crankstar import answer
    from crankstar.fault import EngineError
    from crankstar.stroke_table import stroke_tables

    kind = "" if output in STANDARD_OUTPUT else PurePath(output or "").suffix.lower().removeprefix(".")
    if kind not in ("", "json", "txt"):
        raise RequestError(f"-o {one_line(output or '')}: let the name end in .json or .txt")
    loaded = loaded_engine(engine, settings)
    try:
        if json or kind == "json":
            write(answer.json_text(answer.strokes_tree(loaded)), output)
        else:
            display(stroke_tables(loaded), output)
    except EngineError as error:
        raise RequestError(f"{one_line(engine)}: {error}") from None


@app.command
def derive(
    engine: EngineName,
    /,
    *,
    order: Annotated[
        str | None,
        Parameter(name=["--order", "--orders"], allow_leading_hyphen=True, help="crank orders, as in 2 or 1,2,4; all is 1,2,4,6"),
    ] = None,
    quantity: Annotated[str | None, Parameter(help="force or couple; else both")] = None,
    form: Annotated[str, Parameter(name="--format", help="text, latex, markdown or html")] = "text",
    notation: Annotated[
        str | None, Parameter(help="letters: crankstar (r, l, λ = r/l), stroke (S, L = l/S) or sinitsyn (P_R, C_I, C_II, l0)")
    ] = None,
    power: Annotated[int | None, Parameter(help="highest power of λ in the series of each harmonic, else 7")] = None,
    symbolic: Annotated[
        str | None,
        Parameter(help="leave a dimension open: alpha (half the bank angle), phi (crank phase of a twin), n (cylinders in a row)"),
    ] = None,
    signs: Annotated[bool, Parameter(help="the six signs of balance instead: P_R, M_R, P_I, M_I, P_II, M_II", negative=())] = False,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Derive the closed form of each order, step by step, exactly: from one cylinder to the resultant."""
    from crankstar import derive as exact
    from crankstar.derive import documents, notations

    loaded = loaded_engine(engine, settings)
    turning = request.speed(speed)
    point = request.reference(reference, loaded)
    forms = ["text", *documents.FORMATS]
    if form not in forms:
        raise RequestError(f"--format {one_line(form)}: it can be {', '.join(forms)}")
    if power is not None and not 1 <= power <= 24:
        raise RequestError(f"--power {power}: give a power of λ from 1 to 24")
    given = {"--order": order, "--quantity": quantity, "--power": power, "--speed": speed, "--reference": reference}
    if signs:
        request.alone("--signs", {**given, "--reference": None, "--symbolic": symbolic})
    elif symbolic is not None:
        request.alone("--symbolic", {**given, "--order": None, "--quantity": None})
    wanted: list[tuple[Fraction, request.Derived]] = [
        (one, kind) for one in request.derived_orders("1,2" if order is None else order) for kind in request.quantities(quantity)
    ]
    try:
        letters = notations.chosen(("sinitsyn" if signs else "crankstar") if notation is None else notation)
        with working("deriving ...") as tell:
            chapters = [exact.signs_chapter(loaded, reference=point)] if signs else []
            for one, kind in [] if signs else wanted:
                tell(f"deriving the {kind} of order {one} ...")
                if symbolic is not None:
                    chapters.append(exact.family(loaded, one, kind, symbol=symbolic))
                else:
                    chapters.append(exact.derivation(loaded, one, kind, reference=point, speed=turning, power=power or 7).chapter)
    except exact.DerivationError as error:
        raise RequestError(str(error)) from None
    if form == "text":
        display(documents.rendered(chapters, letters), output)
    else:
        write(documents.FORMATS[form](chapters, letters), output)


@app.command
def errata(
    *,
    source: Annotated[str | None, Parameter(help="only of this source: its key in the references, such as yamamoto2012")] = None,
    output: Output = None,
) -> None:
    """What the sources got wrong: each printed formula beside the true one."""
    from crankstar.errata import ErrataError
    from crankstar.errata import errata as found
    from crankstar.misprints import errata_tables

    try:
        wanted = found(source)
    except ErrataError as error:
        raise RequestError(f"--source {one_line(source or '')}: {error}") from None
    display(errata_tables(wanted), output)
