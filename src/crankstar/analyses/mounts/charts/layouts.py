"""Where the mounts are: from the front, from above and from the side, with the block's two axes.

From above the front is at the foot, so that right is right in both; from the side it is at the
left. The lines of a mount are its three axes, each as long as it is stiff.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.analyses.mounts.charts.words import about, place_text, rests
from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import BLUE, GREEN, GREY, ORANGE, SKY, VERMILION, Panel, figure
from crankstar.charts.gas_curves import without
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label
from crankstar.charts.plane import BAR, Dot, Frame, Plane, Stroke, picture, scale_bar
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.dynamics.mount_modes import Axis
from crankstar.dynamics.mounted_block import SIX, MountError
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import mount_axes
from crankstar.language.messages import N_, _
from crankstar.spectra import Real

TITLE = N_("The mounts, from the front, from above and from the side")
MM = 1e3
MARGIN = 46.0
"""px around what is drawn, for the names."""
LONGEST = 26.0
"""px: half the length of the stiffest axis of a mount."""
TALLEST = 1.1
"""Height of a view, in its widths, at most."""
REACH = 1.5
"""Of the size of the layout: an axis that lies farther off does not make the view larger."""


class _View(NamedTuple):
    """A way of looking: what is up and what is right in the picture, of (up, right, z)."""

    name: str
    upward: tuple[float, float, float]
    rightward: tuple[float, float, float]

    def seen(self, place: Sequence[float] | Real) -> complex:
        """Millimetres, up + i right."""
        at = np.asarray(place, float) * MM
        return complex(*(float(at @ np.asarray(way)) for way in (self.upward, self.rightward)))


UP, RIGHT, REAR = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)


def mount_layout_chart(engine: Engine, *, at: Sequence[float] | None = None) -> Chart:
    """Mounts, crankshaft, centre of mass, torque-roll axis and elastic axis in three views.

    `at` is a point of the block (up, right, z; m) that is shown too. An engine without mounts has a
    figure that says so.
    """
    title = _(TITLE)
    try:
        found = mounts(engine, orders=(), at=at)
    except MountError as error:
        return without(engine, title=title, reason=str(error))
    told = about(engine, found, shaken=False)
    told.append(_("lines of a mount: its three axes, as long as they are stiff"))
    if at is not None:
        told.append(_("ringed: the point {place}", place=place_text(at)))
    views = (
        _View(_("from the front"), UP, RIGHT),
        _View(_("from above, the front of the engine at the foot"), REAR, RIGHT),
        _View(_("from its right, the front of the engine at the left"), UP, REAR),
    )
    rows = [[_panel(engine, found, view, named=at is not None)] for view in views]
    return figure(rows, title=title, subtitle=told, rests=rests(engine))


def _places(engine: Engine, found: MountAnalysis, *, named: bool) -> list[Real]:
    """All that must be in the picture: mounts, both centres, the ends of the crankshaft."""
    own = [np.array([each.up, each.right, each.z]) for each in found.block.mounts]
    own += [np.asarray(centre) for centre in found.block.centres]
    own += [np.array([0.0, 0.0, z]) for z in _ends(engine)]
    return [*own, np.asarray(found.point)] if named else own


def _ends(engine: Engine) -> tuple[float, float]:
    """Where the outermost cylinders are."""
    along = [each.z for each in engine.cylinders]
    return max(along), min(along)


def _frame(places: Sequence[complex]) -> Frame:
    """All places with room around them, no taller than a view may be."""
    width = panel_width()
    right = [place.imag for place in places]
    up = [place.real for place in places]
    across, upright = max(right) - min(right), max(up) - min(up)
    scale = (width - 2 * MARGIN) / (across or upright or 1.0)
    if upright:
        scale = min(scale, (TALLEST * width - 2 * MARGIN) / upright)
    middle, half = (max(right) + min(right)) / 2, width / 2 / scale
    room = MARGIN / scale
    return Frame(middle - half, middle + half, min(up) - room - BAR / scale, max(up) + room, scale)


def _panel(engine: Engine, found: MountAnalysis, view: _View, *, named: bool) -> Panel:
    inside = _places(engine, found, named=named)
    size = max(float(np.linalg.norm(a - b)) for a in inside for b in inside)
    centre = found.block.centres[0]
    axes = (
        (found.torque_roll, GREEN, _("torque-roll axis"), False),
        (found.elastic, ORANGE, _("elastic axis"), True),
    )
    near = [axis.point for axis, *_rest in axes if np.linalg.norm(axis.point - centre) < size]
    frame = _frame([view.seen(place) for place in [*inside, *near]])
    strokes, dots, labels = _mounts(found, view, frame)
    crank = tuple(view.seen((0.0, 0.0, z)) for z in _ends(engine))
    if abs(crank[0] - crank[1]) * frame.scale > 1:
        strokes.append(Stroke(crank, GREY, 5.0))
        labels.append(Label(_("crankshaft"), crank[0], 1j, colour=GREY))
    else:
        dots.append(Dot(crank[0], colour=GREY, size=50))
        labels.append(Label(_("crankshaft"), crank[0], -1 + 0j, colour=GREY))
    for axis, colour, name, dashed in axes:
        line = _line(axis, view, frame, REACH * size)
        if line is None:
            continue
        strokes.append(Stroke(line, colour, 2.0, dashed=dashed))
        dots.append(Dot(line[0], colour=colour, size=22))
        labels.append(Label(name, line[0], _away(line), colour=colour))
    dots.append(Dot(view.seen(centre), colour=VERMILION, size=80))
    labels.append(Label(_("centre of mass"), view.seen(centre), 1 + 0j, colour=VERMILION, led=True))
    if named:
        spot = view.seen(found.point)
        ring = spot + 7 / frame.scale * np.exp(1j * np.linspace(0, 2 * np.pi, 37))
        strokes.append(Stroke(tuple(ring.tolist()), VERMILION, 1.6))
    bar, length = scale_bar(frame, "mm")
    strokes.append(bar)
    plane = Plane((), tuple(strokes), tuple(dots), tuple(labels), (length,))
    return picture(plane, frame, title=view.name)


def _mounts(
    found: MountAnalysis, view: _View, frame: Frame
) -> tuple[list[Stroke], list[Dot], list[Label]]:
    """Each mount as a dot with its axes and its name; those of the foundation in another colour."""
    stiffest = max(max(each.along) for each in found.block.mounts[: found.block.of_block])
    strokes: list[Stroke] = []
    dots: list[Dot] = []
    labels: list[Label] = []
    for index, mount in enumerate(found.block.mounts):
        own = index < found.block.of_block
        colour = BLUE if own else SKY
        spot = view.seen((mount.up, mount.right, mount.z))
        dots.append(Dot(spot, colour=colour, size=60 if own else 36))
        for axis, along in zip(mount_axes(mount), mount.along, strict=True):
            arm = view.seen(axis) / MM * LONGEST / frame.scale * min(along / stiffest, 1.0)
            if own and abs(arm) * frame.scale > 1:
                strokes.append(Stroke((spot - arm, spot + arm), colour, 2.0))
        if own or found.block.freedoms == SIX:
            labels.append(Label(mount.name, spot, 1 + 0j, colour=colour, gap=9.0))
    return strokes, dots, labels


def _line(axis: Axis, view: _View, frame: Frame, reach: float) -> tuple[complex, complex] | None:
    """The part of an axis that is in the picture; its front end first. None where it is outside."""
    way = axis.direction * (1.0 if axis.direction[2] >= 0 else -1.0)
    start, end = view.seen(axis.point + reach * way), view.seen(axis.point - reach * way)
    low, high = 0.0, 1.0
    step = end - start
    room = 4 / frame.scale
    for at, by, least, most in (
        (start.real, step.real, frame.bottom + room, frame.top - room),
        (start.imag, step.imag, frame.left + room, frame.right - room),
    ):
        if abs(by) < 1e-9:
            if not least <= at <= most:
                return None
            continue
        one, other = sorted(((least - at) / by, (most - at) / by))
        low, high = max(low, one), min(high, other)
    return None if low > high else (start + low * step, start + high * step)


def _away(line: tuple[complex, complex]) -> complex:
    """The side of the end of a line for its name: beside it."""
    way = line[0] - line[1]
    return (1j * way / abs(way)) if abs(way) > 1e-9 else 1j
