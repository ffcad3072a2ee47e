"""The schema of engine files with labels and meanings in the reader's language, for a form."""

from __future__ import annotations

from typing import Any

from crankstar.files import schema
from crankstar.language.messages import _, language

UNSHOWN = ("a number with a unit of ", "An engine file of crankstar")
"""How meanings begin that no form shows."""


def form_schema() -> dict[str, Any]:
    """The schema of engine files; in a language other than English, `x-label` names each key.

    >>> from crankstar.language.messages import spoken
    >>> with spoken("ja"):
    ...     form_schema()["$defs"]["Bank"]["properties"]["pin_angle"]["x-label"]
    'ピン角度'
    """
    return schema() if language() == "en" else _labelled(schema())


def words_of_forms() -> list[str]:
    """Every label and meaning of a form, in English."""
    found: dict[str, None] = {}
    _collect(schema(), found)
    return list(found)


def worded(key: str) -> str:
    """A key as words.

    >>> worded("bore_pitch")
    'Bore pitch'
    """
    words = key.replace("_", " ")
    return words[:1].upper() + words[1:]


def _labelled(tree: Any) -> Any:
    if isinstance(tree, list):
        return [_labelled(item) for item in tree]
    if not isinstance(tree, dict):
        return tree
    out = {key: _labelled(value) for key, value in tree.items()}
    if _is_shown(tree.get("description")):
        out["description"] = _(_first(tree["description"]))
    if isinstance(tree.get("properties"), dict):
        named = out["properties"].items()
        out["properties"] = {key: {**node, "x-label": _(worded(key))} for key, node in named}
    return out


def _collect(tree: Any, found: dict[str, None]) -> None:
    for item in tree if isinstance(tree, list) else ():
        _collect(item, found)
    if not isinstance(tree, dict):
        return
    if _is_shown(tree.get("description")):
        found[_first(tree["description"])] = None
    properties = tree.get("properties")
    found.update(dict.fromkeys(map(worded, properties if isinstance(properties, dict) else ())))
    for value in tree.values():
        _collect(value, found)


def _is_shown(text: Any) -> bool:
    return isinstance(text, str) and not text.startswith(UNSHOWN)


def _first(text: str) -> str:
    """The first paragraph, which says enough beside a field."""
    return text.partition("\n\n")[0]
