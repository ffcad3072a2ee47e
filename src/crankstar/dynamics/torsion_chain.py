"""The chain of an engine with a table [torsion], or of a drive line: read, and put in order.

The throws of every crankshaft with the sections between them, each crankshaft turned by the one
before through its coupling; then what hangs on them. Source of the stiffness of throws that are
given by their dimensions: `dynamics.crank_stiffness`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from crankstar.dynamics.crank_stiffness import throw_stiffness
from crankstar.dynamics.torsion_system import Section, TorsionChain, TorsionError
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.engine.torsion import LOSS_FACTOR, Chain, Coupling, Disc, Pendulum, Torsion
from crankstar.engine.torsion_places import FRONT, home
from crankstar.mechanics.kinetic import carried_inertias, throws_from_front
from crankstar.spectra import Real


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
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    count = sum(len(crank.throws) for crank in cranks)
    several = count > len(cranks)
    springs = any(each.stiffness and each.loss_factor is None for each in own.couplings)
    lossy = own.loss_factor is None and (several or springs or _lossy(own.discs))
    assumed = ["torsion.loss_factor"] if lossy else []
    estimated = [] if own.stiffness or not several else ["torsion.stiffness"]
    if estimated and own.dimensions is not None and own.dimensions.shear_modulus is None:
        assumed.append("torsion.dimensions.shear_modulus")
    draft = _Draft(LOSS_FACTOR if own.loss_factor is None else own.loss_factor, cranks)
    _crank_elements(draft, engine, own, cranks)
    ahead: list[int] = []
    for disc in own.discs:
        where = draft.home(disc.to or "")
        if (disc.to or "").lower() == FRONT or where in ahead:
            ahead.append(len(draft.names))
        draft.hang(disc, where)
    for coupling in own.couplings:
        draft.couple(coupling)
    rest = [node for node in range(len(draft.names)) if node not in ahead]
    chain = draft.finished(engine.name, own.pendulums, [*reversed(ahead), *rest], assumed)
    throws = tuple(range(len(ahead), len(ahead) + count))
    places = {
        (crank.name, number): place
        for place, (crank, number) in zip(throws, _numbered(cranks), strict=True)
    }
    cylinders = tuple(places[cylinder.shaft, cylinder.throw] for cylinder in engine.cylinders)
    return replace(chain, throws=throws, cylinders=cylinders, estimated=tuple(estimated))


def _numbered(cranks: Sequence[Shaft]) -> list[tuple[Shaft, int]]:
    """Every throw by its crankshaft and number, crankshaft by crankshaft, front first."""
    return [(crank, number) for crank in cranks for number in throws_from_front(crank)]


def _crank_elements(draft: _Draft, engine: Engine, own: Torsion, cranks: Sequence[Shaft]) -> None:
    """The throws of all crankshafts, and the sections between those of each."""
    throws = _numbered(cranks)
    damping = _each(own.damping or (0.0,), len(throws))
    places = [index for crank in cranks for index in range(1, len(crank.throws) + 1)]
    for (crank, _number), place, value, lost in zip(
        throws, places, throw_inertias(engine, own), damping, strict=True
    ):
        name = f"throw {place}" if crank is cranks[0] else f"throw {place} of {crank.name}"
        ratio = abs(float(crank.speed_ratio))
        draft.mass(name, inertia=float(value), ratio=ratio, damping=lost)
    journal = own.diameter or (own.dimensions.journal_diameter if own.dimensions else None)
    bore = own.bore or (own.dimensions.journal_bore if own.dimensions and not own.diameter else 0.0)
    loss = draft.loss_factor
    gaps = [n for n, (one, other) in enumerate(pairwise(throws)) if one[0] is other[0]]
    stiffnesses = _stiffnesses(own, [throws[gap] for gap in gaps])
    for gap, value in zip(gaps, stiffnesses, strict=True):
        draft.sections.append(Section(gap, gap + 1, 1.0, value, 0.0, loss, journal, bore or 0.0))


def _each(values: Sequence[float], count: int) -> Sequence[float]:
    return tuple(values) * count if len(values) == 1 else tuple(values)


def throw_inertias(engine: Engine, own: Torsion) -> Real:
    """The mean inertia of each throw with its rods and pistons, kg m^2, front first.

    Of several crankshafts one after the other.
    """
    count = sum(len(shaft.throws) for shaft in engine.shafts)
    if own.inertia:
        return np.array(_each(own.inertia, count))
    return np.array(_each(own.bare_inertia, count)) + carried_inertias(engine)


def _stiffnesses(own: Torsion, gaps: Sequence[tuple[Shaft, int]]) -> Sequence[float]:
    """Between each of these throws and the next."""
    if own.dimensions is None or own.stiffness:
        return _each(own.stiffness, len(gaps)) if gaps else ()
    return [
        throw_stiffness(own.dimensions, radius=crank.throws[number - 1].radius)
        for crank, number in gaps
    ]


class _Draft:
    """A chain while its masses are hung on it, in the order of the file."""

    def __init__(self, loss_factor: float, cranks: Sequence[Shaft] = ()) -> None:
        self.loss_factor = loss_factor
        self.cranks = [(crank.name, len(crank.throws)) for crank in cranks]
        self.throws = sum(count for _name, count in self.cranks)
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
        found = home(text, cranks=self.cranks, names=tuple(self.names[self.throws :]))
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

    def couple(self, own: Coupling) -> None:
        """Join another crankshaft to what turns already."""
        on, place = self.home(own.to), self.home(f"{own.at} of {own.crankshaft}")
        if own.stiffness is None:
            joined = self.joined[place]
            self.joined = [self.joined[on] if each == joined else each for each in self.joined]
            return
        loss = own.loss_factor
        if loss is None:
            loss = 0.0 if own.damping else self.loss_factor
        ratio = self.ratio[place] / self.ratio[on]
        self.sections.append(Section(on, place, ratio, own.stiffness, own.damping, loss, None, 0.0))

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
                for each in _from_root(self.sections, self.joined)
            ),
            pendulums=tuple((place[self.home(own.on)], own) for own in pendulums),
            assumed=tuple(assumed),
        )


def _from_root(sections: Sequence[Section], joined: Sequence[int]) -> list[Section]:
    """The sections from the first mass outwards; those of a crank are turned to lead that way."""
    left, out, reached = list(sections), [], {joined[0]}
    while left:
        each = next(one for one in left if {joined[one.before], joined[one.after]} & reached)
        left.remove(each)
        if joined[each.before] not in reached:
            each = each._replace(before=each.after, after=each.before)
        reached.add(joined[each.after])
        out.append(each)
    return out
