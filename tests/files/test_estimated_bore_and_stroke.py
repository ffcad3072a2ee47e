"""An estimated stroke or bore has a size of effect, and what was estimated by it goes along."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

SINGLE = """name = "single"
firing_order = [1]
speed = "5000 rpm"
[cylinder]
{size} = "86 mm"
[layout]
type = "inline"
throws = ["0 deg"]
"""


@pytest.mark.release
@pytest.mark.parametrize(("size", "path", "power"), [("bore", "stroke", 1), ("stroke", "bore", 3)])
def test_the_force_goes_with_the_size_as_it_must(
    size: str, path: str, power: int, run: Run, tmp_path: Path
) -> None:
    """Without weights F_1 = (m_rec + m_rot) r w^2, with m = c D^3 and l/r kept."""
    place = tmp_path / "own.toml"
    place.write_text(SINGLE.format(size=size))
    told: dict[str, Any] = json.loads(run("analyze", str(place), "--estimate", "--json").out)
    row = next(row for row in told["rests_on"] if row["path"] == f"cylinder.{path}")
    moves = row["moves"]
    assert (row["status"], moves["quantity"], moves["order"]) == ("estimated", "force", 1.0)
    for end in ("low", "high"):
        assert moves[end] == pytest.approx(moves["now"] * row[end] ** power, rel=1e-6)
