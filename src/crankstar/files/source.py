"""The text of an engine file, and the tree of keys in it, TOML or JSON, not yet checked."""

from __future__ import annotations

import json
import re
import stat
import sys
import tomllib
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files.errors import EngineFileError, refused
from crankstar.files.kinds import kind_of
from crankstar.files.mistakes import GREATEST_DEPTH, Tree
from crankstar.files.read import engine_of
from crankstar.files.read_files import STANDARD_INPUT, note
from crankstar.files.traces import TRACE, with_trace
from crankstar.files.workbook import PROTECTED, ZIP, workbook_tree
from crankstar.language.messages import _
from crankstar.language.quoting import one_line, seen

GREATEST_FILE = 1_000_000
"""Bytes: a hundred times the longest real engine file."""
_DOTTED = re.compile(r"""(?<![\w"'-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){100}""")
"""A key of TOML with so many dots that tomllib, quadratic in them, would not come to an end."""
STILL = {"angle": [f"{angle} deg" for angle in range(-360, 361, 20)], "pressure": [["1 bar"] * 37]}
"""A trace in place of one that cannot be read, so that the other mistakes of a file are found."""
_STANDARD_INPUTS = ("-", STANDARD_INPUT)


def read_file(
    path: str | Path, *, name: str | None = None, changes: Mapping[str, Any] | None = None
) -> Engine:
    """The engine of a file; "-" is standard input; mistakes name the file `name`.

    Raises EngineFileError.

    `changes` sets values by key path before anything is checked: `{"layout.bore_pitch": "100 mm"}`.
    """
    name, tree = read_tree(path, name=name)
    return engine_of(tree, name=name, changes=changes)


def read_tree(path: str | Path, *, name: str | None = None) -> tuple[str, Tree]:
    """The name by which messages call a file, and its tree of keys, not checked.

    Raises EngineFileError.
    """
    name = name or ("standard input" if str(path) in _STANDARD_INPUTS else _shown_name(path))
    raw = _content(path, name)
    if raw[:4] in (ZIP, PROTECTED) or str(path).lower().endswith(".xlsx"):
        return name, workbook_tree(raw, name)
    tree = tree_of(_text(raw, name), name=name)
    folder = Path() if str(path) in _STANDARD_INPUTS else Path(path).parent
    return name, _with_trace(tree, folder, name)


def _with_trace(tree: Tree, folder: Path, name: str) -> Tree:
    """The tree with the trace that it names. Raises EngineFileError with every mistake of both."""
    try:
        return with_trace(tree, folder, name)
    except EngineFileError as error:
        try:
            engine_of({**tree, "gas": {**tree["gas"], "trace": STILL}}, name=name)
        except EngineFileError as other:
            more = [fault for fault in other.faults if fault.path[:2] != TRACE]
            raise EngineFileError(name, [*error.faults, *more]) from None
        raise


def tree_of_keys(keys: Mapping[str, Any]) -> tuple[str, Tree]:
    """The name of an engine given as keys in Python, and its tree, with the trace that it names.

    That is read from the current folder. Raises EngineFileError.

    >>> tree_of_keys({"name": "twin"})
    ('twin', {'name': 'twin'})
    """
    name = str(keys.get("name", _("the engine")))
    return name, _with_trace(dict(keys), Path(), name)


def _shown_name(path: str | Path) -> str:
    name = str(path)
    return one_line(name if len(name) <= 200 else "..." + name[-197:])


def _content(path: str | Path, name: str) -> bytes:
    try:
        raw = _standard_input(name) if str(path) in _STANDARD_INPUTS else _bytes(Path(path), name)
    except FileNotFoundError:
        raise refused(name, "missing") from None
    except OSError as error:
        raise refused(name, "unreadable", reason=str(error.strerror or error)) from None
    if len(raw) > GREATEST_FILE:
        raise refused(name, "too-large", greatest=GREATEST_FILE // 1_000_000)
    if not raw.strip():
        raise refused(name, "empty")
    return raw


def _text(raw: bytes, name: str) -> str:
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise refused(name, "not-text")
    return text


def _standard_input(name: str) -> bytes:
    if sys.stdin is None:
        raise refused(name, "input-closed")
    return sys.stdin.buffer.read(GREATEST_FILE + 1)


def _bytes(path: Path, name: str) -> bytes:
    try:
        mode = path.stat().st_mode
    except ValueError:
        raise refused(name, "name-impossible") from None
    if stat.S_ISDIR(mode):
        raise refused(name, "directory")
    if not stat.S_ISREG(mode):
        raise refused(name, "not-regular")
    with path.open("rb") as file:
        note(file)
        return file.read(GREATEST_FILE + 1)


def tree_of(text: str, *, name: str = "the engine") -> Tree:
    """The tree of keys in TOML or JSON text (JSON starts with a brace).

    Raises EngineFileError with line and column.
    """

    def once(pairs: list[tuple[str, Any]]) -> Tree:
        tree = dict(pairs)
        if len(tree) < len(pairs):
            counts = Counter(key for key, _ in pairs)
            twice = next(key for key, count in counts.items() if count > 1)
            raise refused(name, "key-twice", key=seen(twice))
        return tree

    as_json = text.lstrip().startswith("{")
    if not as_json and _DOTTED.search(text):
        raise refused(name, "too-deep", greatest=GREATEST_DEPTH)
    try:
        return json.loads(text, object_pairs_hook=once) if as_json else tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        _no_other_json(name, text)
        if found := kind_of(text):
            raise refused(name, "other-kind", found=found) from None
        raise _not_toml(name, text, str(error)) from None
    except json.JSONDecodeError as error:
        raise refused(name, "not-json", reason=str(error)) from None
    except RecursionError:
        raise refused(name, "too-deep", greatest=GREATEST_DEPTH) from None
    except EngineFileError:
        raise
    except ValueError:
        raise refused(name, "long-number") from None


def _no_other_json(name: str, text: str) -> None:
    """Refuse JSON that is a list, a text, a number or null instead of a table."""
    try:
        json.loads(text)
    except ValueError:
        return
    except RecursionError:
        raise refused(name, "too-deep", greatest=GREATEST_DEPTH) from None
    raise refused(name, "json-no-object", example='{"format": 1, "name": "my V8"}')


def _not_toml(name: str, text: str, reason: str) -> EngineFileError:
    """The line of a file at which TOML stops making sense, and what is often meant."""
    at = re.search(r"at line (\d+)", reason)
    line = text.split("\n")[int(at.group(1)) - 1].strip() if at else ""
    bare = re.search(r"[=,\[]\s*([-+]?[\d.]+ *[A-Za-z\u00b0][A-Za-z]*)", line)
    values = {"reason": reason, "line": f": {one_line(line, longest=80)}" if line else ""}
    if bare:
        return refused(name, "not-toml-unit", example=seen(bare.group(1)), **values)
    return refused(name, f"not-toml{'-twice' if reason.startswith('Cannot') else ''}", **values)
