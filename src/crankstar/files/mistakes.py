"""Validation errors of an engine file as faults, and a corrected copy of its tree."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from itertools import takewhile
from typing import Any

from pydantic import ValidationError

from crankstar.engine.records import Record
from crankstar.files.forms import by_key, example, field_at, is_explicit, quantity_of, record_in
from crankstar.language.faults import EngineError, Fault, ValueFaultError
from crankstar.language.quoting import seen

GREATEST_DEPTH = 16
"""Of tables within tables in a file."""
Tree = dict[str, Any]
Path = tuple[str | int, ...]


class SpreadsheetTree(dict[str, Any]):
    """A tree of keys read from a spreadsheet: the cell of each key path, and faults of cells."""

    def __init__(self, tree: Tree, cells: Mapping[Path, str], faults: Sequence[Fault]) -> None:
        super().__init__(tree)
        self.cells, self.faults = dict(cells), list(faults)

    def without(self, paths: Iterable[Sequence[str | int]], tree: Tree) -> SpreadsheetTree:
        """The changed tree, the values at these paths no longer those of cells."""
        gone = [tuple(path) for path in paths]

        def kept(path: Path) -> bool:
            return not any(path[: len(way)] == way for way in gone)

        cells = {path: cell for path, cell in self.cells.items() if kept(path)}
        return SpreadsheetTree(tree, cells, [fault for fault in self.faults if kept(fault.path)])


_KINDS = {
    "int_type": "whole-number",
    "int_from_float": "whole-number",
    "int_parsing_size": "whole-number",
    "float_type": "number",
    "finite_number": "finite-number",
    "string_type": "text",
    "string_unicode": "whole-text",
    "tuple_type": "list",
    "dict_type": "table",
    "model_type": "table",
    "model_attributes_type": "table",
}
"""What is needed, by what pydantic finds."""
_BOUNDS = {
    "greater_than": ("greater-than", "gt"),
    "greater_than_equal": ("at-least", "ge"),
    "less_than_equal": ("at-most", "le"),
}


def faults_of(
    error: ValidationError, model: type[Record], tree: Tree, *, under: Path = ()
) -> list[Fault]:
    """Every mistake of a validation as a fault; `under` is the path of the validated part."""
    faults: list[Fault] = []
    for mistake in _first_of_lists(_mistakes(error)):
        cause = mistake.get("ctx", {}).get("error")
        if isinstance(cause, EngineError):
            faults += cause.faults
            continue
        path = _in_file((*under, *_path(mistake)), tree)
        if isinstance(cause, ValueFaultError):
            faults.append(Fault(path, cause.code, cause.values))
        else:
            faults.append(_fault(mistake, path, model, tree))
    return faults


def _mistakes(error: ValidationError) -> Iterator[Any]:
    """What a validation found, except lists too short only because entries in them are wrong."""
    for mistake in error.errors(include_url=False):
        if (
            mistake["type"] != "too_short"
            or len(mistake["input"]) < mistake.get("ctx", {})["min_length"]
        ):
            yield mistake


_LONG = (("gas", "trace"), ("drive", "load_angle"), ("drive", "load_torque"))
"""Tables whose lists have thousands of numbers."""


def _first_of_lists(mistakes: Iterable[Any]) -> Iterator[Any]:
    """The mistakes, of each kind only the first in a list of samples: all have one reason."""
    seen_there: set[tuple[Any, ...]] = set()
    for mistake in mistakes:
        path, cause = _path(mistake), mistake.get("ctx", {}).get("error")
        kind = (path[:-1], mistake["type"], getattr(cause, "code", ""))
        if path[:2] in _LONG and isinstance(path[-1], int):
            if kind in seen_there:
                continue
            seen_there.add(kind)
        yield mistake


def _in_file(path: Path, tree: Tree) -> Path:
    """The path without the place in a list, where a file has one value instead of a list."""
    several = not path or not isinstance(path[-1], int) or isinstance(_at(tree, path[:-1]), list)
    return path if several or _at(tree, path[:-1]) is None else path[:-1]


def _path(mistake: Any) -> Path:
    return tuple(key for key in mistake["loc"] if key != "[key]")


def _fault(mistake: Any, path: Path, model: type[Record], tree: Tree) -> Fault:
    """What a validation error of pydantic means to the one who wrote the file."""
    kind, context = mistake["type"], mistake.get("ctx", {})
    counted = kind not in _BOUNDS and isinstance(_at(tree, path), int | float)
    if path in _COUNTS and counted:
        return _counted(path, tree)
    if kind == "extra_forbidden":
        return _unknown_key(path, model)
    if kind == "invalid_key":
        return Fault(path, "key.no-text", {"value": seen(mistake["input"])})
    values: dict[str, Any] = {"value": seen(_at(tree, path, mistake["input"]))}
    info = field_at(model, path)
    depth = sum(1 for _ in takewhile(lambda key: isinstance(key, int), reversed(path)))
    sample = example(info, depth=depth) if info else ""
    if path == _LONG[0] and isinstance(mistake["input"], str):
        return Fault(path, "trace.not-read", values | {"example": sample})
    if kind == "missing":
        values = {"key": str(path[-1])}
        return _with_example(Fault(path, "missing", values), sample)
    if kind == "tuple_type" and len(path) == 1 and info and record_in(info.annotation):
        return Fault(path, "type.list-of-tables", values | {"key": str(path[0])})
    if kind in _KINDS:
        return _with_example(Fault(path, "type", values | {"kind": _KINDS[kind]}), sample)
    if kind in _BOUNDS:
        code, bound = _BOUNDS[kind]
        fault = Fault(path, code, values | {"bound": context[bound]})
        return _with_example(fault, sample if info and quantity_of(info) else "")
    if kind == "literal_error":
        choices = str(context.get("expected", "")).replace("'", '"')
        return Fault(path, "choice", values | {"choices": choices})
    size = len(mistake["input"]) if hasattr(mistake["input"], "__len__") else 0
    if kind in ("too_long", "string_too_long"):
        code = "too-many" if kind == "too_long" else "too-long"
        return Fault(path, code, {"size": size, "bound": context["max_length"]})
    if kind == "too_short":
        return Fault(path, "too-few", {"size": size, "count": context["min_length"]})
    return Fault(path, "invalid", values | {"message": mistake["msg"]})


_COUNTS = {("cylinders",), ("layout", "cylinders")}
"""Where a number of cylinders is written, though it follows from what lists them."""


def _counted(path: Path, tree: Tree) -> Fault:
    """What lists the cylinders, each on its throw, in the layout of a file."""
    lists = {"radial": "layout.rows", "tandem": "layout.cranks"}
    key = lists.get(str(_at(tree, ("layout", "type"))), "layout.throws")
    return Fault(path, "cylinders.counted", {"key": key})


def _with_example(fault: Fault, sample: str) -> Fault:
    if not sample:
        return fault
    values = {**fault.values, "example": sample}
    return fault._replace(code=f"{fault.code}.example", values=values)


def _at(tree: Any, path: Path, otherwise: Any = None) -> Any:
    """What stands at a key path of a tree."""
    for key in path:
        if not _has(tree, key):
            return otherwise
        tree = tree[key]
    return tree


def _has(table: Any, key: Any) -> bool:
    return (
        key in table
        if isinstance(table, dict)
        else isinstance(table, list) and isinstance(key, int) and key < len(table)
    )


def _unknown_key(path: Path, model: type[Record]) -> Fault:
    """The probable meaning of an unknown key: similar, or the same key in another table."""
    key, table = str(path[-1]), path[:-1]
    keys = _keys_at(model, table)
    if table and key in by_key(model):
        return Fault(path, "key.belongs-at-top")
    home = _home(key, model)
    if home and not table:  # a key as it stands in a table is no slip of another
        return Fault(path, "key.belongs-in", {"table": home, "path": f"{home}.{key}"})
    near = _near(key, keys)
    if near:
        return Fault(path, "key.misspelt", {"meant": f'"{near}"'})
    if home and len(table) == 1:  # what is of a part, as the width of a bearing, is of no table
        return Fault(path, "key.belongs-in", {"table": home, "path": f"{home}.{key}"})
    return Fault(path, "key.unknown", {"keys": keys})


def _home(key: str, model: type[Record]) -> str | None:
    """The table of a file that has this key; of several the cylinder's."""
    tables = {name: record_in(info.annotation) for name, info in by_key(model).items()}
    homes = [name for name, held in tables.items() if held and key in by_key(held)]
    return "cylinder" if "cylinder" in homes else next(iter(homes), None)


def unknown_sources(tree: Tree, forms: Iterable[type[Record]]) -> Iterator[Fault]:
    """A fault for each key of [provenance] that names no value a file of these forms can have."""
    table = tree.get("provenance")
    names = [name for name in table if isinstance(name, str)] if isinstance(table, dict) else []
    paths: list[str] = []
    for form in forms:
        if not names:
            break
        paths += _paths(form)
        names = [name for name in names if re.sub(r"\[\d+\]", "", name) not in paths]
    for name in names:
        near = _near(name, paths)
        code, values = ("misspelt", {"meant": f'"{near}"'}) if near else ("unknown", {})
        yield Fault(("provenance", name), f"provenance.{code}", values)


RANGED = (
    *("reciprocating_mass", "rotating_mass", "throw_mass", "big_end_mass"),
    *("mass", "centre", "inertia", "rod_length", "rod_ratio", "bore_pitch", "row_pitch"),
    *("inertia_up", "inertia_right", "inertia_z"),
    *("bore", "stroke", "radius", "unbalance", "speed"),
)
"""Values that may have a range: their keys. Forces are computed at the ends of it."""


CONDITIONS = ("speed", "bore", "stroke", "unbalance")
"""Those of them that may be estimated without a range: results hold for that very value."""


def range_faults(tree: Tree) -> Iterator[Fault]:
    """A fault for each range in [provenance] that a value cannot have, or that moves with none."""
    table = tree.get("provenance")
    entries = table.items() if isinstance(table, dict) else ()
    with_range = {
        name: source
        for name, source in entries
        if isinstance(source, dict) and source.get("range") is not None
    }
    for name, source in entries:
        if isinstance(source, dict) and _lacks_range(name, source):
            yield Fault(("provenance", name), "provenance.no-range", {})
        elif isinstance(source, dict) and _is_of_nothing(tree, name, source):
            yield Fault(("provenance", name), "provenance.absent", {})
    leading = [name for name, source in with_range.items() if not source.get("moves_with")]
    for name, source in with_range.items():
        last = name.rpartition(".")[2] if isinstance(name, str) else ""
        if source.get("status") != "estimated":
            yield Fault(("provenance", name, "range"), "provenance.range-known", {})
        elif last not in RANGED:
            yield Fault(("provenance", name), "provenance.range", {"keys": ", ".join(RANGED)})
        other = source.get("moves_with")
        if isinstance(other, str) and other not in leading:
            if other == "cylinder.rod" and last == "inertia":
                continue
            path = ("provenance", name, "moves_with")
            yield Fault(path, "provenance.moves-with", {"value": seen(other)})


def _lacks_range(name: str, source: Tree) -> bool:
    """Whether a value is estimated and nothing tells how far it may be off."""
    last = name.rpartition(".")[2]
    if source.get("status") != "estimated" or last not in RANGED or last in CONDITIONS:
        return False
    ends = source.get("range")
    same = isinstance(ends, list) and len(ends) == 2 and ends[0] == ends[1] == 1
    return ends is None or same


def _is_of_nothing(tree: Tree, name: str, source: Tree) -> bool:
    """Whether a value is said to be estimated that the file has not.

    What an entry of a list that was deleted has left is told by `changes.stale_sources`. A file in
    the explicit form keeps the sources of the short one.
    """
    if source.get("status") != "estimated" or "[" in name or is_explicit(tree):
        return False
    places: list[Any] = [tree]
    for key in name.split("."):
        inner = [place[key] for place in places if isinstance(place, dict) and key in place]
        places = [item for each in inner for item in (each if isinstance(each, list) else [each])]
    return not places


@cache
def _paths(record: type[Record]) -> tuple[str, ...]:
    """The paths of all values of a record and the records in it, without places in lists."""
    paths: list[str] = []
    for key, info in by_key(record).items():
        inner = record_in(info.annotation)
        paths += [key, *(f"{key}.{path}" for path in (_paths(inner) if inner else ()))]
    return tuple(paths)


def _keys_at(model: type[Record], path: Path) -> list[str]:
    """The keys a table of the file may have: those of the record that stands at that place."""
    info = field_at(model, path)
    record = record_in(info.annotation) if info else model if not path else None
    return sorted(by_key(record)) if record else []


OTHER_NAMES = {
    "boost": "intake_pressure",
    "cr": "compression_ratio",
    "fmep": "friction_pressure",
    "manifold_pressure": "intake_pressure",
}
"""Keys by names that the field has for them and that do not look like them."""


def _near(key: str, keys: list[str]) -> str | None:
    meant = OTHER_NAMES.get(key.lower())
    if meant in keys:
        return meant
    turned = [each for each in keys if sorted(each) == sorted(key)]  # two letters exchanged
    return next(iter([*turned, *get_close_matches(key[:60], keys, 1, 0.6)]), None)


def mended(tree: Tree, error: ValidationError, model: type[Record], *, number: int) -> Tree:
    """A copy of the tree with slips corrected and other mistakes left out or replaced.

    Replacements come from `number`, so that faults common to two copies do not depend on them.
    """
    out: Tree = copied(tree)
    for index, mistake in enumerate(_mistakes(error)):
        path = _path(mistake)
        table, last = _at(out, path[:-1]), path[-1] if path else None
        info = field_at(model, path)
        quantity = quantity_of(info) if info else None
        measured = quantity is not None and quantity.dimension != "rotational speed"
        if isinstance(table, dict) and (info is None or not (info.is_required() or measured)):
            value, meant = table.pop(last, None), _near(str(last), _keys_at(model, path[:-1]))
            if len(path) == 1 and _home(str(last), model):
                continue
            if mistake["type"] == "extra_forbidden" and meant is not None:
                table.setdefault(meant, value)
        elif isinstance(table, dict) or _has(table, last):
            text = info is not None and info.annotation is str
            table[last] = (
                number / 9000 if measured else f"text {number}" if text else number + index % 400
            )
    return out


def copied(value: Any) -> Any:
    """A copy of a tree, tables and lists and all in them; a key whose value is null is left out.

    Numbers of numpy, alone or in arrays, become those of Python.
    """
    if isinstance(value, dict):
        return {key: copied(item) for key, item in value.items() if item is not None}
    if hasattr(value, "tolist"):
        value = value.tolist()
    return [copied(item) for item in value] if isinstance(value, list | tuple) else value
