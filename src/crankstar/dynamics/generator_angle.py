"""How far a generator runs ahead of its mean turn and behind it within a cycle.

From the speed w(theta) over a cycle of steady running, of mean w_m over time, the crankshaft is at
the time t(theta), with dt/dtheta = 1/w, ahead of even running by

    alpha(theta) = theta - w_m t(theta)                     rad

less its mean over time; a generator of p pole pairs on the same shaft by p alpha in electrical
angle. For a small irregularity an order k of the torque, T_k, on the inertia J makes the angle
T_k/(J (k w_m)^2).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from crankstar.dynamics.uneven import Running, periodic_integral
from crankstar.mechanics.maxima import extremes
from crankstar.spectra import Real


@dataclass(frozen=True)
class GeneratorAngle:
    """The angle ahead of even running over a cycle [angle], rad; greatest ahead and behind.

    >>> import numpy as np
    >>> GeneratorAngle(np.array([0.0, 0.02, 0.0, -0.02])).greatest
    0.02
    """

    ahead: Real

    @cached_property
    def ends(self) -> tuple[float, float]:
        """The most behind (negative) and the most ahead, rad."""
        found = extremes(self.ahead, 1.0)
        return found.least, found.greatest

    @property
    def greatest(self) -> float:
        """The greatest deviation to either side, rad."""
        return max(map(abs, self.ends))

    @property
    def range(self) -> float:
        """From the most behind to the most ahead, rad."""
        return self.ends[1] - self.ends[0]

    def electrical(self, pole_pairs: int) -> float:
        """The greatest deviation in electrical angle, rad."""
        return pole_pairs * self.greatest


def generator_angle(found: Running) -> GeneratorAngle:
    """The angle by which a shaft is ahead of even running, of a cycle of steady running.

    >>> from crankstar import cycle, driven, load
    >>> five = load("audi-25-tfsi")
    >>> idle = cycle(five, speed="800 rpm", imep="2 bar")
    >>> light, heavy = (generator_angle(driven(five, idle, flywheel=j)) for j in (0.3, 30.0))
    >>> bool(light.greatest > 50 * heavy.greatest)
    True
    """
    span = float(found.theta[1] - found.theta[0])
    slower = found.mean_speed / found.speed
    ahead = periodic_integral(1.0 - slower, span)
    return GeneratorAngle(ahead - float((ahead * slower).mean() / slower.mean()))
