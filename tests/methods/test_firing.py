"""Dead centres and firing angles against closed forms, dense sampling and brute force."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise, permutations, product
from math import asin, degrees, pi, radians
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from tests.strategies import engines

from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.dead_centres import DeadCentre, _dead_centres, _kept, dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import _evenest
from crankstar.engine.layouts import Row, inline, opposed, radial, tandem, vee
from crankstar.files import engine_of
from crankstar.firing.intervals import firing
from crankstar.language.faults import EngineError, Fault

pytestmark = pytest.mark.quick

SIZES = Sizes(stroke=0.08, rod_length=0.14, bore=0.08)


def v8(
    order: tuple[int, ...], *, throws: tuple[float, ...], odd: float, rotation: str = "clockwise"
) -> Engine:
    banks = (
        Bank(bearing=radians(odd), cylinders=(1, 3, 5, 7)),
        Bank(bearing=-radians(odd), cylinders=(2, 4, 6, 8)),
    )
    basis = Basis(name="V8", firing_order=order, rotation=rotation)  # pyright: ignore[reportArgumentType]
    return vee(basis, banks=banks, throws=tuple(map(radians, throws)))


FLAT, CROSS = (0.0, 180.0, 180.0, 0.0), (0.0, 90.0, -90.0, 180.0)
FLAT_ORDER, CROSS_ORDER = (1, 8, 5, 4, 7, 2, 3, 6), (1, 8, 4, 3, 6, 5, 7, 2)


def test_an_offset_cylinder_is_at_dead_centre_where_crank_and_rod_are_in_line() -> None:
    turned = inline(
        Basis(name="x", cylinder=SIZES.model_copy(update={"offset": 0.015})),
        throws=(0.0, 1.0),
        bore_pitch=0.1,
    )
    assert degrees(turned.shafts[0].throws[0].angle) == pytest.approx(degrees(asin(0.015 / 0.18)))
    centres = dead_centres(turned)
    assert centres[1].angle_deg == pytest.approx(0, abs=1e-9)
    assert centres[2].angle_deg == pytest.approx(360 - degrees(1.0))


@pytest.mark.release
@given(engine=engines())
def test_crank_and_rod_are_in_line_where_a_search_finds_the_piston_farthest(engine: Engine) -> None:
    for outward in (1.0, -1.0):
        _kept.cache_clear()
        known = _dead_centres(engine, outward=outward)
        _kept.cache_clear()
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("crankstar.engine.dead_centres._is_in_line", lambda *_: False)
            searched = _dead_centres(engine, outward=outward)
        _kept.cache_clear()
        for number, found in searched.items():
            away = abs(found.angle_deg - known[number].angle_deg)
            assert min(away, found.period_deg - away) < 1e-5
            assert found.period_deg == known[number].period_deg


@pytest.mark.many(first=1)
@pytest.mark.parametrize("ratio", [1, -1])
def test_two_pistons_that_share_a_chamber_fire_where_its_volume_is_least(ratio: int) -> None:
    lag = radians(11)
    engine = opposed(
        Basis(name="x", cycle="two-stroke", cylinder=SIZES),
        throws=(0.0, 2.0),
        crank_distance=0.4,
        lag=lag,
        speed_ratio=Fraction(ratio),
    )
    theta = np.linspace(0, 2 * pi, 720_001)

    def travel(psi: np.ndarray) -> np.ndarray:
        return 0.04 * np.cos(psi) + np.sqrt(0.14**2 - (0.04 * np.sin(psi)) ** 2)

    dense = degrees(theta[np.argmax(travel(theta) + travel(theta - lag))])
    assert dead_centres(engine)[1].angle_deg == pytest.approx(dense, abs=1e-3)
    assert dead_centres(engine)[1].angle_deg == pytest.approx(
        5.5, abs=1e-6
    )  # half-way, by symmetry


def test_the_lag_of_a_second_crankshaft_is_that_of_its_dead_centre_whichever_way_it_turns() -> None:
    for ratio, rotation in product((1, -1), ("clockwise", "counter-clockwise")):
        cranks = (
            Crank(banks=(Bank(cylinders=(1,)),)),
            Crank(
                banks=(Bank(bearing=0.3, cylinders=(2,)),),
                right=3.0,
                speed_ratio=Fraction(ratio),
                lag=radians(100),
            ),
        )
        engine = tandem(Basis(name="x", cycle="two-stroke", rotation=rotation), cranks=cranks)
        assert dead_centres(engine)[2].angle_deg == pytest.approx(100)


def test_a_shaft_at_half_speed_has_a_dead_centre_every_two_turns() -> None:
    cranks = (
        Crank(banks=(Bank(cylinders=(1,)),)),
        Crank(banks=(Bank(cylinders=(2,)),), right=3.0, speed_ratio=Fraction(1, 2)),
    )
    assert dead_centres(tandem(Basis(name="x"), cranks=cranks))[2] == DeadCentre(0.0, 720.0)


def test_slave_rods_shift_the_dead_centres_of_a_radial_engine_by_a_few_degrees() -> None:
    row = Row(cylinders=tuple(range(1, 10)))
    plain = radial(Basis(name="x", cylinder=SIZES), rows=(row,))
    slave = radial(Basis(name="x", cylinder=SIZES), rows=(row,), knuckle_radius=0.02)
    even = [dead_centres(plain)[k].angle_deg for k in range(1, 10)]
    assert even == pytest.approx([40 * k for k in range(9)], abs=1e-9)
    shifted = np.array([dead_centres(slave)[k].angle_deg for k in range(1, 10)]) - even
    assert 0.5 < np.max(np.abs(shifted)) < 15
    assert shifted[1:] == pytest.approx(
        -shifted[1:][::-1], abs=1e-6
    )  # mirror-image about the master rod


@pytest.mark.release
def test_firing_angles_are_the_most_even_that_brute_force_finds() -> None:
    random = np.random.default_rng(3)
    for _ in range(60):
        centres = {
            k: DeadCentre(float(random.choice([0, 90, 120, 180, 240, 270, 300])), 360.0)
            for k in range(1, 5)
        }
        for order in permutations(range(1, 5)):
            found = _evenest(order, centres, 720.0)
            best = brute_force(order, centres)
            assert (found is None) == (best is None)
            if found is not None and best is not None:
                assert squares(found) == pytest.approx(squares(best))


def brute_force(order: tuple[int, ...], centres: dict[int, DeadCentre]) -> list[float] | None:
    first = centres[order[0]].angle_deg
    choices = [
        [first],
        *(
            [(centres[k].angle_deg - first) % 360 + first + turn for turn in (0, 360)]
            for k in order[1:]
        ),
    ]
    rising = [list(way) for way in product(*choices) if all(a < b for a, b in pairwise(way))]
    return min(rising, key=squares, default=None)


def squares(angles: list[float]) -> float:
    return sum((b - a) ** 2 for a, b in zip(angles, [*angles[1:], angles[0] + 720], strict=True))


@pytest.mark.parametrize(
    ("order", "throws", "odd"),
    [(FLAT_ORDER, FLAT, -45.0), (CROSS_ORDER, CROSS, 45.0)],
    ids=["flat", "cross"],
)
def test_both_v8_pages_need_their_own_side_and_the_refusal_names_it(
    order: tuple[int, ...], throws: tuple[float, ...], odd: float
) -> None:
    assert firing(v8(order, throws=throws, odd=odd)).intervals_deg == pytest.approx([90.0] * 8)
    (fault,) = refused(lambda: v8(order, throws=throws, odd=-odd))
    assert fault.path == ("firing_order",)
    assert fault.values["banks"]["1, 3, 5, 7"] == f"{odd:+.4g}"
    # The other rotation is proposed exactly where it would fit.
    try:
        reversed_fits = bool(v8(order, throws=throws, odd=-odd, rotation="counter-clockwise"))
    except EngineError:
        reversed_fits = False
    assert fault.code == "firing_order.unfit-other-banks" + "-or-rotation" * reversed_fits


def refused(make: Callable[[], Engine]) -> list[Fault]:
    """The faults of an engine that cannot be made."""
    with pytest.raises(EngineError) as error:
        make()
    return error.value.faults


def test_an_order_that_fits_in_no_mirror_is_refused_without_a_false_hint() -> None:
    # Two neighbours on one pin cannot fire one after the other with everything else in between.
    (fault,) = refused(lambda: v8((1, 7, 3, 5, 2, 8, 4, 6), throws=FLAT, odd=-45.0))
    assert fault.code == "firing_order.unfit"


def test_cylinders_at_dead_centre_together_fire_together_only_when_told() -> None:
    cranks = (
        Crank(banks=(Bank(cylinders=(1,)),)),
        Crank(banks=(Bank(cylinders=(2,)),), right=3.0, speed_ratio=Fraction(-1)),
    )
    silent = Basis(name="x", cycle="two-stroke", firing_order=(1, 2))
    (fault,) = refused(lambda: tandem(silent, cranks=cranks))
    assert (fault.code, fault.values["together"]) == ("firing_order.unfit-together", "1 and 2")
    together = silent.model_copy(update={"firing_angles": (0.0, 0.0)})
    assert firing(tandem(together, cranks=cranks)).intervals_deg == (0.0, 360.0)
    wrong = silent.model_copy(update={"firing_angles": (0.0, radians(90))})
    (fault,) = refused(lambda: tandem(wrong, cranks=cranks))
    assert (fault.path, fault.code) == (("firing_angles", 1), "firing_angles.off-dead-centre")
    assert (fault.values["number"], fault.values["angle"]) == (2, 0.0)


def test_a_common_pin_twin_fires_at_its_bank_angle_and_the_rest() -> None:
    banks = (
        Bank(bearing=radians(-22.5), cylinders=(1,)),
        Bank(bearing=radians(22.5), cylinders=(2,)),
    )
    engine = vee(Basis(name="45 deg twin", firing_order=(1, 2)), banks=banks, throws=(0.0,))
    assert firing(engine).intervals_deg == pytest.approx((405, 315))
    big_bang = vee(
        Basis(name="x", firing_order=(1, 2), firing_angles=(0.0, radians(45))),
        banks=banks,
        throws=(0.0,),
    )
    assert firing(big_bang).intervals_deg == pytest.approx((45, 675))


@pytest.mark.parametrize("radius", ["55.18809855 mm", "55.1880985501 mm"])
def test_of_two_dead_centres_that_a_mirror_makes_the_first_counts(radius: str) -> None:
    """Two pistons on knuckle pins compress as far at 7.9 deg as at 172.1: rounding is no choice."""
    master: dict[str, Any] = {"number": 1, "shaft": "crank", "throw": 1, "bearing": "180 deg"}
    master |= {"rod_length": "100.521 mm", "reciprocating_mass": "1 kg"}
    pin = {"master": 1, "radius": radius, "angle": "45 deg"}
    first = master | {"number": 2, "rod_length": "156.812860521 mm", "chamber": 2}
    other = first | {"number": 3, "bearing": "0 deg", "rod_length": "259.683894810675 mm"}
    first["articulated"] = pin
    other["articulated"] = pin | {"radius": "26.17734375 mm", "angle": "90 deg"}
    throw = {"angle": "0 deg", "radius": "98.55 mm"}
    tree = {
        "name": "mirror",
        "cycle": "two-stroke",
        "shaft": [{"name": "crank", "throw": [throw]}],
        "cylinders": [master, first, other],
    }
    engine = engine_of(tree)
    assert dead_centres(engine)[2].angle_deg == pytest.approx(7.907031041, abs=1e-6)
