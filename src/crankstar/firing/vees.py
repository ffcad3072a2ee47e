"""V engines that fire evenly: throws, bank angle and pin split for n cylinders.

Pin p of the n/2 bears two rods, at bearing b_p and, where pins are split, b_p + s for the second
bank. With the first bank to the right of the second by an angle V its pistons are at top dead
centre at t_p = -b_p and t_p - V - s. Even firing every I = C/n degrees puts all of these on
multiples of I; counted in I they are classes c_p and c_p + d modulo K = 360/I, with d = -(V + s)/I,
and each class is needed C/360 times in a cycle of C degrees: twice in a four-stroke engine, once in
a two-stroke one. All c with c_1 = 0 that do so are listed.

Two stars are the same engine where one is the other seen from the other end with the pins in
reverse, or in a mirror and turning backwards: c -> -c. What they push is alike but for signs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from math import radians
from typing import Any, NamedTuple

import numpy as np

from crankstar.engine import layouts, motion
from crankstar.engine.basis import ASSUMED_ROD_RATIO, Basis
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Cycle
from crankstar.firing.numbering import with_order
from crankstar.firing.orders import SAME_PLACE, even_orders
from crankstar.firing.timetable import OrderError, off
from crankstar.spectra import Complex

ORDERS = (1, 2, 4)
"""The crank orders by which V engines are distinguished."""
GREATEST_VEE = 16
"""Cylinders: beyond that there are too many stars to list."""
USUAL_BANK_ANGLES = (45.0, 60.0, 72.0, 90.0, 120.0, 180.0)
"""Degrees; with split pins any bank angle can fire evenly, and these are what people build."""
DIGITS = 9
"""Decimals to which two balances are the same."""


class Vector(NamedTuple):
    """Lengths of the forward and backward vector of an order, in m r w^2 A_k (couple: times a)."""

    forward: float
    backward: float

    @property
    def greatest(self) -> float:
        """The greatest value over a turn."""
        return self.forward + self.backward


@dataclass(frozen=True)
class Vee:
    """Evenly firing V engines of one balance: a bank angle, a pin split, and crank stars.

    `stars`: the bearings of the first bank's pins from pin 1, clockwise, degrees, one star for each
    that is not another turned, mirrored or seen from the other end; `count`: how many there are
    with those (pin 1 upwards). `force`, `couple`: vectors of the orders ORDERS, the rods of a pin
    in one plane, couples about the middle.
    """

    cylinders: int
    cycle: Cycle
    bank_angle_deg: float
    pin_split_deg: float
    stars: tuple[tuple[float, ...], ...]
    count: int
    force: tuple[Vector, ...]
    couple: tuple[Vector, ...]

    @property
    def counterweights_suffice(self) -> bool:
        """Whether counterweights cancel all of order 1: nothing turns against the crank."""
        return self.force[0].backward == self.couple[0].backward == 0.0

    @property
    def left(self) -> float:
        """Force and couple that counterweights leave, order by order, at a rod ratio of 4.

        In m r w^2, a couple counted as the force that has it at an arm of one bore pitch.
        """
        return _left(self.force) + _left(self.couple)


@cache
def _harmonics() -> tuple[float, ...]:
    harmonics = motion.piston_harmonics(crank_radius=1.0, rod_length=ASSUMED_ROD_RATIO)
    return tuple(abs(float(harmonics[order].real)) for order in ORDERS)


def _left(vectors: Sequence[Vector]) -> float:
    first, *others = vectors
    return first.backward + sum(
        vector.greatest * size for vector, size in zip(others, _harmonics()[1:], strict=True)
    )


def interval_deg(*, cylinders: int, cycle: Cycle) -> float:
    """Degrees from one firing to the next, all even."""
    return (360.0 if cycle == "two-stroke" else 720.0) / cylinders


def vees(
    *,
    cylinders: int,
    bank_angles_deg: Sequence[float] | None = None,
    greatest_split_deg: float | None = None,
    cycle: Cycle = "four-stroke",
) -> tuple[Vee, ...]:
    """All V engines of so many cylinders that fire evenly, best balanced first.

    Best is: least left by counterweights, then least to be balanced by them. `bank_angles_deg`:
    from above 0 to 180 (else the multiples of the firing interval, and where splits are allowed up
    to `greatest_split_deg` the usual ones). Pins are split by the least angle that makes the engine
    fire evenly, either way if both do. Raises OrderError where the numbers cannot be meant.

    >>> sixes = vees(cylinders=6, bank_angles_deg=(60, 90, 120))
    >>> [(vee.bank_angle_deg, vee.pin_split_deg) for vee in sixes]
    [(60.0, 60.0), (90.0, 30.0), (120.0, 0.0), (60.0, -60.0)]
    >>> cross = vees(cylinders=8, bank_angles_deg=(90,))[0]
    >>> round(cross.couple[0].forward ** 2, 6), cross.counterweights_suffice
    (10.0, True)
    """
    if cylinders % 2 or not 2 <= cylinders <= GREATEST_VEE:
        raise OrderError("vees.cylinders", value=cylinders, greatest=GREATEST_VEE)
    interval = interval_deg(cylinders=cylinders, cycle=cycle)
    angles = (
        _bank_angles(interval, greatest_split_deg)
        if bank_angles_deg is None
        else sorted(set(map(float, bank_angles_deg)))
    )
    if not angles:
        raise OrderError("vees.no-bank-angle", interval=interval)
    if not all(0 < angle <= 180 for angle in angles):
        raise OrderError("vees.bank-angle")
    if greatest_split_deg is not None and not greatest_split_deg >= 0:
        raise OrderError("vees.pin-split")
    solutions: list[Vee] = []
    for angle in angles:
        for split, shift, classes in _least_splits(angle, interval, cylinders // 2):
            if greatest_split_deg is None or abs(split) <= greatest_split_deg + SAME_PLACE:
                solutions += _by_balance(cylinders, cycle, angle, split, shift, classes)
    return tuple(sorted(solutions, key=_merit))


def _merit(vee: Vee) -> tuple[float, ...]:
    to_balance = vee.force[0].forward + vee.couple[0].forward
    return (
        round(vee.left, 6),
        round(to_balance, 6),
        abs(vee.pin_split_deg),
        vee.bank_angle_deg,
        vee.pin_split_deg,
    )


def _bank_angles(interval: float, greatest_split: float | None) -> list[float]:
    multiples = [interval * times for times in range(1, int(180 / interval + 1e-9) + 1)]
    return sorted({*multiples, *(USUAL_BANK_ANGLES if greatest_split else ())})


def _least_splits(
    bank_angle: float, interval: float, pins: int
) -> list[tuple[float, int, np.ndarray]]:
    """The least pin splits (degrees) for even firing, each with its shift and stars [star, pin]."""
    classes = round(360 / interval)
    shifts = sorted(
        (
            (-round(off(shift * interval + bank_angle, cycle_deg=360.0), DIGITS), shift)
            for shift in range(classes)
        ),
        key=_size,
    )
    splits: list[tuple[float, int, np.ndarray]] = []
    for split, shift in shifts:
        if splits and abs(split) > abs(splits[0][0]) + SAME_PLACE:
            break
        listed = stars(pins=pins, classes=classes, shift=shift)
        if len(listed):
            splits.append((split if abs(split) > SAME_PLACE / 2 else 0.0, shift, listed))
    return splits


def _size(split: tuple[float, int]) -> tuple[float, float]:
    return abs(split[0]), split[0]


def stars(*, pins: int, classes: int, shift: int) -> np.ndarray:
    """Class numbers of the pins [star, pin], pin 1 in class 0, that fill every class alike.

    Each pin counts with its partner, `shift` classes later.


    A flat-plane crank, and one with the pins 90 deg apart:

    >>> stars(pins=4, classes=4, shift=2).tolist()[:2]
    [[0, 0, 1, 1], [0, 0, 1, 3]]
    """
    times, rest = divmod(2 * pins, classes)
    if rest:
        return np.zeros((0, pins), np.int8)
    hits = np.zeros((1, classes), np.int8)
    listed = np.zeros((1, 0), np.int8)
    for pin in range(pins):
        grown, filled = [], []
        for own in range(classes if pin else 1):
            more = np.zeros(classes, np.int8)
            np.add.at(more, [own, (own + shift) % classes], 1)
            free = (hits + more <= times).all(axis=1)
            grown.append(np.column_stack([listed[free], np.full(free.sum(), own, np.int8)]))
            filled.append(hits[free] + more)
        listed, hits = np.concatenate(grown), np.concatenate(filled)
    return listed[np.lexsort(listed.T[::-1])]


def _by_balance(
    cylinders: int, cycle: Cycle, bank_angle: float, split: float, shift: int, listed: np.ndarray
) -> Iterable[Vee]:
    """The stars grouped by excitation; equivalent engines are one."""
    interval = interval_deg(cylinders=cylinders, cycle=cycle)
    kinds, first, count = np.unique(
        _kinds(listed, round(360 / interval)), return_index=True, return_counts=True
    )
    vectors = np.abs(
        pushes(listed[first], bank_angle_deg=bank_angle, shift=shift, interval=interval)
    )
    rounded = (np.round(vectors, DIGITS) + 0.0).reshape(len(kinds), -1)
    balances, which = np.unique(rounded, axis=0, return_inverse=True)
    by_balance = np.argsort(which.ravel(), kind="stable")
    for values, mine in zip(
        balances, np.split(by_balance, np.cumsum(np.bincount(which.ravel()))[:-1]), strict=True
    ):
        force, couple = (
            tuple(Vector(*pair) for pair in part)
            for part in values.reshape(2, len(ORDERS), 2).tolist()
        )
        yield Vee(
            cylinders=cylinders,
            cycle=cycle,
            bank_angle_deg=bank_angle,
            pin_split_deg=split,
            # The mirror image of the first star of each kind, c for -c: cranks are usually
            # written so.
            stars=tuple(
                tuple(own * interval for own in star) for star in listed[first[mine]].tolist()
            ),
            count=int(count[mine].sum()),
            force=force,
            couple=couple,
        )


def _kinds(listed: np.ndarray, classes: int) -> np.ndarray:
    """A number for each star, the same for its mirror image and as seen from the other end."""
    weights = classes ** np.arange(listed.shape[1])[::-1]
    reverse = listed[:, ::-1]
    images = [
        (sign * (own - own[:, :1])) % classes @ weights
        for own in (listed.astype(np.int64), reverse.astype(np.int64))
        for sign in (1, -1)
    ]
    return np.min(images, axis=0)


def pushes(listed: np.ndarray, *, bank_angle_deg: float, shift: int, interval: float) -> Complex:
    """Force (m r w^2 A_k) and couple (m r w^2 A_k a) of each star [star, 2, order, with/against].

    A cylinder at bearing B with its dead centre at t pushes e^{iB} (e^{-ikt} with the crank +
    e^{ikt} against it)/2 in order k.
    """
    half = radians(bank_angle_deg) / 2
    dead = np.radians(interval) * listed[:, :, None]
    z = (listed.shape[1] - 1) / 2 - np.arange(listed.shape[1])
    out: list[Any] = []
    for order in ORDERS:
        for sign in (-1, 1):
            lag = sign * order * np.radians(interval) * shift
            pin = (np.exp(1j * half) + np.exp(1j * (lag - half))) / 2
            turned = pin * np.exp(1j * sign * order * dead[:, :, 0])
            out.append([turned.sum(axis=1), turned @ z])
    return np.moveaxis(np.array(out).reshape(len(ORDERS), 2, 2, len(listed)), (3, 2), (0, 1))


def engine_of(vee: Vee, *, star: int = 0) -> Engine:
    """One of the stars of a solution as an engine, with the best of its even firing orders.

    Odd numbers are the first bank, on the right seen from the front. Sizes and masses are unknown.

    >>> from crankstar.firing.intervals import firing
    >>> firing(engine_of(vees(cylinders=10, bank_angles_deg=(90,))[0])).intervals_deg[0]
    72.0
    """
    split = f", pins split by {abs(vee.pin_split_deg):g} deg" if vee.pin_split_deg else ""
    basis = Basis(
        name=f"V{vee.cylinders}, {vee.bank_angle_deg:g} deg{split}",
        cycle=vee.cycle,
        source="found by search: crank and bank angle that fire evenly",
    )
    numbers = range(1, vee.cylinders + 1)
    banks = tuple(
        layouts.Bank(
            bearing=sign * radians(vee.bank_angle_deg) / 2, cylinders=tuple(numbers[first::2])
        )
        for first, sign in enumerate((1, -1))
    )
    throws = tuple(radians(angle) for angle in vee.stars[star])
    engine = layouts.vee(basis, banks=banks, throws=throws, pin_split=radians(vee.pin_split_deg))
    return with_order(engine, even_orders(engine)[0].firing)
