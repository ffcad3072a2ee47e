"""Which V8 buzzes and which one nods: 90-degree engines that differ in the crankshaft only.

The flat-plane crank leaves a second-order force, a horizontal line of 4 sqrt(2) times that of one
piston. The cross-plane crank leaves no such force, but a first-order couple sqrt(10) m r w^2 a that
turns with the crank, for counterweights to remove.
"""

from __future__ import annotations

from typing import NamedTuple

import crankstar
from crankstar import spectra
from crankstar.engine import motion


class Shake(NamedTuple):
    """The second-order force (m r w^2 A_2) and the first-order couple (m r w^2 a) that remain."""

    force: float
    couple_with_crank: float
    couple_against_crank: float


def shake(name: str) -> Shake:
    """The two numbers by which a V8 is known."""
    sums = crankstar.total(crankstar.balance(name))
    second, first = spectra.selected(sums.force, 2), spectra.selected(sums.couple, 1)
    of_one_piston = motion.piston_harmonics(crank_radius=1, rod_length=4)[2].real
    force = spectra.ellipse(second.forward[0], second.backward[0]).semi_major / of_one_piston
    return Shake(force, abs(first.forward[0]), abs(first.backward[0]))


def main() -> dict[str, Shake]:
    """Both engines."""
    return {name: shake(name) for name in ("v8-flat-plane", "v8-cross-plane")}


if __name__ == "__main__":
    for engine, left in main().items():
        print(
            f"{engine:15} order 2 force {left.force:.4f}   order 1 couple "
            f"{left.couple_with_crank:.4f} with the crank"
        )
