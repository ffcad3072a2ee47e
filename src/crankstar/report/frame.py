"""The drawing of axes, angles and signs, its words in the reader's language."""

from __future__ import annotations

import re
from importlib.resources import files

from crankstar.language.messages import _

WORDS = re.compile(r"(<(text|title|desc)\b[^>]*>)(.*?)(</\2>)", re.DOTALL)
LETTER = re.compile(r'<tspan class="italic">(\w)</tspan>')
"""The letter of a quantity within words."""


def drawing() -> str:
    """The drawing as SVG."""
    return WORDS.sub(_translated, _drawn())


def words() -> list[str]:
    """What is written in the drawing, in English, `{z}` for the letter of a quantity."""
    found = (LETTER.sub(r"{\1}", match[3]) for match in WORDS.finditer(_drawn()))
    return [text for text in found if re.search("[A-Za-z]{2}", text)]


def _translated(match: re.Match[str]) -> str:
    text = LETTER.sub(r"{\1}", match[3])
    letters = {letter[1]: letter[0] for letter in LETTER.finditer(match[3])}
    return f"{match[1]}{_(text, **letters)}{match[4]}"


def _drawn() -> str:
    svg = files("crankstar.report").joinpath("frame.svg").read_text(encoding="utf-8")
    return svg[svg.index("<svg") :].strip()
