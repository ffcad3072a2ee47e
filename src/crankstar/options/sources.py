"""Engines as people name them: what they mean, with the tree of their file and its ranges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.files import EngineFileError, changed, engine_of, explicit
from crankstar.files.box import Spread, spread
from crankstar.files.catalog import tree_of
from crankstar.files.chains import chain_of, is_chain
from crankstar.files.changes import turning, with_traces
from crankstar.files.source import tree_of_keys
from crankstar.language.faults import Fault
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given, one_line

EngineLike = Engine | Chain | str | Path | Mapping[str, Any]
"""An engine: itself, its name in the catalog, the path of its file, or the keys of one."""


@dataclass(frozen=True)
class Loaded:
    """An engine or a drive line: how messages call it, the tree of its file, what it is.

    `spread` has the engines over the ranges of its estimated values; `filled` tells whether
    something was estimated that the file leaves out.
    """

    name: str
    tree: dict[str, Any]
    source: Engine | Chain
    spread: Spread | None = None
    filled: bool = False

    @property
    def engine(self) -> Engine:
        """The engine. Raises EngineFileError where it is a drive line."""
        if isinstance(self.source, Chain):
            raise EngineFileError(self.name, [Fault((), "form.drive-line")])
        return self.source

    @property
    def balance_factor(self) -> float | None:
        """That of the file; None without one."""
        factor = self.tree.get("balance_factor")
        return float(factor) if isinstance(factor, int | float) else None

    def of(self, source: Engine | Chain) -> Loaded:
        """The same file, of another engine: one of those over its ranges."""
        return replace(self, source=source)


def loaded(
    engine: EngineLike,
    changes: Mapping[str, Any] | None = None,
    *,
    estimate: bool = False,
    speed: object = None,
    chains: bool = True,
    ranged: bool = True,
    asking: str = "crankstar",
) -> Loaded:
    """What is named, with `changes` by key path; `estimate` fills in what its file leaves out.

    Not the speed where a `speed` is asked for, however it is given.

    Without `chains` a drive line is refused as an engine; without `ranged` there is no spread.
    Raises EngineFileError, and TypeError for what names no engine, which `asking` was given.

    >>> loaded("i4", {"cylinder.stroke": "90 mm"}).source.first.number
    1
    """
    if isinstance(engine, Chain):
        return Loaded(engine.name, {}, engine)
    if isinstance(engine, Engine) and not changes and not estimate:
        return Loaded(engine.name, explicit(engine), engine)
    short = [path for path in changes or () if path.partition(".")[0] in ("cylinder", "layout")]
    if isinstance(engine, Engine) and short:
        raise MessageError(
            _(
                "{path} is a key of a short engine file, which an Engine no longer knows; change "
                "its parts by number, as in {example}, or give the file or its name",
                path=one_line(short[0]),
                example="cylinders[1].bore",
            )
        )
    shown, tree = _tree(engine, asking)
    values = with_traces(changes or {}, "changes")
    if chains and is_chain(tree):
        tree = changed(tree, values, name=shown) if values else tree
        return Loaded(shown, tree, chain_of(tree, name=shown))
    turned = {path: values.pop(path) for path in turning(values)}
    tree = changed(tree, values, name=shown)
    filled = False
    if estimate:
        from crankstar.files.estimate import estimated

        completed = estimated(tree, name=shown, speed=speed)
        tree, filled = completed.tree, bool(completed.filled)
    ends = spread(tree, name=shown, changes=turned) if ranged else None
    own = engine_of(tree, name=shown, changes=turned) if ends is None else ends.engine
    tree = changed(tree, turned, name=shown) if turned else tree
    return Loaded(shown, tree, own, ends, filled)


def engine_named(engine: EngineLike, asking: str) -> Engine:
    """The Engine that is named. Raises EngineFileError, TypeError for what names none."""
    if isinstance(engine, Engine):
        return engine
    source = loaded(engine, asking=asking).source
    if isinstance(source, Engine):
        return source
    raise TypeError(
        _("{function} takes an engine, not a drive line without cylinders", function=asking)
    )


def _tree(engine: EngineLike, asking: str) -> tuple[str, dict[str, Any]]:
    if isinstance(engine, Engine):
        return engine.name, explicit(engine)
    if isinstance(engine, Mapping) and all(isinstance(key, str) for key in engine):
        return tree_of_keys(engine)
    if isinstance(engine, str | Path):
        return tree_of(engine)
    odd = (
        next((key for key in engine if not isinstance(key, str)), None)
        if isinstance(engine, Mapping)
        else None
    )
    raise TypeError(
        _(
            "{function} takes an Engine, a name of the catalog, a path or a dict of keys, not "
            "{given}",
            function=asking,
            given=given(engine) if odd is None else _("one with the key {key}", key=given(odd)),
        )
    )
