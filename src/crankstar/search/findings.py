"""What a search answers: stars with their sums, exact zeros as zeros, how many there are, and what proves that these are all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crankstar.search import harvest, proof
from crankstar.search.checkpoint import Checkpoint
from crankstar.search.halves import halves
from crankstar.search.hands import Hands
from crankstar.search.harvest import Harvest
from crankstar.search.kernels import succession
from crankstar.search.question import All, Best, Front, Judge, Question
from crankstar.search.run import Outcome, Watch, searched
from crankstar.search.stars import SearchError, Star, Stars
from crankstar.search.sums import VectorSum


@dataclass(frozen=True)
class Finding:
    """A star, or of several with the same values the one with the fewest neighbours in succession, and how many there are.

    values: of the objectives in their units; neighbours: how many fire one after the other (in the best order); stars: how many
    stars have these values, turned ones once; classes: mirrored ones, and those from the rear, once; like: stars of other classes.
    """

    star: Star
    values: tuple[float, ...]
    neighbours: int
    stars: int
    classes: int
    like: tuple[Star, ...] = ()


@dataclass(frozen=True)
class Certificate:
    """Why an answer is all there is: what was searched, and what was found there.

    strips: sums, each with the length up to which all stars were met; whole: the strips hold all that the limits allow, else
    stars were found in them that nothing outside can equal; met: how many stars lie in the strips; of: how many there are;
    blocks: pieces in which they were searched.
    """

    strips: tuple[tuple[VectorSum, float], ...]
    whole: bool
    met: int
    of: int
    blocks: int
    attempts: int
    complete: bool
    interrupted: bool


@dataclass(frozen=True)
class Findings:
    """The answer to a question: findings in the order of its objectives, and its certificate."""

    question: Question
    rows: tuple[Finding, ...]
    stars: int | None
    """How many stars the answer holds, turned ones once, also those that are not listed; None in a list of the best."""
    certificate: Certificate

    @property
    def contradicted(self) -> bool:
        """Whether it is proved that no star keeps the limits."""
        return self.certificate.complete and not self.rows


def findings(
    question: Question,
    *,
    hands: Hands | None = None,
    stretch: int | None = None,
    checkpoint: Checkpoint | None = None,
    watch: Watch | None = None,
) -> Findings:
    """The answer to a question. Arguments as for `run.searched`.

    >>> from fractions import Fraction
    >>> from crankstar.search.sums import couple, of
    >>> six = Stars(6, "two-stroke", tuple(Fraction(5 - 2 * j, 2) for j in range(6)))
    >>> front = findings(Question(six, (of(couple(six, 1)), of(couple(six, 2)))))
    >>> [(round(one, 4), round(two, 4)) for one, two in (row.values for row in front.rows)]
    [(0.0, 3.4641), (1.7321, 3.0), (3.0, 1.7321), (3.4641, 0.0)]
    """
    outcome = searched(question, hands=hands, stretch=stretch, checkpoint=checkpoint, watch=watch)
    return read(outcome)


def read(outcome: Outcome) -> Findings:
    """An outcome in the units of the question, zeros proved, judges heard."""
    question, found = outcome.question, outcome.found
    found = _proved(question, found)
    if question.judges:
        found = _judged(question, found)
    unit = (*halves(outcome.asked).unit, *(1.0 for _ in question.judges))
    rows = tuple(_finding(question, found, group, unit) for group in _groups(question, found))
    stars = None if isinstance(question.ask, Best) else int(found.times.sum()) + found.beyond
    return Findings(question, rows, stars, _certificate(outcome))


def _groups(question: Question, found: Harvest) -> list[np.ndarray]:
    """Rows that make one finding: those of equal values in a front, each by itself in a list."""
    if isinstance(question.ask, Front):
        return harvest.groups(found)
    return list(np.arange(len(found)).reshape(-1, 1))


def _finding(question: Question, found: Harvest, group: np.ndarray, unit: Sequence[float]) -> Finding:
    stars = question.stars
    every = [stars.whole(tuple(int(d) for d in found.stars[row])) for row in group]
    ordered = sorted(every, key=lambda star: succeeding(stars, star)) if len(every) > 1 else every
    values = tuple(float(value) * size for value, size in zip(found.values[group[0], : len(unit)], unit, strict=True))
    if isinstance(question.ask, Front):
        many, classes = int(found.times[group].sum()), -(-int(found.classes[group].sum()) // len(question.symmetries))
    else:
        many, classes = images(question, ordered[0]), 1
    return Finding(
        ordered[0], _with_zeros(question, ordered[0], values), succeeding(stars, ordered[0]), many, classes, tuple(ordered[1:])
    )


def images(question: Question, star: Star) -> int:
    """How many stars a star of the answer stands for: itself, mirrored, from the rear."""
    places = question.stars.places
    row = tuple(star[members[0]] for members in places)
    n = question.stars.directions
    out = set()
    for mirrored, back in question.symmetries:
        image = row[::-1] if back else row
        zero = 0 if question.stars.fixed else image[0]
        out.add(tuple((-1 if mirrored else 1) * (d - zero) % n for d in image))
    return len(out)


def succeeding(stars: Stars, star: Star) -> int:
    """How many neighbours fire one after the other; where two cylinders share each direction, in the best order.

    >>> from fractions import Fraction
    >>> five = Stars(5, "four-stroke", tuple(Fraction(2 - j) for j in range(5)))
    >>> succeeding(five, (0, 3, 2, 4, 1)), succeeding(five, (0, 3, 1, 4, 2))
    (3, 4)
    """
    fault = stars.misfit(star)
    if fault:
        raise SearchError([fault])
    members = np.array([(place, -1) for place in range(stars.cylinders)], np.int64)
    seat = np.empty((stars.directions, 2), np.int64)
    return int(succession(np.array(star, np.int64), members, stars.step, stars.directions, seat))


def _with_zeros(question: Question, star: Star, values: tuple[float, ...]) -> tuple[float, ...]:
    """Values of which those that are proved to vanish are zero."""
    out = list(values)
    for place, objective in enumerate(question.objectives):
        small = abs(values[place]) < 1e-6 and not objective.neighbours
        if small and all(proof.vanishing(vector, [star])[0] for _, vector in objective.terms):
            out[place] = 0.0
    return tuple(out)


def _proved(question: Question, found: Harvest) -> Harvest:
    """What was found without stars whose sums are short enough to pass for zero and are not zero. Raises SearchError in a front."""
    zeros = [limit.sum for limit in question.limits if limit.greatest == 0]
    if not zeros or not len(found):
        return found
    stars = [question.stars.whole(tuple(row)) for row in found.stars.tolist()]
    good = np.logical_and.reduce([proof.vanishing(vector, stars) for vector in zeros])
    if not good.all() and not isinstance(question.ask, All):
        message = "a star's sum is nearer to zero than rounding shows, and is not zero; ask for all stars (--all) instead"
        raise SearchError([message])
    return harvest.taken(found, np.flatnonzero(good))


def _judged(question: Question, found: Harvest) -> Harvest:
    """What was found as the judges see it: their values beside the objectives', what they forbid left out."""
    if len(found) >= All().greatest:
        message = f"more than {All().greatest} stars are left to a Python function to judge; narrow the search with limits"
        raise SearchError([message])
    stars = [question.stars.whole(tuple(row)) for row in found.stars.tolist()]
    columns = [np.array([_verdict(judge, star) for star in stars]) for judge in question.judges]
    good = np.ones(len(stars), bool)
    for judge, column in zip(question.judges, columns, strict=True):
        good &= column <= judge.greatest
    values = found.values if question.objectives else found.values[:, :0]
    new = Harvest(np.column_stack([values, *columns]), found.stars, found.classes, found.times, found.met)
    return harvest.gathered([harvest.taken(new, np.flatnonzero(good))], question.ask)


def _verdict(judge: Judge, star: Star) -> float:
    """What a judge says of a star. Raises SearchError where that is no number, or the function fails."""
    try:
        value = float(judge.function(star))
    except Exception as error:  # it is the user's function: whatever it raises is told
        raise SearchError([f"{judge.name} fails for the star {star}: {type(error).__name__}: {error}"]) from error
    if not np.isfinite(value):
        raise SearchError([f"{judge.name} is {value} for the star {star}; it must be a finite number"])
    return value


def _certificate(outcome: Outcome) -> Certificate:
    question, tried = outcome.question, outcome.strips
    ready = halves(outcome.asked)
    strips = tuple((question.sums[place], radius * ready.size[place]) for place, radius in tried.radii if question.sums)
    return Certificate(
        tuple((vector, length * vector.scale) for vector, length in strips),
        tried.whole,
        outcome.found.met,
        question.stars.count,
        outcome.blocks,
        outcome.attempts,
        outcome.complete,
        outcome.interrupted,
    )
