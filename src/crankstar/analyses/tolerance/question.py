"""What is asked of engines that are built to the tolerances of their file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any, Literal, get_args

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.mechanics.excitation import Reference
from crankstar.options import numbers, points, readers
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, choice, refuse_unused

FEWEST_BUILDS, MOST_BUILDS = 1000, 1_000_000
GREATEST_SEED = 2**63
Distribution = Literal["normal", "uniform"]
SIGNALS = (
    "force",
    "couple",
    "roll",
    "torque",
    "force.up",
    "force.right",
    "couple.pitch",
    "couple.yaw",
)
"""What is told of each order: vectors in the clock plane, real signals, and components."""
BEARING = "bearing"
"""The loads on main bearings, as a quantity."""
ABOUT_A_POINT = ("couple", "roll")
"""Quantities that hang on the point of reference."""


def _signals(text: str) -> Sequence[str]:
    """Quantities with commas, each once. Raises RequestError."""
    names = [*dict.fromkeys(request.listed(text))]
    if not names:
        raise RequestError("--quantity: give at least one quantity, such as force,couple")
    return [choice("--quantity", name, (*SIGNALS, BEARING)) for name in names]


def _orders(text: str) -> Sequence[float] | Literal["all"] | None:
    return "all" if text.strip() == "all" else request.orders(text, [])


def _law(text: str) -> str:
    return choice("--distribution", text, get_args(Distribution))


def _reference(given: Any, _engine: Engine) -> Reference:
    """A point as Python has it: a Reference, or z in metres."""
    if isinstance(given, Reference):
        return given
    numbers.check_place("reference", given)
    return Reference(float(given))


@dataclass(frozen=True)
class Question:
    """Which quantities of which orders, by which law, of how many engines built at random.

    `typical` takes published tolerances where the file has none; `speed` in rad/s; `reference` is
    the point of couples and roll.
    """

    quantity: Annotated[
        Sequence[str],
        Reader(
            "--quantity",
            _signals,
            "Also roll, torque, force.up, force.right, couple.pitch, couple.yaw; bearing: the "
            "loads on main bearings.",
        ),
    ] = ()
    orders: Annotated[
        Sequence[float] | Literal["all"] | None,
        Reader("--orders", _orders, "Default: those up to 6 that occur.", number=numbers.orders),
    ] = None
    typical: Annotated[bool, readers.flag("--typical")] = False
    distribution: Annotated[Distribution, Reader("--distribution", _law)] = "normal"
    builds: Annotated[
        int,
        Reader(
            "--builds", partial(request.within, "--builds", least=FEWEST_BUILDS, most=MOST_BUILDS)
        ),
    ] = 100_000
    seed: Annotated[
        int, Reader("--seed", partial(request.within, "--seed", least=0, most=GREATEST_SEED))
    ] = 1
    speed: Annotated[float | None, readers.SPEED] = None
    reference: Annotated[
        Reference | None, Reader("--reference", points.reference, of_source=True, number=_reference)
    ] = None

    @property
    def wanted(self) -> Sequence[float] | None:
        """The orders that are named; None for those that occur."""
        return None if self.orders == "all" else self.orders


def refuse(engine: Engine, question: Question) -> None:
    """Refuse a point on which nothing depends. Raises RequestError."""
    del engine
    names = question.quantity
    if names and not any(name.startswith(ABOUT_A_POINT) for name in names):
        given = {"--reference": question.reference}
        refuse_unused(given, beside=f"--quantity {','.join(names)}")
