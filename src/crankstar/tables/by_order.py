"""Force, couple and moments order by order: as engineers name them, then as vectors.

The vertical and the horizontal part of the couple are the external moments that engineers call
pitch, M_V, and yaw, M_H. The sums of the textbook's vector stars are the same amplitudes in
m r w^2 A_k, A_k the harmonic of the first cylinder's piston.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.engine.engine import Engine
from crankstar.engine.motion import first_harmonic
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import NEGLIGIBLE, order_text
from crankstar.mechanics import bounds
from crankstar.mechanics.balance import Units
from crankstar.mechanics.bounds import bounded
from crankstar.mechanics.remains import Sums, ranked
from crankstar.spectra import Spectrum
from crankstar.tables.paths import shape

QUANTITIES = {
    "force": N_("force"),
    "couple": N_("couple"),
    "roll": N_("rolling moment"),
    "torque": N_("inertia torque"),
    "axis_moment": N_("moment about the axis"),
}
"""The fields of Sums as columns and rows are headed."""
MOMENTS = ("roll", "torque", "axis_moment")
TITLES = {"force": N_("Force on the block"), "couple": N_("Couple on the block")}
STARS = {"force": N_("Force by the vector stars"), "couple": N_("Couple by the vector stars")}
PARTS = {
    "force": (N_("vertical"), N_("horizontal")),
    "couple": (N_("pitch M_V (vertical)"), N_("yaw M_H (horizontal)")),
}
"""The upward and the rightward part of each vector."""


def components(quantity: str, whole: Spectrum, orders: Sequence[float], *, unit: str) -> Table:
    """The orders by size: vertical and horizontal amplitude, path over a turn, greatest value."""
    left, zero = left_in_any(quantity, whole, orders)
    chosen = spectra.selected(whole, left)
    heads = (
        Column(_("order"), label=True),
        *(Column(_(part), unit, kind="wave") for part in PARTS[quantity]),
        Column(_("path"), kind="text", wraps=True, optional=1),
        Column(_("greatest"), unit),
    )
    rows: list[tuple[Value, ...]] = []
    for row, order in enumerate(left):
        path = spectra.ellipse(complex(chosen.forward[row]), complex(chosen.backward[row]))
        drawn = as_given(("drawn", quantity, order), path.semi_major > 0)
        words = shape(path) if drawn else ""
        rows.append((order, *_waves(chosen, row), words, _greatest(chosen, row)))
    notes = none_line(zero)
    if quantity == "couple" and rows:
        notes += (_("Positive pitch lifts the front; positive yaw pushes it to the right."),)
    return Table(_(TITLES[quantity]), heads, tuple(rows), notes=notes)


def left_in_any(
    quantity: str, whole: Spectrum, orders: Sequence[float]
) -> tuple[list[float], list[float]]:
    """The orders that remain, the greatest first, and those that do not; over ranges in none."""
    left, zero = ranked(whole, orders)
    found = of_any(("left", quantity), left)
    more = [order for order in zero if order in found]
    return [*left, *more], [order for order in zero if order not in found]


def _waves(spectrum: Spectrum, row: int) -> list[complex]:
    """The vertical and the horizontal amplitude of an order; a rounding error is zero."""
    waves = [complex(part(spectrum)[row]) for part in (spectra.vertical, spectra.horizontal)]
    largest = max(map(abs, waves))
    return [wave if abs(wave) > NEGLIGIBLE * largest else 0j for wave in waves]


def _greatest(spectrum: Spectrum, row: int) -> float:
    """The greatest value of an order over a turn."""
    return bounds.greatest(complex(spectrum.forward[row]), complex(spectrum.backward[row]))


def star_sums(
    quantity: str, engine: Engine, normalised: Spectrum, orders: Sequence[float]
) -> Table:
    """The same orders in m r w^2 A_k, as the vector stars of a textbook give them."""
    unit = "m*r*w^2*A_k" if quantity == "force" else "m*r*w^2*A_k*a"
    left, _zero = left_in_any(quantity, normalised, orders)
    factors = [first_harmonic(engine, order) for order in left]
    divided = _divided(
        spectra.selected(normalised, left), np.array([factor or 1.0 for factor in factors], complex)
    )
    harmonics = [_real_harmonic(factor) for factor in factors]
    signed = all(harmonic is not None for harmonic in harmonics)
    heads = (
        Column(_("order"), label=True),
        Column("Aₖ", digits=5) if signed else Column("Aₖ", kind="wave"),
        *(Column(_(part), unit, kind="wave") for part in PARTS["force"]),
        Column(_("greatest"), unit),
    )
    rows: list[tuple[Value, ...]] = []
    for row, (order, factor, own) in enumerate(zip(left, factors, harmonics, strict=True)):
        greatest = _greatest(divided, row)
        rows.append((order, own if signed else factor, *_waves(divided, row), greatest))
    return Table(_(STARS[quantity]) if rows else "", heads, tuple(rows))


def turning_vectors(sums: Sums, orders: Sequence[float], units: Units) -> Table:
    """Force and couple of each order as two vectors that turn with and against the crank.

    A vector is written as its length and its bearing at theta = 0.
    """
    vectors = [spectra.selected(signal, orders) for signal in (sums.force, sums.couple)]
    heads = [Column(_("order"), label=True)]
    for quantity, unit in (("force", units.force), ("couple", units.couple)):
        words = _(QUANTITIES[quantity])
        heads += [
            Column(_("{quantity} forward", quantity=words), unit, kind="wave"),
            Column(_("{quantity} backward", quantity=words), unit, kind="wave"),
        ]
    rows: list[tuple[Value, ...]] = []
    for row, order in enumerate(orders):
        pairs = [[complex(v.forward[row]), complex(v.backward[row])] for v in vectors]
        cleared = [
            part if abs(part) > NEGLIGIBLE * max(map(abs, pair)) else 0j
            for pair in pairs
            for part in pair
        ]
        rows.append((order, *cleared))
    note = _("Forward turns with the crankshaft, backward against it; ∠: bearing at θ = 0.")
    return Table(_("Turning vectors"), tuple(heads), tuple(rows), notes=(note,))


def moments(sums: Sums, orders: Sequence[float], *, unit: str) -> Table:
    """Rolling moment, inertia torque and moment about the axis, the largest roll first."""
    signals = [getattr(sums, name) for name in MOMENTS]
    least = NEGLIGIBLE * max(map(sums_size, signals))
    waves = np.array([spectra.amplitude(spectra.selected(signal, orders)) for signal in signals])
    waves[np.abs(waves) <= least] = 0
    found = of_any(
        "moments", [order for order, wave in zip(orders, waves.T, strict=True) if wave.any()]
    )
    there = [order in found for order in orders]
    rows = [
        (order, *map(complex, waves[:, index]))
        for index, order in enumerate(orders)
        if there[index]
    ]
    rows.sort(key=lambda row: [-abs(wave) for wave in row[1:]])
    zero = [order for index, order in enumerate(orders) if not there[index]]
    heads = (
        Column(_("order"), label=True),
        *(Column(_(QUANTITIES[name]), unit, kind="wave") for name in MOMENTS),
    )
    notes = (
        *none_line(zero),
        _(
            "Rolling moment (roll, torque reaction): on the block, clockwise, with the flywheel "
            "taking the inertia torque."
        ),
    )
    return Table(_("Moments about the crank axis"), heads, tuple(rows), notes=notes)


def sums_size(spectrum: Spectrum) -> float:
    """The greatest amplitude of all orders."""
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0))


def none_line(zero: Sequence[float]) -> tuple[str, ...]:
    """The orders of which nothing remains, in one line.

    >>> none_line((1.0, 3.0))
    ('None of orders 1, 3.',)
    """
    orders = ", ".join(order_text(order) for order in sorted(zero))
    if not zero:
        return ()
    return (_n("None of order {orders}.", "None of orders {orders}.", len(zero), orders=orders),)


def _divided(spectrum: Spectrum, factors: np.ndarray) -> Spectrum:
    """The spectrum with the complex amplitude of each order, up or right, divided by a factor."""
    turn = factors if spectrum.sense > 0 else np.conj(factors)
    return replace(
        spectrum, forward=spectrum.forward / turn, backward=spectrum.backward / np.conj(turn)
    )


def _real_harmonic(factor: complex) -> Value:
    """A harmonic without phase, with its sign; None of one that has a phase."""
    if factor == 0:
        return "-"
    real = abs(factor.imag) <= NEGLIGIBLE * abs(factor)
    # it rises or falls with the length of the rod throughout
    return bounded(factor.real, [[factor]]) if real else None
