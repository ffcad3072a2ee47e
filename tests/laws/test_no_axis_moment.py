"""An engine without a moment about its axis has none, not what rounding leaves of two that cancel.

A rod m of length l with its centre at c has one of the order of m c (l - c) - I.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crankstar.files import engine_of
from crankstar.mechanics.excitation import part_spectra, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.studies.sweep import sweep, watched

MASS, LENGTH, CENTRE = 0.38, 0.112, 0.032
THREE: dict[str, Any] = {
    "name": "triple",
    "firing_order": [1, 3, 2],
    "speed": "9000 rpm",
    "cylinder": {
        "stroke": "61 mm",
        "rod_length": "112 mm",
        "reciprocating_mass": "290 g",
        "rod": {"mass": "380 g", "centre": "32 mm"},
    },
    "layout": {"type": "inline", "bore_pitch": "90 mm"},
}


def test_two_masses_at_the_ends_of_a_rod_have_none() -> None:
    found = sweep(THREE, {"cylinder.stroke": [0.055, 0.061, 0.067]})
    assert not np.any(watched(found, "axis_moment").values)
    parts = part_spectra(mechanism(engine_of(THREE))).axis_moment
    assert not np.any(parts.forward)


def test_any_other_inertia_has_its_own() -> None:
    """The angular momentum of a rod about the axis beside that of two masses: (I - m c (l - c)) b'.

    Of three at 120 deg order 3 adds up, with b''s third harmonic from numpy.
    """
    more = 1e-6
    inertia = MASS * CENTRE * (LENGTH - CENTRE) + more
    rod = {"mass": MASS, "centre": CENTRE, "inertia": inertia}
    cylinder = {
        **THREE["cylinder"],
        "rod": {
            key: f"{size!r} {unit}"
            for (key, size), unit in zip(rod.items(), ("kg", "m", "kg*m^2"), strict=True)
        },
    }
    own = total(part_spectra(mechanism(engine_of({**THREE, "cylinder": cylinder})))).axis_moment
    theta = np.linspace(0, 2 * np.pi, 512, endpoint=False)
    tilt = np.fft.rfft(np.arcsin(0.0305 / LENGTH * np.sin(theta)))[3] / 256
    third = np.argmin(np.abs(own.orders - 3))
    size = abs(own.forward[third]) + abs(own.backward[third])
    assert size == pytest.approx(3 * more * 9 * abs(tilt), rel=1e-6)
