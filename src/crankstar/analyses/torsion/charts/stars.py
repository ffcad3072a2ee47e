"""The star of an order in a mode: how far the torques of the cylinders join to drive it.

The vector of cylinder j is a_j, the turn of its throw in the mode, at the angle k phi_j, with phi_j
the crank angle at which it fires; their sum is the vector sum of the order.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from crankstar.analyses.torsion.charts.words import hertz, named_lines, refused, rests, rpm_text
from crankstar.charts.canvas import half_width, panel_width
from crankstar.charts.drawing import Panel, brief, checked_order, figure
from crankstar.charts.grammar import Chart
from crankstar.charts.sums import checked_quantity
from crankstar.charts.vector_panels import vectors_panel
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_criticals import of_note
from crankstar.dynamics.torsion_excitation import firing_phases
from crankstar.dynamics.torsion_modes import Mode, torsion_modes
from crankstar.dynamics.torsion_system import TorsionChain, TorsionError
from crankstar.engine.engine import Engine
from crankstar.firing.weighing import NOTHING, vector_sums
from crankstar.language.messages import N_, _
from crankstar.language.numbers import order_text
from crankstar.spectra import Complex, Real

TorsionMode = Literal["mode-1", "mode-2", "mode-3"]
TITLE = N_("Vectors of the cylinders in mode {number}, {size} Hz")
MOST = 4
HIGHEST = 12.0


class _Star(NamedTuple):
    """An order: the vector of each cylinder and the critical speed, rad/s."""

    order: float
    vectors: Complex
    speed: float

    @property
    def sum(self) -> complex:
        """Nought where it is but rounding."""
        whole = complex(self.vectors.sum())
        return whole if abs(whole) > NOTHING * float(np.abs(self.vectors).sum()) else 0j


def torsion_star(
    engine: Engine, *, quantity: TorsionMode | None = None, orders: Sequence[float] | None = None
) -> Chart:
    """The vectors of the cylinders of orders in a mode, clockwise from up, and their sum.

    The orders are those named, else the four whose critical speeds count for most in this mode, or
    without a speed whose sums are greatest; of orders with one star, or its mirror image, one. An
    engine without a table [torsion] or a firing order has a figure that says so. Raises ChartError.
    """
    mode_name: TorsionMode = (
        "mode-1" if quantity is None else checked_quantity(quantity, TorsionMode)
    )
    number = int(mode_name.removeprefix("mode-"))
    asked = None if orders is None else [checked_order(order) for order in orders]
    plain = _("Vectors of the cylinders in a mode")
    try:
        chain = torsion_chain(engine)
    except TorsionError as error:
        return refused(engine, title=plain, reason=str(error))
    phases = firing_phases(engine)
    if phases is None:
        reason = _("The vectors of an order need the firing order: give firing_order.")
        return refused(engine, title=plain, reason=reason)
    modes = torsion_modes(chain)
    if len(modes) < number:
        reason = _("There is no mode {number}.", number=number)
        return refused(engine, title=plain, reason=reason)
    mode = modes[number - 1]
    stars = _stars(engine, chain, mode, phases, asked)
    width = panel_width() if len(stars) == 1 else half_width()
    numbers = [each.number for each in engine.cylinders]
    panels = [_panel(star, numbers, width) for star in stars]
    across = 1 if len(stars) == 1 else 2
    rows = [panels[at : at + across] for at in range(0, len(panels), across)]
    subtitle = [
        *named_lines(engine),
        _("each as long as its throw turns in the mode, at order times firing angle"),
        _("orange: their sum, in turns of the first mass that a shaft holds"),
    ]
    title = _(TITLE, number=mode.number, size=hertz(mode.speed))
    return figure(rows, title=title, subtitle=subtitle, rests=rests(engine))


def _stars(
    engine: Engine, chain: TorsionChain, mode: Mode, phases: Real, asked: Sequence[float] | None
) -> list[_Star]:
    shape = chain.at_cylinders(mode.shape)

    def star(order: float) -> _Star:
        return _Star(order, shape * np.exp(1j * order * phases), mode.speed / order)

    if asked is not None:
        return [star(order) for order in asked]
    chosen: list[_Star] = []
    for tried in map(star, _by_strength(engine, mode, shape, phases)):
        if len(chosen) < MOST and not any(_alike(tried, other) for other in chosen):
            chosen.append(tried)
    return sorted(chosen, key=lambda each: each.order)


def _by_strength(engine: Engine, mode: Mode, shape: Real, phases: Real) -> list[float]:
    """Orders, the strongest first: of the critical speeds, else by their vector sums."""
    met = [each for each in torsion(engine).criticals if each.mode == mode.number]
    if met:
        return [each.order for each in of_note(met)]
    lowest = 1.0 if engine.cycle == "two-stroke" else 0.5
    tried = lowest * np.arange(1, round(HIGHEST / lowest) + 1)
    found = np.round(vector_sums(shape, phases, tried), 9)
    return tried[np.lexsort((tried, -found))].tolist()


def _alike(one: _Star, other: _Star) -> bool:
    """Whether two orders have the same star, or one that is its mirror image."""
    return bool(
        np.allclose(one.vectors, other.vectors) or np.allclose(one.vectors, other.vectors.conj())
    )


def _panel(star: _Star, numbers: Sequence[int], width: float) -> Panel:
    title = _(
        "order {order}: sum {size}\nat {rpm} rpm",
        order=order_text(star.order),
        size=brief(abs(star.sum)) if star.sum else "0",
        rpm=rpm_text(star.speed),
    )
    return vectors_panel(star.vectors, star.sum, numbers, width=width, title=title)
