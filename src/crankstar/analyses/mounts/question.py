"""What is asked of an engine on its mounts, and what answers it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from crankstar.options import readers


@dataclass(frozen=True)
class Question:
    """At which point and speed (rad/s), over which speeds, where on the block, of which orders."""

    point: Annotated[str, readers.POINT] = ""
    speed: Annotated[float | None, readers.SPEED] = None
    speeds: Annotated[Sequence[float], readers.SPEEDS.saying("Default: those of the file.")] = ()
    at: Annotated[tuple[float, float, float] | None, readers.AT] = None
    orders: Annotated[Sequence[float] | None, readers.ORDERS.saying("Default: up to 24.")] = None
