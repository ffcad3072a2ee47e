"""What the function of an analysis gives: its numbers, tables, arrays and figures."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeGuard, TypeVar, cast

import numpy as np

from crankstar.analysis.document import Document, Table
from crankstar.analysis.reader import asked
from crankstar.analysis.record import Analysis, Chart, Grid, Writes
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import seen
from crankstar.options.refusals import of_row
from crankstar.python.resting import RestsOn, told

if TYPE_CHECKING:
    import pandas
    import xarray

    from crankstar.charts.grammar import Chart as Figure
    from crankstar.options.sources import Loaded

T = TypeVar("T")


class Part:
    """One thing of a result by its name: records as the physics has them, a table, an array.

    It is used like the records (`part[0]`, `len(part)`, a loop, their attributes); where there are
    none, like the rows of the table, each a dict.
    """

    def __init__(
        self, name: str, records: Any, table: Table | None, grid: Grid | None, facts: dict[str, Any]
    ) -> None:
        self._name, self._records, self._table = name, records, table
        self._grid, self._facts = grid, facts

    def to_frame(self) -> pandas.DataFrame:
        """Its table as a pandas data frame, as `--csv` has it: units stand in the names of columns.

        Raises ImportError without pandas, ValueError where it is no table.
        """
        from crankstar.analysis.frames import frame
        from crankstar.tables.machine import columns

        if self._table is None:
            raise ValueError(_("{name} is no table; to_xarray() gives it", name=self._name))
        return frame(*columns(self._table), self._facts)

    def to_xarray(self) -> xarray.Dataset:
        """It as an xarray data set with its dimensions.

        Raises ImportError without xarray, ValueError where it has no dimensions.
        """
        from crankstar.analysis.frames import dataset

        if self._grid is None:
            raise ValueError(
                _("{name} has no dimensions; to_frame() gives its table", name=self._name)
            )
        return dataset(self._grid, self._facts)

    @property
    def _shown(self) -> Any:
        if self._records is not None or self._table is None:
            return self._records
        from crankstar.tables.machine import objects

        return objects(self._table)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._shown, name)

    def __getitem__(self, item: Any) -> Any:
        return self._shown[item]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._shown)

    def __len__(self) -> int:
        return len(self._shown)

    def __eq__(self, other: object) -> bool:
        return self._shown == (other._shown if isinstance(other, Part) else other)

    __hash__ = None  # pyright: ignore[reportAssignmentType]

    def __repr__(self) -> str:
        return repr(self._shown)

    def _repr_html_(self) -> str | None:
        if self._table is None:
            return None
        from crankstar.tables.html import document_html

        return document_html(Document("", (self._table,)))


@dataclass(frozen=True, repr=False, eq=False)
class Result:
    """What an analysis computes of an engine.

    Its attributes are those of the record of its physics (`value`), and its tables and arrays by
    their names, each with `to_frame()` and `to_xarray()`; `source` is the engine or drive line,
    None without one, `question` what was asked, `document` all of it in words and tables.

    >>> import crankstar
    >>> result = crankstar.torsion("cadillac-ld8")
    >>> round(result.modes[0].frequency, 1), len(result.modes.to_frame())
    (418.6, 4)
    """

    analysis: Analysis
    source: Engine | Chain | None
    question: Any
    value: Any
    loaded: Loaded | None = field(repr=False)

    @cached_property
    def document(self) -> Document:
        """Its tables and sentences, with what they rest on and the ranges of what is estimated."""
        return self._document(resting=True)

    def _document(self, *, resting: bool) -> Document:
        if self.loaded is None or not isinstance(self.source, Engine):
            return self._of_source
        from crankstar.tables import ranges

        rests = (lambda: self.rests_on) if resting else None
        if self.analysis.ranged:
            spread = self.loaded.spread if self.analysis.ranges else None
            return ranges.ranged(self._told, spread, self.source, rests=rests)
        return ranges.resting(self._of_source, rests)

    @cached_property
    def _of_source(self) -> Document:
        return self.analysis.document.value(self.source, self.value, self.question)

    def _told(self, source: Engine) -> Document:
        own = source is self.source
        file = None if self.loaded is None else self.loaded.of(source)
        return self._of_source if own else self.analysis.told(source, self.question, file=file)

    @cached_property
    def rests_on(self) -> RestsOn:
        """What its numbers rest on: each assumption, and how far it moves them."""
        if not isinstance(self.source, Engine):
            return RestsOn()
        from crankstar.studies.answers import rests_on

        record = self.analysis
        about = record.resting(self.source, self.value)
        return told(rests_on(about, record.answered(about, self.question, self.value, "machines")))

    @cached_property
    def tables(self) -> Mapping[str, Table]:
        """Its tables by name, as JSON has them."""
        return {table.key: table for table in self._numbers.for_machines.tables if table.key}

    @cached_property
    def _numbers(self) -> Document:
        """The same document without what it rests on, which takes longer to find."""
        return self._document(resting=False)

    @cached_property
    def grids(self) -> Mapping[str, Grid]:
        """Its arrays by name."""
        return {} if self.analysis.grids is None else self.analysis.grids.value(self.value)

    def to_dict(self) -> dict[str, Any]:
        """All of it, as `--json` prints it."""
        from crankstar.tables.machine import tree

        return tree(self.document)

    def to_frame(self, table: str = "") -> pandas.DataFrame:
        """One of its tables, the first unless it is named. Raises ValueError for another name."""
        return self._part(table or next(iter(self.tables))).to_frame()

    def to_xarray(self, array: str = "") -> xarray.Dataset:
        """One of its arrays, the first unless it is named. Raises ValueError for another name."""
        if not self.grids:
            raise ValueError(
                _("{name} has no array; to_frame() gives its tables", name=self.analysis.name)
            )
        return self._part(array or next(iter(self.grids))).to_xarray()

    def to_engine(self, **chosen: Any) -> Engine:
        """The engine that it comes to, as the command writes it: that of a row, one made better.

        `chosen` say which where there are several: `row` of a list, or `number` of those built.
        Raises ValueError where there is none, TypeError for what says nothing about it.

        >>> import crankstar
        >>> crankstar.vees(6, bank="60 deg").to_engine(row=1).name
        'V6, 60 deg, pins split by 60 deg'
        """
        writes = self.analysis.writes
        if writes is None:
            raise ValueError(_("{name} makes no engine", name=self.analysis.name))
        names = (*writes.chosen, *(["number"] if writes.count is not None else []))
        for name in chosen:
            if name not in names:
                raise TypeError(
                    _(
                        "{function} takes no argument {name}; it takes {names}",
                        function="to_engine",
                        name=name,
                        names=", ".join(names) or "-",
                    )
                )
        number = chosen.pop("number", 1)
        return in_python(self.analysis, lambda: self._engine(writes, number, chosen))

    def _engine(self, writes: Writes, number: int, chosen: Mapping[str, Any]) -> Engine:
        question = replace(self.question, **chosen)
        if writes.refuse is not None:
            writes.refuse.value(question)
        if writes.instead is not None:
            return writes.engine.value(self.value, question)
        made = writes.engine.value(
            *((self.value,) if writes.of_result else (self.source, question))
        )
        return made if writes.count is None else of_row("number", number, made)

    def plot(self, figure: str = "", **options: Any) -> Figure:
        """A figure of it, the first unless it is named; `options` as `crankstar plot` takes them.

        What was asked of the analysis is asked of the figure. Raises ValueError for another name
        and where the figure cannot be asked it, ChartError where there is nothing to draw.
        """
        charts = self.analysis.charts
        if not charts:
            raise ValueError(_("{name} has no figure", name=self.analysis.name))
        chart = charts[0] if not figure else self._chart(figure)
        self._check_plotted(chart)
        own = {name: getattr(self.question, name, None) for name in chart.options}
        given = {name: value for name, value in own.items() if value not in (None, "", (), [])}
        return chart.draw(self.source, **{**given, **options})

    def _check_plotted(self, chart: Chart) -> None:
        """Refuse a figure that would show something else than the numbers. Raises ValueError."""
        unasked = [
            one.name
            for one in asked(type(self.question))
            if one.name not in (*chart.options, *self.analysis.lists)
            and not np.array_equal(getattr(self.question, one.name), one.default)
        ]
        if unasked:
            raise ValueError(
                _(
                    "the figure {name} would not show {arguments}; ask without, or use the numbers",
                    name=chart.name,
                    arguments=", ".join(unasked),
                )
            )

    def _chart(self, figure: str) -> Chart:
        for chart in self.analysis.charts:
            if figure in (chart.name, chart.name.removeprefix(f"{self.analysis.name}-")):
                return chart
        names = ", ".join(chart.name for chart in self.analysis.charts)
        raise ValueError(
            _("there is no figure {name}; there are: {names}", name=seen(figure), names=names)
        )

    def _part(self, name: str) -> Part:
        if name not in self.tables and name not in self.grids:
            names = ", ".join(dict.fromkeys([*self.tables, *self.grids]))
            raise ValueError(
                _("there is no table {name}; there are: {names}", name=seen(name), names=names)
            )
        records = getattr(self.value, name, None)
        facts = {
            key: value
            for key, value in self._numbers.facts.items()
            if (isinstance(value, str | int | float) and key != "format") or _is_list(value)
        }
        for one in asked(type(self.question)):  # what was asked for, where no fact says it
            value = getattr(self.question, one.name)
            if value != one.default and (isinstance(value, str | bool) or _is_list(value)):
                facts.setdefault(one.name, int(value) if isinstance(value, bool) else value)
        if weaker := self._numbers.facts.get("weaker"):  # no attribute of an array is a mapping
            facts["weaker"] = ", ".join(f"{number}={share!r}" for number, share in weaker.items())
        return Part(name, records, self.tables.get(name), self.grids.get(name), facts)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if hasattr(self.value, name) and name not in self._named:
            return getattr(self.value, name)
        if name in self._named or name in self.tables or name in self.grids:
            return self._part(name)
        raise AttributeError(f"the result of {self.analysis.name} has no {name!r}")

    @cached_property
    def _named(self) -> frozenset[str]:
        """Names that the record of the physics and the tables or arrays share."""
        return frozenset(name for name in (*self.tables, *self.grids) if hasattr(self.value, name))

    def __reduce__(self) -> tuple[Any, ...]:
        """As what a copy or a pickle is made of: records are found again by their names."""
        return _again, (self.analysis.name, self.source, self.question, self.value, self.loaded)

    def __dir__(self) -> list[str]:
        own = [name for name in dir(self.value) if not name.startswith("_")]
        return sorted({*super().__dir__(), *own, *self.tables, *self.grids})

    def __repr__(self) -> str:
        tables = ", ".join(dict.fromkeys([*self.tables, *self.grids]))
        of = "" if self.source is None else f" of {self.source.name}"
        return f"<{self.analysis.name}{of}: {tables}>"

    def _repr_html_(self) -> str:
        from crankstar.tables.html import document_html

        return document_html(self.document.for_readers)


def _again(name: str, *parts: Any) -> Result:
    """A result that was copied or pickled."""
    from crankstar.analysis.registry import analysis

    return Result(analysis(name), *parts)


def _is_list(value: Any) -> TypeGuard[Sequence[float]]:
    """Whether it is a list of numbers that is not empty, as a data set has among its attributes."""
    if not isinstance(value, list | tuple) or not value:
        return False
    return all(isinstance(each, int | float) for each in cast("Sequence[object]", value))


def in_python(record: Analysis, done: Callable[[], T]) -> T:
    """What is done, its refusals with the names of arguments instead of those of options."""
    try:
        return done()
    except MessageError as error:
        text = str(error)
        for one in asked(record.question.value):
            text = text.replace(one.reader.option, one.name)
        if text == str(error):
            raise
        raise ValueError(text) from None
