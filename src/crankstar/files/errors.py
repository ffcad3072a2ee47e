"""An engine file that cannot be used, with every fault found in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from crankstar.language.faults import Fault, sentence, where
from crankstar.language.messages import MessageError, _, _n

GREATEST_SHOWN, GREATEST_LISTED = 20, 1000
"""Faults of one file that are written out one by one, and that a list of all of them has."""
SCREEN = 20
"""Lines of 80 letters, after which no further fault is begun."""


class EngineFileError(MessageError):
    """An engine file that cannot be used; `faults` have the key paths of the file.

    `cells` has the cells of a spreadsheet by key path.

    >>> import crankstar
    >>> try:
    ...     crankstar.load("i4", changes={"cylinder.stroke": "-1 mm"})
    ... except crankstar.EngineFileError as error:
    ...     [fault.path for fault in error.faults]
    [('cylinder', 'stroke')]
    """

    def __init__(
        self,
        name: str,
        faults: Sequence[Fault],
        cells: Mapping[tuple[str | int, ...], str] | None = None,
    ) -> None:
        self.name, self.faults, self.cells = name, list(faults), dict(cells or {})
        super().__init__(on_one_screen(name, self._told(), count=len(self.faults), checks=True))

    def listed(self) -> str:
        """Every mistake on a line, however many there are."""
        lines = [f"  {line}" for line in islice(self._told(), GREATEST_LISTED)]
        count = len(self.faults)
        more = [_more(count - len(lines))] if count > len(lines) else []
        return "\n".join([_head(self.name, count), *lines, *more])

    def _told(self) -> Iterator[str]:
        for fault in self.faults:
            yield sentence(fault.code, fault.values, place=self._place(fault.path))

    def _place(self, path: tuple[str | int, ...]) -> str:
        """A key path, and the cell where it is, or that of the table it is missing in."""
        sizes = range(len(path), 0, -1)
        cell = next((self.cells[path[:size]] for size in sizes if path[:size] in self.cells), "")
        return f"{cell} ({where(path)})" if cell else where(path)

    def __reduce__(self) -> tuple[Any, ...]:
        """It goes from process to process."""
        return EngineFileError, (self.name, self.faults, self.cells)


def on_one_screen(name: str, sentences: Iterable[str], *, count: int, checks: bool = False) -> str:
    """The mistakes of a file: how many there are, and as many of them as a screen has lines for.

    `checks`: a check of the file lists the others too.

    >>> print(on_one_screen("w.csv", ["line 2 is empty"], count=1))
    w.csv: 1 mistake
      line 2 is empty
    """
    lines: list[str] = []
    for told in islice(sentences, GREATEST_SHOWN):
        if sum(1 + len(line) // 80 for line in lines) >= SCREEN:
            break
        lines.append(told)
    if count > len(lines):
        more = _more(count - len(lines))
        lines.append(_("{more} (crankstar check lists all)", more=more) if checks else more)
    return "\n".join([_head(name, count), *(f"  {line}" for line in lines)])


def _head(name: str, count: int) -> str:
    return _n("{name}: {count} mistake", "{name}: {count} mistakes", count, name=name, count=count)


def _more(count: int) -> str:
    return _("... and {count} more", count=count)


def refused(name: str, code: str, **values: Any) -> EngineFileError:
    """The error of a file as a whole."""
    return EngineFileError(name, [Fault((), f"file.{code}", values)])
