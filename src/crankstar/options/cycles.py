"""Whether what is given as a cycle is one, and one of the engine that is given beside it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted
from crankstar.language.quoting import seen

if TYPE_CHECKING:
    from crankstar.mechanics.gas import Cycle

SAME = 1e-9
"""Share by which the chambers of a cycle may differ from those of the engine: rounding."""


def check_cycle(function: str, arguments: Mapping[str, Any]) -> None:
    """Raises TypeError for a cycle that is none, ValueError for one of other chambers.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> check_cycle("driven", {"engine": five, "cycle": cycle(five)})
    """
    if "cycle" not in arguments:
        return
    from crankstar.mechanics.gas import Cycle  # no gas is loaded without a cycle

    engine, cycle = arguments.get("engine"), arguments["cycle"]
    if not isinstance(cycle, Cycle):
        raise TypeError(
            _(
                "{function} takes a Cycle, as crankstar.cycle gives it, not {given}",
                function=function,
                given=f"Engine {seen(cycle.name)}" if isinstance(cycle, Engine) else quoted(cycle),
            )
        )
    if isinstance(engine, Engine) and not _of_engine(cycle, engine):
        raise ValueError(
            _(
                "{function}: the cycle is of an engine whose chambers are not those of {engine}; "
                "give crankstar.cycle of this engine",
                function=function,
                engine=seen(engine.name),
            )
        )


def _of_engine(cycle: Cycle, engine: Engine) -> bool:
    """Whether the chambers of an engine are those of a cycle: numbers, times and volumes."""
    import numpy as np

    from crankstar.mechanics.gas import check_gas
    from crankstar.mechanics.pressures import volumes_of

    check_gas(engine)
    own, other = volumes_of(engine), cycle.volumes
    if (own.numbers, own.kind, own.cycle) != (other.numbers, other.kind, other.cycle):
        return False
    pairs = ((own.fires, other.fires), (own.rate, other.rate))
    return all(np.allclose(a, b, rtol=SAME, atol=SAME * np.abs(b).max()) for a, b in pairs)
