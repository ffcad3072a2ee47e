"""Laws of gas torque and uneven running, of any engine and against roads of their own."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import pi, radians
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, reject
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import root as solved
from tests.strategies import engines, fired, number

import crankstar
from crankstar import spectra
from crankstar.dynamics.uneven import Running, running
from crankstar.engine.copies import turned_on, with_values
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.engine.volumes import volumes
from crankstar.language.faults import EngineError
from crankstar.mechanics import heat_release, ideal_cycles, real_gas
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import rolling_moment
from crankstar.mechanics.gas import SAMPLES, Cycle, cycle
from crankstar.mechanics.gas_torque import chamber_torque, gas_torque, over_cycle, roll_with_gas
from crankstar.mechanics.kinetic import inertia
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Complex, Real

TRUCK = {"cylinder.stroke": "150 mm", "cylinder.bore": "130 mm", "cylinder.rod_ratio": 3.5}
"""A cylinder of a heavy Diesel engine."""


def loads() -> st.SearchStrategy[Gas]:
    """Gas of every process at loads that each can have."""
    return st.builds(
        Gas,
        process=st.sampled_from(["otto", "diesel", "limited-pressure", "heat-release"]),
        compression_ratio=number(8.0, 16.0),
        gamma=number(1.28, 1.4),
        imep=number(3e5, 12e5),
        peak_pressure=st.none(),
        crankcase_pressure=st.none() | number(0.5e5, 3e5),
    )


@st.composite
def gas_engines(draw: Any, *, with_angles: bool = False) -> Engine:
    """Any engine on one crankshaft with bores that fires in the order of its dead centres."""
    drawn = draw(engines(max_shafts=1, known=True))
    bores = [draw(number(0.04, 0.4)) for _ in drawn.cylinders]
    cylinders = tuple(
        each.model_copy(update={"bore": bore})
        for each, bore in zip(drawn.cylinders, bores, strict=True)
    )
    update = {"cylinders": cylinders, "valves": None, "firing_order": (), "firing_angles": None}
    engine = fired(drawn.model_copy(update=update), with_angles=with_angles)
    assume(engine.firing_order)
    turn = engine.cycle_angle / (2 if engine.cycle == "four-stroke" else 1)
    assume(all(abs(top.period_deg - turn) < 1e-6 for top in dead_centres(engine).values()))
    return engine.model_copy(update={"gas": draw(loads())})


def amplitudes(found: Cycle) -> tuple[Real, Complex]:
    """Orders and amplitudes of the whole gas torque, before rounding is taken off."""
    torque = gas_torque(found).torque
    return torque.orders, spectra.amplitude(torque).sum(axis=0)


def greatest(found: Cycle) -> float:
    return float(np.abs(spectra.amplitude(gas_torque(found).torque)).sum(axis=0).max())


@given(gas_engines())
def test_the_mean_torque_is_mean_pressure_times_swept_volume_over_the_cycle(engine: Engine) -> None:
    found = cycle(engine)
    swept = found.volumes.swept[[*found.volumes.kind]].sum()
    wanted = found.imep * swept / radians(engine.cycle_angle)
    assert gas_torque(found).mean.sum() == pytest.approx(wanted, rel=1e-10)
    assert engine.gas
    assert found.imep == pytest.approx(engine.gas.imep, rel=1e-9)
    assert over_cycle(found).sum(axis=0).mean() == pytest.approx(wanted, rel=1e-9)


@given(gas_engines(), number(1e4, 3e5))
def test_the_crankcase_pressure_moves_whole_orders_alone(engine: Engine, pressure: float) -> None:
    found = cycle(engine)
    other = replace(found, crankcase=found.crankcase + pressure)
    orders, before = amplitudes(found)
    moved = amplitudes(other)[1] - before
    halves = np.abs(orders - np.round(orders)) > 0.25
    rate = found.volumes.rate[[*found.volumes.kind]]
    scale = pressure * float(np.abs(rate).sum(axis=0).max())
    assert np.abs(moved[halves]).max(initial=0.0) < 1e-12 * scale + 1e-14 * greatest(found)
    difference = gas_torque(other).mean - gas_torque(found).mean
    assert np.abs(difference).max() < 1e-12 * scale


def test_the_crankcase_is_a_share_of_order_1_of_a_truck_diesel() -> None:
    """About a tenth of order 1 and 2 % of order 2 at full load, nothing of orders and a half."""
    engine = with_values(
        crankstar.load("single", changes=TRUCK),
        gas=Gas(
            compression_ratio=17.0,
            imep=20e5,
            intake_pressure=2.5e5,
            exhaust_pressure=2.6e5,
            combustion_start=radians(-8.0),
            combustion_duration=radians(60.0),
            wiebe_m=1.0,
        ),
    )
    found = cycle(engine)
    orders, gauge = amplitudes(found)
    absolute = amplitudes(replace(found, crankcase=0.0))[1]
    share = {
        order: float(
            np.abs(absolute - gauge)[orders == order][0] / np.abs(gauge)[orders == order][0]
        )
        for order in (0.5, 1.0, 1.5, 2.0)
    }
    assert share[0.5] < 1e-12
    assert share[1.5] < 1e-12
    assert share[1.0] == pytest.approx(0.113, abs=0.002)
    assert share[2.0] == pytest.approx(0.021, abs=0.001)


def test_the_rate_of_a_centred_cylinder_is_the_closed_formula() -> None:
    """A r sin(theta + phi)/cos(phi), sin(phi) = lambda sin(theta), at 7200 places."""
    engine = crankstar.load("single", changes=TRUCK)
    count = 7200
    theta = np.arange(count) * (4 * pi / count)
    swing = np.arcsin(np.sin(theta) / 3.5)
    area = pi / 4 * 0.13**2
    wanted = area * 0.075 * np.sin(theta + swing) / np.cos(swing)
    found = volumes(engine, count)
    assert np.abs(found.rate[0] - wanted).max() < 1e-13 * area
    assert float(found.swept[0]) == pytest.approx(area * 0.15, rel=1e-12)
    gas = cycle(engine)
    torque = (gas.pressure[0] - gas.crankcase) * wanted[:: count // SAMPLES]
    assert np.abs(chamber_torque(gas)[0] - torque).max() < 1e-12 * np.abs(torque).max()


@pytest.mark.parametrize("cycle_name", ["four-stroke", "two-stroke"])
def test_the_spectrum_is_that_of_a_quadrature_of_pressure_times_volume(cycle_name: str) -> None:
    """Splines through pressure and volume, integrated piece by piece: no Fourier transform."""
    engine = crankstar.load("single", changes={**TRUCK, "cycle": cycle_name})
    found = cycle(engine)
    whole = found.volumes.cycle
    theta = np.arange(SAMPLES + 1) * (whole / SAMPLES)
    fine = np.linspace(0.0, whole, 8 * SAMPLES + 1)
    pressure = CubicSpline(
        theta, np.append(found.pressure[0], found.pressure[0, 0]), bc_type="periodic"
    )
    volume = CubicSpline(
        theta, np.append(found.volumes.above[0], found.volumes.above[0, 0]), bc_type="periodic"
    )
    torque = (pressure(fine) - found.crankcase) * volume(fine, 1)
    orders, spectrum = amplitudes(found)
    scale = np.abs(spectrum).max()
    for order, amplitude in zip(orders[:12], spectrum[:12], strict=True):
        wave = CubicSpline(fine, torque * np.cos(order * fine)).integrate(0.0, whole) - 1j * (
            CubicSpline(fine, torque * np.sin(order * fine)).integrate(0.0, whole)
        )
        assert abs(2 / whole * wave - amplitude) < 1e-6 * scale


@pytest.mark.parametrize(
    ("name", "step"),
    [
        ("triumph-675", 1.5),
        ("honda-b18c", 2.0),
        ("audi-25-tfsi", 2.5),
        ("toyota-2jz", 3.0),
        ("ferrari-f136", 4.0),
        ("man-s50mc-c", 6.0),
    ],
)
def test_even_firing_leaves_multiples_of_half_the_number_of_cylinders(
    name: str, step: float
) -> None:
    """Of the number itself in two-stroke engines: all other orders are nought, not small."""
    total = gas_torque(cycle(crankstar.load(name))).total
    amplitude = spectra.amplitude(total)
    kept = np.abs(total.orders / step - np.round(total.orders / step)) < 1e-9
    assert np.all(amplitude[~kept] == 0)
    assert np.all(np.abs(amplitude[kept]) > 0)


@given(gas_engines(with_angles=True), number(-pi, pi))
def test_turning_the_crankshaft_on_shifts_every_order_by_its_angle(
    engine: Engine, angle: float
) -> None:
    try:
        turned = turned_on(engine, angle)
    except EngineError:
        assume(False)
        return
    orders, before = amplitudes(cycle(engine))
    after = amplitudes(cycle(turned))[1]
    wanted = before * np.exp(1j * orders * engine.sense * angle)
    assert np.abs(after - wanted).max() < 1e-7 * greatest(cycle(engine))


@given(gas_engines())
def test_an_engine_in_the_mirror_has_the_same_torque(engine: Engine) -> None:
    """Turning the other way, throws, cylinders and offsets on the other side."""
    cylinders = tuple(
        each.model_copy(
            update={
                "bearing": -each.bearing,
                "offset": -each.offset,
                "articulated": each.articulated
                and each.articulated.model_copy(update={"angle": -each.articulated.angle}),
            }
        )
        for each in engine.cylinders
    )
    shafts = tuple(
        shaft.model_copy(
            update={
                "right": -shaft.right,
                "throws": tuple(
                    throw.model_copy(update={"angle": -throw.angle}) for throw in shaft.throws
                ),
            }
        )
        for shaft in engine.shafts
    )
    other = "counter-clockwise" if engine.rotation == "clockwise" else "clockwise"
    mirrored = engine.model_copy(
        update={"cylinders": cylinders, "shafts": shafts, "rotation": other}
    )
    before, after = amplitudes(cycle(engine))[1], amplitudes(cycle(mirrored))[1]
    assert np.abs(after - before).max() < 1e-7 * greatest(cycle(engine))


@given(
    bearing=number(-pi, pi),
    offset=number(-0.02, 0.02),
    rotation=st.sampled_from(["clockwise", "counter-clockwise"]),
    load=loads(),
)
def test_gas_makes_no_force_on_the_block_and_the_reaction_of_its_torque(
    bearing: float, offset: float, rotation: str, load: Gas
) -> None:
    """Head, cylinder wall and main bearings together, from the balance of each massless part."""
    radius, length, bore = 0.05, 0.16, 0.09
    drawn = crankstar.load(
        "single", changes={"cylinder.stroke": "100 mm", "cylinder.bore": "90 mm"}
    )
    cylinder = drawn.first.model_copy(
        update={"bearing": bearing, "offset": offset, "rod_length": length}
    )
    engine = drawn.model_copy(update={"cylinders": (cylinder,), "gas": load, "rotation": rotation})
    try:
        found = cycle(engine)
    except GasError:  # more than this cylinder can give
        reject()
    theta = found.volumes.fires[0] + np.arange(SAMPLES) * found.volumes.cycle / SAMPLES
    axis, sense = np.exp(1j * bearing), engine.sense
    pin = radius * np.exp(1j * (sense * theta + engine.throw(cylinder).angle))
    across = (pin / axis).imag - offset
    piston = axis * ((pin / axis).real + np.sqrt(length**2 - across**2) + 1j * offset)
    push = (found.pressure[0] - found.crankcase) * pi / 4 * bore**2  # inward on the piston
    rod = (piston - pin) / length
    thrust = push / (rod / axis).real  # of the rod, as pressure
    wall = 1j * axis * (thrust * (rod / axis).imag)  # on the piston: - push + rod + wall = 0
    piston_balance = -push * axis + thrust * rod - wall
    assert np.abs(piston_balance).max() < 1e-9 * np.abs(push).max()
    on_head, on_wall, on_bearing = push * axis, wall, -thrust * rod
    assert np.abs(on_head + on_wall + on_bearing).max() < 1e-9 * np.abs(push).max()
    moment = np.imag(np.conj(piston) * (on_head + on_wall))  # clockwise; bearings have no arm
    torque = chamber_torque(found)[0]
    assert np.abs(moment + sense * torque).max() < 1e-9 * np.abs(torque).max()


@given(gas_engines())
def test_the_block_rolls_by_minus_the_gas_torque_and_nothing_else_of_gas(engine: Engine) -> None:
    sums, gas = total(balance(engine)), gas_torque(cycle(engine)).total
    theta = np.linspace(0.0, 4 * pi, 97)

    def at(spectrum: spectra.Spectrum) -> Real:
        return np.real(spectra.value(spectrum, theta))

    difference = at(roll_with_gas(sums, gas)) - at(rolling_moment(sums))
    wanted = -engine.sense * at(gas)
    assert np.abs(difference - wanted).max() < 1e-9 * (
        np.abs(wanted).max() + np.abs(difference).max()
    )


# Heat release


def slider(count: int = SAMPLES, ratio: float = 9.0) -> heat_release.Grid:
    """A four-stroke cylinder of half a litre."""
    theta = np.arange(count) * (4 * pi / count)
    root = np.sqrt(16 - np.sin(theta) ** 2)
    travel = np.cos(theta) + root
    slope = -np.sin(theta) - np.sin(theta) * np.cos(theta) / root
    half = 0.5e-3 / 2
    return heat_release.Grid(
        half * (travel[0] - travel) + 0.5e-3 / (ratio - 1), -half * slope, 4 * pi / count
    )


AT_BOTTOM = heat_release.Events(-pi, pi, pi + 1e-3, (2 * pi - 0.2, 2 * pi + 0.2))
"""Valves that close and open at bottom dead centre."""


def test_heat_release_in_no_time_is_the_otto_cycle() -> None:
    grid, gamma, heat = slider(), 1.35, 900.0
    ideal = ideal_cycles.Ideal(9.0, gamma, 1e5, 1e5)
    otto = ideal_cycles.mean_pressure(ideal, heat / 0.5e-3, four_stroke=True)
    above = grid.volume / 0.5e-3 - 1 / 8
    reference = ideal_cycles.pressure(
        ideal, heat / 0.5e-3, above, bottom=SAMPLES // 4, four_stroke=True
    )
    missing: list[float] = []
    for degrees in (40.0, 20.0, 10.0, 5.0):
        width = radians(degrees)
        release = heat_release.Release(-width / 2, width, 5.0, 2.0)
        parts = heat_release.curves(grid, AT_BOTTOM, release, gamma=gamma)
        found = 1e5 * (parts.intake + parts.exhaust) + heat * parts.heat
        work = float((found * grid.rate).sum() * grid.step)
        missing.append(1 - work / (otto * 0.5e-3))
        burnt = slice(round(width / 2 / grid.step) + 1, SAMPLES // 4)
        assert np.abs(found[burnt] / reference[burnt] - 1).max() < 0.02 * degrees / 5
    assert all(0 < after < before for before, after in pairwise(missing))
    assert missing[-1] < 1e-3
    assert otto / (heat / 0.5e-3) == pytest.approx(1 - 9 ** (1 - gamma), rel=1e-12)


RELEASE = heat_release.Release(radians(-15.0), radians(50.0), 5.0, 2.0)
EVENTS = heat_release.Events(-2.4, 2.3, 3.1, (2 * pi - 0.2, 2 * pi + 0.2))


def charge(*, gamma: float | None, wall: float | None) -> real_gas.Charge:
    return real_gas.Charge(1e5, 1.05e5, 340.0, 0.086, 0.086, 10.0, wall, gamma)


@pytest.mark.parametrize("beside", [0.0, 1.7])
def test_the_integrated_pressure_of_a_constant_gamma_is_the_sum_of_curves(beside: float) -> None:
    """Nearly exactly but in the step in which Wiebe's rate ends with a jump."""
    grid = slider()
    begins = np.ceil(EVENTS.closed / grid.step) + 4 * 160 + beside
    release = heat_release.Release(begins * grid.step, 240 * grid.step, 5.0, 2.0)
    parts = heat_release.curves(grid, EVENTS, release, gamma=1.3)
    wanted = 1e5 * parts.intake + 1.05e5 * parts.exhaust + 900.0 * parts.heat
    found = real_gas.real_pressure(grid, EVENTS, release, charge(gamma=1.3, wall=None), heat=900.0)
    missing = np.abs(found - wanted) / wanted.max()
    assert missing.max() < 3e-4
    ends = round(begins + 240)
    missing[ends - 5 : ends + 6] = 0.0
    assert missing.max() < 2e-6


@pytest.mark.parametrize("degrees", [0.3, 1.0, 3.0])
def test_a_short_combustion_releases_all_its_heat(degrees: float) -> None:
    grid = slider()
    release = heat_release.Release(radians(4.1), radians(degrees), 5.0, 2.0)
    parts = heat_release.curves(grid, EVENTS, release, gamma=1.3)
    wanted = 1e5 * parts.intake + 1.05e5 * parts.exhaust + 900.0 * parts.heat
    found = real_gas.real_pressure(grid, EVENTS, release, charge(gamma=1.3, wall=None), heat=900.0)
    later = round(radians(10.0) / grid.step)
    assert found[later] == pytest.approx(wanted[later], rel=2e-3)


@pytest.mark.parametrize("gamma", [1.3, None])
def test_heat_to_the_walls_costs_work_at_equal_heat(gamma: float | None) -> None:
    grid = slider()

    def work(wall: float | None) -> float:
        parts = charge(gamma=gamma, wall=wall)
        found = real_gas.real_pressure(grid, EVENTS, RELEASE, parts, heat=900.0)
        return float((found * grid.rate).sum() * grid.step)

    tight, warm, cold = work(None), work(550.0), work(400.0)
    assert cold < warm < tight
    assert 0.02 < 1 - cold / tight < 0.3


# Uneven running


def heavy() -> tuple[Engine, Cycle]:
    """One heavy cylinder at 1500 rpm, and its gas."""
    engine = crankstar.load(
        "single",
        changes={
            **TRUCK,
            "cylinder.reciprocating_mass": "3 kg",
            "cylinder.rotating_mass": "2 kg",
            "speed": "1500 rpm",
        },
    )
    return engine, cycle(engine, imep=8e5)


def test_the_felt_inertia_is_twice_the_kinetic_energy_at_one_radian_a_second() -> None:
    """Of a piston by the closed formula of its speed, and of what turns with the pin."""
    engine, _gas = heavy()
    theta = np.linspace(0.0, 2 * pi, 181)
    swing = np.arcsin(np.sin(theta) / 3.5)
    speed = 0.075 * np.sin(theta + swing) / np.cos(swing)
    assert inertia(engine, theta) == pytest.approx(3.0 * speed**2 + 2.0 * 0.075**2, rel=1e-10)


def energy_law(engine: Engine, found: Running, flywheel: float) -> Real:
    """dE/dtheta - (T_gas - T_load), E differentiated as a sum of harmonics."""
    energy = (flywheel + inertia(engine, found.theta)) * found.speed**2 / 2
    count, span = energy.size, found.theta[1] - found.theta[0]
    wave = np.fft.rfft(energy) * 1j * np.fft.rfftfreq(count, 1 / count) * (2 * pi / (count * span))
    other = np.fft.rfft(found.gas - found.load)
    wave[-1], other[-1] = 0.0, 0.0  # a cosine of half the samples has no slope at them
    return np.fft.irfft(wave - other, n=count)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(("flywheel", "exponent"), [(2.0, 0.0), (2.0, 2.0), (5.0, -1.0)])
def test_the_energy_of_uneven_running_is_balanced(flywheel: float, exponent: float) -> None:
    engine, gas = heavy()
    found = running(engine, gas, flywheel=flywheel, exponent=exponent)
    residue = energy_law(engine, found, flywheel)
    assert np.abs(residue).max() < 1e-9 * np.abs(found.gas).max()
    assert found.load.mean() == pytest.approx(found.gas.mean(), rel=1e-9)
    assert 1 / (1 / found.speed).mean() == pytest.approx(found.mean_speed, rel=1e-9)


@pytest.mark.release
@pytest.mark.parametrize(("flywheel", "exponent"), [(2.0, 0.0), (2.0, 2.0)])
def test_uneven_running_is_what_shooting_finds(flywheel: float, exponent: float) -> None:
    """J dw/dt + J' w^2/2 = T_gas - T_load, integrated from a speed that comes back."""
    engine, gas = heavy()
    found = running(engine, gas, flywheel=flywheel, exponent=exponent)
    whole = radians(engine.cycle_angle)
    theta = np.append(found.theta, whole)
    torque = CubicSpline(theta, np.append(found.gas, found.gas[0]), bc_type="periodic")
    felt = flywheel + inertia(engine, theta)
    felt[-1] = felt[0]
    moment = CubicSpline(theta, felt, bc_type="periodic")
    mean = found.mean_speed

    def shot(start: float, load: float, at: Real) -> Any:
        def slope(angle: float, state: Real) -> list[float]:
            speed = state[0]
            taken = load * (speed / mean) ** exponent
            left = torque(angle) - taken - moment(angle, 1) * speed**2 / 2
            return [left / (moment(angle) * speed), 1 / speed]

        return solve_ivp(
            slope, (0.0, whole), [start, 0.0], t_eval=at, rtol=1e-8, atol=1e-9, max_step=0.05
        ).y

    def missed(guess: Real) -> list[float]:
        end = shot(guess[0] * mean, guess[1] * found.gas.mean(), np.array([whole]))
        return [end[0, -1] / (guess[0] * mean) - 1, end[1, -1] * mean / whole - 1]

    guess = [found.speed[0] / mean * 1.01, found.load.mean() / found.gas.mean() * 0.99]
    best = solved(missed, guess, options={"xtol": 1e-8})
    assert best.success
    speeds = shot(best.x[0] * mean, best.x[1] * found.gas.mean(), found.theta)[0]
    assert np.abs(speeds - found.speed).max() < 2e-5 * mean
    assert np.ptp(speeds) / mean == pytest.approx(found.irregularity, rel=1e-3)


def test_the_linear_estimate_is_the_limit_of_a_heavy_flywheel() -> None:
    """Its error goes with the irregularity."""
    engine, gas = heavy()
    errors: list[float] = []
    for flywheel in (8.0, 32.0, 128.0):
        found = running(engine, gas, flywheel=flywheel)
        errors.append(abs(found.linear / found.irregularity - 1))
        assert errors[-1] < 3 * found.irregularity
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.25)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.25)
