"""Compiled loops over all stars of a shaft and the firing sequences of each.

Stars are visited depth first, their sums carried along. A star whose values can be bettered
whatever its sequence is left at once. With one goal that depends on the sequence it is known how
great that may be: as the least of the points of the front that are as good in all others. Only
signs whose first sum is short enough are looked at (`sign_kernels`). With several such goals their
least values over all signs, each by itself, are a bound: no sequence of the star is better in any.

Letters of the shapes: n throws; K classes; w sums of the star and m of the sequence, each two
numbers; q goals; f rows found.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from crankstar.stars.compiling import compiled
from crankstar.stars.kernels import entered
from crankstar.stars.sequence_arrays import DEPTH, FORMED, FOUND, KNOWN, STARS
from crankstar.stars.sign_kernels import beyond, driver, largest, least, short, signed, surpassed
from crankstar.stars.sums import SAME

AT_ONCE = 200_000
"""Stars after which the loops come up, so that they can be halted."""


@compiled
def twin(choice: Any, classes: int) -> int:
    """1 if a star is the first of it and its mirror image, 0 if it is both, -1 if the second."""
    for throw in range(choice.shape[0]):
        other = (classes - choice[throw]) % classes
        if choice[throw] != other:
            return 1 if choice[throw] < other else -1
    return 0


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
    if surpassed(walk.whole, front, state[KNOWN], 0.0):
        return
    state[KNOWN] = entered(walk.whole, front, state[KNOWN])
    recorded(tables, walk, code, times, output, state)


@compiled
def recorded(tables: Any, walk: Any, code: int, times: int, output: Any, state: Any) -> None:
    """Write a star with a sequence."""
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
    if surpassed(walk.whole, front, state[KNOWN], 1e-11):
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
        for index in range(classes):
            own = index * tables.step % classes
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
    if surpassed(walk.bounds, front, state[KNOWN], 1e-11):
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
        if not surpassed(walk.values, front, state[KNOWN], 1e-11):
            differences(tables, walk)
            each(tables, walk, times, output, front, state)
        return
    most = cut(walk.values, tables.goal, front, state[KNOWN])
    if most >= walk.values[tables.goal] and most >= 0.0:
        differences(tables, walk)
        below(tables, walk, most, times, output, front, state)


@compiled
def every_one(tables: Any, walk: Any, times: int, output: Any, state: Any) -> None:
    """Write all sequences of a star within the limit of neighbours, whatever their values."""
    classes, width = tables.turns.shape
    ahead, rear, middle = walk.front_half, walk.rear_half, (classes + 1) // 2
    differences(tables, walk)
    aheads = rears = 1
    if tables.room == 2:
        aheads = signed(walk.delta, tables.turns, 0, middle, True, ahead, 0, width)
        rears = signed(walk.delta, tables.turns, middle, classes, False, rear, 0, width)
    for i in range(aheads):
        for j in range(rears):
            state[FORMED] += times
            code = i + (j << (middle - 1))
            walk.whole[:] = walk.values
            if width > 0:
                goals_of(walk, i, j, tables)
            if tables.counts:
                number = succession(tables, walk, code)
                if tables.counted >= 0:
                    walk.whole[tables.counted] = number / tables.size
                if number > tables.at_most:
                    continue
            recorded(tables, walk, code, times, output, state)


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
    if tables.every:
        every_one(tables, walk, times, output, state)
    elif tables.turns.shape[1] > 0:
        sequences(tables, walk, times, output, front, state)
    else:
        walk.whole[:] = walk.values
        if surpassed(walk.whole, front, state[KNOWN], 1e-11):
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

    Else `output` is full, or AT_ONCE stars were visited: empty it and call again, all else as it
    was. most: rows that one star can bring.
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
    depth, stars = state[DEPTH], 0
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
        stars += 1
        if state[FOUND] + most > output.times.shape[0] or stars == AT_ONCE:
            state[DEPTH] = depth
            return False
    return True
