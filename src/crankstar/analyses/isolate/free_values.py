"""The values of mounts that may be chosen, their limits, and the engine with chosen ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import Mount
from crankstar.engine.records import Provenance

FIGURES = 5
"""Of a stiffness, and decimals of a place in metres: finer than any mount is made."""
PLACES = ("up", "right", "z")


class MountLimits(NamedTuple):
    """What the mounts may be: N/m, metres each way (up, right, z), metres, hertz; None is free.

    `stiffness` None leaves that of the file; `shift` noughts leave the places.
    """

    stiffness: tuple[float, float] | None = None
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    sag: float | None = None
    frequencies: tuple[float, float] | None = None


class Free(NamedTuple):
    """A value that is free: of which mount, which key, which axis; its limits."""

    mount: int
    key: str
    axis: int
    low: float
    high: float


def free_values(mounts: Sequence[Mount], limits: MountLimits) -> tuple[Free, ...]:
    """Every stiffness and place that is free."""
    out: list[Free] = []
    for index, mount in enumerate(mounts):
        if limits.stiffness is not None and limits.stiffness[0] < limits.stiffness[1]:
            out += [
                Free(index, "stiffness", axis, *limits.stiffness)
                for axis, value in enumerate(mount.stiffness)
                if value
            ]
        out += [
            Free(index, key, 0, getattr(mount, key) - by, getattr(mount, key) + by)
            for key, by in zip(PLACES, limits.shift, strict=True)
            if by
        ]
    return tuple(out)


def given(mount: Mount, free: Free) -> float:
    """The value that the file gives."""
    return mount.stiffness[free.axis] if free.key == "stiffness" else getattr(mount, free.key)


def fitted(engine: Engine, mounts: tuple[Mount, ...], free: Sequence[Free], aim: str) -> Engine:
    """The engine on other mounts, checked, with the source of their values."""
    was_set = {f"mounts[{each.mount + 1}].{each.key}" for each in free}
    sources = {
        path: source
        for path, source in engine.provenance.items()
        if not any(path == own or path.startswith(f"{own}[") for own in was_set)
    }
    text = f"crankstar isolate: least {aim} within limits; a local optimum"
    sources |= {path: Provenance(status="computed", source=text) for path in sorted(was_set)}
    rounded = tuple(_rounded(mount) for mount in mounts)
    return with_values(engine, mounts=rounded, provenance=sources)


def _rounded(mount: Mount) -> Mount:
    """A mount with stiffnesses to five figures and places to a hundredth of a millimetre."""
    stiffness = tuple(float(f"{each:.{FIGURES}g}") for each in mount.stiffness)
    places = {key: round(getattr(mount, key), FIGURES) for key in PLACES}
    return with_values(mount, stiffness=stiffness, **places)
