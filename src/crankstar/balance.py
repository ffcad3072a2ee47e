"""Engine -> Balance: force, couple, roll and torque of every part of an engine, labelled, about a point, in units.

The laws and their signs are those of `mechanism`; here the parts get their names (cylinder, bank, shaft), the sums are
taken, and numbers are counted: in N and N m at a speed, or, without one, in units of m r w^2 with m and r of the first
cylinder.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from crankstar import phasor
from crankstar.engine import Engine
from crankstar.mechanism import Reference, Totals, mechanism, spectra
from crankstar.phasor import Spectrum

Kind = Literal["piston", "rod", "big end", "throw", "weight"]
Grouping = Literal["kind", "cylinder", "bank", "shaft"]


class Units(NamedTuple):
    """In what the numbers of a Balance are counted."""

    force: str
    couple: str
    roll: str


class Part(NamedTuple):
    """What a row of a Balance stands for; `cylinder` and `bank` are None for what belongs to a shaft alone."""

    kind: Kind
    shaft: str
    cylinder: int | None = None
    bank: str | None = None


@dataclass(frozen=True)
class Balance:
    """Spectra [..., part, order] of what the moving parts do to the block.

    `force` (units.force) and `couple` (units.couple) in the clock plane, `roll` and `torque` (units.roll) as real signals.
    """

    parts: tuple[Part, ...]
    force: Spectrum
    couple: Spectrum
    roll: Spectrum
    torque: Spectrum
    reference: Reference
    units: Units
    speed: float | None

    def _repr_html_(self) -> str:
        """The table of orders, in a notebook."""
        from crankstar import tables, wording

        return wording.html(tables.orders(self))


def default_reference(engine: Engine) -> Reference:
    """The middle of the cylinders' span, on the reference crank axis."""
    places = [cylinder.z for cylinder in engine.cylinders]
    return Reference((min(places) + max(places)) / 2)


def balance(
    engine: Engine, *, speed: float | None = None, reference: Reference | None = None, orders: Sequence[float] | None = None
) -> Balance:
    """The Balance of an engine: at `speed` (rad/s) in N and N m, without one in units of m r w^2; `orders` keeps only those.

    An engine whose masses or sizes are not known is always counted in these units.

    >>> from crankstar.catalog import load
    >>> second = phasor.selected(total(balance(load("v8-flat-plane"))).force, 2)
    >>> print(abs(phasor.vertical(second)), abs(phasor.horizontal(second)).round(6))  # a horizontal line of 4 sqrt(2) A_2
    [0.] [1.436983]
    """
    reference = reference or default_reference(engine)
    raw = spectra(mechanism(engine), reference=reference, orders=orders)
    scale, units = scales(engine, speed)
    return Balance(
        parts=parts(engine),
        force=phasor.scaled(raw.force, scale.force),
        couple=phasor.scaled(raw.couple, scale.couple),
        roll=phasor.scaled(raw.roll, scale.roll),
        torque=phasor.scaled(raw.torque, scale.roll),
        reference=reference,
        units=units,
        speed=speed if units.force == "N" else None,
    )


class Scale(NamedTuple):
    """Factors from what is worked out at 1 rad/s in SI units to what a Balance is counted in."""

    force: float
    couple: float
    roll: float


def scales(engine: Engine, speed: float | None) -> tuple[Scale, Units]:
    """Factors to N and N m at a speed (rad/s), else to m r w^2 and its like, and the names of these units."""
    known = {"mass", "radius"}.isdisjoint(engine.relative)
    if speed is not None and known:
        squared = speed**2
        if "pitch" in engine.relative:
            return Scale(squared, squared / engine.pitch, squared), Units("N", "N*a", "N*m")
        return Scale(squared, squared, squared), Units("N", "N*m", "N*m")
    first = engine.first
    mass, radius = first.reciprocating_mass or (first.rod.mass if first.rod else 1.0), engine.throw(first).radius
    force = 1 / (mass * radius)
    return Scale(force, force / engine.pitch, force / radius), Units("m*r*w^2", "m*r*w^2*a", "m*r^2*w^2")


def parts(engine: Engine) -> tuple[Part, ...]:
    """What each row of a Balance stands for, in order."""
    bank = {number: name for name, numbers in engine.banks.items() for number in numbers}
    moving: list[Part] = []
    kinds: list[Kind] = ["piston"]
    if any(cylinder.rod for cylinder in engine.cylinders):
        kinds.append("rod")
    if any(cylinder.big_end_mass for cylinder in engine.cylinders):
        kinds.append("big end")
    for kind in kinds:
        moving += [Part(kind, c.shaft, c.number, bank[c.number]) for c in engine.cylinders]
    turning = [Part("throw", shaft.name) for shaft in engine.shafts for _ in shaft.throws]
    weights = [Part("weight", shaft.name) for shaft in engine.shafts for _ in shaft.weights]
    return (*moving, *turning, *weights)


def total(result: Balance) -> Totals:
    """The whole engine: the sum of its parts, with what is only rounding error set to zero."""
    return of_parts(result)


def of_parts(result: Balance, **wanted: object) -> Totals:
    """The sum of the parts whose labels are as wanted: `kind=`, `cylinder=`, `bank=`, `shaft=`."""
    rows = [row for row, part in enumerate(result.parts) if all(getattr(part, key) == value for key, value in wanted.items())]
    return Totals(*(phasor.total(getattr(result, name)[rows, :]) for name in Totals._fields))


def grouped(result: Balance, by: Grouping) -> dict[object, Totals]:
    """The sums by one label, in order of first appearance; under None what has no such label."""
    labels = dict.fromkeys(getattr(part, by) for part in result.parts)
    return {label: of_parts(result, **{by: label}) for label in labels}
