"""How the engine would move if nothing held it: the paths of both ends of the crankshaft, seen from the front."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar import phasor
from crankstar.exhibit.numbers import free_response as free
from crankstar.exhibit.proportions import proportions
from crankstar.exhibit.records import Pair, Vectors, Whirl
from crankstar.phasor import Complex, Spectrum
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figure, figures, paragraph, section, table, text
from crankstar.report.matter import Matter
from crankstar.wording import NEGLIGIBLE, number, shape

SIDE, MARGIN = 180.0, 40.0
"""px of the drawing of a path, and round it."""
SAMPLES = 721
STILL = 1e-9
"""Share of the size of the engine below which it does not move."""


class End(NamedTuple):
    """An end of the crankshaft and what it does, order by order."""

    name: str
    moves: Spectrum


def free_response(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001 - all pages are made alike
    """The paths of the front and the rear end, with what of the engine's mass and inertia is an estimate."""
    found = free(matter.engine, matter.shown.orders, along=proportions(matter.engine).along)
    shaft = matter.scene.shafts[0]
    ends = [End(name, _moves(matter, found, z)) for name, z in (("front end", shaft.z_to), ("rear end", shaft.z_from))]
    size = max(high - low for low, high in zip(matter.scene.low, matter.scene.high, strict=True))
    greatest = max(phasor.peak(end.moves).value for end in ends)
    told = paragraph(
        "Seen from the front: where the ends of the crankshaft go if nothing holds the engine, of the orders above together. The "
        "speed makes no difference to the path: force and acceleration grow alike."
    )
    assumed = "".join(paragraph(line, "doubt") for line in found.assumed)
    if greatest < STILL * size:
        still = paragraph("The ends of the crankshaft stand still: no force and no couple of these orders is left.")
        return section("If nothing held it", still + assumed, name="whirl")
    scale, unit = (1e6, "µm") if matter.scene.length_unit == "m" else (1e3, "r / 1000")
    rows = [[number(order), *_told(ends, order, scale, greatest)] for order in matter.shown.orders]
    rows.append(["all", *(cell for end in ends for cell in ("", number(phasor.peak(end.moves).value * scale)))])
    heads = ["order", *(head for end in ends for head in (end.name, f"greatest [{unit}]"))]
    drawn = [figure(_path(end, greatest, scale, unit), f"The path of the {end.name}.") for end in ends]
    whole = told + figures(drawn) + table(heads, rows, title="Paths, order by order") + assumed
    return section("If nothing held it", whole, name="whirl")


def _moves(matter: Matter, found: Whirl, z: float) -> Spectrum:
    """What the crank axis does at z: shift + (z - z of the centre) tilt + i turn * (its place from the centre)."""
    up, right, along = found.centre
    orders, sense = np.array(matter.shown.orders), matter.engine.sense
    shift, tilt = _vectors(found.shift), _vectors(found.tilt)
    turn = phasor.real_signal(orders, _complex(found.turn))
    aside = 1j * complex(-up, -right)
    mates = (turn.forward, turn.backward) if sense > 0 else (turn.backward, turn.forward)
    forward, backward = (shift[way] + (z - along) * tilt[way] + aside * mate for way, mate in enumerate(mates))
    return Spectrum(orders, forward, backward, sense)


def _vectors(given: Vectors) -> tuple[Complex, Complex]:
    return _complex(given.forward), _complex(given.backward)


def _complex(pairs: Sequence[Pair]) -> Complex:
    return np.array([complex(*pair) for pair in pairs])


def _told(ends: Sequence[End], order: float, scale: float, greatest: float) -> list[str]:
    out: list[str] = []
    for end in ends:
        one = phasor.selected(end.moves, [order])
        path = phasor.ellipse(complex(one.forward[0]), complex(one.backward[0]))
        none = path.semi_major <= NEGLIGIBLE * greatest
        out += ["none", "0"] if none else [shape(path, greatest), number(path.semi_major * scale)]
    return out


def _path(end: End, greatest: float, scale: float, unit: str) -> str:
    """The path as a drawing with equal scales, a dot where it is at theta = 0."""
    turns = phasor.period(end.moves)
    run = np.asarray(phasor.value(end.moves, np.linspace(0, 2 * pi * turns, SAMPLES * turns)))
    middle, reach = SIDE / 2 + MARGIN, SIDE / 2 / greatest
    x, y = middle + np.imag(run) * reach, middle - np.real(run) * reach
    line = "L".join(f"{a:.1f} {b:.1f}" for a, b in zip(x, y, strict=True))
    whole = SIDE + 2 * MARGIN
    axes = f"M{MARGIN - 8:g} {middle:g}H{whole - MARGIN + 8:g}M{middle:g} {whole - MARGIN + 8:g}V{MARGIN - 8:g}"
    label = f"{number(float(f'{greatest * scale:.2g}'))} {unit}"
    long = float(f"{greatest * scale:.2g}") / scale * reach
    bar = f"M{middle:g} {whole - 14:g}h{long:g}m0 -3v6M{middle:g} {whole - 17:g}v6"
    size = f'width="{whole:g}" height="{whole:g}" viewBox="0 0 {whole:g} {whole:g}"'
    return (
        f'<svg role="img" xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="12">'
        f"<title>{text(f'path of the {end.name}')}</title>"
        f'<path d="{axes}" fill="none" stroke="currentColor" stroke-opacity="0.35"/>'
        f'<text x="{middle:g}" y="{MARGIN - 14:g}" text-anchor="middle" fill="currentColor">up</text>'
        f'<text x="{whole - 4:g}" y="{middle - 6:g}" text-anchor="end" fill="currentColor">right</text>'
        f'<path d="M{line}" fill="none" stroke="#d1382a" stroke-width="1.6"/>'
        f'<circle cx="{x[0]:.1f}" cy="{y[0]:.1f}" r="4" fill="#d1382a"/>'
        f'<path d="{bar}" fill="none" stroke="currentColor"/>'
        f'<text x="{middle - 6:g}" y="{whole - 10:g}" text-anchor="end" fill="currentColor">{text(label)}</text></svg>'
    )
