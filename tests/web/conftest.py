"""A browser for tests of pages, and a page in it that must have nothing to complain about."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.web.browsing import chromium, settled, watched
from tests.web.engine_page import written
from tests.web.serving import server

__all__ = ["browser", "built_page", "page", "server"]


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium without a window."""
    if os.environ.get("CRANKSTAR_NO_BROWSER") == "1":
        pytest.skip("CRANKSTAR_NO_BROWSER=1")
    with settled(), chromium() as started:
        yield started


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """An empty page; the test fails on console warnings, script errors and network requests."""
    complaints: list[str] = []
    with watched(browser, complaints) as page:
        yield page
    if complaints:
        pytest.fail("\n".join(["the page complains:", *dict.fromkeys(complaints)]), pytrace=False)


@pytest.fixture(scope="session")
def built_page(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """The page of one or two catalog engines, written once: `built_page("v8-cross-plane")`."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base) / "pages"
    folder.mkdir(exist_ok=True)

    def build(*names: str, figures: bool = False) -> Path:
        return written(folder, *names, figures=figures)

    return build
