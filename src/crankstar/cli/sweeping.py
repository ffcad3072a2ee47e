"""The verb that varies one or two values of an engine: sweep."""

from __future__ import annotations

from collections.abc import Sequence
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
    written_tree,
)
from crankstar.cli.output import complain, working, writable, write_bytes
from crankstar.cli.tabulating import give
from crankstar.files.changes import path_and_value
from crankstar.files.read_files import STANDARD_INPUT
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import charts as chart_request
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, TABLES, form_of
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.studies.best_pair import Unbeaten
    from crankstar.studies.sweep import Curve, Sweep


def sweep(
    engine: EngineName,
    /,
    *,
    over: Annotated[list[str], option("--over")],
    quantity: Annotated[
        str,
        option(
            "--quantity",
            "Also roll, torque, couple.pitch, couple.yaw, force.forward, ...; of gas "
            "torque_with_gas, roll_with_gas, mean_torque, peak_pressure, irregularity; "
            "of torsion torsion_frequency, torsion_stress, torsion_amplitude; on the mounts "
            "mount_mode_1 to mount_mode_6, mount_roll_mode, mount_roll_share, mount_force (net, on "
            "the ground), mount_velocity.",
        ),
    ] = "force",
    orders: Annotated[str | None, option("--orders", "Default: the sum of all orders.")] = None,
    greatest: Annotated[bool, option("--greatest")] = False,
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
    """Vary one or two values of an engine: force and couple over them, and the best values."""
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
    made = _Made(
        *_swept(engine, over, quantity, orders, speed, reference, settings, estimate), greatest
    )
    mark_speed(speed, made.sweep.engine)
    if paper is not None:
        _draw(made, kind, paper, output)
        return
    document = made.document(form)
    if form not in ("csv", "parquet"):  # forms of tables alone
        from crankstar.tables.sweep_notes import rested

        document = rested(document, made.sweep, made.curves)
    tree = None
    if form == "xlsx":
        if engine != STANDARD_INPUT:
            found = read_engine(engine, settings, estimate=estimate, speed=speed, ranged=False)
            tree = written_tree(found.engine, found.tree)
        document = replace(document, parts=(*document.parts, *made.document("txt").sentences))
    give(document, output, form=form, tree=tree)
    if form in ("csv", "parquet"):
        for line in made.doubts():
            complain(line)


def _swept(
    engine: str,
    over: Sequence[str],
    quantity: str,
    orders: str | None,
    speed: str | None,
    reference: str | None,
    settings: list[str] | None,
    estimate: bool,
) -> tuple[Sweep, list[Curve]]:
    """The sweep that is asked for, and its curves: each quantity of each order."""
    from crankstar.studies import sweep as sweeps

    wanted, turning, changes = together(
        partial(_orders, orders), partial(request.speed, speed), partial(request.settings, settings)
    )
    names = [*dict.fromkeys(request.listed(quantity))]
    if not names:
        raise RequestError("--quantity: give at least one quantity, such as force,couple")
    sweeps.check_watchable(*names)
    _refuse_idle(names, speed=speed, reference=reference)
    point = None
    if reference is not None:
        loaded = read_engine(engine, settings, estimate=estimate).engine
        point = points.reference(reference, loaded)
    what = one_line(", ".join(path_and_value(text)[0] for text in over), longest=80)
    with working(_("Sweeping {path} ...", path=what)) as tell:
        swept = sweeps.sweep(
            engine,
            over,
            changes=changes,
            reference=point,
            estimate=estimate,
            orders=wanted,
            speed="file" if turning is None else turning,
            tell=lambda done, of: tell(
                _("Sweeping {path}: engine {done} of {count} ...", path=what, done=done, count=of)
            ),
        )
    return swept, [
        sweeps.watched(swept, name, order=number) for name in names for number in wanted or [None]
    ]


def _refuse_idle(names: Sequence[str], *, speed: str | None, reference: str | None) -> None:
    """Refuse options that no quantity depends on. Raises RequestError."""
    from crankstar.studies.sweep_answers import kind_of

    kinds = {kind_of(name) for name in names}
    watched = ", ".join(names)
    if not kinds & {"inertia", "roll"}:
        request.refuse_unused({"--reference": reference}, beside=watched)
    if all(kind.endswith("modes") for kind in kinds):
        request.refuse_unused({"--speed": speed}, beside=watched)


def _orders(orders: str | None) -> list[float] | None:
    wanted = request.orders(orders, [])
    if orders is not None and not wanted:
        raise RequestError(
            "--orders all: omit --orders for the sum of all orders, or give orders such as 1,2"
        )
    return wanted


class _Made:
    """A sweep with its curves, their best values and, of two numbers and two results, the front."""

    def __init__(self, swept: Sweep, curves: list[Curve], greatest: bool) -> None:
        from crankstar.studies.best_pair import best_pair, front
        from crankstar.studies.best_value import best
        from crankstar.tables.sweep_ranges import bands

        self.sweep, self.curves, self.greatest = swept, curves, greatest
        self.pair = len(swept.axes) == 2
        find: Any = best_pair if self.pair else best
        self.bests: list[Any] = [find(swept, curve, greatest=greatest) for curve in curves]
        self.front: Sequence[Unbeaten] = ()
        self.bands = bands(swept, curves, self.bests, greatest=greatest)
        if self.pair and len(curves) == 2:
            self.front = front(swept, curves[0], curves[1], greatest=greatest)

    def doubts(self) -> list[str]:
        """What is hardly right at some of the values."""
        from crankstar.tables.sweep_notes import doubt_sentences

        return doubt_sentences(self.sweep, self.curves)

    def document(self, form: str) -> Document:
        """The tables of the sweep, for readers (txt) or for machines."""
        from crankstar.tables import pair_sweeps, sweeps

        if form in ("csv", "parquet"):
            return sweeps.amplitudes(self.sweep, self.curves, self.bands)
        made, curves, bests = self.sweep, self.curves, self.bests
        if self.pair:
            if form == "txt":
                return pair_sweeps.pair_document(
                    made, curves, bests, self.front, greatest=self.greatest
                )
            return pair_sweeps.answer(made, curves, bests, self.front)
        if form == "txt":
            return sweeps.sweep_document(
                made, curves, bests, bands=self.bands, greatest=self.greatest
            )
        return sweeps.answer(made, curves, bests, bands=self.bands)


def _draw(made: _Made, kind: str, paper: Any, output: str | None) -> None:
    """Write the chart of a sweep."""
    from crankstar.tables.field_names import field_name

    drawing = chart_request.charts()
    title = _(
        "{engine}: {curves} over {path}",
        engine=made.sweep.engine.name,
        curves=drawing.names_of(made.curves),
        path=", ".join(field_name(axis.path) for axis in made.sweep.axes),
    )
    options: dict[str, Any] = {"best": made.bests}
    if made.pair:
        options["front"] = made.front
    else:
        options["bands"] = made.bands
    draw = partial(
        drawing.contours if made.pair else drawing.swept, made.sweep, made.curves, **options
    )
    printed = drawing.printed(draw, paper, title=title)
    write_bytes(drawing.saved_print(printed, kind, title=title), output)
    for line in printed.chart.notes:
        complain(line)
