"""What is asked of torsional vibration, and what answers it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.options import readers
from crankstar.options.gas import refuse_together
from crankstar.options.refusals import RequestError

MOST_MODES = 300


@dataclass(frozen=True)
class Question:
    """At which point and speed (rad/s), over which speeds, of which orders, of how many modes.

    `holzer` is the mode whose table is wanted. Cylinders may be off or lack a share of their
    combustion.
    """

    point: Annotated[str, readers.POINT] = ""
    speed: Annotated[float | None, readers.SPEED] = None
    speeds: Annotated[Sequence[float], readers.SPEEDS.saying("Default: those of the file.")] = ()
    orders: Annotated[Sequence[float] | None, readers.ORDERS.saying("Default: up to 24.")] = None
    modes: Annotated[int | None, readers.count("--modes", MOST_MODES, "Default: 4.")] = None
    holzer: Annotated[int | None, readers.count("--holzer", MOST_MODES)] = None
    off: Annotated[Sequence[int], readers.OFF] = ()
    weaker: Annotated[Sequence[tuple[int, float]], readers.WEAKER] = ()


def refuse(source: Engine | Chain, asked: Question) -> None:
    """Refuse orders of a drive line without a speed, cylinders both off and weaker.

    Raises RequestError.
    """
    refuse_together(off=asked.off, weaker=asked.weaker)
    is_chain = isinstance(source, Chain)
    if is_chain and asked.orders and not len(asked.speeds) and source.speed is None:
        raise RequestError(
            "--orders: a drive line without a speed has critical speeds in a range alone; give "
            '--speeds, such as "300..3000 rpm by 10"'
        )
