"""Standard output without a buffer: a short write is not the end."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from crankstar.cli.output import write_bytes

COMMAND = "import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)); "


class Short(io.BytesIO):
    """Takes seven bytes at a time."""

    def write(self, content: object, /) -> int:
        return super().write(bytes(memoryview(content))[:7])  # pyright: ignore[reportArgumentType]


def test_what_is_written_in_parts_is_written_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    raw = Short()
    stream = io.TextIOWrapper(raw, write_through=True)
    monkeypatch.setattr(sys, "stdout", stream)
    write_bytes(b"forces and couples of every order", None)
    assert raw.getvalue() == b"forces and couples of every order"


@pytest.mark.skipif(os.name != "posix", reason="a limit on the size of files")
def test_a_full_disk_is_told_without_a_buffer(tmp_path: Path) -> None:
    words = "import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); "
    run = "import crankstar.__main__ as m; sys.argv[1:] = ['analyze', 'i4', '--json']; m.main()"
    with (tmp_path / "out.json").open("wb") as out:
        ended = subprocess.run(
            [sys.executable, "-u", "-c", COMMAND + words + run],
            stdout=out,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert ended.returncode == 2
    assert b"cannot be written" in ended.stderr
