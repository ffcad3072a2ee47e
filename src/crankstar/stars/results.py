"""Stars that were found, and how those of several blocks are merged, in whatever order they come.

A row is a star with the values of its objectives, and how many classes and stars it stands for.
Rows of one star add up. Where more stars share all values than are kept, those that go leave their
numbers with those that stay, so that the numbers of a group of equal values are always those of all
its stars. In a front the first row of a group has them all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from crankstar.stars.question import All, Best, Front
from crankstar.stars.sums import SAME

DECIMALS = 9
"""Of the values, in the kernels' unit, by which stars are put in order."""


@dataclass(frozen=True)
class Results:
    """Rows of stars: values [r, q] in the kernels' unit, directions by place [r, p].

    classes: times the number of symmetries; times: stars each row stands for; met: stars examined.
    """

    values: np.ndarray
    stars: np.ndarray
    classes: np.ndarray
    times: np.ndarray
    met: int = 0
    beyond: int = 0
    """Stars of a list that are not kept in it."""

    @property
    def arrays(self) -> dict[str, np.ndarray]:
        """The columns by name."""
        return {name: getattr(self, name) for name in ("values", "stars", "classes", "times")}

    def __len__(self) -> int:
        return len(self.values)


def nothing(objectives: int, places: int) -> Results:
    """No stars."""
    none = np.zeros(0, np.int64)
    return Results(np.zeros((0, max(1, objectives))), np.zeros((0, places), np.int8), none, none)


def merged(parts: Sequence[Results], ask: Front | Best | All) -> Results:
    """The rows of several results: each star once, what is not asked for left out."""
    rows = _each_once(parts)
    rows = _front(rows, ask.size) if isinstance(ask, Front) else _first(rows, ask)
    beyond = rows.beyond + sum(part.beyond for part in parts)
    return replace(rows, met=sum(part.met for part in parts), beyond=beyond)


def best_so_far(whole: Results, begun: Results, ask: Front | Best | All) -> Results:
    """Results of a search and of a wider one over the same stars that was stopped."""
    known = {star.tobytes() for star in whole.stars}
    new = [
        row
        for row in range(len(begun))
        if begun.stars[row].tobytes() not in known and not _among(begun.values[row], whole)
    ]
    return merged([whole, taken(begun, np.array(new, np.int64))], ask)


def _among(values: np.ndarray, rows: Results) -> bool:
    """Whether stars with these values were found; then all of them were counted."""
    return bool((np.abs(rows.values - values) <= 2 * SAME).all(axis=1).any())


def groups(rows: Results) -> list[np.ndarray]:
    """Rows by equal values, in the order of the values."""
    left = np.arange(len(rows))
    out: list[np.ndarray] = []
    while len(left):
        same = (np.abs(rows.values[left] - rows.values[left[0]]) <= 2 * SAME).all(axis=1)
        out.append(left[same])
        left = left[~same]
    return out


def threshold(rows: Results, ask: Front | Best | All) -> np.ndarray | None:
    """The worst value that can still be among the best, once enough are known."""
    if isinstance(ask, Best) and len(rows) >= ask.size:
        return rows.values[ask.size - 1]
    return None


def _each_once(parts: Sequence[Results]) -> Results:
    stars = np.concatenate([part.stars for part in parts])
    if not len(stars):
        return replace(parts[0], met=0, beyond=0)
    values = np.concatenate([part.values for part in parts])
    _, first, where = np.unique(stars, axis=0, return_index=True, return_inverse=True)
    where = where.reshape(-1)
    classes, times = np.zeros((2, len(first)), np.int64)
    np.add.at(classes, where, np.concatenate([part.classes for part in parts]))
    np.add.at(times, where, np.concatenate([part.times for part in parts]))
    return _ordered(Results(values[first], stars[first], classes, times))


def _ordered(rows: Results) -> Results:
    """By the first objective, then the second and so on, then by star."""
    keys = [*rows.stars.T[::-1], *np.round(rows.values, DECIMALS).T[::-1]]
    return taken(rows, np.lexsort(keys))


def taken(rows: Results, which: np.ndarray) -> Results:
    """Some of the rows."""
    return replace(rows, **{name: array[which] for name, array in rows.arrays.items()})


def _front(rows: Results, examples: int) -> Results:
    """Rows that no other dominates; of equal rows so many examples."""
    keep = np.ones(len(rows), bool)
    seen = np.zeros(len(rows), bool)
    order = np.argsort(rows.values.sum(axis=1), kind="stable")
    for row in order:
        if not keep[row] or seen[row]:
            continue
        apart = rows.values - rows.values[row]
        seen |= (np.abs(apart) <= SAME).all(axis=1)
        keep &= ~((apart >= -SAME).all(axis=1) & (apart > SAME).any(axis=1))
    rows = taken(rows, np.flatnonzero(keep))
    classes, times = np.zeros((2, len(rows)), np.int64)
    stay: list[np.ndarray] = []
    for group in groups(rows):
        classes[group[0]], times[group[0]] = rows.classes[group].sum(), rows.times[group].sum()
        stay.append(group[:examples])
    which = np.concatenate(stay) if stay else np.zeros(0, np.int64)
    return taken(Results(rows.values, rows.stars, classes, times), which)


def _first(rows: Results, ask: Best | All) -> Results:
    """The first rows, so many as are asked for; a list of all counts those it does not keep."""
    beyond = rows.beyond if isinstance(ask, Best) else int(rows.times[ask.size :].sum())
    return replace(taken(rows, np.arange(min(len(rows), ask.size))), beyond=beyond)


def as_json(rows: Results) -> dict[str, Any]:
    """The rows as lists of numbers."""
    columns = {name: array.tolist() for name, array in rows.arrays.items()}
    return {**columns, "met": rows.met, "beyond": rows.beyond}


def from_json(tree: dict[str, Any], objectives: int, places: int) -> Results:
    """The rows from their lists. Raises KeyError, TypeError or ValueError where they are none."""
    rows = len(tree["stars"])
    values = np.array(tree["values"], float).reshape(rows, max(1, objectives))
    stars = np.array(tree["stars"], np.int8).reshape(rows, places)
    classes, times = (np.array(tree[name], np.int64).reshape(rows) for name in ("classes", "times"))
    return Results(values, stars, classes, times, int(tree["met"]), int(tree["beyond"]))
