"""What is asked of the piston speed: the fields of the question are the options of the command."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from crankstar.engine.engine import Engine
from crankstar.options import readers
from crankstar.options.refusals import RequestError


@dataclass(frozen=True)
class Question:
    """At which speed, rad/s; None is that of the file."""

    speed: Annotated[float | None, readers.SPEED] = None


def needs(engine: Engine) -> None:
    """Refuse an engine without a stroke. Raises RequestError."""
    if "radius" in engine.relative:
        raise RequestError("piston speed needs the stroke: give cylinder.stroke in the engine file")
