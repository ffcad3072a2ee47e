"""The modules that the docstring of a room lists, in order: each below those that import it.

`python tools/rooms.py` sorts the rows anew; a new module needs a row, anywhere in the table.
"""

from __future__ import annotations

import re
from graphlib import TopologicalSorter
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "src" / "crankstar"
ROW = re.compile(r"^\| `([^`]*)` \|.*\n", re.MULTILINE)


def rooms() -> list[Path]:
    """The folders of modules in the package, and in its rooms."""
    folders = [path.parent for path in sorted(PACKAGE.rglob("*/__init__.py"))]
    return [folder for folder in folders if any(folder.glob("[a-z]*.py"))]


def modules(room: Path) -> dict[str, list[Path]]:
    """The files of each module of a room, of which some are rooms themselves."""
    files = {path.stem: [path] for path in sorted(room.glob("*.py")) if path.stem != "__init__"}
    inner = {path.parent.name: [*path.parent.rglob("*.py")] for path in room.glob("*/__init__.py")}
    return files | inner


def listed(text: str) -> list[str]:
    """The modules in the order of the rows."""
    return [name.rstrip("/") for name in ROW.findall(text)]


def in_order(room: Path, names: list[str]) -> list[str]:
    """Names from bottom to top, those that may stay where they are."""
    here = ".".join(("crankstar", *room.relative_to(PACKAGE).parts))
    below = {name: imported(files, here) - {name} for name, files in modules(room).items()}
    left, order = [*names], []
    TopologicalSorter(below).prepare()  # no circle
    while left:
        lowest = next(name for name in left if not below[name] & {*left})
        left.remove(lowest)
        order.append(lowest)
    return order


def imported(files: list[Path], here: str) -> set[str]:
    """The modules of a room that these files import."""
    statement = re.compile(rf"^from {re.escape(here)}\.(\w+)", re.MULTILINE)
    return {name for path in files for name in statement.findall(path.read_text(encoding="utf-8"))}


def sorted_text(room: Path) -> str:
    """The text of a room's `__init__` with its rows in order."""
    text = (room / "__init__.py").read_text(encoding="utf-8")
    rows = {match[1].rstrip("/"): match[0] for match in ROW.finditer(text)}
    in_turn = iter(in_order(room, [*rows]))
    return ROW.sub(lambda _: rows[next(in_turn)], text)


if __name__ == "__main__":
    for room in rooms():
        (room / "__init__.py").write_text(sorted_text(room), encoding="utf-8")
