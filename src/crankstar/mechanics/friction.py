"""Friction mean effective pressure by published correlations, without pumping.

Sources: spark ignition: M. D. Barnes-Moss, A Designer's Viewpoint, I.Mech.E. C343/73 (1975);
Diesel engines: B. W. Millington, E. R. Hartles, Frictional Losses in Diesel Engines, SAE 680590
(1968), direct injection; both as given by J. B. Heywood, Internal Combustion Engine Fundamentals,
chapter 13. They were measured on motored car and lorry engines; on a large marine engine they are
an extrapolation.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import Any, Literal

from crankstar.language.numbers import RPM

Correlation = Literal["spark-ignition", "diesel", "none"]


def friction_pressure(correlation: Correlation, *, speed: float, stroke: float) -> float:
    """The friction mean effective pressure, Pa, at a speed (rad/s); the stroke in m.

    >>> round(friction_pressure("spark-ignition", speed=300 * pi, stroke=0.08))  # 9000 rpm
    637000
    >>> friction_pressure("none", speed=100.0, stroke=0.08)
    0.0
    """
    thousands = speed * RPM / 1000
    if correlation == "spark-ignition":
        return 1e5 * (0.97 + 0.15 * thousands + 0.05 * thousands**2)
    if correlation == "diesel":
        piston_speed = speed * stroke / pi
        return 1e3 * (75 + 48 * thousands + 0.4 * piston_speed**2)
    return 0.0


def friction_of(values: Mapping[str, Any]) -> float | None:
    """The friction mean effective pressure of a cycle's values, Pa: as given, or by a correlation.

    None where a correlation needs the speed and there is none.

    >>> friction_of({"friction_pressure": 1.7e5}), friction_of({"friction": "none"})
    (170000.0, 0.0)
    >>> friction_of({"friction": "diesel", "stroke": 0.08}) is None
    True
    """
    given, correlation = values.get("friction_pressure"), values.get("friction", "none")
    if given is not None or correlation == "none":
        return given or 0.0
    if values.get("speed") is None:
        return None
    return friction_pressure(correlation, speed=values["speed"], stroke=values["stroke"])
