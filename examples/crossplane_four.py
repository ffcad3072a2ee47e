"""Four cylinders in line: flat crank against cross-plane crank, gains and costs.

The flat crank (0, 180, 180, 0) has 4 A_2 m r w^2 of second-order force. The cross-plane crank (0,
90, -90, 180) has no force of orders 1 and 2 at all, but a first-order couple of sqrt(10) m r w^2 a,
half with the crank and half against it: a balance shaft must take the second half.
"""

from __future__ import annotations

from math import pi

import crankstar
from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.layouts import inline

CRANKS = {"flat": (0.0, pi, pi, 0.0), "cross-plane": (0.0, pi / 2, -pi / 2, pi)}
ROD_RATIO = 4.0


def main() -> dict[str, dict[str, float]]:
    """For each crank the secondary force in m r w^2 A_2 and the primary couple in m r w^2 a."""
    unit = motion.piston_harmonics(crank_radius=1, rod_length=ROD_RATIO)[2].real
    found: dict[str, dict[str, float]] = {}
    for name, throws in CRANKS.items():
        engine = inline(Basis(name=name, cylinder=Sizes(rod_ratio=ROD_RATIO)), throws=throws)
        sums = crankstar.total(crankstar.balance(engine))
        couple = spectra.selected(sums.couple, 1)
        found[name] = {
            "force 2": spectra.peak(spectra.selected(sums.force, 2)).value / unit,
            "couple 1": spectra.peak(couple).value,
            "couple 1, with the crank": abs(couple.forward[0]),
            "couple 1, against it": abs(couple.backward[0]),
        }
    return found


if __name__ == "__main__":
    for crank, numbers in main().items():
        print(crank, *(f"{name}: {value:.4f}" for name, value in numbers.items()), sep="   ")
