"""The verb that searches: search."""

from __future__ import annotations

from functools import partial
from importlib.util import find_spec
from pathlib import PurePath
from types import ModuleType
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from crankstar import chart_request, request
from crankstar.answer import json_text
from crankstar.cli.application import app
from crankstar.cli.options import Settings, Speed, loaded_engine
from crankstar.engine import Engine
from crankstar.output import STANDARD_OUTPUT, complain, display, working, writable, write, write_bytes
from crankstar.quantity import one_line
from crankstar.request import RequestError

if TYPE_CHECKING:
    from crankstar.search.findings import Finding, Findings

TABLES = ("csv", "json", "parquet")
PICTURES = ("svg", "png", "pdf", "html")


def _text(told: str) -> Parameter:
    return Parameter(help=told, allow_leading_hyphen=True)


def _flag(told: str) -> Parameter:
    return Parameter(help=told, negative=())


@app.command
def search(
    cylinders: Annotated[str, Parameter(help="how many cylinders, or an in-line engine (name or file) whose cylinders they are")],
    /,
    *,
    cycle: Annotated[str | None, _text("two-stroke or four-stroke; else four-stroke, or what the engine is")] = None,
    minimise: Annotated[
        str | None,
        Parameter(
            name=["--minimise", "--minimize"],
            help="what to make least: couples M1, M2, ..., forces F1, ..., torsion T1.5, ..., neighbours (that fire one after the "
            "other), couple (rms of all orders of an engine); else M1,M2. With --best weights may be given, as in M1,2*M2",
        ),
    ] = None,
    zero: Annotated[str | None, _text("what is to vanish exactly, as in M2")] = None,
    limit: Annotated[list[str] | None, _flag("what may be at most so great, as in M2=1.5 or neighbours=1")] = None,
    pitch: Annotated[str | None, _text("gaps between cylinders from the front, in pitches, as in 1,1,1.4,1; else equal")] = None,
    fix: Annotated[str | None, _text("throws that stay, as in 1=0,4=3: direction d is 360 d/n deg behind direction 0")] = None,
    symmetric: Annotated[bool, _flag("only cranks whose rear half is the image of the front half")] = False,
    mode_shape: Annotated[str | None, _text("for T: amplitude of the torsional mode at each cylinder")] = None,
    avoid_adjacent: Annotated[bool, _flag("no neighbours may fire one after the other")] = False,
    front: Annotated[bool, _flag("all values of which none can be bettered without another getting worse")] = False,
    best: Annotated[str | None, _text("so many of the best")] = None,
    every: Annotated[bool, Parameter(name="--all", help="all stars within the limits", negative=())] = False,
    all_with: Annotated[
        str | None, _text("all stars with the same moments as a firing order, 1-6-3-4-5-2-7, or with M1=0.2673,M2=1.0056")
    ] = None,
    speed: Speed = None,
    settings: Settings = None,
    workers: Annotated[str | None, _text("processes of this machine; else one for each processor")] = None,
    scheduler: Annotated[str | None, _text("a dask scheduler whose workers do the work, as in tcp://host:8786")] = None,
    checkpoint: Annotated[str | None, _text("file in which the search is kept, and from which it goes on")] = None,
    yes: Annotated[bool, _flag("search even if it takes more than an hour")] = False,
    row: Annotated[str | None, _text("write this row as an engine file instead (-o FILE.toml)")] = None,
    uneven: Annotated[
        str | None, _text("refine the angles of --row, with firing intervals within these of even ones, as in 1,2,5 (degrees)")
    ] = None,
    chart: Annotated[str | None, _text("a picture: front, or stars (of the first rows)")] = None,
    csv: Annotated[bool, _flag("all rows as CSV")] = False,
    json: Annotated[bool, _flag("all rows, and what proves them, as JSON")] = False,
    output: Annotated[
        str | None,
        Parameter(
            name=["--output", "-o"],
            help="file to write: .csv, .json or .parquet (all rows), .txt, .svg, .png, .pdf or .html (picture), .toml (with --row)",
        ),
    ] = None,
) -> int | None:
    """Find the better crank: all ways to set cylinders on evenly spaced throws, searched to the end and proved complete."""
    from crankstar.star_request import whole_number

    wishes = _wishes()
    line = wishes.whole("--row", row)
    crew = wishes.whole("--workers", workers, most=1024)
    for option, text in (("--checkpoint", checkpoint), ("--scheduler", scheduler), ("--pitch", pitch), ("--fix", fix)):
        if text is not None and not text.strip():
            raise RequestError(f"{option}: says nothing; leave it out, or see crankstar search --help")
    kind = _kind(output=output, row=line, chart=chart, uneven=uneven, csv=csv, json=json)
    deviations = wishes.deviations(uneven) if uneven is not None else None
    number = whole_number(cylinders)
    if number is not None:
        request.alone("a number of cylinders", {"--set": settings or None, "--speed": speed})
    about = loaded_engine(cylinders, settings) if number is None else number
    pace = request.speed(speed) or (about.speed if isinstance(about, Engine) else None)
    wish = wishes.Wish(
        minimise, zero, tuple(limit or ()), pitch, fix, mode_shape, symmetric, avoid_adjacent, front, best, every, all_with
    )
    wanted = wishes.request(about, cycle, wish, speed=pace)
    wishes.check_use(wanted.question, chart=chart if chart or kind not in PICTURES else "front", deviations=deviations)
    if output is not None:
        writable(output)
        if checkpoint is not None and PurePath(checkpoint) == PurePath(output):
            raise RequestError(f"-o {one_line(output)}: is the checkpoint too; give the answer a file of its own")
    from crankstar import search_job

    answer = search_job.found(wanted, workers=crew, scheduler=scheduler, checkpoint=checkpoint, agreed=yes)
    if answer.certificate.interrupted:
        return _stopped(answer, wanted.engine, kind, output)
    if line is not None:
        _show_row(answer, wanted.engine, line, deviations, pace, output)
    else:
        _show(answer, wanted.engine, kind, chart, output)
    return None


def _stopped(answer: Findings, engine: Engine | None, kind: str, output: str | None) -> int:
    """Shows the best so far of a search that was stopped, and says that it is incomplete.

    Engines and pictures are left unwritten, and all files where nothing was found yet: an earlier answer may be in them.
    """
    from crankstar.search_table import certificate, search_table

    if kind in TABLES and (answer.rows or output is None):
        _show(answer, engine, kind, None, output)
        complain(f"crankstar: {certificate(answer)}")
        return 130
    display(search_table(answer, engine=engine))
    if output is not None:
        complain(f"crankstar: the search was stopped; {one_line(output)} was not written")
    return 130


def _wishes() -> ModuleType:
    """What reads the words of a search, with what searches. Raises RequestError where that is not installed."""
    try:
        from crankstar import search_request
    except ImportError as error:
        raise RequestError(f'a search is compiled with numba ({error}); install it with: pip install "crankstar[search]"') from None
    return search_request


def _kind(*, output: str | None, row: int | None, chart: str | None, uneven: str | None, csv: bool, json: bool) -> str:
    """As what the answer is given: the end of the file's name; empty for the table on the terminal. Raises RequestError."""
    kind = PurePath(output or "").suffix.lower().removeprefix(".")
    if uneven is not None and row is None:
        raise RequestError("--uneven: say which row is to be refined, as in --row 2 --uneven 1,2,5")
    request.alone("--row" if row is not None else "--chart", {"--csv": csv or None, "--json": json or None} if row or chart else {})
    if row is not None:
        request.alone("--row", {"--chart": chart})
        if row < 1 or kind not in ("", "toml"):
            raise RequestError(f"--row {row}: give a row from 1 up, and the name of an engine file, as in --row 2 -o better.toml")
        return "toml"
    if chart is not None:
        if chart not in ("front", "stars"):
            raise RequestError(f"--chart {one_line(chart)}: it can be front or stars, as in --chart stars -o stars.svg")
        chart_request.charts()
        return chart_request.suffix(output, PICTURES)
    if csv and json:
        raise RequestError("--csv and --json: ask for one of them")
    if csv or json:
        wanted = "csv" if csv else "json"
        if output not in STANDARD_OUTPUT and kind not in ("", wanted):
            raise RequestError(f"-o {one_line(output or '')}: --{wanted} is not what the name says; leave one of them out")
        return wanted
    if output is not None and output not in STANDARD_OUTPUT and kind not in (*TABLES, *PICTURES, "txt"):
        named = ", ".join(f".{one}" for one in (*TABLES, *PICTURES, "txt"))
        raise RequestError(f"-o {one_line(output)}: let the name end in {named}; or in .toml with --row")
    if kind in PICTURES:
        chart_request.charts()
    if kind == "parquet" and find_spec("pyarrow") is None:
        raise RequestError('a .parquet file is written with pyarrow: pip install "crankstar[parquet]"')
    return kind


def _show(answer: Findings, engine: Engine | None, kind: str, chart: str | None, output: str | None) -> None:
    """Writes the answer as what it is wanted."""
    from crankstar import search_table as tables

    if kind == "csv":
        write(tables.csv_text(answer), output)
    elif kind == "json":
        write(json_text(tables.tree(answer)), output)
    elif kind == "parquet":
        write_bytes(tables.parquet_bytes(answer), output)
    elif kind in PICTURES:
        drawing = chart_request.charts()
        try:
            figure = drawing.best_stars(answer) if chart == "stars" else drawing.pareto_front(answer)
        except drawing.ChartError as error:
            raise RequestError(str(error)) from None
        write_bytes(drawing.saved(figure, kind, title=tables.heading(answer.question)), output)
    else:
        display(tables.search_table(answer, engine=engine), output)


def _show_row(
    answer: Findings, engine: Engine | None, row: int, deviations: list[float] | None, speed: float | None, output: str | None
) -> None:
    """Writes a row as an engine file; with uneven angles their table, or the engine of the last of them."""
    from crankstar import uneven_table
    from crankstar.files import toml
    from crankstar.search import engines, weighed
    from crankstar.search.stars import SearchError

    if row > len(answer.rows):
        raise RequestError(f"--row {row}: there are {len(answer.rows)} rows")
    chosen: Finding = answer.rows[row - 1]
    stars, later = answer.question.stars, None
    if deviations is not None:
        try:
            with working("refining the angles ..."):
                found = uneven_table.curve_of(answer.question, chosen.star, deviations_deg=deviations, engine=engine, speed=speed)
        except SearchError as error:
            raise RequestError(str(error)) from None
        if output not in STANDARD_OUTPUT or output is None:
            display(uneven_table.uneven_table(found))
        if output is None:
            return
        later = found[-1].later_deg
    build = engines.engine if engine is None else partial(weighed.with_star, engine)
    write(toml(build(stars, chosen.star, later_deg=later)), output)
