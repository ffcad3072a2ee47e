"""Records of the compiled loops: a question as arrays, buffers for one block, output, state.

Letters of the shapes: m vector sums, each two numbers; n directions; k places of a half; q
objectives; s symmetries; f stars found.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

BLOCK, REGION, ROW, FOUND, MET, FRONT, GROWS = range(7)
"""Places in the state of a search over some blocks.

Block, region and row of the outer half to go on from; stars in the output, stars met in the
regions, points of the front, whether the front grows.
"""


class Tables(NamedTuple):
    """A search as arrays, the same for all blocks."""

    outer: np.ndarray
    """What each free place of the outer half adds to each sum in each direction [k, n, 2 m]."""
    inner: np.ndarray
    constant: np.ndarray
    """What the fixed places add [2 m]."""
    places: np.ndarray
    """Index along the shaft of each place: the outer ones, the inner ones, the fixed ones."""
    fixed: np.ndarray
    """Direction of each fixed place, in the order of `places`."""
    whole: np.ndarray
    """What each place adds, by its index along the shaft [places, n, 2 m]."""
    members: np.ndarray
    """Cylinders of each place, -1 where there is none [places, 2]."""
    symmetries: np.ndarray
    """One row a symmetry: mirrored or not, reversed or not, [s, 2]; the first is 0, 0."""
    counts: bool
    """Whether neighbours in succession are asked for."""
    anchored: bool
    """Whether stars are turned so that the first place has direction 0."""
    step: int
    """From a direction to that of the next cylinder to fire; 0 where two share each direction."""
    weights: np.ndarray
    """Squared weight of each sum in each objective, then the weight of neighbours [q, m + 1]."""
    limits: np.ndarray
    """Greatest length of each sum [m], then of neighbours in succession; infinite where free."""
    floors: np.ndarray
    """Least length of each sum [m]."""


class Buffers(NamedTuple):
    """Buffers for one block: vectors and codes of both halves, and the cells."""

    outer_pairs: np.ndarray
    """Exchanges that lead through all permutations; none where places share directions."""
    inner_pairs: np.ndarray
    outer: np.ndarray
    outer_code: np.ndarray
    inner: np.ndarray
    inner_code: np.ndarray
    start: np.ndarray
    order: np.ndarray
    near: np.ndarray
    where: np.ndarray
    reach: np.ndarray
    """Greatest length of each sum over the inner places [m]."""
    cell: np.ndarray
    """Side of a cell of each plane that leaves about one vector in each [m]."""
    loose: np.ndarray
    """Square of the limit of each sum, and a little more for rounding [m]."""


class Output(NamedTuple):
    """Stars found: values, directions, classes (times symmetries) and stars each stands for."""

    values: np.ndarray
    stars: np.ndarray
    classes: np.ndarray
    times: np.ndarray


class Scratch(NamedTuple):
    """Buffers for one star: sums or their squares, values, directions, two images, seats."""

    sums: np.ndarray
    values: np.ndarray
    star: np.ndarray
    other: np.ndarray
    least: np.ndarray
    seat: np.ndarray
