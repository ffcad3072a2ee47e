"""The errata of the sources as tables for the terminal: the short form of the page in the documents."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType

from crankstar.derive.typeset import text
from crankstar.errata import Erratum, sources
from crankstar.wording import table, titled

TITLES = {"results": ("result", "series", "angle"), "steps on the way to them": ("step",), "lines that do not follow": ("line",)}
"""Headings of the tables, and the kinds of errata under each."""
COLUMNS = ("of what", "printed", "true")


def errata_tables(found: Sequence[Erratum]) -> RenderableType:
    """What is printed beside what is true, source by source: results, the steps on the way, slips of the pen."""
    blocks: list[RenderableType] = []
    for source in dict.fromkeys(one.source for one in found):
        own = [one for one in found if one.source == source]
        for title, kinds in TITLES.items():
            rows = [one for one in own if one.kind in kinds]
            if not rows:
                continue
            out = table(*COLUMNS, left=COLUMNS, folded=COLUMNS[:2])
            for one in rows:
                side = f", {one.component}" if one.component in ("up", "right") else ""
                out.add_row(one.title + side, one.text, text(one.ours))
            blocks.append(titled(f"{sources()[source]} ({source}): {title}", out))
    return Group(*blocks)
