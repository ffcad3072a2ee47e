"""The firing orders that an engine can fire, found and sorted as they are asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, cast

from crankstar.analyses.orders.question import Question
from crankstar.engine.engine import Engine
from crankstar.firing import weighing
from crankstar.firing.orders import (
    SAME_PLACE,
    Order,
    most_even_orders,
    orders_at,
    possible_orders,
    why_uneven,
)
from crankstar.firing.timetable import OrderError
from crankstar.firing.weighing import Shape, Weighed, Weight
from crankstar.language.messages import passage
from crankstar.mechanics.gas import Cycle, computable, cycle
from crankstar.mechanics.gas_torque import of_one_cylinder
from crankstar.options.refusals import RequestError
from crankstar.options.shapes import mode_shape
from crankstar.studies.judged_orders import FAILURES, JUDGES, Judge, judged
from crankstar.tables.torque import load_sentence

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_modes import Mode

REASONS = 4
"""Dead centres that are named as the reason why nothing fires evenly."""


class Listing(NamedTuple):
    """Firing orders of an engine, and what was asked for.

    `why_uneven`: why there are no even ones; `asked_deg`: the intervals that were asked for, none
    where any would do; `tolerance_deg`: how far a firing may be from its place; `weighed`: the sums
    by which they are sorted, those of `weight`, in N m at the `load`, which is a sentence, else
    counted in one cylinder; `mode`: the mode that gives the twist its shape; `judged`: of each
    order the stress or bearing load of the whole engine, by which they are sorted, as `judge` says.
    """

    engine: Engine
    orders: tuple[Order, ...]
    why_uneven: str = ""
    asked_deg: tuple[float, ...] = ()
    tolerance_deg: float | None = None
    weighed: Weighed | None = None
    weight: Weight = "torque"
    load: str = ""
    mode: Mode | None = None
    judged: tuple[float, ...] = ()
    judge: Judge = "stress"


def compute(engine: Engine, question: Question) -> Listing:
    """The orders that are asked for. Raises RequestError."""
    try:
        found = _found(engine, question)
        what = question.minimise
        if what is None:
            return found
        return _judged(found, what, question) if what in JUDGES else _summed(found, what, question)
    except OrderError as error:
        raise RequestError(f"{engine.name}: {error}") from None


def _found(engine: Engine, question: Question) -> Listing:
    """Any that the dead centres allow, those at intervals, or the most even ones."""
    if question.any_:
        return Listing(engine, possible_orders(engine, together=question.together))
    if question.intervals is not None or question.tolerance is not None:
        count = len(engine.chambers)
        wanted = question.intervals or (engine.cycle_angle / count,) * count
        near = question.tolerance
        within = SAME_PLACE if near is None else near
        possible = orders_at(engine, intervals_deg=wanted, tolerance_deg=within)
        return Listing(engine, possible, asked_deg=tuple(wanted), tolerance_deg=near)
    reasons = why_uneven(engine)[:REASONS]
    return Listing(engine, most_even_orders(engine), passage(fault.sentence for fault in reasons))


def _judged(listing: Listing, judge: str, question: Question) -> Listing:
    """The orders sorted by the stress or the bearing load that they make."""
    engine, point = listing.engine, question.point
    own = cast("Judge", judge)
    try:
        best, values = judged(engine, listing.orders, own, point=point)
        load = load_sentence(cycle(engine, point=point))
    except FAILURES as error:
        raise RequestError(f"{engine.name}: {error}") from None
    return listing._replace(orders=best, judged=values, judge=own, load=load)


def _summed(listing: Listing, weight: str, question: Question) -> Listing:
    """The orders sorted by the torque, roll or twist of crank orders."""
    engine, found = listing.engine, gas_of(listing.engine, question)
    mode, _shape = shape_of(engine, weight, question)
    sums = sums_of(engine, listing.orders, weight, question)
    return listing._replace(
        orders=sums.orders,
        weighed=sums,
        weight=cast("Weight", weight),
        load="" if found is None else load_sentence(found),
        mode=mode,
    )


def gas_of(engine: Engine, question: Question) -> Cycle | None:
    """The cycle by which sums are in N m; None where there is none, and one cylinder counts 1."""
    return cycle(engine, point=question.point) if computable(engine) else None


def shape_of(engine: Engine, weight: str, question: Question) -> tuple[Mode | None, Shape]:
    """The amplitude of each chamber, and the mode that gives it, if one does."""
    if weight == "twist":
        return mode_shape(question.mode_shape, engine)
    return None, weighing.even_shape(engine)


def sums_of(engine: Engine, orders: tuple[Order, ...], weight: str, question: Question) -> Weighed:
    """Firing orders, least first, by the sums of the crank orders that are asked for."""
    found, wanted = gas_of(engine, question), question.crank_orders(engine)
    sizes = None if found is None else of_one_cylinder(found, wanted)
    return weighing.weighed(orders, shape_of(engine, weight, question)[1], wanted, sizes)
