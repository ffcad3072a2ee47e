"""The table `[torsion]`, files of drive lines, the verb torsion, and every mistake in them."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run, csv_rows
from tests.texts import EXPLICIT, SHORT, spoilt

from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.files import EngineFileError, engine_of, toml, tree_of
from crankstar.files.catalog import load
from crankstar.files.chains import chain_of

FLYWHEEL = {
    "name": "flywheel",
    "inertia": "0.3 kg*m^2",
    "to": "rear",
    "stiffness": "0.9 MN*m/rad",
    "diameter": "70 mm",
}
TORSION: dict[str, Any] = {
    "inertia": "0.03 kg*m^2",
    "stiffness": ["0.6 MN*m/rad", "0.7 MN*m/rad", "0.6 MN*m/rad"],
    "damping": "2 N*m*s/rad",
    "loss_factor": 0.03,
    "diameter": "60 mm",
    "bore": "20 mm",
    "shear_limit": "20 MPa",
    "disc": [
        {"name": "hub", "inertia": "0.01 kg*m^2", "to": "front", "stiffness": "0.4 MN*m/rad"},
        {"name": "ring", "inertia": "0.05 kg*m^2", "to": "hub", "damping": "8 N*m*s/rad"},
        FLYWHEEL,
        {"name": "gear", "inertia": "0.02 kg*m^2", "to": "flywheel", "speed_ratio": "-29/31"},
    ],
    "pendulum": [
        {"on": "throw 2", "mass": "0.3 kg", "radius": "80 mm", "length": "5 mm", "count": 2}
    ],
}
DIMENSIONS = {
    "journal_diameter": "60 mm",
    "journal_length": "28 mm",
    "pin_diameter": "48 mm",
    "pin_length": "26 mm",
    "web_width": "80 mm",
    "web_thickness": "18 mm",
}
GAS = {
    "imep": "10 bar",
    "compression_ratio": 10,
    "point": [
        {"name": "idle", "speed": "700 rpm", "imep": "2 bar"},
        {"name": "full", "speed": "6000 rpm"},
    ],
}
CHAIN = """
name = "motor, gear and fan"
speed = "1500 rpm"
[[disc]]
name = "motor"
inertia = "2 kg*m^2"
[[disc]]
name = "gear"
inertia = "0.5 kg*m^2"
to = "motor"
stiffness = "20 kN*m/rad"
[[disc]]
name = "fan"
inertia = "0.4 kg*m^2"
to = "gear"
stiffness = "8 kN*m/rad"
speed_ratio = "5/2"
"""


def mistakes(text: str = SHORT, **torsion: Any) -> list[tuple[str, str]]:
    """Where the faults of an engine with such a table are, and which."""
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(text, torsion=torsion))
    return [(".".join(map(str, fault.path)), fault.code) for fault in refusal.value.faults]


def test_a_torsion_table_is_the_same_written_and_read_back() -> None:
    engine = engine_of(spoilt(SHORT, torsion=TORSION))
    again = engine_of(tree_of(toml(engine)))
    assert again.torsion is not None
    assert again.torsion == engine.torsion
    assert again.torsion.inertia == (0.03,)
    assert again.torsion.stiffness[1] == pytest.approx(0.7e6)
    assert str(again.torsion.discs[3].speed_ratio) == "-29/31"


def test_one_value_and_a_list_of_it_are_the_same() -> None:
    one = engine_of(spoilt(SHORT, torsion=TORSION))
    many = engine_of(spoilt(SHORT, torsion={**TORSION, "inertia": ["0.03 kg*m^2"] * 4}))
    assert torsion_chain(one).inertia.tolist() == torsion_chain(many).inertia.tolist()


def disc(**values: Any) -> list[dict[str, Any]]:
    """A flywheel with other values; None leaves one out."""
    own = {**FLYWHEEL, **values}
    return [{key: value for key, value in own.items() if value is not None}]


@pytest.mark.parametrize(
    ("torsion", "place", "code"),
    [
        ({"inertia": None}, "torsion", "torsion.no-inertia"),
        ({"bare_inertia": "0.01 kg*m^2"}, "torsion.bare_inertia", "torsion.two-inertias"),
        ({"inertia": ["1 kg*m^2"] * 3}, "torsion.inertia", "torsion.length"),
        ({"stiffness": None}, "torsion", "torsion.no-stiffness"),
        ({"stiffness": ["1 MN*m/rad"] * 4}, "torsion.stiffness", "torsion.length"),
        ({"dimensions": DIMENSIONS}, "torsion.dimensions", "torsion.two-stiffnesses"),
        ({"damping": ["1 N*m*s/rad"] * 2}, "torsion.damping", "torsion.length"),
        ({"bore": "70 mm"}, "torsion.bore", "torsion.bore"),
        ({"diameter": None}, "torsion.bore", "torsion.bore-alone"),
        ({"disc": disc(to=None)}, "torsion.disc.0.to", "disc.on-nothing"),
        ({"disc": disc(to="gearbox")}, "torsion.disc.0.to", "disc.no-such-place"),
        ({"disc": disc(to="throw 5")}, "torsion.disc.0.to", "disc.no-such-place"),
        ({"disc": disc(to="flywheel")}, "torsion.disc.0.to", "disc.on-itself"),
        (
            {"disc": disc(stiffness=None, damping="0 N*m*s/rad")},
            "torsion.disc.0.damping",
            "disc.no-damping",
        ),
        ({"disc": disc() + disc()}, "torsion.disc.1.name", "disc.same-name"),
        ({"disc": disc(name="Throw 3")}, "torsion.disc.0.name", "disc.place-name"),
        (
            {"disc": [*disc(to="hub"), {"name": "hub", "inertia": "1 kg*m^2", "to": "rear"}]},
            "torsion.disc.0.to",
            "disc.on-a-later",
        ),
        (
            {"disc": disc(stiffness=None, loss_factor=0.1)},
            "torsion.disc.0.loss_factor",
            "disc.rigid-loss",
        ),
        ({"disc": disc(stiffness=0)}, "torsion.disc.0.stiffness", "greater-than.example"),
        (
            {"disc": disc(stiffness="-1 N*m/rad")},
            "torsion.disc.0.stiffness",
            "greater-than.example",
        ),
        ({"disc": disc(inertia=0)}, "torsion.disc.0.inertia", "greater-than.example"),
        ({"disc": disc(damping="-1 N*m*s/rad")}, "torsion.disc.0.damping", "at-least.example"),
        ({"disc": disc(stiffness="1 MN*m")}, "torsion.disc.0.stiffness", "unit.other-dimension"),
        ({"disc": disc(inertia="1 kg")}, "torsion.disc.0.inertia", "unit.other-dimension"),
        ({"disc": disc(speed_ratio=0)}, "torsion.disc.0.speed_ratio", "ratio.zero"),
        ({"loss_factor": -0.1}, "torsion.loss_factor", "at-least"),
        ({"inertia": 0}, "torsion.inertia", "greater-than.example"),
        ({"inertia": "x"}, "torsion.inertia", "unit.not-a-number"),
        (
            {"pendulum": [{**TORSION["pendulum"][0], "on": "nowhere"}]},
            "torsion.pendulum.0.on",
            "disc.no-such-place",
        ),
    ],
)
def test_each_mistake_of_torsion_has_its_sentence(
    torsion: dict[str, Any], place: str, code: str
) -> None:
    whole = {**TORSION, **torsion}
    whole = {key: value for key, value in whole.items() if value is not None}
    assert mistakes(**whole) == [(place, code)]


def test_all_mistakes_are_told_at_once() -> None:
    codes = [code for _place, code in mistakes(stiffness="1 MN*m/rad", disc=disc(to="x") + disc())]
    assert codes == ["torsion.no-inertia", "disc.no-such-place", "disc.same-name"]
    whole = spoilt(SHORT, torsion={**TORSION, "inertia": "1 kg"}, firing_order=[1, 2])
    with pytest.raises(EngineFileError) as refusal:
        engine_of(whole)
    places = {fault.path[0] for fault in refusal.value.faults}
    assert places == {"torsion", "firing_order"}


TWO: dict[str, Any] = {"inertia": "0.01 kg*m^2", "coupling": [{"crankshaft": "rear"}]}


@pytest.mark.parametrize(
    ("own", "place", "code"),
    [
        ({"coupling": []}, "torsion.coupling", "coupling.missing"),
        ({"coupling": [{"crankshaft": "rare"}]}, "crankshaft", "coupling.crankshaft"),
        ({"coupling": [{"crankshaft": "front"}]}, "crankshaft", "coupling.crankshaft"),
        ({"coupling": TWO["coupling"] * 2}, "crankshaft", "coupling.twice"),
        ({"coupling": [{"crankshaft": "rear", "to": "rear of rear"}]}, "to", "coupling.still"),
        ({"coupling": [{"crankshaft": "rear", "to": "hub"}]}, "to", "disc.no-such-place"),
        ({"coupling": [{"crankshaft": "rear", "at": "throw 2"}]}, "at", "disc.no-such-place"),
        ({"coupling": [{"crankshaft": "rear", "loss_factor": 0.1}]}, "stiffness", "coupling.rigid"),
        ({"inertia": ["1 kg*m^2"] * 3}, "torsion.inertia", "torsion.length"),
        ({"stiffness": "1 MN*m/rad"}, "torsion.stiffness", "torsion.one-throw"),
    ],
)
def test_each_mistake_of_several_crankshafts_has_its_sentence(
    own: dict[str, Any], place: str, code: str
) -> None:
    with pytest.raises(EngineFileError) as refusal:
        load("kr250-racer", changes={"torsion": {**TWO, **own}})
    [fault] = refusal.value.faults
    assert fault.code == code
    assert place in ".".join(map(str, fault.path))


def test_a_disc_between_a_crankshaft_and_itself_is_a_loop_that_is_refused() -> None:
    idler = {"name": "idler", "inertia": "1 kg*m^2", "to": "rear of rear", "stiffness": "1 N*m/rad"}
    own = {"coupling": [{"crankshaft": "rear", "to": "idler"}], "disc": [idler]}
    with pytest.raises(EngineFileError) as refusal:
        load("kr250-racer", changes={"torsion": {**TWO, **own}})
    assert [fault.code for fault in refusal.value.faults] == ["coupling.still"]


def test_two_crankshafts_have_a_table_of_masses_and_a_coupling(run: Run) -> None:
    stiff = 'torsion.coupling=[{crankshaft="rear", stiffness="1 MN*m/rad"}]'
    out = run(
        "torsion", "kr250-racer", "--set", 'torsion.inertia="0.01 kg*m^2"', "--set", stiff
    ).out
    assert "throw 1 of rear" in out
    assert "throw 1 - throw 1 of rear" in out
    # two equal masses on a spring: w^2 = 2 k/J
    assert f"{(2 * 1e6 / 0.01) ** 0.5 / (2 * 3.141592653589793):.4f}"[:6] in out


def test_bare_inertias_need_the_masses_of_the_pistons() -> None:
    bare = {key: value for key, value in TORSION.items() if key != "inertia"}
    bare |= {"bare_inertia": "0.01 kg*m^2"}
    tree = spoilt(SHORT, torsion=bare)
    del tree["cylinder"]["reciprocating_mass"]
    del tree["cylinder"]["rotating_mass"]
    with pytest.raises(EngineFileError) as refusal:
        engine_of(tree)
    assert [fault.code for fault in refusal.value.faults] == ["torsion.relative"]


@pytest.mark.release
def test_an_engine_without_masses_twists_by_gas_alone(run: Run, tmp_path: Path) -> None:
    tree = spoilt(SHORT, torsion=TORSION, gas=GAS)
    del tree["cylinder"]["reciprocating_mass"]
    del tree["cylinder"]["rotating_mass"]
    place = tmp_path / "eight.json"
    place.write_text(json.dumps(tree), encoding="utf-8")
    assert "gas alone" in run("torsion", str(place)).out


@pytest.mark.release
def test_an_engine_without_masses_and_gas_has_vector_sums(run: Run, tmp_path: Path) -> None:
    tree = spoilt(SHORT, torsion=TORSION, speed="3000 rpm")
    for key in ("reciprocating_mass", "rotating_mass", "bore"):
        del tree["cylinder"][key]
    place = tmp_path / "eight.json"
    place.write_text(json.dumps(tree), encoding="utf-8")
    answer = told(run, str(place), "--speed", "3000 rpm")
    assert answer["without_gas"]
    assert "response" not in answer
    assert answer["criticals"][0]["vector_sum"] > 0
    assert answer["criticals"][0]["equilibrium_deg"] is None
    assert "nothing is driven" in run("torsion", str(place)).out


@pytest.fixture
def eight(tmp_path: Path) -> str:
    """A V8 with a damper, a flywheel and a gear."""
    place = tmp_path / "eight.json"
    place.write_text(json.dumps(spoilt(SHORT, torsion=TORSION, gas=GAS)), encoding="utf-8")
    return str(place)


@pytest.fixture
def chain(tmp_path: Path) -> str:
    place = tmp_path / "chain.toml"
    place.write_text(CHAIN, encoding="utf-8")
    return str(place)


def told(run: Run, *arguments: str) -> dict[str, Any]:
    return json.loads(run("torsion", *arguments, "--json").out)


@pytest.mark.release
def test_the_answer_of_torsion_is_the_promised_one(run: Run, eight: str) -> None:
    answer = told(run, eight, "--speeds", "600..6000 rpm/28")
    assert answer["format"] == 1
    found = torsion(engine_of(spoilt(SHORT, torsion=TORSION, gas=GAS)))
    for row, mode in zip(answer["modes"], found.modes, strict=True):
        assert row["frequency_hz"] == pytest.approx(mode.frequency)
        assert row["shape"] == pytest.approx(mode.shape.tolist())
        assert len(row["nodes"]) == len(mode.nodes)
    names = [each["name"] for each in answer["masses"]]
    assert names == [
        *("ring", "hub", "throw 1", "throw 2", "throw 3", "throw 4", "flywheel", "gear")
    ]
    assert {"mode", "order", "speed_rpm", "vector_sum"} <= answer["criticals"][0].keys()
    for row in answer["criticals"]:
        assert 600 <= row["speed_rpm"] <= 6000
    speeds = [row["speed_rpm"] for row in answer["response"]]
    apart = np.abs(np.subtract.outer(np.linspace(600, 6000, 28), speeds))
    assert apart.min(axis=1).max() < 1e-6  # those asked for, and the critical ones
    assert speeds == sorted(speeds)
    sections = len(answer["sections"])
    for row in answer["response"]:
        assert {len(row[key]) for key in ("torque", "torque_sum", "stress", "heat")} == {sections}
        for peak, added in zip(row["torque"], row["torque_sum"], strict=True):
            assert peak <= added * (1 + 1e-9)
    assert answer["barred"]
    assert answer["assumed"][0] == "gamma"


@pytest.mark.release
def test_speeds_are_those_of_the_operating_points(run: Run, eight: str) -> None:
    speeds = [row["speed_rpm"] for row in told(run, eight)["response"]]
    assert (min(speeds), max(speeds)) == pytest.approx((700, 6000))


@pytest.mark.release
def test_a_range_may_stand_behind_speed_as_well(run: Run, eight: str) -> None:
    one = told(run, eight, "--speed", "1000..2000 rpm/5")
    assert one == told(run, eight, "--speeds", "1000..2000 rpm/5")


@pytest.mark.release
def test_one_speed_is_told_by_order_and_with_the_inertia_of_each_angle(
    run: Run, eight: str
) -> None:
    answer = told(run, eight, "--speed", "5000 rpm", "--point", "full")
    rows = {row["name"]: row for row in answer["sections_at_speed"]}
    own = rows["throw 3 - throw 4"]
    assert own["torque_of_each_angle"] == pytest.approx(own["torque"], rel=0.1)
    assert own["torque_of_each_angle"] != own["torque"]
    assert answer["point"] == "full"
    assert {row["order"] for row in answer["orders"]} >= {0.5, 4.0}


@pytest.mark.release
def test_another_operating_point_twists_it_otherwise(run: Run, eight: str) -> None:
    idle, full = (
        told(run, eight, "--point", point, "--speed", "700 rpm")["sections_at_speed"][3]["torque"]
        for point in ("idle", "full")
    )
    assert full > 2 * idle


@pytest.mark.release
def test_readers_have_chain_modes_criticals_stress_and_heat(run: Run, eight: str) -> None:
    text = run("torsion", eight, "--holzer", "1").out
    for words in (
        *("Masses", "Shafts between them", "Natural frequencies", "Mode shapes"),
        *("Holzer's table of mode 1", "Critical speeds", "Maximum vibration between 700"),
        *("Barred speeds", "Heat of damping", "stands still in the natural frequencies"),
    ):
        assert words in text


@pytest.mark.release
def test_estimated_stiffness_is_said_to_be(run: Run, tmp_path: Path) -> None:
    own = {key: value for key, value in TORSION.items() if key not in ("stiffness", "loss_factor")}
    tree = spoilt(SHORT, torsion={**own, "dimensions": DIMENSIONS}, gas=GAS)
    place = tmp_path / "estimated.json"
    place.write_text(json.dumps(tree), encoding="utf-8")
    text = " ".join(run("torsion", str(place)).out.split())
    assert "torsion.stiffness: stiffness of the throws from their dimensions" in text
    assert "torsion.dimensions.shear_modulus (80 GPa)" in text
    assert "torsion.loss_factor: 0.02 assumed" in text


def test_a_drive_line_without_cylinders_has_modes_and_criticals(run: Run, chain: str) -> None:
    answer = told(run, chain, "--orders", "1,2", "--speeds", "100..3000 rpm/3")
    assert answer["chain"] == "motor, gear and fan"
    assert [row["shape"][0] for row in answer["modes"]] == [1.0, 1.0]
    lines = {(row["mode"], row["order"]): row["speed_rpm"] for row in answer["criticals"]}
    first = answer["modes"][0]["frequency_hz"]
    assert lines[1, 2.0] == pytest.approx(first * 60 / 2)
    assert "Holzer's table of mode 2" in run("torsion", chain, "--holzer", "2").out
    softer = told(run, chain, "--set", 'disc[2].stiffness="1 kN*m/rad"')
    assert softer["modes"][0]["frequency_hz"] < first


def test_a_drive_line_is_checked_as_engines_are(run: Run, chain: str, tmp_path: Path) -> None:
    assert "good (motor, gear and fan, 3 discs)" in run("check", chain).out
    place = tmp_path / "wrong.toml"
    place.write_text(CHAIN.replace('to = "gear"', 'to = "fan"'), encoding="utf-8")
    found = run("check", str(place))
    assert found.code == 2
    assert "the disc itself" in found.err


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('name = "motor"', 'name = "motor"\nto = "fan"', "disc.first"),
        ('to = "motor"', 'to = "fan"', "disc.on-a-later"),
        ('to = "gear"', 'to = "fan"', "disc.on-itself"),
        ('to = "gear"', 'to = "rear"', "disc.no-such-place"),
        ('to = "gear"\n', "", "disc.on-nothing"),
        ('name = "fan"', 'name = "gear"', "disc.same-name"),
        ('"8 kN*m/rad"', '"0 kN*m/rad"', "greater-than.example"),
        ('"0.5 kg*m^2"', '"-1 kg*m^2"', "greater-than.example"),
        ('speed_ratio = "5/2"', 'ratio = "5/2"', "key.misspelt"),
        ('speed = "1500 rpm"', "speed = 1500", "unit.missing"),
    ],
)
def test_each_mistake_of_a_drive_line_has_its_sentence(old: str, new: str, code: str) -> None:
    assert old in CHAIN
    with pytest.raises(EngineFileError) as refusal:
        chain_of(tree_of(CHAIN.replace(old, new)))
    assert code in [fault.code for fault in refusal.value.faults]


@pytest.mark.many(first=8)
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("i4",), "give the table [torsion]"),
        (("EIGHT", "--holzer", "99"), "there are 5 modes"),
        (("EIGHT", "--holzer", "0"), "--holzer"),
        (("EIGHT", "--modes", "0"), "--modes"),
        (("EIGHT", "--point", "none"), "no operating point"),
        (("EIGHT", "--orders", "25"), "up to 24"),
        (("EIGHT", "--speed", "0 rpm"), "greater than 0"),
        (("EIGHT", "--speeds", "100..6000 rpm by 1"), "up to 2000 speeds"),
        (("CHAIN", "--point", "idle"), "--point"),
        (("CHAIN", "--estimate"), "--estimate"),
    ],
)
def test_what_cannot_be_is_refused_with_what_would_be_right(
    arguments: Sequence[str], words: str, run: Run, eight: str, chain: str
) -> None:
    names = {"EIGHT": eight, "CHAIN": chain}
    found = run("torsion", *(names.get(word, word) for word in arguments))
    assert found.code == 2
    assert words in " ".join(found.err.split())


@pytest.mark.release
def test_torsion_in_a_spreadsheet_and_as_csv(run: Run, eight: str, tmp_path: Path) -> None:
    asked = ("torsion", eight, "--speeds", "500..1500 rpm by 100", "--holzer", "2")
    answer = json.loads(run(*asked, "--json").out)
    kept = {key for key, rows in answer.items() if isinstance(rows, list) and rows}
    kept &= {"modes", "masses", "sections", "holzer", "criticals", "response", "barred"}
    assert {"holzer", "response"} <= kept
    run(*asked, "-o", str(tmp_path / "torsion.xlsx"))
    book = openpyxl.load_workbook(tmp_path / "torsion.xlsx")
    printed = run(*asked, "--csv").out
    for key in kept:
        assert book[key].max_row == len(answer[key]) + 1
        assert len(csv_rows(printed, key)) == len(answer[key])
    rows = csv_rows(run("torsion", eight, "--csv").out, "modes")
    heads = [*rows[0]]
    assert (heads[:2], heads[-1]) == (["mode", "frequency_hz [Hz]"], "nodes")
    names = [mass["name"] for mass in answer["masses"]]
    assert heads[2:-1] == [f"shape_{name}" for name in names]
    assert len(rows) == 5


@pytest.mark.release
def test_masses_that_are_all_rigid_do_not_twist(run: Run) -> None:
    text = run("torsion", "audi-25-tfsi", "--set", 'torsion.inertia="1 kg*m^2"').err
    assert "has no stiffness between the throws" in " ".join(text.split())
    sizes = ('cylinder.bore="90 mm"', 'cylinder.stroke="90 mm"', 'torsion.inertia="0.02 kg*m^2"')
    single = ("single", *(word for size in sizes for word in ("--set", size)))
    text = run("torsion", *single, "--speed", "3000 rpm").out
    assert "Nothing twists" in text
    assert "By order at this speed" in text
    for heading in ("Natural frequencies", "Shafts between", "Heat of damping", "Vibration at"):
        assert heading not in text
    assert told(run, *single, "--speed", "3000 rpm")["modes"] == []


@pytest.mark.release
def test_a_throw_lighter_than_its_pistons_is_doubted(run: Run, eight: str) -> None:
    light = ("--set", 'torsion.inertia="0.001 kg*m^2"')
    assert "bare_inertia of the crankshaft?" in " ".join(run("torsion", eight, *light).out.split())
    assert "bare_inertia of the" not in run("torsion", eight).out
    assert "bare_inertia of the" not in run("check", eight).out


def test_an_engine_without_torsion_raises_in_python() -> None:
    with pytest.raises(TorsionError):
        torsion(engine_of(spoilt(EXPLICIT)))


VALUES = ["", "x", -1, 0, 1e300, "1 MN*m/rad", "-3 kg*m^2", [], {}, True, None, "front", 2.5, "1/2"]


@pytest.mark.release
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.release)])
def test_any_spoilt_torsion_is_a_response_or_a_sentence(seed: int) -> None:
    """Tables with wrong values: vibration whose torques are numbers, or a refusal."""
    chance = np.random.default_rng(seed)

    def pick(options: Sequence[Any]) -> Any:
        return options[int(chance.integers(len(options)))]

    engines = 0
    for _ in range(200 if seed == 0 else 5_000):
        tree: dict[str, Any] = json.loads(json.dumps(TORSION))
        for _ in range(pick([1, 1, 2, 3])):
            table = pick([tree, tree, *tree.get("disc", []), *tree.get("pendulum", [])])
            if isinstance(table, dict):
                table[pick([*table, "stiffness", "damping", "to"])] = pick(VALUES)
            if not isinstance(tree["disc"], list) or not isinstance(tree["pendulum"], list):
                break
        try:
            engine = engine_of(spoilt(SHORT, torsion=tree))
        except EngineFileError:  # whose sentences were written for it
            continue
        engines += 1
        found = torsion(engine, speeds=[100.0, 500.0])
        assert found.response is not None
        assert np.isfinite(found.response.turns).all()
        assert all(np.isfinite(mode.shape).all() for mode in found.modes)
    assert engines > 5


@pytest.mark.parametrize(
    "slip",
    ['stiffness = "9 kN*m/rad"', 'damping = "2 N*m*s/rad"', "speed_ratio = 2", 'diameter = "9 mm"'],
)
def test_what_has_no_effect_on_a_first_disc_is_a_mistake(slip: str) -> None:
    text = CHAIN.replace('inertia = "2 kg*m^2"', f'inertia = "2 kg*m^2"\n{slip}')
    with pytest.raises(EngineFileError, match="first disc of a chain hangs on nothing"):
        chain_of(tomllib.loads(text), name="it")


def test_options_that_do_nothing_to_a_drive_line_are_refused(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "line.toml"
    place.write_text(CHAIN.replace('speed = "1500 rpm"\n', ""), encoding="utf-8")
    assert "--speeds" in run("torsion", str(place), "--orders", "2").err
    assert "--speed" in run("torsion", str(place), "--speed", "300 rpm").err
    assert run("torsion", str(place), "--orders", "2", "--speeds", "300..9000 rpm/9").code == 0


def test_pendulums_are_told_with_the_order_that_they_hold_back(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "line.toml"
    pendulum = '[[pendulum]]\non = "gear"\nmass = "0.4 kg"\nradius = "90 mm"\nlength = "10 mm"\n'
    place.write_text(f"{CHAIN.rstrip()}\n{pendulum}", encoding="utf-8")
    out = run("torsion", str(place)).out
    row = next(line for line in out.splitlines() if line.startswith("gear ") and " 90 " in line)
    assert row.split()[-1] == "3"
    (told,) = json.loads(run("torsion", str(place), "--json").out)["pendulums"]
    assert (told["on"], told["order"], told["length"]) == ("gear", pytest.approx(3), 10)


def test_a_mass_at_a_node_is_printed_as_nought() -> None:
    three = [{"name": "a", "inertia": 1}, {"name": "b", "inertia": 3, "to": "a", "stiffness": 7}]
    three.append({"name": "c", "inertia": 1, "to": "b", "stiffness": 7})
    first = torsion(chain_of({"name": "even", "disc": three}, name="it")).modes[0]
    assert first.shape.tolist() == [1.0, 0.0, pytest.approx(-1.0)]


@pytest.mark.release
def test_all_orders_of_a_two_stroke_engine_are_whole(run: Run) -> None:
    told = ("--set", "torsion.inertia=40 t*m^2", "--set", "torsion.stiffness=900 MN*m/rad")
    out = run("torsion", "man-s90mc-c", *told, "--orders", "all", "--json").out
    assert {each["order"] % 1 for each in json.loads(out)["criticals"]} == {0}


@pytest.mark.parametrize("verb", ["analyze", "verdict", "show", "bearings", "mounts"])
def test_other_commands_say_that_a_drive_line_is_no_engine(
    refused: Callable[..., str], chain: str, verb: str
) -> None:
    answer = refused(verb, chain)
    assert "1 mistake" in answer
    assert "a drive line without cylinders" in answer
    assert "`crankstar torsion`" in answer


def test_a_slip_in_an_engine_with_discs_is_not_taken_for_a_drive_line(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    place = tmp_path / "engine.toml"
    place.write_text('name = "x"\n[layuot]\ntype = "vee"\n[[disc]]\nname = "hub"\n')
    assert "layuot" in refused("analyze", str(place))
