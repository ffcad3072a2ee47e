"""What the bare numbers of an engine file count in: SI units, or a size that is not given.

Without a bore pitch lengths along the crankshaft are in bore pitches, without a stroke lengths in
crank radii, without a mass masses in that of a piston. A change that gives such a size leaves the
numbers what they were; beside a size that has a unit a bare number that may be counted in it is
refused (`bare_numbers.reader`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from contextlib import suppress
from difflib import get_close_matches
from math import prod
from typing import Any

from crankstar.engine.basis import Sizes
from crankstar.engine.quantities import LENGTH, MASS
from crankstar.engine.records import Record
from crankstar.files import bare_numbers, units
from crankstar.files.forms import field_at, form_of, is_explicit, quantity_of
from crankstar.files.mistakes import Path as KeyPath
from crankstar.files.mistakes import Tree
from crankstar.files.parts import tells_mass, with_sums
from crankstar.files.plus_minus import nominal
from crankstar.language.faults import ValueFaultError, where


def relative_of(tree: Tree) -> frozenset[str]:
    """What a file says is not known."""
    named = listed(tree.get("relative"))
    return frozenset(name for name in ("mass", "radius", "pitch") if name in named)


def listed(value: Any) -> list[Any]:
    """A list as it is, nothing else."""
    return value if isinstance(value, list) else []


def unknown_scales(tree: Tree) -> frozenset[str]:
    """What a short file does not tell, so that its numbers must be bare."""
    cylinder, layout = (
        table if isinstance(table := tree.get(key), dict) else {} for key in ("cylinder", "layout")
    )
    banks = [bank for bank in listed(layout.get("banks")) if isinstance(bank, dict)]
    along = any(_tells(layout, key) for key in ("bore_pitch", "positions", "row_pitch"))
    along = along or any(
        isinstance(value, str)
        for value in (layout.get("bank_offset"), *(bank.get("set_back") for bank in banks))
    )
    cranks = [crank for crank in listed(tree.get("crankshaft")) if isinstance(crank, dict)]
    along = along or any(
        isinstance(value, str)
        for crank in cranks
        for value in (*listed(crank.get("bearings")), *listed(crank.get("webs")))
    )
    unknown = {
        "mass": not (_tells(cylinder, "reciprocating_mass") or tells_mass(cylinder)),
        "radius": not _tells(cylinder, "stroke"),
        "pitch": not along and not (_tells(cylinder, "stroke") and _in_one_plane(tree, layout)),
    }
    return relative_of(tree) | {name for name, missing in unknown.items() if missing}


def measured_scales(tree: Tree) -> dict[str, tuple[str, float]]:
    """The sizes that a file gives with a unit: their key and SI value, by scale."""
    return _sizes(tree, with_unit=True)


def written_units(tree: Tree, form: type[Record]) -> dict[str, bare_numbers.Written]:
    """The values that a file gives with a unit, the first of each dimension."""
    return bare_numbers.written(
        (where(path), value, quantity)
        for table, key, path in _leaves(tree)
        if isinstance(value := table[key], str) and path[0] != "provenance"
        if (info := field_at(form, path)) is not None
        if (quantity := quantity_of(info)) is not None
    )


def _in_one_plane(tree: Tree, layout: Tree) -> bool:
    """Whether all cylinders stand at one place of the shaft, so that no bore pitch is needed."""
    if "rows" in layout:
        return len(listed(layout["rows"])) == 1
    banks = [bank for bank in listed(layout.get("banks")) if isinstance(bank, dict)]
    if layout.get("bank_offset") or any(bank.get("set_back") for bank in banks):
        return False
    throws = layout.get("throws", tree.get("firing_order"))
    return "cranks" not in layout and len(listed(throws)) == 1


def _tells(table: Tree, key: str) -> bool:
    """Whether a table has a key, or one that is a slip of the pen for it."""
    others = [str(other)[:60] for other in table if other not in Sizes.model_fields]
    return key in table or bool(get_close_matches(key, others, 1, 0.8))


def with_references(before: Tree, after: Tree, changes: Collection[KeyPath]) -> None:
    """Let the bare numbers of a changed file count in what they counted in before the change.

    `after` has what is at the paths of `changes`; a size among it that the file did not give turns
    the other numbers that are counted in it into SI, in place.

    >>> flat = {"layout": {"type": "vee", "bank_offset": 0.2}}
    >>> after = {"layout": {"type": "vee", "bank_offset": 0.2, "bore_pitch": "100 mm"}}
    >>> with_references(flat, after, [("layout", "bore_pitch")])
    >>> after["layout"]["bank_offset"]
    '20 mm'
    """
    scales = relative_of if is_explicit(after) else unknown_scales
    gained = scales(before) - scales(after)
    if not gained:
        return
    known = {scale: size for scale, (_key, size) in _sizes(after).items() if scale in gained}
    if known:
        absolute(after, known, but=changes)


def _sizes(tree: Tree, *, with_unit: bool = False) -> dict[str, tuple[str, float]]:
    """The sizes of a file that its numbers may count in, by scale: their key and SI value."""
    layout, cylinder = (
        table if isinstance(table := tree.get(key), dict) else {} for key in ("layout", "cylinder")
    )
    places = [
        ("pitch", "layout.bore_pitch", layout.get("bore_pitch"), 1.0, LENGTH),
        ("pitch", "layout.row_pitch", layout.get("row_pitch"), 1.0, LENGTH),
        ("pitch", "bore_pitch", tree.get("bore_pitch"), 1.0, LENGTH),
        ("radius", "cylinder.stroke", cylinder.get("stroke"), 0.5, LENGTH),
    ]
    total, key = cylinder.get("reciprocating_mass"), "cylinder.reciprocating_mass"
    whole = with_sums(tree)[0].get("cylinder")
    if isinstance(whole, dict) and tells_mass(cylinder):
        total, key = whole.get("reciprocating_mass"), "cylinder.parts"
    places.append(("mass", key, total, 1.0, MASS))
    out: dict[str, tuple[str, float]] = {}
    for scale, key, value, share, quantity in places:
        if value is None or (with_unit and not _has_unit(value)):
            continue
        with suppress(ValueFaultError):  # reading the file says what is wrong
            out.setdefault(scale, (key, share * units.without_tolerance(value, quantity)))
    return out


def _has_unit(value: Any) -> bool:
    return isinstance(value, str) and bool(units.unit_of(str(nominal(value))))


def absolute(tree: Tree, sizes: Mapping[str, float], *, but: Collection[KeyPath] = ()) -> None:
    """Give every bare number that is counted in these units its SI value as text, `but` some."""
    form = form_of(tree)
    for table, key, path in [*_leaves(tree)]:
        info = field_at(form, path)
        quantity = quantity_of(info) if info is not None and path[0] != "provenance" else None
        value = table[key]
        if quantity is None or isinstance(value, bool) or path in but:
            continue
        counted = quantity.relative_to & sizes.keys()
        if isinstance(value, str):
            rest = bare_numbers.remaining(quantity, counted)
            if rest is None or not units.is_of(value, rest):
                continue
            value = units.si(value, rest)
        powers = bare_numbers.POWERS.get(quantity.dimension, {})
        factor = prod(sizes[unit] ** powers.get(unit, 1) for unit in counted)
        if counted:
            table[key] = units.text(value * factor, quantity)
    left = [unit for unit in tree.get("relative", ()) if unit not in sizes]
    tree.pop("relative", None)
    if left:
        tree["relative"] = left


def _leaves(tree: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[Any, Any, Any]]:
    """Every number and text of a tree: what holds it, its key there, its path."""
    pairs = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in pairs:
        if isinstance(value, dict | list):
            yield from _leaves(value, (*path, key))
        elif isinstance(value, int | float | str):
            yield tree, key, (*path, key)
