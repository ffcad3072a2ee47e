"""Force and couple of an engine as sentences: which orders remain, and how they move."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from crankstar import spectra
from crankstar.language.alike import as_given
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import order_text
from crankstar.language.shown_units import quantity_text
from crankstar.language.written import capitalised, joined
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.bounds import greatest
from crankstar.mechanics.remains import MINOR, USUAL_ORDERS, Sums, orders_pushed, sizes
from crankstar.spectra import Spectrum
from crankstar.tables.by_order import left_in_any
from crankstar.tables.paths import course, vector_name

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


def vector_sentences(name: str, result: Balance, sums: Sums) -> str:
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
    rest = joined("; ", minor)
    out += [_("{text}.", text=capitalised(rest))] if rest else []
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
