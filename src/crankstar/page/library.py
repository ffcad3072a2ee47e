"""The whole contents of a page without a server: exhibition, figures and derivations, packed."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
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
    jobs: list[tuple[Tree, Engine, str, str, Callable[[Engine, str], Any]]] = []

    def library(engine: Engine, exhibit: Exhibit) -> Tree:
        charts, derivations = {}, {}
        jobs.extend((charts, engine, key.key, key.label, chart) for key in exhibit.charts)
        jobs.extend(
            (derivations, engine, key.key, key.label, derivation) for key in exhibit.derivations
        )
        return {"charts": charts, "derivations": derivations}

    libraries = [library(*pair) for pair in zip(engines, shown.engines, strict=True)]
    fitted: list[Tree | None] = []
    for engine, after, own in zip(engines, shown.fitted, libraries, strict=True):
        remedy = fitting.recommended(engine)
        fitted.append(library(remedy.after, after) if remedy and after else None)
        if after:
            label = _("Spectrum, before and after")
            jobs.append((own["charts"], engine, BEFORE_AND_AFTER, label, chart))
    for done, (shelf, engine, key, label, made) in enumerate(jobs):
        tell(done, len(jobs), label)
        with suppress(ChartError, DerivationError):
            shelf[key] = made(engine, key)
    exhibition_tree = shown.model_dump(mode="json")
    return {"exhibition": exhibition_tree, "libraries": libraries, "fitted": fitted}


def packed(tree: Tree) -> str:
    """A tree, packed, as reproducible JSON text: `{"encoding": "gzip+base64", "data": "..."}`."""
    plain = json.dumps(tree, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return json.dumps(
        {"encoding": "gzip+base64", "data": b64encode(gzip.compress(plain, 9, mtime=0)).decode()}
    )
