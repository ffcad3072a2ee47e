"""Laws of torsional vibration, of any tree of masses and shafts."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.strategies import number
from tests.twisting import chains, pendulums, pushes, row

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_criticals import criticals
from crankstar.dynamics.torsion_modes import Mode, holzer, torsion_modes
from crankstar.dynamics.torsion_response import Response, response
from crankstar.dynamics.torsion_system import TorsionChain, TorsionError
from crankstar.engine.torsion import Chain
from crankstar.spectra import Complex, Real

SPEEDS = np.array([20.0, 150.0, 900.0])


def squared(chain: TorsionChain) -> Real:
    """The squared circular frequencies."""
    return np.array([mode.speed**2 for mode in torsion_modes(chain)])


def freedoms(chain: TorsionChain, mode: Mode) -> Real:
    """The shape of a mode by freedom."""
    first = [chain.freedom.index(freedom) for freedom in range(chain.freedoms)]
    return mode.shape[first] / chain.ratio[first]


@given(chains())
def test_modes_are_orthogonal_in_mass_and_in_stiffness(tree: Chain) -> None:
    chain = torsion_chain(tree)
    inertia, stiffness, _damping = chain.matrices()
    shapes = np.array([freedoms(chain, mode) for mode in torsion_modes(chain)])
    shapes /= np.sqrt(np.einsum("ni,ij,nj->n", shapes, inertia, shapes))[:, None]
    assert shapes @ inertia @ shapes.T == pytest.approx(np.eye(len(shapes)), abs=1e-9)
    found = squared(chain)
    assert shapes @ stiffness @ shapes.T == pytest.approx(np.diag(found), abs=1e-9 * found.max())


@given(chains())
def test_no_mode_turns_the_whole(tree: Chain) -> None:
    chain = torsion_chain(tree)
    inertia = chain.matrices()[0]
    for mode in torsion_modes(chain):
        turns = freedoms(chain, mode)
        momentum = inertia @ turns
        assert abs(momentum.sum()) < 1e-9 * np.abs(momentum).sum()


@given(chains(), st.integers(0, 10**6))
def test_rayleighs_quotient_lies_between_least_and_greatest_frequency(
    tree: Chain, seed: int
) -> None:
    chain = torsion_chain(tree)
    inertia, stiffness, _damping = chain.matrices()
    found = squared(chain)
    turns = np.random.default_rng(seed).normal(size=chain.freedoms)
    for ring in chain.rings:
        turns[ring] = 0.0
    held = np.array([freedom not in chain.rings for freedom in range(chain.freedoms)])
    assume(not chain.rings or len(found) == held.sum() - 1)  # nothing hangs on a ring by a shaft
    turns[held] -= (inertia @ turns)[held].sum() / np.diag(inertia)[held].sum()
    quotient = turns @ stiffness @ turns / (turns @ inertia @ turns)
    assert found[0] * (1 - 1e-9) <= quotient <= found[-1] * (1 + 1e-9)


@given(chains(), number(1.5, 50.0))
def test_frequencies_go_with_the_root_of_stiffness_over_inertia(tree: Chain, by: float) -> None:
    chain = torsion_chain(tree)
    stiffer = replace(
        chain, sections=tuple(s._replace(stiffness=s.stiffness * by) for s in chain.sections)
    )
    heavier = replace(chain, inertia=chain.inertia * by)
    assert squared(stiffer) == pytest.approx(by * squared(chain), rel=1e-8)
    assert squared(heavier) == pytest.approx(squared(chain) / by, rel=1e-8)


@given(chains(), st.data(), number(1.1, 9.0))
def test_no_frequency_falls_with_stiffness_or_rises_with_inertia(
    tree: Chain, data: st.DataObject, by: float
) -> None:
    chain = torsion_chain(tree)
    place = data.draw(st.integers(0, len(chain.sections) - 1))
    sections = list(chain.sections)
    sections[place] = sections[place]._replace(stiffness=sections[place].stiffness * by)
    before = squared(chain)
    slack = 1e-9 * before.max()
    assert (squared(replace(chain, sections=tuple(sections))) >= before - slack).all()
    inertia = chain.inertia.copy()
    inertia[data.draw(st.integers(0, inertia.size - 1))] *= by
    assert (squared(replace(chain, inertia=inertia)) <= before + slack).all()


@given(st.lists(st.tuples(number(0.1, 1.0), number(1e5, 5e5)), min_size=2, max_size=9))
def test_holzers_table_ends_with_nothing_and_mode_n_has_n_nodes(
    masses: list[tuple[float, float]],
) -> None:
    """Of chains as crankshafts are: the recurrence loses digits where the first mass stands.

    What it ends with is nothing but those digits, whatever the torques are; but it is the exact one
    of masses and shafts a few roundings away, so that it changes its sign at the mode.
    """
    inertias, stiffnesses = zip(*masses, strict=True)
    chain = row(inertias, stiffnesses[1:])
    for mode in torsion_modes(chain):
        rows = holzer(chain, speed=mode.speed)
        beside = [holzer(chain, speed=mode.speed * by)[-1].sum for by in (1 - 1e-9, 1 + 1e-9)]
        assert beside[0] * beside[1] < 0  # the speed of the mode is where it is nothing
        assert len(mode.nodes) == mode.number
        shape = [row.amplitude for row in rows]
        turns = freedoms(chain, mode)
        assert np.array(shape) * turns[0] == pytest.approx(turns, abs=1e-6 * np.abs(turns).max())
        off = holzer(chain, speed=mode.speed * 1.01)
        assert abs(off[-1].sum) > 1e-6 * max(abs(row.torque) for row in off)


def test_holzers_table_of_a_chain_with_branches_is_refused() -> None:
    discs = [{"name": "0", "inertia": 1.0}]
    discs += [{"name": f"{n}", "inertia": 1.0, "to": "0", "stiffness": 1e3} for n in (1, 2, 3)]
    chain = torsion_chain(Chain.model_validate({"name": "star", "disc": discs}))
    with pytest.raises(TorsionError, match="branches"):
        holzer(chain, speed=1.0)


@given(chains())
def test_a_gear_is_the_plain_chain_with_inertia_and_stiffness_by_its_square(tree: Chain) -> None:
    chain = torsion_chain(tree)
    total = chain.ratio
    sections = tuple(
        s._replace(
            ratio=1.0,
            stiffness=s.stiffness * total[s.after] ** 2,
            damping=s.damping * total[s.after] ** 2,
        )
        for s in chain.sections
    )
    plain = replace(
        chain,
        ratio=np.ones_like(total),
        inertia=chain.inertia * total**2,
        sections=sections,
        absolute_damping=chain.absolute_damping * total**2,
    )
    assert squared(plain) == pytest.approx(squared(chain), rel=1e-8)
    push = pushes(chain, 1)
    assert push.inertia is not None
    referred = replace(push, gas=push.gas * total[:, None], inertia=push.inertia * total[:, None])
    one = response(chain, push, speeds=SPEEDS)
    other = response(plain, referred, speeds=SPEEDS)
    assert one.turns == pytest.approx(other.turns * total, rel=1e-9, abs=1e-15)
    # the sum of w |torque| |turn| / 2, of turns that agree so far; most of it may cancel
    pushed = one.vibration[..., None] * np.abs(one.driving)
    missed = (pushed * (1e-9 * np.abs(one.turns) + 1e-15)).sum(axis=(1, 2))
    assert (np.abs(one.power - other.power) <= missed).all()


def dynamic_stiffness(chain: TorsionChain, found: Response) -> Complex:
    """The matrices [speed, order, mass, mass] of the chain that vibrates."""
    _inertia, _stiffness, damping = chain.matrices()
    inertia = np.array([np.diag(each) for each in chain.inertias(found.orders)])
    w = found.vibration[..., None, None]
    return chain.complex_stiffness() - w**2 * inertia + 1j * w * damping


def solved(chain: TorsionChain, found: Response) -> Complex:
    """The turns [speed, order, mass] by LAPACK, from the matrices of the chain."""
    push = found.driving @ chain.transform
    free = np.linalg.solve(dynamic_stiffness(chain, found), push[..., None])
    return free[..., 0] @ chain.transform.T


@given(chains(), st.integers(0, 10**6))
def test_the_response_is_that_of_the_matrices(tree: Chain, seed: int) -> None:
    chain = torsion_chain(tree)
    found = response(chain, pushes(chain, seed), speeds=SPEEDS)
    wanted = solved(chain, found)
    scale = np.abs(wanted).max(axis=-1, keepdims=True)
    rounding = 1e-15 * np.linalg.cond(dynamic_stiffness(chain, found))  # of a resonance
    assert (np.abs(found.turns - wanted) < (1e-9 + rounding[..., None]) * scale).all()


@given(chains(), st.data())
def test_the_response_with_pendulums_is_that_of_the_matrices(
    tree: Chain, data: st.DataObject
) -> None:
    absorbers = data.draw(st.lists(pendulums(tuple(d.name for d in tree.discs)), min_size=1))
    chain = torsion_chain(tree.model_copy(update={"pendulums": tuple(absorbers)}))
    found = response(chain, pushes(chain, 3), speeds=SPEEDS)
    wanted = solved(chain, found)
    scale = np.abs(wanted).max(axis=-1, keepdims=True)
    rounding = 1e-14 * np.linalg.cond(dynamic_stiffness(chain, found))
    assert (np.abs(found.turns - wanted) < (1e-8 + rounding[..., None]) * scale).all()


@given(chains(), st.integers(0, 10**6))
def test_the_power_that_goes_in_is_the_heat_that_comes_out(tree: Chain, seed: int) -> None:
    chain = torsion_chain(tree)
    found = response(chain, pushes(chain, seed), speeds=SPEEDS)
    heat = found.heat.sum(axis=-1) + found.absolute_heat.sum(axis=-1)
    through = np.abs(found.driving * found.vibration[..., None] * found.turns).sum(axis=(1, 2))
    assert (np.abs(found.power - heat) < 1e-9 * through).all()
    assert (found.heat >= 0).all()
    assert (found.absolute_heat >= 0).all()


@given(chains(), st.integers(0, 10**6), number(0.1, 9.0))
def test_the_response_is_linear_in_the_torque(tree: Chain, seed: int, by: float) -> None:
    chain = torsion_chain(tree)
    one, other = pushes(chain, seed), pushes(chain, seed + 1)
    assert one.inertia is not None
    assert other.inertia is not None
    both = replace(one, gas=one.gas + by * other.gas, inertia=one.inertia + by * other.inertia)
    first, second, sum_ = (response(chain, each, speeds=SPEEDS) for each in (one, other, both))
    wanted = first.torque + by * second.torque
    assert np.abs(sum_.torque - wanted).max() < 1e-9 * (
        np.abs(first.torque).max() + by * np.abs(second.torque).max()
    )


@given(chains(), st.integers(0, 10**6))
def test_the_peak_over_the_cycle_is_at_most_the_sum_of_the_amplitudes(
    tree: Chain, seed: int
) -> None:
    chain = torsion_chain(tree)
    found = response(chain, pushes(chain, seed), speeds=SPEEDS)
    assert (found.peak <= found.added * (1 + 1e-9)).all()
    theta = np.linspace(0, 4 * pi, 2881)
    for section in range(len(chain.sections)):
        course = np.abs(found.course(section, theta)).max(axis=-1)
        assert (course <= found.peak[:, section] * (1 + 1e-9)).all()
        assert course == pytest.approx(found.peak[:, section], rel=1e-3)


@given(chains(rings=False, damped=False))
def test_a_critical_speed_is_where_a_hardly_damped_chain_resounds(tree: Chain) -> None:
    """Near it the response is the mode, as high as modal torque over modal damping says."""
    loss = 1e-7
    chain = torsion_chain(tree.model_copy(update={"loss_factor": loss}))
    found = squared(chain)
    assume(found.size == 1 or (np.diff(found) > 1e-2 * found[1:]).all())
    push = pushes(chain, 5, orders=(2.0,))
    for each in criticals(chain, orders=[2.0], low=0.0, high=1e9, excitation=push):
        mode = torsion_modes(chain)[each.mode - 1]
        at = response(chain, push, speeds=np.array([each.speed]))
        assert each.speed * 2.0 == pytest.approx(mode.speed, rel=1e-12)
        wanted = (each.equilibrium or 0.0) / loss * np.abs(mode.shape)
        assume((each.equilibrium or 0.0) * np.abs(mode.shape).max() > 0)
        scale = wanted.max()
        assert np.abs(at.turns[0, 0]) == pytest.approx(wanted, abs=1e-2 * scale)


@given(number(0.1, 5.0), number(0.1, 5.0), number(1e3, 1e6))
def test_nodes_of_two_masses_divide_the_shaft_as_the_inertias_say(
    one: float, other: float, stiffness: float
) -> None:
    [mode] = torsion_modes(row([one, other], [stiffness]))
    assert mode.nodes[0].share == pytest.approx(other / (one + other), rel=1e-9)
