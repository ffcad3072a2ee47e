"""One range of blocks in the regions of one attempt; the same wherever and whenever it is run.

A worker holds all arrangements of both halves of one block. Its greatest memory, measured (and
computed by `memory`, with buffers for as many stars as a block may bring): 0.19 GB (0.20) for 16
cylinders, 0.49 GB (0.81) for 20, 0.75 GB (0.98) for 21.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from crankstar.stars import kernels, results
from crankstar.stars.arrangements import exchanges
from crankstar.stars.arrays import FOUND, FRONT, GROWS, MET, Buffers, Output, Scratch
from crankstar.stars.halves import BUFFER, Halves, halves
from crankstar.stars.question import All, Front, Question
from crankstar.stars.regions import Regions
from crankstar.stars.results import Results
from crankstar.stars.star import Star

GREATEST_FRONT = 4096
"""Points of a front that are used to turn others away while it grows; more only make it slower."""


INTERPRETER = 190e6
"""Bytes of a worker with numpy, numba and the compiled loops, before it does any work."""


@dataclass(frozen=True)
class BlockRange:
    """Blocks from start up to stop of a question, and the regions to search."""

    question: Question
    regions: Regions
    start: int
    stop: int

    def results(self) -> Results:
        """What is found in the blocks."""
        return results_of(self)


def asked(question: Question) -> Question:
    """The question that blocks answer: for all stars where Python functions choose later."""
    if not question.functions:
        return question
    return replace(
        question,
        ask=All(),
        functions=tuple(replace(each, function=_absent) for each in question.functions),
    )


def _absent(star: Star) -> float:
    """Stands in for a function on its way to the workers, since not every function can be sent."""
    raise NotImplementedError(star)


def results_of(part: BlockRange) -> Results:
    """The results of a block range."""
    question = part.question
    ready = halves(question)
    tables = ready.tables
    buffers = _buffers(ready)
    rows, places = BUFFER + ready.inner_rows, tables.whole.shape[0]
    objectives = len(tables.weights)
    output = Output(
        np.empty((rows, objectives)),
        np.empty((rows, places), np.int8),
        np.empty(rows, np.int64),
        np.empty(rows, np.int64),
    )
    front = np.empty((GREATEST_FRONT, objectives))
    state = np.zeros(7, np.int64)
    state[GROWS] = isinstance(question.ask, Front) and not question.functions
    radii = np.array(part.regions.radii, float).reshape(-1, 2)
    scratch = _scratch(ready)
    blocks = ready.blocks[part.start : part.stop]
    out = results.nothing(len(question.objectives), places)
    waiting: list[Results] = []
    ended = False
    while not ended:
        ended = kernels.searched(tables, blocks, radii, buffers, output, front, state, scratch)
        rows_found = int(state[FOUND])
        values, stars, classes, times = (array[:rows_found].copy() for array in output)
        waiting.append(Results(values, stars, classes, times))
        state[FOUND] = 0
        if not ended and sum(map(len, waiting)) < len(out):
            continue
        out, waiting = results.merged([out, *waiting], question.ask), []
        bar = results.threshold(out, question.ask)
        if bar is not None:
            front[0], state[FRONT] = bar, 1
    return replace(out, met=int(state[MET]))


def memory(ready: Halves) -> float:
    """Bytes of a worker at most: the interpreter, one block, and its stars before merging."""
    width, objectives, places = (
        ready.tables.constant.shape[0],
        len(ready.tables.weights),
        ready.tables.whole.shape[0],
    )
    outer = ready.outer_rows * (8 * width + 8 + 2)
    inner = ready.inner_rows * (8 * width + 8 + 2 + 4 + 16 + 4) + 4 * _cells(ready)[2]
    output = (BUFFER + ready.inner_rows) * (8 * objectives + places + 16)
    blocks = 2 * 8 * ready.block_count * (2 * len(ready.counts) + 1)
    return INTERPRETER + outer + inner + output + blocks


def _buffers(ready: Halves) -> Buffers:
    """Buffers for one block, its inner half sorted into cells of about one vector each."""
    tables = ready.tables
    width = tables.constant.shape[0]
    once = max(ready.counts) <= 1
    reach, cell, cells = _cells(ready)
    return Buffers(
        outer_pairs=exchanges(len(tables.outer) if once else 0),
        inner_pairs=exchanges(len(tables.inner) if once else 0),
        outer=np.empty((ready.outer_rows, width)),
        outer_code=np.empty(ready.outer_rows, np.int64),
        inner=np.empty((ready.inner_rows, width)),
        inner_code=np.empty(ready.inner_rows, np.int64),
        start=np.empty(cells + 2, np.int32),
        order=np.empty(ready.inner_rows, np.int32),
        near=np.empty((ready.inner_rows, 2)),
        where=np.empty(ready.inner_rows, np.int32),
        reach=reach,
        cell=cell,
        loose=(tables.limits[:-1] + 1e-7) ** 2,
    )


def _scratch(ready: Halves) -> Scratch:
    """Buffers for one star."""
    places, directions, width = ready.tables.whole.shape
    star = np.zeros(places, np.int64)
    seat = np.empty((directions, 2), np.int64)
    return Scratch(
        np.empty(width), np.empty(len(ready.tables.weights)), star, star.copy(), star.copy(), seat
    )


def _cells(ready: Halves) -> tuple[np.ndarray, np.ndarray, int]:
    """Reach of the inner half in each plane, sides of cells with one vector each, most cells."""
    longest = np.abs(ready.tables.inner[:, 0, 0::2] + 1j * ready.tables.inner[:, 0, 1::2])
    reach = longest.sum(axis=0) * 1.001 + 1e-9
    cell = np.sqrt((longest**2).sum(axis=0) * np.pi / ready.inner_rows) + 1e-9
    return reach, cell, min(int((2 * reach / cell).max() + 2) ** 2, 16 * ready.inner_rows + 64)
