"""The bobweight of each pin, and how far it is from that of one half."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from crankstar.analysis.document import Column, Table, Value
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.remedy.loads import Load, bobweight, loads, slave_error
from crankstar.tables.scales import scales


def bobweights(engine: Engine, factor: float, *, notes: Sequence[str] = ()) -> Table:
    """Rotating and reciprocating mass of each pin, and its bobweight."""
    scale, pins = scales(engine).mass, loads(engine)
    columns = (
        Column(_("pin"), kind="text", key="pin", label=True),
        Column(_("cylinders"), kind="list", key="cylinders"),
        Column(_("rotating"), scale.unit, key="rotating"),
        Column(_("reciprocating"), scale.unit, key="reciprocating"),
        Column(bobweight_heading(engine), scale.unit, key="bobweight"),
    )
    rows: list[tuple[Value, ...]] = []
    for pin in pins:
        masses = (pin.rotating, pin.reciprocating, bobweight(pin, factor))
        cells = (pin_name(engine, pin), tuple(pin.cylinders))
        rows.append((*cells, *(mass * scale.factor for mass in masses)))
    own = (
        *(_without_rotating(engine) or [_bobweight_law(factor)]),
        *(
            _(
                "As a share of the reciprocating mass of one of the {count} cylinders on "
                "a pin, the "
                "balance factor is {factor}.",
                count=count,
                factor=number(factor * count),
            )
            for count in sorted({len(pin.cylinders) for pin in pins} - {0, 1})
        ),
        *([] if lacks_rotating(engine) else _off_half(pins, factor)),
        *_own(pins),
        *_slaves(engine, pins),
    )
    title = _("Bobweights")
    if lacks_rotating(engine):
        title = _("No bobweights: the rotating masses are missing")
    return Table(title, columns, tuple(rows), notes=(*own, *notes), key="bobweights")


def _bobweight_law(factor: float) -> str:
    return _(
        "Bobweight = rotating + {factor} × reciprocating, of all cylinders on the pin, at the "
        "crank radius.",
        factor=number(factor),
    )


def lacks_rotating(engine: Engine) -> bool:
    """Whether the file has no mass that turns with a crankpin, in kg or in the mass of a piston."""
    return not any(pin.rotating for pin in loads(engine))


def bobweight_heading(engine: Engine) -> str:
    """What a bobweight is called; without rotating masses it is none."""
    return _("share of the reciprocating mass") if lacks_rotating(engine) else _("bobweight")


def _without_rotating(engine: Engine) -> list[str]:
    if not lacks_rotating(engine):
        return []
    return [
        _(
            "The file gives no rotating mass: these are shares of the reciprocating mass, and no "
            "bobweights. Add cylinder.rotating_mass, or cylinder.parts with big_end and "
            "bearing_shells."
        )
    ]


def pin_name(engine: Engine, pin: Load) -> str:
    """The number of a pin, after the name of its shaft where there are several."""
    return f"{pin.shaft} {pin.throw}" if len(engine.shafts) > 1 else str(pin.throw)


def _own(pins: Sequence[Load]) -> list[str]:
    if not any(pin.own for pin in pins):
        return []
    return [
        _(
            "The throw_mass of the file, crank pin and webs, is in no bobweight: it turns in the "
            "balancing machine too. Counterweights balance both."
        )
    ]


def _slaves(engine: Engine, pins: Sequence[Load]) -> Iterator[str]:
    """How far the masses of articulated rods, counted at their crank pin, are off: of the worst."""
    own = [(slave_error(engine, pin), pin) for pin in pins if bobweight(pin, 0.5)]
    error, pin = max(own, key=lambda each: each[0], default=(0.0, None))
    if pin is None or not error:
        return
    yield _(
        "Articulated rods count as if their knuckle pins were at the crank pin. Of pin {pin} all "
        "that turns with the crank differs by {mass} from its rotating masses and half of its "
        "reciprocating ones, {share} %.",
        pin=pin_name(engine, pin),
        mass=scales(engine).mass.text(error),
        share=number(100 * error / bobweight(pin, 0.5), digits=2),
    )


def _off_half(pins: Sequence[Load], factor: float) -> list[str]:
    """By how much a factor is above or below one half, in both ways in which shops count it."""
    own = [pin for pin in pins if pin.reciprocating and len(pin.cylinders) > 1]
    usual = sum(bobweight(pin, 0.5) for pin in own)
    if not own or factor == 0.5 or not usual:
        return []
    heavier = sum(bobweight(pin, factor) for pin in own) / usual - 1
    values = {
        "points": number(abs(factor - 0.5) * 100, digits=4),
        "share": number(abs(heavier) * 100, digits=4),
    }
    if factor > 0.5:
        over = _(
            "This is an overbalance of {points} % of the reciprocating mass; the bobweight is "
            "{share} % heavier than with 50 %.",
            **values,
        )
        return [over]
    under = _(
        "This is an underbalance of {points} % of the reciprocating mass; the bobweight is "
        "{share} % lighter than with 50 %.",
        **values,
    )
    return [under]
