"""The key paths of the numbers of an engine file, and why one of them cannot be varied."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from fractions import Fraction
from typing import Annotated, Any, get_args, get_origin

from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Record
from crankstar.files.forms import by_key, field_at, form_of, is_explicit, record_in, short_form
from crankstar.language.messages import _, passage
from crankstar.language.quoting import one_line

BANK_ANGLE = "layout.bank_angle"
"""What moves both banks of a V engine about the middle between them; no key of its file."""
UNMOVED = ("firing_order", "firing_angles", "valves", "speed", "format")
"""Keys that move no inertia force."""
LISTED = 24
"""Paths that are named where another one cannot be swept."""


def _leaf(annotation: Any) -> Any:
    """The bare type of a field: float for Annotated[float, ...] | None, tuple for a list."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is tuple or not parts:
        return tuple if origin is tuple else annotation
    return _leaf(
        parts[0] if origin is Annotated else next(part for part in parts if part is not type(None))
    )


def entry_at(tree: Any, keys: Sequence[str | int]) -> Any:
    """What the path leads to in a tree; an empty table where it has no such key."""
    for key in keys:
        if isinstance(key, str) and isinstance(tree, dict):
            tree = tree.get(key, {})
        elif isinstance(key, int) and isinstance(tree, list) and 0 <= key < len(tree):
            tree = tree[key]
        else:
            return None
    return tree


def has_bank_angle(tree: dict[str, Any]) -> bool:
    """Whether a file gives the bearings of two banks."""
    banks = entry_at(tree, ["layout", "banks"])
    return (
        isinstance(banks, list)
        and len(banks) == 2
        and all(isinstance(bank, dict) and "bearing" in bank for bank in banks)
    )


def is_number(tree: dict[str, Any], keys: Sequence[str | int]) -> bool:
    """Whether the path leads to a number that the tree has, or could have."""
    if list(keys) == BANK_ANGLE.split("."):
        return has_bank_angle(tree)
    info = field_at(form_of(tree), keys)
    if info is None or entry_at(tree, keys) is None:
        return False
    kind = _leaf(info.annotation)
    if kind is tuple and isinstance(keys[-1], int):
        kind = _leaf(_tuple_of(info.annotation)[0])
    return kind in (float, Fraction)


def _tuple_of(annotation: Any) -> tuple[Any, ...]:
    """The type of the entries of a list."""
    if get_origin(annotation) is tuple:
        return get_args(annotation)
    return next((entries for part in get_args(annotation) if (entries := _tuple_of(part))), ())


def _numeric(record: type[Record], tree: Any, path: str = "") -> Iterator[str]:
    """The paths of all numbers that a tree has or could have."""
    for key, info in by_key(record).items():
        here, kind, inner = f"{path}{key}", _leaf(info.annotation), record_in(info.annotation)
        value = tree.get(key) if isinstance(tree, dict) else None
        if key in UNMOVED and not path:
            continue
        if kind is tuple:
            for number, entry in enumerate(value if isinstance(value, list) else [], 1):
                if inner is not None:
                    yield from _numeric(inner, entry, f"{here}[{number}].")
                elif _leaf(_tuple_of(info.annotation)[0]) in (float, Fraction):
                    yield f"{here}[{number}]"
        elif (
            inner is not None
            and kind is not dict
            and (value is not None or info.is_required() or info.default is not None)
        ):
            yield from _numeric(inner, value, f"{here}.")
        elif kind in (float, Fraction):
            yield here


def _is_short(tree: dict[str, Any], keys: Sequence[str | int]) -> bool:
    """Whether the path is one of a short file where the tree is explicit, as that of an Engine."""
    of_layout = any(field_at(short_form(kind), keys) for kind in LAYOUTS)
    return is_explicit(tree) and (of_layout or list(keys) == BANK_ANGLE.split("."))


def why_fixed(over: str, keys: Sequence[str | int], forms: Sequence[dict[str, Any]]) -> str:
    """Why a path cannot be swept, and what can."""
    path = one_line(over, longest=80)
    if keys[0] in UNMOVED:
        return _(
            "{path} has no effect on the inertia forces, so it cannot be swept; give the path of "
            "another number",
            path=path,
        )
    paths = {
        path: None for form in forms for path in ("balance_factor", *_numeric(form_of(form), form))
    }
    if has_bank_angle(forms[0]):
        paths |= {BANK_ANGLE: None}
    own = [
        path
        for path in paths
        if not re.search(r"\[(?!1\])", path) and not path.startswith("provenance")
    ]
    more = _(" and more") if len(own) > LISTED else ""
    meant = f"{over[:100]}{'.angle' if isinstance(keys[-1], int) else ''}"
    values = {
        "path": path,
        "near": ", ".join(get_close_matches(meant, paths, 3, 0.5)),
        "numbers": ", ".join(own[:LISTED]) + more,
    }
    there = any(field_at(form_of(form), keys) for form in forms)
    fault = (
        _("{path} is not the path of a single number.", **values)
        if there
        else _("{path} is not a field of the engine.", **values)
    )
    near = _("Did you mean {near}?", **values) if values["near"] else ""
    if not there and _is_short(forms[0], keys):
        near = _(
            "It is a key of short files, and this engine is given part by part: an Engine does not "
            'know its file. Give the name or the path of the file, as in sweep("i4.toml", ...), or '
            "vary one part."
        )
    can = _("The numbers that can be swept are {numbers}.", **values)
    return passage((fault, near, can))
