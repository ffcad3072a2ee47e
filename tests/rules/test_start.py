"""Which heavy libraries a command may load: each takes longer than all of a small command."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.quick

HEAVY = {
    *(
        "altair",
        "anywidget",
        "asyncio",
        "PIL.Image",
        "imageio_ffmpeg",
        "babel",
        "clarabel",
        "cyclopts",
        "dask",
        "distributed",
    ),
    *(
        "fastapi",
        "flint",
        "numba",
        "numpy.ma",
        "openpyxl",
        "pandas",
        "pint",
        "pyarrow",
        "rich.live",
    ),
    *("rich.table", "scipy", "scipy.linalg", "scipy.optimize", "uvicorn", "vl_convert", "xarray"),
}
TERMINAL = {"cyclopts", "rich.table"}
MAY_LOAD = {
    "analyze i4": TERMINAL,
    "analyze i4 --json": {"cyclopts"},
    "check i4": {"cyclopts"},
    "strokes i4": TERMINAL,
    "verdict i4": TERMINAL,
    "derive i4": {*TERMINAL, "flint"},
    "search 5": {*TERMINAL, "flint", "numba", "numpy.ma", "scipy"},
    "plot i4 hodograph -o x.svg": {"cyclopts", "vl_convert"},
    "draw i4 -o x.svg": {"cyclopts"},
    "animate i4 --seconds 0.2 -o x.gif": {"cyclopts", "vl_convert", "PIL.Image"},
    "page i4 -o x.html": {"cyclopts", "flint"},
    "report i4 -o x.html": {"cyclopts", "flint", "vl_convert", "asyncio"},
}
"""A command, and the heavy modules that it cannot do without. Search 5 has its loops compiled."""

SELDOM = {"analyze i4 --json", "check i4", "strokes i4", "verdict i4", "derive i4"}
"""Commands that load as much as others do; seen in `make release`."""

SAID = """
import sys
from crankstar.__main__ import main
sys.argv[0] = "crankstar"
try:
    main()
finally:
    print(*sys.modules, file=sys.stderr)
"""


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    "command",
    [
        pytest.param(command, marks=[pytest.mark.release] * (command in SELDOM))
        for command in MAY_LOAD
    ],
)
def test_a_command_loads_the_heavy_libraries_it_needs_and_no_other(
    command: str, tmp_path: Path
) -> None:
    words = [sys.executable, "-c", SAID, *command.split()]
    if "search" in command:  # the first one may compile
        subprocess.run(words, check=True, capture_output=True, cwd=tmp_path)
    ran = subprocess.run(words, check=True, capture_output=True, text=True, cwd=tmp_path)
    loaded = set(ran.stderr.splitlines()[-1].split())
    assert loaded & HEAVY <= MAY_LOAD[command]
