"""Natural frequencies and shapes of a chain, their nodes, and Holzer's table of a mode.

The eigenvalue problem K q = w^2 M q is solved by LAPACK (scipy). The chain is free to turn, so that
the first frequency is nought, once more for each ring that a fluid alone takes along: these are
left out, and a fluid does not hold a ring in the others, where it stands still.

With pendulums M depends on the order k, and is not positive where they are above their tuning. With
R the rigid turns (K R = 0), every other shape has R' M q = 0, and in these K is positive: there

    M q = (1/w^2) K q

has real 1/w^2, of which the positive ones are frequencies.

Holzer's table of a chain without branches: from one end with theta = 1, row by row

    J w^2 theta, their sum = the torque in the shaft behind, its twist = sum / k,
    theta of the next = theta - twist

and at a natural frequency the sum of all is nought. Source: H. Holzer, Die Berechnung der
Drehschwingungen (1921).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.torsion_system import TorsionChain, TorsionError
from crankstar.spectra import Real

STILL = 1e-3
"""Share of the greatest amplitude below which the first mass is a node."""
ROUNDING = 1e-13
"""Share of the greatest amplitude below which one is rounding error."""
AT_NODE = 1e-9
"""Share of the greatest amplitude below which a mass stands still."""


class Node(NamedTuple):
    """Where a mode stands still: between the masses `before` and `after`, or at one of them.

    `share`: how far from the first to the second, as the shaft twists evenly.
    """

    before: int
    after: int
    share: float


@dataclass(frozen=True)
class Mode:
    """A natural frequency (rad/s) and the shape of it [node], 1 at the first mass.

    At the largest where the first stands still; `twist` [section] of the shafts.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> [found] = torsion_modes(torsion_chain(Chain(name="fan drive", discs=pair)))
    >>> round(found.speed**2, 9), found.shape.round(9).tolist(), round(found.nodes[0].share, 3)
    (5.0, [1.0, -0.666666667], 0.6)
    """

    number: int
    speed: float
    shape: Real
    twist: Real
    nodes: tuple[Node, ...]

    @property
    def frequency(self) -> float:
        """Of the vibration, Hz."""
        return self.speed / (2 * pi)


def torsion_modes(chain: TorsionChain, *, order: float = 0.0) -> tuple[Mode, ...]:
    """The modes of a chain by frequency, rigid turns left out; pendulums as at a crank order.

    At order 0 they are masses that turn with what they hang on.
    """
    from scipy.linalg import eigh  # late: it takes longer to load than all figures

    inertia, stiffness, _damping = chain.matrices(order)
    rigid = 1 + sum(1 for each in chain.sections if each.stiffness == 0)
    if chain.freedoms == rigid:
        return ()
    if float(np.diag(inertia).min()) > 0:
        _values, vectors = eigh(stiffness, inertia)
        squared, vectors = _refined(chain, np.diag(inertia), vectors[:, rigid:])
    else:
        squared, vectors = _indefinite(inertia, stiffness)
    return tuple(
        _mode(chain, number, float(np.sqrt(value)), vector)
        for number, (value, vector) in enumerate(zip(squared, vectors.T, strict=True), 1)
    )


def _refined(chain: TorsionChain, inertia: Real, vectors: Real) -> tuple[Real, Real]:
    """Squared speeds and shapes, without what rounding has left in them of higher modes.

    The solver is exact to a share of the *highest* speed. Each shape is made orthogonal to the
    rigid turns and to all higher ones, and its speed is Rayleigh's quotient of its twists.
    """
    root = np.sqrt(inertia)[:, None]
    kept = np.linalg.qr(root * np.column_stack([_rigid_turns(chain), vectors[:, ::-1]]))[0]
    shapes = (kept[:, -vectors.shape[1] :] / root)[:, ::-1]
    twisted = twists(chain, (chain.transform @ shapes).T)
    return twisted**2 @ np.array([each.stiffness for each in chain.sections]), shapes


def _rigid_turns(chain: TorsionChain) -> Real:
    """The turns in which no shaft twists [freedom, turn]: of all, and of each ring in its fluid."""
    group = list(range(chain.freedoms))
    for each in chain.sections:
        if each.stiffness:
            one, other = (group[chain.freedom[node]] for node in (each.before, each.after))
            group = [one if own == other else own for own in group]
    return np.array([[own == turn for turn in dict.fromkeys(group)] for own in group], float)


def _indefinite(inertia: Real, stiffness: Real) -> tuple[Real, Real]:
    """Squared speeds and shapes where some inertias are negative: of the shapes without a turn."""
    from scipy.linalg import eigh, null_space

    still = null_space(stiffness)
    base = null_space(still.T @ inertia)
    inverse, shapes = eigh(base.T @ inertia @ base, base.T @ stiffness @ base)
    kept = np.flatnonzero(inverse > 1e-12 * float(np.abs(inverse).max()))[::-1]
    return 1 / inverse[kept], base @ shapes[:, kept]


def _mode(chain: TorsionChain, number: int, speed: float, vector: Real) -> Mode:
    free = chain.rings
    shape = chain.transform @ vector
    first = next((n for n in range(shape.size) if chain.freedom[n] not in free), 0)
    greatest = int(np.argmax(np.abs(shape)))
    unit = first if abs(shape[first]) >= STILL * abs(shape[greatest]) else greatest
    shape = np.where(np.abs(shape) > ROUNDING * abs(shape[greatest]), shape / shape[unit], 0.0)
    turns = vector / (chain.transform @ vector)[unit]
    return Mode(number, speed, shape, twists(chain, shape), _nodes(chain, turns))


def twists(chain: TorsionChain, turns: Real) -> Real:
    """The twist of each section [..., section] from the turns of the masses [..., node]."""
    before = [each.before for each in chain.sections]
    after = [each.after for each in chain.sections]
    ratio = np.array([each.ratio for each in chain.sections])
    return turns[..., after] - ratio * turns[..., before]


def _nodes(chain: TorsionChain, turns: Real) -> tuple[Node, ...]:
    """Sections in which the turn, referred to the crankshaft, changes its sign."""
    small = AT_NODE * float(np.abs(turns).max())
    out: list[Node] = []
    for each in chain.sections:
        here, there = (float(turns[chain.freedom[node]]) for node in (each.before, each.after))
        if each.stiffness and abs(here) > small and abs(there) > small and here * there < 0:
            if each.before > each.after:
                here, there = there, here
            ends = sorted((each.before, each.after))
            out.append(Node(ends[0], ends[1], here / (here - there)))
    joined = {chain.freedom[n] for each in chain.sections if each.stiffness for n in each[:2]}
    for freedom in sorted(joined):
        if abs(turns[freedom]) <= small:
            node = chain.freedom.index(freedom)
            out.append(Node(node, node, 0.0))
    return tuple(sorted(out))


class HolzerRow(NamedTuple):
    """A row of Holzer's table; the last one has no shaft behind it (None)."""

    name: str
    inertia: float
    inertia_torque: float
    amplitude: float
    torque: float
    sum: float
    stiffness: float | None
    twist: float | None


def holzer(chain: TorsionChain, *, speed: float, order: float = 0.0) -> tuple[HolzerRow, ...]:
    """Holzer's table at a vibration of `speed` (rad/s), referred to the speed of the crankshaft.

    Rigidly coupled masses are one row. The recurrence loses digits where the first mass hardly
    moves: `torsion_modes` does not. Raises TorsionError for a chain with branches.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> rows = holzer(torsion_chain(Chain(name="fan drive", discs=pair)), speed=5**0.5)
    >>> [round(row.sum, 9) + 0.0 for row in rows]
    [10.0, 0.0]
    """
    path, stiffness = _path(chain)
    inertia = chain.inertias([order])[0]
    out: list[HolzerRow] = []
    amplitude = total = 0.0
    for index, freedom in enumerate(path):
        amplitude = float(amplitude - total / stiffness[index - 1]) if index else 1.0
        unit = float(inertia[freedom]) * speed**2
        total += unit * amplitude
        behind = stiffness[index] if index < len(stiffness) else None
        names = [n for n, own in zip(chain.names, chain.freedom, strict=True) if own == freedom]
        out.append(
            HolzerRow(
                " + ".join(names),
                float(inertia[freedom]),
                unit,
                amplitude,
                unit * amplitude,
                float(total),
                behind,
                None if behind is None else total / behind,
            )
        )
    return tuple(out)


def _path(chain: TorsionChain) -> tuple[list[int], list[float]]:
    """The freedoms from end to end and the stiffnesses between them. Raises TorsionError."""
    free = chain.rings
    beside: dict[int, dict[int, float]] = {
        freedom: {} for freedom in range(chain.freedoms) if freedom not in free
    }
    for each in chain.sections:
        one, other = chain.freedom[each.before], chain.freedom[each.after]
        if other not in free:
            stiffness = each.stiffness * chain.ratio[each.after] ** 2
            beside[one][other] = beside[other][one] = stiffness
    if any(len(near) > 2 for near in beside.values()):
        raise TorsionError("Holzer's table goes along one row of masses, and this chain branches")
    start = next(freedom for freedom in sorted(beside) if len(beside[freedom]) < 2)
    path, stiffness = [start], []
    while near := {k: v for k, v in beside[path[-1]].items() if k not in path}:
        [(following, value)] = near.items()
        path.append(following)
        stiffness.append(value)
    return path, stiffness
