"""Pictures measured as a reader sees them: the box, size and colour of every text of an SVG."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any, NamedTuple

from playwright.sync_api import Page

MEASURE = """() => [...document.querySelectorAll('main > svg')].map(svg => {
  const home = svg.getBoundingClientRect()
  const part = node => {
    const box = node.getBoundingClientRect(), style = getComputedStyle(node)
    let opacity = 1
    for (let at = node; at instanceof Element; at = at.parentElement)
      opacity *= parseFloat(getComputedStyle(at).opacity)
    opacity *= parseFloat(style.fillOpacity)
    const scale = node.getScreenCTM(), turned = Math.abs(scale.b) > Math.abs(scale.a)
    return {text: node.textContent.trim(), left: box.left - home.left, top: box.top - home.top,
      right: box.right - home.left, bottom: box.bottom - home.top, turned, opacity,
      size: parseFloat(style.fontSize) * Math.hypot(scale.a, scale.b), colour: style.fill,
      lines: Math.max(1, new Set([...node.querySelectorAll('tspan')].map(
        one => Math.round(one.getBoundingClientRect().top))).size)}
  }
  return {width: home.width, height: home.height,
    texts: [...svg.querySelectorAll('text')].filter(
      node => node.textContent.trim() && node.getBoundingClientRect().width).map(part)}
})"""
BLANK = 0.17
"""Share of the height of a line, at its head and at its foot, in which no letter is drawn."""


class Text(NamedTuple):
    """A text of a picture: its box without the blank of its line, px, and its letters."""

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


def measured(page: Page, drawings: Sequence[str]) -> list[Measured]:
    """Each SVG as the page shows it."""
    page.set_content(f"<main>{''.join(drawings)}</main>")
    return [_picture(picture) for picture in page.evaluate(MEASURE)]


def _picture(picture: dict[str, Any]) -> Measured:
    return Measured(picture["width"], picture["height"], tuple(map(_text, picture["texts"])))


def _text(found: dict[str, Any]) -> Text:
    ends = {side: found[side] for side in ("left", "right", "top", "bottom")}
    low, high = ("left", "right") if found["turned"] else ("top", "bottom")
    blank = BLANK * (ends[high] - ends[low]) / found["lines"]
    ends |= {low: ends[low] + blank, high: ends[high] - blank}
    red, green, blue = (
        int(float(part)) for part in found["colour"].split("(")[1].rstrip(")").split(",")[:3]
    )
    return Text(
        found["text"],
        **ends,
        size=found["size"],
        colour=(red, green, blue),
        opacity=found["opacity"],
    )


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
