"""The documents as built: opened from disk without network, on wide and narrow screens."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from playwright.sync_api import Page
from tests.web.browsing import too_wide

ROOT = Path(__file__).parents[2]
BUILT = ROOT / ".venv" / "site"
TELEPHONE = 400
"""Pixels across."""


def in_order(nav: list[Any]) -> Iterator[str]:
    """The pages of a navigation, whatever sections it has."""
    for entry in nav:
        for value in entry.values() if isinstance(entry, dict) else [entry]:
            if isinstance(value, list):
                yield from in_order(value)
            else:
                yield value


PAGES = [
    Path(name).stem
    for name in in_order(yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"])
]


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The documents of `make docs`, built here if they changed since."""
    sources = [
        ROOT / "mkdocs.yml",
        *(path for path in (ROOT / "docs").rglob("*.*") if path.suffix != ".pyc"),
    ]
    index = BUILT / "index.html"
    if index.exists() and index.stat().st_mtime > max(path.stat().st_mtime for path in sources):
        return BUILT
    folder = tmp_path_factory.mktemp("site")
    command = [
        sys.executable,
        "-m",
        "mkdocs",
        "build",
        "--strict",
        "--quiet",
        "--site-dir",
        str(folder),
    ]
    subprocess.run(command, cwd=ROOT, env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, check=True)
    return folder


@pytest.mark.parametrize("name", PAGES)
def test_every_page_opens_from_disk_with_one_title_and_fits_a_telephone(
    name: str, site: Path, page: Page
) -> None:
    page.goto((site / f"{name}.html").as_uri())
    assert page.locator("h1").count() == 1
    assert page.locator("h1").is_visible()
    assert page.title()
    page.set_viewport_size({"width": TELEPHONE, "height": 800})
    assert too_wide(page) == []
