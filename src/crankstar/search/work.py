"""A part of a search: one stretch of its blocks in the strips of one attempt; the same wherever and whenever it is run.

A worker holds all arrangements of both halves of one block. Its greatest memory, measured (and computed by `memory`, with room
for as many stars as a block may bring): 0.19 GB (0.20) for 16 cylinders, 0.49 GB (0.81) for 20, 0.75 GB (0.98) for 21.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from crankstar.search import harvest, kernels
from crankstar.search.arrays import Desk, Found, Room
from crankstar.search.halves import BUFFER, Halves, halves
from crankstar.search.harvest import Harvest
from crankstar.search.question import All, Front, Question
from crankstar.search.stars import Star
from crankstar.search.strips import Strips

GREATEST_FRONT = 4096
"""Points of a front that are used to turn others away while it grows; more only make it slower."""


INTERPRETER = 190e6
"""Bytes of a worker with numpy, numba and the compiled loops, before it does any work."""


@dataclass(frozen=True)
class Stretch:
    """Blocks from start up to stop of a question, and the strips to search."""

    question: Question
    strips: Strips
    start: int
    stop: int


def asked(question: Question) -> Question:
    """What the blocks are asked: the question, but for all stars where Python functions are to judge them (later, not here)."""
    if not question.judges:
        return question
    return replace(question, ask=All(), judges=tuple(replace(judge, function=_unheard) for judge in question.judges))


def _unheard(star: Star) -> float:
    """Stands in for a judge on its way to the workers: the judges' functions need not be such as can be sent."""
    raise NotImplementedError(star)


def worked(stretch: Stretch) -> Harvest:
    """What the stars of a stretch bring in."""
    question = stretch.question
    ready = halves(question)
    tables = ready.tables
    room = _room(ready)
    rows, places = BUFFER + ready.inner_rows, tables.whole.shape[0]
    objectives = len(tables.weights)
    found = Found(
        np.empty((rows, objectives)), np.empty((rows, places), np.int8), np.empty(rows, np.int64), np.empty(rows, np.int64)
    )
    front = np.empty((GREATEST_FRONT, objectives))
    state = np.zeros(7, np.int64)
    state[6] = isinstance(question.ask, Front) and not question.judges
    radii = np.array(stretch.strips.radii, float).reshape(-1, 2)
    desk = _desk(ready)
    blocks = ready.blocks[stretch.start : stretch.stop]
    out = harvest.nothing(len(question.objectives), places)
    waiting: list[Harvest] = []
    ended = False
    while not ended:
        ended = kernels.searched(tables, blocks, radii, room, found, front, state, desk)
        waiting.append(_handed_over(found, int(state[3])))
        state[3] = 0
        if not ended and sum(map(len, waiting)) < len(out):
            continue
        out, waiting = harvest.gathered([out, *waiting], question.ask), []
        bar = harvest.threshold(out, question.ask)
        if bar is not None:
            front[0], state[5] = bar, 1
    return replace(out, met=int(state[4]))


def memory(ready: Halves) -> float:
    """Bytes that a worker may come to use: the interpreter, one block, and the stars it has found before they are gathered."""
    width, objectives, places = ready.tables.constant.shape[0], len(ready.tables.weights), ready.tables.whole.shape[0]
    outer = ready.outer_rows * (8 * width + 8 + 2)
    inner = ready.inner_rows * (8 * width + 8 + 2 + 4 + 16 + 4) + 4 * _cells(ready)[2]
    found = (BUFFER + ready.inner_rows) * (8 * objectives + places + 16)
    blocks = 2 * 8 * ready.block_count * (2 * len(ready.counts) + 1)
    return INTERPRETER + outer + inner + found + blocks


def _handed_over(found: Found, rows: int) -> Harvest:
    """The rows the kernel has filled."""
    return Harvest(found.values[:rows].copy(), found.stars[:rows].copy(), found.classes[:rows].copy(), found.times[:rows].copy())


def _room(ready: Halves) -> Room:
    """Room for one block, and how finely its inner half is sorted: about one vector to a cell in the thick of them."""
    tables = ready.tables
    width = tables.constant.shape[0]
    once = max(ready.counts) <= 1
    reach, cell, cells = _cells(ready)
    return Room(
        outer_pairs=kernels.exchanges(len(tables.outer) if once else 0),
        inner_pairs=kernels.exchanges(len(tables.inner) if once else 0),
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


def _desk(ready: Halves) -> Desk:
    """Room for one star."""
    places, directions, width = ready.tables.whole.shape
    star = np.zeros(places, np.int64)
    seat = np.empty((directions, 2), np.int64)
    return Desk(np.empty(width), np.empty(len(ready.tables.weights)), star, star.copy(), star.copy(), seat)


def _cells(ready: Halves) -> tuple[np.ndarray, np.ndarray, int]:
    """How far the inner half reaches in each plane, sides of cells that leave about one vector in each, cells at most."""
    longest = np.abs(ready.tables.inner[:, 0, 0::2] + 1j * ready.tables.inner[:, 0, 1::2])
    reach = longest.sum(axis=0) * 1.001 + 1e-9
    cell = np.sqrt((longest**2).sum(axis=0) * np.pi / ready.inner_rows) + 1e-9
    return reach, cell, min(int((2 * reach / cell).max() + 2) ** 2, 16 * ready.inner_rows + 64)
