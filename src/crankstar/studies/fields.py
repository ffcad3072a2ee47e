"""Numbers of an engine file by key path, and the engine as a function of some of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from functools import reduce
from typing import Annotated, Any, NamedTuple, get_args, get_origin

from crankstar import files
from crankstar.engine.arrangement import OF_FACTOR
from crankstar.engine.basis import BALANCE_FACTOR
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.quantities import ANGLE, Quantity
from crankstar.engine.records import Record
from crankstar.files import EngineFileError, units
from crankstar.files.box import box
from crankstar.files.catalog import tree_of
from crankstar.files.forms import (
    by_key,
    field_at,
    form_of,
    is_explicit,
    quantity_of,
    record_in,
    short_form,
)
from crankstar.files.mistakes import copied
from crankstar.files.source import tree_of_keys
from crankstar.language.messages import _, passage
from crankstar.language.quoting import one_line, seen
from crankstar.remedy import with_counterweights
from crankstar.studies.variants import OverError

BANK_ANGLE = "layout.bank_angle"
"""What moves both banks of a V engine about the middle between them; no key of its file."""
INSTEAD = {"rod_ratio": "rod_length", "rod_length": "rod_ratio"}
"""Of these a file gives one; the one that is varied takes the place of the other."""
LISTED = 24
"""Paths that are named where another one cannot be swept."""
_UNMOVED = ("firing_order", "firing_angles", "valves", "speed", "format")


class Source(NamedTuple):
    """An engine file that is studied: name and tree; the engine itself where it is as it came."""

    name: str
    tree: dict[str, Any]
    engine: Engine | None = None


class Subject(NamedTuple):
    """A varied engine: as its file has it, as a function of the values, and their quantities."""

    base: Engine | None
    make: Callable[..., Engine]
    quantities: tuple[Quantity | None, ...]


class Varied(NamedTuple):
    """The key path of a number that is varied, and the unit of its values, None for SI."""

    path: str
    unit: str | None = None


def source_of(
    engine: str | Engine | Mapping[str, Any],
    *,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
    speed: object = None,
) -> Source:
    """The file of an engine, of a name (catalog, file or "-") or of keys, with `changes` by path.

    `estimate` fills in what it leaves out, but for the speed where a `speed` is asked for. Raises
    EngineFileError.
    """
    own = isinstance(engine, Engine)
    if isinstance(engine, Mapping):
        shown, tree = tree_of_keys(engine)
    else:
        shown, tree = (engine.name, files.explicit(engine)) if own else tree_of(engine)
    tree = files.changed(tree, changes or {}, name=shown)
    if estimate:
        from crankstar.files.estimate import estimated

        tree = estimated(tree, name=shown, speed=speed).tree
    _check_order(shown, tree)
    return Source(shown, tree, engine if own and not changes and not estimate else None)


def ends_of(source: Source, over: Sequence[Varied]) -> tuple[Source, ...]:
    """The file in the middle and at the corners of the ranges of what is estimated and not varied.

    None where there are no ranges. Raises EngineFileError.
    """
    varied = {path for each in over for path in (each.path, instead(each.path))}
    sources = source.tree.get("provenance")
    kept = {k: v for k, v in sources.items() if k not in varied} if sources else {}
    ends = box({**source.tree, "provenance": kept}, name=source.name)
    trees = () if ends is None else (ends.middle, *ends.corners)
    return tuple(
        Source(source.name, {key: value for key, value in tree.items() if key != "provenance"})
        for tree in trees  # whose sources take as long to check as an engine to build
    )


def instead(path: str) -> str:
    """The path of what a file may give instead of a value."""
    *outer, last = path.split(".")
    return ".".join((*outer, INSTEAD.get(last, last)))


def subject(source: Source, over: Sequence[Varied]) -> Subject:
    """The engine of a file as a function of the numbers at these key paths.

    A path is one of the short form or of the explicit form, or `balance_factor`; without any the
    engine is as its file has it. Raises SweepError where there is no such number, EngineFileError.

    >>> twin = subject(source_of("harley-45"), [Varied("layout.banks[1].bearing", "deg")])
    >>> round(twin.make(45).cylinders[0].bearing, 6), twin.quantities[0].dimension
    (0.785398, 'angle')
    """
    shown, tree = source.name, copied(source.tree)
    base = _base(shown, tree)
    tree = _without_others(tree, over)
    if not over and (engine := source.engine) is not None:
        return Subject(engine, lambda: engine, ())
    if not over:
        return Subject(base, lambda: files.engine_of(tree, name=shown), ())
    forms = [tree] if base is None else [tree, _explicit(base)]
    stages = _stages(shown, over, forms, base)
    quantities = tuple(
        None if form is None else _quantity(form, varied)
        for varied, form in zip(over, stages, strict=True)
    )

    written = tuple(
        _written(varied, quantity, base) for varied, quantity in zip(over, quantities, strict=True)
    )

    def make(*numbers: float) -> Engine:
        given = list(zip(over, numbers, strict=True))
        title = f"{shown} with {', '.join(_value_text(varied, number) for varied, number in given)}"
        engine = base
        for place, form in enumerate(forms):
            changed: dict[str, Any] = {}
            for number, own, one in zip(numbers, stages, written, strict=True):
                if own is form:
                    changed |= _changes(form, one, number)
            if changed:
                under = _explicit(engine) if place and engine is not base and engine else form
                engine = files.engine_of(under, name=title, changes=changed)
        factors = (n for n, form in zip(numbers, stages, strict=True) if form is None)
        engine = engine or files.engine_of(tree, name=title)
        return reduce(_with_factor, factors, engine)

    return Subject(base, make, quantities)


def _with_factor(engine: Engine, factor: float) -> Engine:
    """The engine with the counterweights of a balance factor, as its file would give them."""
    weighted = with_counterweights(engine, factor=factor, bare=True)
    origins = {BALANCE_FACTOR: OF_FACTOR, **engine.provenance}
    return with_values(weighted, provenance=origins)


def _without_others(tree: dict[str, Any], over: Sequence[Varied]) -> dict[str, Any]:
    """The tree without what the file gives instead of a number that is varied."""
    out = copied(tree)
    for varied in over:
        *outer, last = files.keys_of(varied.path)
        table = _entry(out, outer)
        if isinstance(table, dict):
            table.pop(INSTEAD.get(str(last)), None)
    return out


def _written(varied: Varied, quantity: Quantity | None, base: Engine | None) -> Varied:
    """A number as it is written into a file: with its unit, that of SI where none was named."""
    if varied.unit is not None or quantity is None or base is None:
        return varied
    if quantity.relative_to & set(base.relative):
        return varied
    return Varied(varied.path, units.si_unit(quantity))


def _changes(form: dict[str, Any], varied: Varied, number: float) -> dict[str, Any]:
    """What a number of a sweep changes in a file, by key path."""
    if varied.path != BANK_ANGLE:
        return {varied.path: f"{number!r} {varied.unit}" if varied.unit else number}
    first, second = (_angle(bank["bearing"]) for bank in form["layout"]["banks"])
    angle = number if varied.unit is None else _angle(f"{number!r} {varied.unit}")
    half = angle / 2 if first > second else -angle / 2
    ends = ((first + second) / 2 + half, (first + second) / 2 - half)
    return {f"layout.banks[{n}].bearing": f"{end!r} rad" for n, end in enumerate(ends, 1)}


def _angle(value: Any) -> float:
    return units.without_tolerance(value, ANGLE) if isinstance(value, str) else float(value)


def _has_bank_angle(tree: dict[str, Any]) -> bool:
    """Whether a file gives the bearings of two banks."""
    banks = _entry(tree, ["layout", "banks"])
    return (
        isinstance(banks, list)
        and len(banks) == 2
        and all(isinstance(bank, dict) and "bearing" in bank for bank in banks)
    )


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
    if any(varied.path == BANK_ANGLE for varied in over):
        bearings = [own for own in keys if own[:2] == ["layout", "banks"] and own[-1] == "bearing"]
        if bearings:
            raise OverError(
                "{path} moves both banks; vary it without their bearings", path=BANK_ANGLE
            )
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
            raise OverError(f"{shown}: {_why_fixed(varied.path, own, forms)}")
        out.append(form)
    return out


def _quantity(form: dict[str, Any], varied: Varied) -> Quantity | None:
    info = field_at(form_of(form), files.keys_of(varied.path))
    quantity = quantity_of(info) if info else None
    if varied.path == BANK_ANGLE:
        quantity = ANGLE
    if varied.unit and quantity is None:
        raise _plain_number(varied)
    return quantity


def _plain_number(varied: Varied) -> OverError:
    return OverError(
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
    """The engine as its file has it, if valid. Raises EngineFileError for a drive line."""
    # a firing order is taken out of the tree unless throws follow from it
    layout = tree.get("layout")
    if not (isinstance(layout, dict) and layout.get("type") == "inline" and "throws" not in layout):
        for key in ("firing_order", "firing_angles"):
            tree.pop(key, None)
    try:
        return files.engine_of(tree, name=shown)
    except EngineFileError as error:
        if any(fault.code == "form.drive-line" for fault in error.faults):
            raise
        return None


def _leaf(annotation: Any) -> Any:
    """The bare type of a field: float for Annotated[float, ...] | None, tuple for a list."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is tuple or not parts:
        return tuple if origin is tuple else annotation
    return _leaf(
        parts[0] if origin is Annotated else next(part for part in parts if part is not type(None))
    )


def _entry(tree: Any, keys: Sequence[str | int]) -> Any:
    """What the path leads to in a tree; an empty table where it has no such key."""
    for key in keys:
        if isinstance(key, str) and isinstance(tree, dict):
            tree = tree.get(key, {})
        elif isinstance(key, int) and isinstance(tree, list) and 0 <= key < len(tree):
            tree = tree[key]
        else:
            return None
    return tree


def _is_number(tree: dict[str, Any], keys: Sequence[str | int]) -> bool:
    """Whether the path leads to a number that the tree has, or could have."""
    if list(keys) == BANK_ANGLE.split("."):
        return _has_bank_angle(tree)
    info = field_at(form_of(tree), keys)
    if info is None or _entry(tree, keys) is None:
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


def _is_short(tree: dict[str, Any], keys: Sequence[str | int]) -> bool:
    """Whether the path is one of a short file where the tree is explicit, as that of an Engine."""
    of_layout = any(field_at(short_form(kind), keys) for kind in LAYOUTS)
    return is_explicit(tree) and (of_layout or list(keys) == BANK_ANGLE.split("."))


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
    if _has_bank_angle(forms[0]):
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
