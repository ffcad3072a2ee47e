"""What a sweep varies and watches, as people give it in Python."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted
from crankstar.language.quoting import seen
from crankstar.options.numbers import check_number, is_number

PAIR = 2


def named(given: Any) -> str:
    """What was given, as a sentence names it: an engine by its name."""
    return f"Engine {seen(given.name)}" if isinstance(given, Engine) else quoted(given)


def check_sweep(function: str, given: dict[str, Any]) -> None:
    """Raises TypeError for what is varied or watched and cannot be; lists values that are made."""
    if "over" in given:
        over = given["over"]
        if isinstance(over, Mapping):
            made = {
                path: [*each] if isinstance(each, Iterator) else each for path, each in over.items()
            }
            _check_values(made)
            given["over"], over = made, [*made]
        texts = over if isinstance(over, list | tuple) else [over]
        odd = [text for text in texts if not isinstance(text, str)]
        if odd:
            raise TypeError(
                _(
                    'over takes text such as "balance_factor=0..1/11", a list of two such texts, '
                    "or a dict of values by key path, not {given}",
                    given=named(odd[0]),
                )
            )
        _check_watch(given.get("watch", ()))
    if "sweep" not in given:
        return
    from crankstar.studies.sweep import Sweep

    if not isinstance(given["sweep"], Sweep):
        raise TypeError(
            _(
                "{function} takes a Sweep, as crankstar.sweep gives it, not {given}",
                function=function,
                given=named(given["sweep"]),
            )
        )
    if not isinstance(given["what"], str):
        raise TypeError(
            _('what takes a quantity such as "force", not {given}', given=named(given["what"]))
        )
    if given.get("order") is not None:
        check_number("order", given["order"])


def _check_values(over: Mapping[Any, Any]) -> None:
    """Raises TypeError for values of a number that are neither numbers nor text."""
    for path, values in over.items():
        listed = isinstance(values, Iterable) and not isinstance(values, bytes | Mapping)
        if not listed or not all(isinstance(each, str) or is_number(each) for each in values):
            raise TypeError(
                _(
                    'over takes a list of numbers or text such as "0..1/11" for {path}, not '
                    "{given}",
                    path=seen(str(path)),
                    given=named(values),
                )
            )


def _check_watch(watch: Any) -> None:
    """Raises TypeError for what is no list of names, each alone or with an order."""
    listed = isinstance(watch, Iterable) and not isinstance(watch, bytes | Mapping)
    names = [watch] if isinstance(watch, str) or not listed else [*watch]
    pairs = [each if isinstance(each, tuple) else (each, 1) for each in names]
    if not all(
        len(pair) == PAIR and isinstance(pair[0], str) and is_number(pair[1]) for pair in pairs
    ):
        listed = False
    if not listed:
        raise TypeError(
            _(
                'watch takes names such as ["force", "couple.pitch"], each alone or with an order, '
                'as in ("force", 2), not {given}',
                given=named(watch),
            )
        )
