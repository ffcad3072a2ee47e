"""At which speed each of several engines is computed, and why."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, rpm_of
from crankstar.mechanics.operating_points import common_speed

HEADS = {
    "own": N_("Each at the speed of its file: {speeds}."),
    "same": N_("All at {rpm} rpm, the speed of each file."),
    "asked": N_("All at {rpm} rpm, as asked for; in the files: {speeds}."),
    "asked, none": N_("All at {rpm} rpm, as asked for; no file has a speed."),
    "least": N_("All at {rpm} rpm, the lowest of those in the files: {speeds}."),
    "assumed": N_("All at {rpm} rpm, assumed, for no file has a speed."),
}


def speed_head(
    engines: Sequence[Engine], names: Sequence[str], speeds: Sequence[float | None]
) -> str:
    """The sentence on the `speeds` (rad/s) of engines; empty where they are in m r w^2.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.language.numbers import RPM
    >>> both = [load("audi-25-tfsi", changes={"speed": each}) for each in ("3000 rpm", None)]
    >>> speed_head(both, ["five", "other"], [3000 / RPM] * 2)
    'All at 3000 rpm, the lowest of those in the files: five: 3000 rpm; other: none.'
    """
    at = [rpm_of(speed) for speed in speeds]
    own = [rpm_of(engine.speed) for engine in engines]
    if None in at:
        return ""
    guessed = [_estimated(engine) for engine in engines]
    told = "; ".join(map(_told, names, own, guessed))
    if at == own:
        kind = "same" if len({*at}) == 1 and not any(guessed) else "own"
        return _(HEADS[kind], rpm=_rpm(at[0]), speeds=told)
    none = not any(own)
    kind = "asked, none" if none else "asked"
    if at[0] == rpm_of(common_speed(engines)):
        kind = "assumed" if none else "least"
    return _(HEADS[kind], rpm=_rpm(at[0]), speeds=told)


def _estimated(engine: Engine) -> bool:
    """Whether a speed is not that of a file but one of such engines."""
    origin = engine.provenance.get("speed")
    return engine.speed is not None and origin is not None and origin.status == "estimated"


def _told(name: str, speed: float | None, estimated: bool) -> str:
    if speed is None:
        return _("{engine}: none", engine=name)
    if estimated:
        return _("{engine}: {rpm} rpm, estimated", engine=name, rpm=_rpm(speed))
    return _("{engine}: {rpm} rpm", engine=name, rpm=_rpm(speed))


def _rpm(speed: float | None) -> str:
    return number(speed or 0.0)
