"""What answers with gas rest on, and those without it: each size by the file that has the value."""

import json
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.lacking import FIVE, GENSET
from tests.marine import WEIGHTED, marine_engine

from crankstar.files import engine_of, toml
from crankstar.files.catalog import load
from crankstar.mechanics.gas import cycle
from crankstar.studies.answer_parts import narrowed
from crankstar.studies.answers import amplitudes, rests_on, torques

BURNING = {"gas": {"compression_ratio": 10.5}, "drive": {"inertia": "0.15 kg*m^2"}}
SHIP = {
    **FIVE,
    "name": "two-stroke six",
    "cycle": "two-stroke",
    "firing_order": [1, 5, 3, 4, 2, 6],
    "speed": "120 rpm",
    "cylinder": {
        "bore": "500 mm",
        "stroke": "2000 mm",
        "rod_length": "2050 mm",
        "reciprocating_mass": "2500 kg",
        "rotating_mass": "3000 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "850 mm"},
    "gas": {"bmep": "19 bar"},
    "drive": {"inertia": "20000 kg*m^2"},
}


def written(folder: Path, tree: dict[str, Any]) -> str:
    path = folder / "engine.toml"
    path.write_text(toml(engine_of(tree)), encoding="utf-8")
    return str(path)


def rows_of(run: Run, *words: str) -> dict[str, dict[str, Any]]:
    return {row["path"]: row for row in json.loads(run(*words, "--json").out)["rests_on"]}


@pytest.mark.release
def test_the_closing_of_the_intake_moves_what_is_compressed() -> None:
    """Motored, by the adiabatic law from the charge pressure where the intake closes."""
    engine = engine_of({**FIVE, **BURNING})
    whole = torques(engine, lambda each: cycle(each, motored=True))
    found = rests_on(engine, narrowed(whole, ["peak pressure"]))
    [own] = [each for each in found if each.path == "valves.intake_closes"]
    assert (own.status, own.value, own.low, own.high) == ("assumed", 50, 40, 70)
    assert own.moved is not None
    radius, rod, ratio, gamma = 0.045, 0.145, 10.5, 1.3

    def peak(closes: float) -> float:
        angle = np.radians(180 + closes)
        way = radius * (1 - np.cos(angle)) + rod - np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
        share = way / (2 * radius)
        return float((1 + share * (ratio - 1)) ** gamma)  # bar, from 1 bar

    assert own.moved.quantity == "peak pressure"
    sizes = (own.moved.now, own.moved.low, own.moved.high)
    assert sizes == pytest.approx([peak(each) for each in (50, 70, 40)], rel=2e-3)


@pytest.mark.release
@pytest.mark.parametrize(
    ("verb", "tree"),
    [
        (("torque",), {**FIVE, **BURNING}),
        (("genset",), GENSET),
        (("marine",), SHIP),
        (("bearings", "--gas"), {**FIVE, **BURNING}),
    ],
    ids=["torque", "genset", "marine", "bearings"],
)
def test_assumed_valves_are_in_the_record_and_given_ones_are_not(
    verb: tuple[str, ...], tree: dict[str, Any], tmp_path: Path, run: Run
) -> None:
    command, *options = verb
    file = written(tmp_path, tree)
    name = "exhaust_closes" if tree is SHIP else "intake_closes"
    before = rows_of(run, command, file, *options)
    assert before[f"valves.{name}"]["moves"]["effect"] > 1e-3
    usual = f"valves.{name}={before[f'valves.{name}']['value']} deg"
    after = rows_of(run, command, file, *options, "--set", usual)
    assert f"valves.{name}" not in after
    others = [path for path in before if path.startswith("valves.") and path[7:] != name]
    assert [path for path in after if path.startswith("valves.")] == others


@pytest.mark.release
@pytest.mark.parametrize("verb", ["genset", "bearings"])
def test_a_cycle_that_a_misfire_brings_in_is_said_to_be_assumed(
    verb: str, tmp_path: Path, run: Run
) -> None:
    for tree, there in ((FIVE, True), ({**FIVE, **BURNING}, False)):
        file = written(tmp_path, tree)
        rows = rows_of(run, verb, file, "--off", "2")
        assert ("gas" in rows) == there
        assert "gas.imep" in rows
        text = run(verb, file, "--off", "2").out
        assert ("Not in the file, a usual cycle is assumed: gas." in text) == there


@pytest.mark.release
def test_the_irregularity_of_a_generating_set_is_among_its_figures(
    tmp_path: Path, run: Run
) -> None:
    file = written(tmp_path, SHIP)
    own = rows_of(run, "genset", file)["gas.combustion_start"]
    assert own["moves"]["quantity"] == "irregularity"
    sizes = [
        json.loads(run("genset", file, "--set", f"gas.combustion_start={end} deg", "--json").out)
        for end in (own["low"], own["high"])
    ]
    assert [own["moves"]["high"], own["moves"]["low"]] == pytest.approx(
        [each["irregularity"] for each in sizes], rel=1e-6
    )


@pytest.mark.release
def test_the_flywheel_that_was_asked_for_is_among_the_figures(tmp_path: Path, run: Run) -> None:
    file, asked = written(tmp_path, GENSET), ("--irregularity", "0.005")
    own = rows_of(run, "genset", file, *asked)["gas.gamma"]
    assert (own["moves"]["quantity"], own["moves"]["unit"]) == ("flywheel", "kg*m^2")


@pytest.mark.release
@pytest.mark.parametrize(
    ("name", "other", "beside"),
    [
        ("friction", "spark-ignition", ("--set", "gas.ignition=compression")),
        ("ignition", "spark", ()),
    ],
)
def test_a_choice_of_two_has_the_figure_of_the_other(
    name: str, other: str, beside: tuple[str, ...], tmp_path: Path, run: Run
) -> None:
    file = written(tmp_path, GENSET)
    own = rows_of(run, "genset", file)[f"gas.{name}"]
    assert (own["other"], own["low"], own["high"]) == (other, None, None)
    changed = json.loads(run("genset", file, "--set", f"gas.{name}={other}", *beside, "--json").out)
    [size] = [
        row["one"]
        for row in changed["sums"]
        if (row["quantity"], row["order"]) == ("roll", own["moves"]["order"])
    ]
    assert own["moves"]["quantity"] == "roll"
    assert own["moves"]["low"] == own["moves"]["high"] == pytest.approx(size, rel=1e-9)
    assert f"With {other}" in " ".join(run("genset", file).out.split())


def test_comparing_in_another_unit_is_what_leaves_the_gas_out(tmp_path: Path, run: Run) -> None:
    out = " ".join(run("compare", written(tmp_path, GENSET), "v8-flat-plane").out.split())
    assert "give speed" not in out
    assert "gas (compared in m r ω², without a speed, as an engine beside it has no masses" in out


def test_of_two_engines_the_one_without_masses_is_said_to_lack_them(
    tmp_path: Path, run: Run
) -> None:
    words = ("compare", written(tmp_path, GENSET), "triumph-675", "v8-flat-plane", "--json")
    printed = json.loads(run(*words).out)
    reasons = {row["engine"]: row["reason"] for row in printed["rests_on"] if row["path"] == "gas"}
    complete, bare, _without = reasons.values()
    assert "as an engine beside it has no masses" in complete
    assert "as its own file lacks masses, sizes or a speed" in bare


@pytest.mark.release
@pytest.mark.parametrize("verb", ["marine", "guide"])
def test_where_a_power_is_said_its_assumed_friction_is_named(
    verb: str, tmp_path: Path, run: Run
) -> None:
    """P = (imep - fmep) V / (2 pi) w: the brake power of `torque` with the other friction."""
    file = written(tmp_path, {**SHIP, "gas": {"imep": "20 bar"}})
    words = (verb, file, *(("--numbers", "6") if verb == "guide" else ()))
    own = rows_of(run, *words)["gas.friction"]
    changed = ("--set", f"gas.friction={own['other']}", "--set", "gas.ignition=compression")
    assert own["moves"]["quantity"] == "brake torque"
    for key, more in (("now", ()), ("low", changed), ("high", changed)):
        torque = json.loads(run("torque", file, *more, "--json").out)
        assert own["moves"][key] == pytest.approx(torque["brake_torque"], rel=1e-9)
        lost = torque["imep"] - torque["brake_torque"] * 2 * np.pi / (6 * np.pi / 4 * 0.5**2 * 2)
        assert lost == pytest.approx(torque["imep"] - torque["bmep"], rel=1e-6)


@pytest.mark.release
def test_the_figures_of_a_ships_engine_are_all_its_guide_moments(tmp_path: Path, run: Run) -> None:
    own = rows_of(run, "marine", written(tmp_path, SHIP))["gas.intake_pressure"]["moves"]
    assert (own["quantity"], own["order"], own["unit"]) == ("X moment", 3.0, "N*m")
    assert [own["low"], own["high"]] == pytest.approx([224e3, 329e3], rel=3e-3)


def test_crankpins_of_a_crosshead_engine_have_a_size() -> None:
    """The couple of order 1 is that of all that moves or turns at the crank radius."""
    engine = marine_engine(**WEIGHTED)
    [own] = [
        each for each in rests_on(engine, amplitudes(engine)) if each.path == "cylinder.throw_mass"
    ]
    assert (own.low, own.high) == pytest.approx((0.3 * 5500, 1.2 * 5500))
    assert "judgement" in own.reason
    assert own.moved is not None
    assert (own.moved.quantity, own.moved.order) == ("couple", 1)
    masses = 5500 + 3000 + np.array([0, 0.3 * 5500, 1.2 * 5500])
    sizes = [own.moved.now, own.moved.low, own.moved.high]
    assert np.array(sizes) / sizes[0] == pytest.approx(masses / masses[0], rel=1e-6)


@pytest.mark.parametrize(("speed", "most"), [("3000 rpm", 2.4), ("6000 rpm", 1.3)])
def test_the_roll_without_gas_has_the_size_of_a_usual_cycle(
    speed: str, most: float, tmp_path: Path, run: Run
) -> None:
    """Of order 2.5 five equal cylinders push as one, and nothing of inertia is in it.

    An engine as slow as a Diesel, which may be charged, or as fast as a petrol engine.
    """
    tree = {**FIVE, "speed": speed}
    engine = engine_of(tree)
    own = rows_of(run, "analyze", written(tmp_path, tree))["gas"]
    assert (own["status"], own["moves"]["quantity"], own["moves"]["order"]) == (
        "left out", "roll", 2.5,
    )  # fmt: skip
    assert [own["low"], own["high"]] == pytest.approx([0.7 * 9, most * 9])
    theta = np.linspace(0, 4 * np.pi, 3600, endpoint=False)
    sine = 0.045 / 0.145 * np.sin(theta)
    arm = 0.045 * (np.sin(theta) + np.cos(theta) * sine / np.sqrt(1 - sine**2))
    sizes = [
        5
        * abs(2 * np.mean(burning.pressure[0] * np.pi / 4 * 0.082**2 * arm * np.exp(-2.5j * theta)))
        for burning in (cycle(engine, imep=load * 1e5) for load in (own["low"], own["high"]))
    ]
    assert [own["moves"]["low"], own["moves"]["high"]] == pytest.approx(sizes, rel=2e-3)
    assert own["moves"]["now"] == pytest.approx(0, abs=1e-9)


def test_the_size_of_gas_needs_a_bore(tmp_path: Path, run: Run) -> None:
    sizes = {key: size for key, size in FIVE["cylinder"].items() if key != "bore"}
    file = written(tmp_path, {**FIVE, "cylinder": sizes})
    out = run("analyze", file).out
    assert "Not in the rolling moment: gas (its size needs cylinder.bore)." in out


@pytest.mark.release
def test_a_speed_that_is_not_certain_leaves_the_load(run: Run) -> None:
    """The load of [gas] has the speed of the file, as an operating point with another load has.

    A per cent of the speed changes neither: the indicated torque is p V / (4 pi) at every speed,
    and of the torque at the flywheel only the friction, by Barnes-Moss, depends on the speed.
    """
    swept = run(
        "sweep", "audi-25-tfsi", "--over", "gas.imep=5..12bar/3",
        "--quantity", "mean_torque", "--json",
    )  # fmt: skip
    assert [row["path"] for row in json.loads(swept.out)["rests_on"]].count("speed") == 0
    engine = load("audi-25-tfsi", changes={"gas.imep": "12 bar"})
    rated = 6500 * np.pi / 30
    volume = 5 * np.pi / 4 * 0.0825**2 * 0.0928
    thousands = 6.5 * np.array([0.99, 1.0, 1.01])
    friction = (0.97 + 0.15 * thousands + 0.05 * thousands**2) * 1e5
    brake = (12e5 - friction) * volume / (4 * np.pi)
    at_own = narrowed(torques(engine, cycle, running=False), ["brake torque"])
    moved = {each.path: each.moved for each in rests_on(engine, at_own)}["speed"]
    assert moved is not None
    assert [moved.high, moved.now, moved.low] == pytest.approx(brake, rel=1e-9)
    asked = torques(engine, partial(cycle, speed=rated), running=False)
    assert {each.path for each in rests_on(engine, asked) if each.effect} & {"speed"} == set()


@pytest.mark.parametrize("speed", [5300, 6000])
def test_an_asked_speed_leaves_the_load_between_two(speed: float) -> None:
    """The gas between two loads depends on the speeds of these, not on that of the file."""
    engine = load("audi-25-tfsi", changes={"gas.imep": "12 bar"})
    asked = torques(engine, partial(cycle, speed=speed * np.pi / 30), running=False)
    assert not [each for each in rests_on(engine, asked) if each.path == "speed" and each.effect]


def test_a_point_at_the_speed_of_the_file_goes_along() -> None:
    """The brake load of the point is that of the file at each speed: its torque stays."""
    engine = load("audi-25-tfsi")
    answer = narrowed(torques(engine, cycle, running=False), ["brake torque", "mean torque"])
    moved = {each.path: each.moved for each in rests_on(engine, answer)}["speed"]
    assert moved is not None
    thousands = 6.5 * np.array([0.99, 1.01])
    friction = (0.97 + 0.15 * thousands + 0.05 * thousands**2) * 1e5
    volume = 5 * np.pi / 4 * 0.0825**2 * 0.0928
    mean = (18.608e5 + friction) * volume / (4 * np.pi)
    assert (moved.quantity, [moved.low, moved.high]) == ("mean torque", pytest.approx(mean))


@pytest.mark.release
@pytest.mark.parametrize(("bore", "told"), [("81.8 mm", 0), ("70 mm", 1)])
def test_how_unlike_chambers_share_the_heat_is_said(
    run: Run, tmp_path: Path, bore: str, told: int
) -> None:
    """Each by its swept volume: the pressures are alike, whatever the bore."""
    tree = {**FIVE, **BURNING, "cylinders": [{"number": 2, "bore": bore}]}
    text = run("torque", written(tmp_path, tree)).out
    assert text.count("Chambers of unlike size burn the same heat") == told
    rows = cycle(engine_of(tree)).pressure
    assert rows[1] == pytest.approx(rows[0], rel=1e-9)  # cylinder 2, and cylinder 1
