"""What pydantic finds wrong with an engine file, said to the person who wrote it, and a file mended of it."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from pydantic import ValidationError

from crankstar.engine import EngineError, Fault, Record
from crankstar.files.forms import by_key, field_at, quantity_of, record_in

Tree = dict[str, Any]


def faults_of(error: ValidationError, model: type[Record]) -> list[Fault]:
    """Every mistake of a validation, as key path and sentence."""
    faults: list[Fault] = []
    for mistake in error.errors():
        cause = mistake.get("ctx", {}).get("error")
        if isinstance(cause, EngineError):
            faults += cause.faults
        else:
            faults.append(Fault(_path(mistake), _sentence(mistake, _path(mistake), model)))
    return faults


def _path(mistake: Any) -> tuple[str | int, ...]:
    return tuple(mistake["loc"])


def _sentence(mistake: Any, path: tuple[str | int, ...], model: type[Record]) -> str:
    """What a validation error of pydantic means, said to the one who wrote the file."""
    kind, seen, context = mistake["type"], mistake["input"], mistake.get("ctx", {})
    if kind == "extra_forbidden":
        return "unknown key" + _alternatives(str(path[-1]), _keys_at(model, path[:-1]))
    if kind == "value_error":
        return str(context["error"])
    need = {
        "missing": "is missing" + _example(model, path),
        "greater_than": f"is {seen_as(seen)}; it must be greater than {context.get('gt'):g}" if "gt" in context else "",
        "greater_than_equal": f"is {seen_as(seen)}; it must be at least {context.get('ge'):g}" if "ge" in context else "",
        "less_than_equal": f"is {seen_as(seen)}; it must be at most {context.get('le'):g}" if "le" in context else "",
        "finite_number": f"is {seen_as(seen)}; a finite number is needed",
        "literal_error": f"is {seen_as(seen)}; it can be {context.get('expected', '')}".replace("'", '"'),
        "too_long": f"has {context.get('actual_length')} entries; at most {context.get('max_length')} are allowed",
        "too_short": f"has {context.get('actual_length')} entries; at least {context.get('min_length')} are needed",
        "string_too_long": f"is longer than {context.get('max_length')} letters",
        "int_type": f"is {seen_as(seen)}; a whole number is needed",
        "int_from_float": f"is {seen_as(seen)}; a whole number is needed",
        "float_type": f"is {seen_as(seen)}; a number is needed",
        "string_type": f"is {seen_as(seen)}; text is needed",
        "tuple_type": f"is {seen_as(seen)}; a list is needed",
        "dict_type": f"is {seen_as(seen)}; a table is needed",
        "model_type": f"is {seen_as(seen)}; a table is needed",
        "model_attributes_type": f"is {seen_as(seen)}; a table is needed",
    }
    return need.get(kind) or f"is {seen_as(seen)}; {mistake['msg']}"


def seen_as(value: Any) -> str:
    """A value of a file as it can be quoted: short, on one line, printable."""
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list | tuple):
        return "a list"
    if isinstance(value, bool):
        return "true" if value else "false"
    text = f'"{value}"' if isinstance(value, str) else f"{value}"
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    return text if len(text) <= 60 else text[:57] + "..."


def _alternatives(key: str, keys: list[str]) -> str:
    near = get_close_matches(key, keys, 1, 0.6)
    return f'; did you mean "{near[0]}"?' if near else f"; there are: {', '.join(sorted(keys))}"


def _keys_at(model: type[Record], path: tuple[str | int, ...]) -> list[str]:
    """The keys a table of the file may have: those of the record that stands at that place."""
    info = field_at(model, path)
    record = record_in(info.annotation) if info else model if not path else None
    return list(by_key(record)) if record else []


def _example(model: type[Record], path: tuple[str | int, ...]) -> str:
    info = field_at(model, path)
    quantity = quantity_of(info) if info else None
    return f'; give it, as in {path[-1]} = "{quantity.example}"' if quantity else ""


def mended(tree: Tree, error: ValidationError, model: type[Record]) -> Tree:
    """A copy of the tree in which what was mistaken is left out, or replaced where something must stand."""
    out: Tree = _copied(tree)
    for mistake in error.errors():
        path = _path(mistake)
        table: Any = out
        for key in path[:-1]:
            table = table[key] if _has(table, key) else None
        info = field_at(model, path)
        quantity = quantity_of(info) if info else None
        last = path[-1] if path else None
        if isinstance(table, dict) and (info is None or not info.is_required()):
            table.pop(last, None)
        elif isinstance(table, dict) or _has(table, last):
            table[last] = 1.0 if quantity else "text" if info is not None and info.annotation is str else 1
    return out


def _has(table: Any, key: Any) -> bool:
    return key in table if isinstance(table, dict) else isinstance(table, list) and isinstance(key, int) and key < len(table)


def _copied(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _copied(item) for key, item in value.items()}
    return [_copied(item) for item in value] if isinstance(value, list) else value
