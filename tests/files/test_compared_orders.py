"""Orders that are asked for are those that a comparison shows, of the torque with gas too."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.lacking import GENSET

from crankstar.files import engine_of, toml
from crankstar.mechanics.gas import cycle


@pytest.mark.release
def test_the_torque_is_listed_in_the_orders_asked_for(run: Run, tmp_path: Path) -> None:
    paths: list[str] = []
    for name, load in (("one", "18 bar"), ("other", "12 bar")):
        tree: dict[str, Any] = {**GENSET, "name": name}
        tree["gas"] = {**GENSET["gas"], "bmep": load}
        paths.append(str(tmp_path / f"{name}.toml"))
        Path(paths[-1]).write_text(toml(engine_of(tree)))
    out = run("compare", *paths, "--orders", "1,3,4", "--json").out
    told = [row for row in json.loads(out)["amplitudes"] if row["quantity"] == "torque_with_gas"]
    assert [(row["order"], row["engine"]) for row in told] == [
        (order, name) for order in (1, 3, 4) for name in ("one", "other")
    ]
    table = run("compare", *paths, "--orders", "1,3,4").out.partition("Torque of gas")[2]
    rows = [line.split()[0] for line in table.partition("─\n")[2].splitlines()[:4] if line]
    assert rows[:3] == ["1", "3", "4"]
    third = [row["greatest"] for row in told if row["order"] == 3]
    assert third == pytest.approx([_third(load) for load in (18e5, 12e5)], rel=2e-3)
    assert [row["greatest"] for row in told if row["order"] != 3] == [0.0] * 4


def _third(load: float) -> float:
    """The third order of the torque of six cylinders by the work of gas and pistons, N m."""
    own = cycle(engine_of({**GENSET, "gas": {**GENSET["gas"], "bmep": f"{load} Pa"}}))
    theta = np.linspace(0, 4 * np.pi, own.pressure.shape[1], endpoint=False)
    radius, rod = 0.075, 0.25
    side = np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    travel = radius * np.sin(theta) * (1 + radius * np.cos(theta) / side)
    wave = np.fft.fft(np.pi / 4 * 0.13**2 * (own.pressure[0] - own.crankcase) * travel)
    energy = np.fft.fft(4.0 * travel**2 / 2 * (50 * np.pi) ** 2)
    order = 6  # of the cycle of two turns
    torque = wave[order] - 1j * 3 * energy[order]
    return float(6 * 2 * abs(torque) / theta.size)
