"""The same engine with other values in every record: leaning, in the mirror, heavier."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder

Update = Callable[[Any], dict[str, Any]]


def unchanged(_: Any) -> dict[str, Any]:
    return {}


def remade(
    engine: Engine,
    *,
    shaft: Update = unchanged,
    throw: Update = unchanged,
    weight: Update = unchanged,
    cylinder: Update = unchanged,
    **own: Any,
) -> Engine:
    """A copy with other fields in every record of a kind."""
    shafts = tuple(
        s.model_copy(
            update={
                "throws": tuple(t.model_copy(update=throw(t)) for t in s.throws),
                "weights": tuple(w.model_copy(update=weight(w)) for w in s.weights),
                **shaft(s),
            }
        )
        for s in engine.shafts
    )
    cylinders = tuple(c.model_copy(update=cylinder(c)) for c in engine.cylinders)
    return engine.model_copy(update={"shafts": shafts, "cylinders": cylinders, **own})


def carried(up: float, right: float, bearing: float) -> dict[str, float]:
    """A place after the whole engine has turned clockwise by an angle about the crank axis."""
    place = complex(up, right) * np.exp(1j * bearing)
    return {"up": place.real, "right": place.imag}


def turned_in_space(engine: Engine, bearing: float) -> Engine:
    """The whole engine, turned clockwise by an angle about the axis of the reference point."""
    return remade(
        engine,
        shaft=lambda s: carried(s.up, s.right, bearing),
        throw=lambda t: {"angle": t.angle + bearing},
        weight=lambda w: {"angle": w.angle + bearing},
        cylinder=lambda c: {"bearing": c.bearing + bearing},
    )


def opposite(engine: Engine) -> str:
    return "counter-clockwise" if engine.rotation == "clockwise" else "clockwise"


def mirrored(engine: Engine) -> Engine:
    """Left and right exchanged."""

    def other_side(c: Cylinder) -> dict[str, Any]:
        link = c.articulated and c.articulated.model_copy(update={"angle": -c.articulated.angle})
        return {"bearing": -c.bearing, "offset": -c.offset, "articulated": link}

    return remade(
        engine,
        shaft=lambda s: {"right": -s.right},
        throw=lambda t: {"angle": -t.angle},
        weight=lambda w: {"angle": -w.angle},
        cylinder=other_side,
        rotation=opposite(engine),
    )
