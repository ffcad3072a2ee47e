"""Doubts on the values of an engine, tried at what may be meant where that is known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from crankstar import spectra
from crankstar.analysis.assumptions import Answer, Assumption, moved
from crankstar.analysis.changed_rods import with_knuckles, with_rods_of
from crankstar.analysis.changed_values import (
    with_block_mass,
    with_drive_inertia,
    with_gas_value,
    with_rod_inertias,
)
from crankstar.analysis.tried_values import Figures
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import TWO_MASSES
from crankstar.engine.quantities import GRAVITY
from crankstar.engine.records import Cylinder
from crankstar.language.faults import Fault, where
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.mass_doubts import body_doubts

GAS_DEPTH = 2
"""Keys of the path of a value of the table [gas]; operating points stand deeper."""
OF_POINTS = {"doubt.charge": ("intake", "enough"), "doubt.friction": ("value", "usual")}
"""Doubts on pressures of operating points: the value and what is tried, bar, by their names."""
OF_RODS = ("doubt.rod-without-inertia", "doubt.rod-inertia")
"""Doubts on moments of inertia of rods."""


def doubtful(engine: Engine, doubts: Sequence[Fault]) -> Iterator[Assumption]:
    """What an answer rests on that is doubted."""
    yield from _rod_inertias(engine, [each for each in doubts if each.code in OF_RODS])
    others = (_of_all(engine, each) for each in doubts if each.code not in OF_RODS)
    told = {each.sentence: each for each in others}
    yield from (_doubt(engine, each) for each in told.values())


def _of_all(engine: Engine, fault: Fault) -> Fault:
    """A doubt on a value of one cylinder; on that of all where all have it alike."""
    table, *rest = fault.path[:1] + fault.path[2:] or ("",)
    if table != "cylinders" or not rest:
        return fault
    values = [_value(engine, each, rest) for each in engine.cylinders]
    alike = values[0] is not None and all(each == values[0] for each in values)
    return fault._replace(path=("cylinder", *rest), cylinder=None) if alike else fault


def _value(engine: Engine, cylinder: Cylinder, keys: Sequence[str | int]) -> Any:
    """A value of a cylinder or of its throw, by the keys of a file below the cylinder; or none."""
    first = keys[0]
    if first == "rod_ratio":
        return cylinder.rod_length / engine.throw(cylinder).radius
    assert isinstance(first, str)  # noqa: S101  # a table has no entries by number
    owner: Any = cylinder if hasattr(cylinder, first) else engine.throw(cylinder)
    for key in keys:
        owner = getattr(owner, str(key), None)
    return owner


def doubted_weight(engine: Engine, speed: float | None) -> list[Assumption]:
    """The doubted mass of a block by whose weight the peak force is told.

    Its size is that force over the weight m g, without a unit, at a speed (rad/s) or the engine's.
    """
    faults = [each for each in body_doubts(engine) if each.code == "doubt.block-mass"]
    result = balance(engine, speed=engine.speed if speed is None else speed)
    force = 0.0 if result.speed is None else float(spectra.peak(total(result).force).value)
    if not force:
        return []

    def figures(each: Engine) -> Figures:
        mass = None if each.block is None else each.block.mass
        return {} if mass is None else {("share of weight", None): force / (mass * GRAVITY)}

    answer = Answer(figures=figures, unit=lambda _quantity, _engine: "")
    tried = moved(engine, [_doubt(engine, fault) for fault in faults], answer)
    return [replace(each, vary=None) for each in tried]


MEANT = {"doubt.uneven": "enough", "doubt.uneven-set": "enough", "doubt.drive-chain": "chain"}
"""Doubts of the inertia of the drive, and the value of each that may be meant."""


def _doubt(engine: Engine, fault: Fault) -> Assumption:
    """A doubt, tried at what may be meant where that is known."""
    path = where(fault.path)
    if fault.code in OF_POINTS:
        value, meant = (fault.values[key] for key in OF_POINTS[fault.code])
        point = fault.path[2] if len(fault.path) > GAS_DEPTH else None
        assert not isinstance(point, str)  # noqa: S101  # it numbers the operating points
        vary = with_gas_value(str(fault.path[-1]), 1e5, point=point)
        return Assumption("doubtful", path, fault.sentence, value, "bar", meant, meant, vary=vary)
    if fault.code in MEANT:
        value, enough = fault.values["value"], fault.values[MEANT[fault.code]]
        vary = with_drive_inertia
        return Assumption(
            "doubtful", path, fault.sentence, value, "kg*m^2", enough, enough, vary=vary
        )
    if fault.code == "doubt.block-mass":
        low, high = (fault.values["litres"] * fault.values[f"car_{end}"] for end in ("low", "high"))
        own = fault.values["value"]
        return Assumption(
            "doubtful", path, fault.sentence, own, "kg", low, high, vary=with_block_mass
        )
    if fault.code == "doubt.central-rods":
        radius = engine.throw(engine.first).radius
        unit, factor = ("r", radius) if "radius" in engine.relative else ("mm", 1e-3)
        low, high = (fault.values[end] * radius / factor for end in ("low", "high"))
        vary = with_knuckles(factor)
        return Assumption("doubtful", path, fault.sentence, None, unit, low, high, vary=vary)
    if fault.code != "doubt.rod-ratio" or fault.cylinder is not None:
        return Assumption("doubtful", path, fault.sentence)
    value, meant = fault.values["value"], fault.values["meant"]
    return Assumption("doubtful", path, fault.sentence, value, "r", meant, meant, vary=with_rods_of)


def _rod_inertias(engine: Engine, faults: Sequence[Fault]) -> Iterator[Assumption]:
    """Moments of inertia of rods that are implied or doubted, one for all rods alike.

    One that is not given lies where those of rods do, m c (l - c) over TWO_MASSES; one that is
    given beside them is tried at the mean of theirs.
    """
    alike: dict[tuple[Any, ...], list[Fault]] = {}
    for fault in faults:
        alike.setdefault((fault.code, *fault.values.values()), []).append(fault)
    for first, *others in alike.values():
        fault = first
        if others:
            every = len(others) + 1 == len(engine.cylinders)
            table = "cylinder" if every else "cylinders"
            fault = first._replace(path=(table, *first.path[2:]), cylinder=None)
        cylinder = engine.cylinders[int(first.path[1])]
        rod = cylinder.rod
        assert rod is not None  # noqa: S101  # the doubt is about it
        ends = rod.mass * rod.centre * (cylinder.rod_length - rod.centre)
        least, mean, most = TWO_MASSES
        low, high = (ends / most, ends / least) if rod.inertia is None else 2 * (ends / mean,)
        numbers = {engine.cylinders[int(each.path[1])].number for each in (first, *others)}
        yield Assumption(
            "doubtful", where(fault.path), fault.sentence, rod.turning_inertia(cylinder.rod_length),
            "kg*m^2", low, high, vary=with_rod_inertias(numbers),
        )  # fmt: skip
