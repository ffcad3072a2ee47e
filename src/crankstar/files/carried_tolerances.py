"""Tolerances carried from a file into the same engine written part by part.

What the explicit form says of one part by itself keeps its tolerance; a bore pitch and the angles
of a layout are no values of that form, and the tolerance of a value that was changed is no longer
known.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import isclose
from typing import Any

from crankstar.files import units
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Path, Tree, copied
from crankstar.files.tolerances import Tolerance, tolerances_of
from crankstar.language.faults import ValueFaultError

SAME = 1e-9
"""Share by which a value may differ that was written and read back."""


def carried(explicit: Tree, tree: Mapping[str, Any]) -> Tree:
    """The explicit tree with the tolerances of the tree that its engine came from.

    >>> tree = {"layout": {"type": "inline"}, "cylinder": {"reciprocating_mass": "500 g +- 2 g"}}
    >>> parts = {"cylinders": [{"number": 1, "reciprocating_mass": "500 g"}]}
    >>> carried(parts, tree)["cylinders"][0]["reciprocating_mass"]
    '500 g +- 2 g'
    """
    tolerances = tolerances_of(tree)
    if not tolerances:
        return explicit
    out = copied(explicit)
    for own in tolerances.values():
        share = 0.5 if own.keys == ("cylinder", "stroke") else 1.0
        for keys in _targets(out, tree, own):
            _put(out, keys, own, share)
    return out


def _targets(out: Tree, tree: Mapping[str, Any], own: Tolerance) -> Iterator[Path]:
    """Where the explicit form may have the value."""
    throws: list[Path] = [
        ("shaft", shaft, "throw", throw)
        for shaft, each in enumerate(out.get("shaft", ()))
        for throw in range(len(each.get("throw", ())))
    ]
    match own.keys:
        case ("cylinder", "stroke"):
            yield from ((*place, "radius") for place in throws)
        case ("cylinder", ("rotating_mass" | "throw_mass") as key):
            yield from ((*place, key) for place in throws)
        case ("cylinder", *keys):
            yield from (("cylinders", index, *keys) for index in range(len(out["cylinders"])))
        case ("cylinders", int(index), *keys) if not is_explicit(tree):
            number = tree["cylinders"][index].get("number")
            for place, cylinder in enumerate(out["cylinders"]):
                if cylinder.get("number") == number:
                    yield ("cylinders", place, *keys)
        case _:
            yield own.keys


def _put(out: Tree, keys: Path, own: Tolerance, share: float) -> None:
    """Write the tolerance behind the value, where it is the same value."""
    table: Any = out
    try:
        for key in keys[:-1]:
            table = table[key]
        value = table[keys[-1]]
        number = value if isinstance(value, float) else units.si(value, own.quantity)
    except (KeyError, IndexError, TypeError, ValueFaultError):
        return
    if not isclose(number, own.value * share, rel_tol=SAME, abs_tol=1e-12):
        return
    bound = own.bound * share
    text = (
        f"{bound:.12g}" if isinstance(value, float) else units.text(bound, own.quantity, digits=9)
    )
    table[keys[-1]] = f"{value} +- {text}"
