"""The verdict: what remains of an engine's inertia forces, what removes it, and who does better."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analyses.verdict.firing_facts import layout_sentence, succession_lines
from crankstar.analyses.verdict.relatives import relative_lines
from crankstar.analysis.registry import added, analyses
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import order_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.remains import Sums, remains, summed
from crankstar.remedy import needs
from crankstar.tables.conditions import unit_sentence
from crankstar.tables.cures import cure_lines, fitted_lines, none_remains, proposal
from crankstar.tables.gas_rolls import largest_sentence
from crankstar.tables.roll_cures import grown_with_gas
from crankstar.tables.vector_sentences import vector_sentences

MOMENTS = {
    "roll": N_(
        "Rolling moment without gas on the block, with the flywheel taking the inertia torque: "
        "largest at order {order}, {size}."
    ),
    "axis_moment": N_(
        "Moment of the forces about the crank axis: largest at order {order}, {size}."
    ),
}


class Fact(NamedTuple):
    """A sentence and its subject.

    One of layout, firing, units, force, couple, roll, tolerances, cure, remedied, relatives, or an
    analysis.
    """

    about: str
    sentence: str


def verdict(
    engine: Engine, *, speed: float | None = None, relatives: bool = True
) -> tuple[Fact, ...]:
    """The facts of an engine, couples about the middle of the cylinders.

    In N and N m at `speed` (rad/s), by default the engine's own; in units of m r w^2 where there is
    none, or masses or sizes are not known. `relatives`: also the engines of the catalog it compares
    with.

    >>> from crankstar.files.catalog import load
    >>> verdict(load("i4"), relatives=False)[3].sentence.partition(" Order 4")[0]
    'No primary force. Secondary force: 1.0161 m r ω², vertical.'
    """
    speed = engine.speed if speed is None else speed
    result = balance(engine, speed=speed)
    sums = summed(result)
    facts = [
        ("layout", layout_sentence(engine)),
        *(("firing", sentence) for sentence in succession_lines(engine)),
        ("units", unit_sentence(engine, result)),
        ("force", vector_sentences("force", result, sums)),
        ("couple", vector_sentences("couple", result, sums)),
        ("roll", largest_sentence(engine, speed=speed)),
        ("roll", _moment_sentences(result, sums)),
        *_of_analyses(engine, speed),
        *(("cure", sentence) for sentence in _cures(engine, speed)),
        *(("remedied", sentence) for sentence in grown_with_gas(engine, speed=speed)),
        *(("relatives", sentence) for sentence in (relative_lines(engine) if relatives else [])),
    ]
    return tuple(Fact(*fact) for fact in facts if fact[1])


def _moment_sentences(result: Balance, sums: Sums) -> str:
    """The greatest order of the rolling moment on the block, and of the moment about the axis."""
    turning = remains(sums.axis_moment)
    there = {"roll": turning or remains(sums.torque), "axis_moment": turning}
    out: list[str] = []
    for name, sentence in MOMENTS.items():
        signal = getattr(sums, name)
        amplitudes = spectra.amplitude(signal)
        place = as_given(("largest", name), int(np.argmax(np.abs(amplitudes))))
        if of_any(("there", name), [True] * bool(there[name] and amplitudes[place])):
            size = quantity_text(complex(amplitudes[place]), result.units.moment)
            out.append(_(sentence, order=order_text(signal.orders[place]), size=size))
    return passage(out) or _("No rolling moment from inertia.")


def _of_analyses(engine: Engine, speed: float | None) -> Iterator[tuple[str, str]]:
    """What the analyses say whose tables the engine file has."""
    for record in analyses():
        if record.facts is None:
            continue
        with added().among_others(record.name):
            if record.tells(engine, speed):
                for sentence in record.facts.value(engine, speed=speed):
                    yield record.name, sentence


def _cures(engine: Engine, speed: float | None) -> list[str]:
    """What removes what remains of the first two orders of the engine as it is."""
    remaining = needs(engine)
    if none := none_remains(engine):
        return [none]
    cures = [*cure_lines(engine, remaining), proposal(engine, speed=speed)]
    return [*fitted_lines(engine), *cures]
