"""Numbers of an engine file by key path, and the engine as a function of some of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from typing import Any, NamedTuple

from crankstar import files
from crankstar.engine.arrangement import OF_FACTOR
from crankstar.engine.basis import BALANCE_FACTOR
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import ANGLE, Quantity
from crankstar.files import EngineFileError, units
from crankstar.files.box import box
from crankstar.files.catalog import tree_of
from crankstar.files.forms import field_at, form_of, quantity_of
from crankstar.files.mistakes import copied
from crankstar.files.source import tree_of_keys
from crankstar.language.quoting import one_line, seen
from crankstar.remedy import with_counterweights
from crankstar.studies.numeric_keys import BANK_ANGLE, UNMOVED, entry_at, is_number, why_fixed
from crankstar.studies.variants import OverError

INSTEAD = {"rod_ratio": "rod_length", "rod_length": "rod_ratio"}
"""Of these a file gives one; the one that is varied takes the place of the other."""


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
        for index, form in enumerate(forms):
            changed: dict[str, Any] = {}
            for number, own, one in zip(numbers, stages, written, strict=True):
                if own is form:
                    changed |= _changes(form, one, number)
            if changed:
                under = _explicit(engine) if index and engine is not base and engine else form
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
        table = entry_at(out, outer)
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
        if all(is_number(form, own) and own[0] not in UNMOVED for own in keys):
            return [form] * len(over)
    out: list[dict[str, Any] | None] = []
    for varied, own in zip(over, keys, strict=True):
        form = next((form for form in forms if is_number(form, own)), None)
        if form is None and varied.path == "balance_factor" and base is not None:
            if varied.unit:
                raise _plain_number(varied)
        elif form is None or own[0] in UNMOVED:
            raise OverError(f"{shown}: {why_fixed(varied.path, own, forms)}")
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
        faults = [fault for fault in error.faults if fault.path[:1] and fault.path[0] in UNMOVED]
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
