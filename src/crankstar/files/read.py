"""Engine files read: from a tree of keys to an Engine, with every fault of a file at once.

A file is read in two steps. First its tree is checked against the records, all mistakes at once;
then the layout and the engine are built, and what only the whole shows (a rod too short, an order
that cannot fire) is added. Where the tree itself has mistakes, a mended copy is built all the same,
so that a wrong unit in one place does not hide a missing cylinder in another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import partial
from itertools import chain
from typing import Any, Literal, NamedTuple

from pydantic import ValidationError

from crankstar.engine.basis import Sizes
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Record
from crankstar.files import bare_numbers
from crankstar.files.chains import is_drive_line
from crankstar.files.changes import changed, throw_angles, with_weights_along
from crankstar.files.errors import EngineFileError
from crankstar.files.forms import form_of, is_explicit, short_form
from crankstar.files.mistakes import Path as KeyPath
from crankstar.files.mistakes import (
    SpreadsheetTree,
    Tree,
    faults_of,
    mended,
    range_faults,
    unknown_sources,
)
from crankstar.files.parts import with_sums
from crankstar.files.references import (
    listed,
    measured_scales,
    relative_of,
    unknown_scales,
    written_units,
)
from crankstar.files.tolerances import tolerance_faults, without_tolerances
from crankstar.language.faults import EngineError, Fault, where
from crankstar.language.quoting import seen


class _Draft(NamedTuple):
    """What came out of a tree: the engine if there is one, and the faults by key path."""

    engine: Engine | None
    faults: list[Fault]


def engine_of(
    tree: Tree, *, name: str = "the engine", changes: Mapping[str, Any] | None = None
) -> Engine:
    """The engine of a tree, in the short or the explicit form.

    Raises EngineFileError with every mistake in it. A throw whose angle is among the `changes`
    takes its weights along, but for those whose own angle is.
    """
    changes = changes or {}
    engine = _engine_of(changed(tree, changes, name=name), name)
    turned = throw_angles(changes)
    if not turned:
        return engine
    others = {path: value for path, value in changes.items() if path not in turned}
    others |= {"firing_order": [], "firing_angles": None}  # which may fit the turned throws only
    try:
        before = _engine_of(changed(tree, others), name)
    except EngineFileError:  # the change is what makes it an engine: there is no angle to turn from
        return engine
    return with_weights_along(before, engine, changes)


def _engine_of(tree: Tree, name: str) -> Engine:
    """The engine of a tree with its changes. Raises EngineFileError."""
    if is_drive_line(tree):
        raise EngineFileError(name, [Fault((), "form.drive-line")])
    explicit = is_explicit(tree)
    given, tolerances = tree, tolerance_faults(tree)
    tree = without_tolerances(tree)
    whole, contradictions = with_sums(tree)
    draft = _explicit(whole) if explicit else _short(whole)
    # an explicit file that was made from a layout keeps the sources of its dimensions
    layouts = LAYOUTS if explicit or _layout_faults(tree.get("layout")) else ()
    forms = chain([form_of(tree)], map(short_form, layouts))
    own = [
        fault
        for fault in draft.faults
        if not _is_bare_sum(fault, tree) and not _is_of_no_table(fault, tree)
    ]
    faults = [*tolerances, *_elsewhere(own, tolerances)]
    faults += _elsewhere(contradictions, draft.faults)
    faults += _elsewhere([*unknown_sources(tree, forms), *range_faults(tree)], draft.faults)
    faults = _without_repeats(in_file(tree, faults, explicit=explicit))
    cells: Mapping[KeyPath, str] = {}
    if isinstance(given, SpreadsheetTree):
        known = [fault for fault in given.faults if fault.path]
        faults, cells = [*given.faults, *_elsewhere(faults, known)], given.cells
    if faults or draft.engine is None:
        raise EngineFileError(name, faults, cells)
    return draft.engine


def _is_bare_sum(fault: Fault, tree: Tree) -> bool:
    """Whether a bare mass is the sum of parts, each of which has a fault of its own."""
    table: Any = tree
    for key in fault.path[:-1]:
        try:
            table = table[key]
        except (KeyError, IndexError, TypeError):
            return False
    return (
        fault.code.startswith("unit.bare-beside")
        and isinstance(table, dict)
        and "parts" in table
        and fault.path[-1] not in table
    )


def _is_of_no_table(fault: Fault, tree: Tree) -> bool:
    """Whether it says that a size is not given, the table of which is something else."""
    tables = (tree.get("cylinder", {}), tree.get("layout", {}))
    lost = any(not isinstance(table, dict) for table in tables)
    return lost and fault.code.startswith("unit.unknown-")


def _explicit(tree: Tree) -> _Draft:
    return _built(tree, Engine, relative_of(tree), lambda engine: engine, because="relative")


def _short(tree: Tree) -> _Draft:
    other = [key for key in ("shaft", "shafts") if key in tree]
    tree = {key: value for key, value in tree.items() if key not in other}
    layout = tree.get("layout")
    faults = [*(Fault((key,), "form.mixed") for key in other), *_layout_faults(layout)]
    near = _near_layout(layout)
    if near and isinstance(layout, dict):  # read as what is meant, it may show more mistakes
        tree = {**tree, "layout": {**layout, "type": near}}
    relative = unknown_scales(tree)
    draft = _built(
        tree,
        form_of(tree),
        relative,
        None if _layout_faults(tree.get("layout")) else partial(_laid_out, relative),
        because="unknown",
    )
    if draft.engine is not None and "pitch" in draft.engine.relative and "pitch" not in relative:
        values = {"key": "bore_pitch", "example": '"105.5 mm"'}
        faults.append(Fault(("layout", "bore_pitch"), "missing.example", values))
    return _Draft(draft.engine, faults + draft.faults)


def _layout_faults(layout: Any) -> list[Fault]:
    if layout is None:
        return [Fault(("layout",), "layout.missing")]
    if not isinstance(layout, dict):
        return [Fault(("layout",), "layout.not-a-table", {"value": seen(layout)})]
    kind, path = layout.get("type"), ("layout", "type")
    if isinstance(kind, str) and kind in LAYOUTS:
        return []
    if isinstance(kind, str) and (why := LAYOUTS.why_not(kind)):
        return [Fault(path, "layout.of-package", {"why": why})]
    choices = {"value": seen(kind), "choices": list(LAYOUTS)}
    if "type" not in layout:
        return [Fault(path, "layout.type-missing", choices)]
    if near := _near_layout(layout):
        return [Fault(path, "layout.type-misspelt", choices | {"meant": f'"{near}"'})]
    return [Fault(path, "layout.type-unknown", choices)]


def _near_layout(layout: Any) -> str:
    """The layout that a misspelt one means; empty where there is none, or it is not misspelt."""
    kind = layout.get("type") if isinstance(layout, dict) else None
    if not isinstance(kind, str) or kind in LAYOUTS or LAYOUTS.why_not(kind):
        return ""
    return next(iter(get_close_matches(kind.lower()[:60], LAYOUTS, 1)), "")


def _laid_out(relative: frozenset[str], record: Any) -> Engine:
    """The engine of a short file's record, counting in units of itself what is in `relative`."""
    record = with_values(record, relative=tuple(sorted(relative)))
    layout = {
        key: getattr(record.layout, key) for key in record.layout.model_fields_set if key != "type"
    }
    return LAYOUTS[record.layout.type](record, **layout)


def _built(
    tree: Tree,
    model: type[Record],
    relative: frozenset[str],
    then: Callable[[Any], Engine] | None,
    *,
    because: Literal["unknown", "relative"],
) -> _Draft:
    """Check a tree against its record and build the engine; corrected copies find more faults."""
    reader = partial(bare_numbers.reader, relative, because=because)
    context = {"reader": reader()}  # of corrected copies, whose numbers are bare
    given = written_units(tree, model)
    strict = {"reader": reader(measured=measured_scales(tree), written=given)}
    try:
        record = model.model_validate(tree, context=strict, by_alias=True, by_name=False)
    except ValidationError as error:
        faults = faults_of(error, model, tree)
        if then is not None:
            copies = [mended(tree, error, model, number=number) for number in _MENDINGS]
            for seek in (_faults_when_built, partial(_faults_behind, faults)):
                first, second = (seek(copy, model, context, then) for copy in copies)
                faults += _elsewhere([fault for fault in first if fault in second], faults)
        return _Draft(None, faults)
    if then is None:
        return _Draft(None, [])
    try:
        return _Draft(then(record), [])
    except EngineError as error:
        faults = error.faults
    except ValidationError as error:
        faults = faults_of(error, model, tree, under=("layout",))
    return _Draft(None, [*faults, *_faults_behind(faults, tree, model, context, then)])


def _faults_behind(
    faults: list[Fault],
    tree: Tree,
    model: type[Record],
    context: dict[str, Any],
    then: Callable[[Any], Engine],
) -> list[Fault]:
    """Faults that show only where the optional tables in which others were found are left out."""
    spoilt = {_short_place(tree, fault)[0] for fault in faults if fault.path} & _OPTIONAL
    if not spoilt & set(tree):
        return []
    rest = {key: value for key, value in tree.items() if key not in spoilt}
    order, layout = tree.get("firing_order"), tree.get("layout")
    if "firing_order" in spoilt and isinstance(order, list) and _has_no_throws(layout):
        rest["firing_order"] = [*range(1, len(order) + 1)]  # throws follow from any
    more = _elsewhere(_faults_when_built(rest, model, context, then), faults)
    return more + _faults_behind(more, rest, model, context, then)


def _has_no_throws(layout: Any) -> bool:
    return isinstance(layout, dict) and "throws" not in layout


_OPTIONAL = {
    "cylinders",
    "valves",
    "block",
    "gas",
    "drive",
    "oil",
    "torsion",
    "mounts",
    "foundation",
    "firing_order",
    "firing_angles",
    "crankshaft",
    "balance_shaft",
}
"""Keys of a short file without which an engine can still be built."""


def _elsewhere(faults: list[Fault], known: list[Fault]) -> list[Fault]:
    """Faults in places of which nothing is known yet."""
    places = [fault.path for fault in known]
    return [
        fault
        for fault in faults
        if not any(
            _overlap(fault.path, place) or place[:1] == (_WANTING.get(fault.code),)
            for place in places
        )
    ]


_WANTING = {"layout.throws-missing": "firing_order", "foundation.alone": "mounts"}
"""Faults for want of a table, which one that is spoilt seems to be."""
_MENDINGS = (9000, 9500)
"""Numbers that no cylinder of a mistaken file has, as far as one can tell."""


def _faults_when_built(
    tree: Tree, model: type[Record], context: dict[str, Any], then: Callable[[Any], Engine]
) -> list[Fault]:
    """The faults that only the whole engine of a mended tree shows: orders, indices, numbering."""
    try:
        then(model.model_validate(tree, context=context, by_alias=True, by_name=False))
    except EngineError as error:
        faults = error.faults
    except ValidationError as error:
        causes = [
            mistake.get("ctx", {}).get("error") for mistake in error.errors(include_url=False)
        ]
        faults = [
            fault for cause in causes if isinstance(cause, EngineError) for fault in cause.faults
        ]
    else:
        return []
    return [fault for fault in faults if not fault.code.startswith(_OF_MOTION)]


_OF_MOTION = ("firing_order.unfit", "firing_angles.", "rod.slave")
"""Faults that may come from what was mended."""


def _overlap(path: tuple[str | int, ...], other: tuple[str | int, ...]) -> bool:
    shorter = min(len(path), len(other))
    return path[:shorter] == other[:shorter]


def in_file(tree: Tree, faults: list[Fault], *, explicit: bool) -> list[Fault]:
    """Faults with the key paths of the file.

    What the short form says of all cylinders is one fault, with the numbers of these cylinders.
    """
    placed: dict[tuple[Any, ...], Fault] = {}
    for fault in faults:
        path = fault.path if explicit else _short_place(tree, fault)
        if explicit and path[:1] == ("crankshaft",):
            path = ("shaft", *path[1:])
        if explicit and path[:1] == ("balance_shaft",):
            path = ("shaft", _without_throws(tree)[int(path[1])], *path[2:])
        shared = fault.cylinder is not None and not explicit
        placed.setdefault((path,) if shared else (path, fault.sentence), fault._replace(path=path))
    return list(placed.values())


def _without_throws(tree: Tree) -> list[int]:
    """Which shafts of an explicit file have no throws."""
    shafts = enumerate(listed(tree.get("shaft", tree.get("shafts"))))
    return [n for n, each in shafts if not (isinstance(each, dict) and each.get("throw"))]


def _without_repeats(faults: list[Fault]) -> list[Fault]:
    """One fault for all values with units that need the same size or mass, which the file lacks."""
    out: list[Fault] = []
    for fault in faults:
        alike = [each for each in faults if each.code == fault.code]
        if not fault.code.startswith(_OF_UNKNOWN) or len(alike) == 1:
            out.append(fault)
        elif fault is alike[0]:
            code = fault.code.replace(_OF_UNKNOWN, "unit.several-")
            out.append(Fault((), code, {"paths": [where(each.path) for each in alike]}))
    return out


_OF_UNKNOWN = "unit.unknown-"


def _short_place(tree: Tree, fault: Fault) -> tuple[str | int, ...]:
    """Where a short file says what a fault of the engine made from it is about."""
    if fault.path[:1] == ("shaft",) and "shaft" not in tree:
        return ("layout",)
    if fault.cylinder is None:
        return fault.path
    rest = fault.path[2:]
    for index, other in enumerate(listed(tree.get("cylinders"))):
        if (
            isinstance(other, dict)
            and other.get("number") == fault.cylinder
            and (not rest or rest[0] in other)
        ):
            return ("cylinders", index, *rest)
    return ("cylinder", *rest) if rest and rest[0] in Sizes.model_fields else ("layout",)
