"""Engines built to the tolerances of their file: their scatter."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from crankstar.engine.engine import Engine
from crankstar.files.tolerances import tolerances_of

if TYPE_CHECKING:
    from crankstar.analyses.tolerance.scatter import Scatter

BUILDS = 20_000
"""Engines built at random: 5 % of them are a thousand."""


def as_built(
    engine: Engine, tree: Mapping[str, Any], *, speed: float | None = None
) -> Scatter | None:
    """The scatter of an engine by the tree of its file; None without tolerances of note.

    At `speed` (rad/s), else at that of the file. The same one again is not worked out again.

    >>> from crankstar.files import engine_of
    >>> from crankstar.files.catalog import load, tree_of
    >>> as_built(load("i4"), tree_of("i4")[1]) is None
    True
    """
    if not tolerances_of(tree):
        return None
    return _built(engine, json.dumps(tree, default=str), speed)


@lru_cache(maxsize=8)
def _built(engine: Engine, text: str, speed: float | None) -> Scatter | None:
    from crankstar.analyses.tolerance.scatter import ScatterError, scatter_of
    from crankstar.studies.fields import Source

    at = "file" if speed is None else speed
    try:
        return scatter_of(Source(engine.name, json.loads(text), engine), speed=at, count=BUILDS)
    except ScatterError:  # no force depends on what has tolerances
        return None
