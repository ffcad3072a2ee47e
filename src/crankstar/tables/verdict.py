"""The verdict: what remains of an engine's inertia forces, what removes it, and who does better."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import order_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.bounds import greatest
from crankstar.mechanics.remains import (
    MINOR,
    USUAL_ORDERS,
    Sums,
    orders_pushed,
    ranked,
    remains,
    sizes,
    summed,
)
from crankstar.remedy import needs
from crankstar.spectra import Spectrum
from crankstar.tables.conditions import unit_sentence
from crankstar.tables.cures import cure_lines, proposal
from crankstar.tables.firing_facts import layout_sentence, succession_lines
from crankstar.tables.paths import course, vector_name
from crankstar.tables.relatives import relative_lines
from crankstar.tables.table import Column, Document, Table

NONE = {
    "force": N_("No force of any order up to {order}."),
    "couple": N_("No couple of any order up to {order}."),
}
FREE = {
    ("force", 1): N_("No primary force."),
    ("force", 2): N_("No secondary force."),
    ("force", 1, 2): N_("No primary or secondary force."),
    ("couple", 1): N_("No primary couple."),
    ("couple", 2): N_("No secondary couple."),
    ("couple", 1, 2): N_("No primary or secondary couple."),
}
MOMENTS = {
    "roll": N_(
        "Rolling moment on the block, with the flywheel taking the inertia torque: largest at "
        "order {order}, {size}."
    ),
    "axis_moment": N_(
        "Moment of the forces about the crank axis: largest at order {order}, {size}."
    ),
}


class Fact(NamedTuple):
    """A sentence and its subject: layout, firing, units, force, couple, roll, cure, relatives."""

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
        ("force", _vector_sentences("force", result, sums)),
        ("couple", _vector_sentences("couple", result, sums)),
        ("roll", _moment_sentences(result, sums)),
        *(("cure", sentence) for sentence in _cures(engine, speed)),
        *(("relatives", sentence) for sentence in (relative_lines(engine) if relatives else [])),
    ]
    return tuple(Fact(*fact) for fact in facts if fact[1])


def verdict_document(engine: Engine, facts: Sequence[Fact]) -> Document:
    """The facts of an engine in two columns: the subject, and the sentence."""
    columns = (
        Column("", kind="text", label=True),
        Column("", kind="text", wraps=True),
        Column("", kind="text", label=True, machine=True),
    )
    rows = zip(verdict_rows(facts), facts, strict=True)
    table = Table("", columns, tuple((*row, fact.about) for row, fact in rows))
    return Document(engine.name, (table,))


def verdict_rows(facts: Sequence[Fact]) -> list[tuple[str, str]]:
    """Each sentence beside its subject, which is named once."""
    names = subjects()
    before = ["", *(fact.about for fact in facts)]
    return [
        ("" if fact.about == about else names[fact.about], fact.sentence)
        for fact, about in zip(facts, before, strict=False)
    ]


def subjects() -> dict[str, str]:
    """The subjects of facts in the reader's language."""
    return {
        "layout": _("layout"),
        "firing": _("firing"),
        "units": _("units"),
        "force": _("force"),
        "couple": _("couple"),
        "roll": _("rolling moment"),
        "cure": _("remedy"),
        "relatives": _("comparison"),
    }


def _vector_sentences(name: str, result: Balance, sums: Sums) -> str:
    """The orders of force or couple that remain, the largest first; whether 1 and 2 are free."""
    spectrum = getattr(sums, name)
    left, zero = ranked(spectrum, orders_pushed(result))
    if not left:
        return _(NONE[name], order=order_text(USUAL_ORDERS))
    remaining = spectra.selected(spectrum, left)
    largest = float(sizes(remaining).max())
    free = tuple(order for order in (1, 2) if order in zero)
    out = [_(FREE[(name, *free)])] if free else []
    minor: list[str] = []
    for row, (order, size) in enumerate(zip(left, sizes(remaining).tolist(), strict=True)):
        if size < MINOR * largest:
            minor.append(
                _(
                    "order {order}: {size}",
                    order=order_text(order),
                    size=quantity_text(
                        greatest(complex(remaining.forward[row]), complex(remaining.backward[row])),
                        getattr(result.units, name),
                    ),
                )
            )
            continue
        out.append(_vector_sentence(name, result, remaining, row))
    rest = "; ".join(minor)
    out += [f"{rest[:1].upper()}{rest[1:]}."] if rest else []
    return " ".join(out)


def largest_sentence(name: str, result: Balance, sums: Sums) -> str:
    """Whether order 1 and 2 of force or couple are free, and the largest order that remains."""
    spectrum = getattr(sums, name)
    left, zero = ranked(spectrum, orders_pushed(result))
    if not left:
        return _(NONE[name], order=order_text(USUAL_ORDERS))
    free = tuple(order for order in (1, 2) if order in zero)
    largest = _vector_sentence(name, result, spectra.selected(spectrum, left[:1]), 0)
    return f"{_(FREE[(name, *free)])} {largest}" if free else largest


def _vector_sentence(name: str, result: Balance, remaining: Spectrum, row: int) -> str:
    """One order of force or couple: its size and its path."""
    forward, backward = complex(remaining.forward[row]), complex(remaining.backward[row])
    path = spectra.ellipse(forward, backward)
    ratio = Fraction(float(remaining.orders[row])).limit_denominator(1000)
    return _(
        "{vector}: {size}, {course}.",
        vector=vector_name(ratio, force=name == "force", couple=name == "couple"),
        size=quantity_text(greatest(forward, backward), getattr(result.units, name)),
        course=course(path),
    )


def _moment_sentences(result: Balance, sums: Sums) -> str:
    """The greatest order of the rolling moment on the block, and of the moment about the axis."""
    turning = remains(sums.axis_moment, result.axis_moment)
    there = {"roll": turning or remains(sums.torque, result.torque), "axis_moment": turning}
    out: list[str] = []
    for name, sentence in MOMENTS.items():
        signal = getattr(sums, name)
        amplitudes = spectra.amplitude(signal)
        place = int(np.argmax(np.abs(amplitudes)))
        if there[name] and amplitudes[place]:
            size = quantity_text(complex(amplitudes[place]), result.units.moment)
            out.append(_(sentence, order=order_text(signal.orders[place]), size=size))
    return " ".join(out) or _("No rolling moment from inertia.")


def _cures(engine: Engine, speed: float | None) -> list[str]:
    """What removes what remains of the first two orders of the engine as it is."""
    remaining = needs(engine)
    if not remaining:
        return [_("No primary or secondary force or couple remains.")]
    return [*cure_lines(engine, remaining), proposal(engine, speed=speed)]
