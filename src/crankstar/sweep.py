"""Sweeps: one number of an engine file taken at many values, what the engine then does, and the value that does it best.

Any number of the file is named by its key path, in the notation of `--set`: in the short form where the file has one, and
in the explicit form for every engine; `balance_factor` for every engine. The firing order is left out of account, since a
sweep of a phase passes through angles at which it cannot fire.

Force, couple, roll and torque are counted in the units of the engine as its file has it, m and r those of its first
cylinder, about one point, the middle of its cylinders unless another is given: so that the curve shows what the engine does,
not what it is counted in. Where the file's own number makes no engine, or leaves masses or lengths unknown that the swept one
makes known, the engine at the first value is the measure.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from crankstar import motion, phasor
from crankstar.balance import Units, default_reference, scales
from crankstar.engine import Engine
from crankstar.fields import subject
from crankstar.files import EngineFileError
from crankstar.mechanism import Mechanism, Reference, Totals, spectra, totals
from crankstar.phasor import Real, Spectrum
from crankstar.quantity import Quantity, one_line, seen
from crankstar.variants import SweepError, Tell, picked, variants

GREATEST_POINTS = 20_000
GREATEST_CELLS = 3_000_000
"""Values times orders: half a gigabyte of vectors."""
GREATEST_WORK = 200_000_000
"""Values times orders times parts: some ten seconds."""
USUAL_POINTS = 201
GREATEST_ORDER = 1000
EXAMPLE = 'as in "layout.banks[1].bearing=0..90 deg", "balance_factor=0..1/11" (11 values) or "balance_factor=0, 0.25, 0.5"'
_PLANE = ("", ".up", ".right", ".forward", ".backward")
WATCHABLE = (*(f"force{part}" for part in _PLANE), *(f"couple{part}" for part in (*_PLANE, ".pitch", ".yaw")), "roll", "torque")
_SI = {"angle": "rad", "length": "m", "length along the crankshaft": "m", "mass": "kg", "rotational speed": "rad/s"}
_SI |= {"moment of inertia": "kg*m^2", "unbalance": "kg*m"}
_NUMBER = re.compile(r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL)


class Over(NamedTuple):
    """What is to be swept: the key path of a number, its values, and the unit they are in ("" if none was given)."""

    path: str
    values: tuple[float, ...]
    unit: str


class Group(NamedTuple):
    """Variants of one structure: which of the values they belong to [row], and their sums [row, order]."""

    rows: np.ndarray
    sums: Totals


@dataclass(frozen=True)
class Sweep:
    """An engine at many values of one of its numbers: `values` [n] in `unit`, and the sums, counted in `units`.

    `engine` is that of the first value. Engines of one structure are a Group; there is more than one only where gear ratios
    are swept, or where a throw or a weight comes or goes.
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
        _enough(self.values.size, orders.size)
        shape = (self.values.size, orders.size)

        def joined(name: str) -> Spectrum:
            forward, backward = np.zeros(shape, complex), np.zeros(shape, complex)
            for group in self.groups:
                own = phasor.selected(getattr(group.sums, name), orders)
                forward[group.rows], backward[group.rows] = own.forward, own.backward
            return Spectrum(orders, forward, backward, getattr(self.groups[0].sums, name).sense)

        return Totals(*map(joined, Totals._fields))


class Curve(NamedTuple):
    """What was watched (and of which order; None: of all together) at every value of a sweep [n], its unit and its name."""

    what: str
    order: float | None
    values: Real
    unit: str
    label: str


class Best(NamedTuple):
    """The best value of a sweep and what it gives.

    `at_edge`: it is an end of the range, and might be better beyond. `flat`: the curve is the same all along. `also`: other
    values that are as good, up to eight. `stretch`: where it is equally good from one value to another, these two.
    """

    value: float
    result: float
    at_edge: bool
    flat: bool
    also: tuple[float, ...] = ()
    stretch: tuple[float, float] | None = None


def over_request(text: str) -> Over:
    """What a text such as "layout.banks[1].bearing=0..90 deg" asks to be swept. Raises SweepError.

    >>> over_request("balance_factor=0..1/5")
    Over(path='balance_factor', values=(0.0, 0.25, 0.5, 0.75, 1.0), unit='')
    >>> over_request("layout.cranks[2].lag=0, 90, 180 deg")[1:]
    ((0.0, 90.0, 180.0), 'deg')
    """
    here = f"--over {one_line(text, longest=100)}"
    path, equals, told = text.partition("=")
    if not equals or not path.strip() or not told.strip():
        raise SweepError(f"{here}: give a field of the engine file and its values, {EXAMPLE}")
    if ".." not in told:
        parts = [part for part in told.split(",") if part.strip()]
        values, unit = _numbers(parts, here)
        if len(set(values)) < 2:
            raise SweepError(f"{here}: is one value; a sweep needs two or more, {EXAMPLE}")
        return Over(path.strip(), tuple(values), unit)
    counts = re.findall(r"/\s*(\d+)(?!\d)", told)
    ends, unit = _numbers(re.sub(r"/\s*\d+", " ", told, count=1).split("..", 1), here)
    count = int(counts[0][:9]) if counts else USUAL_POINTS
    if len(counts) > 1 or not 2 <= count <= GREATEST_POINTS:
        raise SweepError(
            f"{here}: {one_line(counts[-1], longest=20)} is no number of values to sweep; give from 2 to {GREATEST_POINTS}"
        )
    if ends[0] == ends[1]:
        raise SweepError(f"{here}: is an empty range, from {ends[0]:g} to {ends[1]:g}; give two ends that differ")
    return Over(path.strip(), tuple(np.linspace(ends[0], ends[1], count).tolist()), unit)


def _numbers(parts: Sequence[str], here: str) -> tuple[list[float], str]:
    """Numbers, and the one unit that some or all of them have."""
    found = [_NUMBER.fullmatch(part) if len(part) <= 60 else None for part in parts]
    for part, match in zip(parts, found, strict=True):
        if match is None or not np.isfinite(float(match.group(1))) or re.match(r"[.,\d]", match.group(2)):
            raise SweepError(f"{here}: {seen(part.strip())} is not a number, or one with a unit; give values {EXAMPLE}")
    units = dict.fromkeys(match.group(2) for match in found if match and match.group(2))
    if len(units) > 1:
        raise SweepError(f"{here}: has the units {' and '.join(one_line(unit, longest=20) for unit in units)}; give all in one")
    return [float(match.group(1)) for match in found if match], next(iter(units), "")


def swept(
    name: str,
    *,
    over: str,
    values: Sequence[float] | Real,
    unit: str | None = None,
    changes: Mapping[str, Any] | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    speed: float | None = None,
    tell: Tell | None = None,
) -> Sweep:
    """The engine `name` (of the catalog, a file, or "-") at every one of the `values` of the number at the key path `over`.

    `unit` is that of the values: None, SI (radians); a text, as in "deg"; "" says that none was given, which does for plain
    numbers and for lengths and masses that are counted in themselves. `changes` sets other values first, by key path. `orders`
    are all to machine precision unless given. At `speed` (rad/s) the sums are in N and N m, without one in units of m r w^2.
    `tell(done, of)` is called as engines are built one by one. Raises SweepError, EngineFileError.

    >>> sweep = swept("harley-45", over="balance_factor", values=[0, 0.25, 0.5])
    >>> watched(sweep, "force.forward", order=1).values.round(6).tolist()  # at a half what turns with the crank is gone
    [1.0, 0.5, 0.0]
    """
    numbers = _finite(values, over)
    base, make, quantity = subject(name, over=over, unit=unit, changes=changes)
    if unit == "" and quantity and not (base and quantity.relative_to & set(base.relative)) and np.any(numbers):
        raise SweepError(f"{over} has no unit; write its values with one, as in {quantity.example}")
    first = make(float(numbers[0]))
    base = base if base and base.relative == first.relative else first
    point = reference or default_reference(base)
    scale, units = scales(base, speed)

    def at(these: Sequence[float] | Real, tell: Tell | None = None) -> Sweep:
        now = np.asarray(these, float)
        batches = variants(make, now, tell=tell)
        groups = tuple(
            Group(batch.rows, _sums(batch.machine, batch.rows.size, orders, point, scale, now.size)) for batch in batches
        )
        said = unit if unit is not None else "" if quantity is None else _unit(quantity, base)
        known = speed if units.force == "N" else None
        return Sweep(over, said, now, first, groups, units, point, known, at)

    return at(numbers, tell)


def _finite(values: Sequence[float] | Real, over: str) -> Real:
    try:
        numbers = np.asarray(values, float)
    except (TypeError, ValueError):
        raise SweepError(f"{one_line(over, longest=100)}: the values are not numbers; give two or more") from None
    if numbers.ndim != 1 or np.unique(numbers).size < 2 or not np.all(np.isfinite(numbers)):
        raise SweepError(f"{one_line(over, longest=100)}: give a row of two or more finite numbers to sweep over, not all alike")
    if numbers.size > GREATEST_POINTS:
        raise SweepError(f"{one_line(over, longest=100)}: {numbers.size} values; at most {GREATEST_POINTS} can be swept")
    return numbers


def _unit(quantity: Quantity, base: Engine) -> str:
    return "" if quantity.relative_to & set(base.relative) else _SI[quantity.dimension]


def _sums(machine: Mechanism, count: int, orders: Sequence[float] | None, point: Reference, scale: Any, whole: int) -> Totals:
    """The sums of a batch [row, order], in blocks that fit the memory near the processor."""
    some = picked(machine, np.unique(np.linspace(0, count - 1, 9).astype(int)))
    if orders is not None and not (len(orders) and all(0 < order <= GREATEST_ORDER for order in orders)):
        raise SweepError(f"the orders are not possible; give crank orders above 0 up to {GREATEST_ORDER}, such as 1 and 2, or none")
    try:
        wanted = spectra(some).force.orders.tolist() if orders is None else sorted(set(orders))
        _enough(whole, len(wanted))
        moved = motion.resolved(some.links).piston.place
        steps = moved.shape[-1] if moved.ndim > 2 else 1
        parts = 3 * len(machine.cylinder_shaft) + len(machine.rotor_shaft)
        _feasible(whole, len(wanted) * parts)
        block = max(1, min(256, (1 << 18) // (parts * max(steps, len(wanted)))))
        found = totals(machine, orders=wanted, reference=point, block=block)
    except ValueError as error:
        raise SweepError(str(error)) from None
    factors = (scale.force, scale.couple, scale.roll, scale.roll)
    return Totals(*(phasor.scaled(one, factor) for one, factor in zip(found, factors, strict=True)))


def _feasible(values: int, work: int) -> None:
    if values * work > GREATEST_WORK:
        raise SweepError(
            f"{values} values of an engine with so many parts and orders would take long; "
            f"give at most {max(2, GREATEST_WORK // work)} values, or name the orders"
        )


def _enough(values: int, orders: int) -> None:
    if values * orders > GREATEST_CELLS:
        raise SweepError(
            f"{values} values of an engine with {orders} crank orders are too many to keep; "
            f"give at most {GREATEST_CELLS // orders} values, or name the orders"
        )


def watched(sweep: Sweep, what: str, *, order: float | None = None) -> Curve:
    """One number of every variant: the greatest length over a turn of force, couple, roll or torque, or of a part of it.

    `what` is one of WATCHABLE: force, couple, roll, torque; .up, .right, the component that way; .forward, .backward, the
    vectors that turn with and against the crankshaft; couple.pitch and couple.yaw, the moments about the right and the up axis,
    as large as couple.up and couple.right. All orders together over their period, or one `order`. Raises SweepError.

    >>> sweep = swept("single", over="balance_factor", values=[0, 0.5, 1])
    >>> watched(sweep, "force", order=1).values.round(6).tolist(), watched(sweep, "force").unit
    ([1.0, 0.5, 1.0], 'm*r*w^2')
    """
    if what not in WATCHABLE:
        near = get_close_matches(what[:60], WATCHABLE, 1)
        meant = f"did you mean {near[0]}? " if near else ""
        raise SweepError(f"{one_line(what, longest=60)} cannot be watched; {meant}what can is {', '.join(WATCHABLE)}")
    if order is not None and not 0 < order <= GREATEST_ORDER:
        raise SweepError(
            f"there is no order {order:g}; give a crank order above 0 up to {GREATEST_ORDER}, or none for all together"
        )
    quantity, _, part = what.partition(".")
    found = np.zeros(sweep.values.size)
    for group in sweep.groups:
        spectrum = _part(getattr(group.sums, quantity), part)
        if order is None:
            found[group.rows] = phasor.peaks(spectrum)
        else:
            one = phasor.selected(spectrum, [order])
            found[group.rows] = (np.abs(one.forward) + np.abs(one.backward))[:, 0]
    unit = getattr(sweep.units, quantity if quantity in sweep.units._fields else "roll")
    return Curve(what, order, found, unit, what if order is None else f"{what} of order {order:g}")


def _part(spectrum: Spectrum, part: str) -> Spectrum:
    if part in ("forward", "backward"):
        return replace(spectrum, **{"backward" if part == "forward" else "forward": np.zeros_like(spectrum.forward)})
    if part:
        component = phasor.vertical if part in ("up", "pitch") else phasor.horizontal
        return phasor.real_signal(spectrum.orders, component(spectrum))
    return spectrum


ALIKE = 1e-9
"""Results that differ by no more than this share of the greatest of the curve are equally good."""
FINENESS = 1e-8
"""Share of the range to which the best value is found; 16 values at a time, round at most six places of the curve."""
CLOSER, PLACES, ALSO = 16, 6, 8


def best(sweep: Sweep, curve: Curve, *, greatest: bool = False) -> Best:
    """The value at which the curve is least, or with `greatest` greatest: between the values of the sweep where that is better.

    Every place where the curve may come lowest, a smooth hollow or the tip of a V, is swept again more and more closely.

    >>> sweep = swept("single", over="balance_factor", values=np.linspace(0, 1, 8))
    >>> found = best(sweep, watched(sweep, "force", order=1))
    >>> round(found.value, 6), round(found.result, 6), found.at_edge
    (0.5, 0.5, False)
    """
    sign = -1.0 if greatest else 1.0
    x, where = np.unique(sweep.values, return_index=True)
    y = sign * curve.values[where]
    even = ALIKE * float(np.abs(y).max())
    if float(np.ptp(y)) <= even:
        return Best(float(sweep.values[0]), float(curve.values[0]), at_edge=False, flat=True, stretch=(float(x[0]), float(x[-1])))
    runs = _hollows(x, y, even)
    try:
        tips = _tips(sweep, curve, runs, x, sign)
    except (EngineFileError, SweepError):  # not every number between two good ones is one: a ratio of teeth
        tips = [None] * len(runs)
    found: list[tuple[float, float, tuple[float, float] | None]] = []
    for (first, last), tip in zip(runs, tips, strict=True):
        if tip is not None and tip[1] < y[first] - even:
            found.append((*tip, None))
        else:
            middle = (first + last) // 2
            found.append((float(x[middle]), float(y[middle]), (float(x[first]), float(x[last])) if last > first else None))
    least = min(result for _, result, _ in found)
    good = [one for one in found if one[1] <= least + even]
    value, result, stretch = good[0]
    edge = value in (x[0], x[-1]) or bool(stretch and {*stretch} & {float(x[0]), float(x[-1])})
    return Best(value, sign * result, edge, flat=False, also=tuple(one[0] for one in good[1 : ALSO + 1]), stretch=stretch)


def _hollows(x: Real, y: Real, even: float) -> list[tuple[int, int]]:
    """Runs of equal results lower than what is beside them, as far as there may be a lowest value in or beside them."""
    runs: list[tuple[int, int]] = []
    first = 0
    for last in range(x.size):
        if last + 1 < x.size and abs(y[last + 1] - y[first]) <= even:
            continue
        before = y[first - 1] if first else np.inf
        after = y[last + 1] if last + 1 < x.size else np.inf
        if before > y[first] and after > y[first]:
            runs.append((first, last))
        first = last + 1

    def depth(run: tuple[int, int]) -> float:
        """How low a V could reach that has the steeper of the two slopes beside the run."""
        slopes = [abs(y[a] - y[b]) for a, b in ((run[0], run[0] - 1), (run[1], run[1] + 1)) if 0 <= b < x.size]
        return float(y[run[0]] - max(slopes, default=0.0))

    hopeful = [run for run in runs if depth(run) <= y.min() + even]
    exact = [run for run in hopeful if y[run[0]] <= y.min() + even]
    kept = sorted(hopeful, key=depth)[:PLACES]
    return sorted({*kept, *exact[: ALSO + 1]})


def _tips(sweep: Sweep, curve: Curve, runs: Sequence[tuple[int, int]], x: Real, sign: float) -> list[tuple[float, float] | None]:
    """The lowest point in or beside each run, by sweeping all of them closer and closer; signed results."""
    brackets = [(float(x[max(first - 1, 0)]), float(x[min(last + 1, x.size - 1)])) for first, last in runs]
    tips: list[tuple[float, float] | None] = [None] * len(runs)
    span = float(x[-1] - x[0])
    while max(high - low for low, high in brackets) > FINENESS * span:
        closer = np.concatenate([np.linspace(low, high, CLOSER + 1) for low, high in brackets])
        again = sign * watched(sweep.again(closer), curve.what, order=curve.order).values
        for place in range(len(brackets)):
            own = slice(place * (CLOSER + 1), (place + 1) * (CLOSER + 1))
            here, results = closer[own], again[own]
            lowest = int(np.argmin(results))
            tips[place] = min(filter(None, (tips[place], (float(here[lowest]), float(results[lowest])))), key=lambda tip: tip[1])
            brackets[place] = (float(here[max(lowest - 1, 0)]), float(here[min(lowest + 1, CLOSER)]))
    return tips


def rows(sweep: Sweep, curves: Sequence[Curve], *, count: int = 11) -> list[tuple[float, ...]]:
    """A table of a sweep: `count` of its values, evenly chosen from first to last, with what each of the curves has there."""
    chosen = np.unique(np.round(np.linspace(0, sweep.values.size - 1, max(2, count))).astype(int))
    return [(float(sweep.values[row]), *(float(curve.values[row]) for curve in curves)) for row in chosen]
