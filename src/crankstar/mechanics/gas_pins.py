"""What gas puts on crank pins and cylinder walls, order by order.

Gas pushes a piston inward along its cylinder axis a with (p - p_0) A, and the head outward with as
much. Piston, rod and wall are in equilibrium as in `pin_loads`, by the same equations: the wall is
pushed sideways by G, and the crank pin gets the rest,

    S = -(p - p_0) A a - G                              N

so that head, wall and pin together feel nothing: gas makes no force on the block, but bends the
crankshaft between its main bearings. Over a cycle the loads are sums of its orders, halves for a
four-stroke engine.

Source: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, gas forces of the
slider-crank.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.kinetic import samples_over
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import PinLoads
from crankstar.mechanics.side_thrust import gas_guides, gas_push
from crankstar.spectra import Complex, Real, Spectrum

HIGHEST = 96.0
"""The highest order of gas loads that is kept."""
SAMPLES = 1440
"""Of a cycle: seven for each wave of the highest order of a four-stroke engine."""


def gas_pin_loads(engine: Engine, cycle: Cycle) -> PinLoads:
    """Guide forces and pin loads of gas alone [cylinder, order], N; order 0 is steady.

    The pin load of a slave rod is what it adds to the pin of its master, as in `pin_loads`.

    A piston that fires pushes its pin down, where the cylinder stands up:

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("audi-25-tfsi")
    >>> pin = gas_pin_loads(engine, cycle(engine, imep=9e5)).pin
    >>> bool(spectra.value(pin, 0.2)[0].real < -20e3)
    True
    """
    theta = samples_over(engine, SAMPLES)
    turned = np.exp(1j * np.asarray(mechanism(engine).bearing))[:, None]
    guide = gas_guides(engine, cycle, theta) * turned
    pin = -gas_push(engine, cycle, theta) * _axes(engine) - guide
    return PinLoads(_spectrum(engine, guide), _spectrum(engine, pin))


def head_forces(engine: Engine, cycle: Cycle) -> Spectrum:
    """What gas pushes each cylinder head with, outward [cylinder, order], N."""
    theta = samples_over(engine, SAMPLES)
    return _spectrum(engine, gas_push(engine, cycle, theta) * _axes(engine))


def _axes(engine: Engine) -> Complex:
    """The unit vector of each cylinder's axis, outward [cylinder, 1]."""
    return np.exp(1j * np.array([cylinder.bearing for cylinder in engine.cylinders]))[:, None]


def with_gas(loads: PinLoads, gas: PinLoads, *, speed: float) -> PinLoads:
    """Loads of inertia at 1 rad/s and of gas (N), as loads at 1 rad/s that are right at `speed`.

    Scaled with the square of the speed as inertia is, they are N at that speed and at no other.
    """
    return PinLoads(
        *(
            _sum(one, spectra.scaled(other, speed**-2))
            for one, other in zip(loads, gas, strict=True)
        )
    )


def _sum(one: Spectrum, other: Spectrum) -> Spectrum:
    """The sum of two spectra over the orders of both."""
    orders = spectra.distinct(np.concatenate([one.orders, other.orders]))
    parts = [
        replace(spectra.selected(replace(each, complete=True), orders), orders=orders)
        for each in (one, other)
    ]
    return replace(
        parts[0],
        forward=parts[0].forward + parts[1].forward,
        backward=parts[0].backward + parts[1].backward,
    )


def _spectrum(engine: Engine, values: Complex | Real) -> Spectrum:
    """The spectrum of vectors [cylinder, sample] over a cycle, up to HIGHEST."""
    count = values.shape[-1]
    lines = np.fft.fft(values, axis=-1) / count
    turns = engine.cycle_angle / 360
    number = np.arange(1, int(HIGHEST * turns) + 1)
    ahead, behind = lines[..., number], lines[..., -number]
    if engine.sense < 0:
        ahead, behind = behind, ahead
    still, none = lines[..., :1], np.zeros_like(lines[..., :1])
    return Spectrum(
        np.append(0.0, number / turns),
        np.concatenate([still, ahead], axis=-1),
        np.concatenate([none, behind], axis=-1),
        engine.sense,
    )
