"""Who fires after whom."""

import pytest
from hypothesis import given
from tests.strategies import engines

from crankstar.files.catalog import load
from crankstar.firing.intervals import firing
from crankstar.firing.succession import followers, in_succession, neighbours, partners

pytestmark = pytest.mark.quick


@given(engines())
def test_the_intervals_of_every_bank_add_up_to_one_cycle(engine):
    fired = firing(engine)
    groups = [None, *engine.banks.values()]
    for group in groups:
        steps = followers(fired, group)
        if steps:
            assert abs(sum(step.interval_deg for step in steps) - engine.cycle_angle) < 1e-6
            assert [step.then for step in steps] == [
                *[step.first for step in steps][1:],
                steps[0].first,
            ]


def test_the_left_bank_of_the_cross_plane_v8_exhausts_at_270_180_90_and_180_deg():
    engine = load("v8-cross-plane")
    steps = followers(firing(engine), engine.banks["odd"])
    assert [(step.first, step.interval_deg) for step in steps] == [
        (1, 270),
        (3, 180),
        (5, 90),
        (7, 180),
    ]


def test_five_and_seven_are_the_neighbours_of_the_cross_plane_v8_that_fire_in_succession():
    engine = load("v8-cross-plane")
    assert [
        (step.first, step.then) for step in in_succession(firing(engine), neighbours(engine))
    ] == [(5, 7)]


def test_partners_on_a_pin_of_the_cross_plane_v8():
    engine = load("v8-cross-plane")
    assert partners(engine) == {frozenset(pair) for pair in ((1, 2), (3, 4), (5, 6), (7, 8))}
    assert [
        (step.first, step.then) for step in in_succession(firing(engine), partners(engine))
    ] == [(4, 3), (6, 5), (2, 1)]


def test_a_flat_plane_v8_has_even_banks():
    engine = load("v8-flat-plane")
    for numbers in engine.banks.values():
        assert {step.interval_deg for step in followers(firing(engine), numbers)} == {180.0}
