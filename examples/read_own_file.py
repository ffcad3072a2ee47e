"""An engine file of one's own, in newtons: a parallel twin with its cranks 180 degrees apart.

Its first-order forces cancel and leave a couple m r w^2 a; its second-order forces add up to 2 A_2
m r w^2.
"""

from __future__ import annotations

from pathlib import Path

import crankstar
from crankstar import spectra
from crankstar.firing.intervals import firing

FILE = Path(__file__).parent / "twin_180.toml"


def main() -> dict[str, float]:
    """The greatest force (N) of orders 1 and 2 and first-order couple (N m).

    Also the shorter firing interval (deg).
    """
    engine = crankstar.load(FILE)
    sums = crankstar.total(crankstar.balance(engine))
    return {
        "force 1": spectra.peak(spectra.selected(sums.force, 1)).value,
        "force 2": spectra.peak(spectra.selected(sums.force, 2)).value,
        "couple 1": spectra.peak(spectra.selected(sums.couple, 1)).value,
        "interval": min(firing(engine).intervals_deg),
    }


if __name__ == "__main__":
    try:
        for name, value in main().items():
            print(f"{name:10} {value:10.1f}")
    except crankstar.EngineFileError as error:
        print(error)  # every mistake in the file, with its place
