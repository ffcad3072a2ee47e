"""Engines written: the explicit form as TOML with units, and the JSON Schema of both forms."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import tomli_w
from pydantic import TypeAdapter

from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Record
from crankstar.files import bare_numbers, units
from crankstar.files.changes import keys_of
from crankstar.files.forms import field_at, quantity_of, short_form

DESCRIPTION = (
    "An engine file of crankstar: the short form, by layout, or the explicit form with shafts "
    "and cylinders."
)
SCHEMA_DIALECT = "https://json-schema.org/draft/2020-12/schema"


def explicit(engine: Engine) -> dict[str, Any]:
    """The tree of an engine in the explicit form, quantities as text with units.

    What is not set is left out.
    """
    return written(engine, frozenset(engine.relative))


def part_by_part(engine: Engine) -> dict[str, Any]:
    """The explicit form without the sources of keys that it does not have.

    Such as those of the layout it was made from; those of estimates stay, which mark results.

    Unlike `explicit` and `toml`, which give back the same engine with every source, this is a tree
    to go on working with.
    """
    tree = explicit(engine)
    sources = tree.pop("provenance", {})
    kept = {
        path: source
        for path, source in sources.items()
        if source.get("status") == "estimated" or _is_there(tree, keys_of(path))
    }
    return {**tree, "provenance": kept} if kept else tree


def _is_there(tree: Any, path: Sequence[str | int]) -> bool:
    """Whether the tree has that key.

    One that is left out because it has the default value counts as there.

    A list whose place is not given, as in `shaft.throw.radius`, stands for all that is in it.
    """
    return field_at(Engine, path) is not None and _leads_on(tree, path)


def _leads_on(tree: Any, path: Sequence[str | int]) -> bool:
    if not path:
        return True
    key, *rest = path
    if isinstance(key, int):
        return isinstance(tree, list) and 0 <= key < len(tree) and _leads_on(tree[key], rest)
    if isinstance(tree, list):
        return any(_leads_on(item, path) for item in tree)
    return isinstance(tree, dict) and (_leads_on(tree[key], rest) if key in tree else not rest)


def toml(engine: Engine) -> str:
    """An engine as a TOML file in the explicit form; reading it gives the same engine."""
    return tree_text(explicit(engine))


def tree_text(tree: dict[str, Any]) -> str:
    """A tree of keys as TOML, short lists on one line.

    Raises TypeError or ValueError for what TOML has no words for.
    """
    text = tomli_w.dumps(tree)
    for inner in (8, 4):  # short lists in lists first
        text = re.sub(
            rf"\[\n((?: {{{inner}}}\S[^\n]{{0,29}},\n)+) {{{inner - 4}}}\]", _on_one_line, text
        )
    return text


def _on_one_line(match: re.Match[str]) -> str:
    items = [line.strip() for line in match.group(1).splitlines()]
    return "[" + " ".join(items).rstrip(",") + "]"


def written(record: Record, relative: frozenset[str]) -> dict[str, Any]:
    """The tree of a record, quantities as text with units but those `relative` to what is unknown.

    What has its default value is left out.
    """
    out: dict[str, Any] = {}
    for name, info in type(record).model_fields.items():
        value = getattr(record, name)
        if name != "format" and not info.is_required() and value == info.default:
            continue
        out[str(info.validation_alias or name)] = _written(value, quantity_of(info), relative)
    return out


def _written(value: Any, quantity: Any, relative: frozenset[str]) -> Any:
    if isinstance(value, Record):
        return written(value, relative)
    if isinstance(value, tuple):
        return [_written(item, quantity, relative) for item in value]
    if isinstance(value, dict):
        return {key: _written(item, None, relative) for key, item in value.items()}
    if quantity is not None:
        missing = quantity.relative_to & relative
        known = bare_numbers.remaining(quantity, missing) if missing else quantity
        if known is not None:
            return units.text(value, known)
    if isinstance(value, float):
        return float(f"{value:.15g}")
    return value if isinstance(value, int | str) else str(value)


def schema() -> dict[str, Any]:
    """The JSON Schema of engine files, short or explicit, with unit and meaning of every key."""
    models = [Engine, *(short_form(kind) for kind in LAYOUTS)]
    whole = TypeAdapter(_union(models)).json_schema(by_alias=True)
    return {
        "$schema": SCHEMA_DIALECT,
        "title": "crankstar engine file",
        "description": DESCRIPTION,
        **_without_examples(whole),
    }


def _without_examples(tree: Any) -> Any:
    """A schema whose descriptions end before the examples in Python."""
    if isinstance(tree, dict):
        return {
            key: value.partition("\n\n>>>")[0]
            if key == "description" and isinstance(value, str)
            else _without_examples(value)
            for key, value in tree.items()
        }
    return [_without_examples(item) for item in tree] if isinstance(tree, list) else tree


def _union(models: list[type[Record]]) -> Any:
    union: Any = models[0]
    for model in models[1:]:
        union = union | model
    return union
