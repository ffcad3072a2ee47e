"""What is asked of a search: which stars, judged by what, within which limits, and which of them are the answer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from math import inf

from crankstar.search.stars import Star, Stars
from crankstar.search.sums import Limit, Objective, VectorSum

KEPT = 16
"""Stars of each point of a front that are kept as examples."""
GREATEST_LIST = 200_000
"""Stars a list can have."""


@dataclass(frozen=True)
class Front:
    """Asks for the Pareto front: all values of the objectives of which none can be bettered without another getting worse."""

    examples: int = KEPT


@dataclass(frozen=True)
class Best:
    """Asks for the best stars by the (one) objective, classes of mirrored stars once."""

    count: int = 20


@dataclass(frozen=True)
class All:
    """Asks for all stars within the limits, classes of mirrored stars once, in the order of the objectives."""

    greatest: int = GREATEST_LIST


@dataclass(frozen=True)
class Judge:
    """A Python function as an objective or a limit: of a star (a direction for each cylinder), less is better.

    It is asked about every star within the limits, so these must leave few enough. `symmetric`: whether it is the same for
    mirrored stars and from the rear.
    """

    name: str
    function: Callable[[Star], float]
    greatest: float = inf
    symmetric: bool = False
    unit: str = ""


@dataclass(frozen=True)
class Question:
    """Which stars, judged by what, within which limits, and what is the answer."""

    stars: Stars
    objectives: tuple[Objective, ...]
    limits: tuple[Limit, ...] = ()
    neighbours_at_most: float = inf
    ask: Front | Best | All = field(default_factory=Front)
    judges: tuple[Judge, ...] = ()

    @cached_property
    def sums(self) -> tuple[VectorSum, ...]:
        """The vector sums it speaks of, each once."""
        named = [vector for objective in self.objectives for _, vector in objective.terms]
        return tuple(dict.fromkeys([*named, *(limit.sum for limit in self.limits)]))

    @property
    def counts(self) -> bool:
        """Whether neighbours in succession are asked for."""
        return self.neighbours_at_most < inf or any(objective.neighbours for objective in self.objectives)

    @property
    def digest(self) -> str:
        """What tells this question from others, for a checkpoint."""
        judged = [(judge.name, judge.greatest, judge.symmetric) for judge in self.judges]
        words = repr((self.stars, self.objectives, self.limits, self.neighbours_at_most, self.ask, judged))
        return sha256(words.encode()).hexdigest()[:16]

    @cached_property
    def symmetries(self) -> tuple[tuple[int, int], ...]:
        """Changes of a star that leave its values: mirrored or not, from the rear or not. The first changes nothing."""
        if self.stars.fixed or any(not judge.symmetric for judge in self.judges):
            return ((0, 0),)
        ends = self.stars.evenly_placed and not self.stars.symmetric
        if ends and all(_even(vector) for vector in self.sums):
            return ((0, 0), (1, 0), (0, 1), (1, 1))
        return ((0, 0), (1, 0))


def _even(vector: VectorSum) -> bool:
    """Whether a sum is as long for a star taken from the rear."""
    ends = list(zip(vector.weights, reversed(vector.weights), strict=True))
    return all(a == b for a, b in ends) or all(a == -b for a, b in ends)
