"""`crankstar orders --minimise`: firing orders sorted by gas torque, roll or twist."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.search import plain_orders as plain

import crankstar
from crankstar import bearing_loads, cycle, load, spectra
from crankstar import torsion as torsional
from crankstar.dynamics.torsion_criticals import stresses
from crankstar.dynamics.torsion_shapes import cylinder_shape
from crankstar.files.catalog import tree_of
from crankstar.firing.intervals import firing
from crankstar.firing.orders import even_orders
from crankstar.stars.sequence_engines import shaft_of_engine, with_fired
from crankstar.stars.shafts import followed
from crankstar.stars.vector_sums import couple, shape_of, torsion
from crankstar.studies.judged_orders import JUDGES, Judge, judged, judgement

OWN = {
    "inertia": "0.03 kg*m^2",
    "stiffness": "0.9 MN*m/rad",
    "diameter": "60 mm",
    "disc": [
        {"name": "flywheel", "inertia": "0.3 kg*m^2", "to": "rear", "stiffness": "1.4 MN*m/rad"}
    ],
}
"""A table [torsion]."""


@pytest.fixture
def six(tmp_path: Path) -> str:
    """An in-line six with masses and a crankshaft that twists."""
    tree: dict[str, Any] = {**tree_of("bmw-m52b28")[1], "torsion": OWN}
    tree["cylinder"] = {**tree["cylinder"], "reciprocating_mass": "0.6 kg"}
    place = tmp_path / "six.json"
    place.write_text(json.dumps(tree), encoding="utf-8")
    return str(place)


def test_orders_are_sorted_by_the_twist_that_is_asked_for(run: Run) -> None:
    arguments = ("orders", "bmw-m52b28", "--minimise", "twist", "--orders", "0.5")
    rows = json.loads(run(*arguments, "--json").out)["orders"]
    twists = [row["twist"]["0.5"] for row in rows]
    assert twists == sorted(twists)
    assert rows[0]["order"] == [1, 5, 3, 6, 2, 4]
    assert rows[0]["row"] == 1


def test_a_row_of_the_sorted_orders_is_written(run: Run, tmp_path: Path) -> None:
    arguments = ("orders", "yamaha-r1-crossplane", "--any", "--minimise", "roll")
    told = json.loads(run(*arguments, "--orders", "0.5", "--json").out)["orders"]
    assert told[0]["roll"]["0.5"] < told[-1]["roll"]["0.5"]
    place = str(tmp_path / "quiet.toml")
    assert run(*arguments, "--orders", "0.5", "--row", "1", "-o", place).code == 0
    torque = json.loads(run("torque", place, "--json", "--orders", "0.5").out)["orders"][0]
    size = (torque["gas"][0] ** 2 + torque["gas"][1] ** 2) ** 0.5
    assert size == pytest.approx(told[0]["roll"]["0.5"], rel=1e-6)


def test_a_point_of_the_file_gives_the_size_of_a_cylinder(run: Run) -> None:
    arguments = ("orders", "bmw-m52b28", "--minimise", "twist", "--orders", "0.5", "--json")
    idle, full = (
        json.loads(run(*arguments, "--point", point).out)["orders"][0]["twist"]["0.5"]
        for point in ("idle", "full")
    )
    assert idle < full / 3


def test_without_sizes_orders_are_counted_in_one_cylinder(run: Run) -> None:
    shown = " ".join(run("orders", "i6", "--minimise", "twist").out.split())
    assert "Counted in one cylinder." in shown
    assert "N m" not in shown


def test_a_mode_shape_takes_the_place_of_the_even_twist(run: Run) -> None:
    arguments = ("orders", "i4", "--minimise", "twist", "--orders", "2", "--json")
    even = json.loads(run(*arguments).out)["orders"][0]["twist"]["2"]
    rigid = json.loads(run(*arguments, "--mode-shape", "1,1,1,1").out)["orders"][0]["twist"]["2"]
    assert even == pytest.approx(0, abs=1e-9)
    assert rigid == pytest.approx(4)


@pytest.mark.release
def test_an_engine_that_twists_weighs_orders_in_its_own_mode(run: Run, six: str) -> None:
    arguments = ("orders", six, "--minimise", "twist", "--orders", "0.5,1.5")
    rows = json.loads(run(*arguments, "--json").out)["orders"]
    engine = load(six)
    found = torsional(engine)
    mode = found.modes[0]
    shape = mode.shape[list(found.chain.cylinders)]
    own = next(row for row in rows if row["order"] == list(engine.firing_order))
    at = dict(zip(own["order"], np.radians(own["angles_deg"]), strict=True))
    waves = np.array([np.exp(1.5j * at[each.number]) for each in engine.cylinders])
    half = np.array([np.exp(0.5j * at[each.number]) for each in engine.cylinders])
    ratio = abs(waves @ shape) / abs(half @ shape)
    straight = json.loads(run(*arguments, "--mode-shape", "straight", "--json").out)["orders"]
    plain = next(row for row in straight if row["order"] == own["order"])["twist"]
    sizes = [own["twist"][key] for key in ("0.5", "1.5")]
    even = np.linspace(1, -1, 6)
    gas = (plain["1.5"] / abs(waves @ even)) / (plain["0.5"] / abs(half @ even))
    assert sizes[1] / sizes[0] == pytest.approx(gas * ratio, rel=1e-9)
    assert sizes[0] != pytest.approx(plain["0.5"], rel=0.05)
    shown = " ".join(run(*arguments).out.split())
    assert f"mode 1 of the crankshaft, {mode.frequency:.1f} Hz" in shown


@pytest.mark.release
def test_orders_are_sorted_by_the_stress_that_each_makes(
    run: Run, six: str, tmp_path: Path
) -> None:
    arguments = ("orders", six, "--minimise", "stress")
    rows = json.loads(run(*arguments, "--json").out)["orders"]
    values = [row["stress"] for row in rows]
    assert values == sorted(values)
    assert values[-1] > 1.001 * values[0]
    place = str(tmp_path / "best.toml")
    assert run(*arguments, "--row", "1", "-o", place).code == 0
    best = load(place)
    assert list(firing(best).order) == rows[0]["order"]
    low, *_, high = torsional(best).speeds.tolist()
    found = torsional(best, speeds=np.linspace(low, high, 900))
    assert found.response is not None
    peak = np.nanmax(stresses(found.response)[0]) / 1e6
    assert peak == pytest.approx(values[0], rel=0.02)


@pytest.mark.release
def test_orders_are_sorted_by_the_load_on_the_bearings(run: Run, six: str) -> None:
    rows = json.loads(run("orders", six, "--minimise", "bearings", "--json").out)["orders"]
    values = [row["bearings"] for row in rows]
    assert values == pytest.approx(sorted(values), rel=1e-9)
    assert rows[0]["order"] == [1, 5, 3, 6, 2, 4]
    engine = load(six)
    loads = bearing_loads(engine, cycle=cycle(engine))
    assert values[0] == pytest.approx(spectra.peaks(loads.load).max(), rel=1e-12)


@pytest.mark.release
def test_a_front_weighs_the_engine_s_own_mode_and_judges_each_row(
    run: Run, six: str, tmp_path: Path
) -> None:
    arguments = ("search", six, "--minimise", "M1,M2,twist")
    told = json.loads(run(*arguments, "--judge", "bearings,stress", "--json").out)
    engine = load(six)
    mode, shape = cylinder_shape(engine)
    own = told["judged"][0]
    angles = dict(zip(engine.firing_order, range(0, 720, 120), strict=True))
    torsions = [
        abs(sum(a * np.exp(1j * order * np.radians(angles[n])) for n, a in shape.items()))
        for order in (0.5, 1.5, 2.5)
    ]
    assert own["values"]["twist"] == pytest.approx(max(torsions), rel=1e-5)
    assert own["bearings"] == pytest.approx(judgement(engine, "bearings"), rel=1e-9)
    assert own["stress"] == pytest.approx(judgement(engine, "stress"), rel=1e-9)
    row = next(
        place
        for place, each in enumerate(told["rows"], 1)
        if each["stress_order"] != each["firing_order"]
    )
    place = str(tmp_path / "row.toml")
    for more in (("--judge", "bearings,stress"), ()):
        assert run(*arguments, *more, "--row", str(row), "-o", place).code == 0
        written = load(place)
        value, best = told["rows"][row - 1]["stress"], tuple(told["rows"][row - 1]["stress_order"])
        assert (written.firing_order == best) == bool(more)
        assert (judgement(written, "stress") == pytest.approx(value, rel=1e-6)) == bool(more)
    shown = " ".join(run(*arguments, "--judge", "stress").out.split())
    assert f"mode {mode.number} of the crankshaft, {mode.frequency:.1f} Hz" in shown
    assert f"Shear stress {own['stress']:.5g} MPa." in shown


@pytest.mark.release
@pytest.mark.parametrize("judge", JUDGES)
def test_a_row_shows_the_best_of_all_orders_with_its_sums(run: Run, six: str, judge: Judge) -> None:
    """Every permutation that fires evenly, put into the engine and computed."""
    words = ("search", six, "--minimise", "M1,T1.5,neighbours", "--judge", judge, "--json")
    rows = json.loads(run(*words).out)["rows"]
    engine = load(six)
    shaft = shaft_of_engine(engine)
    goals = (couple(shaft, 1), torsion(shaft, Fraction(3, 2), _shape(engine, shaft)))
    found: dict[tuple[float, ...], list[tuple[float, tuple[int, ...]]]] = {}
    for order in plain.angles(6, 720, 0)[0].tolist():
        fired = shaft.fired_in(order)
        sums = [round(one.length(shaft, fired), 5) for one in goals]
        key = (*sums, float(len(followed(shaft, order).neighbours)))
        if key in {_key(row) for row in rows}:
            value = judgement(with_fired(engine, shaft, fired), judge)
            found.setdefault(key, []).append((value, tuple(order)))
    assert len(rows) == len(found) > 5
    better = 0
    for row in rows:
        every = found[_key(row)]
        assert len(every) == row["orders"]
        assert row[judge] == pytest.approx(min(every)[0], rel=1e-9)
        own = {order: value for value, order in every}
        assert own[tuple(row[f"{judge}_order"])] == pytest.approx(row[judge], rel=1e-9)
        better += own[tuple(row["firing_order"])] > 1.001 * row[judge]
    if judge == "stress":  # the order that stands for a row is not always its best
        assert better > 0


def _key(row: dict[str, Any]) -> tuple[float, ...]:
    return (round(row["M1"], 5), round(row["T1.5"], 5), float(row["neighbours_in_succession"]))


def _shape(engine: Any, shaft: Any) -> tuple[Fraction, ...]:
    shape = cylinder_shape(engine)[1]
    return shape_of(shaft, [Fraction(f"{shape[number]:.6f}") for number in sorted(shape)])


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("6", "--minimise", "M1,twist", "--mode-shape", "mode 1"), "no modes of its own"),
        (("6", "--minimise", "M1,twist", "--judge", "stress"), "an engine"),
        (("i6", "--minimise", "M1,twist", "--judge", "noise"), "stress"),
        (("i6", "--minimise", "M1,twist", "--judge", "stress"), "[torsion]"),
        (("i6", "--minimise", "M1,twist", "--mode-shape", "mode 9"), "[torsion]"),
    ],
)
def test_a_front_that_cannot_be_judged_says_why(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    result = run("search", *arguments)
    assert result.code == 2
    assert words in " ".join(result.err.split())
    assert "Traceback" not in result.err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("bmw-m52b28", "--minimise", "stress"), "[torsion]"),
        (("bmw-m52b28", "--minimise", "bearings"), "reciprocating_mass"),
        (("bmw-m52b28", "--minimise", "stress", "--orders", "1"), "torque, roll and twist"),
        (("bmw-m52b28", "--minimise", "bearings", "--mode-shape", "mode 1"), "twist"),
        (("i4", "--minimise", "twist", "--mode-shape", "mode 1"), "[torsion]"),
        (("i4", "--orders", "1"), "--minimise"),
        (("i4", "--minimise", "noise"), "torque"),
        (("i4", "--minimise", "twist", "--orders", "0.3"), "multiples of 0.5"),
        (("i4", "--minimise", "twist", "--mode-shape", "1,2"), "4 numbers"),
        (("i4", "--minimise", "torque", "--mode-shape", "1,2,3,4"), "twist"),
        (("i4", "--minimise", "torque", "--point", "full"), "bore"),
        (("bmw-g650", "--minimise", "twist"), "one place"),
        (("bmw-s65", "--minimise", "twist", "--point", "nowhere"), "no operating point"),
    ],
)
def test_a_wrong_request_to_weigh_orders_is_told(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    result = run("orders", *arguments)
    assert result.code == 2
    assert words in " ".join(result.err.split())
    assert "Traceback" not in result.err


@pytest.mark.release
def test_orders_are_sorted_by_any_function_of_the_engine(six: str) -> None:
    engine = load(six)
    orders = even_orders(engine)
    best, values = judged(engine, orders, lambda each: judgement(each, "stress") / 2)
    plainly, halves = judged(engine, orders, "stress")
    assert best == plainly
    assert values == pytest.approx([value / 2 for value in halves])
    third = judged(engine, orders, lambda each: float(each.firing_order.index(4)))
    assert third[1] == tuple(sorted(each.firing.order.index(4) for each in orders))


def test_a_sum_in_newtons_rests_on_its_gas(run: Run) -> None:
    """Each end of a range is the sum of a file that has that value; without gas there is none."""
    line = ("orders", "audi-25-tfsi", "--minimise", "twist", "--json")
    said = json.loads(run(*line).out)
    rows = {row["path"]: row for row in said["rests_on"]}
    start = rows["gas.combustion_start"]["moves"]
    assert start["quantity"] == "least sum of firing orders"
    assert start["now"] == pytest.approx(said["orders"][0]["twist"]["together"], rel=1e-9)
    late = json.loads(run(*line, "--set", "gas.combustion_start=-10 deg").out)
    early = json.loads(run(*line, "--set", "gas.combustion_start=-30 deg").out)
    ends = sorted(each["orders"][0]["twist"]["together"] for each in (early, late))
    assert [start["low"], start["high"]] == pytest.approx(ends, rel=1e-9)
    counted = json.loads(run("orders", "i6", "--minimise", "torque", "--json").out)
    assert not [row for row in counted.get("rests_on", ()) if row["path"].startswith("gas")]
    found = crankstar.orders("audi-25-tfsi", minimise="twist")
    assert found.value.orders[0].firing.order == tuple(said["orders"][0]["order"])
    assert len(found.to_frame("orders")) == len(said["orders"])


def test_python_takes_crank_orders_as_numbers() -> None:
    found = crankstar.orders("i6", minimise="torque", orders=[0.5, 1]).to_frame("orders")
    assert {"torque_0.5", "torque_1"} < {*found.columns}
    with pytest.raises(ValueError, match="gas torque has multiples of"):
        crankstar.orders("i6", minimise="torque", orders=[0.3])
    with pytest.raises(TypeError, match="orders takes numbers such as"):
        crankstar.orders("i6", minimise="torque", orders=5)  # pyright: ignore[reportArgumentType]
