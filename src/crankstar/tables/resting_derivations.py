"""What the newtons of a derivation rest on, as its last step; of it the gravest in the first."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from crankstar.derive.records import Quantity, Readable, Step
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.excitation import Reference
from crankstar.studies.answer_parts import narrowed
from crankstar.studies.answers import amplitudes, rests_on
from crankstar.tables.assumptions import assumption_lines

Chapter = TypeVar("Chapter", bound=Readable)
FIGURES: dict[Quantity, str] = {"force": "force", "couple": "couple", "torque": "roll"}
"""What an analysis calls a derived quantity; the block rolls by the reaction to the torque."""


def with_record(
    chapter: Chapter,
    engine: Engine,
    *,
    order: Fraction,
    quantity: Quantity,
    speed: float | None = None,
    reference: Reference | None = None,
) -> Chapter:
    """The chapter of an order with what its newtons rest on; as it is where it has none.

    At `speed` (rad/s), else at that of the file; couples about `reference`.

    >>> from crankstar.derive import derivation
    >>> from crankstar.files.catalog import load
    >>> five = load("audi-25-tfsi")
    >>> bare = derivation(five, 1, "couple")
    >>> whole = with_record(bare, five, order=Fraction(1), quantity="couple")
    >>> whole.steps[-1].words[0].partition(":")[0]
    'cylinder.rotating_mass'
    >>> whole.steps[0].words[0].partition(" no ")[0]
    'What matters most for its numbers: cylinder.rotating_mass:'
    """
    needed = {"mass", "radius", *(["pitch"] if quantity == "couple" else [])}
    turning = engine.speed if speed is None else speed
    if turning is None or needed & {*engine.relative}:
        return chapter
    whole = amplitudes(
        engine, speed=speed, gas=True, reference=reference, highest=max(float(order), 1.0)
    )
    answer = narrowed(whole, [FIGURES[quantity]], orders=[float(order)])
    lines = assumption_lines(rests_on(engine, answer))
    if not lines:
        return chapter
    first, *others = chapter.steps
    gravest = _("What matters most for its numbers: {line}", line=lines[0])
    first = replace(first, words=(gravest, *first.words))
    last = Step(_("What it rests on"), tuple(lines))
    return replace(chapter, steps=(first, *others, last))
