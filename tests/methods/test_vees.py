"""V engines against every crank star tried as an engine, balanced from its moving parts."""

from __future__ import annotations

from collections import Counter
from itertools import permutations, product
from math import factorial, gcd, prod, radians, sqrt

import numpy as np
import pytest

import crankstar
from crankstar import Engine, spectra
from crankstar.engine import motion
from crankstar.engine.banks import Bank
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.layouts import vee
from crankstar.firing.intervals import firing
from crankstar.firing.orders import even_orders
from crankstar.firing.timetable import OrderError
from crankstar.firing.vees import ORDERS, Vee, engine_of, interval_deg, stars, vees
from crankstar.mechanics.balance import balance, total
from crankstar.remedy import with_counterweights

HARMONICS = motion.piston_harmonics(crank_radius=1.0, rod_length=4.0)


def tried(
    *, bank_angle: float, split: float, throws: tuple[float, ...], cycle: str = "four-stroke"
) -> Engine:
    """A V engine with these pins, in degrees."""
    count = len(throws)
    banks = tuple(
        Bank(
            bearing=sign * radians(bank_angle) / 2, cylinders=tuple(range(first, 2 * count + 1, 2))
        )
        for first, sign in ((1, 1), (2, -1))
    )
    basis = Basis(name="tried", cycle=cycle, cylinder=Sizes(rod_ratio=4.0))  # pyright: ignore[reportArgumentType]
    return vee(basis, banks=banks, throws=tuple(map(radians, throws)), pin_split=radians(split))


def sizes(engine: Engine) -> list[float]:
    """Lengths of the vectors of force and couple with and against the crank, in m r w^2 A_k (a)."""
    sums = total(balance(engine))
    out: list[float] = []
    for spectrum in (sums.force, sums.couple):
        found = spectra.selected(spectrum, ORDERS)
        for place, order in enumerate(ORDERS):
            out += [
                abs(vectors[place]) / abs(HARMONICS[order].real)
                for vectors in (found.forward, found.backward)
            ]
    return out


def told(one: Vee) -> list[float]:
    return [size for part in (one.force, one.couple) for vector in part for size in vector]


@pytest.mark.many(first=4)
@pytest.mark.parametrize(
    ("cylinders", "bank_angle", "cycle"),
    [
        (4, 180.0, "four-stroke"),
        (4, 90.0, "four-stroke"),
        (6, 60.0, "four-stroke"),
        (6, 90.0, "four-stroke"),
        (6, 120.0, "four-stroke"),
        (8, 90.0, "four-stroke"),
        (8, 60.0, "four-stroke"),
        (4, 90.0, "two-stroke"),
        (4, 60.0, "two-stroke"),
        (6, 90.0, "two-stroke"),
    ],
)
def test_the_stars_are_those_of_all_that_give_an_engine_that_fires_evenly(
    cylinders: int, bank_angle: float, cycle: str
) -> None:
    """Every star on multiples of half a firing interval, with its splits, and its even orders."""
    found = vees(cylinders=cylinders, bank_angles_deg=(bank_angle,), cycle=cycle)  # pyright: ignore[reportArgumentType]
    step = interval_deg(cylinders=cylinders, cycle=cycle)  # pyright: ignore[reportArgumentType]
    pins = cylinders // 2
    for split in {one.pin_split_deg for one in found}:
        even = [
            throws
            for rest in product(
                np.arange(0, 360, step if pins == 4 else step / 2).tolist(), repeat=pins - 1
            )
            if even_orders(
                tried(
                    bank_angle=bank_angle, split=split, throws=(throws := (0.0, *rest)), cycle=cycle
                )
            )
        ]
        mine = [one for one in found if one.pin_split_deg == split]
        assert sum(one.count for one in mine) == len(even)
        assert {star for one in mine for star in one.stars} <= set(even)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("cylinders", "bank_angle", "split"),
    [(6, 90.0, 30.0), (6, 60.0, 60.0), (4, 90.0, 90.0), (8, 72.0, 18.0)],
)
def test_no_lesser_split_makes_an_engine_fire_evenly(
    cylinders: int, bank_angle: float, split: float
) -> None:
    found = vees(cylinders=cylinders, bank_angles_deg=(bank_angle,))
    assert split in {one.pin_split_deg for one in found}
    throws = found[0].stars[0]
    for lesser in np.arange(-abs(split) + 1, abs(split), 1.0).tolist():
        assert even_orders(tried(bank_angle=bank_angle, split=lesser, throws=throws)) == ()


@pytest.mark.many(first=3)
@pytest.mark.parametrize(
    ("cylinders", "bank_angles", "cycle"),
    [
        (2, (90.0, 180.0), "four-stroke"),
        (4, (90.0, 180.0), "four-stroke"),
        (6, (60.0, 75.0, 90.0, 120.0), "four-stroke"),
        (8, (60.0, 90.0, 180.0), "four-stroke"),
        (10, (72.0, 90.0), "four-stroke"),
        (12, (60.0,), "four-stroke"),
        (4, (90.0,), "two-stroke"),
        (6, (90.0,), "two-stroke"),
    ],
)
def test_the_vectors_are_those_of_the_balance_of_every_star(
    cylinders: int, bank_angles: tuple[float, ...], cycle: str
) -> None:
    for one in vees(cylinders=cylinders, bank_angles_deg=bank_angles, cycle=cycle):  # pyright: ignore[reportArgumentType]
        for place in range(len(one.stars)):
            engine = engine_of(one, star=place)
            assert firing(engine).even
            assert sizes(engine) == pytest.approx(told(one), abs=1e-7)


def test_stars_that_share_a_balance_are_counted_with_their_mirror_images_and_reverses() -> None:
    """Of six cranks with four pins 90 deg apart, three pairs are equal, as their balance shows."""
    cross = [one for one in vees(cylinders=8, bank_angles_deg=(90,)) if len({*one.stars[0]}) == 4]
    assert [one.count for one in cross] == [2, 2, 2]
    every = [
        tried(bank_angle=90, split=0, throws=(0.0, *rest))
        for rest in permutations((90.0, 180.0, 270.0))
    ]
    counted = [
        sum(np.allclose(sizes(engine), told(one), atol=1e-7) for engine in every) for one in cross
    ]
    assert counted == [2, 2, 2]


@pytest.mark.parametrize(
    ("pins", "shift"),
    [(2, 1), (3, 1), (4, 1), (4, 2), (5, 1), (5, 0), (6, 1), (6, 2), (6, 3), (7, 3), (8, 3)],
)
def test_the_number_of_stars_follows_from_how_often_each_class_can_be_a_first(
    pins: int, shift: int
) -> None:
    """f(c) + f(c - d) = 2 round each cycle of d: all 1, or in an even cycle 0 and 2 in turn."""
    cycles = gcd(pins, shift)
    length = pins // cycles
    total_count = 0
    for kinds in product((0, 1, 2) if length % 2 == 0 else (1,), repeat=cycles):
        use = Counter(
            kind if place % 2 == 0 else 2 - kind for kind in kinds for place in range(length)
        )
        total_count += factorial(pins) // prod(
            factorial(times) ** count for times, count in use.items()
        )
    assert len(stars(pins=pins, classes=pins, shift=shift)) * pins == total_count


def only(found: tuple[Vee, ...], **wanted: object) -> Vee:
    (one,) = (
        one for one in found if all(getattr(one, key) == value for key, value in wanted.items())
    )
    return one


def test_the_cross_plane_and_the_flat_plane_v8_are_found_and_the_cross_plane_first() -> None:
    found = vees(cylinders=8, bank_angles_deg=(90,))
    cross = found[0]
    assert cross.counterweights_suffice
    assert cross.couple[0].forward == pytest.approx(sqrt(10))
    assert cross.stars == (
        (0.0, 90.0, 270.0, 180.0),
    )  # as in the catalog, which fires in the same orders
    orders = {one.firing.order for one in even_orders(engine_of(cross))}
    assert orders == {one.firing.order for one in even_orders(crankstar.load("v8-cross-plane"))}
    flat = next(one for one in found if (0.0, 180.0, 180.0, 0.0) in one.stars)
    assert flat.force[1].greatest == pytest.approx(4 * sqrt(2))
    assert all(vector == (0.0, 0.0) for vector in flat.couple)
    assert flat.count == 1


def test_the_v6_engines_of_the_books_are_found() -> None:
    found = vees(cylinders=6, bank_angles_deg=(60, 90, 120))
    six_throws = only(found, bank_angle_deg=60.0, pin_split_deg=60.0)
    assert six_throws.couple[0] == pytest.approx((1.5, 0.0))
    assert six_throws.counterweights_suffice
    split_pins = only(found, bank_angle_deg=90.0)
    assert split_pins.pin_split_deg == 30.0
    assert not split_pins.counterweights_suffice
    gm = total(balance(crankstar.load("gm-3800"))).couple
    assert split_pins.couple[0].backward == pytest.approx(abs(spectra.selected(gm, 1).backward[0]))
    assert split_pins.couple[0].forward == pytest.approx(abs(spectra.selected(gm, 1).forward[0]))
    assert only(found, bank_angle_deg=120.0).pin_split_deg == 0.0
    assert {one.count for one in found} == {2}


def test_v10_engines_of_72_deg_and_of_90_deg_with_split_pins_are_found() -> None:
    found = vees(cylinders=10, bank_angles_deg=(72, 90))
    assert {(one.bank_angle_deg, one.pin_split_deg) for one in found} == {
        (72.0, 0.0),
        (90.0, -18.0),
    }
    assert all(
        sum(one.count for one in found if one.bank_angle_deg == angle) == 24 for angle in (72, 90)
    )
    assert all(size == 0 for one in found for vector in one.force for size in vector)


def test_the_v12_of_60_deg_on_the_crank_of_a_six_is_free_of_all() -> None:
    best = vees(cylinders=12)[0]
    assert (best.bank_angle_deg, best.pin_split_deg) == (60.0, 0.0)
    assert told(best) == [0.0] * 12
    assert best.left == 0


def test_a_v16_of_45_deg_and_of_135_deg_is_found() -> None:
    found = vees(cylinders=16, bank_angles_deg=(45, 135), greatest_split_deg=0)
    for angle in (45.0, 135.0):
        mine = [one for one in found if one.bank_angle_deg == angle]
        in_line_eight = next(
            one for one in mine if (0.0, 90.0, 270.0, 180.0, 180.0, 270.0, 90.0, 0.0) in one.stars
        )
        assert in_line_eight.force[:2] == in_line_eight.couple[:2] == ((0.0, 0.0), (0.0, 0.0))
        assert sum(one.count for one in mine) == len(
            stars(pins=8, classes=8, shift=round(angle / 45))
        )


def test_without_bank_angles_all_multiples_of_the_interval_are_tried() -> None:
    assert {one.bank_angle_deg for one in vees(cylinders=8)} == {90.0, 180.0}
    assert {one.bank_angle_deg for one in vees(cylinders=12)} == {60.0, 120.0, 180.0}
    assert {one.bank_angle_deg for one in vees(cylinders=6)} == {120.0}


def test_with_a_greatest_split_the_usual_bank_angles_are_tried_too() -> None:
    assert {
        (one.bank_angle_deg, one.pin_split_deg) for one in vees(cylinders=6, greatest_split_deg=30)
    } == {(90.0, 30.0), (120.0, 0.0)}
    assert {one.bank_angle_deg for one in vees(cylinders=6, greatest_split_deg=60)} == {
        45.0,
        60.0,
        72.0,
        90.0,
        120.0,
        180.0,
    }


def test_split_pins_can_be_forbidden() -> None:
    assert vees(cylinders=6, bank_angles_deg=(90,), greatest_split_deg=0) == ()
    assert len(vees(cylinders=8, bank_angles_deg=(90,), greatest_split_deg=0)) == len(
        vees(cylinders=8, bank_angles_deg=(90,))
    )


def test_the_best_come_first() -> None:
    found = vees(cylinders=8, greatest_split_deg=45)
    assert [round(one.left, 6) for one in found] == sorted(round(one.left, 6) for one in found)


def test_what_is_left_is_what_counterweights_leave() -> None:
    """Half the reciprocating mass opposite each pin removes the forward primary, and no more."""
    for one in vees(cylinders=6, bank_angles_deg=(60, 90)) + vees(cylinders=4):
        sums = total(balance(with_counterweights(engine_of(one), factor=0.5)))
        found = [spectra.selected(spectrum, ORDERS) for spectrum in (sums.force, sums.couple)]
        left = sum(
            float(np.abs(part.forward).sum() + np.abs(part.backward).sum()) for part in found
        )
        assert one.left == pytest.approx(left, abs=1e-7)
        assert abs(found[1].backward[0]) == pytest.approx(one.couple[0].backward, abs=1e-7)


@pytest.mark.parametrize(
    ("wanted", "words"),
    [
        (
            {"cylinders": 7},
            "a V engine of 7 cylinders cannot be searched; give an even number from 2 to 16",
        ),
        ({"cylinders": 18}, "give an even number from 2 to 16"),
        (
            {"cylinders": 2},
            (
                "no bank angle up to 180 deg is a multiple of the firing interval, 360 deg; "
                "give bank angles"
            ),
        ),
        (
            {"cylinders": 8, "bank_angles_deg": (0,)},
            "a bank angle must be above 0 and at most 180 deg",
        ),
        (
            {"cylinders": 8, "bank_angles_deg": (90, 200)},
            "a bank angle must be above 0 and at most 180 deg",
        ),
        ({"cylinders": 8, "greatest_split_deg": -1}, "the largest pin split must be 0 deg or more"),
    ],
)
def test_what_cannot_be_meant_is_refused(wanted: dict[str, object], words: str) -> None:
    with pytest.raises(OrderError, match=words):
        vees(**wanted)  # pyright: ignore[reportArgumentType]
