"""An engine that turns as a film that loops without a seam: GIF, WebP, animated PNG or MP4.

A film shows one cycle of all shafts: its last picture is as far from its first as any two others.
Pillow writes GIF, WebP and PNG, imageio-ffmpeg MP4; they come with `pip install "crankstar[film]"`.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise
from math import pi
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.pictures.drawings import Picture, drawings
from crankstar.pictures.motions import turns_of

FILMS = ("gif", "webp", "png", "mp4")
"""Formats of films, as the names of files end."""
STILLS = ("svg", "png", "pdf")
QUALITY = 82
"""Of WebP, to 100."""
COLOURS = 256
"""Of a GIF, the same in all its pictures."""
SAMPLES = 6
"""Pictures of a film from which the colours of a GIF are taken."""
Tell = Callable[[int, int], None]
"""Called with the pictures drawn and all pictures."""


class Pace(NamedTuple):
    """How long a turn of the first shaft takes, s, and pictures in a second."""

    seconds: float = 3.0
    rate: float = 25.0

    def angles(self, engine: Engine) -> list[float]:
        """The crank angles of the pictures of one cycle of all shafts, radians, equally far apart.

        >>> from crankstar.files.catalog import load
        >>> [round(angle, 3) for angle in Pace(1.0, 4.0).angles(load("i4"))]
        [0.0, 1.571, 3.142, 4.712]
        """
        turns = turns_of(engine)
        count = max(2, round(turns * self.seconds * self.rate))
        return [2 * pi * turns * index / count for index in range(count)]

    def times(self, engine: Engine, *, step: int = 1) -> list[int]:
        """How long each picture stands, ms, in steps of so many; together the whole cycle."""
        count = len(self.angles(engine))
        whole = 1000 * turns_of(engine) * self.seconds / step
        ends = [round(whole * index / count) for index in range(count + 1)]
        return [step * (after - before) for before, after in pairwise(ends)]


def film(
    engine: Engine, kind: str, *, picture: Picture, pace: Pace, tell: Tell = lambda _done, _of: None
) -> bytes:
    """The film as the contents of a file of one of the kinds `FILMS`."""
    if kind == "mp4":  # of an even width and height
        picture = replace(
            picture,
            width=picture.width + picture.width % 2,
            height=picture.height + picture.height % 2,
        )
    angles = pace.angles(engine)
    shown = _told(rasters(drawings(engine, angles, picture)), len(angles), tell)
    if kind == "mp4":
        rate = len(angles) / (turns_of(engine) * pace.seconds)
        return _mp4(shown, (picture.width, picture.height), rate)
    return written(list(shown), kind, pace.times(engine, step=10 if kind == "gif" else 1))


def still(svg: str, kind: str) -> bytes:
    """A drawing as the contents of a file of one of the kinds `STILLS`."""
    if kind == "svg":
        return svg.encode()
    import vl_convert

    from crankstar.charts.fonts import registered

    registered()
    return vl_convert.svg_to_png(svg, scale=1) if kind == "png" else vl_convert.svg_to_pdf(svg)


def rasters(svgs: Iterable[str]) -> Iterator[Any]:
    """Drawings as pictures of Pillow."""
    import vl_convert
    from PIL import Image

    from crankstar.charts.fonts import registered

    registered()
    for svg in svgs:
        yield Image.open(io.BytesIO(vl_convert.svg_to_png(svg, scale=1))).convert("RGB")


def written(
    shown: Sequence[Any], kind: str, times: Sequence[int], *, quality: int = QUALITY
) -> bytes:
    """Pictures of Pillow one after the other as a GIF, a WebP or a PNG, for ever."""
    if kind == "gif":
        palette = _palette(shown)
        shown = [each.quantize(palette=palette, dither=0) for each in shown]
    options: dict[str, Any] = {
        "gif": {"disposal": 1, "optimize": False},
        "webp": {"quality": quality, "method": 4},
        "png": {"default_image": False},
    }[kind]
    file = io.BytesIO()
    shown[0].save(
        file,
        kind.upper(),
        save_all=True,
        append_images=shown[1:],
        duration=list(times),
        loop=0,
        **options,
    )
    return file.getvalue()


def _palette(shown: Sequence[Any]) -> Any:
    """The colours of some of the pictures, so that they do not flicker from one to the next."""
    from PIL import Image

    some = shown[:: max(1, len(shown) // SAMPLES)]
    wide, high = some[0].size
    strip: Any = Image.new("RGB", (wide, high * len(some)))
    for index, each in enumerate(some):
        strip.paste(each, (0, high * index))
    ground = strip.getpixel((0, 0))
    known: Any = strip.quantize(COLOURS - 1)
    known.putpalette([*known.getpalette()[: 3 * (COLOURS - 1)], *ground])
    return known


def _mp4(shown: Iterable[Any], size: tuple[int, int], rate: float) -> bytes:
    """A film in H.264, which every browser and telephone plays."""
    import imageio_ffmpeg

    with TemporaryDirectory() as folder:
        place = Path(folder) / "film.mp4"
        write: Any = imageio_ffmpeg.write_frames
        writer = write(
            str(place),
            size,
            fps=rate,
            codec="libx264",
            macro_block_size=2,
            quality=None,
            ffmpeg_log_level="quiet",
            output_params=["-crf", "18", "-preset", "medium", "-movflags", "+faststart"],
        )
        try:
            writer.send(None)
            for each in shown:
                writer.send(each.tobytes())
        except BaseException as error:  # an interrupt ends ffmpeg at once
            with suppress(BaseException):
                writer.throw(error)
            raise
        writer.close()
        return place.read_bytes()


def _told(shown: Iterable[Any], count: int, tell: Tell) -> Iterator[Any]:
    """Pictures, each told as it is drawn."""
    for done, each in enumerate(shown):
        tell(done + 1, count)
        yield each
