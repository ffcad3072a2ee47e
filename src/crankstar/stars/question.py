"""What is asked of a search: which stars, by which objectives, within which limits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from math import inf, isnan

from crankstar.language.faults import Fault
from crankstar.stars.faults import SearchError, fault
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import Limit, Objective, VectorSum

KEPT = 64
"""Stars of each point of a front that are kept as examples."""
GREATEST_LIST = 200_000
"""Stars a list can have."""


@dataclass(frozen=True)
class Front:
    """Asks for the Pareto front: values that cannot be bettered without another getting worse.

    size: how many stars of each point are kept as examples.
    """

    size: int = KEPT


@dataclass(frozen=True)
class Best:
    """Asks for so many of the best stars by the (one) objective, mirrored ones once."""

    size: int = 20


@dataclass(frozen=True)
class All:
    """Asks for all stars within the limits, mirrored ones once, in the order of the objectives.

    size: how many of them are kept.
    """

    size: int = GREATEST_LIST


@dataclass(frozen=True)
class FunctionObjective:
    """A Python function of a star (a direction for each cylinder) as an objective or a limit.

    Less is better. It is called for every star within the limits, so these must leave few enough.
    symmetric: whether it is the same for mirrored stars and from the rear.
    """

    name: str
    function: Callable[[Star], float]
    greatest: float = inf
    symmetric: bool = False
    unit: str = ""


@dataclass(frozen=True)
class Question:
    """Which stars, by which objectives, within which limits, and which of them are the answer."""

    stars: Stars
    objectives: tuple[Objective, ...]
    limits: tuple[Limit, ...] = ()
    neighbours_at_most: float = inf
    ask: Front | Best | All = field(default_factory=Front)
    functions: tuple[FunctionObjective, ...] = ()

    def __post_init__(self) -> None:
        faults = list(self._faults())
        if faults:
            raise SearchError(faults)

    def _faults(self) -> Iterator[Fault]:
        stars = self.stars
        for vector in self.sums:
            if (len(vector.weights), len(vector.turns)) != (stars.cylinders, stars.directions):
                yield fault("", "other-stars", sum=vector.name, cylinders=len(vector.weights))
        for limit in self.limits:
            if not 0 <= limit.least <= limit.greatest:
                least, greatest = f"{limit.least:g}", f"{limit.greatest:g}"
                wrong = {"sum": limit.sum.name, "least": least, "greatest": greatest}
                yield fault("limit", "limit-range", **wrong)
        if not self.neighbours_at_most >= 0:
            yield fault("limit", "neighbours", given=f"{self.neighbours_at_most:g}")
        if isinstance(self.ask, Best) and not (self.objectives or self.functions):
            yield fault("minimise", "no-objective")
        if isinstance(self.ask, Best) and len(self.objectives) > 1:
            yield fault("minimise", "several-objectives")
        if self.ask.size < 1:
            yield fault("best", "list-size", given=self.ask.size)
        for function in self.functions:
            if isnan(function.greatest):
                yield fault("", "function-limit", name=function.name)

    @cached_property
    def sums(self) -> tuple[VectorSum, ...]:
        """The vector sums in objectives and limits, each once."""
        named = [vector for objective in self.objectives for _, vector in objective.terms]
        return tuple(dict.fromkeys([*named, *(limit.sum for limit in self.limits)]))

    @property
    def counts(self) -> bool:
        """Whether neighbours in succession are asked for."""
        return self.neighbours_at_most < inf or any(
            objective.neighbours for objective in self.objectives
        )

    @property
    def digest(self) -> str:
        """A digest that is the same for equal questions only, for a checkpoint."""
        functions = [(each.name, each.greatest, each.symmetric) for each in self.functions]
        words = repr(
            (self.stars, self.objectives, self.limits, self.neighbours_at_most, self.ask, functions)
        )
        return sha256(words.encode()).hexdigest()[:16]

    @cached_property
    def symmetries(self) -> tuple[tuple[int, int], ...]:
        """Changes that keep the values of a star: mirrored or not, reversed or not."""
        if self.stars.fixed or any(not each.symmetric for each in self.functions):
            return ((0, 0),)
        ends = self.stars.evenly_placed and not self.stars.symmetric
        if ends and all(_even(vector) for vector in self.sums):
            return ((0, 0), (1, 0), (0, 1), (1, 1))
        return ((0, 0), (1, 0))

    def images(self, star: Star) -> set[tuple[int, ...]]:
        """A star, mirrored, from the rear, where that keeps its values: the first of each place.

        Two stars with the same images are one in the answer.
        """
        row = tuple(star[members[0]] for members in self.stars.places)
        n = self.stars.directions
        out: set[tuple[int, ...]] = set()
        for mirrored, back in self.symmetries:
            image = row[::-1] if back else row
            zero = 0 if self.stars.fixed else image[0]
            out.add(tuple((-1 if mirrored else 1) * (d - zero) % n for d in image))
        return out


def _even(vector: VectorSum) -> bool:
    """Whether a sum is as long for a star taken from the rear."""
    ends = list(zip(vector.weights, reversed(vector.weights), strict=True))
    return all(a == b for a, b in ends) or all(a == -b for a, b in ends)
