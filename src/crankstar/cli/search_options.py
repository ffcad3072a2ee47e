"""The options of the verb `search`: what it asks for, who works, in which form the answer comes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal, cast

from cyclopts import Parameter

from crankstar.options.words import SearchWords


@dataclass(frozen=True)
class Work:
    """Who does the work of a search, and how it is kept."""

    workers: Annotated[
        str | None,
        Parameter(help="Worker processes on this machine (default: one for each processor)."),
    ] = None
    scheduler: Annotated[
        str | None, Parameter(help="A dask scheduler with workers, as in tcp://host:8786.")
    ] = None
    checkpoint: Annotated[
        str | None,
        Parameter(help="File in which the progress of the search is kept, to resume it."),
    ] = None
    yes: Annotated[bool, Parameter(help="Search even if it takes more than an hour.")] = False


class Words(SearchWords):
    """The same words, one of them in both spellings."""

    minimise: Annotated[str | None, Parameter(alias="--minimize")] = cast(
        "str | None", SearchWords.model_fields["minimise"]
    )


@dataclass(frozen=True)
class Form:
    """In which form the answer is given."""

    row: Annotated[
        str | None, Parameter(help="Write this row as an engine file instead (-o FILE.toml).")
    ] = None
    uneven: Annotated[
        str | None,
        Parameter(
            help=(
                "Refine the throw angles of --row, with firing intervals within so many degrees "
                "of even ones, as in 1,2,5."
            )
        ),
    ] = None
    chart: Annotated[
        Literal["front", "stars"] | None,
        Parameter(help="Chart to draw: the front, or the stars of the first rows."),
    ] = None
    csv: Annotated[bool, Parameter(help="All rows as CSV.")] = False
    json: Annotated[bool, Parameter(help="All rows and their proof as JSON.")] = False
    output: Annotated[
        str | None,
        Parameter(
            name=["--output", "-o"],
            help="File to write: .csv, .json or .parquet (all rows), .txt, .svg, .png, .pdf or "
            ".html (picture), .toml (with --row).",
        ),
    ] = None
