"""The values of a sweep, read from text: `layout.banks[1].bearing=0..90 deg`."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from crankstar.files.changes import path_and_value
from crankstar.language.messages import N_, _
from crankstar.language.quoting import one_line, seen
from crankstar.studies.variants import SweepError

MOST_AXES = 2
GREATEST = 1e300
"""The sum and the difference of two numbers up to this are numbers."""
GREATEST_POINTS = 20_000
"""Values of one number."""
USUAL_POINTS = 201
USUAL_OF = {1: USUAL_POINTS, 2: 51}
"""Values of a range, by how many numbers are varied at once."""
EXAMPLE = N_(
    'as in "layout.banks[1].bearing=0..90 deg", "balance_factor=0..1/11", '
    '"speed=600..6000 rpm by 200" or "balance_factor=0, 0.5"'
)
_NUMBER = re.compile(
    r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL
)


_NO_UNIT = re.compile(r"[.,\d]|/\d*\.")
_BY = re.compile(r"\s+by\b\s*")
_COUNT = re.compile(r"/\s*([-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)(?!\.?\d)")


class Over(NamedTuple):
    """The key path of a swept number, its values, and their unit ("" if none was given)."""

    path: str
    values: tuple[float, ...]
    unit: str


def over_requests(texts: Sequence[str]) -> tuple[Over, ...]:
    """What one or two texts such as "balance_factor=0..1" ask to be swept. Raises SweepError.

    >>> [len(over.values) for over in over_requests(["balance_factor=0..1"])]
    [201]
    >>> [len(over.values) for over in over_requests(["balance_factor=0..1", "cylinder.z=0..1"])]
    [51, 51]
    """
    check_axes(len(texts))
    return tuple(over_request(text, usual=USUAL_OF[len(texts)]) for text in texts)


def check_axes(count: int, *, option: str = "") -> None:
    """Refuse more numbers than can be varied at once. Raises SweepError, which names the option."""
    if not 1 <= count <= MOST_AXES:
        told = _("{count} values are to be varied; one or two can be at once", count=count)
        told = f"{option}: {told}" if option else told
        raise SweepError(told)


def requested(
    over: str | Sequence[str] | Mapping[str, Any],
) -> list[tuple[str, Sequence[float], str | None]]:
    """Key path, values and their unit (None: SI) of each number that is varied. Raises SweepError.

    >>> requested({"cylinder.stroke": ["80 mm", "90 mm"], "balance_factor": "0..1/3"})[0]
    ('cylinder.stroke', (80.0, 90.0), 'mm')
    """
    asked: Any = [over] if isinstance(over, str) else over
    check_axes(len(asked))
    usual = USUAL_OF[len(asked)]
    if not isinstance(over, Mapping):
        texts = [over_request(text, usual=usual, option="over") for text in asked]
        return [(each.path, each.values, each.unit) for each in texts]
    out: list[tuple[str, Sequence[float], str | None]] = []
    for path, values in over.items():
        listed = values if isinstance(values, str) else [*values]
        if isinstance(listed, str) or any(isinstance(each, str) for each in listed):
            text = listed if isinstance(listed, str) else ", ".join(map(str, listed))
            each = over_request(f"{path}={text}", usual=usual, option="over")
            out.append((each.path, each.values, each.unit))
        else:
            out.append((str(path), [float(each) for each in listed], None))
    return out


def over_request(text: str, *, usual: int = USUAL_POINTS, option: str = "--over") -> Over:
    """What a text such as "layout.banks[1].bearing=0..90 deg" asks to be swept. Raises SweepError.

    A range has `usual` values unless their number or the step between them is given; `option` is
    what mistakes name.

    >>> over_request("balance_factor=0..1/5")
    Over(path='balance_factor', values=(0.0, 0.25, 0.5, 0.75, 1.0), unit='')
    >>> over_request("layout.cranks[2].lag=0, 90, 180 deg")[1:]
    ((0.0, 90.0, 180.0), 'deg')
    >>> over_request("speed=600..1200 rpm by 200")
    Over(path='speed', values=(600.0, 800.0, 1000.0, 1200.0), unit='rpm')
    """
    path, equals, wanted = path_and_value(text)
    asked = f"{option} {one_line(text, longest=100)}"
    if not equals or not path or not wanted.strip():
        raise SweepError(
            "{asked}: give a field of the engine file and its values, {example}",
            asked=asked,
            example=_(EXAMPLE),
        )
    return Over(path, *_values(wanted, asked, _(EXAMPLE), usual))


def speeds_request(text: str, *, option: str = "--speeds") -> Over:
    """Speeds for a text such as "600..6000 rpm by 200". Raises SweepError.

    >>> speeds_request("1000, 2000 rpm")
    Over(path='speed', values=(1000.0, 2000.0), unit='rpm')
    """
    asked = f"{option} {one_line(text, longest=100)}"
    example = _('as in "600..6000 rpm by 200"')
    if not text.strip():
        raise SweepError("{asked}: give speeds, {example}", asked=asked, example=example)
    return Over("speed", *_values(text, asked, example, USUAL_OF[MOST_AXES]))


def dotted(text: str, asked: str) -> str:
    """A text in which an ellipsis is two full stops. Raises SweepError for three of them.

    >>> dotted("600…6000 rpm", "")
    '600..6000 rpm'

    Three may be an ellipsis, or two before a decimal that begins with a point.
    """
    text = text.replace("…", "..")
    if "..." in text:
        raise SweepError(
            "{asked}: three full stops or more can be read in two ways; write two between the ends "
            "of a range, as in 0..1, and 0.5 for .5",
            asked=asked,
        )
    return text


def _values(wanted: str, asked: str, example: str, usual: int) -> tuple[tuple[float, ...], str]:
    """The values that a text names, one by one or as a range, and their unit."""
    wanted = dotted(wanted, asked)
    if ".." not in wanted:
        parts = wanted.strip().removesuffix(",").split(",")
        values, unit = _numbers(parts, asked, example)
        if len(set(values)) < 2:
            raise SweepError(
                "{asked}: this is one value; a sweep needs two or more, {example}",
                asked=asked,
                example=example,
            )
        return tuple(values), unit
    span, *steps = _BY.split(wanted, maxsplit=1)
    if steps:
        return _stepped(span, steps[0], asked, example)
    counts = _COUNT.findall(wanted)
    if len(counts) > 1:
        raise SweepError(
            "{asked}: the number of values stands once, behind a slash at the end, as in 0..1/11; "
            "write fractions as decimals",
            asked=asked,
        )
    count = _count(counts[0], asked) if counts else usual
    ends, unit = _numbers(_COUNT.sub(" ", wanted).split("..", 1), asked, example)
    _check_ends(ends, asked)
    return tuple(np.linspace(ends[0], ends[1], count).tolist()), unit


def _stepped(span: str, step: str, asked: str, example: str) -> tuple[tuple[float, ...], str]:
    """The values of a range from its first end, a step apart, and their unit."""
    if _COUNT.search(span):
        raise SweepError(
            "{asked}: give either the number of values, as in /11, or the step between them, "
            "as in by 0.1",
            asked=asked,
        )
    (first, last, by), unit = _numbers([*span.split("..", 1), step], asked, example)
    _check_ends([first, last], asked)
    if by == 0 or (last - first) * by < 0:
        raise SweepError(
            "{asked}: steps of {step} never lead from {first} to {last}; write by {right}",
            asked=asked,
            step=f"{by:g}",
            first=f"{first:g}",
            last=f"{last:g}",
            right=f"{-by if by else (last - first) / 10:g}",
        )
    whole = (last - first) / by * (1 + 1e-12)
    if whole < 1:
        raise SweepError(
            "{asked}: the step {step} is longer than the range", asked=asked, step=f"{by:g}"
        )
    if whole >= GREATEST_POINTS:
        raise SweepError(
            "{asked}: steps of {step} make {count} values; at most {most} can be swept",
            asked=asked,
            step=f"{by:g}",
            count=f"{whole + 1:.6g}" if np.isfinite(whole) else "1e+308",
            most=GREATEST_POINTS,
        )
    values = first + by * np.arange(int(whole) + 1)
    return tuple(float(f"{value:.12g}") for value in values), unit


def _count(text: str, asked: str) -> int:
    """The number of values behind a slash. Raises SweepError."""
    count = int(text) if re.fullmatch(r"\d{1,9}", text) else 0
    if not 2 <= count <= GREATEST_POINTS:
        raise SweepError(
            "{asked}: {count} behind the slash is the number of values; give a whole number from 2 "
            "to {most}, as in 0..1/11",
            asked=asked,
            most=GREATEST_POINTS,
            count=one_line(text, longest=20),
        )
    return count


def _check_ends(ends: Sequence[float], asked: str) -> None:
    if ends[0] == ends[1]:
        raise SweepError("{asked}: the range is empty; give two ends that differ", asked=asked)


def _numbers(parts: Sequence[str], asked: str, example: str) -> tuple[list[float], str]:
    """Numbers, and the one unit that some or all of them have."""
    matches = [_NUMBER.fullmatch(part) if len(part) <= 60 else None for part in parts]
    for part, match in zip(parts, matches, strict=True):
        if match and abs(float(match[1])) > GREATEST:
            raise SweepError("{asked}: {part} is too large", asked=asked, part=seen(part.strip()))
        if not match or _NO_UNIT.match(match[2]):
            raise SweepError(
                "{asked}: {part} is not a number, with or without a unit; give values, {example}",
                asked=asked,
                part=seen(part.strip()),
                example=example,
            )
    units = dict.fromkeys(match[2] for match in matches if match and match[2])
    if len(units) > 1:
        raise SweepError(
            "{asked}: the units are {units}; give all values in one unit",
            asked=asked,
            units=", ".join(one_line(unit, longest=20) for unit in units),
        )
    return [float(match[1]) for match in matches if match], next(iter(units), "")
