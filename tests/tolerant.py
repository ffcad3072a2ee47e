"""An engine file with tolerances."""

from __future__ import annotations

from typing import Any

from tests.texts import SHORT, spoilt

TOLERANT: dict[str, Any] = spoilt(
    SHORT,
    name="four with tolerances",
    firing_order=[1, 3, 4, 2],
    speed="6000 rpm",
    cylinder={
        "bore": "86 mm",
        "stroke": "86 mm +- 0.05 mm",
        "rod_length": "143 mm",
        "reciprocating_mass": "650 g +- 2 g",
        "rotating_mass": "450 g +- 3 g",
    },
    layout={"type": "inline", "bore_pitch": "94 mm +- 0.1 mm"},
)
