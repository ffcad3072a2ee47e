"""Loads on main bearings: they carry all that shakes the block; bending by a second road."""

from __future__ import annotations

from collections import defaultdict
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from tests.catalog import EVERY_ENGINE
from tests.newton import placed
from tests.strategies import OF_ANY_KIND

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import Model, bearing_loads, bearing_shares, bending_moment
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings
from crankstar.engine.records import Rod
from crankstar.mechanics.balance import unit_unbalance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import pin_loads
from crankstar.remedy import bearing_load, with_web_weights

MODELS = get_args(Model)
TOLERANCE = 1e-9


def vector(values: Any) -> NDArray[Any]:
    return np.asarray(values, complex)


def assert_carried(engine: Engine, model: Model) -> None:
    """Bearing loads and guide forces are force, couple and moment of the balance."""
    reference = Reference(0.3, 0.2, -0.1)
    speed = 100.0
    loads = bearing_loads(engine, speed=speed, model=model)
    balance = crankstar.balance(engine, speed=loads.speed, reference=reference)
    sums = crankstar.total(balance)
    theta = np.linspace(0, 2 * np.pi * spectra.period(sums.force), 37)
    load = vector(spectra.value(loads.load, theta))
    guide = vector(spectra.value(loads.guide, theta))
    pins = vector(spectra.value(loads.pin, theta))
    scale = 1.0 if loads.unit == "N" else 1 / unit_unbalance(engine)
    arm = np.array([bearing.z for bearing in loads.bearings]) - reference.z
    side = np.array([cylinder.z for cylinder in engine.cylinders]) - reference.z
    size = np.abs(load).max() + np.abs(guide).max() + np.abs(pins).max()
    force = load.sum(axis=0) + guide.sum(axis=0)
    assert np.abs(force - spectra.value(sums.force, theta)).max() <= TOLERANCE * size

    couple = arm @ load + side @ guide
    pitch = 1.0 if balance.units.couple == "N*m" else engine.pitch
    expected = spectra.value(sums.couple, theta) * pitch
    reach = np.abs(arm).max() + np.abs(side).max()
    assert np.abs(couple - expected).max() <= TOLERANCE * size * max(reach, pitch)

    # moment about the axis: of bearings and walls, and what turns the shafts at the pins
    moment = np.zeros(theta.size)
    span = 0.0
    for shaft, row in zip(loads.bearings, load, strict=True):
        axis = engine.shaft(shaft.shaft)
        place = axis.up + 1j * axis.right - complex(reference.up, reference.right)
        moment += np.imag(np.conj(place) * row)
        span = max(span, abs(place))
    own = spectra.value(spectra.scaled(_pin(engine), scale * (loads.speed or 1.0) ** 2), theta)
    for cylinder, wall in zip(engine.cylinders, guide, strict=True):
        axis = engine.shaft(cylinder.shaft)
        base = axis.up + 1j * axis.right
        pin, piston, _ = placed(engine, cylinder, theta.astype(np.longdouble))
        at_pin, at_wall = (_clock(points) for points in (pin, piston))
        moment += np.imag(np.conj(at_wall + base - complex(reference.up, reference.right)) * wall)
        if cylinder.articulated is None:
            moment += np.imag(np.conj(at_pin) * _of_group(engine, cylinder.number, vector(own)))
        span = max(span, float(np.abs(at_wall).max()))
    unit = {"N*m": 1.0, "m*r^2*w^2": engine.throw(engine.first).radius}[balance.units.moment]
    expected = np.real(spectra.value(sums.axis_moment, theta)) * unit
    assert np.abs(moment - expected).max() <= 10 * TOLERANCE * size * span


def _pin(engine: Engine) -> Any:
    return pin_loads(mechanism(engine)).pin


def _of_group(engine: Engine, master: int, own: NDArray[Any]) -> NDArray[Any]:
    """What the rods that work through one master put on the crank pin."""
    links = {c.number: c.articulated.master for c in engine.cylinders if c.articulated}

    def root(number: int) -> int:
        return root(links[number]) if number in links else number

    rows = [row for row, c in enumerate(engine.cylinders) if root(c.number) == master]
    return own[rows].sum(axis=0)


def _clock(points: NDArray[Any]) -> NDArray[Any]:
    return (points[..., 1] + 1j * points[..., 0]).astype(complex)


@pytest.mark.parametrize("model", MODELS)
@EVERY_ENGINE
def test_bearings_and_walls_carry_what_shakes_the_block(name: str, model: Model) -> None:
    assert_carried(crankstar.load(name), model)


@pytest.mark.release
@pytest.mark.parametrize("kind", OF_ANY_KIND)
def test_bearings_and_walls_of_any_engine_carry_what_shakes_it(kind: str) -> None:
    @settings(max_examples=8, deadline=None)
    @given(engine=OF_ANY_KIND[kind], model=st.sampled_from(MODELS))
    def holds(engine: Engine, model: Model) -> None:
        assert_carried(engine, model)

    holds()


@pytest.mark.many(first=12)
@pytest.mark.parametrize("model", [None, *MODELS])
@pytest.mark.parametrize("name", ["v8-cross-plane", "boxer-6", "i4", "v2-90", "vw-vr6"])
def test_the_bending_moment_is_the_integral_of_the_shear_force(
    name: str, model: Model | None
) -> None:
    """dM/dz is minus the sum of all in front; the loads are those of `bearing_loads`."""
    engine = with_web_weights(crankstar.load(name), factor=0.4)
    bending = bending_moment(engine, model=model)
    theta = np.linspace(0, 2 * np.pi, 13)
    moment = vector(spectra.value(bending.moment, theta))
    z = np.array(bending.z)
    loads = bearing_loads(engine, model=model or "determinate")
    forces = [(c.z, f) for c, f in zip(engine.cylinders, _on_crank(engine, theta), strict=True)]
    unit = engine.first.reciprocating_mass * engine.throw(engine.first).radius
    shaft = engine.shafts[0]
    turn = np.exp(1j * engine.sense * theta)
    for throw in shaft.throws:
        own = throw.rotating_mass * throw.radius / unit * np.exp(1j * throw.angle)
        forces.append((throw.z, own * turn))
    forces += [
        (weight.z, weight.unbalance / unit * np.exp(1j * weight.angle) * turn)
        for weight in shaft.weights
    ]
    if model is not None:
        push = vector(spectra.value(loads.load, theta))
        forces += [(b.z, -row) for b, row in zip(loads.bearings, push, strict=True)]
    else:
        front, rear = loads.bearings[0].z, loads.bearings[-1].z
        at_front = sum((place - rear) * force for place, force in forces) / (front - rear)
        forces += [(front, -at_front), (rear, at_front - sum(force for _, force in forces))]
    middle = (z[1:] + z[:-1]) / 2
    shear = np.array([sum((f for at, f in forces if at > place), 0 * turn) for place in middle])
    stepped = -np.diff(z)[:, None] * shear
    summed = np.concatenate([[0 * turn], np.cumsum(stepped, axis=0)]) / engine.pitch
    assert moment == pytest.approx(summed, abs=1e-9)
    assert np.abs(moment[0]).max() < 1e-9
    assert np.abs(moment[-1]).max() < 1e-9
    if model == "determinate":
        for bearing in loads.bearings:
            assert np.abs(moment[np.argmin(np.abs(z - bearing.z))]).max() < 1e-9


def _on_crank(engine: Engine, theta: NDArray[Any]) -> NDArray[Any]:
    return vector(spectra.value(spectra.scaled(_pin(engine), 1 / unit_unbalance(engine)), theta))


def test_a_cross_plane_v8_bends_inside_though_its_forces_cancel() -> None:
    """Throws 1 to 4 at 0, 90, 270, 180 deg, one unit each, on bearings at 2 and -2: by hand.

    The couple about the middle is 3 + i, so the front bearing carries (3 + i)/4.
    """
    engine = crankstar.load("v8-cross-plane")
    heavy = tuple(with_values(c, reciprocating_mass=1e-6) for c in engine.cylinders)
    throws = tuple(with_values(t, rotating_mass=1.0) for t in engine.shafts[0].throws)
    shaft = with_values(engine.shafts[0], throws=throws)
    engine = with_values(engine, cylinders=heavy, shafts=(shaft,))
    bending = bending_moment(engine)
    first = spectra.selected(bending.moment, 1)
    size = np.abs(first.forward[:, 0]) * 1e-6
    at = {round(z, 6): s for z, s in zip(bending.z, size, strict=True)}
    carried = (3 + 1j) / 4
    assert at[0.5] == pytest.approx(abs(1 - 1.5 * carried), rel=1e-4)
    assert at[-0.5] == pytest.approx(abs(2 + 1j - 2.5 * carried), rel=1e-4)
    assert at[-1.5] == pytest.approx(abs(3 + 1j - 3.5 * carried), rel=1e-4)


def test_stiff_supports_approach_rigid_ones_and_soft_ones_share_evenly() -> None:
    engine = crankstar.load("i4")
    shaft = engine.shafts[0]

    def peaks(support: float) -> NDArray[Any]:
        own = with_values(shaft, bending_stiffness=1.0, bearing_stiffness=support)
        changed = with_values(engine, shafts=(own,))
        return spectra.peaks(bearing_loads(changed, model="continuous").load)

    rigid = spectra.peaks(bearing_loads(engine, model="continuous").load)
    assert peaks(1e9) == pytest.approx(rigid, rel=1e-5)
    assert peaks(1e-2) != pytest.approx(rigid, rel=0.1)


@pytest.mark.parametrize("support", [1e6, 1e8])
def test_springs_below_a_beam_share_as_by_hand(support: float) -> None:
    """Three equal springs k below a beam of length L with a force P in its middle.

    The ends carry P / (3/2 + k L^3/(48 E I)) together, the middle the rest.
    """
    engine = crankstar.load("i4", changes={"layout.bore_pitch": "90 mm"})
    shaft = with_values(
        engine.shafts[0], bearing_count=3, bending_stiffness=1e4, bearing_stiffness=support
    )
    front, middle, rear = main_bearings(engine, shaft)
    shares = bearing_shares(engine, shaft, [middle], model="continuous")
    ends = 1 / (1.5 + support * (front - rear) ** 3 / (48 * 1e4))
    assert middle == pytest.approx((front + rear) / 2)
    assert shares[:, 0] == pytest.approx([ends / 2, 1 - ends, ends / 2])


def test_fewer_bearings_carry_more() -> None:
    engine = crankstar.load("i4")
    three = with_values(engine, shafts=(with_values(engine.shafts[0], bearing_count=3),))
    assert len(main_bearings(three, three.shafts[0])) == 3
    five, few = (spectra.peaks(bearing_loads(e).load).max() for e in (engine, three))
    assert few > five


def in_two_masses(engine: Engine, *, bodies: bool) -> Engine:
    """The engine with rods of 0.6 of a piston at 0.3 of their length: as bodies, or in two masses.

    The moment of inertia of the bodies is that of the two masses.
    """
    cylinders = []
    on_pins: dict[tuple[str, int], float] = defaultdict(float)
    for cylinder in engine.cylinders:
        length = cylinder.rod_length
        mass = 0.6 * cylinder.reciprocating_mass
        rod = Rod(mass=mass, centre=0.3 * length, inertia=mass * 0.3 * 0.7 * length**2)
        values = {"rod": rod, "reciprocating_mass": cylinder.reciprocating_mass}
        if not bodies:
            values = {"rod": None, "reciprocating_mass": cylinder.reciprocating_mass + 0.3 * mass}
            on_pins[cylinder.shaft, cylinder.throw] += 0.7 * mass
        cylinders.append(with_values(cylinder, **values))
    shafts = [
        with_values(
            shaft,
            throws=tuple(
                with_values(
                    throw,
                    rotating_mass=on_pins[shaft.name, number],
                    throw_mass=0.0 if bodies else 0.3 * engine.first.reciprocating_mass,
                )
                for number, throw in enumerate(shaft.throws, 1)
            ),
        )
        for shaft in engine.shafts
    ]
    return with_values(engine, cylinders=tuple(cylinders), shafts=tuple(shafts))


@pytest.mark.parametrize("name", ["audi-25-tfsi", "v8-cross-plane", "kr250-racer", "jumo-205"])
def test_a_pin_carries_the_same_by_rods_that_are_bodies_or_two_masses(name: str) -> None:
    """What hangs on a pin loads it; the masses of the throw itself do not."""
    engine = crankstar.load(name)
    bodies, masses = (
        bearing_loads(in_two_masses(engine, bodies=each), speed=100.0) for each in (True, False)
    )
    theta = np.linspace(0, 2 * np.pi, 41)
    own, other = (spectra.value(loads.pin, theta) for loads in (bodies, masses))
    scale = 1.0
    if bodies.unit != "N":  # of m r w^2, where m is the reciprocating mass
        of_bodies, of_masses = (in_two_masses(engine, bodies=each) for each in (True, False))
        scale = unit_unbalance(of_masses) / unit_unbalance(of_bodies)
    assert np.abs(own).max() > 0
    assert np.abs(other * scale - own).max() < TOLERANCE * np.abs(own).max()


def test_the_rotating_mass_pulls_at_its_pin_outward_with_m_r_w_squared() -> None:
    engine = crankstar.load("single")
    throw = with_values(engine.shafts[0].throws[0], rotating_mass=0.45)
    heavy = with_values(engine, shafts=(with_values(engine.shafts[0], throws=(throw,)),))
    more, less = (spectra.selected(bearing_loads(e).pin, 1.0) for e in (heavy, engine))
    before = engine.shafts[0].throws[0].rotating_mass
    outward = (0.45 - before) / engine.first.reciprocating_mass
    assert more.forward - less.forward == pytest.approx(outward * np.exp(1j * throw.angle))
    assert more.backward == pytest.approx(less.backward)


@pytest.mark.parametrize("model", MODELS)
@EVERY_ENGINE
def test_the_load_that_weights_lessen_is_that_of_the_bearings(name: str, model: Model) -> None:
    """The first-order load of `balance` is the greatest that `bearings` has of that order."""
    engine = crankstar.load(name)
    loads = bearing_loads(engine, model=model)
    greatest = 0.0
    for row, bearing in enumerate(loads.bearings):
        shaft = engine.shaft(bearing.shaft)
        if shaft.throws:
            first = spectra.selected(loads.load[row], abs(float(shaft.speed_ratio)))
            greatest = max(greatest, float(abs(first.forward[0]) + abs(first.backward[0])))
    assert bearing_load(engine, model=model) == pytest.approx(greatest, rel=1e-9, abs=1e-12)
