"""Exports that other packages add, by entry points of the group `crankstar.exports`.

An entry point names a function (engine) -> str or bytes, the content of the file; its name is that
of `crankstar export --to`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.metadata import EntryPoints

    from crankstar.engine.engine import Engine


def names() -> tuple[str, ...]:
    """The names of the exports that other packages add."""
    return tuple(sorted(_added().names))


def export_of(name: str) -> Callable[[Engine], str | bytes]:
    """The function of a name. Raises KeyError for one that none has."""
    return _added()[name].load()


@cache
def _added() -> EntryPoints:
    from importlib.metadata import entry_points

    return entry_points(group="crankstar.exports")
