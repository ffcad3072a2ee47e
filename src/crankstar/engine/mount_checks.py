"""What must hold of a block on mounts: springs that hold it, a body that can be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import pi

import numpy as np

from crankstar.engine.assembly import Assembly
from crankstar.engine.block import BlockPoint
from crankstar.engine.mounts import ALONG, Foundation, Mount
from crankstar.engine.records import Block
from crankstar.engine.rigid_block import unrestrained
from crankstar.language.faults import Fault
from crankstar.language.quoting import seen

NO_SPREAD = 1e-6
"""m: mounts that are nearer to each other are at one place."""
ROUNDED = 1e-3
"""Share by which moments of inertia given to a few figures may miss what they must be."""
Path = tuple[str | int, ...]


def faults(engine: Assembly) -> Iterator[Fault]:
    """What is wrong with the block, the mounts and the foundation of an engine."""
    yield from _block_faults(engine.block)
    yield from _weight_faults(engine)
    if engine.mounts and engine.relative:
        keys = {"mass": "cylinder.reciprocating_mass", "radius": "cylinder.stroke"}
        named = [keys.get(name, "layout.bore_pitch") for name in sorted(engine.relative)]
        yield Fault(("mounts",), "mounts.relative", {"keys": ", ".join(named)})
    if engine.mounts:
        yield from _mount_faults(engine.mounts, ("mounts",))
    if engine.foundation is not None:
        yield from _foundation_faults(engine, engine.foundation)


def _block_faults(block: Block | None) -> Iterator[Fault]:
    """Moments and products of inertia that no body has."""
    if block is None:
        return
    yield from _point_faults(block.points, ("block", "points"))
    sides = [name for name in ("length", "width", "height") if getattr(block, name) is None]
    if 0 < len(sides) < ALONG:
        yield from (Fault(("block", name), "block.size-missing") for name in sides)
    given = {name: getattr(block, name) for name in ("inertia_up", "inertia_right", "inertia_z")}
    missing = [name for name, value in given.items() if value is None]
    if 0 < len(missing) < len(given):
        yield from (Fault(("block", name), "block.inertia-missing") for name in missing)
    products = ("product_up_right", "product_up_z", "product_right_z")
    if missing:
        if any(block.products) and len(missing) == len(given):
            name = next(name for name in products if getattr(block, name))
            yield Fault(("block", name), "block.products-alone")
        return
    impossible = list(_impossible(("block",), given))
    yield from impossible
    if any(block.products) and not impossible:
        spread = second_moments(tuple(given.values()), block.products)
        if float(np.linalg.eigvalsh(spread)[0]) < -ROUNDED * float(np.trace(spread)):
            name = max(products, key=lambda name: abs(getattr(block, name)))
            values = {"value": getattr(block, name)}
            yield Fault(("block", name), "block.products-impossible", values)


def carried_mass(engine: Assembly) -> float:
    """The mass of all pistons and rods, kg, which the block carries."""
    return sum(
        each.reciprocating_mass + each.big_end_mass + (each.rod.mass if each.rod else 0.0)
        for each in engine.cylinders
    )


def _weight_faults(engine: Assembly) -> Iterator[Fault]:
    """A whole engine that is lighter than its pistons and rods."""
    mass = None if engine.block is None else engine.block.mass
    if mass is None or "mass" in engine.relative:
        return
    moving = carried_mass(engine)
    if mass <= moving:
        values = {"value": mass, "moving": moving}
        yield Fault(("block", "mass"), "block.too-light", values)


def _point_faults(points: Sequence[BlockPoint], here: Path) -> Iterator[Fault]:
    """Points of one name."""
    names = [point.name for point in points]
    for index, name in enumerate(names):
        if name in names[:index]:
            yield Fault((*here, index, "name"), "block.point-twice", {"value": seen(name)})


def second_moments(inertia: Sequence[float], products: Sequence[float]) -> np.ndarray:
    """The integrals of x_i x_j over the mass [up, right, z], which no body has below nought.

    >>> second_moments((3, 4, 5), (0, 0, 0)).diagonal().tolist()
    [3.0, 2.0, 1.0]
    """
    out = np.diag(sum(inertia) / 2 - np.asarray(inertia, float))
    out[0, 1] = out[1, 0] = products[0]
    out[0, 2] = out[2, 0] = products[1]
    out[1, 2] = out[2, 1] = products[2]
    return out


def _impossible(here: Path, given: dict[str, float]) -> Iterator[Fault]:
    """A moment of inertia greater than the sum of the two others."""
    name = max(given, key=given.__getitem__)
    rest = sum(given.values()) - given[name]
    if given[name] > rest * (1 + ROUNDED):
        others = [other for other in given if other != name]
        values = {"value": given[name], "others": others, "sum": rest}
        yield Fault((*here, name), "block.inertia-impossible", values)


def _foundation_faults(engine: Assembly, own: Foundation) -> Iterator[Fault]:
    here = ("foundation",)
    if not engine.mounts:
        yield Fault(here, "foundation.alone")
    yield from _point_faults(own.points, (*here, "points"))
    names = ("inertia_up", "inertia_right", "inertia_z")
    yield from _impossible(here, {name: getattr(own, name) for name in names})
    yield from _shared_names(engine, own)
    if own.mounts:
        yield from _mount_faults(own.mounts, (*here, "mounts"))
        yield from _feet_on_a_foundation(engine)
    else:
        yield Fault((*here, "mounts"), "foundation.no-mounts")


def _shared_names(engine: Assembly, own: Foundation) -> Iterator[Fault]:
    """Mounts and points of the foundation that are named as those of the engine are."""
    points = () if engine.block is None else engine.block.points
    for key, above, below in (
        ("mounts", engine.mounts, own.mounts),
        ("points", points, own.points),
    ):
        taken = {each.name for each in above}
        for index, each in enumerate(below):
            if each.name in taken:
                values = {"value": seen(each.name)}
                yield Fault(("foundation", key, index, "name"), f"foundation.{key}-name", values)


def _feet_on_a_foundation(engine: Assembly) -> Iterator[Fault]:
    """Mounts with feet of their own, on a foundation that moves."""
    names = [mount.name for mount in engine.mounts if mount.foot]
    if names:
        values = {"names": ", ".join(map(seen, names))}
        yield Fault(("foundation",), "mounts.foot-and-foundation", values)


def _mount_faults(mounts: Sequence[Mount], here: Path) -> Iterator[Fault]:
    """Mounts of one name, without stiffness, at one place, or that leave a freedom."""
    found = [fault for each in _each_fault(mounts, here) for fault in each]
    yield from found
    if found:
        return
    places = np.array([(each.up, each.right, each.z) for each in mounts])
    if np.ptp(places, axis=0).max() < NO_SPREAD:
        code = "mounts.one" if len(mounts) == 1 else "mounts.one-place"
        yield Fault(here, code, {"name": seen(mounts[0].name), "count": len(mounts)})
    elif free := unrestrained(mounts):
        yield Fault(here, "mounts.free", {"freedoms": ", ".join(free)})


def _each_fault(mounts: Sequence[Mount], here: Path) -> Iterator[list[Fault]]:
    names = [each.name for each in mounts]
    for index, mount in enumerate(mounts):
        path, out = (*here, index), []
        if mount.name in names[:index]:
            values = {"value": seen(mount.name)}
            out.append(Fault((*path, "name"), "mounts.same-name", values))
        for key in ("stiffness", "damping"):
            count = len(getattr(mount, key))
            if count not in (0, 1, ALONG):
                out.append(Fault((*path, key), "mounts.length", {"count": count}))
        if not any(mount.stiffness):
            out.append(Fault((*path, "stiffness"), "mounts.no-stiffness"))
        rising = [each.frequency for each in mount.rubber]
        if any(after <= before for before, after in pairwise(rising)):
            out.append(Fault((*path, "rubber"), "mounts.rubber-order"))
        out += _foot_faults(mount, path)
        yield out


def _foot_faults(mount: Mount, path: Path) -> Iterator[Fault]:
    """Receptances of what a mount stands on that are out of order, or push by themselves."""
    rising = [each.frequency for each in mount.foot]
    if any(after <= before for before, after in pairwise(rising)):
        yield Fault((*path, "foot"), "mounts.foot-order")
    for index, each in enumerate(mount.foot):
        here = (*path, "foot", index)
        for key in ("amplitude", "lag"):
            count = len(getattr(each, key))
            if count not in (1, ALONG):
                yield Fault((*here, key), "mounts.length", {"count": count})
        if not all(-ROUNDED <= lag <= pi + ROUNDED for lag in each.lag):
            yield Fault((*here, "lag"), "mounts.foot-lag")
