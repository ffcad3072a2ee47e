"""Pictures measured as a reader sees them: the box, size and colour of every text of an SVG."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import hypot
from typing import Any, NamedTuple

from playwright.sync_api import Page

FAMILIES = ("Noto Sans", "DejaVu Sans")
"""The font that travels with the package, and the widest one in common use (`tests/fonts.py`)."""
MEASURE = """() => {
  const pen = document.createElement('canvas').getContext('2d')
  // where the letters of a text end: no font fills the line that a browser reserves for it
  const inked = node => {
    const lines = [...node.querySelectorAll('tspan')]
    const tops = new Set(lines.map(one => Math.round(one.getBoundingClientRect().top)))
    const [head, foot] = (tops.size > 1 ? [lines[0], lines.at(-1)] : [node, node])
      .map(one => pen.measureText(one.textContent))
    const [first, last] = [0, node.getNumberOfChars() - 1].map(
      at => node.getStartPositionOfChar(at))
    const { x, width } = node.getBBox(), to = node.getScreenCTM()
    const top = first.y - head.actualBoundingBoxAscent
    const bottom = last.y + foot.actualBoundingBoxDescent
    return [[x, top], [x + width, top], [x + width, bottom], [x, bottom]]
      .map(([x, y]) => new DOMPoint(x, y).matrixTransform(to))
  }
  return [...document.querySelectorAll('main > svg')].map(svg => {
    const home = svg.getBoundingClientRect()
    const part = node => {
      const style = getComputedStyle(node)
      let opacity = parseFloat(style.fillOpacity)
      for (let at = node; at instanceof Element; at = at.parentElement)
        opacity *= parseFloat(getComputedStyle(at).opacity)
      pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`
      const to = node.getScreenCTM()
      return {text: node.textContent.trim(), opacity, colour: style.fill,
        corners: inked(node).map(({ x, y }) => [x - home.left, y - home.top]),
        size: parseFloat(style.fontSize) * Math.hypot(to.a, to.b)}
    }
    return {width: home.width, height: home.height,
      texts: [...svg.querySelectorAll('text')].filter(
        node => node.textContent.trim() && node.getBoundingClientRect().width).map(part)}
  })
}"""


class Text(NamedTuple):
    """A text of a picture: the corners of what is drawn of it, around it, px, and its letters."""

    text: str
    corners: tuple[tuple[float, float], ...]
    size: float
    colour: tuple[int, int, int]
    opacity: float

    @property
    def left(self) -> float:
        """Its leftmost point."""
        return min(x for x, _y in self.corners)

    @property
    def right(self) -> float:
        """Its rightmost point."""
        return max(x for x, _y in self.corners)

    @property
    def top(self) -> float:
        """Its highest point."""
        return min(y for _x, y in self.corners)

    @property
    def bottom(self) -> float:
        """Its lowest point."""
        return max(y for _x, y in self.corners)

    def overlap(self, other: Text) -> float:
        """How far one has to be moved to stand clear of the other, px; not positive if it does."""
        return min(
            _overlap(self.corners, other.corners, side)
            for each in (self, other)
            for side in each.sides()
        )

    def sides(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """The directions of its line and of its height, as unit vectors."""
        (x0, y0), (x1, y1), *_rest = self.corners
        long = hypot(x1 - x0, y1 - y0)
        x, y = (x1 - x0) / long, (y1 - y0) / long
        return (x, y), (-y, x)


def _overlap(
    one: Sequence[tuple[float, float]],
    other: Sequence[tuple[float, float]],
    side: tuple[float, float],
) -> float:
    """How far two sets of points overlap in a direction."""
    here, there = ([x * side[0] + y * side[1] for x, y in each] for each in (one, other))
    return min(max(here), max(there)) - max(min(here), min(there))


class Measured(NamedTuple):
    """A picture as Chromium shows it, px of 1/96 in."""

    width: float
    height: float
    texts: tuple[Text, ...]

    def collisions(self, by: float = 0.5) -> list[tuple[str, str]]:
        """The pairs of texts of which one stands on the other by more than so many px."""
        return [
            (one.text, other.text)
            for one, other in combinations(self.texts, 2)
            if one.overlap(other) > by
        ]

    def cut(self, by: float = 1.0) -> list[str]:
        """The texts that leave the picture by more than so many px."""
        return [
            one.text
            for one in self.texts
            if min(one.left, one.top) < -by
            or one.right > self.width + by
            or one.bottom > self.height + by
        ]


def measured(page: Page, drawings: Sequence[str], family: str = "") -> list[Measured]:
    """Each SVG as the page shows it, with the fonts that it names or with a family of fonts."""
    style = f"<style>text {{ font-family: '{family}' !important }}</style>" if family else ""
    page.set_content(f"{style}<main>{''.join(drawings)}</main>")
    return [_picture(picture) for picture in page.evaluate(MEASURE)]


def _picture(picture: dict[str, Any]) -> Measured:
    return Measured(picture["width"], picture["height"], tuple(map(_text, picture["texts"])))


def _text(found: dict[str, Any]) -> Text:
    red, green, blue = (
        int(float(part)) for part in found["colour"].split("(")[1].rstrip(")").split(",")[:3]
    )
    corners = tuple((x, y) for x, y in found["corners"])
    return Text(found["text"], corners, found["size"], (red, green, blue), found["opacity"])


def contrast(one: tuple[int, int, int], other: tuple[int, int, int]) -> float:
    """The contrast ratio of two colours, 1 to 21, after WCAG 2.2."""
    light, dark = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def _luminance(colour: tuple[int, int, int]) -> float:
    parts = [part / 255 for part in colour]
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
