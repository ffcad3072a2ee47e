"""Engines whose crankshafts twist, for tests of what the page shows of them."""

from __future__ import annotations

from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files.catalog import load

CLOCKWISE, COUNTER_CLOCKWISE = "audi-25-tfsi", "honda-b18c"
FLYWHEEL = {
    "name": "flywheel",
    "inertia": "0.3 kg*m^2",
    "to": "rear",
    "stiffness": "0.9 MN*m/rad",
    "diameter": "70 mm",
}
HUB = {
    "name": "hub",
    "inertia": "0.01 kg*m^2",
    "to": "front",
    "stiffness": "0.4 MN*m/rad",
    "diameter": "55 mm",
}
RING = {"name": "ring", "inertia": "0.03 kg*m^2", "to": "hub", "damping": "8 N*m*s/rad"}
TORSION: dict[str, Any] = {
    "bare_inertia": "0.012 kg*m^2",
    "stiffness": "0.6 MN*m/rad",
    "damping": "2 N*m*s/rad",
    "diameter": "60 mm",
    "bore": "20 mm",
    "disc": [HUB, RING, FLYWHEEL],
}


def twisting(name: str, **changes: Any) -> Engine:
    """An engine of the catalog with a table [torsion], changed; None leaves a key out.

    One without masses has inertias of its own, and is driven by gas alone.
    """
    own = {key: value for key, value in {**TORSION, **changes}.items() if value is not None}
    if "mass" in load(name).relative:
        own.pop("bare_inertia", None)
        own.setdefault("inertia", "0.03 kg*m^2")
    return load(name, changes={"torsion": own})
