"""What a derivation gives: records that print as documents."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from crankstar.derive import documents
from crankstar.derive.algebra.wave import Wave
from crankstar.derive.records import Quantity, Readable


@dataclass(frozen=True)
class Chapter(Readable):
    """Steps under a title, to be read."""

    def __str__(self) -> str:
        return documents.plain([self])

    def _repr_html_(self) -> str:
        """The chapter typeset, in a notebook."""
        return f"<style>{documents.ALIGNED}</style>{documents.html_parts([self])[0]}"


@dataclass(frozen=True, kw_only=True)
class Derivation(Chapter):
    """The derivation of one order of one quantity of an engine.

    Numbers are counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None; `scale`
    is that A_j. `symbols` has the values of all symbols but theta, lengths in bore pitches. `up`
    and `right` are the exact amplitudes, `forward` and `backward` the vectors. `why` says why
    numbers are decimals, and is empty where they are exact.
    """

    order: Fraction
    quantity: Quantity
    scale: float
    up: Wave
    right: Wave
    forward: Wave
    backward: Wave
    why: str

    @property
    def zero(self) -> bool:
        """Whether nothing remains: exactly, or, in decimals, nothing that differs from zero."""
        return not self.up and not self.right
