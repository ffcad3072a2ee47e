"""The verb vees."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, cast, get_args

from cyclopts import Parameter

from crankstar.cli.options import Csv, Json, option, whole, write_engine
from crankstar.cli.output import working
from crankstar.cli.tabulating import give
from crankstar.engine.quantities import Cycle
from crankstar.language.messages import _, _n
from crankstar.options import values as request
from crankstar.options.forms import ENGINES, TABLES, form_of
from crankstar.options.values import refusal

Top = Annotated[int, option("--top")]
Row = Annotated[int | None, option("--row")]
Place = Annotated[
    str | None,
    option("--output", ".txt, .csv, .json, .xlsx or .parquet; with --row .toml, .json or .xlsx."),
]


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
