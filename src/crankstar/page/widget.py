"""The page as a notebook widget: an engine that turns in a cell, its crank angle a trait.

The widget carries the exhibition with it; figures and derivations are asked of the kernel when a
panel is opened, because making them all would take a second. Needs anywidget.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from math import isfinite
from pathlib import Path, PurePath
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.files import engine_of, explicit, rewritten_by_parts
from crankstar.files.catalog import tree_of
from crankstar.files.estimate import estimated
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import one_line
from crankstar.language.shown_units import Choice, choice, read_choice, shown_in
from crankstar.page import exhibition, exhibits, figures
from crankstar.page import standalone as page
from crankstar.page.library import packed
from crankstar.remedy import fitting
from crankstar.remedy.kept import with_source

Given = Engine | str | Path
"""An engine, the name of one in the catalog, or the path of an engine file."""


def widget(engine: Given, beside: Given | None = None, *, units: str | None = None) -> Any:
    """The engine as a widget with the whole analysis; `beside` turns at the same crank angle.

    Its traits can be read, set and observed: `theta` (crank angle, degrees), `playing`, and `state`
    (camera, panels and so on, as in the address of a page: "camera=front&tab=verdict").
    `show(engine, beside)` puts other engines in the place of these. `units` are those it begins
    with, as `--units` takes them ("us", "kN, kN m"); the page offers others. Raises ImportError
    where anywidget is not installed, EngineFileError for a name or file that is none, UnitsError
    for units that are none, PageError where the front-end has not been built.

    >>> import crankstar
    >>> shown = crankstar.widget("v8-cross-plane")
    >>> shown.theta, shown.playing
    (0.0, False)
    >>> shown.theta = 90.0  # what the notebook shows follows
    """
    return _widget_class()(engine, beside, units=units)


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

        def __init__(
            self, engine: Given, beside: Given | None = None, *, units: str | None = None
        ) -> None:
            self._units = choice() if units is None else read_choice(units)
            self._subjects = _subjects(engine, beside)
            super().__init__(data=_exhibited(self._subjects, self._units))
            self.on_msg(self._answer)

        def show(self, engine: Given, beside: Given | None = None) -> None:
            """Show one engine, or two, instead of the present ones."""
            self._subjects = _subjects(engine, beside)
            self.data = _exhibited(self._subjects, self._units)

        @traitlets.validate("theta")
        def _finite(self, proposal: Mapping[str, Any]) -> float:
            if not isfinite(proposal["value"]):
                raise traitlets.TraitError(
                    _("theta is a crank angle in degrees, not {value}", value=proposal["value"])
                )
            return proposal["value"]

        def _answer(self, _widget: Any, question: Any, _buffers: Any) -> None:
            reply = answer(self._subjects, question)
            if isinstance(reply.get("value"), Subject):  # an engine for the place of another
                place = int(question["engine"])
                own = list(self._subjects)
                own[place] = reply["value"]
                self._subjects = tuple(own)
                reply["value"] = True
                self.data = _exhibited(self._subjects, self._units)
            self.send(reply)

    return EngineWidget


class Subject(NamedTuple):
    """An engine in the widget, the tree of its file, what it was asked for by."""

    engine: Engine
    tree: Mapping[str, Any]
    source: str


def _exhibited(subjects: Sequence[Subject], units: Choice) -> str:
    """The trait that sends the engines to the front end."""
    with shown_in(units):
        shown = exhibition(
            [subject.engine for subject in subjects],
            files_given=[subject.tree for subject in subjects],
            sources=[subject.source for subject in subjects],
        )
    return packed({"exhibition": shown.model_dump(mode="json")})


def _subjects(*given: Given | None) -> tuple[Subject, ...]:
    """The engines that are given."""
    subjects: list[Subject] = []
    for item in given:
        if item is None:
            continue
        if isinstance(item, Engine):
            engine, tree, source = item, explicit(item), item.name
        else:
            name, tree = tree_of(item)
            engine, source = engine_of(tree, name=name), one_line(PurePath(item).name)
        subjects.append(Subject(engine, tree, source))
    return tuple(subjects)


def answer(subjects: tuple[Subject, ...], question: Any) -> dict[str, Any]:
    """The answer to a request of the front end: its `id`, and a `value` or a `sentence`.

    A request is `{"id", "engine", "fitted", "units", "what", "key"}`, `what` being chart (to one
    scale with the other of two engines), derivation, exhibit (in these units), estimate (the engine
    with estimated masses, a Subject) or drawing (the script that draws figures).

    >>> import crankstar
    >>> from crankstar.files.catalog import tree_of
    >>> single = Subject(crankstar.load("single"), tree_of("single")[1], "single")
    >>> request = {"id": 7, "engine": 0, "fitted": False, "what": "chart", "key": "cake"}
    >>> answer((single,), request)["sentence"][:31]
    'cake: there is no such figure; '
    """
    request: dict[str, Any] = dict(question) if isinstance(question, dict) else {}
    same = {"id": request.get("id")}
    try:
        units = choice() if not request.get("units") else read_choice(str(request["units"]))
        with shown_in(units):
            place = int(request["engine"])
            beside = subjects[1 - place] if len(subjects) > 1 else None
            return {**same, "value": _made(subjects[place], request, beside)}
    except MessageError as error:
        return {**same, "sentence": str(error)}
    except (KeyError, IndexError, TypeError, ValueError):
        return {**same, "sentence": _("The notebook cannot answer this request.")}


def _made(subject: Subject, request: Mapping[str, Any], beside: Subject | None) -> Any:
    """What is asked for of an engine that may have one `beside`. Raises MessageError, KeyError."""
    engine, tree = subject.engine, subject.tree
    what, fitted = request["what"], bool(request["fitted"])
    if what == "drawing":
        return page.figures_script()
    if what == "estimate":
        done = estimated(dict(tree), name=engine.name).tree
        return Subject(engine_of(done), done, subject.source)
    if what == "exhibit":
        own = exhibits.fitted(engine, file=tree) if fitted else exhibits.exhibit(engine, file=tree)
        return None if own is None else own.model_dump(mode="json")
    over = exhibits.spread_of(engine, tree)
    if fitted:
        remedy = fitting.recommended(engine)
        if remedy is not None:
            engine = with_source(engine, remedy.after)
            tree = rewritten_by_parts(tree, engine)
            over = exhibits.spread_of(engine, tree)
    key = str(request["key"])
    if what == "chart":
        other = beside and beside.engine
        return figures.chart(engine, key, tree=tree, spread=over, beside=other)
    if what == "derivation":
        return figures.derivation(engine, key)
    raise KeyError(what)
