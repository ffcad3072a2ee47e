"""The gear wheels between crankshafts: which meshes with which, and how large they may be.

>>> from crankstar.files.catalog import load
>>> engine = load("kr250-racer", changes={"drive": {"pitch_radius": "40 mm"}})
>>> [fault.values["half"] for fault in wheel_doubts(engine)]
[45.0]
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.faults import Fault

CLOSE = 0.01
"""Of half the distance of two shafts, by which the pitch radius of wheels that mesh may miss it."""


@dataclass(frozen=True)
class Wheel:
    """The wheel of a crankshaft and what it meshes with: a crankshaft, or None for the output's.

    `beyond` are the crankshafts whose torque passes through, itself first; by an `idler` where both
    turn the same way; `pitch_radius` (m) where it is known.
    """

    crankshaft: str
    onto: str | None
    beyond: tuple[str, ...]
    idler: bool
    pitch_radius: float | None


def crankshafts(engine: Engine) -> tuple[Shaft, ...]:
    """The shafts with throws: balance shafts pass on no torque at a steady speed."""
    return tuple(shaft for shaft in engine.shafts if shaft.throws)


def wheels(engine: Engine) -> tuple[Wheel, ...]:
    """How the crankshafts are geared to the load, by the table `[drive]`; empty for one crankshaft.

    Geared with each other, each meshes with the nearest of those that are nearer to the load, and
    of equally near ones with one that turns the other way, so that no idler is needed.

    >>> from crankstar.files.catalog import load
    >>> (wheel,) = wheels(load("kr250-racer"))
    >>> wheel.crankshaft, wheel.onto, wheel.idler, wheel.pitch_radius
    ('rear', 'front', False, 0.045)
    """
    cranks, drive = crankshafts(engine), engine.drive or Drive()
    if len(cranks) < 2:
        return ()
    if drive.gearing == "output":
        return tuple(
            Wheel(shaft.name, None, (shaft.name,), False, drive.pitch_radius) for shaft in cranks
        )
    root = next((shaft for shaft in cranks if shaft.name == drive.output), cranks[0])
    joined, pairs = [root], []
    waiting = [shaft for shaft in cranks if shaft is not root]
    while waiting:
        shaft, onto = min(
            ((one, other) for one in waiting for other in joined), key=lambda pair: _order(*pair)
        )
        pairs.append((shaft, onto))
        joined.append(shaft)
        waiting.remove(shaft)
    return tuple(
        Wheel(
            shaft.name,
            onto.name,
            _beyond(shaft.name, [(one.name, other.name) for one, other in pairs]),
            idler=_alike(shaft, onto) and _distance(shaft, onto) > 0,
            pitch_radius=drive.pitch_radius or _half_distance(engine, shaft, onto),
        )
        for shaft, onto in pairs
    )


def _half_distance(engine: Engine, shaft: Shaft, other: Shaft) -> float | None:
    """The pitch radius of two wheels that are alike and mesh, m; None for others, or if unknown."""
    if "radius" in engine.relative or _alike(shaft, other):
        return None
    return _distance(shaft, other) / 2 or None


def _order(shaft: Shaft, other: Shaft) -> tuple[float, bool]:
    return round(_distance(shaft, other), 6), _alike(shaft, other)


def _alike(shaft: Shaft, other: Shaft) -> bool:
    """Whether both turn the same way."""
    return shaft.speed_ratio * other.speed_ratio > 0


def _distance(shaft: Shaft, other: Shaft) -> float:
    return abs(complex(shaft.up - other.up, shaft.right - other.right))


def _beyond(name: str, pairs: Sequence[tuple[str, str]]) -> tuple[str, ...]:
    """A crankshaft and all that are geared to the load through it."""
    nearer = [one for one, other in pairs if other == name]
    return (name, *(shaft for one in nearer for shaft in _beyond(one, pairs)))


def wheel_doubts(engine: Engine) -> Iterator[Fault]:
    """A pitch radius with which wheels that are to mesh do not touch, or wheels overlap.

    Crankshafts turn at one speed, so that two wheels that mesh directly are alike, half the
    distance of their shafts each; of two that an idler or the output joins, the sum is less. In a
    plane of their own wheels may overlap; that is not known, so that it is a doubt.
    """
    drive = engine.drive
    radius = None if drive is None else drive.pitch_radius
    if radius is None or {"radius", "pitch"} & set(engine.relative):
        return
    path = ("drive", "pitch_radius")
    direct = [wheel for wheel in wheels(engine) if wheel.onto is not None and not wheel.idler]
    shaft = {each.name: each for each in crankshafts(engine)}
    halves = [_distance(shaft[each.crankshaft], shaft[each.onto or ""]) / 2 for each in direct]
    for half in halves:
        if half and abs(radius - half) > CLOSE * half:
            yield Fault(path, "doubt.pitch-radius", {**_both(radius, half)})
            return
    pairs = [_distance(one, other) / 2 for one, other in combinations(crankshafts(engine), 2)]
    half = min((each for each in pairs if each), default=radius)
    if radius > (1 + CLOSE) * half:
        yield Fault(path, "doubt.wheels-overlap", {**_both(radius, half)})


def _both(radius: float, half: float) -> dict[str, float]:
    return {"value": float(f"{radius * 1e3:.4g}"), "half": float(f"{half * 1e3:.4g}")}
