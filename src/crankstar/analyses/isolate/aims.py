"""What is to be small of mounts, as a number: at its maximum over the speeds, or its mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from crankstar.dynamics.mount_analysis import peaked
from crankstar.dynamics.mount_excitation import MountExcitation
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import MountResponse, mount_response, rms
from crankstar.dynamics.mount_worst import ROLL, roll_mode
from crankstar.dynamics.mounted_block import MountedBlock
from crankstar.spectra import Real

IsolationAim = Literal[
    "force", "mounts", "velocity", "rms force", "rms mounts", "rms velocity", "roll"
]
EVEN = 121
"""Speeds over which a square is integrated in the search."""
ABOUT = (-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0)
"""Speeds about a resonance at which it is integrated in the end, in its damping."""


def aimed(
    block: MountedBlock, push: MountExcitation | None, aim: IsolationAim, point: Sequence[float]
) -> float:
    """What is minimised, of a block that is shaken so: N, m/s or a share; `push` None for roll.

    The maximum between the speeds of `push` too, as `mounts` finds it; the mean over their range.
    """
    if push is None or push.speeds.size == 1:
        speeds = np.array([]) if push is None else push.speeds
        return float(course(block, push, aim, point, speeds)[0])
    modes = mount_modes(block)
    if not aim.startswith("rms"):

        def curve(own: MountResponse) -> Real:
            return _sizes(own, aim, point)[:, None]

        return float(curve(peaked(block, modes, push, curve)).max())
    speeds = np.union1d(push.speeds, np.linspace(push.speeds[0], push.speeds[-1], EVEN))
    if all(mode.damping > 0 for mode in modes):
        at = np.array([each.speed * (1 + n * each.damping) for each in modes for n in ABOUT])
        met = np.divide.outer(at, push.orders).ravel()
        speeds = np.union1d(speeds, met[(speeds[0] < met) & (met < speeds[-1])])
    return mean(course(block, push, aim, point, speeds), speeds)


def course(
    block: MountedBlock,
    push: MountExcitation | None,
    aim: IsolationAim,
    point: Sequence[float],
    speeds: Real,
) -> Real:
    """The rms of force or velocity at each of the speeds; of decoupling, what is not roll."""
    if push is None:
        modes = mount_modes(block)
        energy = np.abs(modes[roll_mode(modes)].energy)
        return np.array([float(energy.sum() - energy[ROLL])])
    own = push.between(speeds) if push.speeds.size > 1 else push
    return _sizes(mount_response(block, own), aim, point)


def _sizes(own: MountResponse, aim: IsolationAim, point: Sequence[float]) -> Real:
    """What is to be small of a response, at each of its speeds."""
    if aim.endswith("force"):
        return rms(own.ground_force[..., :3])
    if aim.endswith("mounts"):
        each = own.mount_force[:, :, : own.block.of_block]
        return rms(each.reshape(*each.shape[:2], -1))
    return rms(own.velocity(point))


def mean(sizes: Real, speeds: Real) -> float:
    """The root mean square over a range: squares integrated straight from speed to speed."""
    if speeds.size < 2:
        return float(sizes[0])
    squares = (sizes[1:] ** 2 + sizes[:-1] ** 2) / 2
    return float(np.sqrt(np.sum(squares * np.diff(speeds)) / (speeds[-1] - speeds[0])))


def of_effect(push: MountExcitation) -> MountExcitation:
    """What shakes it, without the orders that do nothing."""
    there = np.abs(push.push).max(axis=(0, 2)) > 0
    return replace(
        push, orders=push.orders[there], inertia=push.inertia[there], gas=push.gas[:, there]
    )
