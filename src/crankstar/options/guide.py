"""What the verb `guide` is asked in words: numbers of cylinders, firing orders, a wider gap."""

from __future__ import annotations

import re
from collections.abc import Sequence

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import POSITION
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, refusal
from crankstar.options.search import goals_of
from crankstar.options.words import SearchWords
from crankstar.search.faults import SearchError
from crankstar.search.options import SearchOptions
from crankstar.studies.engine_family import LEAST, MOST, ChainDrive


def numbers_of_cylinders(text: str | None) -> tuple[int, ...]:
    """Numbers of cylinders: a range, or a list with commas. Raises RequestError.

    >>> numbers_of_cylinders("5..7, 9")
    (5, 6, 7, 9)
    """
    found: set[int] = set()
    for part in request.listed("5..12" if text is None else text):
        ends = re.fullmatch(r"(\d{1,3})(?:\s*\.\.\s*(\d{1,3}))?", part)
        first, last = (int(ends[1]), int(ends[2] or ends[1])) if ends else (0, 0)
        if not LEAST <= first <= last <= MOST:
            found.clear()
            break
        found |= {*range(first, last + 1)}
    if not found:
        raise refusal(
            "--numbers",
            text or "",
            "give numbers of cylinders from {least} to {most}, as in 5..12 or 5,6,8",
            least=LEAST,
            most=MOST,
        )
    return tuple(sorted(found))


def firing_orders(
    texts: Sequence[str] | None, numbers: Sequence[int]
) -> tuple[tuple[int, ...], ...]:
    """Firing orders, each with all its cylinders, of these numbers. Raises RequestError."""
    found: list[tuple[int, ...]] = []
    for text in texts or ():
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
        found.append(order)
    return tuple(found)


def goals(words: SearchWords) -> SearchOptions:
    """Goals and limits of the search of each engine. Raises RequestError.

    Torsion is none of them: a mode shape is that of one number of cylinders.
    """
    try:
        found = goals_of(words)
    except SearchError as error:
        raise RequestError(error.text(lambda option: f"--{option.replace('_', '-')}")) from None
    measures = [
        *(("--minimise", measure) for _weight, measure in found.minimise or ()),
        *(("--limit", bound.measure) for bound in found.limit),
    ]
    for option, measure in measures:
        if measure.kind == "T":
            raise refusal(
                option,
                measure.name,
                "torsion needs the mode shape of one number of cylinders, which `search` takes; "
                "leave it out",
            )
    return found


def chain_drive(text: str | None, engine: Engine, numbers: Sequence[int]) -> ChainDrive | None:
    """From how many cylinders up the middle ones are farther apart, and by how much.

    `numbers` are those of the family. Raises RequestError.
    """
    if text is None:
        return None
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
    value = request.places("--chain-drive", [wider], [POSITION], engine, example)[0]
    if value <= 0:
        raise request.not_positive("--chain-drive", wider, POSITION)
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
