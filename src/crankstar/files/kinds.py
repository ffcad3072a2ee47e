"""What a file is, by its first lines, where it is plainly of another kind than the one wanted."""

from __future__ import annotations

import csv
import json
import re
import tomllib
from typing import Literal

Kind = Literal["picture", "page", "list", "engine"]
HEADS = {"picture": r"(<\?xml.*?>\s*)?(<!--.*?-->\s*)?<svg\b", "page": r"<(!doctype html|html)\b"}
KEYS = {"cylinder", "cylinders", "layout", "shaft", "torsion"}
"""Tables of an engine file, or of a drive line, of which each has one."""


def kind_of(text: str) -> Kind | None:
    r"""The kind of a text that can be told; None where it cannot.

    >>> kind_of("<svg width='3'/>"), kind_of("no,piston [g]\n1,412"), kind_of("layout.type = 'vee'")
    ('picture', 'list', 'engine')
    >>> kind_of("name = 3,4")
    """
    start = text.removeprefix("\ufeff").lstrip()
    for kind in ("picture", "page"):
        if re.match(HEADS[kind], start[:2000], re.IGNORECASE | re.DOTALL):
            return kind
    if _is_engine(start):
        return "engine"
    return "list" if _is_list(start) else None


def _is_engine(text: str) -> bool:
    try:
        tree = json.loads(text) if text.startswith("{") else tomllib.loads(text)
    except (ValueError, RecursionError):
        return False
    return isinstance(tree, dict) and bool(KEYS & tree.keys())


def _is_list(text: str) -> bool:
    """Whether the first two lines have equally many cells, more than one, and set no key."""
    lines = [line for line in text[:5000].splitlines() if line.strip() and line[0] != "#"][:2]
    if len(lines) < 2 or any("=" in line or line.lstrip()[0] in "[{<" for line in lines):
        return False
    rows = [[*csv.reader(lines, delimiter=sign)] for sign in ",;\t"]
    # an open quote joins both lines
    return any(len(found) == 2 and len(found[0]) == len(found[1]) > 1 for found in rows)
