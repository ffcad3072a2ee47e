"""The verb match: pistons, pins and rods of a batch assigned to the cylinders of an engine."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from os.path import realpath
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Output,
    Settings,
    Speed,
    option,
    read_engine,
    together,
    write_engine,
)
from crankstar.cli.output import complain, progress, writable
from crankstar.cli.tabulating import give, words_for
from crankstar.engine.copies import with_values
from crankstar.engine.quantities import MASS
from crankstar.files.lists import read_list
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import ENGINES, TABLES, form_of, suffix_of
from crankstar.options.refusals import refusal
from crankstar.options.workshop import size

if TYPE_CHECKING:
    from crankstar.studies.matched_orders import Minimised
    from crankstar.studies.part_weights import Batch

MOST_ENGINES = 100
MOST_ORDERS = 24
WEIGHTS = "CSV file (or .xlsx) with the weights: columns no., piston, pin, small end, big end."


def match(
    engine: EngineName,
    weights: Annotated[str, Parameter(help=WEIGHTS)],
    /,
    *,
    orders: Annotated[str | None, option("--orders", "Default: 1,2.")] = None,
    quantity: Annotated[
        str | None, option("--quantity", "Force, couple, or both (the default).")
    ] = None,
    engines: Annotated[int | None, option("--engines")] = None,
    classes: Annotated[str | None, option("--classes")] = None,
    whole: Annotated[bool, option("--whole")] = False,
    speed: Speed = None,
    settings: Settings = None,
    engine_file: Annotated[str | None, option("--engine-file")] = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Match weighed pistons, pins and rods to the cylinders."""
    from crankstar.stars.interrupts import signals_noted
    from crankstar.studies.matched_sets import divided
    from crankstar.studies.matching import matched
    from crankstar.tables.matching import division_document, matching_document

    form = form_of(output, TABLES, json=json, csv=csv)
    batch, source, turning, wanted, of, widths, count, places = together(
        partial(_batch, weights),
        partial(read_engine, engine, settings, ranged=False),
        partial(request.speed, speed),
        partial(_orders, orders),
        partial(_quantities, quantity),
        partial(_widths, classes),
        partial(request.within, "--engines", engines, most=MOST_ENGINES),
        partial(_engine_files, engine_file, engines or 1, apart=(engine, weights, output)),
    )
    if output is not None:
        writable(output)
    loaded = source.engine
    own = turning or loaded.speed
    rest = {"orders": wanted, "quantities": of, "classes": widths, "whole": whole}
    with (
        signals_noted() as stop,
        progress(_("Matching the parts to the cylinders ...")) as show,
        words_for(form),
    ):

        def watch(done: int, of_all: int) -> bool:
            show(done, of_all, "")
            return not stop.is_set()

        if count in (None, 1):
            found = matched(loaded, batch, **rest, watch=watch)
            document = matching_document(loaded, batch, found, speed=own)
            built = [found.engine]
        else:
            division = divided(loaded, batch, engines=count, **rest, watch=watch)
            document = division_document(loaded, batch, division, speed=own)
            built = [each.engine for each in division.engines]
        if stop.is_set():
            complain(_("Interrupted: what follows is the best so far, and not proved."))
    for at, (each, place) in enumerate(zip(built, places, strict=False), 1):
        write_engine(
            with_values(each, name=_name(loaded.name, at, len(built))),
            source.tree,
            place,
            option="--engine-file",
        )
    give(document, output, form=form)


def _name(name: str, at: int, count: int) -> str:
    return (
        _("{engine}, parts matched", engine=name)
        if count == 1
        else _("{engine}, parts matched, no. {number}", engine=name, number=at)
    )


def _batch(place: str) -> Batch:
    """The batch of a list. Raises ListError."""
    from crankstar.studies.part_weights import batch_of

    return batch_of(read_list(place))


def _orders(text: str | None) -> list[float]:
    if text is None:
        return [1.0, 2.0]
    wanted = request.orders(text, [])
    if not wanted or len(wanted) > MOST_ORDERS:
        raise refusal("--orders", text, "give up to {most} orders, as in 1,2", most=MOST_ORDERS)
    return wanted


def _quantities(text: str | None) -> tuple[Minimised, ...]:
    both: tuple[Minimised, ...] = ("force", "couple")
    if text is None:
        return both
    named = [request.choice("--quantity", name, both) for name in request.listed(text) or [text]]
    return tuple(name for name in both if name in named)


def _widths(text: str | None) -> list[float]:
    from crankstar.studies.matching import CLASSES

    if text is None:
        return [*CLASSES]
    parts = request.listed(text)
    if not 1 <= len(parts) <= 12:
        raise refusal("--classes", text, 'give up to 12 widths, as in "1 g, 5 g"')
    return [size("--classes", part, MASS) for part in parts]


def _engine_files(place: str | None, count: int, *, apart: Sequence[str | None]) -> list[str]:
    """The files of the engines, of several each with its number.

    Raises RequestError for a name under which no engine can be written, or that of a file that is
    read or written besides.
    """
    if place is None:
        return []
    if suffix_of(place) not in ENGINES:
        raise refusal("--engine-file", place, "the name must end in .toml, .json or .xlsx")
    path = PurePath(place)
    several = [f"{path.stem}-{number}{path.suffix}" for number in range(1, count + 1)]
    places = [place] if count == 1 else [str(path.with_name(name)) for name in several]
    for each in places:
        if any(realpath(each) == realpath(other) for other in apart if other is not None):
            raise refusal(
                "--engine-file",
                each,
                "it is read or written besides and would be lost; name another",
            )
        writable(each, option="--engine-file")
    return places
