"""What the program makes for the documents, also in their text: tables, lists, the glossary.

Between a marker such as `<!-- errata: taylor1985 -->` and `<!-- end -->` stands what the built page
shows there, so that the Markdown can be read as it is. Figures are drawn when the pages are built;
the text names them. `.venv/bin/python docs/build/tables.py` brings all pages up to date; a test
compares them.
"""

from __future__ import annotations

import os
import re
import sys
from html import unescape
from pathlib import Path
from runpy import run_path
from typing import Any

HERE = Path(__file__).parent
DOCS = HERE.parent
HOOKS: dict[str, Any] = run_path(str(HERE / "hooks.py"))
FIGURE = re.compile(r"<figure[^>]*>.*?</figure>", re.DOTALL)
MATHEMATICS = re.compile(r'<math alttext="([^"]*)".*?</math>', re.DOTALL)


def up_to_date(text: str, place: str) -> str:
    """The text of a page, `place` its path in docs/, with what is made for it as it is now."""
    return HOOKS["MARK"].sub(lambda mark: block(mark.group(1), mark.group(2), place), text)


def block(kind: str, argument: str, place: str) -> str:
    """A marker, what stands for it in the text, and its end."""
    head = f"<!-- {kind}: {argument}".rstrip() + " -->"
    if kind == "figure":
        drawing = (DOCS / argument).read_text(encoding="utf-8")
        title = re.search(r"<title[^>]*>(.*?)</title>", drawing, re.DOTALL)
        path = os.path.relpath(DOCS / argument, (DOCS / place).parent)
        shown = f"![{' '.join(title[1].split()) if title else 'Figure'}]({path})"
    else:
        shown = readable(HOOKS["made"](kind, argument))
    return f"{head}\n\n{shown.strip()}\n\n<!-- end -->"


def readable(made: str) -> str:
    """What is made for the built page without drawings, and formulas as text."""
    without = FIGURE.sub(lambda figure: named(figure[0]), made)
    lines = MATHEMATICS.sub(lambda formula: unescape(formula[1]), without).splitlines()
    kept = [line.rstrip() for line in lines if not re.match(r"\s*</?div\b", line)]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(kept))


def named(figure: str) -> str:
    """A drawing named by the command that draws it, or by its title."""
    caption = re.search(r"<figcaption>(.*?)</figcaption>", figure, re.DOTALL)
    title = re.search(r"<title[^>]*>(.*?)</title>", figure, re.DOTALL)
    label = re.search(r'aria-label="([^"]*)"', figure)
    words = next((found[1] for found in (caption, title, label) if found), "")
    plain = " ".join(unescape(re.sub(r"<[^>]+>", "", words)).split())
    return f"* *Figure: {plain or 'drawn when the pages are built'}.*"


def main() -> None:
    """Bring every page up to date, and say which have changed."""
    sys.path.insert(0, str(DOCS.parent / "src"))
    for page in sorted(DOCS.rglob("*.md")):
        before = page.read_text(encoding="utf-8")
        after = up_to_date(before, page.relative_to(DOCS).as_posix())
        if after != before:
            page.write_text(after, encoding="utf-8")
            print(f"changed: {page.relative_to(DOCS)}")


if __name__ == "__main__":
    main()
