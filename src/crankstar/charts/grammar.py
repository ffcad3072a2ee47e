"""Vega-Lite as plain data: layers of rows with a mark and its channels, and the chart they make.

https://vega.github.io/vega-lite/docs/spec.html says what it all means; nothing is checked here.
Altair writes the same data in the same words, but takes half a second to load: it is asked only
where a notebook has chosen one of its renderers.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crankstar.charts.fonts import registered

SCHEMA = "https://vega.github.io/schema/vega-lite/v6.json"
VEGA_LITE = "application/vnd.vegalite.v6+json"
"""What notebooks call it, those that draw it themselves."""
KINDS = {"Q": "quantitative", "N": "nominal", "O": "ordinal"}
Channel = dict[str, Any]


def field(name: str, **options: Any) -> Channel:
    """A channel for a field of the rows, its kind after a colon; the end of a span has none.

    >>> field("length:Q", title=None), field("end")
    ({'field': 'length', 'type': 'quantitative', 'title': None}, {'field': 'end'})
    """
    name, _, kind = name.partition(":")
    return {"field": name, **({"type": KINDS[kind]} if kind else {}), **options}


def own(name: str) -> Channel:
    """A channel whose values are in the rows as they are drawn: a colour, px, degrees."""
    return field(name, scale=None)


def span(*ends: float) -> dict[str, Any]:
    """A scale from its lower to its upper end exactly."""
    return {"domain": list(ends), "nice": False}


def constant(value: Any) -> Channel:
    """A channel that is the same for all rows: a colour, a text, px."""
    return {"value": value}


@dataclass(frozen=True)
class Layer:
    """Rows of data drawn with one mark; each method gives a layer with one more part."""

    spec: Mapping[str, Any]

    def calculate(self, **formulas: str) -> Layer:
        """With fields worked out from others, one after the other, in Vega's expressions."""
        made = [{"calculate": formula, "as": name} for name, formula in formulas.items()]
        return Layer({**self.spec, "transform": [*self.spec.get("transform", ()), *made]})

    def mark(self, kind: str, **style: Any) -> Layer:
        """With a mark: bar, line, point, rect, rule or text."""
        return Layer({**self.spec, "mark": {"type": kind, **style}})

    def encode(self, **channels: Channel | Sequence[Channel]) -> Layer:
        """With what is shown of each row: where, in which colour, how large."""
        return Layer({**self.spec, "encoding": channels})


def of_rows(rows: Sequence[Mapping[str, Any]]) -> Layer:
    """A layer of rows of data, without a mark."""
    return Layer({"data": {"values": list(rows)}})


COLOUR = own("colour:N")
"""The colour of each row."""
DISC = {"shape": "circle", "filled": True, "opacity": 1}
"""The style of a point that is a dot."""


@dataclass(frozen=True)
class Chart:
    """A figure as Vega-Lite; a notebook shows it with the help of Altair.

    `notes` are the sentences on what its numbers rest on; its `usermeta` has them for machines.
    `lacking` says why nothing is drawn, where it shows no more than that.
    """

    spec: Mapping[str, Any]
    notes: tuple[str, ...] = ()
    lacking: str = ""

    def to_dict(self) -> dict[str, Any]:
        """The figure as a tree that can be written as JSON."""
        return {"$schema": SCHEMA, **self.spec}

    def to_altair(self) -> Any:
        """The same figure as an Altair chart, to be changed, saved or put beside others.

        Altair compares every part with the schema, which takes seconds for a large figure.
        """
        import altair

        return altair.Chart.from_dict(self.to_dict())

    def save(self, path: str | Path, *, title: str = "") -> None:
        """Write it as a file: SVG, PNG, PDF, HTML or JSON by the end of its name.

        `title` is the text for readers who cannot see it. Raises ChartError for another name.
        """
        from importlib import import_module

        saving = import_module("crankstar.charts.saving")  # which is made of this module
        place = Path(path)
        place.write_bytes(saving.saved(self, place.suffix, title=title))

    def _repr_mimebundle_(self, *_: Any, **__: Any) -> Any:
        """The figure in a notebook, without a network: as Vega-Lite where that is known, else SVG.

        A renderer that was chosen for Altair (`altair.renderers.enable("html")`) draws it instead.
        """
        altair = sys.modules.get("altair")  # whoever has chosen a renderer has loaded it
        if altair is not None and altair.renderers.active != "default":
            renderer = altair.renderers.get()
            return renderer(self.to_dict()) if renderer else {}
        import vl_convert

        registered()
        tree = self.to_dict()
        return {VEGA_LITE: tree, "image/svg+xml": vl_convert.vegalite_to_svg(tree)}
