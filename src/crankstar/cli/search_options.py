"""The options of the verb `search`: what it asks for, who works, in which form the answer comes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import Annotated, Any, Literal, TypeVar

from crankstar.cli.options import Csv, Json, option
from crankstar.cli.output import writable
from crankstar.engine.engine import Engine
from crankstar.language.messages import _n
from crankstar.options.refusals import MistakesError, RequestError, refusal, refuse_empty
from crankstar.stars.faults import SearchError

T = TypeVar("T")


def in_options(reading: Callable[[], T]) -> T:
    """What is read of a search, its faults told as those of options. Raises MistakesError."""
    try:
        return reading()
    except SearchError as error:
        raise MistakesError(error.in_options().splitlines()) from None


def no_such_row(row: int, count: int) -> RequestError:
    """What is said where the answer ends before a row."""
    rows = _n("the answer has {count} row", "the answer has {count} rows", count, count=count)
    return RequestError(f"--row {row}: {rows}")


@dataclass(frozen=True)
class Work:
    """Who does the work of a search, and how it is kept."""

    workers: Annotated[int | None, option("--workers")] = None
    scheduler: Annotated[str | None, option("--scheduler")] = None
    checkpoint: Annotated[str | None, option("--checkpoint")] = None
    yes: Annotated[bool, option("--yes")] = False

    def check(self, output: str | None) -> None:
        """Refuse empty names, and a checkpoint that is the output or cannot be written.

        Raises RequestError, OutputError.
        """
        refuse_empty({"--checkpoint": self.checkpoint, "--scheduler": self.scheduler})
        if None not in (output, self.checkpoint) and PurePath(f"{self.checkpoint}") == PurePath(
            f"{output}"
        ):
            raise refusal("-o", f"{output}", "this is the checkpoint; name another file")
        if self.checkpoint is not None:
            writable(self.checkpoint, option="--checkpoint")


@dataclass(frozen=True)
class Form:
    """In which form the answer is given."""

    row: Annotated[int | None, option("--row")] = None
    uneven: Annotated[str | None, option("--uneven")] = None
    chart: Annotated[Literal["front", "stars"] | None, option("--chart")] = None
    csv: Csv = False
    json: Json = False
    output: Annotated[
        str | None,
        option(
            "--output",
            ".csv, .json, .xlsx or .parquet (all rows), .txt, .svg, .png, .pdf or .html (picture); "
            "with --row .toml, .json or .xlsx.",
        ),
    ] = None


@dataclass(frozen=True)
class Sequenced:
    """What is asked where star and firing sequence are searched together."""

    bank: Annotated[
        str | None, option("--bank", "One, of a V engine with two rods on each pin.")
    ] = None
    crank_orders: Annotated[
        str | None, option("--orders", "Of twist. Default: 0.5,1.5,2.5; two-stroke 1,2,3.")
    ] = None
    why: Annotated[str | None, option("--why")] = None
    judge: Annotated[str | None, option("--judge")] = None

    def check(self) -> None:
        """Refuse empty texts. Raises RequestError."""
        refuse_empty(
            {
                "--bank": self.bank,
                "--orders": self.crank_orders,
                "--why": self.why,
                "--judge": self.judge,
            }
        )


@dataclass(frozen=True)
class Line:
    """What is read of a command line: what it asks for, of what, and how the answer is given.

    `named` is the word for the engine or the number of cylinders, `tree` the file, `kind` the form
    of the answer or of the engine of a row, `paper` that of a picture; `speed` in rad/s.
    """

    named: str
    source: int | Engine
    tree: dict[str, Any] | None
    speed: float | None
    wanted: Any
    kind: str
    paper: Any
    workers: int | None
    deviations: list[float] | None
    work: Work
    form: Form

    @property
    def engine(self) -> Engine | None:
        """The engine that is searched for, as the search has it."""
        return self.wanted.engine
