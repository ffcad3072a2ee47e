"""Speeds, orders, angles, points of reference and settings, read from text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from math import degrees as rad2deg
from typing import Any, Literal, cast, get_args

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import ANGLE, LEAST, SPEED, Quantity
from crankstar.files import keys_of, units
from crankstar.files.changes import path_and_value, with_traces
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.language.numbers import number as number_text
from crankstar.language.quoting import one_line, seen
from crankstar.mechanics.balance import Grouping
from crankstar.options.refusals import RequestError, choice, refusal
from crankstar.options.refusals import refuse_unused as refuse_unused  # with the other requests

Derived = Literal["force", "couple", "torque"]
Derivable = Literal["motion", "force", "couple", "torque", "gas", "twist"]
MOST_SPEEDS = 2000
"""Of all analyses, whose tables have a row for each."""
ALONE = ("motion", "gas", "twist")
"""What is not derived order by order."""


def listed(text: str | None) -> list[str]:
    """What stands between commas."""
    return [part.strip() for part in (text or "").split(",") if part.strip()]


def bounded(text: str) -> tuple[str, str]:
    """The name and the greatest value of a quantity in a limit; empty where it has none.

    The value may stand in quotes, as in TOML.

    >>> bounded("M1V=800 kN m"), bounded("couple <= 50%"), bounded('M1="800 kN m"')
    (('M1V', '800 kN m'), ('couple', '50%'), ('M1', '800 kN m'))
    """
    name, _equals, value = re.sub("<=|≤", "=", text).partition("=")
    value = value.strip()
    quoted = re.fullmatch(r"(['\"])(.*)\1", value)
    return name.strip(), quoted[2].strip() if quoted else value


@contextmanager
def reading(option: str, *, example: str = "") -> Iterator[None]:
    """Have the fault of a value told as that of an option. Raises RequestError."""
    try:
        yield
    except ValueFaultError as error:
        mistake = error.at(option)
        if example:
            mistake = _("{mistake}, {example}", mistake=mistake, example=example)
        raise RequestError(mistake) from None


def settings(texts: Sequence[str] | None) -> dict[str, Any]:
    """The values of --set by key path: TOML if they can be read so, else text.

    A trace is read from the CSV file of that name, as in an engine file, but beside the reader.

    >>> settings(["layout.bore_pitch=100 mm", "cylinder.rod_ratio=3.5"])
    {'layout.bore_pitch': '100 mm', 'cylinder.rod_ratio': 3.5}
    """
    found: dict[str, Any] = {}
    for text in texts or ():
        path, value = _setting(text)
        if keys_of(path) in map(keys_of, found):
            raise refusal("--set", text, "{path} is set before; give it once", path=seen(path))
        found[path] = value
    return with_traces(found, "--set")


def settings_of_each(texts: Sequence[str] | None, count: int) -> list[list[str]]:
    """The --set of each of several engines: KEY=VALUE is for all, 2:KEY=VALUE for the second.

    >>> settings_of_each(["balance_factor=0.5", "2:balance_factor=0.6"], 2)
    [['balance_factor=0.5'], ['balance_factor=0.6']]
    """
    of_all: list[str] = []
    out: list[list[str]] = [[] for _engine in range(count)]
    for text in texts or ():
        match = re.match(r"\s*(\d{1,3})\s*:", text)
        if match is None:
            of_all.append(text)
        elif not 1 <= int(match[1]) <= count:
            raise refusal("--set", text, "there are {count} engines, 1 to {count}", count=count)
        else:
            out[int(match[1]) - 1].append(text[match.end() :])
    for own in out:
        paths = [_keys(text) for text in own]
        own[:0] = [text for text in of_all if _keys(text) not in paths]
    return out


def _keys(text: str) -> list[str | int]:
    return keys_of(path_and_value(text)[0])


def _setting(text: str) -> tuple[str, Any]:
    import tomllib

    path, equals, value = path_and_value(text)
    if not equals or not path:
        example = 'layout.bore_pitch="100 mm"'
        raise refusal(
            "--set", text, "give a key path and a value, as in --set {example}", example=example
        )
    try:
        return path, tomllib.loads(f"value = {value}")["value"]
    except (ValueError, RecursionError):  # not TOML, or a number of thousands of digits
        return path, value


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


def speeds(text: str) -> list[float]:
    """Crank speeds in rad/s, of --speeds. Raises SweepError, RequestError for too many.

    >>> [round(speed) for speed in speeds("600..1200 rpm by 300")]
    [63, 94, 126]
    """
    import numpy as np

    from crankstar.studies.ranges import speeds_request
    from crankstar.studies.study import rad_per_s
    from crankstar.studies.variants import SweepError

    asked = speeds_request(text)
    if len(asked.values) > MOST_SPEEDS:
        raise refusal("--speeds", text, "give up to {most} speeds", most=MOST_SPEEDS)
    try:
        return rad_per_s(np.array(asked.values), asked.unit).tolist()
    except SweepError as error:
        raise SweepError(f"--speeds {one_line(text, longest=100)}: {error}") from None


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


def whole(name: str, text: str) -> int:
    """A whole number of a word that follows the command. Raises RequestError."""
    if not re.fullmatch(r"[-+]?\d{1,9}", text.strip()):
        raise refusal(name, text, "give a whole number")
    return int(text)


def orders(text: str | None, present: list[float]) -> list[float] | None:
    """Crank orders, whole, decimal or fractions; all is those present, each also as printed."""
    if text is None:
        return None
    if text.strip() == "all":
        return present
    printed = {str(number_text(order)): order for order in present}
    values = zip(listed(text), fractions(text, most=200), strict=False)
    wanted = [printed.get(part, float(order)) for part, order in values]
    if not wanted or not all(0 < order <= 1000 for order in wanted):
        raise refusal(
            "--orders",
            text,
            "give numbers above 0 up to 1000 with commas, as in 1,2,4,6 or 29/31, or all",
        )
    return list(dict.fromkeys(wanted))


def refuse_foreign(text: str | None, engines: Sequence[Engine], *, gas: bool) -> None:
    """Refuse orders that none of the engines can have. Raises OrderError, RequestError."""
    from crankstar.mechanics.balance import balance
    from crankstar.mechanics.occurring_orders import check_orders, foreign_orders

    present = [order for engine in engines for order in balance(engine).force.orders.tolist()]
    wanted = orders(None if text == "all" else text, present) or []
    for engine in engines:
        wanted = foreign_orders(engine, wanted, gas=gas)
    check_orders(engines[0], wanted, gas=gas)


def quantities(text: str | None) -> list[Derived]:
    """The quantities derived order by order, by default force and couple."""
    names = ["force", "couple"] if text is None else (listed(text) or [text])
    chosen = [choice("--quantity", name, get_args(Derivable)) for name in names]
    return [cast("Derived", name) for name in chosen if name not in ALONE]


def cylinders_off(text: str | None) -> tuple[int, ...]:
    """The numbers of cylinders that do not fire, with commas. Raises RequestError."""
    parts = listed(text)
    if any(not part.isdecimal() or len(part) > 4 for part in parts) or (
        text is not None and not parts
    ):
        raise refusal("--off", text or "", "give numbers of cylinders, as in 2,3")
    return tuple(dict.fromkeys(int(part) for part in parts))


def fractions(text: str, *, most: int) -> list[Fraction]:
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
    from crankstar.derive.records import GREATEST_ORDER

    wanted = fractions("1,2,4,6" if text.strip() == "all" else text, most=24)
    if wanted and not 0 < min(wanted) <= max(wanted) <= GREATEST_ORDER:
        raise refusal(
            "--orders",
            text,
            "give crank orders above 0 and up to {greatest}, such as 2 or 29/31",
            greatest=GREATEST_ORDER,
        )
    if not wanted:
        raise refusal(
            "--orders",
            text,
            "give up to 24 crank orders with commas, as in 2 or 1,2,4,6 or 29/31, or all",
        )
    return list(dict.fromkeys(wanted))


def angles(text: str | None) -> list[float]:
    """Crank angles in radians."""
    if text is not None and not listed(text):
        example = '"0 deg, 90 deg"'
        raise refusal("--theta", text, "give crank angles, such as {example}", example=example)
    with reading("--theta"):
        return [units.si(part, ANGLE) for part in listed(text)]


def degrees(option: str, text: str) -> list[float]:
    """Angles in degrees; a bare number is in degrees, or in the unit that the last of them has."""
    parts = listed(text)
    if not parts:
        raise refusal(option, text, 'give angles with commas, as in "90, 150 deg"')
    unit = units.unit_of(parts[-1]) or "deg"
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


def positive(option: str, text: str, *, quantity: Quantity) -> float:
    """A value above zero. Raises RequestError."""
    with reading(option):
        value = units.si(text, quantity)
    if value <= 0:
        raise not_positive(option, text, quantity)
    return value


def not_positive(option: str, text: str, quantity: Quantity) -> RequestError:
    """The refusal of a value that is not above 0."""
    return refusal(
        option, text, 'it must be greater than 0, such as "{example}"', example=quantity.example
    )


def size(option: str, text: str, *, quantity: Quantity) -> float:
    """A value above 0 with its unit. Raises RequestError."""
    if units.is_bare(text):
        raise refusal(
            option, text, 'write it with a unit, such as "{example}"', example=quantity.example
        )
    with reading(option):
        value = units.si(text, replace(quantity, least=max(quantity.least, LEAST)))
    if not value > 0:
        raise not_positive(option, text, quantity)
    return value
