"""What is asked of mounts: what is minimised, and the limits within which it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import tau
from typing import Annotated, get_args

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, SPEED, STIFFNESS, Quantity
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.options import points, readers
from crankstar.options import values as request
from crankstar.options.ranges import speeds_of
from crankstar.options.refusals import refusal, refuse_unused

WIDEST = 1e4
"""The greatest over the least stiffness: beyond it nothing is gained."""
LARGEST = 10.0
"""Metres: places are not moved further."""
GREATEST_STARTS = 64
MINIMISE = (
    "force (on the ground), mounts (the forces of all) or velocity (of the point): the greatest "
    "over the speeds; each also with rms in front; or roll (what is not roll in the mode of roll)."
)


def _aim(text: str) -> str:
    """What is minimised. Raises RequestError."""
    from crankstar.analyses.isolate.isolation import IsolationAim

    return request.choice("--minimise", " ".join(text.split()), get_args(IsolationAim))


def _stiffness(text: str) -> tuple[float, float]:
    """N/m, the least above zero. Raises RequestError."""
    low, high = _range("--stiffness", text, STIFFNESS, "50..400 N/mm")
    if not 0 < low < high <= WIDEST * low:
        raise refusal(
            "--stiffness",
            text,
            "give two stiffnesses above 0, the lower one first, at most {most} times apart, as in "
            "50..400 N/mm",
            most=f"{WIDEST:g}",
        )
    return low, high


def _frequencies(text: str) -> tuple[float, float]:
    """Hertz; the lower end may be zero. Raises RequestError."""
    low, high = (end / tau for end in _range("--frequencies", text, SPEED, "5..15 Hz"))
    if not 0 <= low < high:
        raise refusal(
            "--frequencies", text, "give two frequencies, the lower one first, as in 5..15 Hz"
        )
    return low, high


def _range(option: str, text: str, quantity: Quantity, example: str) -> tuple[float, float]:
    """Both ends in SI; the unit is that of the last."""
    low, dots, high = (part.strip() for part in text.partition(".."))
    if not dots or not low or not high or units.is_bare(high):
        raise refusal(option, text, "give a range with its unit, as in {example}", example=example)
    if units.is_bare(low):
        low = f"{low} {units.unit_of(high)}"
    with request.reading(option):
        return units.si(low, quantity), units.si(high, quantity)


def _shift(text: str, engine: Engine) -> tuple[float, float, float]:
    """Metres each way: up, right, z. Raises RequestError."""
    example = _('as in "30 mm" or "0 mm, 20 mm, 30 mm" (z, up, right)')
    parts = [part.strip() for part in text.split(",")]
    if len(parts) not in (1, 3):
        raise refusal(
            "--shift", text, "give one length, or z, up and right, {example}", example=example
        )
    sizes = points.places("--shift", parts, [LENGTH] * len(parts), engine, example)
    if not all(0 <= size <= LARGEST for size in sizes) or not any(sizes):
        raise refusal(
            "--shift",
            text,
            "give how far a mount may be moved each way, up to {most} m, {example}",
            most=f"{LARGEST:g}",
            example=example,
        )
    along, up, right = sizes * 3 if len(sizes) == 1 else sizes
    return up, right, along


def _sag(text: str, engine: Engine) -> float | None:
    """Metres. Raises RequestError."""
    return points.length("--sag", text, engine, positive=True)


@dataclass(frozen=True)
class Question:
    """What is minimised, within which limits, in which state, at which point, from how many starts.

    Limits as in `MountLimits`: N/m, m each way (up, right, z), m, Hz. Speeds in rad/s; `at` is a
    point of the block (up, right, z; m).
    """

    minimise: Annotated[str, Reader("--minimise", _aim, MINIMISE)] = "force"
    stiffness: Annotated[tuple[float, float] | None, Reader("--stiffness", _stiffness)] = None
    shift: Annotated[tuple[float, float, float], Reader("--shift", _shift, of_source=True)] = (
        0.0,
        0.0,
        0.0,
    )
    sag: Annotated[float | None, Reader("--sag", _sag, of_source=True)] = None
    frequencies: Annotated[tuple[float, float] | None, Reader("--frequencies", _frequencies)] = None
    point: Annotated[str, readers.POINT] = ""
    speeds: Annotated[
        Sequence[float],
        Reader("--speeds", partial(speeds_of, beside_speed=False), "Default: those of the file."),
    ] = ()
    at: Annotated[tuple[float, float, float] | None, readers.AT] = None
    starts: Annotated[int | None, readers.count("--starts", GREATEST_STARTS, "Default: 6.")] = None


def refuse(engine: Engine, question: Question) -> None:
    """Refuse a point of the block, or speeds and gas, that do not matter. Raises RequestError."""
    del engine
    aim = question.minimise
    if not aim.endswith("velocity"):
        why = _("The goal is {goal}, not the velocity of a point: see --minimise.", goal=aim)
        refuse_unused({"--at": question.at}, why=why)
    if aim == "roll":
        why = _("The share of roll in a natural mode is the same at any speed and load.")
        speeds, point = [*question.speeds], question.point or None
        refuse_unused({"--speeds": speeds, "--point": point}, why=why)
