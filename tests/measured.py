"""Pictures measured as a reader sees them: the box, size and colour of every text of an SVG."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any, NamedTuple

from playwright.sync_api import Page

FAMILIES = ("Noto Sans", "DejaVu Sans")
"""The font that travels with the package, and the widest one in common use (`tests/fonts.py`)."""
MEASURE = """() => {
  const pen = document.createElement('canvas').getContext('2d')
  // where the letters of a text end: no font fills the line that a browser reserves for it
  const inked = (node, style, box) => {
    const lines = [...node.querySelectorAll('tspan')]
    const tops = new Set(lines.map(one => Math.round(one.getBoundingClientRect().top)))
    pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`
    const whole = node.textContent, several = tops.size > 1
    const over = pen.measureText(several ? lines[0].textContent : whole).actualBoundingBoxAscent
    const under =
      pen.measureText(several ? lines.at(-1).textContent : whole).actualBoundingBoxDescent
    const to = node.getScreenCTM(), size = Math.hypot(to.a, to.b)
    const last = node.getNumberOfChars() - 1
    const [first, end] = [0, last].map(at => node.getStartPositionOfChar(at).matrixTransform(to))
    let { left, right, top, bottom } = box
    if (Math.abs(to.b) <= Math.abs(to.a))
      [top, bottom] = [first.y - over * size, end.y + under * size]
    else if (to.b < 0) [left, right] = [first.x - over * size, end.x + under * size]
    else [left, right] = [end.x - under * size, first.x + over * size]
    return { left, right, top, bottom, size }
  }
  return [...document.querySelectorAll('main > svg')].map(svg => {
    const home = svg.getBoundingClientRect()
    const part = node => {
      const style = getComputedStyle(node)
      let opacity = parseFloat(style.fillOpacity)
      for (let at = node; at instanceof Element; at = at.parentElement)
        opacity *= parseFloat(getComputedStyle(at).opacity)
      const { left, right, top, bottom, size } = inked(node, style, node.getBoundingClientRect())
      return {text: node.textContent.trim(), left: left - home.left, top: top - home.top,
        right: right - home.left, bottom: bottom - home.top, opacity,
        size: parseFloat(style.fontSize) * size, colour: style.fill}
    }
    return {width: home.width, height: home.height,
      texts: [...svg.querySelectorAll('text')].filter(
        node => node.textContent.trim() && node.getBoundingClientRect().width).map(part)}
  })
}"""


class Text(NamedTuple):
    """A text of a picture: the box of what is drawn of it, px, and its letters."""

    text: str
    left: float
    top: float
    right: float
    bottom: float
    size: float
    colour: tuple[int, int, int]
    opacity: float


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
            if min(one.right, other.right) - max(one.left, other.left) > by
            and min(one.bottom, other.bottom) - max(one.top, other.top) > by
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
        int(float(part)) for part in found.pop("colour").split("(")[1].rstrip(")").split(",")[:3]
    )
    return Text(**found, colour=(red, green, blue))


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
