"""Rational numbers behind doubles: parts of a turn, short decimals, ratios of lengths.

An engine file says 45 deg or 82.5 mm; the record holds the nearest double of that in radians or
metres. A double that lies within rounding of a short fraction is taken for it. Where there is none,
a length or mass is taken for exactly the double it is, and an angle is not a rational part of a
turn.
"""

from __future__ import annotations

from fractions import Fraction
from math import pi

GREATEST_PART = 36_000
"""Least part of a turn that is recognised: a hundredth of a degree."""
TURN_ROUNDING = 2e-13
"""Turns by which a double may miss its fraction of a turn after a layout's sums of angles."""
RATIO_ROUNDING = 4e-15
"""Share of a number by which its double may miss the fraction behind it, after a change of unit."""


def turn(radians: float) -> Fraction | None:
    """An angle as a rational part of a full turn, None if it is not (near) one.

    >>> turn(pi / 3), turn(1.0)
    (Fraction(1, 6), None)
    """
    part = radians / (2 * pi)
    fraction = Fraction(part).limit_denominator(GREATEST_PART)
    return fraction if abs(float(fraction) - part) <= TURN_ROUNDING else None


def ratio(value: float, *, rounding: float = RATIO_ROUNDING) -> Fraction:
    """A number as the short fraction behind it, else as exactly the double it is.

    >>> ratio(0.1), ratio(0.65 / 0.7)
    (Fraction(1, 10), Fraction(13, 14))
    """
    fraction = Fraction(value).limit_denominator(10**7)
    return fraction if abs(float(fraction) - value) <= rounding * abs(value) else Fraction(value)
