"""What is asked of a verdict."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from crankstar.options import readers


@dataclass(frozen=True)
class Question:
    """At which speed (rad/s): by default that of the file."""

    speed: Annotated[float | None, readers.SPEED] = None
