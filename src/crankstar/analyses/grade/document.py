"""The permissible residual unbalance of a rotor by grade, and the grade that one meets."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.grade.grades import (
    GRADES,
    grade_met,
    grade_of,
    grade_of_planes,
    permissible,
)
from crankstar.analyses.grade.question import Question, Rotor
from crankstar.analysis.document import Column, Document, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, rpm_of
from crankstar.language.shown_units import quantity_text

USUAL = tuple(grade for grade in GRADES if 1 <= grade <= 40)
"""Grades that are listed where none is asked for."""


def document(engine: Engine | None, result: Rotor, question: Question) -> Document:
    """The permissible residual unbalance by grade, and its force; before it what was measured."""
    title = _("Balance quality of a rotor") if engine is None else engine.name
    rotor, grade = result, question.grade
    measured = [spot.unbalance for spot in question.unbalance or ()]
    grades = USUAL if grade is None else (grade,)
    facts = {"mass_kg": rotor.mass, "speed_rpm": rpm_of(rotor.speed), "shares": list(rotor.planes)}
    parts = [_permissible(rotor, grades)]
    lines: list[str] = []
    if measured:
        worth = grade_of_planes(measured, mass=rotor.mass, speed=rotor.speed, planes=rotor.planes)
        parts.insert(0, _measured(rotor, measured, grade_met(worth) if grade is None else grade))
        facts["grade_measured"] = worth
        lines.append(_verdict(worth, grade))
        facts["planes"] = "bearings" if len(measured) > 1 else "whole"
        if len(measured) > 1:
            lines.append(
                _(
                    "The two residual unbalances count as those in the planes of the bearings. "
                    "Readings in other planes, such as counterweights, have to be converted to "
                    "these first."
                )
            )
    return Document(title, (*remarks(*lines), *parts), facts)


def _verdict(worth: float, grade: float | None) -> str:
    met = grade_met(worth)
    values = {"worth": number(worth, digits=3), "met": number(met or 0.0)}
    if grade is not None and worth > grade * (1 + 1e-9):
        return _(
            "The measured residual unbalance is that of G {worth}: more than G {grade} permits.",
            grade=number(grade),
            **values,
        )
    if grade is not None:
        return _(
            "The measured residual unbalance is that of G {worth}: it meets G {grade}.",
            grade=number(grade),
            **values,
        )
    if met is None:
        return _(
            "The measured residual unbalance is that of G {worth}: it meets no grade of the "
            "standard.",
            **values,
        )
    return _("The measured residual unbalance is that of G {worth}: it meets G {met}.", **values)


def _permissible(rotor: Rotor, grades: Sequence[float]) -> Table:
    columns = (
        Column(_("grade G"), "mm/s", key="grade_mm_s", label=True, fixed=True),
        Column(_("whole"), "kg*m", key="unbalance/whole"),
        Column(_("front bearing"), "kg*m", key="unbalance/front"),
        Column(_("rear bearing"), "kg*m", key="unbalance/rear"),
        Column(_("whole"), "N", key="force/whole"),
        Column(_("front bearing"), "N", key="force/front"),
        Column(_("rear bearing"), "N", key="force/rear"),
    )
    rows: list[tuple[Value, ...]] = []
    for grade in grades:
        whole = permissible(grade, mass=rotor.mass, speed=rotor.speed)
        each = (whole, *(whole * share for share in rotor.planes))
        rows.append((grade, *each, *(size * rotor.speed**2 for size in each)))
    note = _(
        "U = G m / ω with m = {mass} and n = {rpm} rpm; its force is U ω². The bearings share it "
        "{front} to {rear}, by their distances from the centre of mass (--bearing-distances; "
        "default: equal).",
        mass=quantity_text(rotor.mass, "kg"),
        rpm=number(rotor.speed * RPM),
        front=number(rotor.planes[0]),
        rear=number(rotor.planes[1]),
    )
    title = _("Permissible residual unbalance by ISO 21940-11")
    return Table(title, columns, tuple(rows), notes=(note,), key="permissible")


def _measured(rotor: Rotor, measured: Sequence[float], grade: float | None) -> Table:
    """Each plane beside what a grade permits it."""
    both = len(measured) > 1
    heading = _("permissible") if grade is None else _("G {grade}", grade=number(grade))
    columns = (
        Column(_("plane"), kind="text", key="plane", label=True),
        Column(_("measured"), "kg*m", key="unbalance"),
        Column(heading, "kg*m", key="permissible"),
        Column(_("force"), "N", key="force"),
        Column(_("grade G"), "mm/s", key="grade_mm_s", digits=3, fixed=True),
        Column(_("grade G"), "mm/s", key="permissible_grade_mm_s", machine=True, fixed=True),
    )
    names = (_("front bearing"), _("rear bearing")) if both else (_("whole"),)
    parts = rotor.planes if both else (1.0,)
    allowed = None if grade is None else permissible(grade, mass=rotor.mass, speed=rotor.speed)
    rows = tuple(
        (
            name,
            size,
            None if allowed is None else allowed * share,
            size * rotor.speed**2,
            grade_of(size / share, mass=rotor.mass, speed=rotor.speed),
            grade,
        )
        for name, size, share in zip(names, measured, parts, strict=True)
    )
    return Table(_("Measured residual unbalance"), columns, rows, key="measured")
