"""Speed of 100 000 engines built to their tolerances: `make bench` prints it.

A six and a V12 with errors of masses, throws and lengths; all signals, the usual orders; warm,
medians.
"""

from __future__ import annotations

from typing import Any

from gas import seconds

import tables
from crankstar.analyses.tolerance.scatter import BUILDS, scatter

MASSES: dict[str, Any] = {
    "cylinder.reciprocating_mass": "500 g +- 3 g",
    "cylinder.rotating_mass": "400 g +- 2 g",
    "cylinder.stroke": "90 mm +- 0.02 mm",
}
TURNED: dict[str, Any] = {
    "layout.throws": ["0 deg", *(f"{each} deg +- 0.1 deg" for each in (240, 120, 120, 240, 0))]
}


def main() -> None:
    """Print the table."""
    rows: list[tables.Row] = []
    for what, name, changes in (
        ("six", "i6", MASSES),
        ("six, throws off their angles", "i6", MASSES | TURNED),
        ("V12", "v12-60", MASSES),
    ):
        took = seconds(lambda name=name, own=changes: scatter(name, changes=own), times=3)
        rows.append((f"{BUILDS} engines, {what}", f"{took:.3g} s", "2 s"))
    tables.show("tolerances", rows)


if __name__ == "__main__":
    main()
