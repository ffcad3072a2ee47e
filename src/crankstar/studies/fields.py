"""Numbers of an engine file by key path, and the engine as a function of some of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from functools import reduce
from typing import Annotated, Any, NamedTuple, get_args, get_origin

from crankstar import files
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Quantity
from crankstar.engine.records import Record
from crankstar.files import EngineFileError
from crankstar.files.catalog import tree_of
from crankstar.files.forms import by_key, field_at, form_of, quantity_of, record_in
from crankstar.language.messages import _
from crankstar.language.quoting import one_line, seen
from crankstar.remedy import with_counterweights
from crankstar.studies.variants import SweepError

LISTED = 24
"""Paths that are named where another one cannot be swept."""
_UNMOVED = ("firing_order", "firing_angles", "valves", "speed", "format")


class Subject(NamedTuple):
    """A varied engine: as its file has it, as a function of the values, and their quantities."""

    base: Engine | None
    make: Callable[..., Engine]
    quantities: tuple[Quantity | None, ...]


class Varied(NamedTuple):
    """The key path of a number that is varied, and the unit of its values, None for SI."""

    path: str
    unit: str | None = None


def subject(
    name: str | Engine, over: Sequence[Varied], *, changes: Mapping[str, Any] | None = None
) -> Subject:
    """The engine `name` (catalog, file or "-") as a function of the numbers at these key paths.

    A path is one of the short form or of the explicit form, or `balance_factor`; without any the
    engine is as its file has it. `changes` sets other values first. Raises SweepError where there
    is no such number, EngineFileError.

    >>> twin = subject("harley-45", [Varied("layout.banks[1].bearing", "deg")])
    >>> round(twin.make(45).cylinders[0].bearing, 6), twin.quantities[0].dimension
    (0.785398, 'angle')
    """
    own = isinstance(name, Engine)
    shown, tree = (name.name, files.explicit(name)) if own else tree_of(name)
    tree = files.changed(tree, changes or {}, name=shown)
    _check_order(shown, tree)
    base = _base(shown, tree)
    if not over and own and not changes:
        return Subject(name, lambda: name, ())
    if not over:
        return Subject(base, lambda: files.engine_of(tree, name=shown), ())
    forms = [tree] if base is None else [tree, _explicit(base)]
    stages = _stages(shown, over, forms, base)
    quantities = tuple(
        None if form is None else _quantity(form, varied)
        for varied, form in zip(over, stages, strict=True)
    )

    def make(*numbers: float) -> Engine:
        given = list(zip(over, numbers, strict=True))
        title = f"{shown} with {', '.join(_value_text(varied, number) for varied, number in given)}"
        engine = base
        for place, form in enumerate(forms):
            changed = {
                varied.path: f"{number!r} {varied.unit}" if varied.unit else number
                for (varied, number), own in zip(given, stages, strict=True)
                if own is form
            }
            if changed:
                under = _explicit(engine) if place and engine is not base and engine else form
                engine = files.engine_of(under, name=title, changes=changed)
        factors = (n for n, form in zip(numbers, stages, strict=True) if form is None)
        engine = engine or files.engine_of(tree, name=title)
        return reduce(lambda e, n: with_counterweights(e, factor=n, bare=True), factors, engine)

    return Subject(base, make, quantities)


def _value_text(varied: Varied, number: float) -> str:
    unit = f" {one_line(varied.unit, longest=20)}" if varied.unit else ""
    return f"{one_line(varied.path)} = {number:.9g}{unit}"


def _explicit(engine: Engine) -> dict[str, Any]:
    return files.explicit(with_values(engine, firing_order=(), firing_angles=None))


def _stages(
    shown: str, over: Sequence[Varied], forms: Sequence[dict[str, Any]], base: Engine | None
) -> list[dict[str, Any] | None]:
    """The form in which each path is a number, one for all if there is; None: a balance factor."""
    keys = [files.keys_of(varied.path) for varied in over]
    for form in forms:
        if all(_is_number(form, own) and own[0] not in _UNMOVED for own in keys):
            return [form] * len(over)
    out: list[dict[str, Any] | None] = []
    for varied, own in zip(over, keys, strict=True):
        form = next((form for form in forms if _is_number(form, own)), None)
        if form is None and varied.path == "balance_factor" and base is not None:
            if varied.unit:
                raise _plain_number(varied)
        elif form is None or own[0] in _UNMOVED:
            raise SweepError(f"{shown}: {_why_fixed(varied.path, own, forms)}")
        out.append(form)
    return out


def _quantity(form: dict[str, Any], varied: Varied) -> Quantity | None:
    info = field_at(form_of(form), files.keys_of(varied.path))
    quantity = quantity_of(info) if info else None
    if varied.unit and quantity is None:
        raise _plain_number(varied)
    return quantity


def _plain_number(varied: Varied) -> SweepError:
    return SweepError(
        "{path} is a plain number; leave out the unit {unit}",
        path=one_line(varied.path),
        unit=seen(varied.unit),
    )


def _check_order(shown: str, tree: dict[str, Any]) -> None:
    """Refuse a file whose firing order or valves cannot be; what is swept has no part in them."""
    try:
        files.engine_of(tree, name=shown)
    except EngineFileError as error:
        faults = [fault for fault in error.faults if fault.path[:1] and fault.path[0] in _UNMOVED]
        if faults:
            raise EngineFileError(shown, faults) from None


def _base(shown: str, tree: dict[str, Any]) -> Engine | None:
    """The engine as its file has it, if valid.

    The firing order is taken out of the tree unless throws follow from it.
    """
    layout = tree.get("layout")
    if not (isinstance(layout, dict) and layout.get("type") == "inline" and "throws" not in layout):
        for key in ("firing_order", "firing_angles"):
            tree.pop(key, None)
    try:
        return files.engine_of(tree, name=shown)
    except EngineFileError:
        return None


def _leaf(annotation: Any) -> Any:
    """The bare type of a field: float for Annotated[float, ...] | None, tuple for a list."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is tuple or not parts:
        return tuple if origin is tuple else annotation
    return _leaf(
        parts[0] if origin is Annotated else next(part for part in parts if part is not type(None))
    )


def _is_number(tree: dict[str, Any], keys: Sequence[str | int]) -> bool:
    """Whether the path leads to a number that the tree has, or could have."""
    info = field_at(form_of(tree), keys)
    table: Any = tree
    for key in keys:
        if isinstance(key, str) and isinstance(table, dict):
            table = table.get(key, {})
        elif isinstance(key, int) and isinstance(table, list) and 0 <= key < len(table):
            table = table[key]
        else:
            return False
    if info is None:
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
        if key in _UNMOVED and not path:
            continue
        if kind is tuple:
            for place, entry in enumerate(value if isinstance(value, list) else [], 1):
                if inner is not None:
                    yield from _numeric(inner, entry, f"{here}[{place}].")
                elif _leaf(_tuple_of(info.annotation)[0]) in (float, Fraction):
                    yield f"{here}[{place}]"
        elif (
            inner is not None
            and kind is not dict
            and (value is not None or info.is_required() or info.default is not None)
        ):
            yield from _numeric(inner, value, f"{here}.")
        elif kind in (float, Fraction):
            yield here


def _why_fixed(over: str, keys: Sequence[str | int], forms: Sequence[dict[str, Any]]) -> str:
    """Why a path cannot be swept, and what can."""
    path = one_line(over, longest=80)
    if keys[0] in _UNMOVED:
        return _(
            "{path} has no effect on the inertia forces, so it cannot be swept; give the path of "
            "another number",
            path=path,
        )
    paths = {
        path: None for form in forms for path in ("balance_factor", *_numeric(form_of(form), form))
    }
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
    can = _("The numbers that can be swept are {numbers}.", **values)
    return " ".join(filter(None, (fault, near, can)))
