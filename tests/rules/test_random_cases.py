"""Which random cases a test tries hangs on nothing but the test and the seed."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st

NUMBER, WORD = 271.8281, "a word of a module"


def cases() -> list[tuple[float, int, str]]:
    """What a strategy gives with one seed."""
    out: list[tuple[float, int, str]] = []

    @seed(1)
    @settings(max_examples=300, database=None)
    @given(st.floats(0, 1000), st.integers(0, 10**6), st.text())
    def test(number: float, whole: int, text: str) -> None:
        out.append((number, whole, text))

    test()
    return out


def test_the_modules_that_are_loaded_make_no_difference(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = cases()
    assert len(set(before)) > 250
    folder: Path = tmp_path_factory.mktemp("loaded")
    text = f"NUMBERS = {NUMBER}, {[*range(70_000, 71_000)]}\nWORD = {WORD!r}\n"
    (folder / "numbers_of_a_module.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(folder)
    assert import_module("numbers_of_a_module").WORD == WORD
    assert cases() == before
