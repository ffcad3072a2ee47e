"""`crankstar` alone: help in a script, the gallery in a terminal with a browser."""

from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path
from urllib.request import urlopen

import pytest
from tests.holding import PATIENCE, awaited

COMMAND = [sys.executable, "-m", "crankstar"]


def surroundings(**more: str) -> dict[str, str]:
    kept = {k: v for k, v in os.environ.items() if k not in ("CI", "DISPLAY", "WAYLAND_DISPLAY")}
    kept.pop("BROWSER", None)
    return {**kept, "TERM": "xterm", **more}


class Running:
    """A bare command in a terminal, whose output is read as it comes, as a person's is.

    A terminal that nobody reads is full after 4 kB, and who writes to it waits for good.
    """

    def __init__(self, env: dict[str, str]) -> None:
        self._terminal, other = pty.openpty()
        self.process = subprocess.Popen(
            COMMAND, env=env, stdin=other, stdout=other, stderr=other, start_new_session=True
        )
        os.close(other)
        self._read = bytearray()
        self._reader = threading.Thread(target=self._follow, daemon=True)
        self._reader.start()

    def _follow(self) -> None:
        while True:
            try:
                self._read += os.read(self._terminal, 65536)
            except OSError:  # the other end is closed
                return

    def ended(self) -> tuple[str, int]:
        """All that was written until nobody could any more, and the exit code."""
        code = self.process.wait(PATIENCE)
        self._reader.join(PATIENCE)
        os.close(self._terminal)
        return re.sub(r"\x1b\[[\d;?]*[a-zA-Z]", "", self._read.decode(errors="replace")), code


@pytest.mark.release
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


@pytest.mark.release
@pytest.mark.parametrize("more", [{}, {"CI": "true", "BROWSER": "/bin/true"}])
def test_in_a_terminal_without_a_browser_or_in_ci_it_prints_help(more: dict[str, str]) -> None:
    said, code = Running(surroundings(**more)).ended()
    assert "Usage: crankstar" in said
    assert code == 0


@pytest.mark.release
def test_in_a_terminal_with_a_browser_it_serves_the_gallery(tmp_path: Path) -> None:
    opened, browser = tmp_path / "opened", tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > "{opened}.new" && mv "{opened}.new" "{opened}"\n')
    browser.chmod(0o755)
    running = Running(surroundings(BROWSER=str(browser)))
    try:
        awaited(opened.exists)
        address = opened.read_text().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/gallery", address)
        with urlopen(address, timeout=PATIENCE) as answer:  # noqa: S310 - of this machine
            assert b"radial-9" in answer.read()
    finally:
        running.process.send_signal(signal.SIGINT)
        said, code = running.ended()
    assert "Ctrl-C stops the server" in said
    assert code == 0
