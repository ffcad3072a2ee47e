"""Forces, couples and bearing loads at one speed: that of the file, unless another is given."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import TYPE_CHECKING, Literal, get_args

from crankstar.dynamics import bearings
from crankstar.dynamics.bearings import BearingLoads, Bending, Model
from crankstar.language.messages import _
from crankstar.language.quoting import given
from crankstar.mechanics import balance as sums
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle
from crankstar.python.resting import RestsOn, told

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.options.sources import EngineLike

UnitSystem = Literal["SI", "relative"]
"""Newtons and metres, or m r w^2 and its like with m and r of the first cylinder."""


@dataclass(frozen=True, eq=False)
class BalanceOf(Balance):
    """The Balance of an `engine`, which says what it rests on.

    >>> import crankstar
    >>> five = crankstar.balance("audi-25-tfsi")
    >>> five.rests_on[1].path, five.rests_on[1].moved.quantity
    ('cylinder.rotating_mass', 'couple')
    """

    engine: Engine = field(repr=False)

    @cached_property
    def rests_on(self) -> RestsOn:
        """What its numbers rest on, as `crankstar analyze` prints it; found when asked for."""
        from crankstar.studies.answer_parts import in_own_unit, narrowed, without_speed
        from crankstar.studies.answers import amplitudes, rests_on

        if self.speed is None:
            answer = in_own_unit(amplitudes(without_speed(self.engine), reference=self.reference))
        else:
            answer = amplitudes(self.engine, speed=self.speed, reference=self.reference)
        orders = self.force.orders.tolist()
        return told(
            rests_on(self.engine, narrowed(answer, ("force", "couple", "roll"), orders=orders))
        )


def balance(
    engine: EngineLike,
    *,
    speed: float | None = None,
    units: UnitSystem = "SI",
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
) -> BalanceOf:
    """The Balance of an engine in N and N m at `speed` (rad/s), by default that of its file.

    In m r w^2 where units are "relative", and where masses, sizes or the speed are not known.
    `orders` keeps only those; `reference` is the point of the couples, by default the middle of the
    cylinders.

    >>> import crankstar
    >>> five = crankstar.balance("audi-25-tfsi")  # at 6500 rpm
    >>> couple = crankstar.spectra.selected(crankstar.total(five).couple, 2)
    >>> five.units.couple, (abs(couple.forward) + abs(couple.backward)).round(1).tolist()
    ('N*m', [1534.3])
    >>> crankstar.balance("audi-25-tfsi", units="relative").units.couple
    'm*r*w^2*a'
    """
    own = _named(engine, "balance")
    at = _speed(own, speed, units)
    made = sums.balance(own, speed=at, reference=reference, orders=orders)
    known = {each.name: getattr(made, each.name) for each in fields(Balance)}
    return BalanceOf(**known, engine=own)


def bearing_loads(
    engine: EngineLike,
    *,
    speed: float | None = None,
    units: UnitSystem = "SI",
    model: Model = "determinate",
    cycle: Cycle | None = None,
) -> BearingLoads:
    """Loads on all main bearings, crank pins and cylinder walls by crank order.

    In N at `speed` (rad/s), by default that of the cycle or the file; in m r w^2 where units are
    "relative", and where masses, sizes or the speed are not known. With a `cycle` those of its gas
    as well. A `continuous` shaft rests on rigid bearings, or on those of the stiffness that the
    file gives. Raises BearingError where gas needs a speed or masses that are not known.

    >>> import crankstar
    >>> crankstar.bearing_loads("audi-25-tfsi").unit
    'N'
    """
    own = _named(engine, "bearing_loads")
    at = cycle.speed if cycle is not None and speed is None else _speed(own, speed, units)
    return bearings.bearing_loads(own, speed=at, model=model, cycle=cycle)


def bending_moment(
    engine: EngineLike,
    *,
    shaft: str | None = None,
    speed: float | None = None,
    units: UnitSystem = "SI",
    model: Model | None = None,
    cycle: Cycle | None = None,
) -> Bending:
    """The bending moment along a crankshaft, by default the first.

    `model=None`: in its two end bearings alone, so that no inner bearing helps. In N m at the speed
    of `bearing_loads`, in m r w^2 a where units are "relative".

    >>> import crankstar
    >>> round(crankstar.bending_moment("audi-25-tfsi").z[0], 3)
    0.22
    """
    own = _named(engine, "bending_moment")
    at = cycle.speed if cycle is not None and speed is None else _speed(own, speed, units)
    return bearings.bending_moment(own, shaft=shaft, speed=at, model=model, cycle=cycle)


def _named(engine: EngineLike, asking: str) -> Engine:
    from crankstar.options.sources import engine_named  # no file is read without a name

    return engine_named(engine, asking)


def _speed(engine: Engine, speed: float | None, units: str) -> float | None:
    """The speed of an answer; None where it is in m r w^2. Raises ValueError."""
    if units not in get_args(UnitSystem):
        raise ValueError(_('units is "SI" or "relative", not {given}', given=given(units)))
    if units == "relative":
        if speed is not None:
            raise ValueError(_('units="relative" has no speed; leave speed out'))
        return None
    return engine.speed if speed is None else speed
