"""Newton's second law: the excitation is minus the rate of change of the bodies' momentum."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.newton import Push, Road, road
from tests.strategies import OF_ANY_KIND, PLACES, RELEASE, SPEEDS, engines

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft
from crankstar.mechanics.balance import Reference, Totals, balance, grouped, total

TOLERANCE = 1e-9
"""Of the largest part; a moment counts at least as the largest force at the crank radius."""

REFERENCES = st.builds(Reference, PLACES, PLACES, PLACES)


class Scale(NamedTuple):
    """In what a Balance is counted."""

    force: float
    couple: float
    roll: float


def units_of(engine: Engine, speed: float) -> Scale:
    """N and N m where masses and sizes are known, else m r w^2 of the first cylinder.

    Couples are per pitch where that is unknown.
    """
    if "mass" not in engine.relative and "radius" not in engine.relative:
        return Scale(1.0, engine.pitch if "pitch" in engine.relative else 1.0, 1.0)
    first = min(engine.cylinders, key=lambda cylinder: cylinder.number)
    shaft = next(shaft for shaft in engine.shafts if shaft.name == first.shaft)
    rod, radius = first.rod, shaft.throws[first.throw - 1].radius
    small_end = max(rod.mass * rod.centre / first.rod_length, 0.0) if rod else 0.0
    mass = first.reciprocating_mass + small_end or (rod.mass if rod else 1.0)
    force = mass * radius * speed**2
    return Scale(force, force * engine.pitch, force * radius)


def assert_same(
    told: Totals,
    walked: Road,
    chosen: Sequence[int],
    scale: Scale,
    radius: float,
    *,
    angles: int = 40,
) -> None:
    """The package's totals of some parts agree with the motion of their bodies."""
    few = np.unique(np.linspace(0, len(walked.theta) - 1, angles).astype(int))
    theta = walked.theta[few].astype(float)
    force, moment, torque = np.zeros((len(few), 3)), np.zeros((len(few), 3)), np.zeros(len(few))
    for index in chosen:
        force = force + walked.pushes[index].force[few]
        moment = moment + walked.pushes[index].moment[few]
        torque = torque + walked.pushes[index].torque[few]
    push, bend, twist, work = largest(walked.pushes, radius)
    vector, couple = (
        spectra.value(told.force, theta) * scale.force,
        spectra.value(told.couple, theta) * scale.couple,
    )
    roll, drive = (
        spectra.value(told.axis_moment, theta) * scale.roll,
        spectra.value(told.torque, theta) * scale.roll,
    )
    for name, found, expected, whole in (
        ("force to the right", vector.imag, force[:, 0], push),
        ("force upward", vector.real, force[:, 1], push),
        ("force along the shaft", 0.0, force[:, 2], push),
        ("pitch about the right axis", -couple.real, moment[:, 0], bend),
        ("yaw about the up axis", couple.imag, moment[:, 1], bend),
        ("clockwise roll", roll, -moment[:, 2], twist),
        ("torque", drive, torque, work),
    ):
        wrong = np.abs(found - expected).max()
        assert wrong <= TOLERANCE * whole, f"{name}: {wrong:.3g} wrong, largest part {whole:.3g}"


def largest(pushes: Sequence[Push], radius: float) -> tuple[float, float, float, float]:
    """The greatest force, bending moment, roll and torque of any one body."""
    force = float(max(np.abs(push.force).max() for push in pushes))
    bend = float(max(np.abs(push.moment[:, :2]).max() for push in pushes))
    twist = float(max(np.abs(push.moment[:, 2]).max() for push in pushes))
    work = float(max(np.abs(push.torque).max() for push in pushes))
    return force, bend, max(twist, force * radius), max(work, force * radius)


def assert_momentum(engine: Engine, *, reference: Reference, speed: float) -> None:
    """The whole engine, and its parts by cylinder, by shaft and by kind."""
    walked, scale = road(engine, reference=reference, speed=speed), units_of(engine, speed)
    radius = max(throw.radius for shaft in engine.shafts for throw in shaft.throws)
    result = balance(engine, speed=speed, reference=reference)
    assert_same(total(result), walked, range(len(walked.bodies)), scale, radius, angles=150)
    for by in ("cylinder", "shaft", "kind"):
        for label, told in grouped(result, by).items():
            chosen = [
                index for index, body in enumerate(walked.bodies) if getattr(body, by) == label
            ]
            assert_same(told, walked, chosen, scale, radius)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("kind", OF_ANY_KIND)
@settings(max_examples=60 if RELEASE else 5)
@given(data=st.data(), reference=REFERENCES, speed=SPEEDS)
def test_the_block_feels_the_rate_of_change_of_momentum(
    kind: str, data: st.DataObject, reference: Reference, speed: float
) -> None:
    assert_momentum(data.draw(OF_ANY_KIND[kind]), reference=reference, speed=speed)


@pytest.mark.release
@pytest.mark.parametrize("kind", OF_ANY_KIND)
@settings(max_examples=150)
@given(data=st.data(), reference=REFERENCES, speed=SPEEDS)
def test_the_block_of_every_layout_feels_it(
    kind: str, data: st.DataObject, reference: Reference, speed: float
) -> None:
    assert_momentum(data.draw(OF_ANY_KIND[kind]), reference=reference, speed=speed)


@pytest.mark.release
@settings(max_examples=500)
@given(engines(), REFERENCES, SPEEDS)
def test_the_block_of_hundreds_of_engines_feels_it(
    engine: Engine, reference: Reference, speed: float
) -> None:
    assert_momentum(engine, reference=reference, speed=speed)


def single(
    *,
    rotation: str = "clockwise",
    reciprocating_mass: float = 0.0,
    throw: Any = None,
    weight: Any = None,
    **cylinder: Any,
) -> Engine:
    """One cylinder with a crank radius of 1 m and a rod of 4 m, at first without any mass."""
    shaft = Shaft.model_validate(
        {
            "name": "crank",
            "throw": [{"angle": 0.0, "radius": 1.0, **(throw or {})}],
            "weight": [weight] if weight else [],
        }
    )
    only = Cylinder.model_validate(
        {
            "number": 1,
            "shaft": "crank",
            "throw": 1,
            "rod_length": 4.0,
            "reciprocating_mass": reciprocating_mass,
            **cylinder,
        }
    )
    return Engine.model_validate(
        {
            "name": "single",
            "rotation": rotation,
            "relative": ("mass",),
            "shafts": [shaft],
            "cylinders": [only],
        }
    )


def felt(engine: Engine, theta: float, *, z: float = 0.0) -> tuple[complex, complex, float, float]:
    """Force, couple, roll and torque in m r w^2 and so on, at one crank angle."""
    whole = total(balance(engine, reference=Reference(z)))
    force, couple, roll, torque = (complex(spectra.value(part, theta)) for part in whole)
    return force, couple, roll.real, torque.real


@pytest.mark.parametrize(("rotation", "side"), [("clockwise", 1), ("counter-clockwise", -1)])
def test_a_pin_a_quarter_turn_on_pulls_to_the_right_in_an_engine_that_turns_clockwise(
    rotation: str, side: int
) -> None:
    engine = single(rotation=rotation, throw={"rotating_mass": 2.0, "z": 3.0})
    force, couple, roll, torque = felt(engine, pi / 2, z=1.0)
    assert force == pytest.approx(2j * side)
    # r x F with r = 2 m to the front and F to the right turns the front of the engine to the right:
    # yaw about the up axis.
    moment = np.cross([0.0, 0.0, 3.0 - 1.0], [force.imag, force.real, 0.0])
    assert moment == pytest.approx([-couple.real, couple.imag, 0.0])
    assert couple == pytest.approx(4j * side)
    assert (roll, torque) == (0, 0)


def test_a_piston_at_top_dead_centre_pulls_outward_by_one_plus_lambda() -> None:
    bearing = 0.6
    force, _, roll, torque = felt(
        single(reciprocating_mass=3.0, throw={"angle": bearing}, bearing=bearing), 0.0
    )
    assert force == pytest.approx(
        (1 + 1 / 4) * complex(cos(bearing), sin(bearing))
    )  # counted in m r w^2 of this cylinder
    assert (roll, torque) == pytest.approx((0, 0), abs=1e-12)


def test_a_piston_offset_to_the_right_that_pulls_up_rolls_the_block_counter_clockwise() -> None:
    force, _, roll, _ = felt(single(reciprocating_mass=1.0, offset=0.5), 0.0)
    assert force.real > 1
    assert roll == pytest.approx(-0.5 * force.real)


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_the_crankshaft_is_held_back_while_the_piston_gathers_speed(rotation: str) -> None:
    engine = single(rotation=rotation, reciprocating_mass=1.0)
    assert felt(engine, 0.5)[3] < 0  # after top dead centre
    assert felt(engine, pi - 0.5)[3] > 0  # before the bottom


@pytest.mark.parametrize(("rotation", "side"), [("clockwise", 1), ("counter-clockwise", -1)])
def test_a_rod_that_swings_over_at_top_dead_centre_has_no_moment_there_but_a_quarter_turn_on(
    rotation: str, side: int
) -> None:
    # The rod leans away from its pin, b = -side arcsin(sin(theta)/4), and the block feels -I b''.
    # Roll is counted in m r^2 w^2.
    mass = 1e-9
    engine = single(rotation=rotation, rod={"mass": mass, "centre": 0.0, "inertia": 1.0})
    assert felt(engine, 0.0)[2] * mass == pytest.approx(0, abs=1e-9)
    assert felt(engine, pi / 2)[2] * mass == pytest.approx(-side / 15**0.5, abs=1e-6)
