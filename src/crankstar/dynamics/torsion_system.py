"""A crankshaft, or a drive line without cylinders, as a chain of inertias and springs.

Each mass i turns by theta_i on its own shaft. Rigid joints and gears leave fewer freedoms q than
masses,

    theta = T q,   M = T' diag(J) T,   K = sum k g g',   C = sum c g g' + T' diag(c_abs) T

with g the row of T by which a spring twists, q referred to the speed of the crankshaft. The springs
make a tree. Structural damping goes with the twist, not with its speed: K (1 + i eta).

A pendulum absorber (point masses m on pivots at R, of length L, swinging little) is at order k an
inertia

    J_k = n m (R + L)^2 / (1 - k^2 L/R)

at every speed, without end at its tuned order sqrt(R/L), which it holds still, and negative above.
Source: J. P. Den Hartog, Mechanical Vibrations, chapter 5, centrifugal pendulum.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from crankstar.engine.torsion import Pendulum
from crankstar.language.messages import MessageError
from crankstar.spectra import Complex, Real

SHARP = 1e-12
"""Nearest to its tuned order that a pendulum is taken to be."""


class TorsionError(MessageError):
    """Torsion that cannot be computed, and why."""


class Section(NamedTuple):
    """A shaft between two masses, by their indices: it twists by theta_after - ratio theta_before.

    `stiffness` 0: a fluid alone. `diameter` None: no stress.
    """

    before: int
    after: int
    ratio: float
    stiffness: float
    damping: float
    loss_factor: float
    diameter: float | None
    bore: float

    @property
    def modulus(self) -> float | None:
        """Torque over shear stress, pi (D^4 - d^4)/(16 D), m^3; None without a diameter."""
        if self.diameter is None:
            return None
        return np.pi / 16 * (self.diameter**4 - self.bore**4) / self.diameter


@dataclass(frozen=True)
class TorsionChain:
    """Masses [node] and the sections between them, SI; a tree, roots before branches.

    `ratio`: turns per turn of the first crankshaft, those of another counted in its own direction;
    `freedom`: which q a mass goes with; `throws`: the masses of the crank throws, front first and
    crankshaft by crankshaft; `cylinders`: the mass on which each cylinder of the engine works.
    `estimated` and `assumed` are the keys of the file that stand for what it lacks.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> torsion_chain(Chain(name="fan drive", discs=pair)).matrices()[1].tolist()
    [[6.0, -6.0], [-6.0, 6.0]]
    """

    name: str
    names: tuple[str, ...]
    inertia: Real
    ratio: Real
    absolute_damping: Real
    freedom: tuple[int, ...]
    sections: tuple[Section, ...]
    throws: tuple[int, ...] = ()
    cylinders: tuple[int, ...] = ()
    pendulums: tuple[tuple[int, Pendulum], ...] = ()
    estimated: tuple[str, ...] = ()
    assumed: tuple[str, ...] = ()

    @property
    def freedoms(self) -> int:
        """How many masses can turn against each other."""
        return 1 + max(self.freedom)

    @property
    def transform(self) -> Real:
        """T [node, freedom]: the turn of each mass by that of the freedoms."""
        out = np.zeros((len(self.names), self.freedoms))
        out[np.arange(len(self.names)), list(self.freedom)] = self.ratio
        return out

    def at_cylinders(self, shape: Real) -> Real:
        """What the torque of each cylinder, by angle of the first crankshaft, has of a shape."""
        on = list(self.cylinders)
        return shape[on] / self.ratio[on]

    @property
    def rings(self) -> frozenset[int]:
        """The freedoms that a fluid alone takes along, with all that hangs on them."""
        free: set[int] = set()
        for each in self.sections:
            if each.stiffness == 0 or self.freedom[each.before] in free:
                free.add(self.freedom[each.after])
        return frozenset(free)

    @property
    def damped(self) -> bool:
        """Whether anything takes work out of a vibration."""
        of_shafts = any(each.damping or each.loss_factor for each in self.sections)
        return of_shafts or bool(np.any(self.absolute_damping))

    def inertias(self, orders: Sequence[float] | Real = (0.0,)) -> Real:
        """The inertia of each freedom with its pendulums, kg m^2 [order, freedom]."""
        wanted = np.asarray(orders, float)
        out = np.tile((self.transform**2).T @ self.inertia, (wanted.size, 1))
        for node, own in self.pendulums:
            out[:, self.freedom[node]] += self.ratio[node] ** 2 * pendulum_inertia(
                own, wanted / abs(self.ratio[node])
            )
        return out

    def matrices(self, order: float = 0.0) -> tuple[Real, Real, Real]:
        """M, K and C [freedom, freedom]; M with the pendulums as they are at an order."""
        count = self.freedoms
        stiff, damp = (
            np.zeros((count, count)),
            np.diag((self.transform**2).T @ self.absolute_damping),
        )
        for each in self.sections:
            row = self.ratio[each.after] * (
                np.eye(count)[self.freedom[each.after]] - np.eye(count)[self.freedom[each.before]]
            )
            stiff += each.stiffness * np.outer(row, row)
            damp += each.damping * np.outer(row, row)
        return np.diag(self.inertias([order])[0]), stiff, damp

    def complex_stiffness(self) -> Complex:
        """K with structural damping, K + i H [freedom, freedom]."""
        lossy = [
            each._replace(stiffness=each.stiffness * each.loss_factor) for each in self.sections
        ]
        whole = self.matrices()[1]
        return whole + 1j * _with_sections(self, lossy).matrices()[1]

    def section_name(self, index: int) -> str:
        """The masses on both sides of a section."""
        front, rear = sorted((self.sections[index].before, self.sections[index].after))
        return f"{self.names[front]} - {self.names[rear]}"

    @property
    def stressed(self) -> bool:
        """Whether a shaft has a diameter, and so a shear stress."""
        return any(each.diameter is not None for each in self.sections)

    @property
    def along(self) -> tuple[int, ...]:
        """The indices of the sections from front to rear, in which tables list them."""
        ends = [sorted((each.before, each.after)) for each in self.sections]
        return tuple(sorted(range(len(ends)), key=ends.__getitem__))


def _with_sections(chain: TorsionChain, sections: Sequence[Section]) -> TorsionChain:
    return replace(chain, sections=tuple(sections))


def pendulum_inertia(own: Pendulum, orders: Real) -> Real:
    """The inertia of pendulums at crank orders, kg m^2 [order]; 0 where they swing with it.

    >>> two = Pendulum(on="front", mass=0.5, radius=0.08, length=0.02)  # tuned to order 2
    >>> pendulum_inertia(two, np.array([0.0, 1.0, 4.0])).round(6).tolist()
    [0.005, 0.006667, -0.001667]
    """
    share = 1 - orders**2 * (own.length / own.radius)
    share = np.where(np.abs(share) < SHARP, SHARP, share)
    return own.count * own.mass * (own.radius + own.length) ** 2 / share
