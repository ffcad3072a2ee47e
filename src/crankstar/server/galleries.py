"""The gallery of the catalog on this server: its page, its style, and pictures as they are asked.

A picture is drawn by a worker when a browser first asks for it, and kept with the other answers.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Path, Query, Request, Response

from crankstar.language.messages import LANGUAGES, language, spoken
from crankstar.server.answers import Answers
from crankstar.server.guard import PAGE_POLICY
from crankstar.server.pages import ASK_AGAIN, CSS, HTML
from crankstar.server.refusal import refused
from crankstar.server.tasks import catalog_tree, engine_of
from crankstar.site import gallery
from crankstar.site.miniatures import LOOKS, miniature

WEBP = "image/webp"
FOR_A_DAY = "private, max-age=86400"
SUFFIXES = {look.suffix: look for look in LOOKS}

router = APIRouter(include_in_schema=False)


def page(lang: str) -> bytes:
    """The gallery as HTML in a language."""
    from crankstar.files import catalog

    asked = f"?lang={lang}" if lang != language() else ""
    cards = [
        gallery.Card(
            entry.name,
            entry.title,
            entry.layout,
            entry.cylinders,
            entry.cycle,
            f"/{asked}#engine={entry.name}",
        )
        for entry in catalog.summaries()
    ]
    with spoken(lang):
        made = gallery.Gallery(
            cards=cards,
            picture=lambda name, look: f"/pictures/{name}{look.suffix}",
            style="/gallery.css",
            script="/gallery.js",
            live=True,
        )
        return gallery.html(made).encode()


def picture(name: str, suffix: str) -> bytes:
    """A picture of an engine of the catalog. Raises Refused."""
    return miniature(engine_of(catalog_tree(name))[0], SUFFIXES[suffix])


@router.get("/gallery")
async def gallery_page(
    request: Request, lang: Annotated[str, Query(max_length=20)] = ""
) -> Response:
    """The catalog as pictures, which lead to the page of each engine."""
    answers: Answers = request.app.state.answers
    asked = lang if lang in LANGUAGES else language()
    heads = {"cache-control": ASK_AGAIN, "content-security-policy": PAGE_POLICY}
    return Response(await answers.to(page, asked), media_type=HTML, headers=heads)


@router.get("/gallery.css")
async def gallery_style() -> Response:
    """The style of the gallery."""
    return Response(gallery.style(), media_type=CSS, headers={"cache-control": ASK_AGAIN})


@router.get("/pictures/{file}")
async def gallery_picture(request: Request, file: Annotated[str, Path(max_length=200)]) -> Response:
    """A picture of an engine: `NAME-light.webp`, `NAME-dark-turning.webp`."""
    suffix = next((suffix for suffix in SUFFIXES if file.endswith(suffix)), None)
    if suffix is None:
        raise refused(404, "question.address")
    answers: Answers = request.app.state.answers
    content = await answers.to(picture, file.removesuffix(suffix), suffix)
    return Response(content, media_type=WEBP, headers={"cache-control": FOR_A_DAY})
