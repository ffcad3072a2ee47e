"""The columns of a list read as values, with every mistake of the list told at once.

A heading says its unit in brackets; a cell may say its own. Each mistake is a sentence with its
line and column, what is wrong with a heading once and not in every row.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from math import nan

from crankstar.engine.quantities import Quantity
from crankstar.files import units
from crankstar.files.lists import NUMBER, UNIT, Listed, Mistake, Row, key_of, refused_list
from crankstar.language.faults import ValueFaultError, sentence
from crankstar.language.messages import _, _n
from crankstar.language.quoting import one_line, seen
from crankstar.language.units import in_degrees

TURN = 6.2832
"""Radians: the greatest angle in another unit than degrees, as of bare numbers in a file."""
DATE = re.compile(r"\d{4}-\d\d-\d\d([ T]\d\d:\d\d:\d\d(\.\d+)?)?|\d\d:\d\d:\d\d(\.\d+)?")
"""A date or a time, which a spreadsheet makes of a number it takes for one."""


class Columns:
    r"""The columns of a list by name; `known` are the names by their headings.

    What is mistaken is read as nan, and noted; `check` raises ListError with all of it.

    >>> from crankstar.engine.quantities import MASS
    >>> from crankstar.files.lists import list_of
    >>> weights = list_of("no,Piston [g]\n1,412\n2,heavy\n3,4 mm", name="w.csv")
    >>> columns = Columns(weights, {"no": "label", "piston": "piston"})
    >>> [round(columns.value(row, "piston", MASS), 9) for row in weights.rows]
    [0.412, nan, nan]
    >>> len(columns.mistakes)
    2
    """

    def __init__(
        self, listed: Listed, known: Mapping[str, str], *, needed: Sequence[str] = ()
    ) -> None:
        self.listed = listed
        self.mistakes: list[Mistake] = [*listed.mistakes]
        self._told: set[int] = set()
        self._spoilt = {each.line for each in listed.mistakes} - {listed.line}
        self._places = self._found(known)
        missing = [f'"{_usual(known)[name]}"' for name in needed if name not in self._places]
        if missing:
            told = _n(
                "line {line}: there is no column {heads}",
                "line {line}: there are no columns {heads}",
                len(missing),
                line=listed.line,
                heads=", ".join(missing),
            )
            self.mistakes.append(Mistake(listed.line, told))

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows under the headings."""
        return self.listed.rows

    def __contains__(self, name: str) -> bool:
        return name in self._places

    def check(self) -> None:
        """Raise ListError where there are mistakes."""
        if self.mistakes:
            raise refused_list(self.listed.name, self.mistakes)

    def refuse_list(self, told: str) -> None:
        """Note a mistake of the whole list."""
        self.mistakes.append(Mistake(0, told))

    def refuse(self, row: Row, name: str, why: str) -> None:
        """Note a mistake of a cell, `why` being a sentence in the language of the context.

        A column that is not there has been told of, or is none that is needed.
        """
        if name in self:
            self._note(row, _("{where}: {why}", where=self.place(row, name), why=why))

    def _note(self, row: Row, told: str) -> None:
        """Note a mistake of a cell, unless its whole line is one: its cells may have moved."""
        if row.line not in self._spoilt:
            self.mistakes.append(Mistake(row.line, told))

    def refuse_head(self, name: str, why: str) -> None:
        """Note a mistake of a heading, once."""
        if name not in self:
            return
        column = self._places[name]
        if column not in self._told:
            self._told.add(column)
            told = _("{where}: {why}", where=self._place(self.listed.line, column), why=why)
            self.mistakes.append(Mistake(self.listed.line, told))

    def place(self, row: Row, name: str) -> str:
        """Where a cell stands, in words."""
        return self._place(row.line, self._places[name])

    def text(self, row: Row, name: str) -> str:
        """What stands in a cell; nothing where there is no such column."""
        return row.cells[self._places[name]] if name in self._places else ""

    def unit(self, name: str) -> str:
        """The unit of a heading; empty where it has none."""
        bracket = UNIT.search(self.listed.heads[self._places[name]]) if name in self else None
        return bracket[1].strip() if bracket else ""

    def number(self, row: Row, name: str) -> float:
        """A plain number in a cell."""
        if name not in self:
            return nan
        text = self.text(row, name)
        if NUMBER.fullmatch(text):
            return float(text)
        if self._is_empty(row, name, text) or self._is_date(row, name, text):
            return nan
        self.refuse(row, name, _("{text} is no number", text=seen(text)))
        return nan

    def value(self, row: Row, name: str, quantity: Quantity, *, usual: str = "") -> float:
        """The SI number of a cell, with its own unit, else that of the heading, else the usual."""
        if name not in self:
            return nan
        text, unit = self.text(row, name), self.unit(name) or usual
        if self._is_empty(row, name, text) or self._is_date(row, name, text):
            return nan
        bare = NUMBER.fullmatch(text) is not None
        if bare and not unit:
            example = units.unit_of(quantity.example)
            why = _(
                'neither the heading nor the cell has a unit; name it, as in "{head} [{unit}]"',
                head=self._head(name),
                unit=example,
            )
            self.refuse_head(name, why)
            return nan
        if bare and not self._measures(name, unit, quantity):
            return nan
        try:
            return _within_a_turn(f"{text} {unit}" if bare else text, quantity)
        except ValueFaultError as error:
            self._note(row, error.at(self.place(row, name)))
            return nan

    def _is_empty(self, row: Row, name: str, text: str) -> bool:
        """Whether nothing stands where a number is wanted; it is noted then."""
        if not text:
            self.refuse(row, name, _("the cell is empty"))
        return not text

    def _is_date(self, row: Row, name: str, text: str) -> bool:
        """Whether a date stands where a number is wanted; it is noted then."""
        if DATE.fullmatch(text) is None:
            return False
        self._note(row, sentence("cell.date", {}, place=self.place(row, name)))
        return True

    def _measures(self, name: str, unit: str, quantity: Quantity) -> bool:
        """Whether the unit of a heading is one of the quantity; else it is noted."""
        try:
            units.si(f"1 {unit}", quantity)
        except ValueFaultError as error:
            if error.code in ("unit.too-small", "unit.too-large"):
                return True  # one of it is no mistake
            column = self._places[name]
            if column not in self._told:
                self._told.add(column)
                line = self.listed.line
                place = _("line {line}, column {column}", line=line, column=column + 1)
                values = {**error.values, "value": f'"{self._head(name)}"'}
                self.mistakes.append(Mistake(line, sentence(error.code, values, place=place)))
            return False
        return True

    def _head(self, name: str) -> str:
        return one_line(self.listed.heads[self._places[name]], longest=60)

    def _place(self, line: int, column: int) -> str:
        head = one_line(self.listed.heads[column], longest=60)
        return _('line {line}, column "{head}"', line=line, head=head)

    def _found(self, known: Mapping[str, str]) -> dict[str, int]:
        """The column of each name; headings that are not known are noted."""
        found: dict[str, int] = {}
        keys, heads = self.listed.keys, self.listed.heads
        for index, (key, head) in enumerate(zip(keys, heads, strict=True)):
            if not key and not any(row.cells[index] for row in self.rows):
                continue
            if not head.strip():
                told = _(
                    "line {line}: column {column} has values and no heading; name it, or leave it "
                    "out",
                    line=self.listed.line,
                    column=index + 1,
                )
                self.mistakes.append(Mistake(self.listed.line, told))
            elif key not in known:
                self._refuse_unknown(head, known)
            elif known[key] not in found:
                found[known[key]] = index
            elif keys.index(key) == index:
                told = _(
                    'the columns "{first}" and "{second}" mean the same; leave one out',
                    first=one_line(heads[found[known[key]]], longest=60),
                    second=one_line(head, longest=60),
                )
                self.mistakes.append(Mistake(self.listed.line, told))
        return found

    def _refuse_unknown(self, head: str, known: Mapping[str, str]) -> None:
        near = get_close_matches(key_of(head), list(known), 1, 0.75)
        line = self.listed.line
        told = (
            _(
                'line {line}: the column {head} is not known; "{meant}" is',
                line=line,
                head=seen(head),
                meant=near[0],
            )
            if near
            else _(
                "line {line}: the column {head} is not known; name columns {names}",
                line=line,
                head=seen(head),
                names=", ".join(_usual(known).values()),
            )
        )
        self.mistakes.append(Mistake(line, told))


def _within_a_turn(text: str, quantity: Quantity) -> float:
    """The SI number of a text; an angle of more than a turn is in degrees."""
    number = units.si(text, quantity)
    if quantity.dimension == "angle" and abs(number) > TURN and not in_degrees(units.unit_of(text)):
        raise units.implausible(text, number, quantity)
    return number


def _usual(known: Mapping[str, str]) -> dict[str, str]:
    """The first of the headings of each name, in their order."""
    found: dict[str, str] = {}
    for head, name in known.items():
        found.setdefault(name, head)
    return found
