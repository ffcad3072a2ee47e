"""The verb tolerance: how far engines built to the tolerances of their file scatter."""

from __future__ import annotations

from dataclasses import asdict, replace
from functools import partial
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any

from crankstar.cli.options import (
    FLAT,
    Csv,
    EngineName,
    Estimating,
    Json,
    Looks,
    ReferencePoint,
    Settings,
    Speed,
    mark_speed,
    option,
    read_engine,
    together,
)
from crankstar.cli.output import complain, working, writable, write_bytes
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.language.messages import _
from crankstar.options import charts as chart_request
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, TABLES, form_of
from crankstar.options.refusals import choice
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.studies.scatter import Scatter

ABOUT_A_POINT = ("couple", "roll")
"""Quantities that hang on the point of reference."""


def tolerance(
    engine: EngineName,
    /,
    *,
    quantity: Annotated[
        str | None,
        option(
            "--quantity",
            "Also roll, torque, force.up, force.right, couple.pitch, couple.yaw; bearing: the "
            "loads on main bearings.",
        ),
    ] = None,
    orders: Annotated[str | None, option("--orders", "Default: those up to 6 that occur.")] = None,
    typical: Annotated[bool, option("--typical")] = False,
    distribution: Annotated[str, option("--distribution")] = "normal",
    builds: Annotated[int | None, option("--builds")] = None,
    seed: Annotated[int | None, option("--seed")] = None,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    looks: Annotated[Looks, FLAT] = Looks(),  # noqa: B008  # it is frozen
    output: Annotated[
        str | None,
        option(
            "--output",
            "A chart (.svg, .png, .pdf, .html) or a table (.csv, .json, .xlsx, .parquet, .txt).",
        ),
    ] = None,
) -> None:
    """Scatter the masses, lengths and angles of an engine within their tolerances."""
    kind = PurePath(output or "").suffix.lower().removeprefix(".")
    picture = kind in PICTURES and not (json or csv)
    if not picture:
        looks.refuse(_("a table"))
    form = kind if picture else form_of(output, (*TABLES, *PICTURES), json=json, csv=csv)
    paper = (
        chart_request.paper(kind, **asdict(looks)) if picture and chart_request.charts() else None
    )
    if output is not None:
        writable(output)
    names, found, tree = _scattered(
        engine,
        quantity=quantity,
        orders=orders,
        typical=typical,
        distribution=distribution,
        builds=builds,
        seed=seed,
        speed=speed,
        reference=reference,
        settings=settings,
        estimate=estimate,
    )
    mark_speed(speed, found.engine)
    if paper is not None:
        _draw(found, names, orders, kind, paper, output)
        return
    from crankstar.studies.answers import amplitudes
    from crankstar.tables.ranges import resting
    from crankstar.tables.scatter import scatter_document

    with words_for(form):
        every = orders is not None
        signals = names or None
        document = scatter_document(found, signals=signals, every=every)
        answered = partial(amplitudes, found.engine, speed=found.speed, reference=found.reference)
        document = resting(document, resting_on(form, found.engine, answered))
        if form == "xlsx":
            own = scatter_document(found, signals=signals, every=every)
            document = replace(document, parts=(*document.parts, *own.sentences))
    give(document, output, form=form, tree=tree)


def _scattered(
    engine: str,
    *,
    quantity: str | None,
    orders: str | None,
    typical: bool,
    distribution: str,
    builds: int | None,
    seed: int | None,
    speed: str | None,
    reference: str | None,
    settings: list[str] | None,
    estimate: bool,
) -> tuple[list[str], Scatter, dict[str, Any]]:
    """The signals that are asked for, the scatter, and the tree of the file.

    Raises RequestError and its like.
    """
    from crankstar.studies.builds import DEVIATION
    from crankstar.studies.fields import Source
    from crankstar.studies.linear_law import BEARING
    from crankstar.studies.scatter import (
        BUILDS,
        FEWEST_BUILDS,
        GREATEST_SEED,
        MOST_BUILDS,
        scatter_of,
    )

    loaded, names, wanted, turning, count, start, law = together(
        partial(read_engine, engine, settings, estimate=estimate, speed=speed, ranged=False),
        partial(_signals, quantity),
        partial(_orders, orders),
        partial(request.speed, speed),
        partial(request.within, "--builds", builds, least=FEWEST_BUILDS, most=MOST_BUILDS),
        partial(request.within, "--seed", seed, least=0, most=GREATEST_SEED),
        partial(choice, "--distribution", distribution, [*DEVIATION]),
    )
    if names and not any(name.startswith(ABOUT_A_POINT) for name in names):
        request.refuse_unused({"--reference": reference}, beside=f"--quantity {','.join(names)}")
    own = loaded.engine
    point = None if reference is None else points.reference(reference, own)
    with working(_("Building engines at random ...")) as tell:
        found = scatter_of(
            Source(loaded.name, loaded.tree, own),
            speed="file" if turning is None else turning,
            reference=point,
            orders=wanted,
            assume="typical" if typical else None,
            distribution=law,
            count=BUILDS if count is None else count,
            seed=1 if start is None else start,
            bearings=BEARING in names,
            tell=lambda done, of: tell(
                _("Building engines at random: {done} of {count} ...", done=done, count=of)
            ),
        )
    return names, found, loaded.tree


def _orders(orders: str | None) -> list[float] | None:
    return None if orders is None or orders.strip() == "all" else request.orders(orders, [])


def _signals(quantity: str | None) -> list[str]:
    from crankstar.studies.linear_law import BEARING
    from crankstar.studies.scatter import SIGNALS

    names = [*dict.fromkeys(request.listed(quantity))]
    if quantity is not None and not names:
        raise RequestError("--quantity: give at least one quantity, such as force,couple")
    return [choice("--quantity", name, (*SIGNALS, BEARING)) for name in names]


def _draw(
    found: Scatter, names: list[str], orders: str | None, kind: str, paper: Any, output: str | None
) -> None:
    """Write the chart of a scatter."""
    drawing = chart_request.charts()
    title = _("{engine}: built to its tolerances", engine=found.engine.name)
    draw = partial(
        drawing.scatter_chart, found, quantities=names, orders=found.orders if orders else ()
    )
    printed = drawing.printed(draw, paper, title=title)
    write_bytes(drawing.saved_print(printed, kind, title=title), output)
    for line in printed.chart.notes:
        complain(line)
