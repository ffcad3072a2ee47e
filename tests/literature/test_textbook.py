"""What every textbook says of the common layouts: star sums, closed forms, firing intervals.

Sums are in units of m r w^2 A_k and m r w^2 A_k a, A_k the harmonics of a piston. Sources: standard
tables of engine balance (for instance C. F. Taylor, The Internal-Combustion Engine in Theory and
Practice, vol. 2, on engine balance); the intervals from the sources that the catalog files name.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, pi, radians, sin, sqrt
from typing import Any

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.spectra import Spectrum

pytestmark = pytest.mark.quick

ANGLES = np.radians(np.arange(0, 360, 5))
EXACT = 1e-9


def sums(
    name: str, order: int, *, changes: Mapping[str, Any] | None = None
) -> tuple[Spectrum, Spectrum]:
    """Force and couple of one order of a catalog engine, in m r w^2 A_k and m r w^2 A_k a."""
    engine = crankstar.load(name, changes=changes)
    whole, factor = total(balance(engine)), 1 / harmonic(engine, order)
    force, couple = (
        spectra.scaled(spectra.selected(spectrum, order), factor)
        for spectrum in (whole.force, whole.couple)
    )
    return force, couple


def harmonic(engine: Engine, order: int) -> float:
    first = engine.first
    harmonics = motion.piston_harmonics(
        crank_radius=engine.throw(first).radius, rod_length=first.rod_length
    )
    return float(harmonics[order].real)


def greatest(spectrum: Spectrum) -> float:
    return float(np.abs(spectra.value(spectrum, ANGLES)).max())


def turning(spectrum: Spectrum) -> tuple[float, float]:
    """How long the vectors are that turn with the crank and against it."""
    return float(abs(spectrum.forward[0])), float(abs(spectrum.backward[0]))


def amplitudes(spectrum: Spectrum) -> tuple[float, float]:
    """Vertical and horizontal amplitude."""
    return float(abs(spectra.vertical(spectrum)[0])), float(abs(spectra.horizontal(spectrum)[0]))


@pytest.mark.parametrize("order", [1, 2, 4])
def test_single_cylinder_is_the_unit_and_shakes_upright(order: int) -> None:
    force, couple = sums("single", order)
    assert amplitudes(force) == pytest.approx((1, 0), abs=EXACT)
    assert greatest(couple) == 0


@pytest.mark.parametrize(
    ("name", "order", "vertical"),
    [
        ("i2-360", 1, 2),
        ("i2-360", 2, 2),
        ("bmw-f800", 1, 2),
        ("i2-270", 1, sqrt(2)),
        ("i2-270", 2, 0),
        ("parallel-twin-180", 2, 2),
        ("i4", 1, 0),
        ("i4", 2, 4),
        ("suzuki-hayabusa", 2, 4),
        ("honda-b18c", 2, 4),
        ("square-four", 1, 0),
        ("square-four", 2, 4),
        ("triple-120", 1, 0),
        ("triple-120", 2, 0),
        ("triple-120", 6, 3),
        ("audi-25-tfsi", 1, 0),
        ("audi-25-tfsi", 2, 0),
        ("yamaha-r1-crossplane", 1, 0),
        ("yamaha-r1-crossplane", 2, 0),
        ("yamaha-r1-crossplane", 4, 4),
        ("i6", 6, 6),
    ],
)
def test_force_of_upright_engines(name: str, order: int, vertical: float) -> None:
    force, _ = sums(name, order)
    assert amplitudes(force) == pytest.approx((vertical, 0), abs=EXACT)


@pytest.mark.parametrize(
    ("name", "first", "second"),
    [
        ("triple-120", sqrt(3), sqrt(3)),
        ("triumph-675", sqrt(3), sqrt(3)),
        ("audi-25-tfsi", 0.4490, 4.9798),
        ("yamaha-r1-crossplane", sqrt(10), 0),
        ("i2-270", sqrt(2) / 2, 1),
        ("i4", 0, 0),
        ("i6", 0, 0),
        ("man-s50mc-c", 0, 2 * sqrt(3)),
        ("man-s90mc-c", 0.2673, 1.0056),
        ("square-four", 0, 0),
    ],
)
def test_couple_of_upright_engines(name: str, first: float, second: float) -> None:
    for order, size in ((1, first), (2, second)):
        _, couple = sums(name, order)
        assert amplitudes(couple) == pytest.approx((size, 0), abs=5e-5)


@pytest.mark.parametrize("name", ["v6-60-six-throws", "ford-cologne"])
def test_v6_60_with_six_throws_has_couples_of_1_5_forward_and_1_5_backward(name: str) -> None:
    for order, expected in ((1, (1.5, 0)), (2, (0, 1.5))):
        force, couple = sums(name, order)
        assert greatest(force) < EXACT
        assert turning(couple) == pytest.approx(expected, abs=EXACT)


def test_v_twin_of_90_degrees_is_1_forward_and_sqrt_2_horizontal() -> None:
    assert turning(sums("v2-90", 1)[0]) == pytest.approx((1, 0), abs=EXACT)
    assert amplitudes(sums("v2-90", 2)[0]) == pytest.approx((0, sqrt(2)), abs=EXACT)


@pytest.mark.parametrize(("factor", "left"), [(0.0, 1.0), (0.5, 0.0), (1.0, 1.0)])
def test_half_the_reciprocating_mass_as_counterweight_frees_the_90_degree_v_twin_of_first_order(
    factor: float, left: float
) -> None:
    force, _ = sums("v2-90", 1, changes={"balance_factor": factor})
    assert greatest(force) == pytest.approx(left, abs=1e-12)


def test_v_twin_of_45_degrees_is_an_ellipse_of_twice_cos_and_sin_squared_of_half_the_angle() -> (
    None
):
    force, _ = sums("harley-45", 1)
    half = radians(45 / 2)
    assert amplitudes(force) == pytest.approx((2 * cos(half) ** 2, 2 * sin(half) ** 2), abs=EXACT)


def test_v4_of_90_degrees_has_a_turning_couple_and_a_horizontal_second_order() -> None:
    force, couple = sums("v4-90", 1)
    assert greatest(force) < EXACT
    assert turning(couple) == pytest.approx((1, 0), abs=EXACT)
    assert amplitudes(sums("v4-90", 2)[0]) == pytest.approx((0, 2 * sqrt(2)), abs=EXACT)


CROSS_PLANES = [
    "bmw-s65",
    "ford-coyote",
    "ford-46-sohc",
    "gm-l76",
    "porsche-cayenne-48",
    "toyota-1uz-fe",
]


@pytest.mark.parametrize("name", CROSS_PLANES)
def test_cross_plane_v8_of_any_numbering_has_only_the_turning_couple_of_sqrt_10(name: str) -> None:
    for order, expected in ((1, (sqrt(10), 0)), (2, (0, 0))):
        force, couple = sums(name, order)
        assert greatest(force) < EXACT
        assert turning(couple) == pytest.approx(expected, abs=EXACT)


def test_flat_plane_v8_of_ferrari_has_the_horizontal_second_order() -> None:
    assert amplitudes(sums("ferrari-f136", 2)[0]) == pytest.approx((0, 4 * sqrt(2)), abs=EXACT)


@pytest.mark.parametrize("name", ["gm-3800", "international-vt275", "ford-essex-42"])
def test_split_pin_v6_leaves_no_force_but_a_couple_against_the_crank_for_its_balance_shaft(
    name: str,
) -> None:
    force, couple = sums(name, 1)
    assert greatest(force) < EXACT
    # each bank, three pins 120 deg apart, has couples of sqrt(3)/2 either way; the other one's are
    # 30 and 150 deg from them
    with_crank, against = turning(couple)
    assert with_crank == pytest.approx(sqrt(3) * cos(radians(15)), abs=EXACT)
    assert against == pytest.approx(sqrt(3) * cos(radians(75)), abs=EXACT)


@pytest.mark.parametrize(
    ("name", "orders"),
    [
        ("i6", (1, 2, 4)),
        ("toyota-2jz", (1, 2, 4)),
        ("bmw-m52b28", (1, 2, 4)),
        ("v12-60", (1, 2, 4)),
        ("merlin", (1, 2, 4)),
        ("boxer-6", (1, 2, 4)),
        ("napier-lion", (1,)),
    ],
)
def test_engines_free_of_force_and_couple(name: str, orders: tuple[int, ...]) -> None:
    for order in orders:
        for spectrum in sums(name, order):
            assert greatest(spectrum) < EXACT


@pytest.mark.parametrize("order", [1, 2, 4])
def test_boxer_twin_has_no_force_but_the_couple_of_its_stagger(order: int) -> None:
    for name in ("boxer-2", "bmw-r1200"):
        force, couple = sums(name, order)
        assert greatest(force) < EXACT
        assert amplitudes(couple) == pytest.approx((0, 1), abs=EXACT)


def test_boxer_four_is_left_with_the_second_order_couple_of_its_stagger() -> None:
    engine = crankstar.load("subaru-ej25")
    stagger = (engine.cylinders[0].z - engine.cylinders[1].z) / engine.pitch
    assert max(greatest(spectrum) for spectrum in sums("subaru-ej25", 1)) < EXACT
    force, couple = sums("subaru-ej25", 2)
    assert greatest(force) < EXACT
    assert amplitudes(couple) == pytest.approx((0, 2 * stagger), abs=EXACT)


def test_golden_dream_cancels_forces_of_every_order_as_its_makers_said() -> None:
    force = total(balance(crankstar.load("brough-golden-dream"))).force
    assert greatest(force) < EXACT


@pytest.mark.parametrize("name", ["radial-9", "pratt-whitney-wasp"])
def test_radial_nine_turns_a_vector_of_4_5_and_its_slave_rods_leave_second_order_turning_with_it(
    name: str,
) -> None:
    assert turning(sums(name, 1)[0]) == pytest.approx((4.5, 0), abs=EXACT)
    second = spectra.selected(total(balance(crankstar.load(name))).force, 2)
    with_crank, against = turning(second)
    assert with_crank == pytest.approx(0.6, abs=0.03)
    assert against < 0.001


def test_radial_with_all_rods_on_the_crank_pin_has_no_second_order() -> None:
    tree = {
        "format": 1, "name": "plain radial", "firing_order": [1, 3, 5, 7, 9, 2, 4, 6, 8],
        "layout": {"type": "radial", "rows": [{"cylinders": list(range(1, 10))}]},
    }  # fmt: skip
    force = total(balance(crankstar.files.engine_of(tree))).force
    assert greatest(spectra.selected(force, 2)) < EXACT


def test_opposed_pistons_without_lag_cancel_each_other_at_every_order() -> None:
    together = total(balance(crankstar.load("jumo-205", changes={"layout.lag": "0 deg"})))
    assert greatest(together.force) < EXACT
    assert greatest(together.couple) < EXACT


def test_deltic_has_no_forces_of_order_1_and_2() -> None:
    for order in (1, 2):
        assert greatest(sums("napier-deltic", order)[0]) < EXACT


# Firing


@pytest.mark.parametrize(
    ("name", "intervals"),
    [
        ("harley-45", (315, 405)),
        ("ducati-90", (270, 450)),
        ("i2-270", (270, 450)),
        ("i2-360", (360, 360)),
        ("fiat-twinair", (360, 360)),
        ("bmw-f800", (360, 360)),
        ("yamaha-r1-crossplane", (270, 180, 90, 180)),
        ("v4-90", (180, 270, 180, 90)),
        ("kr250-racer", (180, 180)),
        ("kr250-racer-simultaneous", (0, 360)),
        ("gm-3800", (120,) * 6),
        ("international-vt275", (120,) * 6),
        ("ford-essex-42", (120,) * 6),
        ("ford-cologne", (120,) * 6),
        ("merlin", (60,) * 12),
        ("napier-deltic", (20,) * 18),
        ("jumo-205", (60,) * 6),
        ("brough-golden-dream", (180,) * 4),
        ("square-four", (180,) * 4),
    ],
)
def test_firing_intervals(name: str, intervals: tuple[float, ...]) -> None:
    assert firing(crankstar.load(name)).intervals_deg == pytest.approx(intervals, abs=1e-6)


def test_common_pins_would_make_the_90_degree_v6_fire_unevenly() -> None:
    intervals = firing(
        crankstar.load("gm-3800", changes={"layout.pin_split": "0 deg"})
    ).intervals_deg
    assert intervals == pytest.approx((150, 90) * 3, abs=1e-6)


def test_pins_22_degrees_apart_make_the_vr6_fire_evenly_within_a_sixth_of_a_degree() -> None:
    intervals = firing(crankstar.load("vw-vr6")).intervals_deg
    assert max(abs(interval - 120) for interval in intervals) < 1 / 6
    row = 2 * (
        radians(7.5) + np.arcsin(12.5 / (164 + 90.3 / 2))
    )  # of the dead centres of the two rows
    assert np.degrees(row) == pytest.approx(22, abs=1 / 6)


def test_lower_crankshaft_of_the_jumo_is_11_degrees_behind() -> None:
    engine = crankstar.load("jumo-205")
    upper, lower = (engine.shaft(name).throws[0].angle for name in ("first", "second"))
    # the upper one is at its inner dead centre pointing down, the lower one 11 deg short of
    # pointing up
    assert np.degrees(upper - lower - pi) % 360 == pytest.approx(11, abs=EXACT)
    assert dead_centres(engine)[1].angle_deg == pytest.approx(11 / 2, abs=1e-6)
