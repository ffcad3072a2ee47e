"""Small pictures of an engine for a gallery: standing still and turning, light and dark."""

from __future__ import annotations

import io
from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.pictures.drawings import Picture, drawings
from crankstar.pictures.films import Pace, rasters, written
from crankstar.pictures.motions import turns_of
from crankstar.pictures.palettes import PALETTES, ThemeName

SIZE = (240, 180)
"""px."""
PACE = Pace(seconds=2.0, rate=9.0)
MOST_TURNS = 2
"""Of a miniature; an engine whose shafts come together later is seen for one turn."""
LARGEST = 60_000
"""Bytes."""
QUALITIES = (55, 40, 28, 18, 8)
"""Of WebP: the first with which a miniature is not too large."""
STILL_QUALITY = 80
STILL_AT = 0.9
"""Crank angle of a picture that stands still, radians: few parts are hidden."""


class Look(NamedTuple):
    """Which miniature: in which colours, and whether it turns."""

    theme: ThemeName
    turning: bool

    @property
    def suffix(self) -> str:
        """What the name of its file ends with.

        >>> Look("dark", True).suffix
        '-dark-turning.webp'
        """
        return f"-{self.theme}{'-turning' * self.turning}.webp"


LOOKS = tuple(Look(theme, turning) for turning in (False, True) for theme in PALETTES)


def miniature(engine: Engine, look: Look) -> bytes:
    """A miniature as WebP, of at most `LARGEST` bytes."""
    how = Picture(width=SIZE[0], height=SIZE[1], theme=look.theme, arrows=(), letters=False)
    if not look.turning:
        file = io.BytesIO()
        next(rasters(drawings(engine, [STILL_AT], how))).save(file, "WEBP", quality=STILL_QUALITY)
        return file.getvalue()
    angles, times = PACE.angles(engine), PACE.times(engine)
    if turns_of(engine) > MOST_TURNS:
        count = len(angles) // turns_of(engine)
        angles, times = angles[:count], times[:count]
    shown = list(rasters(drawings(engine, angles, how)))
    content = b""
    for quality in QUALITIES:
        content = written(shown, "webp", times, quality=quality)
        if len(content) <= LARGEST:
            break
    return content
