"""The whole contents of a page without a server: exhibition, figures and derivations, packed."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from crankstar.charts.drawing import ChartError
from crankstar.derive import DerivationError
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.page.exhibits import exhibition
from crankstar.page.figures import chart, derivation
from crankstar.page.keys import BEFORE_AND_AFTER
from crankstar.page.records import Exhibit
from crankstar.remedy import fitting

Tree = dict[str, Any]
Tell = Callable[[int, int, str], None]
"""Called with the steps done, all steps, and the next one."""


def held(
    engines: Sequence[Engine],
    *,
    files_given: Sequence[Mapping[str, Any]] = (),
    sources: Sequence[str] = (),
    command: str = "",
    tell: Tell = lambda _done, _of, _note: None,
) -> Tree:
    """One engine, or two side by side: `exhibition`, `libraries` and the libraries of `fitted`.

    A library has `charts` and `derivations` by key, as far as they can be drawn and derived, and
    the figure `keys.BEFORE_AND_AFTER` of an engine that is fitted with something.
    """
    shown = exhibition(engines, files_given=files_given, sources=sources, command=command)
    pairs: list[tuple[Engine, Exhibit] | None] = list(zip(engines, shown.engines, strict=True))
    for engine, after in zip(engines, shown.fitted, strict=True):
        found = fitting.recommended(engine)
        pairs.append((found.after, after) if found and after else None)
    compared = [after is not None for after in shown.fitted]
    steps = sum(len(pair[1].charts) + len(pair[1].derivations) for pair in pairs if pair) + sum(
        compared
    )
    done = 0

    def one_more(note: str) -> None:
        nonlocal done
        tell(done, steps, note)
        done += 1

    libraries = [pair and _library(*pair, one_more) for pair in pairs]
    for engine, library, both in zip(
        engines, libraries, compared, strict=False
    ):  # those of the fitted engines come after
        if both and library:
            one_more(_("Spectrum, before and after"))
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
    """A tree, packed, as reproducible JSON text: `{"encoding": "gzip+base64", "data": "..."}`."""
    plain = json.dumps(tree, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return json.dumps(
        {"encoding": "gzip+base64", "data": b64encode(gzip.compress(plain, 9, mtime=0)).decode()}
    )
