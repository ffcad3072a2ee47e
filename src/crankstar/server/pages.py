"""The page, its scripts and the API's description: all from this machine, nothing inline."""

from __future__ import annotations

import gzip
import hashlib
import json
from functools import lru_cache
from html import escape
from importlib.resources import files
from typing import NamedTuple

from fastapi import APIRouter, Request, Response

from crankstar.language.messages import _, language
from crankstar.server.guard import PAGE_POLICY
from crankstar.server.refusal import Refused, refused, said

DOCUMENT = """<!doctype html>
<html lang="%s">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>%s</title>
<link rel="icon" href="data:,">
%s
</head>
<body>
%s
</body>
</html>
"""
HEAD = """<link rel="stylesheet" href="/page.css">
<link rel="up" href="/gallery">
<script type="module" src="%s"></script>"""
BODY = """<div data-crankstar="server" data-figures="%s"></div>
<noscript>%s</noscript>"""
REFUSED = """<main class="failed">
%s
<p><a href="/">%s</a> · <a href="/gallery">%s</a></p>
</main>"""
STYLE = """html, body { margin: 0; height: 100% }
noscript, .failed { display: block; padding: 2em; font: 1rem system-ui, sans-serif }
"""
UNBUILT = """const el = document.querySelector('[data-crankstar]')
el.className = 'failed'
el.textContent = %s
"""
DOCS_HEAD = """<link rel="stylesheet" href="/docs/swagger-ui.css">
<link rel="stylesheet" href="/docs/page.css">
<script defer src="/docs/swagger-ui-bundle.js"></script>
<script defer src="/docs/start.js"></script>"""
DOCS_BODY = """<main id="crankstar"></main>
<noscript>This page needs JavaScript; /openapi.json has the same as JSON.</noscript>"""
DOCS_START = """window.SwaggerUIBundle({
  url: '/openapi.json', dom_id: '#crankstar', deepLinking: true, validatorUrl: null,
  tryItOutEnabled: true, presets: [window.SwaggerUIBundle.presets.apis],
})
"""
DOCS_STYLE = "body { margin: 0; background: #fff }\n"
HTML, SCRIPT, CSS = "text/html", "text/javascript", "text/css"
FOR_EVER = "public, max-age=31536000, immutable"
ASK_AGAIN = "no-cache"


class Asset(NamedTuple):
    """A file that is sent as it is: its bytes, the same compressed, and a name of its content."""

    plain: bytes
    small: bytes
    digest: str


@lru_cache(maxsize=8)
def _asset(name: str, changed: float) -> Asset:
    """A file of the bundle as it was when it was changed."""
    del changed
    plain = (files("crankstar") / "bundle" / name).read_bytes()
    return Asset(plain, gzip.compress(plain, 6, mtime=0), hashlib.sha256(plain).hexdigest()[:16])


def asset(name: str) -> Asset | None:
    """A file of the bundle; None where it was not built."""
    place = files("crankstar") / "bundle" / name
    try:
        # a real file wherever we run
        return _asset(name, place.stat().st_mtime)  # pyright: ignore[reportAttributeAccessIssue]
    except FileNotFoundError:
        return None


router = APIRouter(include_in_schema=False)


def _text(text: str, kind: str) -> Response:
    policy = {"content-security-policy": PAGE_POLICY} if kind == HTML else {}
    return Response(text, media_type=kind, headers={"cache-control": ASK_AGAIN, **policy})


def _file(request: Request, name: str, kind: str) -> Response:
    """A file of the bundle, cached for ever if its address has its digest; raises Refused."""
    asset_ = asset(name)
    if asset_ is None:
        raise refused(404, "question.unbuilt", name=name)
    tag = f'"{asset_.digest}"'
    heads = {
        "etag": tag,
        "cache-control": FOR_EVER if request.query_params.get("v") == asset_.digest else ASK_AGAIN,
    }
    if request.headers.get("if-none-match") == tag:
        return Response(status_code=304, headers=heads)
    if "gzip" in request.headers.get("accept-encoding", ""):
        return Response(
            asset_.small,
            media_type=kind,
            headers={**heads, "content-encoding": "gzip", "vary": "accept-encoding"},
        )
    return Response(asset_.plain, media_type=kind, headers={**heads, "vary": "accept-encoding"})


def refused_page(refusal: Refused) -> Response:
    """A refusal for one who reads it in a browser, with ways on."""
    told = "\n".join(f"<p>{escape(said(fault))}</p>" for fault in refusal.faults)
    ways = (
        escape(_("The page on which the engine turns")),
        escape(_("All engines of the catalog")),
    )
    head = '<link rel="stylesheet" href="/page.css">'
    text = DOCUMENT % (language(), "crankstar", head, REFUSED % (told, *map(escape, ways)))
    response = _text(text, HTML)
    response.status_code = refusal.status
    return response


@router.get("/")
async def page() -> Response:
    """The page on which the engine turns."""
    script, figures = asset("crankstar.js"), asset("figures.js")
    source = "/unbuilt.js" if script is None else f"/app.js?v={script.digest}"
    drawing = "" if figures is None else f"/figures.js?v={figures.digest}"
    needed = _(
        "This page needs JavaScript: switch it on, or use the command line (crankstar --help)."
    )
    text = DOCUMENT % (language(), "crankstar", HEAD % source, BODY % (drawing, escape(needed)))
    return _text(text, HTML)


@router.get("/unbuilt.js")
async def unbuilt() -> Response:
    """What says that there is no bundle."""
    sentence = _(
        "The page is not part of this installation; in a checkout, build it with make bundle. "
        "The API works without it: /docs"
    )
    return _text(UNBUILT % json.dumps(sentence), SCRIPT)


TEXTS = {
    "/page.css": (STYLE, CSS),
    "/docs": (DOCUMENT % ("en", "crankstar API", DOCS_HEAD, DOCS_BODY), HTML),
    "/docs/page.css": (DOCS_STYLE, CSS),
    "/docs/start.js": (DOCS_START, SCRIPT),
}
FILES = {
    "/app.js": ("crankstar.js", SCRIPT),
    "/figures.js": ("figures.js", SCRIPT),
    "/gallery.js": ("gallery.js", SCRIPT),
    "/docs/swagger-ui-bundle.js": ("swagger-ui-bundle.js", SCRIPT),
    "/docs/swagger-ui.css": ("swagger-ui.css", CSS),
}
"""Texts and files of the bundle by their address; the API for people is Swagger UI."""


async def _answer(request: Request) -> Response:
    path = request.scope["path"]
    return _text(*TEXTS[path]) if path in TEXTS else _file(request, *FILES[path])


for _path in (*TEXTS, *FILES):
    router.get(_path)(_answer)
