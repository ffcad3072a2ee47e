"""What a balancing shop works from: bobweights, weights and shafts, what they leave, and what would take away the rest."""

from __future__ import annotations

from cmath import phase
from math import degrees, pi
from typing import NamedTuple

import numpy as np
from rich.console import Group, RenderableType
from rich.text import Text

from crankstar import phasor
from crankstar.balance import Balance, balance, total
from crankstar.engine import Engine
from crankstar.mechanism import Totals, block_roll
from crankstar.phasor import Spectrum
from crankstar.records import Shaft
from crankstar.remedy import Aim, Best, bearing_load, bobweight, loads, needs, said
from crankstar.wording import NEGLIGIBLE, bearing_text, cures, number, table, titled, unit_text

_FORCES = ("force", "couple")
QUIET = 1e-6
"""Share of what there is below which a sum is nothing: best weights are found to about a millionth."""
HEAVY = 20.0
"""Masses from which a shop speaks of kilograms, kg."""


class Job(NamedTuple):
    """An engine before and after; by which balance factor, or which best weights; at what radius weights are told as masses.

    `radius` (m or crank radii) is the crank radius where it is None; at `speed` (rad/s) what is left is told in N and N m.
    """

    before: Engine
    after: Engine
    factor: float | None
    best: Best | None = None
    radius: float | None = None
    speed: float | None = None


def balance_card(job: Job) -> RenderableType:
    """The bobweight card of an engine, the weights and shafts of the balanced one, what they leave, and what is needed yet."""
    blocks: list[RenderableType] = [Text(job.before.name, style="bold"), _bobweights(job)]
    if job.best is not None:
        blocks.append(_certificate(job.best))
    blocks.append(_weights(job))
    if any(shaft.weights and not shaft.throws for shaft in job.after.shafts):
        blocks.append(_shafts(job))
    return Group(*blocks, _left(job), _needed(job.after))


def _mass_unit(engine: Engine) -> tuple[float, str]:
    """Factor and unit for masses: of the first piston, or g, or, of large engines, kg."""
    if "mass" in engine.relative:
        return 1.0, "m"
    greatest = max(max(pin.rotating, pin.reciprocating) for pin in loads(engine))
    return (1.0, "kg") if greatest >= HEAVY else (1000.0, "g")


def _bobweights(job: Job) -> RenderableType:
    engine, factor = job.before, 0.5 if job.factor is None else job.factor
    scale, unit = _mass_unit(engine)
    heads = ("pin", "cylinders", f"rotating [{unit}]", f"reciprocating [{unit}]", f"bobweight [{unit}]")
    out = table(*heads, left=("pin", "cylinders"))
    shared = {len(pin.cylinders) for pin in loads(engine) if pin.cylinders}
    for pin in loads(engine):
        name = f"{pin.shaft} {pin.throw}" if len(engine.shafts) > 1 else str(pin.throw)
        masses = (pin.rotating, pin.reciprocating, bobweight(pin, factor))
        out.add_row(Text(name), ", ".join(map(str, pin.cylinders)) or "-", *(number(mass * scale) for mass in masses))
    words = f"Bobweight = rotating + {number(factor)} × reciprocating, of all cylinders on the pin, at the crank radius."
    for count in sorted(shared - {1}):
        words += f" Counted in one cylinder of the {count} on a pin it is a factor of {number(factor * count)}."
    if job.factor is None:
        words += " The weights below follow no balance factor: these bobweights are those of a factor of 0.5."
    return Group(titled("Bobweights", out), Text(words))


def _certificate(best: Best) -> RenderableType:
    """What the best weights reach, and what nothing can beat."""
    value, unit = _counted(best.aim)
    words = f"{said(best.aim).capitalize()}: {number(best.value, best.bare)} {unit}, {number(best.bare)} with bare crankshafts."
    words += f" No weights in these planes{' within the limits' if best.held else ''} make it less than"
    words += f" {number(best.bound, best.bare, digits=7)} {unit} ({value})."
    if best.angles:
        shown = ", ".join(f"{degrees(angle):.4g}" for angle in best.angles[:8])
        words += f" The peak is reached at crank angles {shown}{' ...' if len(best.angles) > 8 else ''} deg."
    lines = [words]
    for limit, found in best.held:
        if limit.quiet:
            lines.append(
                f"The {said(limit.aim)} is not allowed to become more than with bare crankshafts (--limit would allow it)."
            )
            continue
        unit = _counted(limit.aim)[1]
        held = "binding" if found > limit.at_most * (1 - 1e-5) - 1e-9 else "with room"
        lines.append(f"Limit, {said(limit.aim)}: {number(found, best.bare)} of {number(limit.at_most, best.bare)} {unit}, {held}.")
    return Group(Text(), Text("Best weights", style="bold"), *map(Text, lines))


def _counted(aim: Aim) -> tuple[str, str]:
    rule = "the shaft cut through at its main bearings" if aim.quantity == "bearing" else "lower bound by convex duality"
    return rule, "m r ω² a" if aim.quantity == "couple" else "m r ω²"


def _weights(job: Job) -> RenderableType:
    engine = job.after
    radius = engine.throw(engine.first).radius if job.radius is None else job.radius
    scale, unit = _mass_unit(engine)
    across = "r" if "radius" in engine.relative else "mm"
    shown = number(radius * (1.0 if across == "r" else 1000.0))
    where = "the crank radius" if job.radius is None else f"a radius of {shown} {across}"
    along, place = (1.0, "a") if "pitch" in engine.relative else (1.0, "r") if _lone(engine) else (1000.0, "mm")
    counted, product = _unbalance_unit(engine)
    heads = ("shaft", f"z [{place}]", "bearing at θ = 0 [deg]", f"unbalance [{product}]", f"mass [{unit}]")
    out = table(*heads, left=("shaft",))
    for shaft in engine.shafts:
        for weight in shaft.weights:
            row = (number(weight.z * along, along), bearing_text(np.exp(1j * weight.angle)), number(weight.unbalance * counted))
            out.add_row(Text(shaft.name), *row, number(weight.unbalance / radius * scale))
    if not out.row_count:
        return titled("Weights", Text("none"))
    said_so = Text(f"The mass is that of a lump (or the missing mass of a ring) whose centre is at {where}.")
    return Group(titled("Weights", out), said_so)


def _lone(engine: Engine) -> bool:
    """Whether the webs of a lone cylinder without sizes are as far apart as its crank radius has it, for want of a bore pitch."""
    return "radius" in engine.relative and engine.bore_pitch is None and len({cylinder.z for cylinder in engine.cylinders}) == 1


def _unbalance_unit(engine: Engine) -> tuple[float, str]:
    """Factor and unit for unbalances: kg m, or m r where a mass or a radius is not known."""
    if "mass" in engine.relative:
        return 1 / engine.throw(engine.first).radius, "m r"
    return 1.0, "kg r" if "radius" in engine.relative else "kg m"


def _shafts(job: Job) -> RenderableType:
    """The balance shafts: what each is for, its weights together, where it lies, and the roll that its place adds."""
    engine = job.after
    result = balance(engine)
    across, unit = (1.0, "r") if "radius" in engine.relative else (1000.0, "mm")
    heads = ("shaft", "ratio", "takes away", f"up [{unit}]", f"right [{unit}]", "roll it adds [m r² ω²]")
    out = table(*heads, left=("shaft", "takes away"))
    for shaft in engine.shafts:
        if shaft.throws or not shaft.weights:
            continue
        place = (number(shaft.up * across, across), number(shaft.right * across, across))
        out.add_row(Text(shaft.name), str(shaft.speed_ratio), _task(shaft), *place, number(_roll_added(result, shaft)))
    unplaced = any(shaft.weights and not (shaft.throws or shaft.up or shaft.right) for shaft in engine.shafts)
    note = "Shafts at 0, 0 have no place as yet, and so no roll: say where they lie with --shaft-place and --apart."
    return Group(titled("Balance shafts", out), *([Text(note)] if unplaced else []))


def _task(shaft: Shaft) -> str:
    """What kind of vector a balance shaft pushes: a force, a couple (opposite weights), or both."""
    vectors = [weight.unbalance * np.exp(1j * weight.angle) for weight in shaft.weights]
    force = abs(sum(vectors)) > 1e-9 * sum(map(abs, vectors))
    if not force:
        return "couple"
    return "force" if len({round(phase(vector), 9) for vector in vectors}) == 1 else "force and couple"


def _roll_added(result: Balance, shaft: Shaft) -> float:
    rows = [row for row, part in enumerate(result.parts) if part.shaft == shaft.name and part.kind == "weight"]
    roll = phasor.total(result.roll[rows, :])
    return float(np.abs(phasor.amplitude(phasor.selected(roll, [abs(float(shaft.speed_ratio))]))[0]))


def _left(job: Job) -> RenderableType:
    """The orders in which something was put on the engine, before and after: force, couple, roll, and the load on bearings."""
    orders = sorted({1.0} | {abs(float(shaft.speed_ratio)) for shaft in job.after.shafts if shaft.weights})
    out = table("order", "", "with the crank", "against it", "greatest", left=("",))
    results = {"as it was": balance(job.before, speed=job.speed), "now": balance(job.after, speed=job.speed)}
    sums = {told: total(result) for told, result in results.items()}
    units = results["now"].units
    worse: list[str] = []
    for order in orders:
        for name, unit in (("force", units.force), ("couple", units.couple)):
            tops = [
                _sizes(getattr(found, one), any_order)[2] for found in sums.values() for one in _FORCES for any_order in (1.0, 2.0)
            ]
            largest = max(tops) * QUIET / NEGLIGIBLE or 1.0
            before, now = (_sizes(getattr(found, name), order) for found in sums.values())
            for told, sizes in zip(sums, (before, now), strict=True):
                out.add_row(number(order), f"{name} {told} [{unit_text(unit)}]", *(number(size, largest) for size in sizes))
            if now[2] > before[2] * (1 + 1e-6) + QUIET * max(tops):
                worse.append(f"{name} of order {order:g}")
    balancers = {abs(float(shaft.speed_ratio)) for shaft in job.after.shafts if shaft.weights and not shaft.throws}
    for order in sorted(balancers):
        rolls = {told: _rolls(found, order) for told, found in sums.items()}
        for told, size in rolls.items():
            unit = unit_text(units.roll)
            out.add_row(number(order), f"roll of the block {told} [{unit}]", "", "", number(size, max(*rolls.values(), 1e-300)))
    for told, engine in (("as it was", job.before), ("now", job.after)):
        out.add_row("1", f"greatest load on a main bearing {told} [m r ω²]", "", "", number(bearing_load(engine)))
    title = "What is left" if job.speed is None or units.force != "N" else f"What is left at {number(job.speed * 30 / pi)} rpm"
    lines: list[RenderableType] = [titled(title, out)]
    if worse:
        lines.append(Text(f"These weights make the {' and the '.join(worse)} larger than before."))
    return Group(*lines)


def _rolls(sums: Totals, order: float) -> float:
    return float(np.abs(phasor.amplitude(phasor.selected(block_roll(sums), [order]))[0]))


def _sizes(spectrum: Spectrum, order: float) -> tuple[float, float, float]:
    """The vectors with and against the crank, and the greatest value over a turn."""
    one = phasor.selected(spectrum, [order])
    forward, backward = abs(complex(one.forward[0])), abs(complex(one.backward[0]))
    return forward, backward, forward + backward


def _needed(engine: Engine) -> RenderableType:
    """In words, what would take away the rest of the first and the second order."""
    found = needs(engine, heard=QUIET)
    if not found:
        return Text("\nNo force and no couple of the first and the second order is left.")
    lines = [Text(f"- {told}") for told in cures(engine, found)]
    return Group(Text(), Text("What would take away the rest", style="bold"), *lines)
