"""Lists and changes as Python gives them, and lists that are none: told, never a traceback."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from tests.commands import Run

import crankstar
from crankstar.files.lists import ListError

pytestmark = pytest.mark.quick

CASES = Path(__file__).parents[1] / "cases"
ENGINE, GENSET = str(CASES / "match-engine.toml"), CASES / "genset-four.toml"
ODD: Any = {1: 2}


def weights(first: Any) -> list[dict[str, Any]]:
    return [
        {"no.": name, "piston [g]": first if name == "A" else 410.0, "pin [g]": 99,
         "small end [g]": 150, "big end [g]": 400}
        for name in "ABCD"
    ]  # fmt: skip


@pytest.mark.parametrize("missing", [None, float("nan"), pd.NA, pd.NaT])
def test_a_cell_that_is_missing_is_told_with_its_line(missing: Any) -> None:
    with pytest.raises(ListError, match=r'line 2, column "piston \[g\]": the cell is empty'):
        crankstar.match(ENGINE, weights(missing))


def test_a_cell_that_is_an_array_is_told_with_its_line() -> None:
    with pytest.raises(ListError, match=r'line 2, column "piston \[g\]"'):
        crankstar.match(ENGINE, weights(np.array([1, 2])))


def test_a_series_is_no_list() -> None:
    with pytest.raises(TypeError, match="a data frame, or a list of dicts"):
        crankstar.match(ENGINE, pd.Series([1, 2]))


@pytest.mark.parametrize(
    ("function", "arguments"),
    [("torque", {"off": ODD}), ("torque", {"tangential": ODD}), ("mounts", {"orders": ODD})],
)
def test_a_dict_is_no_list(function: str, arguments: dict[str, Any]) -> None:
    with pytest.raises(TypeError, match=f"{next(iter(arguments))} takes no dict"):
        getattr(crankstar, function)(str(GENSET), **arguments)


def test_changes_have_key_paths() -> None:
    with pytest.raises(TypeError, match="changes takes a dict of values by key path"):
        crankstar.torque(str(GENSET), changes=ODD)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with a name")
def test_a_pipe_is_no_list(run: Run, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "f.csv")
    told = run("match", ENGINE, str(tmp_path / "f.csv"))
    assert told.code == 2
    assert "is no regular file" in told.err


def test_a_decimal_comma_spoils_its_line_alone(run: Run, tmp_path: Path) -> None:
    text = (CASES / "match-weights.csv").read_text(encoding="utf-8")
    (tmp_path / "w.csv").write_text(text.replace("433.0", "433,0"), encoding="utf-8")
    told = " ".join(run("match", ENGINE, str(tmp_path / "w.csv")).err.split())
    assert "1 mistake" in told
    assert "it has 6 cells under 5 headings; if a comma is a decimal sign there" in told


@pytest.mark.parametrize(
    ("trace", "count"), [(None, 3), ("a,p\n0,1\nx,2\n10,y\n", 4), ("a,p [kg]\n0,1\n20,2,3\n", 4)]
)
def test_a_bad_trace_hides_no_other_mistake(
    run: Run, tmp_path: Path, trace: str | None, count: int
) -> None:
    text = GENSET.read_text(encoding="utf-8")
    text = text.replace('imep = "9 bar"', 'trace = "t.csv"').replace("stroke =", "stroek =")
    lines = ['bore = "105 kg"' if line.startswith("bore =") else line for line in text.splitlines()]
    (tmp_path / "e.toml").write_text("\n".join(lines), encoding="utf-8")
    if trace is not None:
        (tmp_path / "t.csv").write_text(trace, encoding="utf-8")
    told = run("check", str(tmp_path / "e.toml")).err
    assert f"{count} mistakes" in told
    for part in ("gas.trace", "cylinder.bore", "cylinder.stroek"):
        assert part in told


@pytest.mark.parametrize(("letter", "code"), [("-", 0), ("\ue000", 2), ("\U000f0000", 2)])
def test_a_name_has_no_private_letters(run: Run, tmp_path: Path, letter: str, code: int) -> None:
    lines = GENSET.read_text(encoding="utf-8").splitlines()
    at = next(place for place, line in enumerate(lines) if line.startswith("name ="))
    lines[at] = f'name = "a{letter}b"'
    (tmp_path / "e.toml").write_text("\n".join(lines), encoding="utf-8")
    told = run("check", str(tmp_path / "e.toml"))
    assert (told.code, "name" in told.err) == (code, code == 2)


def test_an_engine_that_burns_nothing_has_no_air_fuel_ratio(run: Run) -> None:
    assert "air-fuel" in run("torque", str(GENSET)).out
    assert "air-fuel" not in run("torque", str(GENSET), "--off", "1,2,3,4").out
