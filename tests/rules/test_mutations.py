"""Every fault that `tools/mutations.py` makes on purpose can still be made."""

from __future__ import annotations

import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_what_a_mutation_replaces_is_there() -> None:
    text = (ROOT / "tools" / "mutations.toml").read_text(encoding="utf-8")
    gone = [
        each["name"]
        for each in tomllib.loads(text)["mutation"]
        if each["old"] not in (ROOT / each["file"]).read_text(encoding="utf-8")
    ]
    assert gone == []
