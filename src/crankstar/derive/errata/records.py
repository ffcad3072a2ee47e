"""Wrong formulas of a source, and confirmed statements, as frozen records."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal

from crankstar.derive.algebra.formula import Formula
from crankstar.language.messages import MessageError

Kind = Literal["result", "step", "series", "line", "angle"]
"""A result or a step, judged by momentum; a series of A_k; a line; an angle.

A line does not follow from the one before.
"""


class ErrataError(MessageError):
    """A question about the errata that cannot be answered, with those that can."""


@dataclass(frozen=True)
class Erratum:
    """One wrong formula of a source beside the right one.

    `text` is the formula as the source prints it, `printed` the same as a formula, or None where
    values are given at single crank angles only (`points`: degrees and value). `ours` is the right
    one: derived from the engine, or, for a `line`, what the source itself says before it. Both are
    counted in `unit`; `letter` is a length that stands in both, `scale` its value in bore pitches.
    `component` is up, right or along (a bank); `cylinders` are those it is about, none for the
    whole engine. `step` names the step of our derivation at which the source slips, `slip` says how
    it must be.
    """

    id: str
    kind: Kind
    source: str
    place: str
    title: str
    text: str
    printed: Formula | None
    ours: Formula
    slip: str
    step: str = ""
    unit: Formula | None = None
    engine: str = ""
    changes: Mapping[str, Any] = field(default_factory=dict)
    order: int = 0
    quantity: Literal["force", "couple", "roll", ""] = ""
    component: Literal["up", "right", "along", ""] = ""
    cylinders: tuple[int, ...] = ()
    letter: str = ""
    scale: float = 1.0
    points: tuple[tuple[float, Fraction], ...] = ()

    @property
    def group(self) -> str:
        """What the formulas of one sum have in common: its id without the component."""
        return self.id.removesuffix(f"-{self.component}") if self.component else self.id

    @property
    def drawn(self) -> bool:
        """Whether it is a result that a plot shows."""
        return self.kind in ("result", "series")


@dataclass(frozen=True)
class Confirmed:
    """A true statement of a source: the peak of one order, `size` in m r w^2 A_k (a)."""

    source: str
    words: str
    engine: str
    order: int
    quantity: Literal["force", "couple"]
    size: Formula
