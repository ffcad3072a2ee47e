"""Balance shafts stand where the block rolls least: in closed form, by momentum, by search."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.newton import road

from crankstar import load
from crankstar.engine.copies import with_rotation_reversed, with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Block
from crankstar.mechanics.excitation import Reference
from crankstar.remedy import (
    Box,
    Placing,
    RemedyError,
    needs,
    placed,
    roll_reference,
    with_balance_shaft,
    with_web_weights,
)
from crankstar.remedy.fitting import with_placed_shafts
from crankstar.remedy.placing import push, roll, with_places

FAR = Box(up=(-50.0, 50.0), right=(-50.0, 50.0))


def twin(*, reverse: bool = False, rod_ratio: float = 4.0) -> Engine:
    """A 360 degree twin whose counterweights have left the backward half of its primary force."""
    engine = load("i2-360", changes={"cylinder.rod_ratio": rod_ratio})
    return with_web_weights(with_rotation_reversed(engine) if reverse else engine, factor=0.5)


def one_shaft(engine: Engine, box: Box) -> tuple[Engine, Placing]:
    after, (placing,) = with_placed_shafts(engine, ratios=[Fraction(-1)], boxes=[box])
    return after, placing


def momentum_roll(engine: Engine, order: float) -> float:
    """The rolling moment of an order about the crank axis, from the momentum of all bodies."""
    found = road(engine, reference=Reference(0.0), speed=1.0)
    counter_clockwise = np.sum([part.moment[:, 2] for part in found.pushes], axis=0)
    torque = np.sum([part.torque for part in found.pushes], axis=0)
    signal = -counter_clockwise - engine.sense * torque
    return float(2 * abs((signal * np.exp(-1j * order * found.theta)).mean()))


@pytest.mark.many(first=4)
@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("rod_ratio", [3.0, 4.0, 7.0])
def test_the_one_shaft_of_a_twin_belongs_half_lambda_above_the_crank(
    rod_ratio: float, *, reverse: bool
) -> None:
    """The inertia torque of order 1 is r lambda/4 (1 + lambda^2/4 + ...), the shaft's force 1/2."""
    after, placing = one_shaft(twin(reverse=reverse, rod_ratio=rod_ratio), FAR)
    part = 1 / rod_ratio
    closed = part / 2 * (1 + part**2 / 4 + 15 * part**4 / 128)
    assert placing.places == (pytest.approx(closed, rel=part**6),)
    assert placing.roll == 0.0
    assert momentum_roll(after, 1.0) < 1e-9


@pytest.mark.many(first=1)
@pytest.mark.parametrize("rod_ratio", [3.0, 4.0, 7.0])
def test_the_pair_of_a_four_is_nearly_a_rod_length_apart_in_height(rod_ratio: float) -> None:
    """2 m r^2 w^2 (1 + ...) of roll over the force of a shaft, 2 m r w^2 A_2."""
    engine = load("i4", changes={"cylinder.rod_ratio": rod_ratio})
    after, (placing,) = with_placed_shafts(engine, ratios=[Fraction(2), Fraction(-2)], boxes=[FAR])
    up, low = placing.places
    part = 1 / rod_ratio
    assert up.real - low.real == pytest.approx(rod_ratio * (1 - part**2 / 4), rel=part**4)
    assert up.imag == low.imag == 0.0
    assert after.shafts[1].speed_ratio == 2  # the upper one turns with the crankshaft
    assert momentum_roll(after, 2.0) < 1e-9


@given(st.floats(-4, 4), st.floats(-4, 4))
def test_roll_is_the_force_of_the_shaft_times_its_distance_from_the_place_without_roll(
    up: float, right: float
) -> None:
    after, placing = one_shaft(twin(), Box((up, up), (right, right)))
    free = placing.without_roll
    assert free is not None
    force = abs(push(after.shafts[-1]))
    assert force == pytest.approx(1.0)
    (place,) = placing.places
    assert place == pytest.approx(complex(up, right), abs=1e-9)  # next to nothing is nothing
    assert placing.roll == pytest.approx(force * abs(place - free), abs=1e-12)
    assert placing.on_axis == pytest.approx(force * abs(free))


def test_that_distance_is_found_by_momentum_too() -> None:
    after, placing = one_shaft(twin(), Box((-2.5, -2.5), (1.5, 1.5)))
    assert momentum_roll(after, 1.0) == pytest.approx(placing.roll, rel=1e-9)


edges = st.tuples(st.floats(-5, 5), st.floats(0, 4)).map(lambda pair: (pair[0], sum(pair)))
boxes = st.builds(Box, edges, edges)


@given(
    st.sampled_from(["i4", "triple-120", "harley-45", "single", "boxer-2", "i2-270"]),
    st.sampled_from([(-1,), (2, -2), (-1, -1), (2, 2, -2)]),
    st.data(),
)
def test_no_places_in_the_boxes_leave_less_roll(
    name: str, ratios: tuple[int, ...], data: st.DataObject
) -> None:
    """Found again by numerical descent on the spectrum of the roll."""
    engine = load(name)
    own = data.draw(st.lists(boxes, min_size=len(ratios), max_size=len(ratios)))
    wanted = {Fraction(ratio) for ratio in ratios}
    assume(wanted <= {need.ratio for need in needs(engine)})
    after, (placing,) = with_placed_shafts(
        engine, ratios=[Fraction(ratio) for ratio in ratios], boxes=own
    )
    for place, box in zip(placing.places, own, strict=True):
        assert box.up[0] - 1e-9 <= place.real <= box.up[1] + 1e-9
        assert box.right[0] - 1e-9 <= place.imag <= box.right[1] + 1e-9

    def square(at: np.ndarray) -> float:
        moved = with_places(
            after, dict(zip(placing.shafts, at.reshape(-1, 2).tolist(), strict=True))
        )
        return abs(roll(moved, placing.order, roll_reference(after))) ** 2

    limits = [limit for box in own for limit in box]
    start = [sum(limit) / 2 for limit in limits]
    other = minimize(square, start, bounds=limits, method="L-BFGS-B", options={"maxfun": 200})
    assert np.sqrt(other.fun) >= placing.roll - 1e-6
    there = np.array([[place.real, place.imag] for place in placing.places]).ravel()
    assert np.sqrt(square(there)) == pytest.approx(placing.roll, abs=1e-8)
    assert placing.roll <= np.sqrt(square(np.array(start))) + 1e-9


def test_two_shafts_of_one_ratio_count_as_one_at_the_mean_of_their_places() -> None:
    front, rear = Box((-1, 1), (2, 3)), Box((-1, 1), (-3, -2))
    after, (placing,) = with_placed_shafts(
        twin(), ratios=[Fraction(-1), Fraction(-1)], boxes=[front, rear]
    )
    assert placing.roll == 0.0
    assert sum(placing.places) / 2 == pytest.approx(placing.without_roll)
    assert [abs(push(shaft)) for shaft in after.shafts[1:]] == pytest.approx([0.5, 0.5])
    assert momentum_roll(after, 1.0) < 1e-9


def test_a_couple_does_not_care_where_its_shaft_is() -> None:
    for box in (Box((-2, -2), (0, 0)), Box((3, 3), (1, 1))):
        engine = with_web_weights(load("triple-120"), factor=0.5)
        _after, placing = one_shaft(engine, box)
        assert placing.without_roll is None
        assert placing.roll == pytest.approx(placing.on_axis, abs=1e-12)


def test_without_other_weights_the_roll_counts_about_the_centre_of_mass() -> None:
    """Half of the primary force is left, whose moment depends on the axis."""
    engine = load("i2-360")
    block = with_values(engine, block=Block(mass=100.0, up=2.0, right=0.5))
    assert roll_reference(block)[1:] == (2.0, 0.5)
    (_, plain), (_, massive) = (one_shaft(each, FAR) for each in (engine, block))
    assert plain.places != massive.places
    after, placing = one_shaft(block, FAR)
    assert placing.roll == 0.0
    assert abs(roll(after, Fraction(1), Reference(0.0, 2.0, 0.5))) < 1e-12
    assert abs(roll(after, Fraction(1), Reference(0.0))) > 1.0


def test_what_cannot_be_placed_is_told() -> None:
    shaft = with_balance_shaft(twin(), ratio=-1, planes=[0.0])
    for own, said in (
        ([Box((2, 1), (0, 0))], "smaller length first"),
        ([Box((0, float("nan")), (0, 0))], "smaller length first"),
        ([FAR, FAR], "2 boxes for 1 balance shafts"),
    ):
        with pytest.raises(RemedyError, match=said):
            placed(shaft, shafts=["balancer -1"], boxes=own)
