"""Speeds, orders, angles, points of reference and settings, read from text."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import degrees as rad2deg
from math import isfinite
from pathlib import PurePath
from typing import Any, Literal, cast, get_args

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import (
    ANGLE,
    COUPLE,
    FORCE,
    LEAST,
    LENGTH,
    POSITION,
    SPEED,
    UNBALANCE,
    Quantity,
)
from crankstar.files import STANDARD_INPUT, changed, units
from crankstar.files.catalog import tree_of
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.quoting import one_line, seen
from crankstar.mechanics.balance import Grouping, unit_unbalance
from crankstar.mechanics.excitation import Reference
from crankstar.remedy import Aim, Limit, Plane, without_weights
from crankstar.remedy.fitting import Places, ShaftPlaces, Wanted

Derived = Literal["force", "couple", "torque"]
NEEDED = "needed"
"""What --shafts means without speed ratios."""


class RequestError(ValueError):
    """A request that cannot be met, as one sentence that says what would be right."""


def named(engine: str) -> str:
    """The name of an engine in a command for others: a file without its directory, printable.

    >>> named("v8-cross-plane"), named("/home/me/v8.toml"), named("/dev/stdin")
    ('v8-cross-plane', 'v8.toml', '-')
    """
    return "-" if engine == STANDARD_INPUT else one_line(PurePath(engine).name)


def setting(text: str) -> tuple[str, Any]:
    """A --set argument: a key path and a value, TOML if it can be read so, else text."""
    import tomllib

    path, equals, value = text.partition("=")
    if not equals or not path.strip():
        raise RequestError(
            f'--set {one_line(text)}: give a key path and a value, as in --set layout.bore_pitch="100 mm"'
        )
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except (ValueError, RecursionError):  # not TOML, or a number of thousands of digits
        return path.strip(), value


def own_factor(name: str, settings: Sequence[str] | None, *, otherwise: float) -> float:
    """The balance factor that an engine file gives, with what --set changes."""
    if name in ("-", STANDARD_INPUT):
        return otherwise  # which has been read already
    shown, tree = tree_of(name)
    found = changed(tree, dict(setting(text) for text in settings or ()), name=shown).get(
        "balance_factor"
    )
    return float(found) if isinstance(found, int | float) else otherwise


def speed(text: str | None) -> float | None:
    """A crank speed in rad/s."""
    if text is None:
        return None
    try:
        found = units.si(text, SPEED)
    except ValueFaultError as error:
        raise RequestError(error.at("--speed")) from None
    if found <= 0:
        raise RequestError(
            _(
                '--speed is {value}; it must be greater than 0, such as "{example}"',
                value=seen(text),
                example=SPEED.example,
            )
        )
    return found


def whole(option: str, text: str | None, *, most: int) -> int | None:
    """A whole number from 1 up. Raises RequestError."""
    if text is None:
        return None
    if not re.fullmatch(r"\d{1,9}", text.strip(), re.ASCII) or not 1 <= int(text) <= most:
        given = one_line(text)
        wrong = _("{given}: give a whole number from 1 to {most}", given=given, most=most)
        raise RequestError(f"{option}: {wrong}")
    return int(text)


def orders(text: str | None, present: list[float]) -> list[float] | None:
    """Crank orders; all is those that are present."""
    if text is None:
        return None
    if text.strip() == "all":
        return present
    try:
        wanted = [float(part) for part in text.split(",") if part.strip()]
    except ValueError:
        wanted = []
    if (
        not wanted
        or not all(isfinite(order) and 0 < order <= 1000 for order in wanted)
        or len(wanted) > 200
    ):
        raise RequestError(
            f"--orders {one_line(text)}: give numbers from above 0 up to 1000 with commas, as in 1,2,4,6, or all"
        )
    return list(dict.fromkeys(wanted))


def quantities(text: str | None) -> list[Derived]:
    """The quantities to derive: one, or force and couple."""
    if text is not None and text not in get_args(Derived):
        raise RequestError(f"--quantity {one_line(text)}: it can be {', '.join(get_args(Derived))}")
    return [
        kind for kind in get_args(Derived) if text == kind or (text is None and kind != "torque")
    ]


def derived_orders(text: str) -> list[Fraction]:
    """Crank orders to derive, whole, decimal or fractions; `all` is 1, 2, 4, 6 as in textbooks."""
    if text.strip() == "all":
        return [Fraction(order) for order in (1, 2, 4, 6)]
    parts = [part.strip() for part in text.split(",") if part.strip()]
    try:
        wanted = [Fraction(part) for part in parts if len(part) < 20 and "e" not in part.lower()]
    except (ValueError, ZeroDivisionError):
        wanted = []
    if not wanted or len(wanted) < len(parts) or len(wanted) > 24:
        raise RequestError(
            f"--order {one_line(text)}: give up to 24 crank orders with commas, as in 2 or 1,2,4,6 or 29/31, or all"
        )
    return list(dict.fromkeys(wanted))


def angles(text: str | None, *, option: str = "--theta") -> list[float]:
    """Crank angles in radians."""
    try:
        return [units.si(part.strip(), ANGLE) for part in (text or "").split(",") if part.strip()]
    except ValueFaultError as error:
        raise RequestError(error.at(option)) from None


def degrees(option: str, text: str) -> list[float]:
    """Angles in degrees; a bare number is in degrees, or in the unit that the last of them has."""
    parts = [part.strip() for part in text.split(",") if part.strip()]
    unit = (
        "deg"
        if not parts or units.is_bare(parts[-1])
        else parts[-1].lstrip("+-.0123456789").strip()
    )
    try:
        found = [
            rad2deg(units.si(f"{part} {unit}" if units.is_bare(part) else part, ANGLE))
            for part in parts
        ]
    except ValueFaultError as error:
        raise RequestError(error.at(option)) from None
    if not found:
        raise RequestError(
            f'{option} {one_line(text)}: give angles with commas, as in "90, 150 deg"'
        )
    return [round(angle, 9) for angle in found]


def repeated(option: str, text: str, *, of: int) -> list[float]:
    """Firing intervals in degrees, repeated until there are so many."""
    pattern = degrees(option, text)
    if of % len(pattern):
        raise RequestError(
            f"{option} {one_line(text)}: {len(pattern)} intervals cannot be repeated to make {of}, one for each firing"
        )
    return pattern * (of // len(pattern))


def grouping(text: str | None) -> Any:
    """By what parts are grouped."""
    if text is not None and text not in get_args(Grouping):
        raise RequestError(f"--by {one_line(text)}: it can be {', '.join(get_args(Grouping))}")
    return text


def reference(text: str | None, engine: Engine) -> Reference | None:
    """A point of reference in the units of the engine."""
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    example = 'as in "-120 mm" (z) or "0 mm, 35 mm, 0 mm" (z, up, right)'
    if len(parts) not in (1, 3):
        raise RequestError(f"--reference {one_line(text)}: give z, or z, up and right, {example}")
    return Reference(*_places("--reference", parts, [POSITION, LENGTH, LENGTH], engine, example))


def planes(option: str, text: str, engine: Engine) -> list[float]:
    """Places along the shaft in the units of the engine."""
    parts = [part.strip() for part in text.split(",") if part.strip()]
    if not 1 <= len(parts) <= 64:
        raise RequestError(
            f'{option} {one_line(text)}: give places along the shaft, as in "-200 mm, 200 mm"'
        )
    return _places(option, parts, [POSITION] * len(parts), engine, 'as in "-200 mm, 200 mm"')


def weights(text: str, engine: Engine) -> list[Plane] | Places:
    """The place of counterweights: pins, all webs, end webs, or planes of every crankshaft."""
    word = text.strip().lower()
    if word in get_args(Places):
        return cast("Places", word)
    if not any(letter.isdigit() for letter in text):
        raise RequestError(
            f'--weights {one_line(text)}: it can be pins, webs, ends, or places along the shaft as in "-200 mm, 200 mm"'
        )
    cranks = [shaft.name for shaft in engine.shafts if shaft.throws]
    return [Plane(name, z) for name in cranks for z in planes("--weights", text, engine)]


def aim(option: str, text: str, *, pitch: float | None = None) -> Aim:
    """The quantity that weights minimise; `pitch` is its share in a couple, yaw has the rest."""
    found = AIMS.get(" ".join(text.lower().split()))
    if found is None:
        raise RequestError(f"{option} {one_line(text)}: it can be {', '.join(AIMS)}")
    if pitch is None:
        return found
    if not 0 <= pitch <= 1:
        raise RequestError(
            f"--pitch-share {pitch:g}: give the share of pitch from 0 (only yaw counts) to 1 (only pitch)"
        )
    if found not in (AIMS["couple"], AIMS["rms couple"]):
        raise RequestError(
            "--pitch-share goes with --minimise couple or --minimise 'rms couple' only"
        )
    return found._replace(up=2 * pitch, right=2 * (1 - pitch))


AIMS = {
    "force": Aim("force"),
    "couple": Aim("couple"),
    "rms force": Aim("force", rms=True),
    "rms couple": Aim("couple", rms=True),
    "pitch": Aim("couple", up=1.0, right=0.0),
    "yaw": Aim("couple", up=0.0, right=1.0),
    "rms pitch": Aim("couple", rms=True, up=1.0, right=0.0),
    "rms yaw": Aim("couple", rms=True, up=0.0, right=1.0),
    "bearing": Aim("bearing"),
}


def limits(texts: Sequence[str] | None, engine: Engine, *, speed: float | None) -> list[Limit]:
    """Limits such as couple=1.5 (m r w^2 a), couple=50% (of bare crankshafts) or force="500 N".

    Newtons need a speed.
    """
    found: list[Limit] = []
    for text in texts or ():
        name, equals, value = text.partition("=")
        if not equals or not value.strip():
            raise RequestError(
                f'--limit {one_line(text)}: give what and how much, as in couple=50% or force="500 N"'
            )
        wanted = aim("--limit", name)
        found.append(Limit(wanted, _at_most(wanted, value.strip(), text, engine, speed)))
    return found


def _at_most(wanted: Aim, value: str, text: str, engine: Engine, speed: float | None) -> float:
    """A limit in m r w^2 or m r w^2 a."""
    option = f"--limit {one_line(text)}"
    percent = value.removesuffix("%").strip()
    plain = re.fullmatch(
        r"[-+]?(\d+(\.\d*)?|\.\d+)(e[-+]?\d{1,3})?|nan|inf", percent, re.ASCII | re.IGNORECASE
    )
    if plain is not None:
        number = float(percent)
        if not (isfinite(number) and number >= 0):
            raise RequestError(f"{option}: {one_line(value)} is no limit; give a number from 0 up")
        return number if "%" not in value else number / 100 * without_weights(engine, wanted)
    try:
        real = units.si(value, COUPLE if wanted.quantity == "couple" else FORCE)
    except ValueFaultError as error:
        raise RequestError(f"{error.at(option)}, a bare number of m r ω² or a share in %") from None
    known = {"mass", "radius"}.isdisjoint(engine.relative) and (
        "pitch" not in engine.relative or wanted.quantity != "couple"
    )
    if not known or speed is None:
        missing = (
            "a speed, as in --speed '6000 rpm'"
            if known
            else "an engine whose masses and sizes are known; give a bare number of m r ω²"
        )
        raise RequestError(f"{option}: newtons need {missing}")
    if real < 0:
        raise RequestError(f"{option}: {one_line(value)} is no limit; give a number from 0 up")
    return real / (
        unit_unbalance(engine) * speed**2 * (engine.pitch if wanted.quantity == "couple" else 1.0)
    )


def unbalance(option: str, text: str | None, engine: Engine) -> float | None:
    """An unbalance in m r of the first cylinder."""
    if text is None:
        return None
    try:
        found = units.reader(frozenset(engine.relative))(text, UNBALANCE)
    except ValueFaultError as error:
        raise RequestError(error.at(option)) from None
    if not found > 0:
        raise RequestError(
            f'{option} {one_line(text)}: must be greater than 0, such as "{UNBALANCE.example}"'
        )
    return found / unit_unbalance(engine)


def length(
    option: str, text: str | None, engine: Engine, *, positive: bool = False
) -> float | None:
    """A length across the crankshaft in the units of the engine."""
    if text is None:
        return None
    found = _places(option, [text.strip()], [LENGTH], engine, 'as in "60 mm"')[0]
    if positive and not found >= LEAST:
        raise RequestError(f'{option} {one_line(text)}: must be greater than 0, as in "60 mm"')
    return found


def ratios(text: str) -> list[Fraction] | Wanted:
    """Speed ratios of balance shafts, or that those the engine needs are wanted."""
    word = text.strip().lower()
    if word in get_args(Wanted):
        return cast("Wanted", word)
    parts = [part.strip() for part in text.split(",") if part.strip()]
    try:
        found = [Fraction(part) for part in parts if len(part) < 20 and "e" not in part.lower()]
    except (ValueError, ZeroDivisionError):
        found = []
    if len(found) < len(parts) or not found or len(found) > 8:
        raise RequestError(
            f'--shafts {one_line(text)}: give speed ratios with commas, negative against the crank, as in -1 or "2, -2"; '
            "or needed, or all"
        )
    return found


def shaft_places(
    engine: Engine, *, planes_text: str | None, place: str | None, spacing: str | None
) -> ShaftPlaces:
    """Where balance shafts lie and their weights on them."""
    along = None if planes_text is None else tuple(planes("--shaft-planes", planes_text, engine))
    parts = [part.strip() for part in (place or "0, 0").split(",")]
    if len(parts) != 2:
        raise RequestError(
            f'--shaft-place {one_line(place or "")}: give up and right, as in "-60 mm, 0 mm"'
        )
    up, right = _places("--shaft-place", parts, [LENGTH, LENGTH], engine, 'as in "-60 mm, 0 mm"')
    return ShaftPlaces(along, up, right, length("--shaft-spacing", spacing, engine) or 0.0)


def _places(
    option: str, parts: list[str], marks: list[Quantity], engine: Engine, example: str
) -> list[float]:
    """Lengths with their units, or bare where the engine counts in units of its own."""
    read = units.reader(frozenset(engine.relative))
    for part, mark in zip(parts, marks, strict=False):
        if units.is_bare(part) and not mark.relative_to & frozenset(engine.relative):
            raise RequestError(
                f"{option} {one_line(part)}: has no unit; write it with one, {example}"
            )
    try:
        return [read(part, mark) for part, mark in zip(parts, marks, strict=False)]
    except ValueFaultError as error:
        raise RequestError(f"{error.at(option)}, {example}") from None


def alone(option: str, others: Mapping[str, object]) -> None:
    """Refuse unused parts of an option rather than ignore them."""
    idle = [name for name, value in others.items() if value is not None]
    if idle:
        raise RequestError(
            f"{option} has no use for {', '.join(idle)}; leave {'it' if len(idle) == 1 else 'them'} out"
        )
