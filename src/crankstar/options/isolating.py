"""The options of `crankstar isolate` as they are typed, and the best mounts that they ask for."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast, get_args

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, SPEED, Quantity
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.refusals import refusal

if TYPE_CHECKING:
    from crankstar.remedy.isolation import IsolationAim

STIFFNESS = Quantity("stiffness", "200 N/mm")
WIDEST = 1e4
"""The greatest over the least stiffness: beyond it nothing is gained."""
LARGEST = 10.0
"""Metres: places are not moved further."""
GREATEST_STARTS = 64
TURN = 6.283185307179586


def aim(text: str) -> IsolationAim:
    """What is minimised. Raises RequestError."""
    from crankstar.remedy.isolation import IsolationAim

    words = " ".join(text.split())
    return cast("IsolationAim", request.choice("--minimise", words, get_args(IsolationAim)))


def refuse_unused(goal: str, *, at: str | None, speeds: str | None, point: str | None) -> None:
    """Refuse a point of the block, or speeds and gas, that do not matter. Raises RequestError."""
    aim = " ".join(goal.split())
    if not aim.endswith("velocity"):
        why = _("The goal is {goal}, not the velocity of a point: see --minimise.", goal=aim)
        request.refuse_unused({"--at": at}, why=why)
    if aim == "roll":
        why = _("The share of roll in a natural mode is the same at any speed and load.")
        request.refuse_unused({"--speeds": speeds, "--point": point}, why=why)


def stiffness(text: str | None) -> tuple[float, float] | None:
    """N/m, the least above nought. Raises RequestError."""
    if text is None:
        return None
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


def frequencies(text: str | None) -> tuple[float, float] | None:
    """Hertz; the lower end may be nought. Raises RequestError."""
    if text is None:
        return None
    low, high = (end / TURN for end in _range("--frequencies", text, SPEED, "5..15 Hz"))
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


def shift(text: str | None, engine: Engine) -> tuple[float, float, float]:
    """Metres each way: up, right, z; noughts without. Raises RequestError."""
    if text is None:
        return 0.0, 0.0, 0.0
    example = _('as in "30 mm" or "0 mm, 20 mm, 30 mm" (z, up, right)')
    parts = [part.strip() for part in text.split(",")]
    if len(parts) not in (1, 3):
        raise refusal(
            "--shift", text, "give one length, or z, up and right, {example}", example=example
        )
    sizes = request.places("--shift", parts, [LENGTH] * len(parts), engine, example)
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
