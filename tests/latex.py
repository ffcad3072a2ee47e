"""A document typeset by LaTeX, and what LaTeX had against it."""

from __future__ import annotations

import os
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from tests.tools import path_of

LONGEST = 120.0
"""Seconds that a document may take."""


@dataclass(frozen=True, slots=True)
class Compiled:
    """A typeset document: whether it is complete, its pages, and its errors, each with its line."""

    ok: bool
    pages: int
    errors: tuple[str, ...]
    log: str

    def __str__(self) -> str:
        return (
            f"typeset, pages: {self.pages}"
            if self.ok
            else "\n".join(self.errors or ("no page was typeset",))
        )


def compiled(source: str, folder: Path) -> Compiled:
    """The document as pdflatex leaves it in the folder, in `document.pdf` if it is right."""
    (folder / "document.tex").write_text(source, encoding="utf-8")
    command = [
        path_of("latex"),
        "-interaction=nonstopmode",
        "-halt-on-error",
        "-file-line-error",
        "-no-shell-escape",
        "document.tex",
    ]
    whole_lines = {**os.environ, "max_print_line": "10000"}
    try:
        run = subprocess.run(
            command,
            cwd=folder,
            env=whole_lines,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=LONGEST,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Compiled(
            ok=False,
            pages=0,
            errors=(f"LaTeX was not ready after {LONGEST:g} s",),
            log=_log(folder),
        )
    log = _log(folder)
    written = re.search(r"^Output written on .* \((\d+) pages?", log, re.MULTILINE)
    pages = int(written[1]) if written else 0
    return Compiled(ok=run.returncode == 0 and pages > 0, pages=pages, errors=_errors(log), log=log)


def _log(folder: Path) -> str:
    log = folder / "document.log"
    return log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""


def _errors(log: str) -> tuple[str, ...]:
    """`line 5: Undefined control sequence. At: x = \\nonsense` for every error in a log."""
    # an arrow repeats that there was an error
    start = r"^(?:\./document\.tex:(?P<line>\d+): |! )(?! ?==> )"
    errors: list[str] = []
    for error in re.finditer(rf"{start}(?P<what>.*)(?P<rest>(?:\n.*){{0,12}})", log, re.MULTILINE):
        place = re.search(r"^l\.(?P<line>\d+) (?P<at>.*)$", error["rest"], re.MULTILINE)
        line = error["line"] or (place["line"] if place else "")
        at = place["at"].strip() if place else ""
        errors.append(
            (f"line {line}: " if line else "")
            + error["what"].strip()
            + (f" At: {at}" if at else "")
        )
    return tuple(errors)
