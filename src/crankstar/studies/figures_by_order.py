"""Figures of an answer by order: force, couple, rolling moment and torque, and their units."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from crankstar import spectra
from crankstar.analysis.tried_values import Figure
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.remains import MINOR, USUAL_ORDERS, pushed, sizes, summed
from crankstar.spectra import Spectrum


def inertia_sizes(
    engine: Engine,
    speed: float | None,
    reference: Reference | None = None,
    highest: float = USUAL_ORDERS,
) -> dict[Figure, float]:
    """Force, couple and rolling moment by order, at `speed` (rad/s) or the engine's.

    >>> from crankstar.files.catalog import load
    >>> round(inertia_sizes(load("audi-25-tfsi"), None)["couple", 2.0])
    1534
    """
    own = engine.speed if speed is None else speed
    sums = summed(balance(engine, speed=own, reference=reference))
    found: dict[Figure, float] = {}
    for name in ("force", "couple", "roll"):
        spectrum = getattr(sums, name)
        for order, size in zip(spectrum.orders.tolist(), sizes(spectrum).tolist(), strict=True):
            if order <= highest:
                found[name, order] = size
    return found


def components(engine: Engine, speed: float | None) -> dict[Figure, float]:
    """Force and couple by order, up and across, as a frame has them.

    >>> from crankstar.files.catalog import load
    >>> round(components(load("audi-25-tfsi"), 680.68)["vertical couple", 2.0])
    1534
    """
    sums = summed(balance(engine, speed=speed))
    ways = {"vertical": spectra.vertical, "horizontal": spectra.horizontal}
    return {
        (f"{way} {name}", order): size
        for name in ("force", "couple")
        for way, component in ways.items()
        for order, size in zip(
            getattr(sums, name).orders.tolist(),
            np.abs(component(getattr(sums, name))).tolist(),
            strict=True,
        )
        if order <= USUAL_ORDERS
    }


def least_pushed(
    engine: Engine, speed: float | None, reference: Reference | None = None
) -> Mapping[str, float]:
    """A small share of what all parts push together: what is hardly there does not lead.

    >>> from crankstar.files.catalog import load
    >>> sorted(least_pushed(load("i4"), None))
    ['couple', 'force']
    """
    own = engine.speed if speed is None else speed
    result = balance(engine, speed=own, reference=reference)
    return {
        name: MINOR * float(pushed(getattr(result, name)).max(initial=0.0))
        for name in ("force", "couple")
    }


def inertia_unit(speed: float | None, quantity: str, engine: Engine) -> str:
    """The unit of a force, a couple, or a moment.

    >>> from crankstar.files.catalog import load
    >>> inertia_unit(None, "vertical force", load("i4")), inertia_unit(300.0, "roll", load("i4"))
    ('m*r*w^2', 'm*r^2*w^2')
    """
    units = balance(engine, speed=engine.speed if speed is None else speed).units
    kind = quantity.rpartition(" ")[2]  # of vertical force too
    return {"force": units.force, "couple": units.couple}.get(kind, units.moment)


def by_order(name: str, signal: Spectrum) -> dict[Figure, float]:
    """The amplitudes of a real signal up to twice the usual orders.

    >>> wave = spectra.real_signal(np.array([2.0]), np.array([3.0 + 4.0j]))
    >>> by_order("torque", wave)
    {('torque', 2.0): 5.0}
    """
    waves = np.abs(spectra.amplitude(signal))
    return {
        (name, order): size
        for order, size in zip(signal.orders.tolist(), waves.tolist(), strict=True)
        if 0 < order <= 2 * USUAL_ORDERS
    }


def rolls_of(
    name: str, engine: Engine, found: Cycle, *, one_frame: bool = False
) -> dict[Figure, float]:
    """The rolling moment of gas and inertia by order; of `one_frame` with the driven machine.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> five = load("audi-25-tfsi")
    >>> round(rolls_of("roll", five, cycle(five))["roll", 2.5], -1)
    560.0
    """
    from crankstar.dynamics.load_reaction import on_one_frame
    from crankstar.studies.gas_results import roll_of

    roll = roll_of(engine, found)
    return by_order(name, on_one_frame(roll, engine, found) if one_frame else roll)
