"""Analyses of an engine some of whose values are estimated: each number with its range.

The analysis is made for the engine as given, for the one in the middle of all ranges and for those
at their corners, and its tables and sentences are laid upon each other. An amplitude is linear in
each estimated value while the others are held, and the absolute value of what is linear is convex:
over the box of ranges it is nowhere greater than at a corner. Where it is in the middle the mean of
the corners, it is itself linear (nothing cancels), and nowhere less than at a corner. Else the mean
is greater by d, and it is nowhere less than

    2 |f(middle)| - max |f(corner)|,

since the points x and 2 middle - x lie in the box together. Where d is small this is far too low:
f turns little, its part along f(middle) is linear, and what is across adds b^2 / 2 |f|, which is d
on an average and about d |f(middle)| / |f| at a corner. Twice that below the least corner is taken,
where it is higher (tests draw masses at random). A complex amplitude lies in the convex hull of
those at the corners, whose distance from zero is its lower bound; and a size that knows the
amplitudes it comes from (`language.kept.Size`) is bounded by theirs.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from crankstar.analysis.document import Column, Document, Ranged, Remarks, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.files.box import CONDITIONS, MOST_RANGES, Spread
from crankstar.language.kept import NUMBER, Size, alike, plain, value_of
from crankstar.language.messages import _, passage
from crankstar.tables.cells import rough
from crankstar.tables.hulls import distances, greatest_sum
from crankstar.tables.tops import tops

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Assumption

SAME = 1e-7
"""Share of the greatest value of a column below which values are the same."""
LINEAR = 1e-6
"""Share of the greatest by which the middle may lie below the mean of the corners."""
ANY_TEXT = "\N{OBJECT REPLACEMENT CHARACTER}"
"""Stands for any text in the pattern of a sentence."""
_CLAUSE = re.compile(r"\S.*?(?:[.;](?=\s|$)|。|$)", re.DOTALL)
"""A part of a text that ends with a full stop or a semicolon."""
_TYPE = re.compile(r"engines of type ([a-z-]+)")
"""How the source of an estimated value names the type."""
_PHRASE = re.compile(r"\S.*?(?:[,.;](?=\s|$)|。|$)", re.DOTALL)
"""A part of a text that ends with any of these or a comma."""


def estimated_paths(engine: Engine) -> list[str]:
    """The key paths of the estimated values of an engine."""
    return [path for path, source in engine.provenance.items() if source.status == "estimated"]


def doubt(*engines: Engine, marked: bool = True, told: Collection[str] = ()) -> tuple[Remarks, ...]:
    """What is estimated, in a sentence before everything else; none where nothing is.

    `marked` says that numbers have their ranges, which are those of all but CONDITIONS; the effect
    of the key paths `told` stands in the record of what the numbers rest on.
    """
    paths = dict.fromkeys(path for engine in engines for path in estimated_paths(engine))
    if not paths:
        return ()
    carried = [path for path in paths if path not in CONDITIONS]
    lines = [listed(*engines)]
    if marked and len(carried) == len(paths):
        lines.append(_("What rests on them is marked and given with its range."))
    elif marked and carried:
        line = _(
            "What rests on {paths} is marked and given with its range.", paths=", ".join(carried)
        )
        lines.append(line)
    rest = [path for path in paths if path in told and not (marked and path in carried)]
    if rest:
        lines.append(_("The effect of {paths} is listed below.", paths=", ".join(rest)))
    return remarks(passage(lines), kind="doubt")


def _has_marks(document: Document) -> bool:
    """Whether a number of a document is marked as estimated, in a table or in a sentence."""
    if any(column.estimated for table in document.tables for column in table.columns):
        return True
    anything = dict.fromkeys(("sentence", "typical", "low", "high"), ANY_TEXT)
    marks = (
        _("{sentence} (estimated)", **anything),
        _("about {typical} (estimated)", **anything),
        _("about {typical} ({low} to {high}, estimated)", **anything),
    )
    patterns = [re.escape(mark).replace(re.escape(ANY_TEXT), ".*") for mark in marks]
    return any(
        re.search("|".join(patterns), line)
        for part in document.parts
        for line in (part.lines if isinstance(part, Remarks) else part.notes)
    )


def _told(document: Document) -> list[str]:
    """The key paths of estimated values whose effect the record of a document says."""
    rows: Sequence[Any] = document.facts.get("rests_on", ())
    return [row["path"] for row in rows if row["status"] == "estimated" and row["moves"]]


def listed(*engines: Engine) -> str:
    """The estimated values, and the type of engine that they are usual for."""
    paths = ", ".join(dict.fromkeys(path for each in engines for path in estimated_paths(each)))
    kinds = {
        found[1]: None
        for engine in engines
        for path in estimated_paths(engine)
        if (found := _TYPE.search(engine.provenance[path].source or ""))
    }
    if not kinds:
        return _("Estimated: {paths}.", paths=paths)
    return _("Estimated as of type {types}: {paths}.", types=", ".join(kinds), paths=paths)


def facts(*engines: Engine) -> dict[str, Any]:
    """The estimated values for machines: path, source, range as multiples of the value."""
    rows = [
        {"engine": engine.name, "path": path, "source": source.source, "range": source.range}
        for engine in engines
        for path, source in engine.provenance.items()
        if source.status == "estimated"
    ]
    return {"estimated": rows} if rows else {}


def ranged(
    build: Callable[[Engine], Document],
    spread: Spread | None,
    engine: Engine,
    *,
    rests: Callable[[], Sequence[Assumption]] | None = None,
) -> Document:
    """The analysis of an engine; with a spread, what rests on estimates has its range.

    `rests` gives what the answer rests on besides, which it says after its first part.
    """
    document = build(engine) if spread is None else merged(alike(build, spread.engines))
    return with_doubt(resting(document, rests), engine)


def resting(
    document: Document, rests: Callable[[], Sequence[Assumption]] | None, *, at: str = ""
) -> Document:
    """The document with what it rests on after its first part, and for machines.

    `at` are the values at which it was found, of many.

    What it said itself of what is assumed, part for part, gives way to that record; a doubt that
    both have stands there alone.
    """
    if rests is None:
        return document
    from crankstar.tables.assumptions import assumption_facts, assumption_remarks

    found = rests()
    said = assumption_remarks(found, at=at)
    doubtful = {each.reason for each in found if each.status == "doubtful"}
    parts = [
        _without(part, doubtful) if isinstance(part, Remarks) else part
        for part in document.parts
        if not (isinstance(part, Remarks) and part.kind == "assumed")
    ]
    parts = [part for part in parts if not (isinstance(part, Remarks) and not part.lines)]
    first = 1 if parts and isinstance(parts[0], Remarks) else 0
    parts[first:first] = said
    facts = {**document.facts, **assumption_facts(found)}
    facts |= {"rests_on_at": at} if at and found else {}
    return replace(document, parts=tuple(parts), facts=facts)


def _without(part: Remarks, sentences: Collection[str]) -> Remarks:
    """Remarks without some of their lines."""
    return replace(part, lines=tuple(line for line in part.lines if line not in sentences))


def ranged_side_by_side(
    build: Callable[[Sequence[Engine]], Document],
    spreads: Sequence[Spread | None],
    engines: Sequence[Engine],
) -> Document:
    """The analysis of several engines, each over its own ranges while the others are as given."""
    if not any(spreads):
        return with_doubt(build(engines), *engines)
    ends = [() if spread is None else spread.corners for spread in spreads]
    middles = [
        engine if spread is None else spread.middle
        for engine, spread in zip(engines, spreads, strict=True)
    ]
    # no number is of two engines: all go through their corners at the same time
    at = [
        [corners[place % len(corners)] if corners else engine for place in range(2**MOST_RANGES)]
        for engine, corners in zip(engines, ends, strict=True)
    ]
    most = max(map(len, ends))
    sets = (engines, middles, *list(zip(*at, strict=True))[:most])
    return with_doubt(merged(alike(build, sets)), *engines)


def ranged_lines(
    build: Callable[[Engine], Sequence[str]], spread: Spread | None, engine: Engine
) -> tuple[str, ...]:
    """Sentences on an engine; with a spread, what rests on estimates has its range."""
    if spread is None:
        return tuple(build(engine))
    own, *others = alike(build, (engine, spread.middle, *spread.corners))
    return sentences(own, others)


def with_doubt(document: Document, *engines: Engine) -> Document:
    """The document beginning with what is estimated, which its facts list as well."""
    head = doubt(*engines, marked=_has_marks(document), told=_told(document))
    if not head:
        return document
    beside = {**document.facts, **facts(*engines)}
    return replace(document, parts=(*head, *document.parts), facts=beside)


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
            parts.append(replace(part, title=plain(part.title), lines=sentences(part.lines, lines)))
    return Document(plain(first.title), tuple(parts), _plain_facts(first.facts))


def _plain_facts(facts: Any) -> Any:
    return {key: plain(value) if isinstance(value, str) else value for key, value in facts.items()}


def _skeleton(text: str) -> str:
    return NUMBER.sub("#", text)


def _by_name(parts: Sequence[Table | Remarks]) -> dict[tuple[str, ...], Table | Remarks]:
    """Parts by kind, title and how many came before them with the same."""
    out: dict[tuple[str, ...], Table | Remarks] = {}
    for part in parts:
        key = part.key if isinstance(part, Table) else part.kind
        name = (type(part).__name__, key, _skeleton(part.title))
        count = sum(known[:3] == name for known in out)
        out[(*name, str(count))] = part
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
    own, there = _by_skeleton(lines), _by_skeleton(others)
    places = [*there.items(), *([(("", 0), "")] * len(own))]
    return [
        there[name] if name in there else "" if place[0] in own else place[1]
        for name, place in zip(own, places, strict=False)
    ]


def sentence(line: str, others: Sequence[str]) -> str:
    """A sentence whose numbers have the range they have in the others; marked if these differ.

    >>> from crankstar.language.kept import values_kept
    >>> with values_kept():
    ...     from crankstar.language.numbers import number
    ...     lines = [f"Force {number(n)} N at order {number(2)}." for n in (1.2, 1.25, 0.9, 1.6)]
    >>> sentence(lines[0], lines[1:])
    'Force about 1.2 (0.9 to 1.6, estimated) N at order 2.'
    """
    if all(other == line for other in others):
        return plain(line)
    if any(_skeleton(other) != _skeleton(line) for other in others):
        return _in_parts(line, others) if all(others) else _marked(line)
    values = [[value_of(n) for n, _text in NUMBER.findall(each)] for each in (line, *others)]
    columns = iter(zip(*values, strict=True))

    def written(match: re.Match[str]) -> str:
        numbers = next(columns)
        value = number_range(numbers)
        if not isinstance(value, Ranged):
            return match[2]
        ends = {"low": rough(value.low), "high": rough(value.high)}
        typical = rough(_size(value.value))
        if ends["low"] == ends["high"]:
            return _("about {typical} (estimated)", typical=typical)
        return _("about {typical} ({low} to {high}, estimated)", typical=typical, **ends)

    return NUMBER.sub(written, line)


def _in_parts(line: str, others: Sequence[str]) -> str:
    """A sentence whose words differ from those of others, each part of it with its own range.

    Parts in a row that others lack are marked once, behind the last.
    """
    for part in (_CLAUSE, _PHRASE):
        parts = part.findall(line)
        if len(parts) > 1:
            pools = [_by_skeleton(part.findall(other)) for other in others]
            named = _by_skeleton(parts)
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
    return NUMBER.sub(lambda match: rough(_size(value_of(match[1]))), line)


def _by_skeleton(clauses: Sequence[str]) -> dict[tuple[str, int], str]:
    """Clauses by their words and how many came before with the same."""
    out: dict[tuple[str, int], str] = {}
    for clause in clauses:
        words = _skeleton(clause)
        out[words, sum(key[0] == words for key in out)] = clause
    return out


def _tables(table: Table, others: Sequence[Table]) -> Table:
    """A table with the ranges that the others give its numbers, row by row."""
    labels = [place for place, column in enumerate(table.columns) if column.label]
    labels = labels or [0] * bool(table.columns)
    lookups = [_rows(other, labels) for other in others]
    own = _rows(table, labels)
    missing = {
        name: row
        for lookup in lookups
        for name, row in lookup.items()
        if name not in own and _has_numbers(row)
    }
    nought = {name: tuple(map(_zero, table.columns, row)) for name, row in missing.items()}
    measures = tops(table, others)
    rows: list[tuple[Value, ...]] = []
    for name, row in {**own, **nought}.items():
        like = [lookup.get(name, _absent(table.columns, row)) for lookup in lookups]
        rows.append(
            tuple(
                _cell(
                    table.columns[place],
                    value,
                    [other[place] if place < len(other) else None for other in like],
                    measures[place](row),
                )
                for place, value in enumerate(row)
            )
        )
    columns = tuple(
        replace(
            column,
            heading=plain(column.heading),
            unit=plain(column.unit),
            estimated=any(isinstance(row[place], Ranged) for row in rows),
        )
        for place, column in enumerate(table.columns)
    )
    notes = sentences(table.notes, [other.notes for other in others])
    return replace(table, title=plain(table.title), columns=columns, rows=tuple(rows), notes=notes)


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


def number_range(numbers: Sequence[float | complex], top: float = 0.0) -> float | complex | Ranged:
    """A number as given with its range from those in the middle and at the corners, all in a row.

    It is the number itself where they differ by no more than SAME of the greatest, or of `top`.
    """
    if any(isinstance(each, complex) for each in numbers):
        return _complex_range([complex(each) for each in numbers], top)
    return real_range([*map(float, numbers)], top, bound=_bound(numbers))  # pyright: ignore[reportArgumentType]


def real_range(numbers: Sequence[float], top: float, *, bound: float = 0.0) -> float | Ranged:
    """The same of real numbers, sizes that are nowhere below `bound`."""
    value, middle, *corners = numbers
    least, most = min(numbers), max(numbers)
    if most - least <= SAME * max(top, abs(least), abs(most)):
        return value
    bend = sum(corners) / len(corners) - middle
    if least < 0 or bend <= LINEAR * most:
        return Ranged(value, least, most)
    far = 2 * middle - max(corners)
    near = least - 2 * bend * middle / least if least > 0 else 0.0
    low = max(0.0, far, near, bound)
    return Ranged(value, min(least, low if low > SAME * most else 0.0), most)


def _bound(numbers: Sequence[float]) -> float:
    """What sizes that know their bounds are nowhere below; 0 of others."""
    bounds = [each.bounds for each in numbers if isinstance(each, Size)]
    if len(bounds) < len(numbers) or len({each.shape for each in bounds}) > 1:
        return 0.0
    return float(greatest_sum(np.stack(bounds, axis=-1)))


def _complex_range(numbers: Sequence[complex], top: float) -> complex | Ranged:
    value = numbers[0]
    points = np.array(numbers)
    most = float(np.max(np.abs(points)))
    if float(np.max(np.abs(points - value))) <= SAME * max(top, most):
        return value
    low = float(distances(points))
    return Ranged(value, low if low > SAME * most else 0.0, most)
