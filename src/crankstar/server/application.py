"""The application: its routes, its refusals in one shape, its description."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.routing import Match, Route

from crankstar import __version__
from crankstar.language.faults import where
from crankstar.language.messages import N_, _
from crankstar.language.quoting import seen
from crankstar.server import pages, routes
from crankstar.server.answers import Answers
from crankstar.server.guard import Guard
from crankstar.server.refusal import Refused, refused
from crankstar.server.searches import Searches
from crankstar.server.workers import Workers

DESCRIPTION = """How a piston engine shakes: forces, couples and rolls of every order, figures, derivations, remedies, searches.

Every question holds its engine, by its name in the catalog or as the tree of an engine file (`/api/schema` says what may stand
in it). Whatever is wrong is answered in one shape, `{"problems": [{"path": ..., "message": ...}]}`: every mistake, its key path,
and what would be right."""
Opening = tuple[Any, str, str]
"""The engine that the page opens with (name or tree), its name as given, the command."""
OPENS_WITH: Opening = ("v8-cross-plane", "v8-cross-plane", "crankstar serve v8-cross-plane")


def application(
    *, workers: Workers, opening: Opening = OPENS_WITH, host: str = "127.0.0.1"
) -> Guard:
    """The ASGI application of the server."""
    searches = Searches()

    @asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        workers.begin()
        try:
            yield
        finally:
            searches.end()
            workers.end()

    app = FastAPI(
        title="crankstar",
        version=__version__,
        description=DESCRIPTION,
        docs_url=None,
        redoc_url=None,
        redirect_slashes=False,  # a redirection would be no answer in JSON, and its address partly the asker's
        lifespan=lifespan,
    )
    app.state.answers = Answers(workers)
    app.state.searches = searches
    app.state.opening = opening
    app.include_router(routes.router)
    app.include_router(pages.router)
    app.add_exception_handler(Refused, _refuse)
    app.add_exception_handler(HTTPException, _refuse_http)
    app.add_exception_handler(RequestValidationError, _refuse_invalid)
    return Guard(app, host=host)


def _shown(refusal: Refused, headers: Any = None) -> Response:
    return Response(refusal.body, refusal.status, media_type=routes.JSON, headers=headers)


async def _refuse(_: Request, error: Exception) -> Response:
    assert isinstance(error, Refused)  # noqa: S101  # it is registered for nothing else
    return _shown(error)


HTTP = {
    404: N_("There is no such address; see /docs."),
    405: N_("This address does not take this method; see /docs."),
}


async def _refuse_http(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)  # noqa: S101
    if isinstance(error, routes.NotStrictError):
        return _shown(error.refusal)
    heads = {"allow": ", ".join(_methods(request))} if error.status_code == 405 else error.headers
    return _shown(refused(error.status_code, _(HTTP.get(error.status_code, UNANSWERABLE))), heads)


UNANSWERABLE = N_("This question cannot be answered.")


def _methods(request: Request) -> list[str]:
    """The methods of an address, of all its routes; the framework names only those of the first."""
    every = [
        route
        for route in (*request.app.routes, *routes.router.routes, *pages.router.routes)
        if isinstance(route, Route)
    ]
    there = [route for route in every if route.matches(request.scope)[0] is not Match.NONE]
    methods = {method for route in there for method in route.methods or ()}
    return sorted(methods | ({"HEAD"} if "GET" in methods else set()))


async def _refuse_invalid(_: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)  # noqa: S101
    return _shown(
        Refused(422, [(_path(fault["loc"]), _sentence(fault)) for fault in error.errors()])
    )


def _path(loc: tuple[str | int, ...]) -> str:
    """A place in a question, as in an engine file."""
    return where(loc[1:]) if len(loc) > 1 else ""


NEEDED = {
    "string_type": "text is needed",
    "int_type": "a whole number is needed",
    "float_type": "a number is needed",
    "bool_type": "true or false is needed",
    "list_type": "a list is needed",
    "model_attributes_type": "an object is needed",
}
BOUNDS = {
    "greater_than_equal": "it must be at least {ge}",
    "less_than_equal": "it must be at most {le}",
    "literal_error": "it can be {expected}",
    "string_too_long": "at most {max_length} letters are allowed",
    "too_long": "at most {max_length} entries are allowed",
}


def _sentence(fault: Any) -> str:
    """What pydantic finds wrong with a question, said to the one who asks."""
    kind, context = fault["type"], fault.get("ctx") or {}
    if kind == "missing":
        return "is missing; /docs says what is asked here"
    if kind == "extra_forbidden":
        return "unknown key; /docs says what is asked here"
    if kind == "value_error":
        return str(context["error"])
    if kind in BOUNDS:
        return f"is {seen(fault['input'])}; {BOUNDS[kind].format_map(context)}".replace("'", '"')
    return f"is {seen(fault['input'])}; {NEEDED.get(kind, 'it cannot be used here; /docs says what is asked')}"
