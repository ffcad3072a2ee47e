"""What is asked of the loads on bearings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, cast, get_args

from crankstar.analysis.reader import Reader
from crankstar.dynamics.bearings import Model
from crankstar.engine.engine import Engine
from crankstar.options import readers, values
from crankstar.options.refusals import choice


def _model(text: str) -> Model:
    return cast("Model", choice("--model", text, get_args(Model)))


def _orders(text: str, engine: Engine, *, gas: bool, point: str | None, off: Sequence[int]) -> str:
    values.refuse_foreign(text, [engine], gas=gas or point is not None or bool(off))
    return text


POINT = readers.POINT.saying("With --gas.")
MODEL = Reader("--model", _model)
ORDERS = Reader(
    "--orders",
    _orders,
    "Default: those up to 6 that occur.",
    of_source=True,
    beside=("gas", "point", "off"),
)


@dataclass(frozen=True)
class Question:
    """At which speed (rad/s), with the gas of which point, by which model of the crankshaft.

    `off` are cylinders that do not fire; `orders` are as typed, since those of an engine are read
    as they are printed. A point and cylinders that are off have gas too.
    """

    speed: Annotated[float | None, readers.SPEED] = None
    gas: Annotated[bool, readers.flag("--gas")] = False
    point: Annotated[str | None, POINT] = None
    off: Annotated[Sequence[int], readers.OFF] = ()
    model: Annotated[Model, MODEL] = "determinate"
    orders: Annotated[str | None, ORDERS] = None

    @property
    def burning(self) -> bool:
        """Whether the loads have those of the gas."""
        return self.gas or self.point is not None or bool(self.off)
