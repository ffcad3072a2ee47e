"""Laws where features meet: random engines with everything at once (`tests/whole_engines`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st
from tests.equilibrium import assert_statics
from tests.newton import placed, road
from tests.remade import mirrored, turned_in_space
from tests.strategies import RELEASE, number
from tests.whole_engines import whole_engines

from crankstar import spectra
from crankstar.analyses.tolerance.error_sources import sources_of
from crankstar.analyses.tolerance.linear_law import QUANTITIES, linear, summed_parts
from crankstar.dynamics.bearings import bearing_loads
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mounted_block import SIX
from crankstar.dynamics.uneven import UnevenError, driven, flywheel_for
from crankstar.engine.copies import turned_on, with_values
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.files import changed, engine_of, keys_of, toml, tree_of
from crankstar.files.tolerances import tolerances_of
from crankstar.language.faults import EngineError
from crankstar.mechanics.balance import balance, default_reference, scales, total
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_loads import gas_over_speeds
from crankstar.mechanics.gas_pins import head_forces
from crankstar.mechanics.gas_torque import gas_torque, over_cycle
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.operating_points import operating_state
from crankstar.mechanics.side_thrust import pressure_at
from crankstar.spectra import Complex
from crankstar.studies.single_faults import shaken

Loaded = tuple[Engine, Cycle]
laws = settings(
    max_examples=40 if RELEASE else 2,
    deadline=None,
    phases=[Phase.explicit, Phase.generate],
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
"""A few examples in the gate, many in the release: each takes a tenth of a second or more."""


def again(engine: Engine, found: Cycle) -> Cycle:
    """The cycle of another engine at the same speed, with the same cylinders off and weak."""
    off = [each.number for key in found.off for each in engine.chambers[key]]
    weak = {engine.chambers[key][0].number: share for key, share in found.weaker.items()}
    return cycle(engine, speed=found.speed, off=off, weaker=weak)


def torque(found: Cycle) -> Complex:
    """The whole gas torque by order before rounding is taken off, N m."""
    return spectra.amplitude(gas_torque(found).torque).sum(axis=0)


def size_of(found: Cycle) -> float:
    return float(np.abs(spectra.amplitude(gas_torque(found).torque)).sum(axis=0).max())


@laws
@given(whole_engines())
def test_every_body_and_the_whole_are_in_equilibrium(loaded: Loaded) -> None:
    assert_statics(*loaded)


@laws
@given(whole_engines())
def test_bearings_walls_heads_and_mounts_carry_what_accelerates(loaded: Loaded) -> None:
    """Order by order: the block's own M a is what its parts and its mounts push it with.

    What the parts push with is the sum of bearings, walls and heads at every angle, and, by the
    momentum of the moving parts, minus the rate at which that changes.
    """
    engine, found = loaded
    assume(engine.mounts)
    assert found.speed is not None
    at = mounts(engine, speed=found.speed, speeds=[found.speed]).at
    assert at is not None
    walked = road(engine, reference=Reference(0.0), speed=found.speed)
    theta = walked.theta.astype(float)
    heads = head_forces(engine, found)
    loads = bearing_loads(engine, cycle=found)
    carried = sum(
        spectra.value(each, theta).sum(axis=0) for each in (loads.load, loads.guide, heads)
    )
    for place, order in enumerate(at.orders):
        waves = 2 * np.mean(np.exp(-1j * order * theta) * np.array([carried.real, carried.imag]), 1)
        push = at.excitation.push[0, place]
        size = np.abs(carried).max()
        whole = round(float(order * theta.size * theta[1] / (2 * pi)), 6)
        if whole % 1 == 0:
            assert np.abs(push[:2] - waves).max() < 1e-6 * size
        block = at.block
        flat = at.mount_force[0, place].reshape(-1)
        mounted = -flat @ block.arms.reshape(-1, block.freedoms)
        rate = (order * found.speed) ** 2
        moving = -rate * (block.mass @ at.motion[0, place])
        pushed = np.zeros(block.freedoms, complex)
        pushed[:SIX] = push
        scale = np.abs(np.concatenate([pushed, mounted, moving])).max()
        assert np.abs(pushed + mounted - moving).max() < 1e-7 * scale


@laws
@given(whole_engines())
def test_the_power_of_gas_is_that_of_the_crankshaft_and_of_the_load(loaded: Loaded) -> None:
    """p dV of every piston, by its own motion, against mean torque, load and all heat of mounts."""
    engine, found = loaded
    whole = found.volumes.cycle
    theta = (np.arange(7200) + 0.5) * (whole / 7200)
    pressure, crowns = pressure_at(found, theta), pistons(engine).crown
    work = 0.0
    for row, own in enumerate(engine.cylinders):
        along = np.array([np.sin(own.bearing), np.cos(own.bearing)])
        piston = np.asarray(placed(engine, own, theta - theta[0])[1], float) @ along
        after = np.asarray(placed(engine, own, theta + theta[0])[1], float) @ along
        area = pi / 4 * (own.bore or 0.0) ** 2
        chamber = found.volumes.numbers.index(own.chamber or own.number)
        work -= float(crowns[row] * area * (pressure[chamber] * (after - piston)).sum())
    mean = float(gas_torque(found).mean.sum()) * whole
    gross = float(np.abs(over_cycle(found)).sum(axis=0).mean()) * whole
    assert mean == pytest.approx(work, abs=2e-3 * gross)
    try:
        running = driven(engine, found)
    except UnevenError:
        running = None
    if running is not None:
        assert running.load.mean() == pytest.approx(running.gas.mean(), abs=1e-9 * gross)
    if engine.mounts and found.speed is not None:
        at = mounts(engine, speed=found.speed, speeds=[found.speed]).at
        assert at is not None
        assert at.heat.sum() == pytest.approx(at.power.sum(), rel=1e-6, abs=1e-12)


@laws
@given(whole_engines(), number(0.3, 3.0))
def test_loads_are_linear_in_pressure_and_in_the_square_of_the_speed(
    loaded: Loaded, share: float
) -> None:
    engine, found = loaded
    assert found.speed is not None
    still = replace(found, pressure=np.full_like(found.pressure, found.crankcase))
    theta = np.linspace(0, found.volumes.cycle, 37)

    def walls(each: Cycle) -> Complex:
        loads = bearing_loads(engine, cycle=each)
        every = (loads.load, loads.guide, loads.pin)
        return np.concatenate([spectra.value(part, theta) for part in every])

    moving, both = walls(still), walls(found)
    faster = replace(
        found,
        speed=found.speed * share**0.5,
        pressure=found.crankcase + 2 * (found.pressure - found.crankcase),
    )
    size = np.abs(both).max() + np.abs(moving).max()
    expected = share * moving + 2 * (both - moving)
    assert np.abs(walls(faster) - expected).max() < 1e-7 * size * max(share, 2)


@laws
@given(whole_engines(), number(-pi, pi))
def test_turning_the_whole_engine_turns_its_loads_and_leaves_its_torque(
    loaded: Loaded, angle: float
) -> None:
    engine, found = loaded
    leaning = turned_in_space(engine, angle)
    same = again(leaning, found)
    assert np.abs(torque(same) - torque(found)).max() < 1e-7 * size_of(found)
    theta = np.linspace(0, found.volumes.cycle, 37)
    before, after = (bearing_loads(e, cycle=c) for e, c in ((engine, found), (leaning, same)))
    for one, other in ((before.load, after.load), (before.guide, after.guide)):
        upright = spectra.value(one, theta)
        size = np.abs(spectra.value(before.load, theta)).max()
        assert np.abs(spectra.value(other, theta) - upright * np.exp(1j * angle)).max() < (
            1e-6 * size
        )


@laws
@given(whole_engines(), number(-3.0, 3.0))
def test_an_engine_whose_throws_have_turned_is_the_same_at_another_angle(
    loaded: Loaded, angle: float
) -> None:
    drawn, found = loaded
    fires = dict(zip(found.volumes.numbers, found.volumes.fires.tolist(), strict=True))
    try:  # without angles a file does not say in which revolution of a cycle a cylinder fires
        engine = with_values(drawn, firing_angles=tuple(fires[n] for n in drawn.firing_order))
        turned = turned_on(engine, angle)
    except EngineError:
        assume(False)
        return
    orders = gas_torque(found).torque.orders
    wanted = torque(found) * np.exp(1j * orders * engine.sense * angle)
    assert np.abs(torque(again(turned, found)) - wanted).max() < 1e-6 * size_of(found)


@laws
@given(whole_engines())
def test_an_engine_in_the_mirror_has_the_same_torque_and_mirrored_loads(loaded: Loaded) -> None:
    engine, found = loaded
    other = mirrored(engine)
    same = again(other, found)
    assert np.abs(torque(same) - torque(found)).max() < 1e-7 * size_of(found)
    theta = np.linspace(0, found.volumes.cycle, 37)
    one, two = (bearing_loads(e, cycle=c).load for e, c in ((engine, found), (other, same)))
    before, after = spectra.value(one, theta), spectra.value(two, theta)
    assert np.abs(after - np.conj(before)).max() < 1e-6 * np.abs(before).max()


@laws
@given(whole_engines(), number(40.0, 500.0))
def test_a_speed_has_one_state_in_every_function(loaded: Loaded, speed: float) -> None:
    """The torque at a speed, in a range, of a fault and on mounts is that of one cycle."""
    engine, _found = loaded
    one = cycle(engine, speed=speed)
    state = operating_state(engine, speed=speed)
    assert (one.speed, one.shares) == (speed, state.shares)
    ends = [cycle(engine, point=name) if name else one for name, _share in state.shares]
    if len(ends) == 1 and state.point:
        ends = [cycle(engine, point=state.point, speed=speed)]
    mean = sum(share * each.pressure for (_, share), each in zip(state.shares, ends, strict=True))
    assert np.abs(one.pressure - mean).max() < 1e-9 * one.peak
    gas = gas_torque(one).total
    size = size_of(one)
    over = spectra.amplitude(gas_over_speeds(engine, [0.5 * speed, speed, 1.7 * speed]))[1]
    assert np.abs(over - spectra.amplitude(gas)).max() < 1e-7 * size
    if engine.mounts:
        orders = gas.orders.tolist()
        felt = shaken(engine, speed=speed, orders=orders)
        at = mounts(engine, speed=speed, speeds=[speed], orders=orders).at
        assert at is not None
        push = at.excitation.push[0]
        assert np.abs(felt.push - push).max() < 1e-7 * np.abs(push).max()
        moving = total(balance(engine, speed=speed, orders=orders)).force.sense
        rolled = at.excitation.gas[0, :, 5]
        assert np.abs(rolled + moving * spectra.amplitude(gas)).max() < 1e-7 * size


@pytest.mark.release
@laws
@given(whole_engines(), st.sampled_from([0.005, 0.02, 0.08]))
def test_a_flywheel_for_an_irregularity_gives_it(loaded: Loaded, asked: float) -> None:
    engine, found = loaded
    assume(gas_torque(found).mean.sum() > 0)
    try:
        wheel = flywheel_for(engine, found, irregularity=asked)
        running = driven(engine, found, flywheel=wheel)
    except UnevenError:
        assume(False)
        return
    assert running is not None
    if wheel > 0:
        assert running.irregularity == pytest.approx(asked, rel=1e-6)
    else:
        assert running.irregularity <= asked
    drive = with_values(engine.drive, inertia=wheel) if engine.drive and wheel > 0 else None
    if drive is not None:
        own = driven(with_values(engine, drive=drive), found)
        assert own is not None
        assert own.irregularity == pytest.approx(asked, rel=1e-6)


def moving_values(engine: Engine) -> tuple[dict[str, Any], list[str]]:
    """The file of an engine, and the paths of masses, unbalances and throws that its forces have.

    A slave's own masses are left out: those of its knuckle pin are its master's.
    """
    tree = {key: own for key, own in tree_of(toml(engine)).items() if key != "provenance"}
    paths = [
        f"cylinders[{number}].{key}"
        for number, own in enumerate(tree["cylinders"], 1)
        for key in ("reciprocating_mass", "rotating_mass")
        if key in own and not {"parts", "articulated"} & {*own}
    ]
    moving = {"throw": ("radius", "rotating_mass"), "weight": ("unbalance",)}
    paths += [
        f"shaft[{number}].{kind}[{place}].{key}"
        for number, shaft in enumerate(tree["shaft"], 1)
        for kind, keys in moving.items()
        for place, own in enumerate(shaft.get(kind, ()), 1)
        for key in keys
        if key in own
    ]
    return tree, paths


def value_at(tree: Mapping[str, Any], path: str) -> str:
    """What the file has at a path."""
    place: Any = tree
    for key in keys_of(path):
        place = place[key]
    return str(place)


@laws
@given(whole_engines(), st.data())
def test_the_error_of_a_value_moves_forces_as_a_change_of_it_does(
    loaded: Loaded, data: st.DataObject
) -> None:
    """A value with its tolerance, and the file read again with the value a little up and down."""
    engine, _found = loaded
    tree, paths = moving_values(engine)
    assume(paths)
    path = data.draw(st.sampled_from(paths))
    said = value_at(tree, path)
    amount, unit = said.split(" ", 1)
    size = float(amount)
    step = 3e-5 * abs(size)
    assume(step > 0)
    toleranced = changed(tree, {path: f"{said} +- {step!r} {unit}"})
    errors = sources_of(toleranced, tolerances_of(toleranced), engine).errors
    how: dict[str, Any] = {
        "orders": (0.5, 1.0, 2.0, 4.0),
        "reference": default_reference(engine),
        "scale": scales(engine, engine.speed)[0],
    }
    lines = linear(engine, errors, **how)
    low, high = (
        summed_parts(mechanism(engine_of(changed(tree, {path: f"{each!r} {unit}"}))), **how)
        for each in (size - step, size + step)
    )
    bounds = np.array([each.bound for each in errors])
    largest = max(np.abs(both).max() for each in low.values() for both in each)
    for quantity in QUANTITIES:
        for place in (0, 1):
            change = (high[quantity][place] - low[quantity][place]) / 2
            found = bounds @ lines[quantity].rates[place]
            rounding = 1e-10 * np.abs(low[quantity][place]).max() + 1e-16 * largest
            assert np.abs(found - change).max() <= 2e-5 * np.abs(change).max() + rounding, path
