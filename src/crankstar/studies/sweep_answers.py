"""What the results of a sweep rest on: the answer that it gives of the engine at one of its values.

That is the first value; of the speed and of a balance factor the highest, at which there is most.
What gas and vibration rest on may matter more at the other end (`more_beyond`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property, partial

import numpy as np

from crankstar.analysis.assumptions import TOLD, UNMOVED, Answer, Assumption
from crankstar.analysis.registry import analysis, measures, names
from crankstar.engine.basis import BALANCE_FACTOR
from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import cycle
from crankstar.studies.answer_parts import joined, narrowed
from crankstar.studies.answers import amplitudes, rests_on, torques
from crankstar.studies.fields import instead
from crankstar.studies.gas_results import GAS_WATCHABLE
from crankstar.studies.study import SPEED_PATH
from crankstar.studies.sweep import Axis, Curve, Sweep
from crankstar.studies.variants import SweepError

SOME = 1.5
"""How much more an assumption must move at the other end of a range to be told there too."""
NATURAL = " modes"
"""Behind the name of an analysis: free vibration alone."""
HIGHEST = (SPEED_PATH, BALANCE_FACTOR, *(f"gas.{load}" for load in LOADS))
"""Numbers of which the highest value is judged: a great load shows that there is a charger."""
FIGURES: Mapping[str, Sequence[str]] = {
    "force": ["force"],
    "couple": ["couple"],
    "roll": ["roll"],
    "axis_moment": ["roll"],
    "torque": ["roll"],
    "torque_with_gas": ["roll"],
    "roll_with_gas": ["roll"],
    "mean_torque": ["mean torque"],
    "peak_pressure": ["peak pressure"],
    "irregularity": ["irregularity"],
    **{name: measure.figures for name, (_record, measure) in measures().items()},
}
"""The quantities of an answer that say how far a result of a sweep moves."""


@dataclass(frozen=True)
class Judged:
    """The engine of a sweep at one of its values, and the answer that it gives.

    `speed` is in rad/s, None in m r omega^2, `alone` whether vibration is told at this one;
    `values` are the numbers with their units, by the key paths that are varied.
    """

    engine: Engine
    speed: float | None
    values: Mapping[str, str]
    curves: Sequence[Curve]
    alone: bool = False

    @property
    def at(self) -> str:
        """The values by key path, as text."""
        return ", ".join(f"{path} = {value}" for path, value in self.values.items())

    @cached_property
    def answer(self) -> Answer:
        """What the curves rest on; what is varied is in no doubt.

        Nor are the counterweights that a balance factor gives.
        """
        kinds: dict[str, list[Curve]] = {}
        for curve in self.curves:
            kinds.setdefault(kind_of(curve.what), []).append(curve)
        parts = [
            _answer(self.engine, self.speed, kind, own, alone=self.alone)
            for kind, own in kinds.items()
        ]
        answer = parts[0] if len(parts) == 1 else joined(parts)
        given = {path for own in self.values for path in (own, instead(own))}
        given |= {"crankshaft.weight"} if BALANCE_FACTOR in self.values else set()
        return replace(answer, given={*answer.given, *given})


def judged(sweep: Sweep, curves: Sequence[Curve], *, beyond: bool = False) -> Judged:
    """What the curves of a sweep rest on: at the first values, of some at the highest.

    With `beyond` at the other ends of the ranges, that of a closed one in its middle. Where a curve
    has no result there, at the values nearest to them at which all have one.
    """
    wanted = [
        _other_end(axis) if beyond else int(np.argmax(axis.values)) if axis.path in HIGHEST else 0
        for axis in sweep.axes
    ]
    places = _with_results(sweep, curves, wanted)
    try:
        engine, speed = sweep.case(places)
    except SweepError:  # it does not fire in the order of the file, which no inertia needs
        engine, speed = sweep.engine, sweep.speed
    values = {
        axis.path: f"{axis.values[place]:.6g} {axis.unit}".strip()
        for axis, place in zip(sweep.axes, places, strict=True)
    }
    return Judged(engine, speed, values, curves, sweep.alone)


def _with_results(sweep: Sweep, curves: Sequence[Curve], wanted: Sequence[int]) -> tuple[int, ...]:
    """The place on the axes nearest to the one wanted at which no curve has a gap, if there is."""
    gaps = {gap.place for curve in curves for gap in curve.gaps}
    places = (place for place in np.ndindex(sweep.shape) if _flat(sweep, place) not in gaps)
    if _flat(sweep, wanted) not in gaps:
        return tuple(wanted)
    return min(
        places,
        key=lambda place: sum(abs(a - b) for a, b in zip(place, wanted, strict=True)),
        default=tuple(wanted),
    )


def _flat(sweep: Sweep, place: Sequence[int]) -> int:
    return int(np.ravel_multi_index(tuple(place), sweep.shape))


def _other_end(axis: Axis) -> int:
    """The place of the last value, of what is judged at the highest of the least."""
    if axis.closed:
        return axis.values.size // 2
    return int(np.argmin(axis.values)) if axis.path in HIGHEST else axis.values.size - 1


def more_beyond(
    sweep: Sweep, curves: Sequence[Curve], found: Sequence[Assumption]
) -> tuple[str, tuple[Assumption, ...]]:
    """The values at the other ends, and what matters more there than where it was `found`.

    More by SOME of its effect. Nothing of inertia, of which each share is the same at every speed.
    """
    if all(kind_of(curve.what) in ("inertia", "roll") for curve in curves):
        return "", ()
    known = {each.path: each.effect for each in found}
    try:
        other = judged(sweep, curves, beyond=True)
        there = rests_on(other.engine, other.answer)
    except MessageError:  # it has no result there
        return "", ()
    least = {path: max(SOME * effect, TOLD) for path, effect in known.items()}
    more = [each for each in there if each.effect > least.get(each.path, TOLD) + UNMOVED]
    return other.at, tuple(more)


def kind_of(what: str) -> str:
    """Of which analysis a result is; modes are apart from what is forced."""
    if what in GAS_WATCHABLE:
        return "running" if what == "irregularity" else "gas"
    if what in measures():
        record, measure = measures()[what]
        return f"{record.name}{NATURAL}" if measure.natural else record.name
    return "roll" if what.partition(".")[0] in ("roll", "torque", "axis_moment") else "inertia"


def _answer(
    engine: Engine, speed: float | None, kind: str, curves: Sequence[Curve], *, alone: bool
) -> Answer:
    """The answer of one kind, about the results that are watched and their orders."""
    if kind in ("gas", "running"):
        whole = torques(engine, partial(cycle, speed=speed), running=kind == "running")
    elif kind.removesuffix(NATURAL) in names():
        record = analysis(kind.removesuffix(NATURAL))
        question = record.question.value
        ranged = (
            alone and speed is not None and any(one.name == "speeds" for one in fields(question))
        )
        asked = question(speeds=(speed,)) if ranged else question(speed=speed)
        natural = record.natural if kind.endswith(NATURAL) else None
        whole = record.answering(engine, asked) if natural is None else natural.value()
    else:
        whole = amplitudes(engine, speed=speed, gas=kind == "inertia")
    watched = [name for curve in curves for name in FIGURES[curve.what.partition(".")[0]]]
    orders = [curve.order for curve in curves if curve.order is not None]
    by_order = len(orders) == len(curves) and kind in ("inertia", "roll")
    return narrowed(
        whole,
        [*dict.fromkeys(watched)],
        orders=orders if by_order else None,
        given=_frictions(engine) if kind == "gas" else (),
    )


def _frictions(engine: Engine) -> list[str]:
    """The key paths of the friction of an engine, on which no indicated result depends."""
    points = () if engine.gas is None else engine.gas.points
    places = ["gas", *(f"gas.point[{number}]" for number, _point in enumerate(points, 1))]
    return [f"{place}.friction_pressure" for place in places]
