"""Firing orders on a given crank against brute force over all permutations."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, permutations
from math import pi, radians

import pytest
from hypothesis import given
from tests.catalog import EVERY_ENGINE
from tests.strategies import OF_LAYOUT, engines

import crankstar
from crankstar import Engine
from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.copies import with_rotation_reversed
from crankstar.engine.dead_centres import DeadCentre, dead_centres
from crankstar.engine.firing_angles import _evenest
from crankstar.engine.layouts import Row, boxer, inline, opposed, radial, tandem, vee
from crankstar.firing.intervals import firing
from crankstar.firing.numbering import renumbered, with_order
from crankstar.firing.orders import (
    Order,
    even_orders,
    most_even_orders,
    orders_at,
    place_of,
    possible_orders,
    unevenness,
    why_uneven,
)
from crankstar.firing.timetable import GREATEST_COUNT, OrderError
from crankstar.firing.vees import engine_of, vees
from crankstar.language.faults import EngineError


def by_brute_force(centres: dict[int, DeadCentre], cycle: float) -> set[tuple[int, ...]]:
    """Every order from the lowest number that fits a cycle and is as even as possible."""
    first, *others = sorted(centres)
    found: set[tuple[int, ...]] = set()
    for rest in permutations(others):
        angles = _evenest((first, *rest), centres, cycle)
        if angles is not None:
            intervals = [b - a for a, b in pairwise([*angles, angles[0] + cycle])]
            if max(intervals) - min(intervals) < 1e-3:
                found.add((first, *rest))
    return found


def written(orders: tuple[Order, ...]) -> list[tuple[int, ...]]:
    return [one.firing.order for one in orders]


FIVE = inline(Basis(name="five", firing_order=(1, 2, 4, 5, 3)), bore_pitch=0.1)
FOUR_IN_A_PLANE = boxer(
    Basis(name="boxer four"),
    banks=(Bank(bearing=pi / 2, cylinders=(1, 3)), Bank(bearing=-pi / 2, cylinders=(2, 4))),
    throws=(0.0, pi),
    bore_pitch=0.1,
)
KNOWN = {
    "i4": 2,
    "audi-25-tfsi": 1,
    "i6": 4,
    "v6-60-six-throws": 4,
    "gm-3800": 4,
    "v8-flat-plane": 8,
    "v8-cross-plane": 8,
    "gm-l76": 8,
    "ford-coyote": 8,
    "boxer-2": 1,
    "boxer-6": 4,
    "subaru-ej25": 2,
    "square-four": 2,
    "triple-120": 1,
    "harley-45": 0,
    "v2-90": 0,
    "yamaha-r1-crossplane": 0,
    "sinitsyn-8-four-stroke-1": 8,
    "man-s90mc-c": 1,
    "jumo-205": 1,
}


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", KNOWN)
def test_the_even_orders_are_those_among_all_permutations_that_fire_evenly(name: str) -> None:
    engine = crankstar.load(name)
    found = written(even_orders(engine))
    assert len(set(found)) == len(found) == KNOWN[name]
    assert set(found) == by_brute_force(dead_centres(engine), engine.cycle_angle)


@EVERY_ENGINE
def test_the_order_of_every_engine_of_the_catalog_is_found(name: str) -> None:
    engine = crankstar.load(name)
    together = name == "kr250-racer-simultaneous"
    orders = possible_orders(engine, together=together)
    assert (place_of(engine, orders) is not None) == bool(engine.firing_order)
    if engine.firing_order and firing(engine).even:
        assert place_of(engine, even_orders(engine)) is not None
        assert orders[0].firing.even


def test_the_known_orders_of_cross_plane_v8_engines_are_found_in_their_numberings() -> None:
    yamamoto = written(even_orders(crankstar.load("v8-cross-plane")))
    assert {(1, 8, 4, 3, 6, 5, 7, 2), (1, 8, 7, 2, 6, 5, 4, 3)} <= set(yamamoto)
    assert {(1, 8, 4, 3, 6, 5, 7, 2), (1, 8, 7, 2, 6, 5, 4, 3)} <= set(
        written(even_orders(crankstar.load("gm-l76")))
    )
    # Both orders that the Coyote is said to have, in the Mustang and in the F-150.
    ford = set(written(even_orders(crankstar.load("ford-coyote"))))
    assert {(1, 5, 4, 8, 6, 3, 7, 2), (1, 3, 7, 2, 6, 5, 4, 8)} <= ford


def test_of_the_eight_cross_plane_orders_four_have_one_pair_of_neighbours_four_three() -> None:
    orders = even_orders(crankstar.load("v8-cross-plane"))
    assert [len(one.neighbours) for one in orders] == [1] * 4 + [3] * 4
    assert all(
        sorted(row) == [90, 180, 180, 270] for one in orders[:4] for row in one.banks.values()
    )
    assert all(sorted(row) == [90, 90, 90, 450] for one in orders[4:] for row in one.banks.values())
    classic = next(one for one in orders if one.firing.order == (1, 8, 4, 3, 6, 5, 7, 2))
    assert [(step.first, step.then) for step in classic.neighbours] == [(5, 7)]
    assert [(step.first, step.then) for step in classic.partners] == [(4, 3), (6, 5), (2, 1)]


def test_the_banks_of_every_order_of_a_flat_plane_v8_exhaust_evenly() -> None:
    for one in even_orders(crankstar.load("v8-flat-plane")):
        assert set().union(*one.banks.values()) == {180.0}


def test_an_in_line_engine_has_no_banks_to_tell_apart() -> None:
    assert [one.banks for one in even_orders(crankstar.load("i4"))] == [{}, {}]


@pytest.mark.many(first=6)
@pytest.mark.parametrize("cylinders", [4, 6, 8, 10, 12, 14, 16])
def test_paired_dead_centres_give_two_to_the_power_of_one_less_than_the_pairs(
    cylinders: int,
) -> None:
    engine = engine_of(vees(cylinders=cylinders)[0])
    orders = even_orders(engine)
    assert len(orders) == len(set(written(orders))) == 2 ** (cylinders // 2 - 1)
    assert all(one.firing.even for one in orders)


def test_the_known_orders_of_v10_and_v12_engines_are_found() -> None:
    assert len(even_orders(crankstar.load("merlin"))) == 32
    twelve = written(even_orders(crankstar.load("v12-60")))
    assert (1, 12, 5, 8, 3, 10, 6, 7, 2, 11, 4, 9) in twelve[
        :4
    ]  # with neither neighbours nor partners in succession
    assert len(even_orders(engine_of(vees(cylinders=10, bank_angles_deg=(90,))[0]))) == 16


def test_a_two_stroke_engine_has_one_order() -> None:
    assert written(even_orders(crankstar.load("sinitsyn-8-two-stroke"))) == [
        (1, 8, 2, 6, 4, 5, 3, 7)
    ]


def test_a_radial_engine_with_an_odd_number_of_cylinders_fires_every_other_one() -> None:
    engine = radial(Basis(name="seven"), rows=(Row(cylinders=tuple(range(1, 8))),))
    assert written(even_orders(engine)) == [(1, 3, 5, 7, 2, 4, 6)]
    assert len(possible_orders(engine)) == 64


@pytest.mark.release
def test_four_rows_of_seven_are_counted_and_listed_and_more_refused() -> None:
    step = 2 * pi / 28
    rows = tuple(
        Row(cylinders=tuple(range(7 * row + 1, 7 * row + 8)), bearing=row * step * 2)
        for row in range(4)
    )
    engine = radial(Basis(name="corncob"), rows=rows, row_pitch=0.2)
    assert len(dict.fromkeys(written(even_orders(engine)))) == 2**13
    uneven = tuple(
        row.model_copy(update={"bearing": 0.05 * place}) for place, row in enumerate(rows)
    )
    with pytest.raises(
        OrderError, match="there are 134217728 firing orders, too many to list; give intervals"
    ):
        possible_orders(radial(Basis(name="corncob"), rows=uneven, row_pitch=0.2))
    assert 2**13 < GREATEST_COUNT < 2**27 == 134217728


def test_a_radial_with_slave_rods_fires_evenly_but_for_a_few_degrees() -> None:
    wasp = crankstar.load("pratt-whitney-wasp")
    least = unevenness(wasp)
    assert 3 < least < 4
    assert even_orders(wasp, tolerance_deg=least - 1e-6) == ()
    assert written(even_orders(wasp, tolerance_deg=least + 1e-6)) == [(1, 3, 5, 7, 9, 2, 4, 6, 8)]


def test_given_intervals_are_found_wherever_the_cycle_begins() -> None:
    harley = crankstar.load("harley-45")
    for intervals in ((315, 405), (405, 315)):
        assert [one.firing.intervals_deg for one in orders_at(harley, intervals_deg=intervals)] == [
            (315.0, 405.0)
        ]
    assert orders_at(harley, intervals_deg=(360, 360)) == ()
    four = crankstar.load("yamaha-r1-crossplane")
    found = orders_at(four, intervals_deg=(180, 90, 180, 270))
    assert set(written(found)) == {(1, 3, 2, 4), (1, 4, 3, 2), (1, 2, 3, 4), (1, 4, 2, 3)}
    place = place_of(four, found)
    assert place is not None
    assert found[place].firing.intervals_deg == (270.0, 180.0, 90.0, 180.0)


def test_an_odd_firing_v6_on_three_common_pins_is_found_by_its_intervals() -> None:
    banks = (Bank(bearing=-pi / 4, cylinders=(1, 3, 5)), Bank(bearing=pi / 4, cylinders=(2, 4, 6)))
    engine = vee(
        Basis(name="odd V6"), banks=banks, throws=(0.0, radians(120), radians(240)), bore_pitch=0.1
    )
    assert even_orders(engine) == ()
    centres = dead_centres(engine)
    found = orders_at(engine, intervals_deg=(90, 150) * 3)
    assert found
    for order in permutations(range(2, 7)):
        angles = _evenest((1, *order), centres, 720.0)
        fires = angles is not None and [
            round(b - a) for a, b in pairwise([*angles, angles[0] + 720])
        ] in ([90, 150] * 3, [150, 90] * 3)
        assert fires == ((1, *order) in written(found))


def test_the_most_even_orders_come_first() -> None:
    orders = possible_orders(crankstar.load("v4-90"))
    sizes = [one.unevenness_deg for one in orders]
    assert sizes == sorted(sizes)
    assert sizes[0] < sizes[-1]


@pytest.mark.release
@given(engines(max_shafts=1))
def test_the_possible_orders_are_the_permutations_that_fit(engine: Engine) -> None:
    found = possible_orders(engine)
    first, *others = sorted(engine.chambers)
    centres = dead_centres(engine)
    fit = {
        (first, *rest)
        for rest in permutations(others)
        if _evenest((first, *rest), centres, engine.cycle_angle) is not None
    }
    assert {one.firing.order for one in found} == fit
    for one in found[:3]:
        again = firing(with_order(engine, one.firing))
        assert again.order == one.firing.order
        assert again.intervals_deg == pytest.approx(one.firing.intervals_deg, abs=1e-6)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("layout", OF_LAYOUT)
def test_every_order_of_every_layout_can_be_fired(layout: str) -> None:
    @given(OF_LAYOUT[layout])
    def holds(engine: Engine) -> None:
        try:
            found = possible_orders(engine)
        except OrderError:
            return
        for one in found[:2] + found[-1:]:
            assert sum(one.firing.intervals_deg) == pytest.approx(engine.cycle_angle)
            assert firing(with_order(engine, one.firing)).intervals_deg == pytest.approx(
                one.firing.intervals_deg, abs=1e-6
            )

    holds()


def in_a_mirror(engine: Engine) -> Engine:
    """Left and right changed over, but not the way it turns."""
    shafts = tuple(
        shaft.model_copy(
            update={"throws": tuple(t.model_copy(update={"angle": -t.angle}) for t in shaft.throws)}
        )
        for shaft in engine.shafts
    )
    cylinders = tuple(
        c.model_copy(update={"bearing": -c.bearing, "offset": -c.offset}) for c in engine.cylinders
    )
    return engine.model_copy(update={"shafts": shafts, "cylinders": cylinders})


@pytest.mark.parametrize(
    "name", ["v8-cross-plane", "gm-3800", "i6", "merlin", "subaru-ej25", "v4-90", "vw-vr6"]
)
def test_in_a_mirror_or_turning_backwards_an_engine_fires_backwards(name: str) -> None:
    engine = crankstar.load(name)
    forward = set(written(possible_orders(engine)))
    backward = {(1, *reversed(order[1:])) for order in forward}
    assert set(written(possible_orders(with_rotation_reversed(engine)))) == backward
    assert set(written(possible_orders(in_a_mirror(engine)))) == backward
    assert (
        set(written(possible_orders(with_rotation_reversed(in_a_mirror(engine), firing_order=()))))
        == forward
    )


@pytest.mark.release
@given(engines(max_shafts=1))
def test_turning_the_whole_engine_changes_no_order(engine: Engine) -> None:
    shafts = tuple(
        shaft.model_copy(
            update={
                "throws": tuple(t.model_copy(update={"angle": t.angle + 1.0}) for t in shaft.throws)
            }
        )
        for shaft in engine.shafts
    )
    cylinders = tuple(
        cylinder.model_copy(update={"bearing": cylinder.bearing + 1.0})
        for cylinder in engine.cylinders
    )
    turned = engine.model_copy(update={"shafts": shafts, "cylinders": cylinders})
    assert sorted(written(possible_orders(turned))) == sorted(written(possible_orders(engine)))


def test_pistons_that_reach_dead_centre_together_may_be_meant_to_fire_together() -> None:
    twin = crankstar.load("kr250-racer-simultaneous")
    assert possible_orders(twin) == ()
    assert [one.firing.intervals_deg for one in possible_orders(twin, together=True)] == [
        (0.0, 360.0)
    ]
    (only,) = orders_at(twin, intervals_deg=(0, 360))
    assert firing(with_order(twin, only.firing)).intervals_deg == (0.0, 360.0)


def test_four_cylinders_may_fire_in_twos() -> None:
    four = crankstar.load("i4")
    found = orders_at(four, intervals_deg=(0, 360, 0, 360))
    assert found == ()
    found = orders_at(four, intervals_deg=(0, 180, 0, 540))
    assert written(found) == [(1, 4, 2, 3)] * 2
    assert [one.firing.intervals_deg for one in found] == [(0, 180, 0, 540), (0, 540, 0, 180)]
    for one in found:
        assert firing(with_order(four, one.firing)).intervals_deg == one.firing.intervals_deg


def test_geared_shafts_of_different_speed_fire_at_the_dead_centres_of_each() -> None:
    basis = Basis(name="geared", cycle="four-stroke", cylinder=Sizes(stroke=0.08, rod_length=0.14))
    cranks = (
        Crank(banks=(Bank(cylinders=(1,)),)),
        Crank(banks=(Bank(cylinders=(2,)),), speed_ratio="2", right=0.3),  # pyright: ignore[reportArgumentType]
    )
    engine = tandem(basis, cranks=cranks)
    assert [one.firing.intervals_deg for one in possible_orders(engine)] == [
        (360.0, 360.0),
        (180.0, 540.0),
        (540.0, 180.0),
    ]
    assert written(even_orders(engine)) == [(1, 2)]
    slow = tandem(
        basis,
        cranks=(
            cranks[0],
            Crank(banks=(Bank(cylinders=(2,)),), speed_ratio=Fraction(3, 4), right=0.3),
        ),
    )
    with pytest.raises(OrderError, match="cylinder 2 is at top dead centre every 480 deg"):
        even_orders(slow)


def test_where_the_slowest_shaft_is_not_the_first_its_cylinder_counts_the_cycle() -> None:
    basis = Basis(name="geared", cycle="four-stroke", cylinder=Sizes(stroke=0.08, rod_length=0.14))
    cranks = (
        Crank(banks=(Bank(bearing=0.0, cylinders=(1,)),)),
        Crank(banks=(Bank(cylinders=(2,)),), speed_ratio="1/2", lag=radians(90), right=0.3),  # pyright: ignore[reportArgumentType]
    )
    found = possible_orders(tandem(basis, cranks=cranks))
    assert sorted(one.firing.intervals_deg for one in found) == [(90.0, 630.0), (450.0, 270.0)]


def test_a_shaft_at_three_halves_of_the_crank_speed_leaves_two_turns_to_choose_from() -> None:
    basis = Basis(name="geared", cycle="four-stroke", cylinder=Sizes(stroke=0.08, rod_length=0.14))
    cranks = (
        Crank(banks=(Bank(cylinders=(1,)),)),
        Crank(banks=(Bank(cylinders=(2,)),), speed_ratio="3/2", right=0.3),  # pyright: ignore[reportArgumentType]
    )
    engine = tandem(basis, cranks=cranks)
    found = sorted(one.firing.intervals_deg for one in possible_orders(engine))
    assert found == [(120.0, 600.0), (240.0, 480.0), (360.0, 360.0), (480.0, 240.0), (600.0, 120.0)]
    (only,) = even_orders(engine)
    assert (unevenness(engine), why_uneven(engine)) == (0.0, [])
    assert firing(with_order(engine, only.firing)).intervals_deg == (360.0, 360.0)


@pytest.mark.parametrize("cylinders", [10, 14])
def test_orders_are_sorted_by_neighbours_then_banks_then_partners_then_numbers(
    cylinders: int,
) -> None:
    orders = even_orders(engine_of(vees(cylinders=cylinders)[0]))
    keys = [
        (len(one.neighbours), one.bank_unevenness_deg, len(one.partners), one.firing.order)
        for one in orders
    ]
    assert keys == sorted(keys)


def test_opposed_pistons_fire_by_chambers() -> None:
    engine = opposed(
        Basis(name="x", cycle="two-stroke", cylinder=Sizes(stroke=0.08, rod_length=0.14)),
        throws=(0.0, radians(120), radians(240)),
        crank_distance=0.4,
        lag=radians(10),
    )
    (only,) = even_orders(engine)
    assert only.firing.order == (1, 3, 2)
    assert only.banks == {}  # each bank of pistons has all the chambers


WHY = {
    "v2-90": [("orders.uneven", 360, [2], [90, 450])],
    "v4-90": [("orders.uneven", 180, [2], [90, 450]), ("orders.uneven", 180, [4], [270, 630])],
    "kr250-racer-simultaneous": [("orders.crowded", 180, [1, 2], [0])],
}


@pytest.mark.parametrize("name", WHY)
def test_why_nothing_fires_evenly_is_told(name: str) -> None:
    faults = why_uneven(crankstar.load(name))
    assert [
        (f.code, f.values["interval"], f.values["numbers"], f.values["angles"]) for f in faults
    ] == WHY[name]


def test_two_rows_of_nine_with_slave_rods_are_offered_as_near_to_even_as_can_be() -> None:
    rows = (
        Row(cylinders=tuple(range(1, 10))),
        Row(cylinders=tuple(range(10, 19)), bearing=pi / 9, throw=pi),
    )
    engine = radial(Basis(name="eighteen"), rows=rows, row_pitch=0.2, knuckle_radius=0.2)
    with pytest.raises(OrderError, match="there are 131072 firing orders"):
        possible_orders(engine)
    orders = most_even_orders(engine)
    assert len(orders) == 2**8  # nine pairs that are near to dead centre together
    assert (
        max(abs(one - 40) for order in orders for one in order.firing.intervals_deg)
        <= 2 * unevenness(engine) + 1e-3
    )


@pytest.mark.release
def test_a_shaft_of_256_throws_is_answered_in_a_sentence() -> None:
    engine = inline(
        Basis(name="x"), throws=tuple(0.0245 * place**1.1 for place in range(256)), bore_pitch=0.1
    )
    with pytest.raises(OrderError, match=r"there are 5\.7896e\+76 firing orders"):
        most_even_orders(engine)


def test_dead_centres_that_coincide_are_told() -> None:
    engine = inline(Basis(name="x"), throws=(0.0, 0.0, 0.0, pi), bore_pitch=0.1)
    (fault,) = why_uneven(engine)
    assert (fault.code, fault.values["numbers"]) == ("orders.crowded", [1, 2, 3])
    assert fault.values["angles"] == [0, 360]
    assert possible_orders(engine) == ()
    assert why_uneven(crankstar.load("i4")) == []


@pytest.mark.parametrize(
    ("intervals", "tolerance", "told"),
    [
        ((180, 180, 360), 1e-4, "3 intervals are given for 4 firings in a cycle; give 4"),
        (
            (180, 180, 180, 90),
            1e-4,
            "do not make up a cycle; give intervals from 0 up, together 720 deg",
        ),
        ((360, 360, 180, -180), 1e-4, "do not make up a cycle"),
        (
            (180, 180, 180, 180),
            90.0,
            "the tolerance is 90 deg; give less than half of the smallest interval, 90 deg",
        ),
    ],
)
def test_intervals_that_cannot_be_meant_are_refused(
    intervals: tuple[float, ...], tolerance: float, told: str
) -> None:
    with pytest.raises(OrderError, match=told):
        orders_at(crankstar.load("i4"), intervals_deg=intervals, tolerance_deg=tolerance)


def test_an_order_that_the_crank_cannot_fire_is_refused() -> None:
    four = crankstar.load("i4")
    wrong = replace(even_orders(four)[0].firing, order=(1, 4, 2, 3))
    with pytest.raises(EngineError, match="firing_angles"):
        with_order(four, wrong)


def test_an_order_put_on_an_engine_says_that_it_was_computed() -> None:
    eight = crankstar.load("v8-cross-plane")
    other = with_order(eight, even_orders(eight)[0].firing)
    assert other.provenance["firing_order"].status == "computed"
    assert place_of(other, even_orders(other)) == 0


# The Ford numbering: 1 to 4 along the right bank of the car, 5 to 8 along the left; General Motors:
# odd left, even right.
FORD_TO_GM = {1: 2, 2: 4, 3: 6, 4: 8, 5: 1, 6: 3, 7: 5, 8: 7}


def test_the_orders_of_ford_and_general_motors_are_the_same_in_one_numbering() -> None:
    coyote, modular = crankstar.load("ford-coyote"), crankstar.load("ford-46-sohc")
    general = set(written(even_orders(crankstar.load("gm-l76"))))
    assert {
        place: cylinder.bearing > 0
        for place, cylinder in enumerate(crankstar.load("gm-l76").cylinders, 1)
    }[1]
    for ford in (coyote, modular):
        other = renumbered(ford, numbers=FORD_TO_GM)
        assert set(written(even_orders(other))) == general
        assert other.firing_order in general
    assert renumbered(modular, numbers=FORD_TO_GM).firing_order == (1, 8, 7, 2, 6, 5, 4, 3)


@given(engines(max_shafts=1))
def test_renumbering_renames_the_orders_and_back_again_leaves_the_engine(engine: Engine) -> None:
    old = sorted(cylinder.number for cylinder in engine.cylinders)
    there = dict(zip(old, [*old[1:], old[0]], strict=True))
    other = renumbered(engine, numbers=there)
    renamed = {
        frozenset(_cycle(tuple(there.get(n, n) for n in order)))
        for order in written(possible_orders(engine))
    }
    assert {frozenset(_cycle(order)) for order in written(possible_orders(other))} == renamed
    again = renumbered(other, numbers={new: old for old, new in there.items()})
    assert again.cylinders == engine.cylinders
    if engine.firing_order:
        assert sorted(firing(other).intervals_deg) == pytest.approx(
            sorted(firing(engine).intervals_deg), abs=1e-6
        )


def _cycle(order: tuple[int, ...]) -> list[tuple[int, int]]:
    """Who fires after whom."""
    return list(pairwise([*order, order[0]]))


def test_a_number_given_twice_or_to_nobody_is_refused() -> None:
    with pytest.raises(ValueError, match="number the chambers as well"):
        renumbered(crankstar.load("i4"), numbers={1: 2})
    with pytest.raises(EngineError, match="there is no cylinder 9 to renumber"):
        renumbered(crankstar.load("i4"), numbers={9: 2})


def test_counting_from_the_flywheel_writes_the_order_of_an_in_line_four_the_other_way() -> None:
    from_behind = renumbered(crankstar.load("i4"), numbers={1: 4, 2: 3, 3: 2, 4: 1})
    assert from_behind.firing_order == (1, 3, 4, 2)


def test_even_orders_of_an_in_line_five_are_one() -> None:
    assert written(even_orders(FIVE)) == [(1, 2, 4, 5, 3)]
    assert written(even_orders(FOUR_IN_A_PLANE)) == [(1, 3, 2, 4), (1, 4, 2, 3)]
