"""Balance shafts: each cancels the whole vector that turns at its speed, and no other."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from tests.newton import road

from crankstar import load, spectra, total
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Reference, rolling_moment
from crankstar.remedy import (
    RemedyError,
    needs,
    with_balance_shaft,
    with_counterweights,
    with_roll_cancelled,
)
from crankstar.remedy.fitting import ShaftPlaces, with_shafts

pytestmark = pytest.mark.quick

UNTOUCHED = (1.0, 2.0, 4.0)


def with_all_shafts(engine: Engine, *planes: float, apart: float = 0.0) -> Engine:
    """The engine with all the balance shafts that it needs in the first and second order."""
    if all(need.ratio == 1 for need in needs(engine)):
        return engine
    return with_shafts(engine, ratios="all", places=ShaftPlaces(planes=planes, apart=apart))


def vectors(engine: Engine, quantity: str, order: float) -> np.ndarray:
    """The vectors with the crank and against it."""
    one = spectra.selected(getattr(total(balance(engine)), quantity), [order])
    return np.array([one.forward[0], one.backward[0]])


@pytest.mark.many(first=12)
@pytest.mark.parametrize(
    "name",
    [
        "single",
        "harley-45",
        "i2-360",
        "triple-120",
        "v6-60-six-throws",
        "boxer-2",
        "yamaha-r1-crossplane",
    ],
)
@pytest.mark.parametrize("ratio", [-1, 1, -2, 2])
def test_a_shaft_takes_away_its_vector_and_no_other(name: str, ratio: int) -> None:
    engine = load(name)
    way = 0 if ratio > 0 else 1
    there = max(abs(vectors(engine, quantity, abs(ratio))[way]) for quantity in ("force", "couple"))
    if there < 1e-12:
        with pytest.raises(RemedyError, match="leave the shaft out"):
            with_balance_shaft(engine, ratio=ratio, planes=[1.0, -1.0])
        return
    balanced = with_balance_shaft(engine, ratio=ratio, planes=[1.0, 0.25, -1.0], up=0.5, right=-2.0)
    for quantity in ("force", "couple"):
        for order in UNTOUCHED:
            before, after = vectors(engine, quantity, order), vectors(balanced, quantity, order)
            for side in (0, 1):
                wanted = 0.0 if (order, side) == (abs(ratio), way) else before[side]
                assert after[side] == pytest.approx(wanted, abs=1e-13)


def test_a_lanchester_pair_takes_away_the_second_order_of_a_four_without_roll() -> None:
    pair = load("i4")
    for ratio, side in ((2, 3.0), (-2, -3.0)):
        pair = with_balance_shaft(pair, ratio=ratio, planes=[1.0, -1.0], right=side)
    assert np.abs(vectors(pair, "force", 2)) == pytest.approx([0, 0], abs=1e-15)
    before, after = (
        spectra.amplitude(spectra.selected(total(balance(engine)).axis_moment, 2))[0]
        for engine in (load("i4"), pair)
    )
    assert after == pytest.approx(
        before, abs=1e-12
    )  # at one height on both sides, so their arms are alike


def test_heights_of_the_pair_change_the_roll_only() -> None:
    low, high = load("i4"), load("i4")
    for ratio, side in ((2, 3.0), (-2, -3.0)):
        low = with_balance_shaft(low, ratio=ratio, planes=[1.0, -1.0], right=side)
        high = with_balance_shaft(
            high, ratio=ratio, planes=[1.0, -1.0], right=side, up=2.0 if ratio > 0 else 0.0
        )
    for quantity in ("force", "couple"):
        assert vectors(low, quantity, 2) == pytest.approx(vectors(high, quantity, 2), abs=1e-14)
    rolls = [
        spectra.amplitude(spectra.selected(total(balance(engine)).axis_moment, 2))[0]
        for engine in (low, high)
    ]
    assert abs(rolls[0] - rolls[1]) > 0.1


def test_one_shaft_against_the_crank_and_weights_free_a_three_of_its_couple() -> None:
    three = with_balance_shaft(
        with_counterweights(load("triple-120"), factor=0.5), ratio=-1, planes=[1.0, -1.0]
    )
    assert np.abs(vectors(three, "couple", 1)) == pytest.approx([0, 0], abs=1e-14)
    assert np.abs(vectors(three, "force", 1)) == pytest.approx([0, 0], abs=1e-14)
    assert len(three.shafts[1].weights) == 2


@pytest.mark.parametrize(
    ("ratio", "planes", "told"),
    [
        (0, [1.0, -1.0], "not 0"),
        (Fraction(17, 2), [1.0, -1.0], "from -8 to 8"),
        (2, [], "give two"),
        (2, [1.0], "give two planes or more"),
        (2, [1.0, 1.0], "all different"),
        (3, [1.0, -1.0], "leave the shaft out"),
    ],
)
def test_what_cannot_be_done_is_told(ratio: Fraction, planes: list[float], told: str) -> None:
    with pytest.raises(RemedyError, match=told):
        with_balance_shaft(load("i4"), ratio=ratio, planes=planes)


NEEDS = {
    "single": ["1", "-1", "2", "-2"],
    "i4": ["2", "-2"],
    "i6": [],
    "v8-cross-plane": ["1"],
    "v8-flat-plane": ["2", "-2"],
    "v12-60": [],
    "boxer-6": [],
    "yamaha-r1-crossplane": ["1", "-1"],
    "triple-120": ["1", "-1", "2", "-2"],
    "i2-360": ["1", "-1", "2", "-2"],
    "radial-9": ["1", "2", "-2"],  # the articulated rods leave a little of the second order
}


@pytest.mark.parametrize("name", NEEDS)
def test_what_an_engine_needs_is_known(name: str) -> None:
    assert [str(need.ratio) for need in needs(load(name))] == NEEDS[name]


def test_half_the_mass_leaves_one_shaft_to_be_wanted() -> None:
    for name in ("single", "harley-45", "triple-120", "yamaha-r1-crossplane", "gm-3800"):
        left = needs(with_counterweights(load(name), factor=0.5), highest=1)
        assert [str(need.ratio) for need in left] == ["-1"]


@pytest.mark.many(first=6)
@pytest.mark.parametrize(
    "name",
    ["single", "i4", "i2-270", "triple-120", "gm-3800", "vw-vr6", "audi-25-tfsi", "v8-cross-plane"],
)
def test_all_the_shafts_an_engine_needs_leave_nothing_up_to_the_second_order(name: str) -> None:
    engine = load(name)
    half = engine.pitch / 2
    planes = [max(c.z for c in engine.cylinders) + half, min(c.z for c in engine.cylinders) - half]
    cured = with_all_shafts(with_counterweights(engine, factor=0.5), *planes)
    for quantity in ("force", "couple"):
        for order in (1, 2):
            before = (
                np.abs(vectors(engine, quantity, 1)).max()
                + np.abs(vectors(engine, quantity, 2)).max()
                + 1.0
            )
            if (
                name != "vw-vr6"
                # its axes miss the crankshaft: counterweights by factor leave a little forward
            ):
                assert np.abs(vectors(cured, quantity, order)).max() <= 1e-12 * before
            assert np.abs(vectors(cured, quantity, order))[1] <= 1e-12 * before


def test_a_single_plane_will_do_where_the_force_acts_in_it() -> None:
    pair = with_all_shafts(load("i4"), 0.0)
    assert [len(shaft.weights) for shaft in pair.shafts[1:]] == [1, 1]
    assert np.abs(vectors(pair, "force", 2)) == pytest.approx([0, 0], abs=1e-15)
    with pytest.raises(RemedyError, match="give two planes or more"):
        with_all_shafts(load("triple-120"), 0.0)


@pytest.mark.many(first=7)
@pytest.mark.parametrize("name", ["i4", "honda-b18c", "single", "v8-flat-plane", "i2-360"])
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_unequal_heights_take_away_the_roll_of_the_block(name: str, rotation: str) -> None:
    turned = load(name).model_copy(
        update={"rotation": rotation, "firing_order": (), "firing_angles": None}
    )
    planes = [
        max(c.z for c in turned.cylinders) + turned.pitch,
        min(c.z for c in turned.cylinders) - turned.pitch,
    ]
    pair = turned
    radius = turned.throw(turned.first).radius
    for ratio, side in ((2, 1.5), (-2, -1.5)):
        pair = with_balance_shaft(
            pair, ratio=ratio, planes=planes, right=side * radius, up=0.4 * radius
        )
    level = with_roll_cancelled(pair, order=2)
    for quantity in ("force", "couple"):
        assert vectors(level, quantity, 2) == pytest.approx(vectors(pair, quantity, 2), abs=1e-13)
    before, after = (
        complex(spectra.amplitude(spectra.selected(rolling_moment(total(balance(one))), [2.0]))[0])
        for one in (pair, level)
    )
    assert abs(before) > 0.1
    assert abs(after) < 1e-12
    if name != "v8-flat-plane":  # whose force is level: both shafts go down to the crankshaft
        assert sum(shaft.up for shaft in level.shafts[1:]) == pytest.approx(
            0.8 * radius
        )  # moved apart, not away


def test_the_roll_that_is_left_is_nothing_by_momentum() -> None:
    level = with_roll_cancelled(with_all_shafts(load("honda-b18c"), 0.0, apart=3.0), order=2)
    walked = road(level, reference=Reference(0.0), speed=1.0)
    # Moment about the axis towards the viewer is counter-clockwise; a flywheel that takes the
    # torque gives it back to the block.
    moment = -np.sum([np.asarray(push.moment, float)[:, 2] for push in walked.pushes], axis=0)
    torque = np.sum([np.asarray(push.torque, float) for push in walked.pushes], axis=0)
    turns = round(float(walked.theta[-1] / (2 * np.pi)))
    spectrum = np.abs(np.fft.rfft(moment - level.sense * torque)) / walked.theta.size
    pistons = np.abs(np.fft.rfft(torque)) / walked.theta.size
    assert pistons[2 * turns] > 0.1 * pistons.max()
    assert spectrum[2 * turns] < 1e-10 * pistons.max()


def test_a_level_pair_nearly_a_rod_length_apart() -> None:
    """To the lowest order in lambda the heights differ by l.

    Torque 2 m r^2 against 4 m r A_2 with A_2 = r/l.
    """
    for ratio in (4.0, 8.0, 20.0):
        four = load("i4")
        rods = tuple(
            c.model_copy(update={"rod_length": ratio * four.throw(c).radius})
            for c in four.cylinders
        )
        level = with_roll_cancelled(
            with_all_shafts(four.model_copy(update={"cylinders": rods}), 0.0), order=2
        )
        assert level.shafts[1].up - level.shafts[2].up == pytest.approx(
            ratio, rel=0.26 / ratio**2 + 1e-9
        )
    assert level.shafts[1].speed_ratio == 2  # the upper shaft turns with the crankshaft


def test_heights_that_cannot_help_are_told() -> None:
    with pytest.raises(RemedyError, match="no pair of balance shafts of speed ratios 2 and -2"):
        with_roll_cancelled(load("i4"), order=2)
    one = with_balance_shaft(load("i4"), ratio=2, planes=[1.0, -1.0])
    with pytest.raises(RemedyError, match="no pair"):
        with_roll_cancelled(one, order=2)
    boxer = with_all_shafts(load("boxer-2"), 1.5, -1.5)
    with pytest.raises(
        RemedyError, match="cannot cancel the rolling moment"
    ):  # couples of the second order, and a roll
        with_roll_cancelled(boxer, order=2)
