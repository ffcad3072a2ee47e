"""Values of an engine file set by key path, in the notation of the messages.

A throw whose angle is set takes its weights along.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from crankstar.engine.copies import throws_of_weights, with_values, wrapped
from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.engine.records import Shaft
from crankstar.files.errors import EngineFileError, refused
from crankstar.files.mistakes import GREATEST_DEPTH, SpreadsheetTree, Tree, copied
from crankstar.files.references import with_references
from crankstar.files.traces import with_trace
from crankstar.language.faults import Fault, where
from crankstar.language.quoting import one_line, seen

GREATEST_VALUES = 20_000


def bounded(tree: Any, name: str) -> Tree:
    """The tree itself, once it is found to be a table, and no larger than an engine can need."""
    if not isinstance(tree, dict):
        raise refused(name, "not-a-table", value=seen(tree))
    level: list[tuple[tuple[str | int, ...], Any]] = [((), tree)]
    count = 0
    for _ in range(GREATEST_DEPTH):
        level = [(path, value) for path, value in level if isinstance(value, dict | list)]
        count += sum(len(value) for _, value in level)
        if count > GREATEST_VALUES:
            path, widest = max(level, key=lambda item: len(item[1]))
            values = {"size": len(widest), "greatest": GREATEST_VALUES}
            raise EngineFileError(name, [Fault(path, "file.too-many-values", values)])
        if not level:
            return tree
        level = [
            ((*path, key), item)
            for path, value in level
            for key, item in (value.items() if isinstance(value, dict) else enumerate(value))
        ]
    raise refused(name, "too-deep", greatest=GREATEST_DEPTH)


def changed(tree: Tree, changes: Mapping[str, Any], *, name: str = "the engine") -> Tree:
    """A tree with values set by key path: `layout.banks[1].bearing`, counted from one.

    Bare numbers go on counting in what they counted in: see `references`.

    Raises EngineFileError where a path leads nowhere, or where there is more than an engine can
    need.
    """
    out = copied(bounded(tree, name))
    for path, value in changes.items():
        keys = keys_of(path)
        table: Any = out
        for index, key in enumerate(keys):
            if not _can_hold(table, key):
                raise EngineFileError(name, [_unsettable(keys, index, table)])
            if index == len(keys) - 1:
                table[key] = copied(value)  # a later path may lead into it
            else:
                table = table[key] if isinstance(key, int) else table.setdefault(key, {})
    overruled = [keys_of(path) for path in changes if overruling(out, keys_of(path))]
    if overruled:
        raise EngineFileError(
            name,
            [
                Fault(tuple(keys), "set.at-points", {"paths": ", ".join(overruling(out, keys))})
                for keys in overruled
            ],
        )
    if changes:
        with_references(tree, out, [tuple(keys_of(path)) for path in changes])
    out = bounded(_without_estimates(out, changes), name)
    return tree.without(map(keys_of, changes), out) if isinstance(tree, SpreadsheetTree) else out


def with_traces(changes: Mapping[str, Any], name: str) -> dict[str, Any]:
    """The changes with the trace that they name read from the current folder.

    For who may read files. `name` is how messages call what gives the changes. Raises
    EngineFileError.

    >>> with_traces({"gas": {"trace": {"angle": ["0 deg"]}}}, "--set")  # no file is named
    {'gas': {'trace': {'angle': ['0 deg']}}}
    """
    out = dict(changes)
    for path, value in changes.items():
        match keys_of(path):
            case ["gas"]:
                out[path] = with_trace({"gas": value}, Path(), name)["gas"]
            case ["gas", "trace"]:
                out[path] = with_trace({"gas": {"trace": value}}, Path(), name)["gas"]["trace"]
    return out


def overruling(tree: Tree, keys: Sequence[str | int]) -> list[str]:
    """The paths of the operating points' own values where none is left that a value of [gas] is of.

    >>> gas = {"imep": 1e6, "gamma": 1.3, "point": [{"name": "idle", "speed": 80, "gamma": 1.35}]}
    >>> overruling({"gas": gas}, ["gas", "gamma"])  # of the load of the table itself
    []
    >>> overruling({"gas": {**gas, "imep": None}}, ["gas", "gamma"])
    ['gas.point[1].gamma']
    """
    gas: Any = tree.get("gas")
    points = gas.get("point") if isinstance(gas, dict) else None
    if len(keys) != 2 or keys[0] != "gas" or not isinstance(points, list) or not points:
        return []
    name = str(keys[1])
    if any(gas.get(load) is not None for load in LOADS):
        return []
    if not all(isinstance(each, dict) and each.get(name) is not None for each in (gas, *points)):
        return []
    return [f"gas.point[{number}].{name}" for number, _point in enumerate(points, 1)]


def _without_estimates(tree: Tree, changes: Mapping[str, Any]) -> Tree:
    """The tree without the source of what was estimated before it was set.

    What has moved with such a value keeps the range of its own.
    """
    sources = tree.get("provenance")
    if not isinstance(sources, dict):
        return tree
    was_set = [keys_of(path) for path in changes]
    kept = {
        path: source
        for path, source in sources.items()
        if not (
            isinstance(source, dict)
            and source.get("status") == "estimated"
            and keys_of(path) in was_set
        )
    }
    gone = [path for path in sources if path not in kept]
    for path, source in kept.items():
        other = source.get("moves_with") if isinstance(source, dict) else None
        if isinstance(other, str) and other in gone:
            kept[path] = {key: value for key, value in source.items() if key != "moves_with"}
    return {**tree, "provenance": kept} if gone else tree


_QUOTED = r"""(?:"(?:[^"\\]|\\.)*"|'[^']*')"""
_KEY = rf"""(?:{_QUOTED}|[^.\[\]"'][^.\[\]]*)"""
_PATH = re.compile(rf"{_KEY}(?:\.{_KEY}|\[[0-9]{{1,6}}\])*")
_STEP = re.compile(rf"\[([0-9]+)\]|({_KEY})")
_SETTING = re.compile(rf"""((?:{_QUOTED}|[^="'])*)(=)(.*)""", re.DOTALL)


def keys_of(path: str) -> list[str | int]:
    """The keys of a path: names, quoted as in TOML or bare, and places in lists from nought.

    >>> keys_of("shaft[1].throw[2].z"), keys_of('provenance."cylinder.bore".range')
    (['shaft', 0, 'throw', 1, 'z'], ['provenance', 'cylinder.bore', 'range'])
    """
    if not _PATH.fullmatch(path):
        return [path]
    try:
        return [int(at) - 1 if at else _unquoted(key) for at, key in _STEP.findall(path)]
    except tomllib.TOMLDecodeError:
        return [path]


def _unquoted(key: str) -> str:
    return next(iter(tomllib.loads(f"{key}=0"))) if key[0] in "\"'" else key


def path_and_value(text: str) -> tuple[str, str, str]:
    """The key path of `KEY=VALUE`, the sign, the value; sign and value are empty without a sign.

    >>> path_and_value('provenance."a=b".note=c=d')
    ('provenance."a=b".note', '=', 'c=d')
    """
    found = _SETTING.fullmatch(text)
    path, sign, value = text.partition("=") if found is None else found.groups()
    return path.strip(), sign, value


def stale_sources(tree: Tree) -> list[str]:
    """The paths of sources whose entry the file has not, as when an entry of a list was deleted.

    >>> stale_sources({"throw": [{}], "provenance": {"throw[1].z": {}, "throw[2].z": {}}})
    ['throw[2].z']
    """
    sources = tree.get("provenance")
    return [name for name in sources or () if _is_stale(tree, keys_of(name))]


def _is_stale(tree: Tree, keys: list[str | int]) -> bool:
    place: Any = tree
    for key in keys:
        if isinstance(key, int):
            if not isinstance(place, list) or not 0 <= key < len(place):
                return isinstance(place, list)
            place = place[key]
        elif isinstance(place, dict) and key in place:
            place = place[key]
        else:
            return False
    return False


def _can_hold(table: Any, key: str | int) -> bool:
    return (
        isinstance(table, dict)
        if isinstance(key, str)
        else isinstance(table, list) and 0 <= key < len(table)
    )


def _unsettable(keys: list[str | int], index: int, table: Any) -> Fault:
    values: dict[str, Any] = {"whole": one_line(where(tuple(keys[:index])), longest=60)}
    if isinstance(table, list):
        return Fault(tuple(keys), "set.in-list", values | {"size": len(table)})
    code = "set.not-a-list" if isinstance(table, dict) else "set.not-a-table"
    return Fault(tuple(keys), code, values)


def throw_angles(changes: Mapping[str, Any]) -> list[str]:
    """The paths among the changes that turn a throw."""
    return [path for path in changes if _turns_throw(keys_of(path))]


def turning(changes: Mapping[str, Any]) -> list[str]:
    """The same, and with them the paths that turn a weight, which then stays where it is set."""
    turned = throw_angles(changes)
    return [*turned, *filter(_turns_weight, changes)] if turned else []


def _turns_weight(path: str) -> bool:
    match keys_of(path):
        case ["shaft", int(), "weight", int(), "angle"]:
            return True
    return False


def _turns_throw(keys: Sequence[str | int]) -> bool:
    match keys:
        case ["shaft", int(), "throw", int(), "angle"]:
            return True
    return False


def with_weights_along(before: Engine, after: Engine, changes: Mapping[str, Any]) -> Engine:
    """The engine after the changes, its weights turned as far as their throws were.

    Weights whose own angle is among the changes stay as these say.
    """
    was_set = [keys_of(path) for path in changes]
    shafts: list[Shaft] = []
    for index, (old, new) in enumerate(zip(before.shafts, after.shafts, strict=True)):
        turned = [b.angle - a.angle for a, b in zip(old.throws, new.throws, strict=True)]
        weights = [
            weight
            if home is None or ["shaft", index, "weight", number, "angle"] in was_set
            else with_values(weight, angle=wrapped(weight.angle + turned[home - 1]))
            for number, (weight, home) in enumerate(
                zip(new.weights, throws_of_weights(new), strict=True)
            )
        ]
        shafts.append(with_values(new, weights=tuple(weights)))
    return with_values(after, shafts=tuple(shafts))
