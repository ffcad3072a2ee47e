"""The exhaust's pulses with the pressure of the cycle, by order, for each bank or manifold.

While the exhaust of a chamber is open, what drives gas out is its pressure above that of the
exhaust, through an opening that grows and shrinks. The pulse is taken as

    u(phi) = (p(phi) - p_e) sin^2(pi (phi - phi_o)/(phi_c - phi_o))      Pa

from the opening phi_o to the closing phi_c of the exhaust, angles from the dead centre at which
the chamber fires, and nought elsewhere; the sine squared is the lift of a valve. A group has of
order q

    U_q = sum over its chambers j of u_q,j exp(-i q theta_j)             Pa

with u_q,j the amplitude of one pulse. Where all chambers are alike, U_q = u_q S_q, with S_q the sum
of unit pulses of `firing.exhaust_orders`: what vanishes there vanishes here.

Only the ratios of orders have a meaning: flow, temperature and waves in the pipe are left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.valves import timing
from crankstar.firing.strokes import ExhaustGroup, exhaust_groups
from crankstar.mechanics.charge_air import events
from crankstar.mechanics.gas import Cycle
from crankstar.spectra import Complex, Real, Spectrum


@dataclass(frozen=True)
class ExhaustPulses:
    """Pulses by order: `orders` [n], `sums` [group, n] in Pa, `whole` [n] of all groups."""

    orders: Real
    groups: tuple[ExhaustGroup, ...]
    sums: Complex
    whole: Complex


def exhaust_pulses(engine: Engine, cycle: Cycle, *, highest: float) -> ExhaustPulses:
    """The pulses of every exhaust group, orders up to `highest` (turns of the crank).

    A bank of a cross-plane V8 has no order 2, and the half orders fall as those of one pulse:

    >>> from crankstar import cycle, load
    >>> engine = load("gm-l76")
    >>> found = exhaust_pulses(engine, cycle(engine, imep="9 bar"), highest=4)
    >>> size = abs(found.sums[0]).round(-1)
    >>> [order for order, each in zip(found.orders.tolist(), size) if not each]
    [1.0, 2.0, 3.0]
    """
    places = cycle.volumes
    count = cycle.pressure.shape[-1]
    harmonics = np.arange(1, int(highest * places.cycle / (2 * np.pi) + 1e-9) + 1)
    orders = harmonics * (2 * np.pi / places.cycle)
    single = 2 / count * np.fft.rfft(_pulses(engine, cycle), axis=-1)[:, harmonics]
    turned = single * np.exp(-1j * orders * places.fires[:, None])
    groups = exhaust_groups(engine)
    rows = [[places.numbers.index(number) for number in group.chambers] for group in groups]
    return ExhaustPulses(
        orders, groups, np.array([_sum(orders, turned[own]) for own in rows]), _sum(orders, turned)
    )


def _pulses(engine: Engine, cycle: Cycle) -> Real:
    """The pulse of every chamber, Pa [chamber, sample], from the dead centre at which it fires."""
    places = cycle.volumes
    count = cycle.pressure.shape[-1]
    angle = np.arange(count) * (places.cycle / count)
    out = np.zeros_like(cycle.pressure)
    opening = timing(engine.valves, cycle=engine.cycle)
    for row, kind in enumerate(places.kind):
        happens = events(engine, float(places.bottom[kind]))
        bottom = happens.opened + opening.exhaust_opens
        closed = (2 * np.pi if engine.cycle == "four-stroke" else bottom) + opening.exhaust_closes
        span = closed - happens.opened
        after = (angle - happens.opened) % places.cycle
        lift = np.where(after < span, np.sin(np.pi * after / span) ** 2, 0.0)
        out[row] = (cycle.pressure[row] - cycle.values["exhaust_pressure"]) * lift
    return out


def _sum(orders: Real, pulses: Complex) -> Complex:
    """The sum over chambers [chamber, n], rounding set to zero."""
    return spectra.total(Spectrum(orders, pulses, np.zeros_like(pulses))).forward
