"""How an engine changes where a value of its file is multiplied by a factor, by its key path.

What `estimate` took by a bore or a stroke goes along with it: masses by the cube of the bore,
lengths of rods by the stroke.

>>> from crankstar.files.catalog import load
>>> SCALED["cylinder.stroke"](load("audi-25-tfsi"), 2.0).shafts[0].throws[0].radius
0.0928
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isclose

from crankstar.analysis.changed_masses import (
    Vary,
    by_factor,
    with_pistons_balanced,
    with_weights_along,
)
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.gas import OperatingPoint
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.operating_points import operating_state


def _all(field: str) -> Vary:
    """The change of one number of every cylinder by a factor."""

    def vary(engine: Engine, factor: float) -> Engine:
        return with_values(
            engine,
            cylinders=tuple(
                with_values(own, **{field: getattr(own, field) * factor})
                for own in engine.cylinders
            ),
        )

    return vary


def _bore(engine: Engine, factor: float) -> Engine:
    """The change of the bores by a factor, and of masses that were estimated by their cube."""
    cylinders = [
        own if own.bore is None else with_values(own, bore=own.bore * factor)
        for own in engine.cylinders
    ]
    changed = with_values(engine, cylinders=tuple(cylinders))
    for path in BY_BORE:
        if _estimated(engine, path):
            changed = SCALED[path](changed, factor**3)
    if _estimated(engine, "cylinder.rod.mass"):
        changed = _rods(changed, mass=factor**3)
    return changed


def _rods(engine: Engine, *, mass: float = 1.0, length: float = 1.0) -> Engine:
    """The rods, each a rigid body of the same shape, with these multiples of mass and length."""
    cylinders = [
        own
        if own.rod is None
        else with_values(
            own,
            rod=with_values(
                own.rod,
                mass=own.rod.mass * mass,
                centre=own.rod.centre * length,
                inertia=None if own.rod.inertia is None else own.rod.inertia * mass * length**2,
            ),
        )
        for own in engine.cylinders
    ]
    return with_values(engine, cylinders=tuple(cylinders))


BY_BORE = ("cylinder.reciprocating_mass", "cylinder.rotating_mass", "cylinder.throw_mass")
"""What `estimate` takes as a coefficient times the cube of the bore."""


def _estimated(engine: Engine, path: str) -> bool:
    origin = engine.provenance.get(path)
    return origin is not None and origin.status == "estimated" and origin.range is not None


def _stroke(engine: Engine, factor: float) -> Engine:
    """The change of the strokes by a factor, and of rod lengths that were estimated by them.

    Weights of a balance factor balance masses at the crank radius: they change along.
    """
    changed = _of_throws("radius")(engine, factor)
    if any(_estimated(engine, f"cylinder.{name}") for name in ("rod_length", "rod_ratio")):
        changed = SCALED["cylinder.rod_length"](changed, factor)
        if _estimated(engine, "cylinder.rod.mass"):
            changed = _rods(changed, length=factor)
    if not by_factor(engine):
        return changed
    shafts = [
        with_values(
            shaft,
            weights=tuple(
                with_values(own, unbalance=own.unbalance * factor) for own in shaft.weights
            ),
        )
        if shaft.throws
        else shaft
        for shaft in changed.shafts
    ]
    return with_values(changed, shafts=tuple(shafts))


def _reciprocating(engine: Engine, factor: float) -> Engine:
    """The change of the reciprocating masses by a factor, with the weights of a balance factor.

    What they balance beyond all that turns is a share of what reciprocates, rods included; that of
    the pistons changes along.
    """
    return with_pistons_balanced(engine, _all("reciprocating_mass")(engine, factor))


def _of_throws(field: str) -> Vary:
    """The change of one number of every throw by a factor."""

    def vary(engine: Engine, factor: float) -> Engine:
        shafts = [
            with_values(
                shaft,
                throws=tuple(
                    with_values(throw, **{field: getattr(throw, field) * factor})
                    for throw in shaft.throws
                ),
            )
            if shaft.throws
            else shaft
            for shaft in engine.shafts
        ]
        return with_weights_along(engine, with_values(engine, shafts=tuple(shafts)))

    return vary


def speed_value(gas: Cycle | None) -> Vary:
    """The change of the speed by a factor, at which the load that an answer was made with counts.

    Of an answer of `gas` at the speed of the file, or at one that was asked for and is the same,
    that load counts at both: at the speed as it was and as it is then. At any other speed that was
    asked for the loads stay at the speeds where they are.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> five = load("audi-25-tfsi")  # full at 6500 rpm, most torque at 5300
    >>> less = speed_value(cycle(five))(five, 0.99)
    >>> [round(cycle(each).bmep / 1e5, 3) for each in (five, less)]
    [18.608, 18.608]
    """

    def vary(engine: Engine, factor: float) -> Engine:
        own, now = engine.gas, engine.speed
        if now is None:
            return engine
        if own is not None and gas is not None and own.speed is None:
            changed = with_values(own, speed=now)
            if gas.speed is not None and isclose(gas.speed, now, rel_tol=1e-9):
                changed = with_values(own, points=(_same_load(engine, factor), *own.points))
            engine = with_values(engine, gas=changed)
        return with_values(engine, speed=now * factor)

    return vary


def _same_load(engine: Engine, factor: float) -> OperatingPoint:
    """A point of the load that counts at the speed of an engine, at the other of two speeds.

    A load without a speed of its own goes along with that of the engine, times the `factor`: the
    point is at that speed as it was. Of another load it is the reverse.
    """
    own, now = engine.gas, engine.speed
    assert own is not None and now is not None  # noqa: S101, PT018  # there is a load at a speed
    counted = operating_state(engine, speed=now).point
    point = next((each for each in own.points if each.name == counted), None)
    name = f"{''.join(each.name for each in own.points)}'"
    if point is None:
        return OperatingPoint(name=name, speed=now)
    at = now if point.speed is None else now * factor
    return with_values(point, name=name, speed=at)


def _gas_value(name: str) -> Vary:
    def vary(engine: Engine, factor: float) -> Engine:
        gas = engine.gas
        value = None if gas is None else getattr(gas, name)
        if gas is None or value is None:
            return engine
        return with_values(engine, gas=with_values(gas, **{name: value * factor}))

    return vary


SCALED: Mapping[str, Vary] = {
    "cylinder.bore": _bore,
    "cylinder.stroke": _stroke,
    "cylinder.rod_length": _all("rod_length"),
    "cylinder.rod_ratio": _all("rod_length"),
    "cylinder.reciprocating_mass": _reciprocating,
    "cylinder.rotating_mass": _of_throws("rotating_mass"),
    "cylinder.throw_mass": _of_throws("throw_mass"),
    "gas.compression_ratio": _gas_value("compression_ratio"),
    "gas.intake_pressure": _gas_value("intake_pressure"),
    "gas.gamma": _gas_value("gamma"),
}
"""How the engine changes where a value of its file is multiplied by a factor; the speed apart."""
