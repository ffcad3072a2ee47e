"""`crankstar fault` and `crankstar diagnose`: tables, pictures, JSON, and what they refuse."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run, csv_rows
from tests.methods.test_diagnosis import (
    PLACES,
    SHAPES,
    SPEED,
    file,
    four,
    lines,
    seen,
    without_weight,
)

import crankstar
from crankstar.analyses.diagnose.diagnosis import expected
from crankstar.analyses.diagnose.readings import AXES
from crankstar.files import engine_of, tree_text
from crankstar.spectra import Complex
from crankstar.studies.fault_kinds import Fault

Refused = Callable[..., str]
HEAD = "order, up [mm], right [mm], z [mm], direction, amplitude [mm/s], phase [deg]\n"


def listed(velocities: Complex) -> str:
    """Readings as a CSV list."""
    text = HEAD
    for each in lines(velocities):
        size, phase = 1e3 * abs(each.velocity), np.degrees(np.angle(each.velocity))
        place = ", ".join(f"{1e3 * value:g}" for value in each.place)
        text += f"{each.order:g}, {place}, {AXES[each.axis]}, {size:.9g}, {phase:.6f}\n"
    return text


@pytest.fixture(autouse=True)
def _files(tmp_path: Path) -> None:
    """The files lie in the directory where the commands run."""
    (tmp_path / "four.toml").write_text(tree_text(file()), encoding="utf-8")
    cold = {key: value for key, value in file().items() if key != "gas"}
    (tmp_path / "cold.toml").write_text(tree_text(cold), encoding="utf-8")
    (tmp_path / "healthy.csv").write_text(listed(seen(four())), encoding="utf-8")
    (tmp_path / "lost.csv").write_text(listed(seen(without_weight(2))), encoding="utf-8")


@pytest.mark.release
def test_a_lost_weight_is_named_with_what_it_cannot_be_told_from(run: Run) -> None:
    said = " ".join(run("diagnose", "four.toml", "lost.csv").out.split())
    assert "Likeliest: weight 2 lost, which explains 100 %." in said
    assert "it cannot be told from: big end 2 heavier by 200 g" in said
    assert "Next: " in said
    answer = json.loads(run("diagnose", "four.toml", "lost.csv", "--json").out)
    assert (answer["format"], answer["explained"], answer["healthy"]) == (1, True, False)
    assert len(answer["suspects"]) == 16
    alike = answer["cannot_be_told_apart"][0]["faults"][0]
    named = {(row["kind"], row["number"]) for row in answer["suspects"][:2]}
    assert named == {("weight", 2), ("big_end", 2)}
    assert (alike["kind"], alike["number"]) in named


@pytest.mark.release
def test_a_healthy_engine_is_told_in_one_sentence(run: Run) -> None:
    said = " ".join(run("diagnose", "four.toml", "healthy.csv").out.split())
    assert "Nothing is out of order by this measurement" in said
    before = run("diagnose", "four.toml", "healthy.csv", "--before", "healthy.csv").out
    assert "Nothing is out of order" in before


@pytest.mark.release
def test_what_no_fault_explains_is_told_in_one_sentence(run: Run, tmp_path: Path) -> None:
    rows = (tmp_path / "healthy.csv").read_text(encoding="utf-8").splitlines()
    chance = np.random.default_rng(5)
    text = [HEAD.strip()]
    for row in rows[1:]:
        cells = row.split(",")
        text.append(
            ",".join(
                [*cells[:5], f" {chance.uniform(50, 90):.3f}", f" {chance.uniform(0, 360):.1f}"]
            )
        )
    (tmp_path / "odd.csv").write_text("\n".join(text), encoding="utf-8")
    said = " ".join(run("diagnose", "four.toml", "odd.csv").out.split())
    assert "No single fault explains this measurement: the best explains" in said
    assert not json.loads(run("diagnose", "four.toml", "odd.csv", "--json").out)["explained"]


@pytest.mark.release
def test_a_list_may_give_the_error_of_each_reading(
    run: Run, refused: Refused, tmp_path: Path
) -> None:
    head, *rows = (tmp_path / "lost.csv").read_text(encoding="utf-8").splitlines()
    text = "\n".join([f"{head}, error", *(f"{row}, 3 um" for row in rows)])
    (tmp_path / "errors.csv").write_text(text, encoding="utf-8")
    said = " ".join(run("diagnose", "four.toml", "errors.csv").out.split())
    assert "Likeliest: weight 2 lost, which explains 100 %." in said
    assert "Errors are those of the list." in said
    wrong = text.replace("3 um", "0 um", 1)
    (tmp_path / "none.csv").write_text(wrong, encoding="utf-8")
    assert "the error must be greater than 0" in refused("diagnose", "four.toml", "none.csv")
    for tiny in ("1e-300 mm/s", "1e-150 m/s", "1e-200 um", "1e-15 m/s^2"):
        (tmp_path / "tiny.csv").write_text(text.replace("3 um", tiny, 1), encoding="utf-8")
        told = " ".join(refused("diagnose", "four.toml", "tiny.csv").split())
        assert f'line 2, column "error" is "{tiny}", too small for an engine' in told


@pytest.mark.release
def test_one_reading_is_told_to_be_too_few(run: Run, tmp_path: Path) -> None:
    rows = (tmp_path / "lost.csv").read_text(encoding="utf-8").splitlines()
    (tmp_path / "one.csv").write_text("\n".join([rows[0], rows[10]]), encoding="utf-8")
    said = " ".join(run("diagnose", "four.toml", "one.csv").out.split())
    assert "So few readings are explained by many faults" in said


@pytest.mark.release
def test_the_picture_has_bars_and_vectors(run: Run, tmp_path: Path) -> None:
    run("diagnose", "four.toml", "lost.csv", "-o", "why.svg")
    drawn = (tmp_path / "why.svg").read_text(encoding="utf-8")
    assert "weight 2 lost" in drawn
    assert drawn.count(">measured<") == drawn.count(">explained<") == 4


@pytest.mark.release
def test_what_a_cut_changes_is_half_orders_of_roll(run: Run) -> None:
    said = json.loads(run("fault", "four.toml", "--cut", "3", "--json").out)
    rows = {row["order"]: row for row in said["orders"]}
    assert rows[0.5]["before"]["roll"] == pytest.approx(0, abs=1e-6)
    assert rows[0.5]["now"]["roll"] > 10
    assert rows[1]["now"]["force"] == pytest.approx(rows[1]["before"]["force"])
    assert {0.5, 1.0, 1.5} <= {*said["new_orders"]}
    assert said["faults"] == [{"kind": "combustion", "number": 3, "size": 1.0}]


@pytest.mark.release
def test_a_heavier_piston_adds_its_share_of_force(run: Run) -> None:
    said = json.loads(run("fault", "four.toml", "--heavier", "piston.1=20g", "--json").out)
    row = next(row for row in said["orders"] if row["order"] == 1)
    assert row["now"]["force"] == pytest.approx(0.02 * 0.045 * SPEED**2, rel=1e-6)
    assert row["now"]["velocity"] > 0
    text = run("fault", "four.toml", "--heavier", "piston.1=-20g", "--weaker", "2=20%").out
    assert "cylinder 2 weak by 20 %, piston 1 lighter by 20 g" in text


@pytest.mark.release
def test_a_cut_without_gas_in_the_file_is_told_by_a_usual_cycle(run: Run) -> None:
    """As `torque --off` tells it: the same roll of order 0.5; what is assumed is said."""
    told = run("fault", "cold.toml", "--cut", "3", "--orders", "0.5,1").out
    assert "with a usual cycle: the file has no gas." in told
    assert "a usual cycle is assumed: gas" in told
    assert "roll and torque include the gas" in " ".join(told.split())
    half = json.loads(run("fault", "cold.toml", "--cut", "3", "--json").out)["orders"][0]
    alone = json.loads(run("torque", "cold.toml", "--off", "3", "--json").out)["orders"][0]
    assert (half["order"], half["before"]["roll"]) == (0.5, pytest.approx(0, abs=1e-9))
    assert half["now"]["torque"] == pytest.approx(abs(complex(*alone["gas"])), rel=1e-9)


def test_csv_has_every_order(run: Run) -> None:
    said = run("fault", "four.toml", "--lost-weight", "2=30%", "--orders", "1,2", "--csv").out
    rows = list(csv.DictReader(io.StringIO(said)))
    assert [float(row["order"]) for row in rows] == [1, 2]


@pytest.mark.many(first=9)
@pytest.mark.parametrize(
    ("line", "told"),
    [
        (("four.toml",), "name a fault: --cut 3"),
        (("four.toml", "--cut", "x"), "give numbers of cylinders"),
        (("four.toml", "--cut", "9"), "no cylinder 9; give one of 1, 2, 3, 4"),
        (("four.toml", "--weaker", "3"), "as in 3=20%"),
        (("four.toml", "--weaker", "3=120%"), "a share from 0.001 to 1"),
        (("four.toml", "--heavier", "valve.3=20g"), "as in piston.3=20g"),
        (("four.toml", "--heavier", "piston.3=20"), "with a unit"),
        (("four.toml", "--heavier", "piston.3=20 mm"), "a mass is needed"),
        (("four.toml", "--heavier", "piston.3=-5kg"), "lighter by 5000 g: that is more than it"),
        (("four.toml", "--heavier", "piston.3=0 g"), "that changes nothing"),
        (("four.toml", "--heavier", "piston.3=20 kg"), "more than 10 times what it weighs"),
        (("four.toml", "--weaker", "3=0.0000001"), "a share from 0.001 to 1"),
        (("four.toml", "--cut", "1,2,3,4"), "leave at least one that does"),
        (("four.toml", "--cut", "1,2,3", "--weaker", "4=100%"), "leave at least one that does"),
        (("four.toml", "--cut", "3", "--orders", "0.3,1"), "order 0.3 does not occur"),
        (("cold.toml", "--lost-weight", "2", "--orders", "0.5"), "those that do are 1, 2, 3"),
        (("four.toml", "--lost-weight", "9"), "there is no weight 9"),
        (("four.toml", "--lost-weight", "balancer.1"), "no shaft balancer"),
        (
            ("i4", "--heavier", "piston.3=20g", "--speed", "800 rpm"),
            "give cylinder.stroke, cylinder.rec",
        ),
    ],
)
def test_a_fault_that_cannot_be_is_one_sentence(
    refused: Refused, line: tuple[str, ...], told: str
) -> None:
    assert told in " ".join(refused("fault", *line).split())


@pytest.mark.many(first=6)
@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("order, up", "ordr, up", 'the column "ordr" is not known; "order" is'),
        ("phase [deg]", "", "column 7 has values and no heading"),
        ("direction, ", "serial, ", 'the column "serial" is not known'),
        ("\n0.5, ", "\n0, ", 'line 2, column "order": give an order above 0'),
        ("\n0.5, ", "\n0.4, ", 'line 2, column "order": order 0.4 does not occur'),
        ("\n0.5, ", "\nhalf, ", '"half" is no number'),
        (", up, ", ", sideways, ", "give up, down, right, left or z"),
        ("[mm/s]", "[V]", 'line 1, column "amplitude [V]": it has no unit of a displacement'),
        ("[mm/s]", "", "it has no unit of a displacement"),
        ("[mm/s], phase", "[mm/s], speed [rpm], phase", "line 2"),
    ],
)
def test_a_mistake_in_a_measurement_is_told_with_its_place(
    refused: Refused, tmp_path: Path, old: str, new: str, told: str
) -> None:
    text = (tmp_path / "lost.csv").read_text(encoding="utf-8").replace(old, new, 1)
    (tmp_path / "bad.csv").write_text(text, encoding="utf-8")
    assert told in " ".join(refused("diagnose", "four.toml", "bad.csv").split())


def test_two_values_before_of_one_place_are_not_chosen_from(
    refused: Refused, tmp_path: Path
) -> None:
    text = (tmp_path / "lost.csv").read_text(encoding="utf-8")
    head, first, rest = text.split("\n", 2)
    order, *cells, amplitude, phase = first.split(",")
    other = ",".join([order, *cells, f" {2 * float(amplitude) + 1}", phase])
    (tmp_path / "before.csv").write_text("\n".join([head, first, other, rest]), encoding="utf-8")
    asked = ("diagnose", "four.toml", "lost.csv", "--before")
    assert "line 3 of the measurement before has" in " ".join(refused(*asked, "before.csv").split())
    assert '--before "": it is empty' in refused(*asked, "")
    assert "name of a list is empty" in refused("diagnose", "four.toml", "")


@pytest.mark.release
def test_a_fault_that_none_of_the_orders_has_is_told_in_a_sentence(run: Run) -> None:
    line = ("fault", "four.toml", "--lost-weight", "2", "--orders", "2,4")
    said = run(*line).out
    assert "Nothing changes by more than 0.1 % of the greatest order." in said
    assert "What changes" not in said
    assert len(json.loads(run(*line, "--json").out)["orders"]) == 2


@pytest.mark.release
def test_a_part_that_would_lose_all_of_it_is_told(run: Run, tmp_path: Path) -> None:
    rest = lines(np.zeros(len(SHAPES)))
    healthy = expected(four(), rest)
    one = expected(four(), rest, [Fault("piston", 3)]) - healthy  # 1 kg, more than its 690 g
    (tmp_path / "m.csv").write_text(listed(healthy - 0.9 * one), encoding="utf-8")
    said = " ".join(run("diagnose", "four.toml", "m.csv").out.split())
    assert "A part loses no more than it weighs in the file: piston" in said
    answer = json.loads(run("diagnose", "four.toml", "m.csv", "--json").out)
    pistons = [row["size"] for row in answer["suspects"] if row["kind"] == "piston"]
    assert min(pistons) == pytest.approx(-0.69)
    assert answer["suspects"][0]["size"] == min(pistons)


def test_every_mistake_in_a_measurement_is_told_at_once(refused: Refused, tmp_path: Path) -> None:
    rows = ["-1, 0, 0, 0, up, 1, 0", "1, 0, 0, 0, aside, 1e9, 0", "1, 0, 0, 0, up, -3 um, 0 mm"]
    (tmp_path / "bad.csv").write_text(HEAD + "\n".join(rows), encoding="utf-8")
    head, *told = refused("diagnose", "four.toml", "bad.csv").splitlines()
    assert head == "crankstar: bad.csv: 5 mistakes"
    assert [int(line.split()[1].strip(",:")) for line in told] == [2, 3, 3, 4, 4]
    assert any('"1e9 mm/s", too large' in line for line in told)


def test_a_measurement_before_in_other_places_is_refused(refused: Refused, tmp_path: Path) -> None:
    text = (tmp_path / "healthy.csv").read_text(encoding="utf-8")
    place = f"{1e3 * PLACES[0][0]:g}"
    (tmp_path / "other.csv").write_text(text.replace(f" {place},", " 299,"), encoding="utf-8")
    said = refused("diagnose", "four.toml", "lost.csv", "--before", "other.csv")
    assert "line 2 of the measurement has none before it" in " ".join(said.split())


def noisy(tmp_path: Path, *, share: float) -> None:
    """noisy.csv: a heavier big end, with so much of the difference as noise at random."""
    chance = np.random.default_rng(2)
    engine = four()
    heard = expected(engine, lines(seen(engine)), [Fault("big_end", 3, 0.03)])
    size = float(np.abs(heard - seen(engine)).max())
    noise = share * size * (chance.normal(size=heard.size) + 1j * chance.normal(size=heard.size))
    (tmp_path / "noisy.csv").write_text(listed(heard + noise), encoding="utf-8")


@pytest.mark.release
def test_sizes_are_told_as_far_as_their_error_goes(run: Run, tmp_path: Path) -> None:
    noisy(tmp_path, share=0.2)
    found = json.loads(run("diagnose", "four.toml", "noisy.csv", "--json").out)["suspects"]
    said = run("diagnose", "four.toml", "noisy.csv").out.splitlines()
    (row,) = [each for each in found if (each["kind"], each["number"]) == ("big_end", 3)]
    (line,) = [each for each in said if "±" in each and "big end 3 " in each]
    match = re.search(r"heavier by ([\d.]+) g +± ([\d.]+) g", line)
    assert match, line
    told, error = match[1], match[2]
    assert float(error) == pytest.approx(1000 * row["size_error"], rel=0.05)
    places = len(error.partition(".")[2])
    assert len(told.partition(".")[2]) <= places
    assert float(told) == pytest.approx(1000 * row["size"], abs=0.51 * 10**-places)


@pytest.mark.release
def test_suspects_without_a_size_are_left_out_of_what_is_read(run: Run, tmp_path: Path) -> None:
    """Without weights all suspects are shown, and a share cannot be less than nought."""
    tree = {key: value for key, value in file().items() if key != "crankshaft"}
    engine = engine_of(tree)
    (tmp_path / "bare.toml").write_text(tree_text(tree), encoding="utf-8")
    heard = expected(engine, lines(seen(engine)), [Fault("piston", 3, 0.03)])
    (tmp_path / "piston.csv").write_text(listed(heard), encoding="utf-8")
    found = json.loads(run("diagnose", "bare.toml", "piston.csv", "--json").out)["suspects"]
    assert [each for each in found if not each["size"]]
    said = run("diagnose", "bare.toml", "piston.csv").out
    assert "piston 3 heavier by 30 g" in said
    assert not re.search(r"(by|:) -?0 (%|g|kg)", said)
    shown = [each for each in said.splitlines() if "±" in each]
    assert len(shown) == len([each for each in found if each["size"]])


@pytest.mark.release
def test_csv_has_the_unit_of_each_size(run: Run) -> None:
    text = run("diagnose", "four.toml", "lost.csv", "--csv").out
    units = {row["kind"]: row["size_unit"] for row in csv_rows(text, "suspects")}
    assert units == {"piston": "kg", "big_end": "kg", "weight": "share", "combustion": "share"}


@pytest.mark.release
def test_a_point_of_the_block_is_named_and_the_first_one_is_told(run: Run) -> None:
    points = '\n\n[[block.points]]\nname = "{}"\nup = "{} mm"\nright = "20 mm"\nz = "{} mm"\n'
    text = Path("four.toml").read_text(encoding="utf-8")
    Path("seat.toml").write_text(
        text + points.format("seat", 300, -40) + points.format("tip", 120, 90), encoding="utf-8"
    )
    line = ("fault", "seat.toml", "--cut", "3", "--json")
    first, tip = (json.loads(run(*line, *at).out) for at in ((), ("--at", "tip")))
    assert (first["point_mm"], tip["point_mm"]) == ([300, 20, -40], [120, 20, 90])
    plain = json.loads(run(*line, "--at", "90 mm, 120 mm, 20 mm").out)
    assert tip["orders"] == plain["orders"]
    assert run(*line, "--at", "chair").code == 2


@pytest.mark.release
def test_the_point_whose_velocity_is_told_is_named(run: Run) -> None:
    line = ("fault", "four.toml", "--cut", "3")
    said = " ".join(run(*line, "--at", "0 mm, 300 mm, 20 mm").out.split())
    assert "is that of the point 300 mm up, 20 mm to the right, 0 mm along" in said
    own = json.loads(run(*line, "--json").out)
    there = ", ".join(f"{own['point_mm'][k]:g} mm" for k in (2, 0, 1))
    again = json.loads(run(*line, "--at", there, "--json").out)
    assert [row["now"]["velocity"] for row in own["orders"]] == pytest.approx(
        [row["now"]["velocity"] for row in again["orders"]]
    )
    assert "The velocity is that of the centre of mass:" in " ".join(run(*line).out.split())


@pytest.mark.parametrize(
    "faults",
    [
        ("--weaker", "3=80%", "--weaker", "3=80%"),
        ("--cut", "3", "--weaker", "3=20%"),
        ("--lost-weight", "2", "--lost-weight", "2=30%"),
    ],
)
def test_more_than_all_of_a_part_cannot_be_lost(refused: Refused, faults: tuple[str, ...]) -> None:
    assert "together more than all of it" in refused("fault", "four.toml", *faults)


@pytest.mark.release
def test_both_pistons_of_a_chamber_lose_its_combustion_once(refused: Refused, run: Run) -> None:
    line = ("fault", "jumo-205", "--set", "cylinder.reciprocating_mass=3 kg")
    line = (*line, "--set", "layout.bore_pitch=150 mm", "--speed", "2200 rpm")
    assert "together more than all of it" in refused(*line, "--cut", "1,7")
    halves = ("--weaker", "1=50%", "--weaker", "7=50%")
    own, whole = (json.loads(run(*line, *each, "--json").out) for each in (halves, ("--cut", "1")))
    rolls = [[row["now"]["roll"] for row in each["orders"]] for each in (own, whole)]
    assert rolls[0] == pytest.approx(rolls[1])


@pytest.mark.release
def test_a_reading_that_stands_twice_is_one(run: Run, refused: Refused, tmp_path: Path) -> None:
    """Two measurements differ: their mean is better known, by the root of two; a copy is none."""
    noisy(tmp_path, share=0.01)
    text = (tmp_path / "noisy.csv").read_text(encoding="utf-8")
    count = len(text.splitlines())
    (tmp_path / "twice.csv").write_text(text + text.removeprefix(HEAD), encoding="utf-8")
    told = " ".join(refused("diagnose", "four.toml", "twice.csv").split())
    assert f'line {count + 1}, column "order": this reading stands twice' in told
    assert "first in line 2; leave it out" in told
    last = text.splitlines()[-1].rpartition(",")
    again = f"{text}{last[0]},{float(last[2]) + 0.5}\n"
    (tmp_path / "again.csv").write_text(again, encoding="utf-8")
    assert run("diagnose", "four.toml", "again.csv").code == 0


@pytest.mark.release
def test_python_takes_a_frame_and_rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The weight that is missing in the engine that was measured is found, whatever holds it."""
    import pandas

    monkeypatch.chdir(tmp_path)
    frame = pandas.read_csv("lost.csv", skipinitialspace=True)
    lists: list[Any] = ["lost.csv", Path("lost.csv"), frame, frame.to_dict("records")]
    found = [crankstar.diagnose("four.toml", each).to_dict() for each in lists]
    assert [each["suspects"][0] for each in found] == [found[0]["suspects"][0]] * len(lists)
    assert [found[0]["suspects"][0][key] for key in ("kind", "number")] == ["weight", 2]
    wrong: Any
    for wrong in (5, [1, 2], {"order": 1}):
        with pytest.raises(TypeError, match=r"measured takes the name of a CSV file or .*, not "):
            crankstar.diagnose("four.toml", wrong)


def test_values_of_python_may_be_made_one_by_one_or_by_numpy(tmp_path: Path) -> None:
    """The force of order 2 is m r w^2 sum A_2, and A_2 follows the ratio of the rods."""
    ratios = [3.0, 4.0]
    made = crankstar.sweep("single", {"cylinder.rod_ratio": (each for each in ratios)})
    found = crankstar.watched(made, "force", order=2).values
    theta = np.arange(720) * np.pi / 360

    def second(ratio: float) -> float:
        lift = np.cos(theta) + np.sqrt(ratio**2 - np.sin(theta) ** 2)
        return 4 * abs(2 * np.fft.rfft(lift)[2] / theta.size)

    assert found == pytest.approx([second(each) for each in ratios], rel=1e-9)
    changes = {"firing_order": np.array([1, 2, 4, 3]), "speed": np.array("100 rad/s")}
    engine = crankstar.load(str(tmp_path / "four.toml"), changes=changes)
    assert engine.firing_order == (1, 2, 4, 3)
    assert engine.speed == 100
