"""Gas torque: what the pressure in the chambers does to crankshaft and block, order by order.

Work is force times way, so a chamber of pressure p, behind whose pistons p_0 stands, gives the
crankshafts

    T(theta) = (p - p_0) V'(theta)                        N m, positive in the direction of rotation

whatever carries its pistons: one crank or two, plain rods or slave rods. Over a cycle of C radians
(2 pi two-stroke, 4 pi four-stroke) its mean is imep V_d/C, and it is a sum of the orders n 2 pi/C:
halves for a four-stroke engine. V' repeats with every turn, so that p_0, which is steady, adds to
whole orders only, and nothing to the mean.

Head and pistons are pushed apart with equal forces, so that gas makes no force on the block: what
remains is a moment about the crank axis, minus the torque in the sense of rotation. That holds
wherever the load is: with a torque of the load that is steady, the rotor takes the alternating
torque, J dw/dt = T - T_L, and the block its reaction, -J dw/dt, all of it. Only the mean depends on
the load. One on its own ground leaves its reaction, -T_L, on the block; one on the same frame, as
the stator of a generating set, takes it back, and what of it alternates with it
(`dynamics.load_reaction`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.volumes import piston_rates
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.mechanics.gas import Cycle
from crankstar.spectra import Complex, Real, Spectrum

HIGHEST = 24.0
"""The highest order of gas torque that is kept."""
ALL = 360.0
"""The highest order of a peak, which is the sum of all orders."""


@dataclass(frozen=True)
class GasTorque:
    """The gas torque of every chamber: mean [chamber] and spectrum [chamber, order], N m.

    >>> from crankstar import cycle
    >>> found = gas_torque(cycle("audi-25-tfsi", imep="9 bar"))
    >>> found.numbers, found.torque.orders[:3].tolist()
    ((1, 2, 3, 4, 5), [0.5, 1.0, 1.5])
    """

    numbers: tuple[int, ...]
    mean: Real
    torque: Spectrum

    @property
    def total(self) -> Spectrum:
        """The torque of the engine, rounding errors set to zero."""
        return spectra.total(self.torque)


def gas_torque(cycle: Cycle, *, highest: float = HIGHEST) -> GasTorque:
    """The gas torque of each chamber over the angle of the reference crankshaft, up to an order.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> found = gas_torque(cycle(load("honda-b18c"), imep=1e6))

    A four-stroke in-line four fires twice a turn: order 2 and its multiples remain.

    >>> kept = abs(spectra.amplitude(found.total)) > 0
    >>> found.total.orders[kept][:3].tolist()
    [2.0, 4.0, 6.0]
    """
    samples = chamber_torque(cycle)
    places = cycle.volumes
    torque = _by_order(samples, places.fires, places.cycle, highest=highest)
    return GasTorque(places.numbers, samples.mean(axis=-1), torque)


def of_one_cylinder(cycle: Cycle, orders: Sequence[float]) -> list[float]:
    """The amplitude of the first chamber's gas torque in these orders, N m."""
    found = gas_torque(cycle).torque
    first = spectra.amplitude(spectra.selected(found, orders))[0]
    return [float(each) for each in np.abs(first)]


def chamber_torque(cycle: Cycle) -> Real:
    """The torque of each chamber, N m [chamber, sample], from the dead centre at which it fires."""
    rate = cycle.volumes.rate[[*cycle.volumes.kind]]
    return (cycle.pressure - cycle.crankcase) * rate


def over_cycle(cycle: Cycle, count: int = 1440) -> Real:
    """The torque of each chamber, N m [chamber, angle], at equal steps of the crank from 0.

    The samples are moved by the firing angle as sums of harmonics, so that no angle is favoured.
    """
    places = cycle.volumes
    return _delayed(chamber_torque(cycle), places.fires * (2 * np.pi / places.cycle), count)


def crankshaft_torque(engine: Engine, cycle: Cycle, count: int = 1440) -> Real:
    """The gas torque on each shaft, N m [shaft, angle], at equal steps of the crank from 0.

    A chamber whose pistons work on several crankshafts gives each of them (p - p_0) times the share
    of its own pistons in V'. Positive in the direction in which the shaft turns.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> upper, lower = crankshaft_torque(load("jumo-205"), cycle(load("jumo-205"))).mean(axis=-1)
    >>> bool(upper > lower)  # the upper crankshaft leads
    True
    """
    samples, fires = _of_pistons(engine, cycle)
    torque = _delayed(samples, fires * (2 * np.pi / cycle.volumes.cycle), count)
    owner = [cylinder.shaft for cylinder in engine.cylinders]
    return np.array(
        [torque[[name == shaft.name for name in owner]].sum(axis=0) for shaft in engine.shafts]
    )


def _of_pistons(engine: Engine, cycle: Cycle) -> tuple[Real, Real]:
    """The torque of each piston [cylinder, sample] from where its chamber fires, and that angle."""
    places = cycle.volumes
    row = {number: index for index, number in enumerate(places.numbers)}
    chamber = [row[cylinder.chamber or cylinder.number] for cylinder in engine.cylinders]
    rates = piston_rates(engine, cycle.pressure.shape[-1])
    return (cycle.pressure[chamber] - cycle.crankcase) * rates, places.fires[chamber]


def piston_torque(engine: Engine, cycle: Cycle) -> Spectrum:
    """The gas torque of each piston on its crankshaft, N m [cylinder, order]; means apart.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("honda-b18c")
    >>> found = cycle(engine, imep=1e6)
    >>> one, all_ = gas_torque(found).torque, piston_torque(engine, found)
    >>> bool(np.allclose(one.forward, all_.forward))
    True
    """
    samples, fires = _of_pistons(engine, cycle)
    return _by_order(samples, fires, cycle.volumes.cycle)


def _by_order(samples: Real, fires: Real, cycle: float, *, highest: float = HIGHEST) -> Spectrum:
    """The orders of samples over a cycle [row, sample] that begin at the angles `fires`."""
    numbers = np.arange(1, int(highest * cycle / (2 * np.pi)) + 1)
    orders = numbers * (2 * np.pi / cycle)
    amplitude = 2 / samples.shape[-1] * np.fft.rfft(samples, axis=-1)[:, numbers]
    return spectra.real_signal(orders, amplitude * np.exp(-1j * orders * fires[:, None]))


def _delayed(samples: Real, phase: Real, count: int) -> Real:
    """Periodic samples [row, sample] later by a phase, radians of the period, at `count` steps."""
    numbers = np.arange((count + 1) // 2)  # the harmonics that so many angles tell apart
    waves = np.fft.rfft(samples, axis=-1)[:, : numbers.size]
    return np.fft.irfft(waves * np.exp(-1j * numbers * phase[:, None]), n=count, axis=-1) * (
        count / samples.shape[-1]
    )


def gas_roll(gas: Spectrum, sense: int) -> Spectrum:
    """The alternating moment of gas on the block, N m: minus its torque in the sense of rotation.

    Of an engine that drives a propeller and of a generating set alike.
    """
    return spectra.scaled(gas, -sense)


def roll_with_gas(sums: Totals, gas: Spectrum) -> Spectrum:
    """The alternating rolling moment on the block, N m, of moving parts and gas."""
    return added(rolling_moment(sums), gas_roll(gas, sums.force.sense))


def added(one: Spectrum, other: Spectrum) -> Spectrum:
    """The sum of two real signals, over the orders of both."""
    orders = spectra.distinct(np.concatenate([one.orders, other.orders]))

    def placed(spectrum: Spectrum) -> Complex:
        out = np.zeros((*spectrum.forward.shape[:-1], orders.size), complex)
        out[..., np.searchsorted(orders, spectrum.orders - 1e-9)] = spectra.amplitude(spectrum)
        return out

    return replace(
        spectra.real_signal(orders, placed(one) + placed(other)),
        complete=one.complete and other.complete,
    )


def brake_torque(cycle: Cycle) -> float | None:
    """The mean torque that gas and friction leave, N m; None where the friction is not known.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi", changes={"gas.friction_pressure": "2 bar"})
    >>> round(brake_torque(cycle(five, imep="3 bar")) / brake_torque(cycle(five, bmep="2 bar")), 9)
    0.5
    """
    lost = friction_torque(cycle)
    return None if lost is None else float(gas_torque(cycle).mean.sum()) - lost


def friction_torque(cycle: Cycle) -> float | None:
    """The mean torque that friction takes, N m; None where it is not known."""
    if cycle.friction is None:
        return None
    places = cycle.volumes
    return cycle.friction * float(places.swept[[*places.kind]].sum()) / places.cycle
