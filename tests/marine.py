"""A two-stroke seven of invented masses, as an engine file and with changes."""

from __future__ import annotations

from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files import engine_of

SEVEN: dict[str, Any] = {
    "format": 1,
    "name": "two-stroke seven",
    "cycle": "two-stroke",
    "firing_order": [1, 7, 2, 5, 4, 3, 6],
    "speed": "104 rpm",
    "cylinder": {
        "bore": "600 mm",
        "stroke": "2400 mm",
        "rod_ratio": 2.05,
        "reciprocating_mass": "5.5 t",
    },
    "layout": {"type": "inline", "bore_pitch": "1020 mm"},
    "gas": {
        "ignition": "compression",
        "compression_ratio": 20,
        "bmep": "19 bar",
        "intake_pressure": "3.6 bar",
        "combustion_start": "-6 deg",
        "combustion_duration": "60 deg",
    },
}
WEIGHTED: dict[str, Any] = {"cylinder": SEVEN["cylinder"] | {"rotating_mass": "3 t"}}
"""With big ends that nothing balances."""


def marine_engine(**changes: Any) -> Engine:
    """The seven, with other values of its file."""
    return engine_of({**SEVEN, **changes})
