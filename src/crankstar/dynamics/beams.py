"""How the forces on a crankshaft are shared among its main bearings.

Two models, each a matrix of real shares [bearing, force], so that a load vector that turns, order
by order, goes through them unchanged. A crankshaft is taken as equally stiff in all directions.

*Cut* (statically determinate): the shaft is hinged at every bearing between the first and the last,
so that a force goes to the two bearings beside it as the lever says; one beyond the ends bends its
outer span only.

*Continuous*: one uniform Euler-Bernoulli beam of bending stiffness EI on all bearings, each of
which may give by the compliance c (m/N). With w_f the places' deflections under unit forces on a
beam that rests on its first and last bearing only, the others' reactions R are those that bring the
shaft back to where its bearings stand,

    sum_j (d_ij + c delta_ij + ends) R_j = d_if F

and the first and last take the rest. Source: S. P. Timoshenko, Strength of Materials, part I,
continuous beams; the three-moment equation is the second road in the tests.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from crankstar.spectra import Real


def cut_shares(bearings: Sequence[float], places: Sequence[float]) -> Real:
    """Shares [bearing, force] of forces at `places` on a shaft hinged at each bearing.

    >>> cut_shares([2, 1, 0], [1.5, 0.25]).tolist()
    [[0.5, 0.0], [0.5, 0.25], [0.0, 0.75]]
    """
    out = np.zeros((len(bearings), len(places)))
    spans = list(pairwise(range(len(bearings))))
    for force, z in enumerate(places):
        front, rear = next(((a, b) for a, b in spans if z >= bearings[b]), spans[-1])
        share = (z - bearings[rear]) / (bearings[front] - bearings[rear])
        out[front, force], out[rear, force] = share, 1 - share
    return out


def continuous_shares(
    bearings: Sequence[float], places: Sequence[float], *, compliance: float = 0.0
) -> Real:
    """Shares [bearing, force] on one uniform beam over all bearings.

    `compliance` is that of a bearing with its wall, in units of (first to last bearing)^3 / EI;
    0 is rigid.

    The middle one of three bearings carries 10/8 of a load spread evenly, 11/16 of one in the
    middle of a span:

    >>> continuous_shares([2, 1, 0], [0.5]).round(6).tolist()
    [[-0.09375], [0.6875], [0.40625]]
    """
    z = np.asarray(bearings, float)
    length = z[0] - z[-1]
    support = (z[0] - z) / length
    force = (z[0] - np.asarray(places, float)) / length
    lever = np.stack([1 - force, force])
    if z.size == 2:
        return lever
    inner = support[1:-1]
    ends = np.stack([1 - inner, inner])  # what a unit reaction inside takes off each end
    give = compliance * (np.eye(inner.size) + ends.T @ ends)
    reaction = np.linalg.solve(
        _deflections(inner, inner) + give, _deflections(inner, force) + compliance * ends.T @ lever
    )
    end = lever - ends @ reaction
    return np.concatenate([end[:1], reaction, end[1:]])


def _deflections(at: Real, force: Real) -> Real:
    """Deflection [place, force] of a beam on its ends, length and EI one, beyond them too.

    For a force at a between the ends w(x) = b x (1 - b^2 - x^2)/6 + <x - a>^3/6, b = 1 - a; outside
    them the end slopes go on straight: the force bends the beam as the moment about the end does.
    """
    x, a = at[:, None], force[None, :]
    b = 1 - a
    inside = b * x * (1 - b**2 - x**2) / 6 + np.maximum(x - a, 0.0) ** 3 / 6
    before = a * x * (1 - x) * (2 - x) / 6  # overhang -a in front: the moment a at x = 0
    beyond = -b * -x * (1 - x**2) / 6
    return np.where(a < 0, before, np.where(a > 1, beyond, inside))
