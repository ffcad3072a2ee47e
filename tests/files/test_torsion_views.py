"""Torsion in every verb that has it: what they print, draw and write is what `torsion` says."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.commands import Run


@pytest.mark.parametrize("kind", ["torsion-modes", "campbell"])
def test_plot_draws_drive_lines(run: Run, tmp_path: Path, kind: str) -> None:
    place = tmp_path / "fan.toml"
    place.write_text(
        'name = "fan drive"\nspeed = "3000 rpm"\n[[disc]]\nname = "motor"\n'
        'inertia = "2 kg*m^2"\n[[disc]]\nname = "fan"\ninertia = "3 kg*m^2"\n'
        'to = "motor"\nstiffness = "6 kN*m/rad"\n',
        encoding="utf-8",
    )
    ran = run("plot", str(place), kind, "-o", str(tmp_path / "x.svg"))
    assert ran.code == 0, ran.err
    assert "fan drive" in (tmp_path / "x.svg").read_text(encoding="utf-8")
