"""What an answer rests on is told in the numbers that it prints; no column says another again."""

from __future__ import annotations

import json
from pathlib import Path

from tests.commands import Run

FLAT = """name = "V8 90 flat-plane"
firing_order = [1, 8, 3, 6, 4, 5, 2, 7]
[cylinder]
bore = "94 mm"
stroke = "81 mm"
rod_ratio = 3.4
[layout]
type = "vee"
banks = [ { bearing = "-45 deg", cylinders = [1, 2, 3, 4] },
          { bearing = "45 deg", cylinders = [5, 6, 7, 8] } ]
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
[gas]
compression_ratio = 12
imep = "13 bar"
speed = "6000 rpm"
"""


def place(tmp_path: Path) -> Path:
    path = tmp_path / "flat.toml"
    path.write_text(FLAT, encoding="utf-8")
    return path


def test_a_verdict_without_newtons_tells_none(run: Run, tmp_path: Path) -> None:
    text = run("verdict", str(place(tmp_path))).out
    head = text.split("\nlayout ")[0]
    assert "N m" not in " ".join(head.replace("\N{NO-BREAK SPACE}", " ").split())


def test_a_sum_of_one_is_no_column(run: Run, tmp_path: Path) -> None:
    """Without an inertia the sum is the gas; machines have it all the same."""
    path = str(place(tmp_path))
    assert "together" not in run("torque", path).out
    rows = json.loads(run("torque", path, "--json").out)["orders"]
    assert all(row["total"] == row["gas"] for row in rows)
