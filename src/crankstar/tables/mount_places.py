"""The mounts, the foundation and the named points of an engine file, as they are given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees

from crankstar.analysis.document import Column, Table, Value
from crankstar.engine.engine import Engine
from crankstar.engine.records import BlockPoint
from crankstar.language.messages import _

MM = 1e3
DOUBTFUL = ("unverified", "placeholder")


def mount_places(engine: Engine) -> Iterator[Table]:
    """Where each mount is, how it lies and how stiff it is, and where its values come from."""
    if engine.mounts:
        yield _mounts(engine)
    points = () if engine.block is None else engine.block.points
    if points:
        yield _points(_("Points of the block"), points, key="points")
    if engine.foundation is not None and engine.foundation.points:
        title = _("Points of the foundation")
        yield _points(title, engine.foundation.points, key="foundation_points")


def _mounts(engine: Engine) -> Table:
    columns = (
        Column(_("mount"), kind="text", key="name", label=True),
        *_places(),
        Column(_("bearing, lean, twist"), "deg", kind="list", key="turned", optional=1),
        Column(_("stiffness along its axes"), "N/mm", kind="list", key="stiffness"),
        Column(_("damping"), "N*s/m", kind="list", key="damping", optional=2),
        Column(_("loss factor"), key="loss_factor"),
        Column(_("status"), kind="text", key="status", wraps=True),
    )
    base = engine.foundation
    groups = [("mounts", "", engine.mounts)]
    if base is not None:
        groups.append(("foundation.mounts", _("foundation"), base.mounts))
    rows: list[tuple[Value, ...]] = []
    doubtful: set[int] = set()
    for path, of, own in groups:
        for number, mount in enumerate(own, 1):
            known = _statuses(engine, path, number)
            if mount.assumed:
                known.append(_("loss factor assumed"))
            if mount.assumed or any(_(each) in known for each in DOUBTFUL):
                doubtful.add(len(rows))
            rows.append(
                (
                    f"{of}: {mount.name}" if of else mount.name,
                    *(MM * each for each in (mount.up, mount.right, mount.z)),
                    tuple(degrees(each) for each in (mount.bearing, mount.lean, mount.twist)),
                    tuple(each / MM for each in mount.along),
                    tuple(mount.viscous),
                    mount.loss,
                    ", ".join(known),
                )
            )
    return Table(_("Mounts"), columns, tuple(rows), key="mounts", doubtful=frozenset(doubtful))


def _statuses(engine: Engine, path: str, index: int) -> list[str]:
    """How far the values of a mount are to be trusted, as the file says."""
    starts = (f"{path}[{index}]", f"{path}.")
    found = [
        origin.status
        for key, origin in engine.provenance.items()
        if key == path or key.startswith(starts)
    ]
    return [_(each) for each in dict.fromkeys(found)]


def _points(title: str, points: Sequence[BlockPoint], *, key: str) -> Table:
    columns = (Column(_("point"), kind="text", key="name", label=True), *_places())
    rows = tuple(
        (point.name, *(MM * each for each in (point.up, point.right, point.z))) for point in points
    )
    return Table(title, columns, rows, key=key)


def _places() -> tuple[Column, ...]:
    return (
        Column(_("up"), "mm", key="up"),
        Column(_("right"), "mm", key="right"),
        Column(_("along"), "mm", key="z"),
    )
