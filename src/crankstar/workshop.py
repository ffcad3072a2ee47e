"""What a balancing shop works from: the bobweight of each pin, the weights, and what they leave."""

from __future__ import annotations

from math import degrees

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar import phasor
from crankstar.balance import balance, total
from crankstar.engine import Engine
from crankstar.remedy import bobweight, loads
from crankstar.wording import number, table, titled


def balance_card(before: Engine, after: Engine, factor: float) -> RenderableType:
    """The bobweight card of an engine, the weights of the balanced one, and what they leave."""
    return Group(Text(before.name, style="bold"), _bobweights(before, factor), _weights(after), _left(before, after))


def _mass_unit(engine: Engine) -> tuple[float, str]:
    return (1.0, "m") if "mass" in engine.relative else (1000.0, "g")


def _bobweights(engine: Engine, factor: float) -> RenderableType:
    scale, unit = _mass_unit(engine)
    out = table(
        "pin", "cylinders", f"rotating [{unit}]", f"reciprocating [{unit}]", f"bobweight [{unit}]", left=("pin", "cylinders")
    )
    shared = {len(pin.cylinders) for pin in loads(engine) if pin.cylinders}
    for pin in loads(engine):
        name = f"{pin.shaft} {pin.throw}" if len(engine.shafts) > 1 else str(pin.throw)
        masses = (pin.rotating, pin.reciprocating, bobweight(pin, factor))
        out.add_row(Text(name), ", ".join(map(str, pin.cylinders)) or "-", *(number(mass * scale) for mass in masses))
    said = f"Bobweight = rotating + {number(factor)} × reciprocating, of all cylinders on the pin, at the crank radius."
    for count in sorted(shared - {1}):
        said += f" Counted in one cylinder of the {count} on a pin it is a factor of {number(factor * count)}."
    return Group(titled("Bobweights", out), Text(said))


def _weights(engine: Engine) -> RenderableType:
    mass, length = "m" if "mass" in engine.relative else "kg", "r" if "radius" in engine.relative else "m"
    along, place = (1.0, "a") if "pitch" in engine.relative else (1000.0, "mm")
    radius = engine.throw(engine.first).radius
    scale, unit = _mass_unit(engine)
    heads = (
        "shaft",
        f"z [{place}]",
        "bearing at θ = 0 [deg]",
        f"unbalance [{mass} {length}]",
        f"as mass at the crank radius [{unit}]",
    )
    out = table(*heads, left=("shaft",))
    for shaft in engine.shafts:
        for weight in shaft.weights:
            row = (number(weight.z * along, along), number(degrees(weight.angle), 180.0), number(weight.unbalance))
            out.add_row(Text(shaft.name), *row, number(weight.unbalance / radius * scale))
    return titled("Weights", out)


def _left(before: Engine, after: Engine) -> RenderableType:
    """The orders in which something was put on the engine, before and after."""
    orders = sorted({1.0} | {abs(float(shaft.speed_ratio)) for shaft in after.shafts if shaft.weights})
    out = table("order", "", "with the crank", "against it", "greatest", left=("",))
    sums = {"as it was": total(balance(before)), "now": total(balance(after))}
    for order in orders:
        for name, unit in (("force", "m r ω²"), ("couple", "m r ω² a")):
            largest = max(_sizes(getattr(sums["as it was"], quantity), order)[2] for quantity in ("force", "couple")) or 1.0
            for told, found in sums.items():
                sizes = _sizes(getattr(found, name), order)
                out.add_row(number(order), f"{name} {told} [{unit}]", *(number(size, largest) for size in sizes))
    return titled("What is left", out)


def _sizes(spectrum: phasor.Spectrum, order: float) -> tuple[float, float, float]:
    """The vectors with and against the crank, and the greatest value over a turn."""
    one = phasor.selected(spectrum, [order])
    forward, backward = abs(complex(one.forward[0])), abs(complex(one.backward[0]))
    return forward, backward, forward + backward
