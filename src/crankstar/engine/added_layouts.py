"""Layouts that other packages add, by entry points of the group `crankstar.layouts`."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import wraps
from inspect import signature
from typing import Any, get_type_hints
from warnings import catch_warnings

from pydantic import ValidationError, create_model

from crankstar.engine.basis import Basis
from crankstar.engine.engine import Engine
from crankstar.engine.packages import Added, Words, told_of
from crankstar.engine.records import Record
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.quoting import given


def added_layouts(taken: Collection[str]) -> Added[Callable[..., Engine]]:
    """The layouts of other packages, beside those whose names are taken.

    >>> added_layouts(["inline"]).group
    'crankstar.layouts'
    """
    return Added("crankstar.layouts", N_("layout"), taken, _checked)


def _checked(found: Any, words: Words) -> Callable[..., Engine]:
    """A layout of another package, whose faults are those of the file. Raises MessageError."""
    fields: dict[str, Any] = dict(type=(str, ...), **keys_of(found))
    with catch_warnings(action="error"):  # a default that no file can have
        create_model("Layout", __base__=Record, **fields).model_json_schema()

    @wraps(found)
    def laid_out(basis: Basis, **keys: Any) -> Engine:
        try:
            made = found(basis, **keys)
        except (EngineError, ValidationError):
            raise
        except Exception as error:
            fault = Fault(("layout", "type"), "layout.raised", {**words, "why": told_of(error)})
            raise EngineError([fault]) from error
        if not isinstance(made, Engine):
            fault = Fault(("layout", "type"), "layout.no-engine", {**words, "made": given(made)})
            raise EngineError([fault])
        return made

    return laid_out


def keys_of(function: Any) -> dict[str, Any]:
    """The keys of the table of a layout beside its type: the type and the default of each.

    Raises MessageError where the function is no layout.

    >>> from crankstar.engine.layouts import inline
    >>> [*keys_of(inline)][:2]
    ['throws', 'bearing']
    """
    refused = MessageError(
        _(
            "a layout is a function (basis, *, key: type, ...) of a Basis, and of keys by name "
            "whose types are annotated, that gives an Engine"
        )
    )
    if not callable(function):
        raise refused
    first, *others = [*signature(function).parameters.values()] or [None]
    hints = get_type_hints(function, include_extras=True)
    if first is None or first.kind not in (first.POSITIONAL_ONLY, first.POSITIONAL_OR_KEYWORD):
        raise refused
    keys: dict[str, Any] = {}
    for one in others:
        if one is None or one.kind is not one.KEYWORD_ONLY or one.name not in hints:
            raise refused
        keys[one.name] = hints[one.name], ... if one.default is one.empty else one.default
    return keys
