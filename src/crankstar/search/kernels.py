"""Compiled loops of the search: all arrangements of a half, and the pairs of halves whose vectors nearly cancel.

The only user of numba. A star is a choice of one direction for every place of the shaft. The places are parted into an
outer and an inner half. A block fixes which directions each half gets; within it every arrangement of the outer half
meets every arrangement of the inner one, and a vector sum of the star is the sum of the two. All stars whose sum of one
kind (the driver) is at most a radius long are found without meeting the others: the inner vectors are sorted into square
cells, and each outer one looks only into the cells within the radius of its opposite.

Letters of the arrays: m vector sums, each two numbers; n directions; k places of a half; q objectives.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

BITS = 5
"""Bits of a direction in the code of a half: up to 32 directions, up to 12 places."""
SAME = 1e-9
"""Sums nearer than this, in the unit of their weights, count as equal (rounding is below 1e-13; zeros are proved apart)."""
ROUNDING = 1e-11
"""More than rounding in the sum of two halves: by so much less is rejected before a star is summed along its shaft."""


@njit(cache=True, nogil=True)
def arrangements(table: Any, counts: Any, first: Any, vectors: Any, codes: Any) -> int:
    """All arrangements of a half: counts[d] places get direction d. Writes their vectors and codes; says how many."""
    places, directions, width = table.shape
    if places == 0:
        vectors[0] = first
        codes[0] = 0
        return 1
    left = counts.copy()
    choice = np.full(places, -1, np.int64)
    partial = np.empty((places + 1, width))
    code = np.zeros(places + 1, np.int64)
    partial[0] = first
    depth, row = 0, 0
    while depth >= 0:
        chosen = choice[depth]
        if chosen >= 0:
            left[chosen] += 1
        chosen += 1
        while chosen < directions and left[chosen] == 0:
            chosen += 1
        if chosen == directions:
            choice[depth] = -1
            depth -= 1
            continue
        choice[depth] = chosen
        left[chosen] -= 1
        if depth == places - 1:
            for c in range(width):
                vectors[row, c] = partial[depth, c] + table[depth, chosen, c]
            codes[row] = code[depth] | (chosen << (BITS * depth))
            row += 1
        else:
            for c in range(width):
                partial[depth + 1, c] = partial[depth, c] + table[depth, chosen, c]
            code[depth + 1] = code[depth] | (chosen << (BITS * depth))
            depth += 1
    return row


@njit(cache=True)
def exchanges(places: int) -> Any:
    """Pairs of places whose exchange, one after the other, leads through all their permutations [places! - 1, 2].

    Source: B. R. Heap, Permutations by interchanges, The Computer Journal 6 (1963) 293.
    """
    rows = 1
    for k in range(2, places + 1):
        rows *= k
    out = np.empty((rows - 1, 2), np.int8)
    count = np.zeros(places + 1, np.int64)
    row, k = 0, 1
    while k < places:
        if count[k] < k:
            out[row, 0] = 0 if k % 2 == 0 else count[k]
            out[row, 1] = k
            row += 1
            count[k] += 1
            k = 1
        else:
            count[k] = 0
            k += 1
    return out


@njit(cache=True, nogil=True)
def permutations(table: Any, counts: Any, first: Any, pairs: Any, vectors: Any, codes: Any) -> int:
    """As `arrangements`, where each direction is given once: from one to the next by an exchange of two places."""
    places, directions, width = table.shape
    star = np.empty(places, np.int64)
    place = 0
    for d in range(directions):
        if counts[d]:
            star[place] = d
            place += 1
    vector = first.copy()
    code = np.int64(0)
    for place in range(places):
        code |= star[place] << (BITS * place)
        for c in range(width):
            vector[c] += table[place, star[place], c]
    vectors[0] = vector
    codes[0] = code
    for row in range(pairs.shape[0]):
        i, j = pairs[row, 0], pairs[row, 1]
        a, b = star[i], star[j]
        for c in range(width):
            vector[c] += (table[i, b, c] - table[i, a, c]) + (table[j, a, c] - table[j, b, c])
            vectors[row + 1, c] = vector[c]
        code ^= ((a ^ b) << (BITS * i)) | ((a ^ b) << (BITS * j))
        codes[row + 1] = code
        star[i], star[j] = b, a
    return pairs.shape[0] + 1


@njit(cache=True, nogil=True)
def arranged(table: Any, counts: Any, first: Any, pairs: Any, vectors: Any, codes: Any) -> int:
    """All arrangements of a half, by the faster road where there is a choice."""
    if pairs.shape[0] > 0:
        return permutations(table, counts, first, pairs, vectors, codes)
    return arrangements(table, counts, first, vectors, codes)


@njit(cache=True, nogil=True)
def cells(vectors: Any, rows: int, plane: int, reach: float, width: float, start: Any, order: Any, near: Any, cell: Any) -> int:
    """Vectors sorted by square cell of one plane, near[start[c]:start[c + 1]] those of cell c; says how many cells a side."""
    most = int(np.sqrt(start.shape[0] - 2))
    side = max(1, min(int(2 * reach / width), most))
    scale = side / (2 * reach)
    last = side * side
    start[: last + 1] = 0
    for row in range(rows):
        i = min(max(int((vectors[row, plane] + reach) * scale), 0), side - 1)
        j = min(max(int((vectors[row, plane + 1] + reach) * scale), 0), side - 1)
        cell[row] = i * side + j
        start[cell[row] + 1] += 1
    for c in range(last):
        start[c + 1] += start[c]
    for row in range(rows - 1, -1, -1):
        start[cell[row] + 1] -= 1
        at = start[cell[row] + 1]
        order[at] = row
        near[at, 0] = vectors[row, plane]
        near[at, 1] = vectors[row, plane + 1]
    # start[c + 1] has come down to the first row of cell c
    for c in range(last):
        start[c] = start[c + 1]
    start[last] = rows
    return side


@njit(cache=True, nogil=True)
def succession(star: Any, members: Any, step: int, directions: int, seat: Any) -> int:
    """How many neighbours fire one after the other; where two share each direction, in the best order there is."""
    seat[:] = -1
    for place in range(star.shape[0]):
        for one in range(2):
            if members[place, one] >= 0:
                d = star[place]
                seat[d, 0 if seat[d, 0] < 0 else 1] = members[place, one]
    if step > 0:
        count = 0
        for d in range(directions):
            if abs(seat[d, 0] - seat[(d + step) % directions, 0]) == 1:
                count += 1
        return count
    # a cycle is two turns: which of the two that share a direction fires in the first; the first direction's is free
    straight, crossed = 0, 2 * seat.shape[0] + 9
    for d in range(1, directions):
        keep = 0
        swap = 0
        for one in range(2):
            if abs(seat[d - 1, one] - seat[d, one]) == 1:
                keep += 1
            if abs(seat[d - 1, one] - seat[d, 1 - one]) == 1:
                swap += 1
        straight, crossed = min(straight + keep, crossed + swap), min(straight + swap, crossed + keep)
    over = 0
    through = 0
    for one in range(2):
        if abs(seat[directions - 1, one] - seat[0, 1 - one]) == 1:
            over += 1
        if abs(seat[directions - 1, 1 - one] - seat[0, 1 - one]) == 1:
            through += 1
    return min(straight + over, crossed + through)


@njit(cache=True, nogil=True)
def values_of(star: Any, tables: Any, sums: Any, values: Any, seat: Any) -> bool:
    """Values of a star's objectives, summed along the shaft; says whether it keeps the limits."""
    places, directions, width = tables.whole.shape
    lengths = width // 2
    sums[:] = 0.0
    for place in range(places):
        for c in range(width):
            sums[c] += tables.whole[place, star[place], c]
    counted = 0
    if tables.counts:
        counted = succession(star, tables.members, tables.step, directions, seat)
    kept = counted <= tables.limits[lengths]
    for o in range(lengths):
        square = sums[2 * o] * sums[2 * o] + sums[2 * o + 1] * sums[2 * o + 1]
        if np.sqrt(square) > tables.limits[o] + SAME:
            kept = False
        sums[o] = square
    for q in range(values.shape[0]):
        total = 0.0
        for o in range(lengths):
            total += tables.weights[q, o] * sums[o]
        values[q] = np.sqrt(total) + tables.weights[q, lengths] * counted
    return kept


@njit(cache=True, nogil=True)
def canonical(star: Any, tables: Any, other: Any, least: Any) -> int:
    """The first, in the order of words, of all stars that are the same but for the symmetries; says how many they are."""
    places, directions, _ = tables.whole.shape
    same = 0
    for g in range(tables.symmetries.shape[0]):
        sign = -1 if tables.symmetries[g, 0] else 1
        back = tables.symmetries[g, 1]
        zero = 0
        if tables.anchored:
            zero = star[places - 1] if back else star[0]
        order = 0
        for place in range(places):
            d = star[places - 1 - place] if back else star[place]
            other[place] = (sign * (d - zero)) % directions
            if order == 0 and g > 0:
                order = (other[place] > least[place]) - (other[place] < least[place])
        if g == 0 or order < 0:
            least[:] = other
            same = 1
        elif order == 0:
            same += 1
    return tables.symmetries.shape[0] // same


@njit(cache=True, nogil=True)
def dominated(values: Any, front: Any, known: int, slack: float) -> bool:
    """Whether a point of the front is as good in all and better in one; with slack, of values that may be off by so much."""
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


@njit(cache=True, nogil=True)
def entered(values: Any, front: Any, known: int) -> int:
    """The front with one more point in it (not dominated), and without those it dominates or that equal it: how many remain."""
    kept = 0
    for f in range(known):
        worse = True
        for q in range(values.shape[0]):
            if front[f, q] < values[q] - SAME:
                worse = False
        if not worse:
            front[kept] = front[f]
            kept += 1
    if kept < front.shape[0]:
        front[kept] = values
        kept += 1
    return kept


@njit(cache=True, nogil=True)
def searched(tables: Any, blocks: Any, radii: Any, room: Any, found: Any, front: Any, state: Any) -> bool:
    """Visits the stars of some blocks that lie in a strip; says whether it came to the end (else: empty `found`, go on).

    blocks: how many places of each half get each direction, and how many blocks it stands for [b, 2 n + 1]; radii: strips
    as rows of the sum that drives, and its greatest length; found: values [f, q], stars [f, places], how many classes
    each stands for, in units of one over the number of symmetries, and how many stars; front: what is known and as good or
    better in all objectives is not reported (one row of infinities for none); state: block, strip, row to go on from; how
    many are found, how many stars lie in the strips, how many points the front has, whether the front grows.
    """
    directions = tables.whole.shape[1]
    lengths = tables.constant.shape[0] // 2
    symmetries = tables.symmetries.shape[0]
    star = np.empty(tables.whole.shape[0], np.int64)
    least, other = star.copy(), star.copy()
    sums = np.empty(2 * lengths)
    values = np.empty(tables.weights.shape[0])
    seat = np.empty((directions, 2), np.int64)
    free, held = tables.outer.shape[0], tables.inner.shape[0]
    nothing = np.zeros(2 * lengths)
    for f in range(tables.fixed.shape[0]):
        star[tables.places[free + held + f]] = tables.fixed[f]
    for b in range(state[0], blocks.shape[0]):
        outers = arranged(tables.outer, blocks[b, :directions], tables.constant, room.outer_pairs, room.outer, room.outer_code)
        shared = blocks[b, directions : 2 * directions]
        inners = arranged(tables.inner, shared, nothing, room.inner_pairs, room.inner, room.inner_code)
        times = blocks[b, 2 * directions]
        for d in range(state[1], radii.shape[0]):
            drive, radius = int(radii[d, 0]), radii[d, 1]
            x, y = 2 * drive, 2 * drive + 1
            reach = room.reach[drive]
            spread = max(room.cell[drive], min(radius, reach))
            side = cells(room.inner, inners, x, reach, spread, room.start, room.order, room.near, room.where)
            scale, square = side / (2 * reach), radius * radius
            for r in range(state[2], outers):
                p, q = -room.outer[r, x], -room.outer[r, y]
                if abs(p) > reach + radius or abs(q) > reach + radius:
                    continue
                i0 = min(max(int((p - radius + reach) * scale), 0), side - 1)
                i1 = min(max(int((p + radius + reach) * scale), 0), side - 1)
                j0 = min(max(int((q - radius + reach) * scale), 0), side - 1)
                j1 = min(max(int((q + radius + reach) * scale), 0), side - 1)
                for i in range(i0, i1 + 1):
                    for at in range(room.start[i * side + j0], room.start[i * side + j1 + 1]):
                        dx, dy = room.near[at, 0] - p, room.near[at, 1] - q
                        if dx * dx + dy * dy > square:
                            continue
                        s = room.order[at]
                        for o in range(lengths):
                            ux = room.outer[r, 2 * o] + room.inner[s, 2 * o]
                            uy = room.outer[r, 2 * o + 1] + room.inner[s, 2 * o + 1]
                            sums[o] = ux * ux + uy * uy
                        wanted = True
                        for e in range(d):  # met in an earlier strip
                            if sums[int(radii[e, 0])] <= radii[e, 1] * radii[e, 1]:
                                wanted = False
                        if not wanted:
                            continue
                        state[4] += times
                        for o in range(lengths):
                            if sums[o] > room.loose[o]:
                                wanted = False
                        if not wanted:
                            continue
                        for v in range(values.shape[0]):
                            total = 0.0
                            for o in range(lengths):
                                total += tables.weights[v, o] * sums[o]
                            values[v] = np.sqrt(total)
                        if dominated(values, front, state[5], ROUNDING):
                            continue
                        for k in range(free):
                            star[tables.places[k]] = (room.outer_code[r] >> (BITS * k)) & 31
                        for k in range(held):
                            star[tables.places[free + k]] = (room.inner_code[s] >> (BITS * k)) & 31
                        orbit = canonical(star, tables, other, least)
                        if not values_of(least, tables, sums, values, seat) or dominated(values, front, state[5], 0.0):
                            continue
                        if state[6]:
                            state[5] = entered(values, front, state[5])
                        at_row = state[3]
                        found.values[at_row] = values
                        found.stars[at_row] = least
                        found.classes[at_row] = times * (symmetries // orbit)
                        found.times[at_row] = times
                        state[3] += 1
                if state[3] + inners > found.values.shape[0]:
                    state[0], state[1], state[2] = b, d, r + 1
                    return False
            state[2] = 0
        state[1] = 0
    state[0] = blocks.shape[0]
    return True
