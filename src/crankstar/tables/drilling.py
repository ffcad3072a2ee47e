"""What to drill in each plane of a rotor, or which slugs of heavy metal to fit, as a table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees, pi
from typing import NamedTuple

from crankstar.analysis.document import Column, Document, Table, Value, remarks
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.language.shown_units import quantity_text
from crankstar.remedy.drilling import Drill, Holes
from crankstar.tables.scales import Scale


class Correction(NamedTuple):
    """A plane: its name, place along the shaft, unbalance [kg m], heavy spot [rad], holes.

    `pin` is the bearing of pin 1 of its shaft; `drilled` is the heavy spot that the holes are for
    where it is another.
    """

    name: str
    z: float | None
    unbalance: float
    angle: float | None
    holes: Holes
    pin: float | None = None
    drilled: float | None = None


def drilling_document(
    title: str,
    corrections: Sequence[Correction],
    drill: Drill,
    *,
    along: Scale | None = None,
    lines: Sequence[str] = (),
    estimated: bool = False,
) -> Document:
    """What to drill in each plane, or which slugs to fit; `lines` come first.

    `estimated`: the holes are for unbalances that rest on estimates.
    """
    if corrections and not any(each.holes.number for each in corrections):
        lines = (*lines, _("No unbalance remains: nothing is to be drilled."))
    facts = {
        "diameter_mm": 1000 * drill.diameter,
        "radius_mm": 1000 * drill.radius,
        "greatest_depth_mm": 1000 * drill.deepest,
        "tip_deg": round(degrees(drill.tip), 9),
        "density_kg_m3": drill.density,
        "slug_kg_m3": drill.slug,
        "axial": drill.axial,
    }
    if not corrections:
        return Document(title, remarks(*lines), {**facts, "holes": []})
    table = _holes(corrections, drill, along)
    if estimated:
        table = _of_estimates(table)
    return Document(title, (*remarks(*lines), table), facts)


def _of_estimates(table: Table) -> Table:
    """The table with its holes marked, which are for the typical unbalance alone."""
    places = [column.key for column in table.columns].index("count")
    marked = [
        replace(column, heading=_("{heading} (estimated)", heading=column.heading))
        for column in table.columns[places:]
    ]
    note = _(
        "What is drilled or fitted is for the typical unbalance; for another in its range, "
        "crankstar drill --unbalance. Weigh the parts before a hole is drilled."
    )
    mark = Column("", kind="text", key="made_for", machine=True)
    columns = (*table.columns[:places], *marked, mark)
    rows = tuple((*row, MADE_FOR) for row in table.rows)
    return replace(table, columns=columns, rows=rows, notes=(*table.notes, note))


def _holes(corrections: Sequence[Correction], drill: Drill, along: Scale | None) -> Table:
    slug = drill.slug is not None
    columns = [Column(_("plane"), kind="text", key="plane", label=True)]
    if along is not None:
        columns.append(Column("z", along.unit, key="z"))
    columns += [
        Column(_("unbalance"), "kg*m", key="unbalance"),
        Column(_("heavy spot"), "deg", key="heavy_spot_deg", digits=4),
        Column(_("slugs") if slug else _("holes"), key="count"),
        Column(_("fit at") if slug else _("drill at"), "deg", kind="list", key="at_deg", digits=4),
    ]
    if along is not None:
        columns.append(Column(_("from pin 1"), "deg", kind="list", key="from_pin_1_deg", digits=4))
    columns += [
        Column(_("length of each") if slug else _("depth of each"), "mm", key="depth_mm", digits=4),
        Column(_("to the tip"), "mm", key="tip_depth_mm", digits=4, machine=not drill.cone),
        Column(_("mass added") if slug else _("mass removed"), "g", key="mass_g", digits=4),
    ]
    rows: list[tuple[Value, ...]] = []
    for each in corrections:
        made, turned = each.holes, pi if slug else 0.0
        at = _bearings(each, turned)
        row: list[Value] = [each.name]
        if along is not None:
            row.append(None if each.z is None else along.of(each.z))
        heavy = None if each.angle is None else _degrees(each.angle)
        row += [each.unbalance, heavy, made.number, at]
        if along is not None:
            row.append(_bearings(each, turned - (each.pin or 0.0)))
        depths = (1000 * made.depth, 1000 * made.tip_depth) if made.number else (None, None)
        row += [*depths, 1000 * made.mass]
        rows.append(tuple(row))
    title = _("Heavy metal to fit") if slug else _("What to drill")
    notes = list(_notes(drill, along))
    if any(each.angle is None and each.holes.number for each in corrections):
        notes.append(_(NO_SLUG if slug else NO_HOLE))
    return Table(title, tuple(columns), tuple(rows), notes=tuple(notes), key="holes")


MADE_FOR = "typical unbalance (estimated)"
"""What the holes of an estimated engine are for, as machines read it."""
NO_HOLE = N_(
    "Without a direction: at the heavy spot that the machine shows; for degrees, give it as in "
    '"12 g mm at 30 deg".'
)
NO_SLUG = N_(
    "Without a direction: opposite the heavy spot that the machine shows; for degrees, give it as "
    'in "12 g mm at 30 deg".'
)
"""Where to correct an unbalance whose direction was not given."""


def _bearings(each: Correction, turned: float) -> tuple[float, ...] | None:
    if each.angle is None or not each.holes.number:
        return None
    middle = each.angle if each.drilled is None else each.drilled
    return tuple(_degrees(middle + turned + angle) for angle in each.holes.angles)


def _degrees(angle: float) -> float:
    """A direction from 0 to 360 deg; readers are shown the tenth that a bench can set."""
    return round(degrees(angle) % 360, 9) % 360


def _notes(drill: Drill, along: Scale | None) -> tuple[str, ...]:
    values = {
        "diameter": quantity_text(1000 * drill.diameter, "mm"),
        "radius": quantity_text(1000 * drill.radius, "mm"),
        "density": quantity_text(drill.density, "kg/m^3"),
        "tip": number(degrees(drill.tip)),
    }
    if drill.slug is not None:
        slug = quantity_text(drill.slug, "kg/m^3")
        how = (
            _(
                "Slugs of {slug} and {diameter} parallel to the crank axis, {radius} from "
                "it, net of the {density} drilled out.",
                slug=slug,
                **values,
            )
            if drill.axial
            else _(
                "Slugs of {slug} and {diameter}, flush with the rim at a radius of "
                "{radius}, net of the {density} drilled out.",
                slug=slug,
                **values,
            )
        )
    elif drill.axial:
        how = _(
            "Holes of {diameter} parallel to the crank axis, {radius} from it, in {density}.",
            **values,
        )
    else:
        how = _(
            "Holes of {diameter} towards the crank axis from a radius of {radius}, in {density}.",
            **values,
        )
    tip = ""
    if drill.cone:
        tip = _(
            "Depth is that at full diameter; the cone of the tip ({tip} deg) below it is counted.",
            **values,
        )
    where = (
        _("Directions as the balancing machine counts them; several holes stand side by side.")
        if along is None
        else _(
            "Directions are bearings at θ = 0, clockwise from up or from pin 1, seen from the "
            "front; several holes stand side by side."
        )
    )
    return tuple(filter(None, (how, tip, where)))
