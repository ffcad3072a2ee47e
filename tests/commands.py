"""What the tests of the command line share: what a command line comes to, and how it is run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple


class Ran(NamedTuple):
    """What came of a command line."""

    code: int
    out: str
    err: str


Run = Callable[..., Ran]


def replaced(
    draft: Path, target: Path, *, move: Callable[[Path, Path], Path] = Path.replace
) -> Path:
    """Path.replace, but never of a device: these tests may run as root, on code that is broken."""
    assert not Path(target).exists() or Path(target).is_file()
    return move(draft, target)
