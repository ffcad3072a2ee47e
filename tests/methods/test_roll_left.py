"""What the report says would remove the rolling moment that is left does remove it."""

from __future__ import annotations

import cmath
from fractions import Fraction

import numpy as np
import pytest

from crankstar import load, spectra
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.files import engine_of
from crankstar.mechanics.balance import balance
from crankstar.mechanics.remains import summed
from crankstar.remedy import clashes, with_balance_shaft, with_roll_cancelled
from crankstar.remedy.fitting import recommended
from crankstar.tables.roll_cures import roll_left


def remedied(name: str) -> Engine:
    """An engine of the catalog with what is recommended."""
    fitted = recommended(load(name))
    return load(name) if fitted is None else fitted.after


def roll(engine: Engine, order: float) -> complex:
    """The rolling moment of an order, in m r^2 w^2."""
    return complex(spectra.amplitude(spectra.selected(summed(balance(engine)).roll, [order]))[0])


def test_a_pair_of_shafts_leaves_no_roll_at_other_heights() -> None:
    engine = remedied("i4")
    assert "order 2: 2.0005 m r² ω² is left; none would be with the two shafts at 2 and -2" in (
        roll_left(engine, speed=None)
    )
    assert abs(roll(engine, 2.0)) == pytest.approx(2.0005, rel=1e-4)
    assert abs(roll(with_roll_cancelled(engine, order=2), 2.0)) < 1e-9


def test_two_shafts_of_half_the_unbalance_about_the_named_place_leave_no_roll() -> None:
    engine = remedied("single")
    told = roll_left(engine, speed=None)
    assert "two shafts in place of balancer -1" in told
    assert told.endswith("on opposite sides of 0.12701 r up, 0 r right and equally far from it.")
    (balancer,) = engine.shafts[1:]
    (weight,) = balancer.weights
    halves = tuple(
        with_values(
            balancer,
            name=f"half {side:g}",
            up=0.12701,
            right=side,
            weights=(with_values(weight, unbalance=weight.unbalance / 2),),
        )
        for side in (3.0, -3.0)
    )
    pair = with_values(engine, shafts=(engine.shafts[0], *halves))
    assert abs(roll(engine, 1.0)) > 1
    assert abs(roll(pair, 1.0)) < 1e-5
    low = with_values(
        pair, shafts=(pair.shafts[0], *(with_values(half, up=-3.0) for half in halves))
    )
    told = roll_left(low, speed=None)
    assert told.endswith("with the middle of half 3, half -3 at 0.12701 r up, 0 r right.")


@pytest.mark.parametrize(("name", "order"), [("i6", 3.0), ("v8-cross-plane", 4.0)])
def test_two_opposite_shafts_remove_a_roll_of_the_pistons(name: str, order: float) -> None:
    engine = remedied(name)
    told = roll_left(engine, speed=None)
    assert f"order {order:g}: " in told
    assert f"two balance shafts at {order:g} times crank speed, apart" in told
    gap = 4.0

    def turned(angle: float, unbalance: float) -> Engine:
        shafts = tuple(
            Shaft(
                name=f"roll {side}",
                speed_ratio=Fraction(order),
                right=side * gap / 2,
                weights=(Weight(unbalance=unbalance, angle=(angle + half) % (2 * np.pi)),),
            )
            for side, half in ((1, 0.0), (-1, np.pi))
        )
        return with_values(engine, shafts=(*engine.shafts, *shafts))

    there = roll(engine, order)
    unit = roll(turned(0.0, 1.0), order) - there
    angle = cmath.phase(-there / unit)
    ended = min(
        (turned(sign * angle, abs(there / unit)) for sign in (1, -1)),
        key=lambda each: abs(roll(each, order)),
    )
    assert abs(roll(ended, order)) < 1e-9 * abs(there)
    for quantity in ("force", "couple"):
        before, after = (getattr(summed(balance(each)), quantity) for each in (engine, ended))
        for signal in (before, after):
            chosen = spectra.selected(signal, [order])
            assert np.allclose(
                [chosen.forward[0], chosen.backward[0]],
                [
                    spectra.selected(before, [order]).forward[0],
                    spectra.selected(before, [order]).backward[0],
                ],
                atol=1e-9,
            )


def test_recommended_shafts_are_clear_of_those_that_the_engine_has() -> None:
    """A balancer of the file lies where one of the new pair would be."""
    engine = with_balance_shaft(load("i2-270"), ratio=-1, planes=[1.0, -1.0], up=-2.2, right=0.9)
    fitted = recommended(engine)
    assert fitted is not None
    assert [str(ratio) for ratio in fitted.ratios] == ["2", "-2"]
    new = {shaft.name for shaft in fitted.after.shafts[len(engine.shafts) :]}
    assert not [clash for clash in clashes(fitted.after) if {clash.first, clash.second} & new]


def test_a_shaft_is_to_be_moved_where_its_place_without_roll_is_clear_of_the_crank() -> None:
    """The cylinder passes the crank axis at one and a half crank radii."""
    cylinder = {"stroke": "80 mm", "bore": "60 mm", "rod_length": "240 mm", "offset": "60 mm"}
    layout = {"type": "inline", "throws": ["0 deg"], "bore_pitch": "90 mm"}
    engine = engine_of(
        {
            "name": "offset",
            "cylinder": {**cylinder, "reciprocating_mass": "500 g"},
            "layout": layout,
        }
    )
    fitted = recommended(engine)
    assert fitted is not None
    told = roll_left(fitted.after, speed=100.0)
    assert told.endswith("none would be with balancer -1 at 3.2321 mm up, 121.83 mm right.")
    crank, own = fitted.after.shafts
    moved = with_values(fitted.after, shafts=(crank, with_values(own, up=0.0032321, right=0.12183)))
    assert abs(roll(fitted.after, 1.0)) > 1e3 * abs(roll(moved, 1.0))
