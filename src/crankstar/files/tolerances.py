"""Tolerances of an engine file: how far each value may be off, beside the engine itself.

Any value with a unit may be written with a tolerance, "650 g +- 2 g" or "650 g +- 0.5 %". It is a
bound: a part is good from value - t to value + t. The Engine has the value alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from math import pi
from typing import Any, NamedTuple, get_args

from annotated_types import Ge, Gt

from crankstar.engine.quantities import Quantity
from crankstar.engine.records import Record
from crankstar.files import units
from crankstar.files.forms import field_at, form_of, quantity_of
from crankstar.files.mistakes import Path, Tree
from crankstar.files.plus_minus import PERCENT, Toleranced, nominal, parted, unit_behind
from crankstar.language.faults import Fault, ValueFaultError, where
from crankstar.language.messages import _
from crankstar.language.quoting import seen


class Tolerance(NamedTuple):
    """The tolerance of a value: its keys, the value and the bound in SI (or units of itself)."""

    keys: Path
    value: float
    bound: float
    quantity: Quantity

    @property
    def path(self) -> str:
        """The key path as messages write it: `shaft[1].throw[2].angle`."""
        return where(self.keys)


def tolerances_of(tree: Mapping[str, Any]) -> dict[str, Tolerance]:
    """The tolerances of a tree by key path, in the order of the file; faulty ones left out.

    >>> tree = {"layout": {"type": "inline", "bore_pitch": "100 mm +- 0.05 mm"},
    ...     "cylinder": {"stroke": "90 mm", "reciprocating_mass": "500 g +- 0.4 %"}}
    >>> [(own.path, round(own.bound, 9)) for own in tolerances_of(tree).values()]
    [('layout.bore_pitch', 5e-05), ('cylinder.reciprocating_mass', 0.002)]
    """
    read = (_read(form_of(tree), keys, text) for keys, text in _texts(tree))
    return {own.path: own for own in read if isinstance(own, Tolerance)}


def tolerance_faults(tree: Mapping[str, Any]) -> list[Fault]:
    """Every tolerance that cannot be."""
    read = (_read(form_of(tree), keys, text) for keys, text in _texts(tree))
    return [own for own in read if isinstance(own, Fault)]


def without_tolerances(tree: Tree) -> Tree:
    """The tree with the values alone; the same one where it has no tolerance.

    >>> without_tolerances({"name": "six +- 1", "cylinder": {"stroke": "90 mm +- 0.1 mm"}})
    {'name': 'six +- 1', 'cylinder': {'stroke': '90 mm'}}
    """
    if next(_texts(tree), None) is None:
        return tree
    return _stripped(tree, form_of(tree), ())


def _stripped(value: Any, form: type[Record], path: Path) -> Any:
    if isinstance(value, dict):
        return {key: _stripped(item, form, (*path, key)) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_stripped(item, form, (*path, index)) for index, item in enumerate(value)]
    return nominal(value) if _may_have(form, path) else value


def _texts(tree: Mapping[str, Any]) -> Iterator[tuple[Path, Toleranced]]:
    """Every value with a tolerance, where one may be read."""
    form: type[Record] | None = None
    valued = {key: item for key, item in tree.items() if key != "provenance"}
    for path, value in _leaves(valued, ()):
        own = parted(value)
        if own is not None:
            form = form or form_of(tree)
            if _may_have(form, path):
                yield path, own


WIDE = 0.2
"""Share of a mass or a length beyond which its tolerance is a slip of unit. Our judgement."""


def wide(tolerances: Iterable[Tolerance]) -> list[str]:
    """A sentence for each tolerance of a mass or length that no part is made to, if it is not 0.

    >>> tree = {"cylinder": {"stroke": "90 mm +- 30 mm", "rod_length": "150 mm +- 0.05 mm"}}
    >>> len(wide(tolerances_of(tree | {"layout": {"type": "inline"}}).values()))
    1
    >>> wide(tolerances_of({"cylinder": {"rotating_mass": "0 g +- 5 g"}}).values())
    []
    """
    return [
        _(
            "{key} has a tolerance of {share} % of its value; parts are made to less than {bound} "
            "%: is the unit right?",
            key=own.path,
            share=f"{100 * own.bound / own.value:.3g}",
            bound=f"{100 * WIDE:g}",
        )
        for own in tolerances
        if own.quantity.least
        and (own.quantity.dimension == "mass" or own.quantity.dimension.startswith("length"))
        and "clearance" not in own.path
        and own.bound > WIDE * own.value > 0
    ]


def _leaves(value: Any, path: Path) -> Iterator[tuple[Path, Any]]:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _leaves(item, (*path, str(key)))
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            yield from _leaves(item, (*path, index))
    elif isinstance(value, str):
        yield path, value


def _may_have(form: type[Record], path: Path) -> bool:
    """Whether a text at a path is a value: everything but names, sources and notes."""
    if path[:1] == ("provenance",):
        return False
    info = field_at(form, path)
    return info is None or quantity_of(info) is not None or not _is_text(info.annotation)


def _is_text(annotation: Any) -> bool:
    return annotation is str or any(map(_is_text, get_args(annotation)))


def _read(form: type[Record], keys: Path, text: Toleranced) -> Tolerance | Fault | None:
    """The tolerance of a value; its fault; None where the value itself is the mistake."""
    info = field_at(form, keys)
    if info is None:
        return None
    quantity = quantity_of(info)
    if quantity is None:
        return Fault(
            keys, "tolerance.no-quantity", {"value": seen(f"{text.value} +- {text.tolerance}")}
        )
    shown = {"value": seen(text.tolerance), "example": f'"{quantity.example} +- 0.5 %"'}
    unit = unit_behind(text.tolerance)
    if unit is None:
        return Fault(keys, "tolerance.not-a-number", shown)
    number = float(text.tolerance.removesuffix(unit).strip().replace("\u2212", "-"))
    if number < 0:
        return Fault(keys, "tolerance.negative", shown)
    try:
        value = _si(text.value, quantity)
    except ValueFaultError:
        return None
    if unit == PERCENT:
        bound = abs(value) * number / 100
        if value == 0 and number > 0:
            return Fault(keys, "tolerance.share-of-nothing", shown)
    else:
        try:
            bound = abs(_si(text.tolerance, quantity) - _si(f"0 {unit}", quantity))
        except ValueFaultError:
            measured = {"value": shown["value"], "dimension": quantity.dimension}
            return Fault(keys, "tolerance.unit", {**measured, "example": shown["example"]})
    if quantity.dimension == "angle" and bound > pi:
        return Fault(keys, "tolerance.half-turn", shown)
    if _positive(info.annotation, info.metadata) and 0 < value <= bound:
        wide = {"value": shown["value"], "nominal": seen(text.value)}
        return Fault(keys, "tolerance.too-large", wide)
    return Tolerance(keys, value, bound, quantity)


def _si(text: str, quantity: Quantity) -> float:
    """The SI number of a text; a bare one as it is, whose size reading the value judges."""
    if unit_behind(text) == "":
        return float(text.replace("\u2212", "-"))
    return units.si(text, Quantity(quantity.dimension, quantity.example))


def _positive(annotation: Any, metadata: Any) -> bool:
    """Whether a value may not be below nought."""
    marks = [*metadata, *getattr(annotation, "__metadata__", ())]
    for mark in marks:
        for own in (mark, *getattr(mark, "metadata", ())):
            if isinstance(own, Gt | Ge):
                return True
    return any(_positive(part, ()) for part in get_args(annotation))
