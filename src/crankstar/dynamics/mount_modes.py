"""The natural modes of a block on its mounts, its torque-roll axis and its elastic axis.

    K(w) a = w^2 M a                 a' M a = 1

share of a freedom in the kinetic energy of a mode: e_i = a_i (M a)_i, which add up to 1; a mode is
called decoupled in a freedom that has most of it. Of mounts that stiffen, each mode is that of the
stiffness at its own frequency. With damping small, that of a mode is
zeta = a' (w C + K'') a / (2 w^2), K'' the imaginary part of K.

The torque-roll axis is the line through G about which a moment about the crankshaft turns the free
block: the turn is J^-1 e, J the moments and products of inertia, e along the crankshaft. The
elastic axis is that about which the same moment, standing still, turns the block on its mounts: the
screw axis of K^-1 (0, 0, 0, 0, 0, 1). Roll is decoupled where both are one.
Source: T. Jeong and R. Singh, Analytical methods of decoupling the automotive engine torque roll
axis, Journal of Sound and Vibration 234 (2000) 85-114, for both terms.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.mounted_block import SIX, MountedBlock
from crankstar.engine.rigid_block import gathered
from crankstar.spectra import Real

STIFFEST = 1.01
"""Above the highest frequency that the greatest stiffening could give: where a mode is sought."""


ROUNDING = 1e-12
"""Metres, or of a unit direction or shape: rounding error."""


class MountMode(NamedTuple):
    """A natural mode: rad/s, shape with a' M a = 1, shares of energy, damping ratio."""

    speed: float
    shape: Real
    energy: Real
    damping: float

    @property
    def frequency(self) -> float:
        """In hertz."""
        return self.speed / (2 * np.pi)


class Axis(NamedTuple):
    """A line in the block: a point of it (up, right, z), its unit direction, the advance per turn.

    `point` is in the frame of the engine; `advance` (m/rad) is nought where the block turns alone.
    """

    point: Real
    direction: Real
    advance: float

    @property
    def from_crank(self) -> float:
        """The angle between it and the crankshaft, radians."""
        return float(np.arccos(min(1.0, abs(float(self.direction[2])))))


def mount_modes(block: MountedBlock) -> tuple[MountMode, ...]:
    """The modes from low to high.

    Four alike mounts in the plane of the centre of mass: the block bounces as one mass on 4 k.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.dynamics.mounted_block import mounted_block
    >>> at = [(r, z) for r in ("-0.3 m", "0.3 m") for z in ("-0.2 m", "0.2 m")]
    >>> rubber = ["100 N/mm", "40 N/mm", "40 N/mm"]
    >>> mounts = [{"name": r + z, "right": r, "z": z, "stiffness": rubber} for r, z in at]
    >>> own = {"mounts": mounts, "block": {"mass": "160 kg", "z": "0 m"}}
    >>> modes = mount_modes(mounted_block(load("audi-25-tfsi", changes=own)))
    >>> [round(each.speed, 9) for each in modes if each.energy[0] > 0.99]
    [50.0]
    """
    from scipy.linalg import eigh  # late: it takes longer to load than all figures

    plain = eigh(block.stiffness, block.mass)
    return tuple(_mode(block, plain, index) for index in range(block.freedoms))


def _mode(block: MountedBlock, plain: tuple[Real, Real], index: int) -> MountMode:
    values, shapes = plain
    speed, shape = float(np.sqrt(max(values[index], 0.0))), shapes[:, index]
    if block.stiffens:
        greatest = max(1.0, *(s.factor for each in block.mounts for s in each.rubber))
        top = STIFFEST * np.sqrt(greatest) * float(np.sqrt(max(values[index], 0.0)))
        speed = _crossing(lambda w: float(_at(block, w)[0][index]) - w, top=top)
        shape = _at(block, speed)[1][:, index]
    size = np.sqrt(shape**2 * np.diag(block.mass))
    shape = np.where(size < ROUNDING * size.max(), 0.0, shape)
    shape = shape * np.sign(shape[np.argmax(shape * (block.mass @ shape))])
    energy = shape * (block.mass @ shape)
    lost = gathered(block.arms, values=block.along * np.imag(block.lossy(speed))[:, None])
    zeta = float(shape @ (lost + speed * block.damping) @ shape) / (2 * speed**2) if speed else 0.0
    return MountMode(speed, shape, energy, zeta)


def _crossing(gap: Callable[[float], float], *, top: float) -> float:
    """Where a mode that moves with the stiffness meets the frequency of that stiffness."""
    from scipy.optimize import brentq  # late, as above

    return float(brentq(gap, 0.0, top, xtol=1e-12 * top))  # pyright: ignore[reportArgumentType]


def _at(block: MountedBlock, speed: float) -> tuple[Real, Real]:
    """The modes of the stiffness that the mounts have at a frequency (rad/s)."""
    from scipy.linalg import eigh  # late, as above

    along = block.along * block.stiffening(speed)[:, None]
    values, shapes = eigh(gathered(block.arms, values=along), block.mass)
    return np.sqrt(np.maximum(values, 0.0)), shapes


def torque_roll_axis(block: MountedBlock) -> Axis:
    """The axis through G about which a moment about the crankshaft turns the free block.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.dynamics.mounted_block import mounted_block
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> mounts = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> about = {"inertia_up": "8 kg*m^2", "inertia_right": "9 kg*m^2", "inertia_z": "4 kg*m^2"}
    >>> whole = {"mass": "150 kg", "product_up_z": "1 kg*m^2", **about}
    >>> five = load("audi-25-tfsi", changes={"mounts": mounts, "block": whole})
    >>> torque_roll_axis(mounted_block(five)).direction.round(3).tolist()  # rises to the front
    [0.124, 0.0, 0.992]
    """
    turn = np.linalg.solve(block.mass[3:SIX, 3:SIX], [0.0, 0.0, 1.0])
    way = _vector(turn)
    return Axis(block.centres[0], way / np.linalg.norm(way), 0.0)


def elastic_axis(block: MountedBlock) -> Axis:
    """The axis about which a moment about the crankshaft turns the block on its mounts.

    The foundation is held still.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.dynamics.mounted_block import mounted_block
    >>> at = [(r, z) for r in ("-0.3 m", "0.3 m") for z in ("-0.2 m", "0.2 m")]
    >>> mounts = [
    ...     {"name": f"{r} {z}", "right": r, "z": z, "up": "-0.1 m", "stiffness": "100 N/mm"}
    ...     for r, z in at
    ... ]
    >>> own = {"mounts": mounts, "block": {"mass": "160 kg", "z": "0 m"}}
    >>> round(float(elastic_axis(mounted_block(load("audi-25-tfsi", changes=own))).point[0]), 9)
    -0.1
    """
    arms = block.arms[: block.of_block, :, :SIX]
    stiffness = gathered(arms, values=block.along[: block.of_block])
    moment = np.zeros(SIX)
    moment[5] = 1.0
    motion = np.linalg.solve(stiffness, moment)
    shift, way = motion[:3], _vector(motion[3:])
    size = float(way @ way)
    point = block.centres[0] + np.cross(way, shift) / size
    advance = float(way @ shift) / size
    return Axis(_clear(point), _clear(way / np.sqrt(size)), float(_clear(np.array(advance))))


def _clear(values: Real) -> Real:
    """Places and directions with what is only rounding error set to zero."""
    return np.where(np.abs(values) < ROUNDING, 0.0, values)


def _vector(turn: Real) -> Real:
    """The line (up, right, z) about which yaw, pitch and roll turn the block."""
    return np.array([-turn[0], turn[1], turn[2]])
