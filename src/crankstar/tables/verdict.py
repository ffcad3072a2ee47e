"""The verdict: what remains of an engine's inertia forces, what removes it, and who does better."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.mechanics.balance import Balance, balance
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
from crankstar.tables.cures import cure_lines, proposal, vector_name
from crankstar.tables.firing_facts import layout_sentence, succession_lines
from crankstar.tables.paths import course
from crankstar.tables.relatives import relative_lines
from crankstar.tables.table import Column, Document, Table


class Fact(NamedTuple):
    """A sentence and its subject: layout, firing, force, couple, roll, cure, relatives."""

    about: str
    sentence: str


def verdict(engine: Engine, *, relatives: bool = True) -> tuple[Fact, ...]:
    """The facts of an engine, in units of m r w^2, couples about the middle of the cylinders.

    `relatives`: also the engines of the catalog it compares with.

    >>> from crankstar.files.catalog import load
    >>> verdict(load("i4"), relatives=False)[2].sentence
    'No primary force. Secondary force: 1.0161 m r ω², vertical. Order 4: 0.016392; order 6: 0.00029752.'
    """
    result = balance(engine)
    sums = summed(result)
    facts = [
        ("layout", layout_sentence(engine)),
        *(("firing", sentence) for sentence in succession_lines(engine)),
        ("force", _vector_sentences("force", result, sums)),
        ("couple", _vector_sentences("couple", result, sums)),
        ("roll", _moment_sentences(result, sums)),
        *(("cure", sentence) for sentence in _cures(engine)),
        *(("relatives", sentence) for sentence in (relative_lines(engine) if relatives else [])),
    ]
    return tuple(Fact(*fact) for fact in facts)


def verdict_document(engine: Engine, facts: Sequence[Fact]) -> Document:
    """The facts of an engine in two columns: the subject, and the sentence."""
    names = subjects()
    rows: list[tuple[str, str]] = []
    before = ""
    for fact in facts:
        rows.append((names[fact.about] if fact.about != before else "", fact.sentence))
        before = fact.about
    columns = (Column("", kind="text", label=True), Column("", kind="text", wraps=True))
    table = Table("", columns, tuple(rows))
    return Document(engine.name, (table,))


def subjects() -> dict[str, str]:
    """The subjects of facts in the reader's language."""
    return {
        "layout": _("layout"),
        "firing": _("firing"),
        "force": _("force"),
        "couple": _("couple"),
        "roll": _("rolling moment"),
        "cure": _("remedy"),
        "relatives": _("comparison"),
    }


def _vector_sentences(name: str, result: Balance, sums: Sums) -> str:
    """The orders of force or couple that remain, the largest first, and whether 1 and 2 are free."""
    spectrum: Spectrum = getattr(sums, name)
    force = name == "force"
    orders = orders_pushed(result)
    left, zero = ranked(spectrum, orders)
    if not left:
        if force:
            return _("No force of any order up to {order}.", order=number(USUAL_ORDERS))
        return _("No couple of any order up to {order}.", order=number(USUAL_ORDERS))
    unit = unit_text(getattr(result.units, name))
    found = dict(zip(left, sizes(spectra.selected(spectrum, left)).tolist(), strict=True))
    largest = max(found.values())
    out = [_free(force, {1.0, 2.0} & {*zero})]
    minor: list[str] = []
    for order in left:
        values = {"size": number(found[order]), "unit": unit, "order": number(order)}
        if found[order] < MINOR * largest:
            minor.append(_("order {order}: {size}", **values))
            continue
        one = spectra.selected(spectrum, [order])
        path = spectra.ellipse(complex(one.forward[0]), complex(one.backward[0]))
        vector = vector_name(Fraction(order).limit_denominator(1000), force=force, couple=not force)
        out.append(
            _("{vector}: {size} {unit}, {course}.", vector=vector, course=course(path), **values)
        )
    rest = "; ".join(minor)
    out.append(f"{rest[:1].upper()}{rest[1:]}." if rest else "")
    return " ".join(filter(None, out))


def _free(force: bool, zero: set[float]) -> str:
    if zero == {1.0, 2.0}:
        return (
            _("No primary or secondary force.") if force else _("No primary or secondary couple.")
        )
    if 1.0 in zero:
        return _("No primary force.") if force else _("No primary couple.")
    if 2.0 in zero:
        return _("No secondary force.") if force else _("No secondary couple.")
    return ""


def _moment_sentences(result: Balance, sums: Sums) -> str:
    """The greatest order of the rolling moment on the block, and of the moment about the axis."""
    unit = unit_text(result.units.moment)
    out: list[str] = []
    if remains(sums.torque, result.torque) or remains(sums.axis_moment, result.axis_moment):
        order, size = _greatest(sums.roll)
        if size:
            values = {"size": number(size), "unit": unit, "order": number(order)}
            out.append(
                _(
                    "Rolling moment on the block, with the flywheel taking the inertia torque: "
                    "{size} {unit} at order {order}, its largest.",
                    **values,
                )
            )
    if remains(sums.axis_moment, result.axis_moment):
        order, size = _greatest(sums.axis_moment)
        values = {"size": number(size), "unit": unit, "order": number(order)}
        out.append(
            _(
                "Moment of the forces about the crank axis: {size} {unit} at order {order}, its largest.",
                **values,
            )
        )
    return " ".join(out) or _("No rolling moment from inertia.")


def _greatest(signal: Spectrum) -> tuple[float, float]:
    amplitudes = np.abs(spectra.amplitude(signal))
    place = int(np.argmax(amplitudes))
    return float(signal.orders[place]), float(amplitudes[place])


def _cures(engine: Engine) -> list[str]:
    """What removes what remains of the first two orders of the engine as it is."""
    found = needs(engine)
    if not found:
        return [_("No primary or secondary force or couple remains.")]
    return list(filter(None, [*cure_lines(engine, found), proposal(engine)]))
