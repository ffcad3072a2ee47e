"""Orders found by the loops over stars and sequences, merged in whatever sequence they come."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from crankstar.stars import sign_kernels
from crankstar.stars.faults import error
from crankstar.stars.sequence_tables import width_of
from crankstar.stars.shafts import Shaft
from crankstar.stars.vector_sums import SequenceQuestion

GREATEST_FRONT = 1 << 15
"""Points of a front."""
GREATEST_LIST = 200_000
"""Orders that are listed for Python functions."""


class Rows(NamedTuple):
    """Orders found: values [f, q], classes and signs [f, n + K], and how many there are [f].

    The first row of a point stands for all orders with its values, the others for none. points: the
    distinct values, those first that turn most others away [p, q]; none where all orders are
    listed.
    """

    values: np.ndarray
    lines: np.ndarray
    times: np.ndarray
    points: np.ndarray

    @classmethod
    def nothing(cls, goals: int, shaft: Shaft) -> Rows:
        """No orders."""
        none = np.zeros((0, goals))
        return cls(none, np.zeros((0, width_of(shaft)), np.int8), np.zeros(0, np.int64), none)

    def joined(self, other: Rows, question: SequenceQuestion) -> Rows:
        """The rows of both: those on the front of both, or all, where functions are to judge."""
        return self.beside(other) if question.functions else self.merged(other, question.size)

    def beside(self, other: Rows) -> Rows:
        """All rows of both. Raises SearchError where there are too many."""
        values, lines, times = map(np.concatenate, zip(self[:3], other[:3], strict=True))
        out = Rows(values, lines, times, self.points)
        if len(out.times) > GREATEST_LIST:
            raise error("", "function-orders", most=f"{GREATEST_LIST:,}")
        return out

    def merged(self, other: Rows, size: int) -> Rows:
        """The rows of both that are on the front of both; of each point the first ones."""
        points = np.empty((GREATEST_FRONT, self.values.shape[1]))
        points[: len(self.points)] = self.points
        known = sign_kernels.joined(points, len(self.points), other.points)
        return self.sifted(other, points[:known], size)

    def sifted(self, other: Rows, points: np.ndarray, size: int) -> Rows:
        """The rows of both that are on a front; of each point the first ones."""
        if len(points) >= GREATEST_FRONT:
            raise error("minimise", "front-too-large", most=f"{GREATEST_FRONT:,}")
        points = points[np.argsort(points.sum(axis=1), kind="stable")]
        values, lines, times = map(np.concatenate, zip(self[:3], other[:3], strict=True))
        order = np.lexsort(lines.T[::-1])
        values, lines, times = values[order], lines[order], times[order]
        home = np.empty(len(values), np.int64)
        sign_kernels.sifted(values, times, points, size, home)
        kept = home >= 0
        return Rows(values[kept], lines[kept], times[kept], points)

    @property
    def own(self) -> Rows:
        """The rows with their own points only."""
        return self._replace(points=self.values[self.times > 0])


def as_json(rows: Rows) -> dict[str, Any]:
    """The rows as lists of numbers."""
    return {name: getattr(rows, name).tolist() for name in ("values", "lines", "times")}


def from_json(tree: dict[str, Any], question: SequenceQuestion) -> Rows:
    """The rows from their lists. Raises KeyError, TypeError or ValueError where they are none."""
    rows, goals = len(tree["times"]), len(question.goals)
    values = np.array(tree["values"], float).reshape(rows, goals)
    lines = np.array(tree["lines"], np.int8).reshape(rows, width_of(question.shaft))
    found = Rows(values, lines, np.array(tree["times"], np.int64).reshape(rows), values[:0])
    return found if question.functions else found.own
