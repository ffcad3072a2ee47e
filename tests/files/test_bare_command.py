"""`crankstar` alone: help in a script, the gallery in a terminal with a browser."""

from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
import sys
from pathlib import Path
from urllib.request import urlopen

import pytest
from tests.holding import PATIENCE, awaited

COMMAND = [sys.executable, "-m", "crankstar"]


def surroundings(**more: str) -> dict[str, str]:
    kept = {k: v for k, v in os.environ.items() if k not in ("CI", "DISPLAY", "WAYLAND_DISPLAY")}
    kept.pop("BROWSER", None)
    return {**kept, "TERM": "xterm", **more}


def started(env: dict[str, str]) -> tuple[int, int]:
    """A bare command in a terminal of its own: its process, the other end of the terminal."""
    process, terminal = pty.fork()
    if process == 0:
        # a suite that was started in the background ignores interrupts, and so would its children
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.execve(COMMAND[0], COMMAND, env)  # noqa: S606
    return process, terminal


def said_by(terminal: int) -> str:
    """All that is written to a terminal until nobody can any more."""
    said = b""
    while True:
        try:
            said += os.read(terminal, 65536)
        except OSError:  # the other end is closed
            return re.sub(r"\x1b\[[\d;?]*[a-zA-Z]", "", said.decode(errors="replace"))


@pytest.mark.parametrize("more", [{}, {"DISPLAY": ":0", "BROWSER": "/bin/true"}])
def test_without_a_terminal_it_prints_help_and_ends(more: dict[str, str]) -> None:
    ran = subprocess.run(
        COMMAND,
        env=surroundings(**more),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=True,
    )
    assert "Usage: crankstar" in ran.stdout
    assert "analyze" in ran.stdout
    assert ran.stderr == ""


@pytest.mark.parametrize("more", [{}, {"CI": "true", "BROWSER": "/bin/true"}])
def test_in_a_terminal_without_a_browser_or_in_ci_it_prints_help(more: dict[str, str]) -> None:
    process, terminal = started(surroundings(**more))
    said = said_by(terminal)
    os.close(terminal)
    assert "Usage: crankstar" in said
    assert os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]) == 0


def test_in_a_terminal_with_a_browser_it_serves_the_gallery(tmp_path: Path) -> None:
    opened, browser = tmp_path / "opened", tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > "{opened}.new" && mv "{opened}.new" "{opened}"\n')
    browser.chmod(0o755)
    process, terminal = started(surroundings(BROWSER=str(browser)))
    try:
        awaited(opened.exists)
        address = opened.read_text().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/gallery", address)
        with urlopen(address, timeout=PATIENCE) as answer:  # noqa: S310 - of this machine
            assert b"radial-9" in answer.read()
    finally:
        os.kill(process, signal.SIGINT)
        said = said_by(terminal)
        code = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
        os.close(terminal)
    assert "Ctrl-C stops the server" in said
    assert code == 0
