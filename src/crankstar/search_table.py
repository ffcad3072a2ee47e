"""What a search found, as a table, in sentences, as CSV, JSON and Parquet."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Any, NamedTuple

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.derive import radical
from crankstar.derive.typeset import text as formula_text
from crankstar.engine import Engine
from crankstar.search import weighed
from crankstar.search.engines import firing_order
from crankstar.search.findings import Finding, Findings
from crankstar.search.question import All, Best, Front, Question
from crankstar.search.stars import Stars
from crankstar.search.sums import Limit, Objective, VectorSum, couple
from crankstar.wording import number, table, unit_text

ZERO = 1e-6
"""Length up to which a strip that holds an exact zero is told as that."""
LONGEST_FORM = 16
"""Letters of a closed form that is shown beside its number."""
ROWS = 60
"""Rows of a list that are shown; all of them go into a file."""


def search_table(found: Findings, *, engine: Engine | None = None, rows: int = ROWS) -> RenderableType:
    """The stars that were found, how many there are, and what proves that these are all; how the engine they are of does."""
    question = found.question
    shown = found.rows[:rows]
    lines: list[RenderableType] = [Text(heading(question), style="bold"), Text(census(question.stars)), Text()]
    if shown:
        lines += [_table(found, shown), Text()]
    lines += [Text(line) for line in [*as_it_is(found, engine), *sentences(found, shown=len(shown))]]
    return Group(*lines)


def as_it_is(found: Findings, engine: Engine | None) -> list[str]:
    """How the engine does with the throws that it has, and which row that is."""
    star = None if engine is None else weighed.star_of(engine, found.question.stars)
    if star is None:
        return []
    question = found.question
    own = set(question.stars.same(star))
    there = [place for place, row in enumerate(found.rows, 1) if row.star in own or own & set(row.like)]
    vectors = [vector for vector in question.sums if vector.unit]
    sums = ", ".join(f"{vector.name} {number(vector.length(star))} {unit_text(vector.unit)}" for vector in vectors)
    where = f"row {there[0]}" if there else "in none of these rows"
    order = "-".join(map(str, firing_order(question.stars, star)))
    return [f"The engine as it is ({order}) is {where}: {sums}."]


def heading(question: Question) -> str:
    """What was asked, in a line."""
    stars = question.stars
    what = ", ".join(objective.name for objective in question.objectives)
    asked = {Front: f"front of {what}", Best: f"the best by {what}", All: f"all stars, by {what}" if what else "all stars"}[
        type(question.ask)
    ]
    limits = [_limit(limit) for limit in question.limits]
    if question.neighbours_at_most < float("inf"):
        most = question.neighbours_at_most
        limits.append("no neighbours in succession" if most == 0 else f"neighbours in succession up to {most:g}")
    kept = f", with {', '.join(limits)}" if limits else ""
    return f"{stars.cylinders} cylinders, {stars.cycle}: {asked}{kept}"


def _limit(limit: Limit) -> str:
    """A limit in words; a length between two that are next to each other is that length."""
    if limit.greatest == 0:
        return f"{limit.sum.name} = 0"
    if limit.least > 0 and limit.greatest - limit.least < 0.05 * limit.greatest:
        return f"{limit.sum.name} = {number((limit.greatest + limit.least) / 2)}"
    return f"{limit.sum.name} up to {number(limit.greatest)}"


def census(stars: Stars) -> str:
    """How many stars there are, and what is counted once."""
    throws = _counted(stars.directions, "direction") + (f", {stars.sharing} cylinders in each" if stars.sharing > 1 else "")
    kind = " lengthwise symmetric" if stars.symmetric else ""
    if stars.fixed:
        return f"{throws}: {stars.count:,}{kind} stars with the fixed throws"
    mirrored = stars.classes(reversed_=False)
    once = _counted(stars.count, f"{kind} star".strip())
    counted = f"{once}, turned ones counted once; {_counted(mirrored, 'class')} with mirrored ones"
    ends = stars.classes()
    if ends != mirrored:
        counted += f", {ends:,} with those from the rear end too"
    return f"{throws}: {counted}"


def _table(found: Findings, shown: Sequence[Finding]) -> RenderableType:
    heads, body = cells(found, shown)
    out = table(*heads, left=(heads[1],))
    for row in body:
        out.add_row(*row)
    return out


def cells(found: Findings, shown: Sequence[Finding]) -> tuple[list[str], list[list[str]]]:
    """Rows of an answer as they are printed, and the heads of their columns."""
    question = found.question
    named = [_head(objective) for objective in question.objectives] + [judge.name for judge in question.judges]
    beside = all(objective.name != "neighbours" for objective in question.objectives)
    counted = ["neighbours"] if beside else []
    parts = _parts(question)
    names = [_sum_head(vector) for vector in parts]
    order_head = "firing order (one of several)" if question.stars.step == 0 else "firing order"
    body: list[list[str]] = []
    for place, row in enumerate(shown, 1):
        values = [_cell(question, row, column) for column in range(len(row.values))]
        values += [number(vector.length(row.star)) for vector in parts]
        tail = [str(row.neighbours)] if beside else []
        order = "-".join(map(str, firing_order(question.stars, row.star)))
        body.append([str(place), order, *values, *tail, f"{row.stars:,}", f"{row.classes:,}"])
    return ["", order_head, *named, *names, *counted, "stars", "classes"], body


def _parts(question: Question) -> list[VectorSum]:
    """The sums that stand in no column by themselves: those put together in one objective."""
    return [vector for objective in question.objectives if len(objective.terms) > 1 for _, vector in objective.terms]


def _sum_head(vector: VectorSum) -> str:
    return f"{vector.name} [{unit_text(vector.unit)}]" if vector.unit else vector.name


def _head(objective: Objective) -> str:
    return f"{objective.name} [{unit_text(objective.unit)}]" if objective.unit else objective.name


def _cell(question: Question, row: Finding, column: int) -> str:
    """A value, and its closed form where that is short."""
    value = number(row.values[column])
    if column >= len(question.objectives):
        return value
    form = closed_form(question.objectives[column], row)
    return f"{form} = {value}" if form and form != value else value


def closed_form(objective: Objective, row: Finding) -> str:
    """The exact value of a single unweighted sum in radicals; empty where that is long, or there is none."""
    if len(objective.terms) != 1 or objective.neighbours:
        return ""
    weight, vector = objective.terms[0]
    if weight != 1 or vector.scale != 1:
        return ""
    closed = radical.length(vector.exact(row.star))
    text = formula_text(closed.formula) if closed.exact else ""
    return text if len(text) <= LONGEST_FORM else ""


class Hints(NamedTuple):
    """What helps on. others: where the rows are that are not shown; stopped: how a search could go on that was stopped."""

    others: str = "-o FILE.csv has all of them"
    stopped: str = "With --checkpoint FILE the same command goes on from there"


TYPED = Hints()
"""For who typed the command."""


def sentences(found: Findings, *, shown: int, hints: Hints = TYPED) -> list[str]:
    """How many there are, and the certificate."""
    out: list[str] = []
    if shown < len(found.rows):
        out.append(f"{shown} of {len(found.rows):,} rows are shown; {hints.others}.")
    if isinstance(found.question.ask, All) and found.stars is not None:
        out.append(f"{_counted(found.stars, 'star')} in {_counted(len(found.rows), 'class')}." if found.rows else "")
    out.append(certificate(found, hints))
    return [line for line in out if line]


def _counted(many: int, name: str) -> str:
    return f"{many:,} {name}" + ("" if many == 1 else "es" if name.endswith("s") else "s")


def certificate(found: Findings, hints: Hints = TYPED) -> str:
    """What was searched, and why nothing else can belong to the answer."""
    proof = found.certificate
    where = " or ".join(_strip(found.question, vector, length) for vector, length in proof.strips)
    what = f"all stars{f' with {where}' if where and proof.met < proof.of else ''}"
    met = f"{proof.met:,} of {proof.of:,}, in {_counted(proof.blocks, 'block')}"
    if proof.interrupted:
        so_far = "What is shown is the best so far; nothing is proved." if found.rows else "Nothing was found yet."
        return f"INCOMPLETE: stopped before the end ({met}). {so_far} {hints.stopped}."
    if found.contradicted:
        return f"Proved: no star keeps these limits; {what} were searched ({met})."
    if proof.whole:
        return f"Proved complete: {what} were searched ({met})."
    why = "one of them is within each of these, and so better than all that are outside"
    if isinstance(found.question.ask, Best):
        why = "all others are worse"
    elif len(proof.strips) == 1:
        why = "one of them is so good that nothing outside is better"
    return f"Proved complete: {what} were searched ({met}); {why}."


def _strip(question: Question, vector: VectorSum, length: float) -> str:
    """A strip in words; one that is there to hold an exact zero as that."""
    zero = any(limit.sum == vector and limit.greatest == 0 for limit in question.limits)
    return f"{vector.name} = 0" if zero and length < ZERO * vector.scale else f"{vector.name} up to {number(length)}"


def rows(found: Findings) -> tuple[list[str], list[list[Any]]]:
    """All findings as columns: place, firing order, direction and throw angle of each cylinder, values, numbers."""
    question, stars = found.question, found.question.stars
    couples = [couple(stars, order) for order in (1, 2)]
    heads = ["row", "firing_order", "directions", "throw_angles [deg]"]
    heads += [_head(objective).replace(unit_text(objective.unit), objective.unit) for objective in question.objectives]
    heads += [judge.name for judge in question.judges]
    parts = _parts(question)
    heads += [f"{vector.name} [{vector.unit}]" if vector.unit else vector.name for vector in parts]
    heads += [f"|sum z exp(i {order} phi)|" for order in (1, 2)]
    heads += ["neighbours_in_succession", "stars", "classes", "proved"]
    out: list[list[Any]] = []
    for place, row in enumerate(found.rows, 1):
        angles = [f"{-360 * direction / stars.directions + 0.0:.10g}" for direction in row.star]
        order = "-".join(map(str, firing_order(stars, row.star)))
        lengths = [vector.length(row.star) for vector in couples]
        words = [place, order, " ".join(map(str, row.star)), " ".join(angles)]
        told = [*row.values, *(vector.length(row.star) for vector in parts), *lengths]
        out.append([*words, *told, row.neighbours, row.stars, row.classes, found.certificate.complete])
    return heads, out


def csv_text(found: Findings) -> str:
    """All findings as CSV, units in the header."""
    heads, body = rows(found)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(body)
    return out.getvalue()


def tree(found: Findings) -> dict[str, Any]:
    """The findings as one object: what was asked, the rows, how many there are, and the certificate."""
    question, proof = found.question, found.certificate
    stars = question.stars
    return {
        "format": 1,
        "cylinders": stars.cylinders,
        "cycle": stars.cycle,
        "directions": stars.directions,
        "positions": [float(place) for place in stars.positions],
        "asked": heading(question),
        "stars": {
            "turned_once": stars.count,
            "mirrored_once": stars.classes(reversed_=False),
            "from_the_rear_once": stars.classes(),
        },
        "objectives": [{"name": objective.name, "unit": objective.unit} for objective in question.objectives],
        "rows": [
            {
                "firing_order": list(firing_order(stars, row.star)),
                "directions": list(row.star),
                "values": list(row.values),
                "neighbours_in_succession": row.neighbours,
                "stars": row.stars,
                "classes": row.classes,
                "like": [list(star) for star in row.like],
            }
            for row in found.rows
        ],
        "found": found.stars,
        "certificate": {
            "complete": proof.complete,
            "interrupted": proof.interrupted,
            "searched": [{"sum": vector.name, "up_to": length} for vector, length in proof.strips],
            "holds_all_within_limits": proof.whole,
            "stars_searched": proof.met,
            "of_stars": proof.of,
            "blocks": proof.blocks,
            "attempts": proof.attempts,
            "words": certificate(found),
        },
    }


def parquet_bytes(found: Findings) -> bytes:
    """All findings as an Apache Parquet table. Raises ImportError where pyarrow is not installed."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    heads, body = rows(found)
    columns = list(zip(*body, strict=True)) if body else [()] * len(heads)
    out = io.BytesIO()
    pq.write_table(pa.table({head: list(column) for head, column in zip(heads, columns, strict=True)}), out)
    return out.getvalue()
