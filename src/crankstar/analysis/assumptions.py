"""What an answer rests on that an engine file does not say for certain, and how much it matters.

A value may be missing and counted as zero, left out of the model, assumed, estimated or unverified.
Each is an `Assumption`: the key path, the value that was taken, the ends between which it may lie,
and why. An `Answer` gives its figures as a function of the engine; `moved` computes them again over
the range and says which of them moves most:

    effect = max over figures of max |f(x) - f| / F

F being the maximum of the same quantity over all orders, at least what the answer says is the
least to measure by, so that what is hardly there does not lead. Of a range [low, high] both ends
are tried, the value as it is or the middle, where a resonance is met, and where that figure has an
extreme in between (`tried_values` says how they are found): its least and its greatest value are
those of the range. Where an end is no engine the range is that of the values that are one. A value
without ends (an unverified one) is varied by `TRIAL` up and down.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, Literal

from crankstar.analysis.changed_masses import Vary
from crankstar.analysis.tried_values import Figure, Figures, Tried, Tuning
from crankstar.engine.engine import Engine
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import Cycle

Status = Literal[
    "not modelled", "doubtful", "missing", "left out", "assumed", "estimated", "unverified"
]
"""What is not modelled the engine has and its file leaves out: no figure can say how it matters."""
Uses = Literal[
    "inertia", "gas", "running", "sized", "set", "bearings", "torsion", "mounts", "fitted",
    "valves", "firing",
]  # fmt: skip
"""What an answer is made of: what of it may be lacking differs; weights that were fitted to it.

Of firing it is when cylinders fire, of valves what they open at.

Of uneven running there is a flywheel in it, or one is sized for it; it may be of a generating set.
"""
TRIAL = 0.01
"""Share by which a value without ends is varied."""
SIGNIFICANT = 1e-3
"""Effect below which an assumption does not matter to an answer."""
UNMOVED = 1e-9
"""The same below which nothing depends on it: rounding errors."""
TOLD = 0.01
"""Effect from which an assumption has a sentence of its own."""
ROUNDING = 1e-9
"""Share of the maximum load of a mount below which one bears nothing."""
MAIN_OF, PIN_OF, WALL_OF = "main bearing ", "crank pin ", "cylinder wall "
"""The maximum load of one bearing, pin or wall, as quantities: before its number.

All of a kind are measured by the greatest among them.
"""
FIRST_LOAD = "main bearing"
"""The greatest load of an order on a main bearing, as a quantity beside a force or a couple."""
LEADING = (
    *("force", "couple", "vertical force", "vertical couple"),
    *("resonant amplitude", MAIN_OF),
)
TWICE = 2.0
"""Quantities that an answer says first, and how much more another moves that is told instead."""
LOAD_OF = "load of mount "
"""What a mount bears upward at rest, as a quantity: before its name."""
COUPLE_OF, H_OF, X_OF = (f"{name} of member " for name in ("couple", "H", "X"))
"""The moments of an engine of a family, as quantities: before its number of cylinders."""


@dataclass(frozen=True)
class Moved:
    """The figure that an assumption moves most, in the unit of its Balance or in N m.

    `now` is its value as given, `low` and `high` its least and its greatest over the range; `trial`
    says that the value has no range and was varied by TRIAL up and down. `lifting` are the mounts
    that bear a weight now and pull somewhere in the range; `beyond` has the ends that were meant of
    a range and make no engine, each with the reason.
    """

    quantity: str
    order: float | None
    unit: str
    now: float
    low: float
    high: float
    effect: float
    trial: bool = False
    lifting: tuple[str, ...] = ()
    beyond: tuple[tuple[float, str], ...] = ()


@dataclass(frozen=True)
class Assumption:
    """A value that an answer rests on and that the engine file does not give for certain.

    `value`, `low`, `high` are in the unit `unit`, None where there is no number; `reason` is a
    sentence of the catalog of messages, to be translated where it is shown, with `values` in it;
    `explained` says that it stands also where no figure does, as it says what to do; `named` that
    it is one of two choices, tried at the `other` in `values`, without a range; `sentence` is one
    on all of its kind, with their {paths}, instead of that of their status; `figures` are computed
    of the changed engine where those of the answer leave out what changes, others stay as they are;
    `alone` is the same without the values that go along, told where those move nothing.
    """

    status: Status
    path: str
    reason: str
    value: float | str | None = None
    unit: str = ""
    low: float | None = None
    high: float | None = None
    values: tuple[tuple[str, Any], ...] = ()
    explained: bool = False
    named: bool = False
    sentence: str = ""
    moved: Moved | None = None
    vary: Vary | None = field(default=None, repr=False)
    figures: Callable[[Engine], Figures] | None = field(default=None, repr=False)
    alone: Assumption | None = field(default=None, repr=False)

    @property
    def effect(self) -> float:
        """How much the answer moves at most, over its greatest value; 0 where that is not known."""
        return 0.0 if self.moved is None else self.moved.effect


def _nothing(_engine: Engine) -> Mapping[str, float]:
    return {}


@dataclass(frozen=True)
class Answer:
    """An analysis of an engine by its figures: what is compared when a value of its file changes.

    `figures` gives the maximum of each quantity and order of an engine. `unit` is that of a
    quantity, `least` what each quantity is measured by at least; `given` are the key paths of
    values that a question has of its own, as a sweep does, or that belong to no figure of it. `gas`
    is the cycle that is part of the answer; `without_gas` the one that its rolling moment leaves
    out; `gasless` is the sentence on what gas is missing in where it is not known, empty where gas
    does not belong to the answer; `why_gasless` says why it is not in it though the file has some;
    `choices` are those that the answer makes itself, with figures of their own. `tunings` are the
    natural frequencies of an answer that resonates. `shown` are the key paths of assumed values
    that its tables show, or that go into a table of none of the figures: they are told also where
    no figure moves by them. `aims` are quantities that the question is of: what moves one of them
    stands first, and what moves another as well is told by them. `engine` is the one that it is
    about, where the question has a value of its own for a key of the file, which is doubted as one.
    """

    figures: Callable[[Engine], Figures]
    unit: Callable[[str, Engine], str]
    uses: Collection[Uses] = ("inertia",)
    gas: Cycle | None = None
    without_gas: Cycle | None = None
    least: Callable[[Engine], Mapping[str, float]] = _nothing
    given: Collection[str] = ()
    gasless: str = ""
    why_gasless: str = ""
    choices: Sequence[Assumption] = ()
    tunings: Sequence[Tuning] = ()
    shown: Collection[str] = ()
    aims: Collection[str] = ()
    engine: Engine | None = None


def moved(engine: Engine, found: Sequence[Assumption], answer: Answer) -> tuple[Assumption, ...]:
    """The assumptions with what each moves most, the largest first; without those of no effect.

    Parts that are not modelled stand first, then what is doubtful and of no known size; what else
    cannot be varied stays, behind those that can. A doubt that moves little stays too, but not
    where nothing depends on it.
    """
    now = answer.figures(engine)
    least = dict(answer.least(engine))
    out: list[Assumption] = []
    for each in found:
        own = each if each.vary is None else _varied(engine, each, (now, least), answer)
        most = own.moved
        if most is not None and most.effect < SIGNIFICANT and not most.lifting:
            if each.path in answer.shown:
                own = replace(each, moved=None)
            elif each.status != "doubtful" or most.effect < UNMOVED:
                continue
        elif most is not None and _goes_alone(engine, own, most, answer):
            own = replace(each.alone or each, moved=most)
        out.append(own)
    return tuple(sorted(out, key=partial(_rank, answer.aims)))


def _goes_alone(engine: Engine, each: Assumption, most: Moved, answer: Answer) -> bool:
    """Whether the figure that an assumption moves most is the same without what goes along.

    At the upper end of its range, where both make an engine.
    """
    if each.alone is None:
        return False
    key, end = (most.quantity, most.order), float(each.high or 0)
    ways = [way for way in (each.vary, each.alone.vary) if way is not None]
    try:
        sizes = [answer.figures(way(engine, end)).get(key, 0.0) for way in ways]
    except (EngineError, MessageError):
        return False
    return max(sizes) - min(sizes) <= UNMOVED * max(map(abs, sizes))


def _rank(aims: Collection[str], each: Assumption) -> tuple[bool, bool, bool, float]:
    unsized = each.status == "doubtful" and each.moved is None
    beside = bool(aims) and (each.moved is None or each.moved.quantity not in aims)
    return each.status != "not modelled", not unsized, beside, -each.effect


def _varied(
    engine: Engine, each: Assumption, known: tuple[Figures, Mapping[str, float]], answer: Answer
) -> Assumption:
    """One assumption with the figure that it moves most, its ends those of what makes an engine.

    Without a figure where no other value than that as it is makes one.
    """
    assert each.vary is not None  # noqa: S101  # asked before
    now, least = known
    trial = each.low is None or each.high is None
    ends = (1 - TRIAL, 1 + TRIAL) if trial else (float(each.low or 0), float(each.high or 0))
    value = 0.0 if each.value is None else each.value
    own = each.figures
    try:
        tried = Tried(
            at=partial(each.vary, engine),
            figures=answer.figures if own is None else lambda varied: {**now, **own(varied)},
            now=now,
            ends=ends,
            value=1.0 if trial else value if isinstance(value, float) else None,
        )
    except (EngineError, MessageError):
        return replace(each, moved=None)
    if not any(tried.known.values()):  # nothing moves: no figure is left of the answer
        return replace(each, moved=Moved("", None, "", 0.0, 0.0, 0.0, 0.0))
    if not trial and tried.ends[0] < tried.ends[1]:
        tried.add_meetings(answer.tunings)
        key, effect, top = _most(tried, now, least, answer.aims)
        if effect >= TOLD and answer.tunings:
            tried.add_quarters()
            key, effect, top = _most(tried, now, least, answer.aims)
        if effect >= TOLD:
            tried.add_extremes(key, top=top)
            tried.add_jump(key, top=top)
    (quantity, order), effect, _top = _most(tried, now, least, answer.aims)
    sizes = [size for _x, size in tried.sizes((quantity, order))]
    change = Moved(
        quantity=quantity,
        order=order,
        unit=answer.unit(quantity, engine),
        now=now.get((quantity, order), 0.0),
        low=min(sizes),
        high=max(sizes),
        effect=effect,
        trial=trial,
        lifting=() if trial else _lifting(tried, now),
        beyond=() if trial else tuple(tried.beyond),
    )
    low, high = tried.ends if change.beyond else (each.low, each.high)
    return replace(each, moved=change, low=low, high=high)


def _most(
    tried: Tried, now: Figures, least: Mapping[str, float], aims: Collection[str]
) -> tuple[Figure, float, float]:
    """The figure that moves most, by how much of the greatest of its quantity, and that.

    What is aimed at stands before all others where it moves at all; without an aim a force or a
    couple, which an answer says first, before others that move up to TWICE.
    """
    tops = dict(least)
    every = [now, *tried.known.values()]
    for (quantity, _order), size in (item for one in every for item in one.items()):
        kind = _kind(quantity)
        tops[kind] = max(tops.get(kind, 0.0), abs(size))
    best: dict[bool, tuple[Figure, float, float]] = {}
    for key in dict.fromkeys(key for one in every for key in one):
        kind = _kind(key[0])
        size, top, leads = now.get(key, 0.0), tops[kind], kind in (aims or LEADING)
        most = max(abs(one.get(key, 0.0) - size) for one in tried.known.values())
        effect = most / top if top else 0.0
        if leads not in best or effect > best[leads][1] * (1 + 1e-9):
            best[leads] = key, effect, top
    first, other = best.get(True), best.get(False)
    weak = first is not None and aims and first[1] < SIGNIFICANT
    much = TWICE if not aims or weak else float("inf")
    if first is None or (other is not None and other[1] > much * first[1]):
        assert other is not None  # noqa: S101  # an answer has figures
        return other
    return first


def _kind(quantity: str) -> str:
    """The quantity; of the load of one of many bearings, pins or walls without its number."""
    return next(
        (kind for kind in (MAIN_OF, PIN_OF, WALL_OF) if quantity.startswith(kind)), quantity
    )


def _lifting(tried: Tried, now: Figures) -> tuple[str, ...]:
    """The mounts that bear a weight as the file is, and none somewhere in the range."""
    loads = {key: size for key, size in now.items() if key[0].startswith(LOAD_OF)}
    least = ROUNDING * max(map(abs, loads.values()), default=0.0)
    return tuple(
        key[0].removeprefix(LOAD_OF)
        for key, size in loads.items()
        if size > least and min(size for _x, size in tried.sizes(key)) < -least
    )
