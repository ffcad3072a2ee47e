"""Doctests in the docstrings shown as Python examples, wherever in the text they stand."""

from __future__ import annotations

from typing import Any

from griffe import Extension, Object


class Doctests(Extension):
    """Puts a fence round every run of lines that starts with the prompt of Python."""

    def on_object(self, *, obj: Object, **_: Any) -> None:
        """Called for every object whose docstring has been read."""
        if obj.docstring is not None:
            obj.docstring.value = fenced(obj.docstring.value)


def fenced(text: str) -> str:
    """A docstring in which each doctest, up to the next blank line, is a block of its own."""
    paragraphs = [
        f"```pycon\n{part.strip()}\n```" if part.lstrip().startswith(">>>") else part
        for part in text.split("\n\n")
    ]
    return "\n\n".join(paragraphs)
