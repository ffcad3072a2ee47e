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
EXAMPLE = (
    'as in "layout.banks[1].bearing=0..90 deg", "balance_factor=0..1/11" or "balance_factor=0, 0.5"'
)
_NUMBER = re.compile(
    r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)


_NO_UNIT = re.compile(r"[.,\d]|/\d*\.")
_COUNT = re.compile(r"/\s*(\d+)(?!\.?\d)")


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
    path, equals, wanted = text.partition("=")
    given = one_line(text, longest=100)
    if not equals or not path.strip() or not wanted.strip():
        raise SweepError(
            "--over {given}: give a field of the engine file and its values, {example}",
            given=given,
            example=EXAMPLE,
        )
    if ".." not in wanted:
        parts = [part for part in wanted.split(",") if part.strip()]
        values, unit = _numbers(parts, given)
        if len(set(values)) < 2:
            raise SweepError(
                "--over {given}: this is one value; a sweep needs two or more, {example}",
                given=given,
                example=EXAMPLE,
            )
        return Over(path.strip(), tuple(values), unit)
    counts = _COUNT.findall(wanted)
    ends, unit = _numbers(_COUNT.sub(" ", wanted, count=1).split("..", 1), given)
    count = int(counts[0][:9]) if counts else USUAL_POINTS
    if len(counts) > 1 or not 2 <= count <= GREATEST_POINTS:
        raise SweepError(
            "--over {given}: give from 2 to {most} values, not {count}",
            given=given,
            most=GREATEST_POINTS,
            count=one_line(counts[-1], longest=20),
        )
    if ends[0] == ends[1]:
        raise SweepError(
            "--over {given}: the range is empty; give two ends that differ", given=given
        )
    return Over(path.strip(), tuple(np.linspace(ends[0], ends[1], count).tolist()), unit)


def _numbers(parts: Sequence[str], given: str) -> tuple[list[float], str]:
    """Numbers, and the one unit that some or all of them have."""
    matches = [_NUMBER.fullmatch(part) if len(part) <= 60 else None for part in parts]
    for part, match in zip(parts, matches, strict=True):
        if not match or not np.isfinite(float(match[1])) or _NO_UNIT.match(match[2]):
            raise SweepError(
                "--over {given}: {part} is not a number, with or without a unit; give values, "
                "{example}",
                given=given,
                part=seen(part.strip()),
                example=EXAMPLE,
            )
    units = dict.fromkeys(match[2] for match in matches if match and match[2])
    if len(units) > 1:
        raise SweepError(
            "--over {given}: the units are {units}; give all values in one unit",
            given=given,
            units=", ".join(one_line(unit, longest=20) for unit in units),
        )
    return [float(match[1]) for match in matches if match], next(iter(units), "")
