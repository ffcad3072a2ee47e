"""A browser for tests of pages, and a page in it that must have nothing to complain about."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, sync_playwright
from tests.tools import path_of
from tests.web.browsing import ARGUMENTS, root, watched
from tests.web.serving import server

__all__ = ["browser", "page", "server"]


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium without a window."""
    if os.environ.get("CRANKSTAR_NO_BROWSER") == "1":
        pytest.skip("CRANKSTAR_NO_BROWSER=1")
    chromium = path_of("chromium")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, chromium_sandbox=not root(), args=ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """An empty page; the test fails if the console has a warning, a script breaks or anything is asked of the network."""
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        yield page
    if complaints:
        pytest.fail("\n".join(["the page complains:", *dict.fromkeys(complaints)]), pytrace=False)
