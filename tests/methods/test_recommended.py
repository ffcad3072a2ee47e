"""An engine fitted with the verdict's recommendation behaves as promised, by momentum.

The verdict says in words which counterweights and shafts take what away; here words are held to the
fitted engine, and what that is left with is worked out from the places of its bodies alone
(`tests.newton`).
"""

from __future__ import annotations

import re
from fractions import Fraction

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE
from tests.newton import road

import crankstar
from crankstar.analyses.verdict.facts import verdict
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference
from crankstar.page.scene import scene
from crankstar.remedy import RemedyError, needs, with_turning_cancelled
from crankstar.remedy.fitting import Fitted, recommended

NOTHING = 1e-8
"""Share of what all bodies push, in the order of which they push most."""
WEIGHTS = re.compile(r"crankshaft(?: [^:]+)?: removed by (?:other )?counterweights")
FACTOR = re.compile(r"Counterweights with a balance factor of ([\d.]+) ")


def left(engine: Engine, ratios: set[Fraction]) -> dict[Fraction, tuple[float, float]]:
    """Force and couple that turn at each ratio, by momentum, as shares of the whole excitation."""
    reference = default_reference(engine)
    found = road(engine, reference=reference, speed=1.0)
    pushes = np.array([push.force[:, 1] + 1j * push.force[:, 0] for push in found.pushes])
    arms = np.array([body.z - reference.z for body in found.bodies])
    out = {}
    for ratio in ratios:
        waves = np.exp(-1j * engine.sense * float(ratio) * found.theta)
        each = (pushes * waves).mean(axis=1)
        scale = np.abs(pushes).max(axis=1)
        reach = np.abs(arms * scale).sum() or 1.0
        out[ratio] = (float(abs(each.sum()) / scale.sum()), float(abs((arms * each).sum()) / reach))
    return out


def cured(name: str) -> list[str]:
    return [
        fact.sentence
        for fact in verdict(crankstar.load(name), relatives=False)
        if fact.about == "cure"
    ]


def added(engine: Engine, found: Fitted) -> list[Fraction]:
    return [shaft.speed_ratio for shaft in found.after.shafts[len(engine.shafts) :]]


@pytest.mark.many(first=9)
@EVERY_ENGINE
def test_nothing_is_left_of_what_the_verdict_says_can_be_taken_away(name: str) -> None:
    engine, told, found = crankstar.load(name), cured(name), recommended(crankstar.load(name))
    if found is None:
        assert told[0] == "No primary or secondary force or couple remains."
        return
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    assert list(found.ratios) == added(engine, found)
    gone = cranks | set(added(engine, found))
    after = left(found.after, gone)
    assert max(max(pair) for pair in after.values()) < NOTHING, after
    before = left(engine, gone)
    assert max(max(pair) for pair in before.values()) > 1e3 * NOTHING
    assert any(WEIGHTS.search(sentence) for sentence in told) == (found.weights is not None)
    for sentence in filter(WEIGHTS.search, told):
        assert sentence.startswith(("Primary", "Secondary"))
    for ratio in added(engine, found):
        assert any(
            re.search(rf"at (?:2 and )?{ratio} times|shafts at {ratio} and", sentence)
            for sentence in told
        ), ratio


@EVERY_ENGINE
def test_what_is_left_is_of_a_higher_order_than_what_was_taken_by_shafts(name: str) -> None:
    engine, found = crankstar.load(name), recommended(crankstar.load(name))
    if found is None:
        return
    force, couple = (
        max(abs(getattr(need, name)) for need in needs(engine)) for name in ("force", "couple")
    )
    orders = {
        abs(need.ratio)
        for need in needs(found.after)
        if abs(need.force) > 0.01 * force or abs(need.couple) > 0.01 * couple
    }
    assert all(order > abs(ratio) for order in orders for ratio in added(engine, found))
    assert not orders & {1}


@EVERY_ENGINE
def test_the_factor_of_the_verdict_is_that_of_the_fitted_engine(name: str) -> None:
    found = recommended(crankstar.load(name))
    factors = [float(said.group(1)) for sentence in cured(name) if (said := FACTOR.match(sentence))]
    if found is not None and factors and found.weights is not None:
        assert factors == [found.factor]


def test_two_crankshafts_that_turn_against_each_other_need_no_half() -> None:
    """Pistons that move together need all of their mass on the cranks, opposed ones none."""
    told = {
        name: recommended(crankstar.load(name))
        for name in ("kr250-racer", "kr250-racer-simultaneous", "brough-golden-dream")
    }
    racer, together = told["kr250-racer"], told["kr250-racer-simultaneous"]
    assert racer is not None
    assert racer.factor == 0.0
    assert not any(shaft.weights for shaft in racer.after.shafts if shaft.throws)
    assert together is not None
    assert together.factor == 1.0
    assert told["brough-golden-dream"] is None  # it has them
    assert {
        getattr(recommended(crankstar.load(name)), "factor", None)
        for name in ("single", "v8-cross-plane", "radial-9")
    } == {0.5}


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["vw-vr6", "napier-deltic"])
def test_where_no_factor_will_do_the_end_webs_follow_none(name: str) -> None:
    engine, found = crankstar.load(name), recommended(crankstar.load(name))
    assert found is not None
    assert found.factor is None
    assert all(len(shaft.weights) == 2 for shaft in found.after.shafts if shaft.throws)
    assert any(sentence.startswith("Counterweights on the end webs") for sentence in cured(name))
    with pytest.raises(RemedyError, match="no crankshaft has the speed ratio 7"):
        with_turning_cancelled(engine, ratio=7)


@EVERY_ENGINE
def test_shafts_are_drawn_where_they_are_reckoned_and_clear_of_the_crank(name: str) -> None:
    engine, found = crankstar.load(name), recommended(crankstar.load(name))
    if found is None:
        return
    drawn = scene(found.after).shafts
    assert [(shaft.up, shaft.right) for shaft in drawn] == [
        (shaft.up, shaft.right) for shaft in found.after.shafts
    ]
    crank, new = engine.shafts[0], found.after.shafts[len(engine.shafts) :]
    for shaft in new:
        assert abs(complex(shaft.up, shaft.right)) > 1.2 * max(
            throw.radius for throw in crank.throws
        )
    assert sum(shaft.right for shaft in new) == 0
    assert len({(shaft.up, shaft.right) for shaft in new}) == len(new)


def test_shafts_lie_on_the_side_away_from_the_cylinders_of_their_crank() -> None:
    for name, side in {"single": -1, "v8-flat-plane": -1, "boxer-2": -1, "jumo-205": 1}.items():
        found = recommended(crankstar.load(name))
        assert found is not None
        assert all(shaft.up * side > 0 for shaft in found.after.shafts if not shaft.throws)


def test_a_lone_shaft_rolls_the_block_by_its_force_times_its_place_and_a_pair_does_not() -> None:
    lone, pair = recommended(crankstar.load("single")), recommended(crankstar.load("i4"))
    assert lone is not None
    assert pair is not None

    def added(after: Engine) -> np.ndarray:
        weights = [
            (push.moment[:, 2], body)
            for push, body in zip(
                *(road(after, reference=Reference(0.0), speed=1.0)[index] for index in (2, 1)),
                strict=True,
            )
            if body.kind == "weight" and not after.shaft(body.shaft).throws
        ]
        return np.sum([moment for moment, _ in weights], axis=0).astype(float)

    shaft = lone.after.shafts[-1]
    assert np.abs(added(lone.after)).max() == pytest.approx(0.5 * abs(shaft.up), rel=1e-3)
    assert shaft.right == 0
    assert np.abs(added(pair.after)).max() < 1e-12


def turning(engine: Engine, ratio: Fraction) -> float:
    """The force that turns at a ratio, by momentum, N at 1 rad/s."""
    found = road(engine, reference=default_reference(engine), speed=1.0)
    pushes = sum(push.force[:, 1] + 1j * push.force[:, 0] for push in found.pushes)
    return float(abs((pushes * np.exp(-1j * engine.sense * float(ratio) * found.theta)).mean()))


def test_a_shaft_that_removes_hardly_anything_is_not_recommended() -> None:
    """A radial of seven: knuckle pins leave little that turns against the crank twice as fast."""
    sizes = {"bore": "140 mm", "stroke": "150 mm", "rod_length": "290 mm"}
    masses = {"reciprocating_mass": "3.1 kg"}
    row = {"throw": "0 deg", "cylinders": [1, 2, 3, 4, 5, 6, 7]}
    layout = {"type": "radial", "knuckle_radius": "62 mm", "rows": [row]}
    engine = engine_of({"name": "seven", "cylinder": {**sizes, **masses}, "layout": layout})
    ratios = [Fraction(each) for each in (2, -2)]
    greatest = max(turning(engine, ratio) for ratio in ratios)
    shares = {ratio: turning(engine, ratio) / greatest for ratio in ratios}
    assert [ratio for ratio in ratios if shares[ratio] > 0.01] == [Fraction(2)]
    assert min(shares.values()) > 1e-4
    found = recommended(engine)
    assert found is not None
    assert found.ratios == (Fraction(2),)
    whole = recommended(engine, shafts="all")
    assert whole is not None
    assert whole.ratios == tuple(ratios)
