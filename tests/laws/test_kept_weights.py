"""New counterweights add to those of the file: together they do what the factor asks for."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crankstar import load, spectra, total
from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.records import Weight
from crankstar.mechanics.balance import balance
from crankstar.remedy import Aim, changes, fitting, without_added, without_counterweights
from crankstar.remedy.kept import vectors

ENGINES = ("v8-cross-plane", "triple-120", "vw-vr6", "gm-3800", "boxer-6", "square-four")
WHERE = st.sampled_from(["pins", "webs", "ends"])
weights = st.builds(
    Weight, unbalance=st.floats(0.01, 3.0), angle=st.floats(-3.1, 3.1), z=st.floats(-6.0, 6.0)
)
weighted = st.builds(
    lambda name, own: with_weights(load(name), {load(name).shafts[0].name: own}),
    st.sampled_from(ENGINES),
    st.lists(weights, min_size=1, max_size=5),
)


def turning(engine: Engine) -> np.ndarray:
    """Force and couple that turn with the crankshaft."""
    sums = total(balance(engine))
    pair = [spectra.selected(getattr(sums, name), [1.0]) for name in ("force", "couple")]
    return np.array([one.forward[0] for one in pair])


def unbalance(engine: Engine) -> np.ndarray:
    """The sum and the moment of the weights of the first crankshaft."""
    own = engine.shafts[0].weights
    return np.array(
        [sum(vectors(own)), sum(u * w.z for u, w in zip(vectors(own), own, strict=True))]
    )


@given(weighted, WHERE, st.floats(-1, 3))
def test_old_and_new_weights_together_are_those_of_the_factor(
    engine: Engine, where: fitting.Places, factor: float
) -> None:
    kept = fitting.by_factor(engine, factor=factor, weights=where)
    bare = fitting.by_factor(engine, factor=factor, weights=where, bare=True)
    size = 10 * sum(weight.unbalance for weight in (*engine.shafts[0].weights,)) + 50
    assert np.allclose(unbalance(kept), unbalance(bare), rtol=0, atol=1e-10 * size)
    assert np.allclose(turning(kept), turning(bare), rtol=0, atol=1e-10 * size)


@given(weighted, WHERE, st.floats(-1, 3))
def test_what_was_added_is_taken_away_again(
    engine: Engine, where: fitting.Places, factor: float
) -> None:
    after = fitting.by_factor(engine, factor=factor, weights=where)
    assert after.shafts[0].weights[: len(engine.shafts[0].weights)] == engine.shafts[0].weights
    assert without_added(engine, after) == engine
    bare = fitting.by_factor(engine, factor=factor, weights=where, bare=True)
    assert without_added(engine, bare) == engine


@given(weighted, WHERE, st.floats(0, 1))
def test_nothing_is_added_a_second_time(
    engine: Engine, where: fitting.Places, factor: float
) -> None:
    once = fitting.by_factor(engine, factor=factor, weights=where)
    assert fitting.by_factor(once, factor=factor, weights=where) == once


@given(st.sampled_from(ENGINES), WHERE, st.floats(1e-6, 1), st.floats(0.01, 0.99))
def test_a_crank_that_is_half_done_gets_the_other_half_in_the_same_places(
    name: str, where: fitting.Places, factor: float, share: float
) -> None:
    """A part of the weights stands there already: the new ones are what each of them lacks."""
    engine = load(name)
    bare = fitting.by_factor(engine, factor=factor, weights=where)
    part = {
        shaft.name: [
            weight.model_copy(update={"unbalance": share * weight.unbalance})
            for weight in shaft.weights
        ]
        for shaft in bare.shafts
    }
    after = fitting.by_factor(with_weights(engine, part), factor=factor, weights=where)
    for whole, own in zip(bare.shafts, after.shafts, strict=True):
        new = own.weights[len(whole.weights) :]
        assert len(new) == len(whole.weights)
        for more, all_of in zip(new, whole.weights, strict=True):
            assert more.unbalance == pytest.approx((1 - share) * all_of.unbalance, rel=1e-9)
            assert (more.z, more.throw) == (all_of.z, all_of.throw)
            assert np.exp(1j * more.angle) == pytest.approx(np.exp(1j * all_of.angle))


def test_a_weight_relieves_its_own_throw_and_a_flywheel_all_of_them() -> None:
    engine = load("v8-cross-plane")

    def added(z: float) -> np.ndarray:
        own = with_weights(engine, {"crank": [Weight(unbalance=0.3, angle=0.0, z=z)]})
        bare = fitting.by_factor(own, factor=0.5, weights="webs", bare=True).shafts[0].weights
        new = fitting.by_factor(own, factor=0.5, weights="webs").shafts[0].weights[1:]
        return np.array(vectors(new)) - vectors(bare)

    on_web = added(1.25)  # the rear web of the first throw
    assert on_web == pytest.approx([0, -0.3, 0, 0, 0, 0, 0, 0], abs=1e-12)
    between = added(1.5)
    assert between == pytest.approx([-0.15, -0.15, 0, 0, 0, 0, 0, 0], abs=1e-12)
    flywheel = added(-3.0)  # a straight line along the shaft: the least that takes it over
    assert np.ptp(np.diff(np.real(flywheel))) < 1e-12
    assert abs(flywheel).min() > 0
    assert abs(flywheel).max() < 0.3


@pytest.mark.parametrize("name", ["parallel-twin-180", "brough-golden-dream", "kr250-racer"])
def test_best_weights_beside_those_of_the_file_are_no_worse_than_those(name: str) -> None:
    engine = load(name)
    for aim in (Aim("force", rms=True), Aim("couple", rms=True)):
        best = fitting.best(engine, weights="ends", aim=aim)
        assert best.kept
        assert best.value <= best.before * (1 + 1e-9)
        bare = fitting.best(engine, weights="ends", aim=aim, bare=True)
        assert not bare.kept
        assert best.value <= bare.value * (1 + 1e-6) + 1e-9  # it has as much to choose from
        assert all(not own.replaced for own in changes(engine, best.engine).values())


def test_weights_that_are_not_needed_are_recommended_to_be_removed() -> None:
    engine = load("kr250-racer")
    fitted = fitting.recommended(engine)
    assert fitted is not None
    assert fitted.weights == "removed"
    assert fitted.after.shafts[:2] == without_counterweights(engine).shafts


def test_the_recommended_weights_are_added() -> None:
    engine = with_weights(
        load("v8-cross-plane"), {"crank": [Weight(unbalance=0.2, angle=1.0, z=1.75)]}
    )
    fitted = fitting.recommended(engine)
    assert fitted is not None
    own = changes(engine, fitted.after)["crank"]
    assert (len(own.kept), len(own.added), len(own.replaced)) == (1, 8, 0)
    assert np.abs(turning(fitted.after)).max() < 1e-12
    replaced = fitting.recommended(engine, bare=True)
    assert replaced is not None
    assert len(changes(engine, replaced.after)["crank"].replaced) == 1
