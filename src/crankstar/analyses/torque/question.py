"""What is asked of the torque of gas and inertia."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from crankstar.engine.engine import Engine
from crankstar.options import readers
from crankstar.options.gas import refuse_strange, refuse_together
from crankstar.options.refusals import each


@dataclass(frozen=True)
class Question:
    """At which speed (rad/s), point and load (Pa), with which cylinders, and what flywheel.

    `flywheel` in kg m^2, `irregularity` a degree (1) for which one is sized; `tangential` are loads
    (Pa) whose tangential pressures are wanted.
    """

    speed: Annotated[float | None, readers.SPEED] = None
    point: Annotated[str, readers.POINT] = ""
    imep: Annotated[float | None, readers.pressure("--imep")] = None
    bmep: Annotated[float | None, readers.pressure("--bmep")] = None
    peak_pressure: Annotated[float | None, readers.pressure("--peak-pressure")] = None
    motored: Annotated[bool, readers.flag("--motored")] = False
    off: Annotated[Sequence[int], readers.OFF] = ()
    weaker: Annotated[Sequence[tuple[int, float]], readers.WEAKER] = ()
    flywheel: Annotated[float | None, readers.FLYWHEEL] = None
    irregularity: Annotated[float | None, readers.IRREGULARITY] = None
    tangential: Annotated[Sequence[float], readers.TANGENTIAL] = ()
    orders: Annotated[
        Sequence[float] | Literal["all"] | None,
        readers.ORDERS_OR_ALL.saying("Default: those of note."),
    ] = None

    @property
    def load(self) -> dict[str, float]:
        """What says how much the cycle does, by the name of the argument of `cycle`."""
        loads = {"imep": self.imep, "bmep": self.bmep, "peak_pressure": self.peak_pressure}
        return {name: value for name, value in loads.items() if value is not None}


def refuse(engine: Engine, asked: Question) -> None:
    """Refuse what does not go together, and what the engine has not.

    Raises RequestError, OrderError, GasError.
    """
    from crankstar.mechanics.occurring_orders import check_orders

    def check_own_orders() -> None:
        if asked.orders and asked.orders != "all":
            check_orders(engine, asked.orders, gas=True)

    each(
        lambda: refuse_together(
            asked.load, motored=asked.motored, off=asked.off, weaker=asked.weaker
        ),
        lambda: refuse_strange(engine, asked),
        check_own_orders,
    )
