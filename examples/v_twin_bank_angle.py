"""The first-order force of a V twin on one crank pin with a balanced crankshaft, by bank angle.

Both pistons push half of their first-order force forward, with the crank pin, and half backward.
The forward halves always add up to m r w^2, which a counterweight can remove. The backward halves
stand at twice the bank angle to each other: cos(bank angle) is left, nothing at 90 degrees.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import crankstar
from crankstar import spectra
from crankstar.mechanics.batches import totals
from crankstar.mechanics.mechanism import mechanism

BANK_ANGLES = np.arange(0, 181, 15)


def main() -> dict[str, np.ndarray]:
    """First-order vectors by bank angle, in m r w^2; one call for the whole batch."""
    machine = mechanism(crankstar.load("v2-90"))
    bearings = np.radians(BANK_ANGLES)[:, None] * [0.5, -0.5]  # [engine, cylinder]
    first = spectra.selected(totals(replace(machine, bearing=bearings), orders=[1]).force, 1)
    return {
        "bank_angle_deg": BANK_ANGLES,
        "forward": abs(first.forward[:, 0]),
        "backward": abs(first.backward[:, 0]),
    }


if __name__ == "__main__":
    for angle, forward, backward in zip(*main().values(), strict=True):
        print(
            f"{angle:4.0f} deg   a counterweight can remove {forward:.3f}, leaving {backward:.3f}"
        )
