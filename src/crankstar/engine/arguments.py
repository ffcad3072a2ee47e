"""Arguments of functions that take an Engine: what is none is refused with what to write.

The functions of `crankstar` itself read names and paths too (`options.arguments`); those of the
rooms take an Engine and SI numbers only, and say so.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from inspect import isroutine, signature
from math import inf
from numbers import Real
from pathlib import Path
from typing import Any

from lazy_loader import attach_stub

from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted


def is_number(given: Any) -> bool:
    """Whether it is a number; True and False are none."""
    return isinstance(given, Real) and not isinstance(given, bool)


def unboxed(given: Any) -> Any:
    """The number of an array without dimensions; anything else as it is.

    >>> import numpy as np
    >>> unboxed(np.array(5.0)), unboxed([5.0])
    (5.0, [5.0])
    """
    return given.item() if getattr(given, "ndim", None) == 0 else given


def check_number(argument: str, given: Any) -> None:
    """Raises TypeError for what is no number, ValueError for one that is not finite."""
    if not is_number(given):
        raise TypeError(
            _("{argument} takes a number, not {given}", argument=argument, given=quoted(given))
        )
    if not -inf < given < inf:
        raise ValueError(
            _("{argument} is {given}; it must be finite", argument=argument, given=quoted(given))
        )


def check_planes(given: Any) -> None:
    """Raises TypeError for what is no list of places along the shaft."""
    listed = isinstance(given, Iterable) and not isinstance(given, str | bytes | Mapping)
    if not listed or not all(map(is_number, given)):
        raise TypeError(
            _(
                "planes takes places along the shaft in metres, such as [-0.2, 0.2], not {given}",
                given=quoted(given),
            )
        )


def late(room: str, file: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """`__getattr__`, `__dir__` and `__all__` of a room whose names are loaded on first use.

    They stand in the stub beside its `file`, with their modules; functions of an engine refuse what
    is none, as in `of_engines`.

    >>> from crankstar import files
    >>> "toml" in dir(files), files.toml.__module__
    (True, 'crankstar.files.write')
    """
    load, names, public = attach_stub(room, file)

    def attribute(name: str) -> Any:
        load(name)
        own = vars(sys.modules[room])
        of_engines(own, [name])
        return own[name]

    return attribute, names, public


def of_engines(room: dict[str, Any], names: Sequence[str]) -> None:
    """Have the functions of a room with these names refuse an `engine` that is none.

    `room` are the names of its module. Rooms below it and its own modules call the bare functions.

    >>> from crankstar import remedy
    >>> remedy.needs("i4")
    Traceback (most recent call last):
    TypeError: needs takes an Engine, not "i4"; write needs(crankstar.load("i4"))
    """
    for name in names:
        function: Any = room.get(name)  # None where it is loaded late
        bare = getattr(function, "__wrapped__", function)  # of a function that keeps results
        if isroutine(bare) and next(iter(signature(bare).parameters), "") == "engine":
            room[name] = _of_engine(function)


def _of_engine(function: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(function)
    def asking(*args: Any, **kwargs: Any) -> Any:
        from crankstar.engine.engine import Engine  # what names a room alone needs none

        given = args[0] if args else kwargs.get("engine", function)
        if given is not function and not isinstance(given, Engine):
            raise TypeError(_no_engine(function.__name__, given))
        return function(*args, **kwargs)

    return asking


def _no_engine(name: str, given: Any) -> str:
    """What is to be written instead of a name, a path or something else."""
    if isinstance(given, str | Path):
        return _(
            "{function} takes an Engine, not {given}; write {function}(crankstar.load({given}))",
            function=name,
            given=quoted(str(given)),
        )
    return _(
        '{function} takes an Engine, as crankstar.load("i4") gives it, not {given}',
        function=name,
        given=quoted(given),
    )
