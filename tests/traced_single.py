"""A single cylinder with a measured pressure that is a formula, so that all of it is known."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.spectra import Real

BORE, RADIUS, ROD, MASS, SPEED = 0.09, 0.044, 0.149, 0.43, 2400 * pi / 30


def pressure(theta: Real) -> Real:
    """A peak of 61 bar at 14.3 degrees, which no sample meets; bar."""
    return 1 + 60 * np.exp(40 * (np.cos((theta - 0.25) / 2) - 1))


def single(**tables: Any) -> Engine:
    """The engine, with further tables of its file."""
    angle = np.arange(0.0, 720.0, 0.75)
    trace = {
        "angle": [f"{each} deg" for each in angle],
        "pressure": [f"{each:.12f} bar" for each in pressure(np.radians(angle))],
    }
    return engine_of(
        {
            "name": "single",
            "speed": "2400 rpm",
            "cylinder": {
                "bore": f"{BORE} m",
                "stroke": f"{2 * RADIUS} m",
                "rod_length": f"{ROD} m",
                "reciprocating_mass": f"{MASS} kg",
                "rotating_mass": "0 kg",
            },
            "layout": {"type": "inline", "throws": ["0 deg"]},
            "gas": {"trace": trace},
            **tables,
        }
    )
