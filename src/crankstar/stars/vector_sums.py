"""Sums of vectors over a shaft with its firing sequence: forces, couples and torsion.

Alike cylinders at dead centre t_p (first rods) give, in order k,

    F_k = s_k |sum over throws of exp(-i k t_p)|
    M_k = s_k |sum over throws of z_p exp(-i k t_p)|

with s_k = 1 in line. With two rods on each pin and a bank angle V the pin pushes with
cos((k - 1) V/2) of two cylinders along with the crankshaft and cos((k + 1) V/2) against it, so that
s_k = |cos((k - 1) V/2)| + |cos((k + 1) V/2)|. Of order 1 counterweights can take all that turns
with the crankshaft; |cos V| of the sum (in line half of it) they leave: the same for every star but
for the sum itself, so that to minimise M_1 is also to minimise M_1 after counterweights.

Torsion weighs the firing angles theta_j of the cylinders with the amplitude a_j of a mode:

    T_k = |sum over cylinders of a_j exp(-i k theta_j)|

Of two cylinders of a class (dead centres that coincide) one fires a turn later, so that for a half
order their vectors are opposed, and for a whole one parallel: whole orders belong to the star, half
orders are sum over classes c of +-(a_u - a_v) exp(-i k c step), the signs being the sequence.

Source: C. F. Taylor, The Internal Combustion Engine in Theory and Practice, vol. 2, chapter 8, for
F_k and M_k; J. P. Den Hartog, Mechanical Vibrations, section 5.4 (star diagrams of torsion).
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from hashlib import sha256
from math import cos, inf, isfinite, isnan, radians
from typing import Literal

from crankstar.derive.algebra import cyclotomic
from crankstar.language.quoting import seen
from crankstar.stars.faults import SearchError, error, fault
from crankstar.stars.shafts import Fired, Shaft, followed

MOST_GOALS = 4
"""Goals of one front."""
SMALL = 1e-9
"""Share of the sum of all weights below which a sum is looked at exactly."""
SLACK = 1e-8
"""By which a sum may be longer than its limit; zero is exact."""
NOTHING = 1e-12
"""A scale below which an order is balanced between the two banks of each pin."""


@dataclass(frozen=True)
class OrderSum:
    """F_k, M_k or T_k; weights: of each throw (F, M), or of each rod by throw and bank (T)."""

    kind: Literal["F", "M", "T"]
    order: Fraction
    weights: tuple[Fraction, ...]
    scale: float = 1.0

    @property
    def name(self) -> str:
        """As it is written: M1, T2.5."""
        return f"{self.kind}{float(self.order):g}"

    @property
    def unit(self) -> str:
        """The unit; a torsion counts in the gas torque of one cylinder."""
        if self.kind == "T":
            return ""
        force = "m*r*w^2" if self.order == 1 else f"m*r*w^2*A_{self.order}"
        return force if self.kind == "F" else f"{force}*a"

    @property
    def half(self) -> bool:
        """Whether it is a torsion of a half order."""
        return self.order.denominator == 2

    def exact(self, shaft: Shaft, fired: Fired) -> cyclotomic.Number:
        """The sum without its scale, exactly."""
        angles = shaft.angles_deg(fired)
        total = cyclotomic.rational(0)
        for weight, number in zip(self.weights, self._numbers(shaft), strict=True):
            turn = -self.order * angles[number] / 360
            total = total + cyclotomic.root(turn).times(weight)
        return total

    def _numbers(self, shaft: Shaft) -> list[int]:
        """The cylinder of each weight: of a force or couple the first of each throw."""
        rods = shaft.rods if self.kind == "T" else 1
        return [number for pin in shaft.numbers for number in pin[:rods]]

    def length(self, shaft: Shaft, fired: Fired) -> float:
        """How long it is, exact zeros as zero.

        >>> from crankstar.stars.shafts import shaft_of
        >>> vee = shaft_of(8, bank_angle_deg=90)
        >>> cross = vee.fired_in((1, 8, 4, 3, 6, 5, 7, 2))
        >>> round(couple(vee, 1).length(vee, cross) ** 2, 9), force(vee, 2).length(vee, cross)
        (10.0, 0.0)
        """
        steps = shaft.steps(fired)
        step = radians(float(self.order * shaft.step_deg))
        near = sum(
            float(weight) * rect(1.0, -step * steps[number])
            for weight, number in zip(self.weights, self._numbers(shaft), strict=True)
        )
        if self.scale < NOTHING:
            return 0.0
        small = abs(near) < SMALL * sum(map(abs, self.weights))
        return 0.0 if small and self.exact(shaft, fired).zero else self.scale * abs(near)


def shares(shaft: Shaft, order: int) -> tuple[float, float]:
    """The parts of s_k that turn with and against the crankshaft.

    >>> from crankstar.stars.shafts import shaft_of
    >>> [round(share, 6) for share in shares(shaft_of(12, bank_angle_deg=60), 1)]
    [1.0, 0.5]
    """
    if shaft.rods == 1:
        return 0.5, 0.5
    half = radians(float(shaft.bank_angle_deg)) / 2
    parts = [abs(cos((order + way) * half)) for way in (-1, 1)]
    along, against = (part if part > NOTHING else 0.0 for part in parts)
    return along, against


def force(shaft: Shaft, order: int) -> OrderSum:
    """F_k of a shaft."""
    return OrderSum("F", Fraction(order), (Fraction(1),) * shaft.throws, sum(shares(shaft, order)))


def couple(shaft: Shaft, order: int) -> OrderSum:
    """M_k of a shaft about its middle."""
    return OrderSum("M", Fraction(order), shaft.places, sum(shares(shaft, order)))


def straight(shaft: Shaft) -> tuple[Fraction, ...]:
    """The shape that goes evenly from 1 at the farther end of the shaft, by throw and rod.

    >>> from crankstar.stars.shafts import shaft_of
    >>> [str(each) for each in straight(shaft_of(4))]
    ['1', '1/3', '-1/3', '-1']
    """
    middle = sum(shaft.places, Fraction(0)) / shaft.throws
    farthest = max(abs(place - middle) for place in shaft.places)
    return tuple((place - middle) / farthest for place in shaft.places for _ in range(shaft.rods))


def shape_of(shaft: Shaft, amplitudes: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """A shape by throw and rod, of an amplitude for each cylinder by its number, or each throw.

    Raises SearchError where there are others.

    >>> from crankstar.stars.shafts import shaft_of
    >>> vee = shaft_of(4, bank_angle_deg=180)
    >>> shape_of(vee, (Fraction(1), Fraction(-1))) == straight(vee)
    True
    """
    if len(amplitudes) == shaft.cylinders:
        numbers = sorted(number for pin in shaft.numbers for number in pin)
        own = dict(zip(numbers, amplitudes, strict=True))
        return tuple(own[number] for pin in shaft.numbers for number in pin)
    if len(amplitudes) == shaft.throws:
        return tuple(each for each in amplitudes for _ in range(shaft.rods))
    counts = {"given": len(amplitudes), "throws": shaft.throws, "cylinders": shaft.cylinders}
    raise error("mode_shape", "shape-throws", **counts)


def torsion(shaft: Shaft, order: Fraction, shape: Sequence[Fraction]) -> OrderSum:
    """T_k of a shaft in a shape, amplitudes by throw and rod. Raises SearchError.

    >>> from crankstar.stars.shafts import shaft_of
    >>> six = shaft_of(6)
    >>> usual = six.fired_in((1, 5, 3, 6, 2, 4))
    >>> round(torsion(six, Fraction(3, 2), straight(six)).length(six, usual), 9)  # 2 (1 + 3 + 5)/5
    3.6
    """
    name = f"T{float(order):g}"
    if order.denominator > 2:
        raise error("orders", "torsion-order", name=name)
    if shaft.cycle == "two-stroke" and order.denominator != 1:
        raise error("", "two-stroke-torsion", name=name)
    return OrderSum("T", order, tuple(shape))


@dataclass(frozen=True)
class Goal:
    """The largest of some sums, to be minimised; or the number of neighbours in succession."""

    name: str
    sums: tuple[OrderSum, ...]
    neighbours: bool = False

    @property
    def unit(self) -> str:
        """The unit of its sums."""
        return "" if self.neighbours else self.sums[0].unit

    def value(self, shaft: Shaft, fired: Fired) -> float:
        """The largest of its sums for a star with its sequence."""
        if self.neighbours:
            return float(len(followed(shaft, shaft.firing_order(fired)).neighbours))
        return max(each.length(shaft, fired) for each in self.sums)


NEIGHBOURS = Goal("neighbours", (), neighbours=True)
"""How many cylinders that stand side by side in a bank fire in succession."""


def _absent(fired: Fired) -> float:
    """Stands in for a function on its way to the workers, since not every function can be sent."""
    raise NotImplementedError(fired)


@dataclass(frozen=True)
class FunctionGoal(Goal):
    """A Python function of a star with its sequence, to be minimised. See `function_goal`."""

    function: Callable[[Fired], float] = field(default=_absent, repr=False)
    greatest: float = inf
    symmetric: bool = False
    function_unit: str = ""

    @property
    def unit(self) -> str:
        """The unit that was given."""
        return self.function_unit

    def value(self, shaft: Shaft, fired: Fired) -> float:
        """What the function makes of a star with its sequence. Raises SearchError."""
        order = "-".join(map(str, shaft.firing_order(fired)))
        try:
            value = float(self.function(fired))
        except Exception as raised:  # the user's function may raise anything
            what = f"{type(raised).__name__}: {raised}"
            raise error(
                "", "function-order-failed", name=self.name, order=order, error=what
            ) from raised
        if not isfinite(value):
            raise error("", "function-order-value", name=self.name, given=value, order=order)
        return value


def function_goal(
    name: str,
    function: Callable[[Fired], float],
    *,
    greatest: float = inf,
    symmetric: bool = False,
    unit: str = "",
) -> FunctionGoal:
    """A Python function of a star with its sequence as a goal; less is better.

    It is called for every order within the limits, so these must leave few enough. greatest: orders
    with more are left out; symmetric: whether it is the same for mirror images; name: one line that
    no other goal of the question has.

    >>> from crankstar.stars.shafts import shaft_of
    >>> six = shaft_of(6)
    >>> late = function_goal("late", lambda fired: six.firing_order(fired).index(6))
    >>> late.value(six, six.fired_in((1, 5, 3, 6, 2, 4)))
    3.0
    """
    return FunctionGoal(
        name, (), function=function, greatest=greatest, symmetric=symmetric, function_unit=unit
    )


@dataclass(frozen=True)
class Cap:
    """A sum that belongs to the star and may be at most so long; 0: it vanishes, exactly."""

    sum: OrderSum
    greatest: float = 0.0


@dataclass(frozen=True)
class SequenceQuestion:
    """Which stars with which sequences are on the front of some goals, within some caps.

    neighbours_at_most: how many cylinders side by side in a bank may fire in succession; size: how
    many orders of each point of the front are kept.
    """

    shaft: Shaft
    goals: tuple[Goal, ...]
    caps: tuple[Cap, ...] = ()
    neighbours_at_most: int | None = None
    size: int = 16

    def __post_init__(self) -> None:
        faults = [
            fault("limit", "cap-sequence", name=cap.sum.name)
            for cap in self.caps
            if self.of_sequence(cap.sum)
        ]
        if not 1 <= len(self.goals) <= MOST_GOALS:
            wrong = {"count": len(self.goals), "most": MOST_GOALS}
            faults.append(fault("minimise", "too-many-objectives", **wrong))
        if any(not 0 <= cap.greatest < inf for cap in self.caps):
            faults.append(fault("limit", "cap-value"))
        faults += [
            fault("", "function-limit", name=each.name)
            for each in self.functions
            if isnan(each.greatest)
        ]
        names = [goal.name for goal in self.goals]
        faults += [
            fault("minimise", "named-twice", name=name, count=names.count(name))
            for name in dict.fromkeys(names)
            if names.count(name) > 1
        ]
        faults += [
            fault("", "function-name", given=seen(each.name))
            for each in self.functions
            if not each.name.strip() or not each.name.isprintable()
        ]
        if faults:
            raise SearchError(faults)

    def of_sequence(self, one: OrderSum) -> bool:
        """Whether a sum differs between the firing sequences of a star."""
        return one.half and self.shaft.room == 2

    @cached_property
    def star_sums(self) -> tuple[OrderSum, ...]:
        """The sums in goals and caps that the star decides, each once."""
        named = [one for goal in self.goals for one in goal.sums]
        every = dict.fromkeys([*named, *(cap.sum for cap in self.caps)])
        return tuple(one for one in every if not self.of_sequence(one))

    @cached_property
    def sequence_sums(self) -> tuple[OrderSum, ...]:
        """The sums in goals that the sequence decides, each once."""
        every = dict.fromkeys(one for goal in self.goals for one in goal.sums)
        return tuple(one for one in every if self.of_sequence(one))

    @property
    def counts(self) -> bool:
        """Whether neighbours in succession matter."""
        return NEIGHBOURS in self.goals or self.neighbours_at_most is not None

    @property
    def functions(self) -> tuple[FunctionGoal, ...]:
        """The goals that are Python functions."""
        return tuple(goal for goal in self.goals if isinstance(goal, FunctionGoal))

    @property
    def sent(self) -> SequenceQuestion:
        """The question as workers are sent it: without the functions, which they do not call."""
        if not self.functions:
            return self
        goals = (
            replace(goal, function=_absent) if isinstance(goal, FunctionGoal) else goal
            for goal in self.goals
        )
        return replace(self, goals=tuple(goals))

    @property
    def digest(self) -> str:
        """A digest that is the same for equal questions only, for a checkpoint."""
        return sha256(f"sequences {self!r}".encode()).hexdigest()[:16]

    def values(self, fired: Fired) -> tuple[float, ...]:
        """The values of the goals, exact zeros as zero."""
        return tuple(goal.value(self.shaft, fired) for goal in self.goals)

    def kept(self, fired: Fired) -> bool:
        """Whether a star keeps the caps, functions apart."""
        most = self.neighbours_at_most
        if most is not None and NEIGHBOURS.value(self.shaft, fired) > most:
            return False
        return all(
            cap.sum.length(self.shaft, fired) <= (cap.greatest and cap.greatest + SLACK)
            for cap in self.caps
        )

    def within(self, fired: Fired) -> bool:
        """Whether a star keeps all limits."""
        return self.kept(fired) and all(
            each.greatest == inf or each.value(self.shaft, fired) <= each.greatest
            for each in self.functions
        )
