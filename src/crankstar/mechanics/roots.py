"""Where a function of one number is nought."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

STRAIGHT = 1e-14
"""Share of the values at the ends that is nought."""


def root(function: Callable[[float], float], *, low: float, high: float) -> float:
    """The root between two ends at which the function has opposite signs, to rounding.

    Of a straight line at once, without scipy, whose import takes longer.

    >>> round(root(lambda x: x * x - 2.0, low=0.0, high=2.0), 12)
    1.414213562373
    """
    first, last = function(low), function(high)
    if first != last:
        straight = low - first * (high - low) / (last - first)
        if abs(function(straight)) <= STRAIGHT * max(abs(first), abs(last)):
            return straight
    from scipy.optimize import brentq

    exact: Any = 1e-15
    found: Any = brentq(function, low, high, xtol=exact * max(abs(low), abs(high)), rtol=exact)
    return float(found)
