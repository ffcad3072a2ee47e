"""What is asked of a marine engine."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from math import radians
from typing import Annotated, Any, Literal

from crankstar.analyses.marine.compensators import GREATEST_ORDER
from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, POSITION, POWER
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted
from crankstar.options import numbers, points, readers, values
from crankstar.options.numbers import check_number, check_place, is_number
from crankstar.options.refusals import RequestError, refusal, refuse_unused


def power(text: str) -> float:
    """A power above zero, W. Raises RequestError."""
    return values.positive("--rated-power", text, quantity=POWER)


def compensations(texts: Sequence[str], engine: Engine) -> dict[int, tuple[float, ...]]:
    """Positions of the compensators of each order, as in "2: 6 m, -6 m". Raises RequestError."""
    positions: dict[int, tuple[float, ...]] = {}
    for text in texts:
        order, colon, listed = text.partition(":")
        parts = values.listed(listed)
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
        where = points.places("--compensate", parts, marks, engine, example)
        if len(where) > 2 or len(set(where)) < len(where):
            raise refusal("--compensate", text, "give one place or two that differ")
        if int(order) in positions:
            raise refusal("--compensate", text, "give each order once, with one place or two")
        positions[int(order)] = tuple(where)
    return positions


def phase_error(text: str) -> float:
    """By how much compensators come late, radians of their own revolution. Raises RequestError."""
    angles = values.degrees("--phase-error", text)
    if len(angles) > 1 or not is_number(angles[0]) or abs(angles[0]) > 180:
        raise refusal("--phase-error", text, "give one angle up to 180 deg")
    return radians(angles[0])


def node(text: str, engine: Engine) -> float:
    """The position of a node along the crankshaft. Raises RequestError."""
    return points.places("--node", [text.strip()], [POSITION], engine, _('as in "-25 m"'))[0]


def bracing(text: str) -> tuple[float, float]:
    """Height of the top bracings, and the distance of their two planes, m. Raises RequestError."""
    parts = values.listed(text)
    if len(parts) != 2:
        raise refusal(
            "--bracing",
            text,
            "give the height over the crankshaft and the distance of the two planes of bracing, as "
            'in "5.2 m, 8 m"',
        )
    with values.reading("--bracing"):
        height, apart = (units.si(part, LENGTH) for part in parts)
    for part, value in zip(parts, (height, apart), strict=True):
        if value <= 0:
            raise values.not_positive("--bracing", part, LENGTH)
    return height, apart


def positions(given: Any, engine: Engine) -> dict[int, tuple[float, ...]]:
    """Positions of the compensators of each order, of Python: numbers, or text with a unit.

    Numbers are metres, of an engine without a bore pitch bore pitches.

    Raises TypeError for what is no dict of places by order, RequestError for wrong ones.

    >>> from crankstar.files.catalog import load
    >>> positions({2: [3.0, "-3"]}, load("man-s90mc-c"))
    {2: (3.0, -3.0)}
    """
    whole = isinstance(given, Mapping) and all(
        isinstance(order, int) and not isinstance(order, bool) for order in given
    )
    listed = whole and all(isinstance(each, Iterable) for each in given.values())
    if not listed:
        raise TypeError(
            _(
                "{argument} takes orders with places along the shaft, such as {example}, not "
                "{given}",
                argument="compensate",
                example="{2: [6.0, -6.0]}",
                given=quoted(given),
            )
        )
    unit = "" if "pitch" in engine.relative else " m"
    texts: list[str] = []
    for order, places in given.items():
        each = [places] if isinstance(places, str) else [*places]
        for place in each:
            if not isinstance(place, str):
                check_place("compensate", place)
        parts = [place if isinstance(place, str) else f"{float(place)!r}{unit}" for place in each]
        texts.append(f"{order}: {', '.join(parts)}")
    return compensations(texts, engine)


def late(given: Any) -> float:
    """By how much compensators come late, radians. Raises TypeError, ValueError."""
    check_number("phase_error", given)
    return float(given)


def along(given: Any, _engine: Engine) -> float:
    """A place along the crankshaft, m. Raises TypeError, ValueError."""
    check_place("node", given)
    return float(given)


SPEEDS = readers.SPEEDS.saying("External moments go with its square.")
RATED_POWER = Reader("--rated-power", power, number=partial(numbers.power, "rated_power"))
COMPENSATE = Reader("--compensate", compensations, of_source=True, number=positions)
PHASE_ERROR = Reader("--phase-error", phase_error, number=late)
NODE = Reader("--node", node, of_source=True, number=along)
BRACING = Reader("--bracing", bracing)
ORDERS = readers.ORDERS_OR_ALL.saying("Of both tables. Default: those of note.")


@dataclass(frozen=True)
class Question:
    """At which point, speed and speeds (rad/s), against which power (W), with what added.

    `first_order` is the share of the first-order moment that end weights make horizontal;
    `compensate` has the positions z of compensators by order, `phase_error` (rad) by how much these
    come late; `node` is the z about which moments are wanted too; `bracing` the height of top
    bracings and the distance of their planes, m.
    """

    point: Annotated[str, readers.POINT] = ""
    speed: Annotated[float | None, readers.SPEED] = None
    speeds: Annotated[Sequence[float], SPEEDS] = ()
    rated_power: Annotated[float | None, RATED_POWER] = None
    first_order: Annotated[float | None, readers.FIRST_ORDER] = None
    compensate: Annotated[Mapping[int, Sequence[float]] | None, COMPENSATE] = None
    phase_error: Annotated[float | None, PHASE_ERROR] = None
    node: Annotated[float | None, NODE] = None
    bracing: Annotated[tuple[float, float] | None, BRACING] = None
    orders: Annotated[Sequence[float] | Literal["all"] | None, ORDERS] = None


def refuse(_engine: Engine, question: Question) -> None:
    """Refuse a lag of no compensator. Raises RequestError."""
    if not question.compensate and question.phase_error is not None:
        refuse_unused({"--phase-error": True}, without="--compensate")


def refuse_unchanged(question: Question) -> None:
    """Refuse to save an engine to which nothing is added. Raises RequestError."""
    if not question.compensate and question.first_order is None:
        raise RequestError(
            "--save writes the engine with what is added to it: give --first-order or --compensate"
        )
