"""Sweeps: one or two numbers of an engine at many values, and the results.

Any number of the file is named by its key path, in the notation of `--set`: in the short form where
the file has one, and in the explicit form for every engine; `balance_factor` and `speed` for every
engine. The firing order is left out of account, since a sweep of a phase passes through angles at
which it cannot fire.

Force, couple, moments and torque are counted in the units of the engine as its file has it, m and r
those of its first cylinder, about one point, the middle of its cylinders unless another is given:
so that the curve shows what the engine does, not what it is counted in. Where the file's own number
makes no engine, or leaves masses or lengths unknown that the swept one makes known, the engine at
the first value is the measure. Over the speed omega inertia grows with omega^2; of an engine
without masses or sizes it is counted in m r omega_0^2, omega_0 the highest of the speeds.

A range of an angle over full turns at whose ends the engine is the same is closed: its last value
is the first one again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.frames import dataset, with_unit
from crankstar.analysis.record import Grid
from crankstar.analysis.registry import added, measures
from crankstar.engine.engine import Engine
from crankstar.language.quoting import one_line
from crankstar.mechanics import labelled
from crankstar.mechanics.balance import Units
from crankstar.mechanics.excitation import Reference, Totals, rolling_moment
from crankstar.spectra import Real, Spectrum
from crankstar.studies.fields import Source, ends_of, source_of
from crankstar.studies.gas_results import GAS_WATCHABLE, Case, Gap, gas_values, one_by_one
from crankstar.studies.ranges import requested
from crankstar.studies.study import SPEED_PATH, Study, check_apart, study
from crankstar.studies.sums import GREATEST_ORDER, Group, joined
from crankstar.studies.variants import SweepError, Tell

if TYPE_CHECKING:
    import pandas
    import xarray

_PLANE = ("", ".up", ".right", ".forward", ".backward")
WATCHABLE = (
    *(f"force{part}" for part in _PLANE),
    *(f"couple{part}" for part in (*_PLANE, ".pitch", ".yaw")),
    "roll",
    "axis_moment",
    "torque",
)

EVERYTHING = (*WATCHABLE, *GAS_WATCHABLE, *measures())
"""All that a sweep can watch."""


class Axis(NamedTuple):
    """A number that is varied: its key path, its `values` [n] in `unit`.

    `closed`: the last value is the first one again, a full turn later.
    """

    path: str
    unit: str
    values: Real
    closed: bool = False


@dataclass(frozen=True)
class Sweep:
    """An engine at many values of one of its numbers, or of two.

    `axes` are these numbers; the sums of all values, or pairs of values, are counted in `units`.

    `engine` is that of the first values. Engines of the same orders are a Group; there is more than
    one where gear ratios or rods are swept. `again` sweeps other values; `ends` sweeps the same
    ones for the engine in the middle and at the corners of the ranges of its estimated values.
    `cases` are the engines themselves with their speeds, which gas needs; `case` is that of the
    values at some places of the axes.
    `speed` is the one of all [rad/s], None where it is swept or where nothing is in newtons. Where
    the speed is swept, `highest_speed` is omega_0; vibration is `alone` at a speed that is swept or
    was asked for, else its maximum over the speeds of the file. `orders` are those that were asked
    for, None of all. `adds`: a balance factor is varied whose weights are added to others.
    `watch`: the results, each of all orders or of one, that frames and data sets have alone.
    """

    axes: tuple[Axis, ...]
    engine: Engine
    summed: Callable[[], tuple[Group, ...]] = field(repr=False, compare=False)
    units: Units
    reference: Reference
    speed: float | None
    highest_speed: float | None
    alone: bool
    orders: tuple[float, ...] | None
    again: Callable[..., Sweep] = field(repr=False, compare=False)
    ends: Callable[[], tuple[Sweep, ...]] = field(repr=False, compare=False)
    cases: Callable[[], Sequence[Case | SweepError]] = field(repr=False, compare=False)
    case: Callable[[Sequence[int]], Case] = field(repr=False, compare=False)
    adds: bool = False
    watch: tuple[tuple[str, float | None], ...] = ()

    @property
    def groups(self) -> tuple[Group, ...]:
        """The sums of inertia of all values, which gas and vibration do without."""
        return self.summed()

    @property
    def path(self) -> str:
        """The path of the first number."""
        return self.axes[0].path

    @property
    def unit(self) -> str:
        """The unit of the first number."""
        return self.axes[0].unit

    @property
    def values(self) -> Real:
        """The values [n] of the first number."""
        return self.axes[0].values

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values each number has."""
        return tuple(axis.values.size for axis in self.axes)

    @property
    def sums(self) -> Totals:
        """The sums of all values [n, order], or pairs [n, m, order], over all their orders."""
        count = int(np.prod(self.shape))
        lone = self.groups[0]
        in_order = len(self.groups) == 1 and np.array_equal(lone.rows, np.arange(count))
        sums = lone.sums if in_order else joined(self.groups, count)

        def shaped(spectrum: Spectrum) -> Spectrum:
            shape = (*self.shape, spectrum.orders.size)
            return replace(
                spectrum,
                forward=spectrum.forward.reshape(shape),
                backward=spectrum.backward.reshape(shape),
            )

        return Totals(*map(shaped, sums))

    def columns(self) -> dict[str, Real]:
        """The values of each number, by its path, in the order of the rows of a tidy table [n]."""
        grids = np.meshgrid(*(axis.values for axis in self.axes), indexing="ij")
        return {axis.path: grid.ravel() for axis, grid in zip(self.axes, grids, strict=True)}

    @property
    def curves(self) -> tuple[Curve, ...]:
        """What is watched, at every value."""
        return tuple(watched(self, what, order=order) for what, order in self.watch)

    def to_frame(self) -> pandas.DataFrame:
        """The amplitudes at every value as a tidy pandas data frame: one row an amplitude.

        The first columns are the engine and the values, named as in the CSV of `crankstar sweep` by
        path and unit; the others are those of `Balance.to_frame`. attrs: units, the speed (rad/s)
        and the reference point. Where results are watched: one row a value, a column for each of
        them, units in their names. Raises ImportError without pandas.

        >>> twin = sweep("v2-90", {"balance_factor": [0, 0.5, 1]}, watch=["force", ("roll", 2)])
        >>> print(twin.to_frame().round(6).to_string(index=False))
         balance_factor  force_m_r_w2  roll_order_2_m_r2_w2
                    0.0      1.290402                   0.0
                    0.5      0.359398                   0.0
                    1.0      1.290402                   0.0
        """
        if self.watch:
            columns: dict[str, Any] = {}
            for axis, values in zip(self.axes, self.columns().values(), strict=True):
                columns[with_unit(axis.path, axis.unit)] = values
            for name, curve in self._watched().items():
                columns[with_unit(name, curve.unit)] = curve.values.ravel()
            return labelled.frame(columns, self._facts)
        count = int(np.prod(self.shape))
        labels: dict[str, Any] = {"engine": [self.engine.name] * count}
        for axis, values in zip(self.axes, self.columns().values(), strict=True):
            labels[f"{axis.path} [{axis.unit}]" if axis.unit else axis.path] = values
        rows = labelled.columns(joined(self.groups, count), self.units._asdict(), labels)
        units = {f"unit of {axis.path}": axis.unit for axis in self.axes}
        return labelled.frame(rows, {**units, **self._facts})

    def to_xarray(self, *, split: bool = False) -> xarray.Dataset:
        """The amplitudes as an xarray data set with a dimension for each number, and order.

        Dimensions and coordinates are named by the paths. Variables and `split` are those of
        `Balance.to_xarray`. Raises ImportError without xarray.

        >>> table = sweep("v2-90", "balance_factor=0..1/3").to_xarray()
        >>> abs(table.force_forward.sel(order=1)).round(6).values.tolist()  # 0.5 cancels it
        [1.0, 0.0, 1.0]
        """
        if self.watch:
            names = [axis.path for axis in self.axes]
            grid = Grid(
                {axis.path: (axis.path, axis.values, {"units": axis.unit}) for axis in self.axes},
                {
                    name: (tuple(names), curve.values, curve.unit)
                    for name, curve in self._watched().items()
                },
            )
            return dataset(grid, {k: v for k, v in self._facts.items() if v is not None})
        return labelled.dataset(
            self.sums,
            self.units._asdict(),
            dimensions=[axis.path for axis in self.axes],
            labels={
                axis.path: (axis.path, axis.values, {"units": axis.unit}) for axis in self.axes
            },
            facts=self._facts,
            split=split,
        )

    def _watched(self) -> dict[str, Curve]:
        """The curves by name: what is watched, and of which order."""
        return {
            curve.what if curve.order is None else f"{curve.what}_order_{curve.order:g}": curve
            for curve in self.curves
        }

    @property
    def _facts(self) -> dict[str, Any]:
        point = {f"reference_{name}": place for name, place in self.reference._asdict().items()}
        return {
            "engine": self.engine.name,
            "speed": self.speed,
            "highest_speed": self.highest_speed,
            **point,
        }


class Curve(NamedTuple):
    """A result (of one order, or None: of all) at every value of a sweep, its unit and name.

    `values` have the shape of the sweep, nan where there is no result, which `gaps` tell.
    """

    what: str
    order: float | None
    values: Real
    unit: str
    label: str
    gaps: tuple[Gap, ...] = ()

    @property
    def top(self) -> float:
        """The greatest value."""
        return float(np.nanmax(self.values))


def sweep(
    engine: str | Engine | Mapping[str, Any],
    over: str | Sequence[str] | Mapping[str, Any],
    *,
    watch: str | Sequence[str | tuple[str, float]] = (),
    changes: Mapping[str, Any] | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    speed: float | Literal["file"] | None = "file",
    estimate: bool = False,
    tell: Tell | None = None,
) -> Sweep:
    """What `crankstar sweep --over` computes; `watched` gives its curves. Raises as `swept` does.

    `over` is one text, or two for two numbers that are varied at once, or a dict of their values by
    key path: numbers in SI units, or text with a unit. `watch` are results as `watched` takes them,
    each alone or with an order; the frame has these then. `estimate` fills in the masses and
    lengths that the file leaves out; they stay as they are while others are varied.

    >>> twin = sweep("harley-45", "balance_factor=0..1/5")
    >>> watched(twin, "force.forward", order=1).values.round(6).tolist()
    [1.0, 0.5, 0.0, 0.5, 1.0]
    >>> both = sweep("v2-90", ["balance_factor=0..1/3", "cylinder.rod_ratio=3..5/2"])
    >>> watched(both, "force", order=1).values.round(6).tolist()
    [[1.0, 1.0], [0.0, 0.0], [1.0, 1.0]]
    """
    over_all = requested(over)
    several = [watch] if isinstance(watch, str) else watch
    watching = [(each, None) if isinstance(each, str) else each for each in several]
    check_watchable(*(what for what, _order in watching))
    check_apart([path for path, *_values in over_all], changes or {})
    varied = [path for path, *_values in over_all]
    asked = speed if speed != "file" or SPEED_PATH in varied else None
    source = source_of(engine, changes=changes, estimate=estimate, speed=asked)
    made = _over(source, over_all, tell, reference=reference, orders=orders, speed=speed)
    made.summed()
    return replace(made, watch=tuple(watching))


def sweep_of(
    source: Source,
    over: Sequence[tuple[str, Sequence[float] | Real, str | None]],
    *,
    speed: float | Literal["file"] | None = "file",
) -> Sweep:
    """The sweep of the tree of a file over numbers: key path, values, unit. Raises as `swept`."""
    return _over(source, over, None, reference=None, orders=None, speed=speed)


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
    check_apart([over], changes or {})
    source = source_of(name, changes=changes)
    wanted = [(over, values, unit)]
    made = _over(source, wanted, tell, reference=reference, orders=orders, speed=speed)
    made.summed()
    return made


def _over(
    source: Source,
    over: Sequence[tuple[str, Sequence[float] | Real, str | None]],
    tell: Tell | None,
    **how: Any,
) -> Sweep:
    """The sweep of a file over numbers: key path, values, unit.

    Its sums are made where they are asked for first: to refuse a value that makes no engine, ask.
    """
    plan = study(source, over, **how)
    made = _made(plan, [np.asarray(values, float) for _path, values, _unit in over], tell)
    weighted = any(shaft.get("weight") for shaft in source.tree.get("crankshaft", ()))
    return replace(
        made,
        adds=weighted and any(varied.path == "balance_factor" for varied in plan.over),
        ends=lambda: tuple(_over(end, over, None, **how) for end in ends_of(source, plan.over)),
    )


def _made(plan: Study, values: Sequence[Real], tell: Tell | None, *, close: bool = True) -> Sweep:
    """The sweep of a study over these values."""
    closing = [close and plan.closes(index, values) for index in range(len(values))]
    axes = [
        Axis(varied.path, unit, own, closed)
        for varied, unit, own, closed in zip(plan.over, plan.units_of, values, closing, strict=True)
    ]

    def again(*others: Sequence[float] | Real) -> Sweep:
        return _made(plan, [np.asarray(each, float) for each in others], None, close=False)

    def one(places: Sequence[int]) -> Case:
        [found] = plan.cases([own[[place]] for own, place in zip(values, places, strict=True)])
        if isinstance(found, SweepError):
            raise found
        return found

    return Sweep(
        axes=tuple(axes),
        engine=plan.first,
        summed=cache(partial(plan.groups, values, closing, tell)),
        units=plan.units,
        reference=plan.reference,
        speed=plan.speed,
        highest_speed=plan.highest,
        alone=plan.alone,
        orders=None if plan.orders is None else tuple(plan.orders),
        again=again,
        ends=tuple,
        cases=lambda: plan.cases(values),
        case=one,
    )


def check_watchable(*names: str) -> None:
    """Refuse names that are not in WATCHABLE. Raises SweepError."""
    for name in names:
        if name not in EVERYTHING:
            raise SweepError(
                "{quantity} cannot be computed in a sweep; choose from {quantities}",
                quantity=one_line(name, longest=60),
                quantities=", ".join(EVERYTHING),
            )


def watched(sweep: Sweep, what: str, *, order: float | None = None) -> Curve:
    """One result of every variant: the peak of force, couple, moment or torque, or of a part.

    `what` is one of WATCHABLE: force, couple, roll (the rolling moment on the block),
    axis_moment (of the forces, about the crank axis), torque; .up, .right, the component that way;
    .forward, .backward, the vectors that turn with and against the crankshaft; couple.pitch and
    couple.yaw, the moments about the right and the up axis, as large as couple.up and couple.right.
    Or one of GAS_WATCHABLE: what gas does at the load of each engine's file; or a measure of an
    analysis: how its crankshaft vibrates, how it shakes on its mounts.
    All orders together over their period, or one `order`. Raises SweepError.

    >>> sweep = swept("single", over="balance_factor", values=[0, 0.5, 1])
    >>> watched(sweep, "force", order=1).values.round(6).tolist(), watched(sweep, "force").unit
    ([1.0, 0.5, 1.0], 'm*r*w^2')
    """
    check_watchable(what)
    if order is not None and not 0 < order <= GREATEST_ORDER:
        raise SweepError(
            "there is no order {order}; give a crank order above 0 up to {most}",
            order=f"{order:g}",
            most=GREATEST_ORDER,
        )
    if order is not None and sweep.orders is not None and order not in sweep.orders:
        raise SweepError(
            "the sweep has no order {order}; its orders are {orders}",
            order=f"{order:g}",
            orders=", ".join(f"{each:g}" for each in sweep.orders),
        )
    label = what if order is None else f"{what} of order {order:g}"
    if what in GAS_WATCHABLE:
        values, unit, gaps = gas_values(sweep.cases, what, order=order, shape=sweep.shape)
        return Curve(what, order, values, unit, label, gaps)
    if what in measures():
        unit = measures()[what][1].unit
        values, gaps = _measured(sweep, what, order)
        return Curve(what, order, values, unit, label, gaps)
    peaks = np.zeros(int(np.prod(sweep.shape)))
    for group in sweep.groups:
        spectrum = spectrum_of(group.sums, what)
        if order is not None:
            spectrum = spectra.selected(spectrum, [order])
            peaks[group.rows] = (np.abs(spectrum.forward) + np.abs(spectrum.backward))[:, 0]
        else:
            peaks[group.rows] = spectra.peaks(spectrum)
    unit = getattr(sweep.units, what.partition(".")[0], sweep.units.moment)
    return Curve(what, order, peaks.reshape(sweep.shape), unit, label)


def _measured(sweep: Sweep, what: str, order: float | None) -> tuple[Real, tuple[Gap, ...]]:
    """A measure of every variant, of all orders or one; what has none. Raises SweepError."""
    record, measure = measures()[what]
    if order is not None and not measure.orders:
        raise SweepError("{what} has no orders; leave --orders out", what=what)
    assert record.measured is not None  # noqa: S101  # it has measures
    value = record.measured.value

    def of_engine(engine: Engine, speed: float | None) -> float:
        with added().running(record.name):
            return value(engine, what, speed=speed, order=order, alone=sweep.alone)

    return one_by_one(sweep.cases, of_engine, what, shape=sweep.shape)


def spectrum_of(sums: Totals, what: str) -> Spectrum:
    """What is watched of some sums, one of WATCHABLE [..., order]."""
    quantity, _dot, part = what.partition(".")
    return _part(rolling_moment(sums) if quantity == "roll" else getattr(sums, quantity), part)


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
