"""Aims for weights in words, and their units."""

from __future__ import annotations

from typing import Any

from crankstar.language.messages import N_, _
from crankstar.remedy.aims import Aim


def aim_unit(aim: Aim) -> str:
    """The unit of an aim, for readers."""
    return {"couple": "m r ω² a", "roll": "m r² ω²"}.get(aim.quantity, "m r ω²")


def aim_name(aim: Aim) -> str:
    """The name of an aim, such as `peak couple`."""
    if aim.quantity == "bearing":
        return _("greatest load on a main bearing")
    if aim.order is not None:
        return _("roll of order {order}", order=f"{aim.order:g}")
    key = (aim.quantity, aim.up, aim.right)
    return _(_NAMES.get(key, _NAMES[aim.quantity])[aim.rms])


_NAMES: dict[Any, tuple[str, str]] = {
    "force": (N_("peak force"), N_("rms force")),
    "couple": (N_("peak couple"), N_("rms couple")),
    ("force", 1.0, 0.0): (N_("peak vertical force"), N_("rms vertical force")),
    ("couple", 1.0, 0.0): (N_("peak pitch"), N_("rms pitch")),
    ("couple", 0.0, 1.0): (N_("peak yaw"), N_("rms yaw")),
    "roll": (N_("peak roll"), N_("rms roll")),
}
