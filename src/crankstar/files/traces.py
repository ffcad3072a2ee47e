"""A measured pressure from a CSV file that an engine file names: `gas.trace = "pressure.csv"`.

The first column is the crank angle from the dead centre at which the cylinder fires, in degrees;
each other column the absolute pressure of a cylinder, or one for all. Heads say the unit, as in
`p [kPa]` or `cyl1_bar`; bar, and degrees, where they do not. A unit in brackets must be known.
Columns stand apart by commas, semicolons, tabs or spaces; but between commas, a comma may be the
decimal sign.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import isfinite
from pathlib import Path
from typing import Any

from crankstar.engine.quantities import ANGLE, PRESSURE, Quantity
from crankstar.files import units
from crankstar.files.errors import EngineFileError
from crankstar.files.read_files import note
from crankstar.language.faults import Fault, ValueFaultError
from crankstar.language.quoting import one_line

GREATEST_CSV = 20_000_000
"""Bytes."""
_BRACKETS = re.compile(r"[(\[{]([^)\]}]*)[)\]}]\s*([A-Za-z]*)")
_WORD = re.compile(r"[^\W\d_]+[²2]?")
_NUMBERED = re.compile(r"(?:cyl\w*|ch\w*|no|nr|#)?[\s.]*\d+$", re.IGNORECASE)
"""Brackets about the number of a cylinder or of a channel."""
_SAME = {
    **{name.lower(): name for name in ("mbar", "bar", "kPa", "MPa", "hPa", "Pa", "psi", "atm")},
    **dict.fromkeys(("degca", "deg ca", "°ca", "degca.", "ca", "deg", "degree", "degrees"), "deg"),
    **dict.fromkeys(("kgf/cm²", "kgf/cm2", "kg/cm²", "kg/cm2", "at"), "kgf/cm^2"),
}
"""Units as headings write them."""
_PLAIN = frozenset({"min", "max", "in", "out", "no", "nr", "ca", "cad", "atdc", "a", "b", "p"})
"""Words of headings that are units, too, or read like some."""
TRACE = ("gas", "trace")
Tree = dict[str, Any]


def with_trace(tree: Tree, folder: Path, name: str) -> Tree:
    """The tree of an engine file with the trace that it names read in. Raises EngineFileError."""
    gas = tree.get("gas")
    if not isinstance(gas, Mapping) or not isinstance(gas.get("trace"), str | Path):
        return tree
    return {**tree, "gas": {**gas, "trace": read_trace(str(gas["trace"]), folder, name)}}


def read_trace(file: str, folder: Path, name: str) -> Tree:
    """The table `trace` of a CSV file in a folder. Raises EngineFileError."""
    return trace_of(_text(folder, file, name), name=name, file=file)


def _refused(name: str, code: str, **values: Any) -> EngineFileError:
    return EngineFileError(name, [Fault(TRACE, f"trace.{code}", values)])


def _text(folder: Path, file: str, name: str) -> str:
    """The text of a CSV file in a folder."""
    if not file.strip():
        raise _refused(name, "unnamed")
    shown = one_line(file, longest=80)
    place = folder / file
    try:
        if place.exists() and not place.is_file():
            raise _refused(name, "folder" if place.is_dir() else "irregular", file=shown)
        with place.open("rb") as opened:
            note(opened)
            raw = opened.read(GREATEST_CSV + 1)
        text = raw[:GREATEST_CSV].decode("utf-8-sig")
    except FileNotFoundError:
        raise _refused(name, "missing", file=shown, place=one_line(str(place.absolute()))) from None
    except EngineFileError:
        raise
    except (OSError, ValueError):
        raise _refused(name, "unreadable", file=shown) from None
    if len(raw) > GREATEST_CSV:
        raise _refused(name, "too-large", file=shown, greatest=GREATEST_CSV // 1_000_000)
    return text


def trace_of(text: str, *, name: str, file: str) -> Tree:
    r"""The table `trace` of the text of a CSV file. Raises EngineFileError.

    >>> trace_of("angle;p kPa\n0;5000,5\n90;200", name="mine", file="p.csv")["pressure"]
    [['5000.5 kPa', '200 kPa']]
    """
    lines = {
        number: line
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.startswith("#")
    }
    comma = any(";" in line for line in list(lines.values())[:5])
    rows = [_cells(line, semicolons=comma) for line in lines.values()]
    heads = [] if not rows or _number(rows[0][0]) is not None else rows.pop(0)
    width = len(rows[0]) if rows else 0
    file_name = one_line(file, longest=80)
    if width < 2:
        raise _refused(name, "no-columns", file=file_name)
    faults = [
        Fault(TRACE, "trace.row", values)
        for number, row in zip(list(lines)[bool(heads) :], rows, strict=True)
        if len(row) != width or any(_number(cell) is None for cell in row)
        for values in [
            {"file": file_name, "line": number, "cells": one_line(", ".join(row), longest=60)}
        ]
    ]
    heads += [""] * (width - len(heads))
    units: list[str] = []
    for head in heads[:width]:
        quantity, usual = (PRESSURE, "bar") if units else (ANGLE, "deg")
        try:
            units.append(_unit(head, quantity, usual, name=name, file=file))
        except EngineFileError as error:
            units.append(usual)
            faults += error.faults
    if faults:
        raise EngineFileError(name, faults)
    for column, head in enumerate(heads[1:width], 1):
        lowest = min(float(row[column]) for row in rows)
        if lowest <= 0:
            shown = one_line(head, longest=60) or str(column)
            faults.append(
                Fault(TRACE, "trace.gauge", {"file": file_name, "head": shown, "value": lowest})
            )
    if faults:
        raise EngineFileError(name, faults)
    turn, *units = units
    return {
        "angle": [f"{row[0]} {turn}" for row in rows],
        "pressure": [
            [f"{row[column]} {unit}" for row in rows] for column, unit in enumerate(units, 1)
        ],
    }


def _cells(line: str, *, semicolons: bool) -> list[str]:
    """The cells of a line; a decimal comma becomes a point."""
    if semicolons or "\t" in line:
        cells = line.replace(",", ".").split(";" if semicolons else "\t")
    elif re.search(r"\d\s+[-+.\d]", line):
        cells = line.replace(",", ".").split()
    else:
        cells = line.split(",") if "," in line else line.split()
    return [cell.strip().strip('"').strip() for cell in cells]


def _number(text: str) -> float | None:
    """The number that a cell is; None for another text, and one too large to be counted with."""
    if not re.fullmatch(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", text):
        return None
    return float(text) if isfinite(float(text)) else None


def _unit(head: str, quantity: Quantity, usual: str, *, name: str, file: str) -> str:
    """The unit that a heading names, `usual` where it names none.

    What stands in brackets must be one; of other words those count that are units. Raises
    EngineFileError.
    """
    brackets = [f"{inner}{after}".strip() for inner, after in _BRACKETS.findall(head)]
    inside = [text for text in brackets if text and not _NUMBERED.match(text)][-1:]
    words = inside or _WORD.findall(re.sub(r"[_/]", " ", head.replace("°", " deg ")))
    for word in words:
        if not inside and word.lower() in _PLAIN:
            continue
        unit = _SAME.get(word.lower(), word)
        try:
            units.si(f"1 {unit}", quantity)
        except ValueFaultError as fault:
            known = fault.code not in ("unit.unknown", "unit.not-a-number")
            wrong = fault.code in ("unit.gauge", "unit.misspelt") or (known and len(word) > 2)
            if inside or wrong:
                code = "head-gauge" if fault.code == "unit.gauge" else "head"
                shown = {"head": one_line(head, longest=60), "dimension": quantity.dimension}
                places = {"file": one_line(file, longest=80), "example": usual}
                raise _refused(name, code, **shown, **places) from None
            continue
        return unit
    return usual
