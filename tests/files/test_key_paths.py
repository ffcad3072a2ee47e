"""Key paths: what a mistake prints is what --set reads."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.commands import Run

from crankstar.files import changed, keys_of
from crankstar.files.changes import path_and_value
from crankstar.language.faults import where

KEYS = st.text(st.characters(exclude_categories=["Cs"]), max_size=60)
PATHS = st.tuples(KEYS, st.lists(KEYS | st.integers(0, 99_999), max_size=4))


@given(PATHS)
def test_every_path_that_is_printed_leads_to_its_place(path: tuple[str, list[str | int]]) -> None:
    keys = [path[0], *path[1]]
    printed = where(tuple(keys))
    assert printed.isprintable()
    assert keys_of(printed) == keys
    assert path_and_value(f"{printed} = a=b") == (printed, "=", " a=b")


@pytest.mark.parametrize(
    ("path", "keys"),
    [
        ('provenance."cylinder.rod.mass".range', ["provenance", "cylinder.rod.mass", "range"]),
        ("provenance.'shaft[1].z'", ["provenance", "shaft[1].z"]),
        ('"layout"."banks"[2]', ["layout", "banks", 1]),
        ('a."b', ['a."b']),
        ('"a"b', ['"a"b']),
        (r'"\q"', [r'"\q"']),
        ("layout.banks[²]", ["layout.banks[²]"]),
    ],
)
def test_keys_are_quoted_as_in_toml(path: str, keys: list[str | int]) -> None:
    assert keys_of(path) == keys


@pytest.mark.release
def test_the_range_of_an_estimate_is_set_by_the_path_of_its_mistake(
    run: Run, tmp_path: Path
) -> None:
    run("estimate", "toyota-2jz", "-o", "est.json")
    file = tmp_path / "est.json"
    tree = json.loads(file.read_text(encoding="utf-8"))
    mass = next(path for path in tree["provenance"] if path.endswith("mass"))
    path = f'provenance."{mass}".range'
    wrong = run("analyze", "est.json", "--set", f"{path}=[2, 3]")
    assert (wrong.code, f"{path} " in wrong.err) == (2, True)
    assert run("analyze", "est.json", "--set", f"{path}=[0.5, 2]").code == 0
    twice = run("analyze", "est.json", "--set", f"{path}=[0.5, 2]", "--set", f"{path} =[0.5, 3]")
    assert "is set before" in twice.err


def test_a_quoted_path_sets_and_turns_what_the_bare_one_does() -> None:
    sources = {"cylinder.bore": {"status": "estimated"}}
    tree = {"cylinder": {"bore": "80 mm"}, "provenance": sources}
    assert changed(tree, {'"cylinder"."bore"': 0}) == changed(tree, {"cylinder.bore": 0})
    assert changed(tree, {"cylinder.bore": 0})["provenance"] == {}


def test_a_path_into_a_table_that_was_given_with_it_leaves_that_as_it_is() -> None:
    rod = {"mass": "550 g", "centre": "40 mm"}
    tree = changed({"cylinder": {}}, {"cylinder.rod": rod, "cylinder.rod.mass": "500 g"})
    assert tree["cylinder"]["rod"] == {"mass": "500 g", "centre": "40 mm"}
    assert rod == {"mass": "550 g", "centre": "40 mm"}
