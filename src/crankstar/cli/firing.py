"""Verbs about firing: orders, vees."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, cast, get_args

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Settings,
    option,
    read_engine,
    whole,
    write_engine,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Cycle
from crankstar.language.messages import _, _n, passage
from crankstar.options import values as request
from crankstar.options.forms import ENGINES, TABLES, form_of
from crankstar.options.values import RequestError, refusal

if TYPE_CHECKING:
    from crankstar.firing.weighing import Weight
    from crankstar.studies.judged_orders import Judge
    from crankstar.tables.firing_orders import Listing

Top = Annotated[int, option("--top")]
Row = Annotated[int | None, option("--row")]
Place = Annotated[
    str | None,
    option("--output", ".txt, .csv, .json, .xlsx or .parquet; with --row .toml, .json or .xlsx."),
]


USUAL_HIGHEST = 3.0
"""Crank orders up to which firing orders are weighed by default."""
REASONS = 4
"""Dead centres that are named as the reason why nothing fires evenly."""


def orders(
    engine: EngineName,
    /,
    *,
    intervals: Annotated[str | None, option("--intervals")] = None,
    any_: Annotated[bool, option("--any")] = False,
    together: Annotated[bool, option("--together")] = False,
    tolerance: Annotated[str | None, option("--tolerance")] = None,
    minimise: Annotated[
        str | None,
        option(
            "--minimise",
            "Torque, roll or twist of the gas, stress of torsion, or load on the bearings; sorts "
            "the orders.",
        ),
    ] = None,
    crank_orders: Annotated[
        str | None, option("--orders", "For --minimise. Default: 0.5,1,1.5,2,2.5,3.")
    ] = None,
    mode_shape: Annotated[str | None, option("--mode-shape")] = None,
    point: Annotated[str | None, option("--point")] = None,
    top: Top = 20,
    row: Row = None,
    json: Json = False,
    csv: Csv = False,
    settings: Settings = None,
    output: Place = None,
) -> None:
    """List the firing orders that a crank can fire, with exhaust intervals and neighbours."""
    from crankstar.firing import numbering
    from crankstar.firing import orders as firing_orders
    from crankstar.firing.timetable import OrderError
    from crankstar.tables import firing_orders as tables

    form = _form(output, json=json, csv=csv, row=row, top=top)
    if any_:
        request.refuse_unused({"--intervals": intervals, "--tolerance": tolerance}, beside="--any")
    else:
        request.refuse_unused({"--together": together}, without="--any")
    given = {"--orders": crank_orders, "--mode-shape": mode_shape, "--point": point}
    if minimise is None:
        request.refuse_unused(given, without="--minimise")
    found = read_engine(engine, settings, ranged=False)
    loaded = found.engine
    try:
        with working(_("Trying firing orders ...")):
            if any_:
                listing = tables.Listing(
                    loaded, firing_orders.possible_orders(loaded, together=together)
                )
            elif intervals is not None or tolerance is not None:
                listing = _asked(loaded, intervals, tolerance)
            else:
                reasons = firing_orders.why_uneven(loaded)[:REASONS]
                listing = tables.Listing(
                    loaded,
                    firing_orders.most_even_orders(loaded),
                    passage(fault.sentence for fault in reasons),
                )
            if minimise is not None:
                listing = _weighed(listing, minimise, crank_orders, mode_shape, point)
    except OrderError as error:
        raise RequestError(f"{loaded.name}: {error}") from None
    if row is None:
        shown = top if form == "txt" else None
        give(tables.firing_orders(listing, limit=shown), output, form=form)
    else:
        fired = listing.orders[_index(row, listing.orders)].firing
        other = numbering.with_order(loaded, fired)
        words = _("fires {order}", order="-".join(map(str, fired.order)))
        write_engine(with_values(other, name=f"{loaded.name}, {words}"), found.tree, output)


def _weighed(
    listing: Listing, minimise: str, crank_orders: str | None, shape: str | None, point: str | None
) -> Listing:
    """The orders sorted by what is asked for."""
    from crankstar.firing.weighing import WEIGHTS
    from crankstar.studies.judged_orders import JUDGES

    what = request.choice("--minimise", minimise, (*WEIGHTS, *JUDGES))
    if shape is not None and what != "twist":
        raise RequestError("--mode-shape is for --minimise twist")
    if what not in JUDGES:
        return _summed(listing, cast("Weight", what), crank_orders, shape, point)
    if crank_orders is not None:
        raise RequestError("--orders is for --minimise torque, roll and twist")
    return _judged(listing, cast("Judge", what), point)


def _judged(listing: Listing, judge: Judge, point: str | None) -> Listing:
    """The orders sorted by the stress or the bearing load that they make."""
    from crankstar.mechanics.gas import cycle
    from crankstar.studies.judged_orders import FAILURES, judged
    from crankstar.tables.torque import load_sentence

    engine = listing.engine
    try:
        best, values = judged(engine, listing.orders, judge, point=point or "")
        load = load_sentence(cycle(engine, point=point or ""))
    except FAILURES as error:
        raise RequestError(f"{engine.name}: {error}") from None
    return listing._replace(orders=best, judged=values, judge=judge, load=load)


def _summed(
    listing: Listing, weight: Weight, crank_orders: str | None, shape: str | None, point: str | None
) -> Listing:
    """The orders sorted by the torque, roll or twist of these crank orders."""
    from crankstar.firing import weighing
    from crankstar.mechanics.gas import computable, cycle
    from crankstar.mechanics.gas_torque import HIGHEST, of_one_cylinder
    from crankstar.options.shapes import mode_shape
    from crankstar.tables.torque import load_sentence

    engine = listing.engine
    step = 360 / engine.cycle_angle
    there = [step * n for n in range(1, int(HIGHEST / step) + 1)]
    usual = [order for order in there if order <= USUAL_HIGHEST]
    wanted = usual if crank_orders is None else request.orders(crank_orders, there) or usual
    if any(order not in there for order in wanted):
        text = crank_orders or ""
        raise refusal("--orders", text, "gas torque has multiples of {step}", step=f"{step:g}")
    mode = None
    if weight == "twist":
        mode, amplitudes = mode_shape(shape, engine)
    else:
        amplitudes = weighing.even_shape(engine)
    sizes, load = None, ""
    if computable(engine):
        found = cycle(engine, point=point or "")
        sizes, load = of_one_cylinder(found, wanted), load_sentence(found)
    elif point is not None:
        raise RequestError("--point needs the bore and the firing order of the engine")
    sums = weighing.weighed(listing.orders, amplitudes, wanted, sizes)
    return listing._replace(orders=sums.orders, weighed=sums, weight=weight, load=load, mode=mode)


def _asked(engine: Engine, intervals: str | None, tolerance: str | None) -> Listing:
    """The orders with the given intervals, else the even ones, within a tolerance.

    Raises OrderError.
    """
    from crankstar.firing.orders import SAME_PLACE, orders_at
    from crankstar.tables.firing_orders import Listing

    count = len(engine.chambers)
    near = None if tolerance is None else request.degrees("--tolerance", tolerance)[0]
    even = (engine.cycle_angle / count,) * count
    wanted = (
        even if intervals is None else tuple(request.repeated("--intervals", intervals, of=count))
    )
    within = SAME_PLACE if near is None else near
    possible = orders_at(engine, intervals_deg=wanted, tolerance_deg=within)
    return Listing(engine, possible, asked_deg=wanted, tolerance_deg=near)


def vees(
    cylinders: Annotated[
        int, Parameter(help="Number of cylinders, even, up to 16.", converter=whole)
    ],
    /,
    *,
    bank: Annotated[str | None, option("--bank")] = None,
    greatest_split: Annotated[str | None, option("--greatest-split")] = None,
    cycle: Annotated[str, option("--cycle")] = "four-stroke",
    top: Top = 20,
    row: Row = None,
    star: Annotated[int, option("--star")] = 1,
    json: Json = False,
    csv: Csv = False,
    output: Place = None,
) -> None:
    """List V engines that fire evenly: bank angle, pin split, throws and balance."""
    from crankstar.firing import vees as engines
    from crankstar.tables.vee_engines import vee_engines

    form = _form(output, json=json, csv=csv, row=row, top=top)
    if row is None:
        request.refuse_unused({"--star": None if star == 1 else star}, without="--row")
    angles = None if bank is None else request.degrees("--bank", bank)
    split = (
        None if greatest_split is None else request.degrees("--greatest-split", greatest_split)[0]
    )
    stroke = cast("Cycle", request.choice("--cycle", cycle, get_args(Cycle)))
    with working(_("Trying cranks and bank angles ...")):
        solutions = engines.vees(
            cylinders=cylinders, bank_angles_deg=angles, greatest_split_deg=split, cycle=stroke
        )
    if row is None:
        shown = top if form == "txt" else None
        usual = angles is None and split is None
        give(vee_engines(solutions, limit=shown, only_multiples=usual), output, form=form)
    else:
        vee = solutions[_index(row, solutions)]
        place = _index(star, vee.stars, option="--star")
        write_engine(engines.engine_of(vee, star=place), None, output)


def _form(output: str | None, *, json: bool, csv: bool, row: int | None, top: int) -> str:
    """The form of a list, or that of the engine of a row. Raises RequestError."""
    if top < 1:
        raise refusal("--top", top, "give a number from 1 up")
    if row is None:
        return form_of(output, TABLES, json=json, csv=csv)
    request.refuse_unused({"--json": json, "--csv": csv}, beside="--row")
    return form_of(output, ENGINES)


def _index(row: int, rows: Sequence[object], *, option: str = "--row") -> int:
    """The place of a row, counted from 0. Raises RequestError."""
    if not rows:
        raise refusal(option, row, "the list is empty")
    if not 1 <= row <= len(rows):
        why = _n(
            "give 1; there is only one",
            "give a number from 1 to {count}",
            len(rows),
            count=len(rows),
        )
        raise refusal(option, row, why)
    return row - 1
