"""A rigid block on its mounts, and a foundation under them: masses, springs, dampers.

The freedoms are those of `engine.rigid_block`: q = (up, right, z, yaw, pitch, roll) of the block
about its centre of mass G, in a frame that stands still; behind them the six of the foundation
about its own centre, where there is one. With B what q does along the three axes of all mounts,
k, c and eta their stiffness, damping and loss factor, s(w) their stiffening at the frequency w:

    (-w^2 M + i w C + K(w)) q = Q       K = B' k s(w) (1 + i eta) B      C = B' c B

Q are the forces on the freedoms. A mount whose foot has a receptance a(w) of its own acts as the
series of both: with r = s k (1 + i eta) + i w c, its force is r / (1 + r a) times what its ends
approach; feet do not move each other. Motions are small; the crankshaft runs on evenly and has its
mass but not its turning in M; its gyroscopic moment is left out. Gravity acts downward, against
`up`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crankstar.dynamics.whirl import Body, body
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import ALONG, Mount
from crankstar.engine.quantities import GRAVITY
from crankstar.engine.rigid_block import gathered, held, mass_matrix
from crankstar.language.messages import MessageError
from crankstar.spectra import Complex, Real

SIX = 6


class MountError(MessageError):
    """An engine whose block cannot be put on mounts, and why."""


@dataclass(frozen=True)
class MountedBlock:
    """M, and of each spring what the freedoms do along its axes.

    `mounts` are those of the block, then those of the foundation; `arms` [mount, axis, freedom].
    """

    body: Body
    mounts: tuple[Mount, ...]
    of_block: int
    mass: Real
    arms: Real
    centres: Real

    @property
    def freedoms(self) -> int:
        """Six, or twelve with a foundation."""
        return len(self.mass)

    @property
    def along(self) -> Real:
        """The stiffness along each axis under a load that stands still, N/m [mount, axis]."""
        return np.array([each.along for each in self.mounts])

    @property
    def viscous(self) -> Real:
        """The damping along each axis, N s/m [mount, axis]."""
        return np.array([each.viscous for each in self.mounts])

    @property
    def stiffness(self) -> Real:
        """K under a load that stands still."""
        return gathered(self.arms, values=self.along)

    @property
    def damping(self) -> Real:
        """C of the viscous dampers."""
        return gathered(self.arms, values=self.viscous)

    @property
    def each_stiffness(self) -> Real:
        """What each mount adds to K [mount, freedom, freedom]."""
        return np.array(
            [
                gathered(arm[None], values=along[None])
                for arm, along in zip(self.arms, self.along, strict=True)
            ]
        )

    @property
    def stiffens(self) -> bool:
        """Whether a mount is stiffer at some frequency."""
        return any(each.rubber for each in self.mounts)

    def stiffening(self, frequencies: Real | float) -> Real:
        """The factor s at angular frequencies (rad/s), [*frequencies.shape, mount].

        Straight between the values that are given, from 1 at rest; kept beyond the last.
        """
        at = np.asarray(frequencies, float)
        out = np.ones((*at.shape, len(self.mounts)))
        for index, mount in enumerate(self.mounts):
            if mount.rubber:
                knots = [0.0, *(each.frequency for each in mount.rubber)]
                factors = [1.0, *(each.factor for each in mount.rubber)]
                out[..., index] = np.interp(at, knots, factors)
        return out

    @property
    def has_feet(self) -> bool:
        """Whether what a mount stands on gives way by a receptance of its own."""
        return any(each.foot for each in self.mounts)

    def receptance(self, frequencies: Real | float) -> Complex:
        """Of the foot of each mount along its axes, m/N [*frequencies.shape, mount, axis]."""
        at = np.asarray(frequencies, float)
        out = np.zeros((*at.shape, len(self.mounts), ALONG), complex)
        for index, mount in enumerate(self.mounts):
            if mount.foot:
                knots = [each.frequency for each in mount.foot]
                given = np.array([each.along for each in mount.foot])
                for axis in range(ALONG):
                    out[..., index, axis] = np.interp(at, knots, given[:, axis])
        return out

    def rate(self, frequencies: Real | float) -> Complex:
        """Force per deflection of each mount, N/m [*frequencies.shape, mount, axis]."""
        at = np.asarray(frequencies, float)
        lossy = self.lossy(at)[..., None] * self.along
        return lossy + 1j * at[..., None, None] * self.viscous

    def yielding(self, frequencies: Real | float) -> Complex:
        """Deflection of each mount over what its ends approach [*frequencies.shape, mount, axis].

        With its foot in series, 1 / (1 + rate times receptance); 1 where that stands still.
        """
        if not self.has_feet:
            return np.ones((), complex)
        return 1 / (1 + self.rate(frequencies) * self.receptance(frequencies))

    def lossy(self, frequencies: Real | float) -> Complex:
        """The factor s (1 + i eta) at angular frequencies, [*frequencies.shape, mount]."""
        loss = np.array([each.loss for each in self.mounts])
        return self.stiffening(frequencies) * (1 + 1j * loss)

    @property
    def to_ground(self) -> slice:
        """The mounts whose force the ground takes: those of the foundation, where there is one."""
        return slice(self.of_block if self.freedoms > SIX else 0, None)


def mounted_block(engine: Engine) -> MountedBlock:
    """The block of an engine on its mounts. Raises MountError where it has none.

    Two mounts a metre apart beside the centre of mass, and one at it:

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m"), ("right", "0.5 m"), ("rear", "0 m")]
    >>> mounts = [{"name": n, "right": r, "stiffness": "100 N/mm"} for n, r in at]
    >>> mounts[2]["z"] = "-0.3 m"
    >>> own = {"mounts": mounts, "block": {"mass": "150 kg", "z": "0 m"}}
    >>> found = mounted_block(load("audi-25-tfsi", changes=own))
    >>> found.stiffness[0, 0].item(), found.stiffness[5, 5].item()
    (300000.0, 50000.0)
    """
    if not engine.mounts:
        raise MountError(
            "the engine {name} has no mounts; give [[mounts]] in its file, at least two of them",
            name=engine.name,
        )
    own = body(engine)
    products = (0.0, 0.0, 0.0) if engine.block is None else engine.block.products
    mass = mass_matrix(own.mass, inertia=own.inertia, products=products)
    base = engine.foundation
    if base is None:
        mounts, centres = engine.mounts, np.array([own.centre])
        arms = _arms(engine.mounts, centres)
        return MountedBlock(own, mounts, len(mounts), mass, arms, centres)
    centres = np.array([own.centre, (base.up, base.right, base.z)])
    below = mass_matrix(base.mass, inertia=base.inertia, products=(0.0, 0.0, 0.0))
    lower = held(base.mounts, centre=centres[1].tolist())
    lower = np.concatenate([np.zeros_like(lower), lower], axis=-1)
    return MountedBlock(
        own,
        (*engine.mounts, *base.mounts),
        len(engine.mounts),
        np.block([[mass, np.zeros_like(mass)], [np.zeros_like(mass), below]]),
        np.concatenate([_arms(engine.mounts, centres), lower]),
        centres,
    )


def _arms(mounts: Sequence[Mount], centres: Real) -> Real:
    """What the freedoms of the block, and of its foundation, do along the axes of its mounts."""
    upper = held(mounts, centre=centres[0].tolist())
    if len(centres) == 1:
        return upper
    return np.concatenate([upper, -held(mounts, centre=centres[1].tolist())], axis=-1)


def with_mounts(block: MountedBlock, mounts: Sequence[Mount]) -> MountedBlock:
    """The same block, on other mounts of its own; as many as it has.

    >>> from crankstar.engine.copies import with_values
    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> own = {"mounts": rubber, "block": {"mass": "150 kg", "z": "0 m"}}
    >>> block = mounted_block(load("audi-25-tfsi", changes=own))
    >>> wide = [with_values(each, right=2 * each.right) for each in block.mounts]
    >>> (with_mounts(block, wide).stiffness[5, 5] / block.stiffness[5, 5]).item()
    4.0
    """
    below = block.mounts[block.of_block :]
    arms = np.concatenate([_arms(mounts, block.centres), block.arms[block.of_block :]])
    return replace(block, mounts=(*mounts, *below), arms=arms)


def dynamic_stiffness(block: MountedBlock, *, frequencies: Real) -> Complex:
    """-w^2 M + i w C + K(w) at angular frequencies w (rad/s), [w, freedom, freedom].

    Where feet give way, k and c of each mount are in series with its foot.
    """
    at = np.asarray(frequencies, float)
    if block.has_feet:
        along = block.rate(at) * block.yielding(at)
        return gathered(block.arms, values=along) - at[:, None, None] ** 2 * block.mass
    size = block.freedoms
    each = block.each_stiffness.reshape(-1, size * size)
    loss = np.array([[own.loss] for own in block.mounts])
    factor = block.stiffening(at if block.stiffens else np.zeros(1))
    out = np.empty((at.size, size * size), complex)
    out.real = np.einsum("fm,mk->fk", factor, each) - at[:, None] ** 2 * block.mass.ravel()
    out.imag = np.einsum("fm,mk->fk", factor, loss * each) + at[:, None] * block.damping.ravel()
    return out.reshape(-1, size, size)


def settled(block: MountedBlock) -> tuple[Real, Real]:
    """How the block sits down under its weight [freedom], and what each mount bears (N, own axes).

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> mounts = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> own = {"mounts": mounts, "block": {"mass": "150 kg", "z": "0 m"}}
    >>> down, loads = settled(mounted_block(load("audi-25-tfsi", changes=own)))
    >>> round(float(-loads[:, 0].sum()) / 9.80665, 9)
    150.0
    """
    weight = np.zeros(block.freedoms)
    weight[::SIX] = -GRAVITY * np.diag(block.mass)[::SIX]
    down = np.linalg.solve(block.stiffness, weight)
    return down, block.along * (block.arms @ down)


def borne(block: MountedBlock, loads: Real) -> Real:
    """What each mount bears upward at rest, N: less than zero where it pulls; `loads` of `settled`.

    Three mounts alike, the centre of mass ahead of the front ones: the rear one pulls with a third
    of the weight, by moments about the front ones.

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> mounts = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> own = {"mounts": mounts, "block": {"mass": "150 kg", "z": "0.1 m"}}
    >>> block = mounted_block(load("audi-25-tfsi", changes=own))
    >>> [round(each / 9.80665, 6) for each in borne(block, settled(block)[1]).tolist()]
    [100.0, 100.0, -50.0]
    """
    up = block.arms[:, :, 0].copy()
    if block.freedoms > SIX:
        up[block.of_block :] = block.arms[block.of_block :, :, SIX]
    return -(up * loads).sum(axis=-1)
