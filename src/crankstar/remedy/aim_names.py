"""Aims for weights in words, and their units."""

from __future__ import annotations

from typing import Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import scales
from crankstar.remedy.aims import Aim


def aim_unit(aim: Aim) -> str:
    """The unit of an aim, for readers."""
    return {"couple": "m r ω² a", "roll": "m r² ω²"}.get(aim.quantity, "m r ω²")


def aim_text(
    aim: Aim, value: float, engine: Engine, speed: float | None, *, beside: float = 0.0
) -> str:
    """A value of an aim as readers see it: in N or N m at a speed (rad/s), else in m r w^2.

    0 where it is negligible to `beside`.

    >>> from crankstar.files.catalog import load
    >>> aim_text(Aim("couple"), 0.5, load("i4"), None)
    '0.5 m r ω² a'
    """
    kind = {"couple": "couple", "roll": "moment"}.get(aim.quantity, "force")
    own, units = scales(engine, speed)
    factor = getattr(own, kind) / getattr(scales(engine, None)[0], kind)
    return quantity_text(value * factor, getattr(units, kind), beside=beside * factor)


def aim_name(aim: Aim) -> str:
    """The name of an aim, such as `peak couple`.

    >>> aim_name(Aim("couple")), aim_name(Aim("couple", up=1.0, right=0.0, order=1.0))
    ('peak couple', 'pitch of order 1')
    """
    if aim.quantity == "bearing":
        return _("greatest load on a main bearing")
    key = (aim.quantity, aim.up, aim.right)
    if aim.order is not None:
        return _(_OF_ORDER.get(key, _OF_ORDER[aim.quantity]), order=f"{aim.order:g}")
    return _(_NAMES.get(key, _NAMES[aim.quantity])[aim.rms])


_NAMES: dict[Any, tuple[str, str]] = {
    "force": (N_("peak force"), N_("rms force")),
    "couple": (N_("peak couple"), N_("rms couple")),
    ("force", 1.0, 0.0): (N_("peak vertical force"), N_("rms vertical force")),
    ("couple", 1.0, 0.0): (N_("peak pitch"), N_("rms pitch")),
    ("couple", 0.0, 1.0): (N_("peak yaw"), N_("rms yaw")),
    "roll": (N_("peak roll"), N_("rms roll")),
}
_OF_ORDER: dict[Any, str] = {
    "force": N_("force of order {order}"),
    "couple": N_("couple of order {order}"),
    ("force", 1.0, 0.0): N_("vertical force of order {order}"),
    ("force", 0.0, 1.0): N_("horizontal force of order {order}"),
    ("couple", 1.0, 0.0): N_("pitch of order {order}"),
    ("couple", 0.0, 1.0): N_("yaw of order {order}"),
    "roll": N_("roll of order {order}"),
}
