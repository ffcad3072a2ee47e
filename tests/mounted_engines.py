"""Engines on mounts, for tests of what the page shows of them."""

from __future__ import annotations

from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files.catalog import load

FIVE = "audi-25-tfsi"
BLOCK: dict[str, Any] = {
    "mass": "165 kg",
    "up": "90 mm",
    "right": "-15 mm",
    "z": "-40 mm",
    "inertia_up": "9.5 kg*m^2",
    "inertia_right": "10.5 kg*m^2",
    "inertia_z": "4.2 kg*m^2",
}
MOUNTS: list[dict[str, Any]] = [
    {
        "name": "left",
        "up": "40 mm",
        "right": "-320 mm",
        "z": "110 mm",
        "stiffness": ["220 N/mm", "90 N/mm", "80 N/mm"],
        "bearing": "20 deg",
    },
    {
        "name": "right",
        "up": "40 mm",
        "right": "310 mm",
        "z": "90 mm",
        "stiffness": ["200 N/mm", "90 N/mm", "70 N/mm"],
        "bearing": "-25 deg",
        "damping": ["150 N*s/m", "60 N*s/m", "90 N*s/m"],
        "rubber": [{"frequency": "25 Hz", "factor": 1.2}, {"frequency": "100 Hz", "factor": 1.5}],
    },
    {
        "name": "rear",
        "up": "-20 mm",
        "z": "-480 mm",
        "stiffness": "130 N/mm",
        "lean": "10 deg",
        "loss_factor": 0.08,
    },
]
FOUNDATION: dict[str, Any] = {
    "mass": "420 kg",
    "up": "-260 mm",
    "inertia_up": "60 kg*m^2",
    "inertia_right": "55 kg*m^2",
    "inertia_z": "30 kg*m^2",
    "mounts": [
        {
            "name": f"foot {side} {end}",
            "up": "-380 mm",
            "right": right,
            "z": z,
            "stiffness": "2 kN/mm",
        }
        for side, right in (("left", "-400 mm"), ("right", "400 mm"))
        for end, z in (("front", "300 mm"), ("rear", "-500 mm"))
    ],
}
SOFT: list[dict[str, Any]] = [
    {**each, "stiffness": "0.00001 N/mm", "damping": [], "rubber": [], "loss_factor": 0.0}
    for each in MOUNTS
]
"""So soft that the block is as good as free."""
HEAVY: dict[str, Any] = {"cylinder.rotating_mass": "400 g"}
"""Big ends without counterweights, which yaw the block as well as pitch it."""


def standing(name: str = FIVE, **changes: Any) -> Engine:
    """An engine of the catalog on its mounts, changed."""
    return load(name, changes={"block": BLOCK, "mounts": MOUNTS, **changes})
