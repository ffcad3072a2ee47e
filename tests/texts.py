"""Engine files that are right, for tests to spoil, and what a spoilt one is told."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any, NamedTuple

from crankstar.files import EngineFileError, engine_of, tree_of
from crankstar.language.faults import Fault, where

SHORT = """
format = 1
name = "V8, cross-plane, 90 deg"
cycle = "four-stroke"
firing_order = [1, 8, 4, 3, 6, 5, 7, 2]
[cylinder]
bore = "87.5 mm"
stroke = "82.5 mm"
rod_length = "146 mm"
reciprocating_mass = "650 g"
rotating_mass = "700 g"
[layout]
type = "vee"
banks = [
  { bearing = "45 deg", cylinders = [1, 3, 5, 7] },
  { bearing = "-45 deg", cylinders = [2, 4, 6, 8] },
]
throws = ["0 deg", "90 deg", "-90 deg", "180 deg"]
bore_pitch = "105.5 mm"
bank_offset = "21 mm"
"""

EXPLICIT = """
format = 1
name = "two and a balance shaft"
cycle = "two-stroke"
[[shaft]]
name = "crank"
[[shaft.throw]]
angle = "0 deg"
radius = "40 mm"
z = "50 mm"
rotating_mass = "1 kg"
[[shaft.throw]]
angle = "180 deg"
radius = "40 mm"
z = "-50 mm"
[[shaft]]
name = "balance shaft"
speed_ratio = -1
right = "100 mm"
[[shaft.weight]]
unbalance = "0.02 kg*m"
angle = "135 deg"
z = "170 mm"
[[cylinders]]
number = 1
shaft = "crank"
throw = 1
z = "50 mm"
rod_length = "146 mm"
reciprocating_mass = "0.65 kg"
[[cylinders]]
number = 2
shaft = "crank"
throw = 2
z = "-50 mm"
rod_length = "146 mm"
reciprocating_mass = "0.65 kg"
"""

REMEDIES = (
    ";",
    "did you mean",
    "use printable text",
    "Check the order",
    "It would fit",
    "it can be",
)
"""Every sentence about a mistake has one of these: after it stands what would be right."""


def spoilt(text: str, **changes: Any) -> dict[str, Any]:
    """The tree of a text with other values.

    `cylinder__stroke=3` sets cylinder.stroke, `shaft__0__name` what is in a list.
    """
    tree = tomllib.loads(text)
    for place, value in changes.items():
        *way, last = (int(key) if key.isdigit() else key for key in place.split("__"))
        table: Any = tree
        for key in way:
            table = table[key]
        table[last] = value
    return tree


class Problem(NamedTuple):
    """A fault of a file as text: where, and what is said of it behind that."""

    path: str
    message: str


def faults(source: str | Mapping[str, Any]) -> list[Fault]:
    """The faults of an engine file, as text or as a tree, after a look at how they are said."""
    try:
        engine_of(
            tree_of(source, name="FILE") if isinstance(source, str) else dict(source), name="FILE"
        )
    except EngineFileError as error:
        check_sentences(error)
        return error.faults
    return []


def problems(source: str | Mapping[str, Any]) -> list[Problem]:
    """The faults of an engine file as text."""
    return [_problem(fault) for fault in faults(source)]


def _problem(fault: Fault) -> Problem:
    place = where(fault.path)
    message = fault.sentence.removeprefix(place).removeprefix(":").strip()
    return Problem(place if fault.path else "", message)


def codes(source: str | Mapping[str, Any]) -> dict[str, str]:
    """The codes of the faults of a file by key path."""
    return {where(fault.path): fault.code for fault in faults(source)}


def check_sentences(error: EngineFileError) -> None:
    """Every mistake is one printable line of readable length that gives the right value."""
    lines = str(error).split("\n")
    assert lines[0].endswith(("mistake", "mistakes"))
    assert all(line.isprintable() for line in lines)
    assert max(map(len, lines)) < 1500
    for fault in error.faults:
        assert any(word in fault.sentence for word in REMEDIES), fault


def told(source: str | Mapping[str, Any]) -> dict[str, str]:
    """The problems of a file by key path."""
    return {problem.path: problem.message for problem in problems(source)}
