"""What is asked of a family of engines."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import POSITION
from crankstar.language.messages import _
from crankstar.options import points, readers, values
from crankstar.options.refusals import RequestError, not_compiled, refusal
from crankstar.options.words import SearchWords

if TYPE_CHECKING:
    from crankstar.stars.options import SearchOptions

LEAST, MOST = 2, 14
"""Numbers of cylinders of a family; of more the search takes long."""
USUAL = (5, 6, 7, 8, 9, 10, 11, 12)
GOALS = "M1,M2"
"""What is minimised where nothing is named."""


@dataclass(frozen=True)
class ChainDrive:
    """A wider gap between the two middle cylinders, from so many cylinders up, m or pitches."""

    cylinders: int
    wider: float


def numbers_of_cylinders(text: str) -> tuple[int, ...]:
    """Numbers of cylinders: a range, or a list with commas. Raises RequestError.

    >>> numbers_of_cylinders("5..7, 9")
    (5, 6, 7, 9)
    """
    numbers: set[int] = set()
    for part in values.listed(text):
        ends = re.fullmatch(r"(\d{1,3})(?:\s*\.\.\s*(\d{1,3}))?", part)
        first, last = (int(ends[1]), int(ends[2] or ends[1])) if ends else (0, 0)
        if not LEAST <= first <= last <= MOST:
            numbers.clear()
            break
        numbers |= {*range(first, last + 1)}
    if not numbers:
        raise refusal(
            "--numbers",
            text,
            "give numbers of cylinders from {least} to {most}, as in 5..12 or 5,6,8",
            least=LEAST,
            most=MOST,
        )
    return tuple(sorted(numbers))


def firing_orders(texts: Sequence[str], *, numbers: Sequence[int]) -> tuple[tuple[int, ...], ...]:
    """Firing orders, each with all its cylinders, of these numbers. Raises RequestError."""
    orders: list[tuple[int, ...]] = []
    for text in texts:
        words = re.split(r"[-\s]+", text.strip())
        order = tuple(int(word) for word in words if re.fullmatch(r"\d{1,2}", word))
        if len(order) < len(words) or sorted(order) != list(range(1, len(order) + 1)):
            raise refusal("--given", text, "give a firing order, as in 1-7-2-5-4-3-6; repeatable")
        if len(order) not in numbers:
            raise refusal(
                "--given",
                text,
                "engines of {count} cylinders are not listed; see --numbers",
                count=len(order),
            )
        orders.append(order)
    return tuple(orders)


def chain_drive(text: str, engine: Engine, *, numbers: Sequence[int]) -> ChainDrive:
    """From how many cylinders up the middle ones are farther apart, and by how much.

    `numbers` are those of the family. Raises RequestError.
    """
    count, colon, wider = text.partition(":")
    if not colon or not re.fullmatch(r"\d{1,3}", count.strip()):
        raise refusal(
            "--chain-drive",
            text,
            "give a number of cylinders, a colon, and by how much the gap is wider, as in "
            '"9: 600 mm"',
        )
    example = _('as in "9: 600 mm"')
    wider = wider.strip()
    value = points.places("--chain-drive", [wider], [POSITION], engine, example)[0]
    if value <= 0:
        raise values.not_positive("--chain-drive", wider, POSITION)
    if int(count) < LEAST:
        raise refusal(
            "--chain-drive",
            text,
            "before the colon stands from how many cylinders up; give {least} or more, as in "
            '"9: 600 mm"',
            least=LEAST,
        )
    if int(count) > max(numbers):
        raise refusal(
            "--chain-drive",
            text,
            "no engine that is listed has so many cylinders; give a number up to {most}, or see "
            "--numbers",
            most=max(numbers),
        )
    return ChainDrive(int(count), value)


def goals(words: SearchWords) -> SearchOptions:
    """Goals and limits of the search of each engine. Raises RequestError.

    Torsion is none of them: a mode shape is that of one number of cylinders.
    """
    try:
        from crankstar.options.search import goals_of
        from crankstar.stars.faults import SearchError
    except ImportError as error:
        raise not_compiled(error) from None
    try:
        options = goals_of(words)
    except SearchError as error:
        raise RequestError(error.text(lambda option: f"--{option.replace('_', '-')}")) from None
    measures = [
        *(("--minimise", measure) for _weight, measure in options.minimise or ()),
        *(("--limit", bound.measure) for bound in options.limit),
    ]
    for option, measure in measures:
        if measure.kind == "T":
            raise refusal(
                option,
                measure.name,
                "torsion needs the mode shape of one number of cylinders, which `search` takes; "
                "leave it out",
            )
    return options


def _minimised(text: str) -> str:
    goals(SearchWords(minimise=text, best="1"))
    return text


def _limits(texts: list[str]) -> list[str]:
    goals(SearchWords(limit=texts, best="1"))
    return texts


NUMBERS = Reader("--numbers", numbers_of_cylinders, "Default: 5..12.")
FIRING_ORDERS = Reader("--given", firing_orders, beside=("numbers",))
MINIMISE = Reader("--minimise", _minimised, "As in `search`, together; default: M1,M2.")
LIMIT = Reader("--limit", _limits, "As in `search`.")
CHAIN_DRIVE = Reader("--chain-drive", chain_drive, of_source=True, beside=("numbers",))


@dataclass(frozen=True)
class Question:
    """Which numbers of cylinders, which firing orders next to the best, and best by which goals.

    Goals and limits are as typed; `first_order` is the share of the first-order moment that end
    weights make horizontal; speed in rad/s.
    """

    numbers: Annotated[Sequence[int], NUMBERS] = USUAL
    firing_orders: Annotated[Sequence[Sequence[int]], FIRING_ORDERS] = ()
    minimise: Annotated[str | None, MINIMISE] = None
    limit: Annotated[Sequence[str], LIMIT] = ()
    chain_drive: Annotated[ChainDrive | None, CHAIN_DRIVE] = None
    first_order: Annotated[float | None, readers.FIRST_ORDER] = None
    point: Annotated[str, readers.POINT] = ""
    speed: Annotated[float | None, readers.SPEED] = None

    @property
    def goals(self) -> SearchOptions:
        """Goals and limits of each search."""
        return goals(SearchWords(minimise=self.minimise, limit=[*self.limit], best="1"))

    @property
    def goal_words(self) -> str:
        """The same in words."""
        return "; ".join([self.minimise or GOALS, *self.limit])
