"""The options of a search as they are typed: one record for the command line and the API."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field


class SearchWords(BaseModel):
    """The options of a search as they are typed."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    cycle: Literal["two-stroke", "four-stroke"] | None = Field(
        default=None,
        description=(
            "Working cycle, four-stroke or two-stroke (default: that of the engine file, else "
            "four-stroke)."
        ),
    )
    minimise: str | None = Field(
        default=None,
        description="Quantities to minimise: couples M1, M2, ..., forces F1, ..., torsion T1.5, "
        "..., neighbours (cylinders side by side that fire in succession), couple (rms over a "
        "turn of the couple of orders 1, 2, 4 and 6 of an engine); else M1,M2. In a list of the "
        "best with weights, as in M1,2*M2.",
        examples=["M1,M2"],
    )
    zero: str | None = Field(default=None, description="Quantities that must vanish, as in M2.")
    limit: list[str] = Field(
        default=[], description="Greatest value of a quantity, as in M2=1.5 or neighbours=1."
    )
    pitch: str | None = Field(
        default=None,
        description="Gaps between cylinders from the front in pitches, as in 1,1,1.4; else equal.",
    )
    fix: str | None = Field(
        default=None,
        description="Fixed throws, as in 1=0,4=3: direction d is 360 d/n deg behind direction 0.",
    )
    symmetric: bool = Field(
        default=False, description="Only cranks whose rear half mirrors the front half."
    )
    mode_shape: str | None = Field(
        default=None, description="For torsion: amplitude of the mode at each cylinder."
    )
    avoid_adjacent: bool = Field(
        default=False, description="No cylinders side by side fire in succession."
    )
    front: bool = Field(
        default=False,
        description=(
            "The Pareto front: the stars in which one quantity can improve only at the expense "
            "of another."
        ),
    )
    best: int | str | None = Field(default=None, description="List this many of the best stars.")
    all: bool = Field(default=False, description="All stars within the limits.")
    all_with: str | None = Field(
        default=None,
        description="All stars with the same moments as a firing order, as in 1-6-3-4-5-2-7, or "
        "with values, as in M1=0.2673,M2=1.0056.",
    )
