"""The best balance factor of the Kawasaki KR250 racer.

Two cylinders on two crankshafts that turn in opposite directions.

Forces in P, the first-order force of one cylinder at top dead centre, with orders 1 and 2 only, as
the essay on this engine counts them. It takes A_2 = 1/4 for r/l = 1/4; exactly it is 0.2540, so
that 1.5 P becomes 1.508 P.
"""

from __future__ import annotations

import numpy as np

import crankstar
from crankstar import spectra

FACTORS = (0.0, 0.25, 0.5, 0.75, 1.0)
ANGLES = np.radians([0, 90, 180])


def force(name: str, factor: float) -> np.ndarray:
    """The force on the block at top dead centre, 90 degrees later and at bottom dead centre.

    [angle], up + i*right.
    """
    engine = crankstar.load(name, changes={"balance_factor": factor})
    sums = crankstar.total(crankstar.balance(engine))
    return spectra.value(spectra.selected(sums.force, [1, 2]), ANGLES)


def main() -> dict[tuple[str, float], np.ndarray]:
    """Both firing intervals of the racer at each balance factor."""
    return {
        (name, factor): force(name, factor)
        for name in ("kr250-racer", "kr250-racer-simultaneous")
        for factor in FACTORS
    }


if __name__ == "__main__":
    for (engine, factor), vectors in main().items():
        shown = "   ".join(
            f"{abs(v):.2f} P (up {v.real:5.2f}, right {v.imag:5.2f})" for v in vectors
        )
        print(f"{engine:25} {factor:4.0%}   {shown}")
