"""The speeds and the pipes of a sound from the words of a command line."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import partial

from crankstar.dynamics.sound import PIPE, Ride
from crankstar.engine.quantities import LENGTH, SPEED
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.language.numbers import RPM
from crankstar.options.refusals import refusal, together
from crankstar.options.values import reading

USUAL_SPEEDS = "800..6000"
SPEEDS = (20.0, 20_000.0)
"""The least and the greatest speed, rpm."""
SECONDS = (0.2, 60.0)
"""The shortest and the longest sound."""
PIPES = (0.05, 20.0)
"""The shortest and the longest pipe, m."""


def ride(*, rpm: str | None, seconds: float | None, pipe: Sequence[str] | None) -> Ride:
    """A Ride. Raises RequestError.

    >>> there = ride(rpm="3000", seconds=2, pipe=["0.8 m", "1=60 cm"])
    >>> round(there.first), there.first == there.last, there.pipe, there.pipes
    (314, True, 0.8, {1: 0.6})
    """
    (first, last), (usual, own), lasting = together(
        partial(_speeds, USUAL_SPEEDS if rpm is None else rpm),
        partial(_pipes, pipe or ()),
        partial(_seconds, seconds),
    )
    return Ride(first, last, lasting, usual, own)


def _speeds(text: str) -> tuple[float, float]:
    """The first and the last speed, rad/s; a bare number has the unit of the last, else rpm."""
    parts = [part.strip() for part in text.replace("…", "..").split("..")]
    if len(parts) > 2 or not all(re.match(r"[-+]?\.?\d", part) for part in parts):
        raise refusal("--rpm", text, "give a speed, or two with two full stops, as in 800..6000")
    unit = units.unit_of(parts[-1]) or "rpm"
    with reading("--rpm"):
        found = [
            units.si(f"{part} {unit}" if units.is_bare(part) else part, SPEED) for part in parts
        ]
    if not all(SPEEDS[0] <= round(speed * RPM, 6) <= SPEEDS[1] for speed in found):
        least, most = (f"{speed:,.0f}" for speed in SPEEDS)
        raise refusal(
            "--rpm", text, "give speeds from {least} to {most} rpm", least=least, most=most
        )
    return found[0], found[-1]


def _seconds(seconds: float | None) -> float:
    if seconds is None:
        return Ride.seconds
    if not SECONDS[0] <= seconds <= SECONDS[1]:
        raise refusal(
            "--seconds",
            f"{seconds:g}",
            "give a number from {least} to {most}",
            least=f"{SECONDS[0]:g}",
            most=f"{SECONDS[1]:g}",
        )
    return seconds


def _pipes(texts: Sequence[str]) -> tuple[float, dict[int, float]]:
    """The length of all pipes, and those of single cylinders [m]."""
    usual: list[float] = []
    own: dict[int, float] = {}
    for text in texts:
        match = re.match(r"\s*(\d{1,4})\s*=", text)
        given = text[match.end() :] if match else text
        if units.is_bare(given):
            raise refusal(
                "--pipe", text, "write it with a unit, {example}", example=_('as in "0.8 m"')
            )
        with reading("--pipe"):
            length = units.si(given, LENGTH)
        if not PIPES[0] <= length <= PIPES[1]:
            raise refusal(
                "--pipe",
                text,
                "give a length from {least} to {most} m",
                least=f"{PIPES[0]:g}",
                most=f"{PIPES[1]:g}",
            )
        if (match and int(match[1]) in own) or (not match and usual):
            raise refusal("--pipe", text, "the length of this pipe is given twice; give it once")
        if match:
            own[int(match[1])] = length
        else:
            usual.append(length)
    return (usual[0] if usual else PIPE), own
