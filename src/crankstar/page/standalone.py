"""The page as one file: an engine that turns in any browser, from disk, without a network.

The file holds the bundle as a module script and its contents as packed JSON. A
Content-Security-Policy allows that one script by its SHA-256 and nothing else: no other script, no
style, no picture, no connection.
"""

from __future__ import annotations

import re
from base64 import b64encode
from hashlib import sha256
from html import escape
from pathlib import Path

from crankstar.language.messages import N_, MessageError, _, language
from crankstar.page.library import Tree, packed

BUNDLE = Path(__file__).parents[1] / "bundle" / "crankstar.js"


class PageError(MessageError):
    """A page that cannot be written; the message names the remedy."""


def bundle() -> str:
    """The front-end as text of an ES module. Raises PageError where it has not been built."""
    try:
        return BUNDLE.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise PageError(
            "this copy of crankstar lacks the script of the page; build it with "
            "`python web/bundle.py`, or install crankstar from a wheel"
        ) from None


def policy(*scripts: str) -> str:
    """The Content-Security-Policy of a page that runs these inline scripts and nothing else."""
    hashes = (
        " ".join(
            f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in scripts
        )
        or "'none'"
    )
    rest = "img-src data: blob:; base-uri 'none'; form-action 'none'"
    return f"default-src 'none'; script-src {hashes}; {rest}"


def inlined(script: str) -> str:
    r"""A script for a script element, which no text in it ends or opens.

    >>> print(inlined('a = "</script><script>"'))
    a = "<\/script>\x3cscript>"
    """
    return re.sub(
        r"<(script)",
        r"\\x3c\1",
        re.sub(r"</(script)", r"<\\/\1", script, flags=re.IGNORECASE),
        flags=re.IGNORECASE,
    )


def document(tree: Tree) -> str:
    """The page with contents of `library.held` as HTML. Raises PageError without a bundle."""
    names = [engine["name"] for engine in tree["exhibition"]["engines"]]
    script = "\n" + inlined(bundle()) + "\n"
    title = names[0]
    about = _("Inertia forces and couples of {engine}, and their remedies.", engine=title)
    if len(names) > 1:
        title = _("{engine} and {other}", engine=names[0], other=names[1])
        about = _(
            "Inertia forces and couples of {engine} and {other}, and their remedies.",
            engine=names[0],
            other=names[1],
        )
    return "\n".join(
        (
            "<!DOCTYPE html>",
            f'<html lang="{language()}">',
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
            f"<div data-crankstar><p>{escape(_(INCOMPLETE))}</p></div>",
            f"<noscript><h1>{escape(title)}</h1><p>{escape(_(NO_SCRIPT))}</p></noscript>",
            f'<script type="application/json" id="crankstar-data">{packed(tree)}</script>',
            f'<script type="module">{script}</script>',
            "</body>",
            "</html>",
            "",
        )
    )


INCOMPLETE = N_(
    "Drawing the engine. If this message stays, the file is incomplete: write it again with "
    "`crankstar page`."
)
NO_SCRIPT = N_(
    "This page needs its own script, which is part of the file. Allow scripts, or use another "
    "browser."
)
