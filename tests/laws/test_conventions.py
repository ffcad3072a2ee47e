"""The frame and its signs: one small engine for each sentence of the page of conventions."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import asin, pi, radians
from typing import Any

import numpy as np
import pytest

from crankstar import spectra
from crankstar.engine.banks import Bank
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.copies import with_values
from crankstar.engine.cylinder_parts import Rod
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import Row, inline, opposed, radial, vee
from crankstar.engine.motion import piston_harmonics
from crankstar.engine.records import Cylinder, Shaft, Throw, Weight
from crankstar.mechanics.balance import (
    Balance,
    Reference,
    Totals,
    balance,
    of_parts,
    total,
    unit_unbalance,
)
from crankstar.mechanics.excitation import part_spectra
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Spectrum

pytestmark = pytest.mark.quick

MASS, RADIUS, ROD, SPEED = 0.5, 0.04, 0.14, 100.0
FORCE = MASS * RADIUS * SPEED**2
"""m r w^2, N."""
ROTATIONS = pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])


def engine(
    *weights: Weight, bearing: float = 0.0, z: float = 0.0, offset: float = 0.0, **changes: Any
) -> Engine:
    """One cylinder at top dead centre at theta = 0, and perhaps some weights on its crankshaft."""
    dead_centre = bearing + asin(offset / (RADIUS + ROD))
    throw = Throw(angle=dead_centre, radius=RADIUS, z=z)
    return Engine(
        **{
            "name": "one cylinder",
            "shafts": (Shaft(name="crank", throws=(throw,), weights=weights),),
            "cylinders": (
                Cylinder(
                    number=1,
                    shaft="crank",
                    throw=1,
                    bearing=bearing,
                    z=z,
                    offset=offset,
                    rod_length=ROD,
                    reciprocating_mass=MASS,
                ),
            ),
            **changes,
        }
    )


def at(spectrum: Spectrum, degrees: float) -> complex:
    """The vector `up + i*right` at a crank angle."""
    return complex(spectra.value(spectrum, radians(degrees)))


def of_weights(result: Balance) -> Totals:
    return of_parts(result, kind="weight")


def test_a_single_vertical_cylinder_pushes_up_at_top_and_down_at_bottom_dead_centre() -> None:
    force = total(balance(engine(), speed=SPEED)).force
    ratio = RADIUS / ROD
    assert at(force, 0) == pytest.approx(
        FORCE * (1 + ratio), rel=1e-9
    )  # exact at the dead centres: 1 + lambda, 1 - lambda
    assert at(force, 180) == pytest.approx(-FORCE * (1 - ratio), rel=1e-9)


def test_a_cylinder_pushes_along_its_bearing_which_is_clockwise_from_up() -> None:
    force = total(balance(engine(bearing=radians(45)), speed=SPEED)).force
    assert np.degrees(np.angle(at(force, 0))) == pytest.approx(45)
    assert at(force, 0).imag > 0  # to the right


def test_a_weight_at_bearing_90_pushes_right() -> None:
    force = of_weights(balance(engine(Weight(unbalance=0.02, angle=pi / 2)), speed=SPEED)).force
    assert at(force, 0) == pytest.approx(0.02j * SPEED**2)


@ROTATIONS
def test_turning_clockwise_takes_up_to_right_and_turning_counter_clockwise_takes_up_to_left(
    rotation: str,
) -> None:
    force = of_weights(
        balance(engine(Weight(unbalance=0.02, angle=0.0), rotation=rotation), speed=SPEED)
    ).force
    side = 1 if rotation == "clockwise" else -1
    assert at(force, 0) == pytest.approx(0.02 * SPEED**2)
    assert at(force, 90) == pytest.approx(side * 0.02j * SPEED**2, abs=1e-9)


@ROTATIONS
def test_what_turns_with_the_crankshaft_is_forward_whichever_way_it_turns(rotation: str) -> None:
    force = of_weights(
        balance(engine(Weight(unbalance=0.02, angle=0.3), rotation=rotation), speed=SPEED)
    ).force
    assert abs(spectra.selected(force, 1).forward[0]) == pytest.approx(200)
    assert not np.any(force.backward)


@ROTATIONS
def test_a_piston_is_half_forward_and_half_backward(rotation: str) -> None:
    first = spectra.selected(
        total(balance(engine(bearing=0.7, rotation=rotation), speed=SPEED)).force, 1
    )
    assert abs(first.forward[0]) == pytest.approx(FORCE / 2)
    assert abs(first.backward[0]) == pytest.approx(FORCE / 2)


@ROTATIONS
def test_the_exponents_are_those_of_the_page(rotation: str) -> None:
    force = total(balance(engine(bearing=0.7, offset=0.01, rotation=rotation), speed=SPEED)).force
    theta, sign = 0.4, 1j if rotation == "clockwise" else -1j
    written = sum(
        f * np.exp(sign * k * theta) + b * np.exp(-sign * k * theta)
        for k, f, b in zip(force.orders, force.forward, force.backward, strict=True)
    )
    assert complex(spectra.value(force, theta)) == pytest.approx(complex(written))


def test_an_amplitude_with_a_phase_is_a_cosine_of_the_crank_angle() -> None:
    """`a ∠ p` up means a cos(k theta + p) up; the phase leads."""
    for rotation in ("clockwise", "counter-clockwise"):
        second = spectra.selected(
            total(balance(engine(bearing=0.7, offset=0.01, rotation=rotation), speed=SPEED)).force,
            2,
        )
        up, right = complex(spectra.vertical(second)[0]), complex(spectra.horizontal(second)[0])
        for theta in (0.0, 0.5, 2.0):
            vector = complex(spectra.value(second, theta))
            assert abs(up) * np.cos(2 * theta + np.angle(up)) == pytest.approx(vector.real)
            assert abs(right) * np.cos(2 * theta + np.angle(right)) == pytest.approx(vector.imag)


def test_a_cylinder_in_front_of_the_reference_that_pushes_up_gives_a_couple_up() -> None:
    front = engine(z=0.1)
    force = total(balance(front, speed=SPEED)).force
    couple = total(balance(front, speed=SPEED, reference=Reference(0.0))).couple
    assert at(couple, 0) == pytest.approx(0.1 * at(force, 0))
    behind = total(balance(front, speed=SPEED, reference=Reference(0.3))).couple
    assert at(behind, 0) == pytest.approx(-0.2 * at(force, 0))


def test_pitch_is_minus_the_couple_up_and_yaw_is_the_couple_right() -> None:
    """With the moment z x F of a right-handed frame: x right, y up, z to the front."""
    tilted = engine(z=0.1, bearing=0.7)
    sums = total(balance(tilted, speed=SPEED, reference=Reference(0.0)))
    force, couple = at(sums.force, 20), at(sums.couple, 20)
    about_right, about_up, _ = np.cross([0, 0, 0.1], [force.imag, force.real, 0])
    assert about_right == pytest.approx(-couple.real)
    assert about_up == pytest.approx(couple.imag)


def geared(right: float, up: float, weight_angle: float) -> Engine:
    """One cylinder, and a balance shaft with one weight beside or above the crankshaft."""
    plain = engine()
    weight = Weight(unbalance=0.02, angle=weight_angle)
    other = Shaft(
        name="balance shaft", speed_ratio=Fraction(-1), right=right, up=up, weights=(weight,)
    )
    return plain.model_copy(update={"shafts": (*plain.shafts, other)})


def test_a_push_up_on_the_right_of_the_axis_rolls_the_engine_counter_clockwise() -> None:
    roll = of_weights(balance(geared(0.1, 0.0, 0.0), speed=SPEED)).axis_moment
    assert at(roll, 0).real == pytest.approx(-0.1 * 0.02 * SPEED**2)


def test_a_push_to_the_right_above_the_axis_rolls_the_engine_clockwise() -> None:
    roll = of_weights(balance(geared(0.0, 0.1, pi / 2), speed=SPEED)).axis_moment
    assert at(roll, 0).real == pytest.approx(0.1 * 0.02 * SPEED**2)


def test_roll_is_taken_about_the_reference_point() -> None:
    around = Reference(0.0, up=0.0, right=0.1)
    assert not np.any(
        of_weights(
            balance(geared(0.1, 0.0, 0.0), speed=SPEED, reference=around)
        ).axis_moment.forward
    )


def test_a_shaft_that_turns_the_other_way_is_all_backward() -> None:
    force = of_weights(balance(geared(0.1, 0.0, 0.0), speed=SPEED)).force
    assert not np.any(force.forward)
    assert at(force, 90) == pytest.approx(-0.02j * SPEED**2)


@ROTATIONS
def test_a_cylinder_on_a_shaft_that_turns_the_other_way_follows_that_shaft(rotation: str) -> None:
    """Its pin is at the right at theta = 0; a clockwise reference crankshaft turns it up."""
    plain = engine(rotation=rotation)
    second = Shaft(
        name="second", speed_ratio=Fraction(-1), throws=(Throw(angle=pi / 2, radius=RADIUS),)
    )
    other = plain.cylinders[0].model_copy(update={"number": 2, "shaft": "second"})
    geared = plain.model_copy(
        update={"shafts": (*plain.shafts, second), "cylinders": (*plain.cylinders, other)}
    )
    top = 90 if rotation == "clockwise" else 270
    assert dead_centres(geared)[2].angle_deg == pytest.approx(top)
    assert at(of_parts(balance(geared, speed=SPEED), cylinder=2).force, top) == pytest.approx(
        FORCE * (1 + RADIUS / ROD), rel=1e-9
    )


@ROTATIONS
def test_a_piston_that_gains_speed_after_top_dead_centre_holds_the_crankshaft_back(
    rotation: str,
) -> None:
    torque = total(balance(engine(rotation=rotation), speed=SPEED)).torque
    assert at(torque, 30).real < 0  # against the direction of rotation
    assert at(torque, 150).real > 0  # and gives it back on the way to bottom dead centre


@ROTATIONS
def test_a_block_without_its_driveline_feels_the_roll_less_the_torque_of_the_crankshaft(
    rotation: str,
) -> None:
    """The whole moment is the side thrust of the piston, worked out from the rod's slant."""
    sums = total(balance(engine(rotation=rotation), speed=SPEED))
    assert not np.any(
        sums.axis_moment.forward
    )  # the mass moves along a line through the axis: no angular momentum
    sense = 1 if rotation == "clockwise" else -1
    theta = np.linspace(0, 2 * pi, 12)
    across = sense * RADIUS * np.sin(theta)
    height = np.sqrt(ROD**2 - across**2)
    push = np.real(spectra.value(sums.force, theta))  # minus mass times acceleration
    thrust = push * across / height  # to the right, on the wall
    moment = thrust * (RADIUS * np.cos(theta) + height)  # clockwise, about the crank axis
    felt = np.real(spectra.value(sums.axis_moment, theta)) - sense * np.real(
        spectra.value(sums.torque, theta)
    )
    assert felt == pytest.approx(moment, abs=1e-9 * FORCE)


def test_a_positive_offset_puts_the_cylinder_axis_on_the_clockwise_side() -> None:
    offset = engine(offset=0.01)
    assert offset.shafts[0].throws[0].angle > 0  # at top dead centre the crank leans clockwise
    sums = total(balance(offset, speed=SPEED))
    assert at(sums.force, 0).real > 0
    assert at(sums.axis_moment, 0).real == pytest.approx(
        -0.01 * at(sums.force, 0).real
    )  # the push is on the right of the axis


def test_a_positive_roll_is_a_negative_moment_about_the_axis_to_the_front() -> None:
    vector = at(of_weights(balance(geared(0.1, 0.05, 0.6), speed=SPEED)).force, 0)
    moment = np.cross([0.1, 0.05, 0], [vector.imag, vector.real, 0])[2]
    assert at(
        of_weights(balance(geared(0.1, 0.05, 0.6), speed=SPEED)).axis_moment, 0
    ).real == pytest.approx(-moment)


@ROTATIONS
@pytest.mark.parametrize("bearing", [0.0, 30.0, -45.0, 90.0])
def test_layouts_draw_the_engine_with_cylinder_1_at_top_dead_centre(
    rotation: str, bearing: float
) -> None:
    banks = (
        Bank(bearing=radians(bearing), cylinders=(1, 3)),
        Bank(bearing=radians(bearing + 90), cylinders=(2, 4)),
    )
    basis = Basis.model_validate(
        {"name": "V4", "rotation": rotation, "cylinder": Sizes(offset=0.1)}
    )
    made = vee(basis, banks=banks, throws=(0.0, pi), bank_offset=0.2)
    assert dead_centres(made)[1].angle_deg == pytest.approx(0, abs=1e-9)
    later = 90 if rotation == "clockwise" else 270
    assert dead_centres(made)[2].angle_deg == pytest.approx(later, abs=1e-9)


def test_cylinder_1_is_frontmost_and_the_reference_is_the_middle_of_the_span() -> None:
    made = inline(Basis(name="three", firing_order=(1, 3, 2), cycle="two-stroke"), bore_pitch=0.1)
    assert [cylinder.z for cylinder in made.cylinders] == pytest.approx([0.1, 0.0, -0.1])
    assert balance(made).reference == Reference(0.0)
    shifted = made.model_copy(
        update={"cylinders": tuple(c.model_copy(update={"z": c.z + 1}) for c in made.cylinders)}
    )
    assert balance(shifted).reference.z == pytest.approx(1.0)


def test_the_ellipse_has_the_sum_and_the_difference_of_the_two_vectors_as_its_axes() -> None:
    for forward, backward in product((2.0, 1j, 0.5 - 1j), (0.25, -0.7j)):
        path = spectra.value(
            Spectrum(np.array([1.0]), np.array([forward]), np.array([backward])),
            np.linspace(0, 2 * pi, 3601),
        )
        found = spectra.ellipse(forward, backward)
        assert np.abs(path).max() == pytest.approx(found.semi_major, rel=1e-5)
        assert np.abs(path).min() == pytest.approx(found.semi_minor, rel=1e-5)
        longest = path[np.argmax(np.abs(path))]
        assert abs(np.sin(np.angle(longest) - found.bearing)) < 2e-3
        turned = np.sum(np.diff(np.unwrap(np.angle(path))))
        assert np.sign(turned) == found.sense


def test_normalised_numbers_are_counted_in_the_mass_radius_and_pitch_of_the_first_cylinder() -> (
    None
):
    sizes = Sizes(stroke=0.08, rod_length=ROD, reciprocating_mass=MASS)
    made = inline(Basis(name="two", cylinder=sizes), throws=(0.0, pi), bore_pitch=0.1)
    plain, real = total(balance(made)), total(balance(made, speed=SPEED))
    assert real.force.forward == pytest.approx(plain.force.forward * FORCE)
    assert real.couple.forward == pytest.approx(plain.couple.forward * FORCE * 0.1)
    assert real.torque.forward == pytest.approx(plain.torque.forward * FORCE * RADIUS)


@pytest.mark.parametrize("mass", [MASS, 0.0])
def test_the_unit_of_mass_is_all_that_goes_up_and_down_whatever_the_rods(mass: float) -> None:
    rod = Rod(mass=0.6, centre=0.04, inertia=0.002)
    whole = engine(cylinders=(with_values(engine().first, rod=rod, reciprocating_mass=mass),))
    assert unit_unbalance(whole) == pytest.approx((mass + 0.6 * 0.04 / ROD) * RADIUS)
    second = spectra.selected(total(balance(whole)).force, [2.0])
    alone = piston_harmonics(crank_radius=RADIUS, rod_length=ROD)[2]
    assert spectra.peak(second).value == pytest.approx(abs(alone))


def test_orders_are_counted_in_turns_of_the_reference_crankshaft() -> None:
    camshaft = Shaft(
        name="cam", speed_ratio=Fraction(1, 2), weights=(Weight(unbalance=0.01, angle=0.0),)
    )
    half = engine().model_copy(update={"shafts": (*engine().shafts, camshaft)})
    force = part_spectra(mechanism(half)).force
    slow = spectra.selected(
        Spectrum(force.orders, force.forward[-1], force.backward[-1]), [0.5, 1.0]
    )
    assert np.abs(slow.forward) == pytest.approx([0.01 / 4, 0.0])


def test_opposed_pistons_that_lie_are_those_that_stand_turned_a_quarter() -> None:
    basis = Basis(name="opposed", cycle="two-stroke")
    standing, lying = (
        opposed(basis, throws=(0.0, 2.0), crank_distance=12.0, lag=0.2, bearing=bearing)
        for bearing in (0.0, pi / 2)
    )
    assert [(shaft.up, shaft.right) for shaft in standing.shafts] == [(0, 0), (12, 0)]
    assert [(shaft.up, shaft.right) for shaft in lying.shafts] == [(0, 0), (0, 12)]
    for quantity in ("force", "couple"):
        stands, lies = (getattr(total(balance(engine)), quantity) for engine in (standing, lying))
        assert np.abs(spectra.turned(stands, pi / 2).forward - lies.forward).max() < 1e-12
        assert np.abs(spectra.turned(stands, pi / 2).backward - lies.backward).max() < 1e-12


@pytest.mark.parametrize("ratio", [1, -1])
def test_opposed_pistons_in_step_leave_no_force(ratio: int) -> None:
    basis = Basis(name="opposed", cycle="two-stroke")
    engine = opposed(
        basis, throws=(0.0, 2.0, 4.0), crank_distance=12.0, speed_ratio=Fraction(ratio)
    )
    force = total(balance(engine)).force
    assert max(np.abs(force.forward).max(), np.abs(force.backward).max()) < 1e-12


def test_the_rotating_mass_of_a_slave_rod_is_at_its_knuckle_pin() -> None:
    sizes = Sizes(rotating_mass=0.3)
    basis = Basis(name="star", cycle="two-stroke", cylinder=sizes)
    star = radial(basis, rows=(Row(cylinders=(1, 2, 3)),), knuckle_radius=0.5)
    assert [cylinder.big_end_mass for cylinder in star.cylinders] == [0.0, 0.3, 0.3]
    assert [throw.rotating_mass for throw in star.shafts[0].throws] == [0.3]
