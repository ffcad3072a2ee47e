"""What the tests of the command line share: what a command line comes to, and how it is run."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple


class Ran(NamedTuple):
    """What came of a command line."""

    code: int
    out: str
    err: str


Run = Callable[..., Ran]


def csv_rows(text: str, table: str) -> list[dict[str, str]]:
    """The rows of one of several tables in CSV, with the columns that are filled in it."""
    rows = [row for row in csv.DictReader(io.StringIO(text)) if row["table"] == table]
    own = [name for name in (rows[0] if rows else ()) if any(row[name] for row in rows)]
    return [{name: row[name] for name in own if name != "table"} for row in rows]


def replaced(
    draft: Path, target: Path, *, move: Callable[[Path, Path], Path] = Path.replace
) -> Path:
    """Path.replace, but never of a device: these tests may run as root, on code that is broken."""
    assert not Path(target).exists() or Path(target).is_file()
    return move(draft, target)
