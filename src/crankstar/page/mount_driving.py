"""What the page needs to shake the block at any speed, and the points whose motion it can tell."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, cast

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.gas_loads import straight_speeds
from crankstar.page.mount_records import Driving, MountedPoint, Place, Row, Spring
from crankstar.page.torque import wave_of
from crankstar.page.unit_records import Pair
from crankstar.spectra import Complex, Real

if TYPE_CHECKING:
    from crankstar.dynamics.mount_analysis import MountAnalysis
    from crankstar.dynamics.mount_response import MountResponse
    from crankstar.dynamics.mounted_block import MountedBlock

MOST_PLACES = 24
"""Points that are sent, with their motion over the speed; the command line has all."""


def place_of(values: Iterable[float]) -> Place:
    """A point or a vector without negative noughts."""
    up, right, z = (float(each) + 0.0 for each in values)
    return up, right, z


def short(values: Iterable[float]) -> tuple[float, ...]:
    """Numbers that are only drawn or printed, in nine figures."""
    return tuple(float(f"{value:.9g}") for value in values)


def driving(engine: Engine, over: MountResponse, kept: Real) -> Driving:
    """What shakes an engine over its range of speeds, in the orders that are `kept`."""
    from crankstar.dynamics.mount_excitation import mount_excitation

    knots = straight_speeds(engine, (float(over.speeds[0]), float(over.speeds[-1])))
    push = mount_excitation(over.block, engine, speeds=knots)
    with_gas = not push.without_gas
    return Driving(
        mass=tuple(map(_row, over.block.mass)),
        springs=tuple(_springs(over.block)),
        inertia=tuple(map(wave_of, push.inertia[kept].T)),
        gas_speeds=tuple(knots.tolist()) if with_gas else (),
        gas=tuple(map(wave_of, push.gas[:, kept, 5])) if with_gas else (),
    )


def _springs(block: MountedBlock) -> Iterator[Spring]:
    for mount, arms in zip(block.mounts, block.arms, strict=True):
        first, second, third = map(_row, arms)
        yield Spring(
            arms=(first, second, third),
            stiffness=place_of(mount.along),
            damping=place_of(mount.viscous),
            loss=mount.loss,
            stiffening=tuple((each.frequency, each.factor) for each in mount.rubber),
            foot=tuple((each.frequency, *_pairs(each.along)) for each in mount.foot),
        )


def _row(values: Real) -> Row:
    return tuple((values + 0.0).tolist())


def _pairs(values: Iterable[complex]) -> tuple[Pair, Pair, Pair]:
    pairs = tuple((each.real, each.imag) for each in values)
    return cast("tuple[Pair, Pair, Pair]", pairs)


def points_of(engine: Engine, found: MountAnalysis) -> tuple[MountedPoint, ...]:
    """The points of the file, the centres of mass and the places of the mounts on the block.

    The first is that of which motion is told unless another is asked for.
    """
    from crankstar.dynamics.mount_response import rms

    def told(name: str, place: Iterable[float], *, of: int = 0) -> MountedPoint:
        at, own = place_of(place), found.over
        courses: tuple[Complex, ...] = ()
        if own is not None:
            courses = (own.displacement(at, of=of), own.velocity(at, of=of))
        displacement, velocity = (short(rms(each)) for each in courses) if courses else ((), ())
        return MountedPoint(
            name=name, place=at, below=of > 0, displacement=displacement, velocity=velocity
        )

    block, base = found.block, engine.foundation
    places: list[tuple[str, Iterable[float], int]] = []
    if engine.block is not None:
        places += [(each.name, each.place, 0) for each in engine.block.points]
    places.append((_("centre of mass"), block.centres[0], 0))
    if base is not None:
        of = _("foundation")
        places += [(f"{of}: {each.name}", each.place, 1) for each in base.points]
        places.append((f"{of}: {_('centre of mass')}", block.centres[1], 1))
    mounts = block.mounts[: block.of_block]
    places += [(each.name, (each.up, each.right, each.z), 0) for each in mounts]
    return tuple(told(name, place, of=of) for name, place, of in places[:MOST_PLACES])
