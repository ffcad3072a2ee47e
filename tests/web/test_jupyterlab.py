"""The widget in JupyterLab: an engine turns in a cell, the next one sets and reads its angle."""

from __future__ import annotations

import json
import os
import re
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.holding import PATIENCE
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
UP = "is running at:"
"""JupyterLab's own word for it."""


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
    server = subprocess.Popen(
        command,
        cwd=tmp_path,
        env={**os.environ, **homes},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert server.stderr is not None
    said: list[str] = []
    listener = threading.Thread(target=said.extend, args=(server.stderr,), daemon=True)
    try:
        for line in server.stderr:
            said.append(line)
            if UP in line:
                break
        else:
            pytest.fail(f"JupyterLab does not start:\n{''.join(said)[-2000:]}")
        listener.start()  # or it would stand still once the pipe is full
        yield f"http://127.0.0.1:{port}/lab/tree/engine.ipynb?token={TOKEN}"
    finally:
        server.terminate()
        server.wait(PATIENCE)
        if listener.ident is not None:
            listener.join(PATIENCE)
        server.stderr.close()


def run(page: Page, place: int) -> None:
    """Runs a cell once JupyterLab edits it, for until then it does not hear the keys."""
    cell = page.locator(".jp-CodeCell").nth(place)
    cell.locator(".cm-content").click()
    expect(cell).to_have_class(re.compile(r"\bjp-mod-active\b"))
    expect(page.locator(".jp-Notebook.jp-mod-editMode")).to_be_attached()
    expect(cell.locator(".cm-content")).to_be_focused()
    page.keyboard.press("Shift+Enter")
    expect(cell.locator(".jp-InputPrompt")).not_to_have_text("[ ]:")


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
