"""The worst of an engine on its mounts: where over the speeds, and of which order most."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.mount_modes import MountMode
from crankstar.dynamics.mount_response import MountResponse, rms
from crankstar.spectra import Complex

ROLL = 5
"""The place of roll among the freedoms."""


class Worst(NamedTuple):
    """The greatest rms of a vector over the speeds: its size, the speed, the order that has most.

    rad/s; SI.
    """

    size: float
    speed: float
    order: float


def roll_mode(modes: Sequence[MountMode]) -> int:
    """The place of the mode with the greatest share of its energy in the roll of the block."""
    return int(np.argmax([mode.energy[ROLL] for mode in modes]))


def worst(over: MountResponse, amplitudes: Complex) -> Worst:
    """Of amplitudes [speed, order, axis] of a response.

    >>> from types import SimpleNamespace
    >>> own = SimpleNamespace(speeds=np.array([10.0, 20.0]), orders=np.array([1.0, 2.0]))
    >>> worst(own, np.array([[[1.0], [0.0]], [[3.0], [4.0]]]))._asdict()
    {'size': 3.5355339059327378, 'speed': 20.0, 'order': 2.0}
    """
    sizes = rms(amplitudes)
    place = int(np.argmax(sizes))
    strongest = int(np.argmax((np.abs(amplitudes[place]) ** 2).sum(axis=-1)))
    return Worst(float(sizes[place]), float(over.speeds[place]), float(over.orders[strongest]))
