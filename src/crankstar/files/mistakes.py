"""What pydantic finds wrong with an engine file, said to the person who wrote it, and a file mended of it."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from itertools import takewhile
from typing import Any

from pydantic import ValidationError

from crankstar.fault import EngineError, Fault, counted
from crankstar.files.forms import by_key, example, field_at, quantity_of, record_in
from crankstar.quantity import seen
from crankstar.records import Record

Tree = dict[str, Any]
Path = tuple[str | int, ...]

_NEEDED = {
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "int_parsing_size": "a whole number",
    "float_type": "a number",
    "finite_number": "a finite number",
    "string_type": "text",
    "string_unicode": "text of whole characters",
    "tuple_type": "a list",
    "dict_type": "a table",
    "model_type": "a table",
    "model_attributes_type": "a table",
}


def faults_of(error: ValidationError, model: type[Record], tree: Tree, *, under: Path = ()) -> list[Fault]:
    """Every mistake of a validation, as key path and sentence; `under` is where in the file that which was validated stands."""
    faults: list[Fault] = []
    for mistake in _mistakes(error):
        cause = mistake.get("ctx", {}).get("error")
        if isinstance(cause, EngineError):
            faults += cause.faults
        else:
            path = (*under, *_path(mistake))
            faults.append(Fault(path, _sentence(mistake, path, model, tree)))
    return faults


def _mistakes(error: ValidationError) -> Iterator[Any]:
    """What a validation found, but for lists that are too short only because entries in them are mistaken."""
    for mistake in error.errors(include_url=False):
        if mistake["type"] != "too_short" or len(mistake["input"]) < mistake.get("ctx", {})["min_length"]:
            yield mistake


def _path(mistake: Any) -> Path:
    return tuple(key for key in mistake["loc"] if key != "[key]")


def _sentence(mistake: Any, path: Path, model: type[Record], tree: Tree) -> str:
    """What a validation error of pydantic means, said to the one who wrote the file."""
    kind, context = mistake["type"], mistake.get("ctx", {})
    if kind == "extra_forbidden":
        return "unknown key; " + _meant(str(path[-1]), path[:-1], model)
    if kind == "value_error":
        return str(context["error"])
    if kind == "invalid_key":
        return f"has the key {seen(mistake['input'])}; keys are text of whole characters"
    value, info = seen(_at(tree, path, mistake["input"])), field_at(model, path)
    depth = sum(1 for _ in takewhile(lambda key: isinstance(key, int), reversed(path)))
    sample = example(info, depth=depth) if info else ""
    if kind == "tuple_type" and len(path) == 1 and info and record_in(info.annotation):
        return f"is {value}; a list of tables is needed, each of them headed [[{path[0]}]]"
    if kind in _NEEDED:
        return f"is {value}; {_NEEDED[kind]} is needed" + (f", such as {sample}" if sample else "")
    such = f", such as {sample}" if info and quantity_of(info) else ""
    least = context.get("min_length")
    told = {
        "missing": "is missing" + (f"; give it, as in {path[-1]} = {sample}" if sample else ""),
        "greater_than": f"is {value}; it must be greater than {_bound(context.get('gt'))}{such}",
        "greater_than_equal": f"is {value}; it must be at least {_bound(context.get('ge'))}{such}",
        "less_than_equal": f"is {value}; it must be at most {_bound(context.get('le'))}{such}",
        "literal_error": f"is {value}; it can be {context.get('expected', '')}".replace("'", '"'),
        "too_long": f"has {_size(mistake)}; at most {context.get('max_length')} are allowed",
        "too_short": f"has {_size(mistake)}; at least {least} {'is' if least == 1 else 'are'} needed",
        "string_too_long": f"has {_size(mistake, 'letter')}; at most {context.get('max_length')} are allowed",
    }
    return told.get(kind) or f"is {value}; {mistake['msg']}"


def _bound(limit: Any) -> str:
    return "" if limit is None else f"{limit:g}"


def _size(mistake: Any, of: str = "entry") -> str:
    count = len(mistake["input"]) if hasattr(mistake["input"], "__len__") else 0
    return "no entries" if count == 0 else counted(count, of).replace("entrys", "entries")


def _at(tree: Any, path: Path, otherwise: Any = None) -> Any:
    """What stands at a key path of a tree."""
    for key in path:
        if not _has(tree, key):
            return otherwise
        tree = tree[key]
    return tree


def _has(table: Any, key: Any) -> bool:
    return key in table if isinstance(table, dict) else isinstance(table, list) and isinstance(key, int) and key < len(table)


def _meant(key: str, path: Path, model: type[Record]) -> str:
    """What was probably meant by an unknown key: one spelt like it, or the same one in another table."""
    keys = _keys_at(model, path)
    near = _near(key, keys)
    if near:
        return f'did you mean "{near}"?'
    if path and key in by_key(model):
        return "it belongs at the top of the file, above the first [table]"
    tables = {name: record_in(info.annotation) for name, info in by_key(model).items()}
    home = next((name for name, table in tables.items() if table and key in by_key(table)), None)
    return f"it belongs in {home}" if home else f"there are: {', '.join(keys)}"


def _keys_at(model: type[Record], path: Path) -> list[str]:
    """The keys a table of the file may have: those of the record that stands at that place."""
    info = field_at(model, path)
    record = record_in(info.annotation) if info else model if not path else None
    return sorted(by_key(record)) if record else []


def _near(key: str, keys: list[str]) -> str | None:
    return next(iter(get_close_matches(key[:60], keys, 1, 0.6)), None)


def mended(tree: Tree, error: ValidationError, model: type[Record], *, number: int) -> Tree:
    """A copy of the tree in which slips of the pen are put right, and what else is mistaken is left out or replaced.

    What replaces it comes from `number`, so that the faults two mendings have in common do not hang on it.
    """
    out: Tree = copied(tree)
    for place, mistake in enumerate(_mistakes(error)):
        path = _path(mistake)
        table, last = _at(out, path[:-1]), path[-1] if path else None
        info = field_at(model, path)
        quantity = quantity_of(info) if info else None
        measured = quantity is not None and quantity.dimension != "rotational speed"
        if isinstance(table, dict) and (info is None or not (info.is_required() or measured)):
            value, meant = table.pop(last, None), _near(str(last), _keys_at(model, path[:-1]))
            if mistake["type"] == "extra_forbidden" and meant is not None:
                table.setdefault(meant, value)
        elif isinstance(table, dict) or _has(table, last):
            text = info is not None and info.annotation is str
            table[last] = number / 9000 if measured else f"text {number}" if text else number + place % 400
    return out


def copied(value: Any) -> Any:
    """A copy of a tree, tables and lists and all in them; a key whose value is null is left out."""
    if isinstance(value, dict):
        return {key: copied(item) for key, item in value.items() if item is not None}
    return [copied(item) for item in value] if isinstance(value, list | tuple) else value
