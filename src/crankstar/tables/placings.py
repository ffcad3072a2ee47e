"""Where balance shafts were placed, what they leave of the roll, where they would leave none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from crankstar.analysis.document import Remarks, remarks
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given
from crankstar.language.messages import _
from crankstar.language.shown_units import quantity_text
from crankstar.language.written import joined
from crankstar.mechanics.balance import scales as scales_of
from crankstar.remedy import Placing, clashes
from crankstar.remedy.clearance import beyond_ends, raised
from crankstar.tables.scales import scales


def placing_lines(
    engine: Engine, placings: Sequence[Placing], *, speed: float | None
) -> Iterator[Remarks]:
    """The sentences on the places of balance shafts, order by order."""
    lines = [line for placing in placings for line in _lines(engine, placing, speed)]
    if lines:
        lines.append(
            _("`crankstar plot FILE balance-shafts` draws them, FILE being the one that -o writes.")
        )
    if lines and engine.block is not None:
        lines.append(_("The rolling moment is taken about the centre of mass of the block."))
    yield from remarks(*lines, title=_("Places of the balance shafts"))
    yield from remarks(*_clash_lines(engine), *_beyond_lines(engine), kind="doubt")


def _clash_lines(engine: Engine) -> Iterator[str]:
    """A sentence for each pair of shafts that would be inside one another."""
    across = scales(engine).across
    for clash in clashes(engine):
        values = {
            "first": clash.first,
            "second": clash.second,
            "distance": across.text(clash.distance),
            "needed": across.text(raised(clash.needed)),
        }
        yield (
            _(
                "{first} is {distance} from the axis of {second} and would be inside what that "
                "crankshaft sweeps; by usual proportions it needs {needed}.",
                **values,
            )
            if clash.crank
            else _(
                "{first} is {distance} from {second} and would be inside it; by usual proportions "
                "it needs {needed}: give each shaft a --box of its own.",
                **values,
            )
        )


def _beyond_lines(engine: Engine) -> Iterator[str]:
    """A sentence for each shaft with a weight far beyond the crankshaft."""
    along = scales(engine).along
    for shaft, z in beyond_ends(engine):
        yield _(
            "A weight of {name} is at z = {z}, far beyond the crankshaft: a shaft apart from the "
            "engine, or a mistake.",
            name=shaft.name,
            z=along.text(z),
        )


def _lines(engine: Engine, placing: Placing, speed: float | None) -> Iterator[str]:
    (_force, _couple, moment), units = scales_of(engine, speed)
    across = scales(engine).across

    def place(at: complex) -> str:
        return _("{up} up, {right} right", up=across.text(at.real), right=across.text(at.imag))

    values = {
        "order": str(placing.order),
        "roll": quantity_text(placing.roll * moment, units.moment),
        "on_axis": quantity_text(placing.on_axis * moment, units.moment),
        "places": joined("; ", map(place, placing.places)),
    }
    inside = as_given(("inside", placing.order), placing.inside)
    if inside is not None:
        yield _(
            "Order {order}: the least rolling moment in the box, clear of cranks and other shafts, "
            "is {roll}, with {places}.",
            **values,
        )
    elif placing.roll:
        yield _(
            "Order {order}: the least rolling moment in the box is {roll}, with {places}.", **values
        )
    else:
        yield _("Order {order}: no rolling moment remains with {places}.", **values)
    if inside is not None:
        yield _(
            "Less would remain with {place}, but there the shaft would be inside what a crankshaft "
            "or another shaft sweeps, by usual proportions.",
            place=place(inside),
        )
    yield _(
        "On the crank axis, or as a pair symmetric about it, the shafts would leave {on_axis}.",
        **values,
    )
    free = placing.without_roll
    if free is None or not placing.roll:
        return
    mean = sum(placing.places) / len(placing.places)
    values |= {"free": place(free), "distance": across.text(abs(mean - free))}
    if len(placing.places) > 1:
        yield _(
            "None would remain with the middle of the shafts at {free}, {distance} away.", **values
        )
        return
    yield _(
        "None would remain with the shaft at {free}, {distance} away: the rest is the force of the "
        "shaft times this distance. Two shafts with half of the unbalance each leave none where "
        "they are symmetric about that place.",
        **values,
    )
