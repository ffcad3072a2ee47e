"""The orders of the exhaust: equal pulses at the firings of each bank or manifold.

Each chamber gives its common exhaust one pulse a cycle, all of the same shape, at its firing angle
theta_j and so many degrees later. The pulses of a group repeat with the cycle, so they consist of
the orders q = n/2 of a four-stroke and q = n of a two-stroke engine, n = 1, 2, ..., and order q is
that of one pulse times

    S_q = sum over j of exp(-i q theta_j)

|S_q| is at most the number of chambers; it is that number at the firing order of even intervals and
its multiples. The opening of the exhaust comes a constant angle after the firing where all chambers
have the same events, which turns S_q and leaves |S_q|.

No strength of the pulses is in it, no wave in a pipe, and no difference between chambers.

Source: J. P. Den Hartog, Mechanical Vibrations, chapter 5 (the star diagrams of the orders of an
engine's torque are the same sums).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.strokes import ExhaustGroup, exhaust_groups
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import N_, MessageError
from crankstar.spectra import Complex, Real, Spectrum

USUAL_HIGHEST = 8.0
"""The highest order unless another is asked for."""
GREATEST = 1000.0
"""The highest order that can be asked for."""
NO_ORDER = N_(
    "the highest order of the exhaust is {order}; give a number above 0 and at most {greatest}"
)


@dataclass(frozen=True)
class ExhaustOrders:
    """Sums of unit pulses by order: `orders` [n] ascending, `sums` [group, n], `whole` [n].

    Orders count turns of the reference crankshaft; sums are pulses, complex, a pure number. `whole`
    is the sum over all groups, as if all pipes ended in one.
    """

    orders: Real
    groups: tuple[ExhaustGroup, ...]
    sums: Complex
    whole: Complex


def exhaust_orders(engine: Engine, *, highest: float = USUAL_HIGHEST) -> ExhaustOrders:
    """S_q of every exhaust group and of the engine, q up to `highest` (turns of the crank).

    What is only rounding error is exactly zero. Raises EngineError without a firing order, and
    MessageError where `highest` is no order.

    A bank of a cross-plane V8 fires at 0, 180, 450 and 630 deg from one of its firings: it has
    2 sqrt(2) sin(22.5 deg) of order 0.5, 2 sqrt(2) cos(22.5 deg) of 1.5 and 2.5, and no order 2.

    >>> from crankstar.files.catalog import load
    >>> found = exhaust_orders(load("v8-cross-plane"), highest=4)
    >>> found.orders.tolist()
    [0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0]
    >>> abs(found.sums[0]).round(4).tolist()
    [1.0824, 0.0, 2.6131, 0.0, 2.6131, 0.0, 1.0824, 4.0]
    >>> abs(found.whole).round(4).tolist()
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 8.0]
    """
    fired = checked(engine, highest=highest)
    count = int(highest * fired.cycle_deg / 360 + 1e-9)
    harmonics = np.arange(1, count + 1)
    parts = np.array(fired.angles_deg) / fired.cycle_deg % 1.0
    # whole cycles are left out before the exponential, which would lose their digits
    pulses = np.exp(-2j * np.pi * (np.outer(parts, harmonics) % 1.0))
    groups = exhaust_groups(engine)
    orders = harmonics * (360 / fired.cycle_deg)
    rows = [[fired.order.index(number) for number in group.chambers] for group in groups]
    sums = [_sum(orders, pulses[places]) for places in rows]
    return ExhaustOrders(orders, groups, np.array(sums), _sum(orders, pulses))


def firing_rate(engine: Engine) -> float:
    """Firings in a revolution of the crankshaft: the main order of an engine that fires evenly.

    >>> from crankstar.files.catalog import load
    >>> firing_rate(load("v12-60")), firing_rate(load("radial-9"))
    (6.0, 4.5)
    """
    return len(engine.chambers) * 360 / engine.cycle_angle


def checked(engine: Engine, *, highest: float) -> Firing:
    """The firings of an engine that has some; raises as `exhaust_orders`."""
    if not 0 < highest <= GREATEST:
        raise MessageError(NO_ORDER, order=f"{highest:g}", greatest=f"{GREATEST:g}")
    if not engine.firing_order:
        raise EngineError([Fault(("firing_order",), "strokes.no-firing-order")])
    return firing(engine)


def _sum(orders: Real, pulses: Complex) -> Complex:
    """The sum over chambers [chamber, n], rounding set to zero."""
    return spectra.total(Spectrum(orders, pulses, np.zeros_like(pulses))).forward
