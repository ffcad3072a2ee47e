"""The page as one file: an engine that turns in any browser, from disk, without a network.

The file holds the bundle as a module script and what it shows as packed JSON. A Content-Security-Policy allows that one
script by its SHA-256 and nothing else: no other script, no style, no picture, no connection.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Sequence
from hashlib import sha256
from html import escape
from pathlib import Path

from crankstar.exhibit.library import Tree, packed

BUNDLE = Path(__file__).parent / "bundle" / "crankstar.js"


class PageError(ValueError):
    """A page that cannot be made, as one sentence that says what to do."""


def bundle() -> str:
    """The front-end as text of an ES module. Raises PageError where it has not been built."""
    try:
        return BUNDLE.read_text(encoding="utf-8")
    except FileNotFoundError:
        told = "the page's script has not been built in this copy of crankstar; build it with `python web/bundle.py`"
        raise PageError(f"{told}, or install crankstar from a wheel") from None


def policy(*scripts: str) -> str:
    """The Content-Security-Policy of a page that runs these inline scripts and nothing else."""
    hashes = " ".join(f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in scripts) or "'none'"
    rest = "img-src data: blob:; base-uri 'none'; form-action 'none'"
    return f"default-src 'none'; script-src {hashes}; {rest}"


def inlined(script: str) -> str:
    r"""A script as it can stand inside a script element: no text in it ends the element, or opens one in a comment.

    >>> print(inlined('a = "</script><script>"'))
    a = "<\/script>\x3cscript>"
    """
    return re.sub(r"<(script)", r"\\x3c\1", re.sub(r"</(script)", r"<\\/\1", script, flags=re.IGNORECASE), flags=re.IGNORECASE)


def document(tree: Tree) -> str:
    """The page of what `exhibit.library.held` gives, as HTML. Raises PageError where the bundle has not been built."""
    names = [engine["name"] for engine in tree["exhibition"]["engines"]]
    script = "\n" + inlined(bundle()) + "\n"
    title = " and ".join(names)
    about = f"How {_joined(names)} shakes: the engine turns, with its inertia forces, couples and what would balance them."
    return "\n".join(
        (
            "<!DOCTYPE html>",
            '<html lang="en">',
            "<head>",
            '<meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy(script)}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            '<meta name="color-scheme" content="light dark">',
            '<meta name="generator" content="crankstar">',
            f'<meta name="description" content="{escape(about)}">',
            f"<title>{escape(title)}</title>",
            "</head>",
            "<body>",
            f"<div data-crankstar><p>{CUT}</p></div>",
            f"<noscript><h1>{escape(title)}</h1><p>{NO_SCRIPT}</p></noscript>",
            f'<script type="application/json" id="crankstar-data">{packed(tree)}</script>',
            f'<script type="module">{script}</script>',
            "</body>",
            "</html>",
            "",
        )
    )


CUT = "The engine is being drawn. If this does not go away, the file is not whole: write it again with crankstar page."
NO_SCRIPT = "This page turns an engine by a script that is all in this file. Allow scripts for it, or open it in another browser."


def _joined(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
