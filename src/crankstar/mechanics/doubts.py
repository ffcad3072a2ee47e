"""Values that an engine can have, but hardly any engine has: slips of unit and of thought.

They do not hinder a computation. Each is a `Fault`, a place with a sentence: of what a cycle is
computed from (`value_doubts`), of the cycle itself (`cycle_doubts`), of the moments of inertia
(`inertia_doubts`, `torsion_doubts`); of a whole engine `doubts` has them all, with those of masses
(`mass_doubts`) and of stiffnesses (`stiffness_doubts`).

>>> from crankstar.files.catalog import load
>>> [fault.code for fault in doubts(load("honda-b18c", changes={"gas.compression_ratio": 19,
...     "gas.ignition": "spark"}))]
['doubt.spark-ratio', 'doubt.friction']
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import partial
from itertools import pairwise
from math import degrees, isclose, pi
from typing import Any

from crankstar.engine.drive import mean_share
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import firing_doubts
from crankstar.engine.gas import LOADS, Ignition
from crankstar.engine.proportions import TWO_MASSES
from crankstar.engine.torsion import CrankDimensions
from crankstar.engine.valves import timing
from crankstar.language.faults import Fault
from crankstar.language.numbers import RPM, rpm_of
from crankstar.mechanics.central_rods import central_doubts
from crankstar.mechanics.chain_inertia import APART, chain_inertia
from crankstar.mechanics.charge_air import CHARGED, STOICHIOMETRIC
from crankstar.mechanics.friction import friction_of
from crankstar.mechanics.gas import Cycle, computable, cycle
from crankstar.mechanics.gear_wheels import wheel_doubts
from crankstar.mechanics.kinetic import carried_inertias, mean_inertia, throw_inertia
from crankstar.mechanics.magnitudes import magnitude_doubts
from crankstar.mechanics.mass_doubts import (
    body_doubts,
    piston_doubts,
    rod_doubts,
    scale_doubts,
    size_doubts,
    stroke_doubts,
)
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.operating_points import GasError, own_speed
from crankstar.mechanics.stiffness_doubts import beam_doubts, twist_doubts
from crankstar.mechanics.usual_values import (
    HEAVIEST_FLYWHEEL,
    combustion_doubts,
    material_doubts,
    oil_doubts,
)

Path = tuple[str | int, ...]
GREATEST_SPARK_RATIO = 16.0
LEAST_DIESEL_RATIO = 10.0
"""Compression ratios beyond which spark ignition knocks, and a Diesel does not fire."""
LEAST_LOAD = 5e3
"""Pa: a mean effective pressure of less is no load, and may be a number of bar."""
MEAN_PRESSURES = ("imep", "bmep")
RATIOS = (3.0, 25.0)
"""Compression ratios of engines: of the first with electric ignition, of small Diesel engines."""
LONGER = 1.05
"""Of a throw, journal, pin and webs, over the distance to the next."""
GREATEST_PEAK = 250e5
GREATEST_IMEP = 35e5
"""Pa; only racing and research engines have more."""
GREATEST_FRICTION = 6e5
"""Pa: motored engines have 1 to 3 bar, and about 5 at the speeds of racing."""
LEAST_AIR: Mapping[Ignition, float] = {"spark": 0.75, "compression": 1.0}
"""Air-fuel ratio over the stoichiometric one, least of all with which an engine runs."""
GAMMAS = (1.2, 1.42)
"""Of burnt gas at its hottest, and of cold air."""
FASTEST = 7000.0
"""rpm up to which the correlation of friction was measured, and a little more."""
FRICTIONS = {"spark-ignition": FASTEST}
LEAST_FLYWHEEL = 0.3
"""Of the inertia of all that moves: the crankshaft alone has more."""
LEAST_COURSE = 0.01
"""Of the greatest load of a course its mean: a cylinder of an engine has more. Our judgement."""
INERTIA_SPREAD = 2.5
"""Factor by which a moment of inertia may miss that of two masses at the ends of the rod."""
OF_FLYWHEEL = ("doubt.flywheel", "doubt.great-flywheel")
"""Doubts of the inertia of the drive by that of rods and pistons."""
FIRED = {"inertia", "gas", "valves", "firing"}
"""Uses of an engine that depend on when its cylinders fire: its throws are made for that."""


def doubts(engine: Engine) -> tuple[Fault, ...]:
    """All that is hardly right in an engine, each once; its cycles are computed, if it has gas."""
    found = [*firing_doubts(engine), *stroke_doubts(engine)]
    found += [*size_doubts(engine), *rod_doubts(engine)]
    found += [*central_doubts(engine), *piston_doubts(engine), *scale_doubts(engine)]
    found += [*magnitude_doubts(engine)]
    found += [*body_doubts(engine), *inertia_doubts(engine), *torsion_doubts(engine)]
    found += [*beam_doubts(engine), *wheel_doubts(engine), *oil_doubts(engine)]
    gas = engine.gas
    if gas is not None:
        loaded = any(getattr(gas, name) is not None for name in LOADS) or not gas.points
        places: list[tuple[Path, str]] = [(("gas",), "")] if loaded else []
        places += [(("gas", "point", index), point.name) for index, point in enumerate(gas.points)]
        for path, name in places:
            found += _point_doubts(engine, name, path)
    once: dict[tuple[str, Any], Fault] = {}
    for fault in found:
        once.setdefault((fault.code, tuple(fault.values.items())), fault)
    return tuple(once.values())


def doubts_of(engine: Engine, uses: Collection[str], computed: Cycle | None) -> tuple[Fault, ...]:
    """Those doubts of an engine that are about what an answer uses, of gas its one cycle.

    `uses` are the parts of an answer (`studies.assumptions.Uses`).

    >>> from crankstar.files.catalog import load
    >>> own = load("honda-b18c", changes={"gas.compression_ratio": 60})
    >>> [fault.code for fault in doubts_of(own, ["gas"], cycle(own))]
    ['doubt.ratio']
    """
    found: list[Fault] = []
    if FIRED & {*uses}:
        found += [*firing_doubts(engine), *stroke_doubts(engine), *central_doubts(engine)]
    if "inertia" in uses:
        found += [*size_doubts(engine), *rod_doubts(engine)]
        found += [*piston_doubts(engine), *scale_doubts(engine), *inertia_doubts(engine)]
        found += magnitude_doubts(engine)
    if "torsion" in uses:
        found += torsion_doubts(engine)
    if "bearings" in uses:
        found += [*beam_doubts(engine), *oil_doubts(engine)]
    if "mounts" in uses:
        found += body_doubts(engine)
    if {"running", "sized"} & {*uses}:
        found += wheel_doubts(engine)
    if "gas" in uses and computed is not None:
        found += point_doubts(engine, computed)
    return tuple(found)


def _point_doubts(engine: Engine, name: str, path: Path) -> Iterator[Fault]:
    """The doubts of one operating point, or that it has no cycle."""
    try:
        yield from point_doubts(engine, cycle(engine, point=name))
    except GasError as error:
        if computable(engine):
            yield Fault(path, "doubt.no-cycle", {"message": str(error)})


def point_doubts(engine: Engine, computed: Cycle) -> tuple[Fault, ...]:
    """The doubts of one computed cycle, of its values and of its pressures."""
    names = [point.name for point in engine.gas.points] if engine.gas is not None else []
    point = ("point", names.index(computed.name)) if computed.name in names else ()
    path: Path = ("gas", *point)
    values = computed.values
    given = {key: value for key, value in values.items() if key not in computed.assumed}
    shadowed = () if point or computed.motored else _shadowed(engine)
    found = value_doubts(engine, values, given, path=path)
    course = _course_doubts(engine, computed)
    return (*shadowed, *found, *cycle_doubts(computed, path=path), *course)


def _course_doubts(engine: Engine, computed: Cycle) -> Iterator[Fault]:
    """A load course that hardly takes work, so that the part that alternates has no bounds."""
    drive = engine.drive
    if drive is None or not drive.load_torque:
        return
    mean = mean_share(drive, computed.volumes.cycle)
    if mean < LEAST_COURSE:
        share = {"mean": float(f"{100 * mean:.3g}"), "least": 100 * LEAST_COURSE}
        yield Fault(("drive", "load_torque"), "doubt.load-course", share)


def _shadowed(engine: Engine) -> Iterator[Fault]:
    """Operating points at the speed of the load of the table [gas], which counts there."""
    gas, own = engine.gas, own_speed(engine, "")
    if gas is None or own is None or not any(getattr(gas, name) is not None for name in LOADS):
        return
    for index, point in enumerate(gas.points):
        if point.speed is not None and isclose(point.speed, own, rel_tol=1e-9):
            named = {"name": point.name, "rpm": rpm_of(own)}
            yield Fault(("gas", "point", index), "doubt.shadowed", named)


def value_doubts(
    engine: Engine, values: Mapping[str, Any], given: Mapping[str, Any], *, path: Path
) -> Iterator[Fault]:
    """What is hardly right in the values of an operating point; `given` are those of the file."""
    ratio, measured = given.get("compression_ratio"), engine.gas is not None and engine.gas.trace
    if ratio is not None and values["ignition"] == "spark" and ratio > GREATEST_SPARK_RATIO:
        bound = {"value": ratio, "bound": GREATEST_SPARK_RATIO}
        yield Fault(_key(engine, path, "compression_ratio"), "doubt.spark-ratio", bound)
    elif ratio is not None and values["ignition"] == "compression" and ratio < LEAST_DIESEL_RATIO:
        bound = {"value": ratio, "bound": LEAST_DIESEL_RATIO}
        yield Fault(_key(engine, path, "compression_ratio"), "doubt.diesel-ratio", bound)
    elif ratio is not None and not RATIOS[0] <= ratio <= RATIOS[1]:
        bounds = {"value": ratio, "least": RATIOS[0], "most": RATIOS[1]}
        yield Fault(_key(engine, path, "compression_ratio"), "doubt.ratio", bounds)
    kinds: dict[str, Mapping[str, Ignition]] = {"process": {"diesel": "compression"}}
    kinds["friction"] = {"diesel": "compression", "spark-ignition": "spark"}
    for key, fires in kinds.items():
        kind = fires.get(given.get(key, ""), given.get("ignition"))
        if kind != given.get("ignition"):
            both = {"value": given[key], "ignition": given["ignition"]}
            if engine.gas is not None and engine.gas.ignition is None:
                both["process"] = values["process"]
                yield Fault(_key(engine, path, key), "doubt.process-ignition", both)
                continue
            yield Fault(_key(engine, path, key), "doubt.ignition", both)
    gamma = given.get("gamma")
    if gamma is not None and not GAMMAS[0] <= gamma <= GAMMAS[1]:
        yield Fault(_key(engine, path, "gamma"), "doubt.gamma", {"value": gamma})
    yield from combustion_doubts(given, partial(_key, engine, path))
    for key in MEAN_PRESSURES:
        load = given.get(key)
        if load is not None and 0 < load < LEAST_LOAD:
            yield Fault(_key(engine, path, key), "doubt.small-load", {"value": load})
    if measured:
        return
    scavenged = values["intake_pressure"] > values["exhaust_pressure"]
    if engine.cycle == "two-stroke" and not scavenged:
        pressures = {
            "intake": values["intake_pressure"] / 1e5,
            "exhaust": values["exhaust_pressure"] / 1e5,
        }
        yield Fault(_key(engine, path, "intake_pressure"), "doubt.scavenging", pressures)
    yield from _late(engine, values, path)


def _late(engine: Engine, values: Mapping[str, Any], path: Path) -> Iterator[Fault]:
    """Combustion that goes on after the exhaust opens."""
    if values["process"] != "heat-release":
        return
    end = values["combustion_start"] + values["combustion_duration"]
    opened = pi - timing(engine.valves, cycle=engine.cycle).exhaust_opens
    if end > opened + 1e-9:
        angles = {"end": degrees(end), "opened": degrees(opened)}
        yield Fault(_key(engine, path, "combustion_duration"), "doubt.late", angles)


def _key(engine: Engine, path: Path, key: str) -> Path:
    """Where a value of an operating point stands: in it, or in the table that all share."""
    gas, number = engine.gas, path[2:]
    if gas is None or not number or not isinstance(number[0], int):
        return (*path, key)
    own = getattr(gas.points[number[0]], key, None) is not None
    return (*path, key) if own or getattr(gas, key, None) is None else ("gas", key)


def cycle_doubts(cycle: Cycle, *, path: Path = ("gas",)) -> Iterator[Fault]:
    """What is hardly right in a cycle as computed: its pressures, and its friction."""
    if cycle.motored:
        return
    if cycle.peak > GREATEST_PEAK:
        bound = {"value": cycle.peak / 1e5, "bound": GREATEST_PEAK / 1e5}
        yield Fault(path, "doubt.peak", bound)
    if cycle.imep > GREATEST_IMEP:
        bound = {"value": cycle.imep / 1e5, "bound": GREATEST_IMEP / 1e5}
        yield Fault(path, "doubt.imep", bound)
    fires: Ignition = cycle.values["ignition"]
    least = LEAST_AIR[fires] * STOICHIOMETRIC[fires]
    if cycle.air_fuel_ratio is not None and cycle.air_fuel_ratio < least:
        bound = {
            "value": float(f"{cycle.air_fuel_ratio:.3g}"),
            "intake": cycle.values["intake_pressure"] / 1e5,
            "load": float(f"{cycle.imep / 1e5:.4g}"),
            "bound": float(f"{least:.3g}"),
        }
        enough = CHARGED[fires] * STOICHIOMETRIC[fires] / cycle.air_fuel_ratio
        bound["enough"] = float(f"{bound['intake'] * enough:.3g}")
        yield Fault((*path, "intake_pressure"), "doubt.charge", bound)
    rpm = rpm_of(cycle.speed)
    known = cycle.values.get("friction_pressure") is not None
    if cycle.friction is None:
        return
    if cycle.friction > cycle.imep and not isclose(cycle.friction, cycle.imep, rel_tol=1e-9):
        both = {"friction": float(f"{cycle.friction / 1e5:.4g}")}
        both["load"] = float(f"{cycle.imep / 1e5:.4g}") + 0.0
        yield Fault(path, "doubt.no-work", both)
    if known and cycle.friction > GREATEST_FRICTION:
        bound = {"value": cycle.friction / 1e5, "bound": GREATEST_FRICTION / 1e5}
        yield Fault((*path, "friction_pressure"), "doubt.great-friction", bound)
    limit = FRICTIONS.get(cycle.values.get("friction", ""))
    if rpm is not None and limit is not None and not known and rpm > limit:
        usual = friction_of({**cycle.values, "speed": limit / RPM}) or 0.0
        bound = {"rpm": rpm, "bound": limit, "value": cycle.friction / 1e5, "usual": usual / 1e5}
        yield Fault((*path, "friction_pressure"), "doubt.friction", bound)


def torsion_doubts(engine: Engine) -> Iterator[Fault]:
    """Throws that are lighter than the rods and pistons on them, of which `inertia` is the whole.

    Also stiffnesses with which no crankshaft and no disc vibrates.

    >>> from crankstar.files.catalog import load
    >>> own = {"torsion": {"inertia": "0.0001 kg*m^2", "stiffness": "0.5 MN*m/rad"}}
    >>> [fault.code for fault in torsion_doubts(load("audi-25-tfsi", changes=own))]
    ['doubt.stiff-crank', 'doubt.throw-inertia']
    """
    own = engine.torsion
    if own is not None and own.dimensions is not None and "pitch" not in engine.relative:
        yield from _length_doubts(engine, own.dimensions)
    if own is not None:
        yield from twist_doubts(engine, own)
    yield from material_doubts(engine)
    if own is None or not own.inertia or {"mass", "radius"} & set(engine.relative):
        return
    carried = carried_inertias(engine).tolist()
    whole = own.inertia * len(carried) if len(own.inertia) == 1 else own.inertia
    for index, (value, moving) in enumerate(zip(whole, carried, strict=True)):
        if value < moving:
            path = ("torsion", "inertia", *((index,) if len(own.inertia) > 1 else ()))
            values = {"value": value, "moving": float(f"{moving:.3g}")}
            yield Fault(path, "doubt.throw-inertia", values)
            return  # one slip for all


def _length_doubts(engine: Engine, own: CrankDimensions) -> Iterator[Fault]:
    """A journal, a pin and two webs that are longer than from one throw to the next."""
    places = sorted({throw.z for shaft in engine.shafts for throw in shaft.throws})
    gaps = [after - before for before, after in pairwise(places)]
    length = own.journal_length + own.pin_length + 2 * own.web_thickness
    if gaps and length > LONGER * max(gaps):
        values = {"value": float(f"{length * 1e3:.4g}"), "pitch": float(f"{max(gaps) * 1e3:.4g}")}
        yield Fault(("torsion", "dimensions"), "doubt.throw-length", values)


def inertia_doubts(engine: Engine) -> Iterator[Fault]:
    """Moments of inertia of rods and of the flywheel that are out of all proportion."""
    if {"mass", "radius"} & set(engine.relative):
        return
    for index, cylinder in enumerate(engine.cylinders):
        rod = cylinder.rod
        if rod is None or not 0 < rod.centre < cylinder.rod_length:
            continue
        ends = rod.mass * rod.centre * (cylinder.rod_length - rod.centre)
        path = ("cylinders", index, "rod", "inertia")
        if rod.inertia is None:
            low, high = (float(f"{ends / TWO_MASSES[place]:.3g}") for place in (2, 0))
            values = {"value": float(f"{ends:.4g}"), "low": low, "high": high}
            yield Fault(path, "doubt.rod-without-inertia", values, cylinder.number)
            continue
        two = ends / TWO_MASSES[1]
        if rod.inertia > 0 and not two / INERTIA_SPREAD <= rod.inertia <= two * INERTIA_SPREAD:
            values = {"value": rod.inertia, "usual": float(f"{two:.2g}")}
            yield Fault(path, "doubt.rod-inertia", values, cylinder.number)
    drive = engine.drive
    if drive is not None and drive.inertia is not None:
        moving = mean_inertia(mechanism(engine)) + throw_inertia(engine)
        if drive.inertia < LEAST_FLYWHEEL * moving:
            values = {"value": drive.inertia, "moving": float(f"{moving:.2g}")}
            yield Fault(("drive", "inertia"), "doubt.flywheel", values)
        elif drive.inertia > HEAVIEST_FLYWHEEL * moving:
            values = {
                "value": drive.inertia,
                "times": float(f"{drive.inertia / moving:.2g}"),
                "most": HEAVIEST_FLYWHEEL,
            }
            yield Fault(("drive", "inertia"), "doubt.great-flywheel", values)
        yield from _chain_doubts(engine, drive.inertia)


def _chain_doubts(engine: Engine, given: float) -> Iterator[Fault]:
    """An inertia of the drive that is not that of the masses of the chain."""
    chain = chain_inertia(engine)
    if chain and not 1 / APART <= chain / given <= APART:
        values = {"value": given, "chain": float(f"{chain:.4g}")}
        yield Fault(("drive", "inertia"), "doubt.drive-chain", values)
