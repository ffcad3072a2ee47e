"""What a verdict says of engines built to the tolerances of their file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files.tolerances import tolerances_of
from crankstar.tables.verdict import Fact

BUILDS = 20_000
"""Engines built at random: 5 % of them are a thousand."""


def with_built(
    facts: Sequence[Fact], tree: Mapping[str, Any], engine: Engine, *, speed: float | None
) -> Sequence[Fact]:
    """The facts of an engine with those of engines as built, where its file has tolerances."""
    if not tolerances_of(tree):
        return facts
    from crankstar.studies.fields import Source
    from crankstar.studies.scatter import ScatterError, scatter_of
    from crankstar.tables.scatter import sentences

    try:
        at = "file" if speed is None else speed
        found = scatter_of(Source(engine.name, dict(tree), engine), speed=at, count=BUILDS)
    except ScatterError:  # no force depends on what has tolerances
        return facts
    own = [Fact("tolerances", sentence) for sentence in sentences(found)]
    last = max(
        (place for place, fact in enumerate(facts) if fact.about not in ("cure", "relatives")),
        default=-1,
    )
    return [*facts[: last + 1], *own, *facts[last + 1 :]]
