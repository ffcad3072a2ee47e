"""An engine at crank angles as drawings in SVG: parts, arrows, cylinder numbers, name and angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from itertools import product
from math import degrees, hypot

import numpy as np

from crankstar.charts.letters import text_width
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, numbers_text
from crankstar.page.records import Scene
from crankstar.page.scene import scene
from crankstar.pictures.arrows import KINDS, Arrow, Kind, Load, load_of, round_value
from crankstar.pictures.looks import Discs, along, clearest_azimuth, discs_of, facing
from crankstar.pictures.motions import motion_of
from crankstar.pictures.painting import Painter
from crankstar.pictures.palettes import PALETTES, Palette, ThemeName
from crankstar.pictures.panes import Box, Pane, Sight, panes_of

ARROW = 0.28
"""The longest arrow as a share of the greater of breadth and height."""
FOOT, HEAD, EDGE = 30.0, 34.0, 12.0
"""px: below the engine for the scale of arrows, above it for the name, and around everything."""
LETTERS, SMALL = 14, 12
"""px."""
CLOSE = 15.0
"""Numbers of cylinders nearer to each other than this are written as one, px."""
SVG = "http://www.w3.org/2000/svg"
FONT = "system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif"
NAMES = {
    "front": N_("Front"),
    "plan": N_("Plan"),
    "side": N_("Side, from the right"),
    "isometric": N_("Isometric, not to scale"),
}
LABELS: dict[Kind, str] = {"force": N_("Force"), "couple": N_("Couple")}


@dataclass(frozen=True)
class Picture:
    """How an engine is drawn: its view, size (px), colours, arrows, their orders, and letters.

    Without `letters` there are neither name, angle nor numbers, as in a small picture; without a
    `heading` numbers alone, as where both stand beside it; without `ground` what is behind the
    picture shows through.
    """

    view: Sight = "isometric"
    width: int = 720
    height: int = 540
    theme: ThemeName = "light"
    arrows: tuple[Kind, ...] = KINDS
    orders: tuple[float, ...] | None = None
    letters: bool = True
    heading: bool = True
    ground: bool = True


def drawing(engine: Engine, picture: Picture | None = None, *, theta: float = 0.0) -> str:
    """The engine at a crank angle (radians) as SVG.

    >>> from crankstar.files.catalog import load
    >>> drawing(load("single")).count("data-part")
    1
    """
    return next(drawings(engine, [theta], picture))


def drawings(
    engine: Engine, angles: Sequence[float], picture: Picture | None = None
) -> Iterator[str]:
    """The engine at each crank angle (radians) as SVG, all to one scale."""
    how = picture or Picture()
    drawn = scene(engine)
    theta = np.asarray(angles, float)
    moving = motion_of(engine, drawn, theta)
    load = load_of(engine, drawn, theta, kinds=how.arrows, orders=how.orders)
    long = ARROW * max(high - low for low, high in zip(drawn.low[:2], drawn.high[:2], strict=True))
    edge = EDGE if how.letters else 3.0
    head = HEAD if how.letters and how.heading else edge
    foot = FOOT if how.letters and load.values else edge
    box = Box(edge, head, how.width - 2 * edge, how.height - head - foot)
    discs = _with_arrows(discs_of(drawn, numbered=how.letters), load, long)
    panes = panes_of(how.view, discs, box, azimuth=clearest_azimuth(drawn))
    painters = [Painter(drawn, pane.look) for pane in panes]
    palette = PALETTES[how.theme]
    still = _still(engine, drawn, panes, load, long, how)
    thin = 0.9 if how.letters else 0.6
    for at, angle in enumerate(angles):
        said = _("{engine} at {angle} deg", engine=engine.name, angle=number(degrees(angle)))
        yield "".join(
            (
                f'<svg xmlns="{SVG}" width="{how.width}" height="{how.height}"',
                f' viewBox="0 0 {how.width} {how.height}" role="img"',
                f' font-family="{FONT}" font-size="{SMALL}">',
                f"<title>{escape(said)}</title>",
                f'<rect width="100%" height="100%" fill="{palette.ground}"/>' * how.ground,
                f'<g stroke="{palette.edge}" stroke-width="{thin}" stroke-linejoin="round">',
                *(
                    f'<g data-view="{pane.view}">'
                    f"{''.join(painter.painted(pane, moving, at, palette))}</g>"
                    for pane, painter in zip(panes, painters, strict=True)
                ),
                "</g>",
                *(
                    svg
                    for pane in panes
                    for arrow in load.arrows
                    for svg in _arrow(pane, arrow, at, long, palette, letters=how.letters)
                ),
                still,
                _angle(angle, how, palette) if how.letters and how.heading else "",
                "</svg>\n",
            )
        )


def _with_arrows(discs: Discs, load: Load, long: float) -> Discs:
    """Also the room that the tips of arrows need."""
    if not load.arrows:
        return discs
    places = np.array(
        [
            (x + aside * long * np.abs(np.imag(vectors)).max(), y + up * long * most, z)
            for (x, y, z), vectors in ((arrow.place, arrow.vector) for arrow in load.arrows)
            for most in (np.abs(np.real(vectors)).max(),)
            for aside, up in product((-1, 1), repeat=2)
        ]
    )
    ways = np.tile((0.0, 0.0, 1.0), (len(places), 1))
    return Discs(
        np.vstack([discs.centres, places]),
        np.vstack([discs.facings, ways]),
        np.append(discs.radii, np.zeros(len(places))),
    )


def _arrow(
    pane: Pane, arrow: Arrow, at: int, long: float, palette: Palette, *, letters: bool
) -> Iterator[str]:
    """An arrow, unless it is hardly longer than it is thick."""
    x, y, z = arrow.place
    vector = complex(arrow.vector[at])
    tip = (x + long * vector.imag, y + long * vector.real, z)
    (x0, x1), (y0, y1) = (side.tolist() for side in pane.at(np.array([arrow.place, tip])))
    length = hypot(x1 - x0, y1 - y0)
    if length < 3:
        return
    thick = 3.5 if letters else 2.2
    head = min(3.6 * thick, 0.7 * length)
    way = complex(x1 - x0, y1 - y0) / length
    neck = complex(x1, y1) - head * way
    wings = [neck + side * 0.45 * head * 1j * way for side in (1, -1)]
    colour = palette.force if arrow.kind == "force" else palette.couple
    rim = "L".join(f"{spot.real:.1f} {spot.imag:.1f}" for spot in (complex(x1, y1), *wings))
    yield (
        f'<g class="{arrow.kind}" fill="{colour}" stroke="{colour}">'
        f'<path d="M{x0:.1f} {y0:.1f}L{neck.real:.1f} {neck.imag:.1f}" '
        f'stroke-width="{thick}" stroke-linecap="round"/><path d="M{rim}Z" stroke="none"/></g>'
    )


def _still(
    engine: Engine, drawn: Scene, panes: Sequence[Pane], load: Load, long: float, how: Picture
) -> str:
    """What is written: name, numbers, names of views, scales of arrows; the same at every angle."""
    if not how.letters:
        return ""
    palette = PALETTES[how.theme]
    room = how.width - 2 * EDGE - 90
    name, size = engine.name, LETTERS
    while text_width(name, size) > room and len(name) > 8:
        name = name.removesuffix("…")[:-2].rstrip() + "…"
    heading = f'x="{EDGE}" y="22" font-size="{size}" font-weight="600" fill="{palette.text}"'
    out = [f"<text {heading}>{escape(name)}</text>"] if how.heading else []
    for pane in panes:
        out += _numbers(drawn, pane, palette)
        if len(panes) > 1:
            out.append(
                f'<text x="{pane.box.x + 2:.1f}" y="{pane.box.y - 5:.1f}" fill="{palette.quiet}">'
                f"{escape(_(NAMES[pane.view]))}</text>"
            )
    x = EDGE
    for kind, value, unit in load.values:
        pixels = long * panes[-1].scale
        shown = round_value(value * min(1.0, 70 / pixels))
        length = shown / value * pixels
        colour = palette.force if kind == "force" else palette.couple
        y = how.height - 14
        text = f"{number(shown)} {unit}  {_(LABELS[kind])}"
        out.append(
            f'<path d="M{x:.1f} {y}H{x + length - 6:.1f}" stroke="{colour}" stroke-width="3"/>'
            f'<path d="M{x + length:.1f} {y}l-9 -5v10Z" fill="{colour}"/>'
            f'<text x="{x + length + 7:.1f}" y="{y + 4}" fill="{palette.text}">'
            f"{escape(text)}</text>"
        )
        x += length + 7 + text_width(text, SMALL) + 18
    return "".join(out)


def _numbers(drawn: Scene, pane: Pane, palette: Palette) -> Iterator[str]:
    """The numbers of cylinders beyond their heads; those behind each other in one label."""
    labels: list[tuple[float, float, list[int]]] = []
    for c in drawn.cylinders:
        ends = [along(drawn, c, c.bore_from), along(drawn, c, c.bore_to)]
        (x0, x1), (y0, y1) = (side.tolist() for side in pane.at(np.array(ends)))
        length = hypot(x1 - x0, y1 - y0)
        beyond = 0.0 if facing(drawn, c) is not None else max(0.22 * c.bore * pane.scale, 13.0)
        if length > 4:
            x1, y1 = x1 + beyond * (x1 - x0) / length, y1 + beyond * (y1 - y0) / length
        for x, y, names in labels:
            if hypot(x - x1, y - y1) < CLOSE:
                names.append(c.number)
                break
        else:
            labels.append((x1, y1, [c.number]))
    for x, y, names in labels:
        runs = numbers_text(names)
        text = "·".join(map(str, sorted(names))) if "…" in runs else runs.replace(", ", "·")
        yield (
            f'<text x="{x:.1f}" y="{y + 4:.1f}" text-anchor="middle" fill="{palette.text}" '
            f'stroke="{palette.ground}" stroke-width="3" stroke-linejoin="round" '
            f'paint-order="stroke">{text}</text>'
        )


def _angle(angle: float, how: Picture, palette: Palette) -> str:
    """The crank angle."""
    text = f"θ = {degrees(angle):.0f}°"
    return (
        f'<text x="{how.width - EDGE}" y="22" font-size="{LETTERS}" text-anchor="end" '
        f'fill="{palette.quiet}">{text}</text>'
    )
