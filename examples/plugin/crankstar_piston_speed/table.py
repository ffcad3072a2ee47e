"""An export: where cylinders and pins stand, as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io
from math import degrees

from crankstar.engine.engine import Engine


def places(engine: Engine) -> str:
    """Of each cylinder its number, its direction and that of its pin (deg, clockwise from up)."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["cylinder", "bearing [deg]", "pin [deg]", "rod length over crank radius"])
    for cylinder in engine.cylinders:
        throw = engine.throw(cylinder)
        angles = (f"{degrees(angle):.6g}" for angle in (cylinder.bearing, throw.angle))
        rows.writerow([cylinder.number, *angles, f"{cylinder.rod_length / throw.radius:.6g}"])
    return text.getvalue()
