"""Weights turn with their throws: a file that a command writes does what the command promised."""

from cmath import exp, phase
from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.strategies import ANGLES, engines, of_layout

from crankstar import files, spectra, total
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.copies import (
    throws_of_weights,
    turned_on,
    with_banks_mirrored,
    with_rotation_reversed,
    with_throws_turned,
    with_values,
)
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.engine.records import Rod, Shaft, Throw, Weight
from crankstar.files.catalog import load
from crankstar.language.faults import EngineError
from crankstar.mechanics.balance import balance
from crankstar.remedy.counterweights import with_counterweights, with_web_weights
from crankstar.studies.sweep import swept, watched

WEBS = [Weight(unbalance=1, angle=0, z=z) for z in (1.4, 0.2, -0.2, -9.0)]


def crank(*, weights, places=(1.0, -1.0)):
    throws = tuple(Throw(radius=1, angle=0, z=z) for z in places)
    return Shaft(name="crank", throws=throws, weights=weights)


def test_a_weight_belongs_to_the_nearest_throw():
    assert throws_of_weights(crank(weights=WEBS)) == (1, 1, 2, 2)


def test_a_weight_between_two_throws_belongs_to_the_first_listed():
    middle = [Weight(unbalance=1, angle=0, z=1e-15)]
    assert throws_of_weights(crank(weights=middle)) == (1,)
    assert throws_of_weights(crank(weights=middle, places=(-1.0, 1.0))) == (1,)


def test_a_weight_belongs_to_the_throw_that_it_names():
    named = [with_values(weight, throw=2) for weight in WEBS]
    assert throws_of_weights(crank(weights=named)) == (2, 2, 2, 2)


def test_a_weight_on_a_balance_shaft_has_no_throw():
    assert throws_of_weights(crank(weights=WEBS, places=())) == (None,) * 4


def test_a_weight_cannot_name_a_throw_that_is_not_there():
    engine = load("i4")
    shaft = with_values(engine.shafts[0], weights=[Weight(unbalance=1, angle=0, throw=5)])
    with pytest.raises(EngineError) as error:
        with_values(engine, shafts=(shaft,))
    assert [fault.path for fault in error.value.faults] == [("shaft", 0, "weight", 0, "throw")]


@pytest.mark.parametrize("ends_only", [False, True])
@pytest.mark.parametrize("name", ["i4", "v8-cross-plane", "v6-60-six-throws"])
def test_counterweights_name_the_throw_they_are_for(name, ends_only):
    opposite = with_counterweights(load(name), factor=0.5).shafts[0]
    assert [weight.throw for weight in opposite.weights] == [
        number for number, _ in enumerate(opposite.throws, 1)
    ]
    webs = with_web_weights(load(name), factor=0.5, ends_only=ends_only).shafts[0]
    assert {weight.throw for weight in webs.weights} <= {None, *range(1, len(webs.throws) + 1)}


def test_a_rod_is_shared_between_crank_and_piston_by_its_centre_of_mass():
    """0.6 kg, 40 of 150 mm from the big end: 0.16 kg goes to and fro, 0.44 kg turns."""
    rod = Rod(mass=0.6, centre=0.04, inertia=0.001)
    sizes = Sizes(stroke=0.08, rod_length=0.15, reciprocating_mass=0.5, rotating_mass=0.3, rod=rod)
    single = inline(Basis(name="single", cylinder=sizes, balance_factor=0.5), throws=(0.0,))
    (weight,) = single.shafts[0].weights
    assert weight.unbalance == pytest.approx((0.3 + 0.44 + 0.5 * (0.5 + 0.16)) * 0.04)
    (again,) = with_counterweights(single, factor=0.5).shafts[0].weights
    assert again.unbalance == pytest.approx(weight.unbalance)


@pytest.mark.release
@settings(max_examples=30)
@given(st.data())
def test_throws_turned_carry_their_own_unbalance(data):
    """The unbalance vector of each throw with its weights turns as a whole, the others stay."""
    engine = data.draw(engines(known=True))
    named = [(s.name, n) for s in engine.shafts for n, _ in enumerate(s.throws, 1)]
    turns = {key: data.draw(ANGLES) for key in data.draw(st.sets(st.sampled_from(named)))}
    # an order that a turned crank cannot fire is no matter here
    turned = with_throws_turned(engine, turns, firing_order=(), firing_angles=None)
    for before, after in zip(engine.shafts, turned.shafts, strict=True):
        homes = throws_of_weights(before)
        for number, throw in enumerate(before.throws, 1):
            by = turns.get((before.name, number), 0.0)
            assert unbalance(after, number, homes) == pytest.approx(
                unbalance(before, number, homes) * exp(1j * by), abs=1e-12
            )
            assert after.throws[number - 1].radius == throw.radius


def unbalance(shaft, number, homes):
    throw = shaft.throws[number - 1]
    own = [w for w, home in zip(shaft.weights, homes, strict=True) if home == number]
    return throw.rotating_mass * throw.radius * exp(1j * throw.angle) + sum(
        weight.unbalance * exp(1j * weight.angle) for weight in own
    )


@settings(max_examples=30)
@given(st.sampled_from(["inline", "vee", "boxer"]).flatmap(of_layout), ANGLES)
def test_an_engine_turned_on_has_the_same_forces_later(engine, by):
    """Turned clockwise by phi, a spectrum of order k is delayed by phi: the size is the same."""
    later = turned_on(engine, engine.sense * by)
    for name in ("force", "couple", "axis_moment", "torque"):
        one, other = (getattr(total(balance(e)), name) for e in (engine, later))
        assert spectra.peaks(other) == pytest.approx(spectra.peaks(one), rel=1e-6, abs=1e-9)


def test_the_first_cylinder_of_a_mirrored_engine_keeps_its_dead_centre():
    for name in ("v8-cross-plane", "v2-90", "kr250-racer"):
        engine = with_values(load(name), firing_order=())
        mirrored = with_banks_mirrored(engine)
        lag = [
            phase(exp(1j * (e.throw(e.first).angle - e.first.bearing))) for e in (engine, mirrored)
        ]
        assert lag[1] == pytest.approx(lag[0])
        assert [c.bearing for c in mirrored.cylinders] == [-c.bearing for c in engine.cylinders]


def test_a_mirrored_counterweight_stays_opposite_its_pin():
    engine = with_counterweights(with_values(load("v2-90"), firing_order=()), factor=0.5)
    (shaft,) = with_banks_mirrored(engine).shafts
    apart = shaft.weights[0].angle - shaft.throws[0].angle
    assert exp(1j * apart) == pytest.approx(exp(1j * pi))


def test_every_changed_copy_is_checked():
    engine = load("i4")
    with pytest.raises(EngineError):
        with_values(engine, firing_order=(1, 2, 3))
    with pytest.raises(EngineError):
        with_rotation_reversed(engine, cylinders=engine.cylinders[:3])


def test_a_throw_swept_or_set_takes_its_weights_along():
    engine = with_counterweights(load("i4"), factor=0.5)
    tree = files.explicit(with_values(engine, firing_order=()))
    turned = files.engine_of(tree, changes={"shaft[1].throw[2].angle": "30 deg"})
    assert isinstance(turned, Engine)
    throw, weight = turned.shafts[0].throws[1], turned.shafts[0].weights[1]
    assert exp(1j * (weight.angle - throw.angle)) == pytest.approx(-1)


def test_a_sweep_over_a_throw_turns_its_weights_with_it(tmp_path):
    engine = with_values(with_counterweights(load("i4"), factor=0.5), firing_order=())
    path = tmp_path / "four.toml"
    path.write_text(files.toml(engine))
    values = [0.03 * step for step in range(200)]
    sweep = swept(str(path), over="shaft[1].throw[2].angle", values=values, orders=[1])
    found = watched(sweep, "force.forward", order=1).values
    for place in (0, 77, 199):
        turned = with_throws_turned(engine, {("crank", 2): values[place] - pi})
        (forward,) = spectra.selected(total(balance(turned)).force, [1]).forward
        assert found[place] == pytest.approx(abs(forward), abs=1e-12)


def _vee(*own):
    """A V twin whose rods stand side by side on a pin, 24 mm apart."""
    return files.engine_of(
        {
            "format": 1,
            "name": "V twin",
            "cylinder": {
                "stroke": "80 mm",
                "rod_length": "150 mm",
                "reciprocating_mass": "500 g",
                "rotating_mass": "400 g",
            },
            "cylinders": list(own),
            "layout": {
                "type": "vee",
                "banks": [
                    {"bearing": "-45 deg", "cylinders": [1]},
                    {"bearing": "45 deg", "cylinders": [2]},
                ],
                "throws": ["0 deg"],
                "bore_pitch": "100 mm",
                "bank_offset": "24 mm",
            },
        }
    )


@pytest.mark.parametrize("number", [1, 2])
def test_of_unequal_big_ends_on_a_pin_each_turns_in_its_own_place(number):
    """10 g more at 40 mm: a force of 0.4 g m with the crank, and its couple in the rod's place."""
    plain, heavier = _vee(), _vee({"number": number, "rotating_mass": "410 g"})
    own = next(cylinder for cylinder in heavier.cylinders if cylinder.number == number)
    assert abs(own.z) == pytest.approx(0.012)
    (throw,) = heavier.shafts[0].throws
    assert throw.rotating_mass == 0
    assert sorted(c.big_end_mass for c in heavier.cylinders) == pytest.approx([0.4, 0.41])
    assert [c.big_end_mass for c in plain.cylinders] == [0, 0]
    before, after = (total(balance(engine, speed=1.0)) for engine in (plain, heavier))
    force, couple = (
        spectra.selected(getattr(after, name), 1).forward
        - spectra.selected(getattr(before, name), 1).forward
        for name in ("force", "couple")
    )
    assert force == pytest.approx(0.01 * 0.04 * exp(1j * throw.angle))
    assert couple == pytest.approx(0.01 * 0.04 * own.z * exp(1j * throw.angle))
    against = [spectra.selected(sums.couple, 1).backward for sums in (before, after)]
    assert against[0] == pytest.approx(against[1], abs=1e-15)


def test_counterweights_carry_unequal_big_ends():
    (weight,) = (
        with_counterweights(_vee({"number": 2, "rotating_mass": "410 g"}), factor=0.5)
        .shafts[0]
        .weights
    )
    assert weight.unbalance == pytest.approx((0.81 + 0.5 * 1.0) * 0.04)
