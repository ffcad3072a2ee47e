"""The effect of the master rod on the balance of a nine-cylinder radial engine.

With all rods on the crank pin itself nine equal pistons leave a first-order force of 9/2 m r w^2
that turns with the crank, and no second order. With eight slave rods on knuckle pins of a master
rod the pistons are no longer equal, and a second-order force appears. It is nearly a circle, with
the crank at twice its speed, of about n lambda rho/(l - rho) m r w^2 for n cylinders and a knuckle
radius rho; a weight geared to turn at that speed could remove it.
"""

from __future__ import annotations

import crankstar
from crankstar import spectra
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.layouts import Row, radial

ROD_RATIO, KNUCKLE_RADIUS = 4.0, 1.0
"""In crank radii."""


def forces(knuckle_radius: float | None) -> dict[str, float]:
    """The first-order vectors and the greatest second-order force, in m r w^2."""
    row = Row(cylinders=tuple(range(1, 10)))
    engine = radial(
        Basis(name="radial nine", cylinder=Sizes(rod_ratio=ROD_RATIO)),
        rows=(row,),
        knuckle_radius=knuckle_radius,
    )
    sums = crankstar.total(crankstar.balance(engine))
    first = spectra.selected(sums.force, 1)
    return {
        "forward 1": abs(first.forward[0]),
        "backward 1": abs(first.backward[0]),
        "force 2": spectra.peak(spectra.selected(sums.force, 2)).value,
    }


def main() -> dict[str, dict[str, float]]:
    """Both kinds of rods."""
    return {
        "all rods on the crank pin": forces(None),
        "slave rods on a master": forces(KNUCKLE_RADIUS),
    }


if __name__ == "__main__":
    for kind, numbers in main().items():
        print(f"{kind:26}", *(f"{name}: {value:.4f}" for name, value in numbers.items()), sep="   ")
