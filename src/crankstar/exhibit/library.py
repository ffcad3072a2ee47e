"""All that a page or a notebook must have with it, where no server can be asked: the exhibition, every figure and derivation."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from crankstar import fitting
from crankstar.charts.drawing import ChartError
from crankstar.derive import DerivationError
from crankstar.engine import Engine
from crankstar.exhibit.exhibits import exhibition
from crankstar.exhibit.figures import chart, derivation
from crankstar.exhibit.keys import BEFORE_AND_AFTER
from crankstar.exhibit.records import Exhibit

Tree = dict[str, Any]
Tell = Callable[[int, int, str], None]
"""Called with how much is done, of how much, and what comes next."""


def held(
    engines: Sequence[Engine],
    *,
    files_given: Sequence[Mapping[str, Any]] = (),
    sources: Sequence[str] = (),
    command: str = "",
    tell: Tell = lambda _done, _of, _note: None,
) -> Tree:
    """One engine, or two side by side, with all that belongs to them: `exhibition`, `libraries`, `fitted` (its libraries).

    A library has `charts` and `derivations` by key; what cannot be drawn or derived is missing from it. That of an engine with
    something to fit has the comparison of both too (`keys.BEFORE_AND_AFTER`).
    """
    shown = exhibition(engines, files_given=files_given, sources=sources, command=command)
    pairs: list[tuple[Engine, Exhibit] | None] = list(zip(engines, shown.engines, strict=True))
    for engine, after in zip(engines, shown.fitted, strict=True):
        found = fitting.recommended(engine)
        pairs.append((found.after, after) if found and after else None)
    compared = [after is not None for after in shown.fitted]
    steps = sum(len(pair[1].charts) + len(pair[1].derivations) for pair in pairs if pair) + sum(compared)
    done = 0

    def one_more(note: str) -> None:
        nonlocal done
        tell(done, steps, note)
        done += 1

    libraries = [pair and _library(*pair, one_more) for pair in pairs]
    for engine, library, both in zip(engines, libraries, compared, strict=False):  # those of the fitted engines come after
        if both and library:
            one_more("Spectrum, before and after")
            library["charts"][BEFORE_AND_AFTER] = chart(engine, BEFORE_AND_AFTER)
    return {
        "exhibition": shown.model_dump(mode="json"),
        "libraries": libraries[: len(engines)],
        "fitted": libraries[len(engines) :],
    }


def _library(engine: Engine, shown: Exhibit, one_more: Callable[[str], None]) -> Tree:
    charts: Tree = {}
    for key in shown.charts:
        one_more(key.label)
        try:
            charts[key.key] = chart(engine, key.key)
        except ChartError:
            continue
    derivations: Tree = {}
    for key in shown.derivations:
        one_more(key.label)
        try:
            derivations[key.key] = derivation(engine, key.key)
        except DerivationError:
            continue
    return {"charts": charts, "derivations": derivations}


def packed(tree: Tree) -> str:
    """A tree as JSON text that holds it packed: `{"encoding": "gzip+base64", "data": "..."}`; the same every time."""
    plain = json.dumps(tree, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return json.dumps({"encoding": "gzip+base64", "data": b64encode(gzip.compress(plain, 9, mtime=0)).decode()})
