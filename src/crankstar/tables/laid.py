"""Documents and sentences of several engines laid upon each other, each number with its range."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from crankstar.analysis.document import Column, Document, Ranged, Remarks, Table, Value
from crankstar.language.messages import _, passage
from crankstar.language.written import Number, divided, frame, numbers, replaced
from crankstar.tables.cells import rough
from crankstar.tables.number_ranges import number_range
from crankstar.tables.tops import tops

_CLAUSE = re.compile(r"\S.*?(?:[.;](?=\s|$)|。|$)", re.DOTALL)
"""A part of a text that ends with a full stop or a semicolon."""
_PHRASE = re.compile(r"\S.*?(?:[,.;](?=\s|$)|。|$)", re.DOTALL)
"""A part of a text that ends with any of these or a comma."""


def merged(documents: Sequence[Document]) -> Document:
    """The first of several documents, its numbers with the range that the others give them."""
    first, *others = documents
    lookups = [_by_name(document.parts) for document in others]
    parts: list[Table | Remarks] = []
    for name, part in _by_name(first.parts).items():
        like = [lookup.get(name) for lookup in lookups]
        if isinstance(part, Table):
            parts.append(_tables(part, [other for other in like if isinstance(other, Table)]))
        else:
            lines = [other.lines if isinstance(other, Remarks) else () for other in like]
            parts.append(replace(part, lines=sentences(part.lines, lines)))
    return Document(first.title, tuple(parts), first.facts)


def _by_name(parts: Sequence[Table | Remarks]) -> dict[tuple[Any, ...], Table | Remarks]:
    """Parts by kind, title and how many came before them with the same."""
    out: dict[tuple[Any, ...], Table | Remarks] = {}
    for part in parts:
        key = part.key if isinstance(part, Table) else part.kind
        name = (type(part).__name__, key, frame(part.title))
        count = sum(known[:3] == name for known in out)
        out[(*name, count)] = part
    return out


def sentences(lines: Sequence[str], others: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """Each sentence with the ranges that its counterparts give, or marked."""
    like = [counterparts(lines, other) for other in others]
    return tuple(sentence(line, [*own]) for line, *own in zip(lines, *like, strict=True))


def counterparts(lines: Sequence[str], others: Sequence[str]) -> list[str]:
    """The one of the others for each line: with the same words, else in its place, else empty.

    What is said only of other masses moves the rest to other places.

    >>> counterparts(["Bare.", "On shafts."], ["With weights.", "Bare.", "On shafts."])
    ['Bare.', 'On shafts.']
    >>> counterparts(["Up.", "To the left."], ["Up.", "To the right."])
    ['Up.', 'To the right.']
    """
    own, there = _by_words(lines), _by_words(others)
    places = [*there.items(), *([(((), 0), "")] * len(own))]
    return [
        there[name] if name in there else "" if place[0] in own else place[1]
        for name, place in zip(own, places, strict=False)
    ]


def sentence(line: str, others: Sequence[str]) -> str:
    """A sentence whose numbers have the range they have in the others; marked if these differ.

    >>> from crankstar.language.numbers import number
    >>> said = "Force {force} N at order 2."
    >>> lines = [_(said, force=number(force)) for force in (1.2, 1.25, 0.9, 1.6)]
    >>> sentence(lines[0], lines[1:])
    'Force about 1.2 (0.9 to 1.6, estimated) N at order 2.'
    """
    if any(frame(other) != frame(line) for other in others):
        return _in_parts(line, others) if all(others) else _marked(line)
    values = [[each.value for each in numbers(text)] for text in (line, *others)]
    columns = iter(zip(*values, strict=True))

    def written(number: Number) -> str:
        value = number_range(next(columns))
        if not isinstance(value, Ranged):
            return number
        ends = {"low": rough(value.low), "high": rough(value.high)}
        typical = rough(_size(value.value))
        if ends["low"] == ends["high"]:
            return _("about {typical} (estimated)", typical=typical)
        return _("about {typical} ({low} to {high}, estimated)", typical=typical, **ends)

    return replaced(line, written)


def _in_parts(line: str, others: Sequence[str]) -> str:
    """A sentence whose words differ from those of others, each part of it with its own range.

    Parts in a row that others lack are marked once, behind the last.
    """
    for part in (_CLAUSE, _PHRASE):
        own = divided(part, line)
        if len(own) > 1:
            pools = [_by_words(divided(part, other)) for other in others]
            named = _by_words(own)
            lacking = [any(name not in pool for pool in pools) for name in named]
            out: list[str] = []
            for (name, text), lacks, next_too in zip(
                named.items(), lacking, [*lacking[1:], False], strict=True
            ):
                if part is _PHRASE and lacks and next_too:
                    out.append(_roughly(text))
                    continue
                pool_of = zip(pools, others, strict=True)
                out.append(sentence(text, [pool.get(name, other) for pool, other in pool_of]))
            return passage(out)
    return _marked(line)


def _size(value: float | complex) -> float:
    return abs(value) if isinstance(value, complex) else value


def _marked(line: str) -> str:
    """A sentence that is said to rest on estimates, before its full stop; its numbers rough."""
    text = _roughly(line)
    words = text.rstrip(".;,。")
    return _("{sentence} (estimated)", sentence=words) + text[len(words) :]


def _roughly(line: str) -> str:
    """A sentence with its numbers rough."""
    return replaced(line, lambda each: rough(_size(each.value)))


def _by_words(clauses: Sequence[str]) -> dict[tuple[Any, int], str]:
    """Clauses by their words and how many came before with the same."""
    out: dict[tuple[Any, int], str] = {}
    for clause in clauses:
        words = frame(clause)
        out[words, sum(key[0] == words for key in out)] = clause
    return out


def _tables(table: Table, others: Sequence[Table]) -> Table:
    """A table with the ranges that the others give its numbers, row by row."""
    labels = [index for index, column in enumerate(table.columns) if column.label]
    labels = labels or [0] * bool(table.columns)
    lookups = [_rows(other, labels) for other in others]
    own = _rows(table, labels)
    missing = {
        name: row
        for lookup in lookups
        for name, row in lookup.items()
        if name not in own and _has_numbers(row)
    }
    zeros = {name: tuple(map(_zero, table.columns, row)) for name, row in missing.items()}
    measures = tops(table, others)
    rows: list[tuple[Value, ...]] = []
    for name, row in {**own, **zeros}.items():
        like = [lookup.get(name, _absent(table.columns, row)) for lookup in lookups]
        rows.append(
            tuple(
                _cell(
                    table.columns[index],
                    value,
                    [other[index] if index < len(other) else None for other in like],
                    measures[index](row),
                )
                for index, value in enumerate(row)
            )
        )
    columns = tuple(
        replace(column, estimated=any(isinstance(row[index], Ranged) for row in rows))
        for index, column in enumerate(table.columns)
    )
    notes = sentences(table.notes, [other.notes for other in others])
    return replace(table, columns=columns, rows=tuple(rows), notes=notes)


def _rows(table: Table, labels: Sequence[int]) -> dict[tuple[Any, ...], tuple[Value, ...]]:
    """The rows by their labels and how many came before with the same."""
    out: dict[tuple[Any, ...], tuple[Value, ...]] = {}
    for row in table.rows:
        name = tuple(row[place] for place in labels if place < len(row))
        count = sum(known[0] == name for known in out)
        out[name, count] = row
    return out


def _has_numbers(row: tuple[Value, ...]) -> bool:
    return any(isinstance(value, int | float | complex) for value in row)


def _absent(columns: Sequence[Column], row: tuple[Value, ...]) -> tuple[Value, ...]:
    """The row of an engine that has none with these labels: nothing in it, or not said of it."""
    if _has_numbers(row):
        return tuple(map(_zero, columns, row))
    return tuple(value if column.label else "" for column, value in zip(columns, row, strict=True))


def _zero(column: Column, value: Value) -> Value:
    """The value of a row that is left out because nothing is in it."""
    if column.label or not isinstance(value, int | float | complex):
        return value
    return 0j if isinstance(value, complex) else 0.0


def _cell(column: Column, value: Value, others: Sequence[Value], top: float) -> Value:
    """A cell with the range that the others give it; an angle is the same after 360 degrees."""
    if isinstance(value, str):
        return sentence(value, [other if isinstance(other, str) else "" for other in others])
    if isinstance(value, bool) or not isinstance(value, int | float | complex):
        return value
    if column.kind == "phase" or column.label:
        return value
    numbers = [
        other if isinstance(other, int | float | complex) else 0.0 for other in (value, *others)
    ]
    if all(isinstance(number, int) for number in numbers) and len(set(numbers)) == 1:
        return value
    if column.unit == "deg":  # each as near to the value as it comes
        own, *_others = reals = [number.real for number in numbers]
        numbers = [own + (each - own + 180) % 360 - 180 for each in reals]
    return number_range(numbers, top)
