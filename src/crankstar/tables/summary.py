"""How an engine shakes, in a few lines: what remains, the peaks over a turn, the main remedy."""

from __future__ import annotations

from crankstar.analysis.document import Remarks
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import GRAVITY
from crankstar.language.alike import of_any
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import number, order_text
from crankstar.language.shown_units import quantity_text
from crankstar.language.written import joined
from crankstar.mechanics import bounds
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.remains import Sums, pushed
from crankstar.remedy import needs
from crankstar.tables.conditions import assumed_sentence, unit_sentence
from crankstar.tables.cures import cure_lines, fitted_lines, left_by_counterweights, none_remains
from crankstar.tables.gas_rolls import largest_sentence
from crankstar.tables.peaks import FELT, part_peaks
from crankstar.tables.roll_cures import largest_roll
from crankstar.tables.vector_sentences import largest_sentences

PEAKS = {
    "vertical": N_("vertical {size}"),
    "horizontal": N_("horizontal {size}"),
    "pitch": N_("pitch {size}"),
    "yaw": N_("yaw {size}"),
    "roll": N_("roll {size}"),
    "roll beside gas": N_("roll without gas {size}"),
}
"""The parts of force and couple, and the rolling moment, with their peaks."""


def summary(engine: Engine, result: Balance, sums: Sums) -> Remarks:
    """The lines that answer how the engine shakes; ten in a terminal of 80 columns, with its name.

    Largest order of force, couple and rolling moment; peaks over a turn of their vertical and
    horizontal parts; what counterweights would leave, where the file gives none, else the remedy of
    the first vector that has one.
    """
    remaining = [largest_sentences(name, result, sums) for name in ("force", "couple")]
    with_gas = largest_sentence(engine, speed=result.speed)
    remaining += [with_gas, _roll_sentence(result, sums)]
    lines = (
        passage((unit_sentence(engine, result), assumed_sentence(engine))),
        passage(remaining),
        _peaks_sentence(engine, result, sums, beside_gas=bool(with_gas)),
        _remedy_sentence(engine, result),
    )
    return Remarks(tuple(filter(None, lines)))


def _roll_sentence(result: Balance, sums: Sums) -> str:
    """The largest order of the rolling moment of inertia."""
    largest = largest_roll(sums)
    if largest is None:
        return _("No rolling moment from inertia.")
    return _(
        "Roll without gas of order {order}: {size}.",
        order=order_text(largest.order),
        size=quantity_text(largest.wave, result.units.moment),
    )


def _peaks_sentence(engine: Engine, result: Balance, sums: Sums, *, beside_gas: bool) -> str:
    """The peaks over a turn of all orders, and the force beside the weight of the engine."""
    pushes = {
        name: float(pushed(getattr(result, name)).max(initial=0.0)) for name in ("force", "couple")
    }
    whole = {"vertical": "force", "horizontal": "force", "pitch": "couple", "yaw": "couple"}
    found = part_peaks(result, sums)
    felt = of_any(
        "felt",
        [
            name
            for name, (size, _angle, _unit) in found.items()
            if size > FELT * pushes.get(whole.get(name, ""), 0.0)
        ],
    )
    words = PEAKS | ({"roll": PEAKS["roll beside gas"]} if beside_gas else {})
    sizes = [
        _(words[name], size=quantity_text(size, unit))
        for name, (size, _angle, unit) in found.items()
        if name in felt
    ]
    text = _("Peaks: {sizes}.", sizes=joined(", ", sizes)) if sizes else ""
    force = bounds.peak(sums.force).value
    mass = None if engine.block is None else engine.block.mass
    if result.speed is None or mass is None or not force:
        return text
    share = _(
        "The peak force is {share} times the weight of the block of the file, {mass}.",
        mass=quantity_text(mass, "kg"),
        share=number(force * (1 / (mass * GRAVITY)), digits=3),
    )
    return passage((text, share))


def _bare_sentence(engine: Engine, result: Balance) -> str:
    """What usual counterweights would leave, where the file gives none."""
    if any(shaft.weights for shaft in engine.shafts if shaft.throws):
        return ""
    left = left_by_counterweights(engine, speed=result.speed, reference=result.reference)
    if left is None:
        return ""
    if left.factor is None:
        return _(
            "No counterweights in the file; with two on the end webs: {left}.", left=left.words
        )
    return _(
        "No counterweights in the file; with {share} % balanced: {left}.",
        share=f"{100 * left.factor:g}",
        left=left.words,
    )


def _remedy_sentence(engine: Engine, result: Balance) -> str:
    """The first remedy, and that there are others."""
    remaining = needs(engine)
    if none := none_remains(engine):
        return none
    bare = _bare_sentence(engine, result)
    if bare:
        cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
        remaining = [need for need in remaining if need.ratio not in cranks]
    lines = [*filter(None, [bare]), *cure_lines(engine, remaining)]
    others = [_("Cures: crankstar verdict.")] if len(lines) > 1 else []
    return passage((*fitted_lines(engine), lines[0], *others))
