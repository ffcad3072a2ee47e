"""What is asked of a bobweight card."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, NamedTuple

from crankstar.analysis.reader import Reader
from crankstar.options import remedies


class Card(NamedTuple):
    """The balance factor of a card; assumed if neither asked for nor in the file."""

    factor: float
    assumed: bool


@dataclass(frozen=True)
class Question:
    """The share of the reciprocating mass on each pin that is balanced; None as in the file."""

    factor: Annotated[float | None, Reader("--factor", remedies.factor)] = None
