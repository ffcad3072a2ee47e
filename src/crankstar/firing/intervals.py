"""When each combustion chamber fires: angles and intervals of the firing order."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import firing_angles


@dataclass(frozen=True)
class Firing:
    """The chambers in firing order, the angles of firing and the intervals (degrees)."""

    order: tuple[int, ...]
    angles_deg: tuple[float, ...]
    intervals_deg: tuple[float, ...]
    cycle_deg: float

    @property
    def even(self) -> bool:
        """Whether all intervals are equal, to a thousandth of a degree."""
        return max(self.intervals_deg) - min(self.intervals_deg) < 1e-3


@lru_cache(maxsize=256)  # strokes, verdict, gas and figures all want it
def firing(engine: Engine) -> Firing:
    """When each chamber fires; nothing at all of an engine without a firing order."""
    angles = firing_angles(engine)
    if not angles:
        return Firing((), (), (), engine.cycle_angle)
    following = [*angles[1:], angles[0] + engine.cycle_angle]
    intervals = tuple(round(b - a, 9) for a, b in zip(angles, following, strict=True))
    return Firing(engine.firing_order, tuple(angles), intervals, engine.cycle_angle)
