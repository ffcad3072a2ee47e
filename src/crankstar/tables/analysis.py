"""The tables of `analyze`: force, couple and moments of an engine, order by order.

An amplitude a with a phase p stands for `a cos(k theta + p)`, theta the crank angle from top dead
centre of cylinder 1. Normalised numbers are counted in m r w^2 A_k (force) and m r w^2 A_k a
(couple), A_k being the harmonic of the first cylinder's piston, so that they are the sums of the
textbook's vector stars; they stand below those in the units of the analysis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Document, Remarks, Table, remarks
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE, order_text
from crankstar.mechanics.balance import Balance, Grouping, balance, grouped
from crankstar.mechanics.bounds import lengths, size
from crankstar.mechanics.excitation import Reference, rolling_moment
from crankstar.mechanics.remains import Sums, orders_pushed, orders_turning, summed
from crankstar.tables.by_order import (
    MOMENTS,
    QUANTITIES,
    components,
    moments,
    star_sums,
    turning_vectors,
)
from crankstar.tables.conditions import conditions
from crankstar.tables.headings import heading
from crankstar.tables.peaks import peak_lines
from crankstar.tables.summary import summary

SHARES = {
    "cylinder": (N_("Greatest value of each order by cylinder"), N_("cylinder")),
    "bank": (N_("Greatest value of each order by bank"), N_("bank")),
    "shaft": (N_("Greatest value of each order by shaft"), N_("shaft")),
    "kind": (N_("Greatest value of each order by kind of part"), N_("part")),
}
"""The table of shares and its first heading, by what parts are grouped."""
KINDS = (N_("piston"), N_("rod"), N_("big end"), N_("throw"), N_("weight"))
"""The kinds of parts."""
AT_ANGLES = {
    "force": (N_("force up"), N_("force right"), N_("force, resultant")),
    "couple": (N_("pitch M_V"), N_("yaw M_H"), N_("couple, resultant")),
}
"""The columns of a vector at given crank angles."""


class Analysis(NamedTuple):
    """An engine with its Balance, normalised, and in newtons where there is a speed.

    `orders` of force and couple are shown, `turning` of the moments, which have more; whether they
    were `asked` for. `speed` (rad/s) is the one that was asked for.
    """

    engine: Engine
    normalised: Balance
    real: Balance | None
    orders: tuple[float, ...]
    turning: tuple[float, ...]
    asked: bool = False
    speed: float | None = None

    @property
    def best(self) -> Balance:
        """In newtons where that can be."""
        return self.real or self.normalised

    def of(self, orders: Sequence[float]) -> Analysis:
        """The same of these orders; of the usual ones where none are named."""
        wanted = tuple(orders)
        return self._replace(orders=wanted, turning=wanted, asked=True) if orders else self


def analysis(
    engine: Engine, *, speed: float | None, reference: Reference | None = None
) -> Analysis:
    """The analysis of an engine at `speed` (rad/s), else at the engine's own."""
    own = engine.speed if speed is None else speed
    normalised = balance(engine, reference=reference)
    real = balance(engine, speed=own, reference=reference) if own is not None else None
    if real is not None and real.units == normalised.units:
        real = None
    orders, turning = (
        tuple(sorted(of_any((engine.name, name), own)))
        for name, own in (
            ("pushed", orders_pushed(normalised)),
            ("turning", orders_turning(normalised, summed(normalised))),
        )
    )
    return Analysis(engine, normalised, real, orders, turning, speed=speed)


def document(
    shown: Analysis,
    *,
    angles: Sequence[float] = (),
    by: Grouping | None = None,
    vectors: bool = False,
) -> Document:
    """How the engine shakes in ten lines, then the tables of `analyze`.

    `angles` (radians), `by` and `vectors` add sums at angles, shares and turning vectors.
    """
    heads = (
        summary(shown.engine, shown.best, summed(shown.best)),
        Remarks(("", *heading(shown.engine).lines)),
        *remarks(*conditions(shown.engine, shown.best), kind="note"),
    )
    body = tables(shown, angles=angles, by=by, vectors=vectors)
    return Document(shown.engine.name, (*heads, *body, *_with_gas(shown)))


def _with_gas(shown: Analysis) -> tuple[Table, ...]:
    """Torque and roll of gas and inertia, where the file says what the gas does."""
    if shown.engine.gas is None:
        return ()
    from crankstar.tables.torque_orders import gas_tables

    speed = None if shown.real is None else shown.real.speed
    found = gas_tables(shown.engine, speed=speed, orders=shown.orders if shown.asked else ())
    return tuple(replace(table, audience="all") for table in found[:2])


def tables(
    shown: Analysis,
    *,
    angles: Sequence[float] = (),
    by: Grouping | None = None,
    vectors: bool = False,
) -> tuple[Table | Remarks, ...]:
    """Force, couple, moments, star sums, shares, sums at angles, peaks."""
    sums, units = summed(shown.best), shown.best.units
    plain = summed(shown.normalised)
    stars = (
        star_sums(name, shown.engine, getattr(plain, name), shown.orders)
        for name in ("force", "couple")
    )
    return (
        components("force", sums.force, shown.orders, unit=units.force),
        components("couple", sums.couple, shown.orders, unit=units.couple),
        moments(sums, shown.turning, unit=units.moment),
        *(table for table in stars if table.rows),
        *([turning_vectors(sums, shown.orders, units)] if vectors else []),
        *([_shares(shown, by)] if by is not None else []),
        *([_at_angles(shown, sums, angles)] if angles else []),
        Remarks(tuple(peak_lines(shown.engine, shown.best, sums)), _("Peaks")),
    )


def _shares(shown: Analysis, by: Grouping) -> Table:
    """The greatest value of each order for every group of parts, before the sums cancel."""
    units = shown.best.units
    pairs = [(name, order) for name in ("force", "couple", "roll") for order in shown.orders]
    heads = [
        Column(
            _("{quantity}, order {order}", quantity=_(QUANTITIES[name]), order=order_text(order)),
            getattr(units, name, units.moment),
        )
        for name, order in pairs
    ]
    rows = [
        (
            _("shafts alone") if label is None else _group(by, label),
            *(
                size(rolling_moment(sums) if name == "roll" else getattr(sums, name), order)
                for name, order in pairs
            ),
        )
        for label, sums in grouped(shown.best, by).items()
    ]
    title, group = SHARES[by]
    first = Column(_(group), kind="text", label=True)
    return Table(_(title), (first, *heads), tuple(rows))


def _group(by: Grouping, label: object) -> str:
    """A kind of part in words; other groups by their names or numbers."""
    return _(str(label)) if by == "kind" else str(label)


def _at_angles(shown: Analysis, sums: Sums, angles: Sequence[float]) -> Table:
    """Force, couple and moments of all orders together at given crank angles."""
    units = shown.best.units
    heads = [Column("θ", "deg", label=True)]
    columns: list[list[float]] = [[round(degrees(angle), 9) for angle in angles]]
    for name, words in QUANTITIES.items():
        unit, signal = getattr(units, name, units.moment), getattr(sums, name)
        vectors = np.asarray(spectra.value(signal, np.array(angles)), complex)
        parts = [np.real(vectors)]
        if name in MOMENTS:
            heads.append(Column(_(words), unit))
        else:
            heads += [Column(_(head), unit) for head in AT_ANGLES[name]]
            parts.append(np.imag(vectors))
        least = NEGLIGIBLE * spectra.peak(signal).value
        columns += [np.where(np.abs(part) > least, part, 0.0).tolist() for part in parts]
        if name not in MOMENTS:
            columns.append(lengths(np.where(np.abs(vectors) > least, vectors, 0)))
    rows = tuple(zip(*columns, strict=True))
    return Table(_("All orders together at these crank angles"), tuple(heads), rows)
