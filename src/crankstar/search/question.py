"""What is asked of a search: which stars, judged by what, within which limits, and which of them are the answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from math import inf, isnan

from crankstar.search.stars import SearchError, Star, Stars
from crankstar.search.sums import Limit, Objective, VectorSum

KEPT = 64
"""Stars of each point of a front that are kept as examples."""
GREATEST_LIST = 200_000
"""Stars a list can have."""


@dataclass(frozen=True)
class Front:
    """Asks for the Pareto front: all values of the objectives of which none can be bettered without another getting worse."""

    examples: int = KEPT

    @property
    def size(self) -> int:
        """How many stars are kept, of each point."""
        return self.examples


@dataclass(frozen=True)
class Best:
    """Asks for the best stars by the (one) objective, classes of mirrored stars once."""

    count: int = 20

    @property
    def size(self) -> int:
        """How many stars are kept."""
        return self.count


@dataclass(frozen=True)
class All:
    """Asks for all stars within the limits, classes of mirrored stars once, in the order of the objectives."""

    greatest: int = GREATEST_LIST

    @property
    def size(self) -> int:
        """How many stars are kept."""
        return self.greatest


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

    def __post_init__(self) -> None:
        faults = list(self._faults())
        if faults:
            raise SearchError(faults)

    def _faults(self) -> Iterator[str]:
        for vector in self.sums:
            if (len(vector.weights), len(vector.turns)) != (self.stars.cylinders, self.stars.directions):
                yield f"{vector.name} is a sum over other stars: {len(vector.weights)} cylinders in {len(vector.turns)} directions"
        for limit in self.limits:
            if not 0 <= limit.least <= limit.greatest:
                yield f"{limit.sum.name} cannot be from {limit.least:g} to {limit.greatest:g} long"
        if not self.neighbours_at_most >= 0:
            yield f"{self.neighbours_at_most:g} neighbours in succession cannot be; give a number from 0 up"
        if isinstance(self.ask, Best) and len(self.objectives) + len(self.judges) < 1:
            yield "the best by nothing cannot be told; give an objective"
        if isinstance(self.ask, Best) and len(self.objectives) > 1:
            yield "a list of the best has one objective; put several together in one"
        least = (
            self.ask.examples
            if isinstance(self.ask, Front)
            else self.ask.count
            if isinstance(self.ask, Best)
            else self.ask.greatest
        )
        if least < 1:
            yield f"a list of {least} cannot be; ask for at least 1"
        yield from (f"{judge.name}: at most {judge.greatest} cannot be" for judge in self.judges if isnan(judge.greatest))

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
