"""Tasks of worker processes: an engine and a question about it, to the answer as JSON.

An engine is a name of the catalog or a tree of keys; no file is opened by a name from outside.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache, partial
from typing import Any

from pydantic import BaseModel

from crankstar import files
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, catalog
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import MessageError
from crankstar.language.shown_units import read_choice, shown_in
from crankstar.page import exhibits
from crankstar.page.form_words import form_schema
from crankstar.page.records import Exhibit
from crankstar.remedy import fitting
from crankstar.server.refusal import Refused, refused
from crankstar.stars.faults import SearchError

Tree = dict[str, Any]
ENGINE = "the engine"
KEPT = 64
"""Engines that a process keeps at hand."""


@contextmanager
def mistakes_refused(at: str = "") -> Iterator[None]:
    """Turn the mistakes of a question into a refusal; `at` is the path of those without one."""
    try:
        yield
    except (EngineFileError, EngineError, SearchError) as error:
        raise Refused(422, error.faults) from None
    except MessageError as error:
        path = (at,) if at else ()
        lines = str(error).split("\n")
        raise Refused(422, [Fault(path, "request", {"sentence": line}) for line in lines]) from None


def answered(value: Any) -> bytes:
    """An answer as JSON, in ASCII."""
    return json.dumps(value, allow_nan=False, separators=(",", ":")).encode("ascii")


def catalog_tree(name: str, *, status: int = 404, at: str = "") -> Tree:
    """The tree of an engine of the catalog; no other file is looked for. Raises Refused."""
    if name not in catalog.names():
        raise Refused(status, [catalog.unknown_name(name, path=(at,) if at else ())])
    return catalog.tree_of(name)[1]


@contextmanager
def units_of(text: str | None) -> Iterator[None]:
    """Have an answer in these units; None: those of the server. Raises Refused."""
    if text is None:
        yield
        return
    with mistakes_refused(at="units"):
        units = read_choice(text)
    with shown_in(units):
        yield


def engine_of(engine: str | Tree, *, at: str = "engine") -> tuple[Engine, Tree]:
    """An engine that is asked about, and its tree. Raises EngineFileError, Refused."""
    tree = engine if isinstance(engine, dict) else catalog_tree(engine, status=422, at=at)
    return _kept(json.dumps(tree)), tree


@lru_cache(maxsize=KEPT)
def _kept(text: str) -> Engine:
    return files.engine_of(json.loads(text), name=ENGINE)


def exhibit(engine: str | Tree, units: str | None = None) -> bytes:
    """All that the page shows of an engine, but for its neighbours in the catalog, which take long.

    Raises Refused.
    """
    with mistakes_refused(), units_of(units):
        return _json(_exhibit(engine))


def _exhibit(engine: str | Tree) -> Exhibit:
    made, tree = engine_of(engine)
    return exhibits.exhibit(made, file=tree, relatives=False)


def _json(record: BaseModel) -> bytes:
    return record.model_dump_json().encode("utf-8")


def opening(engine: str | Tree, shown: str, command: str) -> bytes:
    """What the page opens with: an engine, its name as given, the command of the server.

    Raises Refused.
    """
    with mistakes_refused():
        return _json(exhibits.opening([_exhibit(engine)], [None], sources=[shown], command=command))


def chart(
    engine: str | Tree, key: str, units: str | None = None, beside: str | Tree | None = None
) -> bytes:
    """A figure by its key, as Vega-Lite, to one scale with an engine beside. Raises Refused."""
    from crankstar.page import figures

    with mistakes_refused(at="key"), units_of(units):
        made, tree = engine_of(engine)
        over = exhibits.spread_of(made, tree)
        other = None if beside is None else _beside(beside)
        return answered(figures.chart(made, key, tree=tree, spread=over, beside=other))


def _beside(engine: str | Tree) -> Engine:
    """A second engine of a question; its mistakes are told apart from those of the first."""
    try:
        return engine_of(engine, at="beside")[0]
    except EngineFileError as error:
        faults = [fault._replace(path=("beside", *fault.path)) for fault in error.faults]
        raise Refused(422, faults) from None


def derivation(engine: str | Tree, key: str) -> bytes:
    """A derivation by its key, as HTML. Raises Refused."""
    from crankstar.page import figures

    with mistakes_refused(at="key"):
        made, _ = engine_of(engine)
        return answered({"html": figures.derivation(made, key)})


def fitted(engine: str | Tree, options: dict[str, Any], units: str | None = None) -> bytes:
    """An engine with weights and balance shafts as an exhibit, or null. Raises Refused."""
    with mistakes_refused(), units_of(units):
        made, tree = engine_of(engine)
        bare = bool(options.get("bare"))
        chosen = {name: value for name, value in options.items() if name != "bare"}
        fit = partial(_fitted, **chosen) if chosen else exhibits.advised
        exhibit = exhibits.fitted_with(made, partial(fit, bare=bare), file=tree)
        return b'{"exhibit":' + (b"null" if exhibit is None else _json(exhibit)) + b"}"


def _fitted(
    engine: Engine,
    *,
    bare: bool,
    factor: float | None = None,
    weights: Any = None,
    shafts: Any = "none",
) -> exhibits.Done | None:
    """An engine with what was asked for.

    Counterweights of a factor, shafts that are needed then.
    """
    after = engine
    if factor is not None or weights is not None:
        after = fitting.by_factor(
            after,
            factor=fitting.FACTORS[0] if factor is None else factor,
            weights=weights or "webs",
            bare=bare,
        )
    if shafts != "none":
        after = fitting.with_shafts(after, ratios=shafts, places=fitting.ShaftPlaces())
    if after is engine:
        return None
    return exhibits.Done(after, factor)


def workshop(engine: str | Tree, cylinders: int | None) -> bytes:
    """What can be changed in an engine, with another number of cylinders if one is given.

    Raises Refused.
    """
    from crankstar.page.workshop import workshop

    with mistakes_refused():
        tree = engine_of(engine)[1]
        return _json(workshop(tree, cylinders=cylinders))


def sliders(engine: str | Tree, units: str | None = None) -> bytes:
    """The curves behind the sliders of an engine. Raises Refused."""
    from crankstar.page.sliders import sliders
    from crankstar.page.workshop_records import SlidersShown

    with mistakes_refused(), units_of(units):
        tree = engine_of(engine)[1]
        return _json(SlidersShown(sliders=sliders(tree, name=ENGINE)))


def presets() -> bytes:
    """The usual layouts to begin with."""
    from crankstar.page.workshop import presets

    return answered([preset.model_dump(mode="json") for preset in presets()])


def toml(engine: str | Tree) -> bytes:
    """An engine file in TOML.

    Raises Refused where it is no engine, or its TOML would not be read back the same.
    """
    with mistakes_refused():
        made, tree = engine_of(engine)
        try:
            text = files.tree_text(_without_nothing(tree))
        except (TypeError, ValueError):
            text = files.toml(made)
        if files.engine_of(files.tree_of(text)) != made:
            text = files.toml(made)
        return answered({"toml": text})


def _without_nothing(value: Any) -> Any:
    """A tree without what is null, which TOML does not have."""
    if isinstance(value, Mapping):
        return {key: _without_nothing(item) for key, item in value.items() if item is not None}
    return [_without_nothing(item) for item in value] if isinstance(value, list) else value


def read(text: str) -> bytes:
    """The tree of an engine file's text, TOML or JSON, checked to be an engine; raises Refused."""
    if not text.strip():
        raise refused(422, "question.no-text", "text")
    if text.startswith("PK\x03\x04"):
        raise refused(422, "question.spreadsheet", "text")
    # what a browser reads of a file in no text: control characters, letters it could not decode
    if "\0" in text or "\ufffd" in text:
        raise refused(422, "question.no-text-file", "text")
    with mistakes_refused():
        tree = files.tree_of(text.removeprefix("\ufeff"), name=ENGINE)
        files.engine_of(tree, name=ENGINE)
        return answered({"tree": tree})


def explicit(engine: str | Tree) -> bytes:
    """The tree of an engine in the explicit form: every shaft, throw, weight and cylinder.

    Raises Refused.
    """
    with mistakes_refused():
        made, _ = engine_of(engine)
        return answered({"tree": files.part_by_part(made)})


def estimate(engine: str | Tree) -> bytes:
    """The tree of an engine whose missing masses and lengths are estimated. Raises Refused."""
    from crankstar.files.estimate import estimated

    with mistakes_refused():
        tree = engine_of(engine)[1]
        return answered({"tree": estimated(tree, name=ENGINE).tree})


def schema() -> bytes:
    """The JSON Schema of engine files, its words in the language of the server."""
    return answered(form_schema())


def summaries() -> bytes:
    """What there is in the catalog."""
    return answered([entry._asdict() for entry in catalog.summaries()])


def catalog_answer(name: str) -> bytes:
    """The tree of an engine of the catalog. Raises Refused."""
    return answered(catalog_tree(name))
