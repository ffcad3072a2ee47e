"""A value written with its tolerance, "650 g +- 2 g", parted into the value and the tolerance.

A tolerance is written behind `+-`, `+/-` or the sign for both, as a number with a unit or in
percent of the value. Where one of the two has no unit, it has that of the other: "650 +- 2 g".
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple

_SIGN = re.compile(r"\s*(?:\+\s?/?\s?[-\u2212]|\u00b1)\s*")
_BEGIN = frozenset("+\u00b1")
"""The letters a sign begins with; most texts have neither."""
_NUMBER = re.compile(
    r"\s*([-+\u2212]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)
_LONGEST = 120
"""Letters: a longer text is no number with a tolerance."""
PERCENT = "%"


class Toleranced(NamedTuple):
    """The text of a value and that of its tolerance, each with its unit."""

    value: str
    tolerance: str


def parted(text: Any) -> Toleranced | None:
    """Value and tolerance of a text; None where it has no tolerance.

    >>> parted("650 g +- 2 g"), parted("90 +/- 0.25 deg").value, parted("12 mm")
    (Toleranced(value='650 g', tolerance='2 g'), '90 deg', None)
    """
    if not isinstance(text, str) or len(text) > _LONGEST or not _BEGIN.intersection(text):
        return None
    halves = _SIGN.split(text)
    if len(halves) != 2:
        return None
    value, tolerance = halves[0].strip(), halves[1].strip()
    own, other = unit_behind(value), unit_behind(tolerance)
    if own is None:
        return None
    if not own and other and other != PERCENT:
        value = f"{value} {other}"
    if own and other == "" and "@" not in own and " at " not in f" {own} ":
        tolerance = f"{tolerance} {own}"
    return Toleranced(value, tolerance)


def with_unit(text: str, unit: str) -> str | None:
    """A text with a tolerance whose value has a unit: its own, else this one; None without one.

    >>> with_unit("650 +- 0.5 %", "g"), with_unit("650 g +- 2 g", "g"), with_unit("650", "g")
    ('650 g +- 0.5 %', '650 g +- 2 g', None)
    """
    own = parted(text)
    if own is None or unit_behind(own.value):
        return None if own is None else text
    return f"{own.value} {unit} +- {own.tolerance}"


def unit_behind(text: str) -> str | None:
    """The unit behind a number; empty without one, None where there is no number."""
    found = _NUMBER.fullmatch(text)
    return None if found is None else found[2]


def nominal(value: Any) -> Any:
    """The value without its tolerance; anything else as it is.

    >>> nominal("650 +- 2 g"), nominal("0.2 ± 0.01"), nominal(3)
    ('650 g', 0.2, 3)
    """
    own = parted(value)
    if own is None:
        return value
    return float(own.value) if unit_behind(own.value) == "" else own.value
