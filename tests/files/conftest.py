"""Command lines run in an empty directory."""

from __future__ import annotations

import io
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Ran, Run, replaced

from crankstar import cli

WRITTEN = re.compile(
    r"^(Wrote |Replaced |Estimated\b|None of orders? |No [a-z_, ]+ at |Not in the(?:se)? "
    r"|--set [a-z_., ]+ changes nothing |package [^\n]+: its |(?:All|Each) at [^\n]+ file"
    r"|--[a-z]+ changes nothing |The file gives no |Shapes are |At [a-z_.]+ = |Interrupted: "
    r"|Записан файл ).*\n"
    r"|^.* rests on:\n(?:.+\n)*",
    re.MULTILINE,
)
"""Lines on standard error of a success: a file written, what is estimated, not there, doubtful.

Last what a figure rests on.
"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    """Run a command line in an empty directory; it ends with 0 or 2 and prints printable text."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Path, "replace", replaced)

    def ran(*arguments: str, stdin: bytes = b"") -> Ran:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin)))
        with pytest.raises(SystemExit) as left:
            cli.main(arguments)
        code, (out, err) = left.value.code, capsys.readouterr()
        assert code in (0, 2)
        assert (code == 2) == bool(WRITTEN.sub("", err))
        assert "Traceback" not in out + err
        assert all(line.isprintable() for line in [*out.split("\n"), *err.split("\n")])
        assert not err or len(err) < 5000
        assert not list(tmp_path.glob(".*"))
        return Ran(int(code), out, err)

    return ran


@pytest.fixture
def refused(run: Run) -> Callable[..., str]:
    """Run a command line that must be refused without having printed anything; what it is told."""

    def told(*arguments: str, **more: Any) -> str:
        result = run(*arguments, **more)
        assert (result.code, result.out) == (2, "")
        assert result.err.startswith("crankstar: ")
        return result.err

    return told
