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

from crankstar.dynamics.crank_stiffness import throw_stiffness
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.engine.torsion import FRONT, LOSS_FACTOR, Chain, Disc, Pendulum, Torsion, home
from crankstar.language.messages import MessageError
from crankstar.mechanics.kinetic import carried_inertias, throws_from_front
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

    `ratio`: turns per turn of the crankshaft; `freedom`: which q a mass goes with; `throws`: the
    masses of the crank throws, front first; `cylinders`: the mass on which each cylinder of the
    engine works. `estimated` and `assumed` are the keys of the file that stand for what it lacks.

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


def torsion_chain(source: Engine | Chain) -> TorsionChain:
    """The chain of an engine with a table [torsion], or of a drive line.

    Raises TorsionError for an engine without that table.
    """
    if isinstance(source, Chain):
        loss = LOSS_FACTOR if source.loss_factor is None else source.loss_factor
        assumed = ("loss_factor",) if source.loss_factor is None and _lossy(source.discs) else ()
        first, *others = source.discs
        draft = _Draft(loss)
        draft.mass(first.name, inertia=first.inertia, damping=first.absolute_damping)
        for disc in others:
            draft.hang(disc, draft.home(disc.to or ""))
        return draft.finished(source.name, source.pendulums, range(len(draft.names)), assumed)
    own = source.torsion
    if own is None:
        raise TorsionError(
            "torsion needs the inertias and stiffnesses of the crankshaft: give the table "
            "[torsion] in the engine file"
        )
    return _of_engine(source, own)


def _lossy(discs: Sequence[Disc]) -> bool:
    """Whether a shaft goes without a loss factor of its own."""
    return any(disc.stiffness and disc.loss_factor is None and not disc.damping for disc in discs)


def _of_engine(engine: Engine, own: Torsion) -> TorsionChain:
    """The chain of an engine: throws, what is ahead of them, what is behind."""
    crank = engine.shafts[0]
    order = throws_from_front(crank)
    count = len(order)
    lossy = own.loss_factor is None and (count > 1 or _lossy(own.discs))
    assumed = ["torsion.loss_factor"] if lossy else []
    estimated = [] if own.stiffness or count < 2 else ["torsion.stiffness"]
    if estimated and own.dimensions is not None and own.dimensions.shear_modulus is None:
        assumed.append("torsion.dimensions.shear_modulus")
    draft = _Draft(LOSS_FACTOR if own.loss_factor is None else own.loss_factor, count)
    damping = _each(own.damping or (0.0,), count)
    for place, (value, lost) in enumerate(zip(throw_inertias(engine, own), damping, strict=True)):
        draft.mass(f"throw {place + 1}", inertia=float(value), damping=lost)
    journal = own.diameter or (own.dimensions.journal_diameter if own.dimensions else None)
    bore = own.bore or (own.dimensions.journal_bore if own.dimensions and not own.diameter else 0.0)
    for place, value in enumerate(_stiffnesses(crank, own, order)):
        draft.sections.append(
            Section(place, place + 1, 1.0, value, 0.0, draft.loss_factor, journal, bore or 0.0)
        )
    ahead: list[int] = []
    for disc in own.discs:
        where = draft.home(disc.to or "")
        if (disc.to or "").lower() == FRONT or where in ahead:
            ahead.append(len(draft.names))
        draft.hang(disc, where)
    rest = [node for node in range(len(draft.names)) if node not in ahead]
    chain = draft.finished(engine.name, own.pendulums, [*reversed(ahead), *rest], assumed)
    by_throw = {number: place for place, number in enumerate(order)}
    throws = tuple(chain.names.index(f"throw {place + 1}") for place in range(count))
    cylinders = tuple(throws[by_throw[cylinder.throw]] for cylinder in engine.cylinders)
    return replace(chain, throws=throws, cylinders=cylinders, estimated=tuple(estimated))


def _each(values: Sequence[float], count: int) -> Sequence[float]:
    return tuple(values) * count if len(values) == 1 else tuple(values)


def throw_inertias(engine: Engine, own: Torsion) -> Real:
    """The mean inertia of each throw with its rods and pistons, kg m^2, front first."""
    count = len(engine.shafts[0].throws)
    if own.inertia:
        return np.array(_each(own.inertia, count))
    return np.array(_each(own.bare_inertia, count)) + carried_inertias(engine)


def _stiffnesses(crank: Shaft, own: Torsion, order: Sequence[int]) -> Sequence[float]:
    gaps = len(order) - 1
    if own.dimensions is not None and not own.stiffness:
        radius = crank.throws[order[0] - 1].radius
        return _each((throw_stiffness(own.dimensions, radius=radius),), gaps) if gaps else ()
    return _each(own.stiffness, gaps) if gaps else ()


class _Draft:
    """A chain while its masses are hung on it, in the order of the file."""

    def __init__(self, loss_factor: float, throws: int = 0) -> None:
        self.loss_factor, self.throws = loss_factor, throws
        self.names: list[str] = []
        self.inertia: list[float] = []
        self.ratio: list[float] = []
        self.damping: list[float] = []
        self.joined: list[int] = []
        self.sections: list[Section] = []

    def mass(
        self,
        name: str,
        *,
        inertia: float,
        ratio: float = 1.0,
        damping: float = 0.0,
        rigid: int | None = None,
    ) -> None:
        """Add a mass, and whether another is rigid with it."""
        self.joined.append(len(self.names) if rigid is None else self.joined[rigid])
        self.names.append(name)
        self.inertia.append(inertia)
        self.ratio.append(ratio)
        self.damping.append(damping)

    def home(self, text: str) -> int:
        """The index of the mass that a text names."""
        found = home(text, throws=self.throws, names=tuple(self.names[self.throws :]))
        if found is None:
            raise TorsionError("a disc hangs on {name}, which is not there", name=text)
        return found.throw if found.throw is not None else self.throws + (found.disc or 0)

    def hang(self, disc: Disc, on: int) -> None:
        """Add a disc and its shaft."""
        ratio = float(disc.speed_ratio)
        rigid = disc.stiffness is None and not disc.damping
        place = len(self.names)
        self.mass(
            disc.name,
            inertia=disc.inertia,
            ratio=ratio * self.ratio[on],
            damping=disc.absolute_damping,
            rigid=on if rigid else None,
        )
        if rigid:
            return
        loss = disc.loss_factor
        if loss is None:
            loss = 0.0 if disc.damping else self.loss_factor
        self.sections.append(
            Section(
                on,
                place,
                ratio,
                disc.stiffness or 0.0,
                disc.damping,
                loss,
                disc.diameter,
                disc.bore or 0.0,
            )
        )

    def finished(
        self, name: str, pendulums: Sequence[Pendulum], order: Sequence[int], assumed: Sequence[str]
    ) -> TorsionChain:
        """The chain with its masses in this order."""
        place = {node: index for index, node in enumerate(order)}
        homes = list(dict.fromkeys(self.joined[node] for node in order))
        return TorsionChain(
            name=name,
            names=tuple(self.names[node] for node in order),
            inertia=np.array([self.inertia[node] for node in order]),
            ratio=np.array([self.ratio[node] for node in order]),
            absolute_damping=np.array([self.damping[node] for node in order]),
            freedom=tuple(homes.index(self.joined[node]) for node in order),
            sections=tuple(
                each._replace(before=place[each.before], after=place[each.after])
                for each in self.sections
            ),
            pendulums=tuple((place[self.home(own.on)], own) for own in pendulums),
            assumed=tuple(assumed),
        )
