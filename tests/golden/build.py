"""Writes the answers with which test_golden.py compares the program.

`python tests/golden/build.py` after an intended change.

They prove nothing (the laws do that); they show that a number, or the public shape of the answer,
has moved.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from crankstar import load
from crankstar.mechanics.balance import balance
from crankstar.tables.balance_orders import answer
from crankstar.tables.machine import tree

FILE = Path(__file__).parent / "answers.json"
ENGINES = ("v8-cross-plane", "audi-25-tfsi", "kr250-racer", "radial-9", "napier-deltic")


def answers() -> dict[str, Any]:
    """The machine-readable answers of a few engines, each at its own speed."""
    engines = {name: load(name) for name in ENGINES}
    return {
        name: tree(answer(engine, balance(engine, speed=engine.speed)))
        for name, engine in engines.items()
    }


if __name__ == "__main__":
    FILE.write_text(json.dumps(answers(), indent=1) + "\n", encoding="utf-8")
