"""The font of the page has every letter that a formula of the catalog has."""

from __future__ import annotations

import json
import re
from contextlib import suppress
from html import unescape

import pytest
from tests.catalog import EVERY_ENGINE
from tests.front_end import WEB

from crankstar.derive import DerivationError
from crankstar.files.catalog import load
from crankstar.page.figures import derivation

LETTERS = json.loads((WEB / "build" / "math-letters.json").read_text(encoding="utf-8"))
ITALIC = 0x1D434


HAS = {chr(code) for low, high in LETTERS for code in range(int(low, 16), int(high, 16) + 1)}


@pytest.mark.many(first=9)
@EVERY_ENGINE
def test_every_letter_of_a_formula_is_in_the_font(name: str) -> None:
    engine = load(name)
    for quantity in ("force", "couple"):
        for order in (1, 2, 4):
            with suppress(DerivationError):
                html = derivation(engine, f"{quantity}:{order}")
                formulas = re.findall(r"<math.*?</math>", html, flags=re.DOTALL)
                letters = set(unescape(re.sub(r"<[^>]*>", "", "".join(formulas))))
                assert letters <= HAS | {"\n"}, order


def test_the_font_has_the_italics_in_which_letters_are_set() -> None:
    small_h = 0x1D455  # has no letter of its own there, but is Planck's constant
    italics = {chr(ITALIC + place) for place in range(52)} - {chr(small_h)}
    assert italics | {"\N{PLANCK CONSTANT}"} <= HAS
