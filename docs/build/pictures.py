"""The pictures of the README; `.venv/bin/python docs/build/pictures.py` draws them again.

Two engines as `crankstar page` writes them, in a Chromium without a window, one light and one dark.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Literal, NamedTuple

sys.path.insert(0, str(Path(__file__).parents[2]))

from playwright.sync_api import ViewportSize, expect
from tests.web.browsing import chromium
from tests.web.engine_page import opened, written

PICTURES = Path(__file__).parents[1] / "pictures"
GREATEST = 220_000
"""Bytes of a picture: they are in git."""


class Shot(NamedTuple):
    """A picture: its file, the engine, what is seen of it, and the colours."""

    file: str
    engine: str
    state: str
    colours: Literal["light", "dark"]


SHOTS = (
    Shot("page-light.png", "v8-cross-plane", "a=40&section=2&tab=orders", "light"),
    Shot("page-dark.png", "pratt-whitney-wasp", "a=75&camera=front&tab=forces", "dark"),
)


def main() -> None:
    """Draws all of them."""
    with chromium() as browser, tempfile.TemporaryDirectory() as folder:
        for shot in SHOTS:
            size: ViewportSize = {"width": 1200, "height": 760}
            with (
                browser.new_context(viewport=size, color_scheme=shot.colours) as context,
                context.new_page() as page,
            ):
                opened(page, written(Path(folder), shot.engine, figures=True), shot.state)
                expect(page.locator("[aria-busy=true]")).to_have_count(0)
                page.wait_for_timeout(1000)  # the camera has come to rest
                page.screenshot(path=PICTURES / shot.file)
            bytes_written = (PICTURES / shot.file).stat().st_size
            print(f"{shot.file}: {bytes_written:,} bytes")
            if bytes_written > GREATEST:
                sys.exit(f"{shot.file} is larger than {GREATEST:,} bytes")


if __name__ == "__main__":
    main()
