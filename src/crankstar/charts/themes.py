"""The colours of a figure on a light and on a dark screen and on paper.

Figures are drawn in the colours of `drawing`, each of which has its place in every theme. All of
a theme have a contrast of at least 4.5 to 1 with its ground, as text needs after WCAG 2.2, 1.4.3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

from crankstar.charts.drawing import (
    BLUE,
    DEEP,
    GREEN,
    GREY,
    ORANGE,
    PALE,
    PURPLE,
    SKY,
    VERMILION,
    ChartError,
)
from crankstar.charts.grammar import Chart
from crankstar.language.messages import _

ThemeName = Literal["light", "dark", "print"]


@dataclass(frozen=True)
class Theme:
    """The colour of the ground, and a colour for each of those of `drawing`.

    `fills` lie below letters, which have their contrast with them.
    """

    ground: str
    colours: Mapping[str, str]
    fills: Mapping[str, str]


_LIGHT = {
    GREY: "#4d5660",
    BLUE: "#0b6aa8",
    VERMILION: "#b84900",
    GREEN: "#00714f",
    ORANGE: "#8f5d00",
    PURPLE: "#a13d76",
    SKY: "#1b7291",
}
_FILLS = {PALE: "#f4f8fb", DEEP: "#b3d2ea"}
THEMES = {
    "light": Theme("#ffffff", _LIGHT, _FILLS),
    "dark": Theme(
        "#14191f",
        {
            GREY: "#b4bdc6",
            BLUE: "#6cb4ee",
            VERMILION: "#ff8a4d",
            GREEN: "#3fc79d",
            ORANGE: "#f0b43c",
            PURPLE: "#e79ac8",
            SKY: "#8fd6ff",
        },
        {PALE: "#1a2129", DEEP: "#1d4566"},
    ),
    "print": Theme(
        "#ffffff", {**_LIGHT, GREY: "#000000", BLUE: "#004f86", VERMILION: "#a33c00"}, _FILLS
    ),
}
"""By name. `print` has black letters and lines, and darker colours."""


def themed(chart: Chart, name: ThemeName) -> Chart:
    """A figure in the colours of a theme, on its ground. Raises ChartError."""
    if name not in THEMES:
        raise ChartError(
            _(
                "there is no theme {theme}; give one of {themes}",
                theme=repr(name),
                themes=", ".join(get_args(ThemeName)),
            )
        )
    theme = THEMES[name]
    spec = _recoloured(chart.spec, {**theme.colours, **theme.fills})
    return replace(chart, spec={**spec, "background": theme.ground})


def recoloured(drawing: str, name: ThemeName) -> str:
    """A drawing as SVG in the colours of a theme.

    >>> recoloured('<path fill="#808080"/>', "print")
    '<path fill="#000000"/>'
    """
    for colour, own in THEMES[name].colours.items():
        drawing = drawing.replace(colour, own)
    return drawing


def _recoloured(value: Any, colours: Mapping[str, str]) -> Any:
    if isinstance(value, str):
        return colours.get(value, value)
    if isinstance(value, Mapping):
        return {key: _recoloured(inner, colours) for key, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_recoloured(inner, colours) for inner in value]
    return value
