"""Torsional vibration as tables: chain, modes, critical speeds, twist, stress, heat of damping."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

from crankstar.analyses.torsion.chain_tables import (
    holzer_table,
    mass_table,
    mode_table,
    pendulum_table,
    section_tables,
    shape_table,
)
from crankstar.analyses.torsion.fatigue_tables import fatigue_of, fatigue_tables
from crankstar.analyses.torsion.question import Question
from crankstar.analyses.torsion.response_tables import (
    barred_table,
    heat_table,
    order_table,
    response_table,
    section_table_at,
    worst_table,
)
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each, remarks
from crankstar.dynamics.torsion_analysis import TorsionAnalysis
from crankstar.dynamics.torsion_criticals import Critical
from crankstar.dynamics.torsion_modes import holzer
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import LOSS_FACTOR, STEEL, Chain
from crankstar.language.messages import _, _n
from crankstar.language.numbers import RPM, number, rpm_of
from crankstar.mechanics.doubts import torsion_doubts
from crankstar.tables.gas_words import (
    cycle_state,
    cycle_words,
    range_facts,
    range_words,
    state_facts,
    weaker_facts,
)
from crankstar.tables.headings import heading
from crankstar.tables.torque import assumed_notes
from crankstar.tables.torque import notes as cycle_notes

MODES = 4
"""How many are shown to readers, unless they ask."""
MPA = 1e-6


def document(source: Engine | Chain, found: TorsionAnalysis, asked: Question) -> Document:
    """All of an analysis, with Holzer's table of a mode that is asked for.

    At one speed orders of note are told, else those asked for. Raises TorsionError.
    """
    chain = found.chain
    told, every = found.modes[: asked.modes or MODES], found.modes[: asked.modes]
    parts: list[Table | Remarks] = [heading(source)] if isinstance(source, Engine) else []
    parts += [mass_table(chain), *section_tables(chain), *for_each(*[pendulum_table(chain)] * 2)]
    parts += for_each(mode_table(chain, told), mode_table(chain, every))
    parts += for_each(shape_table(chain, told), shape_table(chain, every)) if every else ()
    if asked.holzer is not None:
        mode = found.modes[asked.holzer - 1]
        parts.append(holzer_table(mode, holzer(chain, speed=mode.speed)))
    parts += _critical_tables(found)
    if found.response is not None:
        parts.append(response_table(found, found.response))
        parts += [worst_table(found, found.response)] if chain.sections else []
    if found.at is not None:
        parts += [section_table_at(found.at, found.exact, found.cycle)] if chain.sections else []
        parts.append(order_table(found, found.at, asked.orders))
    heat = found.at or found.response
    if heat is not None and (heat.heat.any() or heat.absolute_heat.any()):
        parts.append(heat_table(heat))
    parts += for_each(*[barred_table(found)] * 2)
    parts += remarks(*_unbarred(found))
    fatigue, why = fatigue_of(source, found) if isinstance(source, Engine) else (None, "")
    if fatigue is not None and isinstance(source, Engine):
        parts += fatigue_tables(source, found, fatigue)
    parts += [*remarks(*_notes(source, found), kind="note"), *_doubts(source, found, why)]
    facts = _facts(source, found) | ({"without_fatigue": why} if why else {})
    return Document(source.name, tuple(parts), facts)


def _facts(source: Engine | Chain, found: TorsionAnalysis) -> dict[str, Any]:
    cycle = found.cycle
    return {
        "format": 1,
        "chain" if isinstance(source, Chain) else "engine": source.name,
        **state_facts(None if cycle is None else cycle_state(cycle)),
        "speed_rpm": None if cycle is None else rpm_of(cycle.speed),
        "gas_over_speeds": range_facts(source, found.point) if isinstance(source, Engine) else [],
        "imep": None if cycle is None else cycle.imep,
        "off": [] if cycle is None else list(cycle.off),
        "weaker": weaker_facts(cycle),
        "without_gas": found.without_gas or None,
        "free_end": found.chain.names[found.free_end],
        "assumed": [*found.chain.assumed, *(() if cycle is None else cycle.assumed)],
        "estimated_stiffness": list(found.chain.estimated),
        "shear_limit": found.limit,
        "units": {
            "inertia": "kg*m^2",
            "stiffness": "kN*m/rad",
            "damping": "N*m*s/rad",
            "torque": "N*m",
            "stress": "MPa",
            "heat": "W",
        },
    }


def _critical_tables(found: TorsionAnalysis) -> tuple[Table, ...]:
    """Where orders meet modes; for readers those of note."""
    columns = (
        Column(_("mode"), key="mode", label=True),
        Column(_("order"), key="order", label=True),
        Column(_("speed"), "rpm", key="speed_rpm"),
        Column(_("vector sum"), key="vector_sum"),
        Column(_("torque of excitation"), "N*m", key="torque"),
        Column(_("equilibrium amplitude"), "deg", key="equilibrium_deg"),
    )
    rows: dict[Critical, tuple[Value, ...]] = {
        each: (
            each.mode,
            each.order,
            each.speed * RPM,
            each.vector_sum,
            each.torque,
            None if each.equilibrium is None else degrees(each.equilibrium),
        )
        for each in found.criticals
    }
    told = sorted(found.noted, key=lambda each: (each.mode, -each.speed))
    left = len(found.criticals) - len(told)
    said = _n(
        "{count} more is left out, in which the cylinders hardly join; --json has it.",
        "{count} more are left out, in which the cylinders hardly join; --json has them.",
        left,
        count=left,
    )
    if found.cycle is None and found.chain.cylinders:
        said = _("Without gas those of the first mode are listed; --json has all.")
    title, notes = _("Critical speeds"), (said,) if left else ()
    return for_each(
        Table(title, columns, tuple(rows[each] for each in told), notes, key="criticals"),
        Table(title, columns, tuple(rows.values()), key="criticals"),
    )


def _unbarred(found: TorsionAnalysis) -> Iterator[str]:
    """That no speed is barred, where there is a limit and something to hold it against."""
    if found.limit is None or found.response is None or found.barred:
        return
    if any(each.modulus for each in found.chain.sections):
        yield _(
            "No speed is barred: the shear stress of no shaft is over the limit of {limit} MPa.",
            limit=number(found.limit / 1e6),
        )


def _notes(source: Engine | Chain, found: TorsionAnalysis) -> list[str]:
    """What it rests on, and what is left out."""
    lines = [
        _(
            "Rigid turns of the whole are left out; a shape is 1 at the first mass that a shaft "
            "holds."
        )
    ]
    if not found.modes:
        lines = [_("Nothing twists: all masses are rigidly coupled, or by a fluid alone.")]
    if found.chain.rings:
        lines.append(
            _("A ring that its fluid alone takes along stands still in the natural frequencies.")
        )
    if isinstance(source, Chain):
        return lines
    if any(shaft.weights and not shaft.throws for shaft in source.shafts):
        lines.append(_("Balance shafts are in it where the table [torsion] has them as discs."))
    if not found.speeds.size:
        lines.append(_("Without a speed nothing is driven: give --speeds, or speed in the file."))
        return lines
    if found.response is None:
        lines.append(_("Without masses and without gas nothing is driven."))
        return lines
    if found.cycle is not None:
        lines += cycle_notes(source, found.cycle)
        lines.append(range_words(source, found.point))
        if found.at is not None:
            lines.append(cycle_words(source, found.cycle))
    if found.range_assumed:
        lines.append(_("The range of speeds is taken about the one that is known; see --speeds."))
    lines.append(
        _(
            "Torque and stress are those of vibration: the greatest over a cycle, orders with "
            "their phases, beside the sum of all amplitudes; without the mean torque, and without "
            "the concentration of stress at fillets and oil holes."
        )
    )
    return lines


def _doubts(source: Engine | Chain, found: TorsionAnalysis, unfit: str) -> tuple[Remarks, ...]:
    """What is doubtful of the chain, and what is missing of the excitation.

    `unfit`: why there is no fatigue, though it is asked for.
    """
    lines: list[str] = []
    if isinstance(source, Engine):
        lines += [fault.sentence for fault in torsion_doubts(source)]
    if found.response is not None and not found.chain.damped:
        lines.append(
            _(
                "Nothing damps: at a critical speed the vibration has no bound, and near one what "
                "is printed means little; give torsion.damping or torsion.loss_factor."
            )
        )
    if found.without_gas:
        lines.append(_("Without gas: {reason}.", reason=found.without_gas.rstrip(".")))
    if found.response is not None and found.response.without_inertia:
        lines.append(_("Without masses there is no inertia torque: this is gas alone."))
    if unfit:
        lines.append(_("Without fatigue: {reason}.", reason=unfit.rstrip(".")))
    return (*remarks(*lines, kind="doubt"), *remarks(*_assumed(source, found), kind="assumed"))


def _assumed(source: Engine | Chain, found: TorsionAnalysis) -> list[str]:
    """What is assumed of the shafts and of the cycle."""
    lines: list[str] = []
    if found.chain.estimated:
        lines.append(
            _("The stiffness between the throws is estimated from their dimensions by a formula.")
        )
    if "torsion.dimensions.shear_modulus" in found.chain.assumed:
        lines.append(_("Shear modulus: {value} GPa, assumed.", value=number(STEEL / 1e9)))
    if any(name.endswith("loss_factor") for name in found.chain.assumed):
        value = number(LOSS_FACTOR)
        if found.response is None:
            lines.append(_("Assumed: {paths}.", paths=f"loss_factor ({value})"))
        else:
            lines.append(
                _(
                    "Loss factor of the shafts: {value}, assumed; amplitudes at resonance go with "
                    "it.",
                    value=value,
                )
            )
    if found.cycle is not None and isinstance(source, Engine):
        lines += assumed_notes(source, found.cycle)
    return lines
