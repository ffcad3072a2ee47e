"""The catalog: real and textbook engines as TOML, one file each, each number with its source."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, engine_of, read_tree
from crankstar.language.faults import Fault
from crankstar.language.quoting import one_line

_FOLDER = Path(__file__).parent
SUMMARIES = _FOLDER / "summaries.tsv"
"""The summaries of all engines; `tools/catalog_lists.py` writes it."""
MOST_NAMED = 5
"""Names that are proposed in place of a part of one."""


@cache
def names() -> tuple[str, ...]:
    """The names of all engines in the catalog, in alphabetical order.

    >>> "v8-flat-plane" in names()
    True
    """
    return tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))


def path_of(name: str) -> Path | None:
    """The file of a catalog engine, or None if there is none of that name."""
    return _FOLDER / f"{name}.toml" if name in names() else None


def load(name: str | Path, *, changes: Mapping[str, Any] | None = None) -> Engine:
    """An engine from the catalog by its name, or from a file by its path ("-": standard input).

    A catalog name comes first; say ./NAME for a file that is called the same. `changes` sets values
    by key path. Raises EngineFileError.

    >>> load("i4", changes={"cylinder.stroke": "90 mm"}).first.number
    1
    """
    shown, tree = tree_of(name)
    return engine_of(tree, name=shown, changes=changes)


def tree_of(name: str | Path) -> tuple[str, dict[str, Any]]:
    """The name by which messages call an engine, and the tree of keys of its file, not checked.

    Raises EngineFileError.
    """
    own = path_of(str(name))
    if own is None and not _looks_like_a_file(name):
        raise not_in_catalog(str(name))
    return read_tree(own or name, name=str(name) if own else None)


def not_in_catalog(typed: str) -> EngineFileError:
    """The error of a name that is neither an engine of the catalog nor a file."""
    code = "file.not-in-catalog-near" if _near(typed) else "file.not-in-catalog"
    return EngineFileError(one_line(typed, longest=100), [Fault((), code, {"near": _near(typed)})])


def unknown_name(typed: str, *, path: tuple[str | int, ...] = ()) -> Fault:
    """The fault of a name that no engine of the catalog has, with those that are like it."""
    near = _near(typed)
    return Fault(path, f"catalog.unknown{'-near' if near else ''}", {"near": near})


def _near(typed: str) -> list[str]:
    """Names that begin with the typed text, then those that contain it, else similar ones."""
    part = typed.strip().lower()
    if part:
        alike = sorted(
            (name for name in names() if part in name), key=lambda name: not name.startswith(part)
        )
        if alike:
            return alike[:MOST_NAMED]
    return get_close_matches(typed, names(), 3)


def _looks_like_a_file(name: str | Path) -> bool:
    text = str(name)
    if (
        isinstance(name, Path)
        or text == "-"
        or "/" in text
        or "\\" in text
        or text.lower().endswith((".toml", ".json", ".xlsx"))
    ):
        return True
    try:
        return bool(text) and Path(text).exists()
    except (OSError, ValueError):
        return False


class Summary(NamedTuple):
    """What a list of engines says of one."""

    name: str
    title: str
    layout: str
    cylinders: int
    cycle: str


@cache
def summaries() -> tuple[Summary, ...]:
    """A summary of every engine in the catalog, without reading their files.

    >>> next(entry.cylinders for entry in summaries() if entry.name == "napier-deltic")
    18
    """
    lines = SUMMARIES.read_text(encoding="utf-8").splitlines()
    rows = (line.split("\t") for line in lines)
    return tuple(
        Summary(name, title, layout, int(cylinders), cycle)
        for name, title, layout, cylinders, cycle in rows
    )


def summary(name: str) -> Summary:
    """The summary of an engine of the catalog, from its file."""
    tree = tomllib.loads((_FOLDER / f"{name}.toml").read_text(encoding="utf-8"))
    layout = tree.get("layout", {}).get("type", "explicit")
    order = tree.get("firing_order", ())
    count = len(order) or len(load(name).chambers)
    return Summary(name, tree["name"], layout, count, tree.get("cycle", "four-stroke"))
