"""Measurements as a table, printed or (--write) put into docs/reference/performance.md."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

PAGE = Path(__file__).parent.parent / "docs" / "reference" / "performance.md"
Row = tuple[str, str, str]
"""What is measured, the figure, and the budget where there is one."""


def show(name: str, rows: Sequence[Row]) -> None:
    """Prints the table of that name, and with --write puts it in the docs."""
    lines = [
        "| what | median | budget |",
        "|---|---|---|",
        *(f"| {' | '.join(row)} |" for row in rows),
    ]
    print("\n".join(lines))
    if "--write" in sys.argv:
        start, end = f"<!-- table: {name} -->", f"<!-- end: {name} -->"
        before, rest = PAGE.read_text(encoding="utf-8").split(start)
        after = rest.split(end)[-1]
        PAGE.write_text(
            f"{before}{start}\n\n" + "\n".join(lines) + f"\n\n{end}{after}", encoding="utf-8"
        )
