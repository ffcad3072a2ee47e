"""The report as a PDF, printed by a Chromium that the machine has: without a window, a network, or a profile of its owner."""

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

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
ELSEWHERE = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "C:/Program Files/Google/Chrome/Application/chrome.exe",
    "C:/Program Files (x86)/Microsoft/Edge/Application/msedge.exe",
)
"""Where browsers are that are not among the commands."""
PATIENCE = 60.0
"""Seconds after which a browser is taken to hang; a report is printed in two or three."""
OPTIONS = (
    "--headless",
    "--disable-gpu",
    "--disable-extensions",
    "--disable-background-networking",
    "--no-first-run",
    "--no-default-browser-check",
    "--no-pdf-header-footer",  # the page numbers are in the style sheet; the browser's own tell date and place
    "--host-resolver-rules=MAP * ~NOTFOUND",
)
DATES = re.compile(rb"/(?:CreationDate|ModDate) \([^)]*\)")
BY_HAND = "write the report as .html, open it in a browser and print it there"


class PrintingError(ValueError):
    """A report that cannot be printed, as one sentence that says what can be done."""


def browser() -> str:
    """The path of a Chromium, Chrome or Edge. Raises PrintingError."""
    found = next(filter(None, map(which, BROWSERS)), None) or next((place for place in ELSEWHERE if Path(place).is_file()), None)
    if found is None:
        raise PrintingError(f"a PDF needs Chromium, Chrome or Edge, and none is found; install one, or {BY_HAND}")
    return found


def pdf(page: str, *, by: str, patience: float = PATIENCE) -> bytes:
    """A page as a PDF, printed by the browser at the path `by` in at most `patience` seconds. The same page gives the same PDF.

    Raises PrintingError.
    """
    with TemporaryDirectory(prefix="crankstar-", ignore_cleanup_errors=True) as folder:
        source, target = Path(folder) / "report.html", Path(folder) / "report.pdf"
        source.write_text(page, encoding="utf-8")
        _run([by, *OPTIONS, *_rights(), f"--user-data-dir={folder}/profile", f"--print-to-pdf={target}", source.as_uri()], patience)
        content = target.read_bytes() if target.is_file() else b""
    if not content.startswith(b"%PDF") or b"%%EOF" not in content[-64:]:
        raise PrintingError(f"{Path(by).name} wrote no PDF; {BY_HAND}")
    return DATES.sub(_undated, content)


def _undated(found: re.Match[bytes]) -> bytes:
    """The entry of a date with zeros for its digits: as long as before, since a PDF counts its bytes."""
    return re.sub(rb"\d", b"0", found.group())


def _rights() -> list[str]:
    """Chromium refuses to be run by root with its sandbox, and only then goes without."""
    return ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []


def _run(command: list[str], patience: float) -> None:
    """Run a browser and all that it starts, to the end or until patience ends. Raises PrintingError."""
    name = Path(command[0]).name
    nothing = subprocess.DEVNULL
    try:
        process = subprocess.Popen(  # noqa: S603 - found by `browser`
            command, stdin=nothing, stdout=nothing, stderr=nothing, start_new_session=sys.platform != "win32"
        )
    except OSError as error:
        raise PrintingError(f"{name} cannot be started ({error.strerror or error}); {BY_HAND}") from None
    try:
        code = process.wait(timeout=patience)
    except subprocess.TimeoutExpired:
        raise PrintingError(f"{name} has not printed the report after {patience:g} s and was stopped; {BY_HAND}") from None
    finally:
        if process.poll() is None:
            _end(process)
    if code:
        raise PrintingError(f"{name} could not print the report (it ended with code {code}); {BY_HAND}")


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a browser with its children, which it leads as a group."""
    with suppress(OSError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)
    process.wait()
