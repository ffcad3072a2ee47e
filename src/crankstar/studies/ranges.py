"""The values of a sweep, read from text: `layout.banks[1].bearing=0..90 deg`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.language.quoting import one_line, seen
from crankstar.studies.variants import SweepError

GREATEST_POINTS = 20_000
USUAL_POINTS = 201
EXAMPLE = 'as in "layout.banks[1].bearing=0..90 deg", "balance_factor=0..1/11" (11 values) or "balance_factor=0, 0.25, 0.5"'
_NUMBER = re.compile(
    r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)


class Over(NamedTuple):
    """The key path of a swept number, its values, and their unit ("" if none was given)."""

    path: str
    values: tuple[float, ...]
    unit: str


def over_request(text: str) -> Over:
    """What a text such as "layout.banks[1].bearing=0..90 deg" asks to be swept. Raises SweepError.

    >>> over_request("balance_factor=0..1/5")
    Over(path='balance_factor', values=(0.0, 0.25, 0.5, 0.75, 1.0), unit='')
    >>> over_request("layout.cranks[2].lag=0, 90, 180 deg")[1:]
    ((0.0, 90.0, 180.0), 'deg')
    """
    here = f"--over {one_line(text, longest=100)}"
    path, equals, told = text.partition("=")
    if not equals or not path.strip() or not told.strip():
        raise SweepError(f"{here}: give a field of the engine file and its values, {EXAMPLE}")
    if ".." not in told:
        parts = [part for part in told.split(",") if part.strip()]
        values, unit = _numbers(parts, here)
        if len(set(values)) < 2:
            raise SweepError(f"{here}: is one value; a sweep needs two or more, {EXAMPLE}")
        return Over(path.strip(), tuple(values), unit)
    counts = re.findall(r"/\s*(\d+)(?!\d)", told)
    ends, unit = _numbers(re.sub(r"/\s*\d+", " ", told, count=1).split("..", 1), here)
    count = int(counts[0][:9]) if counts else USUAL_POINTS
    if len(counts) > 1 or not 2 <= count <= GREATEST_POINTS:
        raise SweepError(
            f"{here}: {one_line(counts[-1], longest=20)} is no number of values to sweep; give from 2 to {GREATEST_POINTS}"
        )
    if ends[0] == ends[1]:
        raise SweepError(
            f"{here}: is an empty range, from {ends[0]:g} to {ends[1]:g}; give two ends that differ"
        )
    return Over(path.strip(), tuple(np.linspace(ends[0], ends[1], count).tolist()), unit)


def _numbers(parts: Sequence[str], here: str) -> tuple[list[float], str]:
    """Numbers, and the one unit that some or all of them have."""
    found = [_NUMBER.fullmatch(part) if len(part) <= 60 else None for part in parts]
    for part, match in zip(parts, found, strict=True):
        if (
            match is None
            or not np.isfinite(float(match.group(1)))
            or re.match(r"[.,\d]", match.group(2))
        ):
            raise SweepError(
                f"{here}: {seen(part.strip())} is not a number, or one with a unit; give values {EXAMPLE}"
            )
    units = dict.fromkeys(match.group(2) for match in found if match and match.group(2))
    if len(units) > 1:
        raise SweepError(
            f"{here}: has the units {' and '.join(one_line(unit, longest=20) for unit in units)}; give all in one"
        )
    return [float(match.group(1)) for match in found if match], next(iter(units), "")
