"""The reference of the Python interface: every public name has an example, and its entry."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from typing import Any

import pytest
from tests.rules.test_docs import script

import crankstar
from tools import signatures

pytestmark = pytest.mark.quick

hooks = script("hooks")
PAGE = Path(__file__).parents[2] / "docs" / "reference" / "python.md"


def methods(thing: Any) -> list[tuple[str, Any]]:
    """The public functions and properties that a class defines itself."""
    if not inspect.isclass(thing):
        return []
    out: list[tuple[str, Any]] = []
    for name, member in list(vars(thing).items()):
        function = member.fget if isinstance(member, property) else member
        function = getattr(function, "__func__", function)
        if not name.startswith("_") and inspect.isfunction(function):
            out.append((name, function))
    return out


@pytest.mark.parametrize("name", crankstar.__all__)
def test_every_public_name_is_described_and_has_an_example(name: str) -> None:
    """The example runs, as all doctests of the package do."""
    thing = getattr(crankstar, name)
    assert ">>>" in (inspect.getdoc(thing) or ""), name
    for method, function in methods(thing):
        assert inspect.getdoc(function), f"{name}.{method}"


@pytest.mark.parametrize("name", crankstar.__all__)
def test_every_public_function_says_what_its_arguments_are(name: str) -> None:
    thing = getattr(crankstar, name)
    for function in [thing] if inspect.isfunction(thing) else [f for _, f in methods(thing)]:
        parameters = inspect.signature(function).parameters.values()
        unsaid = [one.name for one in parameters if one.annotation is one.empty]
        assert [one for one in unsaid if one not in ("self", "cls")] == []


def entries() -> set[str]:
    """The names that the page describes, by themselves or as members of a module."""
    out = set(re.findall(r"^### (crankstar\.\w+)$", hooks.functions(""), re.MULTILINE))
    for block in re.findall(
        r"^::: (\S+)\n((?:    .*\n)*)", PAGE.read_text(encoding="utf-8"), re.MULTILINE
    ):
        path, options = block
        members = re.search(r"members: \[(.*?)\]", options)
        out |= {f"{path}.{name}" for name in members[1].split(", ")} if members else {path}
    return out


@pytest.mark.parametrize("name", crankstar.__all__)
def test_every_public_name_has_an_entry_in_the_reference(name: str) -> None:
    thing = getattr(crankstar, name)
    home = f"{thing.__module__}.{thing.__name__}"
    known = entries()
    assert home in known or thing.__module__ in known, home


def test_the_types_of_the_functions_are_those_that_they_read() -> None:
    """`make types` writes them anew."""
    for stub, text in (
        (signatures.STUB, signatures.stub()),
        (signatures.PUBLIC, signatures.public_stub()),
    ):
        assert signatures.formatted(text) == stub.read_text(encoding="utf-8")
