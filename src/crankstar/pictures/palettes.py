"""The colours of the page on light and on dark ground: the crankshaft red, the rest after Okabe."""

from __future__ import annotations

from typing import Literal, NamedTuple

ThemeName = Literal["light", "dark"]
Pair = tuple[str, str]
"""The colour of the side of a part, and of the cap that faces the eye."""


class Palette(NamedTuple):
    """Colours as `#rrggbb`; those of arrows, of letters and of the ground."""

    parts: dict[str, Pair]
    inside: str
    glass: str
    edge: str
    force: str
    couple: str
    text: str
    quiet: str
    ground: str


PALETTES: dict[ThemeName, Palette] = {
    "light": Palette(
        parts={
            "crankshaft": ("#c8352b", "#e2776a"),
            "balance shaft": ("#0c8f6c", "#67c2a8"),
            "gear": ("#b9944a", "#d9bd80"),
            "piston": ("#c3ccd4", "#dfe5ea"),
            "rod": ("#8493a3", "#a9b5c1"),
            "slave": ("#9aa7b4", "#b9c3cd"),
        },
        inside="#76828e",
        glass="#5f86a8",
        edge="#333e49",
        force="#0f6db5",
        couple="#b04f8c",
        text="#28323c",
        quiet="#66727e",
        ground="#ffffff",
    ),
    "dark": Palette(
        parts={
            "crankshaft": ("#bf3f35", "#dc8a7f"),
            "balance shaft": ("#1da27e", "#7bd0b8"),
            "gear": ("#b8954f", "#dcc48c"),
            "piston": ("#98a5b1", "#bac5cf"),
            "rod": ("#6f7f90", "#93a1af"),
            "slave": ("#8391a0", "#a5b2bf"),
        },
        inside="#4c5763",
        glass="#9cc3e4",
        edge="#0a0f14",
        force="#56b4e9",
        couple="#e08fbd",
        text="#e4e9ee",
        quiet="#9aa6b2",
        ground="#14181d",
    ),
}
