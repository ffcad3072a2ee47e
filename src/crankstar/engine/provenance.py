"""Where a value of an engine file comes from, and between which ends it may lie."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import Line, ShareOfValue, Status, Text
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen

LISTED = 4
"""Entries of a list that are quoted."""


def _numbers(value: Any) -> Any:
    """A list from the cell of a spreadsheet, numbers with commas or semicolons; others as given."""
    try:
        if isinstance(value, str):
            ends: Any = tuple(float(part) for part in value.replace(";", ",").split(","))
        elif isinstance(value, list) and any(type(part) in (str, int) for part in value):
            ends = tuple(map(float, value))
        else:
            ends = value
    except (TypeError, ValueError, OverflowError):
        raise ValueFaultError("provenance.multiples", value=_ends_text(value)) from None
    if isinstance(ends, list | tuple) and len(ends) != 2:
        raise ValueFaultError("provenance.two-ends", value=_ends_text(ends))
    return ends


def _ends_text(value: Any) -> str:
    """What stands in place of a range."""
    if not isinstance(value, list | tuple):
        return seen(value)
    more = ", ..." if len(value) > LISTED else ""
    return f"[{', '.join(map(seen, value[:LISTED]))}{more}]"


def _about_one(ends: tuple[float, float] | None) -> tuple[float, float] | None:
    """The ends of a range with the value itself between them. Raises ValueFaultError."""
    if ends is not None and not ends[0] <= 1 <= ends[1]:
        raise ValueFaultError("provenance.ends", value=f"[{ends[0]:g}, {ends[1]:g}]")
    return ends


class Provenance(Record):
    """Where a value of an engine file comes from."""

    status: Status = Field(
        description=(
            "published: read in a source; computed; unverified: from memory; placeholder: a "
            "guess; estimated: by proportions of such engines (`crankstar estimate`)"
        )
    )
    source: Text = Field(default="", description="where it was read, or how it was computed")
    range: Annotated[
        tuple[ShareOfValue, ShareOfValue] | None,
        BeforeValidator(_numbers),
        AfterValidator(_about_one),
    ] = Field(
        default=None,
        examples=[[0.8, 1.25]],
        description=(
            "of an estimated value: the lowest and the highest it may be, as multiples of it"
        ),
    )
    moves_with: Line | None = Field(
        default=None,
        description=(
            "the estimated key with which it rises and falls; `cylinder.rod`, of an inertia: two "
            "masses at the ends of the rod; by itself if left out"
        ),
    )
