"""Exact weights equal those in floating point; that nothing remains is proved, not estimated."""

from __future__ import annotations

from fractions import Fraction

import pytest

from crankstar import load, spectra, total
from crankstar.derive import DerivationError
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.algebra.typeset import text
from crankstar.derive.algebra.wave import length
from crankstar.derive.cure import cure
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.mechanics.balance import balance
from crankstar.remedy import end_planes, end_webs, with_balance_shaft, with_counterweights

CASES = [
    (name, Fraction(ratio))
    for name, ratios in {
        "single": (1, -1, 2, -2),
        "i4": (2, -2),
        "v8-cross-plane": (1,),
        "v8-flat-plane": (2, -2),
        "triple-120": (1, -1, 2, -2),
        "yamaha-r1-crossplane": (1, -1),
        "gm-3800": (1, -1, 2, -2),
        "v6-60-six-throws": (1,),
        "sinitsyn-7-first": (1, -1, 2, -2),
        "sinitsyn-6-valve": (1, -1),
        "sinitsyn-8-two-stroke": (1, -1),
        "harley-45": (1, -1, 2, -2),
        "audi-25-tfsi": (1, -1, 2, -2),
    }.items()
    for ratio in ratios
]


@pytest.mark.many(first=32)
@pytest.mark.parametrize(("name", "ratio"), CASES)
def test_exact_weights_leave_nothing_and_are_those_of_the_remedy(
    name: str, ratio: Fraction
) -> None:
    engine = load(name)
    planes = [*end_planes(engine), (end_planes(engine)[0] + 2 * end_planes(engine)[1]) / 3]
    found = cure(engine, ratio=ratio, planes=planes)
    assert found.proved
    assert all(isinstance(amount, Number) for amount in found.unbalance)
    first = engine.first
    unit = first.reciprocating_mass * engine.throw(first).radius * found.scale
    exact = [complex(amount) * unit for amount in found.unbalance]
    made = with_balance_shaft(engine, ratio=ratio, planes=planes).shafts[-1].weights
    by_plane = {weight.z: weight for weight in made}
    for plane, vector in zip(planes, exact, strict=True):
        weight = by_plane.get(plane)
        size = 0.0 if weight is None else weight.unbalance
        assert abs(vector) == pytest.approx(size, rel=1e-11, abs=1e-12 * max(map(abs, exact)))
    # And on the engine they leave nothing but rounding.
    from cmath import phase

    weights = tuple(
        Weight(unbalance=abs(u), angle=phase(u), z=z) for u, z in zip(exact, planes, strict=True)
    )
    cured = engine.model_copy(
        update={"shafts": (*engine.shafts, Shaft(name="cure", speed_ratio=ratio, weights=weights))}
    )
    for quantity in ("force", "couple"):
        one = spectra.selected(getattr(total(balance(cured)), quantity), [abs(float(ratio))])
        assert abs((one.forward if ratio > 0 else one.backward)[0]) < 1e-12 * len(engine.cylinders)


@pytest.mark.release
def test_the_cross_plane_eight_in_closed_form() -> None:
    engine = load("v8-cross-plane")
    found = cure(engine, ratio=1, planes=end_webs(engine, engine.shafts[0]))
    assert text(length(found.unbalance[0])) == "2√10/7"
    assert found.proved
    assert "∠ (−π + atan 2)" in str(found.chapter)


@pytest.mark.release
def test_what_was_not_cured_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof adds up again: with wrong weights it fails."""
    import sys

    module = sys.modules["crankstar.derive.cure"]
    honest = module._least

    def wrong(*arguments: object) -> list[object]:
        first, *others = honest(*arguments)
        return [first.times(Fraction(10**15 + 1, 10**15)), *others]

    monkeypatch.setattr(module, "_least", wrong)
    found = cure(load("v8-cross-plane"), ratio=1, planes=[1.75, -1.75])
    assert not found.proved
    assert "proved" not in str(found.chapter)


def test_decimals_are_not_called_a_proof() -> None:
    found = cure(load("vw-vr6"), ratio=-1, planes=end_planes(load("vw-vr6")))
    assert not found.proved
    assert "cannot be distinguished from zero" in str(found.chapter)


def turned(engine: Engine) -> Engine:
    return engine.model_copy(
        update={"rotation": "counter-clockwise", "firing_order": (), "firing_angles": None}
    )


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["v8-cross-plane", "gm-3800", "harley-45"])
def test_rotating_masses_and_the_other_way_round_are_counted(name: str) -> None:
    engine = turned(load(name))
    shafts = tuple(
        shaft.model_copy(
            update={
                "throws": tuple(t.model_copy(update={"rotating_mass": 0.25}) for t in shaft.throws)
            }
        )
        for shaft in engine.shafts
    )
    heavy = engine.model_copy(update={"shafts": shafts})
    planes = end_planes(heavy)
    found = cure(heavy, ratio=1, planes=planes)
    assert found.proved
    made = with_counterweights(heavy, factor=0.5, planes=planes).shafts[0].weights
    unit = heavy.first.reciprocating_mass * heavy.throw(heavy.first).radius
    for weight, amount in zip(made, found.unbalance, strict=True):
        assert value(length(amount)) * unit == pytest.approx(weight.unbalance, rel=1e-10)


def test_one_plane_will_do_where_the_force_acts_in_it() -> None:
    assert cure(load("i4"), ratio=2, planes=[0.0]).proved
    with pytest.raises(DerivationError, match="One plane balances only a force"):
        cure(load("triple-120"), ratio=-1, planes=[0.0])
    with pytest.raises(DerivationError, match="No force or couple of order 2"):
        cure(load("v8-cross-plane"), ratio=2, planes=[1.0, -1.0])
