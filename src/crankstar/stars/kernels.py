"""Compiled loops over the pairs of halves whose vectors nearly cancel.

A star is a choice of one direction for every place of the shaft. The places are divided into an
outer and an inner half. A block fixes which directions each half gets; within it every arrangement
of the outer half meets every arrangement of the inner one, and a vector sum of the star is the sum
of the two. All stars whose sum of one kind (the driver) is at most a radius long are found without
meeting the others: the inner vectors are sorted into square cells, and for each outer one only the
cells within the radius of its opposite are searched.

Letters of the arrays: m vector sums, each two numbers; n directions; k places of a half; q
objectives. Arguments that are not arrays of numbers are the records of `arrays`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from crankstar.stars.arrangements import BITS, arranged
from crankstar.stars.arrays import BLOCK, FOUND, FRONT, GROWS, MET, REGION, ROW
from crankstar.stars.compiling import compiled
from crankstar.stars.sums import SAME

ROUNDING = 1e-11
"""More than the rounding in the sum of two halves, which is the margin of the first rejection."""


@compiled
def cells(buffers: Any, rows: int, drive: int, radii: Any) -> int:
    """Number of cells a side; sorts inner vectors by square cell of the driver's plane.

    near[start[c]:start[c + 1]] are those of cell c. A cell is no smaller than the radius, so that
    few are searched.
    """
    plane, reach = 2 * drive, buffers.reach[drive]
    inner, start, order, near, where = (
        buffers.inner,
        buffers.start,
        buffers.order,
        buffers.near,
        buffers.where,
    )  # local names are faster
    side = max(
        1,
        min(
            int(2 * reach / max(buffers.cell[drive], min(radii[1], reach))),
            int(np.sqrt(start.shape[0] - 2)),
        ),
    )
    scale = side / (2 * reach)
    last = side * side
    start[: last + 1] = 0
    for row in range(rows):
        i = min(max(int((inner[row, plane] + reach) * scale), 0), side - 1)
        j = min(max(int((inner[row, plane + 1] + reach) * scale), 0), side - 1)
        where[row] = i * side + j
        start[where[row] + 1] += 1
    for c in range(last):
        start[c + 1] += start[c]
    for row in range(rows - 1, -1, -1):
        start[where[row] + 1] -= 1
        at = start[where[row] + 1]
        order[at] = row
        near[at, 0] = inner[row, plane]
        near[at, 1] = inner[row, plane + 1]
    # start[c + 1] has come down to the first row of cell c
    for c in range(last):
        start[c] = start[c + 1]
    start[last] = rows
    return side


@compiled
def succession(star: Any, members: Any, step: int, directions: int, seat: Any) -> int:
    """Number of neighbours in succession; where two share each direction, in the best order."""
    seat[:] = -1
    for index in range(star.shape[0]):
        for half in range(2):
            if members[index, half] >= 0:
                d = star[index]
                seat[d, 0 if seat[d, 0] < 0 else 1] = members[index, half]
    if step > 0:
        count = 0
        for d in range(directions):
            if abs(seat[d, 0] - seat[(d + step) % directions, 0]) == 1:
                count += 1
        return count
    # a cycle is two turns: which of the two that share a direction fires in the first; the first
    # direction's is free
    straight, crossed = 0, 2 * seat.shape[0] + 9
    for d in range(1, directions):
        keep = 0
        swap = 0
        for half in range(2):
            if abs(seat[d - 1, half] - seat[d, half]) == 1:
                keep += 1
            if abs(seat[d - 1, half] - seat[d, 1 - half]) == 1:
                swap += 1
        straight, crossed = (
            min(straight + keep, crossed + swap),
            min(straight + swap, crossed + keep),
        )
    over = 0
    through = 0
    for half in range(2):
        if abs(seat[directions - 1, half] - seat[0, 1 - half]) == 1:
            over += 1
        if abs(seat[directions - 1, 1 - half] - seat[0, 1 - half]) == 1:
            through += 1
    return min(straight + over, crossed + through)


@compiled
def values_of(star: Any, tables: Any, sums: Any, values: Any, seat: Any) -> bool:
    """Whether a star keeps the limits; writes the values of its objectives."""
    places, directions, width = tables.whole.shape
    lengths = width // 2
    sums[:] = 0.0
    for index in range(places):
        for c in range(width):
            sums[c] += tables.whole[index, star[index], c]
    counted = 0
    if tables.counts:
        counted = succession(star, tables.members, tables.step, directions, seat)
    kept = counted <= tables.limits[lengths]
    for o in range(lengths):
        square = sums[2 * o] * sums[2 * o] + sums[2 * o + 1] * sums[2 * o + 1]
        length = np.sqrt(square)
        if length > tables.limits[o] + SAME or length < tables.floors[o] - SAME:
            kept = False
        sums[o] = square
    for q in range(values.shape[0]):
        total = 0.0
        for o in range(lengths):
            total += tables.weights[q, o] * sums[o]
        values[q] = np.sqrt(total) + tables.weights[q, lengths] * counted
    return kept


@compiled
def canonical(star: Any, tables: Any, other: Any, least: Any) -> int:
    """Number of stars that are the same but for symmetries; writes the first of them, `least`."""
    places, directions, _ = tables.whole.shape
    same = 0
    for g in range(tables.symmetries.shape[0]):
        sign = -1 if tables.symmetries[g, 0] else 1
        back = tables.symmetries[g, 1]
        zero = 0
        if tables.anchored:
            zero = star[places - 1] if back else star[0]
        order = 0
        for index in range(places):
            d = star[places - 1 - index] if back else star[index]
            other[index] = (sign * (d - zero)) % directions
            if order == 0 and g > 0:
                order = (other[index] > least[index]) - (other[index] < least[index])
        if g == 0 or order < 0:
            least[:] = other
            same = 1
        elif order == 0:
            same += 1
    return tables.symmetries.shape[0] // same


@compiled
def dominated(values: Any, front: Any, known: int, slack: float) -> bool:
    """Whether a point of the front is as good in all values and better in one.

    slack: by how much the values may be off.
    """
    for f in range(known):
        better = False
        for q in range(values.shape[0]):
            if front[f, q] > values[q] + SAME - slack:
                break
            if front[f, q] < values[q] - SAME - slack:
                better = True
        else:
            if better:
                return True
    return False


@compiled
def entered(values: Any, front: Any, known: int) -> int:
    """Number of points of a front that a new one has joined.

    The new one is not dominated; those that it dominates or equals leave.
    """
    kept = 0
    for f in range(known):
        worse = True
        for q in range(values.shape[0]):
            if front[f, q] < values[q] - SAME:
                worse = False
        if not worse:
            if kept < f:
                front[kept] = front[f]
            kept += 1
    if kept < front.shape[0]:
        front[kept] = values
        kept += 1
    return kept


@compiled
def squares_of_pair(
    outer: Any, inner: Any, r: int, s: int, radii: Any, d: int, loose: Any, sums: Any
) -> int:
    """Code of the star of two arrangements; writes the squares of its sums.

    -1 if it was met in a region before d, 0 if it breaks a limit, else 1.
    """
    lengths = sums.shape[0] // 2
    for o in range(lengths):
        x = outer[r, 2 * o] + inner[s, 2 * o]
        y = outer[r, 2 * o + 1] + inner[s, 2 * o + 1]
        sums[o] = x * x + y * y
    for e in range(d):
        if sums[int(radii[e, 0])] <= radii[e, 1] * radii[e, 1]:
            return -1
    for o in range(lengths):
        if sums[o] > loose[o]:
            return 0
    return 1


@compiled
def surely_dominated(weights: Any, sums: Any, values: Any, front: Any, known: int) -> bool:
    """Whether a star with these squares of sums is dominated, whatever its neighbours."""
    for v in range(values.shape[0]):
        total = 0.0
        for o in range(sums.shape[0] // 2):
            total += weights[v, o] * sums[o]
        values[v] = np.sqrt(total)
    return dominated(values, front, known, ROUNDING)


@compiled
def write(
    tables: Any,
    buffers: Any,
    pair: Any,
    times: int,
    output: Any,
    front: Any,
    state: Any,
    scratch: Any,
) -> None:
    """Write the star of a pair, as the first of its class, unless dominated or out of limits."""
    free, held = tables.outer.shape[0], tables.inner.shape[0]
    for k in range(free):
        scratch.star[tables.places[k]] = (buffers.outer_code[pair[0]] >> (BITS * k)) & 31
    for k in range(held):
        scratch.star[tables.places[free + k]] = (buffers.inner_code[pair[1]] >> (BITS * k)) & 31
    orbit = canonical(scratch.star, tables, scratch.other, scratch.least)
    if not values_of(scratch.least, tables, scratch.sums, scratch.values, scratch.seat):
        return
    if dominated(scratch.values, front, state[FRONT], 0.0):
        return
    if state[GROWS]:
        state[FRONT] = entered(scratch.values, front, state[FRONT])
    row = state[FOUND]
    output.values[row] = scratch.values
    output.stars[row] = scratch.least
    output.classes[row] = times * (tables.symmetries.shape[0] // orbit)
    output.times[row] = times
    state[FOUND] += 1


@compiled
def searched(
    tables: Any,
    blocks: Any,
    radii: Any,
    buffers: Any,
    output: Any,
    front: Any,
    state: Any,
    scratch: Any,
) -> bool:
    """Whether the end was reached; visits the stars of some blocks that lie in a region.

    Else `output` is full: empty it and call again. blocks: how many places of each half get each
    direction, and how many blocks it stands for [b, 2 n + 1]; radii: for each region its driving
    sum and its greatest length; front: stars that a point of it dominates are left out; state: see
    `arrays.BLOCK`.
    """
    directions = tables.whole.shape[1]
    free, held = tables.outer.shape[0], tables.inner.shape[0]
    nothing = np.zeros(tables.constant.shape[0])
    pair = np.zeros(2, np.int64)
    outer, inner, loose = buffers.outer, buffers.inner, buffers.loose  # records are dear to pass
    outer_pairs, inner_pairs, weights = buffers.outer_pairs, buffers.inner_pairs, tables.weights
    outer_code, inner_code = buffers.outer_code, buffers.inner_code
    sums, values = scratch.sums, scratch.values
    for f in range(tables.fixed.shape[0]):
        scratch.star[tables.places[free + held + f]] = tables.fixed[f]
    for b in range(state[BLOCK], blocks.shape[0]):
        share, rest = blocks[b, :directions], blocks[b, directions : 2 * directions]
        constant = tables.constant
        outers = arranged(tables.outer, share, constant, outer_pairs, outer, outer_code)
        inners = arranged(tables.inner, rest, nothing, inner_pairs, inner, inner_code)
        times = blocks[b, 2 * directions]
        for d in range(state[REGION], radii.shape[0]):
            drive, radius = int(radii[d, 0]), radii[d, 1]
            reach, square = buffers.reach[drive], radius * radius
            side = cells(buffers, inners, drive, radii[d])
            scale, last = side / (2 * reach), side - 1
            start, near, order = buffers.start, buffers.near, buffers.order
            for r in range(state[ROW], outers):
                p, q = -outer[r, 2 * drive], -outer[r, 2 * drive + 1]
                if abs(p) > reach + radius or abs(q) > reach + radius:
                    continue
                pair[0] = r
                j0 = min(max(int((q - radius + reach) * scale), 0), last)
                j1 = min(max(int((q + radius + reach) * scale), 0), last)
                i1 = min(max(int((p + radius + reach) * scale), 0), last)
                for i in range(min(max(int((p - radius + reach) * scale), 0), last), i1 + 1):
                    for at in range(start[i * side + j0], start[i * side + j1 + 1]):
                        dx, dy = near[at, 0] - p, near[at, 1] - q
                        if dx * dx + dy * dy <= square:
                            s, points = order[at], state[FRONT]
                            known = squares_of_pair(outer, inner, r, s, radii, d, loose, sums)
                            state[MET] += times if known >= 0 else 0
                            if known > 0 and not surely_dominated(
                                weights, sums, values, front, points
                            ):
                                pair[1] = s
                                write(tables, buffers, pair, times, output, front, state, scratch)
                if state[FOUND] + inners > output.values.shape[0]:
                    state[BLOCK], state[REGION], state[ROW] = b, d, r + 1
                    return False
            state[ROW] = 0
        state[REGION] = 0
    state[BLOCK] = blocks.shape[0]
    return True
