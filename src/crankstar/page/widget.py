"""The page as a notebook widget: an engine that turns in a cell, its crank angle a trait.

The widget carries the exhibition with it; figures and derivations are asked of the kernel when a
panel is opened, because making them all would take a second. Needs anywidget.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from math import isfinite
from pathlib import Path, PurePath
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.files import engine_of, explicit
from crankstar.files.catalog import tree_of
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import one_line
from crankstar.page import exhibition, figures
from crankstar.page import standalone as page
from crankstar.page.library import packed
from crankstar.remedy import fitting

Given = Engine | str | Path
"""An engine, the name of one in the catalog, or the path of an engine file."""


def widget(engine: Given, beside: Given | None = None) -> Any:
    """The engine as a widget with the whole analysis; `beside` turns at the same crank angle.

    Its traits can be read, set and observed: `theta` (crank angle, degrees), `playing`, and `state`
    (camera, panels and so on, as in the address of a page: "camera=front&tab=verdict").
    `show(engine, beside)` puts other engines in the place of these. Raises ImportError where
    anywidget is not installed, EngineFileError for a name or file that is none, PageError where the
    front-end has not been built.

    >>> import crankstar
    >>> shown = crankstar.widget("v8-cross-plane")
    >>> shown.theta, shown.playing
    (0.0, False)
    >>> shown.theta = 90.0  # what the notebook shows follows
    """
    return _widget_class()(engine, beside)


@cache
def _widget_class() -> type[Any]:
    """The class of all widgets, made when anywidget is first needed."""
    try:
        import anywidget
        import traitlets
    except ImportError as error:
        raise ImportError(
            _(
                'the notebook widget needs anywidget ({error}): pip install "crankstar[widget]"',
                error=error,
            )
        ) from None

    class EngineWidget(anywidget.AnyWidget):
        """One engine, or two side by side, in a cell."""

        _esm = page.bundle()
        data = traitlets.Unicode().tag(sync=True)
        state = traitlets.Unicode().tag(sync=True)
        theta = traitlets.Float(0.0).tag(sync=True)
        playing = traitlets.Bool(False).tag(sync=True)

        def __init__(self, engine: Given, beside: Given | None = None) -> None:
            self._engines, exhibited = _exhibited(engine, beside)
            super().__init__(data=exhibited)
            self.on_msg(self._answer)

        def show(self, engine: Given, beside: Given | None = None) -> None:
            """Show one engine, or two, instead of the present ones."""
            self._engines, self.data = _exhibited(engine, beside)

        @traitlets.validate("theta")
        def _finite(self, proposal: Mapping[str, Any]) -> float:
            if not isfinite(proposal["value"]):
                raise traitlets.TraitError(
                    _("theta is a crank angle in degrees, not {value}", value=proposal["value"])
                )
            return proposal["value"]

        def _answer(self, _widget: Any, question: Any, _buffers: Any) -> None:
            self.send(answer(self._engines, question))

    return EngineWidget


def _exhibited(*given: Given | None) -> tuple[tuple[Engine, ...], str]:
    """The engines, and the trait that sends them to the front end."""
    engines: list[Engine] = []
    trees: list[Mapping[str, Any]] = []
    sources: list[str] = []
    for item in given:
        if item is None:
            continue
        if isinstance(item, Engine):
            engine, tree, source = item, explicit(item), item.name
        else:
            name, tree = tree_of(item)
            engine, source = engine_of(tree, name=name), one_line(PurePath(item).name)
        engines.append(engine)
        trees.append(tree)
        sources.append(source)
    shown = exhibition(engines, files_given=trees, sources=sources)
    return tuple(engines), packed({"exhibition": shown.model_dump(mode="json")})


def answer(engines: tuple[Engine, ...], question: Any) -> dict[str, Any]:
    """The answer to a request of the front end: its `id`, and a `value` or a `sentence`.

    A request is `{"id", "engine", "fitted", "what": "chart" or "derivation", "key"}`.

    >>> import crankstar
    >>> single = crankstar.load("single")
    >>> request = {"id": 7, "engine": 0, "fitted": False, "what": "chart", "key": "cake"}
    >>> answer((single,), request)["sentence"][:31]
    'cake: there is no such figure; '
    """
    request: dict[str, Any] = dict(question) if isinstance(question, dict) else {}
    same = {"id": request.get("id")}
    makers = {"chart": figures.chart, "derivation": figures.derivation}
    try:
        engine = engines[int(request["engine"])]
        if request["fitted"]:
            fitted = fitting.recommended(engine)
            engine = engine if fitted is None else fitted.after
        return {**same, "value": makers[request["what"]](engine, str(request["key"]))}
    except MessageError as error:
        return {**same, "sentence": str(error)}
    except (KeyError, IndexError, TypeError, ValueError):
        return {**same, "sentence": _("The notebook cannot answer this request.")}
