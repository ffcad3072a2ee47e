"""How a block on its mounts shakes: motion of its points, force in the mounts and on the ground.

With q(k w) the steady answer of `mounted_block` to the force Q of order k at the crank speed w:

    displacement of a point = T q        velocity = i k w T q           T of engine.rigid_block
    force in a mount, along its axes = (k_s (1 + i eta) + i k w c) B q
    force on the ground = sum of T' A' of the forces in the mounts that stand on it

rms over a cycle: sqrt(sum of |a|^2 / 2) over orders and axes; the peak is the greatest length at
at least `ANGLES` angles of it, all orders with their phases. The transmissibility of a mount is the
rms force in it over that which the same forces would give if they changed so slowly that the block
had no inertia; of one mass on one spring it is the usual ratio of force passed on to force put in.
A mount that would then bear almost nothing, less than `COUNTS` of what another bears at that speed,
has none: of it the ratio is nearly 0/0, and says nothing of how well the block is isolated. Each
speed is measured by itself, as what shakes it without gas grows with the square of the speed, and
the resonances that the ratio is wanted for are slow.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from crankstar import spectra
from crankstar.dynamics.hand_arm import hand_arm_weighting
from crankstar.dynamics.mount_excitation import MountExcitation
from crankstar.dynamics.mounted_block import SIX, MountedBlock, MountError, dynamic_stiffness
from crankstar.engine.rigid_block import held, moved
from crankstar.spectra import Complex, Real

ANGLES = 360
"""Angles of a cycle at which peaks are looked for, at least."""
AT_ONCE = 16384
"""Frequencies that are solved together, to bound memory."""
OF_A_WAVE = 12
"""Angles of a period of the highest order."""
COUNTS = 0.01
"""Share of the greatest force of all mounts without inertia from which a ratio to one counts."""


@dataclass(frozen=True)
class MountResponse:
    """The steady vibration: `motion` of the freedoms [speed, order, freedom], m and rad."""

    block: MountedBlock
    excitation: MountExcitation
    motion: Complex

    @property
    def speeds(self) -> Real:
        """Crank speeds, rad/s."""
        return self.excitation.speeds

    @property
    def orders(self) -> Real:
        """Crank orders."""
        return self.excitation.orders

    @property
    def vibration(self) -> Real:
        """Angular frequency of each order at each speed, rad/s."""
        return np.multiply.outer(self.speeds, self.orders)

    def displacement(self, point: Sequence[float], *, of: int = 0) -> Complex:
        """Of a point (up, right, z) of the block, m [speed, order, axis].

        `of` is 0 for the block, 1 for the foundation, which has the freedoms of its own.
        """
        own = self.motion[..., of * SIX : (of + 1) * SIX]
        return own @ moved(np.asarray(point, float) - self.block.centres[of]).T

    def velocity(self, point: Sequence[float], *, of: int = 0) -> Complex:
        """Of such a point, m/s [speed, order, axis]."""
        return 1j * self.vibration[..., None] * self.displacement(point, of=of)

    def acceleration(self, point: Sequence[float], *, of: int = 0) -> Complex:
        """Of such a point, m/s^2 [speed, order, axis]."""
        return -(self.vibration[..., None] ** 2) * self.displacement(point, of=of)

    def hand_arm(self, point: Sequence[float], *, of: int = 0) -> Complex:
        """The acceleration of such a point weighted for the hand, m/s^2 [speed, order, axis]."""
        weights = hand_arm_weighting(self.vibration)[..., None]
        return weights * self.acceleration(point, of=of)

    @cached_property
    def deflection(self) -> Complex:
        """Of each mount along its axes, m [speed, order, mount, axis]."""
        return self.block.yielding(self.vibration) * _along(self.block, self.motion)

    @cached_property
    def mount_force(self) -> Complex:
        """In each mount along its axes, N [speed, order, mount, axis]."""
        return self.block.rate(self.vibration) * self.deflection

    @cached_property
    def ground_force(self) -> Complex:
        """Force and moment about G on the ground, as on the freedoms [speed, order, 6]."""
        block = self.block
        standing = block.mounts[block.to_ground]
        arms = held(standing, centre=block.centres[0])
        flat = self.mount_force[:, :, block.to_ground].reshape(*self.motion.shape[:2], -1)
        return flat @ arms.reshape(-1, SIX)

    @cached_property
    def transmissibility(self) -> Real:
        """Of each mount of the block [speed, mount]; nan where it would bear less than `COUNTS`."""
        block = self.block
        bearing = (block.arms * block.along[..., None]).reshape(-1, block.freedoms)
        share = np.linalg.solve(block.stiffness, bearing.T)[:SIX]
        still = (self.excitation.push @ share).reshape(self.mount_force.shape)
        own = slice(block.of_block)
        least = np.sqrt((np.abs(still) ** 2).sum(axis=(1, 3)))[:, own]
        force = np.sqrt((np.abs(self.mount_force) ** 2).sum(axis=(1, 3)))[:, own]
        with np.errstate(invalid="ignore", divide="ignore"):
            counts = least >= COUNTS * least.max(axis=-1, keepdims=True)
            return np.where(counts & (least > 0), force / least, np.nan)

    @property
    def power(self) -> Real:
        """The power that the forces put in, W [speed]."""
        rate = 1j * self.vibration[..., None] * self.motion[..., :SIX]
        return np.real(self.excitation.push * np.conj(rate)).sum(axis=(1, 2)) / 2

    @property
    def heat(self) -> Real:
        """The power that each mount turns into heat, W [speed, mount]."""
        rate = 1j * self.vibration[..., None, None] * self.deflection
        return np.real(self.mount_force * np.conj(rate)).sum(axis=(1, 3)) / 2


def mount_response(block: MountedBlock, excitation: MountExcitation) -> MountResponse:
    """The steady vibration of a block at the speeds and orders of what shakes it.

    Raises MountError where mounts without damping meet their resonance to the last digit.

    One force up on four mounts in the plane of the centre of mass is one mass on one spring:

    >>> from crankstar.dynamics.mounted_block import mounted_block
    >>> from crankstar.files.catalog import load
    >>> at = [(r, z) for r in ("-0.3 m", "0.3 m") for z in ("-0.2 m", "0.2 m")]
    >>> rubber = {"stiffness": "100 N/mm", "loss_factor": 0}
    >>> mounts = [{"name": f"{r} {z}", "right": r, "z": z, **rubber} for r, z in at]
    >>> own = {"mounts": mounts, "block": {"mass": "160 kg", "z": "0 m"}}
    >>> up = np.array([[1.0, 0, 0, 0, 0, 0]])
    >>> push = MountExcitation(np.array([100.0]), np.array([1.0]), up, np.zeros((1, 1, 6)))
    >>> found = mount_response(mounted_block(load("audi-25-tfsi", changes=own)), push)
    >>> found.transmissibility.round(9).tolist()  # 1/((100/50)^2 - 1)
    [[0.333333333, 0.333333333, 0.333333333, 0.333333333]]
    """
    push = _padded(block, excitation.push)
    forces = push.reshape(-1, block.freedoms, 1)
    frequencies = np.multiply.outer(excitation.speeds, excitation.orders).ravel()
    motion = np.empty_like(forces)
    for first in range(0, frequencies.size, AT_ONCE):
        some = slice(first, first + AT_ONCE)
        stiff = dynamic_stiffness(block, frequencies=frequencies[some])
        try:
            motion[some] = np.linalg.solve(stiff, forces[some])
        except np.linalg.LinAlgError:
            raise MountError(
                "mounts without damping resonate without end at one of these speeds; give damping "
                "or a loss factor"
            ) from None
    return MountResponse(block, excitation, motion.reshape(push.shape))


def joined(first: MountResponse, second: MountResponse) -> MountResponse:
    """Two responses of one block, to the same inertia, as one by ascending speed."""
    own, other = first.excitation, second.excitation
    speeds = np.concatenate([own.speeds, other.speeds])
    order = np.argsort(speeds, kind="stable")
    gas = np.concatenate([own.gas, other.gas])[order]
    motion = np.concatenate([first.motion, second.motion])[order]
    return MountResponse(first.block, replace(own, speeds=speeds[order], gas=gas), motion)


def rms(amplitudes: Complex) -> Real:
    """Over a cycle, of amplitudes [speed, order, axis]: all orders and axes together [speed].

    >>> rms(np.array([[[3.0], [4.0j]]])).round(6).tolist()  # sqrt((9 + 16) / 2)
    [3.535534]
    """
    return np.sqrt((np.abs(amplitudes) ** 2).sum(axis=(1, 2)) / 2)


def peak(amplitudes: Complex, *, orders: Real) -> Real:
    """The greatest length over a cycle of a vector by its amplitudes [speed, order, axis]: [speed].

    >>> peak(np.array([[[3.0], [4.0]]]), orders=np.array([1.0, 2.0])).tolist()
    [7.0]
    """
    common = orders * spectra.period(spectra.real_signal(orders, np.zeros(orders.size)))
    count = max(ANGLES, OF_A_WAVE * round(float(common.max(initial=1.0))))
    theta = np.arange(count) * (2 * np.pi / count)
    wave = np.exp(1j * np.multiply.outer(theta, common))
    turns = np.concatenate([np.real(wave), -np.imag(wave)], axis=1)
    parts = np.concatenate([np.real(amplitudes), np.imag(amplitudes)], axis=1)
    flat = np.moveaxis(parts, 1, 0).reshape(turns.shape[1], -1)
    course = (turns @ flat).reshape(count, *amplitudes.shape[::2])
    squared = np.einsum("tsa,tsa->ts", course, course)
    most = squared.argmax(axis=0)
    before, top, after = (
        np.take_along_axis(squared, (most + step)[None] % count, axis=0)[0] for step in (-1, 0, 1)
    )
    bend = before - 2 * top + after  # the top of the parabola through the three samples
    rise = np.divide((after - before) ** 2, -8 * bend, out=np.zeros_like(top), where=bend < 0)
    return np.sqrt(top + rise)


def _padded(block: MountedBlock, push: Complex) -> Complex:
    """Forces on the six freedoms of the block as on all freedoms."""
    more = block.freedoms - push.shape[-1]
    return np.concatenate([push, np.zeros((*push.shape[:-1], more))], axis=-1).astype(complex)


def _along(block: MountedBlock, motion: Complex) -> Complex:
    """The deflection of each mount along its axes [..., mount, axis]."""
    flat = block.arms.reshape(-1, block.freedoms)
    return (motion @ flat.T).reshape(*motion.shape[:-1], *block.arms.shape[:2])
