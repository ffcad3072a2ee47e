"""The whole contents of a page without a server: exhibition, figures and derivations, packed."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

from crankstar.charts.drawing import ChartError
from crankstar.derive import DerivationError
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.messages import _
from crankstar.language.shown_units import Choice, choice, read_choice, shown_in
from crankstar.mechanics.balance import balance
from crankstar.page.exhibits import advised, exhibition, in_units, remedy_tables, spread_of
from crankstar.page.figures import chart, derivation
from crankstar.page.keys import BEFORE_AND_AFTER
from crankstar.page.records import Exhibit, Exhibition
from crankstar.page.told import panels
from crankstar.remedy import fitting
from crankstar.remedy.kept import with_source

OF_FORCES = ("vector-star", "polygon", "hodograph", "over-turn", "spectrum")
"""Figures whose numbers are forces, couples or moments."""
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
    the figure `keys.BEFORE_AND_AFTER` of an engine that is fitted with something. `units` has, by
    the name of each choice of units but the present one, what differs in it: fields of the exhibits
    (`engines`, `cured`) and figures (`libraries`, `fitted`).
    """
    shown = exhibition(engines, files_given=files_given, sources=sources, command=command)
    subjects, cured = _subjects(engines, shown)
    jobs: list[_Job] = []

    def library(subject: _Subject | None, *, more: bool = False, again: bool = False) -> Tree:
        """The places of figures and derivations; `again`: those in other units alone."""
        if subject is None:
            return {"charts": {}, "derivations": {}}
        shelves: Tree = {"charts": {}, "derivations": {}}
        keys = [(key.key, key.label) for key in subject.exhibit.charts]
        keys += [(BEFORE_AND_AFTER, _("Spectrum, before and after"))] if more else []
        for key, label in keys:
            if not again or _has_units(key, subject.engine):
                own = {"tree": subject.exhibit.file, "spread": subject.spread}
                made = partial(chart, subject.engine, key, beside=subject.beside, **own)
                jobs.append(_Job(shelves["charts"], key, label, made, choice()))
        for key in () if again else subject.exhibit.derivations:
            made = partial(derivation, subject.engine, key.key)
            jobs.append(_Job(shelves["derivations"], key.key, key.label, made, choice()))
        return shelves

    whole = {
        "exhibition": shown.model_dump(mode="json"),
        "libraries": [
            library(own, more=after is not None) for own, after in zip(subjects, cured, strict=True)
        ],
        "fitted": [None if after is None else library(after) for after in cured],
        "units": {},
    }
    for offer in shown.units:
        if offer.name == shown.engines[0].units.chosen:
            continue
        with shown_in(read_choice(offer.name)):
            whole["units"][offer.name] = {
                "engines": [_differences(own) for own in subjects],
                "cured": [None if after is None else _differences(after) for after in cured],
                "libraries": [
                    library(own, more=after is not None, again=True)
                    for own, after in zip(subjects, cured, strict=True)
                ],
                "fitted": [library(after, again=True) for after in cured],
            }
    for done, job in enumerate(jobs):
        tell(done, len(jobs), job.label)
        with suppress(ChartError, DerivationError), shown_in(job.units):
            job.shelf[job.key] = job.made()
    return whole


class _Subject(NamedTuple):
    """An engine on the page, over the ranges of its estimated values; how it was fitted.

    The engine `beside` it has figures to one scale with its own.
    """

    engine: Engine
    exhibit: Exhibit
    spread: Spread | None
    fitted_from: _Subject | None = None
    beside: Engine | None = None


class _Job(NamedTuple):
    """A figure or derivation to be made: where it goes, and in which units."""

    shelf: Tree
    key: str
    label: str
    made: Callable[[], Any]
    units: Choice


def _subjects(
    engines: Sequence[Engine], shown: Exhibition
) -> tuple[list[_Subject], list[_Subject | None]]:
    """The engines of a page, and each with what is recommended."""
    subjects = [
        _Subject(engine, exhibit, spread_of(engine, exhibit.file))
        for engine, exhibit in zip(engines, shown.engines, strict=True)
    ]
    cured = [_cured(subject, after) for subject, after in zip(subjects, shown.fitted, strict=True)]
    if len(subjects) == 1:
        return subjects, cured
    after = [(fitted or own).engine for own, fitted in zip(subjects, cured, strict=True)]
    return (
        [
            own._replace(beside=other.engine)
            for own, other in zip(subjects, reversed(subjects), strict=True)
        ],
        [
            own and own._replace(beside=other)
            for own, other in zip(cured, reversed(after), strict=True)
        ],
    )


def _cured(subject: _Subject, after: Exhibit | None) -> _Subject | None:
    """The engine with what is recommended."""
    remedy = fitting.recommended(subject.engine)
    if remedy is None or after is None:
        return None
    engine = with_source(subject.engine, remedy.after)
    return _Subject(engine, after, spread_of(engine, after.file), subject)


def _has_units(key: str, engine: Engine) -> bool:
    """Whether a figure may have numbers in other units: forces in newtons, lengths."""
    figure = key.split(":")[0]
    if figure == "shaft":
        return "pitch" not in engine.relative
    if any(figure in panel.figures for panel in panels()):
        return True
    if figure == "torsion-response":
        return "quantity=stress" in key
    return figure in OF_FORCES and balance(engine, speed=engine.speed).speed is not None


def _differences(subject: _Subject) -> Tree:
    """What of an exhibit is other in the units of the context."""
    parts: Tree = in_units(
        subject.engine,
        subject.spread,
        tree=subject.exhibit.file,
        relatives=subject.fitted_from is None,
    )
    if subject.fitted_from is not None:
        before = subject.fitted_from
        parts["remedies"] = remedy_tables(before.engine, advised, before.spread)
    own = Exhibit.model_construct(**parts).model_dump(mode="json", include={*parts})
    known = subject.exhibit.model_dump(mode="json", include={*parts})
    return {key: value for key, value in own.items() if value != known[key]}


def packed(tree: Tree) -> str:
    """A tree, packed, as reproducible JSON text: `{"encoding": "gzip+base64", "data": "..."}`."""
    plain = json.dumps(tree, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return json.dumps(
        {"encoding": "gzip+base64", "data": b64encode(gzip.compress(plain, 9, mtime=0)).decode()}
    )
