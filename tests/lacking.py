"""Engine files that lack something, for tests of what answers rest on."""

from __future__ import annotations

from typing import Any

FIVE: dict[str, Any] = {
    "format": 1,
    "name": "five",
    "firing_order": [1, 2, 4, 5, 3],
    "speed": "3000 rpm",
    "cylinder": {
        "bore": "82 mm",
        "stroke": "90 mm",
        "rod_length": "145 mm",
        "reciprocating_mass": "480 g",
    },
    "layout": {"type": "inline", "bore_pitch": "91 mm"},
}
"""Without gas, flywheel and rotating masses."""
GENSET: dict[str, Any] = {
    **FIVE,
    "name": "genset six",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "speed": "1500 rpm",
    "cylinder": {
        "bore": "130 mm",
        "stroke": "150 mm",
        "rod_length": "250 mm",
        "reciprocating_mass": "4 kg",
        "rotating_mass": "3.5 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "160 mm"},
    "gas": {"bmep": "18 bar", "compression_ratio": 16},
    "drive": {"inertia": "6 kg*m^2"},
}
"""A generating set whose crankpins have no mass."""
RUBBER = """
[[mounts]]
name = "left"
right = "-0.4 m"
z = "0.1 m"
stiffness = "200 N/mm"
[[mounts]]
name = "right"
right = "0.4 m"
z = "0.1 m"
stiffness = "200 N/mm"
[[mounts]]
name = "rear"
z = "-0.4 m"
stiffness = "200 N/mm"
"""
"""Three mounts, of which no loss factor is known."""
