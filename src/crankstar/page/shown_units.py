"""The units in which a page shows an engine, and those that it offers by name."""

from __future__ import annotations

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import SYSTEMS, choice, choice_text, dimension, shown
from crankstar.mechanics import remains
from crankstar.mechanics.balance import Balance
from crankstar.page import orders as vectors
from crankstar.page.unit_records import Unit, Units, UnitsOffered

LENGTHS = (Unit(label="µm", factor=1e6), Unit(label="mm", factor=1e3))
"""The units of small lengths of a drawing with sizes, from metres."""
LABELS = {"si": N_("SI"), "us": N_("US customary")}
"""What readers know the systems of units by."""


def units_of(engine: Engine, result: Balance, sums: remains.Sums) -> tuple[Units, vectors.Scaling]:
    """The units in which a page shows an engine, and the factors to them.

    Force, couple and moments each have the one unit that fits their peak over a turn.
    """
    own = result.units
    force = shown(own.force, spectra.peak(sums.force).value)
    couple = shown(own.couple, spectra.peak(sums.couple).value)
    moment = shown(own.moment, max(spectra.peak(each).value for each in (sums.roll, sums.torque)))
    lengths = (Unit(label=_(engine.across), factor=1.0),)
    if "radius" not in engine.relative:
        long = shown("mm", 1.0)  # a lone m is the relative mass
        chosen = Unit(label=unit_text(long.unit), factor=1000.0 * long.factor)
        lengths = (chosen,) if "length" in choice() else LENGTHS
    return (
        Units(
            chosen=choice_text(choice()),
            force=unit_text(force.unit),
            couple=unit_text(couple.unit),
            roll=unit_text(moment.unit),
            length=engine.across,
            force_factor=force.factor,
            couple_factor=couple.factor,
            roll_factor=moment.factor,
            counted=(unit_text(own.force), unit_text(own.couple)),
            lengths=lengths,
            mass=_unit("m" if "mass" in engine.relative else "kg", _heaviest(engine)),
            inertia=_inertia(engine),
            pressure=_told("Pa", 1e6),
            power=_told("W", 1e5),
        ),
        vectors.Scaling(force.factor, couple.factor, moment.factor),
    )


def _unit(unit: str, largest: float = 1.0) -> Unit:
    """SI, or of the chosen units the one that fits."""
    said = shown(unit, largest, prefixed=dimension(unit)[0] in choice())
    return Unit(label=unit_text(said.unit), factor=said.factor)


def _inertia(engine: Engine) -> Unit:
    """That of moments of inertia, which have the masses and lengths of the engine file.

    A relative mass with a known crank radius leaves them in m metre^2: m r^2 are r^2 of these.
    """
    if {"mass", "radius"}.isdisjoint(engine.relative):
        return _unit("kg*m^2")
    if "mass" not in engine.relative:
        return _unit("kg*r^2")
    squared = 1.0 if "radius" in engine.relative else engine.throw(engine.first).radius ** 2
    return Unit(label=unit_text("m*r^2"), factor=1.0 / squared)


def _told(unit: str, usual: float) -> Unit:
    """The unit for readers of a quantity of about this size."""
    said = shown(unit, usual)
    return Unit(label=unit_text(said.unit), factor=said.factor)


def _heaviest(engine: Engine) -> float:
    return max(cylinder.reciprocating_mass for cylinder in engine.cylinders)


def offered() -> tuple[UnitsOffered, ...]:
    """The choices of units that a page offers by name: the systems, and that of the context."""
    own = choice_text(choice())
    names = dict.fromkeys((*SYSTEMS, own))
    return tuple(UnitsOffered(name=name, label=_(LABELS.get(name, name))) for name in names)
