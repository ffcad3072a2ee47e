"""What an engine file lacks for newtons and for uneven running, key by key."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection

from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.mechanics.chain_inertia import turning_inertia

KEYS = {
    "radius": "cylinder.stroke",
    "mass": "cylinder.reciprocating_mass",
    "pitch": "layout.bore_pitch",
}
"""The keys of a short file that give what is relative."""
RADIAL = 5
"""Cylinders on one throw from which it is the throw of a radial engine."""
SIZES = ("radius", "mass")
"""What newtons need, with a speed."""
WORDS = {
    "mass": N_("masses (cylinder.reciprocating_mass)"),
    "radius": N_("the stroke (cylinder.stroke)"),
    "pitch": N_("the distance of the cylinders (layout.bore_pitch)"),
}
"""What an engine file may leave out, and the key that gives it."""


def pitch_key(engine: Engine) -> str:
    """The key of a short file for the distance of cylinders, or of the rows of a radial engine.

    >>> from crankstar.files.catalog import load
    >>> pitch_key(load("i4"))
    'layout.bore_pitch'
    """
    on_throw = Counter((cylinder.shaft, cylinder.throw) for cylinder in engine.cylinders)
    return "layout.row_pitch" if max(on_throw.values()) >= RADIAL else KEYS["pitch"]


def lacking_keys(
    engine: Engine, speed: float | None, *, sizes: Collection[str] = SIZES, flywheel: bool = False
) -> list[str]:
    """The keys that are not known of a speed (rad/s), of `sizes`, and of the flywheel if needed.

    >>> from crankstar.files.catalog import load
    >>> lacking_keys(load("man-s50mc-c"), None, flywheel=True)
    ['speed', 'cylinder.reciprocating_mass', 'drive.inertia']
    """
    keys = {**KEYS, "pitch": pitch_key(engine)}
    found = ["speed"] if speed is None else []
    found += [key for size, key in keys.items() if size in sizes and size in engine.relative]
    if flywheel and turning_inertia(engine) is None:
        found.append("drive.inertia")
    return found


def lacking_words(engine: Engine, speed: float | None, sizes: Collection[str] = SIZES) -> list[str]:
    """The names of what is not known of a speed (rad/s) and of `sizes`, and what gives it.

    >>> from crankstar.files.catalog import load
    >>> lacking_words(load("man-s50mc-c"), 10.0)
    ['masses (cylinder.reciprocating_mass)']
    """
    names = [_(WORDS[size]) for size in WORDS if size in sizes and size in engine.relative]
    return names if speed is not None else [*names, _("a speed (see --speed)")]


def is_explicit(engine: Engine) -> bool:
    """Whether the values come from a file in the explicit form, as far as their origins say.

    Its numbers count in what its key `relative` names; a short file gives what it lacks by `KEYS`.

    >>> from crankstar.files.catalog import load
    >>> is_explicit(load("audi-25-tfsi"))
    False
    """
    return any(path.startswith(("shaft", "cylinders.throw")) for path in engine.provenance)


def without_running(engine: Engine, speed: float | None, flywheel: float | None = None) -> str:
    """What keeps the speed over a cycle from being known; empty where nothing does.

    `flywheel` (kg m^2) is one that was given beside the file.

    >>> from crankstar.files.catalog import load
    >>> without_running(load("audi-25-tfsi"), 100.0, flywheel=0.3)
    ''
    """
    missing = lacking_words(engine, speed)
    if flywheel is None and turning_inertia(engine) is None:
        missing.append(_("inertia of crankshaft, flywheel and rotor (see --flywheel)"))
    return _("not known: {missing}", missing=", ".join(missing)) if missing else ""


def running_sentence(reason: str) -> str:
    """Why uneven running is not told, as a sentence; empty where there is no reason.

    >>> running_sentence("not known: a speed (see --speed)")
    'Without uneven running: not known: a speed (see --speed).'
    """
    reason = reason.rstrip(".")
    return _("Without uneven running: {reason}.", reason=reason) if reason else ""
