"""What a derivation gives: records that print as documents."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from crankstar.derive import documents
from crankstar.derive.algebra.wave import Wave
from crankstar.derive.records import Quantity, Step, heading


@dataclass(frozen=True)
class Chapter:
    """Steps under a title, to be read.

    Counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None. `symbols` has the
    values of the letters that have one for this engine (lengths in bore pitches, harmonics),
    `meanings` says what letters are in this engine.
    """

    engine: str
    title: str
    harmonic: int | None
    symbols: dict[str, float]
    steps: tuple[Step, ...]
    meanings: dict[str, str] = field(default_factory=dict)

    def __str__(self) -> str:
        return documents.plain([self])

    def _repr_html_(self) -> str:
        """The chapter typeset, in a notebook."""
        return f"<style>{documents.ALIGNED}</style>{documents.html_part(self)}"


@dataclass(frozen=True)
class Derivation:
    """The derivation of one order of one quantity of an engine.

    Numbers are counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None; `scale`
    is that A_j. `symbols` has the values of all symbols but theta, lengths in bore pitches. `up`
    and `right` are the exact amplitudes, `forward` and `backward` the vectors. `why` says why
    numbers are decimals, and is empty where they are exact.
    """

    engine: str
    order: Fraction
    quantity: Quantity
    harmonic: int | None
    scale: float
    symbols: dict[str, float]
    steps: tuple[Step, ...]
    up: Wave
    right: Wave
    forward: Wave
    backward: Wave
    why: str
    meanings: dict[str, str] = field(default_factory=dict)

    def __str__(self) -> str:
        return str(self.chapter)

    @property
    def chapter(self) -> Chapter:
        """The steps under their title, `Secondary force`."""
        title = heading(self.order, self.quantity)
        return Chapter(self.engine, title, self.harmonic, self.symbols, self.steps, self.meanings)

    @property
    def zero(self) -> bool:
        """Whether nothing remains: exactly, or, in decimals, nothing that differs from zero."""
        return not self.up and not self.right

    def _repr_html_(self) -> str:
        """The derivation typeset, in a notebook."""
        return self.chapter._repr_html_()
