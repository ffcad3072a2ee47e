"""The tables of `analyze`: force, couple and moments of an engine, order by order.

An amplitude a with a phase p stands for `a cos(k theta + p)`, theta the crank angle from top dead
centre of cylinder 1. Normalised numbers are counted in m r w^2 A_k (force) and m r w^2 A_k a
(couple), A_k being the harmonic of the first cylinder's piston, so that they are the sums of the
textbook's vector stars.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.motion import first_harmonic
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import NEGLIGIBLE, number
from crankstar.mechanics.balance import Balance, Grouping, balance, grouped
from crankstar.mechanics.excitation import Reference, rolling_moment
from crankstar.mechanics.remains import Sums, orders_pushed, orders_turning, ranked, size, summed
from crankstar.spectra import Spectrum
from crankstar.tables.conditions import conditions, unverified
from crankstar.tables.headings import heading
from crankstar.tables.paths import shape
from crankstar.tables.peaks import peak_lines
from crankstar.tables.table import Column, Document, Remarks, Table, Value, remarks

QUANTITIES = {
    "force": N_("force"),
    "couple": N_("couple"),
    "roll": N_("rolling moment"),
    "torque": N_("inertia torque"),
    "axis_moment": N_("moment about the axis"),
}
"""The fields of Sums as columns and rows are headed."""
MOMENTS = ("roll", "torque", "axis_moment")
SHARES = {
    "cylinder": (N_("Greatest value of each order by cylinder"), N_("cylinder")),
    "bank": (N_("Greatest value of each order by bank"), N_("bank")),
    "shaft": (N_("Greatest value of each order by shaft"), N_("shaft")),
    "kind": (N_("Greatest value of each order by kind of part"), N_("part")),
}
"""The table of shares and its first heading, by what parts are grouped."""


class Analysis(NamedTuple):
    """An engine with its Balance, normalised, and in newtons where there is a speed.

    `orders` of force and couple are shown, `turning` of the moments, which have more.
    """

    engine: Engine
    normalised: Balance
    real: Balance | None
    orders: tuple[float, ...]
    turning: tuple[float, ...]

    @property
    def best(self) -> Balance:
        """In newtons where that can be."""
        return self.real or self.normalised

    def of(self, orders: Sequence[float]) -> Analysis:
        """The same of these orders; of the usual ones where none are named."""
        return self._replace(orders=tuple(orders), turning=tuple(orders)) if orders else self


def analysis(
    engine: Engine, *, speed: float | None, reference: Reference | None = None
) -> Analysis:
    """The analysis of an engine at `speed` (rad/s), else at the engine's own."""
    speed = engine.speed if speed is None else speed
    normalised = balance(engine, reference=reference)
    real = balance(engine, speed=speed, reference=reference) if speed is not None else None
    if real is not None and real.units == normalised.units:
        real = None
    turning = orders_turning(normalised, summed(normalised))
    return Analysis(engine, normalised, real, orders_pushed(normalised), turning)


def document(
    shown: Analysis, *, angles: Sequence[float] = (), by: Grouping | None = None
) -> Document:
    """The tables of `analyze`; `angles` (radians) and `by` add sums at angles and shares."""
    doubtful = unverified(shown.engine)
    doubt = _("Unverified: {paths}.", paths=", ".join(doubtful)) if doubtful else ""
    heads = (
        heading(shown.engine),
        *remarks(*conditions(shown.engine, shown.best), kind="note"),
        *remarks(doubt, kind="doubt"),
    )
    return Document(shown.engine.name, (*heads, *tables(shown, angles=angles, by=by)))


def tables(
    shown: Analysis, *, angles: Sequence[float] = (), by: Grouping | None = None
) -> tuple[Table | Remarks, ...]:
    """Force, couple, moments, shares, sums at angles, peaks: the document without its heading."""
    sums = summed(shown.normalised)
    real = summed(shown.best)
    return (
        _vectors("force", shown, sums.force, real.force),
        _vectors("couple", shown, sums.couple, real.couple),
        _moments(shown, real),
        *([_shares(shown, by)] if by is not None else []),
        *([_at_angles(shown, real, angles)] if angles else []),
        Remarks(tuple(peak_lines(shown.engine, shown.best, real)), _("Peaks")),
    )


def _vectors(quantity: str, shown: Analysis, plain: Spectrum, real: Spectrum) -> Table:
    """The orders by size: amplitudes up and right, the path over a turn, its greatest value."""
    unit = "m*r*w^2*A_k" if quantity == "force" else "m*r*w^2*A_k*a"
    left, zero = ranked(plain, shown.orders)
    factors = [first_harmonic(shown.engine, order) for order in left]
    divided = _divided(
        spectra.selected(plain, left), np.array([factor or 1.0 for factor in factors], complex)
    )
    heads = [
        Column(_("order"), label=True),
        Column("Aₖ", digits=5),
        Column(_("vertical"), unit, kind="wave"),
        Column(_("horizontal"), unit, kind="wave"),
        Column(_("path"), kind="text", wraps=True, optional=2),
        Column(_("greatest"), unit, optional=1),
        Column(_("greatest"), getattr(shown.best.units, quantity)),
    ]
    vertical, horizontal = spectra.vertical(divided), spectra.horizontal(divided)
    rows: list[tuple[Value, ...]] = []
    for row, (order, factor) in enumerate(zip(left, factors, strict=True)):
        path = spectra.ellipse(complex(divided.forward[row]), complex(divided.backward[row]))
        waves = [
            complex(wave[row]) if abs(wave[row]) > NEGLIGIBLE * path.semi_major else 0j
            for wave in (vertical, horizontal)
        ]
        cells = (order, _harmonic(factor), *waves, shape(path), path.semi_major)
        rows.append((*cells, size(real, order)))
    title = _("Force on the block") if quantity == "force" else _("Couple on the block")
    return Table(title, tuple(heads), tuple(rows), notes=none_line(zero))


def none_line(zero: Sequence[float]) -> tuple[str, ...]:
    """The orders of which nothing remains, in one line.

    >>> none_line((1.0, 3.0))
    ('None of orders 1, 3.',)
    """
    orders = ", ".join(number(order) for order in sorted(zero))
    if not zero:
        return ()
    return (_n("None of order {orders}.", "None of orders {orders}.", len(zero), orders=orders),)


def _divided(spectrum: Spectrum, factors: np.ndarray) -> Spectrum:
    """The spectrum with the complex amplitude of each order, up or right, divided by a factor."""
    turn = factors if spectrum.sense > 0 else np.conj(factors)
    return replace(
        spectrum, forward=spectrum.forward / turn, backward=spectrum.backward / np.conj(turn)
    )


def _harmonic(factor: complex) -> Value:
    if factor == 0:
        return "-"
    return factor.real if abs(factor.imag) <= NEGLIGIBLE * abs(factor) else abs(factor)


def _moments(shown: Analysis, sums: Sums) -> Table:
    """Rolling moment, inertia torque and moment about the axis, the largest roll first."""
    signals = [getattr(sums, name) for name in MOMENTS]
    least = NEGLIGIBLE * max(map(sums_size, signals))
    waves = np.array(
        [spectra.amplitude(spectra.selected(signal, shown.turning)) for signal in signals]
    )
    waves[np.abs(waves) <= least] = 0
    there = np.any(waves, axis=0).tolist()
    rows = [
        (order, *map(complex, waves[:, place]))
        for place, order in enumerate(shown.turning)
        if there[place]
    ]
    rows.sort(key=lambda row: [-abs(wave) for wave in row[1:]])
    zero = [order for place, order in enumerate(shown.turning) if not there[place]]
    unit = shown.best.units.moment
    heads = (
        Column(_("order"), label=True),
        *(Column(_(QUANTITIES[name]), unit, kind="wave") for name in MOMENTS),
    )
    notes = (
        *none_line(zero),
        _("Rolling moment: on the block, clockwise, with the flywheel taking the inertia torque."),
    )
    return Table(_("Moments about the crank axis"), heads, tuple(rows), notes=notes)


def sums_size(spectrum: Spectrum) -> float:
    """The greatest amplitude of all orders."""
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0))


def _shares(shown: Analysis, by: Grouping) -> Table:
    """The greatest value of each order for every group of parts, before the sums cancel."""
    units = shown.best.units
    pairs = [(name, order) for name in ("force", "couple", "roll") for order in shown.orders]
    heads = [
        Column(
            _("{quantity}, order {order}", quantity=_(QUANTITIES[name]), order=number(order)),
            getattr(units, name, units.moment),
        )
        for name, order in pairs
    ]
    rows = [
        (
            _("shafts alone") if label is None else str(label),
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


def _at_angles(shown: Analysis, sums: Sums, angles: Sequence[float]) -> Table:
    """Force, couple and moments of all orders together at given crank angles."""
    units = shown.best.units
    heads = [Column("θ", "deg", label=True)]
    columns: list[list[float]] = [[round(degrees(angle), 9) for angle in angles]]
    for name, words in QUANTITIES.items():
        unit, signal = getattr(units, name, units.moment), getattr(sums, name)
        vectors = np.asarray(spectra.value(signal, np.array(angles)), complex)
        quantity, parts = _(words), [np.real(vectors)]
        if name in MOMENTS:
            heads.append(Column(quantity, unit))
        else:
            heads += [
                Column(_("{quantity} up", quantity=quantity), unit),
                Column(_("{quantity} right", quantity=quantity), unit),
                Column(_("{quantity}, resultant", quantity=quantity), unit),
            ]
            parts += [np.imag(vectors), np.abs(vectors)]
        least = NEGLIGIBLE * spectra.peak(signal).value
        columns += [np.where(np.abs(part) > least, part, 0.0).tolist() for part in parts]
    rows = tuple(zip(*columns, strict=True))
    return Table(_("All orders together at these crank angles"), tuple(heads), rows)
