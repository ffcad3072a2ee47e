"""Guide-force moments: how the side thrusts of the pistons rock and twist the engine frame.

The guide force N of a cylinder pushes its guide sideways at the height h of piston pin or
crosshead, and the crank bearings get as much the other way: a couple that rolls the block,

    R_j = h N_j                                     N m, clockwise seen from the front

At constant speed it is minus the torque of the cylinder, gas and inertia, in the sense of rotation
(and what turns its rod), so that its orders are known exactly. Over the engine these couples make

    H_k = sum of R_jk                               N m: all heads sway together
    B_k = sum of (z_j - z_0) R_jk                   N m^2: the bimoment; front and rear sway apart
    X_k = B_k/L                                     N m

with z_0 the middle of the cylinders and L the rod length, the distance from the crankshaft to the
middle of the guide. H of an order that is a multiple of the firings per turn is that of one
cylinder times their number where firing is even; all other orders of H vanish, but not of X. At top
bracings at the height L_z, in two transverse planes L_x apart, they push with

    F_H = H/L_z (all bracings together),    F_X = B/(L_z L_x) (each plane)      N

The H-moments add up to minus the fluctuation of the torque of the whole engine.

Source: MAN Diesel, Project Guide MC/MC-C engines, section 17.05, guide-force moments: the H-moment
of even firing, the bimoment, X = bimoment/L, forces at the top bracing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError
from crankstar.mechanics.balance import balance, default_reference
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import HIGHEST, piston_torque
from crankstar.spectra import ROUNDING, Complex, Real, Spectrum

NOTED = 0.01
"""Share of the greatest moment from which an order is told to readers."""


class MarineError(MessageError):
    """Moments of a marine engine that cannot be computed, and why."""


@dataclass(frozen=True)
class GuideMoments:
    """Rolling couples of all cylinders [cylinder, order], amplitudes of Re(c exp(i k theta)), N m.

    `arms` are their places about the middle [cylinder], m or pitches; `length` the rod length, m.
    `with_inertia` says whether masses and speed were known; else it is gas alone.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> found = guide_moments(five, cycle(five, imep="9 bar"))
    >>> found.numbers, [float(k) for k in found.orders[abs(found.h) > 1e-6][:2]]
    ((1, 2, 3, 4, 5), [2.5, 5.0])
    """

    numbers: tuple[int, ...]
    orders: Real
    rolling: Complex
    arms: Real
    length: float
    with_inertia: bool
    pitch_known: bool

    @property
    def h(self) -> Complex:
        """The H-moment of each order, N m."""
        return _without_noise(self.rolling)

    @property
    def bimoment(self) -> Complex:
        """The bimoment of each order, N m^2; N m times pitches where the pitch is not known."""
        return _without_noise(self.rolling * self.arms[:, None])

    @property
    def x(self) -> Complex:
        """The X-moment of each order, N m."""
        return self.bimoment / self.length

    def noted(self, share: float = NOTED) -> list[int]:
        """The places of orders in which H or, where it is known, X exceeds a share of its greatest.

        With the share 0 they are all those that do not vanish.
        """
        h, x = np.abs(self.h), np.abs(self.x)
        kept = h > share * h.max(initial=0.0)
        if self.pitch_known:
            kept |= x > share * x.max(initial=0.0)
        return np.flatnonzero(kept).tolist()


def guide_moments(engine: Engine, cycle: Cycle) -> GuideMoments:
    """Guide-force moments of an engine with one crankshaft, gas and inertia at the cycle's speed.

    Raises MarineError for an engine with several crankshafts.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> found = guide_moments(five, cycle(five, imep="9 bar"))

    Even firing leaves of H five times that of one cylinder in order 2.5, and nothing of order 1:

    >>> one = abs(found.rolling[0])
    >>> at = {float(k): place for place, k in enumerate(found.orders)}
    >>> bool(np.isclose(abs(found.h[at[2.5]]), 5 * one[at[2.5]])), abs(found.h[at[1.0]]) == 0
    (True, np.True_)
    >>> bool(abs(found.x[at[1.0]]) > 0)
    True
    """
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        raise MarineError(
            "guide-force moments are those of one crankshaft; {engine} has several",
            engine=engine.name,
        )
    gas = piston_torque(engine, cycle)
    own = _inertia(engine, cycle.speed)
    orders = gas.orders
    if own is not None:
        kept = own.orders[own.orders <= HIGHEST + 1e-9]
        orders = spectra.distinct(np.concatenate([orders, kept]))
    rolling = -engine.sense * spectra.amplitude(spectra.selected(gas, orders))
    if own is not None:
        rolling = rolling + spectra.amplitude(spectra.selected(own, orders))
    middle = default_reference(engine).z
    return GuideMoments(
        numbers=tuple(cylinder.number for cylinder in engine.cylinders),
        orders=orders,
        rolling=rolling,
        arms=np.array([cylinder.z - middle for cylinder in engine.cylinders]),
        length=float(np.mean([cylinder.rod_length for cylinder in engine.cylinders])),
        with_inertia=own is not None,
        pitch_known="pitch" not in engine.relative,
    )


def _inertia(engine: Engine, speed: float | None) -> Spectrum | None:
    """The rolling moment of the moving parts of each cylinder, N m [cylinder, order]."""
    if speed is None or not {"mass", "radius"}.isdisjoint(engine.relative):
        return None
    result = balance(engine, speed=speed)
    rows = [
        [row for row, part in enumerate(result.parts) if part.cylinder == cylinder.number]
        for cylinder in engine.cylinders
    ]
    parts = Totals(*(getattr(result, name) for name in Totals._fields))
    each = [rolling_moment(Totals(*(spectra.total(one[own]) for one in parts))) for own in rows]
    return spectra.stacked(each)


def _without_noise(terms: Complex) -> Complex:
    """The sum over the cylinders, rounding errors set to zero."""
    noise = ROUNDING * np.abs(terms).sum(axis=0)
    found = terms.sum(axis=0)
    return np.where(np.abs(found) <= noise, 0.0, found)
