"""Verbs that list what can fire: orders, vees."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from crankstar import request
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, loaded_engine
from crankstar.engine import Engine
from crankstar.output import STANDARD_OUTPUT, display, working, write
from crankstar.quantity import one_line
from crankstar.request import RequestError

if TYPE_CHECKING:
    from crankstar.order_tables import Listing

Limit = Annotated[int, Parameter(help="how many rows to show; --csv and --json have all")]
Row = Annotated[int | None, Parameter(help="write this row as an engine file, in the explicit form, instead of the table")]
Json = Annotated[bool, Parameter(help="all rows, one object", negative=())]
Csv = Annotated[bool, Parameter(help="all rows as CSV", negative=())]
Place = Annotated[
    str | None,
    Parameter(name=["--output", "-o"], help="file to write: .txt for the table, .csv, .json, or with --row the engine file, .toml"),
]

KINDS = ("", "csv", "json", "txt")
"""Endings of the files that lists are written to; a device or a pipe has none."""


@app.command
def orders(
    engine: EngineName,
    /,
    *,
    intervals: Annotated[
        str | None,
        Parameter(help='only orders with these intervals, repeated to fill the cycle, as in "90, 150 deg"; 0 for firing at once'),
    ] = None,
    any_: Annotated[
        bool, Parameter(name="--any", help="every order the dead centres allow, even or not, most even first", negative=())
    ] = False,
    together: Annotated[
        bool, Parameter(help="with --any: cylinders at dead centre together may fire together", negative=())
    ] = False,
    tolerance: Annotated[
        str | None, Parameter(help='how far a firing may be from its place in the cycle, as in "2 deg"; else 0.0001 deg')
    ] = None,
    limit: Limit = 20,
    row: Row = None,
    json: Json = False,
    csv: Csv = False,
    settings: Settings = None,
    output: Place = None,
) -> None:
    """Firing orders that a crank can fire: evenly, at given intervals or at any; banks, neighbours, throws."""
    from crankstar import order_tables as tables
    from crankstar.answer import json_text
    from crankstar.search import numbering
    from crankstar.search import orders as firing_orders
    from crankstar.search.timetable import OrderError

    kind = _kind(output, json=json, csv=csv, row=row, limit=limit)
    if any_:
        request.alone("--any", {"--intervals": intervals, "--tolerance": tolerance})
    else:
        request.alone("a list without --any", {"--together": together or None})
    loaded = loaded_engine(engine, settings)
    try:
        with working("trying firing orders ..."):
            if any_:
                listing = tables.Listing(loaded, firing_orders.possible_orders(loaded, together=together))
            elif intervals is not None or tolerance is not None:
                listing = _asked(loaded, intervals, tolerance)
            else:
                listing = tables.Listing(loaded, firing_orders.most_even_orders(loaded), firing_orders.why_uneven(loaded))
    except OrderError as error:
        raise RequestError(f"{loaded.name}: {error}") from None
    if row is not None:
        write(_file(numbering.with_order(loaded, listing.orders[_index(row, listing.orders)].firing)), output)
    elif kind == "csv":
        write(tables.orders_csv(listing), output)
    elif kind == "json":
        write(json_text(tables.orders_tree(listing)), output)
    else:
        display(tables.orders_table(listing, limit=limit), output)


def _asked(engine: Engine, intervals: str | None, tolerance: str | None) -> Listing:
    """The orders with the intervals that are asked for, else the even ones, within a tolerance. Raises OrderError."""
    from crankstar.order_tables import Listing
    from crankstar.search.orders import SAME_PLACE, orders_at

    count = len(engine.chambers)
    near = None if tolerance is None else request.degrees("--tolerance", tolerance)[0]
    even = (engine.cycle_angle / count,) * count
    wanted = even if intervals is None else tuple(request.repeated("--intervals", intervals, of=count))
    found = orders_at(engine, intervals_deg=wanted, tolerance_deg=SAME_PLACE if near is None else near)
    return Listing(engine, found, asked_deg=wanted, tolerance_deg=near)


@app.command
def vees(
    cylinders: Annotated[int, Parameter(help="how many cylinders, an even number up to 16")],
    /,
    *,
    bank: Annotated[
        str | None, Parameter(help='bank angles, as in "60 deg, 90 deg"; else the multiples of the firing interval up to 180 deg')
    ] = None,
    greatest_split: Annotated[
        str | None,
        Parameter(
            help='how far pins may be split, as in "30 deg", 0 for not at all; else as far as it takes. Without --bank, the usual '
            "bank angles that need no more are tried too"
        ),
    ] = None,
    two_stroke: Annotated[bool, Parameter(help="two-stroke engines; else four-stroke", negative=())] = False,
    limit: Limit = 20,
    row: Row = None,
    star: Annotated[
        int, Parameter(help="with --row: which of the stars with this balance, mirror images and reverses not counted, as in --csv")
    ] = 1,
    json: Json = False,
    csv: Csv = False,
    output: Place = None,
) -> None:
    """V engines that fire evenly, crank and bank together: bank angle, pin split, throws, and their balance."""
    from crankstar import vee_tables as tables
    from crankstar.answer import json_text
    from crankstar.search import vees as engines
    from crankstar.search.timetable import OrderError

    kind = _kind(output, json=json, csv=csv, row=row, limit=limit)
    if row is None:
        request.alone("a list without --row", {"--star": None if star == 1 else star})
    angles = None if bank is None else request.degrees("--bank", bank)
    split = None if greatest_split is None else request.degrees("--greatest-split", greatest_split)[0]
    cycle = "two-stroke" if two_stroke else "four-stroke"
    try:
        with working("trying cranks and bank angles ..."):
            found = engines.vees(cylinders=cylinders, bank_angles_deg=angles, greatest_split_deg=split, cycle=cycle)
    except OrderError as error:
        raise RequestError(str(error)) from None
    if row is not None:
        one = found[_index(row, found)]
        place = _index(star, one.stars, option="--star", besides=", mirror images and reverses not counted")
        write(_file(engines.engine_of(one, star=place)), output)
    elif kind == "csv":
        write(tables.vees_csv(found), output)
    elif kind == "json":
        write(json_text(tables.vees_tree(found)), output)
    else:
        display(tables.vees_table(found, limit=limit, only_multiples=angles is None and split is None), output)


def _kind(output: str | None, *, json: bool, csv: bool, row: int | None, limit: int) -> str:
    """In which form to write: csv, json, or else a table; as asked for, or as the name of the file says."""
    asked = [name for name, wanted in (("--json", json), ("--csv", csv)) if wanted]
    if len(asked) > 1:
        raise RequestError("--json and --csv: ask for one of them")
    if row is not None:
        request.alone("--row", dict.fromkeys(asked, True))
    if limit < 1:
        raise RequestError(f"--limit {limit}: give a number from 1 up")
    kind = "" if output in STANDARD_OUTPUT else PurePath(output or "").suffix.lower().removeprefix(".")
    if row is not None and kind not in ("", "toml"):
        raise RequestError(f"-o {one_line(output or '')}: let the name of the engine file end in .toml")
    if row is None and not asked and kind not in KINDS:
        raise RequestError(f"-o {one_line(output or '')}: let the name end in .csv, .json, .txt; or in .toml with --row")
    return asked[0].removeprefix("--") if asked else kind


def _index(row: int, of: Any, *, option: str = "--row", besides: str = "") -> int:
    """The place of a row, counted from 0; `besides`: what is not among those that are counted. Raises RequestError."""
    if not 1 <= row <= len(of):
        told = f"there {'is' if len(of) == 1 else 'are'} {len(of) or 'none'}{besides}"
        give = f"; give {'1' if len(of) == 1 else f'a number from 1 to {len(of)}'}" if of else ""
        raise RequestError(f"{option} {row}: {told}{give}")
    return row - 1


def _file(engine: Engine) -> str:
    """An engine file, which is never written where it could not be read again."""
    from crankstar.files import engine_of, toml, tree_of

    text = toml(engine)
    engine_of(tree_of(text))
    return text
