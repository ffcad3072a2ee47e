"""Crank stars: all ways to set in-line cylinders on evenly spaced throws, and their number.

Directions are numbered in the order in which their throws come to top dead centre: direction d
stands for a throw 360 d/n degrees behind that of direction 0 (n directions), so a star is one
number for each cylinder from the front. A two-stroke engine of n cylinders, and a four-stroke one
of odd n, has a throw in each of n directions; a four-stroke one of even n has two in each of n/2.
Turning a star as a whole is turning the crankshaft: it is the same star, and is counted once. Its
mirror image is the crankshaft of the engine that turns the other way, and, where the cylinders
stand symmetrically, the star taken from the rear end is that of the engine turned end for end:
forces and couples are as great in all of these, which are one class.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import factorial, isfinite
from typing import get_args

from crankstar.engine.quantities import Cycle
from crankstar.language.faults import Fault
from crankstar.stars.faults import SearchError, fault

GREATEST_CYLINDERS = 24
"""Cylinders a star can have: a half of more than 12 places is beyond any memory."""


Star = tuple[int, ...]
"""The direction of each cylinder's throw, from the front."""


@dataclass(frozen=True)
class Stars:
    """The stars of an engine of so many cylinders.

    positions: of each cylinder along the shaft, falling from the front, in any unit (the couples
    are counted in it), measured from the middle; symmetric: only cranks of which the rear half is
    the mirror image of the front half (four-stroke, even); fixed: directions that some cylinders
    must have, by cylinder number.
    """

    cylinders: int
    cycle: Cycle
    positions: tuple[Fraction, ...]
    symmetric: bool = False
    fixed: tuple[tuple[int, int], ...] = ()

    def __post_init__(self) -> None:
        faults = list(self._faults())
        if faults:
            raise SearchError(faults)

    def _faults(self) -> Iterator[Fault]:
        if self.cycle not in get_args(Cycle):
            yield fault("cycle", "cycle", given=self.cycle, choices=", ".join(get_args(Cycle)))
        if not 1 <= self.cylinders <= GREATEST_CYLINDERS:
            given, most = self.cylinders, GREATEST_CYLINDERS
            yield fault("", "cylinders", given=given, least=1, most=most)
            return
        if len(self.positions) != self.cylinders:
            given = len(self.positions)
            yield fault("", "positions", given=given, cylinders=self.cylinders)
        elif any(not isfinite(place) for place in self.positions):
            yield fault("", "position")
        if self.symmetric and (self.sharing == 1 or not self.evenly_placed):
            yield fault("symmetric", "symmetric")
            return
        yield from self._fixed_faults()

    def _fixed_faults(self) -> Iterator[Fault]:
        """Faults of the fixed throws."""
        given: dict[int, int] = {}
        last, step = self.directions - 1, f"{360 / self.directions:.4g}"
        for number, direction in self.fixed:
            if not 1 <= number <= self.cylinders:
                wrong = {"cylinder": number, "cylinders": self.cylinders}
                yield fault("fix", "fixed-cylinder", **wrong)
            elif not 0 <= direction <= last:
                wrong = {"cylinder": number, "direction": direction, "last": last, "step": step}
                yield fault("fix", "fixed-direction", **wrong)
            elif given.setdefault(number, direction) != direction:
                wrong = {"cylinder": number, "first": given[number], "second": direction}
                yield fault("fix", "fixed-twice", **wrong)
        held: dict[int, list[int]] = {}
        for number, direction in sorted(given.items()):
            other = self.cylinders + 1 - number
            held.setdefault(direction, []).append(min(number, other) if self.symmetric else number)
            if self.symmetric and number < other and given.get(other, direction) != direction:
                yield fault("fix", "fixed-mirror", first=number, second=other)
        for direction, places in sorted(held.items()):
            if len(set(places)) > self.each:
                numbers = ", ".join(str(number) for number in given if given[number] == direction)
                wrong = {"direction": direction, "cylinders": numbers, "room": self.sharing}
                yield fault("fix", "fixed-crowded", **wrong)

    def misfit(self, star: Sequence[int]) -> Fault | None:
        """Why a row of directions is not one of these stars; None if it is."""
        if len(star) != self.cylinders:
            return fault("", "star-throws", given=len(star), cylinders=self.cylinders)
        if sorted(star) != sorted(d for d in range(self.directions) for _ in range(self.sharing)):
            return fault("", "star-directions", last=self.directions - 1, times=self.sharing)
        return None

    @property
    def sharing(self) -> int:
        """How many cylinders have each direction: 1 or 2."""
        return 2 if self.cycle == "four-stroke" and self.cylinders % 2 == 0 else 1

    @property
    def directions(self) -> int:
        """How many directions throws have."""
        return self.cylinders // self.sharing

    @property
    def step(self) -> int:
        """From a direction to that of the next cylinder to fire.

        0 where two cylinders of a direction leave a choice.
        """
        if self.sharing == 2:
            return 0
        return 1 if self.cycle == "two-stroke" else 2 % self.cylinders

    @cached_property
    def places(self) -> tuple[tuple[int, ...], ...]:
        """What can be placed by itself.

        Cylinders (from 0), or pairs of them in symmetric cranks.
        """
        if self.symmetric:
            return tuple((j, self.cylinders - 1 - j) for j in range(self.cylinders // 2))
        return tuple((j,) for j in range(self.cylinders))

    @cached_property
    def each(self) -> int:
        """How many places have each direction."""
        return len(self.places) // self.directions

    @cached_property
    def evenly_placed(self) -> bool:
        """Whether the cylinders stand symmetrically about the middle."""
        return all(a == -b for a, b in zip(self.positions, reversed(self.positions), strict=True))

    @property
    def angles_deg(self) -> tuple[Fraction, ...]:
        """Crank angle at which each direction is first at top dead centre, degrees."""
        return tuple(Fraction(360 * d, self.directions) for d in range(self.directions))

    def firing_deg(self) -> tuple[Fraction, ...] | None:
        """Crank angle at which each direction fires, degrees; None where there is a choice."""
        if self.step == 0:
            return None
        cycle = 360 if self.cycle == "two-stroke" else 720
        angles = [Fraction(0)] * self.directions
        for turn in range(self.directions):
            angles[turn * self.step % self.directions] = Fraction(cycle * turn, self.directions)
        return tuple(angles)

    @cached_property
    def total(self) -> int:
        """How many stars there are, turned ones counted apart, fixed throws obeyed."""
        left = [self.each] * self.directions
        for _, direction in self.fixed_places:
            left[direction] -= 1
        count = factorial(sum(left))
        for number in left:
            count //= factorial(number)
        return count

    @cached_property
    def fixed_places(self) -> tuple[tuple[int, int], ...]:
        """The fixed throws by place (from 0)."""
        home = {
            cylinder: index for index, members in enumerate(self.places) for cylinder in members
        }
        return tuple(sorted({(home[number - 1], direction) for number, direction in self.fixed}))

    @cached_property
    def count(self) -> int:
        """Number of stars, turned ones counted once (with fixed throws none can be turned)."""
        return self.total if self.fixed else self.total // self.directions

    def classes(self, *, reversed_: bool = True) -> int:
        """The number of classes: mirrored stars count as one, and those from the rear if reversed.

        By Burnside's lemma.

        >>> Stars(7, "two-stroke", tuple(Fraction(3 - j) for j in range(7))).classes()
        192
        """
        if self.fixed:
            return self.count
        turns = [lambda d, c=c: (d + c) % self.directions for c in range(self.directions)]
        mirrors = [lambda d, c=c: (c - d) % self.directions for c in range(self.directions)]
        images = [[g(d) for d in range(self.directions)] for g in (*turns, *mirrors)]
        from_rear = reversed_ and self.evenly_placed and not self.symmetric
        ends = (False, True) if from_rear else (False,)
        still = sum(self._unmoved(image, ends=end) for end in ends for image in images)
        return still // (len(images) * len(ends))

    def _unmoved(self, image: list[int], *, ends: bool) -> int:
        """Number of stars that a change of directions, perhaps reversed too, leaves as they are."""
        if not ends:
            return self.total if image == list(range(self.directions)) else 0
        if any(image[image[d]] != d for d in range(self.directions)):
            return 0
        alone = sum(1 for d in range(self.directions) if image[d] == d)
        pairs = (self.directions - alone) // 2
        if self.each == 1:
            return factorial(pairs) * 2**pairs if alone == len(self.places) % 2 else 0
        halves = 2 * pairs + alone
        return factorial(halves) // 2**pairs * 4**pairs if 2 * halves == len(self.places) else 0

    def whole(self, places: Star) -> Star:
        """The direction of every cylinder, from that of every place."""
        out = [0] * self.cylinders
        for members, direction in zip(self.places, places, strict=True):
            for cylinder in members:
                out[cylinder] = direction
        return tuple(out)

    def same(self, star: Star) -> Iterator[Star]:
        """All stars of a star's class, turned ones once, each with cylinder 1 in direction 0.

        Itself alone if throws are fixed.
        """
        if self.fixed:
            yield star
            return
        seen: set[Star] = set()
        ends = [star, star[::-1]] if self.evenly_placed else [star]
        for row in ends:
            for sign in (1, -1):
                turned = tuple(sign * (d - row[0]) % self.directions for d in row)
                if turned not in seen:
                    seen.add(turned)
                    yield turned
