"""The balancing sheet: bobweights, weights, shafts, what they leave and what removes the rest."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.document import ROW_UNIT, Column, Document, Remarks, Table, Value, remarks
from crankstar.dynamics.bearings import Model
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import RPM, number, order_text
from crankstar.mechanics import bounds
from crankstar.mechanics.balance import Balance, Units, balance, total
from crankstar.mechanics.balance import scales as scales_of
from crankstar.mechanics.excitation import rolling_moment
from crankstar.mechanics.remains import OPTIMISED, Sums, summed
from crankstar.remedy import Best, Placing, balance_shafts, bearing_load, changes, needs
from crankstar.remedy.kept import Changes, vectors
from crankstar.studies.load_answers import balanced
from crankstar.tables.bobweights import bobweights
from crankstar.tables.certificate import certificate
from crankstar.tables.cures import cure_lines, fitted_lines, none_remains
from crankstar.tables.gas_rolls import GasRoll, change_sentence, gas_roll_of, gasless_reason
from crankstar.tables.placings import placing_lines
from crankstar.tables.scales import Scale, scales
from crankstar.tables.turning import bearing, turning

LOADS = {
    "determinate": N_("greatest load on a main bearing"),
    "continuous": N_("greatest load on a main bearing, crankshaft as one beam"),
}
SIZED = N_(
    "Each range is that of engines whose weights and shafts are sized for their own masses. "
    "Weights that are made before the masses are known leave more: `crankstar analyze` of the "
    "file written with -o."
)
"""What the ranges of a balance of estimated masses mean."""


GAS_ROWS = N_(
    "Gas is in the rows of the rolling moment with gas alone, not in the load on a main bearing."
)


class Job(NamedTuple):
    """An engine before and after, and by which balance factor or best weights.

    `description` says what was fitted where neither of them does.
    Masses of counterweights are given at `radius`, those of balance shafts at `shaft_radius` (m or
    crank radii), else at the crank radius; at `speed` (rad/s) what remains is given in N and N m.
    `idle` are the speed ratios of shafts that would have had nothing to do.
    """

    before: Engine
    after: Engine
    factor: float | None = None
    best: Best | None = None
    radius: float | None = None
    speed: float | None = None
    description: str = ""
    placings: tuple[Placing, ...] = ()
    model: Model = "determinate"
    shaft_radius: float | None = None
    idle: tuple[Fraction, ...] = ()

    @property
    def weighted(self) -> bool:
        """Whether counterweights were sized, or taken away, and not left as they were."""
        became = changes(self.before, self.after)
        cranks = [became[shaft.name] for shaft in self.after.shafts if shaft.throws]
        changed = any(each.added or each.replaced for each in cranks)
        return self.factor is not None or self.best is not None or changed

    @property
    def sized(self) -> bool:
        """Whether there are weights that were sized for the masses of the engine."""
        return any(own.added for own in changes(self.before, self.after).values())


def balancing_sheet(job: Job) -> Document:
    """The bobweights of an engine, the weights and shafts of the balanced one, what remains."""
    return Document(job.before.name, tuple(parts(job)), {"engine": job.before.name})


def parts(job: Job) -> Iterator[Table | Remarks]:
    """The sheet without its title."""
    yield from remarks(*fitted_lines(job.before), job.description, *_greater_left(job))
    if job.weighted:
        yield _bobweights(job)
    if job.best is not None:
        yield Remarks(tuple(certificate(job.best, speed=job.speed)), _("Best weights"))
    yield _weights(job)
    if job.weighted:
        yield from turning(job.before, job.after, speed=job.speed)
    if balance_shafts(job.after):
        yield _shafts(job)
        yield from placing_lines(job.after, job.placings, speed=job.speed)
    yield _remaining(job)
    yield from _needed(job)


def _greater_left(job: Job) -> Iterator[str]:
    """A sentence where what remains of one order is greater than all that is removed of another."""
    before, after = (balance(each, speed=job.speed) for each in (job.before, job.after))
    sums = summed(before), summed(after)
    left = {abs(float(need.ratio)) for need in needs(job.after, zero=OPTIMISED)}
    for name, word in (("force", _("force")), ("couple", _("couple"))):
        for order, other in ((1.0, 2.0), (2.0, 1.0)):
            (_was, stays), (old, new) = (
                [float(bounds.greatest(*p)) for p in _vectors(sums, name, k, after.units)]
                for k in (order, other)
            )
            if order in left and stays > old - new > OPTIMISED * old:
                yield _(
                    "The {quantity} of order {order} remains, and is greater than that of order "
                    "{other}, which is removed or reduced.",
                    quantity=word,
                    order=order_text(order),
                    other=order_text(other),
                )


def _bobweights(job: Job) -> Table:
    notes: list[str] = []
    if job.factor is None and any(shaft.weights for shaft in job.after.shafts if shaft.throws):
        notes.append(
            _(
                "The weights fitted follow no balance factor; these bobweights are for a "
                "factor of 0.5."
            )
        )
    return bobweights(job.before, 0.5 if job.factor is None else job.factor, notes=notes)


def _weights(job: Job) -> Table:
    engine = job.after
    across, along, mass, unbalance = scales(engine)
    became = changes(job.before, job.after)
    listed = [shaft for shaft in engine.shafts if job.weighted or not shaft.throws]
    kept = any(became[shaft.name].kept for shaft in listed)
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("weight"), kind="text", key="origin", machine=not kept),
        Column("z", along.unit, key="z"),
        Column(_("bearing at θ = 0"), "deg", key="bearing_deg"),
        Column(_("unbalance"), unbalance.unit, key="unbalance"),
        Column(_("mass"), mass.unit, key="mass"),
    )
    rows = tuple(
        (
            shaft.name,
            origin,
            along.of(weight.z),
            bearing(weight.angle),
            weight.unbalance * unbalance.factor,
            weight.unbalance / _radius(job, shaft) * mass.factor,
        )
        for shaft in listed
        for origin, weights in _by_origin(became[shaft.name])
        for weight in weights
    )
    notes = _mass_notes(job, listed, across) if rows else [_("No weights.")]
    if gone := sum(len(each.replaced) for each in became.values()):
        notes.append(
            _n(
                "{count} counterweight of the file is replaced.",
                "{count} counterweights of the file are replaced.",
                gone,
                count=gone,
            )
        )
    if not job.weighted:
        notes.append(
            _(
                "The crankshafts stay as they are; --factor, --weights or --minimise fits "
                "counterweights."
            )
        )
    elif kept and not any(each.added for each in became.values()):
        notes.append(_("The weights of the file suffice; none are added."))
    return Table(_("Weights"), columns, rows, notes=tuple(notes), key="weights")


def _radius(job: Job, shaft: Shaft) -> float:
    """The radius at which the masses of the weights of a shaft are given."""
    given = job.radius if shaft.throws else job.shaft_radius
    return job.after.throw(job.after.first).radius if given is None else given


def _mass_notes(job: Job, listed: Sequence[Shaft], across: Scale) -> list[str]:
    """At which radius masses are given; of two, which is whose."""
    at = {
        bool(shaft.throws): _("the crank radius") if given is None else across.text(given)
        for shaft in listed
        if shaft.weights
        for given in (job.radius if shaft.throws else job.shaft_radius,)
    }
    if len(set(at.values())) > 1:
        return [
            _(
                "Mass: that of a lump, or that missing from a ring, with its centre at {radius}, "
                "on balance shafts at {shaft_radius}.",
                radius=at[True],
                shaft_radius=at[False],
            )
        ]
    (radius,) = set(at.values())
    return [
        _(
            "Mass: that of a lump, or that missing from a ring, with its centre at {radius}.",
            radius=radius,
        )
    ]


def _by_origin(own: Changes) -> tuple[tuple[str, tuple[Weight, ...]], ...]:
    """The weights of a shaft with the word that says where they come from."""
    return (_("file"), own.kept), (_("new"), own.added)


def _shafts(job: Job) -> Table:
    """The balance shafts: what each removes, where it lies, the moment that its place adds."""
    engine = job.after
    result = balance(engine, speed=job.speed)
    across, _along, _mass, unbalance = scales(engine)
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("speed ratio"), kind="text", key="ratio"),
        Column(_("removes"), kind="text", key="removes"),
        Column(_("unbalance"), unbalance.unit, key="unbalance", optional=1),
        Column(_("bearing at θ = 0"), "deg", key="bearing_deg", optional=1),
        Column(_("up"), across.unit, key="up"),
        Column(_("right"), across.unit, key="right"),
        Column(_("rolling moment added"), result.units.moment, key="roll_added"),
    )
    own = balance_shafts(engine)
    rows = tuple(
        (
            shaft.name,
            str(shaft.speed_ratio),
            _task(shaft),
            *_net(shaft, unbalance),
            across.of(shaft.up),
            across.of(shaft.right),
            _roll_added(result, shaft),
        )
        for shaft in own
    )
    notes: list[str] = []
    if any(not (shaft.up or shaft.right) for shaft in own):
        notes.append(
            _(
                "A shaft at 0, 0 adds no rolling moment; --shaft-place and --shaft-spacing give "
                "the real place."
            )
        )
    if job.idle:
        ratios = ", ".join(map(str, job.idle))
        notes.append(
            _n(
                "No shaft of speed ratio {ratios} is added: it would have nothing to do.",
                "No shafts of speed ratios {ratios} are added: they would have nothing to do.",
                len(job.idle),
                ratios=ratios,
            )
        )
    return Table(_("Balance shafts"), columns, rows, notes=tuple(notes), key="balance_shafts")


def _task(shaft: Shaft) -> str:
    """What a balance shaft removes: a force, a couple (opposite weights), or both."""
    vectors = [weight.unbalance * np.exp(1j * weight.angle) for weight in shaft.weights]
    if abs(sum(vectors)) <= 1e-9 * sum(map(abs, vectors)):
        return _("couple")
    one_way = len({round(phase(vector), 9) for vector in vectors}) == 1
    return _("force") if one_way else _("force and couple")


def _net(shaft: Shaft, scale: Scale) -> tuple[float, float]:
    """The unbalance of a shaft and its bearing; of a couple, those of the first weight."""
    own = vectors(shaft.weights)
    net = sum(own, 0j) if _task(shaft) != _("couple") else own[0]
    return abs(net) * scale.factor, bearing(phase(net))


def _roll_added(result: Balance, shaft: Shaft) -> float:
    rows = [
        row
        for row, part in enumerate(result.parts)
        if part.shaft == shaft.name and part.kind == "weight"
    ]
    return bounds.size(spectra.total(result.axis_moment[rows, :]), abs(float(shaft.speed_ratio)))


def _orders(job: Job) -> list[float]:
    """The orders of the sheet: the first, those of shafts with weights, those with a remedy."""
    ratios = [shaft.speed_ratio for shaft in job.after.shafts if shaft.weights]
    ratios += [need.ratio for need in needs(job.after, zero=OPTIMISED)]
    return sorted({1.0} | {abs(float(ratio)) for ratio in ratios})


def resting(job: Job) -> Answer:
    """The figures of the balanced engine that the sheet prints, for what they rest on."""
    result = [balance(each, speed=job.speed) for each in (job.before, job.after)]
    orders = _orders(job) if _gas_rolls(job) else []
    new = [own.weights for own in job.after.shafts] != [own.weights for own in job.before.shafts]
    return balanced(
        job.after,
        fitted=new,
        gas_orders=[order for order in orders if any(_inertia_rolls(result, order))],
        model=job.model,
    )


def _gas_rolls(job: Job) -> tuple[GasRoll, GasRoll] | None:
    """The rolling moments with gas before and after, where they are known."""
    before, after = (gas_roll_of(each, speed=job.speed) for each in (job.before, job.after))
    return None if before is None or after is None else (before, after)


def _inertia_rolls(balances: Sequence[Balance], order: float) -> list[float]:
    """The rolling moments of inertia before and after, of an order."""
    return _cleared([bounds.size(rolling_moment(total(each)), order) for each in balances])


def _remaining(job: Job) -> Table:
    """The orders in which something was put on the engine, or remains, before and after."""
    before, after = (balance(engine, speed=job.speed) for engine in (job.before, job.after))
    sums, orders = (summed(before), summed(after)), _orders(job)
    rows: list[tuple[Value, ...]] = []
    worse: list[str] = []
    for order in orders:
        for name, word in (("force", _("force")), ("couple", _("couple"))):
            pairs = _vectors(sums, name, order, after.units)
            unit = getattr(after.units, name)
            old, new = (bounds.greatest(*pair) for pair in pairs)
            ways = map(bounds.length, pairs[1])
            rows.append((order, word, unit, *_left(job, old, new), *_left(job, *ways)))
            if name == "couple" and new + old and _by_component(job):
                rows += _components(order, unit, pairs)
            if new > old * (1 + OPTIMISED):
                worse.append(
                    _(
                        "These weights make the {quantity} of order {order} larger than before.",
                        quantity=word,
                        order=order_text(order),
                    )
                )
    rolls, notes = _rolls(job, orders, (before, after))
    rows += rolls
    load = _(LOADS[job.model])
    (scale, _couple, _moment), units = scales_of(job.after, job.speed)
    newtons = scale / scales_of(job.after, None)[0].force
    loaded = [bearing_load(engine, model=job.model) * newtons for engine in (job.before, job.after)]
    rows.append((1.0, load, units.force, *_left(job, *_cleared(loaded)), None, None))
    columns = (
        Column(_("order"), key="order", label=True),
        Column(_("quantity"), kind="text", key="quantity", wraps=True),
        Column(_("unit"), kind="unit", key="unit"),
        Column(_("before"), ROW_UNIT, key="before"),
        Column(_("now"), ROW_UNIT, key="now"),
        Column(_("with the crank"), ROW_UNIT, key="forward", optional=2),
        Column(_("against the crank"), ROW_UNIT, key="backward", optional=1),
    )
    title = _("Remaining unbalance")
    if after.speed is not None:
        title = _("Remaining unbalance at {rpm} rpm", rpm=number(after.speed * RPM))
    return Table(title, columns, tuple(rows), notes=(*worse, *notes), key="remaining")


def _rolls(
    job: Job, orders: Sequence[float], balances: tuple[Balance, Balance]
) -> tuple[list[tuple[Value, ...]], list[str]]:
    """Rows of the rolling moment, without gas and with it; what a remedy of it makes worse."""
    unit = balances[1].units.moment
    gas = _gas_rolls(job)
    rows: list[tuple[Value, ...]] = []
    notes: list[str] = []
    for order in orders:
        alone = _inertia_rolls(balances, order)
        if not any(alone):
            continue
        word = _("rolling moment without gas")
        rows.append((order, word, unit, *_left(job, *alone), None, None))
        if gas is None:
            continue
        both = _cleared([abs(each.at(order)) for each in gas])
        word = _("rolling moment with gas")
        rows.append((order, word, "N*m", *_left(job, *both), None, None))
        if both[1] > both[0] * (1 + OPTIMISED):
            notes.append(change_sentence(*gas, order))
    if rows:
        notes.append(_(GAS_ROWS) if gas else gasless_reason(job.before, speed=job.speed))
    return rows, notes


def _by_component(job: Job) -> bool:
    """Whether the best weights are for pitch or yaw, as external moments are limited."""
    if job.best is None:
        return False
    aims = [job.best.aim, *(limit.aim for limit, _value in job.best.limits)]
    return any(aim.quantity == "couple" and aim.up != aim.right for aim in aims)


def _components(
    order: float, unit: str, pairs: Sequence[tuple[complex, complex]]
) -> Iterator[tuple[Value, ...]]:
    """Rows of pitch and yaw before and after."""
    for word, sign in ((_("pitch M_V"), 1), (_("yaw M_H"), -1)):
        sizes = [abs(ahead + sign * against.conjugate()) for ahead, against in pairs]
        yield (order, word, unit, *_cleared(sizes), None, None)


def _left(job: Job, *sizes: float) -> tuple[float, ...]:
    """Sizes with what bounds them, unless best weights were found: these are not linear."""
    return tuple(map(float, sizes)) if job.best is not None else sizes


def _cleared(values: Sequence[float]) -> list[float]:
    """Values before and after; zero is what an optimiser left beside the greater one."""
    return [value if value > OPTIMISED * max(values) else 0.0 for value in values]


def _vectors(
    sums: tuple[Sums, Sums], name: str, order: float, units: Units
) -> list[tuple[complex, complex]]:
    """Forward and backward vectors before and after; what an optimiser leaves is zero."""
    compared = [name, "force"] if units.couple == "m*r*w^2*a" else [name]
    signals = [getattr(sums_, other) for sums_ in sums for other in compared]
    top = max(bounds.size(signal, usual) for signal in signals for usual in (1.0, 2.0))
    pairs: list[tuple[complex, complex]] = []
    for sums_ in sums:
        vector = spectra.selected(getattr(sums_, name), [order])
        ways = (complex(way[0]) for way in (vector.forward, vector.backward))
        forward, backward = (way if abs(way) > OPTIMISED * top else 0j for way in ways)
        pairs.append((forward, backward))
    return pairs


def _needed(job: Job) -> tuple[Remarks, ...]:
    """What would remove the rest of the first two orders; no other weights where they are best."""
    remaining = needs(job.after, zero=OPTIMISED)
    if none := none_remains(job.after, zero=OPTIMISED):
        return remarks(none)
    if job.best is not None:
        cranks = {shaft.speed_ratio for shaft in job.after.shafts if shaft.throws}
        remaining = [need for need in remaining if need.ratio not in cranks]
    lines = cure_lines(job.after, remaining)
    return remarks(*lines, title=_("Further remedies"), kind="list") if lines else ()
