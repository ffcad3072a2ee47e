"""What a command costs from start to end, as a multiple of a bare `import numpy` in the run.

Whole processes, by turns, so that what else the machine does disturbs all alike; the first round,
in which Python writes its byte code and numba its cache, is not counted. With all extras installed.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from statistics import median
from time import perf_counter

import tables

NUMPY = "import numpy"
COMMANDS: dict[str, tuple[tuple[str, ...], float | None]] = {
    "import crankstar": (("-c", "import crankstar"), None),
    "analyze": (("analyze", "v8-cross-plane"), 5),
    "search 12": (("search", "12"), 6),
    "plot": (("plot", "v8-cross-plane", "hodograph", "-o", "plot.svg"), 8),
    "page": (("page", "v8-cross-plane", "-o", "page.html"), 12),
    "page of a Deltic": (("page", "napier-deltic", "-o", "page.html"), 18),
    "report": (("report", "v8-cross-plane", "-o", "report.html"), 20),
}
"""What is measured, and the multiple that it may take."""
ROUNDS = 7


def seconds(arguments: tuple[str, ...], folder: str) -> float:
    """How long a process takes, with byte code kept as an installation keeps it."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    command = arguments if arguments[0] == "-c" else ("-m", "crankstar", *arguments)
    began = perf_counter()
    subprocess.run(
        [sys.executable, *command], check=True, capture_output=True, cwd=folder, env=kept
    )
    return perf_counter() - began


def rows() -> list[tables.Row]:
    """What is measured, the multiple, and the budget where there is one."""
    times: dict[str, list[float]] = {name: [] for name in (NUMPY, *COMMANDS)}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS + 1):
            times[NUMPY].append(seconds(("-c", NUMPY), folder))
            for name, (arguments, _) in COMMANDS.items():
                times[name].append(seconds(arguments, folder))
    unit = median(times[NUMPY][1:])
    out: list[tables.Row] = [(NUMPY, f"{unit:.3f} s", "")]
    for name, (_, budget) in COMMANDS.items():
        found = median(times[name][1:])
        shown = f"{found / unit:.1f} times ({found:.2f} s)"
        out.append((name, shown, f"{budget:g} times" if budget else ""))
    return out


if __name__ == "__main__":
    tables.show("start", rows())
