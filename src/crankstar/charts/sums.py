"""What remains of force, couple, rolling moment and torque of an engine, with their units."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple, TypeVar, get_args

from crankstar import spectra
from crankstar.charts.canvas import speed_of
from crankstar.charts.comparison import same_unit
from crankstar.charts.drawing import ChartError
from crankstar.charts.estimates import ends_of
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import Balance, balance, of_one_piston
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE, pushed, sizes, summed
from crankstar.spectra import Spectrum

Quantity = Literal["force", "couple"]
Signal = Literal["force", "couple", "roll", "torque"]
Engines = Engine | Sequence[Engine]
"""One engine, or several that are drawn side by side."""
Q = TypeVar("Q", bound=str)


MOST_TURNS = 12
"""Greatest number of turns that are drawn; geared shafts can need very many."""


class Sum(NamedTuple):
    """A quantity of the whole engine: the orders that remain of it, and its unit.

    The unit is that of a Balance until `in_one_unit` writes it as readers see it. `ends` are the
    spectra in the middle and at the corners of the ranges of an estimated engine; `piston` is what
    the first piston alone would make, m r w^2 and its like.
    """

    quantity: str
    unit: str
    spectrum: Spectrum
    ends: tuple[Spectrum, ...] = ()
    piston: float = 0.0

    @property
    def turns(self) -> int:
        """The drawn period, in turns of the crankshaft."""
        return min(spectra.period(self.spectrum), MOST_TURNS)


def sums(
    engine: Engine, quantities: Iterable[str], *, speed: float | None, reference: Reference | None
) -> list[Sum]:
    """These quantities of an engine, in units of m r w^2 or, at a `speed` (rad/s), in N and N m."""
    speed = speed_of(engine, speed)
    result = balance(engine, speed=speed, reference=reference)
    whole, parts = summed(result)._asdict(), vars(result) | {"roll": result.torque}
    others = [
        summed(balance(each, speed=speed, reference=reference))._asdict()
        for each in ends_of(engine)
    ]
    one = of_one_piston(engine, speed=speed)._asdict()
    out = []
    for quantity in quantities:
        least = NEGLIGIBLE * pushed(parts[quantity]).max(initial=0.0)
        ends = tuple(present(other[quantity], least) for other in others)
        spectrum = present(whole[quantity], least)
        missing = {order for end in ends for order in end.orders.tolist()}
        if missing - {*spectrum.orders.tolist()}:  # what cancels in the engine as given alone
            orders = sorted(missing | {*spectrum.orders.tolist()})
            spectrum = spectra.selected(spectrum, orders)
        piston = one.get(quantity, one["moment"])
        out.append(Sum(quantity, unit_of(result, quantity), spectrum, ends, piston))
    return out


def present(spectrum: Spectrum, least: float = 0.0) -> Spectrum:
    """A spectrum without the orders that are not greater than `least`."""
    kept = sizes(spectrum) > least
    return Spectrum(
        spectrum.orders[kept], spectrum.forward[kept], spectrum.backward[kept], spectrum.sense
    )


def unit_of(result: Balance, quantity: str) -> str:
    """The unit of a quantity, as a Balance has it."""
    units = result.units._asdict()
    return units.get(quantity, units["moment"])


def in_one_unit(courses: Sequence[Sum]) -> list[Sum]:
    """The same quantity of several engines, in the one unit that the greatest of all is shown in.

    Raises ChartError where the engines are not counted in the same unit.
    """
    largest = max(spectra.peak(each.spectrum).value for each in courses)
    said = shown(same_unit(each.unit for each in courses), largest)
    return [
        each._replace(
            unit=unit_text(said.unit),
            spectrum=spectra.scaled(each.spectrum, said.factor),
            ends=tuple(spectra.scaled(end, said.factor) for end in each.ends),
            piston=each.piston * said.factor,
        )
        for each in courses
    ]


def several(engines: Engines) -> Sequence[Engine]:
    """The engines of a figure. Raises ChartError where there is none."""
    if not engines:
        raise ChartError(_("no engine is given; name at least one"))
    return [engines] if isinstance(engines, Engine) else engines


def checked_quantity(quantity: Q, among: object = Quantity) -> Q:
    """A quantity that a figure can show; raises ChartError."""
    if quantity not in get_args(among):
        raise ChartError(
            _(
                "{quantity} is not a quantity of this figure; give one of {quantities}",
                quantity=repr(quantity),
                quantities=", ".join(get_args(among)),
            )
        )
    return quantity
