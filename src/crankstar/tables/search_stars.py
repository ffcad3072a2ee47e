"""Crank stars that a search found, how many there are, and what proves that these are all."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.derive.algebra import radicals as radical
from crankstar.derive.algebra.formula import has_decimal
from crankstar.derive.algebra.typeset import text as formula_text
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, _n, passage
from crankstar.language.numbers import number
from crankstar.language.shown_units import quantity_text
from crankstar.stars import engine_stars
from crankstar.stars.answer import Answer, AnswerRow
from crankstar.stars.engines import firing_order
from crankstar.stars.question import All, Best, Front, Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, Objective, VectorSum, couple
from crankstar.tables.estimates import typical_remarks

ZERO = 1e-6
"""Length up to which a region that holds an exact zero is named as that."""
LONGEST_FORM = 16
"""Letters of a closed form that is shown beside its number."""
ROWS = 60
"""Rows of a list that are shown; all of them go into a file."""


class Hints(NamedTuple):
    """Where the other rows are, and how a search that was stopped goes on."""

    others: str = N_("-o FILE.csv writes all of them")
    stopped: str = N_("The same command with --checkpoint FILE resumes it")


TYPED = Hints()
"""For commands."""


def search_stars(
    answer: Answer, *, engine: Engine | None = None, limit: int | None = ROWS, hints: Hints = TYPED
) -> Document:
    """The stars that were found, the certificate, and the row of the engine they are of."""
    question = answer.question
    shown = answer.rows[:limit]
    rows = tuple(_row(answer, index, row) for index, row in enumerate(shown, 1))
    table = Table("", tuple(_columns(question)), rows, key="rows")
    lines = [
        _legend(question),
        *left_out(question),
        *as_it_is(answer, engine),
        *sentences(answer, shown=len(shown), hints=hints),
    ]
    doubt = () if engine is None else typical_remarks(engine)
    parts = (*doubt, *remarks(census(question.stars)), table, Remarks(tuple(lines)))
    return Document(heading(question, _tops(answer)), parts, _facts(answer))


def _legend(question: Question) -> str:
    """What the last columns count."""
    counted = _(
        "stars: how many have these values; classes: these without mirror images and reversals."
    )
    if any(objective.name == "neighbours" for objective in question.objectives):
        return counted
    return passage([_("neighbours: cylinders side by side that fire in succession."), counted])


def _tops(answer: Answer) -> dict[str, float]:
    """The greatest value in each unit in the table for readers, whose prefix sentences share."""
    question, tops = answer.question, dict[str, float]()
    for row in answer.rows[:ROWS]:
        units = [objective.unit for objective in question.objectives]
        columns = zip(units, row.values, strict=False)
        own = ((vector.unit, vector.of_engine(row.star)) for vector in of_pistons(question))
        for unit, value in (*columns, *own):
            tops[unit] = max(tops.get(unit, 0.0), value)
    return tops


def _length(vector: VectorSum, length: float, tops: Mapping[str, float]) -> str:
    """A length of a sum with its unit, that of the table."""
    return quantity_text(length, vector.unit, beside=tops.get(vector.unit, 0.0))


def _columns(question: Question) -> list[Column]:
    several = question.stars.step == 0
    order = _("firing order (one of several)") if several else _("firing order")
    out = [
        Column(_("row"), key="row", label=True),
        Column(order, kind="order", key="firing_order", label=True),
        Column("", kind="list", key="directions", machine=True),
        Column("", "deg", kind="list", key="throw_angles", machine=True),
    ]
    for objective in question.objectives:
        out.append(Column(objective.name, objective.unit))
        out.append(Column("", objective.unit, key=objective.name, machine=True))
    out += [Column(function.name, key=function.name) for function in question.functions]
    out += [Column(part.name, part.unit, key=part.name) for part in _parts(question)]
    out += [Column(each.short, each.unit, key=each.short) for each in of_pistons(question)]
    out += [Column("", "a", key=f"|sum z exp(i {order} phi)|", machine=True) for order in (1, 2)]
    beside = all(objective.name != "neighbours" for objective in question.objectives)
    out += [
        Column(_("neighbours"), key="neighbours_in_succession", machine=not beside),
        Column(_("stars"), key="stars"),
        Column(_("classes"), key="classes"),
        Column("", key="like", machine=True),
        Column("", key="proved", machine=True),
    ]
    return out


def _row(answer: Answer, index: int, row: AnswerRow) -> tuple[Value, ...]:
    question, stars = answer.question, answer.question.stars
    angles = tuple(-360 * direction / stars.directions + 0.0 for direction in row.star)
    order = tuple(firing_order(stars, row.star))
    cells: list[Value] = [index, order, tuple(row.star), angles]
    for column, objective in enumerate(question.objectives):
        value = float(row.values[column])
        form = closed_form(objective, row)
        written = number(value)
        cells += [f"{form} = {written}" if form and form != written else value, value]
    cells += [float(value) for value in row.values[len(question.objectives) :]]
    cells += [float(part.length(row.star)) for part in _parts(question)]
    cells += [vector.of_engine(row.star) for vector in of_pistons(question)]
    cells += [float(couple(stars, order).length(row.star)) for order in (1, 2)]
    like = tuple(tuple(star) for star in row.like)
    counts = (row.neighbours, row.stars, row.classes, like)
    return (*cells, *counts, answer.certificate.complete)


def _facts(answer: Answer) -> dict[str, Any]:
    """What was searched, how many stars there are, and the certificate."""
    question, proof = answer.question, answer.certificate
    stars = question.stars
    return {
        "cylinders": stars.cylinders,
        "cycle": stars.cycle,
        "directions": stars.directions,
        "positions": [float(place) for place in stars.positions],
        "asked": heading(question),
        "counts": {
            "turned_once": stars.count,
            "mirrored_once": stars.classes(reversed_=False),
            "from_the_rear_once": stars.classes(),
            "found": answer.stars,
        },
        "objectives": [
            {"name": objective.name, "unit": objective.unit} for objective in question.objectives
        ],
        "certificate": {
            "complete": proof.complete,
            "interrupted": proof.interrupted,
            "searched": [{"sum": vector.name, "up_to": length} for vector, length in proof.regions],
            "holds_all_within_limits": proof.whole,
            "stars_searched": proof.met,
            "of_stars": proof.of,
            "blocks": proof.blocks,
            "attempts": proof.attempts,
            "sentence": certificate(answer),
        },
    }


def _parts(question: Question) -> list[VectorSum]:
    """The sums that stand in no column by themselves: those put together in one objective."""
    return [
        vector
        for objective in question.objectives
        if len(objective.terms) > 1
        for _weight, vector in objective.terms
    ]


def of_pistons(question: Question) -> list[VectorSum]:
    """The sums that are searched for the pistons only, and differ from those of all parts."""
    return [vector for vector in question.sums if vector.parts]


def left_out(question: Question) -> list[str]:
    """What the sums of the pistons leave out."""
    sums = of_pistons(question)
    if not sums:
        return []
    values = {
        "pistons": ", ".join(vector.name for vector in sums),
        "sums": ", ".join(vector.short for vector in sums),
    }
    return [
        _(
            "{pistons}: the search leaves out rotating masses, counterweights and other shafts, "
            "whose effect differs between throws, and offsets that shift the pistons. {sums}: "
            "the greatest value with all parts, as `analyze` computes it.",
            **values,
        )
    ]


def as_it_is(answer: Answer, engine: Engine | None) -> list[str]:
    """The sums of the engine with the throws that it has, and the row with that star."""
    star = None if engine is None else engine_stars.star_of(engine, answer.question.stars)
    if star is None:
        return []
    question = answer.question
    own, tops = set(question.stars.same(star)), _tops(answer)
    rows = [
        index for index, row in enumerate(answer.rows, 1) if row.star in own or own & set(row.like)
    ]
    sums = ", ".join(
        f"{vector.short} {_length(vector, vector.of_engine(star), tops)}"
        for vector in question.sums
        if vector.unit
    )
    order = "-".join(map(str, firing_order(question.stars, star)))
    if rows:
        return [
            _(
                "The engine as it is ({order}), row {row}: {sums}.",
                order=order,
                row=rows[0],
                sums=sums,
            )
        ]
    return [
        _("The engine as it is ({order}), not among these rows: {sums}.", order=order, sums=sums)
    ]


def heading(question: Question, tops: Mapping[str, float] | None = None) -> str:
    """The question in a line; limits in the units of a table with these greatest values."""
    stars = question.stars
    what = ", ".join(objective.name for objective in question.objectives)
    cylinders = _n("{count} cylinder", "{count} cylinders", stars.cylinders, count=stars.cylinders)
    values = {"cylinders": cylinders, "cycle": _(stars.cycle), "sums": what}
    limits = [_limit(limit, tops or {}) for limit in question.limits]
    if question.neighbours_at_most < float("inf"):
        most = question.neighbours_at_most
        limits.append(
            _("no neighbours in succession")
            if most == 0
            else _("at most {most} neighbours in succession", most=f"{most:g}")
        )
    asked = _("{cylinders}, {cycle}: all stars", **values)
    if isinstance(question.ask, Front):
        asked = _("{cylinders}, {cycle}: Pareto front of {sums}", **values)
    elif isinstance(question.ask, Best):
        asked = _("{cylinders}, {cycle}: the best by {sums}", **values)
    elif what:
        asked = _("{cylinders}, {cycle}: all stars by {sums}", **values)
    if limits:
        return _("{question}; limits: {limits}", question=asked, limits=", ".join(limits))
    return asked


def _limit(limit: Limit, tops: Mapping[str, float]) -> str:
    """A limit; one between two lengths that are next to each other is that length."""
    name = limit.sum.name
    if limit.greatest == 0:
        return f"{name} = 0"
    if limit.least > 0 and limit.greatest - limit.least < 0.05 * limit.greatest:
        return f"{name} = {_length(limit.sum, (limit.greatest + limit.least) / 2, tops)}"
    return f"{name} ≤ {_length(limit.sum, limit.greatest, tops)}"


def census(stars: Stars) -> str:
    """How many stars there are, and which are counted once."""
    throws = _n("{count} direction", "{count} directions", stars.directions, count=stars.directions)
    if stars.sharing > 1:
        throws = _(
            "{directions}, {cylinders} cylinders in each",
            directions=throws,
            cylinders=stars.sharing,
        )
    mirrored, ends = stars.classes(reversed_=False), stars.classes()
    values = {
        "throws": throws,
        "stars": f"{stars.count:,}",
        "mirrored": f"{mirrored:,}",
        "ends": f"{ends:,}",
    }
    if stars.fixed:
        return _n(
            "{throws}: {stars} star with the fixed throws.",
            "{throws}: {stars} stars with the fixed throws.",
            stars.count,
            **values,
        )
    if stars.symmetric:
        return _(
            "{throws}: {stars} lengthwise symmetric stars; {mirrored} not counting mirror images.",
            **values,
        )
    if ends != mirrored:
        return _(
            "{throws}: {stars} stars; {mirrored} not counting mirror images, {ends} not counting "
            "reversals either.",
            **values,
        )
    return _n(
        "{throws}: {stars} star; {mirrored} not counting mirror images.",
        "{throws}: {stars} stars; {mirrored} not counting mirror images.",
        stars.count,
        **values,
    )


def closed_form(objective: Objective, row: AnswerRow) -> str:
    """The exact value of a single unweighted sum in radicals; empty if long or unknown."""
    if len(objective.terms) != 1 or objective.neighbours:
        return ""
    weight, vector = objective.terms[0]
    if weight != 1 or vector.scale != 1:
        return ""
    length = radical.length(vector.exact(row.star))
    text = "" if has_decimal(length) else formula_text(length)
    return text if len(text) <= LONGEST_FORM else ""


def sentences(answer: Answer, *, shown: int, hints: Hints = TYPED) -> list[str]:
    """How many stars there are, and the certificate."""
    out: list[str] = []
    if shown < len(answer.rows):
        rows = f"{len(answer.rows):,}"
        out.append(
            _(
                "{shown} of {rows} rows are shown; {hint}.",
                shown=shown,
                rows=rows,
                hint=_(hints.others),
            )
        )
    if isinstance(answer.question.ask, All) and answer.stars is not None and answer.rows:
        values = {"stars": f"{answer.stars:,}", "classes": f"{len(answer.rows):,}"}
        out.append(_("Stars: {stars}; classes: {classes}.", **values))
    return [*out, certificate(answer, hints)]


def certificate(answer: Answer, hints: Hints = TYPED) -> str:
    """What was searched, and why no other star belongs to the answer."""
    proof = answer.certificate
    tops = _tops(answer)
    regions = [_region(answer.question, vector, length, tops) for vector, length in proof.regions]
    values = {
        "met": f"{proof.met:,}",
        "of": f"{proof.of:,}",
        "regions": _(" or ").join(regions),
        "blocks": _n("{count} block", "{count} blocks", proof.blocks, count=f"{proof.blocks:,}"),
    }
    if proof.interrupted:
        values["hint"] = _(hints.stopped)
        if answer.rows:
            return _(
                "INCOMPLETE: stopped after {met} of {of} stars, {blocks}. These are the best so "
                "far; nothing is proved. {hint}.",
                **values,
            )
        return _(
            "INCOMPLETE: stopped after {met} of {of} stars, {blocks}, without a result. {hint}.",
            **values,
        )
    if answer.contradicted:
        return _("Proved: no star keeps these limits ({met} of {of} searched, {blocks}).", **values)
    if not regions or proof.met >= proof.of:
        return _n(
            "Proved complete: {of} star was searched, {blocks}.",
            "Proved complete: all {of} stars were searched, {blocks}.",
            proof.of,
            **values,
        )
    if proof.whole:
        return _(
            "Proved complete: all stars with {regions} were searched ({met} of {of}, {blocks}).",
            **values,
        )
    if isinstance(answer.question.ask, Best):
        return _(
            "Proved complete: all stars with {regions} were searched ({met} of {of}, {blocks}); "
            "every other star is worse.",
            **values,
        )
    return _(
        "Proved complete: all stars with {regions} were searched ({met} of {of}, {blocks}); "
        "every other star is worse than one of these rows.",
        **values,
    )


def _region(question: Question, vector: VectorSum, length: float, tops: Mapping[str, float]) -> str:
    """A region that was searched; one that holds an exact zero as that."""
    zero = any(limit.sum == vector and limit.greatest == 0 for limit in question.limits)
    if zero and length < ZERO * vector.scale:
        return f"{vector.name} = 0"
    return f"{vector.name} ≤ {_length(vector, length, tops)}"
