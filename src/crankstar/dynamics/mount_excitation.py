"""What shakes a block on its mounts: force, couple and rolling moment on its six freedoms by order.

    Q(theta) = sum Re((gas_k + w^2 inertia_k) exp(i k theta))       N, N m, about the centre of mass

of the freedoms (up, right, z, yaw, pitch, roll): the inertia force has no part along z; M_H is on
yaw, M_V on pitch; the rolling moment is that of inertia and of gas, minus the torque in the sense
of rotation, which the rotor takes (`gas_torque`), wherever the load stands. The mean torque,
which leans the block on its mounts and does not shake it, is left out; so is what the driveline
itself does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crankstar import spectra
from crankstar.dynamics.mounted_block import SIX, MountedBlock
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.excitation import Reference, Totals, part_spectra, rolling_moment, total
from crankstar.mechanics.gas_loads import gas_over_speeds
from crankstar.mechanics.gas_torque import HIGHEST, gas_roll
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Complex, Real, Spectrum


@dataclass(frozen=True)
class MountExcitation:
    """Orders, the inertia of the moving parts at 1 rad/s [order, 6], the gas [speed, order, 6].

    `without_gas` says why there is none.
    """

    speeds: Real
    orders: Real
    inertia: Complex
    gas: Complex
    without_gas: str = ""

    @property
    def push(self) -> Complex:
        """The whole on the six freedoms, N and N m [speed, order, 6]."""
        return self.gas + self.speeds[:, None, None] ** 2 * self.inertia

    def between(self, speeds: Real) -> MountExcitation:
        """The same at other speeds, where gas goes straight from each speed to the next.

        >>> gas = np.array([0j, 2.0])[:, None, None] * np.ones((1, 1, 6))
        >>> own = MountExcitation(np.array([1.0, 3.0]), np.ones(1), np.zeros((1, 6)), gas)
        >>> own.between(np.array([1.5])).gas[0, 0, :2].real.tolist()
        [0.5, 0.5]
        """
        after = np.clip(np.searchsorted(self.speeds, speeds), 1, self.speeds.size - 1)
        low, high = self.speeds[after - 1], self.speeds[after]
        share = ((speeds - low) / (high - low))[:, None, None]
        gas = (1 - share) * self.gas[after - 1] + share * self.gas[after]
        return replace(self, speeds=speeds, gas=gas)


def mount_excitation(
    block: MountedBlock,
    engine: Engine,
    *,
    speeds: Real,
    point: str = "",
    orders: Sequence[float] | None = None,
) -> MountExcitation:
    """Inertia and gas at crank speeds (rad/s); all orders up to 24 of both unless some are given.

    Of a named operating point, else as `gas_over_speeds` has it. Raises GasError for a point that
    the engine has not.

    >>> from crankstar.dynamics.mounted_block import mounted_block
    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> mounts = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> five = load("audi-25-tfsi", changes={"mounts": mounts, "block": {"mass": "150 kg"}})
    >>> found = mount_excitation(mounted_block(five), five, speeds=np.array([100.0]))
    >>> second = abs(found.inertia[found.orders == 2][0]).round(6)
    >>> bool(second[4] > 0), second[:4].tolist()  # a five rocks, and does nothing else
    (True, [0.0, 0.0, 0.0, 0.0])
    """
    found, why = _gas(engine, speeds, point)
    sums = _sums(block, engine, orders)
    own = sums.force.orders[sums.force.orders <= HIGHEST + 1e-9]
    if orders is not None:
        wanted = np.array(sorted({*map(float, orders)}))
    elif found is None:
        wanted = own
    else:
        wanted = spectra.distinct(np.concatenate([own, found.orders]))
    gas = np.zeros((speeds.size, wanted.size, SIX), complex)
    if found is not None:
        roll = gas_roll(spectra.selected(found, wanted), sums.force.sense)
        gas[..., 5] = spectra.amplitude(roll)
    return MountExcitation(speeds, wanted, on_freedoms(sums, wanted), gas, why)


def _sums(block: MountedBlock, engine: Engine, orders: Sequence[float] | None) -> Totals:
    """The sums of the moving parts about the centre of mass."""
    up, right, z = block.body.centre
    return total(part_spectra(mechanism(engine), reference=Reference(z, up, right), orders=orders))


def on_freedoms(sums: Totals, wanted: Real) -> Complex:
    """The inertia forces on the six freedoms at 1 rad/s [order, 6]."""
    force, couple, roll = (
        spectra.selected(each, wanted) for each in (sums.force, sums.couple, rolling_moment(sums))
    )
    none = np.zeros(wanted.size)
    return np.stack(
        [
            spectra.vertical(force),
            spectra.horizontal(force),
            none,
            spectra.horizontal(couple),
            spectra.vertical(couple),
            spectra.amplitude(roll),
        ],
        axis=-1,
    )


def _gas(engine: Engine, speeds: Real, point: str) -> tuple[Spectrum | None, str]:
    """The gas torque over the speeds, or why there is none."""
    if engine.gas is None and not point:
        return None, _("the engine file has no table [gas]")
    try:
        return gas_over_speeds(engine, speeds, point=point), ""
    except GasError as error:
        if point:
            raise
        return None, str(error)
