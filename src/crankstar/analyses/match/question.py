"""What is asked of a batch of parts: which list, what is minimised, in how many engines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING, Annotated, Any, Literal

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import MASS
from crankstar.files.lists import Listed, list_given, read_list
from crankstar.language.messages import N_
from crankstar.options import numbers, readers
from crankstar.options import values as request
from crankstar.options.refusals import refusal

if TYPE_CHECKING:
    from crankstar.analyses.match.batch import Batch

Minimised = Literal["force", "couple"]
MOST_ENGINES = 100
MOST_ORDERS = 24
MOST_CLASSES = 12
WEIGHTS = N_("CSV file (or .xlsx) with the weights: columns no., piston, pin, small end, big end.")


def _orders(text: str) -> Sequence[float]:
    wanted = request.orders(text, [])
    if not wanted or len(wanted) > MOST_ORDERS:
        raise refusal("--orders", text, "give up to {most} orders, as in 1,2", most=MOST_ORDERS)
    return wanted


def _quantities(text: str) -> tuple[Minimised, ...]:
    both: tuple[Minimised, ...] = ("force", "couple")
    named = [request.choice("--quantity", name, both) for name in request.listed(text) or [text]]
    return tuple(name for name in both if name in named)


def _widths(text: str) -> Sequence[float]:
    parts = request.listed(text)
    if not 1 <= len(parts) <= MOST_CLASSES:
        raise refusal(
            "--classes", text, 'give up to {most} widths, as in "1 g, 5 g"', most=MOST_CLASSES
        )
    return [request.size("--classes", part, quantity=MASS) for part in parts]


def _widths_given(given: Any) -> Sequence[float]:
    """Widths in kg, or texts with their units. Raises ValueError, TypeError."""
    several = given if isinstance(given, Iterable) and not isinstance(given, str) else [given]
    return [numbers.mass("classes", each) for each in several]


@dataclass(frozen=True)
class Question:
    """The parts, the orders and quantities that are minimised, the engines, the classes beside.

    `classes` are widths, kg. `whole`: of the engine with its counterweights, not of the parts
    alone. The `speed` (rad/s) is that of the forces.
    """

    weights: Annotated[
        Listed, Reader("weights", read_list, WEIGHTS, number=partial(list_given, name="weights"))
    ]
    orders: Annotated[
        Sequence[float], Reader("--orders", _orders, "Default: 1,2.", number=numbers.orders)
    ] = (1.0, 2.0)
    quantity: Annotated[
        Sequence[Minimised],
        Reader("--quantity", _quantities, "Force, couple, or both (the default)."),
    ] = ("force", "couple")
    engines: Annotated[int, readers.count("--engines", MOST_ENGINES)] = 1
    classes: Annotated[Sequence[float], Reader("--classes", _widths, number=_widths_given)] = (
        0.0005,
        0.001,
        0.002,
        0.005,
    )
    whole: Annotated[bool, readers.flag("--whole")] = False
    speed: Annotated[float | None, readers.SPEED] = None

    @cached_property
    def batch(self) -> Batch:
        """The parts of the list. Raises ListError with every mistake of it."""
        from crankstar.analyses.match.batch import batch_of

        return batch_of(self.weights)

    def turning(self, engine: Engine) -> float | None:
        """The speed of the forces, rad/s: that of the file unless one is given."""
        return self.speed or engine.speed


def count(question: Question) -> int:
    """How many engines are built."""
    return question.engines


def refuse(engine: Engine, question: Question) -> None:
    """Refuse a list with errors. Raises ListError."""
    del engine
    _read = question.batch
