"""Compiled loops over all arrangements of one half of the shaft.

An arrangement is a direction for each place of the half: a code of BITS bits for each, and a
vector, the sum of what the places add in these directions.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from crankstar.stars.compiling import compiled

BITS = 5
"""Bits of a direction in the code of a half: up to 32 directions, up to 12 places."""


@compiled
def arrangements(table: Any, counts: Any, first: Any, vectors: Any, codes: Any) -> int:
    """Number of arrangements of a half, counts[d] places in direction d; writes vectors, codes."""
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


@compiled
def exchanges(places: int) -> Any:
    """Pairs of places, exchanged in turn through all their permutations [places! - 1, 2].

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


@compiled
def permutations(table: Any, counts: Any, first: Any, pairs: Any, vectors: Any, codes: Any) -> int:
    """As `arrangements` where each direction occurs once: two places are exchanged at a time."""
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


@compiled
def arranged(table: Any, counts: Any, first: Any, pairs: Any, vectors: Any, codes: Any) -> int:
    """Number of arrangements of a half, by the faster way; writes vectors and codes."""
    if pairs.shape[0] > 0:
        return permutations(table, counts, first, pairs, vectors, codes)
    return arrangements(table, counts, first, vectors, codes)
