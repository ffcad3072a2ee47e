"""The verb torsion: how a crankshaft or a drive line twists and vibrates."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    Estimating,
    Json,
    Output,
    Settings,
    Speed,
    engine_or_chain,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.speed_ranges import speeds_of
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.torsion import Chain
from crankstar.language.messages import _, _n
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.gas import gas_orders
from crankstar.options.refusals import refusal
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.tables.table import Document

HELP = (
    "Name from the catalog, engine file with a table [torsion], or file of a drive line with discs "
    "alone; - for standard input."
)
MOST_MODES = 300


def torsion(
    engine: Annotated[str, Parameter(help=HELP)],
    /,
    *,
    point: Annotated[str | None, option("--point")] = None,
    speed: Speed = None,
    speeds: Annotated[str | None, option("--speeds", "Default: those of the file.")] = None,
    orders: Annotated[str | None, option("--orders", "Default: up to 24.")] = None,
    modes: Annotated[int | None, option("--modes", "Default: 4.")] = None,
    holzer: Annotated[int | None, option("--holzer")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute torsional vibration: modes, critical speeds, response and stress of a crankshaft."""
    from crankstar.dynamics.torsion_analysis import torsion as analysis
    from crankstar.studies.response_answers import twist
    from crankstar.tables.ranges import ranged
    from crankstar.tables.table import with_tables
    from crankstar.tables.torsion import torsion_document

    form = form_of(output, TABLES, json=json, csv=csv)
    if speed is not None and ".." in speed and speeds is None:
        speed, speeds = None, speed
    (source, spread), turning, over, wanted, most, table = together(
        partial(engine_or_chain, engine, settings, estimate=estimate),
        partial(request.speed, speed),
        partial(speeds_of, speeds),
        partial(gas_orders, None if orders and orders.strip() == "all" else orders),
        partial(request.within, "--modes", modes, most=MOST_MODES),
        partial(request.within, "--holzer", holzer, most=MOST_MODES),
    )
    if isinstance(source, Chain):
        engines_only = {"--point": point, "--speed": speed, "--estimate": estimate}
        request.refuse_unused(engines_only, beside=_("a drive line without cylinders"))
        if wanted and not over and source.speed is None:
            raise RequestError(
                "--orders: a drive line without a speed has critical speeds in a range alone; give "
                '--speeds, such as "300..3000 rpm by 10"'
            )

    def sheet(each: Engine | Chain, *, machine: bool) -> Document:
        found = analysis(
            each, point=point or "", speed=turning, speeds=over, orders=wanted, modes=most
        )
        if table is not None and table > len(found.modes):
            count = len(found.modes)
            why = _n("there is one mode", "there are {count} modes", count, count=count)
            raise refusal("--holzer", table, why)
        return torsion_document(
            each, found, modes=most, holzer_of=table, orders=wanted, machine=machine
        )

    def made(*, machine: bool) -> Document:
        build = partial(sheet, machine=machine)
        if isinstance(source, Chain):
            return build(source)
        answered = partial(twist, source, point=point or "", speed=turning, speeds=over)
        return ranged(build, spread, source, rests=resting_on(form, source, answered))

    with working(_("Computing torsional vibration ...")), words_for(form):
        document = made(machine=form not in ("txt", "xlsx"))
        if form == "xlsx":
            document = with_tables(document, made(machine=True))
    give(document, output, form=form)
