"""The stars of a shaft divided by the classes of their first throws, and the work on a part."""

from __future__ import annotations

import threading
from dataclasses import dataclass

import numpy as np

from crankstar.stars import sequence_kernels
from crankstar.stars.sequence_arrays import FORMED, FOUND, KNOWN, STARS, SequenceOutput
from crankstar.stars.sequence_rows import GREATEST_FRONT, Rows
from crankstar.stars.sequence_tables import mirrored, tables_of, walk_of, width_of
from crankstar.stars.vector_sums import SequenceQuestion

BUFFER = 1 << 13
"""Rows that are collected before they are merged, beside those that one star can bring."""
PARTS = 64
"""Parts into which the stars are divided, at least, where there are so many."""
OF_A_PART = 10_000
"""Stars that a part has at least; to begin one takes as long as to visit a thousand."""


@dataclass(frozen=True)
class SequenceResults:
    """What was found in a part.

    stars: visited; formed: sequences that were looked at; whole: the part was not halted.
    """

    rows: Rows
    stars: int = 0
    formed: int = 0
    whole: bool = True

    def joined(self, other: SequenceResults, question: SequenceQuestion) -> SequenceResults:
        """What was found in both; whole where both are."""
        return SequenceResults(
            self.rows.joined(other.rows, question),
            self.stars + other.stars,
            self.formed + other.formed,
            self.whole and other.whole,
        )


@dataclass(frozen=True)
class SequencePart:
    """The stars with some of the prefixes, from start up to stop.

    prefixes: classes of the first throws [stop - start, throws]; known: points of the front that
    are known before; halt: what ends the work between two calls of the loops.
    """

    question: SequenceQuestion
    start: int
    stop: int
    prefixes: np.ndarray
    known: np.ndarray
    halt: threading.Event | None = None

    def results(self) -> SequenceResults:
        """What is found with the prefixes."""
        out = SequenceResults(Rows.nothing(len(self.question.goals), self.question.shaft))
        for prefix in self.prefixes:
            out = out.joined(_results(self, prefix), self.question)
        return out


def prefixes(question: SequenceQuestion) -> np.ndarray:
    """The classes of the first throws, enough to make so many parts; of mirror images the first.

    Those in between are begun first: their couples are small sooner than those of the ends.
    """
    shaft, once = question.shaft, mirrored(question)
    listed: list[tuple[int, ...]] = [(0,)]
    wanted = min(PARTS, shaft.count // OF_A_PART + 1)
    while len(listed) < wanted and len(listed[0]) < shaft.throws:
        listed = [(*row, own) for row in listed for own in range(shaft.classes)]
        if once:
            listed = [row for row in listed if _first(row, shaft.classes)]
    return np.array(sorted(listed, key=lambda row: abs(row[-1] - shaft.classes / 2)), np.int64)


def _first(row: tuple[int, ...], classes: int) -> bool:
    return row <= tuple((classes - own) % classes for own in row)


def _results(part: SequencePart, prefix: np.ndarray) -> SequenceResults:
    """What is found with a prefix."""
    question = part.question
    shaft, goals = question.shaft, len(question.goals)
    tables, _ = tables_of(question)
    walk, most = walk_of(shaft, tables), shaft.sequences
    rows = BUFFER + most
    output = SequenceOutput(
        np.empty((rows, goals)),
        np.empty((rows, width_of(shaft)), np.int8),
        np.empty(rows, np.int64),
    )
    front = np.empty((GREATEST_FRONT, goals))
    state = np.zeros(5, np.int64)
    state[KNOWN] = min(len(part.known), GREATEST_FRONT)
    front[: state[KNOWN]] = part.known[: state[KNOWN]]
    found, ended = Rows.nothing(goals, shaft), False
    while not ended and not (part.halt and part.halt.is_set()):
        ended = sequence_kernels.visited(tables, prefix, walk, output, front, most, state)
        values, lines, times = (array[: state[FOUND]].copy() for array in output)
        state[FOUND] = 0
        new = Rows(values, lines, times, front[:0])
        if question.functions:
            found = found.beside(new)
        else:  # what was known is in the front of the loops, too
            found = found.sifted(new, front[: state[KNOWN]], question.size)
    rows = found if question.functions else found.own
    return SequenceResults(rows, int(state[STARS]), int(state[FORMED]), ended)
