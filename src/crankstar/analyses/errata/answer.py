"""What answers a question of errata."""

from __future__ import annotations

from typing import NamedTuple

from crankstar.analyses.errata.question import Question
from crankstar.derive.errata import Erratum
from crankstar.derive.errata import errata as errata_of


class Errata(NamedTuple):
    """The wrong formulas of published sources, each with the one that is derived."""

    errata: tuple[Erratum, ...]


def compute(_source: None, asked: Question) -> Errata:
    """The errata of one source, or of all."""
    return Errata(tuple(errata_of(asked.source)))
