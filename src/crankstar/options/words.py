"""The options of a search as they are typed: one record for the command line and the API."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from crankstar.options.vocabulary import meaning


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
