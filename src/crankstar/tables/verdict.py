"""The verdict: what remains of an engine's inertia forces, what removes it, and who does better."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Document, Table
from crankstar.analysis.registry import added, analyses
from crankstar.engine.engine import Engine
from crankstar.language.kept import as_given, of_any
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import order_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.bounds import greatest
from crankstar.mechanics.remains import (
    MINOR,
    USUAL_ORDERS,
    Sums,
    orders_pushed,
    remains,
    sizes,
    summed,
)
from crankstar.remedy import needs
from crankstar.spectra import Spectrum
from crankstar.tables.by_order import left_in_any
from crankstar.tables.conditions import unit_sentence
from crankstar.tables.cures import cure_lines, fitted_lines, none_remains, proposal
from crankstar.tables.firing_facts import layout_sentence, succession_lines
from crankstar.tables.gas_rolls import largest_sentence
from crankstar.tables.paths import course, vector_name
from crankstar.tables.relatives import relative_lines
from crankstar.tables.roll_cures import grown_with_gas

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
        ("force", _vector_sentences("force", result, sums)),
        ("couple", _vector_sentences("couple", result, sums)),
        ("roll", largest_sentence(engine, speed=speed)),
        ("roll", _moment_sentences(result, sums)),
        *_of_analyses(engine, speed),
        *(("cure", sentence) for sentence in _cures(engine, speed)),
        *(("remedied", sentence) for sentence in grown_with_gas(engine, speed=speed)),
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
        **{record.name: _(record.subject) for record in analyses() if record.facts},
        "tolerances": _("as built"),
        "cure": _("remedy"),
        "remedied": _("with the remedy"),
        "relatives": _("comparison"),
    }


class _Remaining(NamedTuple):
    """The orders of force or couple that remain, the largest first; those of 1 and 2 that do not.

    `spectrum` is that of the orders.
    """

    orders: Sequence[float]
    free: tuple[int, ...]
    spectrum: Spectrum


def _remaining(name: str, result: Balance, sums: Sums) -> _Remaining:
    left, zero = left_in_any(name, getattr(sums, name), orders_pushed(result))
    left = as_given(("by size", name), left)
    free = tuple(order for order in (1, 2) if order in zero)
    return _Remaining(left, free, spectra.selected(getattr(sums, name), left))


def _vector_sentences(name: str, result: Balance, sums: Sums) -> str:
    """The orders of force or couple that remain, the largest first; whether 1 and 2 are free."""
    remaining = _remaining(name, result, sums)
    if not remaining.orders:
        return _(NONE[name], order=order_text(USUAL_ORDERS))
    out = [_(FREE[(name, *remaining.free)])] if remaining.free else []
    minor: list[str] = []
    for row, order in enumerate(remaining.orders):
        if _is_minor(name, remaining, row):
            size = _greatest(remaining.spectrum, row)
            words = quantity_text(size, getattr(result.units, name))
            minor.append(_("order {order}: {size}", order=order_text(order), size=words))
        else:
            out.append(_vector_sentence(name, result, remaining, row))
    rest = "; ".join(minor)
    out += [_("{text}.", text=f"{rest[:1].upper()}{rest[1:]}")] if rest else []
    return passage(out)


def largest_sentences(name: str, result: Balance, sums: Sums) -> str:
    """The largest order of force or couple, and the size of orders 1 and 2, or that they are free.

    Of these none that is minor.
    """
    remaining = _remaining(name, result, sums)
    if not remaining.orders:
        return _(NONE[name], order=order_text(USUAL_ORDERS))
    out = [_(FREE[(name, *remaining.free)])] if remaining.free else []
    out.append(_vector_sentence(name, result, remaining, 0, brief=True))
    out += [
        _vector_sentence(name, result, remaining, row, course_too=False)
        for row, order in enumerate(remaining.orders)
        if row and order in (1, 2) and not _is_minor(name, remaining, row)
    ]
    return passage(out)


def _greatest(spectrum: Spectrum, row: int) -> float:
    return greatest(complex(spectrum.forward[row]), complex(spectrum.backward[row]))


def _is_minor(name: str, remaining: _Remaining, row: int) -> bool:
    """Whether an order is far smaller than the largest, and no estimate makes it other than 0."""
    lengths = sizes(remaining.spectrum)
    minor = bool(0 < lengths[row] < MINOR * lengths.max())
    return as_given(("minor", name, remaining.orders[row]), minor)


def _vector_sentence(
    name: str,
    result: Balance,
    remaining: _Remaining,
    row: int,
    *,
    course_too: bool = True,
    brief: bool = False,
) -> str:
    """One order of force or couple: its size and its path; that of nothing is none."""
    spectrum, order = remaining.spectrum, remaining.orders[row]
    path = spectra.ellipse(complex(spectrum.forward[row]), complex(spectrum.backward[row]))
    ratio = Fraction(float(order)).limit_denominator(1000)
    words = {
        "vector": vector_name(ratio, force=name == "force", couple=name == "couple"),
        "size": quantity_text(_greatest(spectrum, row), getattr(result.units, name)),
    }
    if course_too and as_given(("course", name, order), path.semi_major > 0):
        return _("{vector}: {size}, {course}.", course=course(path, brief=brief), **words)
    return _("{vector}: {size}.", **words)


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
