"""What is asked of firing orders: which of them, by what they are sorted, which is written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.options import numbers, readers
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, refusal, refuse_unused

USUAL_HIGHEST = 3.0
"""Crank orders up to which firing orders are weighed by default."""
SUMS, JUDGES = ("torque", "roll", "twist"), ("stress", "bearings")
"""What orders are sorted by: sums of crank orders, and what is computed of the whole engine."""


def _intervals(text: str, engine: Engine) -> Sequence[float]:
    return tuple(request.repeated("--intervals", text, of=len(engine.chambers)))


def _tolerance(text: str) -> float:
    return request.degrees("--tolerance", text)[0]


def _minimise(text: str) -> str:
    return request.choice("--minimise", text, (*SUMS, *JUDGES))


def _there(engine: Engine) -> list[float]:
    """The crank orders that gas torque has."""
    from crankstar.mechanics.gas_torque import HIGHEST

    step = 360 / engine.cycle_angle
    return [step * n for n in range(1, int(HIGHEST / step) + 1)]


def _orders(text: str, engine: Engine) -> Sequence[float] | None:
    there = _there(engine)
    wanted = request.orders(text, there)
    if any(order not in there for order in wanted or ()):
        raise refusal("--orders", text, "gas torque has multiples of {step}", step=f"{there[0]:g}")
    return wanted


def _orders_given(given: Any, engine: Engine) -> Sequence[float]:
    """The same as numbers. Raises ValueError, TypeError."""
    return _orders(",".join(f"{order:.12g}" for order in numbers.orders(given)), engine) or ()


@dataclass(frozen=True)
class Question:
    """Which firing orders: any, those at intervals (degrees) or the even ones; sorted by what.

    `orders` are crank orders that are minimised; `top` is how many readers see; the engine with the
    order of `row` may be written.
    """

    intervals: Annotated[
        Sequence[float] | None, Reader("--intervals", _intervals, of_source=True)
    ] = None
    any_: Annotated[bool, readers.flag("--any")] = False
    together: Annotated[bool, readers.flag("--together")] = False
    tolerance: Annotated[float | None, Reader("--tolerance", _tolerance)] = None
    minimise: Annotated[
        str | None,
        Reader(
            "--minimise",
            _minimise,
            "Torque, roll or twist of the gas, stress of torsion, or load on the bearings; sorts "
            "the orders.",
        ),
    ] = None
    orders: Annotated[
        Sequence[float] | None,
        Reader(
            "--orders",
            _orders,
            "For --minimise. Default: 0.5,1,1.5,2,2.5,3.",
            of_source=True,
            number=_orders_given,
        ),
    ] = None
    mode_shape: Annotated[str | None, Reader("--mode-shape", str)] = None
    point: Annotated[str, readers.POINT] = ""
    top: Annotated[int | None, readers.TOP] = None
    row: Annotated[int | None, Reader("--row", int)] = None

    def crank_orders(self, engine: Engine) -> Sequence[float]:
        """The crank orders that are minimised."""
        return self.orders or [each for each in _there(engine) if each <= USUAL_HIGHEST]


def refuse(engine: Engine, question: Question) -> None:
    """Refuse what has no effect, and a point of an engine without gas. Raises RequestError."""
    from crankstar.mechanics.gas import computable

    if question.row is not None:
        refuse_unused({"--top": question.top}, beside="--row")
    if not question.any_:
        _check_intervals(engine, question)
    own = {"--intervals": question.intervals, "--tolerance": question.tolerance}
    if question.any_:
        refuse_unused(own, beside="--any")
    else:
        refuse_unused({"--together": question.together}, without="--any")
    what, shape, point = question.minimise, question.mode_shape, question.point
    if what is None:
        given = {"--orders": question.orders, "--mode-shape": shape, "--point": point or None}
        refuse_unused(given, without="--minimise")
        return
    if shape is not None and what != "twist":
        raise RequestError("--mode-shape is for --minimise twist")
    if question.orders is not None and what in JUDGES:
        raise RequestError("--orders is for --minimise torque, roll and twist")
    if point and not computable(engine):
        raise RequestError("--point needs the bore and the firing order of the engine")


def _check_intervals(engine: Engine, question: Question) -> None:
    """Refuse intervals that make no cycle, and a tolerance too wide. Raises RequestError."""
    from crankstar.firing.orders import SAME_PLACE, check_intervals
    from crankstar.firing.timetable import OrderError

    count, near = len(engine.chambers), question.tolerance
    even = (engine.cycle_angle / count,) * count
    for option, wanted, within in (
        ("--intervals", question.intervals or even, SAME_PLACE),
        ("--tolerance", question.intervals or even, SAME_PLACE if near is None else near),
    ):
        try:
            check_intervals(engine, wanted, within)
        except OrderError as error:
            raise RequestError(f"{option}: {error}") from None


def writes(question: Question) -> str:
    """The option that has an engine written in place of the list; empty without."""
    return "" if question.row is None else "--row"
