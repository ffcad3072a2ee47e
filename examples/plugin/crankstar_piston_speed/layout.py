"""A layout of engine files: cylinders in a row on throws that wind round the shaft."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from crankstar.engine.banks import BorePitch
from crankstar.engine.basis import Basis
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.engine.quantities import Angle


def helix(
    basis: Basis,
    *,
    cylinders: Annotated[int, Field(ge=1, le=24, description="how many stand in the row")],
    step: Annotated[Angle, Field(description="from each throw to the next, clockwise")],
    bore_pitch: BorePitch = None,
) -> Engine:
    """Cylinders 1, 2, ... in a row, each throw turned from the one before by the same angle."""
    throws = tuple(step * place for place in range(cylinders))
    return inline(basis, throws=throws, bore_pitch=bore_pitch)
