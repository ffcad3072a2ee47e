"""Analyses that may be asked without an engine, on the command line and in Python."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

import crankstar

pytestmark = pytest.mark.quick

HOLE: dict[str, Any] = {"diameter": 0.0127, "at_radius": 0.08}
RUNS: list[dict[str, Any]] = [
    {"run": "initial", "bearing 1 [mm/s]": 4.0, "phase 1": 30,
     "bearing 2 [mm/s]": 3.0, "phase 2": 200},
    {"run": "1", "trial [g*mm]": 500, "at": 0, "bearing 1 [mm/s]": 6.0, "phase 1": 60,
     "bearing 2 [mm/s]": 3.5, "phase 2": 190},
    {"run": "2", "trial [g*mm]": 500, "at": 0, "bearing 1 [mm/s]": 4.4, "phase 1": 20,
     "bearing 2 [mm/s]": 5.1, "phase 2": 240},
]  # fmt: skip


def refused(run: Run, *line: str) -> str:
    """What is said of a command line that is refused, on one line."""
    told = run(*line)
    assert (told.code, told.out) == (2, "")
    return " ".join(told.err.split())


def test_a_row_of_a_list_is_an_engine() -> None:
    found = crankstar.vees(6, bank="60 deg, 90 deg")
    table = found.to_frame()
    for row in range(1, len(table) + 1):
        engine = found.to_engine(row=row)
        assert len(engine.cylinders) == 6
        angle = table["bank_angle_deg"].tolist()[row - 1]
        assert f"{angle:g} deg" in engine.name


@pytest.mark.parametrize(
    ("chosen", "error", "told"),
    [
        ({"row": 9}, ValueError, "row 9: give a number from 1 to"),
        ({"row": 1, "star": 7}, ValueError, "star 7: give 1"),
        ({"number": 1}, TypeError, "to_engine takes no argument number; it takes row, star"),
    ],
)
def test_a_row_that_there_is_not_is_refused(
    chosen: dict[str, Any], error: type[Exception], told: str
) -> None:
    with pytest.raises(error, match=told):
        crankstar.vees(6, bank="60 deg, 90 deg").to_engine(**chosen)


def test_what_is_written_is_what_the_function_gives(run: Run) -> None:
    said = run("vees", "8", "--bank", "90 deg", "--row", "2")
    assert f'name = "{crankstar.vees(8, bank="90 deg").to_engine(row=2).name}"' in said.out


def test_an_engine_without_one_to_make_says_so() -> None:
    with pytest.raises(ValueError, match="torsion makes no engine"):
        crankstar.torsion("cadillac-ld8").to_engine()


def test_holes_take_away_what_a_machine_shows() -> None:
    """U = rho A (h + c/3) R of an axial hole, its tip flat."""
    made = crankstar.drill(unbalance="850 g*mm at 20 deg", axial=True, tip="180 deg",
                           greatest_depth=0.05, **HOLE)  # fmt: skip
    (row,) = made.to_frame().to_dict("records")
    area = pi * HOLE["diameter"] ** 2 / 4
    assert 7850 * area * row["depth_mm"] / 1000 * HOLE["at_radius"] == pytest.approx(850e-6)
    assert made.source is None
    assert made.to_dict()["axial"] is True


def test_a_grade_is_that_of_the_rotor_alone() -> None:
    speed = 6000 * pi / 30
    table = crankstar.grade(mass=28, speed=speed, grade="G6.3").to_frame()
    assert table["unbalance_whole_kg_m"].tolist() == pytest.approx([6.3e-3 * 28 / speed])


def test_runs_are_rows_as_well_as_a_file(tmp_path: Path) -> None:
    heads = [
        "run",
        "trial [g*mm]",
        "at",
        "bearing 1 [mm/s]",
        "phase 1",
        "bearing 2 [mm/s]",
        "phase 2",
    ]
    lines = [",".join(str(row.get(head, "")) for head in heads) for row in RUNS]
    place = tmp_path / "runs.csv"
    place.write_text("\n".join([",".join(heads), *lines]), encoding="utf-8")
    rows, file = crankstar.correct(RUNS), crankstar.correct(place)
    assert rows.to_dict() == file.to_dict()


def test_what_is_about_a_file_has_no_effect_without_one(run: Run) -> None:
    told = refused(run, "grade", "--mass", "x", "--set", "speed=1", "--estimate")
    assert "--mass is" in told
    assert "--set, --estimate have no effect without ENGINE" in told
    assert "give the greatest service speed" in told
    with pytest.raises(ValueError, match="changes has no effect without engine"):
        crankstar.grade(mass=28, speed=600.0, changes={"speed": 1})


def test_a_command_of_no_engine_takes_none(run: Run) -> None:
    assert "--set" not in run("vees", "--help").out
    with pytest.raises(TypeError, match="takes no argument changes; it takes cylinders"):
        crankstar.vees(6, changes={"speed": 1})  # pyright: ignore[reportCallIssue]


def test_every_mistake_of_a_hole_is_told(run: Run) -> None:
    told = refused(run, "drill", "--diameter", "12.7", "--tip", "5", "--slug", "lead")
    for part in ("--diameter 12.7", "--tip 5", "--slug lead", "name an engine file"):
        assert part in told


def test_coefficients_are_saved_beside_the_answer(run: Run, tmp_path: Path) -> None:
    place, saved = tmp_path / "runs.csv", tmp_path / "saved.csv"
    heads = [*RUNS[1]]
    lines = [",".join(str(row.get(head, "")) for head in heads) for row in RUNS]
    place.write_text("\n".join([",".join(heads), *lines]), encoding="utf-8")
    assert run("correct", str(place), "--save-coefficients", str(saved)).code == 0
    again = run("correct", str(place), "--coefficients", str(saved), "--save-coefficients", "x.csv")
    assert again.code == 2
    for name, why in (("x.txt", "must end in .csv"), (str(place), "would be lost")):
        assert why in refused(run, "correct", str(place), "--save-coefficients", name)
    told = refused(run, "correct", "--unbalance", "1 g*mm at 0, 2 g*mm at 90",
                   "--save-coefficients", "y.csv")  # fmt: skip
    assert "--save-coefficients has no effect with --unbalance" in told
    assert "--measuring-planes" in told


def test_a_picture_of_weights_shows_no_hole(run: Run, tmp_path: Path) -> None:
    line = ("correct", "--unbalance", "850 g*mm at 20 deg, 400 g*mm at 200 deg",
            "--measuring-planes", "0 mm, 400 mm", "--correction-planes", "60 mm, 340 mm",
            "-o", str(tmp_path / "c.svg"), "--at-radius", "80 mm")  # fmt: skip
    assert "--diameter has no effect with a picture" in refused(run, *line, "--diameter", "12 mm")
    assert run(*line).code == 0
    assert "mass in g at a radius of 80" in (tmp_path / "c.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("verb", [("vees", "6"), ("orders", "i4")])
def test_rows_that_are_shown_have_no_effect_beside_the_one_that_is_written(
    run: Run, verb: tuple[str, str]
) -> None:
    told = refused(run, *verb, "--row", "1", "--top", "3")
    assert "--top has no effect with --row" in told
