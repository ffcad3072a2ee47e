"""Balance shafts: each takes away the whole vector that turns at its speed, and touches no other."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from crankstar import balance, load, phasor, total
from crankstar.engine import Engine
from crankstar.remedy import RemedyError, with_balance_shaft, with_counterweights

UNTOUCHED = (1.0, 2.0, 4.0)


def vectors(engine: Engine, quantity: str, order: float) -> np.ndarray:
    """The vectors with the crank and against it."""
    one = phasor.selected(getattr(total(balance(engine)), quantity), [order])
    return np.array([one.forward[0], one.backward[0]])


@pytest.mark.parametrize(
    "name", ["single", "harley-45", "i2-360", "triple-120", "v6-60-six-throws", "boxer-2", "yamaha-r1-crossplane"]
)
@pytest.mark.parametrize("ratio", [-1, 1, -2, 2])
def test_a_shaft_takes_away_its_vector_and_no_other(name: str, ratio: int) -> None:
    engine = load(name)
    way = 0 if ratio > 0 else 1
    there = max(abs(vectors(engine, quantity, abs(ratio))[way]) for quantity in ("force", "couple"))
    if there < 1e-12:
        with pytest.raises(RemedyError, match="has no use"):
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
    before, after = (phasor.amplitude(phasor.selected(total(balance(engine)).roll, 2))[0] for engine in (load("i4"), pair))
    assert after == pytest.approx(before, abs=1e-12)  # at one height on both sides, so their arms are alike


def test_heights_of_the_pair_change_the_roll_only() -> None:
    low, high = load("i4"), load("i4")
    for ratio, side in ((2, 3.0), (-2, -3.0)):
        low = with_balance_shaft(low, ratio=ratio, planes=[1.0, -1.0], right=side)
        high = with_balance_shaft(high, ratio=ratio, planes=[1.0, -1.0], right=side, up=2.0 if ratio > 0 else 0.0)
    for quantity in ("force", "couple"):
        assert vectors(low, quantity, 2) == pytest.approx(vectors(high, quantity, 2), abs=1e-14)
    rolls = [phasor.amplitude(phasor.selected(total(balance(engine)).roll, 2))[0] for engine in (low, high)]
    assert abs(rolls[0] - rolls[1]) > 0.1


def test_one_shaft_against_the_crank_and_weights_free_a_three_of_its_couple() -> None:
    three = with_balance_shaft(with_counterweights(load("triple-120"), factor=0.5), ratio=-1, planes=[1.0, -1.0])
    assert np.abs(vectors(three, "couple", 1)) == pytest.approx([0, 0], abs=1e-14)
    assert np.abs(vectors(three, "force", 1)) == pytest.approx([0, 0], abs=1e-14)
    assert len(three.shafts[1].weights) == 2


@pytest.mark.parametrize(
    ("ratio", "planes", "told"),
    [
        (0, [1.0, -1.0], "not 0"),
        (Fraction(17, 2), [1.0, -1.0], "from -8 to 8"),
        (2, [1.0], "two planes or more"),
        (2, [1.0, 1.0], "two planes or more"),
        (3, [1.0, -1.0], "has no use"),
    ],
)
def test_what_cannot_be_done_is_told(ratio: Fraction, planes: list[float], told: str) -> None:
    with pytest.raises(RemedyError, match=told):
        with_balance_shaft(load("i4"), ratio=ratio, planes=planes)
