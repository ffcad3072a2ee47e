"""What the verb `marine` is asked in words: shares, places, top bracings, power."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import radians

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, POSITION, POWER
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.numbers import is_number
from crankstar.options.refusals import RequestError, refusal
from crankstar.remedy.compensators import GREATEST_ORDER


def power(text: str | None) -> float | None:
    """A power above nought, W. Raises RequestError."""
    if text is None:
        return None
    with request.reading("--rated-power"):
        value = units.si(text, POWER)
    if value <= 0:
        raise request.not_positive("--rated-power", text, POWER)
    return value


def compensations(texts: Sequence[str] | None, engine: Engine) -> dict[int, tuple[float, ...]]:
    """The places of the compensators of each order, as in "2: 6 m, -6 m". Raises RequestError."""
    found: dict[int, tuple[float, ...]] = {}
    for text in texts or ():
        order, colon, places = text.partition(":")
        parts = request.listed(places)
        if not colon or not re.fullmatch(r"\d{1,3}", order.strip()) or not parts:
            raise refusal(
                "--compensate",
                text,
                "give the order, a colon, and one place or two along the crankshaft, as in "
                '"2: 6 m, -6 m"',
            )
        if not 1 <= int(order) <= GREATEST_ORDER:
            raise refusal(
                "--compensate",
                text,
                "compensators are made for orders 1 to {greatest}",
                greatest=GREATEST_ORDER,
            )
        example, marks = _('as in "2: 6 m, -6 m"'), [POSITION] * len(parts)
        where = request.places("--compensate", parts, marks, engine, example)
        if len(where) > 2 or len(set(where)) < len(where):
            raise refusal("--compensate", text, "give one place or two that differ")
        if int(order) in found:
            raise refusal("--compensate", text, "give each order once, with one place or two")
        found[int(order)] = tuple(where)
    return found


def refuse_unused(
    compensate: Sequence[str] | None,
    first_order: str | None,
    phase_error: str | None,
    save: str | None,
) -> None:
    """Refuse a lag of no compensator, and an engine to which nothing is added."""
    if not compensate:
        request.refuse_unused({"--phase-error": phase_error}, without="--compensate")
    if save is not None and not compensate and first_order is None:
        raise RequestError(
            "--save writes the engine with what is added to it: give --first-order or --compensate"
        )


def node(text: str | None, engine: Engine) -> float | None:
    """The place of a node along the crankshaft. Raises RequestError."""
    if text is None:
        return None
    return request.places("--node", [text.strip()], [POSITION], engine, _('as in "-25 m"'))[0]


def bracing(text: str | None) -> tuple[float, float] | None:
    """Height of the top bracings, and the distance of their two planes, m. Raises RequestError."""
    if text is None:
        return None
    parts = request.listed(text)
    if len(parts) != 2:
        raise refusal(
            "--bracing",
            text,
            "give the height over the crankshaft and the distance of the two planes of bracing, as "
            'in "5.2 m, 8 m"',
        )
    with request.reading("--bracing"):
        height, apart = (units.si(part, LENGTH) for part in parts)
    for part, value in zip(parts, (height, apart), strict=True):
        if value <= 0:
            raise request.not_positive("--bracing", part, LENGTH)
    return height, apart


def phase_error(text: str | None) -> float:
    """By how much compensators come late, radians of their own turn. Raises RequestError."""
    if text is None:
        return 0.0
    angles = request.degrees("--phase-error", text)
    if len(angles) > 1 or not is_number(angles[0]) or abs(angles[0]) > 180:
        raise refusal("--phase-error", text, "give one angle up to 180 deg")
    return radians(angles[0])
