"""What everyone is to read on every screen: nothing cut off, no barrier, light and dark."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from playwright.sync_api import Page, expect
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import opened
from tests.web.overflow import overflows

SCREENS = [(320, "dark"), (390, "light"), (1024, "dark"), (1440, "light")]
"""Widths in pixels, and the colours of the system."""
Scheme = Literal["light", "dark"]


def read_by_everyone(
    page: Page, path: Path, state: str, *, width: int, scheme: Scheme, figures: int = 0
) -> None:
    """Opens a page on such a screen, with so many figures in its panel, and checks it."""
    page.set_viewport_size({"width": width, "height": 844})
    page.emulate_media(color_scheme=scheme)
    opened(page, path, state)
    if figures:
        expect(page.locator("[role=tabpanel] .figures svg")).to_have_count(figures)
    assert too_wide(page) == []
    assert overflows(page) == []
    assert barriers(page) == []
