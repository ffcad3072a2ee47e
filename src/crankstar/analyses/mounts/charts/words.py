"""What figures of an engine on its mounts say, and why there are none."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.analyses.mounts.figures import mounted_modes, on_mounts
from crankstar.analysis.assumptions import Answer
from crankstar.charts.canvas import shows_rests
from crankstar.charts.drawing import heading
from crankstar.charts.resting import Rests, narrowed
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.shown_units import quantity_text

NO_SPEED = N_("Without a speed nothing shakes it: give --speeds, or speed in the file.")


def about(engine: Engine, found: MountAnalysis, *, shaken: bool = True) -> list[str]:
    """Its name, and what is assumed; of what is `shaken` also by what, or by what not."""
    lines = heading(engine)
    if found.block.body.assumed and not shows_rests():
        lines.append(_("Part of the block is assumed: `crankstar mounts` names what."))
    if not shaken or found.over is None:
        return lines
    if any(each.assumed for each in found.block.mounts) and not shows_rests():
        lines.append(_("Loss factor of mounts without damping: assumed."))
    if found.over.excitation.without_gas:
        reason = found.over.excitation.without_gas.rstrip(".")
        lines.append(_("Without gas: {reason}.", reason=reason))
    if found.range_assumed:
        lines.append(_("The range of speeds is taken about the one that is known; see --speeds."))
    return lines


def place_text(point: Sequence[float]) -> str:
    """A point (up, right, z), in words.

    >>> place_text((0.1, -0.02, 0.3))
    'at 100 mm up, -20 mm to the right, 300 mm along'
    """
    up, right, along = (quantity_text(round(each * 1e3, 1) + 0.0, "mm") for each in point)
    return _("at {up} up, {right} to the right, {along} along", up=up, right=right, along=along)


def rests(engine: Engine, quantity: str = "", **options: Any) -> Rests:
    """Of a figure of the engine on its mounts: a quantity of `figures.ON_MOUNTS`, or its modes."""

    def answer(each: Engine) -> Answer:
        if not quantity:
            return mounted_modes()
        return narrowed(on_mounts(each, **options), [quantity])

    return Rests([engine], answer, "mounts")
