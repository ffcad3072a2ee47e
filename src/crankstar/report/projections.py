"""Directions of sight, and solids drawn flat along them in px."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from crankstar.language.messages import N_, _
from crankstar.spectra import Complex, Real

RING: Complex = np.exp(2j * np.pi * np.arange(24) / 24)
"""The corners of a circle."""


class Look(NamedTuple):
    """A direction of sight with a title; `turned` gives a point (up, right, z) on the drawing.

    The result is (to the right, upward, towards the viewer).
    """

    title: str
    turned: Callable[[Any, Any, Any], tuple[Any, Any, Any]]
    axes: tuple[tuple[str, float, float], ...]


FRONT = Look(
    N_("{engine} from the front"),
    lambda up, right, z: (right, up, z),
    ((N_("up"), 0, 1), (N_("right"), 1, 0)),
)
SIDE = Look(
    N_("{engine} from the right side, the front at the left"),
    lambda up, right, z: (-z, up, right),
    (("up", 0, 1), ("z", -1, 0)),
)
PLAN = Look(
    N_("{engine} from above, the front at the foot"),
    lambda up, right, z: (right, -z, up),
    (("right", 1, 0), ("z", 0, -1)),
)


class Part(NamedTuple):
    """A drawn part: its distance towards the viewer, and its SVG."""

    near: float
    svg: str


class Pen(NamedTuple):
    """Draws solids on a flat drawing, in px."""

    look: Look
    scale: float
    x0: float
    y0: float

    def at(self, place: ArrayLike, *, z: ArrayLike) -> tuple[Real, Real, Real]:
        """Points of the clock plane at z: x, y, and distance towards the viewer."""
        spot: Complex = np.asarray(place, complex)
        across, upward, near = self.look.turned(np.real(spot), np.imag(spot), np.asarray(z, float))
        return self.x0 + across * self.scale, self.y0 - upward * self.scale, near

    def outline(self, rim: Complex, ends: tuple[float, float], style: str) -> Part:
        """A prism along z with this rim at both ends."""
        return self.hull(np.concatenate([rim, rim]), np.repeat(ends, rim.size), style)

    def hull(self, places: Complex, z: Real, style: str) -> Part:
        """A convex solid with these corners."""
        x, y, near = self.at(places, z=z)
        shape = np.broadcast_shapes(x.shape, y.shape)
        corners = hull(np.stack([np.broadcast_to(x, shape), np.broadcast_to(y, shape)], axis=-1))
        path = "L".join(f"{x:g} {y:g}" for x, y in corners)
        return Part(float(np.mean(near)), f'<path d="M{path}Z" {style}/>')

    def disc(
        self, centre: complex, ends: tuple[float, float], style: str, *, radius: float
    ) -> Part:
        """A cylinder along z: a circle from the front, else a rectangle."""
        if self.look is FRONT:
            x, y, near = self.at(centre, z=max(ends))
            return Part(
                float(near),
                f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" {style}/>',
            )
        return self.outline(centre + radius * np.array([1, 1j, -1, -1j]), ends, style)

    def barrel(
        self,
        centre: complex,
        along: tuple[float, float],
        style: str,
        *,
        axis: complex,
        radius: float,
        z: float,
    ) -> Part:
        """A cylinder along an axis of the clock plane."""
        places = [centre + axis * (end + 1j * radius * np.imag(RING)) for end in along]
        return self.hull(np.concatenate(places), np.tile(z + radius * np.real(RING), 2), style)


def style(colour: str, *, fill: float, line: float = 1.0, dash: str = "") -> str:
    """The attributes of fill and outline."""
    body = f'fill="{colour}" fill-opacity="{fill:g}"' if fill else 'fill="none"'
    return f'{body} stroke="{colour}" stroke-width="{line:g}"' + (
        f' stroke-dasharray="{dash}"' if dash else ""
    )


def axes(look: Look, height: float) -> str:
    """The axes of the frame in a lower corner."""
    long = 26.0
    flip = any(dx < 0 for _, dx, _ in look.axes)
    x, y = (14.0 + long if flip else 12.0), height - 12.0
    if any(dy < 0 for *_, dy in look.axes):
        y -= long
    drawn = ""
    for name, dx, dy in look.axes:
        end_x, end_y = x + dx * long, y - dy * long
        back_x, back_y = end_x - 4 * dx, end_y + 4 * dy
        tip = (
            f"M{back_x - 3 * dy:g} {back_y - 3 * dx:g}L{end_x:g} {end_y:g}"
            f"L{back_x + 3 * dy:g} {back_y + 3 * dx:g}"
        )
        line = 'fill="none" stroke="currentColor" stroke-width="1"'
        drawn += f'<path d="M{x:g} {y:g}L{end_x:g} {end_y:g}{tip}" {line}/>'
        side = (
            f'x="{end_x + 5:g}" y="{end_y + 9 * (dy <= 0) + 1:g}"'
            if dy
            else f'x="{end_x - 2 * (dx < 0):g}" y="{end_y - 5:g}"'
        )
        drawn += f'<text {side} font-size="11" fill="currentColor">{_(name)}</text>'
    return drawn


def third_angle(*, x: float, y: float) -> str:
    """The symbol of third-angle projection after ISO 5456-2, its upper left corner at a place, px.

    A truncated cone from its small end, at the left, and from the side: the view from the left is
    at the left.
    """
    line = 'fill="none" stroke="currentColor" stroke-width="1.4"'
    thin = 'fill="none" stroke="currentColor" stroke-width="0.6" stroke-dasharray="7 2 1 2"'
    rings = "".join(f'<circle cx="14" cy="14" r="{radius}" {line}/>' for radius in (6, 12))
    return (
        f'<g class="projection" transform="translate({x:.1f} {y:.1f})">{rings}'
        f'<path d="M36 8L64 2V26L36 20Z" {line}/><path d="M-2 14H70M14 -2V30" {thin}/></g>'
    )


def hull(points: Real) -> list[tuple[float, float]]:
    """The convex hull of points [point, xy] to a tenth of a px, by Andrew's monotone chain."""
    ordered = sorted({(x, y) for x, y in np.round(points, 1).tolist()})
    if len(ordered) < 3:
        return ordered

    def half(way: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        out: list[tuple[float, float]] = []
        for x, y in way:
            while len(out) > 1 and (out[-1][0] - out[-2][0]) * (y - out[-2][1]) <= (
                out[-1][1] - out[-2][1]
            ) * (x - out[-2][0]):
                out.pop()
            out.append((x, y))
        return out[:-1]

    return half(ordered) + half(ordered[::-1])
