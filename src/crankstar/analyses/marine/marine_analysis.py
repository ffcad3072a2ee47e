"""All that a project guide tells of an engine's vibration, in one record.

External moments with weights at the ends and compensators, about the middle of the cylinders and
about a node of the hull; guide-force moments at an operating point; the power that they are set
against. Axial vibration of the crankshaft, and what the propeller does, are left out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import pi, radians
from types import MappingProxyType
from typing import Any

import numpy as np

from crankstar.analyses.marine.compensators import Compensator, compensators, with_compensators
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.mechanics.balance import scales
from crankstar.mechanics.external_moments import USUAL, ExternalMoments, Wanted, external_moments
from crankstar.mechanics.gas import Cycle, cycle_or_reason
from crankstar.mechanics.guide_moments import GuideMoments, MarineError, guide_moments
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.operating_points import operating_state
from crankstar.remedy.end_weights import with_end_weights
from crankstar.spectra import Real

NOTHING: Mapping[int, Sequence[float]] = MappingProxyType({})
"""Nothing to compensate."""


@dataclass(frozen=True)
class MarineAnalysis:
    """External moments before and after what is added, guide-force moments, power (W).

    `engine` is the engine with weights and compensators. `at_node` are the moments about the node,
    before and after. `guide` is None where gas is not known; `without_guide` says why. `orders` are
    those wanted, "all", or None: those of note. `usual` are the moments of the usual orders and of
    those wanted. `speed` (rad/s) is the one that is meant, with masses or without.

    >>> from crankstar import marine
    >>> found = marine("audi-25-tfsi", node=-2.0)
    >>> found.guide is None, found.at_node[0].z, found.compensators
    (False, -2.0, ())
    """

    engine: Engine
    before: ExternalMoments
    after: ExternalMoments
    at_node: tuple[ExternalMoments, ExternalMoments] | None
    end_weights: float | None
    compensators: tuple[Compensator, ...]
    phase_error: float
    guide: GuideMoments | None
    cycle: Cycle | None
    without_guide: str
    power: float | None
    speeds: Real
    usual: ExternalMoments
    orders: Wanted = None
    speed: float | None = None

    def unbalance(self, moment: float) -> float | None:
        """The power-related unbalance of a moment (N m), N m/kW; None without power or masses."""
        known = self.power is not None and self.after.units.couple == "N*m"
        return moment / (self.power / 1e3) if known and self.power else None

    @property
    def mean_pressure(self) -> float | None:
        """The brake mean effective pressure of the power at the highest speed that is known, Pa.

        None without power, speed, bore or stroke.
        """
        gas = self.engine.gas
        known = {self.engine.speed, self.after.speed, self.cycle and self.cycle.speed}
        known |= set() if gas is None else {gas.speed, *(each.speed for each in gas.points)}
        speeds = [each for each in known if each is not None]
        bores = [each.bore for each in self.engine.cylinders]
        if self.power is None or not speeds or None in bores or "radius" in self.engine.relative:
            return None
        swept = sum(
            pi / 2 * (each.bore or 0.0) ** 2 * self.engine.throw(each).radius
            for each in self.engine.cylinders
        )
        return self.power * radians(self.engine.cycle_angle) / (swept * max(speeds))

    @property
    def strained(self) -> tuple[Compensator, ...]:
        """Compensators that push with more than all parts of the engine in any order together."""
        most = self.before.of_a_part * len(self.engine.cylinders)
        scale = scales(self.engine, self.after.speed)[0].force
        return tuple(each for each in self.compensators if abs(each.force) * scale > most)


def marine(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    rated_power: float | None = None,
    horizontal_share: float | None = None,
    compensate: Mapping[int, Sequence[float]] = NOTHING,
    node: float | None = None,
    phase_error: float = 0.0,
    orders: Wanted = None,
) -> MarineAnalysis:
    """The external and guide-force moments of an engine at an operating point and speed (rad/s).

    Without a speed it is the greatest of `speeds`. `horizontal_share` has weights at the ends that
    make this share of the first-order moment horizontal; `compensate` has the orders whose vertical
    moment is to be compensated, with the one place z or two at which that is done, about `node` (z)
    where there is one; `phase_error` (rad) is by how much the compensators are late. `rated_power`
    (W) stands before that of the operating point. `orders` are those wanted of both kinds of
    moments, "all", or None: those of note. Raises RemedyError, OrderError for an order that the
    engine cannot have, and GasError for a point that it has not.

    >>> from crankstar.files.catalog import load
    >>> changes = {"layout.bore_pitch": "1.6 m", "cylinder.reciprocating_mass": "9 t"}
    >>> seven = load("man-s90mc-c", changes=changes)
    >>> found = marine(seven, compensate={2: (6.0, -6.0)})
    >>> found.before.moment(2) > 7e5, found.after.moment(2) < 1e-3
    (True, True)
    """
    if orders is not None and not isinstance(orders, str):
        check_orders(engine, orders, gas=engine.gas is not None)
    found, why = cycle_or_reason(engine, point=point, speed=speed)
    turning = operating_state(engine, point=point, speed=speed).speed
    over = np.unique(np.asarray(speeds, float))
    if turning is None and over.size:
        turning = float(over[-1])
    changed = engine
    if horizontal_share is not None:
        changed = with_end_weights(changed, share=horizontal_share)
    fitted: list[Compensator] = []
    for order, places in compensate.items():
        own = compensators(changed, order=order, places=places, node=node, phase_error=phase_error)
        changed = with_compensators(changed, own)
        fitted += own
    guide = None
    if found is not None:
        try:
            guide = guide_moments(engine, found)
        except MarineError as error:
            why = str(error)
    at: dict[str, Any] = {"speed": turning, "orders": orders}
    pair = [external_moments(each, **at) for each in (engine, changed)]
    about = None
    if changed is not engine or node is not None:  # every order that one of them tells
        at["orders"] = sorted({*pair[0].orders.tolist(), *pair[1].orders.tolist()})
        pair = [external_moments(each, **at) for each in (engine, changed)]
    if node is not None:
        about = [external_moments(each, about=node, **at) for each in (engine, changed)]
    usual = pair[1]
    if orders is not None and not isinstance(orders, str):
        usual = external_moments(changed, speed=turning, orders=sorted({*USUAL, *orders}))
    if changed is not engine:
        changed = with_values(changed, name=_name(engine, horizontal_share, [*compensate]))
    return MarineAnalysis(
        engine=changed,
        before=pair[0],
        after=pair[1],
        at_node=None if about is None else (about[0], about[1]),
        end_weights=horizontal_share,
        compensators=tuple(fitted),
        phase_error=phase_error,
        guide=guide,
        cycle=found,
        without_guide=why,
        power=_power(found) if rated_power is None else rated_power,
        speeds=over,
        usual=usual,
        orders=orders if orders is None or isinstance(orders, str) else tuple(orders),
        speed=turning,
    )


def _name(engine: Engine, share: float | None, compensate: Sequence[int]) -> str:
    """The name of the engine, and what was added to it."""
    added = [] if share is None else [_("weights at the ends")]
    if compensate:
        orders = ", ".join(map(str, compensate))
        added.append(_("compensators of order {orders}", orders=orders))
    return one_line(", ".join((engine.name, *added)))


def _power(found: Cycle | None) -> float | None:
    """The brake power of a cycle, W."""
    if found is None or found.speed is None or found.bmep is None:
        return None
    swept = float(found.volumes.swept[[*found.volumes.kind]].sum())
    return found.bmep * swept / found.volumes.cycle * found.speed
