"""The page as a widget of a notebook: an engine that turns in a cell, and whose angle the cells can read and set.

The widget carries the exhibition with it; figures and derivations are asked of the kernel when a panel is opened, because
drawing them all would take seconds. Needs anywidget and, for the figures, Altair and vl-convert.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from math import isfinite
from pathlib import Path, PurePath
from typing import Any

from crankstar import fitting, page
from crankstar.catalog import tree_of
from crankstar.charts.drawing import ChartError
from crankstar.derive import DerivationError
from crankstar.engine import Engine
from crankstar.exhibit import exhibition, figures
from crankstar.exhibit.library import packed
from crankstar.files import engine_of, explicit
from crankstar.quantity import one_line

Given = Engine | str | Path
"""An engine, the name of one in the catalog, or the path of an engine file."""


def widget(engine: Given, beside: Given | None = None) -> Any:
    """The engine as something a notebook shows: it turns, with the whole analysis; `beside` turns at the same crank angle.

    Its traits can be read, set and observed: `theta` (crank angle, degrees), `playing`, and `state` (camera, panels and so on,
    as in the address of a page: "camera=front&tab=verdict"). `show(engine, beside)` puts other engines in the place of these.
    Raises ImportError where anywidget is not installed, EngineFileError for a name or file that is none, PageError where the
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
        raise ImportError(f'an engine in a notebook needs anywidget ({error}): pip install "crankstar[widget]"') from None

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
            """Puts one engine, or two, in the place of what is shown."""
            self._engines, self.data = _exhibited(engine, beside)

        @traitlets.validate("theta")
        def _finite(self, proposal: Mapping[str, Any]) -> float:
            if not isfinite(proposal["value"]):
                raise traitlets.TraitError(f"theta is a crank angle in degrees, not {proposal['value']}")
            return proposal["value"]

        def _answer(self, _widget: Any, question: Any, _buffers: Any) -> None:
            self.send(answer(self._engines, question))

    return EngineWidget


def _exhibited(*given: Given | None) -> tuple[tuple[Engine, ...], str]:
    """The engines, and the trait that tells the front-end of them."""
    engines: list[Engine] = []
    trees: list[Mapping[str, Any]] = []
    sources: list[str] = []
    for one in given:
        if one is None:
            continue
        if isinstance(one, Engine):
            engine, tree, source = one, explicit(one), one.name
        else:
            name, tree = tree_of(one)
            engine, source = engine_of(tree, name=name), one_line(PurePath(one).name)
        engines.append(engine)
        trees.append(tree)
        sources.append(source)
    shown = exhibition(engines, files_given=trees, sources=sources)
    return tuple(engines), packed({"exhibition": shown.model_dump(mode="json")})


def answer(engines: tuple[Engine, ...], question: Any) -> dict[str, Any]:
    """What a front-end asks of the kernel: `{"id", "engine", "fitted", "what": "chart" or "derivation", "key"}`.

    The answer has the same id, and `value`, or `sentence` if there is none.

    >>> import crankstar
    >>> single = crankstar.load("single")
    >>> answer((single,), {"id": 7, "engine": 0, "fitted": False, "what": "chart", "key": "cake"})["sentence"][:31]
    'cake: there is no such figure; '
    """
    told: dict[str, Any] = dict(question) if isinstance(question, dict) else {}
    same = {"id": told.get("id")}
    makers = {"chart": figures.chart, "derivation": figures.derivation}
    try:
        engine = engines[int(told["engine"])]
        if told["fitted"]:
            found = fitting.recommended(engine)
            engine = engine if found is None else found.after
        return {**same, "value": makers[told["what"]](engine, str(told["key"]))}
    except ImportError as error:
        return {**same, "sentence": f'Figures are drawn with Altair and vl-convert ({error}): pip install "crankstar[charts]"'}
    except (ChartError, DerivationError, figures.NoSuchKeyError) as error:
        return {**same, "sentence": str(error)}
    except (KeyError, IndexError, TypeError, ValueError):
        return {**same, "sentence": "This is not a question that the notebook understands."}
