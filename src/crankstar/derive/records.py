"""A derivation as data: steps in words, each with formulas that can be evaluated, and what each must come to."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal

from crankstar.derive.formula import Formula, Power, Symbol, product
from crankstar.derive.wave import Wave

Quantity = Literal["force", "couple"]
Kind = Literal["signal", "forward", "backward", "series", "plain"]

GREATEST_ORDER = 24
ORDINALS = {1: "first", 2: "second", 3: "third", 4: "fourth", 5: "fifth", 6: "sixth", 8: "eighth"}


class DerivationError(ValueError):
    """A derivation that cannot be given, as one sentence that says what can."""


@dataclass(frozen=True)
class Line:
    """Formulas that are equal: `name = chain[0] = chain[1] = ...`.

    A `signal` is the component along `bearing_deg` (degrees clockwise from up) of what the rows `rows` of a Balance push, at
    crank angle theta; `forward` and `backward` are vectors. Both are counted in the unit of the derivation. A `series` is an
    approximation, the powers of lambda up to a chosen one; a `plain` line is a definition, or a number of the real engine.
    `arm` is the arm of what the line is about, to be told with its label.
    """

    name: Formula | None
    chain: tuple[Formula, ...]
    kind: Kind = "plain"
    rows: tuple[int, ...] = ()
    bearing_deg: float = 0.0
    label: str = ""
    note: str = ""
    arm: Formula | None = None
    series: tuple[int, int] | None = None


@dataclass(frozen=True)
class Step:
    """What is done, in words, and the formulas."""

    title: str
    words: tuple[str, ...]
    lines: tuple[Line, ...] = ()


@dataclass(frozen=True)
class Chapter:
    """Steps under a title, to be read; counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None.

    `symbols` has the values of the letters that have one for this engine (lengths in bore pitches, harmonics), `meanings` says
    in words what letters are in this engine.
    """

    engine: str
    title: str
    harmonic: int | None
    symbols: dict[str, float]
    steps: tuple[Step, ...]
    meanings: dict[str, str] = field(default_factory=dict)

    def __str__(self) -> str:
        from crankstar.derive import documents

        return documents.plain([self])

    def _repr_html_(self) -> str:
        """The chapter typeset, in a notebook."""
        from crankstar.derive import documents

        return f"<style>{documents.ALIGNED}</style>{documents.html_part(self)}"


@dataclass(frozen=True)
class Derivation:
    """The derivation of one order of one quantity of an engine.

    Numbers are counted in `m r w^2 A_j`, j = `harmonic`, or in `m r w^2` where it is None; `scale` is that A_j. `symbols` has
    the values of all symbols but theta, lengths in bore pitches. `up` and `right` are the exact amplitudes, `forward` and
    `backward` the vectors. `why` says why numbers are decimals, and is empty where they are exact.
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
        """The steps under their title, `Second-order force`."""
        title = nth(self.order, self.quantity)
        return Chapter(self.engine, title[0].upper() + title[1:], self.harmonic, self.symbols, self.steps, self.meanings)

    @property
    def zero(self) -> bool:
        """Whether there is nothing: an exact zero, or, where numbers are decimals, nothing that can be told from zero."""
        return not self.up and not self.right

    def _repr_html_(self) -> str:
        """The derivation typeset, in a notebook."""
        return self.chapter._repr_html_()


def unit_symbol(harmonic: int | None) -> Symbol:
    """The letter for m r w^2 A_j, which each notation writes in its own way."""
    return Symbol("C", "" if harmonic is None else str(harmonic))


def unit_formula(harmonic: int | None) -> Formula:
    """In letters: m r w^2 A_k."""
    factors: list[Formula] = [Symbol("m"), Symbol("r"), Power(Symbol("omega"), 2)]
    if harmonic is not None and harmonic > 1:
        factors.append(Symbol("A", str(harmonic)))
    return product(*factors)


def ordinal(order: Fraction) -> str:
    """An order in words."""
    if order.denominator == 1:
        return ORDINALS.get(int(order), f"{int(order)}th")
    return f"order {order}"


def nth(order: Fraction, quantity: str) -> str:
    """An order of a quantity in words: `second-order force`."""
    return f"{ordinal(order)}-order {quantity}" if order.denominator == 1 else f"{quantity} of order {order}"
