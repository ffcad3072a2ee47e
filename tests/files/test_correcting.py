"""`crankstar correct`: two planes from a balancing machine or from trial runs."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run, csv_rows

RUNS = """run, trial [g*mm], at [deg], bearing 1 [mm/s], phase 1, bearing 2 [mm/s], phase 2 [deg]
initial, , , 5.2, 40, 3.1, 210
plane 1, 400, 0, 4.1, 75, 3.6, 205
plane 2, 400, 90, 5.5, 52, 1.9, 240
check, , , 0.4, 100, 0.3, 20
"""
SHOWN = ("--unbalance", "850 g*mm at 20 deg, 400 g*mm at 110 deg")
PLANES = ("--measuring-planes", "0 mm, 400 mm", "--correction-planes", "60 mm, 340 mm")
Refused = Callable[..., str]


def polar(size: float, degrees: float) -> complex:
    """A vector."""
    return complex(size * np.exp(1j * np.radians(degrees)))


def test_the_corrections_of_trial_runs_bring_the_vibration_to_nought(
    run: Run, tmp_path: Path
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    said = json.loads(run("correct", "runs.csv", "--positions", "12", "--json").out)
    matrix = np.array([[complex(*each) for each in row] for row in said["influence"]])
    added = np.zeros(2, complex)
    for row in said["added"]:
        assert row["at_deg"] % 30 == 0
        added[row["plane"] - 1] += polar(row["unbalance"], row["at_deg"])
    initial = np.array([polar(5.2, 40), polar(3.1, 210)])
    assert initial + matrix @ added == pytest.approx(0, abs=1e-9)
    first = initial + matrix @ np.array([400e-6, 0])
    assert first == pytest.approx([polar(4.1, 75), polar(3.6, 205)])
    assert [round(row["share_percent"], 1) for row in said["left"]] == [6.2, 7.6]
    assert said["left_share"] < 0.1


def test_unbalance_of_a_machine_is_drilled_in_the_correction_planes(run: Run) -> None:
    hole = ("--diameter", "12.7 mm", "--at-radius", "80 mm")
    said = json.loads(run("correct", *SHOWN, *PLANES, *hole, "--json").out)
    first, second = polar(850, 20), polar(400, 110)
    planes = [polar(1e6 * row["unbalance"], row["heavy_spot_deg"]) for row in said["planes"]]
    assert sum(planes) == pytest.approx(first + second, abs=2)
    assert 60 * planes[0] + 340 * planes[1] == pytest.approx(400 * second, abs=600)
    assert [row["unbalance"] for row in said["holes"]] == [
        row["unbalance"] for row in said["planes"]
    ]
    alone = json.loads(
        run("drill", "--unbalance", f"{said['planes'][0]['unbalance']} kg*m", *hole, "--json").out
    )
    assert said["holes"][0]["depth_mm"] == pytest.approx(alone["holes"][0]["depth_mm"])


def test_weights_have_masses_where_a_radius_is_given(run: Run) -> None:
    said = json.loads(run("correct", *SHOWN, *PLANES, "--at-radius", "50 mm", "--json").out)
    for row in said["added"]:
        assert row["mass_g"] * 1e-3 * 0.05 == pytest.approx(row["unbalance"])


def test_a_picture_has_the_heavy_spots_and_what_is_added(run: Run, tmp_path: Path) -> None:
    run("correct", *SHOWN, *PLANES, "-o", "planes.svg")
    drawn = (tmp_path / "planes.svg").read_text(encoding="utf-8")
    assert drawn.count("heavy spot") == drawn.count("add<") == 2
    assert "plane 2" in drawn


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ((), "give either a list of runs"),
        (("runs.csv", *SHOWN), "give either a list of runs"),
        ((*SHOWN, "--measuring-planes", "0 mm, 1 mm"), "--correction-planes"),
        ((*SHOWN, *PLANES[:2], "--correction-planes", "1 mm, 1 mm"), "at one place"),
        ((*SHOWN, *PLANES[:2], "--correction-planes", "1, 2"), "with a unit"),
        (("--unbalance", "850 g*mm, 3 g*mm", *PLANES), "each with its direction"),
        ((*SHOWN, *PLANES, "--positions", "2"), "from 3 to 360"),
        ((*SHOWN, *PLANES, "--positions", "0, 10, 20 deg"), "half a turn apart"),
        ((*SHOWN, *PLANES, "--positions=-12"), "how many there are at equal steps"),
        (
            (*SHOWN, "--measuring-planes", "0 mm, 1e-300 mm", *PLANES[2:]),
            "--measuring-planes 0 mm, 1e-300 mm: the two are at one place",
        ),
        (("none.csv",), "no such file"),
    ],
)
def test_a_request_that_cannot_be_met_is_one_sentence(
    refused: Refused, tmp_path: Path, line: tuple[str, ...], told: str
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    assert told in " ".join(refused("correct", *line).split())


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("plane 2, 400, 90", "plane 1, 400, 90", 'line 4, column "run": this run stands twice'),
        ("plane 2, 400, 90", "third, 400, 90", "name the runs initial, plane 1"),
        ("plane 2, 400, 90, 5.5, 52, 1.9, 240\n", "", 'there is no run "plane 2"'),
        ("plane 1, 400", "plane 1, 0", "must be greater than 0"),
        (
            "plane 1, 400",
            "plane 1, 1e-300",
            'line 3, column "trial [g*mm]" is "1e-300 g*mm", too small',
        ),
        ("5.2, 40", "1e-300, 40", 'column "bearing 1 [mm/s]" is "1e-300 mm/s", too small'),
        ("5.2, 40", "fast, 40", '"fast", not a number'),
        ("[g*mm]", "[g]", 'line 1, column 2 is "trial [g]", a mass; add the radius'),
        ("bearing 1 [mm/s]", "bearing 1 [kg]", "none of a displacement, a velocity or an acc"),
        ("initial, , ,", "initial, 400, ,", "this run is without a trial weight"),
        ("check, , ,", "check, , 90,", 'line 5, column "at [deg]": this run is without'),
        ("4.1, 75", "-4.1, 75", "an amplitude is not negative"),
        ("phase 2 [deg]", "angle 2 [deg]", "is not known"),
        ("phase 2 [deg]", "colour", "name columns run, trial, at, bearing 1, phase 1, bearing 2"),
    ],
)
def test_a_mistake_in_the_runs_is_told_with_its_place(
    refused: Refused, tmp_path: Path, old: str, new: str, told: str
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS.replace(old, new), encoding="utf-8")
    said = " ".join(refused("correct", "runs.csv").split())
    assert told in said


def test_every_mistake_in_the_runs_is_told_at_once(refused: Refused, tmp_path: Path) -> None:
    wrong = RUNS.replace("initial, , ", "initial, 300, ").replace("4.1, 75", "fast, x")
    (tmp_path / "runs.csv").write_text(wrong.replace("0.3, 20", "-0.3, 20, 8"), encoding="utf-8")
    head, *told = refused("correct", "runs.csv").splitlines()
    assert head == "crankstar: runs.csv: 4 mistakes"
    assert [line.split(",")[0].split(":")[0].strip() for line in told] == [
        "line 2",
        "line 3",
        "line 3",
        "line 5",  # whose cells may stand under other headings
    ]


def test_vibration_without_a_unit_is_in_divisions_of_the_instrument(
    run: Run, tmp_path: Path
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    (tmp_path / "bare.csv").write_text(RUNS.replace(" [mm/s]", ""), encoding="utf-8")
    own, bare = (run("correct", name, "--csv").out for name in ("runs.csv", "bare.csv"))
    assert own == bare


def test_runs_may_have_the_line_ends_of_any_system(run: Run, tmp_path: Path) -> None:
    said = set()
    for end in ("\n", "\r\n", "\r"):
        (tmp_path / "runs.csv").write_bytes(RUNS.replace("\n", end).encode())
        said.add(run("correct", "runs.csv", "--csv").out)
    assert len(said) == 1


OPPOSITE = ("--unbalance", "100 g*mm at 0 deg, 100 g*mm at 180 deg")


def test_two_unbalances_that_cancel_leave_nothing_without_a_direction(run: Run) -> None:
    said = json.loads(run("correct", *OPPOSITE, *PLANES, "--json").out)
    still, twist = said["unbalance"]
    assert (still["size"], still["direction_deg"]) == (0.0, None)
    assert twist["couple"] == pytest.approx(100e-6 * 400e-3)
    assert "e-1" not in run("correct", *OPPOSITE, *PLANES).out


def test_one_unbalance_in_a_correction_plane_leaves_nothing_to_do_in_the_other(run: Run) -> None:
    line = ("--unbalance", "100 g*mm at 30 deg, 100 g*mm at 30 deg")
    planes = ("--measuring-planes", "0 mm, 400 mm", "--correction-planes", "200 mm, 340 mm")
    said = json.loads(run("correct", *line, *planes, "--json").out)
    assert [row["heavy_spot_deg"] for row in said["planes"]] == [30.0, None]
    assert [row["plane"] for row in said["added"]] == [1]
    hole = ("--diameter", "12.7 mm", "--at-radius", "80 mm")
    drilled = json.loads(run("correct", *line, *planes, *hole, "--json").out)["holes"]
    assert [row["count"] for row in drilled] == [1, 0]


@pytest.mark.parametrize("places", ["0 mm, 400 mm", "400 mm, 0 mm"])
def test_the_couple_is_said_to_point_where_the_farther_plane_is_heavy(
    run: Run, places: str
) -> None:
    """A pair alone: its heavy spot in the plane at 400 mm is known."""
    line = (*OPPOSITE, "--measuring-planes", places, *PLANES[2:])
    farther = 180.0 if places.endswith("400 mm") else 0.0
    couple = json.loads(run("correct", *line, "--json").out)["unbalance"][1]
    assert couple["direction_deg"] == farther
    said = " ".join(run("correct", *line).out.split())
    assert "Its heavy spot is in this direction in the plane at 400 mm" in said


def test_csv_says_what_to_add(run: Run, tmp_path: Path) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    weights = ("--positions", "12", "--at-radius", "80 mm")
    for line in (("runs.csv", *weights), (*SHOWN, *PLANES, *weights)):
        rows = csv_rows(run("correct", *line, "--csv").out, "added")
        columns = ("plane", "at_deg [deg]", "unbalance [kg*m]", "mass_g [g]")
        added = json.loads(run("correct", *line, "--json").out)["added"]
        told = [[float(row[name]) for name in columns] for row in rows]
        assert told == [
            [each[k] for k in ("plane", "at_deg", "unbalance", "mass_g")] for each in added
        ]


def test_csv_has_the_influence_coefficients(run: Run, tmp_path: Path) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    rows = csv_rows(run("correct", "runs.csv", "--csv").out, "influence_coefficients")
    first = (polar(4.1, 75) - polar(5.2, 40)) / 400e-6
    assert [(row["bearing"], row["plane"]) for row in rows] == [
        ("1", "1"), ("1", "2"), ("2", "1"), ("2", "2"),
    ]  # fmt: skip
    size, phase = (float(rows[0][name]) for name in ("vibration_per_kg_m", "phase_deg [deg]"))
    assert polar(size, phase) == pytest.approx(first)


def test_influence_coefficients_are_told_as_vectors(run: Run, tmp_path: Path) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    said = run("correct", "runs.csv").out
    first = (polar(4.1, 75) - polar(5.2, 40)) / 400e-6
    assert "Influence coefficients" in said
    (line,) = [each for each in said.splitlines() if each.split()[:2] == ["1", "1"]]
    size, phase = map(float, line.split()[2:4])
    assert size == pytest.approx(abs(first), rel=1e-3)
    assert phase == pytest.approx(np.degrees(np.angle(first)) % 360, abs=0.1)


NEXT = """run, bearing 1 [mm/s], phase 1, bearing 2 [mm/s], phase 2 [deg]
initial, 3.3, 80, 4.4, 300
"""


def saved(run: Run, tmp_path: Path) -> None:
    """The runs, the coefficients that they show, the initial run of the next rotor."""
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    (tmp_path / "next.csv").write_text(NEXT, encoding="utf-8")
    run("correct", "runs.csv", "--save-coefficients", "known.csv")


def test_saved_coefficients_are_read_as_they_were(run: Run, tmp_path: Path) -> None:
    saved(run, tmp_path)
    first = json.loads(run("correct", "runs.csv", "--json").out)["influence"]
    known = ("--coefficients", "known.csv", "--json")
    again = json.loads(run("correct", "next.csv", *known).out)
    assert again["influence"] == [[pytest.approx(each, rel=1e-9) for each in row] for row in first]
    matrix = np.array([[complex(*each) for each in row] for row in again["influence"]])
    added = np.array([polar(row["unbalance"], row["at_deg"]) for row in again["added"]])
    initial = np.array([polar(3.3, 80), polar(4.4, 300)])
    assert initial + matrix @ added == pytest.approx(0, abs=0.01)  # at_deg has one decimal
    planes = np.array([polar(row["unbalance"], row["heavy_spot_deg"]) for row in again["planes"]])
    assert matrix @ planes == pytest.approx(initial, abs=0.01)


def test_the_next_rotor_may_be_measured_in_another_unit_of_the_same_kind(
    run: Run, tmp_path: Path
) -> None:
    saved(run, tmp_path)
    inches = NEXT.replace("bearing 1 [mm/s]", "bearing 1 [in/s]").replace(
        " 3.3,", f" {3.3 / 25.4},"
    )
    (tmp_path / "inches.csv").write_text(inches, encoding="utf-8")
    own, other = (
        json.loads(run("correct", name, "--coefficients", "known.csv", "--json").out)["planes"]
        for name in ("next.csv", "inches.csv")
    )
    assert [row["unbalance"] for row in other] == [
        pytest.approx(row["unbalance"], rel=1e-9) for row in own
    ]


@pytest.mark.parametrize(("left", "told"), [(0.1, "hold as nearly as that"), (0.6, "do not hold")])
def test_a_check_run_says_whether_the_coefficients_hold(
    run: Run, tmp_path: Path, left: float, told: str
) -> None:
    saved(run, tmp_path)
    check = f"check, {3.3 * left}, 80, {4.4 * left}, 300\n"
    (tmp_path / "next.csv").write_text(NEXT + check, encoding="utf-8")
    line = ("correct", "next.csv", "--coefficients", "known.csv")
    said = " ".join(run(*line).out.split())
    assert f"The check run has {100 * left:g} % of the vibration before, each bearing" in said
    assert told in said
    answer = json.loads(run(*line, "--json").out)
    assert answer["left_share"] == pytest.approx(left)
    assert [row["share_percent"] for row in answer["left"]] == [pytest.approx(100 * left)] * 2


@pytest.mark.many(first=12)
@pytest.mark.parametrize(
    ("line", "told"),
    [
        (("runs.csv", "--coefficients", "known.csv"), "has no effect with coefficients"),
        (("next.csv",), "or --coefficients"),
        (("um.csv", "--coefficients", "known.csv"), 'is in "mm/s" there and in "um" in the runs'),
        (("next.csv", "--coefficients", "none.csv"), "none.csv: there is no such file"),
        (("next.csv", "--coefficients", "bad.csv"), "bad.csv: 2 mistakes"),
        (("next.csv", "--coefficients", "alike.csv"), "do not tell the two planes apart"),
        (("next.csv", "--coefficients", "half.csv"), "there is no line of plane 2"),
        (("next.csv", "--coefficients", "next.csv"), 'there are no columns "plane", "unbalance"'),
        (("known.csv", "--coefficients", "known.csv"), 'there is no column "run"'),
        (("open.csv", "--coefficients", "known.csv"), "open.csv"),
        (("still.csv", "--coefficients", "known.csv"), "there is nothing to correct"),
        (("runs.csv", "--save-coefficients", "runs.csv"), "would be lost"),
        (("runs.csv", "--save-coefficients", "x.toml"), "must end in .csv"),
        (("runs.csv", "--save-coefficients", "none/x.csv"), "file with --save-coefficients"),
        (("runs.csv", "--save-coefficients", "new.csv", "-o", "none/x.txt"), "no such directory"),
        ((*SHOWN, *PLANES, "--coefficients", "known.csv"), "no effect with --unbalance"),
        (
            ("next.csv", "--coefficients", "known.csv", "--save-coefficients", "new.csv"),
            "--save-coefficients has no effect",
        ),
    ],
)
def test_coefficients_that_cannot_be_used_are_told(
    run: Run, refused: Refused, tmp_path: Path, line: tuple[str, ...], told: str
) -> None:
    saved(run, tmp_path)
    head, one, two = (tmp_path / "known.csv").read_text(encoding="utf-8").splitlines()
    lists = {
        "um": NEXT.replace("bearing 1 [mm/s]", "bearing 1 [um]"),
        "bad": "\n".join([head, one.replace("1000", "-3"), two.replace("2,", "3,", 1)]),
        "alike": "\n".join([head, one, one.replace("1,", "2,", 1)]),
        "half": "\n".join([head, one]),
        "open": NEXT.replace("run,", 'run,"', 1),
        "still": f"{NEXT.splitlines()[0]}\ninitial, 0, 0, 0, 0\n",
    }
    for name, text in lists.items():
        (tmp_path / f"{name}.csv").write_text(text, encoding="utf-8")
    assert told in " ".join(refused("correct", *line).split())
    assert not (tmp_path / "new.csv").exists()
