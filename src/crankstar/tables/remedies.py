"""The balancing sheet: bobweights, weights and shafts, what they leave and what removes the rest."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from math import degrees, pi
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.mechanics.balance import Balance, balance, total
from crankstar.mechanics.excitation import rolling_moment
from crankstar.mechanics.remains import OPTIMISED, Sums, size, summed
from crankstar.remedy import Best, bearing_load, bobweight, loads, needs
from crankstar.spectra import Spectrum
from crankstar.tables.certificate import certificate
from crankstar.tables.cures import cure_lines
from crankstar.tables.table import Column, Document, Remarks, Table, Value, remarks

HEAVY = 20.0
"""Masses from which they are given in kilograms, kg."""


class Job(NamedTuple):
    """An engine before and after, and by which balance factor or best weights.

    Masses of weights are given at `radius` (m or crank radii), else at the crank radius; at `speed`
    (rad/s) what remains is given in N and N m.
    """

    before: Engine
    after: Engine
    factor: float | None
    best: Best | None = None
    radius: float | None = None
    speed: float | None = None


def balancing_sheet(job: Job) -> Document:
    """The bobweights of an engine, the weights and shafts of the balanced one, what remains."""
    return Document(job.before.name, tuple(parts(job)), {"engine": job.before.name})


def parts(job: Job) -> Iterator[Table | Remarks]:
    """The sheet without its title."""
    yield _bobweights(job)
    if job.best is not None:
        yield Remarks(tuple(certificate(job.best)), _("Best weights"))
    yield _weights(job)
    if any(shaft.weights and not shaft.throws for shaft in job.after.shafts):
        yield _shafts(job)
    yield _remaining(job)
    yield from _needed(job.after)


def _mass_unit(engine: Engine) -> tuple[float, str]:
    """Factor and unit for masses: of the first piston, or g, or, of large engines, kg."""
    if "mass" in engine.relative:
        return 1.0, "m"
    greatest = max(max(pin.rotating, pin.reciprocating) for pin in loads(engine))
    return (1.0, "kg") if greatest >= HEAVY else (1000.0, "g")


def _bobweights(job: Job) -> Table:
    engine, factor = job.before, 0.5 if job.factor is None else job.factor
    scale, unit = _mass_unit(engine)
    columns = (
        Column(_("pin"), kind="text", key="pin", label=True),
        Column(_("cylinders"), kind="list", key="cylinders"),
        Column(_("rotating"), unit, key="rotating"),
        Column(_("reciprocating"), unit, key="reciprocating"),
        Column(_("bobweight"), unit, key="bobweight"),
    )
    rows: list[tuple[Value, ...]] = []
    for pin in loads(engine):
        name = f"{pin.shaft} {pin.throw}" if len(engine.shafts) > 1 else str(pin.throw)
        masses = (pin.rotating, pin.reciprocating, bobweight(pin, factor))
        rows.append((name, tuple(pin.cylinders), *(mass * scale for mass in masses)))
    shared = {len(pin.cylinders) for pin in loads(engine)} - {0, 1}
    notes = [
        _(
            "Bobweight = rotating + {factor} × reciprocating, of all cylinders on the pin, at the "
            "crank radius.",
            factor=number(factor),
        ),
        *(
            _(
                "Counted in one of the {count} cylinders on a pin, the balance factor is {factor}.",
                count=count,
                factor=number(factor * count),
            )
            for count in sorted(shared)
        ),
    ]
    if job.factor is None:
        notes.append(
            _(
                "The weights below follow no balance factor; these bobweights are for a factor of 0.5."
            )
        )
    return Table(_("Bobweights"), columns, tuple(rows), notes=tuple(notes), key="bobweights")


def _weights(job: Job) -> Table:
    engine = job.after
    radius = engine.throw(engine.first).radius if job.radius is None else job.radius
    scale, unit = _mass_unit(engine)
    along, place = _along(engine)
    counted, product = _unbalance_unit(engine)
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column("z", place, key="z"),
        Column(_("bearing at θ = 0"), "deg", key="bearing_deg"),
        Column(_("unbalance"), product, key="unbalance"),
        Column(_("mass"), unit, key="mass"),
    )
    rows = tuple(
        (
            shaft.name,
            round(weight.z * along, 9) + 0.0,
            _bearing(weight.angle),
            weight.unbalance * counted,
            weight.unbalance / radius * scale,
        )
        for shaft in engine.shafts
        for weight in shaft.weights
    )
    at = _("the crank radius")
    if job.radius is not None:
        across = "r" if "radius" in engine.relative else "mm"
        at = f"{number(radius * (1.0 if across == 'r' else 1000.0))} {across}"
    note = _("Mass: of a lump, or missing from a ring, with its centre at {radius}.", radius=at)
    notes = (note,) if rows else (_("No weights."),)
    return Table(_("Weights"), columns, rows, notes=notes, key="weights")


def _bearing(angle: float) -> float:
    bearing = round(degrees(phase(complex(np.exp(1j * angle)))), 3)
    return 180.0 if bearing == -180 else bearing + 0.0


def _along(engine: Engine) -> tuple[float, str]:
    """Factor and unit along the crankshaft: mm, a, or r for a lone cylinder without sizes."""
    if "pitch" in engine.relative:
        return 1.0, "a"
    lone = len({cylinder.z for cylinder in engine.cylinders}) == 1 and engine.bore_pitch is None
    return (1.0, "r") if lone and "radius" in engine.relative else (1000.0, "mm")


def _unbalance_unit(engine: Engine) -> tuple[float, str]:
    """Factor and unit for unbalances: kg m, or m r where a mass or a radius is not known."""
    if "mass" in engine.relative:
        return 1 / engine.throw(engine.first).radius, "m*r"
    return 1.0, "kg*r" if "radius" in engine.relative else "kg*m"


def _shafts(job: Job) -> Table:
    """The balance shafts: what each removes, where it lies, the moment that its place adds."""
    engine = job.after
    result = balance(engine)
    across, unit = (1.0, "r") if "radius" in engine.relative else (1000.0, "mm")
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("speed ratio"), kind="text", key="ratio"),
        Column(_("removes"), kind="text", key="removes"),
        Column(_("up"), unit, key="up"),
        Column(_("right"), unit, key="right"),
        Column(_("rolling moment added"), "m*r^2*w^2", key="roll_added"),
    )
    own = [shaft for shaft in engine.shafts if shaft.weights and not shaft.throws]
    rows = tuple(
        (
            shaft.name,
            str(shaft.speed_ratio),
            _task(shaft),
            round(shaft.up * across, 9) + 0.0,
            round(shaft.right * across, 9) + 0.0,
            _roll_added(result, shaft),
        )
        for shaft in own
    )
    note = _(
        "A shaft at 0, 0 adds no rolling moment; --shaft-place and --shaft-spacing give the real "
        "place."
    )
    notes = (note,) if any(not (shaft.up or shaft.right) for shaft in own) else ()
    return Table(_("Balance shafts"), columns, rows, notes=notes, key="balance_shafts")


def _task(shaft: Shaft) -> str:
    """What a balance shaft removes: a force, a couple (opposite weights), or both."""
    vectors = [weight.unbalance * np.exp(1j * weight.angle) for weight in shaft.weights]
    if abs(sum(vectors)) <= 1e-9 * sum(map(abs, vectors)):
        return _("couple")
    one_way = len({round(phase(vector), 9) for vector in vectors}) == 1
    return _("force") if one_way else _("force and couple")


def _roll_added(result: Balance, shaft: Shaft) -> float:
    rows = [
        row
        for row, part in enumerate(result.parts)
        if part.shaft == shaft.name and part.kind == "weight"
    ]
    moment = spectra.total(result.axis_moment[rows, :])
    return float(
        abs(spectra.amplitude(spectra.selected(moment, [abs(float(shaft.speed_ratio))]))[0])
    )


class Line(NamedTuple):
    """A row of what remains: quantity and unit, and the vectors before and after."""

    order: float
    quantity: str
    unit: str
    before: tuple[float, float]
    after: tuple[float, float]


def _remaining(job: Job) -> Table:
    """The orders in which something was put on the engine, before and after."""
    before, after = (balance(engine, speed=job.speed) for engine in (job.before, job.after))
    fitted = [shaft for shaft in job.after.shafts if shaft.weights]
    orders = sorted({1.0} | {abs(float(shaft.speed_ratio)) for shaft in fitted})
    lines: list[Line] = []
    sums = summed(before), summed(after)
    for order in orders:
        lines += [_vector_line(sums, name, order, after) for name in ("force", "couple")]
    shafts = {abs(float(shaft.speed_ratio)) for shaft in fitted if not shaft.throws}
    for order in sorted(shafts):
        rolls = [size(rolling_moment(total(result)), order) for result in (before, after)]
        least = OPTIMISED * max(rolls)
        pairs = [(roll if roll > least else 0.0, 0.0) for roll in rolls]
        lines.append(Line(order, _("rolling moment"), after.units.moment, pairs[0], pairs[1]))
    columns = (
        Column(_("order"), key="order", label=True),
        Column(_("quantity"), kind="text", key="quantity", wraps=True),
        Column(_("unit"), kind="text", key="unit"),
        Column(_("before"), key="before"),
        Column(_("now"), key="now"),
        Column(_("with the crank"), key="forward", optional=2),
        Column(_("against the crank"), key="backward", optional=1),
    )
    rows: list[tuple[Value, ...]] = []
    for line in lines:
        turning = line.after if line.quantity != _("rolling moment") else (None, None)
        rows.append(
            (
                line.order,
                line.quantity,
                unit_text(line.unit),
                sum(line.before),
                sum(line.after),
                *turning,
            )
        )
    load = _("greatest load on a main bearing")
    bearing = (bearing_load(job.before), bearing_load(job.after))
    rows.append((1.0, load, "m r ω²", *bearing, None, None))
    worse = [line for line in lines if sum(line.after) > sum(line.before) * (1 + OPTIMISED)]
    notes = tuple(
        _(
            "These weights make the {quantity} of order {order} larger than before.",
            quantity=line.quantity,
            order=number(line.order),
        )
        for line in worse
        if line.quantity != _("rolling moment")
    )
    title = _("Remaining unbalance")
    if job.speed is not None and after.units.force == "N":
        title = _("Remaining unbalance at {rpm} rpm", rpm=number(job.speed * 30 / pi))
    return Table(title, columns, tuple(rows), notes=notes, key="remaining")


def _vector_line(sums: tuple[Sums, Sums], name: str, order: float, result: Balance) -> Line:
    """Forward and backward vectors before and after; what an optimiser leaves is zero."""
    top = max(size(getattr(one, name), other) for one in sums for other in (1.0, 2.0))
    if name == "couple" and result.units.couple == "m*r*w^2*a":
        top = max(top, *(size(one.force, other) for one in sums for other in (1.0, 2.0)))
    pairs = [_ways(getattr(one, name), order, OPTIMISED * top) for one in sums]
    word = _("force") if name == "force" else _("couple")
    return Line(order, word, getattr(result.units, name), pairs[0], pairs[1])


def _ways(spectrum: Spectrum, order: float, least: float) -> tuple[float, float]:
    one = spectra.selected(spectrum, [order])
    forward, backward = abs(complex(one.forward[0])), abs(complex(one.backward[0]))
    return (forward if forward > least else 0.0, backward if backward > least else 0.0)


def _needed(engine: Engine) -> tuple[Remarks, ...]:
    """What would remove the rest of the first and the second order."""
    found = needs(engine, zero=OPTIMISED)
    if not found:
        return remarks(_("No primary or secondary force or couple remains."))
    return remarks(*cure_lines(engine, found), title=_("Further remedies"), kind="list")
