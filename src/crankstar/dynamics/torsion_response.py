"""Forced torsional vibration of a chain, all orders and speeds at once, and what it does.

At a vibration of w = k W, k the order and W the speed of the crankshaft,

    (K + i H - w^2 M_k + i w C) q = T' torque

with H = eta K by section. A chain is a tree, so that the equations are solved as an electrical
network is, exactly and without a matrix: from the ends inwards, a shaft of dynamic stiffness s in
front of what has Z makes s Z/(s + Z) of it, and passes on the share s/(s + Z) of the torque; from
the root outwards the turns follow.

The torque in a section is (k (1 + i eta) + i w c) times its twist; its course over the cycle is the
sum of all orders with their phases, its peak at most the sum of the amplitudes, mostly less. The
shear stress is torque over pi (D^4 - d^4)/(16 D), nominal, without stress concentration. Work per
second: torque times speed of the turn, c |w twist|^2/2 in dampers, eta k |twist|^2 w/2 in shafts,
c |w theta|^2/2 against what stands still.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from crankstar import spectra
from crankstar.dynamics.torsion_excitation import Excitation
from crankstar.dynamics.torsion_modes import twists
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.spectra import Complex, Real


@dataclass(frozen=True)
class Response:
    """The steady vibration at crank speeds [speed] (rad/s) in orders [order].

    `turns` [speed, order, node] of the masses and `twist` [speed, order, section], radians,
    `torque` [speed, order, section] in the sections, N m: amplitudes c of Re(c exp(i k theta));
    `driving` [speed, order, node] what twists, N m; `without_inertia`: of gas alone.
    """

    chain: TorsionChain
    speeds: Real
    orders: Real
    turns: Complex
    twist: Complex
    torque: Complex
    driving: Complex
    without_inertia: bool = False

    @property
    def vibration(self) -> Real:
        """The circular frequencies, rad/s [speed, order]."""
        return np.multiply.outer(self.speeds, self.orders)

    @cached_property
    def added(self) -> Real:
        """The sum of the amplitudes of the torque of all orders, N m [speed, section]."""
        return np.abs(self.torque).sum(axis=1)

    @cached_property
    def peak(self) -> Real:
        """The greatest torque over the cycle, orders with their phases, N m [speed, section]."""
        return spectra.peaks(_signal(self.orders, self.torque))

    def peak_turn(self, node: int) -> Real:
        """The greatest turn of a mass over the cycle, rad [speed]."""
        known = self.peak_turns
        if node not in known:
            known[node] = spectra.peaks(_signal(self.orders, self.turns[..., [node]]))[:, 0]
        return known[node]

    @cached_property
    def peak_turns(self) -> dict[int, Real]:
        """The greatest turns of the masses that were asked for, by node, kept."""
        return {}

    def course(self, section: int, theta: Real) -> Real:
        """The torque in a section at crank angles, N m [speed, angle]."""
        signal = _signal(self.orders, self.torque)[:, section]
        return np.real(spectra.value(signal, theta))

    @cached_property
    def heat(self) -> Real:
        """The power that each section turns into heat, W [speed, section]."""
        w = self.vibration[..., None]
        lossy = np.array([each.stiffness * each.loss_factor for each in self.chain.sections])
        fluid = np.array([each.damping for each in self.chain.sections])
        return ((w * lossy + w**2 * fluid) * np.abs(self.twist) ** 2 / 2).sum(axis=1)

    @property
    def absolute_heat(self) -> Real:
        """The power that damping against what stands still takes, W [speed, node]."""
        w = self.vibration[..., None]
        return (w**2 * self.chain.absolute_damping * np.abs(self.turns) ** 2 / 2).sum(axis=1)

    @property
    def power(self) -> Real:
        """The power that the torques put in, W [speed]."""
        rate = 1j * self.vibration[..., None] * self.turns
        return np.real(self.driving * np.conj(rate)).sum(axis=(1, 2)) / 2


def joined(first: Response, second: Response) -> Response:
    """Two responses of one chain as one, by ascending speed; peaks that are known stay known."""
    speeds = np.concatenate([first.speeds, second.speeds])
    order = np.argsort(speeds, kind="stable")

    def both(name: str) -> Real | Complex:
        return np.concatenate([getattr(first, name), getattr(second, name)])[order]

    fields = {name: both(name) for name in ("turns", "twist", "torque", "driving")}
    out = replace(first, speeds=speeds[order], **fields)
    if "peak" in vars(first):
        vars(out)["peak"] = both("peak")
    vars(out)["peak_turns"] = {
        node: np.concatenate([known, second.peak_turn(node)])[order]
        for node, known in first.peak_turns.items()
    }
    return out


def _signal(orders: Real, amplitude: Complex) -> spectra.Spectrum:
    """Amplitudes [speed, order, part] as real signals [speed, part]."""
    return spectra.real_signal(orders, np.swapaxes(amplitude, 1, 2))


def response(chain: TorsionChain, excitation: Excitation, *, speeds: Real) -> Response:
    """The steady vibration of a chain at crank speeds (rad/s).

    Two equal masses against each other, shaken at sqrt(3/2) of their natural frequency:

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [
    ...     Disc(name="a", inertia=2),
    ...     Disc(name="b", inertia=2, to="a", stiffness=4, loss_factor=0),
    ... ]
    >>> push = Excitation(np.array([1.0]), np.array([[6.0 + 0j], [0j]]), None)
    >>> chain = torsion_chain(Chain(name="pair", discs=pair))
    >>> found = response(chain, push, speeds=np.array([1.5**0.5 * 2]))
    >>> found.turns[0, 0].real.round(9).tolist(), found.torque[0, 0].real.round(9).tolist()
    ([-1.0, 0.5], [6.0])
    """
    speeds = np.atleast_1d(np.asarray(speeds, float))
    driving = np.swapaxes(excitation.torque(speeds), 1, 2)
    w = np.multiply.outer(speeds, excitation.orders)
    push = np.ascontiguousarray(np.moveaxis(driving @ chain.transform, -1, 0))
    inertia = chain.inertias(excitation.orders)
    lost = (chain.transform**2).T @ chain.absolute_damping
    stiff = [_stiffness(chain, index, w) for index in range(len(chain.sections))]
    ends = [(chain.freedom[each.before], chain.freedom[each.after]) for each in chain.sections]
    behind: list[Complex] = [
        -(w**2) * inertia[:, freedom] + 1j * w * lost[freedom] for freedom in range(chain.freedoms)
    ]
    share: list[Complex] = []
    for index in reversed(range(len(ends))):
        root, end = ends[index]
        part = stiff[index] / (stiff[index] + behind[end])
        share.append(part)
        behind[root] = behind[root] + part * behind[end]
        push[root] += part * push[end]
    share.reverse()
    turns = np.empty_like(push)
    first = chain.freedom[_root(chain)]
    turns[first] = push[first] / behind[first]
    for (root, end), part, own in zip(ends, share, stiff, strict=True):
        turns[end] = part * (turns[root] + push[end] / own)
    whole = np.moveaxis(turns, 0, -1) @ chain.transform.T
    between = twists(chain, whole)
    torque = np.empty_like(between)
    for index, own in enumerate(stiff):
        squared = chain.ratio[chain.sections[index].after] ** 2
        torque[..., index] = own / squared * between[..., index]
    return Response(
        chain,
        speeds,
        excitation.orders,
        whole,
        between,
        torque,
        driving,
        excitation.inertia is None,
    )


def _stiffness(chain: TorsionChain, index: int, w: Real) -> Complex:
    """The dynamic stiffness of a section, referred to the speed of the crankshaft."""
    own = chain.sections[index]
    squared = chain.ratio[own.after] ** 2
    fixed = own.stiffness * (1 + 1j * own.loss_factor)
    return squared * (fixed + 1j * own.damping * w)


def _root(chain: TorsionChain) -> int:
    """The mass from which all sections lead away."""
    after = {chain.freedom[each.after] for each in chain.sections}
    return next(n for n, freedom in enumerate(chain.freedom) if freedom not in after)
