"""A trace file that is not there, or holds no numbers, is told with where it was sought."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Callable
from math import cos, pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import crankstar
from crankstar.files import engine_of

Run = Callable[..., Any]
ENGINE = """name = "four"
firing_order = [1, 3, 4, 2]
speed = "5500 rpm"
[cylinder]
bore = "82 mm"
stroke = "90 mm"
rod_length = "145 mm"
reciprocating_mass = "480 g"
[gas]
compression_ratio = 10.8
TRACE
[layout]
type = "inline"
bore_pitch = "91 mm"
"""
ROWS = [(angle, 1 + 59 * ((1 + cos(angle * pi / 360)) / 2) ** 8) for angle in range(-360, 360, 5)]
CSV = "theta,p [bar]\n" + "".join(f"{angle},{bar:.6f}\n" for angle, bar in ROWS)


@pytest.fixture
def files(tmp_path: Path) -> Path:
    """A folder beside the one where commands run, with the engine in it."""
    folder = tmp_path / "engines"
    folder.mkdir()
    (folder / "plain.toml").write_text(ENGINE.replace("TRACE", ""), encoding="utf-8")
    traced = ENGINE.replace("TRACE", 'trace = "t.csv"')
    (folder / "traced.toml").write_text(traced, encoding="utf-8")
    return folder


def test_a_missing_trace_is_told_with_the_place_where_it_was_sought(
    run: Run, files: Path, tmp_path: Path
) -> None:
    of_file = run("torque", str(files / "traced.toml"))
    assert f"gas.trace names t.csv, but there is no file {files / 't.csv'}" in of_file.err
    (files / "t.csv").write_text(CSV, encoding="utf-8")
    plain = str(files / "plain.toml")
    set_here = run("torque", plain, "--set", "gas.trace=t.csv")
    assert f"gas.trace names t.csv, but there is no file {tmp_path / 't.csv'}" in set_here.err
    typed = (files / "traced.toml").read_bytes()
    from_input = run("torque", "-", stdin=typed)
    assert f"gas.trace names t.csv, but there is no file {tmp_path / 't.csv'}" in from_input.err
    (tmp_path / "t.csv").write_text(CSV, encoding="utf-8")
    answers = [
        run("torque", str(files / "traced.toml"), "--json").out,
        run("torque", plain, "--set", "gas.trace=t.csv", "--json").out,
        run("torque", "-", "--json", stdin=typed).out,
    ]
    assert answers[0] == answers[1] == answers[2]


def test_what_is_no_file_is_told_as_what_it_is(run: Run, files: Path, tmp_path: Path) -> None:
    (tmp_path / "folder.csv").mkdir()
    os.mkfifo(tmp_path / "pipe.csv")
    said = {
        "folder.csv": "names folder.csv, which is a folder",
        "pipe.csv": "names pipe.csv, which is no regular file",
        "": "is an empty name; give that of a CSV file",
    }
    for name, sentence in said.items():
        refused = run("torque", str(files / "plain.toml"), "--set", f"gas.trace={name}")
        assert (refused.code, f"gas.trace {sentence}" in refused.err) == (2, True), refused.err


@pytest.mark.parametrize("cell", ["1e999", "nan", "inf", "-1e999"])
def test_a_pressure_that_is_no_number_is_told_with_file_and_line(
    cell: str, run: Run, files: Path
) -> None:
    lines = CSV.splitlines()
    lines[4] = f"-345,{cell}"
    (files / "t.csv").write_text("\n".join(lines), encoding="utf-8")
    refused = run("torque", str(files / "traced.toml"))
    assert f"gas.trace names t.csv, whose line 5 is -345, {cell}; give numbers" in refused.err
    lines[2:2] = ["# measured at full load", ""]  # lines are counted as an editor counts them
    (files / "t.csv").write_text("\n".join(lines), encoding="utf-8")
    refused = run("torque", str(files / "traced.toml"))
    assert f"gas.trace names t.csv, whose line 7 is -345, {cell}; give numbers" in refused.err


@pytest.mark.release
def test_a_key_that_nothing_comes_of_beside_a_trace_is_refused(run: Run, files: Path) -> None:
    """The ratio counts where a cylinder only compresses, the temperature where heat is lost."""
    (files / "t.csv").write_text(CSV, encoding="utf-8")
    traced = str(files / "traced.toml")

    def torque(*words: str) -> str:
        return run("torque", traced, *words, "--json").out

    ratio = ("--set", "gas.compression_ratio=9")
    assert json.loads(torque())["mean_torque"] == json.loads(torque(*ratio))["mean_torque"]
    assert (
        json.loads(torque("--off", "2"))["mean_torque"]
        != json.loads(torque("--off", "2", *ratio))["mean_torque"]
    )
    warm = ("--set", "gas.intake_temperature=400 K")
    refused = run("torque", traced, *warm)
    assert "gas.intake_temperature has no effect beside gas.trace" in refused.err
    walls = ("--set", "gas.wall_temperature=450 K", "--off", "2")
    assert (
        json.loads(torque(*walls))["mean_torque"]
        != json.loads(torque(*walls, *warm))["mean_torque"]
    )


def test_a_load_that_is_set_and_does_not_count_is_told(run: Run) -> None:
    words = ["torque", "audi-25-tfsi", "--json", "--point", "idle"]
    plain, changed = run(*words), run(*words, "--set", "gas.bmep=5 bar")
    assert json.loads(plain.out)["mean_torque"] == json.loads(changed.out)["mean_torque"]
    assert "--set gas.bmep changes nothing here" in changed.err
    assert "operating point idle" in changed.err
    assert "changes nothing" not in run(*words[:3], "--set", "gas.bmep=5 bar").err


def work_of_the_formula() -> float:
    """The mean torque of four cylinders, their work p dV over 4 pi, N m: by their own geometry."""
    theta = np.linspace(-2 * np.pi, 2 * np.pi, 28801)
    bar = 1 + 59 * ((1 + np.cos(theta / 2)) / 2) ** 8
    radius, rod = 0.045, 0.145
    lift = radius * np.cos(theta) + np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    return float(np.trapezoid(bar * 1e5, -np.pi / 4 * 0.082**2 * lift)) * 4 / (4 * np.pi)


FOUR = tomllib.loads(ENGINE.replace("TRACE", "").replace("compression_ratio = 10.8", ""))
GAS = {"trace": "t.csv"}
CHANGES: list[Any] = [
    {"gas.trace": "t.csv"},
    {"gas": {"trace": "t.csv"}},
    {"gas.trace": Path("t.csv")},
]


@pytest.mark.parametrize("changes", CHANGES)
def test_python_reads_a_trace_where_it_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changes: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "t.csv").write_text(CSV, encoding="utf-8")
    expected = pytest.approx(work_of_the_formula(), rel=1e-3)
    asked = [crankstar.torque(FOUR, changes=changes), crankstar.torque(FOUR | {"gas": GAS})]
    assert [each.to_dict()["mean_torque"] for each in asked] == [expected, expected]
    swept = crankstar.sweep(FOUR, "speed=1000..2000 rpm/2", watch="mean_torque", changes=changes)
    assert swept.curves[0].values.tolist() == [expected, expected]


def test_a_trace_within_a_table_is_read_on_the_command_line(run: Run, files: Path) -> None:
    plain = str(files / "plain.toml")
    Path("t.csv").write_text(CSV, encoding="utf-8")
    out = json.loads(run("torque", plain, "--set", 'gas={trace="t.csv"}', "--json").out)
    assert out["mean_torque"] == pytest.approx(work_of_the_formula(), rel=1e-3)


def test_where_no_file_may_be_read_the_table_is_asked_for() -> None:
    """As the server has it: an engine whose text comes from elsewhere."""
    with pytest.raises(crankstar.EngineFileError) as caught:
        engine_of(FOUR | {"gas": GAS})
    [fault] = caught.value.faults
    assert fault.code == "trace.not-read"
    assert "give what it holds as a table, such as { angle = " in fault.sentence
