"""A star as an Engine: in-line, upright, turning clockwise, in the units of the star.

A throw of direction d comes to top dead centre 360 d/n degrees of crank angle after that of
direction 0 (n directions). The shaft turns clockwise seen from the front, so that its pin stands at
the bearing -360 d/n degrees while that of direction 0 is up. In a two-stroke engine the directions
fire in the order 0, 1, 2, ..., in a four-stroke one of odd n every other one. Where two cylinders
share each direction, one of the two fires in the first turn of the cycle, the other in the second:
of all these orders that with the fewest neighbours in succession is taken, and among those the
first by the numbers of its cylinders.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import radians

from crankstar.engine.basis import ASSUMED_ROD_RATIO, ROD_SOURCE, Basis, Sizes
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.engine.records import Provenance
from crankstar.stars.faults import SearchError, error
from crankstar.stars.star import Star, Stars

Seats = list[tuple[int, int]]
"""The two cylinders of each direction, in the order in which the directions fire."""


def firing_order(stars: Stars, star: Star) -> tuple[int, ...]:
    """The cylinders of a star in the order in which they fire, cylinder 1 first.

    Raises SearchError.

    >>> from fractions import Fraction
    >>> def row(n):
    ...     return tuple(Fraction(n - 1, 2) - j for j in range(n))
    >>> firing_order(Stars(5, "four-stroke", row(5)), (0, 3, 2, 4, 1))  # directions 0, 2, 4, 1, 3
    (1, 3, 4, 5, 2)
    >>> firing_order(Stars(6, "four-stroke", row(6)), (0, 1, 2, 2, 1, 0))
    (1, 5, 3, 6, 2, 4)
    """
    misfit = stars.misfit(star)
    if misfit:
        raise SearchError([misfit])
    n = stars.directions
    if stars.sharing == 2:
        seats = [_sharing(star, (star[0] + turn) % n) for turn in range(n)]
        return _least_neighbours(seats)
    at = {direction: number for number, direction in enumerate(star, 1)}
    return tuple(at[(star[0] + turn * stars.step) % n] for turn in range(n))


def _sharing(star: Star, direction: int) -> tuple[int, int]:
    first, other = (number for number, own in enumerate(star, 1) if own == direction)
    return first, other


def _least_neighbours(seats: Seats) -> tuple[int, ...]:
    """The order with the fewest neighbours in succession, of equal ones the lowest by its numbers.

    Cylinder 1 is the first of the first seat.

    `left[k][c]` is the least number from seat k to the end of the cycle, if cylinder c of seat k
    fires in the first turn.
    """
    last = len(seats) - 1
    over = seats[0]
    left = [[0, 0] for _ in seats]
    for c in (0, 1):
        first, second = _turned(seats[last], c)
        left[last][c] = _beside(first, over[1]) + _beside(second, over[0])
    for k in range(last - 1, -1, -1):
        for c in (0, 1):
            left[k][c] = min(_step(seats, k, c, then) + left[k + 1][then] for then in (0, 1))
    chosen = [0]
    for k in range(last):
        ways = sorted(
            (_step(seats, k, chosen[-1], then) + left[k + 1][then], seats[k + 1][then], then)
            for then in (0, 1)
        )
        chosen.append(ways[0][2])
    pairs = [_turned(seat, c) for seat, c in zip(seats, chosen, strict=True)]
    return (*(first for first, _ in pairs), *(second for _, second in pairs))


def _step(seats: Seats, k: int, own: int, then: int) -> int:
    """Neighbours in succession from seat k to the next, in both turns."""
    return sum(
        _beside(a, b)
        for a, b in zip(_turned(seats[k], own), _turned(seats[k + 1], then), strict=True)
    )


def _turned(seat: tuple[int, int], first: int) -> tuple[int, int]:
    return seat[first], seat[1 - first]


def _beside(first: int, other: int) -> int:
    return int(abs(first - other) == 1)


def dead_centres_deg(stars: Stars, star: Star) -> tuple[float, ...]:
    """Angle of each cylinder's top dead centre after that of cylinder 1, 0 to 360 degrees."""
    n = stars.directions
    return tuple(float(360 * ((direction - star[0]) % n) / n) for direction in star)


def engine(
    stars: Stars, star: Star, *, later_deg: Sequence[float] | None = None, name: str | None = None
) -> Engine:
    """The in-line engine of a star.

    Crank radius and masses of one, positions in the unit of those of the star.

    `later_deg`: by how many degrees of crank angle each cylinder comes later to top dead centre
    than the star says, for uneven angles; `name`: left out, the number of cylinders, the cycle and
    the firing order. The length of the rods is assumed, and said to be: couples of the first order
    do not hang on it. Raises SearchError, and EngineError for what cannot fire.

    >>> from fractions import Fraction
    >>> from crankstar.mechanics.balance import balance, total
    >>> from crankstar.stars.sums import couple
    >>> seven = Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7)))
    >>> built = engine(seven, (0, 6, 2, 3, 4, 1, 5))
    >>> built.name
    '7 cylinders, two-stroke, 1-6-3-4-5-7-2'
    >>> first = 2 * abs(total(balance(built)).couple.forward[0])  # in the cylinders' plane
    >>> print(first.round(6), round(couple(seven, 1).length((0, 6, 2, 3, 4, 1, 5)), 6))
    4.51031 4.51031
    """
    order = firing_order(stars, star)
    centres = dead_centres_deg(stars, star)
    later = tuple(later_deg) if later_deg is not None else (0.0,) * stars.cylinders
    if len(later) != stars.cylinders:
        raise error("", "later", given=len(later), cylinders=stars.cylinders)
    basis = Basis(
        name=name or f"{_counted(stars.cylinders)}, {stars.cycle}, {'-'.join(map(str, order))}",
        cycle=stars.cycle,
        firing_order=order,
        cylinder=Sizes(rod_ratio=ASSUMED_ROD_RATIO),
        relative=("pitch",),
        source="a crank star of evenly spaced throws"
        if later_deg is None
        else "a crank star with uneven angles",
        provenance=_provenance(stars),
    )
    throws = tuple(
        -radians(angle + by - later[0]) for angle, by in zip(centres, later, strict=True)
    )
    behind = tuple(float(stars.positions[0] - place) for place in stars.positions)
    # positions are counted in the unit of the star, whatever the least gap between two cylinders is
    return with_values(inline(basis, throws=throws, positions=behind), bore_pitch=1.0)


def _counted(cylinders: int) -> str:
    return f"{cylinders} cylinder{'s' if cylinders > 1 else ''}"


def _provenance(stars: Stars) -> dict[str, Provenance]:
    """Where each value of the engine of a star comes from, by its key in the explicit form."""
    choice = (
        "; of the orders the throws allow, one with the fewest neighbours in succession"
        if stars.sharing == 2
        else ""
    )
    sources = {
        "firing_order": f"follows from the throws{choice}",
        "relative": "a star has neither sizes nor masses",
        "bore_pitch": "the unit in which the positions of the star are counted",
        "shaft": "the throws of the star, crank radius 1",
        "cylinders": "the positions of the star, reciprocating masses of 1",
    }
    computed = {
        key: Provenance(status="computed", source=source) for key, source in sources.items()
    }
    rods = Provenance(status="placeholder", source=ROD_SOURCE)
    return {**computed, "cylinders.rod_length": rods}
