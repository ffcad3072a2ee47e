"""The page as one file: an engine that turns in any browser, from disk, without a network.

The file holds the script of the page, that of its figures, which is read when the first is wanted,
both packed, the few lines that unpack the one, and its contents as packed JSON. A
Content-Security-Policy allows these three scripts by their SHA-256 and nothing else: no other
script, no style, no picture, no connection.
"""

from __future__ import annotations

import gzip
import re
from base64 import b64encode
from hashlib import sha256
from html import escape
from pathlib import Path
from typing import NamedTuple

from crankstar.language.messages import N_, MessageError, _, language
from crankstar.page.library import Tree, packed

BUNDLE = Path(__file__).parents[1] / "bundle" / "crankstar.js"
FIGURES = "figures.js"
"""Beside it, the script that draws figures."""


class PageError(MessageError):
    """A page that cannot be written; the message names the remedy."""


def bundle() -> str:
    """The front-end as text of an ES module. Raises PageError where it has not been built."""
    return _script(BUNDLE)


def figures_script() -> str:
    """What draws figures, as text of a plain script. Raises PageError where it was not built."""
    return _script(BUNDLE.with_name(FIGURES))


def _script(path: Path) -> str:
    """A script of the bundle. Raises PageError."""
    try:
        return path.read_text(encoding="utf-8")
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


UNPACK = """
const place = document.querySelector("[data-crankstar]")
let fail
const ready = new Promise((follow, refuse) => {
  place.addEventListener("crankstar", () => follow(place.crankstar.ready), { once: true })
  fail = refuse
})
ready.catch(() => {})  // the page says it
place.crankstar = { ready, settled: () => ready.then(() => place.crankstar.settled()) }
try {
  const letters = atob(document.getElementById("crankstar-script").textContent)
  const bytes = new Uint8Array(letters.length)
  for (let i = 0; i < bytes.length; i++) bytes[i] = letters.charCodeAt(i)
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))
  const script = document.createElement("script")
  script.type = "module"
  script.textContent = await new Response(stream).text()
  document.body.append(script)
} catch (error) {
  fail(error)  // what stands in the page stays: that the file is incomplete
}
"""
"""The script that puts the packed one in the page, and says until it is there that it comes."""


def _packed(script: str, name: str) -> str:
    """A script as text, as the bundle has it packed beside it; packed here where it has not."""
    place = BUNDLE.with_name(f"{name}.gz")
    data = place.read_bytes() if place.is_file() else gzip.compress(script.encode(), 9, mtime=0)
    return b64encode(data).decode()


class Shared(NamedTuple):
    """What pages of one site share: addresses of their two scripts, and of the page above them."""

    script: str
    figures: str
    up: str


def plain_script() -> str:
    """The front-end as a plain script, which a page that is opened from disk may ask for.

    Raises PageError without a bundle.
    """
    own, count = EXPORT.subn("", bundle())
    if count != 1:
        raise PageError("the script of the page is not one module; build it anew")
    return f'(() => {{"use strict";\n{own}\n}})();\n'


EXPORT = re.compile(r"export\s*\{[^{}]*\};?\s*$")
"""The last statement of the bundle, which only a module can have."""
SHARED_POLICY = (
    "default-src 'none'; script-src 'self' file:; style-src 'self' file:; "
    "img-src 'self' file: data: blob:; base-uri 'none'; form-action 'none'"
)
"""Of a page of a site, on a web host or on disk: only what is beside it."""


def document(tree: Tree, *, shared: Shared | None = None) -> str:
    """The page with contents of `library.held` as HTML. Raises PageError without a bundle.

    A page of a site has what it shares with the others in files of their own.
    """
    names = [engine["name"] for engine in tree["exhibition"]["engines"]]
    up = figures = ""
    if shared is None:
        script, drawing = bundle(), figures_script()
        allowed = policy(UNPACK, script, drawing)
        packed_script, packed_drawing = _packed(script, BUNDLE.name), _packed(drawing, FIGURES)
        element = (  # what begins stands last: nothing does in a file that is cut short
            f'<script type="application/gzip" id="crankstar-figures">{packed_drawing}</script>\n'
            f'<script type="application/gzip" id="crankstar-script">{packed_script}</script>\n'
            f'<script type="module">{UNPACK}</script>'
        )
    else:
        allowed = SHARED_POLICY
        element = f'<script defer src="{escape(shared.script)}"></script>'
        figures = f' data-figures="{escape(shared.figures)}"'
        up = f'<link rel="up" href="{escape(shared.up)}">'
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
            f'<meta http-equiv="Content-Security-Policy" content="{allowed}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            '<meta name="color-scheme" content="light dark">',
            '<meta name="generator" content="crankstar">',
            f'<meta name="description" content="{escape(about)}">',
            f"<title>{escape(title)}</title>{up}",
            "</head>",
            "<body>",
            f"<div data-crankstar{figures}><p>{escape(_(INCOMPLETE))}</p></div>",
            f"<noscript><h1>{escape(title)}</h1><p>{escape(_(NO_SCRIPT))}</p></noscript>",
            f'<script type="application/json" id="crankstar-data">{packed(tree)}</script>',
            element,
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
