"""What an answer rests on that an engine file does not say for certain, and how much it matters.

A value may be missing and counted as zero, left out of the model, assumed, estimated or unverified.
Each is an `Assumption`: the key path, the value that was taken, the ends between which it may lie,
and why. An `Answer` gives its figures as a function of the engine; `moved` computes them again at
both ends and says which of them moves most:

    effect = max over figures of max(|f(low) - f|, |f(high) - f|) / F

F being the maximum of the same quantity over all orders, at least what the answer says is the
least to measure by, so that what is hardly there does not lead. A value without ends (an unverified
one) is varied by `TRIAL` up and down.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from crankstar.engine.engine import Engine
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import Cycle
from crankstar.studies.changed_values import Vary

Status = Literal["doubtful", "missing", "left out", "assumed", "estimated", "unverified"]
Uses = Literal["inertia", "gas", "running", "bearings", "torsion", "mounts"]
"""What an answer is made of: what of it may be lacking differs."""
TRIAL = 0.01
"""Share by which a value without ends is varied."""
SIGNIFICANT = 1e-3
"""Effect below which an assumption does not matter to an answer."""
Figure = tuple[str, float | None]
"""A quantity (`force`, `couple`, `roll`) and an order; None where the quantity has no orders."""
Figures = Mapping[Figure, float]


@dataclass(frozen=True)
class Moved:
    """The figure that an assumption moves most, in the unit of its Balance or in N m.

    `now` is its value as given, `low` and `high` the ends over the range; `trial` says that the
    value has no range and was varied by TRIAL up and down.
    """

    quantity: str
    order: float | None
    unit: str
    now: float
    low: float
    high: float
    effect: float
    trial: bool = False


@dataclass(frozen=True)
class Assumption:
    """A value that an answer rests on and that the engine file does not give for certain.

    `value`, `low`, `high` are in the unit `unit`, None where there is no number; `reason` is a
    sentence of the catalog of messages, to be translated where it is shown, with `values` in it;
    `explained` says that it stands also where no figure does, as it says what to do; `named` that
    it is one of two choices, which is named where it moves a figure, without a range; `sentence` is
    one on all of its kind, with their {paths}, instead of that of their status.
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
    vary: Vary | None = None

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
    values that a question has of its own, as a sweep does. `gas` is the cycle that is part of the
    answer; `without_gas` the one that its rolling moment leaves out; `gasless` is the sentence on
    what gas is missing in where it is not known, empty where gas does not belong to the answer;
    `why_gasless` says why it is not in it though the file has some.
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


def moved(engine: Engine, found: Sequence[Assumption], answer: Answer) -> tuple[Assumption, ...]:
    """The assumptions with what each moves most, the largest first; without those of no effect.

    What is doubtful stands first; what cannot be varied stays, behind those that can.
    """
    now = answer.figures(engine)
    out: list[Assumption] = []
    for each in found:
        most = each.moved if each.vary is None else _moved(engine, each, now, answer)
        if most is not None and most.effect < SIGNIFICANT:
            continue
        out.append(each if each.named else replace(each, moved=most))
    return tuple(sorted(out, key=lambda each: (each.status != "doubtful", -each.effect)))


def _moved(engine: Engine, each: Assumption, now: Figures, answer: Answer) -> Moved | None:
    """The figure that one assumption moves most; None where an end is no engine."""
    vary = each.vary
    assert vary is not None  # noqa: S101  # asked before
    trial = each.low is None or each.high is None
    ends = (1 - TRIAL, 1 + TRIAL) if trial else (each.low, each.high)
    try:
        others = [
            answer.figures(vary(engine, float(end)))
            for end in dict.fromkeys(ends)
            if end is not None
        ]
    except (EngineError, MessageError):
        return None
    tops = dict(answer.least(engine))
    for (quantity, _order), size in (item for one in (now, *others) for item in one.items()):
        tops[quantity] = max(tops.get(quantity, 0.0), abs(size))
    best: Moved | None = None
    for key in dict.fromkeys(key for one in (now, *others) for key in one):
        quantity, order = key
        size = now.get(key, 0.0)
        sizes = [one.get(key, 0.0) for one in others]
        most = max(abs(other - size) for other in sizes)
        effect = most / tops[quantity] if tops[quantity] else 0.0
        if best is None or effect > best.effect * (1 + 1e-9):
            unit = answer.unit(quantity, engine)
            best = Moved(quantity, order, unit, size, min(sizes), max(sizes), effect, trial)
    return best
