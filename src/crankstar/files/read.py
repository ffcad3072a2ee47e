"""Engine files read: TOML or JSON text to an Engine, with every mistake of a file in one screen.

A file is read in two steps. First its tree is checked against the records, all mistakes at once; then the layout and
the engine are built, and what only the whole shows (a rod too short, an order that cannot fire) is added. Where the
tree itself has mistakes, a mended copy is built all the same, so that a wrong unit in one place does not hide a missing
cylinder in another.
"""

from __future__ import annotations

import json
import stat
import sys
import tomllib
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError

from crankstar import motion, units
from crankstar.engine import Engine, EngineError, Fault, Record, where
from crankstar.files.forms import form_of, is_explicit
from crankstar.files.mistakes import Tree, faults_of, mended, seen_as
from crankstar.firing import unfit
from crankstar.layouts import LAYOUTS

GREATEST_FILE = 1_000_000
"""Bytes: a hundred times the longest real engine file."""


class Problem(NamedTuple):
    """One mistake of an engine file: the key path it is at, and what was seen and would be right."""

    path: str
    message: str


class EngineFileError(ValueError):
    """An engine file that cannot be used, with every mistake found in it."""

    def __init__(self, name: str, problems: list[Problem]) -> None:
        self.name = name
        self.problems = problems
        lines = [f"{problem.path}: {problem.message}" if problem.path else problem.message for problem in problems]
        super().__init__("\n".join([f"{name}: {_counted(problems)}", *(f"  {line}" for line in lines)]))


def _counted(problems: list[Problem]) -> str:
    return "1 mistake" if len(problems) == 1 else f"{len(problems)} mistakes"


class _Draft(NamedTuple):
    """What came out of a tree: the engine if there is one, and the faults by key path."""

    engine: Engine | None
    faults: list[Fault]


def read(path: str | Path, *, name: str | None = None, changes: Mapping[str, Any] | None = None) -> Engine:
    """The engine of a file; "-" reads standard input; mistakes are told of `name`. Raises EngineFileError.

    `changes` sets values by key path before anything is checked: `{"layout.bore_pitch": "100 mm"}`.
    """
    name = name or ("standard input" if str(path) == "-" else _shown_name(path))
    return engine_of(tree_of(_text(path, name), name=name), name=name, changes=changes)


def _shown_name(path: str | Path) -> str:
    name = str(path)
    return "".join(letter if letter.isprintable() else "?" for letter in (name if len(name) <= 200 else "..." + name[-197:]))


def _text(path: str | Path, name: str) -> str:
    try:
        raw = sys.stdin.buffer.read(GREATEST_FILE + 1) if str(path) == "-" else _bytes(Path(path), name)
    except FileNotFoundError:
        raise _refused(name, "there is no such file; `crankstar list` names the engines of the catalog") from None
    except OSError as error:
        raise _refused(name, f"cannot be read: {error.strerror or error}") from None
    except ValueError:
        raise _refused(name, "is not a name a file can have") from None
    if len(raw) > GREATEST_FILE:
        raise _refused(name, f"is larger than {GREATEST_FILE // 1_000_000} MB; an engine file has a few kB")
    if not raw.strip():
        raise _refused(name, "is empty; `crankstar new vee` writes one to start from")
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise _refused(name, "is not a text file in UTF-8; an engine file is TOML or JSON")
    return text


def _bytes(path: Path, name: str) -> bytes:
    mode = path.stat().st_mode
    if stat.S_ISDIR(mode):
        raise _refused(name, "is a directory; name a file in it")
    if not stat.S_ISREG(mode):
        raise _refused(name, "is not a regular file; use - to read standard input")
    with path.open("rb") as file:
        return file.read(GREATEST_FILE + 1)


def _refused(name: str, message: str) -> EngineFileError:
    return EngineFileError(name, [Problem("", message)])


def tree_of(text: str, *, name: str = "the engine") -> Tree:
    """The tree of keys in TOML or JSON text (JSON starts with a brace). Raises EngineFileError with line and column."""
    try:
        tree = json.loads(text) if text.lstrip().startswith("{") else tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _refused(name, f"is not TOML: {error}") from None
    except json.JSONDecodeError as error:
        raise _refused(name, f"is not JSON: {error}") from None
    except RecursionError:
        raise _refused(name, "is nested too deeply for an engine file") from None
    except ValueError as error:  # a number of thousands of digits
        raise _refused(name, f"cannot be read: {error}") from None
    return tree


def engine_of(tree: Tree, *, name: str = "the engine", changes: Mapping[str, Any] | None = None) -> Engine:
    """The engine of a tree, in the short or the explicit form. Raises EngineFileError with every mistake in it."""
    tree = _changed(tree, changes or {}, name)
    explicit = is_explicit(tree)
    draft = _explicit(tree) if explicit else _short(tree)
    engine, faults = draft.engine, draft.faults
    if engine is not None and not faults:
        faults = motion.unreachable(engine) or unfit(engine)
    if faults or engine is None:
        raise EngineFileError(name, _problems(tree, faults, explicit=explicit))
    return engine


def _changed(tree: Tree, changes: Mapping[str, Any], name: str) -> Tree:
    out = json.loads(json.dumps(tree, default=str)) if changes else tree
    for path, value in changes.items():
        *way, last = path.split(".")
        table: Any = out
        for key in way:
            table = table.setdefault(key, {}) if isinstance(table, dict) else None
        if not isinstance(table, dict):
            raise _refused(name, f"there is no table {'.'.join(way)} in which {last} could be set")
        table[last] = value
    return out


def _explicit(tree: Tree) -> _Draft:
    known = _listed(tree.get("relative"))
    return _built(
        tree, relative=frozenset(name for name in ("mass", "radius", "pitch") if name in known), then=lambda engine: engine
    )


def _listed(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _short(tree: Tree) -> _Draft:
    layout = tree.get("layout")
    kind = layout.get("type") if isinstance(layout, dict) else None
    told = _layout_faults(layout, kind)
    relative = _unknown(tree)
    draft = _built(tree, relative=relative, then=None if told else _laid_out)
    if draft.engine is not None and "pitch" in draft.engine.relative and "pitch" not in relative:
        told.append(Fault(("layout", "bore_pitch"), "is missing; other lengths along the crankshaft are known, so give it"))
    return _Draft(draft.engine, told + draft.faults)


def _layout_faults(layout: Any, kind: Any) -> list[Fault]:
    if layout is None:
        example = '[layout] with type = "vee" (`crankstar new vee` writes one), or give [[shaft]] and [[cylinders]]'
        return [Fault(("layout",), f"is missing; say how the cylinders are arranged in a table {example}")]
    if not isinstance(layout, dict):
        return [Fault(("layout",), f"is {seen_as(layout)}; a table is needed")]
    if isinstance(kind, str) and kind in LAYOUTS:
        return []
    near = get_close_matches(str(kind), LAYOUTS, 1)
    told = "is missing" if kind is None else f"is {seen_as(kind)}" + (f'; did you mean "{near[0]}"?' if near else "")
    return [Fault(("layout", "type"), f"{told}; there are: {', '.join(LAYOUTS)}")]


def _unknown(tree: Tree) -> frozenset[str]:
    """What a short file does not tell, so that its numbers must be bare."""
    cylinder, layout = (table if isinstance(table := tree.get(key), dict) else {} for key in ("cylinder", "layout"))
    banks = [bank for bank in _listed(layout.get("banks")) if isinstance(bank, dict)]
    along = any(key in layout for key in ("bore_pitch", "positions", "row_pitch")) or isinstance(layout.get("bank_offset"), str)
    unknown = {
        "mass": "reciprocating_mass" not in cylinder,
        "radius": "stroke" not in cylinder,
        "pitch": not along and not any(isinstance(bank.get("set_back"), str) for bank in banks),
    }
    return frozenset(name for name, missing in unknown.items() if missing)


def _laid_out(record: Any) -> Engine:
    layout = {key: getattr(record.layout, key) for key in record.layout.model_fields_set if key != "type"}
    return LAYOUTS[record.layout.type](record, **layout)


def _built(tree: Tree, *, relative: frozenset[str], then: Callable[[Any], Engine] | None) -> _Draft:
    """Check a tree against its record and build the engine; with mistakes in it, add what a mended copy shows."""
    model, context = form_of(tree), {"reader": units.reader(relative)}
    try:
        record = model.model_validate(tree, context=context)
        return _Draft(None if then is None else then(record), [])
    except EngineError as error:
        return _Draft(None, error.faults)
    except ValidationError as error:
        faults = faults_of(error, model)
        if then is not None:
            faults += _structural(mended(tree, error, model), model, context, then, known=faults)
        return _Draft(None, faults)


def _structural(
    tree: Tree, model: type[Record], context: dict[str, Any], then: Callable[[Any], Engine], *, known: list[Fault]
) -> list[Fault]:
    """The faults of a mended tree that do not hang on what it was mended with: orders, indices, numbering."""
    try:
        then(model.model_validate(tree, context=context))
    except EngineError as error:
        found = error.faults
    except ValidationError as error:
        causes = [mistake.get("ctx", {}).get("error") for mistake in error.errors()]
        found = [fault for cause in causes if isinstance(cause, EngineError) for fault in cause.faults]
    else:
        return []
    told = {fault.path for fault in known}
    return [f for f in found if not f.geometric and not any(_overlap(f.path, path) for path in told)]


def _overlap(one: tuple[str | int, ...], other: tuple[str | int, ...]) -> bool:
    shorter = min(len(one), len(other))
    return one[:shorter] == other[:shorter]


def _problems(tree: Tree, faults: list[Fault], *, explicit: bool) -> list[Problem]:
    """Faults as lines of text, in the words of the file: what the short form says of all cylinders is said once."""
    overridden = {other.get("number") for other in _listed(tree.get("cylinders")) if isinstance(other, dict)}
    lines: dict[Problem, None] = {}
    for fault in faults:
        path = fault.path
        if not explicit and path[:1] == ("cylinders",) and len(path) == 3 and path[2] == "rod_length" and not overridden:
            path = ("cylinder", path[2])
        if not explicit and path[:1] == ("shaft",):
            path = ("layout",)
        lines.setdefault(Problem(where(path), fault.message))
    return list(lines)
