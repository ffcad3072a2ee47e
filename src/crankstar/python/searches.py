"""The search for crank stars as a function: what is sought in, the stars with their proof out."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cached_property, partial
from numbers import Integral
from typing import TYPE_CHECKING, Any, Literal, cast

from pydantic import ValidationError

from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given
from crankstar.options.refusals import not_compiled
from crankstar.options.sources import loaded
from crankstar.options.words import SearchWords

if TYPE_CHECKING:
    import pandas

    from crankstar.analysis.document import Document
    from crankstar.charts.grammar import Chart
    from crankstar.options.sources import EngineLike
    from crankstar.stars.answer import Answer
    from crankstar.stars.options import Search
    from crankstar.stars.progress import Progress

GREATEST_WORKERS = 1024
Texts = str | Iterable[str]
"""A text as the command line has it, with commas, or its parts."""


@dataclass(frozen=True, repr=False, eq=False)
class Found:
    """The stars that a search found, and what proves that these are all.

    `answer` has its rows and its certificate, `engine` what was searched, if that is an engine.

    >>> import crankstar
    >>> found = crankstar.search(5, cycle="two-stroke", best=1, minimise="M1")
    >>> len(found), found.to_engine().firing_order
    (1, (1, 5, 2, 3, 4))
    """

    answer: Answer
    engine: Engine | None

    @cached_property
    def document(self) -> Document:
        """All of it in words and tables."""
        from crankstar.tables.search_stars import search_stars

        return search_stars(self.answer, engine=self.engine, limit=None)

    def __len__(self) -> int:
        return len(self.answer.rows)

    def to_dict(self) -> dict[str, Any]:
        """All of it, as `--json` prints it."""
        from crankstar.tables.machine import tree

        return tree(self.document)

    def to_frame(self) -> pandas.DataFrame:
        """Its rows as a pandas data frame, as `--csv` has them. Raises ImportError without pandas.

        The proof stands in `attrs`.
        """
        from crankstar.analysis.frames import frame
        from crankstar.tables.machine import columns

        document = self.document.for_machines
        (table,) = (each for each in document.tables if each.key == "rows")
        return frame(*columns(table), document.facts)

    def plot(self, figure: Literal["front", "stars"] = "front") -> Chart:
        """The front, or the best stars drawn. Raises ValueError for another name."""
        from crankstar import charts

        figures: dict[str, Callable[[Answer], Chart]] = {
            "front": charts.pareto_front,
            "stars": charts.best_stars,
        }
        if figure not in figures:
            raise ValueError(
                _("search has the figures {names}, not {name}", names="front, stars", name=figure)
            )
        return figures[figure](self.answer)

    def to_engine(self, row: int = 1) -> Engine:
        """The engine of a row, counted from 1: with its throws and firing order.

        Raises ValueError where there is no such row.
        """
        from crankstar.stars import engine_stars, engines

        if not 1 <= row <= len(self):
            raise ValueError(
                _("there is no row {row}; the answer has {rows}", row=row, rows=len(self))
            )
        star, stars = self.answer.rows[row - 1].star, self.answer.question.stars
        build = (
            engines.engine if self.engine is None else partial(engine_stars.with_star, self.engine)
        )
        return build(stars, star)

    def __repr__(self) -> str:
        from crankstar.tables.search_stars import certificate, heading

        return f"{heading(self.answer.question)}: {certificate(self.answer)}"

    def _repr_html_(self) -> str:
        from crankstar.tables.html import document_html

        return document_html(self.document)


def search(
    about: int | EngineLike,
    /,
    *,
    cycle: Literal["two-stroke", "four-stroke"] | None = None,
    minimise: Texts | None = None,
    zero: Texts | None = None,
    limit: Texts | Mapping[str, Any] = (),
    gaps: Texts | None = None,
    fix: str | Mapping[int, int] | None = None,
    symmetric: bool = False,
    mode_shape: Texts | None = None,
    avoid_adjacent: bool = False,
    front: bool = False,
    best: int | None = None,
    all: bool = False,  # noqa: A002  # as the option is called
    all_with: Texts | None = None,
    speed: float | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
    workers: int | None = None,
    tell: Callable[[Progress], None] | None = None,
) -> Found:
    """Better cranks: all arrangements of evenly spaced throws, searched with proof.

    `about` is the number of cylinders, or an engine in line (itself, name, path, keys), with
    `changes` by key path, at `speed` (rad/s), by default that of its file; `estimate` fills in
    what its file leaves out. The goals and limits are those of `crankstar search`, as text or as
    lists and dicts. `tell` is called with the Progress; so many `workers` are processes, which a
    script starts under `if __name__ == "__main__"`. Raises SearchError with every fault of what is
    asked.

    >>> import crankstar
    >>> found = crankstar.search(5, cycle="two-stroke", minimise=["M1", "M2"])
    >>> found.answer.certificate.complete, found.to_frame()["firing_order"][0]
    (True, '1-5-2-3-4')
    """
    from crankstar.options.search import search_of

    words = _words(
        {
            "cycle": cycle,
            "minimise": _joined("minimise", minimise),
            "zero": _joined("zero", zero),
            "limit": [limit] if isinstance(limit, str) else _pairs("limit", limit),
            "gaps": _joined("gaps", gaps),
            "fix": fix if fix is None or isinstance(fix, str) else ",".join(_pairs("fix", fix)),
            "symmetric": symmetric,
            "mode_shape": _joined("mode_shape", mode_shape),
            "avoid_adjacent": avoid_adjacent,
            "front": front,
            "best": best,
            "all": all,
            "all_with": _joined("all_with", all_with),
        }
    )
    source, pace = _source(about, changes, speed, estimate=estimate)
    with named():
        wanted = search_of(source, words, speed=pace)
        answer = _answer(wanted, workers, tell)
    return Found(answer, wanted.engine)


@contextmanager
def named() -> Iterator[None]:
    """Have refusals name arguments instead of the options of a command. Raises ValueError."""
    try:
        yield
    except MessageError as error:
        text = re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda name: name[1].replace("-", "_"), str(error))
        if text == str(error):
            raise
        raise ValueError(text) from None


def _words(values: Mapping[str, Any]) -> SearchWords:
    """The words of a search. Raises TypeError for a value of another type than theirs."""
    try:
        return SearchWords(**values)
    except ValidationError as error:
        first = error.errors()[0]
        name, wrong = str(first["loc"][0]), given(first["input"])
        raise TypeError(
            _(
                "{argument} cannot be {given}: {reason}",
                argument=name,
                given=wrong,
                reason=first["msg"],
            )
        ) from None


def _joined(argument: str, parts: Texts | None) -> str | None:
    if parts is None or isinstance(parts, str):
        return parts
    return ",".join(map(str, _listed(argument, parts)))


def _listed(argument: str, parts: Iterable[Any]) -> Iterable[Any]:
    """The parts of a list. Raises TypeError for what is none."""
    if not isinstance(parts, Iterable) or isinstance(parts, bytes):
        raise TypeError(
            _("{argument} takes text or a list of it, not {given}", argument=argument,
              given=given(parts))
        )  # fmt: skip
    return parts


def _pairs(argument: str, values: Iterable[str] | Mapping[Any, Any]) -> list[str]:
    if isinstance(values, Mapping):
        return [f"{name}={value}" for name, value in values.items()]
    return [str(each) for each in _listed(argument, values)]


def _source(
    about: int | EngineLike,
    changes: Mapping[str, Any] | None,
    speed: float | None,
    *,
    estimate: bool,
) -> tuple[int | Engine, float | None]:
    """What is searched, and its speed. Raises TypeError for what belongs to an engine alone."""
    if isinstance(about, Integral) and not isinstance(about, bool):
        of_engine = {"changes": changes, "speed": speed, "estimate": estimate or None}
        if unused := [name for name, value in of_engine.items() if value is not None]:
            raise TypeError(
                _(
                    "{arguments}: of an engine alone, not of a number of cylinders",
                    arguments=", ".join(unused),
                )
            )
        return int(about), None
    found = loaded(
        cast("EngineLike", about), changes, estimate=estimate, speed=speed, asking="search"
    ).source
    if not isinstance(found, Engine):
        raise TypeError(
            _("{function} takes an engine, not a drive line without cylinders", function="search")
        )
    return found, found.speed if speed is None else speed


def _answer(wanted: Search, workers: int | None, tell: Callable[[Progress], None] | None) -> Answer:
    """The answer, by so many processes or in this one."""
    _check_workers(workers)
    try:
        from crankstar.options.search import whole
        from crankstar.stars import executors, halves
        from crankstar.stars.answer import answer_to
    except ImportError as error:
        raise not_compiled(error) from None
    question = wanted.question
    halves.check(question)
    with executors.processes(workers) if workers else nullcontext() as pool:
        return whole(wanted, answer_to(question, workers=pool, watch=tell))


def _check_workers(workers: Any) -> None:
    """Raises ValueError for workers of no possible number."""
    counted = isinstance(workers, Integral) and not isinstance(workers, bool)
    if workers is not None and not (counted and 1 <= int(workers) <= GREATEST_WORKERS):
        raise ValueError(
            _(
                "workers is from 1 to {most}, not {given}",
                most=GREATEST_WORKERS,
                given=given(workers),
            )
        )
