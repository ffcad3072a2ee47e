"""The options of a search as they are typed: one record for the command line and the API."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from crankstar.options.values import listed
from crankstar.options.vocabulary import meaning

TWIST = "twist"
"""The torsion of several orders as a goal, which chooses the firing sequence as well."""


class SearchWords(BaseModel):
    """The options of a search as they are typed."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    cycle: Literal["two-stroke", "four-stroke"] | None = Field(
        default=None,
        description=meaning("--cycle", "Default: that of the engine file, else four-stroke."),
    )
    minimise: str | None = Field(
        default=None,
        description=meaning(
            "--minimise",
            "Several with commas: couples M1, M2, ... (M1V, M1H: the external moment in the "
            "vertical, in the horizontal plane), forces F1, ..., torsion T1.5, ..., "
            "guide-force moments that twist the frame X3, ..., "
            "neighbours (cylinders side by side that fire in succession), couple (rms over a turn "
            "of the couple of orders 1, 2, 4 and 6 of an engine); else M1,M2. In a list of the "
            "best with weights, as in M1,2*M2. On the command line also twist, the largest "
            "torsion of --orders, which also chooses the firing order.",
        ),
        examples=["M1,M2"],
    )
    zero: str | None = Field(default=None, description=meaning("--zero"))
    limit: list[str] = Field(
        default=[],
        description=meaning("--limit", 'Such as M2=1.5, M1V="800 kN m" or neighbours=1.'),
    )
    gaps: str | None = Field(default=None, description=meaning("--gaps"))
    fix: str | None = Field(default=None, description=meaning("--fix"))
    symmetric: bool = Field(default=False, description=meaning("--symmetric"))
    mode_shape: str | None = Field(default=None, description=meaning("--mode-shape"))
    avoid_adjacent: bool = Field(default=False, description=meaning("--avoid-adjacent"))
    front: bool = Field(default=False, description=meaning("--front"))
    best: int | str | None = Field(default=None, description=meaning("--best"))
    all: bool = Field(default=False, description=meaning("--all"))
    all_with: str | None = Field(default=None, description=meaning("--all-with"))


@dataclass(frozen=True)
class SequenceWords:
    """The options of a front over stars and sequences beside those of every search, as typed."""

    bank: str | None = None
    crank_orders: str | None = None
    why: str | None = None
    judge: str | None = None


def sequence_options(words: SearchWords, more: SequenceWords) -> str:
    """The options that ask for star and firing sequence together, as typed; empty without any.

    >>> sequence_options(SearchWords(minimise="M1,twist"), SequenceWords(bank="90"))
    '--minimise twist, --bank'
    """
    given = {
        "--minimise twist": TWIST in listed(words.minimise or ""),
        "--bank": more.bank,
        "--orders": more.crank_orders,
        "--why": more.why,
        "--judge": more.judge,
    }
    return ", ".join(name for name, value in given.items() if value)
