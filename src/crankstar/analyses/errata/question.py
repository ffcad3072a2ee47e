"""What is asked of errata: of which source."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from crankstar.analysis.reader import Reader


def _source(text: str) -> str:
    """The name of a source. Raises RequestError."""
    from crankstar.derive.errata import sources
    from crankstar.options.values import choice

    return choice("--source", text, sources())


@dataclass(frozen=True)
class Question:
    """Of which source; None of all."""

    source: Annotated[str | None, Reader("--source", _source)] = None
