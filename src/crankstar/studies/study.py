"""A study: what is varied, what it is counted in and about, and the sums of any of its values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, Literal

import numpy as np

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import ANGLE, SPEED, Quantity
from crankstar.files import EngineFileError, engine_of, keys_of, units
from crankstar.language.faults import EngineError, ValueFaultError, sentence
from crankstar.language.quoting import one_line, seen
from crankstar.language.units import spelt
from crankstar.mechanics.balance import Scale, Units, default_reference, scales
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real
from crankstar.studies.fields import INSTEAD, Source, Subject, Varied, subject
from crankstar.studies.grids import grid_variants
from crankstar.studies.ranges import GREATEST_POINTS, MOST_AXES
from crankstar.studies.sums import Group, closed, over_speeds, sums_of
from crankstar.studies.variants import (
    Batch,
    OverError,
    SweepError,
    Tell,
    alike,
    arrays_of,
    variants,
)

SPEED_PATH = "speed"
"""The key path of what is no part of the engine, and yet a number of its file."""
GREATEST_VARIANTS = 200_000
"""Engines of one sweep."""
FULL_TURN = 1e-9
"""Share of a turn by which the ends of a closed range may differ from full turns."""


@dataclass(frozen=True)
class Study:
    """One or two numbers of an engine that are varied; everything else is the same for all values.

    `over` are their key paths and units, `units_of` the units as they are shown. Sums are counted
    in `units`, about `reference`, at `speed` (rad/s; None where it is varied, or nothing is in
    newtons); where the speed is varied, `highest` is its greatest value. What vibrates is told
    `alone` at a speed that is asked for or varied, else as the maximum over the speeds of the file.
    """

    source: Source
    over: tuple[Varied, ...]
    units_of: tuple[str, ...]
    subject: Subject
    first: Engine
    units: Units
    scale: Scale
    reference: Reference
    speed: float | None
    highest: float | None
    alone: bool
    orders: tuple[float, ...] | None

    @property
    def _fast(self) -> int | None:
        """The place of the speed among what is varied."""
        return next((n for n, each in enumerate(self.over) if each.path == SPEED_PATH), None)

    def closes(self, index: int, values: Sequence[Real]) -> bool:
        """Whether the range of a number is some full turns, and the engine the same at its ends."""
        own, varied = values[index], self.over[index]
        slow = [n for n in range(len(self.over)) if n != self._fast]
        quantity = self.subject.quantities[slow.index(index)] if index in slow else None
        steps = np.diff(own)
        if quantity is None or quantity.dimension != ANGLE.dimension or own.size < 3:
            return False
        if not (np.all(steps > 0) or np.all(steps < 0)):
            return False
        turns = float(own[-1] - own[0]) * _factor(varied, ANGLE) / (2 * pi)
        if round(turns) == 0 or abs(turns - round(turns)) > FULL_TURN:
            return False
        others = {n: float(values[n][values[n].size // 2]) for n in slow}
        try:
            ends = [
                mechanism(self.subject.make(*({**others, index: float(end)}[n] for n in slow)))
                for end in (own[0], own[-1])
            ]
        except EngineFileError:
            return False
        return alike(ends[0], ends[1], beside=arrays_of(ends[0]))

    def groups(
        self, values: Sequence[Real], closing: Sequence[bool], tell: Tell | None
    ) -> tuple[Group, ...]:
        """The sums of all values; of a closed range the last are the first ones."""
        inner = [own[:-1] if close else own for own, close in zip(values, closing, strict=True)]
        slow = [own for index, own in enumerate(inner) if index != self._fast]
        shape = tuple(own.size for own in inner)
        groups = sums_of(
            self._batches(slow, tell),
            orders=self.orders,
            reference=self.reference,
            scale=self.scale,
            whole=int(np.prod([own.size for own in values])),
        )
        if self._fast is not None:
            speeds = rad_per_s(inner[self._fast], self.units_of[self._fast])
            groups = over_speeds(groups, speeds / (self.highest or 1.0), shape, self._fast)
        if any(closing):
            groups = closed(groups, tuple(own.size for own in values), closing)
        return groups

    def cases(self, values: Sequence[Real]) -> list[tuple[Engine, float | None] | SweepError]:
        """Every engine as its file would have it, firing order included, and its speed (rad/s).

        A SweepError in place of one that cannot fire in the order of the file.
        """
        grids = np.meshgrid(*values, indexing="ij")
        slow = [n for n in range(len(self.over)) if n != self._fast]
        order = engine_of(self.source.tree, name=self.source.name).firing_order
        known: dict[tuple[float, ...], Engine | SweepError] = {}
        out: list[tuple[Engine, float | None] | SweepError] = []
        for cell in zip(*(grid.ravel().tolist() for grid in grids), strict=True):
            numbers = tuple(cell[n] for n in slow)
            if numbers not in known:
                try:
                    known[numbers] = _firing(self.subject.make(*numbers), order)
                except SweepError as error:
                    known[numbers] = error
            engine, at = known[numbers], self.speed
            if isinstance(engine, SweepError):
                out.append(engine)
                continue
            if self._fast is not None:
                speed = np.array([cell[self._fast]])
                at = float(rad_per_s(speed, self.units_of[self._fast])[0])
            out.append((engine, at))
        return out

    def _batches(self, values: Sequence[Real], tell: Tell | None) -> tuple[Batch, ...]:
        make = self.subject.make
        if not values:
            return (Batch(np.array([0]), mechanism(make())),)
        if len(values) == 1:
            return variants(make, values[0], tell=tell)
        return grid_variants(make, *values, tell=tell)


def _firing(engine: Engine, order: tuple[int, ...]) -> Engine:
    """The engine with a firing order. Raises SweepError where it cannot fire so."""
    if engine.firing_order or not order:
        return engine
    try:
        return with_values(engine, firing_order=order)
    except EngineError as error:
        raise SweepError(
            "{engine} does not fire in the order of the file: {reason}",
            engine=engine.name,
            reason=str(error),
        ) from None


def study(
    source: Source,
    over: Sequence[tuple[str, Sequence[float] | Real, str | None]],
    *,
    reference: Reference | None,
    orders: Sequence[float] | None,
    speed: float | Literal["file"] | None,
) -> Study:
    """The study of an engine over numbers: key path, values, unit. Raises as `sweep` does."""
    numbers = {path.strip(): finite(values, path) for path, values, _unit in over}
    _check_count([each.size for each in numbers.values()])
    every = tuple(Varied(path.strip(), unit) for path, _values, unit in over)
    slow = tuple(each for each in every if each.path != SPEED_PATH)
    what = subject(source, slow)
    for each, quantity in zip(slow, what.quantities, strict=True):
        _check_unit(each, numbers[each.path], quantity, what.base)
    first = what.make(*(float(numbers[each.path][0]) for each in slow))
    base = what.base if what.base and what.base.relative == first.relative else first
    quantity_of = dict(zip(slow, what.quantities, strict=True))
    units_of = tuple(_shown_unit(each, quantity_of.get(each), base) for each in every)
    at = base.speed if speed == "file" else speed
    highest = None
    if SPEED_PATH in numbers:
        if isinstance(speed, int | float):
            raise OverError("the speed is given and varied; leave one of the two out")
        unit = next(own for each, own in zip(every, units_of, strict=True) if each not in slow)
        at = highest = float(rad_per_s(numbers[SPEED_PATH], unit).max())
    scale, counted = scales(base, at)
    if highest is not None and counted.force != "N":
        counted = Units(*(unit.replace("w^2", "w_0^2") for unit in counted))
    return Study(
        source=source,
        over=every,
        units_of=units_of,
        subject=what,
        first=first,
        units=counted,
        scale=scale,
        reference=reference or default_reference(base),
        speed=at if counted.force == "N" and highest is None else None,
        highest=highest,
        alone=highest is not None or isinstance(speed, int | float),
        orders=None if orders is None else tuple(orders),
    )


def rad_per_s(values: Real, unit: str) -> Real:
    """Speeds in rad/s. Raises SweepError."""
    if not unit:
        raise _no_unit(Varied(SPEED_PATH), SPEED)
    speeds = values * _factor(Varied(SPEED_PATH, unit), SPEED, shown=float(values.flat[0]))
    if np.any(speeds <= 0):
        raise OverError(
            "the speed is {speed} {unit}; it must be greater than 0, such as {example}",
            speed=f"{float(values.min()):g}",
            unit=unit,
            example=SPEED.example,
        )
    if np.any(speeds < SPEED.least):
        raise OverError(
            "the speed is {speed} {unit}, too small for an engine; give one such as {example}",
            speed=f"{float(values.min()):g}",
            unit=unit,
            example=SPEED.example,
        )
    if np.any(speeds > units.greatest(SPEED)):
        raise OverError(
            "the speed is {speed} {unit}, too large for an engine; give one such as {example}",
            speed=f"{float(values.max()):g}",
            unit=unit,
            example=SPEED.example,
        )
    return speeds


def _factor(varied: Varied, quantity: Quantity, *, shown: float = 1.0) -> float:
    """How much of the SI unit the unit of a number is. Raises SweepError, with the number shown."""
    if varied.unit is None:
        return 1.0
    try:
        return units.si(f"1 {varied.unit}", quantity)
    except ValueFaultError as error:
        value = seen(f"{shown:g} {varied.unit}")
        told = sentence(error.code, {**error.values, "value": value}, place=varied.path)
        raise OverError(told) from None


def finite(values: Sequence[float] | Real, over: str) -> Real:
    """The values as numbers, two or more that differ. Raises SweepError."""
    try:
        numbers = np.asarray(values, float)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    path = one_line(over, longest=100)
    if numbers.ndim != 1 or np.unique(numbers).size < 2 or not np.all(np.isfinite(numbers)):
        raise OverError("{path}: give two or more finite numbers that differ", path=path)
    if numbers.size > GREATEST_POINTS:
        raise OverError(
            "{path}: {count} values; at most {most} can be swept",
            path=path,
            count=numbers.size,
            most=GREATEST_POINTS,
        )
    return numbers


def check_apart(paths: Sequence[str], changes: Mapping[str, Any]) -> None:
    """Refuse more numbers than can be varied at once, one number twice, and one that is set."""
    if not 1 <= len(paths) <= MOST_AXES:
        raise OverError("{count} numbers; one or two can be varied at once", count=len(paths))
    keys = [keys_of(path.strip()) for path in paths]
    if len(keys) > 1 and keys[0] == keys[1]:
        raise OverError(
            "{path} is varied twice; name another number for the second",
            path=one_line(paths[0], longest=80),
        )
    for path in changes:
        *outer, last = keys_of(path)
        if [*outer, last] in keys or [*outer, INSTEAD.get(str(last))] in keys:
            raise OverError(
                "{path} is set, but the values that are varied would replace it; leave one of the "
                "two out",
                path=one_line(path, longest=80),
            )


def _check_count(sizes: Sequence[int]) -> None:
    if np.prod(sizes) > GREATEST_VARIANTS:
        raise OverError(
            "{first} times {second} are {count} engines; at most {most} can be swept",
            first=sizes[0],
            second=sizes[-1],
            count=int(np.prod(sizes)),
            most=GREATEST_VARIANTS,
        )


def _check_unit(
    varied: Varied, values: Real, quantity: Quantity | None, base: Engine | None
) -> None:
    """Refuse values without a unit where one is needed."""
    relative = base is not None and quantity and quantity.relative_to & set(base.relative)
    if varied.unit == "" and quantity and not relative and np.any(values):
        raise _no_unit(varied, quantity)


def _no_unit(varied: Varied, quantity: Quantity) -> OverError:
    return OverError(
        "{path} has no unit; write its values with one, as in {example}",
        path=varied.path,
        example=quantity.example,
    )


def _shown_unit(varied: Varied, quantity: Quantity | None, base: Engine) -> str:
    """The unit of a number that is varied; the SI unit where its values have none."""
    if varied.path == SPEED_PATH:
        return "rad/s" if varied.unit is None else spelt(varied.unit)
    if varied.unit is not None:
        return spelt(varied.unit)
    if quantity is None or quantity.relative_to & set(base.relative):
        return ""
    return units.si_unit(quantity)
