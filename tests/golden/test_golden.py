"""A few whole answers, kept: what moved without anybody meaning it."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import build


def leaves(tree: Any, path: str = "") -> dict[str, Any]:
    if isinstance(tree, dict):
        return {
            key: leaf
            for name, part in tree.items()
            for key, leaf in leaves(part, f"{path}/{name}").items()
        }
    if isinstance(tree, list):
        return {
            key: leaf
            for place, part in enumerate(tree)
            for key, leaf in leaves(part, f"{path}/{place}").items()
        }
    return {path: tree}


@pytest.mark.parametrize("name", build.ENGINES)
def test_an_answer_is_what_it_was(name: str) -> None:
    kept, now = (
        leaves(json.loads(build.FILE.read_text(encoding="utf-8"))[name]),
        leaves(build.answers()[name]),
    )
    assert list(now) == list(kept)
    scale = max(abs(value) for value in kept.values() if isinstance(value, float))
    for path, value in kept.items():
        assert now[path] == (
            pytest.approx(value, rel=1e-9, abs=1e-12 * scale) if isinstance(value, float) else value
        ), path
