"""Speeds, orders, angles, points of reference and settings, read from text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
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
from crankstar.language.numbers import number as number_text
from crankstar.language.quoting import one_line, seen
from crankstar.mechanics.balance import Grouping, unit_unbalance
from crankstar.mechanics.excitation import Reference
from crankstar.options.refusals import RequestError, choice, refusal, refuse_unused
from crankstar.remedy import Aim, Limit, Plane, without_weights
from crankstar.remedy.fitting import Places, ShaftPlaces, Wanted

Derived = Literal["force", "couple", "torque"]
Derivable = Literal["motion", "force", "couple", "torque"]
NEEDED = "needed"
"""What --shafts means without speed ratios."""


def listed(text: str | None) -> list[str]:
    """What stands between commas."""
    return [part.strip() for part in (text or "").split(",") if part.strip()]


@contextmanager
def reading(option: str, *, example: str = "") -> Iterator[None]:
    """Have the fault of a value told as that of an option. Raises RequestError."""
    try:
        yield
    except ValueFaultError as error:
        raise RequestError(", ".join(filter(None, (error.at(option), example)))) from None


def named(engine: str) -> str:
    """The name of an engine in a command for others: a file without its directory, printable.

    >>> named("v8-cross-plane"), named("/home/me/v8.toml"), named("/dev/stdin")
    ('v8-cross-plane', 'v8.toml', '-')
    """
    return "-" if engine == STANDARD_INPUT else one_line(PurePath(engine).name)


def settings(texts: Sequence[str] | None) -> dict[str, Any]:
    """The values of --set by key path: TOML if they can be read so, else text.

    >>> settings(["layout.bore_pitch=100 mm", "cylinder.rod_ratio=3.5"])
    {'layout.bore_pitch': '100 mm', 'cylinder.rod_ratio': 3.5}
    """
    return dict(map(_setting, texts or ()))


def settings_of_each(texts: Sequence[str] | None, count: int) -> list[list[str]]:
    """The --set of each of several engines: KEY=VALUE is for all, 2:KEY=VALUE for the second.

    >>> settings_of_each(["balance_factor=0.5", "2:balance_factor=0.6"], 2)
    [['balance_factor=0.5'], ['balance_factor=0.5', 'balance_factor=0.6']]
    """
    out: list[list[str]] = [[] for _engine in range(count)]
    for text in texts or ():
        match = re.match(r"\s*(\d{1,3})\s*:", text, re.ASCII)
        if match is None:
            for own in out:
                own.append(text)
        elif not 1 <= int(match[1]) <= count:
            raise refusal("--set", text, "there are {count} engines, 1 to {count}", count=count)
        else:
            out[int(match[1]) - 1].append(text[match.end() :])
    return out


def _setting(text: str) -> tuple[str, Any]:
    import tomllib

    path, equals, value = text.partition("=")
    if not equals or not path.strip():
        example = 'layout.bore_pitch="100 mm"'
        raise refusal(
            "--set", text, "give a key path and a value, as in --set {example}", example=example
        )
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except (ValueError, RecursionError):  # not TOML, or a number of thousands of digits
        return path.strip(), value


def own_factor(name: str, texts: Sequence[str] | None, *, otherwise: float) -> float:
    """The balance factor that an engine file gives, with what --set changes."""
    if name in ("-", STANDARD_INPUT):
        return otherwise  # which has been read already
    shown, tree = tree_of(name)
    factor = changed(tree, settings(texts), name=shown).get("balance_factor")
    return float(factor) if isinstance(factor, int | float) else otherwise


def speed(text: str | None) -> float | None:
    """A crank speed in rad/s."""
    if text is None:
        return None
    with reading("--speed"):
        turning = units.si(text, SPEED)
    if turning <= 0:
        raise RequestError(
            '--speed is {value}; it must be greater than 0, such as "{example}"',
            value=seen(text),
            example=SPEED.example,
        )
    return turning


def single(option: str, texts: Sequence[str] | None) -> str | None:
    """The one value of an option that may be repeated elsewhere. Raises RequestError."""
    if texts and len(texts) > 1:
        raise refusal(option, ", ".join(texts), "give it once; here it takes one engine")
    return texts[0] if texts else None


def within(option: str, number: int | None, *, least: int = 1, most: int) -> int | None:
    """The whole number, if any, once it is between these two. Raises RequestError."""
    if number is not None and not least <= number <= most:
        raise refusal(
            option, number, "give a whole number from {least} to {most}", least=least, most=most
        )
    return number


def orders(text: str | None, present: list[float]) -> list[float] | None:
    """Crank orders, whole, decimal or fractions; all is those present, each also as printed."""
    if text is None:
        return None
    if text.strip() == "all":
        return present
    printed = {number_text(order): order for order in present}
    values = zip(listed(text), _fractions(text, most=200), strict=False)
    wanted = [printed.get(part, float(order)) for part, order in values]
    if not wanted or not all(0 < order <= 1000 for order in wanted):
        raise refusal(
            "--orders",
            text,
            "give numbers above 0 up to 1000 with commas, as in 1,2,4,6 or 29/31, or all",
        )
    return list(dict.fromkeys(wanted))


def quantities(text: str | None) -> list[Derived]:
    """The quantities to derive order by order, force and couple by default; `motion` is none."""
    names = ["force", "couple"] if text is None else (listed(text) or [text])
    chosen = [choice("--quantity", name, get_args(Derivable)) for name in names]
    return [cast("Derived", name) for name in chosen if name != "motion"]


def _fractions(text: str, *, most: int) -> list[Fraction]:
    """Fractions with commas; none where one cannot be read, or there are too many."""
    parts = listed(text)
    try:
        values = [
            Fraction(part)
            for part in parts
            if len(part) < 20 and not re.search(r"e[-+]?\d{3}", part, re.IGNORECASE)
        ]
    except (ValueError, ZeroDivisionError):
        return []
    return values if len(values) == len(parts) <= most else []


def derived_orders(text: str) -> list[Fraction]:
    """Crank orders to derive, whole, decimal or fractions; `all` is 1, 2, 4, 6 as in textbooks."""
    wanted = _fractions("1,2,4,6" if text.strip() == "all" else text, most=24)
    if not wanted:
        raise refusal(
            "--orders",
            text,
            "give up to 24 crank orders with commas, as in 2 or 1,2,4,6 or 29/31, or all",
        )
    return list(dict.fromkeys(wanted))


def angles(text: str | None) -> list[float]:
    """Crank angles in radians."""
    with reading("--theta"):
        return [units.si(part, ANGLE) for part in listed(text)]


def degrees(option: str, text: str) -> list[float]:
    """Angles in degrees; a bare number is in degrees, or in the unit that the last of them has."""
    parts = listed(text)
    if not parts:
        raise refusal(option, text, 'give angles with commas, as in "90, 150 deg"')
    bare = units.is_bare(parts[-1])
    unit = "deg" if bare else parts[-1].lstrip("+-.0123456789").strip()
    whole_parts = [f"{part} {unit}" if units.is_bare(part) else part for part in parts]
    with reading(option):
        return [round(rad2deg(units.si(part, ANGLE)), 9) for part in whole_parts]


def repeated(option: str, text: str, *, of: int) -> list[float]:
    """Firing intervals in degrees, repeated until there are so many."""
    pattern = degrees(option, text)
    if of % len(pattern):
        raise refusal(
            option,
            text,
            "{count} intervals cannot be repeated to make {firings}, one for each firing",
            count=len(pattern),
            firings=of,
        )
    return pattern * (of // len(pattern))


def grouping(text: str | None) -> Any:
    """By what parts are grouped."""
    return text and choice("--by", text, get_args(Grouping))


def reference(text: str | None, engine: Engine) -> Reference | None:
    """A point of reference in the units of the engine."""
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    example = _('as in "-120 mm" (z) or "0 mm, 35 mm, 0 mm" (z, up, right)')
    if len(parts) not in (1, 3):
        raise refusal("--reference", text, "give z, or z, up and right, {example}", example=example)
    return Reference(*_places("--reference", parts, [POSITION, LENGTH, LENGTH], engine, example))


def planes(option: str, text: str, engine: Engine) -> list[float]:
    """Places along the shaft in the units of the engine."""
    parts, example = listed(text), _('as in "-200 mm, 200 mm"')
    if not 1 <= len(parts) <= 64:
        raise refusal(option, text, "give places along the shaft, {example}", example=example)
    return _places(option, parts, [POSITION] * len(parts), engine, example)


def weights(text: str, engine: Engine) -> list[Plane] | Places:
    """The place of counterweights: pins, all webs, end webs, or planes of every crankshaft."""
    word = text.strip().lower()
    if word in get_args(Places):
        return cast("Places", word)
    if not any(letter.isdigit() for letter in text):
        raise refusal(
            "--weights",
            text,
            'it can be pins, webs, ends, or places along the shaft as in "-200 mm, 200 mm"',
        )
    cranks = [shaft.name for shaft in engine.shafts if shaft.throws]
    return [Plane(name, z) for name in cranks for z in planes("--weights", text, engine)]


def aim(option: str, text: str, *, pitch: float | None = None) -> Aim:
    """The quantity that weights minimise; `pitch` is its share in a couple, yaw has the rest."""
    wanted = AIMS[choice(option, " ".join(text.lower().split()), AIMS)]
    if pitch is None:
        return wanted
    if not 0 <= pitch <= 1:
        raise refusal(
            "--pitch-share",
            f"{pitch:g}",
            "give the share of pitch from 0 (only yaw counts) to 1 (only pitch)",
        )
    if wanted not in (AIMS["couple"], AIMS["rms couple"]):
        refuse_unused({"--pitch-share": pitch}, beside=f"--minimise {text}")
    return wanted._replace(up=2 * pitch, right=2 * (1 - pitch))


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


def limits(texts: Sequence[str], engine: Engine, *, speed: float | None) -> list[Limit]:
    """Limits such as couple=1.5 (m r w^2 a), couple=50% (of bare crankshafts) or force="500 N".

    Newtons need a speed.
    """
    out: list[Limit] = []
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals or not value.strip():
            raise refusal(
                "--limit", text, 'give a quantity and its limit, as in couple=50% or force="500 N"'
            )
        wanted = aim("--limit", name)
        out.append(Limit(wanted, _at_most(wanted, value.strip(), text, engine, speed)))
    return out


def _at_most(wanted: Aim, value: str, text: str, engine: Engine, speed: float | None) -> float:
    """A limit in m r w^2 or m r w^2 a."""
    percent = value.removesuffix("%").strip()
    plain = r"[-+]?(\d+(\.\d*)?|\.\d+)(e[-+]?\d{1,3})?|nan|inf"
    real = re.fullmatch(plain, percent, re.ASCII | re.IGNORECASE) is None
    couple = wanted.quantity == "couple"
    if real:
        example = _("a bare number of m r ω² or a share in %")
        with reading(f"--limit {one_line(text)}", example=example):
            number = units.si(value, COUPLE if couple else FORCE)
        if {"mass", "radius", *(["pitch"] if couple else [])} & {*engine.relative}:
            raise refusal(
                "--limit",
                text,
                "the masses and sizes of this engine are not known; give a number of m r ω²",
            )
        if speed is None:
            raise refusal("--limit", text, "newtons need a speed, as in --speed '6000 rpm'")
        number /= unit_unbalance(engine) * speed**2 * (engine.pitch if couple else 1.0)
    else:
        number = float(percent)
        if "%" in value:
            number *= without_weights(engine, wanted) / 100
    if not (isfinite(number) and number >= 0):
        raise refusal("--limit", text, "give a number from 0 up")
    return number


def unbalance(option: str, text: str | None, engine: Engine) -> float | None:
    """An unbalance in m r of the first cylinder."""
    if text is None:
        return None
    with reading(option):
        value = units.reader(frozenset(engine.relative))(text, UNBALANCE)
    if not value > 0:
        raise _not_positive(option, text, UNBALANCE)
    return value / unit_unbalance(engine)


def length(
    option: str, text: str | None, engine: Engine, *, positive: bool = False
) -> float | None:
    """A length across the crankshaft in the units of the engine."""
    if text is None:
        return None
    value = _places(option, [text.strip()], [LENGTH], engine, _('as in "60 mm"'))[0]
    if positive and not value >= LEAST:
        raise _not_positive(option, text, LENGTH)
    return value


def _not_positive(option: str, text: str, quantity: Quantity) -> RequestError:
    return refusal(
        option, text, 'it must be greater than 0, such as "{example}"', example=quantity.example
    )


def ratios(text: str) -> list[Fraction] | Wanted:
    """Speed ratios of balance shafts, or that those the engine needs are wanted."""
    word = text.strip().lower()
    if word in get_args(Wanted):
        return cast("Wanted", word)
    values = _fractions(text, most=8)
    if not values:
        raise refusal(
            "--shafts",
            text,
            'give speed ratios with commas, negative against the crank, as in -1 or "2, -2"; or '
            "needed, or all",
        )
    return values


def shaft_places(
    engine: Engine, *, planes_text: str | None, place: str | None, spacing: str | None
) -> ShaftPlaces:
    """Where balance shafts lie and their weights on them."""
    along = None if planes_text is None else tuple(planes("--shaft-planes", planes_text, engine))
    parts = [part.strip() for part in (place or "0, 0").split(",")]
    example = _('as in "-60 mm, 0 mm"')
    if len(parts) != 2:
        raise refusal("--shaft-place", place, "give up and right, {example}", example=example)
    up, right = _places("--shaft-place", parts, [LENGTH, LENGTH], engine, example)
    return ShaftPlaces(along, up, right, length("--shaft-spacing", spacing, engine) or 0.0)


def _places(
    option: str, parts: list[str], marks: list[Quantity], engine: Engine, example: str
) -> list[float]:
    """Lengths with their units, or bare where the engine counts in units of its own."""
    read = units.reader(frozenset(engine.relative))
    for part, mark in zip(parts, marks, strict=False):
        if units.is_bare(part) and not mark.relative_to & frozenset(engine.relative):
            raise refusal(option, part, "write it with a unit, {example}", example=example)
    with reading(option, example=example):
        return [read(part, mark) for part, mark in zip(parts, marks, strict=False)]
