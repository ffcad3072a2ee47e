"""What a result rests on, as Python prints it: a sentence each, as on the command line.

>>> import crankstar
>>> crankstar.balance("i4", units="relative").rests_on[-1]
Unverified: firing_order.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields

from crankstar.analysis.assumptions import Assumption


@dataclass(frozen=True, repr=False)
class Told(Assumption):
    """An assumption that prints as its sentence.

    >>> Told("assumed", "gas.gamma", "usual for such engines", 1.3)
    Assumed: gas.gamma (1.3).
    """

    def __repr__(self) -> str:
        from crankstar.tables.assumptions import assumption_sentence

        return assumption_sentence(self)


class RestsOn(tuple[Told, ...]):
    """The assumptions of a result, what matters most first; a line each where they are printed.

    >>> RestsOn([Told("assumed", "gas.gamma", "usual"), Told("missing", "gas", "usual")])
    Assumed: gas.gamma.
    Not in the file, counted as zero: gas.
    """

    __slots__ = ()

    def __repr__(self) -> str:
        return "\n".join(map(repr, self)) if self else "()"

    def _repr_html_(self) -> str:
        from crankstar.tables.html import paragraph

        return "".join(paragraph(repr(each)) for each in self)


def told(found: Iterable[Assumption]) -> RestsOn:
    """Assumptions that print as sentences.

    >>> told([Assumption("missing", "gas", "usual")])
    Not in the file, counted as zero: gas.
    """
    return RestsOn(
        Told(**{each.name: getattr(own, each.name) for each in fields(Assumption)}) for own in found
    )
