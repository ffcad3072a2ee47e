"""How wide letters are, and texts in lines of a width.

The widths are those of DejaVu Sans, the widest sans-serif font in common use, and of Noto Sans,
which travels with the package, where that is wider: what is kept apart in them is apart in Arial
and Helvetica as well.
"""

from __future__ import annotations

from functools import lru_cache
from unicodedata import east_asian_width

NO_BREAK = "\N{NO-BREAK SPACE}"
SMALL, TEXT = 12, 13
"""Sizes of letters, px."""
WIDTHS = {
    0.3: "'ijlJ",
    0.34: f" {NO_BREAK},.·:;I",
    0.4: "f()[]t-!¹²³r/",
    0.47: '"',
    0.5: "_°´–",
    0.55: "sz?гзεζcсэ|*",
    0.57: "LΓνkт",
    0.62: "FvxyPTYaoeτρκγλθδчьвухбеарГТУυχ",
    0.69: "АХΔΛΖΧдц",
    0.77: "ABCDHKNRUVXZ&БВДИЙКЛНПСЦЧЬЭЯΑΒΗΝΠΩφψм",
    0.84: "OQGΘΟΦΨОыw#+<=>~±×÷ωю−ъЪ≤≥^",
    0.92: "фжш∠○",
    0.98: "m%WMΜщМФЫ",
    1.09: "@…ЖЮШЩ—№",
}
"""Of letters by their width in their size; of others it is `USUAL`, of Japanese ones 1."""
USUAL = 0.65
_WIDTH = {letter: width for width, letters in WIDTHS.items() for letter in letters}


@lru_cache(maxsize=4096)
def text_width(text: str, size: float = TEXT) -> float:
    """About how wide the longest line of a text is, px.

    >>> text_width("1.1", 100), text_width("mm", 10)
    (164.0, 19.6)
    """
    return round(size * max(sum(map(_width, line)) for line in text.split("\n")), 6)


def _width(letter: str) -> float:
    known = _WIDTH.get(letter)
    if known is not None:
        return known
    return 1.0 if east_asian_width(letter) in "WF" else USUAL


def together(text: str) -> str:
    """A text that `folded` keeps in one line, such as a unit."""
    return text.replace(" ", NO_BREAK)


def folded(text: str, *, width: float, size: float = TEXT) -> list[str]:
    """A text in lines of a width, px: between words, between Japanese letters, in words too long.

    >>> folded("one two three", width=60), folded("慣性偶力", width=30)
    (['one two', 'three'], ['慣性', '偶力'])
    >>> folded(f"force in {together('m r ω²')}", width=90)
    ['force in', 'm r ω²']
    """
    lines = [""]
    for word in words(text):
        if lines[-1] and text_width((lines[-1] + word).rstrip(), size) > width:
            lines.append("")
        for letter in word if lines[-1] or word.strip() else "":
            if text_width((lines[-1] + letter).rstrip(), size) > width and lines[-1]:
                lines.append("")
            lines[-1] += letter
    return [line.strip().replace(NO_BREAK, " ") for line in lines if line.strip()] or [""]


def words(text: str) -> list[str]:
    """The pieces after which a line may end; a space belongs to the word before it."""
    pieces = [""]
    for letter in text:
        pieces[-1] += letter
        if letter == " " or east_asian_width(letter) in "WF":
            pieces.append("")
    return [piece for piece in pieces if piece]
