"""Sweeps over what no engine runs with say so; a value that nothing uses cannot be set."""

import json
from math import pi
from pathlib import Path

import pytest
from tests.commands import Run

import crankstar
from crankstar.files.errors import EngineFileError

STARVED = ("sweep", "honda-b18c", "--quantity", "torque_with_gas")


@pytest.mark.release
def test_a_sweep_says_from_where_to_where_the_fuel_cannot_burn(run: Run) -> None:
    """9 bar of 1 bar of charge have 22.5: less than 11 of any charge below 0.489 bar."""
    words = [*STARVED, "--over", "gas.intake_pressure=0.3..1 bar by 0.1"]
    made = run(*words)
    assert made.code == 0, made.err
    said = " ".join(made.out.split())
    assert said.count("the fuel cannot burn") == 1
    assert "At gas.intake_pressure = 0.3 bar: " in said
    assert "So it is from 0.3 bar to 0.5 bar." in said
    [doubt] = json.loads(run(*words, "--json").out)["doubts"]
    assert doubt in said


@pytest.mark.release
def test_a_sweep_of_two_numbers_says_it_too_and_one_that_burns_does_not(run: Run) -> None:
    two = ["--over", "gas.intake_pressure=0.3..1 bar/3", "--over", "gas.gamma=1.25..1.35/3"]
    assert "the fuel cannot burn" in " ".join(run(*STARVED, *two).out.split())
    rich = [*STARVED, "--over", "gas.intake_pressure=0.8..1 bar/3"]
    assert "cannot burn" not in run(*rich).out
    assert json.loads(run(*rich, "--json").out)["doubts"] == []


def test_a_value_that_every_operating_point_has_of_its_own_cannot_be_set(run: Run) -> None:
    said = "give gas.point[1].intake_pressure, gas.point[2].intake_pressure"
    for words in (
        ["torque", "audi-25-tfsi", "--set", "gas.intake_pressure=1 bar"],
        ["sweep", "audi-25-tfsi", "--over", "gas.intake_pressure=1..2 bar/3"],
    ):
        made = run(*words)
        assert made.code == 2
        assert said in " ".join(made.err.split())
    with pytest.raises(EngineFileError, match="has no effect"):
        crankstar.load("audi-25-tfsi", changes={"gas.intake_pressure": "1 bar"})
    one = crankstar.load("audi-25-tfsi", changes={"gas.gamma": 1.32})  # no point has one
    assert crankstar.cycle(one).values["gamma"] == 1.32
    # the load of the table [gas] has all of its values
    both = {"gas.imep": "9 bar", "gas.intake_pressure": "0.9 bar"}
    assert crankstar.load("audi-25-tfsi", changes=both).gas is not None


@pytest.mark.release
def test_its_table_for_programs_and_its_chart_say_it_too(run: Run, tmp_path: Path) -> None:
    words = [*STARVED, "--over", "gas.intake_pressure=0.3..1 bar/4"]
    made = run(*words, "--csv")
    assert made.out.startswith("engine,")
    assert "the fuel cannot burn" in " ".join(made.err.split())
    assert "the fuel" not in made.out
    assert run(*words, "-o", str(tmp_path / "chart.html")).code == 0
    figure = (tmp_path / "chart.html").read_text("utf-8")
    assert "cannot" in figure
    assert "burn" in figure


@pytest.mark.release
def test_values_between_two_doubtful_ones_are_not_said_to_be_doubtful(run: Run) -> None:
    words = ["--over", "gas.compression_ratio=2,10,28", "--quantity", "peak_pressure"]
    said = " ".join(run("sweep", "honda-b18c", *words).out.split())
    assert "So it is at 2, 28." in said
    few = ["--over", "gas.compression_ratio=1.5,2,10,28", "--quantity", "peak_pressure"]
    assert "So it is at 1.5 to 2, 28." in " ".join(run("sweep", "honda-b18c", *few).out.split())


@pytest.mark.release
def test_friction_is_not_doubted_in_what_it_is_not_in(run: Run) -> None:
    """The file runs faster than its friction was measured; a peak pressure has none of it."""
    words = ["sweep", "honda-b18c", "--over", "gas.imep=8..9 bar/2", "--quantity"]
    said = [
        {each["path"] for each in json.loads(run(*words, name, "--json").out)["rests_on"]}
        for name in ("peak_pressure", "mean_torque")
    ]
    assert all("gas.friction_pressure" not in paths for paths in said)
    assert "gas.friction_pressure" in run("torque", "honda-b18c").out


TWO_LOADS = """
name = "four with two loads"
firing_order = [1, 3, 4, 2]
speed = "9000 rpm"
[cylinder]
bore = "67 mm"
stroke = "42.5 mm"
rod_length = "92 mm"
reciprocating_mass = "200 g"
rotating_mass = "150 g"
[gas]
compression_ratio = 13
ignition = "spark"
friction_pressure = "1 bar"
[[gas.point]]
name = "idle"
speed = "1200 rpm"
bmep = "0.1 bar"
[[gas.point]]
name = "full"
speed = "9000 rpm"
bmep = "12 bar"
[drive]
inertia = "0.012 kg*m^2"
[layout]
type = "inline"
bore_pitch = "75 mm"
"""


@pytest.mark.release
def test_what_matters_more_at_the_other_end_of_a_range_is_told_there(run: Run) -> None:
    """An unthrottled idle is far more uneven than one with the charge of a closed throttle."""
    Path("two.toml").write_text(TWO_LOADS, encoding="utf-8")
    words = ("sweep", "two.toml", "--over", "speed=1200..9000 rpm/2", "--quantity", "irregularity")
    told = json.loads(run(*words, "--json").out)
    assert told["rests_on_at"] == "speed = 9000 rpm"
    assert "With speed = 1200 rpm these move more:" in run(*words).out
    [row] = [
        each
        for each in told["rests_on"]
        if each["path"] == "gas.intake_pressure" and each.get("at") == "speed = 1200 rpm"
    ]
    least = crankstar.load(
        "two.toml", changes={"gas.point[1].intake_pressure": f"{row['low']!r} bar"}
    )
    found = crankstar.driven(least, crankstar.cycle(least, speed=1200 * pi / 30))
    assert found is not None
    assert row["moves"]["low"] == pytest.approx(found.irregularity, rel=1e-6)
    assert row["moves"]["now"] > 2 * row["moves"]["low"]
