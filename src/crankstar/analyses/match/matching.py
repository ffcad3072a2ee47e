"""A batch of pistons, pins and rods matched to the cylinders of an engine, with proof.

Pins go with pistons first, the heaviest with the lightest (`batch.paired`). Then pistons
with their pins, and rods, are assigned to the cylinders so that the unbalance U that is left
(`law`) is least of all assignments (`assignments`). Beside it stands what chance would
leave: the rms of U over all assignments, of items i with the 2-vector m_i = (going up and down,
turning) and the 2-column vectors A_c of the cylinders, S the scatter of the m_i,

    E U^2 = |F(mean)|^2 + n/(n - 1) sum tr(A_c S A_c') - tr(A S A')/(n - 1),    A = sum A_c,

and what classes of w leave, in which every part may lie anywhere, its variance w^2/12, counted
from the middle of the class.

The crankshaft is balanced for the parts that are fitted, so that what they add is counted from
their own mean, not from that of the list: of p cylinders

    U = |sum A_c (m_i(c) - mean of the fitted m)| = |sum (A_c - A/p) m_i(c)|,

which is a sum of one vector for each part again, whichever parts are left over.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from crankstar.analyses.match.assignments import Kind, Watch, least
from crankstar.analyses.match.batch import Batch, MatchingError, base, paired
from crankstar.analyses.match.law import ORDERS, LinearUnbalance, linear_unbalance
from crankstar.analyses.match.question import Minimised
from crankstar.engine.engine import Engine
from crankstar.language.faults import EngineError
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.remains import kept
from crankstar.spectra import Real
from crankstar.studies.part_weights import with_parts

CLASSES = (0.0005, 0.001, 0.002, 0.005)
"""Widths of classes that are compared where none are asked for, kg."""


class Place(NamedTuple):
    """What goes into a cylinder: its number, the items of the batch by kind, None where none is."""

    cylinder: int
    piston: int | None
    pin: int | None
    rod: int | None


class ByClass(NamedTuple):
    """What classes of a width (kg) leave: the rms of U, and a bound that it does not exceed."""

    width: float
    rms: float
    most: float


@dataclass(frozen=True)
class Matched:
    """A matched engine: what goes where, U left (kg m), whether it is proved least.

    `whole`: U is that of the whole engine; else of what the parts add to the engine with the mean
    of those that are fitted everywhere. `whole_unbalance` is that of the whole engine either way,
    `whole_alike` with the mean of those fitted, or for the `whole` engine of the list.
    `as_listed` is U with the parts in the order of the list, `by_chance` its rms over all
    assignments, `fixed` that of the engine with this mean everywhere. `left_over`: of each kind.
    """

    engine: Engine
    law: LinearUnbalance
    places: tuple[Place, ...]
    unbalance: float
    proved: bool
    as_listed: float
    by_chance: float
    fixed: float
    classes: tuple[ByClass, ...]
    quantities: tuple[Minimised, ...]
    whole: bool
    whole_unbalance: float
    whole_alike: float
    left_over: int = 0

    @property
    def any_order(self) -> bool:
        """Whether every assignment leaves the same, the parts being alike."""
        return abs(self.by_chance - self.unbalance) <= NEGLIGIBLE * self.by_chance


class _Masses(NamedTuple):
    """The items of a kind: each item's masses [item, 2], more than the mean of the engine's own."""

    items: Real
    names: tuple[str, ...]


def matched(
    engine: Engine,
    batch: Batch,
    *,
    orders: Sequence[float] = ORDERS,
    quantities: Sequence[Minimised] = ("force", "couple"),
    classes: Sequence[float] = CLASSES,
    whole: bool = False,
    watch: Watch | None = None,
) -> Matched:
    """The assignment of a batch to the cylinders of an engine that leaves least unbalance.

    Of what the parts add to the engine with the mean of those that are fitted in every cylinder,
    for which its crankshaft is balanced afterwards; or of the `whole` engine with the
    counterweights that it has. Parts that are too many are left over, whichever that are best.

    Raises MatchingError where there are too few parts, or the engine cannot tell their effect,
    OrderError for an order that does not occur.

    >>> from crankstar.files.catalog import load
    >>> parts = {"piston": np.array([0.412, 0.410, 0.411, 0.413])}
    >>> found = matched(load("subaru-ej25"), Batch(("a", "b", "c", "d"), parts), orders=(1.0,))
    >>> found.proved, bool(found.unbalance < found.by_chance)
    (True, True)
    """
    before, count = base(engine, batch), len(engine.cylinders)
    if batch.size < count:
        raise MatchingError(
            "the list has {items} of each part and the engine {count} cylinders; list at least as "
            "many",
            items=batch.size,
            count=count,
        )
    check_orders(engine, orders, gas=False)
    law = linear_unbalance(engine, orders=orders, quantities=quantities)
    if not (law.reciprocating.any() or law.rotating.any()):
        raise MatchingError(
            "no part of this engine makes an order {orders}; choose among those of its forces, 1, "
            "2, 4 ...",
            orders=", ".join(f"{order:g}" for order in orders),
        )
    pins, _sums = paired(batch)
    kinds = _kinds(batch, pins)
    counted = law if whole else _about_fitted(law)
    each = [Kind(_vectors(counted, masses.items)) for masses in kinds]
    mean = np.zeros(law.fixed.size)
    fixed = law.rows(*_shift(before)) if whole else mean
    if whole:
        mean = fixed + np.sum([kind.vectors.mean(axis=0).sum(axis=0) for kind in each], axis=0)
    found = least(fixed, each, watch=watch)
    places = _places(engine, batch, pins, dict(zip(_names(batch), found.items, strict=True)))
    if not whole:
        before = base(engine, _fitted(batch, places))
    start = fixed + _sum(each, [tuple(range(count))] * len(each))
    scatter = sum(_scatter(counted, masses.items) for masses in kinds)
    pushed = float(np.linalg.norm(law.fixed)) + sum(
        float(np.linalg.norm(_vectors(law, masses.items), axis=2).max(axis=0).sum())
        for masses in kinds
    )

    def size(rows: Real | float) -> float:
        return kept(float(np.linalg.norm(rows)), beside=pushed)

    built = _built(engine, _added(batch, before, places), before, batch)
    alike = _alike(law, before, batch if whole else _fitted(batch, places))
    return Matched(
        engine=built,
        law=law,
        places=places,
        unbalance=size(found.length),
        proved=found.proved,
        as_listed=size(start),
        by_chance=size(np.sqrt(mean @ mean + scatter)),
        fixed=size(mean),
        classes=tuple(_by_class(law, batch, mean, width) for width in classes),
        quantities=tuple(quantities),
        whole=whole,
        whole_unbalance=size(_of_engine(law, batch, before, places)),
        whole_alike=size(alike),
        left_over=batch.size - count,
    )


def left_by(
    engine: Engine,
    batch: Batch,
    places: Sequence[Place],
    *,
    orders: Sequence[float],
    quantities: Sequence[Minimised],
    whole: bool,
) -> float:
    """U (kg m) with the parts of a batch in these places, as `Matched.unbalance` has it.

    >>> from crankstar.files.catalog import load
    >>> four = load("subaru-ej25")
    >>> parts = Batch(("a", "b"), {"piston": np.array([0.412, 0.410])})
    >>> here = [Place(n, int(n > 2), None, None) for n in (1, 2, 3, 4)]
    >>> asked = {"orders": (1.0,), "quantities": ("force", "couple")}
    >>> left = left_by(four, parts, here, whole=False, **asked)

    Two grams less in cylinders 3 and 4, next to each other on opposite sides, are a couple.

    >>> 0 < left < 0.004 * four.throw(four.first).radius
    True
    """
    law = linear_unbalance(engine, orders=orders, quantities=quantities)
    if whole:
        return float(np.linalg.norm(_of_engine(law, batch, base(engine, batch), places)))
    counted = _about_fitted(law)
    masses = {name: _in_places(batch, name, places) for name in batch.masses}
    around = masses.pop("big_end", np.zeros(len(places)))
    up = sum(masses.values(), np.zeros(len(places)))
    return float(np.linalg.norm(counted.reciprocating @ up + counted.rotating @ around))


def _about_fitted(law: LinearUnbalance) -> LinearUnbalance:
    """The law of what is counted from the mean of all cylinders: A_c less the mean of all A_c."""
    own = (law.reciprocating, law.rotating)
    up, around = (arms - arms.mean(axis=1, keepdims=True) for arms in own)
    return replace(law, fixed=0 * law.fixed, reciprocating=up, rotating=around)


def _fitted(batch: Batch, places: Sequence[Place]) -> Batch:
    """The parts that are in the engine, cylinder by cylinder."""
    masses = {name: _in_places(batch, name, places) for name in batch.masses}
    return Batch(tuple(str(place.cylinder) for place in places), masses)


def _in_places(batch: Batch, name: str, places: Sequence[Place]) -> Real:
    """The masses of a part, cylinder by cylinder."""
    kind = name if name in ("piston", "pin") else "rod"
    return batch.masses[name][[getattr(place, kind) for place in places]]


def _of_engine(
    law: LinearUnbalance, batch: Batch, before: Mapping[str, Real], places: Sequence[Place]
) -> Real:
    """The rows of the whole engine with the parts in it."""
    return law.rows(
        *_shift({name: own - _in_places(batch, name, places) for name, own in before.items()})
    )


def _alike(law: LinearUnbalance, before: Mapping[str, Real], batch: Batch) -> Real:
    """The rows of the whole engine with the mean of a batch in every cylinder."""
    return law.rows(
        *_shift({name: own - batch.masses[name].mean() for name, own in before.items()})
    )


def _built(
    engine: Engine, added: Mapping[str, Sequence[float]], before: Mapping[str, Real], batch: Batch
) -> Engine:
    """The engine with the parts. Raises MatchingError."""
    try:
        return with_parts(engine, added)
    except EngineError:
        raise MatchingError(
            "the weights of the list differ by more than the parts weigh in the file: {parts}; "
            "check their units",
            parts=", ".join(_far(before, batch)) or "-",
        ) from None


FAR = 2.0
"""Mass of a part in the list over that in the file, either way: the unit is another."""


def _far(before: Mapping[str, Real], batch: Batch) -> list[str]:
    """The kinds of parts of which the list has other masses than the file, both told."""
    out: list[str] = []
    for name, own in before.items():
        listed, known = batch.masses[name], float(own.mean())
        at = int(np.argmax(np.abs(listed - known)))
        if known <= 0 or not known / FAR < listed[at] < known * FAR:
            words = _(
                "{part} {label} has {listed} in the list and {known} in the file",
                part=name.replace("_", " "),
                label=batch.labels[at],
                listed=quantity_text(float(f"{listed[at]:.4g}"), "kg"),
                known=quantity_text(float(f"{known:.4g}"), "kg"),
            )
            out.append(words)
    return out


def _sum(kinds: Sequence[Kind], items: Sequence[Sequence[int]]) -> Real:
    """What assigned items add up to [row]."""
    places = np.arange(kinds[0].places)
    own = [kind.vectors[[*some], places] for kind, some in zip(kinds, items, strict=True)]
    return np.sum(own, axis=(0, 1))


def _names(batch: Batch) -> list[str]:
    return [*(["piston"] if batch.has_pistons else []), *(["rod"] if batch.has_rods else [])]


def _kinds(batch: Batch, pins: Sequence[int]) -> list[_Masses]:
    """Pistons with their pins, and rods, each as masses that go up and down, and that turn."""
    none = np.zeros(batch.size)
    part = {name: batch.masses.get(name, none) for name in ("piston", "pin")}
    out: list[_Masses] = []
    if batch.has_pistons:
        up = part["piston"] + part["pin"][[*pins]]
        out.append(_Masses(np.column_stack([up, none]), ("piston", "pin")))
    if batch.has_rods:
        ends = [batch.masses.get(name, none) for name in ("small_end", "big_end")]
        out.append(_Masses(np.column_stack(ends), ("small_end", "big_end")))
    return out


def _shift(before: Mapping[str, Real]) -> tuple[Real, Real]:
    """What the engine is without its own parts of the kinds listed, kg [cylinder]."""
    none = np.zeros(len(next(iter(before.values()))))
    up = none - sum((before[name] for name in before if name != "big_end"), none)
    return up, none - before.get("big_end", none)


def _vectors(law: LinearUnbalance, masses: Real) -> Real:
    """What each item adds at each cylinder [item, cylinder, row]."""
    return np.einsum("i,rc->icr", masses[:, 0], law.reciprocating) + np.einsum(
        "i,rc->icr", masses[:, 1], law.rotating
    )


def _scatter(law: LinearUnbalance, masses: Real) -> float:
    """The variance of the sum of the rows over all assignments of a kind."""
    count = len(masses)
    if count < 2:
        return 0.0
    apart = masses - masses.mean(axis=0)
    own = apart.T @ apart / count
    arms = np.stack([law.reciprocating, law.rotating], axis=-1)
    each = np.einsum("rcj,jk,rck->", arms, own, arms)
    whole = arms.sum(axis=1)
    together = np.einsum("rj,jk,rk->", whole, own, whole)
    return float(count / (count - 1) * each - together / (count - 1))


def _by_class(law: LinearUnbalance, batch: Batch, mean: Real, width: float) -> ByClass:
    """What classes of a width leave: each listed part anywhere in its class."""
    up = sum(name in batch.masses for name in ("piston", "pin", "small_end"))
    around = int("big_end" in batch.masses)
    squares = up * (law.reciprocating**2).sum() + around * (law.rotating**2).sum()
    rms = float(np.sqrt(mean @ mean + squares * width**2 / 12))
    lengths = np.linalg.norm(law.reciprocating, axis=0), np.linalg.norm(law.rotating, axis=0)
    most = np.linalg.norm(mean) + width / 2 * (up * lengths[0].sum() + around * lengths[1].sum())
    return ByClass(width, rms, float(most))


def _places(
    engine: Engine, batch: Batch, pins: Sequence[int], items: Mapping[str, Sequence[int]]
) -> tuple[Place, ...]:
    """What goes into each cylinder."""
    out: list[Place] = []
    for at, cylinder in enumerate(engine.cylinders):
        piston = items["piston"][at] if "piston" in items else None
        out.append(
            Place(
                cylinder.number,
                piston if "piston" in batch.masses else None,
                pins[piston] if piston is not None and "pin" in batch.masses else None,
                items["rod"][at] if "rod" in items else None,
            )
        )
    return tuple(out)


def _added(
    batch: Batch, before: Mapping[str, Real], places: Sequence[Place]
) -> dict[str, list[float]]:
    """What each cylinder has more of each part than before, kg."""
    out: dict[str, list[float]] = {}
    for name, own in before.items():
        out[name] = (_in_places(batch, name, places) - own).tolist()
    return out


def labels(batch: Batch, place: Place) -> tuple[str, ...]:
    """The names of the piston, the pin and the rod of a cylinder; empty where there is none."""
    items = (place.piston, place.pin, place.rod)
    return tuple("" if item is None else batch.labels[item] for item in items)
