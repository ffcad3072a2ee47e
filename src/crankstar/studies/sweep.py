"""Sweeps: one number of an engine file at many values, and the results.

Any number of the file is named by its key path, in the notation of `--set`: in the short form where
the file has one, and in the explicit form for every engine; `balance_factor` for every engine. The
firing order is left out of account, since a sweep of a phase passes through angles at which it
cannot fire.

Force, couple, moments and torque are counted in the units of the engine as its file has it, m and r
those of its first cylinder, about one point, the middle of its cylinders unless another is given:
so that the curve shows what the engine does, not what it is counted in. Where the file's own number
makes no engine, or leaves masses or lengths unknown that the swept one makes known, the engine at
the first value is the measure.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Quantity
from crankstar.language.quoting import one_line
from crankstar.mechanics import labelled
from crankstar.mechanics.balance import Units, default_reference, scales
from crankstar.mechanics.batches import totals
from crankstar.mechanics.excitation import Reference, Totals, part_spectra, rolling_moment
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Real, Spectrum
from crankstar.studies.fields import subject
from crankstar.studies.ranges import GREATEST_POINTS, over_request
from crankstar.studies.variants import SweepError, Tell, picked, variants

if TYPE_CHECKING:
    import pandas
    import xarray

GREATEST_CELLS = 3_000_000
"""Values times orders: half a gigabyte of vectors."""
GREATEST_WORK = 200_000_000
"""Values times orders times parts: some ten seconds."""
GREATEST_ORDER = 1000
_PLANE = ("", ".up", ".right", ".forward", ".backward")
WATCHABLE = (
    *(f"force{part}" for part in _PLANE),
    *(f"couple{part}" for part in (*_PLANE, ".pitch", ".yaw")),
    "roll",
    "axis_moment",
    "torque",
)
_SI = {
    "angle": "rad",
    "length": "m",
    "length along the crankshaft": "m",
    "mass": "kg",
    "rotational speed": "rad/s",
}
_SI |= {"moment of inertia": "kg*m^2", "unbalance": "kg*m"}


class Group(NamedTuple):
    """Variants of one structure: indices of their values [row] and sums [row, order]."""

    rows: np.ndarray
    sums: Totals


@dataclass(frozen=True)
class Sweep:
    """An engine at many values of one of its numbers.

    `values` [n] in `unit`, and the sums, counted in `units`.

    `engine` is that of the first value. Engines of one structure are a Group; there is more than
    one only where gear ratios are swept, or where a throw or a weight comes or goes.
    """

    path: str
    unit: str
    values: Real
    engine: Engine
    groups: tuple[Group, ...]
    units: Units
    reference: Reference
    speed: float | None
    again: Callable[[Sequence[float] | Real], Sweep] = field(repr=False, compare=False)

    @property
    def sums(self) -> Totals:
        """The sums of all values [n, order], over all orders that any of them has."""
        if len(self.groups) == 1:
            return self.groups[0].sums
        orders = np.unique(np.concatenate([group.sums.force.orders for group in self.groups]))
        _feasible(self.values.size, orders.size, GREATEST_CELLS)
        shape = (self.values.size, orders.size)

        def joined(name: str) -> Spectrum:
            forward, backward = np.zeros(shape, complex), np.zeros(shape, complex)
            for group in self.groups:
                own = spectra.selected(getattr(group.sums, name), orders)
                forward[group.rows], backward[group.rows] = own.forward, own.backward
            return Spectrum(orders, forward, backward, getattr(self.groups[0].sums, name).sense)

        return Totals(*map(joined, Totals._fields))

    def to_frame(self) -> pandas.DataFrame:
        """The amplitudes at every value as a tidy pandas data frame: one row an amplitude.

        The first column is the value, named by the path; the others are those of
        `Balance.to_frame`. attrs: its unit, the speed (rad/s) and the reference point. Raises
        ImportError without pandas.
        """
        rows = labelled.columns(self.sums, self.units._asdict(), {self.path: self.values})
        return labelled.frame(rows, {f"unit of {self.path}": self.unit, **self._facts})

    def to_xarray(self, *, split: bool = False) -> xarray.Dataset:
        """The amplitudes as an xarray data set with the dimensions value and order.

        Variables and `split` are those of `Balance.to_xarray`. Raises ImportError without xarray.

        >>> table = swept("v2-90", over="balance_factor", values=[0, 0.5, 1]).to_xarray()
        >>> abs(table.force_forward.sel(order=1)).round(6).values.tolist()  # 0.5 cancels it
        [1.0, 0.0, 1.0]
        """
        return labelled.dataset(
            self.sums,
            self.units._asdict(),
            dimension="value",
            labels={"value": ("value", self.values, {"path": self.path, "units": self.unit})},
            facts=self._facts,
            split=split,
        )

    @property
    def _facts(self) -> dict[str, Any]:
        point = {f"reference_{name}": place for name, place in self.reference._asdict().items()}
        return {"engine": self.engine.name, "speed": self.speed, **point}


class Curve(NamedTuple):
    """A result (of one order, or None: of all) at every value of a sweep [n], its unit and name."""

    what: str
    order: float | None
    values: Real
    unit: str
    label: str


def swept(
    name: str | Engine,
    *,
    over: str,
    values: Sequence[float] | Real,
    unit: str | None = None,
    changes: Mapping[str, Any] | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    speed: float | Literal["file"] | None = None,
    tell: Tell | None = None,
) -> Sweep:
    """An engine, or that of a name or file, at each of the `values` of the number at `over`.

    `unit` is that of the values: None, SI (radians); a text, as in "deg"; "" says that none was
    given, which does for plain numbers and for lengths and masses that are counted in themselves.
    `changes` sets other values first, by key path. `orders` are all to machine precision unless
    given. At `speed` (rad/s, or "file": that of the engine file) the sums are in N and N m, without
    one in units of m r w^2.
    `tell(done, of)` is called as engines are built one by one. Raises SweepError,
    EngineFileError, and RemedyError for a balance factor that no counterweight has.

    >>> sweep = swept("harley-45", over="balance_factor", values=[0, 0.25, 0.5])
    >>> watched(sweep, "force.forward", order=1).values.round(6).tolist()  # 0.5 cancels it
    [1.0, 0.5, 0.0]
    """
    numbers = _finite(values, over)
    base, make, quantity = subject(name, over=over, unit=unit, changes=changes)
    if (
        unit == ""
        and quantity
        and not (base and quantity.relative_to & set(base.relative))
        and np.any(numbers)
    ):
        raise SweepError(
            "{path} has no unit; write its values with one, as in {example}",
            path=over,
            example=quantity.example,
        )
    first = make(float(numbers[0]))
    base = base if base and base.relative == first.relative else first
    point = reference or default_reference(base)
    speed = base.speed if speed == "file" else speed
    scale, units = scales(base, speed)

    def at(these: Sequence[float] | Real, tell: Tell | None = None) -> Sweep:
        now = np.asarray(these, float)
        batches = variants(make, now, tell=tell)
        groups = tuple(
            Group(batch.rows, _sums(batch.machine, batch.rows.size, orders, point, scale, now.size))
            for batch in batches
        )
        said = unit if unit is not None else "" if quantity is None else _unit(quantity, base)
        known = speed if units.force == "N" else None
        return Sweep(over, said, now, first, groups, units, point, known, at)

    return at(numbers, tell)


def sweep(
    engine: str | Engine,
    over: str,
    *,
    changes: Mapping[str, Any] | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    speed: float | Literal["file"] | None = "file",
) -> Sweep:
    """What `crankstar sweep --over` computes; `watched` gives its curves. Raises as `swept` does.

    >>> twin = sweep("harley-45", "balance_factor=0..1/5")
    >>> watched(twin, "force.forward", order=1).values.round(6).tolist()
    [1.0, 0.5, 0.0, 0.5, 1.0]
    """
    asked = over_request(over)
    return swept(
        engine,
        over=asked.path,
        values=asked.values,
        unit=asked.unit,
        changes=changes,
        reference=reference,
        orders=orders,
        speed=speed,
    )


def _finite(values: Sequence[float] | Real, over: str) -> Real:
    try:
        numbers = np.asarray(values, float)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    path = one_line(over, longest=100)
    if numbers.ndim != 1 or np.unique(numbers).size < 2 or not np.all(np.isfinite(numbers)):
        raise SweepError("{path}: give two or more finite numbers that differ", path=path)
    if numbers.size > GREATEST_POINTS:
        raise SweepError(
            "{path}: {count} values; at most {most} can be swept",
            path=path,
            count=numbers.size,
            most=GREATEST_POINTS,
        )
    return numbers


def _unit(quantity: Quantity, base: Engine) -> str:
    return "" if quantity.relative_to & set(base.relative) else _SI[quantity.dimension]


def _sums(
    machine: Mechanism,
    count: int,
    orders: Sequence[float] | None,
    point: Reference,
    scale: Any,
    whole: int,
) -> Totals:
    """The sums of a batch [row, order], in blocks that fit the memory near the processor."""
    some = picked(machine, np.unique(np.linspace(0, count - 1, 9).astype(int)))
    if orders is not None and not (
        len(orders) and all(0 < order <= GREATEST_ORDER for order in orders)
    ):
        raise SweepError(
            "the orders are not possible; give crank orders above 0 up to {most}, or none",
            most=GREATEST_ORDER,
        )
    try:
        wanted = part_spectra(some).force.orders.tolist() if orders is None else sorted(set(orders))
        _feasible(whole, len(wanted), GREATEST_CELLS)
        moved = motion.resolved(some.links).piston.place
        steps = moved.shape[-1] if moved.ndim > 2 else 1
        parts = 3 * len(machine.cylinder_shaft) + len(machine.rotor_shaft)
        _feasible(whole, len(wanted) * parts)
        block = max(1, min(256, (1 << 18) // (parts * max(steps, len(wanted)))))
        sums = totals(machine, orders=wanted, reference=point, block=block)
    except ValueError as error:
        raise SweepError(str(error)) from None
    factors = (scale.force, scale.couple, scale.moment, scale.moment)
    return Totals(
        *(spectra.scaled(spectrum, factor) for spectrum, factor in zip(sums, factors, strict=True))
    )


def _feasible(values: int, work: int, most: int = GREATEST_WORK) -> None:
    """Refuse so many values that each need so much work, or room."""
    if values * work > most:
        raise SweepError(
            "{count} values are too many for an engine with so many parts and orders; give at most "
            "{most} values, or name the orders",
            count=values,
            most=max(2, most // work),
        )


def watched(sweep: Sweep, what: str, *, order: float | None = None) -> Curve:
    """One result of every variant: the peak of force, couple, moment or torque, or of a part.

    `what` is one of WATCHABLE: force, couple, roll (the rolling moment on the block),
    axis_moment (of the forces, about the crank axis), torque; .up, .right, the component that way;
    .forward, .backward, the vectors that turn with and against the crankshaft; couple.pitch and
    couple.yaw, the moments about the right and the up axis, as large as couple.up and couple.right.
    All orders together over their period, or one `order`. Raises SweepError.

    >>> sweep = swept("single", over="balance_factor", values=[0, 0.5, 1])
    >>> watched(sweep, "force", order=1).values.round(6).tolist(), watched(sweep, "force").unit
    ([1.0, 0.5, 1.0], 'm*r*w^2')
    """
    if what not in WATCHABLE:
        raise SweepError(
            "{quantity} cannot be computed in a sweep; choose from {quantities}",
            quantity=one_line(what, longest=60),
            quantities=", ".join(WATCHABLE),
        )
    if order is not None and not 0 < order <= GREATEST_ORDER:
        raise SweepError(
            "there is no order {order}; give a crank order above 0 up to {most}",
            order=f"{order:g}",
            most=GREATEST_ORDER,
        )
    quantity, _dot, part = what.partition(".")
    peaks = np.zeros(sweep.values.size)
    for group in sweep.groups:
        spectrum = _part(_quantity(group.sums, quantity), part)
        if order is not None:
            spectrum = spectra.selected(spectrum, [order])
            peaks[group.rows] = (np.abs(spectrum.forward) + np.abs(spectrum.backward))[:, 0]
        else:
            peaks[group.rows] = spectra.peaks(spectrum)
    unit = getattr(sweep.units, quantity, sweep.units.moment)
    label = what if order is None else f"{what} of order {order:g}"
    return Curve(what, order, peaks, unit, label)


def _quantity(sums: Totals, name: str) -> Spectrum:
    return rolling_moment(sums) if name == "roll" else getattr(sums, name)


def _part(spectrum: Spectrum, part: str) -> Spectrum:
    if part in ("forward", "backward"):
        return replace(
            spectrum,
            **{"backward" if part == "forward" else "forward": np.zeros_like(spectrum.forward)},
        )
    if part:
        component = spectra.vertical if part in ("up", "pitch") else spectra.horizontal
        return spectra.real_signal(spectrum.orders, component(spectrum))
    return spectrum


def rows(sweep: Sweep, curves: Sequence[Curve], *, count: int = 11) -> list[tuple[float, ...]]:
    """A table of a sweep: `count` values, evenly chosen, and the result of each curve there."""
    chosen = np.unique(np.round(np.linspace(0, sweep.values.size - 1, max(2, count))).astype(int))
    return [
        (float(sweep.values[row]), *(float(curve.values[row]) for curve in curves))
        for row in chosen
    ]
