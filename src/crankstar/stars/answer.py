"""The answer of a search: stars with exact zeros, how many there are, and the proof of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crankstar.stars import proof, results
from crankstar.stars.checkpoint import Checkpoint
from crankstar.stars.executors import Workers
from crankstar.stars.faults import SearchError, error
from crankstar.stars.halves import halves
from crankstar.stars.kernels import succession
from crankstar.stars.question import All, Best, Front, FunctionObjective, Question
from crankstar.stars.results import Results
from crankstar.stars.run import Outcome, Watch, searched
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import VectorSum


@dataclass(frozen=True)
class AnswerRow:
    """A star; of several with the same values, that with the fewest neighbours in succession.

    values: of the objectives in their units; neighbours: how many fire one after the other (in the
    best order); stars: how many stars have these values, turned ones once; classes: mirrored ones,
    and those from the rear, once; like: stars of other classes.
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

    regions: sums, each with the length up to which all stars were met; whole: the regions hold all
    that the limits allow, else stars were found in them that nothing outside can equal; met: how
    many stars lie in the regions; of: how many there are; blocks: pieces in which they were
    searched.
    """

    regions: tuple[tuple[VectorSum, float], ...]
    whole: bool
    met: int
    of: int
    blocks: int
    attempts: int
    complete: bool
    interrupted: bool


@dataclass(frozen=True)
class Answer:
    """The answer to a question: answer_to in the order of its objectives, and its certificate."""

    question: Question
    rows: tuple[AnswerRow, ...]
    stars: int | None
    """How many stars the answer holds, turned ones once, also those that are not listed.

    None in a list of the best.
    """
    certificate: Certificate

    @property
    def contradicted(self) -> bool:
        """Whether it is proved that no star keeps the limits."""
        return self.certificate.complete and not self.rows


def answer_to(
    question: Question,
    *,
    workers: Workers | None = None,
    range_size: int | None = None,
    checkpoint: Checkpoint | None = None,
    watch: Watch | None = None,
) -> Answer:
    """The answer to a question. Arguments as for `run.searched`.

    >>> from fractions import Fraction
    >>> from crankstar.stars.sums import couple, of
    >>> six = Stars(6, "two-stroke", tuple(Fraction(5 - 2 * j, 2) for j in range(6)))
    >>> front = answer_to(Question(six, (of(couple(six, 1)), of(couple(six, 2)))))
    >>> [(round(one, 4), round(two, 4)) for one, two in (row.values for row in front.rows)]
    [(0.0, 3.4641), (1.7321, 3.0), (3.0, 1.7321), (3.4641, 0.0)]
    """
    outcome = searched(
        question, workers=workers, range_size=range_size, checkpoint=checkpoint, watch=watch
    )
    return read(outcome)


def read(outcome: Outcome) -> Answer:
    """An outcome in the units of the question, zeros proved, functions evaluated."""
    question, listed = outcome.question, outcome.results
    listed = _proved(question, listed)
    if question.functions:
        listed = _evaluated(question, listed)
    unit = (*halves(outcome.asked).unit, *(1.0 for _ in question.functions))
    rows = tuple(_finding(question, listed, group, unit) for group in _groups(question, listed))
    stars = None if isinstance(question.ask, Best) else int(listed.times.sum()) + listed.beyond
    return Answer(question, rows, stars, _certificate(outcome))


def _groups(question: Question, listed: Results) -> list[np.ndarray]:
    """Rows that make one finding: those of equal values in a front, each by itself in a list."""
    if isinstance(question.ask, Front):
        return results.groups(listed)
    return list(np.arange(len(listed)).reshape(-1, 1))


def _finding(
    question: Question, listed: Results, group: np.ndarray, unit: Sequence[float]
) -> AnswerRow:
    stars = question.stars
    every = [stars.whole(tuple(int(d) for d in listed.stars[row])) for row in group]
    ordered = sorted(every, key=lambda star: succeeding(stars, star)) if len(every) > 1 else every
    values = tuple(
        float(value) * size
        for value, size in zip(listed.values[group[0], : len(unit)], unit, strict=True)
    )
    if isinstance(question.ask, Front):
        many, classes = (
            int(listed.times[group].sum()),
            -(-int(listed.classes[group].sum()) // len(question.symmetries)),
        )
    else:
        many, classes = images(question, ordered[0]), 1
    return AnswerRow(
        ordered[0],
        _with_zeros(question, ordered[0], values),
        succeeding(stars, ordered[0]),
        many,
        classes,
        tuple(ordered[1:]),
    )


def images(question: Question, star: Star) -> int:
    """How many stars a star of the answer stands for: itself, mirrored, from the rear."""
    return len(question.images(star))


def succeeding(stars: Stars, star: Star) -> int:
    """The number of neighbours that fire one after the other.

    Where two cylinders share each direction, that of the best order.

    >>> from fractions import Fraction
    >>> five = Stars(5, "four-stroke", tuple(Fraction(2 - j) for j in range(5)))
    >>> succeeding(five, (0, 3, 2, 4, 1)), succeeding(five, (0, 3, 1, 4, 2))
    (3, 4)
    """
    misfit = stars.misfit(star)
    if misfit:
        raise SearchError([misfit])
    members = np.array([(index, -1) for index in range(stars.cylinders)], np.int64)
    seat = np.empty((stars.directions, 2), np.int64)
    return int(succession(np.array(star, np.int64), members, stars.step, stars.directions, seat))


def _with_zeros(question: Question, star: Star, values: tuple[float, ...]) -> tuple[float, ...]:
    """Values of which those that are proved to vanish are zero."""
    out = list(values)
    for index, objective in enumerate(question.objectives):
        small = abs(values[index]) < 1e-6 and not objective.neighbours
        if small and all(proof.vanishing(vector, [star])[0] for _, vector in objective.terms):
            out[index] = 0.0
    return tuple(out)


def _proved(question: Question, listed: Results) -> Results:
    """Results without stars whose sums are nearly but not exactly zero; SearchError in a front."""
    zeros = [limit.sum for limit in question.limits if limit.greatest == 0]
    if not zeros or not len(listed):
        return listed
    stars = [question.stars.whole(tuple(row)) for row in listed.stars.tolist()]
    good = np.logical_and.reduce([proof.vanishing(vector, stars) for vector in zeros])
    if not good.all() and not isinstance(question.ask, All):
        raise error("zero", "near-zero")
    return results.taken(listed, np.flatnonzero(good))


def _evaluated(question: Question, listed: Results) -> Results:
    """Results with the values of functions beside the objectives, those beyond limits left out."""
    if len(listed) >= All().size:
        raise error("", "function-stars", most=All().size)
    stars = [question.stars.whole(tuple(row)) for row in listed.stars.tolist()]
    columns = [
        np.array([_value(function, star) for star in stars]) for function in question.functions
    ]
    good = np.ones(len(stars), bool)
    for function, column in zip(question.functions, columns, strict=True):
        good &= column <= function.greatest
    values = listed.values if question.objectives else listed.values[:, :0]
    new = Results(
        np.column_stack([values, *columns]), listed.stars, listed.classes, listed.times, listed.met
    )
    return results.merged([results.taken(new, np.flatnonzero(good))], question.ask)


def _value(function: FunctionObjective, star: Star) -> float:
    """The value of a function for a star; raises SearchError if it fails or is not a number."""
    try:
        value = float(function.function(star))
    except Exception as raised:  # the user's function may raise anything
        what = f"{type(raised).__name__}: {raised}"
        raise error(
            "", "function-failed", name=function.name, star=str(star), error=what
        ) from raised
    if not np.isfinite(value):
        raise error("", "function-value", name=function.name, given=value, star=str(star))
    return value


def _certificate(outcome: Outcome) -> Certificate:
    question, tried = outcome.question, outcome.regions
    ready = halves(outcome.asked)
    regions = tuple(
        (question.sums[place], radius * ready.size[place])
        for place, radius in tried.radii
        if question.sums
    )
    return Certificate(
        tuple((vector, length * vector.scale) for vector, length in regions),
        tried.whole,
        outcome.results.met,
        question.stars.count,
        outcome.blocks,
        outcome.attempts,
        outcome.complete,
        outcome.interrupted,
    )
