"""Analyses of an engine some of whose values are estimated: each number with its range.

The analysis is made for the engine as given, for the one in the middle of all ranges and for those
at their corners; its tables and sentences are laid upon each other (`laid`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from crankstar.analysis.document import Document, Remarks, remarks
from crankstar.engine.engine import Engine
from crankstar.files.box import CONDITIONS, MOST_RANGES, Spread
from crankstar.language.alike import alike
from crankstar.language.messages import _, passage
from crankstar.language.written import HOLE
from crankstar.tables.laid import merged, sentences

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Assumption

_TYPE = re.compile(r"engines of type ([a-z-]+)")
"""How the source of an estimated value names the type."""


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
    anything = dict.fromkeys(("sentence", "typical", "low", "high"), HOLE)
    marks = (
        _("{sentence} (estimated)", **anything),
        _("about {typical} (estimated)", **anything),
        _("about {typical} ({low} to {high}, estimated)", **anything),
    )
    patterns = [re.escape(mark).replace(re.escape(HOLE), ".*") for mark in marks]
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
        [corners[index % len(corners)] if corners else engine for index in range(2**MOST_RANGES)]
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
