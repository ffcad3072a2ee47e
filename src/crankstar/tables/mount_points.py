"""How the named points of a block shake: velocity, acceleration, and that weighted for the hand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_response import MountResponse, rms
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number
from crankstar.language.shown_units import quantity_text

MM = 1e3
FREEDOM_NAMES = {
    "up": N_("up"),
    "right": N_("right"),
    "z": N_("along"),
    "yaw": N_("yaw"),
    "pitch": N_("pitch"),
    "roll": N_("roll"),
}
"""The freedoms as headings."""


def told_point(engine: Engine, point: Sequence[float]) -> str:
    """A point of the block (up, right, z; m) in words, by its name where the file gives it one.

    >>> from crankstar.files.catalog import load
    >>> told_point(load("audi-25-tfsi"), (0.1, -0.02, 0.3))
    'up 100 mm, right -20 mm, along 300 mm'
    """
    named = () if engine.block is None else engine.block.points
    name = next((own.name for own in named if own.place == tuple(point)), "")
    up, right, along = (quantity_text(round(each * MM, 6) + 0.0, "mm") for each in point)
    place = _("up {up}, right {right}, along {along}", up=up, right=right, along=along)
    return f"{name} ({place})" if name else place


def point_tables(engine: Engine, found: MountAnalysis) -> Iterator[Table]:
    """The worst over the speeds of each point of the file, and what they do at one speed."""
    places = _places(engine)
    if not places:
        return
    if found.over is not None and found.over.speeds.size > 1:
        yield _over_speeds(places, found.over)
    if found.at is not None:
        yield _at_speed(places, found.at)


class _Place(NamedTuple):
    """A point by its name, (up, right, z), and the body that it is of."""

    name: str
    at: tuple[float, float, float]
    of: int


def _places(engine: Engine) -> list[_Place]:
    """The points of the block, then those of the foundation."""
    points = () if engine.block is None else engine.block.points
    out = [_Place(point.name, point.place, 0) for point in points]
    if engine.foundation is not None:
        of = _("foundation")
        below = engine.foundation.points
        out += [_Place(f"{of}: {point.name}", point.place, 1) for point in below]
    return out


def _over_speeds(places: list[_Place], own: MountResponse) -> Table:
    columns = (
        Column(_("point"), kind="text", key="name", label=True),
        Column(_("velocity, rms"), "mm/s", key="velocity_rms"),
        Column(_("at speed"), "rpm", key="velocity_rpm", optional=1, digits=5),
        Column(_("acceleration, rms"), "m/s^2", key="acceleration_rms"),
        Column(_("at speed"), "rpm", key="acceleration_rpm", optional=1, digits=5),
        Column(_("weighted for the hand"), "m/s^2", key="hand_arm_rms", fixed=True),
        Column(_("at speed"), "rpm", key="hand_arm_rpm", digits=5),
    )
    rows: list[tuple[Value, ...]] = []
    for place in places:
        cells: list[Value] = [place.name]
        for course in _courses(own, place):
            worst = int(np.argmax(course))
            cells += [float(course[worst]), float(own.speeds[worst] * RPM)]
        rows.append(tuple(cells))
    title = _("Points of the block, where each shakes most")
    return Table(title, columns, tuple(rows), (_weighting(),), key="points")


def _at_speed(places: list[_Place], own: MountResponse) -> Table:
    columns = (
        Column(_("point"), kind="text", key="name", label=True),
        Column(_("displacement, rms"), "um", key="displacement_rms", optional=1),
        Column(_("velocity, rms"), "mm/s", key="velocity_rms"),
        Column(_("acceleration, rms"), "m/s^2", key="acceleration_rms"),
        Column(_("weighted for the hand"), "m/s^2", key="hand_arm_rms", fixed=True),
    )
    rows = tuple(
        (
            place.name,
            1e6 * float(rms(own.displacement(place.at, of=place.of))[0]),
            *(float(course[0]) for course in _courses(own, place)),
        )
        for place in places
    )
    title = _("Points of the block at {rpm} rpm", rpm=number(float(own.speeds[0] * RPM)))
    return Table(title, columns, rows, (_weighting(),), key="points_at_speed")


def _courses(own: MountResponse, place: _Place) -> Iterator[np.ndarray]:
    """Velocity (mm/s), acceleration and weighted acceleration (m/s^2), rms [speed]."""
    yield MM * rms(own.velocity(place.at, of=place.of))
    yield rms(own.acceleration(place.at, of=place.of))
    yield rms(own.hand_arm(place.at, of=place.of))


def _weighting() -> str:
    return _(
        "Weighted for the hand: W_h of ISO 5349-1, total of the three axes; what is harmful also "
        "depends on the hours of a day."
    )
