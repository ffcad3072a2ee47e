"""Compiled loops over all stars of a shaft, and over the firing sequences of each by halves.

Stars are visited depth first, their sums carried along. A star whose values can be bettered
whatever its sequence is left at once. For the others the half orders of torsion are sums over the
classes c of +-v_c: the classes are divided into two halves, all signs of one meet all of the other,
and only pairs whose sum is short enough not to be dominated are looked at. With one goal that
depends on the sequence that length is known before: the least value of that goal in the points of
the front that are as good in all others. With several goals their least values over all signs, each
by itself, are a bound: no sequence of the star is better than that in any of them.

Source: E. Horowitz and S. Sahni, Computing partitions with applications to the knapsack problem,
Journal of the ACM 21 (1974) 277 (sums of signs by halves).

Letters of the shapes: n throws; K classes; w sums of the star and m of the sequence, each two
numbers; q goals; f rows found.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from crankstar.search.compiling import compiled
from crankstar.search.kernels import dominated, entered
from crankstar.search.sums import SAME

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


@compiled
def twin(choice: Any, classes: int) -> int:
    """1 if a star is the first of it and its mirror image, 0 if it is both, -1 if the second."""
    for throw in range(choice.shape[0]):
        other = (classes - choice[throw]) % classes
        if choice[throw] != other:
            return 1 if choice[throw] < other else -1
    return 0


@compiled
def signed(
    delta: Any, turns: Any, first: int, last: int, fixed: bool, out: Any, low: int, high: int
) -> int:
    """Number of sums over the classes from first to last with all signs; writes them [2 m, rows].

    fixed: the sign of the first class is +. Bit b of a row is set where class first + b (after the
    fixed one) has the sign -. Of the sums only the columns from low to high.
    """
    for c in range(low, high):
        total = 0.0
        for own in range(first, last):
            total += delta[own] * turns[own, c]
        out[c, 0] = total
    rows = 1
    for own in range(first + (1 if fixed else 0), last):
        for c in range(low, high):
            twice = 2.0 * delta[own] * turns[own, c]
            for row in range(rows):
                out[c, rows + row] = out[c, row] - twice
        rows *= 2
    return rows


@compiled
def short(x: float, y: float, rear: Any, c: int, rows: int, square: float) -> int:
    """How many of the rear half make a sum with x + iy whose square is at most so great."""
    count = 0
    for row in range(rows):
        dx = x + rear[c, row]
        dy = y + rear[c + 1, row]
        count += dx * dx + dy * dy <= square
    return count


@compiled
def largest(front: Any, i: int, rear: Any, j: int, weights: Any) -> float:
    """The largest of the weighted lengths of the sums of two rows."""
    most = 0.0
    for o in range(weights.shape[0]):
        if weights[o] > 0.0:
            x = front[2 * o, i] + rear[2 * o, j]
            y = front[2 * o + 1, i] + rear[2 * o + 1, j]
            most = max(most, weights[o] * weights[o] * (x * x + y * y))
    return np.sqrt(most)


@compiled
def driver(weights: Any) -> int:
    """The sum with the greatest weight."""
    best = 0
    for o in range(weights.shape[0]):
        if weights[o] > weights[best]:
            best = o
    return best


@compiled
def least(front: Any, fronts: int, rear: Any, rears: int, weights: Any) -> float:
    """The least value of a goal over all signs."""
    drive = driver(weights)
    best = np.inf
    for i in range(fronts):
        square = (best / weights[drive]) ** 2
        if short(front[2 * drive, i], front[2 * drive + 1, i], rear, 2 * drive, rears, square):
            for j in range(rears):
                best = min(best, largest(front, i, rear, j, weights))
    return best


@compiled
def cut(values: Any, goal: int, front: Any, known: int) -> float:
    """The greatest value of a goal at which a star with these others is not surely dominated."""
    out = np.inf
    for f in range(known):
        if front[f, goal] - SAME >= out:
            continue
        better, worse = False, False
        for q in range(values.shape[0]):
            if q == goal:
                continue
            if front[f, q] > values[q] + SAME:
                worse = True
                break
            if front[f, q] < values[q] - SAME:
                better = True
        if not worse:
            out = min(out, front[f, goal] + (-SAME if better else SAME))
    return out


@compiled
def written(
    tables: Any, walk: Any, code: int, times: int, output: Any, front: Any, state: Any
) -> None:
    """Write a star with a sequence that no point of the front dominates."""
    if dominated(walk.whole, front, state[KNOWN], 0.0):
        return
    state[KNOWN] = entered(walk.whole, front, state[KNOWN])
    row = state[FOUND]
    throws = walk.choice.shape[0]
    output.values[row] = walk.whole
    for throw in range(throws):
        output.rows[row, throw] = walk.choice[throw]
    if tables.room == 2:
        for own in range(tables.turns.shape[0]):
            output.rows[row, throws + own] = 1 if own == 0 else 1 - ((code >> (own - 1)) & 1)
    output.times[row] = times
    state[FOUND] += 1


@compiled
def goals_of(walk: Any, i: int, j: int, tables: Any) -> None:
    """Write the values of the goals with the signs of two rows."""
    for q in range(walk.values.shape[0]):
        own = largest(walk.front_half, i, walk.rear_half, j, tables.sequence_weights[q])
        walk.whole[q] = max(walk.values[q], own)


@compiled
def allowed(tables: Any, walk: Any, code: int, front: Any, state: Any) -> bool:
    """Whether neighbours in succession are few enough; writes their number where it is a goal."""
    if not tables.counts:
        return True
    if dominated(walk.whole, front, state[KNOWN], 1e-11):
        return False
    number = succession(tables, walk, code)
    if tables.counted >= 0:
        walk.whole[tables.counted] = number / tables.size
    return number <= tables.at_most


@compiled
def differences(tables: Any, walk: Any) -> None:
    """Write the difference of the amplitudes of each class, in the order of throws and banks."""
    classes = tables.turns.shape[0]
    walk.delta[:] = 0.0
    walk.seen[:] = 0
    for throw in range(tables.amplitudes.shape[0]):
        for bank in range(tables.amplitudes.shape[1]):
            own = (walk.choice[throw] + bank * tables.shift) % classes
            sign = 1.0 if walk.seen[own] == 0 else -1.0
            walk.seat[own, walk.seen[own]] = 2 * throw + bank
            walk.seen[own] += 1
            walk.delta[own] += sign * tables.amplitudes[throw, bank]


@compiled
def succession(tables: Any, walk: Any, code: int) -> int:
    """Number of neighbours in a bank that fire in succession; the seats are those of the star."""
    classes = walk.seat.shape[0]
    first, last, count = 0, -1, 0
    for turn in range(tables.room):
        for place in range(classes):
            own = place * tables.step % classes
            side = turn
            if own > 0 and (code >> (own - 1)) & 1:
                side = 1 - turn
            now = walk.seat[own, side]
            if last < 0:
                first = now
            elif abs(now - last) == 2:  # two throws side by side, in one bank
                count += 1
            last = now
    return count + (1 if abs(first - last) == 2 else 0)


@compiled
def calmest(tables: Any, walk: Any) -> tuple[int, int]:
    """The sequence with the fewest neighbours in succession, and how many sequences there are."""
    if tables.room == 1:
        return 0, 1
    many = 1 << (walk.seat.shape[0] - 1)
    best, fewest = 0, 2 * walk.seat.shape[0] + 1
    for code in range(many):
        number = succession(tables, walk, code)
        if number < fewest:
            best, fewest = code, number
    return best, many


@compiled
def beyond(tables: Any, walk: Any, code: int, drive: int, weights: Any, square: float) -> float:
    """Square of the largest weighted sum but the driver with some signs; -1 where it is greater.

    Greater than `square`, at once.
    """
    classes, most = tables.turns.shape[0], 0.0
    for o in range(weights.shape[0]):
        if o == drive or weights[o] == 0.0:
            continue
        x, y = 0.0, 0.0
        for own in range(classes):
            size = walk.delta[own]
            if own > 0 and (code >> (own - 1)) & 1:
                size = -size
            x += size * tables.turns[own, 2 * o]
            y += size * tables.turns[own, 2 * o + 1]
        own_square = weights[o] * weights[o] * (x * x + y * y)
        if own_square > square:
            return -1.0
        most = max(most, own_square)
    return most


@compiled
def below(
    tables: Any, walk: Any, most: float, times: int, output: Any, front: Any, state: Any
) -> None:
    """Write the sequences of a star whose one goal is at most so great: those of a short driver."""
    goal, classes = tables.goal, tables.turns.shape[0]
    weights, delta, turns = tables.sequence_weights[goal], walk.delta, tables.turns
    ahead, rear = walk.front_half, walk.rear_half
    drive, middle = driver(weights), (classes + 1) // 2
    c = 2 * drive
    aheads = signed(delta, turns, 0, middle, True, ahead, c, c + 2)
    rears = signed(delta, turns, middle, classes, False, rear, c, c + 2)
    greatest = (most + SAME) ** 2
    square = greatest / weights[drive] ** 2
    for i in range(aheads):
        x, y = ahead[c, i], ahead[c + 1, i]
        if short(x, y, rear, c, rears, square) == 0:
            continue
        for j in range(rears):
            dx, dy = x + rear[c, j], y + rear[c + 1, j]
            own = dx * dx + dy * dy
            if own <= square:
                state[FORMED] += times
                code = i + (j << (middle - 1))
                others = beyond(tables, walk, code, drive, weights, greatest)
                if others < 0.0:
                    continue
                value = np.sqrt(max(others, own * weights[drive] ** 2))
                walk.whole[:] = walk.values
                walk.whole[goal] = max(walk.values[goal], value)
                if allowed(tables, walk, code, front, state):
                    written(tables, walk, code, times, output, front, state)


@compiled
def each(tables: Any, walk: Any, times: int, output: Any, front: Any, state: Any) -> None:
    """Write the sequences of a star by several goals, unless none of them can be on the front."""
    classes, width = tables.turns.shape
    ahead, rear, middle = walk.front_half, walk.rear_half, (classes + 1) // 2
    aheads = signed(walk.delta, tables.turns, 0, middle, True, ahead, 0, width)
    rears = signed(walk.delta, tables.turns, middle, classes, False, rear, 0, width)
    for q in range(walk.values.shape[0]):
        walk.bounds[q] = walk.values[q]
        if tables.sequence_weights[q].max() > 0.0:
            own = least(ahead, aheads, rear, rears, tables.sequence_weights[q])
            walk.bounds[q] = max(walk.bounds[q], own)
    if dominated(walk.bounds, front, state[KNOWN], 1e-11):
        return
    for i in range(aheads):
        for j in range(rears):
            state[FORMED] += times
            goals_of(walk, i, j, tables)
            code = i + (j << (middle - 1))
            if allowed(tables, walk, code, front, state):
                written(tables, walk, code, times, output, front, state)


@compiled
def sequences(tables: Any, walk: Any, times: int, output: Any, front: Any, state: Any) -> None:
    """Look for sequences of a star that no point of the front dominates."""
    if tables.goal < 0:
        if not dominated(walk.values, front, state[KNOWN], 1e-11):
            differences(tables, walk)
            each(tables, walk, times, output, front, state)
        return
    most = cut(walk.values, tables.goal, front, state[KNOWN])
    if most >= walk.values[tables.goal] and most >= 0.0:
        differences(tables, walk)
        below(tables, walk, most, times, output, front, state)


@compiled
def met(tables: Any, walk: Any, output: Any, front: Any, state: Any) -> None:
    """Weigh the star that the walk has come to."""
    throws, classes = walk.choice.shape[0], tables.turns.shape[0]
    times = 1
    if tables.mirrored:
        side = twin(walk.choice, classes)
        if side < 0:
            return
        times = 1 + side
    state[STARS] += times
    sums = walk.sums[throws]
    walk.values[:] = 0.0
    for o in range(tables.caps.shape[0]):
        length = np.sqrt(sums[2 * o] * sums[2 * o] + sums[2 * o + 1] * sums[2 * o + 1])
        if length > tables.caps[o] + SAME:
            return
        for q in range(walk.values.shape[0]):
            walk.values[q] = max(walk.values[q], tables.star_weights[q, o] * length)
    if tables.turns.shape[1] > 0:
        sequences(tables, walk, times, output, front, state)
    else:
        walk.whole[:] = walk.values
        if dominated(walk.whole, front, state[KNOWN], 1e-11):
            return
        differences(tables, walk)
        if not allowed(tables, walk, 0, front, state):
            return
        code, many = calmest(tables, walk)
        written(tables, walk, code, times * many, output, front, state)


@compiled
def room_for(tables: Any, hits: Any, own: int) -> bool:
    """Whether the cylinders of a throw in a class have room."""
    classes = hits.shape[0]
    for bank in range(tables.amplitudes.shape[1]):
        at = own + bank * tables.shift
        if hits[at if at < classes else at - classes] >= tables.room:
            return False
    return True


@compiled
def filled(tables: Any, hits: Any, own: int, by: int) -> None:
    """Put the cylinders of a throw into their classes, or take them out."""
    classes = hits.shape[0]
    for bank in range(tables.amplitudes.shape[1]):
        at = own + bank * tables.shift
        hits[at if at < classes else at - classes] += by


@compiled
def placed(tables: Any, walk: Any, throw: int, own: int) -> None:
    """Put a throw into a class: writes fillings and sums."""
    filled(tables, walk.hits, own, 1)
    for c in range(tables.star.shape[2]):
        walk.sums[throw + 1, c] = walk.sums[throw, c] + tables.star[throw, own, c]
    walk.choice[throw] = own


@compiled
def visited(
    tables: Any, prefix: Any, walk: Any, output: Any, front: Any, most: int, state: Any
) -> bool:
    """Whether all stars that begin with a prefix were visited.

    Else `output` is full: empty it and call again, as it was. most: rows that one star can bring.
    state: see DEPTH; DEPTH is 0 at the first call.
    """
    throws, classes = walk.choice.shape[0], tables.star.shape[1]
    free = prefix.shape[0]
    choice, hits, sums, star = walk.choice, walk.hits, walk.sums, tables.star
    if state[DEPTH] == 0:
        hits[:] = 0
        for throw in range(free):
            if not room_for(tables, hits, prefix[throw]):
                return True
            placed(tables, walk, throw, prefix[throw])
        if free == throws:
            met(tables, walk, output, front, state)
            return True
        choice[free:] = -1
        state[DEPTH] = free
    depth = state[DEPTH]
    while depth >= free:
        own = choice[depth]
        if own >= 0:
            filled(tables, hits, own, -1)
        own += 1
        while own < classes and not room_for(tables, hits, own):
            own += 1
        if own == classes:
            choice[depth] = -1
            depth -= 1
            continue
        filled(tables, hits, own, 1)
        for c in range(star.shape[2]):
            sums[depth + 1, c] = sums[depth, c] + star[depth, own, c]
        choice[depth] = own
        if depth < throws - 1:
            depth += 1
            continue
        met(tables, walk, output, front, state)
        if state[FOUND] + most > output.times.shape[0]:
            state[DEPTH] = depth
            return False
    return True


@compiled
def sifted(values: Any, times: Any, points: Any, size: int, home: Any) -> None:
    """Find the point of each row, and keep so many rows of each: home is -1 for the others.

    times: how many orders a row stands for; the first row of a point gets them all. A row whose
    values are no point's is dominated.
    """
    seen = np.zeros(points.shape[0], np.int64)
    first = np.zeros(points.shape[0], np.int64)
    for row in range(values.shape[0]):
        home[row] = -1
        for f in range(points.shape[0]):
            same = True
            for q in range(values.shape[1]):
                if abs(values[row, q] - points[f, q]) > 2 * SAME:
                    same = False
                    break
            if same:
                if seen[f] == 0:
                    first[f] = row
                else:
                    times[first[f]] += times[row]
                    times[row] = 0
                if seen[f] < size:
                    home[row] = f
                seen[f] += 1
                break


@compiled
def joined(points: Any, known: int, others: Any) -> int:
    """Number of points of a front that others have joined, where no known one is as good."""
    for row in range(others.shape[0]):
        needed = True
        for f in range(known):
            worse = False
            for q in range(others.shape[1]):
                if points[f, q] > others[row, q] + SAME:
                    worse = True
                    break
            if not worse:
                needed = False
                break
        if needed:
            known = entered(others[row], points, known)
    return known
