"""The programs that tests need besides Python, as `tests/tools.sh` finds them."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).with_name("tools.sh")


def path_of(tool: str) -> str:
    """The path of `chromium`, `poppler` or `latex`; without it the test fails with advice."""
    answer = subprocess.run(
        ["/bin/sh", str(SCRIPT), "where", tool], capture_output=True, text=True, check=False
    )
    if answer.returncode:
        pytest.fail(answer.stderr.strip(), pytrace=False)
    return answer.stdout.strip()
