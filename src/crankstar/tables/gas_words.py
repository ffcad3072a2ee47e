"""What does not burn in a cycle, in words and for machines."""

from __future__ import annotations

from crankstar.language.messages import _
from crankstar.language.numbers import number, numbers_text
from crankstar.mechanics.gas import Cycle


def burning_words(title: str, cycle: Cycle) -> str:
    """A title with the cylinders that burn nothing, or less than the others."""
    if cycle.off:
        off = numbers_text(cycle.off)
        title = _("{title}, without combustion in {numbers}", title=title, numbers=off)
    for cylinder, lost in cycle.weaker.items():
        share = number(100 * lost, digits=3)
        title = _(
            "{title}, cylinder {number} weak by {share} %",
            title=title,
            number=cylinder,
            share=share,
        )
    return title


def weaker_facts(cycle: Cycle | None) -> dict[str, float]:
    """The share that each weak chamber lacks, by its number as text."""
    return {} if cycle is None else {str(key): share for key, share in cycle.weaker.items()}
