"""The widget in JupyterLab: an engine turns in a cell, the next one sets and reads its angle."""

from __future__ import annotations

import json
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.web.browsing import HANG, root
from tests.web.engine_page import farthest_off

import crankstar

pytestmark = pytest.mark.release
TOKEN = "0123456789abcdef"  # noqa: S105 - of a server that answers here only, for a minute
CELLS = [
    "import crankstar\nengine = crankstar.widget('v8-cross-plane')\nengine",
    "engine.theta = 77\nengine.playing",
    "engine.playing = True",
    "engine.playing = False",
    "print('the angle is', engine.theta)",
]
ENGINE = (
    "[...document.querySelectorAll('.jp-OutputArea-output *')].find(element => element.crankstar)"
)
STARTS_WITHIN = 120.0


@pytest.fixture
def lab(tmp_path: Path) -> Iterator[str]:
    """The address of a local JupyterLab with one notebook; nothing of it remains afterwards."""
    if find_spec("jupyterlab") is None:
        pytest.fail(
            'JupyterLab is missing: make release installs it, or pip install -e ".[notebook]"',
            pytrace=False,
        )
    cells = [
        {
            "cell_type": "code",
            "metadata": {},
            "execution_count": None,
            "outputs": [],
            "source": text,
        }
        for text in CELLS
    ]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    notebook = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 4}
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    homes = {
        name: str(tmp_path / name)
        for name in (
            "HOME",
            "JUPYTER_CONFIG_DIR",
            "JUPYTER_DATA_DIR",
            "JUPYTER_RUNTIME_DIR",
            "IPYTHONDIR",
        )
    }
    for home in homes.values():
        Path(home).mkdir()
    folder = tmp_path / "notebooks"
    folder.mkdir()
    (folder / "engine.ipynb").write_text(json.dumps(notebook), encoding="utf-8")
    own = [
        f"--ServerApp.root_dir={folder}",
        f"--IdentityProvider.token={TOKEN}",
        "--ServerApp.ip=127.0.0.1",
        f"--ServerApp.port={port}",
    ]
    quiet = [
        "--no-browser",
        "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    ]
    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        *own,
        *quiet,
        *(["--allow-root"] if root() else []),
    ]
    with (tmp_path / "log").open("w") as log:
        server = subprocess.Popen(
            command, cwd=tmp_path, env={**os.environ, **homes}, stdout=log, stderr=log
        )
    try:
        address = f"http://127.0.0.1:{port}"
        _answered(f"{address}/api?token={TOKEN}", server, tmp_path / "log")
        yield f"{address}/lab/tree/engine.ipynb?token={TOKEN}"
    finally:
        server.terminate()
        server.wait(20)


def _answered(address: str, server: subprocess.Popen[bytes], log: Path) -> None:
    """Waits until the server answers."""
    end = time.monotonic() + STARTS_WITHIN
    while server.poll() is None and time.monotonic() < end:
        try:
            urlopen(address).close()  # noqa: S310 - our own server
        except URLError:
            time.sleep(0.2)
        else:
            return
    pytest.fail(f"JupyterLab does not start:\n{log.read_text()[-2000:]}")


def run(page: Page, place: int) -> None:
    """Runs a cell, again where JupyterLab, still drawing itself, has missed the keys."""
    cell = page.locator(".jp-CodeCell").nth(place)
    for _ in range(5):
        cell.locator(".cm-content").click()
        page.keyboard.press("Shift+Enter")
        with suppress(AssertionError):
            expect(cell.locator(".jp-InputPrompt")).not_to_have_text("[ ]:", timeout=10_000)
            return
    pytest.fail(f"cell {place} does not run")


def test_an_engine_turns_in_jupyterlab(lab: str, browser: Browser) -> None:
    # not watched as our own pages are: JupyterLab has its sockets, and its own warnings
    broken: list[str] = []
    context = browser.new_context(viewport={"width": 1400, "height": 1000})
    context.on("weberror", lambda error: broken.append(str(error.error)))
    context.set_default_timeout(HANG)
    with context, context.new_page() as page:
        page.goto(lab)
        page.locator(".jp-CodeCell").first.click()
        expect(page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]")).to_be_attached()
        run(page, 0)
        page.wait_for_function(f"() => {ENGINE}")
        page.evaluate(f"async () => await {ENGINE}.crankstar.ready")
        run(page, 1)
        page.wait_for_function(f"() => {ENGINE}.crankstar.theta === 77")
        read = page.evaluate(f"() => {ENGINE}.crankstar.read().pistons")
        at = {int(number): place for number, place in read.items()}
        assert farthest_off(crankstar.load("v8-cross-plane"), [at], [77.0]) < 1e-6
        run(page, 2)
        page.wait_for_function(
            f"() => {ENGINE}.crankstar.playing && {ENGINE}.crankstar.theta > 100"
        )
        run(page, 3)
        page.wait_for_function(f"() => !{ENGINE}.crankstar.playing")
        theta = page.evaluate(f"() => {ENGINE}.crankstar.theta")
        # what the page has to say is sent when the kernel is idle
        expect(page.locator(".jp-Notebook-ExecutionIndicator[data-status=idle]")).to_be_attached()
        run(page, 4)
        said = page.locator(".jp-OutputArea-output", has_text="the angle is")
        expect(said).to_be_visible()
        found = re.search(r"the angle is ([\d.]+)", said.inner_text())
        assert found
        assert float(found[1]) == pytest.approx(theta, abs=1e-6)
    assert broken == []
