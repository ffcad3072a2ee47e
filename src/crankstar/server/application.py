"""The application: its routes, its refusals in one shape, its description."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.routing import Match, Route

from crankstar import __version__
from crankstar.language.faults import Fault, ValueFaultError
from crankstar.language.quoting import seen
from crankstar.language.server_faults import QUESTION
from crankstar.server import galleries, pages, routes
from crankstar.server.answers import Answers
from crankstar.server.guard import Guard
from crankstar.server.refusal import Refused, refused
from crankstar.server.searches import Searches
from crankstar.server.watching import Watched
from crankstar.server.workers import Workers

DESCRIPTION = """How a piston engine shakes: force, couple and rolling moment by order,
figures, derivations, remedies, searches.

Every request holds its engine, by its name in the catalog or as the tree of an engine file
(`/api/schema` describes its keys). Every mistake in a request is answered in one form,
`{"problems": [{"path": ..., "code": ..., "values": ..., "message": ...}]}`: the key path of the
mistake, its code and values, and a sentence that says what would be right."""
Opening = tuple[Any, str, str]
"""The engine that the page opens with (name or tree), its name as given, the command."""
OPENS_WITH: Opening = ("v8-cross-plane", "v8-cross-plane", "crankstar serve v8-cross-plane")


def application(
    *,
    workers: Workers,
    opening: Opening = OPENS_WITH,
    host: str = "127.0.0.1",
    watched: Watched | None = None,
    one_language: bool = False,
) -> Guard:
    """The ASGI application of the server; the page follows a watched file.

    It is in the language that a browser prefers, or, of `one_language`, always in ours.
    """
    searches = Searches()

    @asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        workers.begin()
        watching = None if watched is None else asyncio.ensure_future(watched.watch())
        try:
            yield
        finally:
            if watching is not None:
                watching.cancel()
            searches.end()
            workers.end()

    app = FastAPI(
        title="crankstar",
        version=__version__,
        description=DESCRIPTION,
        docs_url=None,
        redoc_url=None,
        # a redirection would be no answer in JSON, and its address partly the asker's
        redirect_slashes=False,
        lifespan=lifespan,
    )
    app.state.answers = Answers(workers)
    app.state.searches = searches
    app.state.opening = opening
    app.state.watched = watched
    app.include_router(routes.router)
    app.include_router(pages.router)
    app.include_router(galleries.router)
    app.add_exception_handler(Refused, _refuse)
    app.add_exception_handler(HTTPException, _refuse_http)
    app.add_exception_handler(RequestValidationError, _refuse_invalid)
    return Guard(app, host=host, one_language=one_language)


def _shown(refusal: Refused, headers: Any = None) -> Response:
    return Response(refusal.body, refusal.status, media_type=routes.JSON, headers=headers)


async def _refuse(request: Request, error: Exception) -> Response:
    assert isinstance(error, Refused)  # noqa: S101  # it is registered for nothing else
    return pages.refused_page(error) if _is_read(request) else _shown(error)


def _is_read(request: Request) -> bool:
    """Whether a browser opens the address for somebody to read, as scripts do not."""
    return request.method == "GET" and "text/html" in request.headers.get("accept", "")


async def _refuse_http(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)  # noqa: S101
    if isinstance(error, routes.NotStrictError):
        return _shown(error.refusal)
    heads = {"allow": ", ".join(_methods(request))} if error.status_code == 405 else error.headers
    code = {404: "address", 405: "method"}.get(error.status_code, "unanswerable")
    refusal = refused(error.status_code, f"question.{code}")
    return pages.refused_page(refusal) if _is_read(request) else _shown(refusal, heads)


def _methods(request: Request) -> list[str]:
    """The methods of an address, of all its routes; the framework names only those of the first."""
    every = [
        route
        for route in (
            *request.app.routes,
            *routes.router.routes,
            *pages.router.routes,
            *galleries.router.routes,
        )
        if isinstance(route, Route)
    ]
    there = [route for route in every if route.matches(request.scope)[0] is not Match.NONE]
    methods = {method for route in there for method in route.methods or ()}
    return sorted(methods | ({"HEAD"} if "GET" in methods else set()))


async def _refuse_invalid(_: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)  # noqa: S101
    return _shown(Refused(422, map(_fault, error.errors())))


def _fault(wrong: Any) -> Fault:
    """What pydantic finds wrong with a question."""
    path, context = tuple(wrong["loc"][1:]), wrong.get("ctx") or {}
    if isinstance(error := context.get("error"), ValueFaultError):
        return Fault(path, error.code, error.values)
    kind = wrong["type"] if wrong["type"] in QUESTION else "other"
    limits = {
        key: value.replace("'", '"') if key == "expected" else value
        for key, value in context.items()
    }
    return Fault(path, f"question.{kind}", {"given": seen(wrong["input"]), **limits})
