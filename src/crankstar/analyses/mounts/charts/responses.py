"""How an engine shakes on its mounts over the speed, and what goes through them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import Literal, NamedTuple

import numpy as np

from crankstar.analyses.mounts.charts.words import NO_SPEED, about, place_text, rests
from crankstar.analyses.mounts.speed_tables import without_ratio
from crankstar.charts.canvas import curve_height, panel_width, relative_width
from crankstar.charts.drawing import (
    GREY,
    PALETTE,
    ChartError,
    Panel,
    checked_order,
    figure,
    layered,
    named_in_legend,
)
from crankstar.charts.gas_curves import ROOM, without
from crankstar.charts.grammar import Chart, field, of_rows, own, span
from crankstar.charts.letters import text_width
from crankstar.charts.sums import checked_quantity
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mount_response import MountResponse, rms
from crankstar.dynamics.mounted_block import SIX, MountError
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, order_text, unit_text
from crankstar.language.shown_units import Shown, shown
from crankstar.mechanics.gas_torque import HIGHEST
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.spectra import Complex, Real

MountView = Literal["velocity", "displacement", "acceleration", "hand-arm", "force", "mounts"]
TITLES = {
    "velocity": N_("Velocity of a point on its mounts over the speed"),
    "displacement": N_("Displacement of a point on its mounts over the speed"),
    "acceleration": N_("Acceleration of a point on its mounts over the speed"),
    "hand-arm": N_("Acceleration of a point, weighted for the hand, over the speed"),
    "force": N_("Force of the mounts on the ground over the speed"),
    "mounts": N_("Force in each mount over the speed"),
}
AXES = {
    "velocity": N_("velocity, rms ({unit})"),
    "displacement": N_("displacement, rms ({unit})"),
    "acceleration": N_("acceleration, rms ({unit})"),
    "hand-arm": N_("weighted acceleration, rms ({unit})"),
    "force": N_("force, rms ({unit})"),
    "mounts": N_("force, rms ({unit})"),
}
UNITS = {
    "velocity": "mm/s",
    "displacement": "um",
    "acceleration": "m/s^2",
    "hand-arm": "m/s^2",
    "force": "N",
    "mounts": "N",
}
FIGURES = {
    "velocity": "velocity at the point",
    "displacement": "displacement at the point",
    "acceleration": "acceleration at the point",
    "hand-arm": "weighted acceleration",
    "force": "mount force",
    "mounts": "one mount",
}
"""What each view shows, as `figures.on_mounts` names it."""
FACTORS = {"velocity": 1e3, "displacement": 1e6}
"""Of what is not drawn in SI."""
THROUGH = N_("Transmissibility of the mounts over the speed")
TOTAL = N_("all orders")
MOST_ORDERS, VISIBLE = 5, 0.02
"""Orders that are drawn by themselves, and the share of the greatest that one of them has."""
MOST_MOUNTS = 10
"""Lines of mounts that can be told apart; of more those that have most are drawn."""
ALIKE = 7e-3
"""Share of the height of a drawing within which one line covers another: a line is as thick."""
HEIGHT = 230.0
BESIDE_NAME = 40.0
"""px beside a name in a legend: its line, and the space to the next one."""


class _Line(NamedTuple):
    """A line over the speeds."""

    name: str
    values: Real
    colour: str
    width: float = 1.8
    dash: tuple[int, int] = (1, 0)


def mount_response_chart(
    engine: Engine,
    *,
    quantity: MountView | None = None,
    speeds: Sequence[float] | None = None,
    orders: Sequence[float] | None = None,
    point: str | None = None,
    at: Sequence[float] | None = None,
) -> Chart:
    """Vibration of a point, or the force on the ground, rms over the speed.

    `hand-arm` is the acceleration weighted for the hand (`dynamics.hand_arm`).

    The strongest orders (thin), or those named, and all orders together (thick); `mounts` is the
    force in each mount, of all orders. `at` is the point of the block (up, right, z; m), else its
    centre of mass; `speeds` in rad/s, else those of the file; `point` names an operating point. An
    engine without mounts or without a speed has a figure that says so. Raises ChartError,
    OrderError for an order that does not occur, and GasError for an operating point that is not
    there.
    """
    wanted: MountView = "velocity" if quantity is None else checked_quantity(quantity, MountView)
    asked = None if orders is None else [checked_order(order) for order in orders]
    title = _(TITLES[wanted])
    try:
        found = mounts(engine, point=point or "", speeds=[*(speeds or ())], at=at)
    except MountError as error:
        return without(engine, title=title, reason=str(error))
    check_orders(engine, asked or (), gas=engine.gas is not None)
    if asked and max(asked) > HIGHEST:
        raise ChartError(_("give orders up to {highest}", highest=f"{HIGHEST:g}"))
    if found.over is None:
        return without(engine, title=title, reason=_(NO_SPEED))
    said = Shown(UNITS[wanted], 1.0) if wanted == "hand-arm" else shown(UNITS[wanted], 1.0)
    unit = unit_text(said.unit)
    over = found.over
    by_mount = wanted == "mounts"
    lines = _of_mounts(over) if by_mount else _by_order(over, found.point, wanted, asked)
    lines = [line._replace(values=line.values * said.factor) for line in lines]
    panel = _panel(over, lines, _(AXES[wanted], unit=unit))
    told = about(engine, found)
    if wanted not in ("force", "mounts"):
        told.append(place_text(found.point))
    top = max(lines, key=lambda line: float(line.values.max()))
    told.append(
        _(
            "maximum: {size} {unit} at {rpm} rpm",
            size=number(float(f"{top.values.max():.4g}")),
            unit=unit,
            rpm=number(round(float(over.speeds[int(np.argmax(top.values))] * RPM))),
        )
    )
    options = {"point": point or "", "speeds": [*(speeds or ())], "at": at}
    rests_on = rests(engine, FIGURES[wanted], **options)
    return figure([[panel]], title=title, subtitle=told, rests=rests_on)


def transmissibility_chart(
    engine: Engine, *, speeds: Sequence[float] | None = None, point: str | None = None
) -> Chart:
    """The transmissibility of each mount over the speed (rad/s).

    It is the rms force in it over that of the same shaking without inertia of the block; dashed: 1,
    above which the mounts do harm. A mount without one (`MountResponse.transmissibility`) has no
    line, and is named. An engine without mounts or a speed has a figure that says so.
    Raises GasError for an operating point that is not there.
    """
    title = _(THROUGH)
    try:
        found = mounts(engine, point=point or "", speeds=[*(speeds or ())])
    except MountError as error:
        return without(engine, title=title, reason=str(error))
    if found.over is None:
        return without(engine, title=title, reason=_(NO_SPEED))
    over = found.over
    if not np.isfinite(over.transmissibility).any():
        return without(engine, title=title, reason=_("Nothing shakes this engine."))
    names = [each.name for each in over.block.mounts[: over.block.of_block]]
    every = _coloured(*_apart(names, over.transmissibility, top=1.0))
    lines = [line for line in every if np.isfinite(line.values).any()]
    one = _Line(_("stiff mounts (dashed)"), np.ones(over.speeds.size), GREY, 1.2, (4, 3))
    told = [
        *about(engine, found),
        _("force in a mount over that without inertia of the block"),
        *without_ratio(over),
    ]
    panel = _panel(over, [*lines, one], _("transmissibility"))
    options = {"point": point or "", "speeds": [*(speeds or ())]}
    rests_on = rests(engine, "transmissibility", **options)
    return figure([[panel]], title=title, subtitle=told, rests=rests_on)


def _by_order(
    over: MountResponse, at: Sequence[float], view: str, asked: Sequence[float] | None
) -> list[_Line]:
    """The whole, and its strongest orders or those that are asked for."""
    amplitudes = FACTORS.get(view, 1.0) * _amplitudes(over, at, view)
    each = np.sqrt((np.abs(amplitudes) ** 2).sum(axis=2) / 2)
    tops = each.max(axis=0)
    if asked is not None:
        kept = [index for index, order in enumerate(over.orders.tolist()) if order in asked]
    else:
        strongest = np.argsort(-tops, kind="stable")[:MOST_ORDERS].tolist()
        least = VISIBLE * float(tops.max(initial=0.0))
        kept = sorted(place for place in strongest if tops[place] > least)
    names = [_("order {order}", order=order_text(over.orders[place])) for place in kept]
    return [_Line(_(TOTAL), rms(amplitudes), GREY, 3.0), *_coloured(names, each[:, kept])]


def _amplitudes(over: MountResponse, at: Sequence[float], view: str) -> Complex:
    """[speed, order, axis], SI."""
    if view == "force":
        return over.ground_force[..., :3]
    return getattr(over, view.replace("-", "_"))(at)


def _of_mounts(over: MountResponse) -> list[_Line]:
    """The force in each mount, those that the ground takes first."""
    count = len(over.block.mounts)
    each = np.column_stack([rms(over.mount_force[:, :, index]) for index in range(count)])
    names = [mount.name for mount in over.block.mounts]
    if over.block.freedoms > SIX:
        below = _("foundation")
        own = over.block.of_block
        names = [*names[:own], *(f"{below}: {name}" for name in names[own:])]
    kept = np.sort(np.argsort(-each.max(axis=0), kind="stable")[:MOST_MOUNTS])
    return _coloured(*_apart([names[place] for place in kept], each[:, kept]))


def _apart(names: Sequence[str], values: Real, *, top: float = 0.0) -> tuple[list[str], Real]:
    """Lines that lie on each other as one that has both names, as of left and right mounts.

    The drawing reaches to the largest value, or to `top`.
    """
    near = ALIKE * np.nanmax(np.abs(values), initial=top)
    first: dict[int, list[str]] = {}
    for index, name in enumerate(names):
        on = (
            other
            for other in first
            if np.allclose(values[:, index], values[:, other], rtol=0, atol=near, equal_nan=True)
        )
        first.setdefault(next(on, index), []).append(name)
    return [", ".join(alike) for alike in first.values()], values[:, [*first]]


def _coloured(names: Sequence[str], values: Real) -> list[_Line]:
    """A line for each column; a second round of colours is dashed."""
    colours = islice(cycle(PALETTE), len(names))
    return [
        _Line(name, values[:, index], colour, dash=(1, 0) if index < len(PALETTE) else (6, 3))
        for index, (name, colour) in enumerate(zip(names, colours, strict=True))
    ]


def _panel(over: MountResponse, lines: Sequence[_Line], axis: str) -> Panel:
    speeds = (over.speeds * RPM).tolist()
    rows = [
        {"x": x, "y": float(f"{y:.6g}"), "what": line.name, "width": line.width}
        for line in lines
        for x, y in zip(speeds, line.values.tolist(), strict=True)
        if np.isfinite(y)
    ]
    low, high = speeds[0], speeds[-1]
    if low == high:
        low, high = 0.9 * low, 1.1 * high
    x = field(
        "x:Q",
        scale=span(low, high),
        title=_("speed (rpm)"),
        axis={"tickCount": 5 if relative_width() > 0.8 else 3},
    )
    top = ROOM * max(float(np.nanmax(line.values)) for line in lines) or 1.0
    y = field("y:Q", scale=span(0, top), title=axis, axis={"tickCount": 4, "minExtent": 34})
    widest = max(text_width(line.name) for line in lines)
    columns = 2 if widest < panel_width() / 2 - BESIDE_NAME else 1
    single = {"point": True} if len(speeds) == 1 else {}
    drawn = of_rows(rows).mark("line", strokeJoin="round", **single)
    layer = drawn.encode(
        x=x,
        y=y,
        **named_in_legend([(line.name, line.colour, line.dash) for line in lines], columns=columns),
        strokeWidth=own("width:Q"),
    )
    return layered([layer], width=panel_width(), height=curve_height(HEIGHT))
