"""Laws of the gears between crankshafts: shares of torque, work, flywheel; roads of their own."""

from __future__ import annotations

from math import pi, radians
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from tests.strategies import number

import crankstar
from crankstar import spectra
from crankstar.dynamics.meshes import Mesh, meshes
from crankstar.dynamics.uneven import SAMPLES, Running, running
from crankstar.engine.copies import with_values
from crankstar.engine.drive import Drive, Gearing
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import crankshaft_torque, friction_torque, over_cycle
from crankstar.mechanics.gear_wheels import Wheel, crankshafts, wheels
from crankstar.mechanics.kinetic import inertia, inertias, shaft_torque
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real

MASSES = {
    "cylinder.reciprocating_mass": "150 g",
    "cylinder.rotating_mass": "200 g",
    "speed": "8000 rpm",
}
GEARED = ["kr250-racer", "kr250-production", "jumo-205", "napier-deltic", "brough-golden-dream"]
OUTPUT = Drive(gearing="output")


def racer(*, together: bool = False, **drive: Any) -> Engine:
    """The KR250 racer with masses."""
    name = "kr250-racer-simultaneous" if together else "kr250-racer"
    return with_values(crankstar.load(name, changes=MASSES), drive=Drive(**drive))


def square_four() -> Engine:
    """The square four with sizes and masses."""
    changes = {
        "cylinder.bore": "65 mm",
        "cylinder.stroke": "75 mm",
        "cylinder.reciprocating_mass": "300 g",
        "layout.cranks[2].right": "150 mm",
        "speed": "5000 rpm",
    }
    return crankstar.load("square-four", changes=changes)


def own_torque(engine: Engine, share: float = 0.0) -> list[Real]:
    """What each crankshaft passes on to the output, all of them with the same share."""
    parts = [share] * len(crankshafts(engine))
    found = meshes(with_values(engine, drive=OUTPUT), cycle(engine), inertia_shares=parts)
    return [mesh.torque for mesh in found]


def orders_of(torque: Real) -> Real:
    """Amplitudes of a two-stroke torque by order, mean first."""
    return np.abs(np.fft.rfft(torque))[:24] * 2 / torque.size


@pytest.mark.parametrize("name", GEARED)
def test_the_torques_of_all_crankshafts_are_the_torque_of_the_engine(name: str) -> None:
    engine = crankstar.load(name)
    found = cycle(engine)
    own = crankshaft_torque(engine, found, SAMPLES)
    whole = over_cycle(found, SAMPLES).sum(axis=0)
    assert np.abs(own.sum(axis=0) - whole).max() < 1e-10 * np.abs(own).max()


@given(
    lag=number(-pi, pi),
    bearing=number(-pi, pi),
    offset=number(-0.01, 0.01),
    bore=number(0.05, 0.2),
    way=st.sampled_from([1, -1]),
)
def test_two_pistons_share_the_torque_of_their_chamber(
    lag: float, bearing: float, offset: float, bore: float, way: int
) -> None:
    changes = {
        "layout.lag": f"{lag} rad",
        "layout.bearing": f"{bearing} rad",
        "layout.speed_ratio": way,
        "cylinder.bore": f"{bore} m",
        "cylinder.offset": f"{offset} m",
        "firing_order": [],
        "layout.throws": ["0 deg"],
    }
    engine = crankstar.load("jumo-205", changes=changes)
    found = cycle(engine)
    own = crankshaft_torque(engine, found, SAMPLES)
    whole = over_cycle(found, SAMPLES).sum(axis=0)
    assert np.abs(own.sum(axis=0) - whole).max() < 1e-9 * np.abs(own).max()


def test_the_inertia_torques_of_all_crankshafts_are_that_of_the_engine() -> None:
    for engine in (racer(), square_four()):
        theta = np.linspace(0.0, 2 * pi, 73)
        own = np.real(spectra.value(shaft_torque(mechanism(engine)), theta)).sum(axis=0)
        assert engine.speed
        sums = total(balance(engine, speed=engine.speed))
        whole = np.real(spectra.value(sums.torque, theta)) / engine.speed**2
        assert np.abs(own - whole).max() < 1e-12 * np.abs(whole).max()
        felt = inertias(engine, theta)
        assert felt.sum(axis=0) == pytest.approx(inertia(engine, theta), rel=1e-12)


def test_the_rear_crankshaft_passes_on_what_its_own_slider_crank_gives() -> None:
    """Pressure times area down the rod, and the change of its kinetic energy, by hand."""
    engine = racer()
    found = cycle(engine)
    (mesh,) = meshes(engine, found, inertia_shares=(0.0, 0.0))
    psi = mesh.theta - pi  # from its top dead centre
    radius, area, mass = 0.0272, pi / 4 * 0.054**2, 0.15
    steps = np.append(np.arange(found.pressure.shape[1]) * 2 * pi / found.pressure.shape[1], 2 * pi)
    pressure = CubicSpline(
        steps, np.append(found.pressure[1], found.pressure[1, 0]), bc_type="periodic"
    )
    swing = np.arcsin(np.sin(psi) / 4)
    on_piston = (pressure(psi % (2 * pi)) - found.crankcase) * area
    on_rod = on_piston / np.cos(swing)
    gas = on_rod * radius * np.sin(psi + swing)
    assert found.speed
    speed = CubicSpline(
        np.append(mesh.theta, 2 * pi),
        0.5
        * mass
        * (found.speed * radius * np.append(np.sin(psi + swing) / np.cos(swing), np.sin(-pi))) ** 2,
    )
    wanted = gas - speed(mesh.theta, 1)
    assert np.abs(mesh.torque - wanted).max() < 1e-4 * np.abs(wanted).max()


@pytest.mark.parametrize("name", GEARED)
@pytest.mark.parametrize("share", [0.0, 0.2])
@pytest.mark.parametrize("gearing", ["crankshafts", "output"])
def test_the_power_of_the_crankshafts_beyond_goes_through_the_gears(
    name: str, share: float, gearing: Gearing
) -> None:
    """Also through a chain of gears, where each mesh carries all that is behind it."""
    engine = with_values(crankstar.load(name), drive=Drive(gearing=gearing))
    found = cycle(engine)
    own = dict(
        zip(
            [shaft.name for shaft in engine.shafts],
            crankshaft_torque(engine, found).mean(axis=-1),
            strict=True,
        )
    )
    parts = [share] * len(crankshafts(engine))
    for mesh in meshes(engine, found, inertia_shares=parts):
        wanted = sum(own[name] for name in mesh.wheel.beyond)
        assert mesh.mean == pytest.approx(wanted, rel=1e-9)
        assert mesh.work_share == pytest.approx(wanted / sum(own.values()), rel=1e-9)


@pytest.mark.parametrize("exact", [False, True])
def test_alike_crankshafts_that_fire_together_pass_on_half_the_load(exact: bool) -> None:
    engine = racer(together=True)
    found = cycle(engine)
    run = running(engine, found, flywheel=0.004) if exact else None
    (mesh,) = meshes(engine, found, running=run)
    load = over_cycle(found).sum(axis=0).mean() / 2
    assert np.abs(mesh.torque - load).max() < 1e-9 * mesh.scale
    assert mesh.reversals == ()
    assert mesh.driving == 1.0


@pytest.mark.many(first=2)
@pytest.mark.parametrize("share", [0.0, 0.1, 0.25, 0.5])
def test_sharing_the_flywheel_relieves_the_orders_that_both_crankshafts_have(share: float) -> None:
    """By 1 - 2 s: all of them where both fire together, even ones alone at 180 degrees."""
    apart, together = (own_torque(racer(together=which), share)[1] for which in (False, True))
    free = orders_of(own_torque(racer())[1])
    relieved = free * (1 - 2 * share)
    scale = 1e-9 * free.max()
    assert np.abs(orders_of(together)[1:] - relieved[1:]).max() < scale
    assert np.abs(orders_of(apart)[2::2] - relieved[2::2]).max() < scale
    assert np.abs(orders_of(apart)[1::2] - free[1::2]).max() < scale


@given(
    shares=st.lists(number(0.0, 1.0), min_size=2, max_size=2).filter(lambda both: sum(both) > 0.1)
)
def test_what_all_gears_pass_on_to_the_output_is_the_load(shares: list[float]) -> None:
    """Where no inertia is with the load itself; else the load and what that inertia takes."""
    engine = with_values(racer(), drive=OUTPUT)
    found = cycle(engine)
    parts = np.array(shares) / sum(shares)
    passed = [mesh.torque for mesh in meshes(engine, found, inertia_shares=parts.tolist())]
    load = over_cycle(found).sum(axis=0).mean()
    assert np.abs(sum(passed) - load).max() < 1e-9 * np.abs(passed).max()
    half = [mesh.torque for mesh in meshes(engine, found, inertia_shares=(parts / 2).tolist())]
    free = sum(own_torque(engine))
    assert np.abs(sum(half) - (free + load) / 2).max() < 1e-9 * np.abs(half).max()


def up_and_down(theta: np.ndarray) -> np.ndarray:
    """A course from 1 to 3 and back over its mean, of each step around an angle its mean."""
    half = pi / SAMPLES
    before, at, after = (
        np.interp(theta + each, [0, pi, 2 * pi], [1.0, 3.0, 1.0], period=2 * pi)
        for each in (-half, 0.0, half)
    )
    return (before + 2 * at + after) / 8


def test_a_load_that_goes_over_the_cycle_is_passed_on_as_it_goes() -> None:
    drive = Drive(gearing="output", load_angle=(0.0, pi), load_torque=(1.0, 3.0))
    engine = with_values(racer(), drive=drive)
    found = cycle(engine)
    passed = [mesh.torque for mesh in meshes(engine, found)]
    theta = np.arange(SAMPLES) * 2 * pi / SAMPLES
    load = up_and_down(theta) * over_cycle(found).sum(axis=0).mean()
    assert np.abs(sum(passed) - load).max() < 1e-9 * np.abs(passed).max()


def test_the_friction_that_a_file_gives_is_passed_on_steadily() -> None:
    drive = Drive(gearing="output", load_angle=(0.0, pi), load_torque=(1.0, 3.0))
    gas = with_values(racer().gas or Gas(), friction_pressure=2e5)
    engine = with_values(racer(), drive=drive, gas=gas)
    found = cycle(engine)
    passed = sum(mesh.torque for mesh in meshes(engine, found))
    lost = friction_torque(found)
    assert lost
    theta = np.arange(SAMPLES) * 2 * pi / SAMPLES
    shape = up_and_down(theta)
    load = lost + (over_cycle(found).sum(axis=0).mean() - lost) * shape
    assert np.abs(passed - load).max() < 1e-9 * np.abs(passed).max()


@pytest.mark.parametrize("name", ["racer", "square four"])
def test_the_exact_torque_tends_to_that_of_the_shares_as_the_flywheel_grows(name: str) -> None:
    engine = racer() if name == "racer" else square_four()
    found = cycle(engine)
    shares = (0.5, 0.5) if name == "racer" else (0.7, 0.1)
    (limit,) = meshes(engine, found, inertia_shares=shares)
    missing: list[float] = []
    for flywheel in (0.1, 1.0, 10.0):
        run = running(engine, found, flywheel=flywheel)
        (mesh,) = meshes(engine, found, running=run, inertia_shares=shares)
        missing.append(float(np.abs(mesh.torque - limit.torque).max()) / limit.scale)
    assert missing[0] > 1e-6
    assert missing[1] == pytest.approx(missing[0] / 10, rel=0.1)
    assert missing[2] == pytest.approx(missing[1] / 10, rel=0.1)


def sprung(engine: Engine, run: Running, shares: tuple[float, float]) -> tuple[Real, Real]:
    """Crank angle and torque of a stiff spring between the crankshafts, over a second cycle.

    Each crankshaft with its own equation of motion, the load on the first.
    """
    theta = np.append(run.theta, radians(engine.cycle_angle))
    whole = inertias(engine, run.theta) + np.array(shares)[:, None] * run.flywheel
    gas = crankshaft_torque(engine, cycle(engine), SAMPLES)
    felt, torque = (
        [CubicSpline(theta, np.append(row, row[0]), bc_type="periodic") for row in rows]
        for rows in (whole, gas)
    )
    stiffness = 0.5 * whole.min() * (400 * run.mean_speed) ** 2
    damping = 2 * np.sqrt(stiffness * whole.min() / 2)

    def slope(_time: float, state: Real) -> list[float]:
        angle, speed = state[:2], state[2:]
        passed = stiffness * (angle[1] - angle[0]) + damping * (speed[1] - speed[0])
        given = (passed - run.load.mean(), -passed)
        bends = [
            (torque[i](angle[i]) + given[i] - felt[i](angle[i], 1) * speed[i] ** 2 / 2)
            / felt[i](angle[i])
            for i in (0, 1)
        ]
        return [*speed, *bends]

    start = run.speed[0]
    span = 2 * pi / run.mean_speed * 2
    times = np.linspace(span / 2, 0.95 * span, 300)
    out = solve_ivp(
        slope,
        (0.0, span),
        [0.0, 0.0, start, start],
        method="LSODA",
        t_eval=times,
        rtol=1e-9,
        atol=1e-10,
    )
    passed = stiffness * (out.y[1] - out.y[0]) + damping * (out.y[3] - out.y[2])
    return out.y[0], passed


@pytest.mark.many(first=2)
@pytest.mark.parametrize("together", [False, True])
@pytest.mark.parametrize("shares", [(0.5, 0.5), (0.8, 0.2)])
def test_a_stiff_spring_between_the_crankshafts_feels_the_torque_of_the_mesh(
    together: bool, shares: tuple[float, float]
) -> None:
    engine = racer(together=together)
    found = cycle(engine)
    run = running(engine, found, flywheel=0.004)
    (mesh,) = meshes(engine, found, running=run, inertia_shares=shares)
    angle, felt = sprung(engine, run, shares)
    wanted = np.interp(angle % (2 * pi), mesh.theta, mesh.torque, period=2 * pi)
    assert np.abs(felt - wanted).max() < 0.005 * mesh.scale


def drawn(torque: Real) -> Mesh:
    theta = np.arange(torque.size) * (2 * pi / torque.size)
    wheel = Wheel("rear", "front", ("rear",), False, 0.05)
    return Mesh(wheel, 0.5, theta, torque, 0.5, float(np.abs(torque).max()))


def test_contact_is_reversed_where_the_torque_goes_through_nought() -> None:
    theta = np.arange(720) * (2 * pi / 720)
    mesh = drawn(0.5 + np.cos(theta))
    assert np.degrees(mesh.reversals) == pytest.approx([120.0, 240.0], abs=2e-3)
    assert mesh.driving == pytest.approx(2 / 3, abs=2e-3)
    assert drawn(1.5 + np.cos(theta)).reversals == ()
    assert drawn(np.maximum(np.cos(theta), 0.0) + 1e-14 * np.cos(99 * theta)).reversals == ()
    light = np.where(np.cos(theta) > 0, np.cos(theta), 0.005 * np.cos(theta))
    assert drawn(light).reversals == ()
    late = np.where(theta < 1.0, 1.0, np.where(theta < 2.0, 0.005 * np.cos(20 * theta), -1.0))
    assert drawn(late).reversals[0] == pytest.approx(2.0, abs=0.1)
    exact = np.cos(theta)
    exact[180] = exact[540] = 0.0
    assert np.degrees(drawn(exact).reversals) == pytest.approx([90.0, 270.0])
    assert drawn(exact).work == pytest.approx(4.0, rel=1e-4)
    assert drawn(exact).force == pytest.approx(20.0)


def test_crankshafts_mesh_with_the_nearest_and_by_an_idler_if_they_turn_alike() -> None:
    (rear,) = wheels(crankstar.load("kr250-production"))
    assert rear.idler
    assert rear.pitch_radius is None
    (rear,) = wheels(racer(output="rear", pitch_radius=0.03))
    assert (rear.crankshaft, rear.onto, rear.pitch_radius) == ("front", "rear", 0.03)
    assert [wheel.onto for wheel in wheels(crankstar.load("napier-deltic"))] == [None] * 3
    triangle = with_values(crankstar.load("napier-deltic"), drive=None)
    bottom, right = wheels(triangle)
    assert (bottom.onto, right.onto) == ("top left", "bottom")
    assert bottom.beyond == ("bottom", "top right")
    assert not bottom.idler
    assert wheels(crankstar.load("v8-flat-plane")) == ()
    coaxial = crankstar.load("kr250-production", changes={"layout.cranks[2].right": "0 mm"})
    assert [(wheel.idler, wheel.pitch_radius) for wheel in wheels(coaxial)] == [(False, None)]


@pytest.mark.parametrize(
    ("name", "drive", "found"),
    [
        ("kr250-racer", {"pitch_radius": "45.2 mm"}, None),
        ("kr250-racer", {"pitch_radius": "45 m"}, ("doubt.pitch-radius", 45e3, 45.0)),
        ("kr250-racer", {"pitch_radius": "30 mm"}, ("doubt.pitch-radius", 30.0, 45.0)),
        ("kr250-racer", {"pitch_radius": "30 mm", "gearing": "output"}, None),
        (
            "kr250-racer",
            {"pitch_radius": "60 mm", "gearing": "output"},
            ("doubt.wheels-overlap", 60.0, 45.0),
        ),
        ("jumo-205", {"pitch_radius": "100 mm"}, None),
    ],
)
def test_wheels_that_mesh_have_half_the_distance_of_their_shafts(
    name: str, drive: dict[str, str], found: tuple[str, float, float] | None
) -> None:
    """Jumo 205: an idler joins crankshafts that turn the same way."""
    engine = crankstar.load(name, changes={"drive": drive})
    told = [each for each in doubts(engine) if each.path == ("drive", "pitch_radius")]
    assert [(each.code, each.values["value"], each.values["half"]) for each in told] == (
        [found] if found else []
    )
