"""Corrections in two planes as tables: static and couple unbalance, what to add, what is left."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from crankstar.analyses.correct.question import Question
from crankstar.analyses.correct.solving import Corrections
from crankstar.analyses.correct.two_planes import HOLDS, LEAST_EFFECT, static_and_couple
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.language.messages import _, passage
from crankstar.language.numbers import number
from crankstar.options.holes import drill_of
from crankstar.remedy.drilling import holes
from crankstar.spectra import Complex
from crankstar.tables.drilling import Correction, drilling_document

MM2 = 1e9
"""g mm^2 in kg m^2."""


def document(_source: None, result: Corrections, question: Question) -> Document:
    """All of it; instead of weights to add the tables of what to drill."""
    found, drilled = result, _drilled(result, question)
    parts: list[Table | Remarks] = []
    if found.measured is not None:
        parts.append(_measured(found.measured, found.at))
    parts.append(_planes(found))
    if drilled is None:
        parts.append(_added(found))
    else:
        parts += drilled.parts
    if found.left is not None:
        parts.append(_left(found, found.left))
    facts = dict(drilled.facts) if drilled else {}
    if found.influence is not None:
        facts["influence"] = [[[v.real, v.imag] for v in row] for row in found.influence.tolist()]
        parts.append(_influence(found.influence))
    lines = [
        _(
            "Angles are counted as in the input, those of weights and phases in the same "
            "direction; what is added stands opposite the heavy spot. The rotor is rigid."
        )
    ]
    doubts: list[str] = []
    if found.left_share is not None:
        facts["left_share"] = found.left_share
        (lines if found.left_share <= HOLDS else doubts).append(_held(found, found.left_share))
    if found.effects is not None:
        for plane, share in enumerate(found.effects.tolist(), 1):
            if share < LEAST_EFFECT:
                doubts.append(
                    _(
                        "The trial weight in plane {plane} changed the vibration by {share} % at "
                        "most; with a heavier one the answer is surer.",
                        plane=plane,
                        share=number(100 * share, digits=2),
                    )
                )
    return Document(
        _("Correction in two planes"),
        (*parts, *remarks(*lines, kind="note"), *remarks(*doubts, kind="doubt")),
        {"format": 1, **facts},
    )


def _drilled(found: Corrections, question: Question) -> Document | None:
    """What to drill, where a hole is described."""
    if not question.drills:
        return None
    drill = drill_of(question)
    made = [
        Correction(str(at), None, float(abs(each)), float(np.angle(each)), holes(abs(each), drill))
        for at, each in enumerate(found.unbalance, 1)
    ]
    return drilling_document("", made, drill)


def _held(found: Corrections, share: float) -> str:
    """Whether what a check run has left shows that the coefficients hold."""
    left = _(
        "The check run has {share} % of the vibration before, each bearing weighed by its "
        "influence coefficients.",
        share=number(100 * share, digits=3),
    )
    if share <= HOLDS:
        return passage(
            [
                left,
                _(
                    "The coefficients hold as nearly as that; what is left can be corrected with "
                    "them again, opposite its heavy spot."
                ),
            ]
        )
    if found.known:
        return passage(
            [
                left,
                _(
                    "The coefficients do not hold for this rotor, this speed or these bearings, or "
                    "other weights were fitted; take trial runs anew."
                ),
            ]
        )
    return passage(
        [
            left,
            _("Other weights were fitted, or the vibration does not follow them; check the runs."),
        ]
    )


def _vector(value: complex) -> tuple[float, float | None]:
    """Size and direction; nought has none."""
    if not value:
        return 0.0, None
    return abs(value), round(degrees(float(np.angle(value))) % 360, 9) % 360


def _measured(unbalance: Complex, at: Sequence[float]) -> Table:
    """Static and couple unbalance."""
    static, couple = static_and_couple(unbalance, at=at)
    columns = (
        Column(_("unbalance"), kind="text", label=True),
        Column("", kind="text", key="name", machine=True),
        Column(_("size"), "kg*m", key="size"),
        Column(_("couple"), "g*mm^2", fixed=True),
        Column("", "kg*m^2", key="couple", machine=True),
        Column(_("direction"), "deg", key="direction_deg", digits=4),
    )
    (still, where), (twist, turned) = _vector(static), _vector(couple)
    rows: tuple[tuple[Value, ...], ...] = (
        (_("static"), "static", still, None, None, where),
        (_("couple"), "couple", None, MM2 * twist, twist, turned),
    )
    said = _(
        "The couple is taken about the middle of the measuring planes. Its heavy spot is in this "
        "direction in the plane at {place}, and opposite in the other.",
        place=f"{number(1000 * max(at))} mm",
    )
    return Table(_("Static and couple unbalance"), columns, rows, (said,), key="unbalance")


def _influence(influence: Complex) -> Table:
    """How far 1 kg m in a plane moves each bearing; JSON has the matrix in `facts` too."""
    columns = (
        Column(_("at bearing"), key="bearing", label=True),
        Column(_("plane"), key="plane"),
        Column(_("vibration per kg m"), key="vibration_per_kg_m", digits=4),
        Column(_("phase"), "deg", key="phase_deg", digits=4),
    )
    rows = tuple(
        (bearing, plane, *_vector(complex(each)))
        for bearing, own in enumerate(influence, 1)
        for plane, each in enumerate(own, 1)
    )
    said = _(
        "What an unbalance in a plane adds to the vibration of a bearing, in the unit of the list; "
        "the phase is counted from the direction of the unbalance."
    )
    return Table(_("Influence coefficients"), columns, rows, (said,), key="influence_coefficients")


def _planes(found: Corrections) -> Table:
    columns = (
        Column(_("plane"), key="plane", label=True),
        Column(_("unbalance"), "kg*m", key="unbalance"),
        Column(_("heavy spot"), "deg", key="heavy_spot_deg", digits=4),
    )
    rows = tuple((at, *_vector(complex(each))) for at, each in enumerate(found.unbalance, 1))
    return Table(_("Unbalance in the correction planes"), columns, rows, key="planes")


def _added(found: Corrections) -> Table:
    """The weights to add, each at a position."""
    massed = found.radius is not None
    columns = (
        Column(_("plane"), key="plane", label=True),
        Column(_("add at"), "deg", key="at_deg", digits=4),
        Column(_("unbalance"), "kg*m", key="unbalance"),
        *((Column(_("mass"), "g", key="mass_g", digits=4),) if massed else ()),
        Column("", "kg*m", key="plane_unbalance", machine=True),
        Column("", "deg", key="heavy_spot_deg", machine=True),
    )
    rows: list[tuple[Value, ...]] = []
    for plane, weights in enumerate(found.added, 1):
        for each in weights:
            mass = (1000 * each.unbalance / found.radius,) if found.radius is not None else ()
            at = round(degrees(each.angle) % 360, 9) % 360
            whole = _vector(complex(found.unbalance[plane - 1]))
            rows.append((plane, at, each.unbalance, *mass, *whole))
    return Table(_("What to add"), columns, tuple(rows), key="added")


def _left(found: Corrections, left: Complex) -> Table:
    """What the check run shows, and which share of the unbalance before that is."""
    columns = (
        Column(_("plane"), key="plane", label=True),
        Column(_("unbalance"), "kg*m", key="unbalance"),
        Column(_("heavy spot"), "deg", key="heavy_spot_deg", digits=4),
        Column(_("of that before"), "%", key="share_percent", digits=3),
    )
    rows = tuple(
        (at, *_vector(complex(own)), 100 * abs(own) / abs(before) if before else None)
        for at, (own, before) in enumerate(zip(left, found.unbalance, strict=True), 1)
    )
    return Table(_("Left by the check run"), columns, rows, key="left")
