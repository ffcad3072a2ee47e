"""What views tell of large engines: guide-force moments, all that a ship needs of its engine."""

from __future__ import annotations

from functools import lru_cache

from crankstar.analyses.marine.document import guide_table
from crankstar.analyses.marine.marine_analysis import MarineAnalysis, marine
from crankstar.analysis.document import Table
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.guide_moments import MarineError, guide_moments

LARGE_BORE = 0.2
"""m, of engines that stand in ships and power plants: their guide-force moments matter."""


def large_engine_table(engine: Engine, cycle: Cycle) -> Table | None:
    """The guide-force moments of an engine of LARGE_BORE with one crankshaft; None of others."""
    if (engine.first.bore or 0.0) < LARGE_BORE:
        return None
    try:
        return guide_table(guide_moments(engine, cycle))
    except MarineError:
        return None


@lru_cache(maxsize=8)
def ship_engine(engine: Engine, speed: float | None = None) -> MarineAnalysis | None:
    """The moments of a large two-stroke engine in line, as `crankstar marine` has them.

    At its first operating point, or at `speed` (rad/s). None of other engines, and of those whose
    file lacks what they take in N m: masses, sizes, the speed and the gas.
    """
    bearings = {round(cylinder.bearing, 9) for cylinder in engine.cylinders}
    large = (engine.first.bore or 0.0) >= LARGE_BORE
    if not large or engine.cycle_angle != 360 or len(bearings) > 1 or engine.gas is None:
        return None
    found = marine(engine, speed=speed)
    guide = found.guide
    if guide is None or not (guide.with_inertia and guide.pitch_known):
        return None
    return found if found.after.units.couple == "N*m" and found.after.speed is not None else None
