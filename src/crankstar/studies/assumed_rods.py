"""What is assumed of rods: where they stand on their crankpins, how long they are, master rods."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from math import isclose

from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.changed_rods import (
    masters,
    pins_at_one_place,
    rods_at_one_place,
    with_master_mass,
    with_pins_apart,
    with_rods_apart,
    with_rods_of,
    with_slave_rods,
)
from crankstar.engine.basis import ROD_SOURCE
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import proportion
from crankstar.engine.records import Cylinder
from crankstar.engine.weighed import EngineType
from crankstar.language.messages import N_

ROD_WIDTH = 0.3
"""Width of a big end over the bore, at most: 0.2 to 0.3 in vehicles. Our judgement."""
STAGGER = (0.35, 0.65)
"""Distance of opposite pins over the bore, a rod and a web of each. Our judgement."""
MASTER_ENDS = (2.0, 6.0)
"""What turns of a master rod over that of a slave rod: its big end has the flanges and pins of all.

No radial engine of the catalog has masses of its rods: our judgement.
"""
SLAVE_ENDS = (0.98, 1.02)
"""Length of a slave rod over the master's rod less the knuckle radius. Our judgement.

Such lengths put the pistons at one height at the dead centres, but for the swing of the knuckles.
"""


def rods(engine: Engine, kind: EngineType | None) -> Iterator[Assumption]:
    """What is assumed of the rods of an engine of this type, None where it is not known."""
    yield from _lengths(engine, kind)
    yield from _beside(engine, kind)
    yield from _masters(engine)


def _lengths(engine: Engine, kind: EngineType | None) -> Iterator[Assumption]:
    """Rod lengths that are assumed, l = 4 r, with the range of the type."""
    for path, origin in engine.provenance.items():
        if origin.status != "placeholder" or not origin.source.endswith(ROD_SOURCE):
            continue
        radius = engine.throw(engine.first).radius
        ends = (3.2, 4.8)
        if kind is not None and kind != "crosshead":
            usual = proportion("rod length", kind)
            ends = usual.low, usual.high
        yield Assumption(
            "assumed",
            path,
            N_("neither rod length nor l/r in the file"),
            value=engine.first.rod_length / radius,
            unit="r",
            low=min(ends[0], engine.first.rod_length / radius),
            high=max(ends[1], engine.first.rod_length / radius),
            vary=with_rods_of,
        )
        return


def _beside(engine: Engine, kind: EngineType | None) -> Iterator[Assumption]:
    """Rods of one crankpin, or opposite crankpins, at the same place.

    In mm; where the file has no bore pitch, which the couples are counted in then, in bore pitches
    of usual bores.
    """
    of_pitch = "pitch" in engine.relative
    if "radius" in engine.relative and not of_pitch:
        return
    pins, pairs = pins_at_one_place(engine), rods_at_one_place(engine)
    if of_pitch:
        usual = proportion("bore pitch", "petrol" if kind in (None, "crosshead") else kind)
        unit, bore, factor = "a", 1 / usual.typical, engine.bore_pitch or 1.0
    else:
        unit, factor = "mm", 1e-3
        bore = 1e3 * max(own.bore or 2 * engine.throw(own).radius for own in engine.cylinders)
    if pins:
        reason = N_("opposite crankpins stand at the same place, as none can")
        if of_pitch:
            reason = N_(
                "opposite crankpins stand at the same place, as none can; the range takes a usual "
                "bore pitch, as the file has none"
            )
        low, high = (share * bore for share in STAGGER)
        yield Assumption(
            "missing", "layout.bank_offset", reason, None, unit, low, high,
            vary=with_pins_apart(factor),
        )  # fmt: skip
    if not pairs:
        return
    reason = N_("two rods on one crankpin stand at the same place, as only fork-and-blade rods do")
    if of_pitch:
        reason = N_(
            "two rods on one crankpin stand at the same place, as only fork-and-blade rods do; the "
            "range takes a usual bore pitch, as the file has none"
        )
    width = ROD_WIDTH * bore
    yield Assumption(
        "assumed", "layout.bank_offset", reason, None, unit, -width, width,
        vary=with_rods_apart(factor),
    )  # fmt: skip


def _masters(engine: Engine) -> Iterator[Assumption]:
    """Master rods that turn no more than a slave rod, and slave rods of the usual length."""
    slaves = masters(engine)
    stars = {own.number: own for own in engine.cylinders if own.number in slaves}
    alike = {number: _as_slaves(engine, own, slaves[number]) for number, own in stars.items()}
    if stars and all(alike.values()):
        usual = next(iter(slaves.values()))[0].rotating
        low, high = (end * usual for end in MASTER_ENDS)
        yield Assumption(
            "assumed", "cylinders.rotating_mass",
            N_(
                "the master rod has the rotating mass of a slave rod; the range is a judgement by "
                "that"
            ),
            usual, "m" if "mass" in engine.relative else "kg", low, high, vary=with_master_mass,
        )  # fmt: skip
    lengths = {
        isclose(own.rod_length, master.rod_length - own.articulated.radius, rel_tol=1e-9)
        for number, master in stars.items()
        for own in slaves[number]
        if own.articulated is not None
    }
    if lengths == {True}:
        first = next(iter(slaves.values()))[0]
        ratio = first.rod_length / engine.throw(first).radius
        yield Assumption(
            "assumed", "layout.slave_rod_length",
            N_("the rod of the master less the knuckle radius"),
            ratio, "r", SLAVE_ENDS[0] * ratio, SLAVE_ENDS[1] * ratio, vary=with_slave_rods,
        )  # fmt: skip


def _as_slaves(engine: Engine, master: Cylinder, slaves: list[Cylinder]) -> bool:
    """Whether a master rod has the rotating mass of each of its slave rods, which have some."""
    plain = Counter((own.shaft, own.throw) for own in engine.cylinders if not own.articulated)
    throw = engine.throw(master)
    own = master.rotating + throw.rotating_mass / plain[master.shaft, master.throw]
    return own > 0 and all(isclose(own, each.rotating, rel_tol=1e-9) for each in slaves)
