"""External moments as project guides of marine engines print them: order by order, about a point.

The inertia forces of all moving parts leave a force and a moment of each order k,

    F_kV = Re(F exp(i k theta)),    M_kV = sum (z - z_0) F_V    N, N m

in the vertical plane (V), and the same in the horizontal one (H). Both grow with the square of the
speed. Of an order whose forces add up to nought the moment is the same about every point; else that
about another point z_n, such as a node of the hull, is M + (z_0 - z_n) F. Throws in n directions,
evenly spaced and with as many cylinders each, leave forces of those even orders alone that are
multiples of n: the sixth of a two-stroke six, the second of a four-stroke four.

The power-related unbalance is the moment over the power of the engine, N m/kW. MAN B&W class it by
the need of a compensator.

Source: MAN Diesel, Project Guide S80MC-C7/ME-C7, section 17.04: the scaling, the power-related
unbalance and its classes (table 17.04.01); WinGD, Marine Installation Manual X72DF (2021),
section 6.1: the same for M_2V, M_1V and M_1H.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.mechanics.balance import Units, balance, default_reference, total
from crankstar.mechanics.excitation import Reference
from crankstar.spectra import Complex, Real

Wanted = Sequence[float] | Literal["all"] | None
"""Orders that are asked for: these, all that occur, or those of note."""
USUAL = (1.0, 2.0, 4.0)
"""Orders that project guides print: M_1V, M_1H, M_2V, M_4V."""
NOTED = 1e-3
"""Share of the greatest moment, or of the greatest force of a part, from which an order is told."""
LEAST = 1e-9
"""The same where all orders are asked for, and of every single moment: less is rounding."""
HIGHEST = 24.0
"""The highest order that is told unless it is asked for."""
FREE = 1e-6
"""Share of the greatest force of a part below which a sum of forces is none."""
UNBALANCE_CLASSES: tuple[tuple[float, str], ...] = (
    (60.0, N_("not relevant")),
    (120.0, N_("unlikely")),
    (220.0, N_("likely")),
    (np.inf, N_("most likely")),
)
"""N m/kW up to which a compensator is so much needed."""


@dataclass(frozen=True)
class ExternalMoments:
    """Force and moment of each order about z, amplitudes c of Re(c exp(i k theta)) [order].

    In `units`: N and N m at `speed` (rad/s), or those of m r w^2 where masses are not known.
    `of_a_part` is the greatest force of a single part, against which sums are small or not;
    `computed` are the orders of a list that was asked for, None where all are computed.

    >>> from crankstar.files.catalog import load
    >>> found = external_moments(load("triple-120"))
    >>> [float(abs(each).round(4)) for each in found.vertical[:2]]  # a three: sqrt(3) m r w^2 a
    [1.7321, 0.44]
    """

    z: float
    speed: float | None
    units: Units
    orders: Real
    force_vertical: Complex
    force_horizontal: Complex
    vertical: Complex
    horizontal: Complex
    of_a_part: float
    computed: tuple[float, ...] | None = None

    @property
    def pushing(self) -> list[float]:
        """The orders that leave a force, so that their moments differ about other points."""
        pushed = np.maximum(np.abs(self.force_vertical), np.abs(self.force_horizontal))
        return self.orders[pushed > FREE * self.of_a_part].tolist()

    def moment(self, order: float, side: str = "V") -> float:
        """The amplitude of M_kV or M_kH, nought where it does not occur or is rounding alone.

        nan where it is not computed.
        """
        if self.computed is not None and not np.isclose(order, self.computed, rtol=0).any():
            return np.nan
        values = self.vertical if side == "V" else self.horizontal
        size = float(np.abs(values[np.abs(self.orders - order) < 1e-9]).sum())
        greatest = float(np.abs((self.vertical, self.horizontal)).max(initial=0.0))
        return size if size > LEAST * greatest else 0.0

    def at(self, speed: float) -> float:
        """The factor from the moments of this record to those at another speed (rad/s)."""
        return 1.0 if self.speed is None else (speed / self.speed) ** 2


def external_moments(
    engine: Engine, *, speed: float | None = None, about: float | None = None, orders: Wanted = None
) -> ExternalMoments:
    """The external moments at a speed (rad/s), `about` the place z, else the middle of cylinders.

    `orders` are those wanted: by default 1, 2, 4 and all others of note up to 24, with "all" those
    that are more than rounding. Without speed or masses they are in units of m r w^2.

    >>> from crankstar.files.catalog import load
    >>> five = load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "0.6 kg"})
    >>> slow, fast = (external_moments(five, speed=speed) for speed in (50.0, 100.0))
    >>> round(fast.moment(2) / slow.moment(2), 9), round(slow.at(100.0), 9)
    (4.0, 4.0)
    """
    place = default_reference(engine).z if about is None else about
    given = None if isinstance(orders, str) else orders
    result = balance(engine, speed=speed, reference=Reference(place), orders=given)
    sums = total(result)
    force, couple = sums.force, sums.couple
    values = {
        "force_vertical": spectra.vertical(force),
        "force_horizontal": spectra.horizontal(force),
        "vertical": spectra.vertical(couple),
        "horizontal": spectra.horizontal(couple),
    }
    kept = np.arange(force.orders.size)
    each = np.abs(result.force.forward) + np.abs(result.force.backward)
    of_a_part = float(each.max(initial=0.0))
    if given is None:
        share = NOTED if orders is None else LEAST
        size = np.maximum(np.abs(values["vertical"]), np.abs(values["horizontal"]))
        push = np.maximum(np.abs(values["force_vertical"]), np.abs(values["force_horizontal"]))
        if push.max(initial=0.0) <= FREE * of_a_part:
            push = np.zeros_like(push)
        noted = (size > share * size.max(initial=0.0)) | (push > share * of_a_part)
        usual = np.isclose(force.orders[:, None], USUAL, rtol=0, atol=1e-9).any(axis=1)
        kept = np.flatnonzero((noted | usual) & (force.orders <= HIGHEST + 1e-9))
    return ExternalMoments(
        place,
        result.speed,
        result.units,
        force.orders[kept],
        **{name: value[kept] for name, value in values.items()},
        of_a_part=of_a_part,
        computed=None if given is None else tuple(map(float, given)),
    )


def unbalance_class(power_related: float) -> str:
    """How much a compensator is needed at a power-related unbalance (N m/kW), by MAN B&W's table.

    The class is a word of UNBALANCE_CLASSES, not translated. A moment grows with the square of the
    speed, the power of a propeller with its cube: an engine that is derated along it is worse.

    >>> [unbalance_class(value) for value in (36.4, 60.1, 146.4, 300)]
    ['not relevant', 'unlikely', 'likely', 'most likely']
    """
    return next(word for most, word in UNBALANCE_CLASSES if power_related <= most)
