"""Engines built to their tolerances: the linear law, its worst case, and engines at random."""

from itertools import product
from math import log, pi, sqrt
from typing import Any, cast

import numpy as np
import pytest

from crankstar.analyses.tolerance.builds import _drawn, _plan
from crankstar.analyses.tolerance.error_sources import sources_of
from crankstar.analyses.tolerance.linear_law import (
    QUANTITIES,
    Linear,
    Vectors,
    amplitudes,
    linear,
    moved,
    summed_parts,
    variances,
    worst,
)
from crankstar.analyses.tolerance.scatter import ScatterError, scatter
from crankstar.engine.motion import piston_harmonics
from crankstar.engine.quantities import ANGLE, INERTIA, LENGTH, MASS
from crankstar.files import changed, engine_of, keys_of
from crankstar.files.catalog import load, tree_of
from crankstar.files.tolerances import tolerances_of
from crankstar.files.units import si
from crankstar.mechanics.balance import default_reference, scales
from crankstar.mechanics.mechanism import mechanism

ORDERS = (1.0, 2.0, 3.0, 4.0, 6.0)
SPEED = 6000 * pi / 30
MASSES = {"cylinder.reciprocating_mass": "500 g +- 3 g", "cylinder.stroke": "90 mm"}
RODS = {
    "cylinder.reciprocating_mass": "500 g",
    "cylinder.stroke": "90 mm",
    "cylinder.rod": {"mass": "550 g", "centre": "40 mm", "inertia": "0.0025 kg*m^2"},
}
OPTIONS = {"count": 1000, "orders": ORDERS}


def errors_of(name, changes):
    shown, tree = tree_of(name)
    tree = changed(tree, changes)
    engine = engine_of(tree, name=shown)
    return engine, sources_of(tree, tolerances_of(tree), engine).errors


def law(name, changes, *, speed=SPEED):
    engine, errors = errors_of(name, changes)
    how = {
        "orders": ORDERS,
        "reference": default_reference(engine),
        "scale": scales(engine, speed)[0],
    }
    return engine, errors, linear(engine, errors, **how), how


@pytest.mark.many(first=4)
@pytest.mark.parametrize("name", ["i4", "i6", "v8-cross-plane", "v2-90", "boxer-6", "v12-60"])
def test_mass_errors_add_up_whatever_the_layout(name) -> None:
    engine, errors, lines, _how = law(name, MASSES)
    assert len(errors) == len(engine.cylinders)
    cylinder = engine.first
    harmonics = piston_harmonics(
        crank_radius=0.045, rod_length=cylinder.rod_length, offset=cylinder.offset
    )
    found = np.sqrt(variances(lines["force"], np.full(len(errors), 0.001)).sum(axis=0))
    for order, rms in zip(ORDERS, found, strict=True):
        size = abs(harmonics[int(order)])
        expected = sqrt(len(errors)) * 0.001 * 0.045 * SPEED**2 * size
        assert rms == pytest.approx(expected, rel=1e-9, abs=1e-9), order


def test_a_perfect_six_with_a_gram_of_scatter_shakes_with_43_5_newtons() -> None:
    found = scatter("i6", changes=MASSES, speed=SPEED, count=20_000)
    row = found.of("force", 1)
    assert row.nominal == 0
    assert row.rms == pytest.approx(sqrt(6) * 0.001 * 0.045 * SPEED**2, rel=1e-12)
    assert round(row.rms, 1) == 43.5
    assert row.rms_found == pytest.approx(row.rms, rel=0.01)


def test_an_order_that_is_nought_as_drawn_is_rayleigh() -> None:
    # pins at 0, 120 and 240 deg: both parts of the amplitude scatter alike and by themselves
    row = scatter("i6", changes=MASSES, speed=SPEED).of("force", 1)
    assert row.half_of == pytest.approx(row.rms * sqrt(log(2)), rel=0.01)
    assert row.one_in_20 == pytest.approx(row.rms * sqrt(log(20)), rel=0.01)
    assert row.one_in_100 == pytest.approx(row.rms * sqrt(log(100)), rel=0.015)


def test_an_order_whose_forces_are_in_phase_is_half_a_bell() -> None:
    # a flat-plane four: pins at 0 and 180 deg only, so that order 1 is up or down
    row = scatter("i4", changes=MASSES, speed=SPEED).of("force", 1)
    assert row.one_in_20 == pytest.approx(1.959964 * row.rms, rel=0.01)
    assert row.half_of == pytest.approx(0.674490 * row.rms, rel=0.01)


def test_uniform_errors_scatter_more_than_normal_ones() -> None:
    rows = [
        scatter("i6", changes=MASSES, speed=SPEED, distribution=each).of("force", 1)
        for each in ("normal", "uniform")
    ]
    assert rows[1].rms == pytest.approx(rows[0].rms * sqrt(3), rel=1e-12)
    assert rows[1].rms_found == pytest.approx(rows[1].rms, rel=0.01)
    assert rows[1].worst == rows[0].worst


SHARED = [
    ("i4", "cylinder.rod.mass", "kg", 1e-3),
    ("i4", "cylinder.rod.centre", "m", 1e-5),
    ("i4", "cylinder.rod.inertia", "kg*m^2", 1e-5),
    ("honda-b18c", "cylinder.rod_length", "m", 1e-5),
    ("honda-b18c", "cylinder.stroke", "m", 1e-5),
    ("i4", "cylinder.rotating_mass", "kg", 1e-3),
    ("v8-cross-plane", "layout.banks[2].bearing", "rad", 1e-5),
    ("v8-cross-plane", "layout.throws[2]", "rad", 1e-5),
    ("v8-cross-plane", "layout.bank_offset", "", 1e-4),
    ("v8-cross-plane", "cylinder.offset", "", 1e-4),
    ("v6-60-six-throws", "layout.throws[3]", "rad", 1e-5),
    ("parts", "cylinder.parts.small_end", "kg", 1e-3),
    ("parts", "cylinder.parts.big_end", "kg", 1e-3),
    ("parts", "cylinder.parts.pin", "kg", 1e-3),
    ("radial-9", "layout.knuckle_radius", "", 1e-4),
    ("radial-9", "layout.slave_rod_length", "", 1e-4),
    ("square-four", "layout.cranks[2].lag", "rad", 1e-5),
    ("square-four", "layout.cranks[2].right", "", 1e-4),
    ("jumo-205", "layout.crank_distance", "m", 1e-4),
    ("napier-deltic", "shaft[2].throw[3].angle", "rad", 1e-5),
    ("napier-deltic", "shaft[2].throw[3].radius", "m", 1e-5),
]
PARTS = {"piston": "300 g", "pin": "90 g", "small_end": "150 g", "big_end": "400 g"}
GIVEN = {
    "i4": {**RODS, "cylinder.rotating_mass": "0.4 kg"},
    "parts": {
        "cylinder.parts": PARTS,
        "cylinder.stroke": "90 mm",
        "cylinder.rod": {"inertia": "0.0025 kg*m^2"},
    },
    "radial-9": {"layout.slave_rod_length": 3.2},
    "v8-cross-plane": {"cylinder.offset": 0.05, "layout.banks[1].offset": -0.03},
}
"""What the engine of a case has besides; "parts" is a four whose parts were weighed."""


@pytest.mark.many(first=12)
@pytest.mark.parametrize(("name", "path", "unit", "step"), SHARED)
def test_the_errors_of_a_value_together_are_a_change_of_the_value(name, path, unit, step) -> None:
    """Read the file again with the value changed: the sum of all its errors is the same change."""
    shown, tree = tree_of("i4" if name == "parts" else name)
    without = ("provenance", "firing_order", "gas", "valves")
    tree = {key: own for key, own in tree.items() if key not in without}
    tree = changed(tree, GIVEN.get(name, {}))
    engine = engine_of(tree, name=shown)
    value = _value(engine, path, tree)

    def written(number):
        return f"{number!r} {unit}" if unit else number

    tolerance = f"{value!r} {unit} +- {step} {unit}" if unit else f"{value!r} +- {step}"
    own = changed(tree, {path: tolerance})
    errors = sources_of(own, tolerances_of(own), engine).errors
    how = {
        "orders": ORDERS,
        "reference": default_reference(engine),
        "scale": scales(engine, SPEED)[0],
    }
    lines = linear(engine, errors, **how)
    low, high = (
        summed_parts(
            mechanism(engine_of(changed(tree, {path: written(value + sign * step)}))), **how
        )
        for sign in (-1, 1)
    )
    for quantity in QUANTITIES:
        for place in (0, 1):
            change = (high[quantity][place] - low[quantity][place]) / (2 * step)
            found = lines[quantity].rates[place].sum(axis=0)
            rounding = 1e-12 * np.abs(low[quantity][place]).max() / step + 1e-9
            size = np.abs(change).max()
            assert np.abs(found - change).max() <= 2e-5 * size + rounding, quantity


def _value(engine, path, tree):
    cylinder = engine.cylinders[0]
    place = tree
    for key in keys_of(path):
        try:
            place = place[key]
        except KeyError:
            break
    if isinstance(place, float | int):
        return float(place)
    if isinstance(place, str):
        last = path.rpartition(".")[2].rstrip("[0123456789]")
        return si(place, ANGLE if last in ("throws", "bearing", "lag", "angle") else UNITS[last])
    return {"layout.cranks[2].lag": 0.0, "cylinder.rod_length": cylinder.rod_length}[path]


UNITS = {
    "mass": MASS,
    "small_end": MASS,
    "big_end": MASS,
    "pin": MASS,
    "rotating_mass": MASS,
    "inertia": INERTIA,
    "centre": LENGTH,
    "stroke": LENGTH,
    "crank_distance": LENGTH,
    "radius": LENGTH,
    "rod_length": LENGTH,
}


VARIED = {
    "i6": {**MASSES, "cylinder.throw_mass": "0 g +- 5 g"},
    "i4": {
        **RODS,
        "cylinder.rod.mass": "550 g +- 3 g",
        "cylinder.rod.inertia": "0.0025 kg*m^2 +- 4 %",
        "layout.bore_pitch": "87 mm +- 0.3 mm",
    },
    "radial-9": {"cylinder.reciprocating_mass": "1 +- 0.01", "cylinder.rotating_mass": "1 +- 0.02"},
    "napier-deltic": {
        "cylinders[1].reciprocating_mass": "1 +- 0.01",
        "shaft[3].throw[2].angle": "0.3 rad +- 0.01 rad",
    },
    "square-four": {**MASSES, "layout.cranks[2].lag": "180 deg +- 0.4 deg"},
    "jumo-205": {**MASSES, "layout.lag": "11 deg +- 0.3 deg"},
}


@pytest.mark.parametrize("name", VARIED)
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_random_engines_are_those_of_the_batch_machinery(name, rotation) -> None:
    ways = {"rotation": rotation, "firing_order": [], "gas": None, "torsion": None}
    if name == "i4":
        ways["layout.throws"] = ["0 deg", "180 deg", "180 deg", "0 deg"]
    if name == "i6":
        ways["layout.throws"] = ["0 deg", "240 deg", "120 deg", "120 deg", "240 deg", "0 deg"]
    engine, errors, lines, how = law(name, {**VARIED[name], **ways})
    assert errors
    plan = _plan(mechanism(engine), errors, lines, (), how)
    assert not plan.first_order
    bounds = np.array([error.bound for error in errors])
    sizes = _drawn(np.random.default_rng(3), 50, bounds, "normal")
    exact = summed_parts(moved(mechanism(engine), errors, sizes), **how)
    for quantity, own in plan.exact(sizes).items():
        for mine, other in zip(own, exact[quantity], strict=True):
            assert np.abs(mine - other).max() < 1e-11 * np.abs(other).max(initial=1e-300) + 1e-9


def test_lengths_of_the_motion_count_to_first_order_where_they_are_small() -> None:
    changes = {"cylinder.rod_length": "150 mm +- 0.3 mm", "cylinder.stroke": "90 mm +- 0.2 mm"}
    engine, errors, lines, how = law("honda-b18c", changes)
    plan = _plan(mechanism(engine), errors, lines, (), how)
    assert len(plan.first_order) == 8
    bounds = np.array([error.bound for error in errors])
    sizes = _drawn(np.random.default_rng(3), 50, bounds, "normal")
    exact = summed_parts(moved(mechanism(engine), errors, sizes), **how)
    for quantity in QUANTITIES:
        whole = amplitudes(exact[quantity])
        straight = [
            lines[quantity].nominal[place] + sizes @ lines[quantity].rates[place]
            for place in (0, 1)
        ]
        apart = np.abs(amplitudes(Vectors(*straight)) - whole).max()
        off = [e - n for e, n in zip(exact[quantity], lines[quantity].nominal, strict=True)]
        assert apart < 5e-3 * amplitudes(Vectors(*off)).max(), quantity


def test_a_large_error_of_a_length_is_worked_out_engine_by_engine() -> None:
    changes = {"cylinder.rod_length": "150 mm +- 15 mm", "cylinder.stroke": "90 mm"}
    engine, errors, lines, how = law("honda-b18c", changes)
    assert not _plan(mechanism(engine), errors, lines, (), how).first_order
    found = scatter("honda-b18c", changes=changes, speed=SPEED, **OPTIONS)
    assert found.of("force", 2).rms_found > 0


def test_the_worst_case_is_the_worst_of_all_signs() -> None:
    random = np.random.default_rng(11)
    for _case in range(20):
        count = int(random.integers(1, 9))
        shape = (count, 1)
        rates = Vectors(
            *(random.normal(size=shape) + 1j * random.normal(size=shape) for _ in range(2))
        )
        nominal = Vectors(*(random.normal(size=1) + 1j * random.normal(size=1) for _ in range(2)))
        bounds = random.uniform(0.1, 1.0, count)
        signs = np.array([*product((-1, 1), repeat=count)]) * bounds
        every = np.abs(nominal.forward + signs @ rates.forward)
        every = every + np.abs(nominal.backward + signs @ rates.backward)
        assert worst(Linear(nominal, rates), bounds)[0] == pytest.approx(every.max(), rel=1e-12)


def test_no_engine_within_its_tolerances_is_worse_than_the_worst_case() -> None:
    throws = ["0 deg", "180 deg +- 0.1 deg", "180 deg +- 0.1 deg", "0 deg"]
    changes = {**MASSES, "cylinder.throw_mass": "0 g +- 4 g", "layout.throws": throws}
    found = scatter("i4", changes=changes, speed=SPEED, distribution="uniform")
    for signal in ("force", "couple", "roll", "force.up", "couple.yaw"):
        for row in found.rows:
            if row.signal == signal:
                greatest = found.amplitudes(signal, row.order).max()
                assert greatest <= row.worst * (1 + 1e-4), (signal, row.order)


def test_shares_add_up_and_follow_the_square_of_the_tolerance() -> None:
    one = scatter("i6", changes={**MASSES, "cylinder.rotating_mass": "400 g +- 3 g"}, **OPTIONS)
    two = scatter("i6", changes={**MASSES, "cylinder.rotating_mass": "400 g +- 6 g"}, **OPTIONS)
    shares = [each.of("force", 1).shares for each in (one, two)]
    assert [sum(each.values()) for each in shares] == pytest.approx([1, 1])
    ratios = [e["cylinder.rotating_mass"] / e["cylinder.reciprocating_mass"] for e in shares]
    # a mass that turns pushes upward and to the right, one on a line upward only
    assert ratios == pytest.approx([2, 8])


def test_each_pitch_errs_by_itself_about_the_middle_of_its_engine() -> None:
    changes = {"layout.bore_pitch": "100 mm +- 0.1 mm", **MASSES}
    changes["cylinder.reciprocating_mass"] = "500 g"
    engine, errors, lines, _how = law("triple-120", changes)
    assert [error.part for error in errors] == ["pitch 1 to 2", "pitch 2 to 3"]
    parts = np.array([0.0, 120.0, 240.0])
    lag = np.exp(1j * np.radians([engine.throw(c).angle * 180 / pi for c in engine.cylinders]))
    assert parts.size == lag.size
    force = 0.5 * 0.045 * SPEED**2 * lag  # order 1 of each piston, upward
    first = 0.5 * (force[0] - force[1] - force[2])
    assert 2 * abs(lines["couple"].rates.forward[0, 0]) == pytest.approx(abs(first), rel=1e-9)


def test_a_wider_pitch_gives_two_equal_forces_no_couple_about_their_own_middle() -> None:
    changes = {"layout.bore_pitch": "100 mm +- 0.1 mm", **MASSES}
    changes["cylinder.reciprocating_mass"] = "500 g"
    _engine, errors, lines, _how = law("i2-360", changes)
    assert len(errors) == 1
    assert abs(lines["force"].nominal.forward[0]) > 1000
    assert np.abs(lines["couple"].rates.forward).max() < 1e-6


def test_halves_of_the_pistons_on_a_shared_pin_err_by_themselves() -> None:
    changes = {"cylinder.rotating_mass": "400 g +- 3 g", **MASSES}
    changes["cylinder.reciprocating_mass"] = "500 g"
    _engine, errors, lines, _how = law("v2-90", changes)
    assert len(errors) == 2
    rms = sqrt(float(variances(lines["force"], np.full(2, 0.001)).sum(axis=0)[0]))
    assert rms == pytest.approx(sqrt(2) * sqrt(2) * 0.001 * 0.045 * SPEED**2, rel=1e-9)


def test_a_cylinder_with_a_value_of_its_own_has_its_own_tolerance() -> None:
    tree = changed(tree_of("i4")[1], MASSES)
    tree["cylinders"] = [{"number": 2, "reciprocating_mass": "510 g"}]
    own = sources_of(tree, tolerances_of(tree), engine_of(tree)).errors
    assert [error.part for error in own] == ["cylinder 1", "cylinder 3", "cylinder 4"]
    tree["cylinders"][0]["reciprocating_mass"] = "510 g +- 1 g"
    own = sources_of(tree, tolerances_of(tree), engine_of(tree)).errors
    assert [error.bound for error in own] == pytest.approx([0.003] * 3 + [0.001])


def test_the_two_forms_of_a_file_scatter_alike() -> None:
    from crankstar.files import explicit

    _shown, tree = tree_of("honda-b18c")
    tree = explicit(engine_of(changed(tree, MASSES)))
    for cylinder in tree["cylinders"]:
        cylinder["reciprocating_mass"] += " +- 3 g"
        cylinder["rod_length"] += " +- 0.1 mm"
    engine = engine_of(tree)
    own = sources_of(tree, tolerances_of(tree), engine).errors
    how = {"orders": ORDERS, "reference": default_reference(engine)}
    how["scale"] = scales(engine, SPEED)[0]
    _engine, errors, lines, _how = law(
        "honda-b18c", {**MASSES, "cylinder.rod_length": "137.9 mm +- 0.1 mm"}
    )
    mine = linear(engine, own, **how)
    for quantity in ("force", "roll"):
        totals = []
        for each, law_of in ((errors, lines), (own, mine)):
            bounds = np.array([error.bound for error in each])
            totals.append(variances(law_of[quantity], bounds).sum(axis=0))
        assert totals[0] == pytest.approx(totals[1], rel=1e-9, abs=1e-12)


def test_the_phase_of_a_balance_shaft_turns_all_its_weights() -> None:
    weights = [
        {"unbalance": "0.01 kg*m", "angle": "180 deg", "z": "100 mm"},
        {"unbalance": "0.01 kg*m", "angle": "180 deg", "z": "-100 mm"},
    ]
    shaft = {"weight": weights, "phase": "0 deg +- 1 deg"}
    tree = changed(tree_of("single")[1], MASSES)
    tree["cylinder"]["reciprocating_mass"] = "500 g"
    tree["layout"] = {**tree["layout"], "bore_pitch": "100 mm"}
    tree["balance_shaft"] = [shaft]
    engine = engine_of(tree)
    (error,) = sources_of(tree, tolerances_of(tree), engine).errors
    how = {"orders": (1.0,), "reference": default_reference(engine)}
    lines = linear(engine, [error], scale=scales(engine, SPEED)[0], **how)
    found = abs(lines["force"].rates.backward[0, 0])
    assert found == pytest.approx(0.02 * SPEED**2, rel=1e-9)
    turned = engine_of(changed(tree, {"balance_shaft[1].phase": "90 deg"}))
    assert [weight.angle for weight in turned.shafts[1].weights] == pytest.approx([-pi / 2] * 2)


def test_a_weight_of_nothing_may_be_off_balance_either_way() -> None:
    weight = {"unbalance": "0 g*mm +- 300 g*mm", "angle": "0 deg", "throw": 1}
    changes = {**MASSES, "crankshaft": [{"weight": [weight]}]}
    changes["cylinder.reciprocating_mass"] = "500 g"
    found = scatter("i4", changes=changes, speed=SPEED)
    row = found.of("force.up", 1)
    assert row.nominal == 0
    assert row.rms == pytest.approx(1e-4 * SPEED**2, rel=1e-9)
    assert row.half_of == pytest.approx(0.674490 * row.rms, rel=0.02)


def test_bare_lengths_stay_bare() -> None:
    changes = {"layout.banks[2].set_back": "0 +- 0.01", "cylinder.rotating_mass": "0.4 +- 0.01"}
    found = scatter("harley-45", changes=changes, **OPTIONS)
    assert found.idle == ()
    assert found.of("couple", 1).shares["layout.banks[2].set_back"] > 0.5


def test_the_same_seed_builds_the_same_engines() -> None:
    each = [
        scatter("i6", changes=MASSES, seed=seed, **OPTIONS).of("force", 1).one_in_20
        for seed in (5, 5, 6)
    ]
    assert each[0] == each[1] != each[2]


def test_what_cannot_be_scattered_is_refused() -> None:
    with pytest.raises(ScatterError, match="has no tolerances"):
        scatter("i4")
    with pytest.raises(ScatterError, match=r"stand in its file.*assume="):
        scatter(load("i4"))
    with pytest.raises(ScatterError, match="no force"):
        scatter("i4", changes={"speed": "6000 rpm +- 1 %"})
    for count in cast("list[Any]", [10, 1e5, True, "many", 10**9]):
        with pytest.raises(ScatterError, match="1000 to 1000000"):
            scatter("i4", changes=MASSES, count=count)
    for seed in cast("list[Any]", [-1, 1.5, None]):
        with pytest.raises(ScatterError, match="seed is"):
            scatter("i4", changes=MASSES, seed=seed)
    with pytest.raises(ScatterError, match="assume is"):
        scatter("i4", changes=MASSES, assume=cast("Any", "usual"))
    with pytest.raises(ScatterError, match="has no order 9"):
        scatter("i4", changes=MASSES, **OPTIONS).of("force", 9)
    with pytest.raises(ScatterError, match="normal, uniform"):
        scatter("i4", changes=MASSES, distribution=cast("Any", "triangular"))
    assert load("i4").name  # the engine itself is what it was


@pytest.mark.parametrize(
    "own",
    [
        {"cylinder.rod_length": "150 mm +- 60 mm"},
        {"cylinder.stroke": "90 mm +- 89 mm"},
        {"cylinder.stroke": "250 mm +- 20 mm", "cylinder.rod_length": "150 mm"},
    ],
)
def test_rods_that_might_not_reach_their_cylinders_are_refused(own: dict[str, Any]) -> None:
    changes = {"cylinder.reciprocating_mass": "500 g", "cylinder.stroke": "90 mm"} | own
    if "cylinder.rod_length" in changes:
        changes["cylinder.rod_ratio"] = None
    with pytest.raises(ScatterError, match="might not turn"):
        scatter("i4", changes=changes, count=1000)
