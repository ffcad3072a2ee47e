"""The arrays of loads: over a turn or a cycle, of each main bearing, crank pin and wall."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from crankstar import spectra
from crankstar.analyses.bearings.answer import Loads
from crankstar.analysis.record import Grid
from crankstar.spectra import Spectrum

STEP = 1.0
"""deg: of the crank angle."""


def grids(result: Loads) -> Mapping[str, Grid]:
    """The load upward and to the right of each part over the crank angle; by order of bearings.

    `bearings`, `pins` and `guides` [part, theta_deg], `orders` [bearing, order] as complex
    amplitudes c of Re(c exp(i order theta)), all in the unit of the loads.
    """
    loads = result.of_parts
    names = [f"{bearing.shaft} {bearing.number}" for bearing in loads.bearings]
    pins = [f"{pin.shaft} {pin.throw}" for pin in loads.pins]
    both = ("bearing", "order")
    return {
        "bearings": _over_angle("bearing", names, loads.load, loads.unit),
        "pins": _over_angle("pin", pins, loads.pin, loads.unit),
        "guides": _over_angle("cylinder", [*loads.cylinders], loads.guide, loads.unit),
        "orders": Grid(
            {"bearing": names, "order": loads.load.orders},
            {
                "vertical": (both, spectra.vertical(loads.load), loads.unit),
                "horizontal": (both, spectra.horizontal(loads.load), loads.unit),
            },
        ),
    }


def _over_angle(part: str, names: Sequence[str | int], load: Spectrum, unit: str) -> Grid:
    """The components of the loads of all parts over the time after which they are the same."""
    degrees = np.arange(0.0, 360.0 * spectra.period(load), STEP)
    found = spectra.value(load, np.radians(degrees))
    axes = (part, "theta_deg")
    return Grid(
        {part: [*names], "theta_deg": degrees},
        {"vertical": (axes, np.real(found), unit), "horizontal": (axes, np.imag(found), unit)},
    )
