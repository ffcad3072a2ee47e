"""Critical speeds, equilibrium amplitudes, and the speeds that a limit of stress bars.

An order k meets a mode of w_n at the speed w_n/k of the crankshaft: the crossings of the Campbell
diagram. How hard it drives the mode is its torque of excitation |sum a_j T_jk|; the equilibrium
amplitude, of the mass at which the shape a is 1, is what that would turn it by if it were steady,

    theta_e = |sum a_j T_jk| / (w_n^2 sum J_i a_i^2)

and a resonance is as many times that as the dynamic magnifier says.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.torsion_excitation import Excitation
from crankstar.dynamics.torsion_modes import Mode, torsion_modes
from crankstar.dynamics.torsion_response import Response
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.firing.weighing import vector_sums
from crankstar.spectra import ROUNDING, Real

SAME_ORDER = 1e-9
OF_NOTE = 0.05
"""Share of the greatest equilibrium amplitude, or vector sum, from which readers are told."""


class Critical(NamedTuple):
    """An order that meets a mode at a crank speed (rad/s).

    `vector_sum` is None without firing angles; `torque` (N m) and `equilibrium` (rad) without an
    excitation.
    """

    mode: int
    order: float
    speed: float
    vector_sum: float | None
    torque: float | None
    equilibrium: float | None


class Barred(NamedTuple):
    """Crank speeds (rad/s) between which the stress of a section passes the limit."""

    low: float
    high: float
    section: int


def criticals(
    chain: TorsionChain,
    *,
    orders: Sequence[float] | Real,
    low: float,
    high: float,
    modes: int | None = None,
    phases: Real | None = None,
    excitation: Excitation | None = None,
) -> tuple[Critical, ...]:
    """Where orders meet the first `modes` between two crank speeds (rad/s), by mode and order.

    `phases` [cylinder] are the angles at which the cylinders fire.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> chain = torsion_chain(Chain(name="fan drive", discs=pair))
    >>> [round(each.speed**2, 3) for each in criticals(chain, orders=[1, 2], low=0, high=3)]
    [5.0, 1.25]
    """
    fixed = torsion_modes(chain)
    met: list[tuple[Mode, float, float]] = []
    for order in map(float, orders):
        own = torsion_modes(chain, order=order) if chain.pendulums else fixed
        for mode in own[:modes]:
            speed = mode.speed / order
            if low * (1 - 1e-12) <= speed <= high * (1 + 1e-12):
                met.append((mode, order, speed))
    driven = _driven(chain, met, excitation)
    out = [
        Critical(mode.number, order, speed, _summed(chain, mode, order, phases), *push)
        for (mode, order, speed), push in zip(met, driven, strict=True)
    ]
    return tuple(sorted(out, key=lambda each: each[:2]))


def _summed(chain: TorsionChain, mode: Mode, order: float, phases: Real | None) -> float | None:
    """The vector sum of an order in a mode, None without firing angles."""
    if phases is None:
        return None
    return float(vector_sums(chain.at_cylinders(mode.shape), phases, [order])[0])


def _driven(
    chain: TorsionChain, met: Sequence[tuple[Mode, float, float]], excitation: Excitation | None
) -> list[tuple[float, float] | tuple[None, None]]:
    """Torque and equilibrium amplitude of each mode, order and speed that meet."""
    out: list[tuple[float, float] | tuple[None, None]] = [(None, None)] * len(met)
    if excitation is None or not met:
        return out
    orders = np.array([order for _mode, order, _speed in met])
    apart = np.abs(excitation.orders - orders[:, None])
    column = np.argmin(apart, axis=1)
    known = np.flatnonzero(apart.min(axis=1) < SAME_ORDER)
    torque = excitation.torque(np.array([met[number][2] for number in known.tolist()]))
    first = [chain.freedom.index(freedom) for freedom in range(chain.freedoms)]
    inertias = chain.inertias(orders)
    pushes = [
        met[number][0].shape * torque[row, :, column[number]]
        for row, number in enumerate(known.tolist())
    ]
    noise = ROUNDING * max((float(np.abs(each).sum()) for each in pushes), default=0.0)
    for number, pushed in zip(known.tolist(), pushes, strict=True):
        mode, size = met[number][0], float(abs(pushed.sum()))
        size = size if size > noise else 0.0
        turns = mode.shape[first] / chain.ratio[first]
        modal = float(inertias[number] @ turns**2)
        out[number] = size, size / (mode.speed**2 * abs(modal))
    return out


def strength(each: Critical) -> float:
    """By how much a critical speed counts beside others, whatever the mass at which a shape is 1.

    The root of the work of the excitation at its equilibrium amplitude, J; without an excitation
    its vector sum, without firing angles 1.
    """
    if each.equilibrium is not None and each.torque is not None:
        return (each.torque * each.equilibrium) ** 0.5
    return 1.0 if each.vector_sum is None else each.vector_sum


def of_note(found: Sequence[Critical], *, share: float = OF_NOTE) -> list[Critical]:
    """Those that have at least this share of the greatest strength, the strongest first.

    >>> weak, strong = (Critical(1, k, 9 / k, size, None, None) for k, size in ((1, 0.1), (3, 4.0)))
    >>> [each.order for each in of_note([weak, strong])]
    [3]
    """
    least = share * max(map(strength, found), default=0.0)
    kept = [each for each in found if strength(each) >= least]
    return sorted(kept, key=lambda each: (-strength(each), each.mode, each.order))


def half_power_speeds(
    chain: TorsionChain, found: Critical, modes: Sequence[Mode] | None = None
) -> tuple[float, float]:
    """The crank speeds beside a critical one at which the mode has half the power, rad/s.

    W (1 -+ eta/2), with eta = a'(H + w C)a / a'Ka the loss factor of the mode at its frequency w;
    `modes` are those of the chain at order 0, where they are known.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [
    ...     Disc(name="a", inertia=2),
    ...     Disc(name="b", inertia=2, to="a", stiffness=4, loss_factor=0.02),
    ... ]
    >>> chain = torsion_chain(Chain(name="pair", discs=pair))
    >>> one = criticals(chain, orders=[1], low=0, high=3)[0]
    >>> tuple(round(speed, 6) for speed in half_power_speeds(chain, one))
    (1.98, 2.02)
    """
    if modes is None or chain.pendulums:
        modes = torsion_modes(chain, order=found.order if chain.pendulums else 0.0)
    mode = next(each for each in modes if each.number == found.mode)
    first = [chain.freedom.index(freedom) for freedom in range(chain.freedoms)]
    turns = mode.shape[first] / chain.ratio[first]
    _inertia, stiffness, damping = chain.matrices()
    lossy = np.imag(chain.complex_stiffness()) + mode.speed * damping
    half = float(turns @ lossy @ turns) / float(turns @ stiffness @ turns) / 2
    return found.speed * max(1 - half, 0.0), found.speed * (1 + half)


def stresses(found: Response) -> tuple[Real, Real]:
    """Greatest shear stress over the cycle and the sum of all orders' amplitudes [speed, section].

    Pa; nan where a section has no diameter.
    """
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    return found.peak / modulus, found.added / modulus


def barred(speeds: Real, stress: Real, *, limit: float) -> tuple[Barred, ...]:
    """The ranges of speed in which a stress [speed, section] is above the limit, both in Pa.

    Between computed speeds the stress is taken to go straight.

    >>> barred(np.array([1.0, 2.0, 3.0]), np.array([[10.0], [30.0], [10.0]]), limit=20.0)
    (Barred(low=1.5, high=2.5, section=0),)
    """
    out: list[Barred] = []
    for section in range(stress.shape[1]):
        over = stress[:, section] - limit
        inside = over > 0
        edges = np.flatnonzero(np.diff(inside.astype(int)))
        ends = [
            float(speeds[n] - over[n] * (speeds[n + 1] - speeds[n]) / (over[n + 1] - over[n]))
            for n in edges
        ]
        ends = [float(speeds[0])] * bool(inside[:1].any()) + ends
        ends += [float(speeds[-1])] * bool(inside[-1:].any())
        out += [Barred(low, high, section) for low, high in zip(ends[::2], ends[1::2], strict=True)]
    return tuple(sorted(out))
