"""A free engine: its centre of mass and its angular momentum are constant; engines that whirl."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.newton import Rate, Road, road
from tests.strategies import PLACES, engines, number

import crankstar
from crankstar import spectra
from crankstar.dynamics import whirl
from crankstar.dynamics.whirl import Body
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Block, Rod
from crankstar.mechanics.balance import Reference

TOLERANCE = 1e-9
PARTS = st.tuples(number(0.1, 20.0), number(0.1, 20.0), number(0.1, 20.0))
BODIES = st.builds(
    lambda mass, centre, parts: Body(
        mass, centre, (parts[0] + parts[1], parts[1] + parts[2], parts[2] + parts[0])
    ),
    number(20.0, 900.0),
    st.tuples(PLACES, PLACES, PLACES),
    PARTS,
)


def varying(samples: np.ndarray) -> np.ndarray:
    """What is left when the mean over the period is taken away."""
    return samples - samples.mean(axis=0)


def moments(walked: Road, body: Body) -> tuple[np.ndarray, np.ndarray, float]:
    """Sums of m r and m r z over the moving bodies, as `up + i*right`, and the greatest m r."""
    first = np.zeros(len(walked.theta), np.clongdouble)
    second = np.zeros(len(walked.theta), np.clongdouble)
    whole = 0.0
    for part in walked.bodies:
        moved = varying(part.mass * (part.centre[:, 1] + 1j * part.centre[:, 0]))
        first += moved
        second += (part.z - body.centre[2]) * moved
        whole = max(whole, float(np.abs(moved).max()))
    return first, second, whole


def angular(walked: Road, body: Body, sense: int) -> tuple[np.ndarray, float]:
    """Clockwise angular momentum of moving bodies and flywheel about the centre of mass.

    At 1 rad/s; the flywheel takes the kinetic energy that the parts lose.
    """
    turns = round(float(walked.theta[1] * len(walked.theta) / (2 * np.pi)))
    rate = Rate(turns, len(walked.theta))
    up, right, _ = body.centre
    out, whole = np.zeros(len(walked.theta), np.longdouble), 0.0
    for part in walked.bodies:
        velocity, spin = rate(part.centre), rate(part.counter_clockwise)
        arm = part.centre + np.array(part.axis) - np.array([right, up])
        moved = (
            part.mass * (arm[:, 1] * velocity[:, 0] - arm[:, 0] * velocity[:, 1])
            - part.inertia * spin
        )
        energy = part.mass * np.sum(velocity**2, axis=1) / 2 + part.inertia * spin**2 / 2
        out += varying(moved) - sense * varying(energy)
        whole = max(whole, float(np.abs(moved).max()), float(np.abs(energy).max()))
    return out, whole


@pytest.mark.release
@given(engines(known=True), BODIES)
def test_centre_of_mass_and_angular_momentum_stay_what_they_were(
    engine: Engine, body: Body
) -> None:
    walked = road(engine, reference=Reference(0.0), speed=1.0)
    found = whirl.response(engine, of=body)
    few = slice(None, None, max(1, len(walked.theta) // 50))
    theta = walked.theta[few].astype(float)
    first, second, whole = (
        part[few] if isinstance(part, np.ndarray) else part for part in moments(walked, body)
    )
    shift, tilt = spectra.value(found.shift, theta), spectra.value(found.tilt, theta)
    assert np.abs(body.mass * shift + first).max() <= TOLERANCE * whole
    about_up, about_right, about_z = body.inertia
    swung = about_right * np.real(tilt) + 1j * about_up * np.imag(tilt)
    reach = max(abs(part.z - body.centre[2]) for part in walked.bodies) + 1e-3
    assert np.abs(swung + second).max() <= TOLERANCE * whole * reach
    turning = spectra.real_signal(
        found.turn.orders, 1j * found.turn.orders * spectra.amplitude(found.turn)
    )
    spun, most = angular(walked, body, engine.sense)
    assert (
        np.abs(about_z * np.real(spectra.value(turning, theta)) + spun[few]).max()
        <= 10 * TOLERANCE * most
    )


def axes(found: whirl.Response, order: float) -> tuple[float, float]:
    tilt = spectra.selected(found.tilt, order)
    path = spectra.ellipse(complex(tilt.forward[0]), complex(tilt.backward[0]))
    return path.semi_major, path.semi_minor


@pytest.mark.parametrize("name", ["v8-cross-plane", "ford-coyote", "toyota-1uz-fe"])
def test_a_cross_plane_v8_whirls_in_a_circle_about_its_middle(name: str) -> None:
    engine = crankstar.load(name)
    found = whirl.response(engine, of=whirl.body(engine))
    long, short = axes(found, 1.0)
    assert long > 0
    assert short == pytest.approx(long, rel=0.01)
    first = spectra.selected(found.shift, 1.0)
    assert np.abs(first.forward[0]) + np.abs(first.backward[0]) < 1e-9 * long


def test_a_cross_plane_v8_whirls_as_far_as_its_couple_says() -> None:
    """The couple sqrt(10) m r a about the middle, by hand, over the inertia of the box; order 1."""
    engine = crankstar.load("v8-cross-plane")
    body = whirl.body(engine)
    pistons, bore = 8.0, 2.0  # a bore that is not known is a stroke
    corner = (1 + engine.first.rod_length + bore + bore / 2) / 2**0.5
    sides = (corner + 2.0, 2 * corner, 3.2 + bore)
    assert whirl.outline(engine) == pytest.approx(sides)
    assert body.mass == pytest.approx(55 * pistons)
    up, right, along = (body.mass * share for share in walls(*sides))
    assert body.inertia == pytest.approx(((up + right) / 2, (up + right) / 2, along), rel=1e-4)
    long, _ = axes(whirl.response(engine, of=body), 1.0)
    assert long * body.inertia[1] == pytest.approx(10**0.5, rel=1e-9)


def walls(a: float, b: float, c: float) -> list[float]:
    """The moments of inertia per mass of the walls of a box, from points on them."""
    number = 300
    grid = (np.arange(number) + 0.5) / number - 0.5
    squares, areas = np.zeros(3), 0.0
    for axis, area in enumerate((b * c, c * a, a * b)):
        places = np.stack(np.meshgrid(*np.repeat(grid[None], 2, axis=0)), axis=-1).reshape(-1, 2)
        sheet = np.insert(places, axis, 0.5, axis=1) * [a, b, c]
        squares += area * (sheet**2).mean(axis=0)
        areas += area
    return [float((squares.sum() - own) / areas) for own in squares]


def test_a_heavy_flat_engine_makes_an_ellipse_of_a_round_couple() -> None:
    engine = crankstar.load("v8-cross-plane")
    box = whirl.body(engine)
    flat = Body(box.mass, box.centre, (3 * box.inertia[0], box.inertia[1], box.inertia[2]))
    long, short = axes(whirl.response(engine, of=flat), 1.0)
    assert long == pytest.approx(3 * short)


def test_the_block_of_a_file_is_what_answers_and_what_it_leaves_out_is_told() -> None:
    engine = crankstar.load("audi-25-tfsi")
    assert "a box about cylinders and crankcase" in whirl.body(engine).assumed[0]
    known = Block(
        mass=180.0, up=0.1, right=-0.01, z=0.02, inertia_up=11.0, inertia_right=12.0, inertia_z=5.0
    )
    body = whirl.body(engine.model_copy(update={"block": known}))
    assert body == Body(180.0, (0.1, -0.01, 0.02), (11.0, 12.0, 5.0))
    weighed = whirl.body(engine.model_copy(update={"block": Block(mass=180.0)}))
    assert weighed.mass == 180.0
    assert weighed.inertia[0] == weighed.inertia[1]
    assert "moments of inertia" in weighed.assumed[0]


def test_lengths_along_a_shaft_of_unknown_pitch_are_counted_in_units_across() -> None:
    """The same engine twice: the unit of length along the shaft is `along` units across it."""
    engine = crankstar.load("i4")
    along = 2.36
    body = whirl.body(engine, along=along)
    assert body.centre == (0.0, 0.0, 0.0)
    stretched = engine.model_copy(
        update={
            "shafts": tuple(
                shaft.model_copy(
                    update={
                        "throws": tuple(
                            throw.model_copy(update={"z": throw.z * along})
                            for throw in shaft.throws
                        )
                    }
                )
                for shaft in engine.shafts
            ),
            "cylinders": tuple(c.model_copy(update={"z": c.z * along}) for c in engine.cylinders),
        }
    )
    assert whirl.body(stretched) == body
    shifted = Body(body.mass, (0.0, 0.0, 1.5), body.inertia)
    one, other = (
        whirl.response(engine, of=shifted, along=along),
        whirl.response(stretched, of=shifted),
    )
    for name in ("shift", "tilt", "turn"):
        assert np.allclose(
            getattr(one, name).forward, getattr(other, name).forward, rtol=1e-12, atol=1e-15
        )
    block = Block(mass=180.0, up=0.1, right=-0.01, z=0.4)
    there = whirl.body(with_values(engine, block=block), along=along)
    assert there.centre == pytest.approx((0.1, -0.01, 0.4 * along))
    assert there == whirl.body(
        with_values(stretched, block=with_values(block, z=0.4 * along)), along=1.0
    )


def test_a_third_of_a_rod_counts_as_reciprocating_in_the_estimated_mass() -> None:
    """A third of a slender rod's mass is where its piston pin is, by the inertia about its end."""
    length, mass = 0.15, 0.6
    samples = (np.arange(100_000) + 0.5) / 100_000
    share = float((samples**2).mean())
    rod = Rod(mass=mass, centre=length / 2, inertia=mass * length**2 / 12)
    engine = crankstar.load("audi-25-tfsi")
    cylinders = [
        with_values(c, rod=rod, reciprocating_mass=0.4, bore=None) for c in engine.cylinders
    ]
    with_rods = whirl.body(with_values(engine, cylinders=tuple(cylinders)))
    assert with_rods.mass == pytest.approx(
        whirl.MASS_TO_PISTONS * len(cylinders) * (0.4 + share * mass), rel=1e-6
    )


KNOWN = [
    (2.0, 138.0, 4 * 0.48),  # in-line four, weighed
    (2.97, 225.0, 6 * 0.52),  # V6 with its gearbox
    (5.0, 210.0, 8 * 0.65),
    (2.48, 183.0, 5 * (0.492 + 0.18)),  # Audi 2.5 TFSI
]
"""Displacement (l), mass of the engine and of its reciprocating parts (kg)."""


@pytest.mark.parametrize(("litres", "mass", "pistons"), KNOWN)
def test_known_engines_are_within_both_estimates_of_the_mass(
    litres: float, mass: float, pistons: float
) -> None:
    """By volume and by reciprocating mass, pi/4 D^2 s being the displacement of a cylinder."""
    engine = crankstar.load("audi-25-tfsi")
    count = len(engine.cylinders)
    bore = (4 * litres / 1e3 / count / (np.pi * 2 * engine.shafts[0].throws[0].radius)) ** 0.5
    low, high = whirl.MASS_ENDS
    for own in (float(bore), None):
        cylinders = [
            with_values(c, bore=own, rod=None, reciprocating_mass=pistons / count)
            for c in engine.cylinders
        ]
        usual, by_volume = whirl.estimated_mass(with_values(engine, cylinders=tuple(cylinders)))
        assert by_volume == (own is not None)
        assert usual == pytest.approx(70 * litres if by_volume else 55 * pistons)
        assert low * usual < mass < high * usual
