"""A drive inertia with which hardly any engine runs: flywheel or rotor are not in it.

By the linear estimate delta = dE/(J w_m^2) of `uneven`, J = J_drive + mean inertia of what moves,
an inertia that makes delta runs as evenly as such engines do with

    J_drive = dE/(delta_usual w_m^2) - (J - J_drive)                        kg m^2
"""

from __future__ import annotations

from math import pi

from crankstar.dynamics.uneven import fluctuation
from crankstar.engine.engine import Engine
from crankstar.language.faults import Fault
from crankstar.language.numbers import RPM
from crankstar.mechanics.chain_inertia import APART, chain_inertia
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.operating_points import GasError

WORST_SET, USUAL_SET = 1 / 50, 1 / 100
"""Degrees of irregularity of generating sets: beyond any under load, and one of the least even.

They have 1/75 to 1/300; the bound is our judgement.
"""
WORST, USUAL = 1 / 8, 1 / 30
"""The same of other engines at full speed: pumps and vehicles have 1/20 to 1/180. Our judgement."""
FULL_SPEED = 6.0
"""m/s of the piston in the mean from which it is full speed: engines idle at 1 to 3."""
CONSTANT_POWER = -1.0
"""Exponent of the load of a generator."""


def doubts_of_points(engine: Engine) -> tuple[Fault, ...]:
    """The doubt at the first of the loads of a file that raises it, if one does.

    >>> from crankstar import load
    >>> doubts_of_points(load("audi-25-tfsi"))
    ()
    """
    points = () if engine.gas is None else engine.gas.points
    for name in ("", *(point.name for point in points)):
        found = _of_point(engine, name)
        doubts = () if found is None else uneven_doubts(engine, found)
        if doubts:
            return doubts
    return ()


def _of_point(engine: Engine, name: str) -> Cycle | None:
    try:
        return cycle(engine, point=name)
    except GasError:
        return None


def uneven_doubts(engine: Engine, found: Cycle, *, generating: bool = False) -> tuple[Fault, ...]:
    """The doubt of the drive inertia of the file by the irregularity of one cycle, if there is one.

    `generating`: it is known to drive a generator; else the exponent of its load says so. Nothing
    of a cycle that is motored or has weak cylinders, which no bound is for.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi", changes={"drive": {"inertia": "0.05 kg*m^2"}})
    >>> full = cycle(five, speed="2500 rpm", imep="20 bar")
    >>> [len(uneven_doubts(five, full, generating=each)) for each in (False, True)]
    [0, 1]
    """
    drive, speed = engine.drive, found.speed
    unknown = drive is None or speed is None or {"mass", "radius"} & {*engine.relative}
    if unknown or found.motored or found.off or found.weaker:
        return ()
    assert drive is not None  # noqa: S101  # asked before
    assert speed is not None  # noqa: S101
    if drive.inertia is None or (chain_inertia(engine) or 0.0) > APART * drive.inertia:
        return ()  # what is doubted then is that it is not that of the chain
    generating = generating or drive.load_exponent == CONSTANT_POWER
    stroke = 2 * engine.throw(engine.first).radius
    if not generating and stroke * speed / pi < FULL_SPEED:
        return ()
    worst, usual = (WORST_SET, USUAL_SET) if generating else (WORST, USUAL)
    swing, moving = fluctuation(engine, found)
    uneven = swing / ((drive.inertia + moving) * speed**2)
    if uneven <= worst:
        return ()
    values = {
        "value": drive.inertia,
        "parts": float(f"{1 / uneven:.2g}"),
        "rpm": float(f"{speed * RPM:.4g}"),
        "enough": float(f"{swing / (usual * speed**2) - moving:.2g}"),
    }
    code = "doubt.uneven-set" if generating else "doubt.uneven"
    return (Fault(("drive", "inertia"), code, values),)
