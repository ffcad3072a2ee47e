"""What an answer rests on: against own sums, over the catalog, and in what is printed."""

from __future__ import annotations

import json
import re
from math import degrees, isfinite, pi
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run
from tests.files.conftest import run

from crankstar import spectra
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analyses.torsion.figures import twist
from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.changed_values import with_bearings_moved
from crankstar.dynamics.bearings import BearingLoads, bearing_loads
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.engine.block import inertia_in_box
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings
from crankstar.files import engine_of, toml
from crankstar.files.catalog import load, names
from crankstar.mechanics.gas import cycle
from crankstar.studies.answer_parts import narrowed
from crankstar.studies.answers import amplitudes, rests_on, torques
from crankstar.studies.load_answers import bearing_peaks
from crankstar.tables.assumptions import assumption_lines

__all__ = ["run"]


def assumptions(engine: Engine) -> tuple[Assumption, ...]:
    return rests_on(engine, amplitudes(engine))


def of(found: tuple[Assumption, ...], path: str) -> Assumption:
    return next(each for each in found if each.path == path)


def primary_couple(masses: np.ndarray, turning: float, speed: float) -> float:
    """The maximum of the primary pitching couple of the in-line five, by its own phasors, N m."""
    phases = np.radians([0, 144, 216, 288, 72])
    z = 0.088 * np.array([2, 1, 0, -1, -2])
    star = abs(np.sum(z * np.exp(1j * phases)))
    return float((masses.mean() + turning) * 0.0464 * speed**2 * star)


def turning_of(own: Assumption) -> tuple[float, float]:
    """Both ends of all that turns at the crank radius: big end and crankpin."""
    pins = dict(own.values)["pins"]
    assert own.low is not None
    assert own.high is not None
    return own.low + pins[0], own.high + pins[1]


def test_a_missing_rotating_mass_moves_the_primary_couple_as_own_phasors_say() -> None:
    engine = load("audi-25-tfsi")
    own = of(assumptions(engine), "cylinder.rotating_mass")
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert (own.status, own.value, own.moved.quantity, own.moved.order) == (
        "missing",
        0.0,
        "couple",
        1.0,
    )
    speed, masses = 6500 * pi / 30, np.full(5, 0.492)
    least, most = turning_of(own)
    ends = [primary_couple(masses, each, speed) for each in (0.0, least, most)]
    # the firing order 1-2-4-5-3 with throws 144 deg apart
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(ends, rel=1e-6)
    # the ranges of `crankstar estimate`: big end 182 to 529 g, crankpin 205 to 461 g
    assert (own.low, own.high) == pytest.approx((0.182, 0.529), abs=5e-4)
    assert (least, most) == pytest.approx((0.387, 0.990), abs=5e-4)


def test_forces_follow_the_square_of_an_unverified_speed() -> None:
    own = of(assumptions(load("audi-25-tfsi")), "speed")
    assert own.moved is not None
    assert own.moved.trial
    assert (own.moved.low, own.moved.high) == pytest.approx(
        (own.moved.now * 0.99**2, own.moved.now * 1.01**2)
    )


def test_an_assumed_rod_has_the_range_of_its_type() -> None:
    tree = {
        "name": "four",
        "speed": "6000 rpm",
        "cylinder": {"bore": "80 mm", "stroke": "80 mm", "reciprocating_mass": "500 g"},
        "layout": {"type": "inline", "throws": ["0 deg", "180 deg", "180 deg", "0 deg"]},
    }
    own = of(assumptions(engine_of(tree)), "cylinder.rod_length")
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert own.value == 4.0
    assert 2.5 < own.low < own.high < 5.5
    # secondary force of four pistons, 4 m r w^2 A2(l/r), A2 = 1/x + 1/(4 x^3) + 15/(128 x^5) + ...
    unit = 4 * 0.5 * 0.04 * (6000 * pi / 30) ** 2
    second = [unit * (1 / x + 1 / (4 * x**3) + 15 / (128 * x**5)) for x in (4.0, own.high, own.low)]
    assert (own.moved.quantity, own.moved.order) == ("force", 2.0)
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(second, rel=1e-4)


@pytest.mark.release
def test_what_matters_most_comes_first_and_every_effect_is_a_number() -> None:
    for name in names():
        engine = load(name)
        found = assumptions(engine)
        effects = [each.effect for each in found if each.status != "not modelled"]
        assert effects == sorted(effects, reverse=True), name
        assert all(isfinite(effect) and effect >= 0 for effect in effects), name
        assert len({each.path for each in found}) == len(found), name


def test_what_a_cycle_assumes_moves_its_torque() -> None:
    engine = load("audi-25-tfsi")
    own = cycle(engine)
    found = rests_on(engine, torques(engine, cycle))
    assert {f"gas.{name}" for name in own.assumed} - {"gas.crankcase_pressure"} <= {
        each.path for each in found
    }
    start = of(found, "gas.combustion_start")
    assert start.moved is not None
    assert start.moved.low < start.moved.now < start.moved.high


def test_a_weight_that_is_given_is_not_missing() -> None:
    paths = {
        each.path for each in assumptions(load("v8-cross-plane", changes={"balance_factor": 0.5}))
    }
    assert "crankshaft.weight" not in paths


def test_the_first_lines_of_an_analysis_say_it_and_so_does_json(run: Run) -> None:
    text = run("analyze", "audi-25-tfsi").out
    head = "\n".join(text.splitlines()[:16])
    assert "cylinder.rotating_mass" in head
    assert "747 to 1260 N m" in " ".join(head.split())
    rows = json.loads(run("analyze", "audi-25-tfsi", "--json").out)["rests_on"]
    assert rows[0]["path"] == "cylinder.rotating_mass"  # the roll with gas is beside that without
    assert rows[0]["moves"]["now"] == pytest.approx(417.949, abs=1e-3)
    assert rows[0]["moves"]["high"] == pytest.approx(1258.8, abs=0.1)


def test_the_roll_that_is_left_out_is_what_the_gas_pushes() -> None:
    engine = load("audi-25-tfsi")
    own = of(assumptions(engine), "gas.point.full")
    assert own.moved is not None
    burning = cycle(engine)
    # five equal cylinders 144 deg apart: of order 2.5 five times the wave of one, none of inertia
    theta = np.linspace(0, 4 * pi, burning.pressure.shape[1], endpoint=False)
    ratio = engine.first.rod_length / 0.0464
    sine = np.sin(theta) / ratio
    arm = 0.0464 * (np.sin(theta) + np.cos(theta) * sine / np.sqrt(1 - sine**2))
    torque = (burning.pressure[0] - 1.01325e5) * pi / 4 * 0.0825**2 * arm
    wave = 5 * abs(2 * np.mean(torque * np.exp(-2.5j * theta)))
    assert (own.status, own.moved.order, own.moved.now) == ("left out", 2.5, 0.0)
    assert own.moved.low == own.moved.high == pytest.approx(wave, rel=2e-3)


def test_the_load_of_bearings_is_that_of_a_file_with_the_mass() -> None:
    engine = load("audi-25-tfsi")
    own = of(rests_on(engine, bearing_peaks(engine, lambda _: None)), "cylinder.rotating_mass")
    assert own.moved is not None
    number = int(own.moved.quantity.removeprefix("main bearing "))
    pins = dict(own.values)["pins"]
    for mass, pin, size in zip(
        (own.low, own.high), pins, (own.moved.low, own.moved.high), strict=True
    ):
        masses = {"cylinder.rotating_mass": f"{mass} kg", "cylinder.throw_mass": f"{pin} kg"}
        heavier = load("audi-25-tfsi", changes=masses)
        peaks = spectra.peaks(bearing_loads(heavier, speed=heavier.speed).load)
        assert size == pytest.approx(float(peaks[number - 1]))


def test_bearings_that_are_placed_in_the_file_are_not_assumed() -> None:
    bare = load("audi-25-tfsi")
    at = [f"{88 * (2.5 - number)} mm" for number in range(6)]
    placed = load("audi-25-tfsi", changes={"crankshaft": [{"bearings": at}]})
    paths = [
        {each.path for each in rests_on(one, bearing_peaks(one, lambda _: None))}
        for one in (bare, placed)
    ]
    assert ["crankshaft.bearings" in each for each in paths] == [True, False]


@pytest.mark.release
def test_the_amplitude_at_a_resonance_goes_with_the_assumed_loss_factor() -> None:
    engine = load("cadillac-ld8")
    answer = narrowed(twist(engine), ["torsional amplitude"])
    own = of(rests_on(engine, answer), "torsion.loss_factor")
    assert own.moved is not None
    for loss, size in ((own.low, own.moved.high), (own.high, own.moved.low)):
        found = torsion(load("cadillac-ld8", changes={"torsion.loss_factor": loss}))
        assert found.response is not None
        peak = found.response.peak_turn(found.free_end).max()
        assert size == pytest.approx(degrees(float(peak)), rel=1e-6)


@pytest.mark.release
def test_a_block_without_moments_of_inertia_has_estimated_frequencies() -> None:
    places = [("left", -0.5, 0.0), ("right", 0.5, 0.0), ("rear", 0.0, -0.3)]
    rubber = [
        {"name": name, "right": f"{right} m", "z": f"{z} m", "stiffness": "50 N/mm"}
        for name, right, z in places
    ]
    engine = load("audi-25-tfsi", changes={"mounts": rubber, "block": {"mass": "150 kg"}})
    found = rests_on(engine, on_mounts(engine, speed=300.0))
    own = of(found, "block.inertia")
    assert (own.status, own.low, own.high) == ("estimated", 0.5, 2.5)
    radius, rod, bore = 0.0464, engine.first.rod_length, 0.0825
    box = inertia_in_box(150.0, sides=(3 * radius + rod + bore, 4 * radius, 4 * 0.088 + bore))
    assert own.vary is not None
    doubled = own.vary(engine, 2.0).block
    assert doubled is not None
    assert doubled.inertia is not None
    assert doubled.inertia[2] == pytest.approx(2 * box.high[2], rel=1e-9)
    assert own.effect > 0.1
    assert "mounts.loss_factor" in {each.path for each in found}


def test_a_doubt_that_asks_ends_with_its_question_mark() -> None:
    question = Assumption("doubtful", "torsion.stiffness", "torsion.stiffness is x: is it right?")
    plain = Assumption("doubtful", "torsion.stiffness", "torsion.stiffness is low")
    assert assumption_lines([question, plain]) == [question.reason, f"{plain.reason}."]


SAYING = [
    ("analyze", "audi-25-tfsi"),
    ("torque", "audi-25-tfsi"),
    ("genset", "audi-25-tfsi"),
    ("marine", "man-s90mc-c"),
    ("fault", "audi-25-tfsi", "--cut", "2"),
    ("bobweight", "audi-25-tfsi"),
    ("drill", "audi-25-tfsi", "--diameter", "12.7 mm", "--at-radius", "80 mm"),
    ("sweep", "audi-25-tfsi", "--over", "cylinder.rod_length=130..160 mm", "--quantity", "couple"),
    ("tolerance", "audi-25-tfsi", "--typical", "--builds", "1000"),
    ("guide", "audi-25-tfsi", "--numbers", "5"),
    ("bearings", "audi-25-tfsi", "--gas"),
    ("torsion", "cadillac-ld8"),
]


@pytest.mark.many(first=5)
@pytest.mark.parametrize("words", SAYING, ids=lambda words: words[0])
def test_every_command_says_what_it_rests_on(run: Run, words: tuple[str, ...]) -> None:
    assert "rests on:" in run(*words).out
    rows = json.loads(run(*words, "--json").out)["rests_on"]
    effects = [row["moves"]["effect"] if row["moves"] else 0.0 for row in rows]
    assert rows
    assert effects == sorted(effects, reverse=True)
    assert {row["status"] for row in rows} <= {
        "missing", "left out", "assumed", "estimated", "unverified"
    }  # fmt: skip


@pytest.mark.parametrize(
    "words",
    [("verdict", "audi-25-tfsi"), ("balance", "audi-25-tfsi"), ("compare", "audi-25-tfsi", "i4")],
    ids=lambda words: words[0],
)
def test_commands_of_text_alone_say_it_too(run: Run, words: tuple[str, ...]) -> None:
    assert "rests on:" in run(*words).out


@pytest.mark.release
def test_what_a_sweep_varies_is_not_in_doubt(run: Run) -> None:
    over = ("--over", "cylinder.rod_length=130..160 mm", "--quantity", "couple")
    rows = json.loads(run("sweep", "audi-25-tfsi", *over, "--json").out)["rests_on"]
    paths = {row["path"] for row in rows}
    assert "cylinder.rod_length" not in paths
    assert "cylinder.rotating_mass" in paths


def test_where_the_roll_has_its_gas_the_verdict_does_not_say_that_it_is_left_out(run: Run) -> None:
    said = " ".join(run("verdict", "audi-25-tfsi").out.split())
    assert "gas.point.full" not in said
    assert "gas.combustion_duration" in said
    assert "gas.point" not in run("verdict", "i4").out


@pytest.mark.many(first=1)
@pytest.mark.parametrize("units", ["si", "us", "kN, kN m"])
def test_both_ends_of_a_range_are_in_one_unit(run: Run, units: str) -> None:
    said = " ".join(run("analyze", "audi-25-tfsi", "--units", units).out.split())
    found = re.search(r"the couple of order 1 is ([\d.]+) to ([\d.]+) (.+?), not ([\d.]+) ", said)
    assert found
    low, high, now = (float(found[place]) for place in (1, 2, 4))
    # masses of 387 g, 990 g and none turn with pistons of 492 g
    assert (low / now, high / now) == pytest.approx((1 + 0.387 / 0.492, 1 + 0.990 / 0.492), 3e-3)


def test_a_bobweight_is_in_grams_at_both_ends(run: Run) -> None:
    assert "428 to 775 g, not 246 g" in " ".join(run("bobweight", "audi-25-tfsi").out.split())


def test_bearings_of_a_single_are_shifted_by_a_share_of_their_distance() -> None:
    engine = load("bmw-g650")
    moved = with_bearings_moved(engine, 10.0)
    shaft, other = engine.shafts[0], moved.shafts[0]
    front, rear = main_bearings(engine, shaft)
    assert other.bearings == pytest.approx([z + 0.1 * (front - rear) for z in (front, rear)])


@pytest.mark.release
def test_gas_that_is_left_out_is_measured_by_the_greater_of_both() -> None:
    for name in names():
        found = assumptions(load(name))
        assert all(each.effect <= 1 for each in found if each.status == "left out"), name


def single(**more: object) -> dict[str, object]:
    """A single without a rotating mass, r = 40 mm, m = 500 g, at 6000 rpm."""
    sizes = {"bore": "80 mm", "stroke": "80 mm", "rod_length": "140 mm"}
    return {
        "name": "one",
        "speed": "6000 rpm",
        "cylinder": {**sizes, "reciprocating_mass": "500 g"},
        "layout": {"type": "inline", "throws": [0]},
        **more,
    }


@pytest.mark.parametrize("bore", [True, False])
def test_a_rotating_mass_missing_beside_counterweights_moves_the_force_they_balance(
    bore: bool,
) -> None:
    """Up (m + m_rot) r - u, to the right m_rot r - u: the greatest of both, times w^2."""
    tree = single(crankshaft=[{"weight": [{"throw": 1, "unbalance": "12 g*m"}]}])
    if not bore:
        del tree["cylinder"]["bore"]  # type: ignore[attr-defined]
    own = of(assumptions(engine_of(tree)), "cylinder.rotating_mass")
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert 0.1 < own.low < own.high < 1.5
    speed = 6000 * pi / 30
    sizes = [
        speed**2 * max(abs((0.5 + turning) * 0.04 - 0.012), abs(turning * 0.04 - 0.012))
        for turning in (0.0, *turning_of(own))
    ]
    assert (own.moved.quantity, own.moved.order) == ("force", 1.0)
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(sizes, rel=1e-6)


def test_counterweights_of_a_balance_factor_go_with_the_rotating_mass() -> None:
    """Outside nothing moves; the crankpin carries what a file with that mass has on it."""
    tree = single(balance_factor=0.5)
    engine = engine_of(tree)
    assert "cylinder.rotating_mass" not in {each.path for each in assumptions(engine)}
    own = of(
        rests_on(engine, bearing_peaks(engine, lambda _engine: None)), "cylinder.rotating_mass"
    )
    assert own.moved is not None
    assert own.moved.quantity == "crank pin 1"
    whole = engine_of(tree, changes={"cylinder.rotating_mass": f"{own.high} kg"})
    loads = bearing_loads(whole, speed=whole.speed)
    assert own.moved.high == pytest.approx(float(spectra.peaks(loads.pin).max()), rel=1e-6)
    explicit = bearing_loads(
        engine_of(tree, changes={"cylinder.rotating_mass": "0 kg"}), speed=whole.speed
    )
    assert own.moved.now == pytest.approx(float(spectra.peaks(explicit.pin).max()), rel=1e-6)


def test_usual_counterweights_say_what_they_balance(run: Run) -> None:
    """Half of the reciprocating masses leaves half of the primary couple."""
    own = of(assumptions(load("audi-25-tfsi")), "crankshaft.weight")
    assert own.moved is not None
    assert dict(own.values) == {"factor": 0.5}
    assert own.moved.high == pytest.approx(own.moved.now / 2, rel=1e-9)
    told = " ".join(run("analyze", "audi-25-tfsi").out.split())
    assert "usual ones (all rotating masses and 50 % of the reciprocating masses)" in told


@pytest.mark.release
def test_a_pressure_that_is_assumed_moves_the_roll_beside_which_it_stands(
    run: Run, tmp_path: Path
) -> None:
    tree = single(gas={"compression_ratio": 9.5}, cycle="four-stroke", firing_order=[1])
    found = rests_on(engine_of(tree), amplitudes(engine_of(tree), both=True))
    own = of(found, "gas.imep")
    assert own.moved is not None
    assert (own.value, own.unit) == (9.0, "bar")
    assert own.moved.quantity == "roll with gas"
    sizes = []
    for pressure in (9.0, own.low, own.high):
        changed = engine_of(tree, changes={"gas.imep": f"{pressure} bar"})
        place = tmp_path / "one.toml"
        place.write_text(toml(changed), encoding="utf-8")
        rows = json.loads(run("torque", "one.toml", "--json").out)["orders"]
        [row] = [each for each in rows if each["order"] == own.moved.order]
        # gas and inertia torque, whose sum the block feels
        sizes.append(abs(complex(*row["gas"]) + complex(*row["inertia"])))
    assert own.moved.now == pytest.approx(sizes[0], rel=1e-6)
    assert sorted((own.moved.low, own.moved.high)) == pytest.approx(sorted(sizes[1:]), rel=1e-6)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("verb", ["analyze", "bearings", "torsion"])
def test_gas_that_cannot_be_computed_says_what_would_put_it_in(
    run: Run, verb: str, tmp_path: Path
) -> None:
    torsion_table = {
        "inertia": "0.02 kg*m^2",
        "disc": [
            {"name": "wheel", "inertia": "0.2 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
        ],
    }
    tree = single(gas={"imep": "9 bar"}, firing_order=[1], torsion=torsion_table)
    del tree["cylinder"]["bore"]  # type: ignore[attr-defined]
    (tmp_path / "one.json").write_text(json.dumps(tree), encoding="utf-8")
    told = " ".join(run(verb, "one.json").out.split())
    assert "gas: gas forces need the bore: give cylinder.bore in the engine file. With" in told


@pytest.mark.parametrize(
    ("given", "missing"), [("rotating_mass", "throw_mass"), ("throw_mass", "rotating_mass")]
)
def test_half_of_what_turns_is_not_all_of_it(given: str, missing: str) -> None:
    """Of a bare single, upward force (m + m_rot + m_pin) r w^2 with the half that is missing."""
    tree = single()
    engine = engine_of(tree, changes={f"cylinder.{given}": "0.4 kg"})
    own = of(assumptions(engine), f"cylinder.{missing}")
    assert own.moved is not None
    assert own.low is not None
    speed = 6000 * pi / 30
    sizes = [speed**2 * (0.9 + more) * 0.04 for more in (0.0, own.low, own.high or 0.0)]
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(sizes, rel=1e-6)
    both = {"cylinder.rotating_mass": "0.4 kg", "cylinder.throw_mass": "0.3 kg"}
    paths = {each.path for each in assumptions(engine_of(tree, changes=both))}
    assert not {"cylinder.rotating_mass", "cylinder.throw_mass"} & paths


@pytest.mark.many(first=1)
@pytest.mark.parametrize("command", ["analyze", "verdict", "bearings", "balance", "torque"])
def test_a_rod_that_hardly_any_engine_has_is_doubted_everywhere(run: Run, command: str) -> None:
    """Rod length over stroke taken for that over crank radius: 2.2 times the secondary force."""
    said = " ".join(
        run(command, "audi-25-tfsi", "--set", "cylinder.rod_length=75.632 mm").out.split()
    )
    rests = said.partition("This rests on: ")[2]
    assert "cylinder.rod_ratio: the rod is 1.63 times as long as the crank radius" in rests
    assert "rod_ratio is 3.26" in rests


@pytest.mark.release
def test_the_charge_of_a_part_load_reaches_down_to_a_closed_throttle() -> None:
    """Down to about the pressure at which all of the air of the load burns."""
    sizes = {"cylinder.reciprocating_mass": "500 g", "gas": {"imep": "3 bar"}}
    engine = load("honda-b18c", changes=sizes)
    own = of(rests_on(engine, torques(engine, cycle)), "gas.intake_pressure")
    assert own.low is not None
    assert (own.value, own.high) == (1.0, pytest.approx(1.2))
    throttled = cycle(
        load("honda-b18c", changes={**sizes, "gas.intake_pressure": f"{own.low} bar"})
    )
    assert throttled.air_fuel_ratio is not None
    assert 11 < throttled.air_fuel_ratio < 14.7  # gas exchange takes some more fuel
    full = cycle(engine).air_fuel_ratio
    assert full is not None
    assert own.low == pytest.approx(14.7 / full)
    loaded = load("honda-b18c", changes={**sizes, "gas": {"imep": "11 bar"}})
    usual = of(rests_on(loaded, torques(loaded, cycle)), "gas.intake_pressure")
    assert (usual.low, usual.high) == pytest.approx((0.9, 1.2))


def _peak(loads: BearingLoads, quantity: str) -> float:
    """The maximum load of a numbered part."""
    kind, _space, number = quantity.rpartition(" ")
    parts = {"main bearing": loads.load, "crank pin": loads.pin, "cylinder wall": loads.guide}
    return float(spectra.peaks(parts[kind])[int(number) - 1])


def test_loads_say_what_the_gas_that_they_leave_out_would_change() -> None:
    """With it they are those of the program with gas; of a usual cycle those at its two loads."""
    engine = load("audi-25-tfsi")
    rest = of(rests_on(engine, bearing_peaks(engine, lambda _: None)), "gas")
    assert rest.moved is not None
    burnt = bearing_loads(engine, speed=engine.speed, cycle=cycle(engine))
    most = _peak(burnt, rest.moved.quantity)
    assert rest.moved.high == pytest.approx(most, rel=1e-9)

    bare = load("audi-25-tfsi", changes={"gas": None})
    rest = of(rests_on(bare, bearing_peaks(bare, lambda _: None)), "gas")
    assert rest.moved is not None
    assert dict(rest.values)["ignition"] == "spark"
    ends: list[float] = []
    for imep in (rest.low, rest.high):
        assert imep is not None
        filled = load("audi-25-tfsi", changes={"gas": {"imep": f"{imep} bar"}})
        burnt = bearing_loads(filled, speed=filled.speed, cycle=cycle(filled))
        ends.append(_peak(burnt, rest.moved.quantity))
    assert rest.moved.low <= min(ends) * (1 + 1e-9)
    assert rest.moved.high >= max(ends) * (1 - 1e-9)


def test_a_force_is_told_before_a_roll_that_moves_little_more() -> None:
    """The rotating mass of a radial engine is in its primary force, which is said first."""
    row = {"throw": "0 deg", "cylinders": [1, 2, 3, 4, 5, 6, 7]}
    sizes = {"bore": "140 mm", "stroke": "150 mm", "rod_length": "290 mm"}
    engine = engine_of(
        {
            "name": "seven",
            "speed": "2100 rpm",
            "cylinder": {**sizes, "reciprocating_mass": "3.1 kg"},
            "layout": {"type": "radial", "knuckle_radius": "62 mm", "rows": [row]},
        }
    )
    rest = of(rests_on(engine, amplitudes(engine)), "cylinder.rotating_mass")
    assert rest.moved is not None
    assert (rest.moved.quantity, rest.moved.order) == ("force", 1)
    turning = 2100 * pi / 30
    assert rest.moved.now == pytest.approx(7 / 2 * 3.1 * 0.075 * turning**2, rel=1e-6)
    assert rest.high is not None
    pins = dict(rest.values)["pins"]
    more = 7 * (rest.high + pins[1]) * 0.075 * turning**2
    assert rest.moved.high == pytest.approx(rest.moved.now + more, rel=0.03)  # knuckles swing
