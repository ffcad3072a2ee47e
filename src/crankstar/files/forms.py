"""The two forms of an engine file as records.

The explicit one is the Engine itself, a short one has a layout.

The `[layout]` table of a short file holds the keyword arguments of a layout function; its record is
made from the function's signature, so that a new layout needs no second description.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Annotated, Any, Literal, get_args, get_origin

from pydantic import Field, create_model
from pydantic.fields import FieldInfo

from crankstar.engine.added_layouts import keys_of
from crankstar.engine.basis import Basis
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.quantities import Quantity
from crankstar.engine.records import Record


def is_explicit(tree: Mapping[str, Any]) -> bool:
    """Whether a tree is in the explicit form: shafts and cylinders rather than a layout."""
    return not {"layout", "cylinder"} & tree.keys() and bool(
        {"shaft", "shafts", "cylinders"} & tree.keys()
    )


@lru_cache(maxsize=16)
def short_form(kind: str | None) -> type[Record]:
    """The record of a short file with a layout of that kind; None: any layout table."""
    if kind is None:
        return create_model(
            "Short",
            __base__=Basis,
            layout=(Annotated[Any, Field(description="how the cylinders are arranged")], {}),
        )
    function = LAYOUTS[kind]
    named: Any = Annotated[Literal[kind], Field(description="names the layout")]
    fields: dict[str, Any] = {"type": (named, ...), **keys_of(function)}
    layout = create_model(kind.capitalize(), __base__=Record, __doc__=_summary(function), **fields)
    said: Any = Annotated[layout, Field(description="how the cylinders are arranged")]
    return create_model(
        f"Short{kind.capitalize()}", __base__=Basis, __doc__=_summary(function), layout=(said, ...)
    )


def form_of(tree: Mapping[str, Any]) -> type[Record]:
    """The record a tree should fit."""
    if is_explicit(tree):
        return Engine
    layout = tree.get("layout")
    kind = layout.get("type") if isinstance(layout, dict) else None
    return short_form(kind if isinstance(kind, str) and kind in LAYOUTS else None)


def _summary(function: Any) -> str:
    return (inspect.getdoc(function) or "").split("\n")[0]


def field_at(model: type[Record], path: Iterable[str | int]) -> FieldInfo | None:
    """The field of a record, or of the records in it, that a key path of a file leads to."""
    record: type[Record] | None = model
    info: FieldInfo | None = None
    free = False
    for key in path:
        if isinstance(key, int) or free:
            free = False
            continue
        info = by_key(record).get(key) if record else None
        record = record_in(info.annotation) if info else None
        free = info is not None and get_origin(info.annotation) is dict  # whose own keys are free
    return info


def by_key(record: type[Record]) -> dict[str, FieldInfo]:
    """The fields of a record by the keys they have in files."""
    return {str(info.validation_alias or name): info for name, info in record.model_fields.items()}


def record_in(annotation: Any) -> type[Record] | None:
    """The record a type is or holds: Throw for tuple[Throw, ...]."""
    if isinstance(annotation, type) and issubclass(annotation, Record):
        return annotation
    return next(
        (record for part in get_args(annotation) if (record := record_in(part)) is not None), None
    )


def quantity_of(info: FieldInfo) -> Quantity | None:
    """What a field measures, if it measures anything."""
    own = (mark for mark in info.metadata if isinstance(mark, Quantity))
    return next(own, None) or _quantity_in(info.annotation)


def _quantity_in(annotation: Any) -> Quantity | None:
    for part in (*getattr(annotation, "__metadata__", ()), *get_args(annotation)):
        quantity = part if isinstance(part, Quantity) else _quantity_in(part)
        if quantity is not None:
            return quantity
    return None


def example(info: FieldInfo, *, depth: int = 0) -> str:
    """An example value of a field, or of an item of its list, in TOML; empty if there is none."""
    if info.examples and not depth:
        return json.dumps(info.examples[0], ensure_ascii=False)
    sample = _sample(info.annotation, quantity_of(info))
    for _ in range(depth):
        sample = sample[1:-1] if sample.startswith("[") else sample
    return sample


def _sample(annotation: Any, quantity: Quantity | None) -> str:
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is tuple:
        return f"[{_sample(parts[0], quantity)}]"
    if origin is dict:
        return f"{{ key = {_sample(parts[1], None)} }}"
    if origin is Literal:
        return json.dumps(parts[0])
    if parts:
        return _sample(parts[0], quantity)  # what is annotated, or the first of a union
    if isinstance(annotation, type) and issubclass(annotation, Record):
        fields = [*by_key(annotation).items()]
        required = dict([pair for pair in fields if pair[1].is_required()] or fields[:1])
        return "{ " + ", ".join(f"{key} = {example(info)}" for key, info in required.items()) + " }"
    plain = {int: "1", float: "1.5", str: '"a name"', Fraction: '"29/31"'}
    return f'"{quantity.example}"' if quantity else plain.get(annotation, "")
