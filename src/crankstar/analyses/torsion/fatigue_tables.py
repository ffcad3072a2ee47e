"""The safety of a crankshaft against fatigue as a table, and as the sentence of a verdict."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from crankstar.analysis.document import Column, Table, Value, for_each
from crankstar.dynamics.crank_fatigue import (
    ACCEPTED,
    Fatigue,
    FatigueError,
    FilletStress,
    crank_fatigue,
)
from crankstar.dynamics.crank_fillets import torsion_margin
from crankstar.dynamics.torsion_analysis import TorsionAnalysis
from crankstar.engine.engine import Engine
from crankstar.engine.fillets import fillet_ratios
from crankstar.language.alike import as_given
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number

MPA = 1e-6
ALIKE = 1e-9
FILLETS = {"pin": N_("pin"), "journal": N_("journal")}


def fatigue_of(engine: Engine, found: TorsionAnalysis) -> tuple[Fatigue | None, str]:
    """The fatigue of an engine that has the table for it; where there is none, why."""
    if engine.torsion is None or engine.torsion.fatigue is None:
        return None, ""
    try:
        return crank_fatigue(engine, found), ""
    except FatigueError as error:
        return None, str(error)


def fatigue_tables(engine: Engine, found: TorsionAnalysis, own: Fatigue) -> tuple[Table, ...]:
    """The fillets of each throw; for readers throws that are alike as one."""
    return for_each(
        _table(own, _alike(own), kind="text", notes=_notes(engine, found, own)),
        _table(own, [(each.throw, n) for n, each in enumerate(own.fillets)], kind="number"),
    )


def _table(
    own: Fatigue,
    throws: Sequence[tuple[int | str, int]],
    *,
    kind: Literal["text", "number"],
    notes: Sequence[str] = (),
) -> Table:
    columns = (
        Column(_("throw"), kind=kind, key="throw", label=True),
        Column(_("fillet"), kind="text", key="fillet", label=True),
        Column(_("nominal bending"), "MPa", key="bending", fixed=True, digits=4),
        Column(
            _("nominal compression"), "MPa", key="compression", fixed=True, digits=4, machine=True
        ),
        Column(_("nominal torsion"), "MPa", key="torsion", fixed=True, digits=4),
        Column(_("bending factor"), key="factor_bending", digits=4, optional=1),
        Column(_("compression factor"), key="factor_compression", digits=4, machine=True),
        Column(_("torsion factor"), key="factor_torsion", digits=4, optional=1),
        Column(
            _("bending in the fillet"),
            "MPa",
            key="fillet_bending",
            fixed=True,
            digits=4,
            optional=2,
        ),
        Column(
            _("torsion in the fillet"),
            "MPa",
            key="fillet_torsion",
            fixed=True,
            digits=4,
            optional=2,
        ),
        Column(_("equivalent stress"), "MPa", key="equivalent", fixed=True, digits=4),
        Column(_("fatigue strength"), "MPa", key="strength", fixed=True, digits=4),
        Column(_("acceptability factor"), key="acceptability", digits=4),
    )
    rows = tuple(_row(throw, index, own) for throw, index in throws)
    title = _("Fatigue of the crankshaft")
    return Table(title, columns, rows, tuple(notes), key="fatigue")


def _alike(own: Fatigue) -> list[tuple[int | str, int]]:
    """Fillets by their index in `fillets`, with the throws that are like it."""
    groups: list[list[int]] = []
    for index, each in enumerate(own.fillets):
        alike = [g for g in groups if _are_alike(own.fillets[g[0]], each)]
        if alike:
            alike[0].append(index)
        else:
            groups.append([index])
    return [(_listed([own.fillets[n].throw for n in group]), group[0]) for group in groups]


def _are_alike(one: FilletStress, other: FilletStress) -> bool:
    return one.place == other.place and all(
        abs(a - b) <= ALIKE * max(abs(a), abs(b)) for a, b in zip(one[2:], other[2:], strict=True)
    )


def _listed(throws: Sequence[int]) -> str:
    """Numbers of throws; three and more in a row as the first and the last."""
    if len(throws) > 2 and throws[-1] - throws[0] == len(throws) - 1:
        return f"{throws[0]}-{throws[-1]}"
    return ", ".join(map(str, throws))


def _row(throw: int | str, index: int, own: Fatigue) -> tuple[Value, ...]:
    each = own.fillets[index]
    used = own.factors[each.throw - 1]
    compression = None if each.place == "pin" else used["journal_compression"]
    return (
        throw,
        _(FILLETS[each.place]) if isinstance(throw, str) else each.place,
        each.bending * MPA,
        None if each.place == "pin" else each.compression * MPA,
        each.torsion * MPA,
        used[f"{each.place}_bending"],
        compression,
        used[f"{each.place}_torsion"],
        each.fillet_bending * MPA,
        each.fillet_torsion * MPA,
        each.equivalent * MPA,
        each.strength * MPA,
        each.acceptability,
    )


def _notes(engine: Engine, found: TorsionAnalysis, own: Fatigue) -> list[str]:
    """What the stresses are, and what they rest on."""
    lines = [
        _(
            "Bending by gas and inertia at {rpm} rpm; torsion by vibration: half the range from "
            "minimum to maximum, {torque} N m in {shaft} at {worst} rpm, the maximum between "
            "{low} and {high} rpm.",
            rpm=number(round(own.speed * RPM)),
            torque=number(float(f"{own.torsional.torque:.4g}")),
            shaft=found.chain.section_name(own.torsional.section),
            worst=number(round(own.torsional.speed * RPM)),
            low=number(round(float(found.speeds[0]) * RPM)),
            high=number(round(float(found.speeds[-1]) * RPM)),
        ),
        _(
            "By IACS, Unified Requirement M53, which accepts a crankshaft from an acceptability "
            "factor of {least} on; oil bores are not in it.",
            least=number(ACCEPTED),
        ),
    ]
    if margin := _margin(engine):
        lines.append(
            _(
                "Unverified: two coefficients of the rule; as printed they give the greater "
                "stress, else the factors of torsion are {share} % lower.",
                share=number(float(f"{100 * margin:.2g}")),
            )
        )
    if found.barred:
        lines.append(_("Torsion in barred ranges of speed is left out."))
    if engine.torsion is not None and engine.torsion.fatigue is not None:
        extra = engine.torsion.fatigue.additional_stress
        lines.append(
            _(
                "The equivalent stress has {stress} MPa of bending added for misalignment and "
                "axial vibration.",
                stress=number(extra * MPA),
            )
        )
    return lines


def _margin(engine: Engine) -> float:
    """By which share factors of torsion would be lower; 0 where the file gives them."""
    own = engine.torsion
    if own is None or own.fatigue is None or own.dimensions is None:
        return 0.0
    if {"pin_torsion", "journal_torsion"} <= own.fatigue.factors.keys():
        return 0.0
    radius = max(throw.radius for throw in engine.shafts[0].throws)
    return torsion_margin(fillet_ratios(own.dimensions, own.fatigue, radius=radius))


def fatigue_sentence(engine: Engine, found: TorsionAnalysis) -> str:
    """The weakest fillet and whether it is accepted; nothing without the table for it."""
    own, _why = fatigue_of(engine, found)
    if own is None:
        return ""
    index = own.fillets.index(own.weakest)
    weakest = own.fillets[as_given("weakest fillet", index)]
    words = {
        "factor": number(float(f"{weakest.acceptability:.3g}")),
        "throw": weakest.throw,
        "asked": number(ACCEPTED),
    }
    if as_given("fatigue accepted", own.accepted):
        return _(
            "The crankshaft bears its stress: least acceptability factor {factor}, in a fillet of "
            "throw {throw}; {asked} is asked for.",
            **words,
        )
    return _(
        "The crankshaft may break by fatigue: acceptability factor {factor} in a fillet of throw "
        "{throw}, and {asked} is asked for.",
        **words,
    )
