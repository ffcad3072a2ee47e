"""Throws with one rod each, or with two as in a V engine, that fire evenly: star and sequence.

N cylinders that fire evenly every I = C/N degrees (C the cycle) have their dead centres on
multiples of a step: I, and I/2 in a four-stroke engine of odd N. Counted in steps, modulo a turn,
they are K = 360/step classes, each with the same number of cylinders: two in a four-stroke engine
of even N, else one. A star gives each throw the class of its first rod; the second rod of a pin is
at top dead centre `shift` classes later, for a bank angle V clockwise from the second bank to the
first shift = -V/step. Of two cylinders of a class one fires in the first turn of the cycle, the
other in the second: a sequence says which, 2^(K-1) of them but for the turn in which the cycle
begins.

A star turned is the same crankshaft: throw 1 has class 0. A star whose classes are counted
backwards is its mirror image, the engine that turns the other way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import factorial, gcd
from typing import NamedTuple, get_args

from crankstar.engine.quantities import Cycle
from crankstar.stars.faults import error

Classes = tuple[int, ...]
"""The class of each throw from the front, that of throw 1 being 0."""
MOST_IN_LINE, MOST_IN_V = 14, 24
"""Cylinders: beyond that there are too many stars to go through all."""
NEAR = 1e-6
"""Steps by which a dead centre or a firing may miss its class."""


class Fired(NamedTuple):
    """A star and a firing sequence on it.

    `first`: for each class whether the first of its two cylinders, by throw and bank, fires in the
    first turn; empty where a class has one cylinder.
    """

    star: Classes
    first: tuple[bool, ...] = ()


@dataclass(frozen=True)
class Shaft:
    """The throws of an evenly firing engine and the cylinders on them.

    places: of each throw along the shaft, falling from the front, from the middle, in bore pitches;
    numbers: of the cylinders on each throw, one, or two of which the first is in the first bank;
    bank_angle_deg: how far the first bank stands clockwise of the second, 0 in line.
    """

    cycle: Cycle
    places: tuple[Fraction, ...]
    numbers: tuple[tuple[int, ...], ...]
    bank_angle_deg: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if self.cycle not in get_args(Cycle):
            choices = ", ".join(get_args(Cycle))
            raise error("cycle", "cycle", given=self.cycle, choices=choices)
        given, most = self.cylinders, MOST_IN_LINE if self.rods == 1 else MOST_IN_V
        if not 2 * self.rods <= given <= most:
            raise error("", "sequence-cylinders", given=given, least=2 * self.rods, most=most)
        if self.rods == 2 and (self.bank_angle_deg / self.step_deg).denominator != 1:
            angle, step = float(self.bank_angle_deg), f"{float(self.step_deg):.6g}"
            raise error("bank", "bank-uneven", given=f"{angle:g}", cylinders=given, step=step)
        if not self.count:
            angle = f"{float(self.bank_angle_deg):g}"
            raise error("bank", "bank-no-star", given=angle, cylinders=given)

    @property
    def throws(self) -> int:
        """How many throws there are."""
        return len(self.places)

    @cached_property
    def rods(self) -> int:
        """Rods on each throw."""
        return len(self.numbers[0])

    @property
    def cylinders(self) -> int:
        """How many cylinders there are."""
        return self.throws * self.rods

    @property
    def cycle_deg(self) -> int:
        """Crank angle of a working cycle."""
        return 360 if self.cycle == "two-stroke" else 720

    @cached_property
    def step_deg(self) -> Fraction:
        """Crank angle from one class to the next."""
        return Fraction(360, self.classes)

    @cached_property
    def room(self) -> int:
        """Cylinders in each class: two in a four-stroke engine of an even number, else one."""
        return 2 if self.cycle == "four-stroke" and self.cylinders % 2 == 0 else 1

    @cached_property
    def classes(self) -> int:
        """How many classes there are."""
        return self.cylinders // self.room

    @cached_property
    def shift(self) -> int:
        """Classes by which the second rod of a pin comes to top dead centre later."""
        return int(-self.bank_angle_deg / self.step_deg) % self.classes

    @property
    def sequences(self) -> int:
        """Firing sequences on each star."""
        return 2 ** (self.classes - 1) if self.room == 2 else 1

    @cached_property
    def count(self) -> int:
        """Stars, turned ones counted once.

        >>> shaft_of(20, bank_angle_deg=108).count  # 9! with a throw in each class, and 22,680
        385560
        """
        kinds = [(1,)] if self.room == 1 else [(2,)]
        if self.rods == 2:
            kinds = [(0, 1), (1, 0)] if self.room == 1 else [(1, 1), (0, 2), (2, 0)]
        step = self.shift if self.rods == 2 else 1
        rounds = gcd(self.classes, step)
        length = self.classes // rounds
        if self.rods == 2 and length % 2:
            kinds = [(1, 1)] if self.room == 2 else []
        total = Fraction(factorial(self.throws))
        share = sum(
            Fraction(1, _arranged([kind[at % len(kind)] for at in range(length)])) for kind in kinds
        )
        return int(total * share**rounds / self.classes)

    def seats(self, star: Sequence[int]) -> list[list[tuple[int, int]]]:
        """For each class the throws and banks (from 0) of its cylinders, by throw, then bank."""
        out: list[list[tuple[int, int]]] = [[] for _ in range(self.classes)]
        for throw, own in enumerate(star):
            for bank in range(self.rods):
                out[(own + bank * self.shift) % self.classes].append((throw, bank))
        return out

    def fires(self, star: Sequence[int]) -> bool:
        """Whether a star fires evenly."""
        return all(len(seat) == self.room for seat in self.seats(star))

    def steps(self, fired: Fired) -> dict[int, int]:
        """At which step of the cycle each cylinder fires, the first rod of throw 1 at 0."""
        out: dict[int, int] = {}
        for own, seat in enumerate(self.seats(fired.star)):
            odd = self.cycle_deg == 720 and self.room == 1 and own % 2 == 1
            for index, (throw, bank) in enumerate(seat):
                late = odd or (bool(fired.first) and fired.first[own] == (index == 1))
                out[self.numbers[throw][bank]] = own + self.classes * late
        return out

    def angles_deg(self, fired: Fired) -> dict[int, Fraction]:
        """Crank angle at which each cylinder fires, that of the first rod of throw 1 being 0.

        >>> six = shaft_of(6)
        >>> six.angles_deg(Fired((0, 1, 2, 2, 1, 0), (True, True, False)))[3]
        Fraction(600, 1)
        """
        return {number: at * self.step_deg for number, at in sorted(self.steps(fired).items())}

    def firing_order(self, fired: Fired) -> tuple[int, ...]:
        """The cylinders in the order in which they fire, from the lowest number.

        >>> six = shaft_of(6)
        >>> six.firing_order(Fired((0, 1, 2, 2, 1, 0), (True, False, True)))
        (1, 5, 3, 6, 2, 4)
        """
        steps = self.steps(fired)
        order = sorted(steps, key=steps.__getitem__)
        start = order.index(min(order))
        return (*order[start:], *order[:start])

    def fired_of(self, angles_deg: Mapping[int, float]) -> Fired:
        """The star and sequence of firing angles by cylinder. Raises SearchError.

        Where these are no angles of an even cycle, or the cylinders of a pin do not fit.
        """
        start = angles_deg[self.numbers[0][0]]
        later = {number: (angle - start) % self.cycle_deg for number, angle in angles_deg.items()}
        steps = {number: round(angle / float(self.step_deg)) for number, angle in later.items()}
        for number, angle in later.items():
            if abs(angle / float(self.step_deg) - steps[number]) > NEAR:
                raise error("", "not-even", number=number)
        for pin in self.numbers:
            if self.rods == 2 and (steps[pin[1]] - steps[pin[0]] - self.shift) % self.classes:
                wanted = float(self.shift * self.step_deg)
                apart = (steps[pin[1]] - steps[pin[0]]) * float(self.step_deg) % self.cycle_deg
                values = {"first": pin[0], "second": pin[1], "apart": f"{apart:.6g}"}
                values |= {"wanted": f"{wanted:.6g}", "other": f"{wanted + 360:.6g}"}
                raise error("why", "pin-apart", **values)
        star = tuple(steps[pin[0]] % self.classes for pin in self.numbers)
        first: tuple[bool, ...] = ()
        if self.room == 2 and self.fires(star):
            seats = self.seats(star)
            earlier = [later[self.numbers[throw][bank]] < 360 - NEAR for (throw, bank), _ in seats]
            first = tuple(earlier)
        if not self.fires(star) or self.angles_deg(Fired(star, first)).keys() != later.keys():
            raise error("why", "order-uneven")
        return Fired(star, first)

    def mirrored(self, fired: Fired) -> Fired:
        """The mirror image: what comes later comes earlier by as much; of a V, banks change places.

        >>> six = shaft_of(6)
        >>> six.firing_order(six.mirrored(six.fired_in((1, 5, 3, 6, 2, 4))))
        (1, 4, 2, 6, 3, 5)
        """
        angles = self.angles_deg(fired)
        pairs = (
            (own, other) for pin in self.numbers for own, other in zip(pin, pin[::-1], strict=True)
        )
        return self.fired_of({own: float(-angles[other]) for own, other in pairs})

    def fired_in(self, order: Sequence[int]) -> Fired:
        """The star and sequence of a firing order. Raises SearchError.

        >>> six = shaft_of(6)
        >>> six.fired_in((1, 5, 3, 6, 2, 4)).star
        (0, 1, 2, 2, 1, 0)
        """
        every = sorted(number for pin in self.numbers for number in pin)
        if sorted(order) != every:
            given = "-".join(map(str, order))
            raise error("why", "order-numbers", given=given, count=len(every))
        step = self.cycle_deg / self.cylinders
        return self.fired_of({number: index * step for index, number in enumerate(order)})


class Followed(NamedTuple):
    """Cylinders that fire in succession: side by side in a bank, and on one throw."""

    neighbours: tuple[tuple[int, int], ...]
    partners: tuple[tuple[int, int], ...]


def followed(shaft: Shaft, order: Sequence[int]) -> Followed:
    """Neighbours and pin partners that fire in succession, in firing order.

    >>> followed(shaft_of(6), (1, 5, 3, 6, 2, 4)).neighbours
    ()
    """
    home = {
        number: (throw, bank)
        for throw, pin in enumerate(shaft.numbers)
        for bank, number in enumerate(pin)
    }
    steps = list(pairwise([*order, order[0]]))
    beside = [
        (one, other)
        for one, other in steps
        if home[one][1] == home[other][1] and abs(home[one][0] - home[other][0]) == 1
    ]
    shared = [(one, other) for one, other in steps if home[one][0] == home[other][0]]
    return Followed(tuple(beside), tuple(shared))


def _arranged(counts: Sequence[int]) -> int:
    """The product of the factorials."""
    out = 1
    for count in counts:
        out *= factorial(count)
    return out


def shaft_of(
    cylinders: int,
    *,
    bank_angle_deg: float | None = None,
    cycle: Cycle = "four-stroke",
    gaps: Sequence[Fraction] | None = None,
) -> Shaft:
    """A shaft of so many cylinders, in line or at a bank angle with two rods on each throw.

    `gaps`: between the throws from the front, in pitches, else equal. Odd numbers are the first
    bank, which stands on the right seen from the front.

    >>> shaft_of(8, bank_angle_deg=90).numbers
    ((1, 2), (3, 4), (5, 6), (7, 8))
    """
    rods = 1 if bank_angle_deg is None else 2
    if bank_angle_deg is not None and (cylinders % 2 or not 0 < bank_angle_deg <= 180):
        code = "bank-odd" if cylinders % 2 else "bank-angle"
        raise error("bank", code, given=f"{bank_angle_deg:g}", cylinders=cylinders)
    throws = cylinders // rods
    if gaps is not None and len(gaps) != throws - 1:
        wanted = {"given": len(gaps), "cylinders": cylinders, "wanted": throws - 1}
        raise error("gaps", "throw-gap-count", **wanted)
    numbers = tuple(
        tuple(range(1 + rods * throw, 1 + rods * (throw + 1))) for throw in range(throws)
    )
    angle = Fraction(0 if bank_angle_deg is None else bank_angle_deg).limit_denominator(10_000)
    return Shaft(cycle, places_of(throws, gaps), numbers, angle)


def places_of(throws: int, gaps: Sequence[Fraction] | None = None) -> tuple[Fraction, ...]:
    """Places along the shaft from the middle, falling from the front."""
    places = [Fraction(0)]
    for gap in gaps or (Fraction(1),) * (throws - 1):
        places.append(places[-1] - gap)
    middle = (places[0] + places[-1]) / 2
    return tuple(place - middle for place in places)
