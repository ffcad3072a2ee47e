"""The tables of `analyze`: force, couple and moments of an engine, order by order.

An amplitude a with a phase p stands for `a cos(k theta + p)`, theta the crank angle from top dead
centre of cylinder 1. Normalised numbers are counted in m r w^2 A_k (force) and m r w^2 A_k a
(couple), A_k being the harmonic of the first cylinder's piston, so that they are the sums of the
textbook's vector stars.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees, pi
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.motion import first_harmonic
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE, number
from crankstar.mechanics.balance import Balance, Grouping, balance, grouped
from crankstar.mechanics.excitation import Reference, rolling_moment
from crankstar.mechanics.remains import Sums, orders_pushed, orders_turning, ranked, size, summed
from crankstar.spectra import Spectrum
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
        *remarks(*conditions(shown), kind="note"),
        *remarks(doubt, kind="doubt"),
    )
    return Document(shown.engine.name, (*heads, *tables(shown, angles=angles, by=by)))


def tables(
    shown: Analysis, *, angles: Sequence[float] = (), by: Grouping | None = None
) -> tuple[Table | Remarks, ...]:
    """Force, couple, moments, shares, sums at angles, peaks: the document without its heading."""
    sums = summed(shown.normalised)
    real = summed(shown.real) if shown.real else None
    parts: list[Table | Remarks] = [
        _vectors("force", shown, sums.force, real.force if real else None),
        _vectors("couple", shown, sums.couple, real.couple if real else None),
        _moments(shown, real or sums),
    ]
    if by is not None:
        parts.append(_shares(shown, by))
    if angles:
        parts.append(_at_angles(shown, real or sums, angles))
    return (
        *parts,
        Remarks(tuple(peak_lines(shown.engine, shown.best, real or sums, sums)), _("Peaks")),
    )


def conditions(shown: Analysis) -> list[str]:
    """Reference point, meaning of a phase, speed and units."""
    engine = shown.engine
    point = _("Couples and moments about {point}; a ∠ p means a cos(kθ + p).", point=_point(shown))
    return [point, unit_sentence(engine, shown.best), unit_sizes(engine)]


def unit_sentence(engine: Engine, result: Balance) -> str:
    """The unit of forces, and the reason where it is not newtons."""
    if result.speed is not None:
        return _("Forces in N at {speed} rpm.", speed=number(result.speed * 30 / pi))
    match "mass" in engine.relative, "radius" in engine.relative:
        case True, True:
            return _(
                "The file gives neither masses nor the stroke: forces in m r ω², the same at every "
                "speed."
            )
        case True, False:
            return _("The file gives no masses: forces in m r ω², the same at every speed.")
        case False, True:
            return _("The file gives no stroke: forces in m r ω², the same at every speed.")
    return _('Forces in m r ω². For newtons, add a speed to the file, as in speed = "6000 rpm".')


def unverified(engine: Engine) -> list[str]:
    """The key paths of values whose status is unverified or placeholder."""
    return [
        path
        for path, origin in engine.provenance.items()
        if origin.status in ("unverified", "placeholder")
    ]


def _point(shown: Analysis) -> str:
    """The reference point: its z, and its place in the clock plane where that matters."""
    engine, point = shown.engine, shown.normalised.reference
    along = "a" if "pitch" in engine.relative else "mm"
    across = "r" if "radius" in engine.relative else "mm"
    scale = {"mm": 1000.0, "a": 1.0, "r": 1.0}
    place = f"z = {number(point.z * scale[along])} {along}"
    if point.up or point.right:
        return _(
            "{place}, {up} {unit} up, {right} {unit} right of the crank axis",
            place=place,
            up=number(point.up * scale[across]),
            right=number(point.right * scale[across]),
            unit=across,
        )
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        return _("{place} on the axis of shaft {name}", place=place, name=engine.shafts[0].name)
    return place


def unit_sizes(engine: Engine) -> str:
    """The sizes of m, r and a, as far as they are known."""
    first = engine.first
    known = [
        ("m", first.reciprocating_mass, "kg", "mass"),
        ("r", engine.throw(first).radius * 1000, "mm", "radius"),
    ]
    if len({cylinder.z for cylinder in engine.cylinders}) > 1:
        known.append(("a", engine.pitch * 1000, "mm", "pitch"))
    sizes = [
        f"{letter} = {number(value)} {unit}"
        for letter, value, unit, key in known
        if key not in engine.relative
    ]
    return f"{', '.join(sizes)}." if sizes else ""


def _vectors(quantity: str, shown: Analysis, plain: Spectrum, real: Spectrum | None) -> Table:
    """The orders by size: amplitudes up and right, the path over a turn, its greatest value."""
    unit = "m*r*w^2*A_k" if quantity == "force" else "m*r*w^2*A_k*a"
    left, zero = ranked(plain, shown.orders)
    factors = [first_harmonic(shown.engine, order) for order in left]
    divided = _divided(
        spectra.selected(plain, left), np.array([factor or 1.0 for factor in factors], complex)
    )
    heads = [
        Column(_("order"), label=True),
        Column("Aₖ", optional=1, digits=5),
        Column(_("vertical"), unit, kind="wave"),
        Column(_("horizontal"), unit, kind="wave"),
        Column(_("path"), kind="text", wraps=True),
        Column(_("greatest"), unit, optional=2),
    ]
    heads.append(Column(_("greatest"), getattr(shown.best.units, quantity)))
    rows: list[tuple[Value, ...]] = []
    for row, (order, factor) in enumerate(zip(left, factors, strict=True)):
        pair = complex(divided.forward[row]), complex(divided.backward[row])
        path = spectra.ellipse(*pair)
        waves = (spectra.vertical(divided)[row], spectra.horizontal(divided)[row])
        cells = (order, _harmonic(factor), *(_wave(one, path.semi_major) for one in waves))
        rows.append((*cells, shape(path), path.semi_major, size(real or plain, order)))
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
    return (
        (_("None of order {orders}.", orders=orders),)
        if len(zero) == 1
        else (_("None of orders {orders}.", orders=orders),)
    )


def _wave(value: complex, greatest: float) -> complex:
    return complex(value) if abs(value) > NEGLIGIBLE * greatest else 0j


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
    """Rolling moment, inertia torque and moment about the axis, the largest rolling moment first."""
    found = {name: getattr(sums, name) for name in MOMENTS}
    largest = max(sums_size(signal) for signal in found.values())
    sizes = {order: [size(signal, order) for signal in found.values()] for order in shown.turning}
    left = [order for order in shown.turning if max(sizes[order]) > NEGLIGIBLE * largest]
    left.sort(key=lambda order: [-one for one in sizes[order]])
    unit = shown.best.units.moment
    heads = (
        Column(_("order"), label=True),
        *(Column(_(QUANTITIES[name]), unit, kind="wave") for name in found),
    )
    rows = [
        (
            order,
            *(
                _wave(spectra.amplitude(spectra.selected(signal, [order]))[0], largest)
                for signal in found.values()
            ),
        )
        for order in left
    ]
    zero = [order for order in shown.turning if order not in left]
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
    result = shown.best
    pairs = [(name, order) for name in ("force", "couple", "roll") for order in shown.orders]
    units = {
        "force": result.units.force,
        "couple": result.units.couple,
        "roll": result.units.moment,
    }
    heads = [
        Column(
            _("{quantity}, order {order}", quantity=_(QUANTITIES[name]), order=number(order)),
            units[name],
        )
        for name, order in pairs
    ]
    rows: list[tuple[Value, ...]] = []
    for label, sums in grouped(result, by).items():
        signals = {"force": sums.force, "couple": sums.couple, "roll": rolling_moment(sums)}
        name = _("shafts alone") if label is None else str(label)
        rows.append((name, *(size(signals[one], order) for one, order in pairs)))
    titles = {
        "cylinder": _("Greatest value of each order by cylinder"),
        "bank": _("Greatest value of each order by bank"),
        "shaft": _("Greatest value of each order by shaft"),
        "kind": _("Greatest value of each order by kind of part"),
    }
    groups = {"cylinder": _("cylinder"), "bank": _("bank"), "shaft": _("shaft"), "kind": _("part")}
    first = Column(groups[by], kind="text", label=True)
    return Table(titles[by], (first, *heads), tuple(rows))


def _at_angles(shown: Analysis, sums: Sums, angles: Sequence[float]) -> Table:
    """Force, couple and moments of all orders together at given crank angles."""
    units = shown.best.units
    heads = [Column("θ", "deg", label=True)]
    for name, unit in (("force", units.force), ("couple", units.couple)):
        quantity = _(QUANTITIES[name])
        heads += [
            Column(_("{quantity} up", quantity=quantity), unit),
            Column(_("{quantity} right", quantity=quantity), unit),
            Column(_("{quantity}, resultant", quantity=quantity), unit),
        ]
    heads += [Column(_(QUANTITIES[name]), units.moment) for name in MOMENTS]
    tops = {name: spectra.peak(getattr(sums, name)).value for name in Sums._fields}
    rows: list[tuple[Value, ...]] = []
    for angle in angles:
        cells: list[Value] = [round(degrees(angle), 9)]
        for name in ("force", "couple"):
            vector = complex(spectra.value(getattr(sums, name), angle))
            cells += [_cleared(one, tops[name]) for one in (vector.real, vector.imag, abs(vector))]
        for name in MOMENTS:
            moment = complex(spectra.value(getattr(sums, name), angle)).real
            cells.append(_cleared(moment, tops[name]))
        rows.append(tuple(cells))
    return Table(_("All orders together at these crank angles"), tuple(heads), tuple(rows))


def _cleared(value: float, top: float) -> float:
    return value if abs(value) > NEGLIGIBLE * top else 0.0
