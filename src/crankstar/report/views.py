"""The engine itself in a report: the pictures of `crankstar draw`, on the ground of the page."""

from __future__ import annotations

from crankstar.engine.engine import Engine
from crankstar.pictures.drawings import Picture, drawing
from crankstar.pictures.palettes import PALETTES

SHEET = Picture(view="sheet", width=660, height=440, arrows=(), heading=False, ground=False)
"""Front, side and plan to one scale, and the engine as it stands."""
FRONT_PAGE = Picture(width=660, height=270, arrows=(), heading=False, ground=False)
"""The engine as it stands, on the front page."""


def view(engine: Engine, picture: Picture) -> str:
    """The engine at theta = 0 as SVG; letters take the colour of the page."""
    palette = PALETTES[picture.theme]
    letters = f'fill="{palette.text}"'
    quiet = f'fill="{palette.quiet}"'
    drawn = drawing(engine, picture)
    return drawn.replace(letters, 'fill="currentColor"').replace(quiet, 'fill="currentColor"')
