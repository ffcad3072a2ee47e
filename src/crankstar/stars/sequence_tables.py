"""A question over stars and firing sequences as arrays, and the buffers of its loops."""

from __future__ import annotations

from fractions import Fraction
from math import inf

import numpy as np

from crankstar.stars.sequence_arrays import ShaftTables, Walk
from crankstar.stars.shafts import Shaft
from crankstar.stars.vector_sums import NEIGHBOURS, OrderSum, SequenceQuestion, straight, torsion


def width_of(shaft: Shaft) -> int:
    """Numbers that a star with its sequence is written in: classes, and signs where it has any."""
    return shaft.throws + (shaft.classes if shaft.room == 2 else 0)


def mirrored(question: SequenceQuestion) -> bool:
    """Whether mirror images have the same values.

    Both rods of each pin have one amplitude, and functions are told to be the same.
    """
    rods = question.shaft.rods
    return all(each.symmetric for each in question.functions) and all(
        len(set(one.weights[index : index + rods])) == 1
        for goal in question.goals
        for one in goal.sums
        if one.kind == "T"
        for index in range(0, len(one.weights), rods)
    )


def tables_of(question: SequenceQuestion) -> tuple[ShaftTables, np.ndarray]:
    """The question as arrays, and the unit of each goal in them."""
    shaft = question.shaft
    stars, signs = question.star_sums, question.sequence_sums
    if question.counts and shaft.room == 2 and not signs:  # so that sequences are gone through
        signs = (torsion(shaft, Fraction(1, 2), straight(shaft)),)
    step = 2 * np.pi * np.arange(shaft.classes) / shaft.classes
    columns = [_column(shaft, one, step) for one in stars]
    turns = [part for one in signs for part in _parts(np.exp(-1j * float(one.order) * step))]
    amplitudes = np.array(signs[0].weights if signs else (0,) * shaft.cylinders, float)
    reach = [sum(map(abs, map(float, one.weights))) * one.scale for one in (*stars, *signs)]
    at = {one: index for index, one in enumerate((*stars, *signs))}
    sizes = [max((reach[at[one]] for one in goal.sums), default=1.0) for goal in question.goals]
    unit = np.where(np.array(sizes) > 0, sizes, 1.0)
    unit = np.maximum(unit / shaft.throws, 1e-9)
    weights = np.zeros((len(unit), len(at)))
    for row, goal, size in zip(weights, question.goals, unit, strict=True):
        for one in goal.sums:
            row[at[one]] = one.scale / size
    caps = np.full(len(stars), inf)
    for cap in question.caps:
        place = at[cap.sum]
        least = cap.greatest / cap.sum.scale if cap.sum.scale > 1e-12 else inf
        caps[place] = min(caps[place], least)
    most = question.neighbours_at_most
    alone = np.flatnonzero(weights[:, len(stars) :].any(axis=1))
    counted = question.goals.index(NEIGHBOURS) if NEIGHBOURS in question.goals else -1
    tables = ShaftTables(
        star=np.ascontiguousarray(
            np.stack([part for column in columns for part in _parts(column)], axis=-1)
            if columns
            else np.zeros((shaft.throws, shaft.classes, 0))
        ),
        amplitudes=amplitudes.reshape(shaft.throws, shaft.rods),
        turns=np.ascontiguousarray(
            np.stack(turns, axis=-1) if turns else np.zeros((shaft.classes, 0))
        ),
        star_weights=np.ascontiguousarray(weights[:, : len(stars)]),
        sequence_weights=np.ascontiguousarray(weights[:, len(stars) :]),
        caps=caps,
        shift=shaft.shift if shaft.rods == 2 else 0,
        room=shaft.room,
        mirrored=mirrored(question),
        goal=int(alone[0]) if len(alone) == 1 and counted < 0 else -1,
        counts=question.counts,
        counted=counted,
        size=float(unit[counted]),
        at_most=shaft.cylinders if most is None else most,
        every=bool(question.functions),
        step=2 % shaft.classes if shaft.room == 1 and shaft.cycle_deg == 720 else 1,
    )
    return tables, unit


def _parts(column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.real(column), np.imag(column)


def _column(shaft: Shaft, one: OrderSum, step: np.ndarray) -> np.ndarray:
    """What each throw adds to a sum of the star in each class [n, K]."""
    weights = np.array(one.weights, float)
    if one.kind != "T":
        return np.outer(weights, np.exp(-1j * float(one.order) * step))
    own = np.arange(shaft.classes)
    out = np.zeros((shaft.throws, shaft.classes), complex)
    for bank, of_bank in enumerate(weights.reshape(shaft.throws, shaft.rods).T):
        at = (own + bank * shaft.shift) % shaft.classes
        angle = step[at] + 2 * np.pi * (at % 2) * (shaft.room == 1 and shaft.cycle_deg == 720)
        out += np.outer(of_bank, np.exp(-1j * float(one.order) * angle))
    return out


def walk_of(shaft: Shaft, tables: ShaftTables) -> Walk:
    """The buffers of the loops, at the first star."""
    throws, classes = shaft.throws, shaft.classes
    goals, width = len(tables.star_weights), tables.turns.shape[1]
    middle = (classes + 1) // 2
    few = width > 0
    return Walk(
        choice=np.zeros(throws, np.int64),
        sums=np.zeros((throws + 1, tables.star.shape[2])),
        hits=np.zeros(classes, np.int64),
        values=np.zeros(goals),
        bounds=np.zeros(goals),
        whole=np.zeros(goals),
        seen=np.zeros(classes, np.int64),
        seat=np.zeros((classes, 2), np.int64),
        delta=np.zeros(classes),
        front_half=np.zeros((width, 2 ** (middle - 1) if few else 1)),
        rear_half=np.zeros((width, 2 ** (classes - middle) if few else 1)),
    )
