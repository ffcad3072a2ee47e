"""The digits of a number that are certain, as its print has them."""

from __future__ import annotations

from fractions import Fraction
from math import floor, log10

from flint import arb

from crankstar.derive.algebra.formula import Decimal

MOST_PLACES = 30
"""Places behind the point at most, however small a decimal is."""
NARROW = 1e-6
"""Share of the last figure within which a number is known that may be rounded to it."""
NEAR_UNIT = 0.1
"""The same of a whole number, none of whose figures were certain if it were cut."""


def figures(decimal: Decimal) -> str | None:
    """The digits of a decimal that are certain, at most as many as it asks for.

    `-0.8516` is cut, not rounded.

    An enclosure of zero that is not zero is written as 0. Of a number of which not even the first
    digit is certain, these are the places at which it certainly has none, or None, if it has more
    than units.

    >>> figures(Decimal(arb(5e-10, 0.7e-10))), figures(Decimal(arb(5, 0.7)))
    ('0.000000000', None)
    """
    ball = decimal.ball
    if ball.contains(0):
        return "0"
    most = max(0, min(decimal.digits - 1 - floor(log10(float(abs(ball).mid()))), MOST_PLACES))
    for places in range(most, -1, -1):
        scaled = abs(ball) * 10**places
        # Cut; or rounded where it is known to be so near to a round number that a cut is undecided.
        near = NARROW if places else NEAR_UNIT
        for start in (scaled, *([scaled + arb(0.5)] if scaled.rad() < near else [])):
            low, high = start.lower().floor(), start.upper().floor()
            if low == high:
                shown = _pointed(int(low.unique_fmpz()), places)
                return shown if ball > 0 else f"-{shown}"
    return None


def _pointed(whole: int, places: int) -> str:
    """A whole number over 10**places as a decimal."""
    digits = str(whole).rjust(places + 1, "0")
    return digits if places == 0 else f"{digits[:-places]}.{digits[-places:]}"


def finite(size: Fraction) -> str | None:
    """A fraction of at most six decimal places as it is, None where it has more.

    >>> finite(Fraction(1, 8)), finite(Fraction(1, 3))
    ('0.125', None)
    """
    places = next((n for n in range(7) if 10**n % size.denominator == 0), None)
    return None if places is None else _pointed(int(size * 10**places), places)
