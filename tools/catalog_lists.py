"""The lists of the catalog: what commands say of its engines without reading all their files.

`python tools/catalog_lists.py` writes them anew; a test compares them with the engines.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from crankstar.analyses.verdict.relatives import BALANCES, piston_balance
from crankstar.files.catalog import SUMMARIES, load, names, summary


def lists() -> dict[Path, str]:
    """The file of each list, and what is to be in it: an engine a line."""
    return {
        SUMMARIES: _lines(summary(name) for name in names()),
        BALANCES: _lines((name, *map(repr, piston_balance(load(name)))) for name in names()),
    }


def _lines(rows: Iterable[Sequence[object]]) -> str:
    return "".join("\t".join(map(str, row)) + "\n" for row in rows)


if __name__ == "__main__":
    for place, text in lists().items():
        place.write_text(text, encoding="utf-8")
