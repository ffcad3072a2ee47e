"""Engine files read: TOML or JSON text to an Engine, with every mistake of a file in one screen.

A file is read in two steps. First its tree is checked against the records, all mistakes at once; then the layout and
the engine are built, and what only the whole shows (a rod too short, an order that cannot fire) is added. Where the
tree itself has mistakes, a mended copy is built all the same, so that a wrong unit in one place does not hide a missing
cylinder in another.
"""

from __future__ import annotations

import json
import re
import stat
import sys
import tomllib
from collections import Counter
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError

from crankstar import motion, units
from crankstar.arrangement import Sizes
from crankstar.engine import Engine
from crankstar.fault import EngineError, Fault, counted, where
from crankstar.files.forms import form_of, is_explicit
from crankstar.files.mistakes import Tree, copied, faults_of, mended
from crankstar.firing import unfit
from crankstar.layouts import LAYOUTS
from crankstar.quantity import one_line, seen
from crankstar.records import Record

GREATEST_FILE = 1_000_000
"""Bytes: a hundred times the longest real engine file."""
GREATEST_VALUES = 20_000
GREATEST_DEPTH = 16
GREATEST_TOLD = 100
"""Mistakes of one file that are told one by one."""


STANDARD_INPUT = "/dev/stdin"
_STANDARD_INPUTS = ("-", STANDARD_INPUT)


class Problem(NamedTuple):
    """One mistake of an engine file: the key path it is at, and what was seen and would be right."""

    path: str
    message: str


class EngineFileError(ValueError):
    """An engine file that cannot be used, with every mistake found in it."""

    def __init__(self, name: str, problems: list[Problem]) -> None:
        self.name = name
        self.problems = problems
        lines = [f"{path}: {message}" if path else message for path, message in problems[:GREATEST_TOLD]]
        if len(problems) > GREATEST_TOLD:
            lines.append(f"... and {len(problems) - GREATEST_TOLD} more")
        super().__init__("\n".join([f"{name}: {counted(len(problems), 'mistake')}", *(f"  {line}" for line in lines)]))


class _Draft(NamedTuple):
    """What came out of a tree: the engine if there is one, and the faults by key path."""

    engine: Engine | None
    faults: list[Fault]


def read(path: str | Path, *, name: str | None = None, changes: Mapping[str, Any] | None = None) -> Engine:
    """The engine of a file; "-" reads standard input; mistakes are told of `name`. Raises EngineFileError.

    `changes` sets values by key path before anything is checked: `{"layout.bore_pitch": "100 mm"}`.
    """
    name, tree = read_tree(path, name=name)
    return engine_of(tree, name=name, changes=changes)


def read_tree(path: str | Path, *, name: str | None = None) -> tuple[str, Tree]:
    """The name by which messages call a file, and its tree of keys, not checked. Raises EngineFileError."""
    name = name or ("standard input" if str(path) in _STANDARD_INPUTS else _shown_name(path))
    return name, tree_of(_text(path, name), name=name)


def _shown_name(path: str | Path) -> str:
    name = str(path)
    return one_line(name if len(name) <= 200 else "..." + name[-197:])


def _text(path: str | Path, name: str) -> str:
    try:
        raw = _standard_input(name) if str(path) in _STANDARD_INPUTS else _bytes(Path(path), name)
    except FileNotFoundError:
        raise _refused(name, "there is no such file; `crankstar list` names the engines of the catalog") from None
    except OSError as error:
        raise _refused(name, f"cannot be read ({error.strerror or error}); name another file") from None
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


def _standard_input(name: str) -> bytes:
    if sys.stdin is None:
        raise _refused(name, "is closed; pipe an engine file into it, or name one")
    return sys.stdin.buffer.read(GREATEST_FILE + 1)


def _bytes(path: Path, name: str) -> bytes:
    try:
        mode = path.stat().st_mode
    except ValueError:
        raise _refused(name, "is not a name a file can have; name an engine of the catalog or a file") from None
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

    def once(pairs: list[tuple[str, Any]]) -> Tree:
        tree = dict(pairs)
        if len(tree) < len(pairs):
            twice = next(key for key, count in Counter(key for key, _ in pairs).items() if count > 1)
            raise _refused(name, f"has the key {seen(twice)} twice in one table; give it once")
        return tree

    try:
        return json.loads(text, object_pairs_hook=once) if text.lstrip().startswith("{") else tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _refused(name, f"is not TOML: {error}{_line_told(text, str(error))}") from None
    except json.JSONDecodeError as error:
        raise _refused(name, f"is not JSON: {error}; `crankstar new vee` writes a file in TOML to compare with") from None
    except RecursionError:
        raise _refused(name, "is nested too deeply; an engine file has tables in tables, and no more") from None
    except EngineFileError:
        raise
    except ValueError:
        raise _refused(name, "holds a number of thousands of digits; write it shorter, as in 0.0825") from None


def _line_told(text: str, told: str) -> str:
    """The line of a file at which TOML stops making sense, and what is often meant."""
    found = re.search(r"at line (\d+)", told)
    line = text.split("\n")[int(found.group(1)) - 1].strip() if found else ""
    bare = re.search(r"[=,\[]\s*([-+]?[\d.]+ *[A-Za-z\u00b0][A-Za-z]*)", line)
    hint = "; `crankstar new vee` writes a file to compare with"
    if bare:
        hint = f"; a number with a unit stands in quotation marks, as in {seen(bare.group(1))}"
    elif told.startswith("Cannot"):
        hint = "; the same key or table stands twice, give it once"
    return (f": {one_line(line, longest=80)}" if line else "") + hint


def engine_of(tree: Tree, *, name: str = "the engine", changes: Mapping[str, Any] | None = None) -> Engine:
    """The engine of a tree, in the short or the explicit form. Raises EngineFileError with every mistake in it."""
    tree = changed(tree, changes or {}, name=name)
    explicit = is_explicit(tree)
    draft = _explicit(tree) if explicit else _short(tree)
    engine, faults = draft.engine, draft.faults
    if engine is not None and not faults:
        faults = motion.unreachable(engine) or unfit(engine)
    if faults or engine is None:
        raise EngineFileError(name, _problems(tree, faults, explicit=explicit))
    return engine


def _bounded(tree: Any, name: str) -> Tree:
    """The tree itself, once it is found to be a table, and no larger than an engine can need."""
    if not isinstance(tree, dict):
        raise _refused(name, f"is {seen(tree)}; a table of keys is needed")
    level: list[tuple[tuple[str | int, ...], Any]] = [((), tree)]
    count = 0
    for _ in range(GREATEST_DEPTH):
        level = [(path, value) for path, value in level if isinstance(value, dict | list)]
        count += sum(len(value) for _, value in level)
        if count > GREATEST_VALUES:
            path, widest = max(level, key=lambda item: len(item[1]))
            told = f"has {len(widest)} entries, and the file more than {GREATEST_VALUES} values; no engine needs so many"
            raise EngineFileError(name, [Problem(where(path), told)])
        if not level:
            return tree
        level = [
            ((*path, key), item)
            for path, value in level
            for key, item in (value.items() if isinstance(value, dict) else enumerate(value))
        ]
    raise _refused(name, "is nested too deeply; an engine file has tables in tables, and no more")


def changed(tree: Tree, changes: Mapping[str, Any], *, name: str = "the engine") -> Tree:
    """A tree with values set by key path, in the notation of the messages: `layout.banks[1].bearing`, counted from one.

    Raises EngineFileError where a path leads nowhere, or where there is more than an engine can need.
    """
    out = copied(_bounded(tree, name))
    for path, value in changes.items():
        way = keys_of(path)
        table: Any = out
        for place, key in enumerate(way):
            if not _can_hold(table, key):
                whole = one_line(where(tuple(way[:place])), longest=60)
                raise EngineFileError(name, [Problem(one_line(path), f"cannot be set; {whole} is {_holding(table)}")])
            if place == len(way) - 1:
                table[key] = value
            else:
                table = table[key] if isinstance(key, int) else table.setdefault(key, {})
    return _bounded(out, name)


def keys_of(path: str) -> list[str | int]:
    """The keys of a path: names, and places in lists counted from nought."""
    if not re.fullmatch(r"[^.\[\]]+(\.[^.\[\]]+|\[\d{1,6}\])*", path):
        return [path]
    return [int(index) - 1 if index else key for index, key in re.findall(r"\[(\d+)\]|([^.\[\]]+)", path)]


def _can_hold(table: Any, key: str | int) -> bool:
    return isinstance(table, dict) if isinstance(key, str) else isinstance(table, list) and 0 <= key < len(table)


def _holding(table: Any) -> str:
    if isinstance(table, list):
        return f"a list of {len(table)}; name one of them by its place, as in [1], or give the whole of it"
    return "not a list" if isinstance(table, dict) else "not a table; give the whole of it"


def _explicit(tree: Tree) -> _Draft:
    return _built(tree, Engine, _relative(tree), lambda engine: engine, instead="or take {name} out of relative")


def _relative(tree: Tree) -> frozenset[str]:
    """What a file says is not known."""
    told = _listed(tree.get("relative"))
    return frozenset(name for name in ("mass", "radius", "pitch") if name in told)


def _listed(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _short(tree: Tree) -> _Draft:
    other = [key for key in ("shaft", "shafts") if key in tree]
    mixed = "belongs to the explicit form, and layout and cylinder to the short one; leave one out (`crankstar show --explicit`)"
    tree = {key: value for key, value in tree.items() if key not in other}
    layout = tree.get("layout")
    told = [*(Fault((key,), mixed) for key in other), *_layout_faults(layout)]
    relative = _unknown(tree)
    draft = _built(
        tree, form_of(tree), relative, None if _layout_faults(layout) else partial(_laid_out, relative), instead="or give that"
    )
    if draft.engine is not None and "pitch" in draft.engine.relative and "pitch" not in relative:
        told.append(Fault(("layout", "bore_pitch"), 'is missing; give it, as in bore_pitch = "105.5 mm"'))
    return _Draft(draft.engine, told + draft.faults)


def _layout_faults(layout: Any) -> list[Fault]:
    if layout is None:
        example = '[layout] with type = "vee" (`crankstar new vee` writes one), or give [[shaft]] and [[cylinders]]'
        return [Fault(("layout",), f"is missing; say how the cylinders are arranged in a table {example}")]
    if not isinstance(layout, dict):
        return [Fault(("layout",), f'is {seen(layout)}; a table is needed, [layout] with type = "vee"')]
    kind = layout.get("type")
    if isinstance(kind, str) and kind in LAYOUTS:
        return []
    near = get_close_matches(kind.lower()[:60], LAYOUTS, 1) if isinstance(kind, str) else []
    told = "is missing" if "type" not in layout else f"is {seen(kind)}"
    return [Fault(("layout", "type"), told + (f'; did you mean "{near[0]}"?' if near else f"; it can be {', '.join(LAYOUTS)}"))]


def _unknown(tree: Tree) -> frozenset[str]:
    """What a short file does not tell, so that its numbers must be bare."""
    cylinder, layout = (table if isinstance(table := tree.get(key), dict) else {} for key in ("cylinder", "layout"))
    banks = [bank for bank in _listed(layout.get("banks")) if isinstance(bank, dict)]
    along = any(_tells(layout, key) for key in ("bore_pitch", "positions", "row_pitch"))
    along = along or any(isinstance(value, str) for value in (layout.get("bank_offset"), *(bank.get("set_back") for bank in banks)))
    unknown = {"mass": not _tells(cylinder, "reciprocating_mass"), "radius": not _tells(cylinder, "stroke"), "pitch": not along}
    return _relative(tree) | {name for name, missing in unknown.items() if missing}


def _tells(table: Tree, key: str) -> bool:
    """Whether a table has a key, or one that is a slip of the pen for it."""
    others = [str(other)[:60] for other in table if other not in Sizes.model_fields]
    return key in table or bool(get_close_matches(key, others, 1, 0.8))


def _laid_out(relative: frozenset[str], record: Any) -> Engine:
    """The engine of a short file's record, counting in units of itself what is in `relative`."""
    record = record.model_copy(update={"relative": tuple(sorted(relative))})
    layout = {key: getattr(record.layout, key) for key in record.layout.model_fields_set if key != "type"}
    return LAYOUTS[record.layout.type](record, **layout)


def _built(
    tree: Tree, model: type[Record], relative: frozenset[str], then: Callable[[Any], Engine] | None, *, instead: str
) -> _Draft:
    """Check a tree against its record and build the engine; with mistakes in it, add what mended copies show."""
    context = {"reader": units.reader(relative, instead=instead)}
    try:
        record = model.model_validate(tree, context=context, by_alias=True, by_name=False)
    except ValidationError as error:
        faults = faults_of(error, model, tree)
        if then is not None:
            copies = [_made(mended(tree, error, model, number=number), model, context, then) for number in _MENDINGS]
            agreed = [fault for fault in copies[0] if fault in copies[1]]
            faults += [fault for fault in agreed if not any(_overlap(fault.path, other.path) for other in faults)]
        return _Draft(None, faults)
    try:
        return _Draft(None if then is None else then(record), [])
    except EngineError as error:
        return _Draft(None, error.faults)
    except ValidationError as error:
        return _Draft(None, faults_of(error, model, tree, under=("layout",)))


_MENDINGS = (9000, 9500)
"""Numbers that no cylinder of a mistaken file has, as far as one can tell."""


def _made(tree: Tree, model: type[Record], context: dict[str, Any], then: Callable[[Any], Engine]) -> list[Fault]:
    """The faults that only the whole engine of a mended tree shows: orders, indices, numbering."""
    try:
        then(model.model_validate(tree, context=context, by_alias=True, by_name=False))
    except EngineError as error:
        return error.faults
    except ValidationError as error:
        causes = [mistake.get("ctx", {}).get("error") for mistake in error.errors(include_url=False)]
        return [fault for cause in causes if isinstance(cause, EngineError) for fault in cause.faults]
    return []


def _overlap(one: tuple[str | int, ...], other: tuple[str | int, ...]) -> bool:
    shorter = min(len(one), len(other))
    return one[:shorter] == other[:shorter]


def _problems(tree: Tree, faults: list[Fault], *, explicit: bool) -> list[Problem]:
    """Faults as lines of text, in the words of the file: what the short form says of all cylinders is said once."""
    lines: dict[str, Problem] = {}
    also: Counter[str] = Counter()
    for fault in faults:
        place = where(fault.path if explicit else _short_place(tree, fault))
        alike = place if fault.cylinder is not None and not explicit else f"{place}: {fault.message}"
        also[alike] += int(alike in lines and lines[alike].message != fault.message)
        lines.setdefault(alike, Problem(place, fault.message))
    return [Problem(path, f"{message} (and so for others)" if also[alike] else message) for alike, (path, message) in lines.items()]


def _short_place(tree: Tree, fault: Fault) -> tuple[str | int, ...]:
    """Where a short file says what a fault of the engine made from it is about."""
    if fault.path[:1] == ("shaft",) and "shaft" not in tree:
        return ("layout",)
    if fault.cylinder is None:
        return fault.path
    rest = fault.path[2:]
    for index, other in enumerate(_listed(tree.get("cylinders"))):
        if isinstance(other, dict) and other.get("number") == fault.cylinder and (not rest or rest[0] in other):
            return ("cylinders", index, *rest)
    return ("cylinder", *rest) if rest and rest[0] in Sizes.model_fields else ("layout",)
