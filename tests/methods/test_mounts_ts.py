"""The block on its mounts at any speed, in TypeScript against Python: to 1e-9 of the greatest."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.front_end import node
from tests.mounted_engines import FOUNDATION, HEAVY, MOUNTS, standing

from crankstar.dynamics.mount_analysis import mounts
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import mount_axes
from crankstar.page.mounts import mounts_shown
from crankstar.spectra import Complex

RPM = 30 / pi
FEET = [
    {
        **each,
        "foot": [
            {"frequency": "10 Hz", "amplitude": ["2 um/N", "1 um/N", "3 um/N"], "lag": "40 deg"},
            {"frequency": "90 Hz", "amplitude": "4 um/N"},
        ],
    }
    for each in MOUNTS
]
ENGINES = {
    "three mounts": standing(),
    "on a foundation": standing(foundation=FOUNDATION, rotation="counter-clockwise"),
    "on feet that give way": standing(mounts=FEET),
    "without gas": standing(gas=None, **HEAVY),
    "a grip": standing(
        block={
            "mass": "165 kg",
            "inertia_up": "9.5 kg*m^2",
            "inertia_right": "10.5 kg*m^2",
            "inertia_z": "4.2 kg*m^2",
            "product_up_z": "0.8 kg*m^2",
            "points": [{"name": "grip", "up": "1 m", "right": "0.3 m", "z": "-0.4 m"}],
        }
    ),
}
SHARES = (0.0, 0.013, 0.377, 0.82, 1.0)
"""Of the way from the slowest speed to the fastest."""


@pytest.mark.release
def test_typescript_shakes_the_block_as_python_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    roads, report = tmp_path / "roads.json", tmp_path / "report.json"
    roads.write_text(json.dumps([road(*each) for each in ENGINES.items()]))
    monkeypatch.setenv("CRANKSTAR_MOUNT_ROADS", str(roads))
    node(
        "node_modules/vitest/vitest.mjs",
        "run",
        "test/mountRoads.test.ts",
        "--reporter=default",
        "--reporter=json",
        f"--outputFile={report}",
    )
    told = json.loads(report.read_text())
    assert told["numPassedTests"] == len(ENGINES) * len(SHARES)


def road(name: str, engine: Engine) -> dict[str, Any]:
    """What the page is sent, and what Python says of speeds between those that it has curves of."""
    shown, over = mounts_shown(engine), mounts(engine).over
    assert shown is not None
    assert over is not None
    low, high = over.speeds[[0, -1]]
    # the fastest last: gas of a single load is that of it
    speeds = low + (high - low) * np.array(SHARES)
    found = mounts(engine, speeds=speeds, orders=shown.orders)
    response = found.over
    assert response is not None
    rows = np.searchsorted(response.speeds, found.asked)  # peaks lie between those asked for
    axes = np.array([mount_axes(each) for each in found.block.mounts])
    forces = np.einsum("skma,mai->smik", response.mount_force, axes)
    points = [response.displacement(each.place, of=int(each.below)) for each in shown.points]
    said = [
        {
            "rpm": float(speed * RPM),
            "motion": pairs(response.motion[at].T),
            "forces": pairs(forces[at]),
            "points": pairs(np.array([each[at].T for each in points])),
            "through": [None if np.isnan(x) else float(x) for x in response.transmissibility[at]],
            "heat": response.heat[at].tolist(),
        }
        for at, speed in zip(rows.tolist(), speeds, strict=True)
    ]
    return {"name": name, "mounts": json.loads(shown.model_dump_json()), "said": said}


def pairs(values: Complex) -> Any:
    return np.stack([np.real(values), np.imag(values)], axis=-1).tolist()
