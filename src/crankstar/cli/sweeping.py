"""The verb that varies one or two values of an engine: sweep."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, replace
from functools import partial
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

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
    beside,
    engine_read,
    mark_speed,
    once,
    option,
    or_none,
    read_engine,
    together,
    written_tree,
)
from crankstar.cli.output import complain, working, writable, write_bytes
from crankstar.cli.tabulating import give
from crankstar.files.catalog import tree_of
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
    from crankstar.mechanics.excitation import Reference
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

    def read_form() -> str:
        return kind if picture else form_of(output, (*TABLES, *PICTURES), json=json, csv=csv)

    def read_paper() -> Any:
        if not picture:
            looks.refuse(_("a table"))
            return None
        return chart_request.paper(kind, **asdict(looks)) if chart_request.charts() else None

    form, paper, _place, asked = together(
        read_form,
        read_paper,
        lambda: None if output is None else writable(output),
        partial(_asked, engine, over, quantity, orders, speed, reference, settings, estimate),
    )
    made = _Made(*_swept(engine, over, asked, estimate=estimate), greatest)
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


class _Asked(NamedTuple):
    """What is asked of a sweep: quantities, orders, speed (rad/s), values that are set, point."""

    names: Sequence[str]
    orders: Sequence[float] | None
    speed: float | None
    changes: dict[str, Any]
    point: Reference | None


def _asked(
    engine: str,
    over: Sequence[str],
    quantity: str,
    orders: str | None,
    speed: str | None,
    reference: str | None,
    settings: list[str] | None,
    estimate: bool,
) -> _Asked:
    """The options of the sweep. Raises RequestError with every mistake in them."""
    load = once(partial(read_engine, engine, settings, estimate=estimate))

    def read_point() -> Reference | None:
        if reference is None:
            return None
        return points.reference(reference, engine_read(load))

    def read() -> _Asked:
        asked = together(
            partial(_names, quantity, speed=speed, reference=reference),
            partial(_orders, orders),
            partial(request.speed, speed),
            partial(request.settings, settings),
            read_point,
            partial(_check_over, over, settings),
            *([load] if reference is not None else []),
        )
        return _Asked(*asked[: len(_Asked._fields)])

    return beside(read, partial(tree_of, engine))


def _names(quantity: str, *, speed: str | None, reference: str | None) -> list[str]:
    """The quantities. Raises RequestError, and SweepError for what no sweep has."""
    from crankstar.studies.sweep import check_watchable

    names = [*dict.fromkeys(request.listed(quantity))]
    if not names:
        raise RequestError("--quantity: give at least one quantity, such as force,couple")
    check_watchable(*names)
    _refuse_idle(names, speed=speed, reference=reference)
    return names


def _check_over(over: Sequence[str], settings: Sequence[str] | None) -> None:
    """Refuse what cannot be varied in any engine. Raises SweepError."""
    from crankstar.studies.ranges import check_axes, over_request
    from crankstar.studies.study import check_apart

    check_axes(len(over), option="--over")
    found = together(*(partial(over_request, text) for text in over))
    with _told_of_over():
        check_apart(
            [each.path for each in found], or_none(partial(request.settings, settings)) or {}
        )


@contextmanager
def _told_of_over() -> Iterator[None]:
    """Have what is wrong with numbers that are varied told as of their option."""
    from crankstar.studies.variants import OverError

    try:
        yield
    except OverError as error:
        raise RequestError(f"--over: {error}") from None


def _swept(
    engine: str, over: Sequence[str], asked: _Asked, *, estimate: bool
) -> tuple[Sweep, list[Curve]]:
    """The sweep that is asked for, and its curves: each quantity of each order."""
    from crankstar.studies import sweep as sweeps

    what = one_line(", ".join(path_and_value(text)[0] for text in over), longest=80)
    with working(_("Sweeping {path} ...", path=what)) as tell, _told_of_over():
        swept = sweeps.sweep(
            engine,
            over,
            changes=asked.changes,
            reference=asked.point,
            estimate=estimate,
            orders=asked.orders,
            speed="file" if asked.speed is None else asked.speed,
            tell=lambda done, of: tell(
                _("Sweeping {path}: engine {done} of {count} ...", path=what, done=done, count=of)
            ),
        )
    return swept, [
        sweeps.watched(swept, name, order=number)
        for name in asked.names
        for number in asked.orders or [None]
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
