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
def cells(room: Any, rows: int, drive: int, radii: Any) -> int:
    """Inner vectors sorted by square cell of the plane that drives; says how many cells a side.

    near[start[c]:start[c + 1]] are those of cell c. A cell is no smaller than the radius, so that few are looked into.
    """
    plane, reach = 2 * drive, room.reach[drive]
    inner, start, order, near, where = room.inner, room.start, room.order, room.near, room.where  # else looked up in each turn
    side = max(1, min(int(2 * reach / max(room.cell[drive], min(radii[1], reach))), int(np.sqrt(start.shape[0] - 2))))
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
def weighed(outer: Any, inner: Any, r: int, s: int, radii: Any, d: int, loose: Any, sums: Any) -> int:
    """Squares of the sums of the star of two arrangements; -1 if met in a strip before d, 0 if it breaks a limit, else 1."""
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


@njit(cache=True, nogil=True)
def hopeless(weights: Any, sums: Any, values: Any, front: Any, known: int) -> bool:
    """Whether a star with these squares of sums is dominated however few neighbours it has in succession."""
    for v in range(values.shape[0]):
        total = 0.0
        for o in range(sums.shape[0] // 2):
            total += weights[v, o] * sums[o]
        values[v] = np.sqrt(total)
    return dominated(values, front, known, ROUNDING)


@njit(cache=True, nogil=True)
def reported(tables: Any, room: Any, pair: Any, times: int, found: Any, front: Any, state: Any, desk: Any) -> None:
    """Writes down the star of a pair, as the first of its class, unless what is known is better or it breaks a limit."""
    free, held = tables.outer.shape[0], tables.inner.shape[0]
    for k in range(free):
        desk.star[tables.places[k]] = (room.outer_code[pair[0]] >> (BITS * k)) & 31
    for k in range(held):
        desk.star[tables.places[free + k]] = (room.inner_code[pair[1]] >> (BITS * k)) & 31
    orbit = canonical(desk.star, tables, desk.other, desk.least)
    if not values_of(desk.least, tables, desk.sums, desk.values, desk.seat):
        return
    if dominated(desk.values, front, state[5], 0.0):
        return
    if state[6]:
        state[5] = entered(desk.values, front, state[5])
    row = state[3]
    found.values[row] = desk.values
    found.stars[row] = desk.least
    found.classes[row] = times * (tables.symmetries.shape[0] // orbit)
    found.times[row] = times
    state[3] += 1


@njit(cache=True, nogil=True)
def searched(tables: Any, blocks: Any, radii: Any, room: Any, found: Any, front: Any, state: Any, desk: Any) -> bool:
    """Visits the stars of some blocks that lie in a strip; says whether it came to the end (else: empty `found`, go on).

    blocks: how many places of each half get each direction, and how many blocks it stands for [b, 2 n + 1]; radii: strips
    as rows of the sum that drives, and its greatest length; front: what is known and as good or better in all objectives
    is not reported; state: block, strip, row to go on from; how many are found, how many stars lie in the strips, how
    many points the front has, whether the front grows.
    """
    directions = tables.whole.shape[1]
    free, held = tables.outer.shape[0], tables.inner.shape[0]
    nothing = np.zeros(tables.constant.shape[0])
    pair = np.zeros(2, np.int64)
    outer, inner, loose, weights = room.outer, room.inner, room.loose, tables.weights  # structures are dear to pass
    sums, values = desk.sums, desk.values
    for f in range(tables.fixed.shape[0]):
        desk.star[tables.places[free + held + f]] = tables.fixed[f]
    for b in range(state[0], blocks.shape[0]):
        shared = blocks[b, :directions], blocks[b, directions : 2 * directions]
        outers = arranged(tables.outer, shared[0], tables.constant, room.outer_pairs, room.outer, room.outer_code)
        inners = arranged(tables.inner, shared[1], nothing, room.inner_pairs, room.inner, room.inner_code)
        times = blocks[b, 2 * directions]
        for d in range(state[1], radii.shape[0]):
            drive, radius = int(radii[d, 0]), radii[d, 1]
            reach, square = room.reach[drive], radius * radius
            side = cells(room, inners, drive, radii[d])
            scale, last = side / (2 * reach), side - 1
            start, near, order = room.start, room.near, room.order
            for r in range(state[2], outers):
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
                            known = weighed(outer, inner, r, order[at], radii, d, loose, sums)
                            state[4] += times if known >= 0 else 0
                            if known > 0 and not hopeless(weights, sums, values, front, state[5]):
                                pair[1] = order[at]
                                reported(tables, room, pair, times, found, front, state, desk)
                if state[3] + inners > found.values.shape[0]:
                    state[0], state[1], state[2] = b, d, r + 1
                    return False
            state[2] = 0
        state[1] = 0
    state[0] = blocks.shape[0]
    return True
