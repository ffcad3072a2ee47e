"""Where a function of one number is nought."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def root(function: Callable[[float], float], *, low: float, high: float) -> float:
    """The root between two ends at which the function has opposite signs, to rounding.

    >>> round(root(lambda x: x * x - 2.0, low=0.0, high=2.0), 12)
    1.414213562373
    """
    from scipy.optimize import brentq

    exact: Any = 1e-15
    found: Any = brentq(function, low, high, xtol=exact * max(abs(low), abs(high)), rtol=exact)
    return float(found)
