"""The widths by which charts are laid out, against the fonts in which they are seen."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from fontTools.ttLib import TTFont
from tests.fonts import file

import crankstar
from crankstar.charts.letters import text_width

PACKAGE = Path(crankstar.__file__).parent
FONTS = [
    ("fontpkg_noto_sans", "files/NotoSans[wdth,wght].ttf"),
    ("matplotlib", "mpl-data/fonts/ttf/DejaVuSans.ttf"),
]
BARS = frozenset("▁▂▃▄▅▆▇█")
"""Of terminals only."""


@pytest.mark.parametrize(("package", "name"), FONTS)
def test_no_letter_of_a_message_is_wider_than_it_is_taken_to_be(package: str, name: str) -> None:
    place = file(package, name)
    assert place is not None
    font: Any = TTFont(str(place))
    glyphs, advances, em = font.getBestCmap(), font["hmtx"], font["head"].unitsPerEm
    catalogs = sorted(PACKAGE.glob("language/catalogs/*/LC_MESSAGES/crankstar.po"))
    letters = {*"".join(each.read_text(encoding="utf-8") for each in catalogs)} - BARS
    widths = {each: advances[glyphs[ord(each)]][0] / em for each in letters if ord(each) in glyphs}
    assert len(widths) > 150
    too_narrow = {
        each: (width, text_width(each, 1))
        for each, width in widths.items()
        if width > text_width(each, 1) + 0.03
    }
    assert too_narrow == {}
