"""Records of the compiled loops over stars and firing sequences: question, walk, output, state.

Letters of the shapes: n throws; K classes; w sums of the star and m of the sequence, each two
numbers; q goals; f rows found.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

DEPTH, FOUND, KNOWN, STARS, FORMED = range(5)
"""Places in the state.

Throw to go on with, rows in the output, points of the front, stars visited and sequences looked at
(both by what they stand for).
"""


class ShaftTables(NamedTuple):
    """A question as arrays."""

    star: np.ndarray
    """What each throw adds to each sum of the star in each class [n, K, 2 w]."""
    amplitudes: np.ndarray
    """Amplitude of each rod [n, rods]."""
    turns: np.ndarray
    """What an amplitude of one adds to each sum of the sequence, by class [K, 2 m]."""
    star_weights: np.ndarray
    """Scale of each sum of the star in each goal, 0 where it is not in it [q, w]."""
    sequence_weights: np.ndarray
    """The same of the sums of the sequence [q, m]."""
    caps: np.ndarray
    """Greatest length of each sum of the star [w]."""
    shift: int
    room: int
    mirrored: bool
    """Whether of two stars that are mirror images one stands for both."""
    goal: int
    """The goal that depends on the sequence; -1 where there are several, or neighbours are one."""
    counts: bool
    """Whether neighbours in succession matter."""
    counted: int
    """The goal that is their number, -1 where none is."""
    size: float
    """By what their number is divided in it."""
    at_most: int
    """How many there may be."""
    every: bool
    """Whether all orders within the limits are written, whatever is better: for functions."""
    step: int
    """From a class to the next to fire."""


class Walk(NamedTuple):
    """Where the loops are: choices by throw, sums and fillings so far; buffers for one star."""

    choice: np.ndarray
    sums: np.ndarray
    hits: np.ndarray
    values: np.ndarray
    """Those of the goals, star sums only [q]."""
    bounds: np.ndarray
    """The same with the least that the sequence can add [q]."""
    whole: np.ndarray
    """The same with a sequence [q]."""
    seen: np.ndarray
    """How many cylinders of each class were met [K]."""
    seat: np.ndarray
    """The cylinders of each class, twice the throw and the bank [K, 2]."""
    delta: np.ndarray
    """Difference of the two amplitudes of each class [K]."""
    front_half: np.ndarray
    """Sums over the first classes with all signs [2 m, rows]."""
    rear_half: np.ndarray


class SequenceOutput(NamedTuple):
    """Rows found: values [f, q], classes and signs [f, n + K], how many each stands for [f]."""

    values: np.ndarray
    rows: np.ndarray
    times: np.ndarray
