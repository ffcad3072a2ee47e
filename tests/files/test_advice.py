"""The advice of a refusal is right for what was asked, and its sentences end once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from crankstar.charts.registry import CHARTS

Run = Callable[..., Any]
LINE = """name = "line"
speed = "1500 rpm"
[[disc]]
name = "motor"
inertia = "1 kg*m^2"
[[disc]]
name = "fan"
inertia = "2 kg*m^2"
stiffness = "1 kN*m/rad"
to = "motor"
"""


@pytest.mark.parametrize(
    "words",
    [
        ["export", "line.toml", "-o", "x.py"],
        ["plot", "line.toml", "torsion-response"],
        ["sweep", "line.toml", "--over", "disc[1].inertia=1..3 kg*m^2/3", "--quantity", "force"],
    ],
)
def test_a_drive_line_is_told_what_takes_it(words: list[str], run: Run, tmp_path: Path) -> None:
    (tmp_path / "line.toml").write_text(LINE, encoding="utf-8")
    refused = run(*words)
    assert refused.code == 2
    assert "`export --to opentorsion` or `ross`" in refused.err
    charts = [name for name, chart in CHARTS.items() if chart.of_chains]
    assert f"`plot` with {' or '.join(charts)} take it" in refused.err
    assert "is not a field" not in refused.err


def test_a_drive_line_goes_where_the_advice_sends_it(run: Run, tmp_path: Path) -> None:
    (tmp_path / "line.toml").write_text(LINE, encoding="utf-8")
    for program in ("opentorsion", "ross"):
        assert run("export", "line.toml", "--to", program, "-o", f"{program}.py").code == 0


@pytest.mark.release
def test_a_doubt_that_ends_with_a_question_has_no_full_stop_behind_it(run: Run) -> None:
    over = "gas.compression_ratio=8..60/4"
    done = run("sweep", "audi-25-tfsi", "--over", over, "--quantity", "mean_torque")
    text = " ".join((done.out + done.err).split())
    assert "? So it is from" in text
    assert "?." not in text
