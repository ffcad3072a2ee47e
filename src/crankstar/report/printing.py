"""The report as a PDF, printed by an installed Chromium without window, network or user profile."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from crankstar.language.messages import N_, MessageError, _

BROWSERS = (
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "msedge",
)
ELSEWHERE = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "C:/Program Files/Google/Chrome/Application/chrome.exe",
    "C:/Program Files (x86)/Microsoft/Edge/Application/msedge.exe",
)
"""Browsers that are not on the search path."""
PATIENCE = 300.0
"""Seconds until a browser is stopped; a report is printed in two or three, on a busy machine in a
hundred."""
OPTIONS = (
    "--headless",
    "--disable-gpu",
    "--disable-extensions",
    "--disable-background-networking",
    "--no-first-run",
    "--no-default-browser-check",
    "--no-pdf-header-footer",
    "--virtual-time-budget=5000",  # until the fonts of the page are there
    "--host-resolver-rules=MAP * ~NOTFOUND",
)
DATES = re.compile(rb"/(?:CreationDate|ModDate) \([^)]*\)")
BY_HAND = N_("write the report as .html, open it in a browser and print it there")


class PrintingError(MessageError):
    """A report that cannot be printed; the message names a way round it."""


def browser() -> str:
    """The path of a Chromium, Chrome or Edge. Raises PrintingError."""
    program = next(filter(None, map(which, BROWSERS)), None) or next(
        (place for place in ELSEWHERE if Path(place).is_file()), None
    )
    if program is None:
        raise PrintingError(
            "a PDF needs Chromium, Chrome or Edge; install one, or {remedy}", remedy=_(BY_HAND)
        )
    return program


def pdf(page: str, *, by: str, patience: float = PATIENCE) -> bytes:
    """A page as a PDF, printed by the browser at the path `by` in at most `patience` seconds.

    The same page gives the same PDF.

    Raises PrintingError.
    """
    with TemporaryDirectory(prefix="crankstar-", ignore_cleanup_errors=True) as folder:
        source, target = Path(folder) / "report.html", Path(folder) / "report.pdf"
        source.write_text(page, encoding="utf-8")
        places = [f"--user-data-dir={folder}/profile", f"--print-to-pdf={target}", source.as_uri()]
        _run([by, *OPTIONS, *_rights(), *places], patience)
        content = target.read_bytes() if target.is_file() else b""
    if not content.startswith(b"%PDF") or b"%%EOF" not in content[-64:]:
        name = Path(by).name
        raise PrintingError("{browser} wrote no PDF; {remedy}", browser=name, remedy=_(BY_HAND))
    return DATES.sub(_undated, content)


def _undated(match: re.Match[bytes]) -> bytes:
    """The entry of a date with zeros for its digits, as a PDF counts its bytes."""
    return re.sub(rb"\d", b"0", match.group())


def _rights() -> list[str]:
    """No sandbox for root, for whom Chromium refuses to start with one."""
    return ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []


def _run(command: list[str], patience: float) -> None:
    """Run a browser with its children for `patience` seconds at most. Raises PrintingError."""
    name = Path(command[0]).name
    nothing = subprocess.DEVNULL
    try:
        process = subprocess.Popen(  # noqa: S603 - found by `browser`
            command,
            stdin=nothing,
            stdout=nothing,
            stderr=nothing,
            start_new_session=sys.platform != "win32",
        )
    except OSError as error:
        raise PrintingError(
            "{browser} cannot be started ({reason}); {remedy}",
            browser=name,
            reason=error.strerror or error,
            remedy=_(BY_HAND),
        ) from None
    try:
        code = process.wait(timeout=patience)
    except subprocess.TimeoutExpired:
        raise PrintingError(
            "{browser} did not finish in {seconds} s and was stopped; {remedy}",
            browser=name,
            seconds=f"{patience:g}",
            remedy=_(BY_HAND),
        ) from None
    finally:
        if process.poll() is None:
            _end(process)
    if code:
        raise PrintingError(
            "{browser} could not print the report (exit code {code}); {remedy}",
            browser=name,
            code=code,
            remedy=_(BY_HAND),
        )


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a browser with its children, which it leads as a group."""
    with suppress(OSError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)
    process.wait()
